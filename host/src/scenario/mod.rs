//! What is to be simulated? Reads a TOML file; writes nothing, returns a checked scenario.

mod observe;
mod place;
mod read;
mod spec;
mod start;

pub use observe::{Axis, CorrelationSpec, ObserveSpec, PairSpec, ProfileSpec};
pub use place::{Placed, Side};
pub use spec::{
    EnduringSpec, Gas, GrainSpec, LawSpec, MatrixSpec, MethodName, Options, OutsideSpec,
    RadiusSpec, ReleaseSpec, Scenario, SideSpec, Sides, SurfaceSpec,
};
pub use start::{Start, touching};
