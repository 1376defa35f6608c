//! Can this scenario be run? Reads a TOML file; writes nothing, returns a checked scenario or names the first field that is wrong.

use super::spec::{Gas, GrainSpec, LawSpec, MethodName, Scenario, SideSpec, Sides, SurfaceSpec};
use anyhow::{Context, Result, anyhow, bail};
use std::path::Path;

impl Scenario {
    /// Reads a scenario file.
    ///
    /// # Errors
    /// One line that names file, line and field.
    pub fn read(file: &Path) -> Result<Self> {
        let name = file.display();
        let text = std::fs::read_to_string(file).with_context(|| format!("cannot read {name}"))?;
        Self::parse(&text).with_context(|| format!("{name}"))
    }

    /// Reads a scenario from text.
    ///
    /// # Errors
    /// One line that names line or field.
    ///
    /// ```
    /// use carom_host::scenario::Scenario;
    /// let text = "dimension = 1\nduration = 1.0\nsample = 0.1\n\
    ///     [law]\nkind = \"constant\"\nrestitution = 1.5\n\
    ///     [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.0]";
    /// let error = Scenario::parse(text).unwrap_err().to_string();
    /// assert_eq!(error, "law.restitution is 1.5, must be from 0 to 1");
    /// ```
    pub fn parse(text: &str) -> Result<Self> {
        let scenario: Self = toml::from_str(text).map_err(|error| {
            let line = error.span().map_or(1, |span| 1 + text[..span.start].matches('\n').count());
            anyhow!("line {line}: {}", error.message().replace('\n', ", "))
        })?;
        check(&scenario)?;
        Ok(scenario)
    }

    /// The same scenario, run by this method only.
    ///
    /// # Errors
    /// When the law or the box does not allow it.
    pub fn with_method(self, method: MethodName) -> Result<Self> {
        let scenario = Self { methods: vec![method], ..self };
        check(&scenario)?;
        Ok(scenario)
    }
}

/// More grains than this are a slip of the pen: 20 GB.
const MAX_GRAINS: usize = 100_000_000;

fn check(scenario: &Scenario) -> Result<()> {
    let d = scenario.dimension;
    if !(1..=3).contains(&d) {
        bail!("dimension is {d}, must be 1, 2 or 3");
    }
    length_of("gravity", scenario.gravity.len(), d, true)?;
    scenario.gravity.iter().try_for_each(|g| finite("gravity", *g))?;
    check_end(scenario)?;
    positive("sample", scenario.sample)?;
    check_sample(scenario)?;
    if let Some(observe) = &scenario.observe {
        observe.check(scenario.sample, scenario.duration)?;
    }
    scenario.options.exact_until.map_or(Ok(()), |t| positive("options.exact_until", t))?;
    not_negative("options.tc", scenario.options.tc)?;
    law(&scenario.law)?;
    sides(&scenario.sides, d)?;
    methods(scenario)?;
    if scenario.grains.is_empty() && scenario.gas.is_none() {
        bail!("no grains: add [[grain]] entries or a [gas]");
    }
    for (number, grain) in scenario.grains.iter().enumerate() {
        check_grain(number, grain, d)?;
    }
    scenario.gas.as_ref().map_or(Ok(()), gas)
}

fn check_end(scenario: &Scenario) -> Result<()> {
    match (scenario.duration, scenario.collisions) {
        (Some(duration), None) => positive("duration", duration),
        (None, Some(0)) => bail!("collisions is 0, must be at least 1"),
        (None, Some(_)) => Ok(()),
        _ => bail!("give one of duration [s] and collisions"),
    }
}

/// More samples than this are a slip of the pen.
const MAX_SAMPLES: f64 = 1e7;

fn check_sample(scenario: &Scenario) -> Result<()> {
    let (sample, duration) = (scenario.sample, scenario.duration.unwrap_or(0.0));
    if duration / sample > MAX_SAMPLES {
        let least = duration / MAX_SAMPLES;
        bail!("sample is {sample:?}, must be at least {least:?}: duration in {MAX_SAMPLES} parts");
    }
    Ok(())
}

fn law(law: &LawSpec) -> Result<()> {
    match *law {
        LawSpec::Lsd { stiffness, damping } => {
            positive("law.stiffness", stiffness)?;
            not_negative("law.damping", damping)
        }
        LawSpec::Viscoelastic { young, poisson, dissipation } => {
            positive("law.young", young)?;
            if !(poisson > -1.0 && poisson <= 0.5) {
                bail!("law.poisson is {poisson}, must be above -1 and at most 0.5");
            }
            not_negative("law.dissipation", dissipation)
        }
        LawSpec::Constant { restitution } => fraction("law.restitution", restitution),
    }
}

