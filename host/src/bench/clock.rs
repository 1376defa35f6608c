//! How much computing was that? Reads the process's clock; writes nothing, returns seconds.

/// User CPU time of this process (s): what others do on the machine is left out as far as it can be.
#[cfg(unix)]
pub fn user_seconds() -> f64 {
    use nix::sys::resource::{UsageWho, getrusage};
    use nix::sys::time::TimeValLike;
    getrusage(UsageWho::RUSAGE_SELF)
        .map_or(0.0, |usage| usage.user_time().num_microseconds() as f64 * 1e-6)
}

/// Seconds since the first call, where there is no CPU time to be had.
#[cfg(not(unix))]
pub fn user_seconds() -> f64 {
    use std::sync::OnceLock;
    use std::time::Instant;
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed().as_secs_f64()
}
