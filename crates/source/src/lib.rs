//! TOML files that people write: the way back from a mistake to file, line, key, value and what would be right.
//!
//! A [`Source`] is a file's text with the [`Requirements`] of its keys. Its tables are read key by key ([`Section`]), and whatever is
//! wrong becomes a [`SourceError`]. The parameters of the figures and the descriptions of oscillators are read through it.

mod error;
mod requirements;
mod section;
mod setting;
mod text;
mod words;

pub use error::SourceError;
pub use requirements::Requirements;
pub use section::Section;
pub use setting::{Setting, SettingError};
pub use text::{Source, Text, read_file};
pub use words::{nearest, shortened, suggestion};
