//! Where does everything stand? Reads a scenario; writes nothing, returns grains and box at time 0.

use super::friction;
use super::gas;
use super::grains::{GrainSpec, PlaceSpec};
use super::laws::Laws;
use super::populate::{self, Population};
use super::problem::Problem;
use super::side::{Flow, Made, Placed, Shaking, Side, filled, sphere_mass};
use super::sides::{MadeSpec, SideSpec, SurfaceSpec};
use super::spec::Scenario;
use super::walls::{self, Motion, Wall};
use anyhow::Result;
use carom_reference::Plate;

/// Grains, box and gravity: the same for every method.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Start {
    /// 1, 2 or 3.
    pub dimension: usize,
    /// The grains.
    pub grains: Vec<Placed>,
    /// The box; axes beyond the dimension are open.
    pub sides: [Side; 3],
    /// How fast the lower and the upper wall of each axis go on steadily: where `sides` has them, they are at time 0.
    pub steady: [[f64; 2]; 3],
    /// The flow of a sheared box.
    pub flow: Option<Flow>,
    /// Uniform gravity.
    pub gravity: [f64; 3],
    /// What each grain is made of: a number of [`Laws::names`].
    pub materials: Vec<u8>,
    /// Of which species each grain is: a number of `species_names`.
    pub species: Vec<u16>,
    /// What species are called; grains that are listed one by one are the first, and a gas the next.
    pub species_names: Vec<String>,
    /// The angular velocity of each grain, where there is friction; else nothing.
    pub rotations: Vec<[f64; 3]>,
    /// I/(m R²) of all grains.
    pub inertia: f64,
    /// Whether the scenario has `[[species]]`.
    pub has_species: bool,
    /// What two materials do when they touch.
    pub laws: Laws,
    /// The facets of all obstacles, in the order of the scenario and of its files.
    pub walls: Vec<Wall>,
    /// How obstacles move.
    pub motions: Vec<Motion>,
}

impl Start {
    /// Places everything.
    ///
    /// # Errors
    /// When the box has no size, or grains find no place.
    pub fn new(scenario: &Scenario) -> Result<Self> {
        Ok(Self::of(scenario)?)
    }

    /// Separation of two points, nearest image.
    pub fn nearest(&self, a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
        std::array::from_fn(|k| self.sides[k].nearest(a[k] - b[k]))
    }

    /// Where an axis begins and ends all of the time; none where it does not, or walls go on.
    pub fn range(&self, axis: usize) -> Option<[f64; 2]> {
        self.sides[axis].range().filter(|_| self.steady[axis] == [0.0; 2])
    }

    /// Where an axis begins and ends at a time, if it does.
    pub fn range_at(&self, axis: usize, time: f64) -> Option<[f64; 2]> {
        let ends = self.sides[axis].range()?;
        Some([0, 1].map(|end| ends[end] + self.steady[axis][end] * time))
    }

    /// Mean radius of the grains.
    pub fn mean_radius(&self) -> f64 {
        self.grains.iter().map(|grain| grain.radius).sum::<f64>() / self.grains.len() as f64
    }

    fn of(scenario: &Scenario) -> Result<Self, Problem> {
        let laws = Laws::new(scenario);
        let densities: Vec<f64> = scenario
            .species
            .iter()
            .map(|species| density(scenario, &laws, species.density, species.material.as_deref()))
            .collect();
        let mut populations = populate::populations(scenario, &densities)?;
        let sides = sides(scenario, &laws, &populations)?;
        let mut start = Self { dimension: scenario.dimension, sides, laws, ..Self::default() };
        start.steady = scenario.sides.named().map(|(_, side)| side.moving());
        start.gravity = padded(&scenario.gravity);
        start.flow = flow(scenario, &start.sides);
        start.has_species = !scenario.species.is_empty();
        for (number, obstacle) in scenario.obstacles.iter().enumerate() {
            let made = made(&start.laws, obstacle.made());
            let mut walls = walls::walls((number, obstacle), &scenario.folder, made)?;
            if let Some(motion) = Motion::of(obstacle) {
                let number = u8::try_from(start.motions.len()).ok();
                walls.iter_mut().for_each(|wall| wall.motion = number);
                start.motions.push(motion);
            }
            start.walls.extend(walls);
        }
        start.list(scenario);
        start.scatter(scenario)?;
        start.populate(scenario, &mut populations)?;
        start.inertia = scenario.inertia.unwrap_or(friction::SPHERE);
        if scenario.has_friction() {
            start.rotations = scenario.grains.iter().map(rotation).collect();
            start.rotations.resize(start.grains.len(), [0.0; 3]);
        }
        Ok(start)
    }

