//! An oscillator with the parameter across a line of the parameter plane first, then the one that
//! is held.

use grazing_continuation::curve::Window;
use grazing_continuation::mps::{EventTimes, unknown};
use grazing_model::{
    AnyMotion, AnyOscillator, FlowJet, ImpactOscillator, MapJet, OnWall, ParameterJet, State, flow_variable,
};
use nalgebra::SMatrix;

use crate::Scope;
use crate::curves::DiagramCurve;

/// An oscillator with its parameters (μ, η) exchanged.
#[derive(Clone)]
struct Exchanged(AnyOscillator);

/// The oscillator, with its parameters exchanged if required.
pub fn oriented(oscillator: &AnyOscillator, exchanged: bool) -> AnyOscillator {
    if exchanged { AnyOscillator::new(Exchanged(oscillator.clone())) } else { oscillator.clone() }
}

/// Exchanges two variables in second derivatives.
fn exchange<const N: usize>(hessian: &mut SMatrix<f64, N, N>, [a, b]: [usize; 2]) {
    hessian.swap_columns(a, b);
    hessian.swap_rows(a, b);
}

fn exchanged_jet(mut jet: ParameterJet) -> ParameterJet {
    jet.gradient.swap_rows(0, 1);
    exchange(&mut jet.hessian, [0, 1]);
    jet
}

impl ImpactOscillator for Exchanged {
    type Motion = AnyMotion;

    fn parameters(&self) -> [f64; 2] {
        let [mu, eta] = self.0.parameters();
        [eta, mu]
    }

    fn with_parameters(&self, [eta, mu]: [f64; 2]) -> Self {
        Self(self.0.with_parameters([mu, eta]))
    }

    fn roughly(&self) -> Self {
        Self(self.0.roughly())
    }

    fn finely(&self) -> Option<Self> {
        self.0.finely().map(Self)
    }

    fn forcing_frequency(&self) -> ParameterJet {
        exchanged_jet(self.0.forcing_frequency())
    }

    fn other_stop(&self) -> Option<Self> {
        self.0.other_stop().map(Self)
    }

    fn gap(&self, phase: f64) -> [ParameterJet; 2] {
        self.0.gap(phase).map(exchanged_jet)
    }

    fn acceleration(&self, state: State) -> f64 {
        self.0.acceleration(state)
    }

    fn flow_along<const ORDER: usize>(&self, motion: &AnyMotion, from: State, duration: f64) -> FlowJet {
        let mut jet = self.0.flow_along::<ORDER>(motion, from, duration);
        let variables @ [a, b] = [flow_variable::PRIMARY, flow_variable::SECONDARY];
        jet.jacobian.swap_columns(a, b);
        jet.hessians.iter_mut().for_each(|hessian| exchange(hessian, variables));
        jet
    }

    fn reset<const ORDER: usize>(&self, impact: OnWall) -> MapJet<OnWall, OnWall> {
        let mut jet = self.0.reset::<ORDER>(impact);
        let variables @ [a, b] = [unknown::PRIMARY, unknown::SECONDARY];
        jet.jacobian.swap_columns(a, b);
        jet.hessians.iter_mut().for_each(|hessian| exchange(hessian, variables));
        jet
    }

    fn motion(&self, from: State) -> AnyMotion {
        self.0.motion(from)
    }
}

impl Scope {
    /// The scope for the oscillator with exchanged parameters.
    #[must_use]
    pub(super) fn exchanged(&self) -> Self {
        let Window { primary, secondary } = self.window;
        Self { window: Window { primary: secondary, secondary: primary }, ..self.clone() }
    }
}

/// Curves of a diagram with exchanged parameters.
pub(super) fn exchanged(curves: &[DiagramCurve]) -> Vec<DiagramCurve> {
    let mut curves = curves.to_vec();
    for point in curves.iter_mut().flat_map(|curve| &mut curve.curve.points) {
        point.solution.unknowns.swap(unknown::PRIMARY, unknown::SECONDARY);
        // The carried state is unrelated to the roles of the parameters; it starts anew.
        point.times = EventTimes::default();
    }
    curves
}
