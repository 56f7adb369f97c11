//! Evidence that an orbit has settled: an attracting cycle, found from the orbit.

use core::f64::consts::TAU;

use grazing_continuation::mps::Multipliers;
use grazing_model::motion::Motion;
use grazing_model::orbit::{Flight, FlightEnd, Orbit};
use grazing_model::{AnyMotion, AnyOscillator, ImpactOscillator, State, flow_variable};
use nalgebra::{Matrix2, Vector2};

use super::derivative::from_impact_to_impact;
use super::strike::Strike;
use crate::tolerances::{BETWEEN_ORBITS, BETWEEN_RELEASES};

/// Motion that recurs to within this may be about to settle.
const NEARLY: f64 = 0.1;
/// Largest number of impacts of a cycle in the search.
const LONGEST_CYCLE: usize = 24;
/// Largest number of forcing periods of a cycle without impacts in the search.
pub(super) const MOST_PERIODS: u32 = 16;
/// Limit on the impacts of an orbit, which has only a few a period; sticking and chattering end it
/// by themselves.
pub(super) const MOST_IMPACTS: usize = 1_000_000;
/// Radians by which motion is released later to see whether it still recurs: far more than rounding, and
/// less than what tells releases apart.
const LATER: f64 = 1e-10;
/// Limit on the steps of Newton's method, which converges within a few from motion that is about to
/// settle.
const STEPS: u32 = 12;
/// Last step of Newton's method.
const SOLVED: f64 = 1e-11;

/// A periodic solution that attracts, with impacts or without, and with rests at the wall or without.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cycle {
    /// A state on the cycle: where it comes to rest at the wall, or else on the incoming set, before
    /// an impact, if there is one; as the stop sees it, and without impacts the first.
    pub from: State,
    /// The stop at which it is, if there are two.
    pub stop: usize,
    /// The number of impacts on the cycle, without those that are left out where impacts accumulate; 0
    /// for motion without impacts.
    pub impacts: usize,
    /// The number of rests at the wall.
    pub rests: usize,
    /// Whether infinitely many impacts accumulate before one of them.
    pub accumulates: bool,
    /// The duration of the cycle in forcing periods.
    pub periods: u32,
    /// The multipliers of the cycle, over that time: 0 with a rest, since all nearby motion is released
    /// at the same phase.
    pub multipliers: Multipliers,
}

impl Cycle {
    /// The cycle approached by an orbit that ends with these flights, if its last impacts nearly
    /// recur, and Newton's method leads from them to a neighbouring cycle that attracts.
    pub(super) fn with_impacts(
        oscillator: &AnyOscillator,
        flights: &[Flight<AnyMotion>],
        impacts: &[Strike],
    ) -> Option<Self> {
        let longest = flights.iter().map(|flight| flight.duration).sum();
        cycle_lengths(impacts).find_map(|count| {
            let before = &impacts[impacts.len() - count..];
            Self::beside(oscillator, before, longest)
        })
    }

    /// The cycle near these impacts with the same number of impacts, which takes no longer than
    /// `longest` once round.
    fn beside(oscillator: &AnyOscillator, before: &[Strike], longest: f64) -> Option<Self> {
        let (count, last) = (before.len(), *before.last()?);
        let round = |impact| Round::of(oscillator, Strike { impact, ..last }, count, longest);
        let (from, Round { derivative, periods, .. }) = solved(last.impact, 1.0, round)?;
        // The last impact is that from which a round begins, and with which it ends.
        let on_cycle = round(from)?.impacts;
        let beside = on_cycle.iter().zip(before).all(|(a, b)| a.is_like(BETWEEN_ORBITS, b));
        beside.then_some(())?;
        let from = (State::on_wall(from[0], from[1]), last.stop);
        Self::without_rest(from, (count, periods), &derivative)
    }

    /// The cycle without impacts approached by a flight, of which the time from zero on counts.
    pub(super) fn without_impacts(oscillator: &AnyOscillator, flight: &Flight<AnyMotion>) -> Option<Self> {
        (1..=MOST_PERIODS).find_map(|periods| Self::of_free(oscillator, flight, periods))
    }

