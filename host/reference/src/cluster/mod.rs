//! How do grains in contact move, as one system? Reads their state at an instant; writes their motion up to the next end of a contact.

mod equations;
mod members;
mod step;

pub(crate) use members::{Cluster, Link, Side};
