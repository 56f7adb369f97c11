//! Steps of the collocation whose start, time and length move along a curve.

use super::{PositionVelocity, Step};
use crate::scalar::Scalar;
use crate::smooth::factors::Factors;
use crate::smooth::oscillator::{Integrated, SmoothOscillator};
use crate::smooth::stages::{Lanes, Matrix, STAGES, Stages};
use crate::smooth::tableau::{MATRIX, NODES, POSITION_WEIGHTS, SQUARE, WEIGHTS};
use crate::taylor::Taylor;

/// Number of parts of a step: with order 12, three take five and a half digits off an error.
const PARTS: u32 = 3;

/// Taylor polynomials at the stages, order by order.
type Orders = [Stages; Taylor::ORDER + 1];

impl<M: SmoothOscillator> Integrated<M> {
    /// The end of a step that plain numbers have chosen, from a start and a time that move; `None`
    /// if a part of it cannot be solved.
    ///
    /// The step is taken in parts. Its length suits the solution and its first derivatives; the
    /// second and the third bend within what the force does, and where that is short each has
    /// errors thirty times as large as the order before.
    pub(in crate::smooth) fn series_after(
        &self,
        from: PositionVelocity<Taylor>,
        time: Taylor,
        step: &Step,
    ) -> Option<PositionVelocity<Taylor>> {
        let share = 1.0 / f64::from(PARTS);
        let mut state = from;
        for part in 0..PARTS {
            let begin = f64::from(part) * share;
            let plain = state.map(|component| component.value());
            let solved = self.part(plain, time.value(), step, [begin, share])?;
            let time = time + Taylor::constant(begin * step.length);
            let factors = Factors::new(&self.slopes(plain, time.value(), &solved));
            let length = Taylor::constant(solved.length);
            state = self.series_step(state, [time, length], solved.accelerations, &factors);
        }
        Some(state)
    }

    /// The solution that passes `from` at `time`, continued for a time that vanishes at s = 0.
    ///
    /// The step has length only along the curve, where the collocation is exact far beyond third
    /// order.
    pub(in crate::smooth) fn series_shifted(
        &self,
        from: PositionVelocity<Taylor>,
        time: Taylor,
        by: Taylor,
    ) -> PositionVelocity<Taylor> {
        let [x, y] = from.map(|component| component.value());
        let accelerations = Stages::constant(self.force(x, y, time.value()));
        // Newton's matrix of a step of length zero is the identity.
        let factors = Factors::new(&[Stages::constant(0.0); 2]);
        self.series_step(from, [time, by], accelerations, &factors)
    }

    /// The end of a step whose accelerations at s = 0 are known: each iteration of Newton's method
    /// with the matrix at s = 0 adds one order.
    fn series_step(
        &self,
        [x0, y0]: PositionVelocity<Taylor>,
        [time, length]: [Taylor; 2],
        plain: Stages,
        factors: &Factors,
    ) -> PositionVelocity<Taylor> {
        let [mu, eta] = self.parameters.map(Taylor::constant);
        let mut accelerations: Orders = [Stages::constant(0.0); Taylor::ORDER + 1];
        accelerations[0] = plain;
        for _ in 0..Taylor::ORDER {
            let [positions, velocities] = [&SQUARE, &MATRIX].map(|matrix| at_stages(&accelerations, matrix));
            let mut residuals = accelerations.map(|order| -order);
            for i in 0..STAGES {
                let x = x0 + length * (y0.scale(NODES[i]) + length * positions[i]);
                let y = y0 + length * velocities[i];
                let force = self.model.force(x, y, time + length.scale(NODES[i]), mu, eta);
                for (order, coefficient) in residuals.iter_mut().zip(force.coefficients()) {
                    order.0[i] += coefficient;
                }
            }
            for (order, residual) in accelerations.iter_mut().zip(residuals) {
                *order = *order + factors.solve(residual);
            }
        }
        let weighted = |weights: &[f64; STAGES]| {
            Taylor::new(accelerations.map(|order: Lanes<STAGES>| order.weighted(weights)))
        };
        [x0 + length * (y0 + length * weighted(&POSITION_WEIGHTS)), y0 + length * weighted(&WEIGHTS)]
    }
}

/// The product of a matrix and the Taylor polynomials at the stages.
fn at_stages(orders: &Orders, matrix: &Matrix) -> [Taylor; STAGES] {
    let sums = orders.map(|order| order.through(matrix));
    core::array::from_fn(|i| Taylor::new(sums.map(|order| order.0[i])))
}
