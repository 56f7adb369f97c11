//! Running extremes of what a check measures; what is not a number counts against the statement.

use crate::outcome::{Measure, Outcome};

/// The largest of a number of deviations.
#[derive(Debug, Clone, Copy, Default)]
pub struct Largest {
    value: f64,
    samples: usize,
}

impl Largest {
    /// Takes in one deviation; a NaN stays.
    pub fn add(&mut self, deviation: f64) {
        self.samples += 1;
        if deviation.is_nan() || deviation > self.value {
            self.value = deviation;
        } else if self.value.is_nan() {
            self.value = f64::NAN;
        }
    }

    /// Takes in the distance of two numbers, relative to the scale of the terms that they were computed from.
    pub fn compare(&mut self, computed: f64, expected: f64, scale: f64) {
        self.add((computed - expected).abs() / scale.abs());
    }

    /// The measure with what rounding, or the accuracy of the second route, explains.
    pub fn measure(&self, tolerance: f64) -> Measure {
        Measure::Deviation { largest: self.value, tolerance }
    }

    /// The outcome.
    pub fn outcome(&self, tolerance: f64, over: impl Into<String>) -> Outcome {
        Outcome::new(self.measure(tolerance), self.samples, over)
    }
}

/// The smallest of a number of observed orders.
#[derive(Debug, Clone, Copy)]
pub struct LeastOrder {
    value: f64,
    samples: usize,
}

impl Default for LeastOrder {
    fn default() -> Self {
        Self { value: f64::INFINITY, samples: 0 }
    }
}

impl LeastOrder {
    /// Takes in one observed order; a NaN stays.
    pub fn add(&mut self, observed: f64) {
        self.samples += 1;
        if observed.is_nan() || observed < self.value {
            self.value = observed;
        }
    }

    /// Takes in one observed order of a remainder that is there to be seen: if it never was, the statement was not tested,
    /// and that counts against it.
    pub fn add_seen(&mut self, observed: f64) {
        self.add(if observed == f64::INFINITY { f64::NEG_INFINITY } else { observed });
    }

    /// The outcome against the stated order.
    pub fn outcome(&self, stated: f64, slack: f64, over: impl Into<String>) -> Outcome {
        let measure = Measure::Order { observed: self.value, stated, slack };
        Outcome::new(measure, self.samples, over)
    }
}

/// The cases that agree with a statement.
#[derive(Debug, Clone, Copy, Default)]
pub struct Cases {
    agreeing: usize,
    cases: usize,
}

impl Cases {
    /// Takes in one case.
    pub fn add(&mut self, agrees: bool) {
        self.cases += 1;
        self.agreeing += usize::from(agrees);
    }

    /// The measure.
    pub fn measure(&self) -> Measure {
        Measure::Agreement { agreeing: self.agreeing, cases: self.cases }
    }

    /// The outcome.
    pub fn outcome(&self, over: impl Into<String>) -> Outcome {
        Outcome::new(self.measure(), self.cases, over)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_a_number_stays() {
        let mut largest = Largest::default();
        let mut least = LeastOrder::default();
        for value in [1e-16, f64::NAN, 1e-17] {
            largest.add(value);
            least.add(value);
        }
        assert!(!largest.outcome(1.0, "").passes());
        assert!(!least.outcome(0.0, 0.0, "").passes());
    }

    #[test]
    fn the_largest_deviation_and_the_least_order_are_kept() {
        let mut largest = Largest::default();
        let mut least = LeastOrder::default();
        for value in [2.0, 3.0, 1.0] {
            largest.add(value);
            least.add(value);
        }
        assert_eq!(largest.measure(5.0), Measure::Deviation { largest: 3.0, tolerance: 5.0 });
        assert!(matches!(least.outcome(1.0, 0.0, "").measure, Measure::Order { observed: 1.0, .. }));
    }
}
