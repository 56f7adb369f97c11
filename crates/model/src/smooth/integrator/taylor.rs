//! Steps of the collocation whose start, time and length move along a curve.

use super::{Factors, MATRIX, NODES, POSITION_WEIGHTS, Pair, SQUARE, STAGES, Step, WEIGHTS};
use crate::smooth::{Integrated, Scalar, SmoothOscillator, Taylor};

/// Parts of a step: with order 12, two take three and a half digits off an error.
const PARTS: u32 = 2;

impl<M: SmoothOscillator> Integrated<M> {
    /// The end of a step that plain numbers have chosen, from a start that moves; `None` if a part of it cannot be solved.
    ///
    /// The step is taken in parts. Its length suits the solution and its first derivatives; the second and the third bend within
    /// what the force does, and where that is short each has errors thirty times as large as the order before.
    pub(in crate::smooth) fn series_after(
        &self,
        from: Pair<Taylor>,
        time: f64,
        step: &Step,
    ) -> Option<Pair<Taylor>> {
        let length = step.length / f64::from(PARTS);
        let mut state = from;
        for part in 0..PARTS {
            let passed = f64::from(part) / f64::from(PARTS);
            let time = time + passed * step.length;
            let plain = state.map(|component| component.value());
            let guess = Step { length, accelerations: step.guess(passed, length), slope_roughness: 0.0 };
            let solved = self.solve_step(plain, time, guess)?;
            let (_, factors, _) = self.linearised(plain, time, &solved);
            let [time, length] = [time, length].map(Taylor::constant);
            state = self.series_step(state, [time, length], solved.accelerations, &factors);
        }
        Some(state)
    }

    /// The solution that passes `from` at `time`, a while later that vanishes at s = 0.
    ///
    /// The step has no length but along the curve, where the collocation is exact far beyond third order.
    pub(in crate::smooth) fn series_shifted(
        &self,
        from: Pair<Taylor>,
        time: Taylor,
        by: Taylor,
    ) -> Pair<Taylor> {
        let [x, y] = from.map(|component| component.value());
        let accelerations = [self.force(x, y, time.value()); STAGES];
        // Newton's matrix of a step without length is the identity.
        let factors = Factors::new(&[[0.0; STAGES]; 2]);
        self.series_step(from, [time, by], accelerations, &factors)
    }

    /// The end of a step whose accelerations at s = 0 are known: each iteration of Newton's method with the matrix at s = 0
    /// adds one order.
    #[expect(clippy::needless_range_loop, reason = "indices as in the formulas")]
    fn series_step(
        &self,
        [x0, y0]: Pair<Taylor>,
        [time, length]: [Taylor; 2],
        plain: [f64; STAGES],
        factors: &Factors,
    ) -> Pair<Taylor> {
        let [mu, eta] = self.parameters.map(Taylor::constant);
        let mut accelerations = plain.map(Taylor::constant);
        let sum = |weights: &[f64; STAGES], values: &[Taylor; STAGES]| {
            let mut sum = [0.0; Taylor::ORDER + 1];
            for (weight, value) in weights.iter().zip(values) {
                for (sum, coefficient) in sum.iter_mut().zip(value.coefficients()) {
                    *sum += weight * coefficient;
                }
            }
            Taylor::new(sum)
        };
        for _ in 0..Taylor::ORDER {
            let residuals: [Taylor; STAGES] = core::array::from_fn(|i| {
                let x = x0 + length * (y0.scale(NODES[i]) + length * sum(&SQUARE[i], &accelerations));
                let y = y0 + length * sum(&MATRIX[i], &accelerations);
                self.model.force(x, y, time + length.scale(NODES[i]), mu, eta) - accelerations[i]
            });
            let mut corrections = [[0.0; Taylor::ORDER + 1]; STAGES];
            for k in 0..=Taylor::ORDER {
                let mut order = residuals.map(|residual| residual.coefficients()[k]);
                factors.solve(&mut order);
                for i in 0..STAGES {
                    corrections[i][k] = order[i];
                }
            }
            for i in 0..STAGES {
                accelerations[i] = accelerations[i] + Taylor::new(corrections[i]);
            }
        }
        [
            x0 + length * (y0 + length * sum(&POSITION_WEIGHTS, &accelerations)),
            y0 + length * sum(&WEIGHTS, &accelerations),
        ]
    }
}
