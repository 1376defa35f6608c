//! Which rule holds between two materials? Reads the materials of an impact; asks the pair's rule.

use super::enduring::Enduring;
use super::rule::{Answer, ContactForce, Impact, Response, Rule};
use super::tangential::Tangential;
use crate::error::{Error, Subject};
use crate::scalar::Scalar;
use carom_tables::read::Compression;

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
    #[inline(always)]
    fn pairs(&self) -> PairRules<'_, R> {
        PairRules { rules: self.0.as_flattened(), count: M }
    }
}

/// A rule for each pair of materials, as [`ByMaterial`], in memory that the user lends: for as many materials as are
/// known when the program runs.
///
/// ```
/// use carom::law::{HardSphere, PairRules};
/// let [steel, glass, mixed] = [0.95_f64, 0.9, 0.92].map(|restitution| HardSphere { restitution });
/// let rules = [steel, mixed, mixed, glass];
/// assert!(PairRules::new(&rules).is_some());
/// assert!(PairRules::new(&rules[..3]).is_none());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairRules<'r, R> {
    rules: &'r [R],
    count: usize,
}

impl<'r, R> PairRules<'r, R> {
    /// The rules row by row, a row and a column for each material; nothing if they are not as many as the square of a
    /// number. Of the two entries of a pair the one in the row of the smaller number is used.
    #[must_use]
    pub fn new(rules: &'r [R]) -> Option<Self> {
        let count = rules.len().isqrt();
        (count * count == rules.len()).then_some(Self { rules, count })
    }

    #[inline(always)]
    fn rule(&self, materials: [u8; 2]) -> Option<&'r R> {
        let last = self.count.saturating_sub(1);
        let [a, b] = materials.map(|m| usize::from(m).min(last));
        self.rules.get(a.min(b) * self.count + a.max(b))
    }
}

impl<S: Scalar, R: Rule<S>> Rule<S> for PairRules<'_, R> {
    #[inline(always)]
    fn enduring(&self) -> Option<Enduring> {
        self.rules.iter().find_map(Rule::enduring)
    }

    #[inline(always)]
    fn collide(&self, impact: &Impact<S>) -> Answer<S> {
        match self.rule(impact.materials) {
            Some(rule) => rule.collide(impact),
            None => Answer::exact(Response::Instantaneous(S::one())),
        }
    }

    fn adds_energy(&self) -> bool {
        self.rules.iter().any(Rule::adds_energy)
    }

    fn check(&self) -> Result<(), Error> {
        if self.rules.is_empty() {
            return Err(Error::input(Subject::Rule, "materials", 0.0, "at least 1"));
        }
        self.rules.iter().try_for_each(Rule::check)?;
        let remembers = self.remembers();
        if self.rules.iter().any(|rule| rule.remembers() != remembers) {
            let wanted = "for all pairs of materials, or for none (Integrated)";
            return Err(Error::input(Subject::Rule, "force law of one's own", 1.0, wanted));
        }
        let inertia = self.inertia();
        match self.rules.iter().map(Rule::inertia).find(|q| *q != inertia) {
            None => Ok(()),
            Some(q) => {
                let wanted = "the same for all materials (smooth ones: Rough with beta = -1)";
                let q = q.map_or(0.0, S::to_f64);
                Err(Error::input(Subject::Rule, "inertia", q, wanted))
            }
        }
    }

    #[inline(always)]
    fn force(&self, impact: &Impact<S>, overlap: S) -> Option<ContactForce<S>> {
        self.rule(impact.materials)?.force(impact, overlap)
    }

    /// The shortest of all pairs of materials.
    fn contact_time(&self, impact: &Impact<S>, overlap: S) -> Option<S> {
        let times = self.rules.iter().filter_map(|rule| rule.contact_time(impact, overlap));
        times.reduce(S::min)
    }

    #[inline(always)]
    fn remembers(&self) -> bool {
        self.rules.iter().any(Rule::remembers)
    }

    fn remembered_force(&self, impact: &Impact<S>, now: [S; 2], memory: &mut [S; 2]) -> S {
        let rule = self.rule(impact.materials);
        rule.map_or(S::zero(), |rule| rule.remembered_force(impact, now, memory))
    }

    fn reach(&self, impact: &Impact<S>) -> S {
        self.rule(impact.materials).map_or(S::zero(), |rule| rule.reach(impact))
    }

    #[inline(always)]
    fn inertia(&self) -> Option<S> {
        self.rules.iter().find_map(Rule::inertia)
    }

    #[inline(always)]
    fn tangential(&self, materials: [u8; 2]) -> Option<Tangential<S>> {
        self.rule(materials)?.tangential(materials)
    }

    fn course(&self, impact: &Impact<S>) -> Option<(S, Compression<S>)> {
        self.rule(impact.materials)?.course(impact)
    }
}

impl<S: Scalar, R: Rule<S>, const M: usize> Rule<S> for ByMaterial<R, M> {
    #[inline(always)]
    fn enduring(&self) -> Option<Enduring> {
        self.pairs().enduring()
    }

    fn collide(&self, impact: &Impact<S>) -> Answer<S> {
        self.pairs().collide(impact)
    }

    fn adds_energy(&self) -> bool {
        self.pairs().adds_energy()
    }

    fn check(&self) -> Result<(), Error> {
        self.pairs().check()
    }

    fn force(&self, impact: &Impact<S>, overlap: S) -> Option<ContactForce<S>> {
        self.pairs().force(impact, overlap)
    }

    fn contact_time(&self, impact: &Impact<S>, overlap: S) -> Option<S> {
        self.pairs().contact_time(impact, overlap)
    }

    #[inline(always)]
    fn remembers(&self) -> bool {
        self.pairs().remembers()
    }
    fn remembered_force(&self, impact: &Impact<S>, now: [S; 2], memory: &mut [S; 2]) -> S {
        self.pairs().remembered_force(impact, now, memory)
    }
    fn reach(&self, impact: &Impact<S>) -> S {
        self.pairs().reach(impact)
    }

    #[inline(always)]
    fn inertia(&self) -> Option<S> {
        self.pairs().inertia()
    }

    #[inline(always)]
    fn tangential(&self, materials: [u8; 2]) -> Option<Tangential<S>> {
        self.pairs().tangential(materials)
    }

    fn course(&self, impact: &Impact<S>) -> Option<(S, Compression<S>)> {
        self.pairs().course(impact)
    }
}
