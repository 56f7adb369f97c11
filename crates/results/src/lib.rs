//! Results as rows of tables.
//!
//! Whoever computes makes rows of these types, whoever draws or shows takes them, and the CSV files
//! are made of them. A column is declared once, in [`columns`], with name, symbol, unit, meaning
//! and the paper's equation; a row type lists its columns ([`Row::COLUMNS`]). Headers, the pages
//! that explain the data, headings and tooltips of the report, LaTeX tables and the names that
//! parameters must not have follow from that. Rows that nobody draws (coefficients, hypotheses,
//! quantities along the grazing curve, the theorems in action) are what is computed, with a column
//! for each thing that is told of it ([`row!`]). What is made together, as all that a figure shows,
//! is declared together ([`tables!`]).
//!
//! | module | rows and tables of |
//! |---|---|
//! | [`plane`] | two-parameter diagrams and magnifications: Figures 7 and 8, and those of any oscillator |
//! | [`branches`] | Figure 2 |
//! | [`family`] | resonances as constants of an oscillator vary |
//! | [`measured`] | measurements beside a diagram, and what is identified from them |
//! | [`place`] | what an oscillator does at one place of the parameter plane |
//! | [`space`] | Figures 1, 3 and 9 |
//!
//! Rows of one figure alone stand with that figure.
//!
//! [`kinds`] says what kinds of curves, points and regions are called and how they look.

// What the macros write names this crate, here and elsewhere.
extern crate self as grazing_results;

pub mod branches;
mod cell;
pub mod columns;
pub mod family;
mod frame;
pub mod kinds;
pub mod measured;
mod names;
pub mod place;
pub mod plane;
pub mod readings;
pub mod space;
mod table;

pub use cell::{Cell, brief};
pub use columns::Column;
pub use frame::{Frame, span};
pub use names::{GREEK, Names, UnitNames, VARIED, directs, raised, symbol};
pub use table::{Row, Table, TablePlan, Tables};
