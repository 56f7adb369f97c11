//! Third derivatives of the flow and of the reset law, along curves.

use crate::oscillator::ImpactOscillator;
use crate::scalar::Scalar;
use crate::taylor::Taylor;

/// An impact oscillator that can be followed along a curve of arguments to third order.
///
/// The criticality of bifurcations needs third derivatives, but only in one direction at a time:
/// with arguments that move along a curve, [`Taylor`] polynomials in its parameter s, the images do
/// as well. Curves, theorems and simulation need [`ImpactOscillator`] alone, for which second
/// derivatives in all directions are enough.
pub trait ThirdOrder: ImpactOscillator {
    /// The flow of eq:f, the wall ignored: position and velocity after a time `duration` of either
    /// sign from the state (x₀, y₀, z₀), the parameters (μ, η) held; NaN if the solution does not
    /// exist for so long.
    fn flow_series(&self, from: [Taylor; 3], duration: Taylor) -> [Taylor; 2];

    /// The reset law R of eq:R as a function of (y, z), extended smoothly to y < 0, the parameters
    /// (μ, η) held.
    fn reset_series(&self, velocity: Taylor, phase: Taylor) -> [Taylor; 2];

    /// The flow from (y, z) on Σ to the plane of constant phase `target`, with coordinates (x, y).
    ///
    /// Counterpart of [`maps::to_phase`](crate::maps::to_phase) along curves.
    fn to_phase_series(&self, [velocity, phase]: [Taylor; 2], target: f64) -> [Taylor; 2] {
        let duration = (Taylor::constant(target) - phase).scale(1.0 / self.forcing_frequency().value);
        self.flow_series([Taylor::constant(0.0), velocity, phase], duration)
    }
}
