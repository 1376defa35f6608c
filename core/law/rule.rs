//! What is a rule asked, and what does it answer? An impact and the matrix of restitution; reads and writes nothing.

use super::enduring::Enduring;
use super::tangential::Tangential;
use crate::error::Error;
use crate::scalar::Scalar;
use carom_tables::read::Compression;

/// Two bodies at the instant they touch, in all that a rule may depend on.
///
/// Against a plane, the reduced mass and both radii are the grain's own and there is no tangential speed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Impact<S> {
    /// l = R₁ + R₂.
    pub contact_distance: S,
    /// R_eff = R₁ R₂ / (R₁ + R₂), MP13 below Eq. (52).
    pub effective_radius: S,
    /// m_eff = m₁ m₂ / (m₁ + m₂), MP13 Eq. (5).
    pub reduced_mass: S,
    /// The speed of approach v_n = −ṙ(0) ≥ 0.
    pub normal_speed: S,
    /// The speed across, l φ̇(0) ≥ 0.
    pub tangential_speed: S,
    /// What gravity and a plate's motion add to the speed of approach per unit of time, all through the contact.
    /// Against planes only: gravity moves two grains alike.
    pub acceleration: S,
    /// The materials of the two; a plane is of the grain's own unless it says another.
    pub materials: [u8; 2],
}

/// A lasting contact's whole outcome: the matrix of restitution (MP13 Eq. 23) and the duration.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Outcome<S> {
    /// The contact duration τ = ε_t T.
    pub duration: S,
    /// −ε_ṙ ≥ 0: the speed of separation in units of the speed of approach.
    pub restitution: S,
    /// ε_r: the distance at the end in units of l.
    pub separation: S,
    /// ε_φ: by how much the line of centres turns, in radians.
    pub angle: S,
}

/// What two bodies that touch do. With the feature `serde` it is written, not read, as [`Error`] is.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Response<S> {
    /// An instantaneous collision with this coefficient of restitution.
    Instantaneous(S),
    /// A contact that lasts and turns (eMD*).
    Lasting(Outcome<S>),
    /// No answer: outside the table's domain, and the user asked not to guess.
    Refused {
        /// η = 1/l̃.
        eta: S,
        /// Scaled dissipation.
        c_dis: S,
    },
    /// No answer: this quantity does not fit the number type.
    Overflow(&'static str),
}

/// How far an answer can be trusted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Validity {
    /// The impact lies inside the domain of the law's table, or needs none.
    Inside,
    /// It lies outside; the nearest impact inside was used.
    Clamped,
    /// It lies outside; the hard-sphere rule was used.
    HardSphere,
}

/// A response and how far it can be trusted. The world counts what is not [`Validity::Inside`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Answer<S> {
    /// What happens.
    pub response: Response<S>,
    /// How well it is known.
    pub validity: Validity,
}

impl<S> Answer<S> {
    /// An answer from inside the domain.
    pub fn exact(response: Response<S>) -> Self {
        Self { response, validity: Validity::Inside }
    }
}

/// The normal force of two bodies that overlap by x: F_n = `elastic` + `damping` ẋ, and never an attraction.
///
/// # Units
/// Force; force over speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactForce<S> {
    /// What the overlap alone gives.
    pub elastic: S,
    /// What the rate at which it grows adds.
    pub damping: S,
}

impl<S: Scalar> ContactForce<S> {
    /// F_n at this rate of the overlap; at least 0 (MP13: no attraction).
    pub fn at_rate(&self, rate: S) -> S {
        (self.elastic + self.damping * rate).max(S::zero())
    }
}

/// A collision rule: what two bodies do when they touch.
///
/// Implement it to bring your own; the host brings one that integrates the contact directly.
pub trait Rule<S: Scalar> {
    /// What these two do. Called once for each contact.
    fn collide(&self, impact: &Impact<S>) -> Answer<S>;

    /// The mode of all worlds of this rule; none, the default: that which the builder is told. An answer that the
    /// compiler knows keeps the other mode out of the program, see [`PaperMode`](super::PaperMode).
    #[inline(always)]
    fn enduring(&self) -> Option<Enduring> {
        None
    }

    /// Whether grains may part faster than they met. A restitution above 1 is refused unless this says so.
    fn adds_energy(&self) -> bool {
        false
    }

