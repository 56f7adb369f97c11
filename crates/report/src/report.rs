//! The content of the page.

use grazing_claims::audit::{ClaimVerdict, Finding};
use grazing_claims::errata;
use grazing_claims::published::{PublishedComparison, Tally};
use grazing_claims::source::Sources;

use crate::html::Html;
use crate::manifest::Manifest;
use crate::oscillator::OscillatorEntry;
use crate::outputs::{FigureEntry, TableOutput};

/// Everything that the page shows.
#[derive(Debug, Clone, Default)]
pub struct Report<'a> {
    /// The figures, in the order of the paper.
    pub figures: Vec<FigureEntry>,
    /// The outputs that are tables only.
    pub tables: Vec<TableOutput>,
    /// The figures and tables beyond the paper, about what it leaves open.
    pub beyond: FiguresAndTables,
    /// The numbers that the paper prints, with the computed ones.
    pub published: Vec<PublishedComparison<'a>>,
    /// The claims with the findings of their tests, in the order of the paper.
    pub claims: Vec<Finding<'a>>,
    /// The source files to which claims lead.
    pub sources: Sources,
    /// Oscillators from text files, each with an identifier of its own. A page can be about them
    /// alone: empty parts are omitted.
    pub oscillators: Vec<OscillatorEntry>,
    /// Sentences about what failed or is incomplete, and why.
    pub missing: Vec<String>,
    /// The manifest of the files, their parameters, and the program.
    pub manifest: Manifest,
    /// The address of the repository's files at its host, with a slash at its end, for the links to
    /// source files; without it, files are named but not linked: a page can be passed on without
    /// the files beside it.
    pub root: Option<String>,
}

/// Figures and tables.
#[derive(Debug, Clone, Default)]
pub struct FiguresAndTables {
    /// The figures.
    pub figures: Vec<FigureEntry>,
    /// The outputs that are tables only.
    pub tables: Vec<TableOutput>,
}

/// The numbers of values and claims of the paper that are confirmed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Counts {
    /// The published values, with the number of those that are met.
    pub published: Tally,
    /// Claims that hold.
    pub passed: usize,
    /// Claims that do not hold, or whose check failed to run.
    pub failed: usize,
    /// Claims that give parameters, with which the computation begins.
    pub given: usize,
    /// Claims that are not tested by a computation.
    pub unchecked: usize,
    /// Errata; one that occurs in several places is counted once.
    pub errata: usize,
}

impl Counts {
    /// Counts values, claims and errata.
    pub fn of(published: &[PublishedComparison<'_>], claims: &[Finding<'_>]) -> Self {
        let count = |is: fn(&Finding<'_>) -> bool| claims.iter().filter(|finding| is(finding)).count();
        let failed = count(|finding| finding.verdict.fails());
        let given =
            count(|finding| matches!(finding.verdict, ClaimVerdict::Given(_)) && !finding.verdict.fails());
        let unchecked = count(|finding| matches!(finding.verdict, ClaimVerdict::Unchecked(_)));
        Self {
            published: Tally::of(published),
            passed: claims.len() - failed - given - unchecked,
            failed,
            given,
            unchecked,
            errata: errata::count(claims.iter().map(|finding| finding.claim)),
        }
    }
}

impl Report<'_> {
    /// The counts of everything that the page shows.
    pub fn counts(&self) -> Counts {
        Counts::of(&self.published, &self.claims)
    }

    /// Whether the page shows anything of the paper.
    pub(crate) fn is_of_the_paper(&self) -> bool {
        !(self.figures.is_empty()
            && self.tables.is_empty()
            && self.published.is_empty()
            && self.claims.is_empty())
    }

    /// Links to those files with these paths that were written; to files of an oscillator only if
    /// the page shows nothing of the paper.
    pub(crate) fn links(&self, paths: &[String], of_oscillator: bool) -> Vec<Html> {
        let listed = self.manifest.outputs.iter().filter(|file| paths.contains(&file.path));
        let there = listed.filter(|_| !(of_oscillator && self.is_of_the_paper()));
        there.map(|file| self.manifest.link(&file.path)).collect()
    }

    /// The figures of the paper and beyond it.
    pub(crate) fn paper_figures(&self) -> impl Iterator<Item = &FigureEntry> {
        self.figures.iter().chain(&self.beyond.figures)
    }

    /// The figures of the paper, beyond it, and of all oscillators.
    pub(crate) fn all_figures(&self) -> impl Iterator<Item = &FigureEntry> {
        self.paper_figures().chain(self.oscillators.iter().flat_map(|oscillator| &oscillator.figures))
    }
}
