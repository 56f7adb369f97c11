//! Impacts that accumulate, rest at the wall and release, compared with a simulation that shares no
//! code with the orbits.

use core::f64::consts::TAU;

use grazing_model::orbit::{FlightEnd, Orbit, OrbitEnd};
use grazing_model::phase::turned;
use grazing_model::rest::{Rest, release};
use grazing_model::smooth::{Function, Integrated, Scalar, SmoothOscillator};
use grazing_model::{ImpactOscillator, LinearOscillator, State};

/// The oscillator ẍ + 2ζẋ + x = −1 + 𝒜 cos ωt with restitution r, in closed form.
#[derive(Clone, Copy, Debug)]
struct Known {
    damping: f64,
    restitution: f64,
    amplitude: f64,
    omega: f64,
}

/// An event of an orbit, with its time.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Event {
    Impact { time: f64, velocity: f64 },
    Stick(f64),
    Release(f64),
}

impl Known {
    /// Position and velocity after a time from (x, v) at phase z, the wall ignored: the closed form, and for
    /// short times, in which differences of it are lost in rounding, its power series.
    fn flow(&self, [x, v, z]: [f64; 3], t: f64) -> [f64; 2] {
        let Self { damping: d, amplitude, omega, .. } = *self;
        if t < 0.02 {
            // The derivatives of x, from that of order k − 2 on, times t^k/k!.
            let mut terms = [x, v * t];
            let (mut position, mut velocity) = (x + v * t, v);
            for k in 2..12 {
                let (kf, turn) = (f64::from(k), 0.5 * core::f64::consts::PI * f64::from(k - 2));
                let powers: f64 = (1..k - 1).map(|j| omega * t / f64::from(j)).product();
                let forcing = amplitude * libm::cos(z + turn) * powers - if k == 2 { 1.0 } else { 0.0 };
                let accelerated =
                    (forcing - terms[0]) * t * t / (kf * (kf - 1.0)) - 2.0 * d * terms[1] * t / kf;
                terms = [terms[1], accelerated];
                position += accelerated;
                velocity += accelerated * kf / t;
            }
            return [position, velocity];
        }
        let [real, imaginary] = [1.0 - omega * omega, 2.0 * d * omega];
        let [c, s] = [real, imaginary].map(|part| amplitude * part / (real * real + imaginary * imaginary));
        let forced = |phase: f64| {
            let [cos, sin] = [libm::cos(phase), libm::sin(phase)];
            [c * cos + s * sin - 1.0, omega * (s * cos - c * sin)]
        };
        let ([x0, v0], [x1, v1]) = (forced(z), forced(z + omega * t));
        let (w, decay) = ((1.0 - d * d).sqrt(), libm::exp(-d * t));
        let (a, b) = (x - x0, (v - v0 + d * (x - x0)) / w);
        let [cos, sin] = [libm::cos(w * t), libm::sin(w * t)];
        let free = [a * cos + b * sin, b * w * cos - a * w * sin - d * (a * cos + b * sin)];
        [x1 + decay * free[0], v1 + decay * free[1]]
    }

    fn force(&self, phase: f64) -> f64 {
        self.amplitude * libm::cos(phase) - 1.0
    }

    /// The time and the velocity of the first impact from a state at or below the wall.
    fn flight(&self, from: [f64; 3], longest: f64) -> Option<[f64; 2]> {
        let halved = |mut low: f64, mut high: f64, below: &dyn Fn([f64; 2]) -> bool| {
            for _ in 0..200 {
                let middle = 0.5 * (low + high);
                if below(self.flow(from, middle)) { low = middle } else { high = middle }
            }
            high
        };
        let mut t = 0.0;
        let mut before = [from[0], from[1]];
        let mut step = (0.02 * from[1].abs() / self.force(from[2]).abs()).clamp(1e-9, 5e-3);
        while t < longest {
            let here = self.flow(from, t + step);
            let top = (before[1] > 0.0 && here[1] <= 0.0).then(|| halved(t, t + step, &|[_, v]| v > 0.0));
            let beyond = match top {
                Some(top) if self.flow(from, top)[0] > 0.0 => Some(top),
                _ => (here[0] > 0.0).then_some(t + step),
            };
            if let Some(beyond) = beyond {
                let time = halved(t, beyond, &|[x, _]| x <= 0.0);
                return Some([time, self.flow(from, time)[1]]);
            }
            (t, before) = (t + step, here);
            step = (1.1 * step).min(5e-3);
        }
        None
    }