    fn of_free(oscillator: &AnyOscillator, flight: &Flight<AnyMotion>, periods: u32) -> Option<Self> {
        let period = oscillator.forcing_period();
        let duration = f64::from(periods) * period;
        // A flight that ends at the end of the counted time may be shorter by rounding.
        if duration > (flight.duration + flight.start.min(0.0)) * (1.0 + f64::EPSILON * 8.0) {
            return None;
        }
        let point = |time: f64| {
            let state = state_at(oscillator, flight, time);
            (Vector2::new(state.position, state.velocity), state.phase)
        };
        let ((last, phase), (before, _)) = (point(flight.duration), point(flight.duration - duration));
        let distance = |a: &Vector2<f64>, b: &Vector2<f64>| libm::hypot(a[0] - b[0], (a[1] - b[1]) * period);
        (distance(&last, &before) < NEARLY).then_some(())?;
        let state = |at: Vector2<f64>| State { position: at[0], velocity: at[1], phase };
        let round = |at: Vector2<f64>| {
            let flow = oscillator.flow::<1>(state(at), duration);
            let derivative = flow.jacobian.fixed_columns::<2>(flow_variable::POSITION).into_owned();
            Some(Round { image: flow.value, derivative, periods, impacts: Vec::new() })
        };
        let (at, Round { derivative, .. }) = solved(last, period, round)?;
        let clear = |seen: &AnyOscillator, from: State| {
            seen.motion(from).highest_maximum(duration).is_none_or(|top| top.position < 0.0)
        };
        let clear = clear(oscillator, state(at))
            && oscillator.other_stop().is_none_or(|other| clear(&other, oscillator.across(state(at))));
        (clear && distance(&at, &last) < BETWEEN_ORBITS).then_some(())?;
        Self::without_rest((state(at), 0), (0, periods), &derivative)
    }

    /// A cycle that does not rest, if it attracts.
    fn without_rest(
        (from, stop): (State, usize),
        (impacts, periods): (usize, u32),
        derivative: &Matrix2<f64>,
    ) -> Option<Self> {
        let multipliers = Multipliers { trace: derivative.trace(), determinant: derivative.determinant() };
        let cycle = Self { from, stop, impacts, rests: 0, accumulates: false, periods, multipliers };
        multipliers.stable().then_some(cycle)
    }

    /// The cycle of motion that the force releases from rest at a stop at a phase, if it releases it at
    /// the same phase again within a time. There is none if a release a little later leads elsewhere: then
    /// rounding does, too.
    pub(super) fn through_rest(
        oscillator: &AnyOscillator,
        (stop, phase): (usize, f64),
        longest: f64,
    ) -> Option<Self> {
        let cycle = Self::after_release(oscillator, (stop, phase), longest)?;
        let later = Self::after_release(oscillator, (stop, phase + LATER), longest)?;
        let late = libm::remainder(later.from.phase - cycle.from.phase, TAU);
        let alike =
            (cycle.rests, cycle.periods) == (later.rests, later.periods) && late.abs() < BETWEEN_ORBITS;
        alike.then_some(cycle)
    }

    fn after_release(oscillator: &AnyOscillator, (stop, phase): (usize, f64), longest: f64) -> Option<Self> {
        let (mut impacts, mut rests, mut accumulates) = (0, 0, false);
        let released = (stop, State::on_wall(0.0, phase));
        for flight in Orbit::from_stop(oscillator, released, longest, MOST_IMPACTS) {
            // Rounding of the phase may let the motion rest for a moment at first.
            if let Some(rest) = flight.rest.filter(|rest| rest.start > 0.0) {
                rests += 1;
                accumulates |= rest.accumulated;
                if rest.stop == stop && is_same_phase(flight.from.phase, phase) {
                    let periods = libm::round(flight.start / oscillator.forcing_period()).max(1.0) as u32;
                    let from = State::on_wall(0.0, rest.phase);
                    let multipliers = Multipliers { trace: 0.0, determinant: 0.0 };
                    return Some(Self { from, stop, impacts, rests, accumulates, periods, multipliers });
                }
            }
            impacts += usize::from(matches!(flight.end, FlightEnd::Impact(_)));
        }
        None
    }

