//! An oscillator as a line of the parameter plane sees it: the parameter across first, then the one that is held.

use grazing_continuation::curve::Window;
use grazing_continuation::mps::{EventTimes, unknown};
use grazing_model::{FlowJet, ImpactOscillator, MapJet, OnWall, ParameterJet, State, flow_variable};
use nalgebra::SMatrix;

use crate::Scope;
use crate::curves::DiagramCurve;

/// An oscillator with its parameters (μ, η) as they are, or in each other's role.
#[derive(Clone, Debug)]
pub struct OrientedOscillator<O> {
    /// The oscillator.
    pub oscillator: O,
    /// They are exchanged.
    pub exchanged: bool,
}

impl<O> OrientedOscillator<O> {
    fn of(&self, oscillator: O) -> Self {
        Self { oscillator, exchanged: self.exchanged }
    }

    fn in_roles(&self, [first, second]: [f64; 2]) -> [f64; 2] {
        if self.exchanged { [second, first] } else { [first, second] }
    }
}

/// Exchanges two variables in second derivatives.
fn exchange<const N: usize>(hessian: &mut SMatrix<f64, N, N>, [a, b]: [usize; 2]) {
    hessian.swap_columns(a, b);
    hessian.swap_rows(a, b);
}

impl<O: ImpactOscillator> ImpactOscillator for OrientedOscillator<O> {
    type Motion = O::Motion;

    fn parameters(&self) -> [f64; 2] {
        self.in_roles(self.oscillator.parameters())
    }

    fn with_parameters(&self, parameters: [f64; 2]) -> Self {
        self.of(self.oscillator.with_parameters(self.in_roles(parameters)))
    }

    fn roughly(&self) -> Self {
        self.of(self.oscillator.roughly())
    }

    fn finely(&self) -> Option<Self> {
        self.oscillator.finely().map(|finer| self.of(finer))
    }

    fn forcing_frequency(&self) -> ParameterJet {
        let mut jet = self.oscillator.forcing_frequency();
        if self.exchanged {
            jet.gradient.swap_rows(0, 1);
            exchange(&mut jet.hessian, [0, 1]);
        }
        jet
    }

    fn acceleration(&self, state: State) -> f64 {
        self.oscillator.acceleration(state)
    }

    fn flow_along<const ORDER: usize>(&self, motion: &O::Motion, from: State, duration: f64) -> FlowJet {
        let mut jet = self.oscillator.flow_along::<ORDER>(motion, from, duration);
        if self.exchanged {
            let variables @ [a, b] = [flow_variable::PRIMARY, flow_variable::SECONDARY];
            jet.jacobian.swap_columns(a, b);
            jet.hessians.iter_mut().for_each(|hessian| exchange(hessian, variables));
        }
        jet
    }

    fn reset<const ORDER: usize>(&self, impact: OnWall) -> MapJet<OnWall, OnWall> {
        let mut jet = self.oscillator.reset::<ORDER>(impact);
        if self.exchanged {
            let variables @ [a, b] = [unknown::PRIMARY, unknown::SECONDARY];
            jet.jacobian.swap_columns(a, b);
            jet.hessians.iter_mut().for_each(|hessian| exchange(hessian, variables));
        }
        jet
    }

    fn motion(&self, from: State) -> O::Motion {
        self.oscillator.motion(from)
    }
}

impl Scope {
    /// The same for the oscillator whose parameters are exchanged.
    #[must_use]
    pub(super) fn exchanged(&self) -> Self {
        let Window { primary, secondary } = self.window;
        Self { window: Window { primary: secondary, secondary: primary }, ..self.clone() }
    }
}

/// Curves of a diagram with the parameters in each other's role.
pub(super) fn exchanged(curves: &[DiagramCurve]) -> Vec<DiagramCurve> {
    let mut curves = curves.to_vec();
    for point in curves.iter_mut().flat_map(|curve| &mut curve.curve.points) {
        point.solution.unknowns.swap_rows(unknown::PRIMARY, unknown::SECONDARY);
        // What the equations carry says nothing of parameters.
        point.times = EventTimes::default();
    }
    curves
}
