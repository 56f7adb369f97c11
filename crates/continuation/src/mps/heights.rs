//! How high the motion of a solution reaches, with first derivatives in the unknowns: at a maximum, beneath
//! either of two stops, and at a phase.

use grazing_model::maps::{self, MapError};
use grazing_model::motion::Motion;
use grazing_model::{AtPhase, ImpactOscillator, OnWall, State};

use super::{LoopEquations, PeriodicSolution, Unknowns, at_phase_zero, unknown};

impl<O: ImpactOscillator> LoopEquations<O> {
    /// The value of x at the maximum near a time after the first recoil, with its first derivatives in
    /// the unknowns; the time becomes that of the maximum.
    ///
    /// # Errors
    /// The maximum has disappeared.
    pub fn maximum_near(&self, point: &Unknowns, time: &mut f64) -> Result<(f64, Unknowns), MapError> {
        if let Some(beside) = self.maximum_at_other_stop(point, time) {
            return beside;
        }
        let mut gradient = point.filled(0.0);
        if self.has_impacts() {
            let (flight, start) = self.flight_at(point, *time);
            let views = self.views(point);
            let oscillator = views.at(flight);
            let reset = oscillator.reset::<1>(point.impact(flight));
            let landing = maps::virtual_map::<O, 1>(oscillator, reset.image(), Some(*time - start))?;
            *time = landing.time + start;
            let jet = landing.jet.after::<1, _>(&reset).plain();
            for (variable, index) in unknown::of_impact(flight).into_iter().enumerate() {
                gradient[index] = jet.jacobian[(0, variable)];
            }
            return Ok((jet.value[0], gradient));
        }
        let oscillator = self.oscillator_at(point);
        let landing = maps::maximum_from_phase_zero::<O, 1>(&oscillator, at_phase_zero(point), *time)?;
        *time = landing.time;
        let jet = landing.jet.plain();
        (0..4).for_each(|index| gradient[index] = jet.jacobian[(0, index)]);
        Ok((jet.value[0], gradient))
    }

    /// Whether the highest maximum of a solution is one of −D − x, at the other stop than that from which its
    /// flight begins.
    pub fn is_nearest_to_other_stop(&self, solution: &PeriodicSolution) -> bool {
        let Some(top) = solution.highest_interior_maximum.filter(|_| self.has_two_stops()) else {
            return false;
        };
        self.maximum_at_other_stop(&solution.unknowns, &mut top.time.clone()).is_some()
    }

    /// The same for a maximum of −D − x, which touches the other stop than that from which the flight begins;
    /// `None` if the motion is nearer to its own there, or there is only one.
    ///
    /// At the maximum the derivative in time vanishes, so that the phase may be held in the others.
    fn maximum_at_other_stop(
        &self,
        point: &Unknowns,
        time: &mut f64,
    ) -> Option<Result<(f64, Unknowns), MapError>> {
        self.has_two_stops().then_some(())?;
        let (flight, start) = if self.has_impacts() { self.flight_at(point, *time) } else { (0, 0.0) };
        let views = self.views(point);
        let (oscillator, from) = (views.at(flight), self.beginning(&views, point, flight));
        let other = oscillator.other_stop()?;
        let frequency = oscillator.forcing_frequency().value;
        let motion = oscillator.motion(from);
        let there = motion.at(*time - start).state(from.phase + frequency * (*time - start));
        if oscillator.across(there).position <= there.position {
            return None;
        }
        let top = match maps::maximum_near(&other, oscillator.across(from), *time - start) {
            Ok(top) => top,
            Err(error) => return Some(Err(error)),
        };
        *time = top + start;
        let phase = from.phase + frequency * top;
        let mut gradient = point.filled(0.0);
        if self.has_impacts() {
            let reset = oscillator.reset::<1>(point.impact(flight));
            let there = maps::to_phase::<O, 1, OnWall>(oscillator, &motion, from, phase);
            let jet = maps::across(oscillator, &there, phase).after::<1, _>(&reset).plain();
            for (variable, index) in unknown::of_impact(flight).into_iter().enumerate() {
                gradient[index] = jet.jacobian[(0, variable)];
            }
            return Some(Ok((jet.value[0], gradient)));
        }
        let there = maps::to_phase::<O, 1, AtPhase>(oscillator, &motion, from, phase);
        let jet = maps::across(oscillator, &there, phase).plain();
        (0..4).for_each(|index| gradient[index] = jet.jacobian[(0, index)]);
        Some(Ok((jet.value[0], gradient)))
    }

    /// The position x of the flight when the forcing is at a phase, counted from that of the
    /// recoil, with its first derivatives in the unknowns.
    pub fn position_at(&self, point: &Unknowns, phase: f64) -> (f64, Unknowns) {
        let oscillator = self.oscillator_at(point);
        let reset = oscillator.reset::<1>(point.impact(0));
        let recoil: State = reset.image().into();
        let motion = oscillator.motion(recoil);
        let there = maps::to_phase::<O, 1, OnWall>(&oscillator, &motion, recoil, phase);
        let jet = there.after::<1, _>(&reset).plain();
        let mut gradient = point.filled(0.0);
        (0..4).for_each(|index| gradient[index] = jet.jacobian[(0, index)]);
        (jet.value[0], gradient)
    }
}
