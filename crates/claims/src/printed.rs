//! Numbers of `expected/published.toml` that checks need, such as the parameters of Figure 2.

use serde::Deserialize;
use thiserror::Error;

const FILE: &str = include_str!("../../../expected/published.toml");

/// A number could not be read.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PrintedError {
    /// The file is not as it should be.
    #[error("expected/published.toml: {0}")]
    Unreadable(String),
    /// There is no such number.
    #[error("expected/published.toml has no number {0}")]
    Missing(String),
}

#[derive(Deserialize)]
struct File {
    value: Vec<Entry>,
}

#[derive(Deserialize)]
struct Entry {
    id: String,
    value: String,
}

/// The printed number with this identifier.
///
/// # Errors
/// [`PrintedError`].
pub fn printed(id: &str) -> Result<f64, PrintedError> {
    let file: File = toml::from_str(FILE).map_err(|error| PrintedError::Unreadable(error.message().to_owned()))?;
    let entry = file.value.into_iter().find(|entry| entry.id == id);
    let entry = entry.ok_or_else(|| PrintedError::Missing(id.to_owned()))?;
    entry.value.parse().map_err(|_| PrintedError::Unreadable(format!("{id} is not a number")))
}
