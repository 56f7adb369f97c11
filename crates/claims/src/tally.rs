//! Tallies of measurements that result in one [`Outcome`]. A NaN is never lost.

use crate::outcome::{Measure, Outcome};

/// The largest deviation.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Deviations {
    largest: f64,
    samples: usize,
}

impl Deviations {
    /// Adds the modulus of one deviation.
    pub fn see(&mut self, deviation: f64) {
        let deviation = deviation.abs();
        if deviation.is_nan() || deviation > self.largest {
            self.largest = deviation;
        }
        self.samples += 1;
    }

    /// The tally of these deviations.
    pub fn of(deviations: impl IntoIterator<Item = f64>) -> Self {
        let mut largest = Self::default();
        deviations.into_iter().for_each(|deviation| largest.see(deviation));
        largest
    }

    /// Adds the difference of two numbers, relative to the scale of their terms.
    pub fn compare(&mut self, computed: f64, expected: f64, scale: f64) {
        self.see((computed - expected) / scale);
    }

    /// Adds the differences of pairs (found, stated), relative to one plus |stated|.
    pub fn pairs(&mut self, pairs: impl IntoIterator<Item = (f64, f64)>) {
        pairs.into_iter().for_each(|(found, stated)| self.compare(found, stated, 1.0 + stated.abs()));
    }

    /// Adds a yes-or-no condition; if it fails, no deviation counts as small.
    pub fn require(&mut self, holds: bool) {
        self.see(if holds { 0.0 } else { f64::INFINITY });
    }

    /// The largest deviation; NaN if one of them is NaN.
    pub fn largest(&self) -> f64 {
        self.largest
    }

    /// The largest deviation with a tolerance.
    pub fn measure(&self, tolerance: f64) -> Measure {
        Measure::Deviation { largest: self.largest, tolerance }
    }

    /// The outcome, with the number of deviations.
    pub fn outcome(&self, tolerance: f64, over: &str) -> Outcome {
        Outcome::new(self.measure(tolerance), self.samples, over)
    }
}

/// The smallest of many numbers: margins of an inequality, or orders of a remainder.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Smallest {
    value: f64,
    samples: usize,
}

impl Default for Smallest {
    fn default() -> Self {
        Self { value: f64::INFINITY, samples: 0 }
    }
}

impl Smallest {
    /// Adds one number.
    pub fn see(&mut self, value: f64) {
        if value.is_nan() || value < self.value {
            self.value = value;
        }
        self.samples += 1;
    }

    /// Adds an order that has to be resolved: if it never was, nothing was tested.
    pub fn see_resolved(&mut self, order: f64) {
        self.see(if order == f64::INFINITY { f64::NEG_INFINITY } else { order });
    }

    /// Adds a yes-or-no condition; if it fails, no number counts as large.
    pub fn require(&mut self, holds: bool) {
        self.see(if holds { f64::INFINITY } else { f64::NEG_INFINITY });
    }

    /// The smallest number as a margin.
    pub fn margin(&self, over: &str) -> Outcome {
        Outcome::new(Measure::Margin { smallest: self.value }, self.samples, over)
    }

    /// The smallest number as an order.
    pub fn order(&self, stated: f64, slack: f64, over: &str) -> Outcome {
        Outcome::new(Measure::Order { observed: self.value, stated, slack }, self.samples, over)
    }
}

/// The number of cases that agree with a statement.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Votes {
    agreeing: usize,
    cases: usize,
    silent: usize,
}

impl Votes {
    /// Adds one case.
    pub fn see(&mut self, agrees: bool) {
        self.agreeing += usize::from(agrees);
        self.cases += 1;
    }

    /// The tally of these cases.
    pub fn of(cases: impl IntoIterator<Item = bool>) -> Self {
        let mut votes = Self::default();
        cases.into_iter().for_each(|agrees| votes.see(agrees));
        votes
    }

    /// Adds a case on which the statement is silent.
    pub fn silent(&mut self) {
        self.silent += 1;
    }

    /// The count as a measurement.
    pub fn measure(&self) -> Measure {
        Measure::Agreement { agreeing: self.agreeing, cases: self.cases }
    }

    /// The count as an outcome.
    pub fn outcome(&self, over: &str) -> Outcome {
        let over = match self.silent {
            0 => over.to_owned(),
            silent => format!("{over}; the statement is silent on {silent} more"),
        };
        Outcome::new(self.measure(), self.cases, over)
    }
}