    /// The events of the orbit from a state: impacts are followed down to a velocity of 10⁻⁶, and the
    /// rest of the sequence is geometric, with an error of some 10⁻¹².
    fn events(&self, mut from: [f64; 3], horizon: f64) -> Vec<Event> {
        let (mut events, mut time) = (Vec::new(), 0.0);
        while let Some([duration, velocity]) = self.flight(from, horizon - time) {
            time += duration;
            events.push(Event::Impact { time, velocity });
            let phase = turned(from[2] + self.omega * duration);
            from = [0.0, -self.restitution * velocity, phase];
            let force = self.force(phase);
            if velocity > 1e-6 || force < 0.0 {
                continue;
            }
            let left = 2.0 * self.restitution * velocity / (force * (1.0 - self.restitution));
            // The force presses around phase 0, up to arccos 1/𝒜.
            let end = libm::acos(1.0 / self.amplitude);
            let rest = turned(end - phase) / self.omega;
            events.extend([Event::Stick(time + left), Event::Release(time + rest)]);
            time += rest;
            from = [0.0, 0.0, end];
        }
        events
    }
}

/// The events of an orbit.
fn events(oscillator: &impl ImpactOscillator, from: State, horizon: f64) -> Vec<Event> {
    let of_flight = |start: f64, end: f64, rest: Option<Rest>, how: FlightEnd| {
        let rest = rest.map(|rest| [Event::Stick(rest.start), Event::Release(start)]);
        let impact = match how {
            FlightEnd::Impact(impact) => Some(Event::Impact { time: end, velocity: impact.velocity }),
            FlightEnd::TimeIsUp(_) => None,
        };
        rest.into_iter().flatten().chain(impact)
    };
    let flights = Orbit::new(oscillator, from, horizon, usize::MAX);
    flights.flat_map(|one| of_flight(one.start, one.start + one.duration, one.rest, one.end)).collect()
}

/// Numbers that fill an interval evenly.
fn spread(k: u32, square: f64, [low, high]: [f64; 2]) -> f64 {
    let turns = f64::from(k) * square.sqrt();
    low + (high - low) * (turns - libm::floor(turns))
}

#[test]
fn accumulations_rests_and_releases_are_those_of_an_independent_simulation() {
    let (mut rests, mut impacts) = (0, 0);
    for k in 1..=1000 {
        let known = Known {
            damping: spread(k, 2.0, [0.02, 0.3]),
            restitution: spread(k, 3.0, [0.05, 0.6]),
            amplitude: spread(k, 5.0, [1.1, 6.0]),
            omega: spread(k, 7.0, [0.2, 0.9]),
        };
        let Known { damping, restitution, amplitude, omega } = known;
        let oscillator = LinearOscillator::new(damping, restitution, amplitude, omega).unwrap();
        let [x, phase] = [spread(k, 11.0, [-2.0, -0.1]), spread(k, 13.0, [0.0, TAU])];
        let horizon = 4.0 * oscillator.forcing_period();
        let found = events(&oscillator, State::at_rest(x, phase), horizon);
        let expected = known.events([x, 0.0, phase], horizon);
        // Impacts too slow to be followed are in one of the lists only.
        let fast = |event: &&Event| !matches!(event, Event::Impact { velocity, .. } if *velocity < 1e-2);
        // Errors grow from impact to impact, most at slow ones that the force does not press; a rest
        // ends them.
        let mut growth = 1.0;
        for (a, b) in found.iter().filter(fast).zip(expected.iter().filter(fast)) {
            let (a, b) = match (a, b) {
                (Event::Impact { time: a, velocity: v }, Event::Impact { time: b, velocity: w }) => {
                    impacts += 1;
                    growth *= 1.0 + 1.0 / w;
                    assert!((v - w).abs() < 1e-9 * growth, "{known:?}: {a} {b}, {v} {w}");
                    (a, b)
                }
                (Event::Stick(a), Event::Stick(b)) => {
                    // The force a changes by the share of 1/a² · 10⁻⁶ during the series that takes 1/a · 10⁻⁶.
                    let force = known.force(phase + omega * b);
                    let geometric = 1e-11 / (force * force * force);
                    assert!((a - b).abs() < 1e-9 + geometric, "{known:?}: {a} {b}");
                    continue;
                }
                (Event::Release(a), Event::Release(b)) => {
                    growth = 1.0;
                    rests += 1;
                    (a, b)
                }
                _ => panic!("{known:?} from {x}, {phase}: {found:?}\n{expected:?}"),
            };
            assert!((a - b).abs() < 1e-9, "{known:?}: {a} {b}");
        }
    }
    assert!(rests > 2000 && impacts > 10_000, "{rests} {impacts}");
}

