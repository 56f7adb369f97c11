//! How densely the places lie at which solutions are sought by lattices in a window.
//!
//! Where the distances by which motion misses its beginning hardly change from one side of the
//! window to the other, lattices at many places in it show the same; in a window that is narrow
//! enough a few are sufficient.

use grazing_continuation::curve::Window;
use grazing_model::{AnyOscillator, ImpactOscillator};

use super::field::Missed;
use super::{CELLS, Lattice, misses};

/// Largest change between neighbouring places of the distances by which motion misses its
/// beginning, as a fraction of their range on a cell of the lattice that is divided first
/// (empirical: in whole windows of the examples, where slices are closest, it is 1 to 2.5; and a cell is
/// divided up to 32 times along each side).
const CHANGE: f64 = 1.0;

/// Of so many equal intervals between levels of η in a window, the number after each of which
/// lattices are needed: it divides the number of intervals.
///
/// In as many intervals all distances change by no more than [`CHANGE`], as far as the corners and
/// the middle of the window show.
pub(super) fn stride(
    intervals: usize,
    lattice: impl Fn([f64; 2]) -> Lattice,
    (oscillator, loops): (&AnyOscillator, &[u32]),
    window: Window,
) -> usize {
    if intervals == 0 {
        return 1;
    }
    let rough = oscillator.roughly();
    let at = |shares: [f64; 2]| coarse(&lattice(window.parameters(shares)), &rough, loops);
    let middle = at([0.5; 2]);
    let corners = [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]];
    let change = corners.into_iter().map(|corner| change(&middle, &at(corner))).fold(0.0, f64::max);
    // From a corner to the middle and on; NaN is much.
    let few = |parts: &usize| intervals.is_multiple_of(*parts) && 2.0 * change <= CHANGE * *parts as f64;
    intervals / (1..=intervals).find(few).unwrap_or(intervals)
}

/// The distances for each number of loops at the corners of the cells that are divided first, row
/// by row.
type Coarse = Vec<Vec<Vec<Missed>>>;

fn coarse(lattice: &Lattice, rough: &AnyOscillator, loops: &[u32]) -> Coarse {
    let [across, up] = lattice.sides(1);
    let at = |i: u32, k: u32| &lattice.start + &across * f64::from(i) + &up * f64::from(k);
    let row = |i| (0..=CELLS[1]).map(|k| misses(rough, loops.iter().copied(), &at(i, k))).collect();
    (0..=lattice.cells).map(row).collect()
}

/// The largest change from one lattice to another, as a fraction of the range on a cell beside it.
fn change(from: &Coarse, to: &Coarse) -> f64 {
    let mut largest = 0.0;
    let rows = from.windows(2).zip(to.windows(2));
    for (from, to) in rows {
        for k in 1..from[0].len() {
            let corners = |rows: &[Vec<Vec<Missed>>], p: usize| {
                [&rows[0][k - 1], &rows[0][k], &rows[1][k - 1], &rows[1][k]].map(|at| at[p].xy())
            };
            for p in 0..from[0][k].len() {
                let [here, there] = [corners(from, p), corners(to, p)];
                let range = here.iter().flat_map(|a| here.iter().map(move |b| (a - b).norm()));
                let range = range.fold(0.0, f64::max);
                let moved = (0..4).map(|corner| (there[corner] - here[corner]).norm() / range);
                // NaN is much.
                largest = moved.fold(largest, |most, moved| if moved <= most { most } else { moved });
            }
        }
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::super::USUAL_VELOCITY;
    use super::*;

    #[test]
    fn lattices_are_the_farther_apart_the_narrower_the_window_is() {
        let oscillator = crate::specimens::forced("-0.04*v - x - 0.1*x^3", 0.8).oscillator([0.5, 0.9]);
        let strides = [0.3, 0.03, 0.01, 0.003, 0.001].map(|width| {
            let window = Window { primary: [0.5, 0.5 + width], secondary: [0.9, 0.9 + width] };
            let lattice = |place| Lattice::slow(place, USUAL_VELOCITY);
            stride(16, lattice, (&oscillator, &[1, 2]), window)
        });
        assert_eq!((strides[0], strides[4]), (1, 16), "{strides:?}");
        assert!(strides.windows(2).all(|pair| pair[0] <= pair[1]), "{strides:?}");
        // Every part of the intervals is as long.
        assert!(strides.iter().all(|stride| 16 % stride == 0));
    }
}
