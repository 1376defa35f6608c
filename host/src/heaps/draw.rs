//! Which boxes are drawn? Reads a seed; writes nothing, returns grains, walls, gravity and law in plain numbers.
//!
//! The largest radius, its mass and gravity are 1, so that the unit of time is (R/g)^½: 10 ms for grains of 1 mm.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// What gravity does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Gravity {
    /// Straight down.
    Constant,
    /// Straight down, on a vibrating plate.
    Plate,
    /// In another direction every 25 ms (for R = 1 mm).
    Swinging,
    /// There is none.
    Zero,
}

/// What grains do when they touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LawKind {
    /// A constant coefficient of restitution.
    Hard(f64),
    /// Spring constant and damping.
    Linear([f64; 2]),
    /// Young's modulus and dissipation.
    Viscoelastic([f64; 2]),
}

impl LawKind {
    /// As it is written in a table.
    pub const fn label(&self) -> &'static str {
        match self {
            Self::Hard(_) => "hard",
            Self::Linear(_) => "linear",
            Self::Viscoelastic(_) => "viscoelastic",
        }
    }

    /// Whether it takes at least a tenth of the speed.
    fn is_lossy(&self) -> bool {
        match *self {
            Self::Hard(restitution) => restitution <= 0.9,
            Self::Linear([_, damping]) => damping > 0.0,
            Self::Viscoelastic([_, dissipation]) => dissipation > 0.0,
        }
    }
}

/// A grain: radius, mass, position and velocity; the last axis points up.
#[derive(Clone, Copy, Debug)]
pub struct DrawnGrain {
    pub radius: f64,
    pub mass: f64,
    pub position: [f64; 3],
    pub velocity: [f64; 3],
}

/// A plane: grains stay where normal · r ≥ offset.
#[derive(Clone, Copy, Debug)]
pub struct DrawnPlane {
    pub normal: [f64; 3],
    pub offset: f64,
    /// Amplitude and frequency of a plate.
    pub vibration: Option<[f64; 2]>,
}

/// A box.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// What it was drawn from.
    pub seed: u64,
    /// 1, 2 or 3.
    pub dimension: usize,
    pub(super) grains: Vec<DrawnGrain>,
    pub(super) planes: Vec<DrawnPlane>,
    /// The coefficient of restitution of hard planes; none: the grains' law.
    pub hard_walls: Option<f64>,
    /// What gravity does.
    pub gravity: Gravity,
    /// The grains' law.
    pub law: LawKind,
    layers: usize,
}

impl Drawn {
    /// How many grains there are.
    pub fn count(&self) -> usize {
        self.grains.len()
    }

    /// Up to when it must sleep, if it must: where every contact loses energy and nothing drives it.
    pub fn must_sleep_by(&self) -> Option<f64> {
        let lossy = self.law.is_lossy() && self.hard_walls.is_none_or(|e| e <= 0.9);
        let calm = lossy && self.gravity == Gravity::Constant;
        match self.count() {
            0..=20 if calm => Some(400.0 + self.ringing()),
            21..=50 if calm => Some(1200.0 + self.ringing()),
            _ => None,
        }
    }

    /// How long the heap, taken as a column of its layers, rings by its own law: eight times 1/δ of its
    /// lowest mode, δ = γ/(2 m) (π/2N)² for N of mass m. A stand-in's dashpot sees to itself.
    fn ringing(&self) -> f64 {
        let layers = self.layers as f64;
        let damping = match self.law {
            LawKind::Hard(_) => return 0.0,
            LawKind::Linear([_, damping]) => damping,
            LawKind::Viscoelastic([young, dissipation]) => {
                // A dF/dx under half the weight of the column.
                let rigidity = young * 2.0 / 3.0 * 0.5_f64.sqrt() / (1.0 - 0.3 * 0.3);
                dissipation * 1.5 * rigidity.powf(2.0 / 3.0) * (layers / 2.0).cbrt()
            }
        };
        16.0 / damping * (2.0 * layers / std::f64::consts::PI).powi(2)
    }

    /// The radius of the smallest grain.
    pub fn smallest(&self) -> f64 {
        self.grains.iter().fold(1.0, |least, grain| grain.radius.min(least))
    }
}

/// The box of a seed. `heavy` makes a small grain's mass no less than fits a number with 16 binary places.
pub fn draw(seed: u64, most: usize, heavy: bool) -> Drawn {
    let mut rng = Pcg64::seed_from_u64(seed);
    let dimension = [1, 2, 2, 2, 3][rng.random_range(0..5)];
    let count = count(&mut rng, most);
    let unequal = rng.random_bool(0.5);
    let power = if heavy { 1 } else { dimension as i32 };
    let radii: Vec<f64> =
        (0..count).map(|_| if unequal { rng.random_range(0.2..1.0) } else { 1.0 }).collect();
    let gravity = match rng.random_range(0..8) {
        0..5 => Gravity::Constant,
        5 => Gravity::Plate,
        6 => Gravity::Swinging,
        _ => Gravity::Zero,
    };
    let law = law(&mut rng, if heavy { [2500.0, 8000.0] } else { [8000.0, 20_000.0] });
    let hard_walls = rng.random_bool(0.5).then(|| restitution(&mut rng));
    let wide = 2.0 * f64::from(rng.random_range(1..=5));
    let wide = if rng.random_bool(0.3) { wide } else { wide * rng.random_range(1.0..1.3) };
    let wedge = dimension > 1 && rng.random_bool(0.2);
    let slope = if wedge { rng.random_range(0.2..1.7) } else { 0.0 };
    let layers =
        count.div_ceil((((wide / 2.0001).floor() as usize).max(1)).pow(dimension as u32 - 1));
    let (grains, height) = place(&mut rng, &radii, power, dimension, [wide, slope], gravity);
    let mut planes = sides(&mut rng, dimension, [wide, height], gravity);
    if wedge {
        planes.extend(wedges(&mut rng, dimension, wide, slope));
    }
    Drawn { seed, dimension, grains, planes, hard_walls, gravity, law, layers }
}

