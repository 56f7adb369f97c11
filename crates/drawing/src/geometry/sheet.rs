//! Geometry on the sheet for placing labels: spots, boxes, polylines and polygons, in points.

use grazing_results::span;

/// A position on the sheet, in points to the right and downwards.
pub type Spot = (f64, f64);

/// A position in hundredths of a point, the precision of files.
pub type Hundredths = (i32, i32);

pub(crate) fn in_hundredths((x, y): Spot) -> Hundredths {
    ((x * 100.0).round() as i32, (y * 100.0).round() as i32)
}

pub(crate) fn in_points((x, y): Hundredths) -> Spot {
    (f64::from(x) / 100.0, f64::from(y) / 100.0)
}

pub(crate) fn all_in_hundredths(spots: &[Spot]) -> Vec<Hundredths> {
    spots.iter().map(|&spot| in_hundredths(spot)).collect()
}

/// A rectangle of the sheet, in points to the right and downwards.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// The least horizontal coordinate.
    pub left: f64,
    /// The least vertical coordinate.
    pub top: f64,
    /// The greatest horizontal coordinate.
    pub right: f64,
    /// The greatest vertical coordinate.
    pub bottom: f64,
}

impl Bounds {
    /// The centre of the rectangle.
    pub fn centre(&self) -> Spot {
        (0.5 * (self.left + self.right), 0.5 * (self.top + self.bottom))
    }

    /// The rectangle enlarged by `by` on every side.
    pub fn grown(&self, by: f64) -> Bounds {
        Bounds { left: self.left - by, top: self.top - by, right: self.right + by, bottom: self.bottom + by }
    }

    /// The smallest rectangle that contains both.
    pub fn joined(self, other: Bounds) -> Bounds {
        Bounds {
            left: self.left.min(other.left),
            top: self.top.min(other.top),
            right: self.right.max(other.right),
            bottom: self.bottom.max(other.bottom),
        }
    }

    /// The intersection of both rectangles; with reversed sides if it is empty.
    #[must_use]
    pub fn common(self, other: Bounds) -> Bounds {
        Bounds {
            left: self.left.max(other.left),
            top: self.top.max(other.top),
            right: self.right.min(other.right),
            bottom: self.bottom.min(other.bottom),
        }
    }

    /// Whether both share more than a border.
    pub fn overlaps(&self, other: &Bounds) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }

    /// Whether the rectangle contains all of the other.
    pub fn holds(&self, inner: &Bounds) -> bool {
        self.left <= inner.left
            && inner.right <= self.right
            && self.top <= inner.top
            && inner.bottom <= self.bottom
    }

    /// Whether part of the segment lies in the rectangle.
    pub fn meets(&self, from: Spot, to: Spot) -> bool {
        fractions_inside([self.left, self.right], [self.top, self.bottom], from, to).is_some()
    }

    /// The smallest rectangle that contains these spots; with reversed sides if there are none.
    pub fn around(spots: &[Spot]) -> Bounds {
        let [left, right] = span(spots.iter().map(|spot| spot.0));
        let [top, bottom] = span(spots.iter().map(|spot| spot.1));
        Bounds { left, top, right, bottom }
    }

    /// The rectangle of this size about a centre.
    pub fn about((x, y): Spot, width: f64, height: f64) -> Bounds {
        Bounds {
            left: x - 0.5 * width,
            top: y - 0.5 * height,
            right: x + 0.5 * width,
            bottom: y + 0.5 * height,
        }
    }
}

/// The fractions of the segment from `a` to `b` at which it enters and leaves a rectangle (Liang–Barsky).
pub(crate) fn fractions_inside(x: [f64; 2], y: [f64; 2], a: (f64, f64), b: (f64, f64)) -> Option<(f64, f64)> {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for (outward, room) in [(-dx, a.0 - x[0]), (dx, x[1] - a.0), (-dy, a.1 - y[0]), (dy, y[1] - a.1)] {
        if outward == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if outward < 0.0 {
            enter = enter.max(room / outward);
        } else {
            leave = leave.min(room / outward);
        }
    }
    (enter <= leave).then_some((enter, leave))
}

/// The least length (points) of segments of thinned curves, which is fine enough for placing labels.
const THINNED_STEP: f64 = 0.8;

