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

mod pair;
mod symmetry;

use core::f64::consts::{PI, TAU};

use grazing_model::maps::{self, MapError, Passage};
use grazing_model::motion::{Maximum, Motion};
use grazing_model::phase::turned;
use grazing_model::smooth::Purpose;
use grazing_model::{AnyOscillator, AtPhase, ImpactOscillator, MapJet, OnWall, State, Surface};
use grazing_theorems::from_map::GrazingOrbit;
use nalgebra::Vector2;
use smallvec::SmallVec;

pub use pair::{LoopPair, Round};
pub use symmetry::Symmetry;

pub(crate) use crate::solution::Stability;
pub use crate::solution::{Multipliers, PeriodicSolution};
use crate::tolerances::{FAR, RECURS, REST, UNSURE_HEIGHT};
pub use crate::unknowns::{Unknowns, parameters, unknown};

/// The state at phase zero for a point without impacts.
fn at_phase_zero(point: &Unknowns) -> AtPhase {
    AtPhase::new(point[0], point[1])
}

/// Fraction of a flight: a maximum nearer to one of its ends than this is that end, which is
/// located like all maxima to some 10⁻⁸.
const END: f64 = 1e-4;

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

/// A flight of a solution, from the recoil of an impact to the next.
pub(crate) struct Flight<M> {
    pub(crate) motion: M,
}

pub(crate) type Flights<M> = SmallVec<[Flight<M>; 1]>;

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
    pub(crate) stability: Option<Stability>,
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
}

