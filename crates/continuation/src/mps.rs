//! Maximal periodic solutions (MPSs), and periodic solutions without impacts, as zeros of smooth
//! functions.
//!
//! A p-loop MPS has one impact, at velocity y and phase z, and returns to it after p forcing
//! periods. Two maps lead from (y, z) to one surface: one through the recoil and p loops, the other
//! straight from the impact, with the wall ignored. The MPS is where they agree; its stability
//! multipliers are the eigenvalues of the first one's derivative times the inverse of the second
//! one's. The choice of the surface gives the [`Formulation`].
//!
//! A periodic solution without impacts is the case p = 0: from (x, y) at phase zero the flow leads
//! round one forcing period, and the other map is the identity. Everything else is the same: two
//! equations, multipliers from the two maps, a highest maximum.
//!
//! A periodic solution with K impacts in p forcing periods has two more unknowns and two more
//! equations for each: from every impact one map leads through its recoil to the plane of the next,
//! and agrees there with the map straight from that impact ([`Round`]). Which impacts there are is in
//! the [`Unknowns`] alone, so that no crossing of the wall is ever looked for.

mod heights;
mod pair;
mod symmetry;

use core::f64::consts::{PI, TAU};

use grazing_model::maps::{self, MapError};
use grazing_model::{AnyOscillator, AtPhase, ImpactOscillator, MapJet, OnWall, State, Surface};
use nalgebra::Vector2;
use smallvec::SmallVec;

pub use pair::{LoopPair, Round};
pub use symmetry::Symmetry;

pub(crate) use crate::solution::StabilityFunctions;
pub use crate::solution::{Multipliers, PeriodicSolution};
use crate::tolerances::{FAR, RECURS};
pub use crate::unknowns::{Unknowns, parameters, unknown};

/// The state at phase zero for a point without impacts.
pub(crate) fn at_phase_zero(point: &Unknowns) -> AtPhase {
    AtPhase::new(point[0], point[1])
}

/// The surface on which the map through recoil and loops is compared with the direct map from the
/// impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Formulation {
    /// The Poincaré section Π, y = 0: the VIVID function V = P_global^p ∘ P_virt ∘ R − P_virt
    /// (eq:V), the paper's method. It ends where one of the maxima that it passes through
    /// disappears: that of a loop on Π, or the virtual one beyond the wall, as where the wall is
    /// met with ẍ ≥ 0.
    Vivid,
    /// The plane of constant phase through the impact: flow for p forcing periods from the impact
    /// phase, less the duration of the recoil. It has no virtual points and is defined everywhere,
    /// and one landing serves all loops: curves are followed with it.
    FixedPhase,
}

/// The planes of comparison through the impacts of a solution.
pub(crate) fn planes(point: &Unknowns) -> SmallVec<[f64; 1]> {
    (0..point.impacts()).map(|impact| point[unknown::phase(impact)]).collect()
}

/// State carried along a curve: event times, so that "the next maximum" is never ambiguous, and the
/// phase of the comparison plane.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EventTimes {
    /// Evolution times of P_virt from the impact and from the recoil.
    virtual_times: [Option<f64>; 2],
    /// Return times of P_global, loop by loop.
    return_times: SmallVec<[f64; 4]>,
    /// Phases of the planes of [`Formulation::FixedPhase`], one for each impact.
    planes: SmallVec<[f64; 1]>,
    /// Time from the recoil to the interior maximum that a grazing curve holds at the wall.
    pub(crate) grazing_time: f64,
    /// Time from the recoil to a second interior maximum, where two touch the wall.
    pub(crate) second_grazing_time: f64,
    /// The stability found by the last evaluation along a curve.
    pub(crate) stability: Option<StabilityFunctions>,
    /// Whether the next evaluation may find another stability.
    pub(crate) unsettled: bool,
}

