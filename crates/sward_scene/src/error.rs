//! The error type: one line each, with the file, the place, the cause and the remedy.

use std::path::{Path, PathBuf};

/// What can be wrong with a scene, or with a file that it refers to.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SceneError {
    /// A file cannot be read.
    #[error("{}: {cause}", file.display())]
    Read {
        /// The file.
        file: PathBuf,
        /// Why, and what to do.
        cause: String,
    },
    /// The scene is not well-formed RON, or has an unknown key or a value of the wrong type.
    #[error("{}:{line}:{column}: {cause}", file.display())]
    Syntax {
        /// The scene file.
        file: PathBuf,
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// What is wrong.
        cause: String,
    },
    /// A value is out of its range, or names something that is not there.
    #[error("{}{}: {key}: {cause}", file.display(), place(*at))]
    Value {
        /// The scene file.
        file: PathBuf,
        /// Line and column, from 1.
        at: Option<(usize, usize)>,
        /// The key as a path, such as `fields[0].species[1].height_m`.
        key: String,
        /// What is wrong and what is allowed.
        cause: String,
    },
    /// A mesh or an image that the scene refers to is broken.
    #[error("{}: {cause}", file.display())]
    Asset {
        /// The file.
        file: PathBuf,
        /// What is wrong with it, where, and what to do.
        cause: String,
    },
    /// There is no camera of that name.
    #[error("{}: no camera '{name}'; there are: {known}", file.display())]
    Camera {
        /// The scene file.
        file: PathBuf,
        /// The name asked for.
        name: String,
        /// The names that there are.
        known: String,
    },
}

fn place(at: Option<(usize, usize)>) -> String {
    at.map(|(line, column)| format!(":{line}:{column}")).unwrap_or_default()
}

impl SceneError {
    pub(crate) fn asset(file: &Path, cause: impl Into<String>) -> Self {
        Self::Asset { file: file.into(), cause: one_line(&cause.into()) }
    }

    pub(crate) fn read(file: &Path, error: &std::io::Error) -> Self {
        let cause = match error.kind() {
            std::io::ErrorKind::NotFound => "no such file; check the path".into(),
            std::io::ErrorKind::IsADirectory => "is a folder; name a file".into(),
            std::io::ErrorKind::PermissionDenied => "may not be read; check its permissions".into(),
            std::io::ErrorKind::InvalidData => "is not UTF-8 text".into(),
            _ => format!("cannot be read: {}", one_line(&error.to_string())),
        };
        Self::Read { file: file.into(), cause }
    }
}

/// Messages of other crates may hold line breaks; ours are one line.
pub(crate) fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
