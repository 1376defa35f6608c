//! Which rules are in one mode only? Reads another rule; writes its answers, with the mode said once for all.

use super::enduring::Enduring;
use super::rule::{Answer, ContactForce, Impact, Rule};
use super::tangential::Tangential;
use crate::error::Error;
use crate::scalar::Scalar;
use carom_tables::read::Compression;

/// A rule whose worlds are always in the papers' mode, whatever the builder is told: a program that has no other
/// worlds carries no code for clusters (28 KB on a Cortex-M4F).
///
/// ```
/// use carom::law::{HardSphere, PaperMode};
/// use carom::{Grain, Memory, World};
/// let mut memory = Memory::<f32, 1, 2>::new();
/// let world = World::builder(&mut memory)
///     .rule(PaperMode(HardSphere { restitution: 0.9 }))
///     .grain(Grain::with_mass(0.5, 1.0))?
///     .start()?;
/// # Ok::<(), carom::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PaperMode<R>(pub R);

/// A rule whose worlds always integrate contacts that last or crowd, whatever the builder is told.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct IntegratedMode<R>(pub R);

macro_rules! in_mode {
    ($wrapper:ident, $mode:ident) => {
        impl<S: Scalar, R: Rule<S>> Rule<S> for $wrapper<R> {
            #[inline(always)]
            fn enduring(&self) -> Option<Enduring> {
                Some(Enduring::$mode)
            }
            fn collide(&self, impact: &Impact<S>) -> Answer<S> {
                self.0.collide(impact)
            }
            fn adds_energy(&self) -> bool {
                self.0.adds_energy()
            }
            fn check(&self) -> Result<(), Error> {
                self.0.check()
            }
            fn force(&self, impact: &Impact<S>, overlap: S) -> Option<ContactForce<S>> {
                self.0.force(impact, overlap)
            }
            fn contact_time(&self, impact: &Impact<S>, overlap: S) -> Option<S> {
                self.0.contact_time(impact, overlap)
            }
            #[inline(always)]
            fn remembers(&self) -> bool {
                self.0.remembers()
            }
            fn remembered_force(&self, impact: &Impact<S>, now: [S; 2], memory: &mut [S; 2]) -> S {
                self.0.remembered_force(impact, now, memory)
            }
            fn reach(&self, impact: &Impact<S>) -> S {
                self.0.reach(impact)
            }
            #[inline(always)]
            fn inertia(&self) -> Option<S> {
                self.0.inertia()
            }
            #[inline(always)]
            fn tangential(&self, materials: [u8; 2]) -> Option<Tangential<S>> {
                self.0.tangential(materials)
            }
            fn course(&self, impact: &Impact<S>) -> Option<(S, Compression<S>)> {
                self.0.course(impact)
            }
        }
    };
}

in_mode!(PaperMode, Paper);
in_mode!(IntegratedMode, Integrated);
