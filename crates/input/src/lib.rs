//! What people write: oscillators as text files, and TOML files of any kind whose keys are declared once.
//!
//! # Oscillators
//! A [`Description`] is read from a TOML file and has passed every check: the file names constants
//! and the two parameters μ and η, and gives the force F(x, v, t), the forcing frequency ω, the
//! restitution Φ(y, z) and the impact duration Ψ(y, z) as expressions ([`Expression`]). It is a
//! [`SmoothOscillator`](grazing_model::smooth::SmoothOscillator), like any oscillator that is
//! written in Rust.
//!
//! ```
//! use grazing_input::Description;
//! use grazing_model::smooth::SmoothOscillator;
//!
//! let text = r#"
//! name = "Duffing oscillator with a wall"
//! [parameters]
//! zeta = 0.05
//! kappa = 0.1
//! [primary]
//! name = "A"
//! range = [0.0, 1.5]
//! [secondary]
//! name = "omega"
//! range = [0.4, 1.1]
//! [motion]
//! force = "-2*zeta*v - x - kappa*x^3 - 1 + A*cos(omega*t)"
//! frequency = "omega"
//! [impact]
//! restitution = "0.8"
//! duration = "0"
//! [analysis]
//! loops = [1, 2, 3]
//! "#;
//! let duffing = Description::parse(text, "duffing.toml")?;
//! assert_eq!(duffing.force(-1.0, 0.0, 0.0, 0.5, 0.8), 1.0 + 0.1 - 1.0 + 0.5);
//! # Ok::<(), grazing_input::DescriptionError>(())
//! ```
//!
//! Errors in a file are reported as a [`DescriptionError`]: file, line, key, the expression with a
//! mark under the place, the error and its remedy.
//!
//! # Files whose keys are declared
//! The keys of a kind of file are declared once, as structs ([`keys!`]) whose fields have a [`kind`]. A
//! [`Source`] is a file's text with the [`Requirements`] of its keys. Its tables are read as such structs, or
//! key by key ([`Section`]), and every error becomes a [`SourceError`]. The parameters of the figures and the
//! descriptions of oscillators are read in this way.

mod checks;
mod description;
mod document;
mod error;
mod expression;
mod file;
mod names;
mod part;
mod read;
mod validate;

pub use description::{Description, Expressions, OneParameterRequest, OwnCurve, Wall};
pub use document::{
    Key, Keys, Mistake, Requirements, Schema, Section, Setting, SettingError, Source, SourceError,
    SourcePlace, Text, kind, nearest, read_bytes, read_file, read_foreign, shortened, suggestion, what_is,
};
pub use error::{DescriptionError, Note};
pub use expression::{Expression, ExpressionError, MOST_VALUES_ON_STACK};
pub use file::{AnalysisLimits, Axis, FigureStyle, LabelKind, WallSide};
