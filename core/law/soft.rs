//! What does a soft contact do? The matrix of restitution of MP13 from a table; reads an impact, writes its outcome.

#[cfg(feature = "standard")]
use super::embedded::Standard;
use super::embedded::TableSet;
use super::load::loaded;
use super::rule::{Answer, ContactForce, Impact, Response, Rule, Validity};
use super::scales::ForceLaw;
#[cfg(feature = "standard")]
use super::scales::{LinearDashpot, Viscoelastic};
use crate::error::Error;
use crate::scalar::Scalar;
use carom_tables::read::{Compression, Groups, StoredNumber, Table};

/// What to do with an impact outside the table's domain. It is counted in any case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Outside {
    /// Stop with an error.
    Reject,
    /// Use the nearest impact inside the domain.
    Clamp,
    /// Use the hard-sphere rule with the restitution of the (clamped) central collision.
    HardSphere,
}

/// eMD*: a contact that lasts, turns and gives back what the law's table says.
///
/// The table's certificate tells domain and largest error; `C` is the number it is stored in.
#[derive(Clone, Copy, Debug)]
pub struct Soft<L, C: 'static = f32> {
    law: L,
    table: &'static Table<C>,
    outside: Outside,
}

#[cfg(feature = "standard")]
impl<S: Scalar> Soft<LinearDashpot<S>, <Standard as TableSet<S>>::Stored>
where
    Standard: TableSet<S>,
{
    /// The linear spring-dashpot with the embedded table of [`Standard`], whatever other features are on.
    #[must_use]
    pub fn linear_dashpot(law: LinearDashpot<S>, outside: Outside) -> Self {
        Self::embedded(law, Standard, outside)
    }
}

#[cfg(feature = "standard")]
impl<S: Scalar> Soft<Viscoelastic<S>, <Standard as TableSet<S>>::Stored>
where
    Standard: TableSet<S>,
{
    /// Viscoelastic spheres with the embedded table of [`Standard`], whatever other features are on.
    #[must_use]
    pub fn viscoelastic(law: Viscoelastic<S>, outside: Outside) -> Self {
        Self::embedded(law, Standard, outside)
    }
}

impl<L, C> Soft<L, C> {
    /// Any force law with any table made for it.
    #[must_use]
    pub const fn with_table(law: L, table: &'static Table<C>, outside: Outside) -> Self {
        Self { law, table, outside }
    }

    /// A force law with its table from an embedded set: `Compact`, `Standard` or `Wide`, each behind the
    /// feature of its name.
    ///
    /// ```
    /// # #[cfg(feature = "compact")] {
    /// use carom::law::{LinearDashpot, Outside, Soft, embedded::Compact};
    /// let law = LinearDashpot { stiffness: 2000.0_f32, damping: 0.5 };
    /// let rule = Soft::embedded(law, Compact, Outside::Clamp);
    /// # }
    /// ```
    #[must_use]
    pub fn embedded<S, T>(law: L, _: T, outside: Outside) -> Self
    where
        S: Scalar,
        L: ForceLaw<S>,
        T: TableSet<S, Stored = C>,
    {
        Self::with_table(law, T::table(L::LAW), outside)
    }
}

impl<S, L, C> Rule<S> for Soft<L, C>
where
    S: Scalar,
    L: ForceLaw<S>,
    C: StoredNumber,
{
    fn collide(&self, impact: &Impact<S>) -> Answer<S> {
        let scales = self.law.scales(impact);
        if let Some(quantity) = scales.overflow(impact) {
            return Answer::exact(Response::Overflow(quantity));
        }
        let groups = impact.groups(&scales);
        let (found, validity) = match (self.table.read(&groups), self.outside) {
            (Some(found), _) => (Some(found), Validity::Inside),
            (None, Outside::Reject) => (None, Validity::Inside),
            (None, Outside::Clamp) => (self.table.read_nearest(&groups), Validity::Clamped),
            (None, Outside::HardSphere) => return self.central(&groups),
        };
        let Some(found) = found else { return refused(&groups) };
        // Where the nearest impact stands in, c_dis and η are not those of what was found.
        let load = match validity {
            Validity::Inside => scales.load(impact, found.speed),
            _ => S::zero(),
        };
        let end = self.table.data.coordinates.end;
        let outcome = scales.outcome(&loaded((L::LAW, end), &groups, load, found));
        Answer { response: Response::Lasting(outcome), validity }
    }

    fn check(&self) -> Result<(), Error> {
        self.law.check()
    }

    fn force(&self, impact: &Impact<S>, overlap: S) -> Option<ContactForce<S>> {
        Some(self.law.force(impact, overlap))
    }

    fn contact_time(&self, impact: &Impact<S>, overlap: S) -> Option<S> {
        Some(self.law.contact_time(impact, overlap))
    }

    fn course(&self, impact: &Impact<S>) -> Option<(S, Compression<S>)> {
        self.law.course(impact)
    }
}

impl<L, C: StoredNumber> Soft<L, C> {
    fn central<S: Scalar>(&self, groups: &Groups<S>) -> Answer<S> {
        let central = Groups { sin: S::zero(), cos: S::one(), eta: S::zero(), c_dis: groups.c_dis };
        match self.table.read_nearest(&central) {
            Some(found) => Answer {
                response: Response::Instantaneous(found.speed),
                validity: Validity::HardSphere,
            },
            None => refused(groups),
        }
    }
}

fn refused<S: Scalar>(groups: &Groups<S>) -> Answer<S> {
    let response = Response::Refused { eta: groups.eta, c_dis: groups.c_dis };
    Answer { response, validity: Validity::HardSphere }
}
