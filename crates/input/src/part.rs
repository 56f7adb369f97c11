//! The part of a plane in which a description is valid.

use grazing_model::smooth::{SmoothOscillator, Stop};

use crate::checks::PlaceChecks;
use crate::description::Description;

/// The number of cells of the lattice along either parameter, at whose corners places are checked.
const CELLS: usize = 24;
/// The number of times that a cell is halved to find where the sides lie.
const HALVINGS: u32 = 5;
/// The ratio of the highest forcing frequency in the ranges to the lowest that is allowed outside of them: as the
/// period grows without limit, so does the number of resonances.
const SLOWEST: f64 = 16.0;

impl Description {
    /// The largest rectangle of places in these ranges at which the checks of a file pass, as far as a lattice
    /// shows; the ranges need not be those of the file. None if there is none, or once the computation is
    /// cancelled.
    pub fn valid_part(&self, ranges: [[f64; 2]; 2], stop: &Stop) -> Option<[[f64; 2]; 2]> {
        if !ranges.iter().all(|[low, high]| low < high) {
            return None;
        }
        let seen: Vec<Description> = self.from_each_wall().collect();
        let samplers: Vec<PlaceChecks<'_>> = seen.iter().map(PlaceChecks::new).collect();
        let [low, high] = self.forcing_frequencies();
        let slowest = low.min(high / SLOWEST);
        let passes = |at: [f64; 2]| {
            !stop.is_asked()
                && self.forcing_frequency::<f64>(at[0], at[1]) >= slowest
                && samplers.iter().all(|sampler| sampler.passes(at))
        };
        let mut part = largest(ranges, &passes)?;
        // Each side moves out by parts of a cell.
        let mut steps = ranges.map(|[low, high]| (high - low) / CELLS as f64);
        for _ in 0..HALVINGS {
            steps = steps.map(|step| 0.5 * step);
            for (k, end) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                let step = if end == 0 { -steps[k] } else { steps[k] };
                let side = (part[k][end] + step).clamp(ranges[k][0], ranges[k][1]);
                let mut places = (0..=CELLS).map(|at| match k {
                    0 => [side, line(part[1], at)],
                    _ => [line(part[0], at), side],
                });
                if places.all(passes) {
                    part[k][end] = side;
                }
            }
        }
        (part.iter().all(|[low, high]| low < high) && !stop.is_asked()).then_some(part)
    }
}

/// The value at a line of the lattice over a range.
fn line([low, high]: [f64; 2], line: usize) -> f64 {
    let share = line as f64 / CELLS as f64;
    low * (1.0 - share) + high * share
}

/// The largest rectangle, or part of a line, all of whose places in the lattice pass.
fn largest(ranges: [[f64; 2]; 2], passes: &impl Fn([f64; 2]) -> bool) -> Option<[[f64; 2]; 2]> {
    let valid: Vec<[bool; CELLS + 1]> = (0..=CELLS)
        .map(|i| core::array::from_fn(|j| passes([line(ranges[0], i), line(ranges[1], j)])))
        .collect();
    let mut best = (0, [[0; 2]; 2]);
    for first in 0..=CELLS {
        let mut all = [true; CELLS + 1];
        for (last, column) in valid.iter().enumerate().skip(first) {
            all.iter_mut().zip(column).for_each(|(all, valid)| *all &= valid);
            let mut from = 0;
            for (j, valid) in all.iter().enumerate() {
                if !valid {
                    from = j + 1;
                    continue;
                }
                let places = (last - first + 1) * (j - from + 1);
                if places > best.0 {
                    best = (places, [[first, last], [from, j]]);
                }
            }
        }
    }
    let (places, lines) = best;
    (places > 0).then(|| [0, 1].map(|k| lines[k].map(|at| line(ranges[k], at))))
}