    /// Whether the rule's parameters make sense; asked once, when a world starts.
    ///
    /// # Errors
    /// A [`Error::Input`] that names the parameter.
    fn check(&self) -> Result<(), Error> {
        Ok(())
    }

    /// The force between two bodies that overlap by this much, where more than two touch or a contact
    /// lasts. None, the default, stands for a rule without force law: there a linear spring-dashpot
    /// with the rule's own coefficient of restitution stands in for it.
    ///
    /// # Units
    /// `overlap` is a length.
    fn force(&self, _impact: &Impact<S>, _overlap: S) -> Option<ContactForce<S>> {
        None
    }

    /// How long a contact of two bodies without damping lasts, at the speed of this impact or already
    /// pressed together by this much, whichever makes it shorter: sets the length of a step. None for a
    /// rule without force law.
    fn contact_time(&self, _impact: &Impact<S>, _overlap: S) -> Option<S> {
        None
    }

    /// Whether contacts have a force law that only integration knows: [`Rule::remembered_force`]. False, the default,
    /// is known to the compiler.
    #[inline(always)]
    fn remembers(&self) -> bool {
        false
    }

    /// The force between two bodies that overlap by this much, which grows at this rate, where
    /// [`Rule::remembers`]; the contact's own two numbers are 0 at its beginning. Below zero it attracts.
    fn remembered_force(&self, _impact: &Impact<S>, _now: [S; 2], _memory: &mut [S; 2]) -> S {
        S::zero()
    }

    /// Up to which gap a contact goes on that has begun, where [`Rule::remembers`].
    fn reach(&self, _impact: &Impact<S>) -> S {
        S::zero()
    }

    /// q = I/(m R²) of all grains, if they rotate. None, the default, is smooth grains: what rotation takes is not in
    /// their programs at all.
    #[inline(always)]
    fn inertia(&self) -> Option<S> {
        None
    }

    /// What the surfaces of two materials do to each other, where grains rotate; none: they are smooth.
    #[inline(always)]
    fn tangential(&self, _materials: [u8; 2]) -> Option<Tangential<S>> {
        None
    }

    /// How a contact that nothing turns goes over time, and the unit T of that time: from it follows what rough surfaces
    /// do in it. None, the default: the contacts of rough grains that last are integrated.
    fn course(&self, _impact: &Impact<S>) -> Option<(S, Compression<S>)> {
        None
    }
}

/// What points to a rule is the same rule.
macro_rules! through {
    ($pointer:ty) => {
        impl<S: Scalar, R: Rule<S> + ?Sized> Rule<S> for $pointer {
            #[inline(always)]
            fn enduring(&self) -> Option<Enduring> {
                (**self).enduring()
            }
            fn collide(&self, impact: &Impact<S>) -> Answer<S> {
                (**self).collide(impact)
            }
            fn adds_energy(&self) -> bool {
                (**self).adds_energy()
            }
            fn check(&self) -> Result<(), Error> {
                (**self).check()
            }
            fn force(&self, impact: &Impact<S>, overlap: S) -> Option<ContactForce<S>> {
                (**self).force(impact, overlap)
            }
            fn contact_time(&self, impact: &Impact<S>, overlap: S) -> Option<S> {
                (**self).contact_time(impact, overlap)
            }
            #[inline(always)]
            fn remembers(&self) -> bool {
                (**self).remembers()
            }
            fn remembered_force(&self, impact: &Impact<S>, now: [S; 2], memory: &mut [S; 2]) -> S {
                (**self).remembered_force(impact, now, memory)
            }
            fn reach(&self, impact: &Impact<S>) -> S {
                (**self).reach(impact)
            }
            #[inline(always)]
            fn inertia(&self) -> Option<S> {
                (**self).inertia()
            }
            #[inline(always)]
            fn tangential(&self, materials: [u8; 2]) -> Option<Tangential<S>> {
                (**self).tangential(materials)
            }
            fn course(&self, impact: &Impact<S>) -> Option<(S, Compression<S>)> {
                (**self).course(impact)
            }
        }
    };
}

through!(&R);
#[cfg(feature = "alloc")]
through!(alloc::boxed::Box<R>);
