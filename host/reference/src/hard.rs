//! How do two rough hard spheres part? Reads two that touch and their coefficients; writes their motion after the impact, in closed form.

use crate::error::{ReferenceError, positive, zero_or_more};
use crate::rough::RoughGrain;
use crate::rough_step::{cross, dot, plus};

/// What an impact without duration does: ε along the normal, and across it β₀, as far as μ allows. Both grains have
/// I = q m R².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HardImpact {
    /// ε, from 0 to 1.
    pub restitution: f64,
    /// β₀, from −1 to 1: the surfaces part with −β₀ of what they slid with.
    pub beta_0: f64,
    /// μ ≥ 0; none if the surfaces never slide.
    pub mu: Option<f64>,
    /// q, 2/5 for spheres.
    pub inertia: f64,
}

impl HardImpact {
    fn validate(&self) -> Result<(), ReferenceError> {
        if !(0.0..=1.0).contains(&self.restitution) {
            let wanted = "between 0 and 1";
            return Err(ReferenceError::parameter("restitution", self.restitution, wanted));
        }
        if !(-1.0..=1.0).contains(&self.beta_0) {
            return Err(ReferenceError::parameter("beta_0", self.beta_0, "between -1 and 1"));
        }
        zero_or_more("mu", self.mu.unwrap_or(0.0))?;
        positive("inertia", self.inertia)
    }
}

/// Two that touch and near each other, after an impact without duration (Foerster, Louge, Chang & Allia, Phys. Fluids 6,
/// 1108, 1994).
///
/// # Errors
///
/// [`ReferenceError`] for a bad coefficient, and for grains that do not near each other.
///
/// # Examples
///
/// ```
/// use carom_reference::{HardImpact, RoughGrain, collide_hard};
/// let still = RoughGrain { radius: 0.1, mass: 1.0, position: [0.0; 3], velocity: [0.0; 3], rotation: [0.0; 3] };
/// let a = RoughGrain { position: [0.2, 0.0, 0.0], velocity: [-1.0, 0.0, 0.0], ..still };
/// let impact = HardImpact { restitution: 0.5, beta_0: 0.0, mu: None, inertia: 0.4 };
/// let [a, b] = collide_hard([a, still], impact)?;
/// assert_eq!([a.velocity[0], b.velocity[0]], [-0.25, -0.75]);
/// # Ok::<(), carom_reference::ReferenceError>(())
/// ```
pub fn collide_hard(
    grains: [RoughGrain; 2],
    impact: HardImpact,
) -> Result<[RoughGrain; 2], ReferenceError> {
    impact.validate()?;
    let [a, b] = grains;
    let r = plus(&a.position, -1.0, &b.position);
    let n = r.map(|x| x / dot(&r, &r).sqrt());
    let v = plus(&a.velocity, -1.0, &b.velocity);
    let nearing = -dot(&v, &n);
    if !(nearing > 0.0) {
        let what = "approach speed";
        return Err(ReferenceError::NotAnImpact { first: 0, second: 1, what, value: nearing });
    }
    let mass = a.mass * b.mass / (a.mass + b.mass);
    let turning: [f64; 3] =
        std::array::from_fn(|k| a.radius * a.rotation[k] + b.radius * b.rotation[k]);
    let sliding = plus(&plus(&v, nearing, &n), -1.0, &cross(&turning, &n));
    let slip = dot(&sliding, &sliding).sqrt();
    let along = (1.0 + impact.restitution) * mass * nearing;
    let stick = (1.0 + impact.beta_0) * mass * slip * impact.inertia / (1.0 + impact.inertia);
    let across = impact.mu.map_or(stick, |mu| stick.min(mu * along));
    let rub = if slip > 0.0 { sliding.map(|x| -across * x / slip) } else { [0.0; 3] };
    let impulse = plus(&rub, along, &n);
    let turned = |grain: RoughGrain, sign: f64| {
        let share = -1.0 / (impact.inertia * grain.mass * grain.radius);
        RoughGrain {
            velocity: plus(&grain.velocity, sign / grain.mass, &impulse),
            rotation: plus(&grain.rotation, share, &cross(&n, &rub)),
            ..grain
        }
    };
    Ok([turned(a, 1.0), turned(b, -1.0)])
}
