//! What does a contact do? Force laws, tables and rules; reads an impact, writes its outcome.

mod adhesion;
mod contact_law;
pub mod embedded;
mod enduring;
mod hard;
mod hysteretic;
mod load;
mod material;
mod mode;
mod pair_tabulated;
mod power_law;
mod rough;
mod rule;
mod scales;
mod soft;
mod stick_slip;
mod tangential;

pub use adhesion::{Adhesive, Dmt, Jkr};
pub(crate) use contact_law::tried;
pub use contact_law::{ContactLaw, Integrated, Memory};
pub use enduring::Enduring;
pub use hard::{Central, HardSphere};
pub use hysteretic::{Cohesive, WaltonBraun};
pub use material::{ByMaterial, PairRules};
pub use mode::{IntegratedMode, PaperMode};
pub use pair_tabulated::PairTabulated;
pub use power_law::PowerLaw;
pub use rough::Rough;
pub use rule::{Answer, ContactForce, Impact, Outcome, Response, Rule, Validity};
pub use scales::{ForceLaw, LinearDashpot, Scales, Viscoelastic};
pub use soft::{Outside, Soft};
pub(crate) use stick_slip::SurfaceContact;
pub use tangential::Tangential;
