//! What is a force law of your own? The force at any instant of a contact, which may remember; reads an impact, writes what the contact remembers.

use super::enduring::Enduring;
use super::rule::{Answer, ContactForce, Impact, Response, Rule};
use crate::error::{Error, Subject};
use crate::scalar::Scalar;

/// What a contact remembers from its beginning on: two numbers of the law's own, 0 at first.
pub type Memory<S> = [S; 2];

/// A force law between two bodies that touch, of your own making: [`Integrated`] makes a rule of it.
///
/// Its contacts are integrated step by step, so there is no limit to what it can be: it may attract, hold on beyond the
/// touch, and remember. A hysteretic law in so many lines:
///
/// ```
/// use carom::law::{ContactLaw, Impact, Integrated, Memory};
/// use carom::{Error, Grain, HeapMemory, World, space::ContactState, world::WithContacts};
///
/// /// Pressed by k₁ x; let go, and pressed again, by k₂ (x − x₀), so that the force is the same at the deepest x.
/// struct Clay { k1: f64, k2: f64 }
///
/// impl ContactLaw<f64> for Clay {
///     fn force(&self, _: &Impact<f64>, overlap: f64, _rate: f64, memory: &mut Memory<f64>) -> f64 {
///         let [deepest, _] = memory;
///         *deepest = deepest.max(overlap);
///         (self.k2 * (overlap - *deepest) + self.k1 * *deepest).max(0.0)
///     }
///     fn stiffness(&self, _: &Impact<f64>, _overlap: f64) -> f64 {
///         self.k2
///     }
/// }
///
/// let clay = Integrated(Clay { k1: 1.0e6, k2: 4.0e6 });
/// let contacts = vec![ContactState::VACANT; 4];
/// let mut memory = WithContacts::new(HeapMemory::<f64, 3>::with_capacity(2), contacts);
/// let mut world = World::builder(&mut memory)
///     .rule(clay)
///     .grain(Grain::with_mass(0.5, 1.0).moving([1.0, 0.0, 0.0]))?
///     .grain(Grain::with_mass(0.5, 1.0).at([1.1, 0.0, 0.0]))?
///     .start()?;
/// world.advance_to(1.0)?;
/// let parting = world.grain(1).unwrap().velocity.x - world.grain(0).unwrap().velocity.x;
/// assert!((parting - 0.5).abs() < 0.01); // √(k₁/k₂)
/// # Ok::<(), carom::Error>(())
/// ```
pub trait ContactLaw<S: Scalar> {
    /// The force along the line of centres at this overlap, which grows at this rate: above zero it pushes the two
    /// apart, below it holds them together. Asked once in each step, in the order of time.
    ///
    /// # Units
    /// A force; a length; a speed.
    fn force(&self, impact: &Impact<S>, overlap: S, rate: S, memory: &mut Memory<S>) -> S;

    /// The largest slope dF/dx of the force up to this overlap: how long steps are follows from it.
    ///
    /// # Units
    /// Force over length.
    fn stiffness(&self, impact: &Impact<S>, overlap: S) -> S;

    /// Up to which gap a contact that has begun goes on; 0, the default, for laws that end at the touch.
    ///
    /// # Units
    /// Length.
    fn reach(&self, _impact: &Impact<S>) -> S {
        S::zero()
    }

    /// Whether the parameters make sense; asked once, when a world starts.
    ///
    /// # Errors
    /// A [`Error::Input`] that names the parameter.
    fn check(&self) -> Result<(), Error> {
        Ok(())
    }
}

/// A rule whose contacts are all integrated under a force law of your own. Its worlds need memory for contacts, see
/// [`WithContacts`](crate::world::WithContacts).
///
/// Not in the papers' mode, where each contact is an event.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Integrated<L>(pub L);

impl<L> Integrated<L> {
    /// How deep two go that near each other with this speed, at most, and the stiffness there.
    fn deepest<S: Scalar>(&self, impact: &Impact<S>, overlap: S) -> S
    where
        L: ContactLaw<S>,
    {
        let mut deepest = overlap;
        for _ in 0..8 {
            let stiffness = self.0.stiffness(impact, deepest);
            if !(stiffness > S::zero()) {
                break;
            }
            let more = impact.normal_speed * impact.reduced_mass.sqrt_of_ratio(stiffness);
            deepest = deepest.max(more);
        }
        deepest
    }
}

impl<S: Scalar, L: ContactLaw<S>> Rule<S> for Integrated<L> {
    #[inline(always)]
    fn enduring(&self) -> Option<Enduring> {
        Some(Enduring::Integrated)
    }

    /// Never asked: each contact is integrated.
    fn collide(&self, _: &Impact<S>) -> Answer<S> {
        Answer::exact(Response::Refused { eta: S::zero(), c_dis: S::zero() })
    }

    fn check(&self) -> Result<(), Error> {
        self.0.check()
    }

    fn force(&self, impact: &Impact<S>, overlap: S) -> Option<ContactForce<S>> {
        let elastic = self.0.force(impact, overlap, S::zero(), &mut [S::zero(); 2]);
        Some(ContactForce { elastic, damping: S::zero() })
    }

    fn contact_time(&self, impact: &Impact<S>, overlap: S) -> Option<S> {
        let stiffness = self.0.stiffness(impact, self.deepest(impact, overlap));
        let pi = S::from_f64(core::f64::consts::PI);
        let swings = stiffness > S::zero();
        Some(if swings { pi * impact.reduced_mass.sqrt_of_ratio(stiffness) } else { S::NEVER })
    }

    #[inline(always)]
    fn remembers(&self) -> bool {
        true
    }

    fn remembered_force(
        &self,
        impact: &Impact<S>,
        [overlap, rate]: [S; 2],
        memory: &mut Memory<S>,
    ) -> S {
        self.0.force(impact, overlap, rate, memory)
    }

    fn reach(&self, impact: &Impact<S>) -> S {
        self.0.reach(impact)
    }
}

/// Whether a contact under this law begins, pushes, and ends: what a world asks at its start.
///
/// # Errors
/// [`Error::Input`] with the overlap at which the force is none, or if it never pushes the two apart.
pub(crate) fn tried<S: Scalar>(rule: &impl Rule<S>, impact: &Impact<S>) -> Result<(), Error> {
    let mut pushes = false;
    let parts = [1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1];
    for part in parts.into_iter().chain(parts.into_iter().rev()) {
        let overlap = impact.contact_distance * S::from_f64(part);
        let mut memory = [S::zero(); 2];
        let force = rule.remembered_force(impact, [overlap, S::zero()], &mut memory);
        if !force.is_finite() {
            let wanted = "one at which the law gives a finite force";
            return Err(Error::input(Subject::Rule, "overlap", overlap.to_f64(), wanted));
        }
        pushes |= force > S::zero();
    }
    let reach = rule.reach(impact);
    if !(reach >= S::zero() && reach < impact.contact_distance) {
        let wanted = "at least 0, and less than the contact distance: else no contact ends";
        return Err(Error::input(Subject::Rule, "reach", reach.to_f64(), wanted));
    }
    if pushes {
        return Ok(());
    }
    let wanted = "above 0 at some overlap up to a tenth of the contact distance";
    Err(Error::input(Subject::Rule, "force", 0.0, wanted))
}
