//! Progress of long work, on standard error, only where that is a terminal.

use indicatif::{ProgressBar, ProgressStyle};
use std::time::Duration;

/// Work of unknown length, such as growing.
pub fn spinner(quiet: bool, what: &str) -> Progress {
    let bar = if quiet { ProgressBar::hidden() } else { ProgressBar::new_spinner() };
    let style = ProgressStyle::with_template("{spinner} {msg} {elapsed}");
    let bar = bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_spinner()));
    bar.enable_steady_tick(Duration::from_millis(120));
    Progress(bar.with_message(what.to_string()))
}

/// Work of a known number of steps, such as frames.
pub fn bar(quiet: bool, what: &str, steps: u64) -> Progress {
    let bar = if quiet { ProgressBar::hidden() } else { ProgressBar::new(steps) };
    let style = ProgressStyle::with_template("{msg} {wide_bar} {pos}/{len} {eta}");
    let bar = bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    Progress(bar.with_message(what.to_string()))
}

/// A bar that is gone from the screen when it goes out of scope, errors included.
pub struct Progress(ProgressBar);

impl Progress {
    /// One more step is done.
    pub fn step(&self) {
        self.0.inc(1);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
