//! What do grains do under L94's force laws? Reads an impact; returns forces for eMD*, and for eMD the restitution that the reference finds.

use carom::Error;
use carom::law::{Answer, ContactLaw, Impact, Memory, Response, Rule};
use carom_reference::{End, ForceLaw, Grain};

/// F = K x^(1 + β) + D m x^γ ẋ until the overlap x is none (L94, Eqs. 2 to 8).
///
/// # Units
/// K in N/m^(1 + β), D in 1/(s m^γ).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct L94 {
    /// K.
    pub stiffness: f64,
    /// β.
    pub beta: f64,
    /// D.
    pub damping: f64,
    /// γ.
    pub gamma: f64,
}

/// The m of the law: twice the reduced mass of two grains, at a wall the grain's own.
fn mass(impact: &Impact<f64>) -> f64 {
    // Against a plane both radii are the grain's own; of two grains the effective one is smaller than their sum.
    let is_plane = !(impact.contact_distance > impact.effective_radius);
    if is_plane { impact.reduced_mass } else { 2.0 * impact.reduced_mass }
}

impl ContactLaw<f64> for L94 {
    fn force(&self, impact: &Impact<f64>, overlap: f64, rate: f64, _: &mut Memory<f64>) -> f64 {
        let x = overlap.max(0.0);
        self.stiffness * x.powf(1.0 + self.beta)
            + self.damping * mass(impact) * x.powf(self.gamma) * rate
    }

    /// K (1 + β) x^β.
    fn stiffness(&self, impact: &Impact<f64>, overlap: f64) -> f64 {
        // At the touch it may be none: there that of a millionth of the distance.
        let deep = overlap.max(1e-6 * impact.contact_distance);
        self.stiffness * (1.0 + self.beta) * deep.powf(self.beta)
    }
}

impl L94 {
    /// The law as the reference has it.
    pub fn of_reference(&self) -> ForceLaw {
        let Self { stiffness, beta, damping, gamma } = *self;
        ForceLaw::PowerLaw { stiffness, beta, damping, gamma, tangential: 0.0 }
    }

    /// With which part of its speed of approach a pair parts, contact and all; none if it never does.
    fn restitution(&self, impact: &Impact<f64>) -> Option<f64> {
        let grain = |position, velocity| Grain::<1> {
            radius: 0.5 * impact.contact_distance,
            mass: 2.0 * impact.reduced_mass,
            position: [position],
            velocity: [velocity],
        };
        let pair = [grain(impact.contact_distance, -impact.normal_speed), grain(0.0, 0.0)];
        // Two such grains have twice the reduced mass for m.
        let damping = self.damping * mass(impact) / (2.0 * impact.reduced_mass);
        let law = Self { damping, ..*self }.of_reference();
        carom_reference::collide(pair, law, End::Overlap, &[]).ok().map(|hit| -hit.eps_rdot)
    }
}

/// Hard spheres with the law's ε(v).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hard(pub L94);

impl Rule<f64> for Hard {
    fn collide(&self, impact: &Impact<f64>) -> Answer<f64> {
        // An overdamped contact never ends: they stay together.
        let restitution = self.0.restitution(impact).unwrap_or(0.0);
        Answer::exact(Response::Instantaneous(restitution.clamp(0.0, 1.0)))
    }

    fn check(&self) -> Result<(), Error> {
        ContactLaw::check(&self.0)
    }
}