    /// Gives grains from a number on the velocity of the flow besides their own, those which (counted from there) take it.
    fn let_flow(&mut self, first: usize, takes: impl Fn(usize) -> bool) {
        let Some(flow) = self.flow else { return };
        let added = self.grains[first..].iter_mut().enumerate();
        for (_, grain) in added.filter(|(k, _)| takes(*k)) {
            grain.velocity[flow.along] += flow.speed(&grain.position);
        }
    }

    /// Notes what the grains are that were added last.
    fn label(&mut self, name: &str, material: Option<&str>) {
        let count = self.grains.len() - self.species.len();
        let number = self.laws.number(material).unwrap_or(0);
        self.species.extend(std::iter::repeat_n(self.species_names.len() as u16, count));
        self.materials.extend(std::iter::repeat_n(number as u8, count));
        if self.species_names.last().is_none_or(|last| last != name) {
            self.species_names.push(name.to_owned());
        }
    }

    fn list(&mut self, scenario: &Scenario) {
        for grain in &scenario.grains {
            self.grains.push(placed(scenario, &self.laws, grain));
            self.species.push(0);
            self.materials.push(self.laws.number(grain.material.as_deref()).unwrap_or(0) as u8);
        }
        if !scenario.grains.is_empty() {
            self.species_names.push("grain".to_owned());
        }
    }

    fn scatter(&mut self, scenario: &Scenario) -> Result<(), Problem> {
        let Some(gas) = &scenario.gas else { return Ok(()) };
        let density = density(scenario, &self.laws, gas.density, gas.material.as_deref());
        let first = self.grains.len();
        gas::scatter(gas, density, &self.sides, self.dimension, &mut self.grains)?;
        self.let_flow(first, |_| true);
        self.label("gas", gas.material.as_deref());
        Ok(())
    }

