//! Which grains rotate? A rule for smooth grains and what their surfaces do; reads an impact, asks both.

use super::enduring::Enduring;
use super::rule::{Answer, ContactForce, Impact, Rule};
use super::tangential::Tangential;
use crate::error::{Error, Subject};
use crate::scalar::Scalar;
use carom_tables::read::Compression;

/// A rule whose grains have rough surfaces and rotate: along the line of centres the rule of smooth grains, across it
/// another law.
///
/// Its worlds need memory for angular velocities, see [`Rotating`](crate::world::Rotating). Grains are spheres or
/// disks whose mass is spread evenly about their centre, all alike: their moment of inertia is I = q m R².
///
/// With [`Tangential::Constant`] and [`Tangential::Walton`] a collision without duration is one of rough hard spheres.
///
/// ```
/// use carom::law::{HardSphere, Rough, Tangential};
/// use carom::{Grain, Memory, World, world::Rotating};
/// // Glass after Foerster, Louge, Chang & Allia (1994).
/// let glass = Rough::spheres(HardSphere { restitution: 0.97 }, Tangential::Walton { mu: 0.092, beta_0: 0.44 });
/// let mut memory = Rotating::new(Memory::<f64, 2, 2>::new(), [[0.0; 2]; 3]);
/// let mut world = World::builder(&mut memory)
///     .rule(glass)
///     .grain(Grain::with_mass(1.0, 1.0).moving([1.0, 0.5]))?
///     .grain(Grain::with_mass(1.0, 1.0).at([3.0, 0.0]))?
///     .start()?;
/// world.advance_to(2.0)?;
/// assert!(world.view().angular_velocity(0).unwrap()[2] < 0.0);
/// # Ok::<(), carom::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rough<R, S> {
    /// What happens along the line of centres.
    pub normal: R,
    /// What happens across it.
    pub tangential: Tangential<S>,
    /// q = I/(m R²): 2/5 for spheres, 1/2 for disks, at most 1.
    pub inertia: S,
    /// Up to which softness η = X/l (MP13 Eq. 45) two that touch alone have their contact from tables, which neglect
    /// parts of η² of their velocities: 1/20 if nothing else is said. Softer contacts are integrated; with 0 all are.
    pub eta_max: S,
}

impl<R, S: Scalar> Rough<R, S> {
    /// Rough spheres: q = 2/5.
    pub fn spheres(normal: R, tangential: Tangential<S>) -> Self {
        Self { normal, tangential, inertia: S::from_f64(0.4), eta_max: S::from_f64(0.05) }
    }

    /// Rough disks: q = 1/2.
    pub fn disks(normal: R, tangential: Tangential<S>) -> Self {
        Self { inertia: S::half(), ..Self::spheres(normal, tangential) }
    }
}

impl<S: Scalar, R: Rule<S>> Rule<S> for Rough<R, S> {
    #[inline(always)]
    fn enduring(&self) -> Option<Enduring> {
        self.normal.enduring()
    }

    fn collide(&self, impact: &Impact<S>) -> Answer<S> {
        self.normal.collide(impact)
    }

    fn adds_energy(&self) -> bool {
        self.normal.adds_energy()
    }

    fn check(&self) -> Result<(), Error> {
        self.normal.check()?;
        self.tangential.check()?;
        if !(self.eta_max >= S::zero() && self.eta_max.is_finite()) {
            let wanted = "finite and at least 0: 0.05 for most";
            return Err(Error::input(Subject::Rule, "eta_max", self.eta_max.to_f64(), wanted));
        }
        if self.inertia > S::zero() && self.inertia <= S::one() {
            return Ok(());
        }
        let wanted = "above 0 and at most 1: 0.4 for spheres, 0.5 for disks";
        Err(Error::input(Subject::Rule, "inertia", self.inertia.to_f64(), wanted))
    }

    fn force(&self, impact: &Impact<S>, overlap: S) -> Option<ContactForce<S>> {
        self.normal.force(impact, overlap)
    }

    fn contact_time(&self, impact: &Impact<S>, overlap: S) -> Option<S> {
        self.normal.contact_time(impact, overlap)
    }

    #[inline(always)]
    fn remembers(&self) -> bool {
        self.normal.remembers()
    }
    fn remembered_force(&self, impact: &Impact<S>, now: [S; 2], memory: &mut [S; 2]) -> S {
        self.normal.remembered_force(impact, now, memory)
    }
    fn reach(&self, impact: &Impact<S>) -> S {
        self.normal.reach(impact)
    }

    #[inline(always)]
    fn inertia(&self) -> Option<S> {
        Some(self.inertia)
    }

    #[inline(always)]
    fn tangential(&self, _: [u8; 2]) -> Option<Tangential<S>> {
        Some(self.tangential)
    }

    fn course(&self, impact: &Impact<S>) -> Option<(S, Compression<S>)> {
        let (time, contact) = self.normal.course(impact)?;
        let is_stiff = time * impact.normal_speed <= self.eta_max * impact.contact_distance;
        is_stiff.then_some((time, contact))
    }
}