impl EventTimes {
    /// The event times with the time from the recoil to the interior maximum that is held at the
    /// wall.
    #[must_use]
    pub fn touching(self, time: f64) -> Self {
        Self { grazing_time: time, ..self }
    }
}

/// The stop that an impact hits, of those of a sequence that recurs; 0 for an empty one.
fn stop_of(stops: &[usize], impact: usize) -> usize {
    if stops.is_empty() { 0 } else { stops[impact % stops.len()] }
}

/// An oscillator as each stop sees it that an impact of a solution hits.
pub(crate) struct Views<'a, O> {
    oscillator: O,
    other: Option<O>,
    stops: &'a [usize],
}

impl<O: ImpactOscillator> Views<'_, O> {
    /// The oscillator as the stop of the impact with an index sees it.
    pub(crate) fn at(&self, impact: usize) -> &O {
        match (stop_of(self.stops, impact), &self.other) {
            (1, Some(other)) => other,
            _ => &self.oscillator,
        }
    }

    /// The state just after the impact with an index.
    pub(crate) fn recoil(&self, point: &Unknowns, impact: usize) -> State {
        self.at(impact).reset::<1>(point.impact(impact)).image().into()
    }
}

/// The equations of the periodic solutions of one oscillator with one impact in p forcing periods
/// (MPSs), or without impacts (p = 0).
#[derive(Clone, Debug)]
pub struct LoopEquations<O = AnyOscillator> {
    oscillator: O,
    loops: u32,
    formulation: Formulation,
    /// The units of μ and η in lengths.
    units: [f64; 2],
    /// The symmetry of motion without impacts.
    symmetry: Option<Symmetry>,
    /// Whether the equations are those of symmetric motion over half a period.
    halved: bool,
    /// The stop that each impact hits, if not all are at x = 0.
    stops: SmallVec<[usize; 4]>,
}

impl<O: ImpactOscillator> LoopEquations<O> {
    /// The equations of MPSs with `loops` = p ≥ 1 loops, or, for any formulation, of periodic
    /// solutions without impacts (p = 0); the oscillator's own parameters do not matter.
    pub fn new(oscillator: O, loops: u32, formulation: Formulation) -> Self {
        let stops = SmallVec::new();
        Self { oscillator, loops, formulation, units: [1.0; 2], symmetry: None, halved: false, stops }
    }

    /// The equations of periodic solutions without impacts; in lengths of steps μ and η are
    /// measured in these units.
    pub fn without_impacts(oscillator: O, units: [f64; 2]) -> Self {
        Self { units, ..Self::new(oscillator, 0, Formulation::FixedPhase) }
    }

    /// The equations with the symmetry of motion without impacts, if any.
    #[must_use]
    pub fn with_symmetry(self, symmetry: Option<Symmetry>) -> Self {
        Self { symmetry, ..self }
    }

    /// The equations of solutions whose impacts hit these stops, in their order, over and over: 0 is that at
    /// x = 0, 1 the other. Each impact is as its stop sees it.
    #[must_use]
    pub fn at_stops(&self, stops: impl IntoIterator<Item = usize>) -> Self {
        Self { stops: stops.into_iter().collect(), ..self.clone() }
    }

    /// The stops that impacts hit, in their order, over and over; none if all are at x = 0.
    pub fn stops(&self) -> &[usize] {
        &self.stops
    }

    /// The stop that the impact with an index hits.
    pub fn stop(&self, impact: usize) -> usize {
        stop_of(&self.stops, impact)
    }

    /// Whether so many impacts hit the same stops in order if another is taken for the first.
    fn stops_recur(&self, impacts: usize, first: usize) -> bool {
        (0..impacts).all(|impact| self.stop(impact) == self.stop((impact + first) % impacts))
    }

    /// Whether the oscillator has two stops.
    pub fn has_two_stops(&self) -> bool {
        self.oscillator.other_stop().is_some()
    }

