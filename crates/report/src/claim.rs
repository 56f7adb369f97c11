//! A claim with what came of testing it, as plain data.

use crate::PublishedEntry;
use crate::html::number;

/// A claim of the paper with what came of testing it.
#[derive(Debug, Clone, PartialEq)]
pub struct ClaimEntry {
    /// The label, as `eq:gp`.
    pub label: String,
    /// Where it stands: "section 2.4, eq. (15)".
    pub place: String,
    /// The kind of statement: "identity".
    pub kind: String,
    /// The statement in words.
    pub says: String,
    /// The formula in LaTeX.
    pub formula: Option<String>,
    /// The items that hold it.
    pub holds: Vec<Source>,
    /// The check that tests it.
    pub check: Option<Source>,
    /// The figures that show it, as `fig04`.
    pub figures: Vec<String>,
    /// What came of it.
    pub verdict: Verdict,
    /// The misprint, if there is one.
    pub misprint: Option<MisprintEntry>,
}

/// A function or another item of the code.
#[derive(Debug, Clone, PartialEq)]
pub struct Source {
    /// Its path, as `grazing_theorems::auxiliary::resonance_boundary`.
    pub name: String,
    /// The file from the root of the repository, where it is known, and the line, from 1.
    pub file: Option<(String, usize)>,
}

/// Where print and mathematics differ; words with LaTeX between dollars.
#[derive(Debug, Clone, PartialEq)]
pub struct MisprintEntry {
    /// The print.
    pub printed: String,
    /// The corrected form.
    pub corrected: String,
    /// Why, and what follows from it.
    pub reason: String,
    /// The computation that decides it.
    pub decided: String,
}

/// What came of testing a claim.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
    /// A check was run.
    Checked {
        /// Whether the statement holds, and the print, where it differs, does not.
        passed: bool,
        /// The statement, corrected where needed.
        measured: Measured,
        /// The statement as printed, where that differs.
        print: Option<Measured>,
        /// Number of points, cases or searches.
        samples: usize,
        /// What they were.
        over: String,
    },
    /// A check could not be carried out.
    Failed {
        /// Why.
        error: String,
    },
    /// It was compared with published values.
    Published {
        /// These.
        values: Vec<PublishedEntry>,
    },
    /// It was not tested numerically.
    Unchecked {
        /// Why.
        reason: String,
    },
}

/// One measurement, with what it is held against.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Measured {
    /// The largest deviation of an identity.
    Deviation {
        /// What was seen.
        largest: f64,
        /// What is explained by rounding.
        tolerance: f64,
    },
    /// The order of a remainder.
    Order {
        /// The smallest seen.
        observed: f64,
        /// The one that is stated.
        stated: f64,
        /// How far below it may lie.
        slack: f64,
    },
    /// The smallest margin of an inequality.
    Margin {
        /// Positive where it holds.
        smallest: f64,
    },
    /// Cases in which a statement was seen to hold.
    Agreement {
        /// Those that agree.
        agreeing: usize,
        /// All.
        cases: usize,
    },
}

/// The three ways a claim can come out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum State {
    /// It holds.
    Passed,
    /// It does not, or the check broke down.
    Failed,
    /// It was not tested.
    Unchecked,
}

impl State {
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::Failed => "failed",
            Self::Unchecked => "unchecked",
        }
    }
}

impl Verdict {
    /// How the claim came out.
    pub fn state(&self) -> State {
        let passed = match self {
            Self::Checked { passed, .. } => *passed,
            Self::Failed { .. } => false,
            Self::Published { values } => !values.is_empty() && values.iter().all(|value| value.met),
            Self::Unchecked { .. } => return State::Unchecked,
        };
        if passed { State::Passed } else { State::Failed }
    }
}

impl Measured {
    /// The measurement in words, as HTML.
    pub(crate) fn html(&self) -> String {
        match *self {
            Self::Deviation { largest, tolerance } => {
                format!("largest deviation <b>{}</b>, tolerance {}", number(largest, 2), number(tolerance, 2))
            }
            Self::Order { observed, stated, slack } => format!(
                "order <b>{}</b> seen, {} stated (slack {})",
                number(observed, 3),
                number(stated, 1),
                number(slack, 1)
            ),
            Self::Margin { smallest } => {
                format!("smallest margin <b>{}</b>, to be positive", number(smallest, 2))
            }
            Self::Agreement { agreeing, cases } => format!("<b>{agreeing}</b> of {cases} cases agree"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measurements_stand_beside_what_they_are_held_against() {
        let deviation = Measured::Deviation { largest: 3.14e-15, tolerance: 1e-12 };
        assert_eq!(
            deviation.html(),
            "largest deviation <b>3.1 × 10<sup>−15</sup></b>, tolerance 10<sup>−12</sup>"
        );
        assert_eq!(
            Measured::Order { observed: f64::INFINITY, stated: 2.0, slack: 0.3 }.html(),
            "order <b>∞</b> seen, 2 stated (slack 0.3)"
        );
    }

    #[test]
    fn a_claim_about_numbers_passes_only_if_all_are_met() {
        let value = |met| PublishedEntry {
            id: "a".into(),
            quantity: "a".into(),
            printed: "1".into(),
            computed: Some(1.0),
            met,
            label: "eq:a".into(),
            place: "somewhere".into(),
        };
        let state = |values| Verdict::Published { values }.state();
        assert_eq!(state(vec![value(true), value(true)]), State::Passed);
        assert_eq!(state(vec![value(true), value(false)]), State::Failed);
        assert_eq!(state(vec![]), State::Failed);
    }
}
