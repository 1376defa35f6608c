//! By which method and rule does a scenario run? Reads a scenario; writes nothing, hands out one running method.

use super::event_driven::EventDriven;
use super::force_based::ForceBased;
use super::interface::Method;
use crate::drive::Driving;
use crate::integrated::Integrated;
use crate::observe::Layout;
use crate::scenario::{
    EnduringSpec, LawSpec, Laws, Made, MatrixSpec, MethodName, OutsideSpec, ReleaseSpec, Scenario,
    Shaking, Side, Start, sources,
};
use crate::tables::embedded;
use anyhow::{Context, Result, bail};
use carom::HeapMemory;
use carom::law::{
    Central, HardSphere, LinearDashpot, Outside, PairRules, Rule, Soft, Viscoelastic,
};
use carom::particle::Body;
use carom::space::{Plane, Surface, Vibration};
use carom::world::{ScheduledEvent, Snapshot, WorldBuilder};
use carom::{Enduring, Grain, Release, World};
use carom_reference::{Exact, Plate, Verlet, VerletOptions};
use carom_tables::read::Law;

/// Sets a method up and hands it to `work`.
///
/// # Errors
/// An error of the set-up or of `work`.
///
/// ```
/// use carom_host::{method, scenario::{MethodName, Scenario, Start}};
/// let scenario = Scenario::parse("dimension = 1\nduration = 1.0\nsample = 1.0\n\
///     [law]\nkind = \"lsd\"\nstiffness = 1e6\ndamping = 0.0\n\
///     [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.0]\nmoving = [1.0]\n\
///     [[grain]]\nradius = 0.1\nmass = 1.0\nat = [0.5]").unwrap();
/// let start = Start::new(&scenario).unwrap();
/// let speed = method::with(MethodName::Emd, &scenario, &start, |method| {
///     method.advance_to(1.0)?;
///     Ok(method.grains()[1].velocity[0])
/// }).unwrap();
/// assert!((speed - 1.0).abs() < 1e-6);
/// ```
pub fn with<T>(
    name: MethodName,
    scenario: &Scenario,
    start: &Start,
    work: impl FnOnce(&mut dyn Method) -> Result<T>,
) -> Result<T> {
    with_state(name, scenario, start, None, work)
}

/// As [`with`], from a state that [`Method::save`] gave. A method that cannot be saved begins anew.
///
/// # Errors
/// As [`with`], and when the state is not one of such a world.
pub fn with_state<T>(
    name: MethodName,
    scenario: &Scenario,
    start: &Start,
    state: Option<&[u8]>,
    work: impl FnOnce(&mut dyn Method) -> Result<T>,
) -> Result<T> {
    match start.dimension {
        1 => with_dimension::<1, T>(name, scenario, start, state, work),
        2 => with_dimension::<2, T>(name, scenario, start, state, work),
        _ => with_dimension::<3, T>(name, scenario, start, state, work),
    }
}

fn with_dimension<const D: usize, T>(
    name: MethodName,
    scenario: &Scenario,
    start: &Start,
    state: Option<&[u8]>,
    work: impl FnOnce(&mut dyn Method) -> Result<T>,
) -> Result<T> {
    let context = || name.label();
    match name {
        MethodName::Md => {
            let (system, law) = system::<D>(scenario, start)?;
            let (end, options) = (carom_reference::End::Force, VerletOptions::default());
            let run = Verlet::new(&system, law, end, options).with_context(context)?;
            work(&mut ForceBased::new(run, start)).with_context(context)
        }
        MethodName::Exact => {
            let (system, law) = system::<D>(scenario, start)?;
            let run = Exact::new(system, law, carom_reference::End::Force).with_context(context)?;
            work(&mut ForceBased::new(run, start)).with_context(context)
        }
        MethodName::Emd | MethodName::EmdStar => {
            with_world::<D, T>(name, scenario, start, state, work).with_context(context)
        }
    }
}

/// A saved world of the core.
type Saved<const D: usize> = Snapshot<f64, D, Vec<Body<f64, D>>, Vec<ScheduledEvent<f64>>>;

