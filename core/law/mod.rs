//! What does a contact do? Force laws, tables and rules; reads an impact, writes its outcome.

pub mod embedded;
mod enduring;
mod hard;
mod load;
mod material;
mod mode;
mod rule;
mod scales;
mod soft;

pub use enduring::Enduring;
pub use hard::{Central, HardSphere};
pub use material::{ByMaterial, PairRules};
pub use mode::{IntegratedMode, PaperMode};
pub use rule::{Answer, ContactForce, Impact, Outcome, Response, Rule, Validity};
pub use scales::{ForceLaw, LinearDashpot, Scales, Viscoelastic};
pub use soft::{Outside, Soft};