/// Half of all boxes have few grains.
fn count(rng: &mut Pcg64, most: usize) -> usize {
    let range = match rng.random_range(0..20) {
        0..10 => 1..=10,
        10..16 => 11..=30,
        16..19 => 31..=80,
        _ => 81..=200,
    };
    rng.random_range(range).min(most)
}

fn restitution(rng: &mut Pcg64) -> f64 {
    [0.0, 0.1, 0.3, 0.5, 0.7, 0.8, 0.9, 0.98, 1.0][rng.random_range(0..9)]
}

fn law(rng: &mut Pcg64, [stiffness, young]: [f64; 2]) -> LawKind {
    let loses = rng.random_bool(0.7);
    match rng.random_range(0..4) {
        0..2 => LawKind::Hard(restitution(rng)),
        2 => {
            let scaled = if loses { rng.random_range(0.15..0.6) } else { 0.0 };
            LawKind::Linear([stiffness, scaled * (stiffness / 2.0).sqrt()])
        }
        _ => {
            let dissipation = if loses { rng.random_range(0.002..0.01) } else { 0.0 };
            LawKind::Viscoelastic([young, dissipation])
        }
    }
}

/// Grains in layers, each somewhere in its cell; and the height of the box.
fn place(
    rng: &mut Pcg64,
    radii: &[f64],
    power: i32,
    dimension: usize,
    [wide, slope]: [f64; 2],
    gravity: Gravity,
) -> (Vec<DrawnGrain>, f64) {
    let row = ((wide / 2.0001).floor() as usize).max(1);
    let cell = wide / row as f64;
    let base = if slope > 0.0 { 2.0 + slope * wide } else { 1.01 };
    let speed = if gravity == Gravity::Zero { 1.5 } else { 0.2 };
    let mut height = base;
    let grains = radii.iter().enumerate().map(|(i, &radius)| {
        let mut layer = i;
        let mut position = [0.0; 3];
        for x in position.iter_mut().take(dimension - 1) {
            let free = (cell / 2.0 - radius - 1e-3).max(0.0);
            *x = (layer % row) as f64 * cell + cell / 2.0 + free * rng.random_range(-1.0..1.0);
            layer /= row;
        }
        position[dimension - 1] = base + 2.05 * layer as f64;
        height = position[dimension - 1];
        let mut velocity = [0.0; 3];
        velocity.iter_mut().take(dimension).for_each(|v| *v = rng.random_range(-speed..speed));
        DrawnGrain { radius, mass: radius.powi(power), position, velocity }
    });
    let grains = grains.collect();
    (grains, height + 3.0)
}

/// The sides of the box, its floor at 0 (a plate somewhat below).
fn sides(
    rng: &mut Pcg64,
    dimension: usize,
    [wide, height]: [f64; 2],
    gravity: Gravity,
) -> Vec<DrawnPlane> {
    let mut planes = Vec::new();
    for axis in 0..dimension {
        let up = axis == dimension - 1;
        for (sign, at) in [(1.0, 0.0), (-1.0, if up { height } else { wide })] {
            let mut normal = [0.0; 3];
            normal[axis] = sign;
            let plate = up && sign > 0.0 && gravity == Gravity::Plate;
            let vibration =
                plate.then(|| [rng.random_range(0.02..0.2), rng.random_range(0.1..0.8)]);
            let offset = sign * at - vibration.map_or(0.0, |[amplitude, _]| amplitude);
            planes.push(DrawnPlane { normal, offset, vibration });
        }
    }
    planes
}

/// One plane that cuts off a lower corner, or two that make a funnel.
fn wedges(rng: &mut Pcg64, dimension: usize, wide: f64, slope: f64) -> Vec<DrawnPlane> {
    let length = slope.hypot(1.0);
    let both = rng.random_bool(0.5);
    let across = |sign: f64| {
        let mut normal = [0.0; 3];
        (normal[0], normal[dimension - 1]) = (sign * slope / length, 1.0 / length);
        // Through the floor in the middle, or at the far side.
        let foot = if both { wide / 2.0 } else { wide };
        DrawnPlane { normal, offset: normal[0] * foot, vibration: None }
    };
    if both { vec![across(1.0), across(-1.0)] } else { vec![across(1.0)] }
}
