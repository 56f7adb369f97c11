//! Motion between two stops, compared with a simulation in closed form that shares no code with the orbits.

use core::f64::consts::TAU;

use grazing_description::Description;
use grazing_model::orbit::{FlightEnd, Orbit};
use grazing_model::{AnyOscillator, ImpactOscillator, State};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

/// The oscillator ẍ + 2ζẋ + x = load + A cos ωt between an upper stop at `upper` and a lower one at
/// −lower + b cos ωt, with a restitution for each.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Linear {
    damping: f64,
    load: f64,
    amplitude: f64,
    omega: f64,
    upper: f64,
    lower: f64,
    shaken: f64,
    restitutions: [f64; 2],
}

/// An impact: time, relative velocity, and whether it is at the upper stop.
pub(crate) type Hit = (f64, f64, bool);

/// Velocity below which an impact is too near to grazing, or to the end of a sequence of impacts.
const SLOW: f64 = 0.03;

impl Linear {
    /// Position and velocity a time after (x, v) at phase z, the stops ignored.
    fn flow(&self, [x, v, z]: [f64; 3], t: f64) -> [f64; 2] {
        let (d, omega) = (self.damping, self.omega);
        let [real, imaginary] = [1.0 - omega * omega, 2.0 * d * omega];
        let [c, s] =
            [real, imaginary].map(|part| self.amplitude * part / (real * real + imaginary * imaginary));
        let forced = |phase: f64| {
            let [cos, sin] = [libm::cos(phase), libm::sin(phase)];
            [c * cos + s * sin + self.load, omega * (s * cos - c * sin)]
        };
        let ([x0, v0], [x1, v1]) = (forced(z), forced(z + omega * t));
        let (w, decay) = ((1.0 - d * d).sqrt(), libm::exp(-d * t));
        let (a, b) = (x - x0, (v - v0 + d * (x - x0)) / w);
        let [cos, sin] = [libm::cos(w * t), libm::sin(w * t)];
        let free = [a * cos + b * sin, b * w * cos - a * w * sin - d * (a * cos + b * sin)];
        [x1 + decay * free[0], v1 + decay * free[1]]
    }

    /// Position and velocity of the lower stop at a phase.
    fn floor(&self, phase: f64) -> [f64; 2] {
        let [cos, sin] = [libm::cos(phase), libm::sin(phase)];
        [-self.lower + self.shaken * cos, -self.shaken * self.omega * sin]
    }

    /// How far the motion is beyond the upper and beyond the lower stop after a time.
    fn beyond(&self, from: [f64; 3], t: f64) -> [f64; 2] {
        let [x, _] = self.flow(from, t);
        [x - self.upper, self.floor(from[2] + self.omega * t)[0] - x]
    }

    /// The first time at which a stop is reached, and whether it is the upper one: steps so short that no
    /// impact is faster, and bisection. A stop that is just left must be left first.
    fn first(&self, from: [f64; 3], left: Option<bool>, longest: f64) -> Option<(f64, bool)> {
        const STEP: f64 = 1e-3;
        let mut away = [left != Some(true), left != Some(false)];
        let mut t = 0.0;
        while t < longest {
            let next = t + STEP;
            let there = self.beyond(from, next);
            for (k, upper) in [(0, true), (1, false)] {
                if away[k] && there[k] > 0.0 {
                    let (mut low, mut high) = (t, next);
                    for _ in 0..80 {
                        let middle = 0.5 * (low + high);
                        if self.beyond(from, middle)[k] > 0.0 { high = middle } else { low = middle }
                    }
                    return Some((high, upper));
                }
                away[k] |= there[k] < 0.0;
            }
            t = next;
        }
        None
    }

    /// The impacts up to a time, or up to one that is slow; and the state at that time, unless one is.
    pub(crate) fn impacts(&self, mut from: [f64; 3], longest: f64) -> (Vec<Hit>, Option<[f64; 2]>) {
        let (mut time, mut hits, mut left) = (0.0, Vec::new(), None);
        while let Some((after, upper)) = self.first(from, left, longest - time) {
            let [x, v] = self.flow(from, after);
            let phase = from[2] + self.omega * after;
            let [_, floor] = self.floor(phase);
            time += after;
            let (wall, speed) = if upper { (0.0, v) } else { (floor, floor - v) };
            hits.push((time, speed, upper));
            if speed < SLOW {
                return (hits, None);
            }
            let back = self.restitutions[usize::from(!upper)] * speed;
            from = [x, if upper { wall - back } else { wall + back }, phase];
            left = Some(upper);
        }
        (hits, Some(self.flow(from, longest - time)))
    }

    /// The oscillator as a file describes it, with one stop or the other first.
    pub(crate) fn description(&self, upper_first: bool) -> Description {
        let Self { damping, load, upper, lower, shaken, restitutions: [r, s], .. } = self;
        let upper = format!("[[walls]]\nposition = \"{upper}\"\nside = \"below\"\nrestitution = \"{r}\"\n");
        let lower = format!(
            "[[walls]]\nposition = \"-{lower} + {shaken}*cos(omega*t)\"\nrestitution = \"{s}\"\nduration = \"0\"\n"
        );
        let walls = if upper_first { upper + &lower } else { lower + &upper };
        let text = format!(
            "name = \"two stops\"\n[parameters]\n[primary]\nname = \"A\"\nrange = [0.0, 3.0]\n[secondary]\nname = \"omega\"\n\
             range = [0.4, 2.5]\n[motion]\nforce = \"-2*{damping}*v - x + ({load}) + A*cos(omega*t)\"\nfrequency = \"omega\"\n\
             {walls}[impact]\nrestitution = \"0.1\"\nduration = \"0\"\n[analysis]\nloops = [1, 2]\n"
        );
        Description::parse(&text, "two stops").unwrap_or_else(|error| panic!("{error}\n{text}"))
    }

