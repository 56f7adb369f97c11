//! Motion without impacts that recurs after several periods of the forcing.
//!
//! A forcing with one period also has every multiple of it as a period: motion over k periods is
//! motion over one period of an oscillator whose forcing is taken to recur k times less often. The
//! same code therefore serves both, with ω/k for ω and z/k for z.

use grazing_model::{
    AnyMotion, AnyOscillator, FlowJet, ImpactOscillator, MapJet, OnWall, ParameterJet, State, flow_variable,
};

/// The oscillator with k forcing periods counted as one.
pub(crate) fn over_periods(oscillator: &AnyOscillator, periods: u32) -> AnyOscillator {
    AnyOscillator::new(OverPeriods { oscillator: oscillator.clone(), periods: f64::from(periods) })
}

#[derive(Clone)]
struct OverPeriods {
    oscillator: AnyOscillator,
    periods: f64,
}

impl OverPeriods {
    fn with(&self, oscillator: AnyOscillator) -> Self {
        Self { oscillator, ..*self }
    }

    /// The state with the phase of the original oscillator.
    fn counted(&self, state: State) -> State {
        State { phase: self.periods * state.phase, ..state }
    }
}

impl ImpactOscillator for OverPeriods {
    type Motion = AnyMotion;

    fn parameters(&self) -> [f64; 2] {
        self.oscillator.parameters()
    }

    fn with_parameters(&self, parameters: [f64; 2]) -> Self {
        self.with(self.oscillator.with_parameters(parameters))
    }

    fn roughly(&self) -> Self {
        self.with(self.oscillator.roughly())
    }

    fn finely(&self) -> Option<Self> {
        Some(self.with(self.oscillator.finely()?))
    }

    fn forcing_frequency(&self) -> ParameterJet {
        let ParameterJet { value, gradient, hessian } = self.oscillator.forcing_frequency();
        let slower = 1.0 / self.periods;
        ParameterJet { value: value * slower, gradient: gradient * slower, hessian: hessian * slower }
    }

    fn acceleration(&self, state: State) -> f64 {
        self.oscillator.acceleration(self.counted(state))
    }

    fn flow_along<const ORDER: usize>(&self, motion: &AnyMotion, from: State, duration: f64) -> FlowJet {
        let mut jet = self.oscillator.flow_along::<ORDER>(motion, self.counted(from), duration);
        jet.jacobian.column_mut(flow_variable::PHASE).scale_mut(self.periods);
        for hessian in &mut jet.hessians {
            hessian.column_mut(flow_variable::PHASE).scale_mut(self.periods);
            hessian.row_mut(flow_variable::PHASE).scale_mut(self.periods);
        }
        jet
    }

    fn reset<const ORDER: usize>(&self, impact: OnWall) -> MapJet<OnWall, OnWall> {
        const PHASE: usize = 1;
        let OnWall { velocity, phase } = impact;
        let mut jet = self.oscillator.reset::<ORDER>(OnWall::new(velocity, self.periods * phase));
        jet.value[PHASE] /= self.periods;
        jet.jacobian.row_mut(PHASE).unscale_mut(self.periods);
        jet.hessians[PHASE].unscale_mut(self.periods);
        jet.jacobian.column_mut(PHASE).scale_mut(self.periods);
        for hessian in &mut jet.hessians {
            hessian.column_mut(PHASE).scale_mut(self.periods);
            hessian.row_mut(PHASE).scale_mut(self.periods);
        }
        jet
    }

    fn other_stop(&self) -> Option<Self> {
        self.oscillator.other_stop().map(|other| self.with(other))
    }

    fn gap(&self, phase: f64) -> [ParameterJet; 2] {
        self.oscillator.gap(self.periods * phase)
    }

    fn motion(&self, from: State) -> AnyMotion {
        self.oscillator.motion(self.counted(from))
    }
}

#[cfg(test)]
mod tests {
    use grazing_model::AtRest;
    use grazing_model::maps::{global_iterate, global_map};

    use super::*;

    #[test]
    fn the_global_map_over_three_periods_is_the_third_iterate_of_that_over_one() {
        let force = "-0.2*v - x - 0.3*x^3 - 1";
        let oscillator = crate::specimens::unforced(force).oscillator([0.8, 0.7]);
        let near = oscillator.with_parameters([0.8, 0.7]);
        let orbit = grazing_theorems::from_map::GrazingOrbit::find(&near, 0.3).expect("it grazes");
        let (oscillator, phase) = (orbit.oscillator(), orbit.phase());
        let once = global_iterate::<_, 2>(oscillator, 3, AtRest::new(0.0, phase)).expect("it comes back");
        let slow = over_periods(oscillator, 3);
        let thrice = global_map::<_, 2>(&slow, AtRest::new(0.0, phase / 3.0), None).expect("it comes back");
        // (x, z/3) for (x, z), among four variables the second of which is the phase.
        let unit = |index: usize| if index == 1 { 3.0 } else { 1.0 };
        for component in 0..2 {
            for j in 0..4 {
                let expected = once.jacobian[(component, j)] * unit(j) / unit(component);
                let seen = thrice.jet.jacobian[(component, j)];
                assert!((seen - expected).abs() <= 1e-9 * (1.0 + expected.abs()), "{seen} {expected}");
                for k in 0..4 {
                    let expected = once.hessians[component][(j, k)] * unit(j) * unit(k) / unit(component);
                    let seen = thrice.jet.hessians[component][(j, k)];
                    assert!((seen - expected).abs() <= 1e-8 * (1.0 + expected.abs()), "{seen} {expected}");
                }
            }
        }
    }
}
