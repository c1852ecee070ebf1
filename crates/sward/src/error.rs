//! The one error type of the library: each variant names the cause, and its message the remedy.

/// What can go wrong when a field is described, grown, uploaded or drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A mesh cannot carry grass: it is empty, has no area, or its data are broken.
    #[error("mesh: {0}")]
    Mesh(String),
    /// A setting is out of its range. `setting` is the field's path, such as `species[1].height_m`.
    #[error("{setting}: {cause}")]
    Setting {
        /// Path of the setting as the user wrote it.
        setting: String,
        /// What is wrong and which values are allowed.
        cause: String,
    },
    /// The adapter lacks a limit or a feature that the request needs.
    #[error("{what} needs {limit} of {needed}, the adapter has {available}; {remedy}")]
    Limit {
        /// What was asked for.
        what: String,
        /// Name of the wgpu limit.
        limit: &'static str,
        /// What it would take.
        needed: u64,
        /// What there is.
        available: u64,
        /// What to do about it.
        remedy: String,
    },
    /// A saved state cannot be saved, or not gone on from: it is damaged, or of something else.
    #[error("the saved state {0}")]
    State(String),
}

impl Error {
    /// A setting out of range.
    pub(crate) fn setting(setting: impl Into<String>, cause: impl Into<String>) -> Self {
        Self::Setting { setting: setting.into(), cause: cause.into() }
    }

    /// A saved state at fault.
    pub(crate) fn state(cause: impl Into<String>) -> Self {
        Self::State(cause.into())
    }

    /// A mesh that cannot carry grass.
    pub(crate) fn mesh(cause: impl Into<String>) -> Self {
        Self::Mesh(cause.into())
    }
}

/// Checks that a setting lies in `least..=most`; NaN does not.
pub(crate) fn within(setting: &str, value: f32, least: f32, most: f32) -> Result<(), Error> {
    if (least..=most).contains(&value) {
        return Ok(());
    }
    Err(Error::setting(setting, format!("{value} is out of range; use {least} to {most}")))
}

/// Checks that a setting is above 0 and at most `most`; NaN is not.
pub(crate) fn above_zero(setting: &str, value: f32, most: f32) -> Result<(), Error> {
    if value > 0.0 && value <= most {
        return Ok(());
    }
    Err(Error::setting(setting, format!("{value} is out of range; use above 0 to {most}")))
}
