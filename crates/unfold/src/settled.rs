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

/// The number of forcing periods after which a solution recurs, and the stops that its impacts hit, in their
/// order, over and over; none if all are at x = 0.
pub type ImpactPattern = (u32, Vec<usize>);

/// A kind of solutions and, at one of its points or near it, one of them.
pub(crate) type Recurring = (ImpactPattern, Unknowns);

/// The equations of solutions of a kind.
pub(crate) fn equations(oscillator: &AnyOscillator, (periods, stops): &ImpactPattern) -> LoopEquations {
    let equations = LoopEquations::new(oscillator.clone(), *periods, Formulation::FixedPhase);
    if stops.is_empty() { equations } else { equations.at_stops(stops.iter().copied()) }
}

/// The kind of the solutions of equations.
pub(crate) fn kind(equations: &LoopEquations) -> ImpactPattern {
    (equations.loops(), equations.stops().to_vec())
}

/// The impacts of the cycle on which an orbit has settled; `None` without impacts, and with rests at the
/// wall, where the multipliers are 0 and the equations have no solution.
pub(crate) fn near(oscillator: &AnyOscillator, orbit: &LongOrbit) -> Option<Recurring> {
    let cycle = orbit.cycle.filter(|cycle| cycle.impacts > 0 && cycle.rests == 0)?;
    let frequency = oscillator.forcing_frequency().value;
    let (flights, struck) = (orbit.flights.get(..cycle.impacts)?, orbit.impacts.get(..cycle.impacts)?);
    let (first, begin) = (struck.first()?.impact, flights.first()?);
    let end = |index: usize| flights[index].start + flights[index].duration;
    // Phases are not reduced.
    let phase = |index: usize| first[1] + frequency * (end(index) - (begin.start + begin.duration));
    let impacts: Vec<OnWall> =
        struck.iter().enumerate().map(|(index, hit)| OnWall::new(hit.impact[0], phase(index))).collect();
    let all = Unknowns::of_impacts(&impacts, oscillator.parameters());
    let stops: Vec<usize> = struck.iter().map(|hit| hit.stop).collect();
    if stops.iter().all(|stop| *stop == stops[0]) {
        let stops = if stops[0] == 0 { Vec::new() } else { vec![stops[0]] };
        return Some(((cycle.periods, stops), all));
    }
    // Of the ways to number the impacts, that whose stops come first in the order of words.
    let numbered = |first: usize| [&stops[first..], &stops[..first]].concat();
    let first = (0..stops.len()).min_by_key(|first| numbered(*first)).unwrap_or(0);
    let mut over_and_over = numbered(first);
    let recurs = |count: &usize| {
        over_and_over.len().is_multiple_of(*count)
            && over_and_over.iter().zip(&over_and_over[*count..]).all(|(stop, later)| stop == later)
    };
    let count = (1..over_and_over.len()).find(recurs).unwrap_or(over_and_over.len());
    over_and_over.truncate(count);
    Some(((cycle.periods, over_and_over), all.beginning_with(first, cycle.periods)))
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
        let mut slices: BTreeMap<(usize, ImpactPattern), Slice> = BTreeMap::new();
        let empty = || Slice::new(self.secondary, Vec::new());
        for (kind, at) in solutions.iter().filter(|(_, at)| (2..=self.most).contains(&at.impacts())) {
            let slice = slices.entry((at.impacts(), kind.clone())).or_insert_with(empty);
            self.slicer(kind).through(slice, core::iter::once(at.clone()));
        }
        for impacts in 1..=self.most / 2 {
            let mut doublings: Vec<Recurring> = Vec::new();
            let none: ImpactPattern = (0, Vec::new());
            let own = slices.range((impacts, none.clone())..(impacts + 1, none));
            let own =
                own.flat_map(|((_, kind), slice)| slice.branches.iter().map(|curve| (kind.clone(), curve)));
            let known = known.iter().filter(|(_, curve)| {
                curve.points.first().is_some_and(|first| first.solution.impacts() == impacts)
            });
            let known = known.map(|(equations, curve)| (kind(equations), curve));
            for (kind, curve) in own.chain(known) {
                let doubling = |event: &&Event| {
                    Bifurcation::of(event.condition, kind.0) == Some(Bifurcation::PeriodDoubling)
                        && event.solution.admissible()
                };
                let found = curve.events.iter().filter(doubling);
                doublings.extend(found.map(|event| (kind.clone(), event.solution.unknowns.clone())));
            }
            for ((periods, stops), at) in doublings {
                let doubled = (2 * periods, stops.clone());
                let halved = equations(self.oscillator, &(periods, stops));
                let slicer = self.slicer(&doubled);
                let slice = slices.entry((2 * impacts, doubled)).or_insert_with(empty);
                slicer.beginning_beside(slice, &halved, at);
            }
        }
        let distinct = |((_, kind), slice): ((usize, ImpactPattern), Slice)| {
            let slicer = self.slicer(&kind);
            let branches = slicer.distinct(slice).into_iter();
            branches.map(|curve| (slicer.equations.clone(), curve)).collect::<Vec<_>>()
        };
        slices.into_iter().flat_map(distinct).collect()
    }

    fn slicer(&self, kind: &ImpactPattern) -> Slicer {
        Slicer::new(equations(self.oscillator, kind), self.window, StepControl::DRAWING)
    }
}
