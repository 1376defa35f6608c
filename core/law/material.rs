//! Which rule holds between two materials? Reads the materials of an impact; asks the pair's rule.

use super::rule::{Answer, ContactForce, Impact, Response, Rule};
use crate::error::{Error, Subject};
use crate::scalar::Scalar;

/// A rule for each pair of `M` materials.
///
/// Row and column are the grains' `material` numbers; the order of the two does not matter: the
/// entry in the row of the smaller and the column of the larger number is used. A material of `M` or more is answered with the last rule.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ByMaterial<R, const M: usize>(pub [[R; M]; M]);

impl<R, const M: usize> ByMaterial<R, M> {
    fn rule(&self, materials: [u8; 2]) -> Option<&R> {
        let last = M.saturating_sub(1);
        let [a, b] = materials.map(|m| usize::from(m).min(last));
        self.0.get(a.min(b))?.get(a.max(b))
    }
}

impl<S: Scalar, R: Rule<S>, const M: usize> Rule<S> for ByMaterial<R, M> {
    fn collide(&self, impact: &Impact<S>) -> Answer<S> {
        match self.rule(impact.materials) {
            Some(rule) => rule.collide(impact),
            None => Answer::exact(Response::Instantaneous(S::one())),
        }
    }

    fn check(&self) -> Result<(), Error> {
        if M == 0 {
            return Err(Error::input(Subject::Rule, "materials", 0.0, "at least 1"));
        }
        self.0.iter().flatten().try_for_each(Rule::check)
    }

    fn force(&self, impact: &Impact<S>, overlap: S) -> Option<ContactForce<S>> {
        self.rule(impact.materials)?.force(impact, overlap)
    }

    /// The shortest of all pairs of materials.
    fn contact_time(&self, impact: &Impact<S>, overlap: S) -> Option<S> {
        let times = self.0.iter().flatten().filter_map(|rule| rule.contact_time(impact, overlap));
        times.reduce(S::min)
    }
}
