//! Measuring what a scene costs, for `bench` and `paper`.

mod report;
mod times;

pub use report::{Measured, Milliseconds, Percentiles, Report};
pub use times::{
    COUNTED_FRAMES, Measuring, Times, frames_run, measure, measure_in_turns, statistics,
    warm_up_frames,
};
