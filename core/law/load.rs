//! What does weight change in a contact with a plane? Reads an impact's acceleration and the outcome without it; writes the outcome with it.
//!
//! Scaled (MP13, Sec. V), the acceleration is w = g T/v_n and the contact x'' = w − F(x, x'). Let x₀ be the contact
//! without weight, which lasts τ and leaves ε.
//!
//! * **Linear spring-dashpot.** x = x₀ + w s with the step response s = 1 − x₀' − c x₀, as the equation of x₀,
//!   integrated, says; s' = x₀. Near τ all derivatives of x₀ follow from ε and c, so no table and no transcendental
//!   function is needed for when F, or x, is zero again: after τ + a + c a²/2 with a = w (1 + 1/ε). It is the closed
//!   form to second order in a, exact for c = 0 to the same order: 2 arctan w.
//! * **Viscoelastic spheres** have no closed form: the first order in w, whose two coefficients as functions of c are
//!   fits to integrated contacts (`carom_tables::contact::integrate_loaded`).

use super::rule::Impact;
use super::scales::Scales;
use crate::scalar::Scalar;
use carom_tables::read::{End, Groups, Law, ScaledRestitution};

impl<S: Scalar> Scales<S> {
    /// The impact's acceleration in units of v_n/T, where a contact of this restitution surely ends under it.
    ///
    /// What is larger is cut to ε/(2 (1 + ε) (1 + c_dis)): weight, not the impact, then decides what happens, and
    /// worlds lay such grains down or integrate them.
    ///
    /// # Units
    /// None.
    pub fn load(&self, impact: &Impact<S>, restitution: S) -> S {
        let gained = impact.acceleration * self.time;
        if gained == S::zero() {
            return gained;
        }
        let one = S::one();
        let most = restitution * S::half() / ((one + restitution) * (one + self.c_dis));
        if gained.abs() < most * impact.normal_speed {
            return gained / impact.normal_speed;
        }
        if gained > S::zero() { most } else { -most }
    }
}

/// The outcome of a contact with a plane under this load, from that without it.
///
/// The error of speed and duration is of order (w/ε)³ for the linear law. For viscoelastic spheres it is about
/// 2 (w/ε)², and for c_dis ≤ 1 another 0.3 % of the change of speed, 1 % of that of duration.
pub(super) fn loaded<S: Scalar>(
    (law, end): (Law, End),
    groups: &Groups<S>,
    load: S,
    without: ScaledRestitution<S>,
) -> ScaledRestitution<S> {
    let (c, e, one) = (groups.c_dis, without.speed, S::one());
    if load == S::zero() {
        return without;
    }
    let later = load * (one + e) / e;
    let lost = c * if end == End::Force { load } else { later };
    let (change, delay) = match law {
        Law::LinearDashpot => {
            let half = later * S::half();
            (later * (load - half) - lost, later + c * later * half)
        }
        Law::Viscoelastic => {
            let (change, delay) = viscoelastic(end, c.min(one));
            (-(lost * change), load * delay / e)
        }
    };
    let speed = e + e * change;
    let separation = match end {
        End::Force => one - c * speed * groups.eta,
        End::Overlap => without.separation,
    };
    ScaledRestitution { tau: without.tau + delay, speed, separation, ..without }
}

/// −∂ln ε/∂w in units of c (at the end by overlap of c (1 + 1/ε)), and ε ∂τ/∂w: fits over 0 ≤ c ≤ 1.
fn viscoelastic<S: Scalar>(end: End, c: S) -> (S, S) {
    let fit = |[zero, one, two]: [f32; 3]| {
        let [zero, one, two] = [zero, one, two].map(S::from_f32);
        zero + c * (one + c * two)
    };
    match end {
        End::Force => (fit([1.0, -0.2196, 0.0708]), fit([1.3194, 0.15, -0.045])),
        End::Overlap => (fit([1.0, -0.1032, 0.0471]), fit([1.3194, 0.19, 0.18])),
    }
}
