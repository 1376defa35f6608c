//! What moves? Grains as users and as the engine know them, and what they touch; reads numbers, writes nothing.

mod body;
mod grain;
mod index;
mod partner;

pub use body::Body;
pub use grain::Grain;
pub use index::Index;
pub use partner::Partner;
