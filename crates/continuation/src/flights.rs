//! The motion of a periodic solution, flight by flight, and what is known of the solution from it.

use grazing_model::motion::{Maximum, Motion};
use grazing_model::orbit::{Flight, FlightEnd};
use grazing_model::phase::turned;
use grazing_model::smooth::Purpose;
use grazing_model::{ImpactOscillator, Passage};
use grazing_theorems::from_map::GrazingOrbit;
use smallvec::SmallVec;

use crate::mps::{EventTimes, LoopEquations, planes};
use crate::solution::{Multipliers, PeriodicSolution, StabilityFunctions};
use crate::tolerances::{REST, UNSURE_HEIGHT};
use crate::unknowns::{Unknowns, unknown};

/// Fraction of a flight: a maximum nearer to one of its ends than this is that end, which is
/// located like all maxima to some 10⁻⁸.
const END: f64 = 1e-4;

impl<O: ImpactOscillator> LoopEquations<O> {
    /// The flights of a solution, from impact to impact; without impacts one over a forcing period.
    pub(crate) fn flights(&self, point: &Unknowns) -> SmallVec<[O::Motion; 1]> {
        let views = self.views(point);
        let flight = |impact: usize| views.at(impact).motion(self.beginning(&views, point, impact));
        (0..point.impacts()).map(flight).collect()
    }

    /// The flights as the other stop sees each, if there are two.
    fn flights_across(&self, point: &Unknowns) -> Option<SmallVec<[O::Motion; 1]>> {
        self.has_two_stops().then_some(())?;
        let views = self.views(point);
        let across = |impact: usize| {
            let (oscillator, from) = (views.at(impact), self.beginning(&views, point, impact));
            Some(oscillator.other_stop()?.motion(oscillator.across(from)))
        };
        (0..point.impacts()).map(across).collect()
    }

    /// The flights of a solution as those of an orbit, timed from the first recoil; without impacts one
    /// over a forcing period. The first stop sees them, if there are two.
    pub fn flown(&self, point: &Unknowns) -> Vec<Flight<O::Motion>> {
        let (views, oscillator) = (self.views(point), self.oscillator_at(point));
        let (motions, spans) = (self.flights(point), self.spans(point));
        let count = motions.len();
        let flight = |(index, (motion, [start, duration])): (usize, (O::Motion, [f64; 2]))| {
            let from = self.beginning(&views, point, index);
            let (from, motion) = match self.stop(index) {
                0 => (from, motion),
                _ => {
                    let from = views.at(index).across(from);
                    (from, oscillator.motion(from))
                }
            };
            let next = point.impact((index + 1) % count);
            let end = match self.has_impacts() {
                true => FlightEnd::Impact(next.into()),
                false => {
                    let phase = oscillator.forcing_frequency().value * duration;
                    FlightEnd::TimeIsUp(motion.at(duration).state(phase))
                }
            };
            Flight { start, from, motion, duration, end, stop: self.stop((index + 1) % count), rest: None }
        };
        motions.into_iter().zip(spans).enumerate().map(flight).collect()
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
        let views = self.views(point);
        let oscillator = views.at(0);
        let frequency = oscillator.forcing_frequency().value;
        let count = point.impacts();
        let phases = |impact: usize| [point.impact(impact).phase, views.recoil(point, impact).phase];
        let [_, first] = phases(0);
        (0..count)
            .map(|impact| {
                let [_, recoil] = phases(impact);
                let loops = if impact + 1 == count { self.loops() } else { 0 };
                let next = point[unknown::phase((impact + 1) % count)];
                [(recoil - first) / frequency, flight_time(oscillator, loops, next, recoil)]
            })
            .collect()
    }

    /// The solution on a curve of interior grazing as a grazing orbit with impacts elsewhere; `None` where
    /// P_global is not defined, and with two stops.
    pub fn touching_orbit(&self, point: &Unknowns, times: &EventTimes) -> Option<GrazingOrbit<O>> {
        // A passage knows of one stop.
        (!self.has_two_stops()).then_some(())?;
        let oscillator = self.oscillator_at(point);
        let (touching, start) = self.flight_at(point, times.grazing_time);
        let spans = self.spans(point);
        let back = times.grazing_time - start;
        let phase = self.departure(point).phase + oscillator.forcing_frequency().value * times.grazing_time;
        let others = (1..spans.len()).map(|later| spans[(touching + later) % spans.len()][1]);
        let to_wall = [spans[touching][1] - back].into_iter().chain(others);
        GrazingOrbit::through(oscillator, phase, Passage::through(self.loops(), to_wall, back)).ok()
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
    pub(crate) fn solution_and_stability(&self, point: &Unknowns) -> (PeriodicSolution, StabilityFunctions) {
        let flights = self.flights(point);
        let stability = self.symmetric_stability(point, &flights).unwrap_or_else(|| {
            let maps = self.maps_along::<1>(point, &planes(point), &flights, None);
            maps.map_or(StabilityFunctions::UNKNOWN, |maps| maps.stability())
        });
        (self.orbit(point, &flights, stability.multipliers), stability)
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
            loops: self.loops(),
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
        let (loops, unknowns) = (self.loops(), point.clone());
        PeriodicSolution { loops, unknowns, multipliers, highest_interior_maximum: None }
    }

    fn orbit(&self, point: &Unknowns, flights: &[O::Motion], multipliers: Multipliers) -> PeriodicSolution {
        PeriodicSolution {
            loops: self.loops(),
            unknowns: point.clone(),
            multipliers,
            highest_interior_maximum: Purpose::Admissibility.during(|| match self.has_impacts() {
                true => self.highest(point, flights, |motion, flight| motion.highest_maximum(flight)),
                false => {
                    let period = self.flight(point);
                    let own = highest_point(&flights[0], period);
                    let across = self.flights_across(point).map(|flights| highest_point(&flights[0], period));
                    Some(across.filter(|across| across.position > own.position).unwrap_or(own))
                }
            }),
        }
    }

    /// The highest of the maxima that are found in each flight, its time counted from the first
    /// recoil.
    fn highest(
        &self,
        point: &Unknowns,
        flights: &[O::Motion],
        of: impl Fn(&O::Motion, f64) -> Option<Maximum>,
    ) -> Option<Maximum> {
        let highest = |flights: &[O::Motion]| {
            let spans = self.spans(point);
            let found = flights.iter().zip(spans).filter_map(|(flight, [start, duration])| {
                let top = of(flight, duration)?;
                Some(Maximum { time: top.time + start, ..top })
            });
            found.max_by(|a, b| a.position.total_cmp(&b.position))
        };
        let own = highest(flights);
        let Some(across) = self.flights_across(point) else { return own };
        let both = own.into_iter().chain(highest(&across));
        both.max_by(|a, b| a.position.total_cmp(&b.position))
    }

    /// The time from the first recoil to the next first impact; without impacts the forcing period.
    pub fn flight(&self, point: &Unknowns) -> f64 {
        let oscillator = self.oscillator_at(point);
        match self.has_impacts() {
            true => {
                flight_time(&oscillator, self.loops(), point[unknown::PHASE], self.departure(point).phase)
            }
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