fn sides(sides: &Sides, dimension: usize) -> Result<()> {
    let named = [("x", sides.x), ("y", sides.y), ("z", sides.z)];
    for (axis, (name, side)) in named.into_iter().enumerate() {
        if axis >= dimension && side != SideSpec::Open {
            bail!("box.{name} is given, but dimension is {dimension}");
        }
        match side {
            SideSpec::Open | SideSpec::Periodic { .. } => {}
            SideSpec::Walls { surface, restitution, .. } => made_of(name, surface, restitution)?,
            SideSpec::Plate { at, amplitude, frequency, phase, surface, restitution } => {
                made_of(name, surface, restitution)?;
                finite(&format!("box.{name}.at"), at)?;
                finite(&format!("box.{name}.phase"), phase)?;
                not_negative(&format!("box.{name}.amplitude"), amplitude)?;
                if amplitude > 0.0 {
                    positive(&format!("box.{name}.frequency"), frequency)?;
                }
            }
        }
    }
    Ok(())
}

fn made_of(name: &str, surface: SurfaceSpec, restitution: Option<f64>) -> Result<()> {
    match (surface, restitution) {
        (SurfaceSpec::Hard, Some(e)) => fraction(&format!("box.{name}.restitution"), e),
        (SurfaceSpec::Hard, None) => bail!("box.{name}.restitution: hard walls need one"),
        (SurfaceSpec::Soft, Some(_)) => {
            bail!("box.{name}.restitution: soft walls follow the law and have none")
        }
        (SurfaceSpec::Soft, None) => Ok(()),
    }
}

/// Force-based MD needs forces, from walls too.
fn methods(scenario: &Scenario) -> Result<()> {
    for method in &scenario.methods {
        let label = method.label();
        if *method != MethodName::Emd && matches!(scenario.law, LawSpec::Constant { .. }) {
            bail!(
                "methods: {label} needs a force law, but law.kind is constant; leave {label} out"
            );
        }
        let force_based = matches!(method, MethodName::Md | MethodName::Exact);
        if force_based && scenario.hard_walls().is_some() {
            bail!(
                "methods: {label} needs soft walls, but the box has hard ones; leave {label} out"
            );
        }
    }
    Ok(())
}

fn check_grain(number: usize, grain: &GrainSpec, dimension: usize) -> Result<()> {
    let name = |field: &str| format!("grain {number}: {field}");
    positive(&name("radius"), grain.radius)?;
    match (grain.mass, grain.density) {
        (Some(mass), None) => positive(&name("mass"), mass)?,
        (None, Some(density)) => positive(&name("density"), density)?,
        _ => bail!("grain {number}: give one of mass [kg] and density [kg/m3]"),
    }
    length_of(&name("at"), grain.at.len(), dimension, false)?;
    length_of(&name("moving"), grain.moving.len(), dimension, true)?;
    grain.at.iter().try_for_each(|x| finite(&name("at"), *x))?;
    grain.moving.iter().try_for_each(|x| finite(&name("moving"), *x))
}

fn gas(gas: &Gas) -> Result<()> {
    if !(1..=MAX_GRAINS).contains(&gas.count) {
        bail!("gas.count is {}, must be from 1 to {MAX_GRAINS}", gas.count);
    }
    let [small, large] = gas.radius.range();
    positive("gas.radius", small)?;
    if !(large.is_finite() && large >= small) {
        bail!("gas.radius is [{small}, {large}], must be the smallest and then the largest");
    }
    positive("gas.density", gas.density)?;
    not_negative("gas.thermal_speed", gas.thermal_speed)?;
    match gas.packing_fraction {
        Some(phi) if !(phi > 0.0 && phi < 1.0) => {
            bail!("gas.packing_fraction is {phi}, must be above 0 and below 1")
        }
        _ => Ok(()),
    }
}

fn positive(field: &str, value: f64) -> Result<()> {
    if value > 0.0 && value.is_finite() {
        return Ok(());
    }
    bail!("{field} is {value}, must be finite and above 0")
}

fn not_negative(field: &str, value: f64) -> Result<()> {
    if value >= 0.0 && value.is_finite() {
        return Ok(());
    }
    bail!("{field} is {value}, must be finite and at least 0")
}

fn fraction(field: &str, value: f64) -> Result<()> {
    if (0.0..=1.0).contains(&value) {
        return Ok(());
    }
    bail!("{field} is {value}, must be from 0 to 1")
}

fn finite(field: &str, value: f64) -> Result<()> {
    if value.is_finite() {
        return Ok(());
    }
    bail!("{field} has {value}, must be finite")
}

fn length_of(field: &str, length: usize, dimension: usize, may_be_empty: bool) -> Result<()> {
    if length == dimension || (may_be_empty && length == 0) {
        return Ok(());
    }
    bail!("{field} has {length} numbers, must have {dimension}, one for each axis")
}
