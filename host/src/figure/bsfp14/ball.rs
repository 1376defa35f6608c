//! Does a bouncing ball come to rest? Drops it by naive and by stable detection, and in a world of the engine; writes how that ended (BSFP14 Fig. 7).
//!
//! The ball of diameter σ = 1 falls from r = r_plate + 1, so by 1/2, with ε = 0.5; the paper does not
//! say what g is, here it is 9.81. In exact arithmetic it hits the plate first at t_1 = √(1/9.81) and comes
//! to rest, after infinitely many impacts, at t_final = t_1 (1 + ε)/(1 − ε), wherever the plate is.

use carom::detect::root;
use carom::law::HardSphere;
use carom::{Enduring, Error, Grain, Memory, World};

/// σ.
pub const SIGMA: f64 = 1.0;
/// g.
pub const GRAVITY: f64 = -9.81;
/// ε.
pub const RESTITUTION: f64 = 0.5;
/// A naive simulation with so many impacts does not halt any more.
const ENOUGH: u32 = 200;

/// The closed form of the time at which the ball comes to rest.
pub fn t_final() -> f64 {
    (2.0 * (1.0 - SIGMA / 2.0) / -GRAVITY).sqrt() * (1.0 + RESTITUTION) / (1.0 - RESTITUTION)
}

/// How the overlap function is written: three variants that differ by rounding only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// f = r − r_p − σ/2, as in Eq. (11).
    InTurn,
    /// f = r − (r_p + σ/2).
    Summed,
    /// f = r − σ/2 − r_p.
    Lowest,
}

/// How the flight is written: two variants that differ by rounding only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flight {
    /// r + Δt v + Δt²/2 g, as in Eq. (11).
    InTurn,
    /// r + Δt (v + Δt/2 g).
    Nested,
}

/// How the next impact is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Variant {
    /// By BSFP14's rule, Algorithm 2; otherwise by the quadratic formula, Eq. (12).
    pub stable: bool,
    /// How the overlap function is written.
    pub form: Form,
    /// How the flight is written.
    pub flight: Flight,
}

impl Variant {
    /// All of them: naive first.
    pub fn all() -> Vec<Self> {
        let mut all = Vec::new();
        for stable in [false, true] {
            for flight in [Flight::InTurn, Flight::Nested] {
                for form in [Form::InTurn, Form::Summed, Form::Lowest] {
                    all.push(Self { stable, form, flight });
                }
            }
        }
        all
    }

    /// By which rule the next impact is found.
    pub fn method(self) -> &'static str {
        if self.stable { "stable" } else { "naive" }
    }

    /// f in letters.
    pub fn form(self) -> &'static str {
        match self.form {
            Form::InTurn => "r − r_p − σ/2",
            Form::Summed => "r − (r_p + σ/2)",
            Form::Lowest => "r − σ/2 − r_p",
        }
    }

    /// The flight in letters.
    pub fn flight(self) -> &'static str {
        match self.flight {
            Flight::InTurn => "r + Δt v + Δt²/2 g",
            Flight::Nested => "r + Δt (v + Δt/2 g)",
        }
    }

    /// The overlap function at Δt = 0.
    fn gap(self, r: f64, plate: f64) -> f64 {
        match self.form {
            Form::InTurn => r - plate - SIGMA / 2.0,
            Form::Summed => r - (plate + SIGMA / 2.0),
            Form::Lowest => r - SIGMA / 2.0 - plate,
        }
    }

    fn fly(self, r: f64, v: f64, dt: f64) -> f64 {
        match self.flight {
            Flight::InTurn => r + dt * v + dt * dt / 2.0 * GRAVITY,
            Flight::Nested => r + dt * (v + 0.5 * dt * GRAVITY),
        }
    }

    /// The time until the next impact; none if the simulation must be halted.
    fn next(self, gap: f64, v: f64) -> Option<f64> {
        if self.stable {
            return root::plane(gap, v, GRAVITY);
        }
        let discriminant = v * v - 2.0 * GRAVITY * gap;
        (discriminant >= 0.0).then(|| -(v + discriminant.sqrt()) / GRAVITY)
    }
}

/// How one simulation ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// The discriminant became negative: no next impact could be computed.
    pub halted: bool,
    /// When.
    pub time: f64,
    /// After how many impacts.
    pub impacts: u32,
}

/// Drops the ball on a plate. It is at rest when it will not rise by as much as the last place of its position.
pub fn drop_on(plate: f64, variant: Variant) -> End {
    let (mut r, mut v, mut time) = (plate + 1.0, 0.0, 0.0);
    let mut rest = None;
    for impacts in 0..ENOUGH {
        let Some(dt) = variant.next(variant.gap(r, plate), v) else {
            return End { halted: true, time, impacts };
        };
        r = variant.fly(r, v, dt);
        v = -RESTITUTION * (v + dt * GRAVITY);
        time += dt;
        if rest.is_none() && r - v * v / (2.0 * GRAVITY) == r {
            rest = Some(End { halted: false, time, impacts: impacts + 1 });
        }
        if rest.is_some() && variant.stable {
            break;
        }
    }
    rest.unwrap_or(End { halted: true, time, impacts: ENOUGH })
}

/// Drops the ball on a plate in a world of its own, until the engine lays it down.
///
/// # Errors
/// An error of the engine.
pub fn drop_in_world(plate: f64) -> Result<End, Error> {
    let mut memory = Memory::<f64, 1, 1>::new();
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .hard_walls([[plate, plate + 10.0]], RESTITUTION)
        .gravity([GRAVITY])
        .rule(HardSphere { restitution: RESTITUTION })
        .grain(Grain::with_mass(SIGMA / 2.0, 1.0).at([plate + 1.0]))?
        .start()?;
    let mut impacts = 0;
    while !world.view().is_at_rest(0) && impacts < ENOUGH && world.step()?.is_some() {
        impacts += 1;
    }
    Ok(End { halted: !world.view().is_at_rest(0), time: world.now().as_f64(), impacts })
}
