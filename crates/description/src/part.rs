//! The part of a plane in which a description is valid.

use grazing_model::smooth::{SmoothOscillator, Stop};

use crate::checks::Sampler;
use crate::description::Description;

/// The number of cells of the lattice along either parameter, at whose corners places are checked.
const CELLS: usize = 24;
/// The ratio of the highest forcing frequency in the ranges to the lowest that is allowed outside of them: as the
/// period grows without limit, so does the number of resonances.
const SLOWEST: f64 = 16.0;

impl Description {
    /// The largest rectangle of places in these ranges at which the checks of a file pass, up to the cells of
    /// a lattice; the ranges need not be those of the file. None if there is none, or once the computation is
    /// cancelled.
    pub fn valid_part(&self, ranges: [[f64; 2]; 2], stop: &Stop) -> Option<[[f64; 2]; 2]> {
        let sampler = Sampler::new(self);
        let line = |[low, high]: [f64; 2], line: usize| {
            let share = line as f64 / CELLS as f64;
            low * (1.0 - share) + high * share
        };
        let corners = [0, 1].map(|k| [self.primary(), self.secondary()][k].range());
        let corners = [0, 1].into_iter().flat_map(|i| [0, 1].map(|j| [corners[0][i], corners[1][j]]));
        let frequencies = corners.map(|[mu, eta]| self.forcing_frequency::<f64>(mu, eta));
        let [low, high] = frequencies.fold([f64::INFINITY, 0.0_f64], |[low, high], frequency| {
            [low.min(frequency), high.max(frequency)]
        });
        let slowest = low.min(high / SLOWEST);
        let valid = |i: usize, j: usize| {
            let at = [line(ranges[0], i), line(ranges[1], j)];
            !stop.is_asked() && self.forcing_frequency::<f64>(at[0], at[1]) >= slowest && sampler.passes(at)
        };
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
        (area > 0 && !stop.is_asked()).then(|| [0, 1].map(|k| cells[k].map(|at| line(ranges[k], at))))
    }
}
