//! Branches in the form in which they are drawn: x on Π, loop by loop.

use core::f64::consts::TAU;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::{Curve, Event};
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{
    EventTimes, Formulation, LoopEquations, PeriodicSolution, Unknowns, unknown,
};
use grazing_model::maps::virtual_map;
use grazing_model::orbit::Flight;
use grazing_model::phase::centred;
use grazing_model::{AnyMotion, OnWall};
use grazing_results::branches::{BranchBifurcation, BranchPoint};
use grazing_results::{Stability, span};
use nalgebra::Vector2;

use super::flights::visits_of;
use crate::segments::{BranchVertex, vertices};

/// A branch of periodic solutions at one η.
#[derive(Clone, Debug)]
pub struct Branch {
    /// The equations, in the formulation in which the branch was begun.
    pub equations: LoopEquations,
    /// The points and bifurcations of the branch.
    pub curve: Curve,
}

/// One loop of the solutions of a branch: its points in order.
pub(super) type Strand = Vec<BranchPoint>;

/// Largest V of a solution whose visits to Π are the right ones (empirical: Newton's method leaves
/// some 10⁻¹⁰; another maximum is farther away than this by orders of magnitude).
const CLOSED: f64 = 1e-6;
/// Largest change of a visit's phase from point to point of a branch (empirical: a step of a curve
/// that is drawn turns by two degrees).
const LARGEST_TURN: f64 = 0.3;
/// The same with several impacts, where a maximum far below the wall moves fast; the phase between one
/// maximum and the next is larger.
const LARGEST_TURN_OF_SEVERAL: f64 = 1.0;

/// A meeting of a solution with Π.
#[derive(Clone, Copy)]
struct Meeting {
    /// The point (x, z).
    place: Vector2<f64>,
    /// Velocity and phase of the impact with which the flight ends; NaN without impacts.
    impact: [f64; 2],
    /// The number of the wall that is hit, from 1; 0 without impacts.
    wall: u32,
}

impl Branch {
    /// The number of impacts of the solutions.
    pub fn impacts(&self) -> u32 {
        self.curve.points.first().map_or(0, |first| first.solution.impacts() as u32)
    }

    /// The number of the wall that an impact hits, from 1; 0 without impacts.
    pub(super) fn wall(&self, impact: usize) -> u32 {
        if self.equations.has_impacts() { self.equations.stop(impact) as u32 + 1 } else { 0 }
    }

    /// The points (x, z) at which the solutions meet Π, loop by loop; NaN where they are unknown. All
    /// solutions have as many.
    ///
    /// With one impact the times of the maxima are carried from point to point, and visits count only if
    /// the last is the virtual point of the impact, as for an MPS. That point is always known. With
    /// several impacts each flight meets Π in its maxima, counted back from the virtual point of its
    /// impact, as that of simulated motion does. For motion without impacts the visit is its highest point.
    fn visits(&self, places: &[BranchVertex<'_>]) -> Vec<Vec<Meeting>> {
        match self.impacts() {
            0 => {
                let highest = |at: &BranchVertex<'_>| {
                    let touches = at.event.is_some_and(|event| event.condition == Condition::InteriorGrazing);
                    let x = if touches { 0.0 } else { at.solution.ceiling() };
                    let place = Vector2::new(x, self.equations.impact(at.solution)[1]);
                    vec![Meeting { place, impact: [f64::NAN; 2], wall: 0 }]
                };
                places.iter().map(highest).collect()
            }
            // A section between two stops would have maxima and minima.
            1 if !self.equations.has_two_stops() => self.loops_of_mps(places),
            _ => self.maxima_of_flights(places),
        }
    }