/// The distance of two spots.
pub fn distance(a: Spot, b: Spot) -> f64 {
    let (dx, dy) = (a.0 - b.0, a.1 - b.1);
    (dx * dx + dy * dy).sqrt()
}

/// Whether two segments cross.
pub fn cross((a, b): (Spot, Spot), (from, to): (Spot, Spot)) -> bool {
    let side = |a: Spot, b: Spot, c: Spot| (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0) > 0.0;
    side(a, b, from) != side(a, b, to) && side(from, to, a) != side(from, to, b)
}

/// Whether the spot is inside the closed polygon (even-odd rule).
pub fn inside(polygon: &[Spot], (x, y): Spot) -> bool {
    let mut within = false;
    for (a, b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        if (a.1 > y) != (b.1 > y) && x < a.0 + (y - a.1) / (b.1 - a.1) * (b.0 - a.0) {
            within = !within;
        }
    }
    within
}

/// The curve without points closer than [`THINNED_STEP`] to the previous one kept; both ends are kept.
pub(crate) fn thinned(curve: &[Spot]) -> Vec<Spot> {
    let mut kept: Vec<Spot> = Vec::new();
    for (index, &spot) in curve.iter().enumerate() {
        if kept.last().is_none_or(|&last| distance(last, spot) >= THINNED_STEP) || index + 1 == curve.len() {
            kept.push(spot);
        }
    }
    kept
}

/// Length of a polyline on the sheet, in points.
pub(crate) fn length(curve: &[Spot]) -> f64 {
    curve.windows(2).map(|pair| distance(pair[0], pair[1])).sum()
}

/// The spot at a fraction of the curve's length, and the curve's unit direction there.
pub(crate) fn along(curve: &[Spot], fraction: f64) -> Option<(Spot, Spot)> {
    let mut left = fraction * length(curve);
    for pair in curve.windows(2) {
        let step = distance(pair[0], pair[1]);
        if step > 0.0 && left <= step {
            let direction = ((pair[1].0 - pair[0].0) / step, (pair[1].1 - pair[0].1) / step);
            return Some(((pair[0].0 + left * direction.0, pair[0].1 + left * direction.1), direction));
        }
        left -= step;
    }
    None
}

/// Whether the spot is within reach of a curve.
pub(crate) fn near(curve: &[Spot], spot: Spot, reach: f64) -> bool {
    let box_around = Bounds::about(spot, 2.0 * reach, 2.0 * reach);
    curve.windows(2).any(|pair| box_around.meets(pair[0], pair[1]))
}

/// Area of a polygon on the sheet, in square points.
pub(crate) fn area(polygon: &[Spot]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    (0.5 * polygon.iter().zip(next).map(|(a, b)| a.0 * b.1 - b.0 * a.1).sum::<f64>()).abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_box_crossed_by_a_segment_need_not_hold_its_ends() {
        let bounds = Bounds::about((0.0, 0.0), 2.0, 2.0);
        assert!(bounds.meets((-5.0, -4.0), (5.0, 4.0)));
        assert!(!bounds.meets((-5.0, 0.0), (5.0, 9.0)));
    }

    #[test]
    fn half_way_along_a_hook_is_measured_along_it() {
        let hook = [(0.0, 0.0), (4.0, 0.0), (4.0, 2.0)];
        assert_eq!(length(&hook), 6.0);
        assert_eq!(along(&hook, 0.5), Some(((3.0, 0.0), (1.0, 0.0))));
        assert_eq!(along(&hook, 5.0 / 6.0).unwrap().1, (0.0, 1.0));
    }

    #[test]
    fn inside_follows_a_reentrant_outline() {
        let hook = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (3.0, 4.0), (3.0, 1.0), (0.0, 1.0)];
        assert!(inside(&hook, (3.5, 3.0)) && inside(&hook, (0.5, 0.5)));
        assert!(!inside(&hook, (1.5, 2.5)));
        assert_eq!(area(&hook), 7.0);
    }

    #[test]
    fn thinning_keeps_the_ends_and_the_shape() {
        let fine: Vec<Spot> = (0..=100).map(|i| (0.1 * f64::from(i), 0.0)).collect();
        let coarse = thinned(&fine);
        assert!(coarse.len() < 20);
        assert_eq!((coarse[0], coarse[coarse.len() - 1]), (fine[0], fine[100]));
        assert!((length(&coarse) - length(&fine)).abs() < 1e-12);
    }
}
