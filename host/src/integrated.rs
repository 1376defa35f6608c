//! What does a contact do, without a table? Integrates the contact equation for each impact; writes its outcome.

use carom::Error;
use carom::law::{Answer, ContactForce, ForceLaw, Impact, Response, Rule};
use carom_tables::contact;
use carom_tables::read::End;

/// eMD* with the matrix of restitution integrated directly, to 1e-12 (MP13 Eqs. 42, 54).
///
/// Slow, and without a domain: tables are compared with it.
///
/// ```
/// use carom::law::{Impact, LinearDashpot, Response, Rule};
/// use carom_host::integrated::Integrated;
/// let rule = Integrated::new(LinearDashpot { stiffness: 2000.0, damping: 0.0 });
/// let head_on = Impact {
///     contact_distance: 0.2, effective_radius: 0.05, reduced_mass: 2.0,
///     normal_speed: 1.0, tangential_speed: 0.0, acceleration: 0.0, materials: [0, 0],
/// };
/// let Response::Lasting(outcome) = rule.collide(&head_on).response else { unreachable!() };
/// // Half a period of the oscillator.
/// assert!((outcome.duration - std::f64::consts::PI * (2.0_f64 / 2000.0).sqrt()).abs() < 1e-12);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Integrated<L> {
    law: L,
    end: End,
}

impl<L> Integrated<L> {
    /// The contact ends when the force vanishes (MP13).
    #[must_use]
    pub const fn new(law: L) -> Self {
        Self { law, end: End::Force }
    }

    /// The same law with the other end of contact.
    #[must_use]
    pub fn ending(self, end: End) -> Self {
        Self { end, ..self }
    }
}

impl<L: ForceLaw<f64>> Rule<f64> for Integrated<L> {
    fn collide(&self, impact: &Impact<f64>) -> Answer<f64> {
        let scales = self.law.scales(impact);
        let groups = impact.groups(&scales);
        let mut scaled = contact::integrate(L::LAW, self.end, &groups);
        let load = scales.load(impact, scaled.speed);
        if load != 0.0 {
            scaled = contact::integrate_loaded(L::LAW, self.end, &groups, load);
        }
        Answer::exact(Response::Lasting(scales.outcome(&scaled)))
    }

    fn check(&self) -> Result<(), Error> {
        self.law.check()
    }

    fn force(&self, impact: &Impact<f64>, overlap: f64) -> Option<ContactForce<f64>> {
        Some(self.law.force(impact, overlap))
    }

    fn contact_time(&self, impact: &Impact<f64>, overlap: f64) -> Option<f64> {
        Some(self.law.contact_time(impact, overlap))
    }
}