    fn populate(
        &mut self,
        scenario: &Scenario,
        populations: &mut [Population<'_>],
    ) -> Result<(), Problem> {
        let (first, first_grain) = (self.species_names.len(), self.grains.len());
        let of = populate::place(scenario, &self.sides, populations, &mut self.grains)?;
        let is_told = |k: usize| matches!(scenario.species[k].place, PlaceSpec::File { .. });
        self.let_flow(first_grain, |grain| !is_told(of[grain]));
        let number =
            |k: usize| self.laws.number(scenario.species[k].material.as_deref()).unwrap_or(0) as u8;
        self.materials.extend(of.iter().map(|k| number(*k)));
        self.species.extend(of.iter().map(|k| (first + k) as u16));
        let name = |(k, species): (usize, &super::grains::SpeciesSpec)| {
            species.name.clone().unwrap_or_else(|| format!("species {k}"))
        };
        self.species_names.extend(scenario.species.iter().enumerate().map(name));
        Ok(())
    }
}

/// The density of what is made of this material, if it does not say its own.
fn density(scenario: &Scenario, laws: &Laws, own: Option<f64>, material: Option<&str>) -> f64 {
    let number = laws.number(material).ok();
    let of_material = || scenario.materials.get(number?)?.density;
    own.or_else(of_material).unwrap_or_default()
}

fn placed(scenario: &Scenario, laws: &Laws, grain: &GrainSpec) -> Placed {
    let density = density(scenario, laws, grain.density, grain.material.as_deref());
    Placed {
        radius: grain.radius,
        mass: grain.mass.unwrap_or_else(|| sphere_mass(grain.radius, density)),
        position: padded(&grain.at),
        velocity: padded(&grain.moving),
    }
}

/// About the third axis in two dimensions.
fn rotation(grain: &GrainSpec) -> [f64; 3] {
    match grain.rotating[..] {
        [x, y, z] => [x, y, z],
        [z] => [0.0, 0.0, z],
        _ => [0.0; 3],
    }
}

fn padded(numbers: &[f64]) -> [f64; 3] {
    std::array::from_fn(|k| numbers.get(k).copied().unwrap_or(0.0))
}

/// The box, its size set by a packing fraction where sides say none.
fn sides(
    scenario: &Scenario,
    laws: &Laws,
    populations: &[Population<'_>],
) -> Result<[Side; 3], Problem> {
    let edge = edge(scenario, populations)?;
    let mut sides = [Side::Open; 3];
    for (side, (name, spec)) in sides.iter_mut().zip(scenario.sides.named()) {
        let range = |from: Option<f64>, to: Option<f64>| match (from, to, edge) {
            (Some(from), Some(to), _) => Ok([from, to]),
            (_, _, Some(edge)) => Ok([0.0, edge]),
            _ => {
                let message = format!(
                    "box.{name}: give from and to [m], or gas.packing_fraction or box.packing_fraction"
                );
                Err(Problem { path: format!("box.{name}"), offset: None, message })
            }
        };
        let made = made(laws, spec.surface().unwrap_or_default());
        *side = match *spec {
            SideSpec::Open => Side::Open,
            SideSpec::Periodic { from, to } => Side::Periodic(range(from, to)?),
            SideSpec::Walls { from, to, amplitude, frequency, phase, .. } => {
                let shaking = Shaking { amplitude, frequency, phase };
                Side::Walls(range(from, to)?, made, (amplitude != 0.0).then_some(shaking))
            }
            SideSpec::Plate { at, amplitude, frequency, phase, .. } => {
                Side::Plate(Plate { at, amplitude, frequency, phase }, made)
            }
        };
    }
    Ok(sides)
}

/// The flow of a sheared box.
fn flow(scenario: &Scenario, sides: &[Side; 3]) -> Option<Flow> {
    let shear = scenario.sides.shear?;
    let [from, to] = sides[shear.gradient.number()].range()?;
    let (along, gradient) = (shear.flow.number(), shear.gradient.number());
    Some(Flow { along, gradient, rate: shear.rate, middle: 0.5 * (from + to) })
}

fn made(laws: &Laws, (surface, restitution, material): MadeSpec<'_>) -> Made {
    match (material, restitution) {
        (Some(name), _) => Made::Of(laws.number(Some(name)).unwrap_or(0) as u8),
        (None, Some(restitution)) => Made::Hard(restitution),
        (None, None) if surface == Some(SurfaceSpec::Hard) => Made::Hard(1.0),
        (None, None) => Made::Soft,
    }
}

/// How long the sides are that say no size, so that the packing fraction is what the scenario says.
fn edge(scenario: &Scenario, populations: &[Population<'_>]) -> Result<Option<f64>, Problem> {
    let of_gas = scenario.gas.as_ref().and_then(|gas| gas.packing_fraction);
    let (path, packing) = match (scenario.sides.packing_fraction, of_gas) {
        (Some(packing), None) => ("box.packing_fraction", packing),
        (None, Some(packing)) => ("gas.packing_fraction", packing),
        (None, None) => return Ok(None),
        (Some(_), Some(_)) => {
            let message =
                "box.packing_fraction is given, and so is gas.packing_fraction: give one of them";
            return Err(Problem {
                path: "box.packing_fraction".to_owned(),
                offset: None,
                message: message.to_owned(),
            });
        }
    };
    let d = scenario.dimension;
    let (mut sized, mut unsized_axes, mut has_plate) = (1.0, 0, false);
    for (_, spec) in &scenario.sides.named()[..d] {
        match spec {
            SideSpec::Periodic { from, to } | SideSpec::Walls { from, to, .. } => {
                match (from, to) {
                    (Some(from), Some(to)) => sized *= to - from,
                    _ => unsized_axes += 1,
                }
            }
            SideSpec::Plate { .. } => has_plate = true,
            SideSpec::Open => {}
        }
    }
    if unsized_axes == 0 && has_plate {
        return Ok(None);
    }
    if unsized_axes == 0 {
        let message =
            format!("{path} sets the size of the box: leave out from and to of a side, or it");
        return Err(Problem { path: path.to_owned(), offset: None, message });
    }
    let radii = |population: &Population<'_>| population.radii.clone();
    let mut all: Vec<f64> = populations.iter().flat_map(radii).collect();
    all.extend(scenario.gas.iter().flat_map(gas::radii));
    if path == "box.packing_fraction" {
        all.extend(scenario.grains.iter().map(|grain| grain.radius));
    }
    let volume: f64 = all.into_iter().map(|radius| filled(radius, d)).sum();
    let axes = unsized_axes + i32::from(has_plate);
    Ok(Some((volume / (packing * sized)).powf(1.0 / f64::from(axes))))
}
