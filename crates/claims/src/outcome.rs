//! What a check finds out.

use std::error::Error;

/// Why something could not be computed.
pub type Failure = Box<dyn Error + Send + Sync>;

/// What a check returns; an error is a computation that could not be done, and counts as a failure.
pub type CheckResult = Result<Outcome, Failure>;

/// How well a statement holds.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// The statement, as corrected where the paper has a misprint.
    pub measure: Measure,
    /// The statement as printed, where the print differs; it has to fail.
    pub print: Option<Measure>,
    /// Number of points, cases or searches that were looked at.
    pub samples: usize,
    /// What the samples were, in a few words: "points of the trapesium, p = 2 to 15".
    pub over: String,
}

/// One measurement, with what it is held against.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Measure {
    /// An identity: the largest deviation, and the rounding that it may have.
    Deviation {
        /// The largest deviation seen, relative to the size of the terms.
        largest: f64,
        /// What rounding, or the accuracy of the second route, explains.
        tolerance: f64,
    },
    /// An expansion: the order at which the remainder was seen to vanish.
    Order {
        /// The smallest order seen; infinite where the remainder is below rounding throughout.
        observed: f64,
        /// The order that is stated.
        stated: f64,
        /// How far below the stated one the observed order may lie, because of the next term.
        slack: f64,
    },
    /// An inequality: the smallest margin that a search could find, positive where it holds.
    Margin {
        /// The smallest value of what is said to be positive, scaled as the check says.
        smallest: f64,
    },
    /// A yes-or-no statement: the cases that agree.
    Agreement {
        /// Cases that agree.
        agreeing: usize,
        /// All cases.
        cases: usize,
    },
}

impl Measure {
    /// Whether the statement holds.
    pub fn holds(&self) -> bool {
        match *self {
            Self::Deviation { largest, tolerance } => largest <= tolerance,
            // A remainder that was never seen has no order.
            Self::Order { observed, stated, slack } => observed.is_finite() && observed >= stated - slack,
            // A search that never met its domain comes back with infinity.
            Self::Margin { smallest } => smallest > 0.0 && smallest.is_finite(),
            Self::Agreement { agreeing, cases } => cases > 0 && agreeing == cases,
        }
    }
}

impl Outcome {
    /// The outcome of a statement that is printed as it is true.
    pub fn new(measure: Measure, samples: usize, over: impl Into<String>) -> Self {
        Self { measure, print: None, samples, over: over.into() }
    }

    /// The same with the statement as printed, which differs.
    pub fn against_print(self, print: Measure) -> Self {
        Self { print: Some(print), ..self }
    }

    /// Whether the statement holds over some samples, and the print, where it differs, does not.
    pub fn passes(&self) -> bool {
        self.samples > 0 && self.measure.holds() && self.print.is_none_or(|print| !print.holds())
    }
}
