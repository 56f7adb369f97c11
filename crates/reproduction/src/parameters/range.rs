//! Ranges of one and of two parameters.

/// A closed range of finite numbers that is not empty: `lower < upper`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    lower: f64,
    upper: f64,
}

impl Range {
    /// The range `[lower, upper]`; `None` unless both are finite and `lower < upper`.
    pub fn new(lower: f64, upper: f64) -> Option<Range> {
        (lower.is_finite() && upper.is_finite() && lower < upper).then_some(Range { lower, upper })
    }

    /// The lower end.
    pub fn lower(&self) -> f64 {
        self.lower
    }

    /// The upper end.
    pub fn upper(&self) -> f64 {
        self.upper
    }

    /// `upper - lower`, positive.
    pub fn width(&self) -> f64 {
        self.upper - self.lower
    }

    /// Whether `value` lies in the range, its ends included; never for NaN.
    pub fn contains(&self, value: f64) -> bool {
        self.lower <= value && value <= self.upper
    }

    /// Whether `value` lies in the range, its ends excluded.
    pub fn strictly_contains(&self, value: f64) -> bool {
        self.lower < value && value < self.upper
    }

    /// Whether all of `other` lies in this range.
    pub fn encloses(&self, other: &Range) -> bool {
        self.lower <= other.lower && other.upper <= self.upper
    }
}

/// A part of the (amplitude, frequency) plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rectangle {
    amplitude: Range,
    frequency: Range,
}

impl Rectangle {
    /// The rectangle of all (amplitude, frequency) with both in their range.
    pub fn new(amplitude: Range, frequency: Range) -> Rectangle {
        Rectangle { amplitude, frequency }
    }

    /// The forcing amplitudes, across.
    pub fn amplitude(&self) -> Range {
        self.amplitude
    }

    /// The forcing frequencies, up.
    pub fn frequency(&self) -> Range {
        self.frequency
    }

    /// Whether the point lies in the rectangle, its edges included.
    pub fn contains(&self, amplitude: f64, frequency: f64) -> bool {
        self.amplitude.contains(amplitude) && self.frequency.contains(frequency)
    }
}
