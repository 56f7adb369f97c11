//! Periodic solutions with several impacts on which simulated motion has settled, and the branches through
//! them at one value of η.

use std::collections::BTreeMap;

use grazing_continuation::arclength::StepControl;
use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::{Curve, Event, Window};
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns};
use grazing_model::{AnyOscillator, ImpactOscillator, OnWall};

use crate::long_time::LongOrbit;
use crate::slices::{Slice, Slicer};

/// A number of forcing periods and, at one of its points or near it, a solution with impacts that recurs
/// after as many.
pub(crate) type Recurring = (u32, Unknowns);

/// The equations of solutions that recur after so many forcing periods.
pub(crate) fn equations(oscillator: &AnyOscillator, periods: u32) -> LoopEquations {
    LoopEquations::new(oscillator.clone(), periods, Formulation::FixedPhase)
}

/// The impacts of the cycle on which an orbit has settled; `None` without impacts, and with rests at the
/// wall, where the multipliers are 0 and the equations have no solution.
pub(crate) fn near(oscillator: &AnyOscillator, orbit: &LongOrbit) -> Option<Recurring> {
    let cycle = orbit.cycle.filter(|cycle| cycle.impacts > 0 && cycle.rests == 0)?;
    let frequency = oscillator.forcing_frequency().value;
    let (flights, struck) = (orbit.flights.get(..cycle.impacts)?, orbit.impacts.get(..cycle.impacts)?);
    let (first, begin) = (struck.first()?, flights.first()?);
    let end = |index: usize| flights[index].start + flights[index].duration;
    // Phases are not reduced.
    let phase = |index: usize| first[1] + frequency * (end(index) - (begin.start + begin.duration));
    let impacts: Vec<OnWall> =
        struck.iter().enumerate().map(|(index, impact)| OnWall::new(impact[0], phase(index))).collect();
    Some((cycle.periods, Unknowns::of_impacts(&impacts, oscillator.parameters())))
}

/// The solution beside a point at the oscillator's own parameters.
pub(crate) fn solution(equations: &LoopEquations, near: &Unknowns, here: [f64; 2]) -> Option<Unknowns> {
    let [primary, secondary] = here;
    let held = [Condition::Primary(primary), Condition::Secondary(secondary)];
    locate(equations, held, near.clone(), &mut EventTimes::default()).ok()
}

/// The search for the branches at one value of η.
pub(crate) struct Through<'a> {
    pub(crate) oscillator: &'a AnyOscillator,
    pub(crate) window: Window,
    pub(crate) secondary: f64,
    /// The most impacts of a solution.
    pub(crate) most: usize,
}

impl Through<'_> {
    /// The branches of solutions with several impacts through some solutions, and those with twice the impacts
    /// and twice the time that begin at admissible period doublings of these and of known branches.
    pub(crate) fn branches(
        &self,
        solutions: &[Recurring],
        known: &[(LoopEquations, Curve)],
    ) -> Vec<(LoopEquations, Curve)> {
        let mut slices: BTreeMap<(usize, u32), Slice> = BTreeMap::new();
        let empty = || Slice::new(self.secondary, Vec::new());
        for (periods, at) in solutions.iter().filter(|(_, at)| (2..=self.most).contains(&at.impacts())) {
            let slice = slices.entry((at.impacts(), *periods)).or_insert_with(empty);
            self.slicer(*periods).through(slice, core::iter::once(at.clone()));
        }
        for impacts in 1..=self.most / 2 {
            let mut doublings: Vec<(u32, Unknowns)> = Vec::new();
            let own = slices.range((impacts, 0)..(impacts + 1, 0));
            let own =
                own.flat_map(|((_, periods), slice)| slice.branches.iter().map(|curve| (*periods, curve)));
            let known = known.iter().filter(|(_, curve)| {
                curve.points.first().is_some_and(|first| first.solution.impacts() == impacts)
            });
            let known = known.map(|(equations, curve)| (equations.loops(), curve));
            for (periods, curve) in own.chain(known) {
                let doubling = |event: &&Event| {
                    Bifurcation::of(event.condition, periods) == Some(Bifurcation::PeriodDoubling)
                        && event.solution.admissible()
                };
                let found = curve.events.iter().filter(doubling);
                doublings.extend(found.map(|event| (periods, event.solution.unknowns.clone())));
            }
            for (periods, at) in doublings {
                let halved = equations(self.oscillator, periods);
                let slice = slices.entry((2 * impacts, 2 * periods)).or_insert_with(empty);
                self.slicer(2 * periods).beginning_beside(slice, &halved, at);
            }
        }
        let distinct = |((_, periods), slice): ((usize, u32), Slice)| {
            let slicer = self.slicer(periods);
            let branches = slicer.distinct(slice).into_iter();
            branches.map(|curve| (slicer.equations.clone(), curve)).collect::<Vec<_>>()
        };
        slices.into_iter().flat_map(distinct).collect()
    }

    fn slicer(&self, periods: u32) -> Slicer {
        Slicer::new(equations(self.oscillator, periods), self.window, StepControl::DRAWING)
    }
}
