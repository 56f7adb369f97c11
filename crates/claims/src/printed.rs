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

fn entries() -> Result<Vec<Entry>, PrintedError> {
    let file: File =
        toml::from_str(FILE).map_err(|error| PrintedError::Unreadable(error.message().to_owned()))?;
    Ok(file.value)
}

impl Entry {
    fn number(&self) -> Result<f64, PrintedError> {
        self.value.parse().map_err(|_| PrintedError::Unreadable(format!("{} is not a number", self.id)))
    }
}

/// The printed number with this identifier.
///
/// # Errors
/// [`PrintedError`].
pub fn printed(id: &str) -> Result<f64, PrintedError> {
    let entry = entries()?.into_iter().find(|entry| entry.id == id);
    entry.ok_or_else(|| PrintedError::Missing(id.to_owned()))?.number()
}

/// The printed values of a quantity at resonances: p, n, and the number with identifier `quantity_p…_n…`.
///
/// # Errors
/// [`PrintedError`].
pub fn printed_at_resonances(quantity: &str) -> Result<Vec<(u32, u32, f64)>, PrintedError> {
    let indices = |id: &str| {
        let (loops, index) = id.strip_prefix(quantity)?.strip_prefix("_p")?.split_once("_n")?;
        Some((loops.parse().ok()?, index.parse().ok()?))
    };
    let mut found = Vec::new();
    for entry in entries()? {
        if let Some((loops, index)) = indices(&entry.id) {
            found.push((loops, index, entry.number()?));
        }
    }
    Ok(found)
}
