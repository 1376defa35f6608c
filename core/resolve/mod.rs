//! What happens then? Reads an event and the rule; writes bodies, returns the outcome and whose predictions are void.

mod answer;
mod clearance;
mod collision;
mod contact;
mod contact_end;
mod context;
mod effects;
mod event;
mod impact_frame;
mod instantaneous;
mod parameters;
mod plane;
mod rest;
mod support;
mod supported;
mod wake;

pub(crate) use contact::continue_under as continue_contact_under;
pub(crate) use context::Context;
pub use effects::EventOutcome;
pub(crate) use effects::{Effects, Incident};
pub(crate) use event::resolve;
pub(crate) use parameters::Parameters;
pub use parameters::Release;
pub(crate) use support::{lies_on, min_hop_time};
