//! Which rule is known when the program runs only? Boxes a rule; reads and writes nothing.
//!
//! The engine is compiled once for each type of rule, and takes seconds of that. Where a rule is asked by a pointer it
//! is compiled once for all of them; a run takes hardly longer. What is timed has a rule of its own type.

use carom::Error;
use carom::law::{Answer, ContactForce, Enduring, Impact, Rule};

/// A rule of any kind.
pub type AnyRule<'a> = Box<dyn Rule<f64> + Send + Sync + 'a>;

/// A rule of any kind, of smooth grains.
pub type SmoothRule<'a> = Smooth<AnyRule<'a>>;

/// A rule of smooth grains, boxed.
///
/// ```
/// use carom::law::{HardSphere, Rule};
/// let rule = carom_host::any_rule::smooth(HardSphere { restitution: 0.9 });
/// assert!(rule.check().is_ok() && rule.inertia().is_none());
/// ```
pub fn smooth<'a>(rule: impl Rule<f64> + Send + Sync + 'a) -> SmoothRule<'a> {
    Smooth(Box::new(rule))
}

/// A rule whose grains are smooth, so that the compiler leaves out what rotation needs.
#[derive(Debug)]
pub struct Smooth<R>(R);

impl<R: Rule<f64>> Rule<f64> for Smooth<R> {
    fn collide(&self, impact: &Impact<f64>) -> Answer<f64> {
        self.0.collide(impact)
    }
    fn enduring(&self) -> Option<Enduring> {
        self.0.enduring()
    }
    fn adds_energy(&self) -> bool {
        self.0.adds_energy()
    }
    fn check(&self) -> Result<(), Error> {
        self.0.check()
    }
    fn force(&self, impact: &Impact<f64>, overlap: f64) -> Option<ContactForce<f64>> {
        self.0.force(impact, overlap)
    }
    fn contact_time(&self, impact: &Impact<f64>, overlap: f64) -> Option<f64> {
        self.0.contact_time(impact, overlap)
    }
    fn remembers(&self) -> bool {
        self.0.remembers()
    }
    fn remembered_force(&self, impact: &Impact<f64>, now: [f64; 2], memory: &mut [f64; 2]) -> f64 {
        self.0.remembered_force(impact, now, memory)
    }
    fn reach(&self, impact: &Impact<f64>) -> f64 {
        self.0.reach(impact)
    }
}
