//! Has somebody asked to stop? Reads signals by a handler; whoever is at work looks whether there was one.

use crate::output;
use std::sync::atomic::{AtomicBool, Ordering};

/// Somebody has asked.
static ASKED: AtomicBool = AtomicBool::new(false);
/// Somebody looks.
static HEEDED: AtomicBool = AtomicBool::new(false);

/// A run was stopped from outside and can go on.
#[derive(Debug, thiserror::Error)]
#[error("stopped at t = {time} s; the same command with --restart goes on from there")]
pub struct Stopped {
    /// Where (s).
    pub time: f64,
}

/// For the handler of an interrupt: whoever heeds it gets time to stop at the first; else, and at the
/// second, drafts go and the program ends.
pub fn handle() {
    let first = !ASKED.swap(true, Ordering::SeqCst);
    if !(first && HEEDED.load(Ordering::SeqCst)) {
        output::discard_drafts();
        std::process::exit(130);
    }
}

/// As long as this lives somebody looks often whether there was an interrupt.
#[derive(Debug)]
pub struct Heed(());

impl Heed {
    /// Begins to heed interrupts.
    pub fn new() -> Self {
        HEEDED.store(true, Ordering::SeqCst);
        Self(())
    }

    /// Whether there was one.
    pub fn is_asked(&self) -> bool {
        ASKED.load(Ordering::SeqCst)
    }
}

impl Default for Heed {
    fn default() -> Self {
        Self::new()
    }
}

impl Drop for Heed {
    fn drop(&mut self) {
        HEEDED.store(false, Ordering::SeqCst);
    }
}
