//! The report: one HTML page that shows what was computed, to be read beside the paper.
//!
//! [`Report`] holds figures, tables, verdicts and a manifest as plain data, and [`page`] makes the page of it: one text
//! without a reference to anything outside it but links to follow. Equal reports give equal bytes; there is no date in
//! them. The page has a style sheet and a few scripts of its own, in `assets/`: zoom and values under the pointer in
//! `figures.js`, sorting and filtering in `tables.js`, the filters of the ledger in `claims.js`, light and dark in
//! `theme.js`. Without scripts it is a document like any other.
//!
//! This crate computes nothing and does no input or output.

mod claim;
mod columns;
mod data;
mod figure;
mod formula;
mod html;
mod ledger;
mod manifest;
mod misprints;
mod oscillator;
mod oscillators;
mod page;
mod published;
mod summary;
mod table;

// The sample serves the tests in this crate and those beside it.
#[cfg(test)]
extern crate self as grazing_report;
#[cfg(test)]
#[path = "../tests/sample/mod.rs"]
mod sample;

pub use claim::{ClaimEntry, Measured, MisprintEntry, Source, State, Verdict};
pub use figure::Figure;
pub use formula::{FormulaError, mathml, prose};
pub use manifest::{Manifest, OutputFile};
pub use oscillator::{CoefficientEntry, Finding, Judgement, OscillatorEntry, ResonanceEntry};
pub use page::page;
pub use published::PublishedEntry;
pub use table::TableOutput;

/// All that the page shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    /// The figures, in the order of the paper.
    pub figures: Vec<Figure>,
    /// The outputs that are tables only.
    pub tables: Vec<TableOutput>,
    /// The numbers that the paper prints, with the computed ones.
    pub published: Vec<PublishedEntry>,
    /// The ledger of claims, in the order of the paper.
    pub claims: Vec<ClaimEntry>,
    /// Oscillators from text files. A page can be about them alone: parts of which there is nothing are left out.
    pub oscillators: Vec<OscillatorEntry>,
    /// What of all this could not be made, or not wholly, and why.
    pub missing: Vec<String>,
    /// What was made, from what, and by what.
    pub manifest: Manifest,
    /// The path from the page's folder to the root of the repository, as `../` or nothing, for the links to source files;
    /// without it, files are named but not linked.
    pub root: Option<String>,
}

impl Report {
    /// Whether anything of the paper is shown.
    fn is_of_the_paper(&self) -> bool {
        !(self.figures.is_empty()
            && self.tables.is_empty()
            && self.published.is_empty()
            && self.claims.is_empty())
    }
}
