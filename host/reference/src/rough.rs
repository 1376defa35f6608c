//! How does a rough grain hit another, or a plane? Reads two that touch, a force law and friction; writes their motion after the contact.

use crate::error::{ReferenceError, zero_or_more};
use crate::friction::Friction;
use crate::general_law::{Bound, GeneralLaw, Normal};
use crate::law::ForceLaw;
use crate::rough_step::{STATE, State, Vector, dot, parts, plus};
use crate::touch::Touch;
use std::cell::Cell;

/// A grain that rotates. In two dimensions positions and velocities have no third component, rotations only that.
///
/// # Units
///
/// SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoughGrain {
    /// R > 0.
    pub radius: f64,
    /// m > 0.
    pub mass: f64,
    /// Centre.
    pub position: Vector,
    /// Velocity of the centre.
    pub velocity: Vector,
    /// Angular velocity ω.
    pub rotation: Vector,
}

/// What a contact under friction comes to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoughImpact {
    /// τ (s).
    pub duration: f64,
    /// Both grains at its end; of an impact on a plane the first, twice.
    pub after: [RoughGrain; 2],
}

fn state(parts: [Vector; 5]) -> State {
    let mut y = [0.0; STATE];
    parts.iter().flatten().zip(&mut y).for_each(|(x, place)| *place = *x);
    y
}

fn checked(friction: &Friction, law: &ForceLaw) -> Result<(), ReferenceError> {
    law.validate()?;
    friction.validate()
}

/// The contact of two rough grains that touch and near each other. It ends when the normal force vanishes.
///
/// # Errors
///
/// [`ReferenceError`] for a bad law or friction, and for grains that do not near each other or do not part.
///
/// # Examples
///
/// ```
/// use carom_reference::{ForceLaw, Friction, RoughGrain, collide_rough};
/// let still = RoughGrain { radius: 0.1, mass: 1.0, position: [0.0; 3], velocity: [0.0; 3], rotation: [0.0; 3] };
/// let a = RoughGrain { position: [0.2, 0.0, 0.0], velocity: [-1.0, 0.0, 0.0], rotation: [0.0, 0.0, 5.0], ..still };
/// let law = ForceLaw::LinearDashpot { stiffness: 1e6, damping: 0.0 };
/// let friction = Friction { mu: 0.3, stiffness: 3e5, damping: 0.0, inertia: 0.4 };
/// let hit = collide_rough([a, still], law, friction)?;
/// // The second is turned against the first.
/// assert!(hit.after[1].rotation[2] < 0.0 && hit.after[0].rotation[2] < 5.0);
/// # Ok::<(), carom_reference::ReferenceError>(())
/// ```
pub fn collide_rough(
    grains: [RoughGrain; 2],
    law: ForceLaw,
    friction: Friction,
) -> Result<RoughImpact, ReferenceError> {
    checked(&friction, &law)?;
    let [a, b] = &grains;
    let normal = Normal::Plain(law.pair([a.radius, b.radius], [a.mass, b.mass]));
    pair(&grains, normal, friction)?.ok_or_else(endless)
}

