//! TOML files that people write: mistakes are reported with file, line, key, value and remedy.
//!
//! The keys of a kind of file are declared once, as structs ([`keys!`](crate::keys)) whose fields have a
//! [`kind`]. A [`Source`] is a file's text with the [`Requirements`] of its keys. Its tables are
//! read as such structs, or key by key ([`Section`]), and every error becomes a [`SourceError`].

mod error;
mod file;
mod keys;
pub mod kind;
mod reading;
mod section;
mod setting;
mod source;
mod text;
mod words;

pub use error::{Mistake, SourceError, SourcePlace};
pub use file::{read_bytes, read_file, read_foreign, what_is};
pub use keys::{Key, Requirements, Schema};
pub use kind::Keys;
pub use section::Section;
pub use setting::{Setting, SettingError};
pub use source::Source;
pub use text::Text;
pub use words::{nearest, shortened, suggestion};
