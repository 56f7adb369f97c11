//! Limits on the steps along a branch of motion without impacts, and on the branch itself.

use grazing_continuation::curve::{CurvePoint, Window};
use grazing_continuation::mps::{LoopEquations, Multipliers, Unknowns, unknown};
use grazing_model::ImpactOscillator;

use crate::winding::angle_in_a_period;

/// A branch that has passed the wall is abandoned where a multiplier exceeds this (empirical):
/// beyond the wall it matters only if it may return, and next to a force that pulls into a pole
/// motion grows without bounds, so that every solution there is expensive to find.
const LOST_MULTIPLIERS: f64 = 1e4;
/// Height above the wall, whose distance from rest is of order one, at which a branch through the
/// range of η is abandoned: the branch behind a resonance is reached from there.
const HIGH: f64 = 10.0;
/// Largest turn of multipliers in a step, as a fraction of their distance from ±1.
const PART: f64 = 0.3;
/// Smallest step required by this rule, as a fraction of the range of η: without damping a
/// resonance has no width.
const LEAST_WAY: f64 = 1e-4;

/// Whether a branch has risen above the wall, where it is so unstable that no motion stays near it.
pub(crate) fn is_lost(points: &[CurvePoint]) -> bool {
    points[1..].last().is_some_and(|last| {
        !last.solution.admissible() && last.solution.multipliers.size() > LOST_MULTIPLIERS
    })
}

/// The longest step of a branch through the range of η that does not pass over a resonance of
/// motion without impacts, which is as narrow as the damping is small.
///
/// The multipliers λ of small motion about an orbit turn as η changes, and at a resonance pass 1 or
/// −1 at a distance that depends on the damping. A step may therefore turn them by a fraction of
/// their distance from there.
pub(crate) struct StepLimits<'a> {
    equations: &'a LoopEquations,
    /// The width of the range of η.
    width: f64,
    /// The angle by which small motion turns in a unit of time, where the branch begins.
    rate: f64,
}

impl<'a> StepLimits<'a> {
    pub(crate) fn new(equations: &'a LoopEquations, window: Window, start: &Unknowns) -> Self {
        let oscillator = equations.oscillator_at(start);
        let turned = angle_in_a_period(&oscillator, equations.departure(start));
        Self { equations, width: window.widths()[1], rate: turned / oscillator.forcing_period() }
    }

    /// The longest step from the last of some points of a branch; `None` where it is abandoned.
    pub(crate) fn longest(&self, points: &[CurvePoint], tangent: &Unknowns, size: f64) -> Option<f64> {
        let last = points.last()?;
        let high = points.len() > 1 && last.solution.ceiling() > HIGH * size;
        let along = tangent[unknown::SECONDARY].abs() / self.width;
        (!high && !is_lost(points)).then(|| self.way(points) / along)
    }

    /// The longest step as a fraction of the range of η.
    fn way(&self, points: &[CurvePoint]) -> f64 {
        let turned = |back: usize| match points.len().checked_sub(back + 2) {
            Some(before) => {
                let [a, b] = [before, before + 1].map(|k| self.share_and_angle(&points[k]));
                // The angle of rounding means nothing.
                if points[before..].iter().any(|point| point.solution.multipliers.forget(1)) {
                    return 0.0;
                }
                let turned = (b[1] - a[1]).abs() / (b[0] - a[0]).abs();
                if turned.is_finite() { turned } else { 0.0 }
            }
            None => 0.0,
        };
        let solution = &points[points.len() - 1].solution;
        let Multipliers { trace, determinant } = solution.multipliers;
        // 1 − λ| and |1 + λ| of either multiplier of a complex pair.
        let distances = [1.0 - trace + determinant, 1.0 + trace + determinant].map(|c| c.abs().sqrt());
        let oscillator = self.equations.oscillator_at(&solution.unknowns);
        let frequency = oscillator.forcing_frequency();
        let change = frequency.gradient[1].abs() * self.width / frequency.value;
        let expected = self.rate.abs() * oscillator.forcing_period() * change;
        let step = PART * distances[0].min(distances[1]) / expected.max(turned(0)).max(turned(1));
        // Infinite where nothing turns.
        if step.is_nan() { f64::INFINITY } else { step.max(LEAST_WAY) }
    }

    /// The fraction of the range of η, up to a constant, and the angle of λ, between 0 and π.
    fn share_and_angle(&self, point: &CurvePoint) -> [f64; 2] {
        let Multipliers { trace, determinant } = point.solution.multipliers;
        let angle = libm::acos((0.5 * trace / determinant.sqrt()).clamp(-1.0, 1.0));
        [point.solution.unknowns[unknown::SECONDARY] / self.width, angle]
    }
}
