//! The general class of impact oscillators, section 2.1 of the paper.

use crate::jet::{FlowJet, MapJet, ParameterJet};
use crate::motion::Motion;
use crate::state::{OnWall, State};

/// A one-degree-of-freedom oscillator ẍ = F(x, ẋ, t; μ, η) with a wall at x = 0 and a smooth reset
/// law.
///
/// Paper: eq:F, eq:f, eq:R, eq:resetLaw. An implementor provides the flow, with the wall ignored,
/// and the reset law, both with derivatives in all arguments and in the two parameters; everything
/// else (P_virt, P_global, P_disc, orbits with impacts, continuation) is written once against this
/// trait.
pub trait ImpactOscillator: Clone + Send + Sync {
    /// Motion between impacts as a function of time; the search for events works on it.
    type Motion: Motion;

    /// The primary parameter μ and the secondary parameter η.
    fn parameters(&self) -> [f64; 2];

    /// The oscillator at other parameters (μ, η).
    fn with_parameters(&self, parameters: [f64; 2]) -> Self;

    /// The oscillator with motion computed to some seven digits, and bounds that are estimates,
    /// where that takes less time: for exploration whose results are solved for accurately
    /// afterwards.
    fn roughly(&self) -> Self {
        self.clone()
    }

    /// The oscillator with motion integrated in shorter steps, or `None` where motion is not
    /// integrated: the change in a result is its error of integration.
    fn finely(&self) -> Option<Self> {
        None
    }

    /// The angular frequency ω(μ, η) of the forcing with its derivatives.
    fn forcing_frequency(&self) -> ParameterJet;

    /// The vector field F at a state: the acceleration ẍ.
    fn acceleration(&self, state: State) -> f64;

    /// The flow of eq:f for a time `duration` of either sign, the wall ignored, with derivatives up
    /// to `ORDER` (1 or 2).
    fn flow<const ORDER: usize>(&self, from: State, duration: f64) -> FlowJet {
        self.flow_along::<ORDER>(&self.motion(from), from, duration)
    }

    /// The flow from a state whose motion is available, so that its steps need not be computed
    /// again.
    fn flow_along<const ORDER: usize>(&self, motion: &Self::Motion, from: State, duration: f64) -> FlowJet;

    /// The reset law R of eq:R as a function of (y, z; μ, η), extended smoothly to y < 0;
    /// derivatives up to `ORDER`.
    fn reset<const ORDER: usize>(&self, impact: OnWall) -> MapJet<OnWall, OnWall>;

    /// The oscillator seen from its other stop, if it has two: that one stands at x = 0 then, and
    /// motion takes place in x ≤ 0 as before. The other stop of what is returned is this one.
    fn other_stop(&self) -> Option<Self> {
        None
    }

    /// The distance D > 0 between the stops and its rate Ḋ at a phase of the forcing, with their
    /// derivatives in μ and η at this phase; infinite and zero for one stop.
    fn gap(&self, _phase: f64) -> [ParameterJet; 2] {
        [f64::INFINITY, 0.0].map(ParameterJet::constant)
    }

    /// The state as it is seen from the other stop: x and y are −D − x and −Ḋ − y there.
    fn across(&self, state: State) -> State {
        let [gap, rate] = self.gap(state.phase);
        State { position: -gap.value - state.position, velocity: -rate.value - state.velocity, ..state }
    }

    /// The motion that starts in a state, the wall ignored.
    fn motion(&self, from: State) -> Self::Motion;

    /// The forcing period 2π/ω.
    fn forcing_period(&self) -> f64 {
        core::f64::consts::TAU / self.forcing_frequency().value
    }
}
