//! The part of a plane in which a description is valid.

use grazing_model::smooth::{SmoothOscillator, Stop};

use crate::checks::Sampler;
use crate::description::Description;

/// The number of cells of the lattice along either parameter, at whose corners places are checked.
const CELLS: usize = 24;
/// The number of times that a cell is halved to find where the sides lie.
const HALVINGS: i32 = 5;
/// The ratio of the highest forcing frequency in the ranges to the lowest that is allowed outside of them: as the
/// period grows without limit, so does the number of resonances.
const SLOWEST: f64 = 16.0;

impl Description {
    /// The largest rectangle of places in these ranges at which the checks of a file pass, as far as a
    /// lattice shows; the ranges need not be those of the file. None if there is none, or once the computation is
    /// cancelled.
    pub fn valid_part(&self, ranges: [[f64; 2]; 2], stop: &Stop) -> Option<[[f64; 2]; 2]> {
        if !ranges.iter().all(|[low, high]| low < high) {
            return None;
        }
        let sampler = Sampler::new(self);
        let line = |[low, high]: [f64; 2], line: usize| {
            let share = line as f64 / CELLS as f64;
            low * (1.0 - share) + high * share
        };
        let [low, high] = self.forcing_frequencies();
        let slowest = low.min(high / SLOWEST);
        let passes = |at: [f64; 2]| {
            !stop.is_asked() && self.forcing_frequency::<f64>(at[0], at[1]) >= slowest && sampler.passes(at)
        };
        let valid = |i: usize, j: usize| passes([line(ranges[0], i), line(ranges[1], j)]);
        let valid: Vec<Vec<bool>> = (0..=CELLS).map(|i| (0..=CELLS).map(|j| valid(i, j)).collect()).collect();
        let mut largest = (0, [[0; 2]; 2]);
        for first in 0..=CELLS {
            let mut column = vec![true; CELLS + 1];
            for last in first..=CELLS {
                column.iter_mut().zip(&valid[last]).for_each(|(all, valid)| *all &= valid);
                let mut from = 0;
                for (j, valid) in column.iter().enumerate() {
                    if !valid {
                        from = j + 1;
                        continue;
                    }
                    let area = (last - first) * (j - from);
                    if area > largest.0 {
                        largest = (area, [[first, last], [from, j]]);
                    }
                }
            }
        }
        let (area, cells) = largest;
        if area == 0 {
            return None;
        }
        let mut part = [0, 1].map(|k| cells[k].map(|at| line(ranges[k], at)));
        // Each side moves out by parts of a cell.
        for halving in 1..=HALVINGS {
            for (k, end) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                let [low, high] = ranges[k];
                let outwards = if end == 0 { -1.0 } else { 1.0 };
                let step = (high - low) / CELLS as f64 * 0.5_f64.powi(halving);
                let side = (part[k][end] + outwards * step).clamp(low, high);
                let along = part[1 - k];
                let places = (0..=CELLS).map(|at| match k {
                    0 => [side, line(along, at)],
                    _ => [line(along, at), side],
                });
                if side != part[k][end] && places.clone().all(passes) {
                    part[k][end] = side;
                }
            }
        }
        (!stop.is_asked()).then_some(part)
    }
}