    /// The oscillator, seen from one stop or from the other, in the units of the file.
    pub(crate) fn oscillator(&self, upper_first: bool) -> AnyOscillator {
        self.description(upper_first).oscillator([self.amplitude, self.omega])
    }

    /// A state as the first stop sees it.
    pub(crate) fn seen(&self, [x, v, z]: [f64; 3], upper_first: bool) -> State {
        let [floor, rate] = self.floor(z);
        match upper_first {
            true => State { position: x - self.upper, velocity: v, phase: z },
            false => State { position: floor - x, velocity: rate - v, phase: z },
        }
    }

    /// An oscillator and a state between its stops.
    pub(crate) fn random(random: &mut Pcg64) -> (Self, [f64; 3]) {
        let mut within = |low: f64, high: f64| low + (high - low) * uniform(random);
        let oscillator = Self {
            damping: within(0.01, 0.2),
            load: within(-0.5, 0.5),
            amplitude: within(0.3, 3.0),
            omega: within(0.4, 2.5),
            upper: within(0.3, 1.5),
            lower: within(0.3, 1.5),
            shaken: if within(0.0, 1.0) < 0.5 { 0.0 } else { within(0.01, 0.2) },
            restitutions: [within(0.2, 0.95), within(0.2, 0.95)],
        };
        let phase = within(0.0, TAU);
        let [floor, _] = oscillator.floor(phase);
        let x = floor + (oscillator.upper - floor) * within(0.02, 0.98);
        (oscillator, [x, within(-1.0, 1.0), phase])
    }
}

pub(crate) fn uniform(random: &mut Pcg64) -> f64 {
    (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}

#[test]
fn impacts_at_both_stops_come_when_and_where_the_closed_form_has_them() {
    let mut random = Pcg64::new(20_261_128, 47);
    let (mut compared, mut at, mut ends, mut worst) = (0, [0; 2], 0, 0.0_f64);
    for number in 0..1000 {
        let (known, from) = Linear::random(&mut random);
        let upper_first = number % 2 == 0;
        let oscillator = known.oscillator(upper_first);
        let longest = 4.0 * TAU / known.omega;
        let (hits, end) = known.impacts(from, longest);
        let mut orbit = Orbit::new(&oscillator, known.seen(from, upper_first), longest, 100_000);
        // Motion amplifies rounding and the error of integration, some 1e-13, from impact to impact: more than
        // a thousandfold within a few where one is slow, which ends the comparison.
        let mut amplified = 1.0;
        for (k, &(time, speed, upper)) in hits.iter().enumerate() {
            amplified *= 1.0 + 1.0 / speed;
            if amplified > 1e4 || speed < SLOW {
                break;
            }
            let flight =
                orbit.next().unwrap_or_else(|| panic!("{number}: impact {k} is missing: {known:?} {from:?}"));
            let FlightEnd::Impact(impact) = flight.end else {
                panic!("{number}: no impact {k}: {known:?} {from:?}")
            };
            let there = flight.start + flight.duration;
            assert_eq!(flight.stop == 0, upper == upper_first, "{number}, impact {k}: {known:?} {from:?}");
            worst = worst.max((there - time).abs()).max((impact.velocity - speed).abs());
            assert!(
                (there - time).abs() < 1e-9,
                "{number}, impact {k}: {there} for {time}: {known:?} {from:?}"
            );
            assert!(
                (impact.velocity - speed).abs() < 1e-8,
                "{number}, impact {k}: {} for {speed}",
                impact.velocity
            );
            compared += 1;
            at[usize::from(!upper)] += 1;
            if k + 1 == hits.len()
                && let Some([x, v]) = end
                && let Some(last) = orbit.next()
                && let FlightEnd::TimeIsUp(state) = last.end
            {
                let there = known.seen([x, v, from[2] + known.omega * longest], upper_first);
                assert!((state.position - there.position).abs() < 1e-8, "{number}: {state:?} for {there:?}");
                assert!((state.velocity - there.velocity).abs() < 1e-8, "{number}: {state:?} for {there:?}");
                ends += 1;
            }
        }
    }
    assert!(
        compared > 3000 && at.iter().all(|count| *count > 1000) && ends > 100,
        "{compared} {at:?} {ends} {worst}"
    );
}

#[test]
fn both_views_of_an_oscillator_lead_back_to_each_other() {
    let mut random = Pcg64::new(3, 47);
    for _ in 0..50 {
        let (known, from) = Linear::random(&mut random);
        let [upper, lower] = [true, false].map(|first| known.oscillator(first));
        let other = upper.other_stop().expect("there are two stops");
        let (state, seen) = (known.seen(from, true), known.seen(from, false));
        let across = upper.across(state);
        // Differences of numbers of order one.
        assert!(
            (across.position - seen.position).abs() < 1e-14
                && (across.velocity - seen.velocity).abs() < 1e-14
        );
        assert!((other.acceleration(across) - lower.acceleration(seen)).abs() < 1e-13);
        let back = other.across(across);
        assert!(
            (back.position - state.position).abs() < 1e-14 && (back.velocity - state.velocity).abs() < 1e-14
        );
        let again = other.other_stop().expect("there are two stops");
        assert_eq!(again.acceleration(state), upper.acceleration(state));
    }
}