/// The same of two under a law of another kind, which this constant force helps to hold. None if the two do not part:
/// they have neared each other again eight times.
///
/// # Errors
///
/// As [`collide_rough`].
///
/// # Examples
///
/// ```
/// use carom_reference::{Friction, GeneralLaw, RoughGrain, collide_general};
/// let still = RoughGrain { radius: 0.1, mass: 1.0, position: [0.0; 3], velocity: [0.0; 3], rotation: [0.0; 3] };
/// let a = RoughGrain { position: [0.2, 0.0, 0.0], velocity: [-1.0, 0.0, 0.0], ..still };
/// let law = GeneralLaw::WaltonBraun { loading: 1e6, unloading: 4e6 };
/// let smooth = Friction { mu: 0.0, stiffness: 1.0, damping: 0.0, inertia: 0.4 };
/// let hit = collide_general([a, still], (law, 0.0), smooth)?.unwrap();
/// let [a, b] = hit.after.map(|grain| grain.velocity[0]);
/// assert!((a - b - 0.5).abs() < 1e-9); // √(k₁/k₂)
/// # Ok::<(), carom_reference::ReferenceError>(())
/// ```
pub fn collide_general(
    grains: [RoughGrain; 2],
    (law, cohesion): (GeneralLaw, f64),
    friction: Friction,
) -> Result<Option<RoughImpact>, ReferenceError> {
    law.validate()?;
    zero_or_more("cohesion", cohesion)?;
    friction.validate()?;
    let [a, b] = &grains;
    let radius = a.radius * b.radius / (a.radius + b.radius);
    let mass = a.mass * b.mass / (a.mass + b.mass);
    pair(&grains, Normal::General(Bound { law, cohesion, radius, mass }), friction)
}

fn endless() -> ReferenceError {
    let why = "its grains near each other again and again";
    ReferenceError::Unresolved { time: 0.0, grain: 0, why }
}

fn pair(
    grains: &[RoughGrain; 2],
    normal: Normal,
    friction: Friction,
) -> Result<Option<RoughImpact>, ReferenceError> {
    let &[a, b] = grains;
    let separation = plus(&a.position, -1.0, &b.position);
    let velocity = plus(&a.velocity, -1.0, &b.velocity);
    let distance = dot(&separation, &separation).sqrt();
    let touch = Touch {
        normal,
        friction,
        radii: [a.radius, b.radius],
        inverse: [1.0 / a.mass, 1.0 / b.mass],
        plane: None,
        deepest: Cell::new(0.0),
    };
    let begin = state([separation, velocity, a.rotation, b.rotation, [0.0; 3]]);
    let speed = -dot(&separation, &velocity) / distance;
    let Some((end, duration)) = touch.impact(&begin, speed)? else { return Ok(None) };
    let [r, v, w, z, _] = parts(&end);
    let total = a.mass + b.mass;
    let centre =
        |x: &Vector, y: &Vector| std::array::from_fn(|k| (a.mass * x[k] + b.mass * y[k]) / total);
    let (place, flow): (Vector, Vector) =
        (centre(&a.position, &b.position), centre(&a.velocity, &b.velocity));
    let place = plus(&place, duration, &flow);
    let one = |grain: RoughGrain, share: f64, rotation: Vector| RoughGrain {
        position: plus(&place, share, &r),
        velocity: plus(&flow, share, &v),
        rotation,
        ..grain
    };
    let after = [one(a, b.mass / total, w), one(b, -a.mass / total, z)];
    Ok(Some(RoughImpact { duration, after }))
}

/// The same of a grain and a plane through this point, from which the normal, of unit length, points to the grain.
///
/// # Errors
///
/// As [`collide_rough`].
pub fn collide_rough_with_plane(
    grain: RoughGrain,
    (point, normal): (Vector, Vector),
    law: ForceLaw,
    friction: Friction,
) -> Result<RoughImpact, ReferenceError> {
    checked(&friction, &law)?;
    let touch = Touch {
        normal: Normal::Plain(law.wall(grain.radius, grain.mass)),
        friction,
        radii: [grain.radius, 0.0],
        inverse: [1.0 / grain.mass, 0.0],
        plane: Some(normal),
        deepest: Cell::new(0.0),
    };
    let away = plus(&grain.position, -1.0, &point);
    let begin = state([away, grain.velocity, grain.rotation, [0.0; 3], [0.0; 3]]);
    let speed = -dot(&normal, &grain.velocity);
    let (end, duration) = touch.impact(&begin, speed)?.ok_or_else(endless)?;
    let [r, velocity, rotation, ..] = parts(&end);
    let after = RoughGrain { position: plus(&point, 1.0, &r), velocity, rotation, ..grain };
    Ok(RoughImpact { duration, after: [after; 2] })
}
