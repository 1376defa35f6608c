//! What happens then? Reads an event and the rule; writes bodies, returns the outcome and whose predictions are void.

mod accept_answer;
mod broken_contact;
mod clearance;
mod contact_begin;
mod contact_end;
mod context;
mod crowded_collision;
mod effects;
mod event;
mod grain_collision;
mod gravity_change;
mod impact_frame;
mod instantaneous_collision;
mod make_room;
mod parameters;
mod plane_collision;
mod rest;
mod simultaneous_collision;
mod support;
mod supported_collision;
mod wake;

pub(crate) use broken_contact::cluster as cluster_contact;
pub(crate) use contact_end::end as end_contact;
pub(crate) use context::Context;
pub use effects::EventOutcome;
pub(crate) use effects::{Effects, Incident};
pub(crate) use event::resolve;
pub(crate) use gravity_change::continue_contact;
pub(crate) use parameters::Parameters;
pub use parameters::Release;
pub(crate) use simultaneous_collision::{Crowd, Grains, slack};
pub(crate) use support::{lies_on, min_hop_time};
pub(crate) use wake::let_go;
