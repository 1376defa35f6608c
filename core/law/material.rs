//! Which rule holds between two materials? Reads the materials of an impact; asks the pair's rule.

use super::enduring::Enduring;
use super::rule::{Answer, ContactForce, Impact, Response, Rule};
use crate::error::{Error, Subject};
use crate::scalar::Scalar;

/// A rule for each pair of `M` materials.
///
/// Row and column are the grains' `material` numbers; the order of the two does not matter: the
/// entry in the row of the smaller and the column of the larger number is used. A material of `M` or more is answered with the last rule.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(serialize = "R: serde::Serialize", deserialize = "R: serde::Deserialize<'de>"))
)]
pub struct ByMaterial<R, const M: usize>(
    #[cfg_attr(feature = "serde", serde(with = "rows"))] pub [[R; M]; M],
);

/// serde knows arrays of 32 places at most, and none whose length is a parameter: rows are lists.
#[cfg(feature = "serde")]
mod rows {
    use heapless::Vec;
    use serde::de::Error as _;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub(super) fn serialize<R: Serialize, Z: Serializer, const M: usize>(
        rows: &[[R; M]; M],
        serializer: Z,
    ) -> Result<Z::Ok, Z::Error> {
        serializer.collect_seq(rows.iter().map(<[R; M]>::as_slice))
    }

    pub(super) fn deserialize<'de, R, Z, const M: usize>(
        deserializer: Z,
    ) -> Result<[[R; M]; M], Z::Error>
    where
        R: Deserialize<'de>,
        Z: Deserializer<'de>,
    {
        let rows = Vec::<Vec<R, M>, M>::deserialize(deserializer)?;
        let full: Vec<[R; M], M> =
            rows.into_iter().filter_map(|row| row.into_array().ok()).collect();
        full.into_array().map_err(|_| Z::Error::custom("fewer rules than pairs of materials"))
    }
}

impl<R, const M: usize> ByMaterial<R, M> {
    fn rule(&self, materials: [u8; 2]) -> Option<&R> {
        let last = M.saturating_sub(1);
        let [a, b] = materials.map(|m| usize::from(m).min(last));
        self.0.get(a.min(b))?.get(a.max(b))
    }
}

impl<S: Scalar, R: Rule<S>, const M: usize> Rule<S> for ByMaterial<R, M> {
    #[inline(always)]
    fn enduring(&self) -> Option<Enduring> {
        self.0.iter().flatten().find_map(Rule::enduring)
    }

    fn collide(&self, impact: &Impact<S>) -> Answer<S> {
        match self.rule(impact.materials) {
            Some(rule) => rule.collide(impact),
            None => Answer::exact(Response::Instantaneous(S::one())),
        }
    }

    fn adds_energy(&self) -> bool {
        self.0.iter().flatten().any(Rule::adds_energy)
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