    fn loops_of_mps(&self, places: &[BranchVertex<'_>]) -> Vec<Vec<Meeting>> {
        let vivid = self.equations.with_formulation(Formulation::Vivid);
        // The maximum next to the impact.
        let landing = |point: &Unknowns| {
            let impact = OnWall::new(point[unknown::VELOCITY], point[unknown::PHASE]);
            let landing = virtual_map::<_, 1>(&self.equations.oscillator_at(point), impact, None);
            landing.map_or(Vector2::repeat(f64::NAN), |landing| landing.jet.value)
        };
        let closed = |point: &Unknowns, mut times: EventTimes| {
            let maps = vivid.maps::<1>(point, &mut times).ok()?;
            let pair = maps.first();
            let elsewhere = pair.impact.value - landing(point);
            let misses = [pair.difference().0, elsewhere].map(|miss| miss.norm() <= CLOSED);
            (misses == [true; 2]).then_some(times)
        };
        let top = |point: &Unknowns| {
            let mut visits = vec![Vector2::repeat(f64::NAN); self.equations.loops() as usize];
            if let Some(last) = visits.last_mut() {
                *last = landing(point);
            }
            visits
        };
        let mut carried = EventTimes::default();
        let visits = places.iter().map(|at| {
            let point = &at.solution.unknowns;
            let times = closed(point, carried.clone()).or_else(|| closed(point, EventTimes::default()));
            carried = times.clone().unwrap_or_default();
            let visits = times.and_then(|times| vivid.visits(point, &times).ok());
            let impact = self.equations.impact(at.solution);
            visits
                .unwrap_or_else(|| top(point))
                .into_iter()
                .map(|place| Meeting { place, impact, wall: 1 })
                .collect()
        });
        visits.collect()
    }

    fn maxima_of_flights(&self, places: &[BranchVertex<'_>]) -> Vec<Vec<Meeting>> {
        let of_solution = |at: &BranchVertex<'_>| {
            let point = &at.solution.unknowns;
            let oscillator = self.equations.oscillator_at(point);
            let flights = self.equations.flown(point).into_iter().enumerate();
            let of_flight = |(index, flight): (usize, Flight<AnyMotion>)| {
                let next = point.impact((index + 1) % point.impacts());
                let impact = [next.velocity, next.phase];
                let wall = self.wall(index + 1);
                let place = |[x, z]: [f64; 2]| Meeting { place: Vector2::new(x, z), impact, wall };
                visits_of(&oscillator, &flight).into_iter().map(place).collect::<Vec<_>>()
            };
            flights.map(of_flight).collect::<Vec<_>>()
        };
        let found: Vec<Vec<Vec<Meeting>>> = places.iter().map(of_solution).collect();
        let longest = |flight: usize| found.iter().map(|flights| flights[flight].len()).max().unwrap_or(0);
        let counts: Vec<usize> = (0..self.impacts() as usize).map(longest).collect();
        let filled = |(meetings, count): (Vec<Meeting>, &usize)| {
            let unknown = Meeting { place: Vector2::repeat(f64::NAN), impact: [f64::NAN; 2], wall: 0 };
            let missing = count - meetings.len();
            core::iter::repeat_n(unknown, missing).chain(meetings).collect::<Vec<_>>()
        };
        let whole = |flights: Vec<Vec<Meeting>>| flights.into_iter().zip(&counts).flat_map(filled).collect();
        found.into_iter().map(whole).collect()
    }

    /// The strands and bifurcations of the branch that are drawn. Strands have no numbers yet.
    pub(super) fn shown(&self) -> (Vec<Strand>, Vec<BranchBifurcation>) {
        let places = vertices(&self.curve);
        let visits = self.visits(&places);
        let (loops, impacts) = (self.equations.loops(), self.impacts());
        let stability = self.stability(&places);
        let mut strands = Vec::new();
        let turn = match impacts {
            0 => f64::INFINITY,
            1 => LARGEST_TURN,
            _ => LARGEST_TURN_OF_SEVERAL,
        };
        for visit in 0..visits.first().map_or(0, Vec::len) {
            let mut points = Vec::new();
            let mut phase = f64::NAN;
            for (k, (at, visits)) in places.iter().zip(&visits).enumerate() {
                let Meeting { place, impact: [velocity, of_impact], wall } = visits[visit];
                let [x, z] = place.into();
                // Where another maximum is taken for the visit, a new strand begins.
                if libm::remainder(z - phase, TAU).abs() > turn {
                    strands.push(core::mem::take(&mut points));
                }
                phase = z;
                let [primary, secondary] = at.solution.parameters();
                points.push(BranchPoint {
                    diagram: 0,
                    loops,
                    impacts,
                    wall,
                    secondary,
                    primary,
                    x,
                    visit: visit as u32 + 1,
                    impact_velocity: velocity,
                    impact_phase: centred(of_impact),
                    stable: stability[k],
                    admissible: at.solution.ceiling() <= PeriodicSolution::TOUCH,
                    branch: 0,
                });
            }
            strands.push(points);
        }
        let bifurcations = places.iter().zip(&visits).filter_map(|(at, visits)| {
            let kind = Bifurcation::of(at.event?.condition, loops)?;
            let [primary, secondary] = at.solution.parameters();
            at.solution.admissible().then(|| BranchBifurcation {
                diagram: 0,
                kind,
                loops,
                impacts,
                wall: visits.last().map_or(0, |last| last.wall),
                secondary,
                primary,
                impact_velocity: at.solution.impact_velocity(),
                x: visits.last().map_or(f64::NAN, |last| last.place[0]),
            })
        });
        let bifurcations = bifurcations.collect();
        (strands, bifurcations)
    }

    /// The stability of the solutions; at y = 0 they are unstable.
    pub(super) fn stability(&self, places: &[BranchVertex<'_>]) -> Vec<Stability> {
        // At a multiplier on the unit circle a solution is given the stability that it has beyond
        // the bifurcation.
        let critical = |event: &Event| matches!(event.condition, Condition::Multiplier(_) | Condition::TORUS);
        let own = |k: usize| match places[k].event {
            Some(event) if critical(event) => None,
            _ => Some(Stability::of(places[k].solution.multipliers)),
        };
        let hits = |at: &BranchVertex<'_>| !at.solution.has_impacts() || at.solution.impact_velocity() > 0.0;
        let beyond = |k: usize| (k..places.len()).find_map(own).filter(|_| hits(&places[k]));
        (0..places.len()).map(|k| beyond(k).unwrap_or(Stability::Unstable)).collect()
    }

    /// The ranges of μ in which the MPSs are stable and admissible.
    pub fn stable_stretches(&self) -> Vec<[f64; 2]> {
        let places = vertices(&self.curve);
        let shown = |at: &BranchVertex<'_>| {
            at.solution.impact_velocity() > 0.0 && at.solution.stable() && at.solution.admissible()
        };
        let mut stretches = Vec::new();
        for run in places.chunk_by(|a, b| shown(a) == shown(b)) {
            let [low, high] = span(run.iter().map(|at| at.solution.parameters()[0]));
            if shown(&run[0]) && low < high {
                stretches.push([low, high]);
            }
        }
        stretches
    }

    /// The stable admissible MPSs at a value of μ.
    pub fn stable_at(&self, primary: f64) -> Vec<Unknowns> {
        let mut found: Vec<Unknowns> = Vec::new();
        for pair in self.curve.points.windows(2) {
            let [before, after] = [&pair[0].solution, &pair[1].solution];
            let [from, secondary] = before.parameters();
            let brackets = (from - primary) * (after.parameters()[0] - primary) <= 0.0;
            if !(brackets && (before.stable() || after.stable())) {
                continue;
            }
            let conditions = [Condition::Secondary(secondary), Condition::Primary(primary)];
            let mut times = pair[0].times.clone();
            let Ok(point) = locate(&self.equations, conditions, before.unknowns.clone(), &mut times) else {
                continue;
            };
            let solution = self.equations.solution(&point);
            if solution.stable() && solution.admissible() {
                found.push(point);
            }
        }
        found
    }
}

/// The parts of a strand in a range of μ, each with the points next to it outside.
pub(super) fn within<T: Clone>(
    strand: &[T],
    primary: impl Fn(&T) -> f64,
    [low, high]: [f64; 2],
) -> Vec<Vec<T>> {
    let near = |k: usize| {
        let inside = |point: &T| (low..=high).contains(&primary(point));
        let [first, last] = [k.saturating_sub(1), (k + 1).min(strand.len() - 1)];
        strand[first..=last].iter().any(inside)
    };
    let places: Vec<usize> = (0..strand.len()).collect();
    let runs = places.chunk_by(|a, b| near(*a) == near(*b)).filter(|run| near(run[0]));
    runs.map(|run| strand[run[0]..=run[run.len() - 1]].to_vec()).collect()
}

/// Whether two bifurcations are the same, with parameters no farther apart than `distance`.
pub(super) fn same_bifurcation(a: &BranchBifurcation, b: &BranchBifurcation, distance: f64) -> bool {
    (a.kind, a.loops, a.impacts) == (b.kind, b.loops, b.impacts)
        && (a.primary - b.primary).abs() <= distance
        && (a.impact_velocity - b.impact_velocity).abs() <= CLOSED
}
