//! What does a contact under a force law of one's own come to? Reads a table of that pair of bodies; answers an impact.

use super::contact_law::ContactLaw;
use super::rule::{Answer, ContactForce, Impact, Outcome, Response, Rule, Validity};
use super::soft::Outside;
use crate::error::Error;
use crate::scalar::Scalar;
use carom_tables::read::{PairOutcome, PairTable, StoredNumber};

/// A force law of one's own, without a state, and the table that `carom_tables::recipe::PairRecipe` has made of it for one
/// pair of bodies: a contact of two alone is read from the table, and only those that crowd are integrated.
///
/// Grains of one size and mass are one pair; others, and planes, are pairs of their own, with tables of their own
/// ([`PairRules`](super::PairRules)). What is no pair of the table's is outside it.
///
/// ```
/// use carom::law::embedded::read::{PAIR_TERMS, PairCertificate, PairTable};
/// use carom::law::{Outside, PairTabulated, PowerLaw};
/// # static BALLS: PairTable<f32> = PairTable {
/// #     certificate: PairCertificate { contact_distance: 0.2, reduced_mass: 0.5, speeds: [0.1, 1.0], across: 1.0,
/// #         bytes: 720, largest: [0.0; 3], points: 0 },
/// #     pieces: [1, 1], time: 1e-3, span: 2.302585092994046, coefficients: &[0.0; 180],
/// # };
/// let law = PowerLaw { stiffness: 1e8, exponent: 1.75, damping: 1e4, damping_exponent: 0.6 };
/// let rule = PairTabulated { law, table: &BALLS, outside: Outside::Reject }; // BALLS: from your build.rs
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PairTabulated<L, C: 'static = f32> {
    /// The force law.
    pub law: L,
    /// Its table.
    pub table: &'static PairTable<C>,
    /// What is done outside the table.
    pub outside: Outside,
}

impl<L, C: StoredNumber> PairTabulated<L, C> {
    /// Whether this is the table's pair, to a hundred thousandth.
    fn is_pair<S: Scalar>(&self, impact: &Impact<S>) -> bool {
        let c = &self.table.certificate;
        let alike = |x: S, wanted: f64| {
            let wanted = S::from_f64(wanted);
            (x - wanted).abs() <= wanted * S::from_f64(1e-5)
        };
        alike(impact.contact_distance, c.contact_distance)
            && alike(impact.reduced_mass, c.reduced_mass)
    }

    /// What the table says of the nearest speeds.
    fn nearest<S: Scalar>(&self, speeds: [S; 2]) -> Option<PairOutcome<S>> {
        self.table.read(self.table.clamp(speeds))
    }
}

impl<S: Scalar, L: ContactLaw<S>, C: StoredNumber> Rule<S> for PairTabulated<L, C> {
    fn collide(&self, impact: &Impact<S>) -> Answer<S> {
        let speeds = [impact.normal_speed, impact.tangential_speed];
        let read = if self.is_pair(impact) { self.table.read(speeds) } else { None };
        let (found, validity) = match (read, self.outside) {
            (Some(found), _) => (Some(found), Validity::Inside),
            (None, Outside::Reject) => (None, Validity::Inside),
            (None, Outside::Clamp) => (self.nearest(speeds), Validity::Clamped),
            (None, Outside::HardSphere) => {
                let central = self.nearest([impact.normal_speed, S::zero()]);
                let response = central.map_or(refused(), |found| {
                    Response::Instantaneous(found.restitution.max(S::zero()))
                });
                return Answer { response, validity: Validity::HardSphere };
            }
        };
        let response = found.map_or(refused(), |found| {
            Response::Lasting(Outcome {
                duration: found.duration,
                restitution: found.restitution.max(S::zero()).min(S::one()),
                separation: S::one(),
                angle: found.angle,
            })
        });
        Answer { response, validity }
    }

    fn check(&self) -> Result<(), Error> {
        self.law.check()
    }

    /// The law's own force, as far as it is linear in the rate.
    fn force(&self, impact: &Impact<S>, overlap: S) -> Option<ContactForce<S>> {
        let force = |rate| self.law.force(impact, overlap, rate, &mut [S::zero(); 2]);
        let slow = S::from_f64(self.table.certificate.speeds[0]);
        let elastic = force(S::zero());
        Some(ContactForce { elastic, damping: (force(slow) - elastic) / slow })
    }

    /// Half a swing with the stiffness at the deepest overlap at this speed.
    fn contact_time(&self, impact: &Impact<S>, overlap: S) -> Option<S> {
        let mut deepest = overlap;
        let swing = |deepest| {
            let stiffness = self.law.stiffness(impact, deepest);
            let swings = stiffness > S::zero();
            swings.then(|| impact.reduced_mass.sqrt_of_ratio(stiffness))
        };
        for _ in 0..8 {
            let Some(time) = swing(deepest) else { break };
            deepest = deepest.max(impact.normal_speed * time);
        }
        let pi = S::from_f64(core::f64::consts::PI);
        Some(swing(deepest).map_or(S::NEVER, |time| pi * time))
    }
}

fn refused<S: Scalar>() -> Response<S> {
    Response::Refused { eta: S::zero(), c_dis: S::zero() }
}
