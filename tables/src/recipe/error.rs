//! What is wrong with a recipe? Reads nothing; writes one clear line.

use std::fmt::{self, Display};
use std::path::PathBuf;

/// Why a table could not be made.
#[derive(Debug)]
#[non_exhaustive]
pub enum Error {
    /// A field of the recipe is out of range.
    Field {
        /// Its name.
        field: &'static str,
        /// Its value.
        value: String,
        /// What would be right.
        wanted: &'static str,
    },
    /// The file could not be written.
    Write {
        /// The file.
        path: PathBuf,
        /// What the file system said.
        source: std::io::Error,
    },
}

impl Error {
    pub(super) fn field(field: &'static str, value: impl Display, wanted: &'static str) -> Self {
        Error::Field { field, value: value.to_string(), wanted }
    }
}

impl Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Field { field, value, wanted } => {
                write!(f, "recipe: {field} is {value}, but must be {wanted}")
            }
            Error::Write { path, source } => write!(f, "{}: {source}", path.display()),
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Error::Write { source, .. } => Some(source),
            Error::Field { .. } => None,
        }
    }
}