#[test]
fn the_oscillator_of_the_report_has_its_impacts_and_rests_in_every_period() {
    // ẍ = −0.1ẋ − x − 1 + 5 cos ωt, r = 0.3 at ω = 0.5: impacts that were found by a program of another hand.
    let oscillator = LinearOscillator::new(0.05, 0.3, 5.0, 0.5).unwrap();
    let period = oscillator.forcing_period();
    let flights: Vec<_> = Orbit::new(&oscillator, State::at_rest(-1.0, 1.0), 20.0 * period, 10_000).collect();
    let last = flights.iter().rposition(|flight| flight.rest.is_some()).unwrap();
    let first = flights[..last].iter().rposition(|flight| flight.rest.is_some()).unwrap();
    let reported = [(5.4530, 0.7654), (2.7721, 0.9152), (0.8550, 0.9522), (0.2573, 0.9629)];
    for (flight, (velocity, turns)) in flights[first..last].iter().zip(reported) {
        let FlightEnd::Impact(impact) = flight.end else { panic!("{flight:?}") };
        assert!((impact.velocity - velocity).abs() < 5e-5, "{impact:?}");
        let phase = turned(impact.phase) / TAU;
        assert!((phase - turns).abs() < 5e-5, "{phase} {impact:?}");
    }
    let rest = flights[last].rest.unwrap();
    assert!(rest.accumulated && (flights[last].start - flights[first].start - period).abs() < 1e-11);
    // The force turns where 5 cos z = 1.
    assert!((flights[last].from.phase - libm::acos(0.2)).abs() < 1e-14);
}

/// A ball under a force g + 𝒜 cos ωt towards the wall, whose impacts are in contact for a while.
#[derive(Clone, Debug)]
struct Ball {
    weight: f64,
    restitution: f64,
    contact: f64,
}

impl SmoothOscillator for Ball {
    fn force<S: Scalar>(&self, _: S, _: S, t: S, amplitude: S, omega: S) -> S {
        amplitude * (omega * t).apply(Function::Cos) + S::constant(self.weight)
    }

    fn forcing_frequency<S: Scalar>(&self, _: S, omega: S) -> S {
        omega
    }

    fn restitution<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
        S::constant(self.restitution)
    }

    fn impact_duration<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
        S::constant(self.contact)
    }
}

