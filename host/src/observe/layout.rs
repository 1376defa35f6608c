//! Which sum stands where? Reads the start of a run; writes nothing, numbers the sums.

use super::obstacles::{Observed, Struck};
use crate::scenario::{Flow, Side, Start};
use std::ops::Range;

/// What is summed for every kind of contact, one after the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contact {
    /// How many began.
    Count,
    /// Those of them that last.
    Lasting,
    /// Kinetic energy that went (J).
    Loss,
    /// Speeds of approach (m/s).
    Approach,
    /// Coefficients of restitution.
    Restitution,
    /// Durations (s).
    Duration,
}

impl Contact {
    /// How many there are.
    pub const COUNT: usize = 6;
}

/// What is summed for every plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wall {
    /// Contacts that began.
    Count,
    /// Momentum given to the plane, along its normal and away from the grains (kg m/s).
    Push,
    /// Kinetic energy that grains lost there (J).
    Loss,
}

impl Wall {
    /// How many there are.
    pub const COUNT: usize = 3;
}

/// What is summed over states, for every species.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// Grains.
    Count,
    /// m v² along an axis, of velocities from the mean one (J).
    Square(usize),
    /// v² (m²/s²).
    Second,
    /// v⁴ (m⁴/s⁴).
    Fourth,
}

impl State {
    /// How many there are.
    pub const COUNT: usize = 6;
}

/// The largest number of species that are told apart.
const MAX_SPECIES: usize = 16;

/// Where the sums of a run stand.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// 1, 2 or 3.
    pub dimension: usize,
    /// Of which species each grain is.
    pub species: Vec<u16>,
    /// What species are called.
    pub names: Vec<String>,
    /// The box.
    pub sides: [Side; 3],
    /// The flow of a sheared box.
    pub flow: Option<Flow>,
    /// The planes: their names and their areas, where these are known.
    pub walls: Vec<(String, Option<f64>)>,
    /// The obstacles.
    pub obstacles: Vec<Observed>,
    /// Of which of them each facet is.
    pub facets: Vec<usize>,
    /// Volume of the box, if it is bounded.
    pub volume: Option<f64>,
    /// The mass of a grain of each species, the mean if they differ, and how many there are.
    pub masses: Vec<(f64, usize)>,
}

impl Layout {
    /// The sums of this system.
    pub fn new(start: &Start) -> Self {
        let (species, names) = species(start);
        let masses = (0..names.len()).map(|s| mass(start, &species, s)).collect();
        let length = |axis: usize| start.range(axis).map(|[from, to]| to - from);
        let without = |left_out: usize| {
            let mut axes = (0..start.dimension).filter(|&axis| axis != left_out);
            axes.try_fold(1.0, |product, axis| Some(product * length(axis)?))
        };
        let volume = without(usize::MAX);
        let mut walls = Vec::new();
        for (axis, side) in start.sides.iter().enumerate().take(start.dimension) {
            let name = ["x", "y", "z"][axis];
            let ends: &[&str] = match side {
                Side::Walls(..) => &["from", "to"],
                Side::Plate(..) => &["plate"],
                _ => &[],
            };
            walls.extend(ends.iter().map(|end| (format!("{name} {end}"), without(axis))));
        }
        Self {
            dimension: start.dimension,
            species,
            names,
            sides: start.sides,
            flow: start.flow,
            walls,
            obstacles: Observed::all(start),
            facets: start.walls.iter().map(|facet| facet.obstacle).collect(),
            volume,
            masses,
        }
    }

    /// How many planes bound the axes before this one.
    pub fn planes_before(&self, axis: usize) -> usize {
        let planes = |side: &Side| match side {
            Side::Walls(..) => 2,
            Side::Plate(..) => 1,
            _ => 0,
        };
        self.sides.iter().take(axis).map(planes).sum()
    }

    /// How many sums collisions have.
    pub fn tally_width(&self) -> usize {
        self.obstacle(self.obstacles.len(), Struck::Count)
    }

    /// How many sums there are.
    pub fn width(&self) -> usize {
        self.tally_width() + 1 + self.dimension.pow(2) + State::COUNT * self.names.len()
    }

    /// Pairs of species, both the same included.
    pub fn pairs(&self) -> usize {
        self.names.len() * (self.names.len() + 1) / 2
    }

    /// The number of a pair of species.
    pub fn pair(&self, a: usize, b: usize) -> usize {
        let (low, high) = (a.min(b), a.max(b));
        high * (high + 1) / 2 + low
    }

    /// Time over which contacts were seen (s); 0 where a method does not show them.
    pub const TIME: usize = 0;

    /// Σ r_a Δp_b over contacts of two grains, r from the other to the one that Δp is given to (J s).
    pub fn virial(&self, a: usize, b: usize) -> usize {
        1 + a * self.dimension + b
    }

    /// A sum over contacts between two species.
    pub fn contact(&self, pair: usize, what: Contact) -> usize {
        1 + self.dimension.pow(2) + Contact::COUNT * pair + what as usize
    }

    /// A sum over contacts with a plane.
    pub fn wall(&self, wall: usize, what: Wall) -> usize {
        self.contact(self.pairs(), Contact::Count) + Wall::COUNT * wall + what as usize
    }

    /// A sum over contacts with an obstacle.
    pub fn obstacle(&self, number: usize, what: Struck) -> usize {
        self.wall(self.walls.len(), Wall::Count) + Struck::COUNT * number + what.place()
    }

    /// How many states were looked at.
    pub fn states(&self) -> usize {
        self.tally_width()
    }

    /// Σ m v_a v_b over states (J).
    pub fn stress(&self, a: usize, b: usize) -> usize {
        self.tally_width() + 1 + a * self.dimension + b
    }

    /// A sum over the states of a species.
    pub fn state(&self, species: usize, what: State) -> usize {
        let place = match what {
            State::Count => 0,
            State::Square(axis) => 1 + axis,
            State::Second => 4,
            State::Fourth => 5,
        };
        self.tally_width() + 1 + self.dimension.pow(2) + State::COUNT * species + place
    }

    /// The sums of states.
    pub fn of_states(&self) -> Range<usize> {
        self.tally_width()..self.width()
    }

    /// Whether velocities along an axis count from the mean one: not between two walls.
    pub fn is_drifting(&self, axis: usize) -> bool {
        !matches!(self.sides[axis], Side::Walls(..))
    }
}

/// The mean mass of a species, and how many grains it has.
fn mass(start: &Start, species: &[u16], which: usize) -> (f64, usize) {
    let of = || start.grains.iter().zip(species).filter(|(_, s)| usize::from(**s) == which);
    (of().map(|(grain, _)| grain.mass).sum::<f64>() / of().count() as f64, of().count())
}

/// The species of a start; very many of them are one.
fn species(start: &Start) -> (Vec<u16>, Vec<String>) {
    match start.species_names.len() {
        2..=MAX_SPECIES => (start.species.clone(), start.species_names.clone()),
        _ => (vec![0; start.grains.len()], vec!["grains".to_owned()]),
    }
}
