//! The linear system of Newton's method for the stages of a step.

use super::stages::{Lanes, STAGES, Stages};
use super::tableau::{MATRIX, SQUARE};
use crate::scalar::Scalar;

/// The factors of the matrix I − h² A² F_x − h A F_y of Newton's method by columns, without pivots:
/// it is close to the identity where the step is not too long, and where it is not the iteration
/// fails and the step is shortened.
pub(super) struct Factors([Stages; STAGES]);

#[expect(clippy::needless_range_loop, reason = "indices as in the formulas")]
impl Factors {
    /// From h² F_x and h F_y at the stages.
    #[inline]
    pub(super) fn new([by_position, by_velocity]: &[Stages; 2]) -> Self {
        let mut factors = Self([Stages::constant(0.0); STAGES]);
        let m = &mut factors.0;
        for j in 0..STAGES {
            m[j] = -(*by_position * SQUARE.0[j] + *by_velocity * MATRIX.0[j]);
            m[j].0[j] += 1.0;
        }
        for k in 0..STAGES {
            let inverse = 1.0 / m[k].0[k];
            m[k].0[k] = inverse;
            for i in k + 1..STAGES {
                m[k].0[i] *= inverse;
            }
            for j in k + 1..STAGES {
                for i in k + 1..STAGES {
                    m[j].0[i] -= m[k].0[i] * m[j].0[k];
                }
            }
        }
        factors
    }

    #[inline]
    pub(super) fn solve(&self, Lanes(mut b): Stages) -> Stages {
        for k in 0..STAGES {
            for i in k + 1..STAGES {
                b[i] -= self.0[k].0[i] * b[k];
            }
        }
        for k in (0..STAGES).rev() {
            b[k] *= self.0[k].0[k];
            for i in 0..k {
                b[i] -= self.0[k].0[i] * b[k];
            }
        }
        Lanes(b)
    }
}
