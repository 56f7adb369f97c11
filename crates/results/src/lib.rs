//! Results as rows of tables.
//!
//! Crates that compute produce rows of these types, crates that draw or display take them, and the CSV
//! files are written from them. A column is declared once, in [`columns`], with name, symbol, unit,
//! meaning and the paper's equation; a row type lists its columns ([`Row::COLUMNS`]). From this follow
//! the headers, the pages that explain the data, headings and tooltips of the report, LaTeX tables and
//! the names that are forbidden for parameters. A computed value may itself be a row, with a column for each
//! quantity reported ([`row!`]). Tables that are computed together, such as all tables of
//! one figure, are declared together ([`tables!`]).
//!
//! | module | rows and tables of |
//! |---|---|
//! | [`plane`] | two-parameter diagrams and magnifications: Figures 7 and 8, and those of any oscillator |
//! | [`branches`] | Figure 2 |
//! | [`grazing`] | quantities along grazing curves |
//! | [`resonance`] | results at resonances, and what all tables of resonances have |
//! | [`family`] | resonances as constants of an oscillator vary |
//! | [`measured`] | measurements beside a diagram, and what is identified from them |
//! | [`place`] | the behaviour of an oscillator at one point of the parameter plane |
//! | [`space`] | Figures 1, 3 and 9 |
//!
//! Row types used by only one figure are defined with that figure.
//!
//! [`kinds`] has the names and appearance of the kinds of curves, points and regions.

// The macros refer to this crate by its name, here and in other crates.
extern crate self as grazing_results;

pub mod branches;
mod cell;
pub mod columns;
mod dimension;
pub mod family;
mod frame;
pub mod grazing;
pub mod kinds;
pub mod measured;
mod names;
pub mod place;
pub mod plane;
pub mod readings;
pub mod resonance;
mod scientific;
pub mod space;
#[doc(hidden)]
pub mod table;
pub mod title;

pub use cell::{Cell, Stability, Tone, brief};
pub use columns::Column;
pub use dimension::{Dimension, Dimensioned, Field};
pub use frame::{Frame, span};
pub use names::{GREEK, Names, UnitNames, VARIED, directs, raised, symbol, with_unit, words};
pub use scientific::Scientific;
pub use table::{DrawnAs, Row, Table, TablePlan, Tables};
pub use title::Title;
