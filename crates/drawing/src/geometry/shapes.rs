//! Outlines of the markers.

use crate::geometry::sheet::Spot;

/// The outline of an upright star with five points.
pub(crate) fn star((x, y): Spot, radius: f64) -> Vec<Spot> {
    // Sines and cosines of multiples of 36 degrees, clockwise from the top; the inner corners are
    // those of the pentagram.
    const INNER: f64 = 0.381_97;
    const TURNS: [Spot; 10] = [
        (0.0, 1.0),
        (0.587_79, 0.809_02),
        (0.951_06, 0.309_02),
        (0.951_06, -0.309_02),
        (0.587_79, -0.809_02),
        (0.0, -1.0),
        (-0.587_79, -0.809_02),
        (-0.951_06, -0.309_02),
        (-0.951_06, 0.309_02),
        (-0.587_79, 0.809_02),
    ];
    let corner = |(index, &(right, up)): (usize, &Spot)| {
        let reach = if index % 2 == 0 { radius } else { INNER * radius };
        (x + reach * right, y - reach * up)
    };
    TURNS.iter().enumerate().map(corner).collect()
}

/// An upright triangle of equal sides with its centroid at the spot, up to the hundredths of the
/// sheet.
pub(crate) fn triangle((x, y): Spot, side: f64) -> [Spot; 3] {
    // Heights 1/sqrt(3) above the centroid and 1/(2 sqrt(3)) below.
    let [up, down, half] = [0.577_35, 0.288_68, 0.5].map(|share| (100.0 * share * side).round() / 100.0);
    [(x, y - up), (x + half, y + down), (x - half, y + down)]
}