#[test]
fn a_ball_under_its_weight_comes_to_rest_when_the_geometric_series_says() {
    let (weight, omega, velocity) = (2.0, 0.7, 0.9);
    for (restitution, contact) in [(0.05, 0.0), (0.5, 0.0), (0.9, 0.0), (0.5, 0.3), (0.99, 0.1), (0.999, 0.0)]
    {
        let ball = Integrated::new(Ball { weight, restitution, contact }, [0.0, omega]);
        let end = Orbit::new(&ball, State::on_wall(velocity, 0.4), 2e3, usize::MAX).finish();
        let OrbitEnd::Resting { rest, held } = end else { panic!("{end:?}") };
        // Contact, and flight after it, of impacts of velocities v, rv, r²v, …
        let first = contact * velocity / omega + 2.0 * restitution * velocity / weight;
        let expected = first / (1.0 - restitution);
        assert!(held && rest.accumulated, "{rest:?}");
        // Errors of a velocity, some 10⁻¹⁴ as of the integration, add up over the sequence.
        let within = 1e-12 / (1.0 - restitution) / (1.0 - restitution);
        assert!((rest.start - expected).abs() < within, "{restitution}: {} {expected}", rest.start);
        assert_eq!(rest.start + rest.duration, 2e3);
    }
}

#[test]
fn a_plastic_impact_sticks_at_once_if_pressed_and_leaves_at_once_if_not() {
    let (weight, amplitude, omega) = (0.5, 2.0, 0.8);
    let ball = Integrated::new(Ball { weight, restitution: 0.0, contact: 0.0 }, [amplitude, omega]);
    let end = libm::acos(-0.25);
    // Pressed at phase 0: the flight begins where the force turns.
    let flight = Orbit::new(&ball, State::on_wall(0.9, 0.0), 5.0, 10).next().unwrap();
    let rest = flight.rest.unwrap();
    assert_eq!((rest.start, rest.phase, rest.accumulated), (0.0, 0.0, false));
    assert!((rest.duration * omega - end).abs() < 1e-14 && (flight.start - rest.duration).abs() < 1e-14);
    // The position at a time after the release.
    let at = |from: f64, t: f64| {
        let turn = omega * t;
        0.5 * weight * t * t
            - amplitude / (omega * omega)
                * (libm::cos(from + turn) - libm::cos(from) + turn * libm::sin(from))
    };
    for (phase, flights) in [(end, 1), (2.0, 2), (3.0, 2)] {
        let found: Vec<_> = Orbit::new(&ball, State::on_wall(0.7, phase), 40.0, 10).take(flights).collect();
        assert!(found[0].rest.is_none() && found[0].start == 0.0, "{phase}");
        for flight in &found {
            let FlightEnd::Impact(impact) = flight.end else { panic!("{phase}: it falls back") };
            // Integration, over some hundred.
            let there = at(flight.from.phase, flight.duration);
            assert!(there.abs() < 1e-11 && impact.velocity > 1e-3, "{phase}: {there} {impact:?}");
        }
    }
}

#[test]
fn release_is_the_first_change_of_sign_however_short_the_force_turns() {
    for k in 1..=200 {
        let amplitude = spread(k, 2.0, [1.0001, 9.0]);
        let oscillator = LinearOscillator::new(0.1, 0.5, amplitude, spread(k, 3.0, [0.1, 2.0])).unwrap();
        let end = libm::acos(1.0 / amplitude);
        // From any pressed phase.
        let from = end * spread(k, 5.0, [-1.0, 1.0]);
        let found = release(&oscillator, from).unwrap();
        // The rounding of the force, over its slope.
        assert!((found - end).abs() < 1e-14 + 1e-15 / libm::sin(end), "{amplitude}: {found} {end}");
        assert_eq!(release(&oscillator, end + 1e-3), Some(end + 1e-3));
    }
    // The force turns around phase π for a short while, or not at all.
    for (amplitude, turns) in [(1.0 + 1e-9, true), (1.0 - 1e-9, false)] {
        let ball = Integrated::new(Ball { weight: 1.0, restitution: 0.5, contact: 0.0 }, [amplitude, 0.5]);
        let found = release(&ball, 0.3);
        assert_eq!(found.is_some(), turns, "{amplitude}");
        let expected = libm::acos(-1.0 / amplitude);
        // The slope there is 4 · 10⁻⁵.
        assert!(found.is_none_or(|found| (found - expected).abs() < 1e-10), "{found:?} {expected}");
    }
}