    /// The mean rate at which small displacements from the cycle grow, which is negative: the
    /// logarithm of its larger multiplier divided by its duration; −∞ with a rest.
    pub(super) fn exponent(&self, period: f64) -> f64 {
        let Multipliers { trace, determinant } = self.multipliers;
        let square = 0.25 * trace * trace - determinant;
        let modulus = if square < 0.0 { determinant.sqrt() } else { 0.5 * trace.abs() + square.sqrt() };
        libm::log(modulus) / (f64::from(self.periods) * period)
    }
}

/// One round of a possible cycle.
struct Round {
    image: Vector2<f64>,
    derivative: Matrix2<f64>,
    periods: u32,
    /// The impacts on the way, the last of which is the image.
    impacts: Vec<Strike>,
}

impl Round {
    /// The round from an impact (y, z) to the impact with number `count` after it, whose phase is
    /// counted from that of the first, within the longest time.
    fn of(oscillator: &AnyOscillator, from: Strike, count: usize, longest: f64) -> Option<Self> {
        let mut impact = from;
        let (mut derivative, mut time) = (Matrix2::identity(), 0.0);
        let mut impacts = Vec::with_capacity(count);
        let start = (from.stop, from.state());
        for flight in Orbit::from_stop(oscillator, start, longest, MOST_IMPACTS).take(count) {
            let next = Strike::of(&flight)?;
            if flight.rest.is_some() {
                return None;
            }
            derivative = from_impact_to_impact(oscillator, impact, &flight) * derivative;
            time = flight.start + flight.duration;
            impacts.push(next);
            impact = next;
        }
        (impacts.len() == count && impact.stop == from.stop).then_some(())?;
        let periods = libm::round(time / oscillator.forcing_period()).max(1.0);
        let turn = libm::remainder(impact.impact[1] - from.impact[1], TAU);
        let image = Vector2::new(impact.impact[0], from.impact[1] + turn);
        Some(Self { image, derivative, periods: periods as u32, impacts })
    }
}

/// The fixed point of a map near a point, and the round from it; differences of the second
/// coordinate are divided by a scale.
fn solved(
    mut at: Vector2<f64>,
    scale: f64,
    round: impl Fn(Vector2<f64>) -> Option<Round>,
) -> Option<(Vector2<f64>, Round)> {
    let begin = at;
    for _ in 0..STEPS {
        let there = round(at)?;
        let step = (Matrix2::identity() - there.derivative).try_inverse()? * (there.image - at);
        at += step;
        let size = |by: Vector2<f64>| libm::hypot(by[0], by[1] * scale);
        // NaN ends the search as well.
        (size(at - begin) < NEARLY).then_some(())?;
        if size(step) < SOLVED {
            return Some((at, there));
        }
    }
    None
}

/// The numbers of impacts after which impacts (y, z) nearly recur, in increasing order.
pub(super) fn cycle_lengths(impacts: &[Strike]) -> impl Iterator<Item = usize> {
    let nearly = |length: &usize| impacts.iter().zip(&impacts[*length..]).all(|(a, b)| a.is_like(NEARLY, b));
    (1..=LONGEST_CYCLE.min(impacts.len() / 2)).filter(nearly)
}

/// The state at a time from the beginning of a flight.
pub(super) fn state_at(oscillator: &AnyOscillator, flight: &Flight<AnyMotion>, time: f64) -> State {
    let phase = flight.from.phase + oscillator.forcing_frequency().value * time;
    flight.motion.at(time).state(phase)
}

/// Whether two phases of releases from rest are the same: they are exact but for rounding.
pub(super) fn is_same_phase(a: f64, b: f64) -> bool {
    libm::remainder(a - b, TAU).abs() < BETWEEN_RELEASES
}

impl Strike {
    /// Whether both are at one stop and differ by no more than `distance`, as for [`same_impact`].
    pub(crate) fn is_like(&self, distance: f64, other: &Self) -> bool {
        self.stop == other.stop && same_impact(distance, &self.impact, &other.impact)
    }
}

/// Whether two impacts (y, z) differ by no more than `distance`, relative to y where that exceeds
/// one.
pub fn same_impact(distance: f64, a: &Vector2<f64>, b: &Vector2<f64>) -> bool {
    (a[0] - b[0]).abs() <= distance * a[0].max(1.0) && libm::remainder(a[1] - b[1], TAU).abs() <= distance
}
