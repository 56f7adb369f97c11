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

/// An upright equilateral triangle with its centroid at the spot, to hundredths of a point.
pub(crate) fn triangle((x, y): Spot, side: f64) -> [Spot; 3] {
    // Heights 1/sqrt(3) above the centroid and 1/(2 sqrt(3)) below.
    let [up, down, half] = [0.577_35, 0.288_68, 0.5].map(|share| (100.0 * share * side).round() / 100.0);
    [(x, y - up), (x + half, y + down), (x - half, y + down)]
}

/// A regular octagon about a spot, which appears round at the size of a mark.
pub(crate) fn octagon((x, y): Spot, radius: f64) -> Vec<Spot> {
    // Cosine and sine of 22.5 degrees.
    let (long, short) = (0.923_88 * radius, 0.382_68 * radius);
    let right = [(long, -short), (long, short), (short, long), (-short, long)];
    let left = right.map(|(across, down)| (-across, -down));
    right.into_iter().chain(left).map(|(across, down)| (x + across, y + down)).collect()
}

/// An upright square about a spot.
pub(crate) fn square((x, y): Spot, side: f64) -> Vec<Spot> {
    let half = 0.5 * side;
    vec![(x - half, y - half), (x + half, y - half), (x + half, y + half), (x - half, y + half)]
}

/// A square on its corner about a spot.
pub(crate) fn diamond((x, y): Spot, diagonal: f64) -> Vec<Spot> {
    let half = 0.5 * diagonal;
    vec![(x, y - half), (x + half, y), (x, y + half), (x - half, y)]
}

/// A plus about a spot, its arms a third as wide as it is.
pub(crate) fn plus((x, y): Spot, width: f64) -> Vec<Spot> {
    let (half, sixth) = (0.5 * width, width / 6.0);
    // The corners in order, a quarter turn at a time.
    let quarter = [(half, -sixth), (half, sixth), (sixth, sixth)];
    let turned = |turns: usize| {
        quarter.map(|(right, down)| match turns {
            0 => (right, down),
            1 => (-down, right),
            2 => (-right, -down),
            _ => (down, -right),
        })
    };
    (0..4).flat_map(turned).map(|(right, down)| (x + right, y + down)).collect()
}
