//! Outcomes of checks.

use std::error::Error;

/// The reason why a computation failed.
pub type CheckError = Box<dyn Error + Send + Sync>;

/// The result of a check; an error means that the computation failed, and counts as a failure.
pub type CheckResult = Result<Outcome, CheckError>;

/// A measure of how well a statement holds.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// The measurement of the statement, corrected where the paper has a misprint.
    pub measure: Measure,
    /// The measurement of the printed statement, where it differs; it has to fail.
    pub print: Option<Measure>,
    /// The number of points, cases or searches.
    pub samples: usize,
    /// A short description of the samples: "points of the trapesium, p = 2 to 15".
    pub over: String,
}

/// One measurement, with the value that it is compared with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Measure {
    /// An identity: the largest deviation, and the rounding that is tolerated.
    Deviation {
        /// The largest deviation, relative to the size of the terms.
        largest: f64,
        /// The deviation explained by rounding, or by the accuracy of the second computation.
        tolerance: f64,
    },
    /// An expansion: the observed order with which the remainder vanishes.
    Order {
        /// The smallest observed order; infinite where the remainder is below rounding throughout.
        observed: f64,
        /// The stated order.
        stated: f64,
        /// The tolerated difference of the observed order below the stated one, due to the next term.
        slack: f64,
    },
    /// An inequality: the smallest margin found by a search, positive where it holds.
    Margin {
        /// The smallest value of the quantity that should be positive, scaled as the check describes.
        smallest: f64,
    },
    /// A yes-or-no statement: the cases that agree.
    Agreement {
        /// The number of cases that agree.
        agreeing: usize,
        /// The number of all cases.
        cases: usize,
    },
}

impl Measure {
    /// Whether the statement holds.
    pub fn holds(&self) -> bool {
        match *self {
            Self::Deviation { largest, tolerance } => largest <= tolerance,
            // A remainder that was never resolved has no order.
            Self::Order { observed, stated, slack } => observed.is_finite() && observed >= stated - slack,
            // A search that never reached its domain returns infinity.
            Self::Margin { smallest } => smallest > 0.0 && smallest.is_finite(),
            Self::Agreement { agreeing, cases } => cases > 0 && agreeing == cases,
        }
    }
}

impl Outcome {
    /// The outcome of a statement that is printed correctly.
    pub fn new(measure: Measure, samples: usize, over: impl Into<String>) -> Self {
        Self { measure, print: None, samples, over: over.into() }
    }

    /// Adds the measurement of the printed statement, which differs.
    pub fn against_print(self, print: Measure) -> Self {
        Self { print: Some(print), ..self }
    }

    /// Whether the statement holds over some samples, and the printed form, where it differs, does not.
    pub fn passes(&self) -> bool {
        self.samples > 0 && self.measure.holds() && self.print.is_none_or(|print| !print.holds())
    }
}