fn with_world<const D: usize, T>(
    name: MethodName,
    scenario: &Scenario,
    start: &Start,
    state: Option<&[u8]>,
    work: impl FnOnce(&mut dyn Method) -> Result<T>,
) -> Result<T> {
    let rules = rules(name, scenario, &start.laws)?;
    let rules: Vec<&dyn Rule<f64>> = rules.iter().map(|rule| &**rule).collect();
    match &rules[..] {
        [only] => with_rule::<D, T>(name, scenario, start, state, only, work),
        _ => {
            let rule = PairRules::new(&rules).context("a rule for each pair of materials")?;
            with_rule::<D, T>(name, scenario, start, state, &rule, work)
        }
    }
}

fn with_rule<const D: usize, T>(
    name: MethodName,
    scenario: &Scenario,
    start: &Start,
    state: Option<&[u8]>,
    rule: &dyn Rule<f64>,
    work: impl FnOnce(&mut dyn Method) -> Result<T>,
) -> Result<T> {
    let layout = scenario.observe.as_ref().map(|_| Layout::new(start));
    let mut storage = HeapMemory::<f64, D>::with_capacity(start.grains.len());
    if let Some(bytes) = state {
        let (saved, tally, driving): (Saved<D>, Option<Vec<f64>>, Option<Driving<D>>) =
            postcard::from_bytes(bytes).context("the saved state is damaged")?;
        let world = World::restore(&mut storage, rule, &saved)?;
        let method = EventDriven::new(world, name, scenario.options.events);
        let method = method.with_tally(layout.as_ref(), tally.as_deref());
        return work(&mut method.driven(driving));
    }
    let builder = World::builder(&mut storage).gravity(first(&start.gravity));
    let builder = builder.enduring(enduring(scenario));
    let builder =
        enclose(builder.release(release(scenario)).tc(scenario.options.tc), start).rule(rule);
    let materials = start.materials.iter().copied().chain(std::iter::repeat(0));
    let grains = start.grains.iter().zip(materials).map(|(grain, material)| {
        Grain::with_mass(grain.radius, grain.mass)
            .at(first(&grain.position))
            .moving(first(&grain.velocity))
            .of_material(material)
    });
    let world = builder.grains(grains).and_then(WorldBuilder::start)?;
    let method = EventDriven::new(world, name, scenario.options.events);
    let driving = driving(scenario, start)?;
    work(&mut method.with_tally(layout.as_ref(), None).driven(driving))
}

/// What drives a run, if anything does.
fn driving<const D: usize>(scenario: &Scenario, start: &Start) -> Result<Option<Driving<D>>> {
    let sources = sources(scenario, start);
    let is_driven = !sources.is_empty();
    let driving = || Driving::new(sources, start.grains.len(), scenario.seed);
    is_driven.then(driving).transpose()
}

fn enduring(scenario: &Scenario) -> Enduring {
    match scenario.options.enduring {
        EnduringSpec::Paper => Enduring::Paper,
        EnduringSpec::Integrated => Enduring::Integrated,
    }
}

fn release(scenario: &Scenario) -> Release {
    match scenario.options.release {
        ReleaseSpec::Paired => Release::Paired,
        ReleaseSpec::Independent => Release::Independent,
    }
}

fn enclose<'m, const D: usize, R>(
    mut builder: WorldBuilder<'m, f64, D, R>,
    start: &Start,
) -> WorldBuilder<'m, f64, D, R> {
    for (axis, side) in start.sides.iter().enumerate().take(D) {
        match *side {
            Side::Open => {}
            Side::Periodic(range) => builder = builder.periodic_axis(axis, range),
            Side::Plate(plate, made) => {
                let Plate { at, amplitude, frequency, phase } = plate;
                let shaking = Shaking { amplitude, frequency, phase };
                builder = builder.plane(wall(axis, (at, 1.0), made, Some(shaking)));
            }
            Side::Walls([from, to], made, shaking) => {
                for end in [(from, 1.0), (to, -1.0)] {
                    builder = builder.plane(wall(axis, end, made, shaking));
                }
            }
        }
    }
    builder
}

/// The wall across an axis that faces up or down it; a positive amplitude moves it up first, wherever it faces.
fn wall<const D: usize>(
    axis: usize,
    (at, facing): (f64, f64),
    made: Made,
    shaking: Option<Shaking>,
) -> Plane<f64, D> {
    let mut normal = [0.0; D];
    normal[axis] = facing;
    let surface = match made {
        Made::Soft => Surface::Rule,
        Made::Hard(restitution) => Surface::Hard(restitution),
        Made::Of(material) => Surface::Material(material),
    };
    let plane = Plane::new(normal, facing * at, surface);
    match shaking.filter(|shaking| shaking.amplitude != 0.0) {
        Some(Shaking { amplitude, frequency, phase }) => {
            plane.vibrating(Vibration::new(facing * amplitude, frequency).starting_at(phase))
        }
        None => plane,
    }
}

