//! The report: one HTML page that shows what was computed, to be read beside the paper.
//!
//! [`Report`] holds figures, tables, verdicts and a manifest, and [`page`] makes the page of it: one text without a
//! reference to anything outside it but links to follow. Equal reports give equal bytes; there is no date in them. The
//! page is put together from `templates/`, a file for each of its sections. It has a style sheet and a few scripts of its
//! own, in `assets/`: zoom in `zoom.js` and `panels.js` (with `scales.js` and `gestures.js`, which the page of `explore` has, too), values under the pointer in `figures.js`, sorting and filtering
//! in `tables.js`, the filters of the ledger in `claims.js`, light and dark in `theme.js`. Without scripts it is a document
//! like any other, but for the rows of long tables.
//!
//! This crate computes nothing and does no input or output.

mod columns;
mod data;
mod figure;
mod formula;
mod html;
mod ledger;
mod legend;
mod manifest;
mod oscillator;
mod page;
mod published;
mod svg;
mod table;

// The sample serves the tests in this crate and those beside it.
#[cfg(test)]
extern crate self as grazing_report;
#[cfg(test)]
#[path = "../tests/sample/mod.rs"]
mod sample;

use grazing_claims::audit::{ClaimVerdict, Finding};
use grazing_claims::published::Comparison;
use grazing_claims::source::Sources;

use html::Html;

pub use figure::FigureEntry;
pub use formula::{FormulaError, mathml};
pub use manifest::{Manifest, OutputFile};
pub use oscillator::OscillatorEntry;
pub use page::page;
pub use table::TableOutput;

/// All that the page shows.
#[derive(Debug, Clone, Default)]
pub struct Report<'a> {
    /// The figures, in the order of the paper.
    pub figures: Vec<FigureEntry>,
    /// The outputs that are tables only.
    pub tables: Vec<TableOutput>,
    /// The numbers that the paper prints, with the computed ones.
    pub published: Vec<Comparison<'a>>,
    /// The claims with what came of testing them, in the order of the paper.
    pub claims: Vec<Finding<'a>>,
    /// The source files to which claims lead.
    pub sources: Sources,
    /// Oscillators from text files, each with an identifier of its own. A page can be about them alone: parts of which there is nothing are
    /// left out.
    pub oscillators: Vec<OscillatorEntry>,
    /// What of all this could not be made, or not wholly, and why.
    pub missing: Vec<String>,
    /// What was made, from what, and by what.
    pub manifest: Manifest,
    /// The address of the repository's files at its host, with a slash at its end, for the links to source files; without it, files are
    /// named but not linked: a page is passed on without the files beside it.
    pub root: Option<String>,
}

/// How much of the paper came out how.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Counts {
    /// Published values that are met.
    pub met: usize,
    /// Claims that hold.
    pub passed: usize,
    /// Claims that do not, or whose check broke down.
    pub failed: usize,
    /// Claims that are not tested by a computation.
    pub unchecked: usize,
    /// Misprints.
    pub misprints: usize,
}

impl Report<'_> {
    /// How much of the paper came out how.
    pub fn counts(&self) -> Counts {
        let count = |is: fn(&Finding<'_>) -> bool| self.claims.iter().filter(|finding| is(finding)).count();
        let failed = count(|finding| finding.verdict.fails());
        let unchecked = count(|finding| matches!(finding.verdict, ClaimVerdict::Unchecked(_)));
        Counts {
            met: self.published.iter().filter(|comparison| comparison.is_met()).count(),
            passed: self.claims.len() - failed - unchecked,
            failed,
            unchecked,
            misprints: count(|finding| finding.claim.misprint.is_some()),
        }
    }

    /// Whether anything of the paper is shown.
    fn is_of_the_paper(&self) -> bool {
        !(self.figures.is_empty()
            && self.tables.is_empty()
            && self.published.is_empty()
            && self.claims.is_empty())
    }

    /// Links to those of the files with these paths that were written: of an oscillator only where its files are all that there are.
    fn links(&self, paths: &[String], of_oscillator: bool) -> Vec<Html> {
        let listed = self.manifest.outputs.iter().filter(|file| paths.contains(&file.path));
        let there = listed.filter(|_| !(of_oscillator && self.is_of_the_paper()));
        there.map(|file| self.manifest.link(&file.path)).collect()
    }

    /// The figures of the paper and of all oscillators.
    fn all_figures(&self) -> impl Iterator<Item = &FigureEntry> {
        self.figures.iter().chain(self.oscillators.iter().flat_map(|oscillator| &oscillator.figures))
    }
}
