//! Motion between two stops, compared with a simulation in closed form that shares no code with the orbits.

use core::f64::consts::TAU;

use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns};
use grazing_input::Description;
use grazing_model::orbit::{FlightEnd, Orbit};
use grazing_model::{AnyOscillator, ImpactOscillator, OnWall, State};
use grazing_unfold::long_time::{Horizon, LongOrbit};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

/// The oscillator ẍ + 2ζẋ + x = load + A cos ωt between an upper stop at `upper` and a lower one at
/// −lower + b cos ωt, with a restitution for each.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Linear {
    pub(crate) damping: f64,
    pub(crate) load: f64,
    pub(crate) amplitude: f64,
    pub(crate) omega: f64,
    pub(crate) upper: f64,
    pub(crate) lower: f64,
    pub(crate) shaken: f64,
    pub(crate) restitutions: [f64; 2],
}

/// An impact: time, relative velocity, and whether it is at the upper stop.
pub(crate) type Hit = (f64, f64, bool);

/// Velocity below which an impact is too near to grazing, or to the end of a sequence of impacts.
const SLOW: f64 = 0.03;

impl Linear {
    /// Position and velocity a time after (x, v) at phase z, the stops ignored.
    pub(crate) fn flow(&self, [x, v, z]: [f64; 3], t: f64) -> [f64; 2] {
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
    pub(crate) fn floor(&self, phase: f64) -> [f64; 2] {
        let [cos, sin] = [libm::cos(phase), libm::sin(phase)];
        [-self.lower + self.shaken * cos, -self.shaken * self.omega * sin]
    }

    /// How far the motion is beyond the upper and beyond the lower stop after a time.
    fn beyond(&self, from: [f64; 3], t: f64) -> [f64; 2] {
        let [x, _] = self.flow(from, t);
        [x - self.upper, self.floor(from[2] + self.omega * t)[0] - x]
    }

    /// The first time at which a stop is reached, and whether it is the upper one: steps shorter
    /// than any way beyond a stop and back with a velocity above `SLOW`, and bisection. A stop that is just left must be left first.
    fn first(&self, from: [f64; 3], left: Option<bool>, longest: f64) -> Option<(f64, bool)> {
        const STEP: f64 = 3e-3;
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

/// A symmetric oscillator between stops at ±1 with one restitution; the amplitude does not matter.
pub(crate) fn symmetric(random: &mut Pcg64) -> Linear {
    let mut within = |low: f64, high: f64| low + (high - low) * uniform(random);
    let restitution = within(0.4, 0.95);
    Linear {
        damping: within(0.01, 0.15),
        load: 0.0,
        amplitude: 1.0,
        omega: within(0.5, 1.8),
        upper: 1.0,
        lower: 1.0,
        shaken: 0.0,
        restitutions: [restitution; 2],
    }
}

/// Symmetric motion with one impact at each stop in a forcing period, in closed form: at the upper stop
/// velocity y and phase z, half a period later its mirror image at the lower one.
///
/// S. W. Shaw and P. J. Holmes, A periodically forced piecewise linear oscillator, J. Sound Vib. 90, 129-155,
/// 1983, and F. Peterka, Laws of impact motion of mechanical systems with one degree of freedom, Acta Technica
/// CSAV 4, 462-473 and 5, 569-580, 1974, have it in other notation. With the free part f of the motion and its
/// flow M over half a period, f(h) = −f(0) and f'(h) = K f'(0), so that f is proportional to y; the forced part is
/// what is left of x and x' at the impact, and on an ellipse.
pub(crate) struct Mirrored {
    /// f(0) = `free` y and P'(0) = `forced` y.
    pub(crate) free: f64,
    pub(crate) forced: f64,
    /// The flow of free motion over half a period.
    flow: [[f64; 2]; 2],
}

impl Linear {
    pub(crate) fn mirrored(&self) -> Mirrored {
        let (d, h) = (self.damping, core::f64::consts::PI / self.omega);
        let (w, decay) = ((1.0 - d * d).sqrt(), libm::exp(-d * h));
        let [cos, sin] = [libm::cos(w * h), libm::sin(w * h)];
        let flow =
            [[decay * (cos + d * sin / w), decay * sin / w], [-decay * sin / w, decay * (cos - d * sin / w)]];
        let k = flow[1][1] - flow[0][1] * flow[1][0] / (1.0 + flow[0][0]);
        let r = self.restitutions[0];
        let speed = -(1.0 + r) / (1.0 + k);
        Mirrored { free: -flow[0][1] * speed / (1.0 + flow[0][0]), forced: -r - speed, flow }
    }

    /// The amplitude of the forced motion for an amplitude of one.
    pub(crate) fn response(&self) -> f64 {
        let omega = self.omega;
        1.0 / libm::hypot(1.0 - omega * omega, 2.0 * self.damping * omega)
    }

    /// The impact (y, z) at an impact velocity, with the amplitude at which it is one.
    pub(crate) fn with_velocity(&self, of: &Mirrored, y: f64) -> (Self, f64) {
        let [p, slope] = [1.0 - of.free * y, of.forced * y / self.omega];
        let here = Self { amplitude: libm::hypot(p, slope) / self.response(), ..*self };
        // P = c cos z + s sin z and P'/ω = s cos z − c sin z.
        let omega = self.omega;
        let [real, imaginary] = [1.0 - omega * omega, 2.0 * self.damping * omega];
        let [c, s] =
            [real, imaginary].map(|part| here.amplitude * part / (real * real + imaginary * imaginary));
        (here, libm::atan2(s * p - c * slope, c * p + s * slope))
    }

    /// The derivative of (y, z) to the next impact, half a period later and mirrored.
    pub(crate) fn half_derivative(&self, of: &Mirrored, [y, z]: [f64; 2]) -> [[f64; 2]; 2] {
        let r = self.restitutions[0];
        let force = |v: f64| -2.0 * self.damping * v - 1.0 + self.amplitude * libm::cos(z);
        let [before, after] = [force(y), force(-r * y)];
        let column = |dy: f64, dz: f64| {
            let late = dz / self.omega;
            let [dx, dv] = [r * y * late, -r * dy - after * late];
            let x = of.flow[0][0] * dx + of.flow[0][1] * dv;
            let v = of.flow[1][0] * dx + of.flow[1][1] * dv;
            // At the lower stop everything has the other sign.
            let [x, v] = [-x, -v];
            let late = -x / y;
            [v + before * late, self.omega * late]
        };
        let [a, b] = [column(1.0, 0.0), column(0.0, 1.0)];
        [[a[0], b[0]], [a[1], b[1]]]
    }
}

fn mixed(oscillator: &AnyOscillator) -> LoopEquations {
    LoopEquations::new(oscillator.clone(), 1, Formulation::FixedPhase).at_stops([0, 1])
}

#[test]
fn symmetric_motion_with_an_impact_at_each_stop_is_that_of_its_closed_form() {
    let mut random = Pcg64::new(1983, 47);
    let (mut found, mut stable, mut pitchforks) = (0, 0, 0);
    for number in 0..300 {
        let known = symmetric(&mut random);
        let of = known.mirrored();
        let y = 0.2 + 1.8 * uniform(&mut random);
        let (here, z) = known.with_velocity(&of, y);
        // The closed form is motion that stays between the stops.
        let (hits, _) = here.impacts([1.0, -here.restitutions[0] * y, z], 0.5 * TAU / here.omega + 1e-6);
        let [(time, speed, false)] = hits[..] else { continue };
        if (time - 0.5 * TAU / here.omega).abs() > 1e-9 || here.amplitude > 3.0 {
            continue;
        }
        assert!((speed - y).abs() < 1e-9, "{number}: {speed} for {y}");
        found += 1;
        let oscillator = here.oscillator(true);
        let impacts = [OnWall::new(y, z), OnWall::new(y, z + 0.5 * TAU)];
        let equations = mixed(&oscillator);
        let near = Unknowns::of_impacts(&impacts, [here.amplitude, here.omega]);
        let held = [Condition::Primary(here.amplitude), Condition::Secondary(here.omega)];
        let point = locate(&equations, held, near.clone(), &mut EventTimes::default()).expect("it is there");
        assert!((&point - &near).norm() < 1e-8, "{number}: {point:?} for {near:?}");
        let solution = equations.solution(&point);
        assert!(solution.admissible(), "{number}: {solution:?}");
        let [[a, b], [c, d]] = here.half_derivative(&of, [y, z]);
        let (trace, determinant) = (a + d, a * d - b * c);
        let whole = [trace * trace - 2.0 * determinant, determinant * determinant];
        let scale = 1.0 + trace * trace;
        let seen = solution.multipliers;
        // Multipliers are as exact as the flow, some 1e-12, times their size.
        assert!((seen.trace - whole[0]).abs() < 1e-8 * scale, "{number}: {seen:?} for {whole:?}");
        assert!((seen.determinant - whole[1]).abs() < 1e-8 * scale, "{number}: {seen:?} for {whole:?}");
        // The same from the equations of two impacts, which know of no symmetry.
        let maps = equations.maps::<1>(&point, &mut EventTimes::default()).expect("they are defined");
        assert!(
            (maps.multipliers().trace - whole[0]).abs() < 1e-8 * scale,
            "{number}: {:?}",
            maps.multipliers()
        );
        let clear = trace.abs() < 0.95 * (1.0 + determinant) && determinant < 0.9;
        if clear {
            stable += 1;
            let from = here.seen([1.0, -here.restitutions[0] * y + 1e-3, z], true);
            let orbit =
                LongOrbit::follow(&oscillator, State { position: 0.0, ..from }, Horizon::drifting(200, 32));
            assert_eq!(orbit.fate.numbers(), Some((2, 1)), "{number}: {:?} {here:?}", orbit.fate);
            assert_eq!(orbit.fate.second, 1.0, "{number}: {:?}", orbit.fate);
            assert!(orbit.impacts.iter().all(|hit| (hit.impact[0] - y).abs() < 1e-7), "{number}");
        }
        // A pitchfork in the amplitude is where the multiplier over half a period is -1: 1 + T + D = 0, by
        // bisection in the velocity.
        let broken = |y: f64| {
            let (here, z) = known.with_velocity(&of, y);
            let [[a, b], [c, d]] = here.half_derivative(&of, [y, z]);
            1.0 + a + d + a * d - b * c
        };
        let (mut low, mut high) = (0.9 * y, 1.1 * y);
        if broken(low) * broken(high) < 0.0 {
            let sign = broken(low);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if broken(middle) * sign > 0.0 { low = middle } else { high = middle }
            }
            let conditions = [Condition::SymmetryBreaking, Condition::Secondary(here.omega)];
            let at = locate(&equations, conditions, point, &mut EventTimes::default()).expect("it is there");
            let (there, _) = known.with_velocity(&of, low);
            assert!((at[0] - low).abs() < 1e-8, "{number}: {at:?} for {low}");
            assert!((at[2] - there.amplitude).abs() < 1e-8, "{number}: {at:?} for {}", there.amplitude);
            pitchforks += 1;
        }
    }
    assert!(found > 60 && stable > 20 && pitchforks > 5, "{found} {stable} {pitchforks}");
}

#[test]
fn the_fold_of_symmetric_motion_is_where_the_closed_form_has_its_least_amplitude() {
    let mut random = Pcg64::new(1974, 47);
    let mut found = 0;
    for number in 0..60 {
        let known = symmetric(&mut random);
        let of = known.mirrored();
        // The amplitude is a root of a quadratic in y, least at its vertex.
        let slope = of.forced / known.omega;
        let y = of.free / (of.free * of.free + slope * slope);
        if !(0.05..3.0).contains(&y) {
            continue;
        }
        let (here, z) = known.with_velocity(&of, y);
        let equations = mixed(&here.oscillator(true));
        let (beside, turned) = known.with_velocity(&of, 1.02 * y);
        let impacts = [0.0, 0.5 * TAU].map(|later| OnWall::new(1.02 * y, turned + later));
        let near = Unknowns::of_impacts(&impacts, [beside.amplitude, here.omega]);
        let conditions = [Condition::SADDLE_NODE, Condition::Secondary(here.omega)];
        let Ok(fold) = locate(&equations, conditions, near, &mut EventTimes::default()) else { continue };
        if (fold[0] - y).abs() > 0.1 * y {
            continue;
        }
        assert!((fold[2] - here.amplitude).abs() < 1e-9, "{number}: {fold:?} for {}", here.amplitude);
        assert!(
            (fold[0] - y).abs() < 1e-6 && libm::remainder(fold[1] - z, TAU).abs() < 1e-6,
            "{number}: {fold:?}"
        );
        found += 1;
    }
    assert!(found > 10, "{found}");
}
