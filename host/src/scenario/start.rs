//! Where does everything stand? Reads a scenario; writes nothing, returns grains and box at time 0.

use super::bounds::{flow, made, sides};
use super::clear::Obstacles;
use super::friction;
use super::gas;
use super::grains::{GrainSpec, PlaceSpec};
use super::laws::Laws;
use super::motion::Motion;
use super::outside::{Room, outside};
use super::populate::{self, Population};
use super::problem::Problem;
use super::side::{Flow, Placed, Side, sphere_mass};
use super::spec::Scenario;
use super::standing::Standing;
use super::walls::{self, Wall};
use anyhow::Result;

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
    /// What they are called, in the order of the scenario.
    pub obstacles: Vec<Standing>,
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

    /// Of which obstacle a facet is, and what it is called.
    pub fn facet(&self, number: usize) -> Option<(usize, String)> {
        let obstacle = self.walls.get(number)?.obstacle;
        Some((obstacle, self.obstacles.get(obstacle)?.facet(obstacle, number)))
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
        start.stand(scenario)?;
        let obstacles = Obstacles::new(&start.walls, &start.motions, &start.obstacles);
        start.list(scenario);
        start.scatter(scenario, &obstacles)?;
        start.populate(scenario, &obstacles, &mut populations)?;
        start.inertia = scenario.inertia.unwrap_or(friction::SPHERE);
        if scenario.has_friction() {
            start.rotations = scenario.grains.iter().map(rotation).collect();
            start.rotations.resize(start.grains.len(), [0.0; 3]);
        }
        Ok(start)
    }

    /// Puts obstacles up.
    fn stand(&mut self, scenario: &Scenario) -> Result<(), Problem> {
        for (number, obstacle) in scenario.obstacles.iter().enumerate() {
            let made = made(&self.laws, obstacle.made());
            let (inside, mut walls) = walls::walls((number, obstacle), &scenario.folder, made)?;
            let (file, piece) = (obstacle.file.clone(), obstacle.piece());
            self.obstacles.push(Standing { file, piece, inside, first: self.walls.len() });
            if let Some(motion) = Motion::of(obstacle) {
                let number = u8::try_from(self.motions.len()).ok();
                walls.iter_mut().for_each(|wall| wall.motion = number);
                self.motions.push(motion);
            }
            self.walls.extend(walls);
        }
        let room = Room::new(self.dimension, &self.sides, &self.steady);
        outside(&room, &self.walls, &self.obstacles).map_or(Ok(()), Err)
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

    fn scatter(&mut self, scenario: &Scenario, obstacles: &Obstacles) -> Result<(), Problem> {
        let Some(gas) = &scenario.gas else { return Ok(()) };
        let density = density(scenario, &self.laws, gas.density, gas.material.as_deref());
        let first = self.grains.len();
        gas::scatter((gas, density), &self.sides, obstacles, &mut self.grains, self.dimension)?;
        self.let_flow(first, |_| true);
        self.label("gas", gas.material.as_deref());
        Ok(())
    }

    fn populate(
        &mut self,
        scenario: &Scenario,
        obstacles: &Obstacles,
        populations: &mut [Population<'_>],
    ) -> Result<(), Problem> {
        let (first, first_grain) = (self.species_names.len(), self.grains.len());
        let of =
            populate::place(scenario, (&self.sides, obstacles), populations, &mut self.grains)?;
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
