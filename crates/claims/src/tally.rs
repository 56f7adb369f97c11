//! Tallies of measurements that result in one [`Outcome`]. A NaN is never lost.

use crate::outcome::{Measure, Outcome};

/// The largest deviation.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Deviations {
    largest: f64,
    samples: usize,
}

impl Deviations {
    /// Adds the modulus of one deviation.
    pub(crate) fn see(&mut self, deviation: f64) {
        let deviation = deviation.abs();
        if deviation.is_nan() || deviation > self.largest {
            self.largest = deviation;
        }
        self.samples += 1;
    }

    /// The tally of these deviations.
    pub(crate) fn of(deviations: impl IntoIterator<Item = f64>) -> Self {
        let mut largest = Self::default();
        deviations.into_iter().for_each(|deviation| largest.see(deviation));
        largest
    }

    /// Adds the difference of two numbers, relative to the scale of their terms.
    pub(crate) fn compare(&mut self, computed: f64, expected: f64, scale: f64) {
        self.see((computed - expected) / scale);
    }

    /// Adds the differences of pairs (found, stated), relative to one plus |stated|.
    pub(crate) fn pairs(&mut self, pairs: impl IntoIterator<Item = (f64, f64)>) {
        pairs.into_iter().for_each(|(found, stated)| self.compare(found, stated, 1.0 + stated.abs()));
    }

    /// Adds a yes-or-no condition; if it fails, no deviation counts as small.
    pub(crate) fn require(&mut self, holds: bool) {
        self.see(if holds { 0.0 } else { f64::INFINITY });
    }

    /// The largest deviation; NaN if one of them is NaN.
    pub(crate) fn largest(&self) -> f64 {
        self.largest
    }

    /// The largest deviation with a tolerance.
    pub(crate) fn measure(&self, tolerance: f64) -> Measure {
        Measure::Deviation { largest: self.largest, tolerance }
    }

    /// The outcome, with the number of deviations.
    pub(crate) fn outcome(&self, tolerance: f64, over: &str) -> Outcome {
        Outcome::new(self.measure(tolerance), self.samples, over)
    }
}

/// The smallest of many numbers: margins of an inequality, or orders of a remainder.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Smallest {
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
    pub(crate) fn see(&mut self, value: f64) {
        if value.is_nan() || value < self.value {
            self.value = value;
        }
        self.samples += 1;
    }

    /// Adds an order that has to be resolved: if it never was, nothing was tested.
    pub(crate) fn see_resolved(&mut self, order: f64) {
        self.see(if order == f64::INFINITY { f64::NEG_INFINITY } else { order });
    }

    /// Adds a yes-or-no condition; if it fails, no number counts as large.
    pub(crate) fn require(&mut self, holds: bool) {
        self.see(if holds { f64::INFINITY } else { f64::NEG_INFINITY });
    }

    /// The smallest number as a margin.
    pub(crate) fn margin(&self, over: &str) -> Outcome {
        Outcome::new(Measure::Margin { smallest: self.value }, self.samples, over)
    }

    /// The smallest number as an order.
    pub(crate) fn order(&self, stated: f64, slack: f64, over: &str) -> Outcome {
        Outcome::new(Measure::Order { observed: self.value, stated, slack }, self.samples, over)
    }
}

/// The number of cases that agree with a statement.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Votes {
    agreeing: usize,
    cases: usize,
    silent: usize,
}

impl Votes {
    /// Adds one case.
    pub(crate) fn see(&mut self, agrees: bool) {
        self.agreeing += usize::from(agrees);
        self.cases += 1;
    }

    /// The tally of these cases.
    pub(crate) fn of(cases: impl IntoIterator<Item = bool>) -> Self {
        let mut votes = Self::default();
        cases.into_iter().for_each(|agrees| votes.see(agrees));
        votes
    }

    /// Adds a case on which the statement is silent.
    pub(crate) fn silent(&mut self) {
        self.silent += 1;
    }

    /// The count as a measurement.
    pub(crate) fn measure(&self) -> Measure {
        Measure::Agreement { agreeing: self.agreeing, cases: self.cases }
    }

    /// The count as an outcome.
    pub(crate) fn outcome(&self, over: &str) -> Outcome {
        let over = match self.silent {
            0 => over.to_owned(),
            silent => format!("{over}; the statement is silent on {silent} more"),
        };
        Outcome::new(self.measure(), self.cases, over)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn deviations(values: &[f64], tolerance: f64) -> Outcome {
        Deviations::of(values.iter().copied()).outcome(tolerance, "")
    }

    fn margin(values: &[f64]) -> Outcome {
        let mut smallest = Smallest::default();
        values.iter().for_each(|value| smallest.see(*value));
        smallest.margin("")
    }

    #[test]
    fn the_extreme_is_kept_and_what_is_not_a_number_stays() {
        let outcome = deviations(&[1.0, -3.0, 2.0], 3.0);
        assert_eq!(outcome, Outcome::new(Measure::Deviation { largest: 3.0, tolerance: 3.0 }, 3, ""));
        assert_eq!(margin(&[1.0, -3.0, 2.0]).measure, Measure::Margin { smallest: -3.0 });
        let spoiled = [1.0, f64::NAN, 2.0];
        assert!(!deviations(&spoiled, 10.0).passes() && !margin(&spoiled).passes());
    }

    #[test]
    fn a_remainder_that_was_never_seen_and_a_broken_condition_count_against_the_statement() {
        let mut smallest = Smallest::default();
        smallest.see_resolved(2.0);
        assert!(smallest.order(2.0, 0.1, "").passes());
        smallest.see_resolved(f64::INFINITY);
        assert!(!smallest.order(2.0, 0.1, "").passes());
        let (mut deviations, mut smallest) = (Deviations::default(), Smallest::default());
        deviations.require(false);
        smallest.require(false);
        assert!(!deviations.measure(1.0).holds() && !smallest.margin("").passes());
    }

    #[test]
    fn votes_count_both_sides() {
        let mut votes = Votes::of([true, false]);
        votes.silent();
        assert_eq!(votes.measure(), Measure::Agreement { agreeing: 1, cases: 2 });
        assert!(votes.outcome("").over.contains("silent on 1 more"));
    }
}
