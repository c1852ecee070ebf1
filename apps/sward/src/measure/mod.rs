//! Measuring what a scene costs, for `bench` and `paper`.

mod report;
mod times;

pub use report::{Measured, Milliseconds, Percentiles, Report};
pub use times::{Times, frames_run, measure, statistics, warm_up_frames};
