//! Results as rows of tables.
//!
//! Whoever computes makes rows of these types, whoever draws or shows takes them, and the CSV files are made of them. A column is declared
//! once, in [`columns`], with name, symbol, unit, meaning and the paper's equation; a row type lists its columns ([`Row::COLUMNS`]). Headers,
//! the pages that explain the data, headings and tooltips of the report, LaTeX tables and the names that parameters must not have
//! follow from that.
//!
//! | module | rows of |
//! |---|---|
//! | [`plane`] | two-parameter diagrams and magnifications: Figures 7 and 8, and those of any oscillator |
//! | [`resonances`] | coefficients, hypotheses, quantities along the grazing curve |
//! | [`branches`] | Figure 2 |
//! | [`space`] | Figures 1, 3 and 9 |
//! | [`sketches`] | Figures 4, 5, 6 and 10 |
//! | [`theorems`] | Theorems 2.2 to 2.5 in action |

pub mod branches;
mod cell;
pub mod columns;
mod names;
pub mod plane;
pub mod resonances;
pub mod sketches;
pub mod space;
mod table;
pub mod theorems;

pub use cell::Cell;
pub use columns::Column;
pub use names::{GREEK, Names, symbol, symbol_at_grazing};
pub use table::{Plan, Row, Table};
