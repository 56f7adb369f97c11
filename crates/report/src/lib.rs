//! The report: one HTML page of all results, to be read beside the paper.
//!
//! [`Report`] holds figures, tables, verdicts and a manifest, and [`page`] turns it into one text
//! without a reference to anything outside except links to follow. Equal reports give equal bytes;
//! there is no date in them. The page is assembled from `templates/`, with a file for each of its
//! sections. It has a style sheet and a few scripts of its own, in `assets/`: zoom in `zoom.js` and
//! `panels.js` (with `scales.js` and `gestures.js`, which the page of `explore` also uses), values
//! under the pointer in `figures.js`, sorting and filtering in `tables.js`, the filters of the
//! ledger in `claims.js`, light and dark in `theme.js`. Without scripts it is a document like any
//! other, except for the rows of long tables.
//!
//! Figures for print are its second output: a [`Drawing`] is a figure, read from its SVG, that becomes PDF or
//! PNG.
//!
//! This crate computes nothing and does no input or output.

mod columns;
mod data;
mod figure;
mod formats;
mod formula;
mod html;
mod ledger;
mod manifest;
mod oscillator;
mod outputs;
mod page;
mod published;
mod report;
mod table;

// The sample is used by the tests in this crate and by those beside it.
#[cfg(test)]
extern crate self as grazing_report;
#[cfg(test)]
#[path = "../tests/sample/mod.rs"]
mod sample;

pub use formats::{Drawing, FormatError, comparison};
pub use formula::{FormulaError, mathml};
pub use manifest::{FileDigest, Manifest};
pub use oscillator::OscillatorEntry;
pub use outputs::{FigureEntry, TableOutput};
pub use page::page;
pub use report::{Counts, FiguresAndTables, Report};