impl<O: ImpactOscillator> LoopEquations<O> {
    /// The equations of MPSs with `loops` = p ≥ 1 loops, or, for any formulation, of periodic
    /// solutions without impacts (p = 0); the oscillator's own parameters do not matter.
    pub fn new(oscillator: O, loops: u32, formulation: Formulation) -> Self {
        Self { oscillator, loops, formulation, units: [1.0; 2], symmetry: None, halved: false }
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

    /// The displacement from one point to another, with phases modulo 2π.
    pub fn gap(&self, from: &Unknowns, to: &Unknowns) -> Unknowns {
        let gap = to - from;
        let gap = if self.has_impacts() { gap.less_turns() } else { gap };
        gap.component_div(&self.units(from))
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

    /// The state in which the flight begins: just after the impact, (0, y_rec, z_rec); without
    /// impacts at phase zero, (x, y, 0).
    pub fn departure(&self, point: &Unknowns) -> State {
        match self.has_impacts() {
            true => self.recoil(point, 0),
            false => at_phase_zero(point).at_phase_zero(),
        }
    }

    /// The state just after the impact with an index.
    fn recoil(&self, point: &Unknowns, impact: usize) -> State {
        self.oscillator_at(point).reset::<1>(point.impact(impact)).image().into()
    }

    /// The flights of a solution, from impact to impact; without impacts one over a forcing period.
    pub(crate) fn flights(&self, point: &Unknowns) -> Flights<O::Motion> {
        let oscillator = self.oscillator_at(point);
        let flight = |from: State| Flight { motion: oscillator.motion(from) };
        match self.has_impacts() {
            true => (0..point.impacts())
                .map(|impact| flight(oscillator.reset::<1>(point.impact(impact)).image().into()))
                .collect(),
            false => SmallVec::from_buf([flight(at_phase_zero(point).at_phase_zero())]),
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
            Formulation::Vivid if self.has_impacts() && point.impacts() == 1 => {
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
    fn maps_along<const ORDER: usize>(
        &self,
        point: &Unknowns,
        planes: &[f64],
        flights: &[Flight<O::Motion>],
        mirror: Option<Symmetry>,
    ) -> Result<Round, MapError> {
        if self.has_impacts() {
            return Ok(self.fixed_phase_maps::<ORDER>(point, planes, flights));
        }
        let (oscillator, from, motion) =
            (self.oscillator_at(point), at_phase_zero(point), &flights[0].motion);
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

    /// The maps of solutions with impacts to the planes of constant phase, one for each impact, which
    /// exist at every point.
    pub(crate) fn fixed_phase_maps<const ORDER: usize>(
        &self,
        point: &Unknowns,
        planes: &[f64],
        flights: &[Flight<O::Motion>],
    ) -> Round {
        let oscillator = self.oscillator_at(point);
        let pair = |(index, flight): (usize, &Flight<O::Motion>)| {
            let impact = point.impact(index);
            let reset = oscillator.reset::<ORDER>(impact);
            let [from_recoil, from_impact]: [State; 2] = [reset.image().into(), impact.into()];
            let (next, loops) =
                if index + 1 == flights.len() { (planes[0], self.loops) } else { (planes[index + 1], 0) };
            let around_to = next + f64::from(loops) * TAU;
            let around = maps::to_phase::<O, ORDER, _>(&oscillator, &flight.motion, from_recoil, around_to);
            let straight = oscillator.motion(from_impact);
            let ahead =
                maps::to_phase::<O, ORDER, OnWall>(&oscillator, &straight, from_impact, planes[index]);
            LoopPair::of(&around.after::<ORDER, _>(&reset), &ahead)
        };
        flights.iter().enumerate().map(pair).collect()
    }

    /// The direction in which the impacts after the first follow it, when the first and the parameters move in
    /// a direction (y, z, μ, η); they have a velocity.
    pub(crate) fn with_others(&self, at: &Unknowns, direction: Unknowns) -> Unknowns {
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

    /// The value of x at the maximum near a time after the first recoil, with its first derivatives in
    /// the unknowns; the time becomes that of the maximum.
    ///
    /// # Errors
    /// The maximum has disappeared.
    pub fn maximum_near(&self, point: &Unknowns, time: &mut f64) -> Result<(f64, Unknowns), MapError> {
        let oscillator = self.oscillator_at(point);
        let mut gradient = point.filled(0.0);
        if self.has_impacts() {
            let (flight, start) = self.flight_at(point, *time);
            let reset = oscillator.reset::<1>(point.impact(flight));
            let landing = maps::virtual_map::<O, 1>(&oscillator, reset.image(), Some(*time - start))?;
            *time = landing.time + start;
            let jet = landing.jet.after::<1, _>(&reset).plain();
            for (variable, index) in unknown::of_impact(flight).into_iter().enumerate() {
                gradient[index] = jet.jacobian[(0, variable)];
            }
            return Ok((jet.value[0], gradient));
        }
        let landing = maps::maximum_from_phase_zero::<O, 1>(&oscillator, at_phase_zero(point), *time)?;
        *time = landing.time;
        let jet = landing.jet.plain();
        (0..4).for_each(|index| gradient[index] = jet.jacobian[(0, index)]);
        Ok((jet.value[0], gradient))
    }

    /// The index of the flight at a time after the first recoil, and the time at which it begins.
    pub(crate) fn flight_at(&self, point: &Unknowns, time: f64) -> (usize, f64) {
        if point.impacts() == 1 {
            return (0, 0.0);
        }
        let spans = self.spans(point);
        let after = spans.iter().take_while(|[start, _]| *start <= time).count();
        (after.max(1) - 1, spans[after.max(1) - 1][0])
    }

    /// The times at which flights begin and how long they take, from the first recoil on.
    fn spans(&self, point: &Unknowns) -> SmallVec<[[f64; 2]; 1]> {
        if !self.has_impacts() {
            return SmallVec::from_buf([[0.0, self.oscillator_at(point).forcing_period()]]);
        }
        let oscillator = self.oscillator_at(point);
        let frequency = oscillator.forcing_frequency().value;
        let count = point.impacts();
        let phases = |impact: usize| {
            let at = point.impact(impact);
            [at.phase, State::from(oscillator.reset::<1>(at).image()).phase]
        };
        let [_, first] = phases(0);
        (0..count)
            .map(|impact| {
                let [_, recoil] = phases(impact);
                let loops = if impact + 1 == count { self.loops } else { 0 };
                let next = point[unknown::phase((impact + 1) % count)];
                [(recoil - first) / frequency, flight_time(&oscillator, loops, next, recoil)]
            })
            .collect()
    }

    /// The solution on a curve of interior grazing as a grazing orbit with impacts elsewhere; `None` where
    /// P_global is not defined.
    pub fn touching_orbit(&self, point: &Unknowns, times: &EventTimes) -> Option<GrazingOrbit<O>> {
        let oscillator = self.oscillator_at(point);
        let (touching, start) = self.flight_at(point, times.grazing_time);
        let spans = self.spans(point);
        let back = times.grazing_time - start;
        let phase = self.departure(point).phase + oscillator.forcing_frequency().value * times.grazing_time;
        let others = (1..spans.len()).map(|later| spans[(touching + later) % spans.len()][1]);
        let to_wall = [spans[touching][1] - back].into_iter().chain(others);
        GrazingOrbit::through(oscillator, phase, Passage::through(self.loops, to_wall, back)).ok()
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

    /// The periodic solution at a zero of the equations: multipliers, maxima, stability,
    /// admissibility.
    ///
    /// No virtual points are needed, for any formulation.
    pub fn solution(&self, point: &Unknowns) -> PeriodicSolution {
        self.solution_and_stability(point).0
    }

    /// The periodic solution at a zero of the equations, with the stability from which its
    /// multipliers follow.
    pub(crate) fn solution_and_stability(&self, point: &Unknowns) -> (PeriodicSolution, Stability) {
        let flights = self.flights(point);
        let stability = self.symmetric_stability(point, &flights).unwrap_or_else(|| {
            let maps = self.maps_along::<1>(point, &planes(point), &flights, None);
            maps.map_or(Stability::UNKNOWN, |maps| maps.stability())
        });
        (self.orbit(point, &flights, stability.multipliers), stability)
    }

    /// The stability of symmetric motion over the whole period, from the map over half of it.
    fn symmetric_stability(&self, point: &Unknowns, flights: &[Flight<O::Motion>]) -> Option<Stability> {
        let mirror = Some(self.symmetry?);
        let maps = self.maps_along::<1>(point, &planes(point), flights, mirror).ok()?;
        (maps.distance() < RECURS).then(|| maps.stability().of_the_square())
    }

    /// The periodic solution at a point with y = 0 that is approached along a curve with the given
    /// tangent; its multipliers are limits.
    pub fn limiting_solution(&self, point: &Unknowns, tangent: &Unknowns) -> PeriodicSolution {
        let flights = self.flights(point);
        let maps = self.fixed_phase_maps::<2>(point, &planes(point), &flights);
        // The orbit begins and ends at a maximum; neither is an interior one.
        let highest = self.highest(point, &flights, |motion, flight| {
            let ends = END * flight;
            let interior = motion
                .local_maxima(flight)
                .into_iter()
                .filter(|maximum| (ends..flight - ends).contains(&maximum.time));
            interior.max_by(|a, b| a.position.total_cmp(&b.position))
        });
        PeriodicSolution {
            loops: self.loops,
            unknowns: point.clone(),
            multipliers: maps.limiting_multipliers(tangent),
            highest_interior_maximum: highest,
        }
    }

    /// The periodic solution to fewer digits, with known multipliers; its maxima are computed only
    /// on request.
    pub(crate) fn sketch(
        &self,
        point: &Unknowns,
        multipliers: Multipliers,
        with_maxima: bool,
    ) -> PeriodicSolution {
        if with_maxima {
            let orbit = |equations: &Self| self.orbit(point, &equations.flights(point), multipliers);
            return Purpose::Admissibility.during(|| {
                let rough = orbit(&self.roughly());
                if rough.ceiling().abs() > UNSURE_HEIGHT { rough } else { orbit(self) }
            });
        }
        let (loops, unknowns) = (self.loops, point.clone());
        PeriodicSolution { loops, unknowns, multipliers, highest_interior_maximum: None }
    }

    fn orbit(
        &self,
        point: &Unknowns,
        flights: &[Flight<O::Motion>],
        multipliers: Multipliers,
    ) -> PeriodicSolution {
        PeriodicSolution {
            loops: self.loops,
            unknowns: point.clone(),
            multipliers,
            highest_interior_maximum: Purpose::Admissibility.during(|| match self.has_impacts() {
                true => self.highest(point, flights, |motion, flight| motion.highest_maximum(flight)),
                false => Some(highest_point(&flights[0].motion, self.flight(point))),
            }),
        }
    }

    /// The highest of the maxima that are found in each flight, its time counted from the first
    /// recoil.
    fn highest(
        &self,
        point: &Unknowns,
        flights: &[Flight<O::Motion>],
        of: impl Fn(&O::Motion, f64) -> Option<Maximum>,
    ) -> Option<Maximum> {
        let spans = self.spans(point);
        let found = flights.iter().zip(spans).filter_map(|(flight, [start, duration])| {
            let top = of(&flight.motion, duration)?;
            Some(Maximum { time: top.time + start, ..top })
        });
        found.max_by(|a, b| a.position.total_cmp(&b.position))
    }

    /// The time from the first recoil to the next first impact; without impacts the forcing period.
    pub fn flight(&self, point: &Unknowns) -> f64 {
        let oscillator = self.oscillator_at(point);
        match self.has_impacts() {
            true => flight_time(&oscillator, self.loops, point[unknown::PHASE], self.departure(point).phase),
            false => oscillator.forcing_period(),
        }
    }

    /// Velocity and phase of the impact of a solution; without impacts 0 and the phase of the
    /// highest point, in [0, 2π).
    pub fn impact(&self, solution: &PeriodicSolution) -> [f64; 2] {
        let point = &solution.unknowns;
        if self.has_impacts() {
            return [point[unknown::VELOCITY], point[unknown::PHASE]];
        }
        let time = solution.highest_interior_maximum.map_or(f64::NAN, |maximum| maximum.time);
        [0.0, turned(time * self.oscillator_at(point).forcing_frequency().value)]
    }
}

/// The time from the recoil to the impact of a solution with p loops, p T − (z_rec − z)/ω, computed
/// from the phases of impact and recoil.
pub fn flight_time<O: ImpactOscillator>(oscillator: &O, loops: u32, impact: f64, recoil: f64) -> f64 {
    let lag = (recoil - impact) / oscillator.forcing_frequency().value;
    f64::from(loops) * oscillator.forcing_period() - lag
}

/// Number of instants of a period at which rest is recognised: no motion is slow at all of them.
const INSTANTS: u32 = 32;

/// The highest point of periodic motion; the first point if it is at rest.
fn highest_point(motion: &impl Motion, period: f64) -> Maximum {
    let at_rest = (0..=INSTANTS).all(|instant| {
        let here = motion.at(period * f64::from(instant) / f64::from(INSTANTS));
        here.velocity.abs() * period <= REST && here.acceleration.abs() * period * period <= REST
    });
    // Slightly more than a period, so that a maximum at phase zero lies inside.
    let highest = if at_rest { None } else { motion.highest_maximum(1.25 * period) };
    highest.unwrap_or_else(|| Maximum { time: 0.0, position: motion.at(0.0).position })
}