    /// The oscillator at the parameters of a point, as the stops of the impacts see it.
    pub(crate) fn views(&self, point: &Unknowns) -> Views<'_, O> {
        let oscillator = self.oscillator_at(point);
        let other = if self.stops.contains(&1) { oscillator.other_stop() } else { None };
        Views { oscillator, other, stops: &self.stops }
    }

    /// The equations of symmetric motion: half a forcing period and the mirror lead back; `None`
    /// where there is no symmetry.
    pub fn halved(&self) -> Option<Self> {
        self.symmetry.map(|_| Self { halved: true, ..self.clone() })
    }

    /// The number of loops p; 0 without impacts.
    pub fn loops(&self) -> u32 {
        self.loops
    }

    /// Whether there is an impact in p forcing periods.
    pub fn has_impacts(&self) -> bool {
        self.loops > 0
    }

    /// The index of the unknown that is an angle: the impact phase.
    pub fn angle(&self) -> Option<usize> {
        self.has_impacts().then_some(unknown::PHASE)
    }

    /// The units of the unknowns of a point in lengths.
    pub fn units(&self, point: &Unknowns) -> Unknowns {
        let mut units = point.filled(1.0);
        (units[unknown::PRIMARY], units[unknown::SECONDARY]) = (self.units[0], self.units[1]);
        units
    }

    /// The displacement from one point to another, with phases modulo 2π; of the ways to number the
    /// impacts of the first point, that which makes it shortest counts.
    pub fn gap(&self, from: &Unknowns, to: &Unknowns) -> Unknowns {
        let apart = |from: &Unknowns| {
            let gap = to - from;
            let gap = if self.has_impacts() { gap.less_turns() } else { gap };
            gap.component_div(&self.units(from))
        };
        let others = (1..from.impacts()).filter(|first| self.stops_recur(from.impacts(), *first));
        let others = others.map(|first| apart(&from.beginning_with(first, self.loops)));
        let shorter = |short: Unknowns, next: Unknowns| if next.norm() < short.norm() { next } else { short };
        others.fold(apart(from), shorter)
    }

    /// The displacement from a solution to itself a part of its time later, for a number of equal parts into
    /// which both its impacts and its forcing periods can be divided.
    pub fn after_a_part(&self, point: &Unknowns, parts: usize) -> Option<Unknowns> {
        let divides = point.impacts().is_multiple_of(parts)
            && self.loops.is_multiple_of(parts as u32)
            && self.stops_recur(point.impacts(), point.impacts() / parts);
        let later = || point.beginning_with(point.impacts() / parts, self.loops);
        divides.then(|| (later() - point).less_turns())
    }

    /// Whether a solution with several impacts recurs after a part of its time, and so has fewer of them.
    pub fn recurs_sooner(&self, point: &Unknowns) -> bool {
        let parts = (2..=point.impacts()).filter_map(|parts| self.after_a_part(point, parts));
        parts.into_iter().any(|apart| apart.norm() < RECURS)
    }

    /// The equations of solutions that take half as long, if that is a whole number of forcing periods.
    pub fn of_half_the_time(&self) -> Option<Self> {
        (self.loops > 0 && self.loops.is_multiple_of(2))
            .then(|| Self { loops: self.loops / 2, ..self.clone() })
    }

    /// The formulation in use.
    pub fn formulation(&self) -> Formulation {
        self.formulation
    }

    /// The equations in another formulation.
    pub fn with_formulation(&self, formulation: Formulation) -> Self {
        Self { formulation, ..self.clone() }
    }

    /// The equations of solutions that take this many times as long.
    pub(crate) fn over(&self, times: u32) -> Self {
        Self { loops: self.loops * times, ..self.clone() }
    }

    /// The equations with motion computed to fewer digits, where that takes less time.
    #[must_use]
    pub fn roughly(&self) -> Self {
        Self { oscillator: self.oscillator.roughly(), ..self.clone() }
    }

    /// The equations with motion integrated in shorter steps; `None` where it is not integrated.
    pub fn finely(&self) -> Option<Self> {
        Some(Self { oscillator: self.oscillator.finely()?, ..self.clone() })
    }

    /// The oscillator at the parameters of a point.
    pub fn oscillator_at(&self, point: &Unknowns) -> O {
        self.oscillator.with_parameters(parameters(point))
    }

    /// The state in which the flight begins: just after the impact, (0, y_rec, z_rec), as its stop sees it;
    /// without impacts at phase zero, (x, y, 0).
    pub fn departure(&self, point: &Unknowns) -> State {
        match self.has_impacts() {
            true => self.views(point).recoil(point, 0),
            false => at_phase_zero(point).at_phase_zero(),
        }
    }

    /// The state in which the flight after an impact begins, as its stop sees it, or that of motion without
    /// impacts.
    pub(crate) fn beginning(&self, views: &Views<'_, O>, point: &Unknowns, impact: usize) -> State {
        match self.has_impacts() {
            true => views.recoil(point, impact),
            false => at_phase_zero(point).at_phase_zero(),
        }
    }

    /// The maps of all impacts at a point with derivatives up to `ORDER`.
    ///
    /// # Errors
    /// VIVID is not defined there.
    pub fn maps<const ORDER: usize>(
        &self,
        point: &Unknowns,
        times: &mut EventTimes,
    ) -> Result<Round, MapError> {
        match self.formulation {
            Formulation::Vivid if self.has_impacts() && point.impacts() == 1 && self.stops.is_empty() => {
                let oscillator = self.oscillator_at(point);
                let impact = point.impact(0);
                let reset = oscillator.reset::<ORDER>(impact);
                let [from_impact, from_recoil] = times.virtual_times;
                let ahead = maps::virtual_map::<O, ORDER>(&oscillator, impact, from_impact)?;
                let back = maps::virtual_map::<O, ORDER>(&oscillator, reset.image(), from_recoil)?;
                times.virtual_times = [Some(ahead.time), Some(back.time)];
                let mut jet = back.jet.after::<ORDER, _>(&reset);
                times.return_times.resize(self.loops as usize, oscillator.forcing_period());
                for time in &mut times.return_times {
                    let next = maps::global_map::<O, ORDER>(&oscillator, jet.image(), Some(*time))?;
                    *time = next.time;
                    jet = next.jet.after::<ORDER, _>(&jet);
                }
                Ok(LoopPair::of(&jet, &ahead.jet).into())
            }
            _ => {
                if times.planes.len() != point.impacts() {
                    self.settle(point, times);
                }
                let mirror = self.symmetry.filter(|_| self.halved);
                self.maps_along::<ORDER>(point, &times.planes, &self.flights(point), mirror)
            }
        }
    }

    /// The maps to planes of constant phase, given the flights. Without impacts they are the flow
    /// over a forcing period, or over half of it with a mirror, and the identity; they are undefined
    /// where motion goes far away.
    pub(crate) fn maps_along<const ORDER: usize>(
        &self,
        point: &Unknowns,
        planes: &[f64],
        flights: &[O::Motion],
        mirror: Option<Symmetry>,
    ) -> Result<Round, MapError> {
        if self.has_impacts() {
            return Ok(self.fixed_phase_maps::<ORDER>(point, planes, flights));
        }
        let (oscillator, from, motion) = (self.oscillator_at(point), at_phase_zero(point), &flights[0]);
        let to =
            |phase| maps::to_phase::<O, ORDER, AtPhase>(&oscillator, motion, from.at_phase_zero(), phase);
        let around = match mirror {
            Some(symmetry) => symmetry.mirrored(to(PI), point),
            None => to(TAU),
        };
        let size = around.value.norm();
        // NaN counts as far away as well.
        if size.is_nan() || size > FAR {
            return Err(MapError::NoRest { near: oscillator.forcing_period(), velocity: size });
        }
        Ok(LoopPair::of(&around, &MapJet::identity(from)).into())
    }

    /// The stability of symmetric motion over the whole period, from the map over half of it, or of a solution
    /// with one impact at each of two stops that is its own mirror image.
    pub(crate) fn symmetric_stability(
        &self,
        point: &Unknowns,
        flights: &[O::Motion],
    ) -> Option<StabilityFunctions> {
        if let Some(half) = self.mirrored(point, flights) {
            return Some(half.stability().of_the_square());
        }
        let mirror = Some(self.symmetry?);
        let maps = self.maps_along::<1>(point, &planes(point), flights, mirror).ok()?;
        (maps.distance() < RECURS).then(|| maps.stability().of_the_square())
    }

    /// The maps of solutions with impacts to the planes of constant phase, one for each impact, which
    /// exist at every point.
    pub(crate) fn fixed_phase_maps<const ORDER: usize>(
        &self,
        point: &Unknowns,
        planes: &[f64],
        flights: &[O::Motion],
    ) -> Round {
        let views = self.views(point);
        let pair = |(index, flight): (usize, &O::Motion)| {
            let (oscillator, impact) = (views.at(index), point.impact(index));
            let reset = oscillator.reset::<ORDER>(impact);
            let [from_recoil, from_impact]: [State; 2] = [reset.image().into(), impact.into()];
            let (next, loops) =
                if index + 1 == flights.len() { (planes[0], self.loops) } else { (planes[index + 1], 0) };
            let around_to = next + f64::from(loops) * TAU;
            let mut around = maps::to_phase::<O, ORDER, _>(oscillator, flight, from_recoil, around_to);
            if self.stop((index + 1) % flights.len()) != self.stop(index) {
                around = maps::across(oscillator, &around, around_to);
            }
            let straight = oscillator.motion(from_impact);
            let ahead = maps::to_phase::<O, ORDER, OnWall>(oscillator, &straight, from_impact, planes[index]);
            LoopPair::of(&around.after::<ORDER, _>(&reset), &ahead)
        };
        flights.iter().enumerate().map(pair).collect()
    }

    /// The direction in which the impacts after the first follow it, when the first and the parameters move in
    /// a direction (y, z, μ, η); they have a velocity.
    pub fn with_others(&self, at: &Unknowns, direction: Unknowns) -> Unknowns {
        if at.impacts() == 1 {
            return direction;
        }
        let maps = self.fixed_phase_maps::<1>(at, &planes(at), &self.flights(at));
        let mut all = at.filled(0.0);
        (0..4).for_each(|index| all[index] = direction[index]);
        maps.follow_on(&mut all);
        all
    }

    /// Updates the carried state at an accepted point: the planes of comparison move to its phases.
    pub(crate) fn settle(&self, point: &Unknowns, times: &mut EventTimes) {
        times.planes = planes(point);
    }

    /// The points (x⁽ʲ⁾, z⁽ʲ⁾), j = 1, …, p, at which the loops of an MPS meet Π; the last is
    /// virtual.
    ///
    /// Paper: eq:xjzj. Starts from the event times in `times`.
    ///
    /// # Errors
    /// A loop has no maximum of x near Π, half a forcing period or more after the one before, as
    /// where VIVID is not defined.
    pub fn visits(&self, point: &Unknowns, times: &EventTimes) -> Result<Vec<Vector2<f64>>, MapError> {
        let oscillator = self.oscillator_at(point);
        let recoil = oscillator.reset::<1>(point.impact(0)).image();
        let mut here = maps::virtual_map::<O, 1>(&oscillator, recoil, times.virtual_times[1])?.jet.image();
        (0..self.loops as usize)
            .map(|j| {
                let time = times.return_times.get(j).copied();
                here = maps::next_visit(&oscillator, here, time)?.jet.image();
                Ok(here.coordinates())
            })
            .collect()
    }
}
