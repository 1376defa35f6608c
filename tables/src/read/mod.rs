//! How is a table laid out, and what does it say about a collision? Reads the scaled groups and a table; writes the scaled restitution.
//!
//! [`Table::read`] is the entrance. The other types are the parts of a table; generated Rust text
//! names them, a program need not.

pub(crate) mod certificate;
mod chebyshev;
pub(crate) mod coordinates;
pub(crate) mod domain;
pub(crate) mod groups;
pub(crate) mod history;
pub(crate) mod law;
pub(crate) mod layout;
pub(crate) mod pair;
pub(crate) mod real;
mod square_root;
pub(crate) mod stored;
pub(crate) mod table;

pub use certificate::Certificate;
pub use coordinates::CoordinateMap;
pub use domain::Domain;
pub use groups::{Groups, ScaledRestitution};
pub use history::{Compression, History, TERMS};
pub use law::{End, Law};
pub use layout::{Branch, Leaf, Row, TableData};
pub use pair::{PAIR_TERMS, PairCertificate, PairOutcome, PairTable};
pub use real::Real;
pub use stored::{Quantised, StoredNumber};
pub use table::Table;