fn system<const D: usize>(
    scenario: &Scenario,
    start: &Start,
) -> Result<(carom_reference::System<D>, carom_reference::ForceLaw)> {
    let boundary = std::array::from_fn(|axis| match start.sides[axis] {
        Side::Periodic([lo, hi]) => carom_reference::Boundary::Periodic { lo, hi },
        Side::Walls([lo, hi], ..) => carom_reference::Boundary::Walls { lo, hi },
        Side::Plate(plate, _) => carom_reference::Boundary::Plate(plate),
        Side::Open => carom_reference::Boundary::Open,
    });
    let grains = start.grains.iter().map(|grain| carom_reference::Grain {
        radius: grain.radius,
        mass: grain.mass,
        position: first(&grain.position),
        velocity: first(&grain.velocity),
    });
    let system = carom_reference::System::new(grains.collect(), boundary, first(&start.gravity))?;
    Ok((system, force_law(scenario)?))
}

/// The first `D` of three numbers.
fn first<const D: usize>(numbers: &[f64; 3]) -> [f64; D] {
    std::array::from_fn(|k| numbers[k])
}

/// The rules of an event-driven method for all pairs of materials, row by row; pairs that never meet have
/// that of another.
///
/// # Errors
/// When no two materials have a law, or one has no such rule.
pub fn rules(
    name: MethodName,
    scenario: &Scenario,
    laws: &Laws,
) -> Result<Vec<Box<dyn Rule<f64>>>> {
    let all = || laws.pairs().flatten();
    let some = all().next().context("there is no law")?;
    if name == MethodName::EmdStar && !all().any(|law| law.has_force()) {
        bail!("{} needs a force law, but law.kind is constant", name.label());
    }
    Ok(laws.pairs().map(|law| rule(name, scenario, law.unwrap_or(some))).collect())
}

/// The collision rule of an event-driven method.
fn rule(name: MethodName, scenario: &Scenario, law: LawSpec) -> Box<dyn Rule<f64>> {
    match law {
        LawSpec::Constant { restitution } => Box::new(HardSphere { restitution }),
        LawSpec::Lsd { stiffness, damping } => {
            let law = LinearDashpot { stiffness, damping };
            match scenario.options.matrix {
                MatrixSpec::Integrate => by_method(name, Integrated::new(law)),
                MatrixSpec::Table => {
                    let table = embedded(scenario.options.table, Law::LinearDashpot);
                    by_method(name, Soft::with_table(law, table, outside(scenario)))
                }
            }
        }
        LawSpec::Viscoelastic { young, poisson, dissipation } => {
            let law = Viscoelastic { young, poisson, dissipation };
            match scenario.options.matrix {
                MatrixSpec::Integrate => by_method(name, Integrated::new(law)),
                MatrixSpec::Table => {
                    let table = embedded(scenario.options.table, Law::Viscoelastic);
                    by_method(name, Soft::with_table(law, table, outside(scenario)))
                }
            }
        }
    }
}

/// eMD takes only the central restitution of the rule, eMD* all of it.
fn by_method(name: MethodName, rule: impl Rule<f64> + 'static) -> Box<dyn Rule<f64>> {
    match name {
        MethodName::Emd => Box::new(Central(rule)),
        _ => Box::new(rule),
    }
}

fn outside(scenario: &Scenario) -> Outside {
    match scenario.options.outside {
        OutsideSpec::Reject => Outside::Reject,
        OutsideSpec::Clamp => Outside::Clamp,
        OutsideSpec::HardSphere => Outside::HardSphere,
    }
}

/// The force law of the reference.
///
/// # Errors
/// When the law has no force.
pub fn force_law(scenario: &Scenario) -> Result<carom_reference::ForceLaw> {
    match scenario.only_law().context("MD needs one law for all contacts")? {
        LawSpec::Lsd { stiffness, damping } => {
            Ok(carom_reference::ForceLaw::LinearDashpot { stiffness, damping })
        }
        LawSpec::Viscoelastic { young, poisson, dissipation } => {
            Ok(carom_reference::ForceLaw::Viscoelastic { young, poisson, dissipation })
        }
        LawSpec::Constant { .. } => bail!("MD needs a force law, but law.kind is constant"),
    }
}
