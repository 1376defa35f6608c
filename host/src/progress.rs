//! How far is it? Reads what is done; writes a bar to standard error, if that is a terminal.

use indicatif::{ProgressBar, ProgressStyle};

/// A bar that shows how much is done, for work that can be counted.
#[derive(Debug)]
pub struct Progress(ProgressBar);

impl Progress {
    /// Nothing of `total` is done.
    pub fn new(label: &str, total: u64) -> Self {
        let bar = ProgressBar::new(total).with_prefix(label.to_owned());
        let style = "{prefix} [{bar:24}] {percent:>3} %  {msg}  {eta} left";
        if let Ok(style) = ProgressStyle::with_template(style) {
            bar.set_style(style.progress_chars("=> "));
        }
        Self(bar)
    }

    /// So much more is done.
    pub fn add(&self, done: u64) {
        self.0.inc(done);
    }

    /// A word on what is being done.
    pub fn say(&self, message: impl Into<String>) {
        self.0.set_message(message.into());
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
