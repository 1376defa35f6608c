//! How far is it? Reads what is done; writes a bar to standard error, if that is a terminal.
//!
//! Bars belong to the program: without the feature `cli` nothing is shown.

#[cfg(feature = "cli")]
use indicatif::{ProgressBar as Bar, ProgressStyle};

/// A bar that shows how much is done, for work that can be counted.
#[derive(Debug)]
pub struct Progress(Bar);

impl Progress {
    /// Nothing of `total` is done.
    pub fn new(label: &str, total: u64) -> Self {
        let style = "{prefix} [{bar:24}] {percent:>3} %  {msg}  {eta} left";
        Self(styled(Bar::new(total).with_prefix(label.to_owned()), style))
    }

    /// So much of a method's run is done already; bars of several methods stand in line.
    pub(crate) fn of_method(label: &str, total: u64, done: u64) -> Self {
        let style = "{prefix:>9} [{bar:24}] {percent:>3} %  {msg}  {eta} left";
        let bar = Bar::new(total).with_prefix(label.to_owned()).with_position(done);
        let bar = styled(bar, style);
        bar.reset_eta();
        Self(bar)
    }

    /// So many of all runs are done already.
    pub(crate) fn of_runs(total: u64, done: u64) -> Self {
        let style = "{pos}/{len} runs [{bar:30}] {per_sec}, {eta} left";
        let bar = styled(Bar::new(total).with_position(done), style);
        bar.reset_eta();
        Self(bar)
    }

    /// So much more is done.
    pub fn add(&self, done: u64) {
        self.0.inc(done);
    }

    /// So much is done in all.
    pub(crate) fn set(&self, done: u64) {
        self.0.set_position(done);
    }

    /// A text on what is being done.
    pub fn set_message(&self, message: impl Into<String>) {
        self.0.set_message(message.into());
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}

#[cfg(feature = "cli")]
fn styled(bar: Bar, style: &str) -> Bar {
    if let Ok(style) = ProgressStyle::with_template(style) {
        bar.set_style(style.progress_chars("=> "));
    }
    bar
}

#[cfg(not(feature = "cli"))]
fn styled(bar: Bar, _: &str) -> Bar {
    bar
}

/// A bar that nobody sees.
#[cfg(not(feature = "cli"))]
#[derive(Debug)]
struct Bar;

#[cfg(not(feature = "cli"))]
impl Bar {
    fn new(_: u64) -> Self {
        Self
    }

    fn with_prefix(self, _: String) -> Self {
        self
    }

    fn with_position(self, _: u64) -> Self {
        self
    }

    fn reset_eta(&self) {}

    fn inc(&self, _: u64) {}

    fn set_position(&self, _: u64) {}

    fn set_message(&self, _: String) {}

    fn finish_and_clear(&self) {}
}
