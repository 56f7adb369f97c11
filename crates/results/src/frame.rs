//! The rectangle of data space that a panel shows.

use grazing_continuation::curve::Window;

use crate::dimensioned;

/// The least and the greatest of some numbers; [∞, −∞] if there are none.
pub fn span(numbers: impl IntoIterator<Item = f64>) -> [f64; 2] {
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    numbers.into_iter().fold(none, |[low, high], number| [low.min(number), high.max(number)])
}

/// A rectangle of data space, shown by one panel, in the units of the data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Lower and upper end of the horizontal axis.
    pub x: [f64; 2],
    /// Lower and upper end of the vertical axis.
    pub y: [f64; 2],
}

// A frame of the plane of the two parameters; what shows another plane says what its frames are made of.
dimensioned! {
    Frame, |own| {
        own.x[0] => "{primary}",
        own.x[1] => "{primary}",
        own.y[0] => "{secondary}",
        own.y[1] => "{secondary}",
    }
}

impl Frame {
    /// The corners of the rectangle, with the first one repeated at the end.
    pub fn outline(&self) -> [(f64, f64); 5] {
        let ([left, right], [low, high]) = (self.x, self.y);
        [(left, low), (right, low), (right, high), (left, high), (left, low)]
    }

    /// Whether the point is inside or on the edge; false for NaN.
    pub fn contains(&self, (x, y): (f64, f64)) -> bool {
        self.x[0] <= x && x <= self.x[1] && self.y[0] <= y && y <= self.y[1]
    }
}

impl From<Window> for Frame {
    /// The primary parameter on the horizontal axis and the secondary one on the vertical axis.
    fn from(window: Window) -> Self {
        Self { x: window.primary, y: window.secondary }
    }
}
