//! The examples with two walls, and that of a ball on a table, against motion that is known in closed form, or
//! integrated by a program that shares no code with ours.

use core::f64::consts::{PI, TAU};

use grazing_continuation::bifurcation::Bifurcation;
use grazing_input::Description;
use grazing_model::orbit::{FlightEnd, Orbit, OrbitEnd};
use grazing_model::smooth::Stop;
use grazing_model::{AnyOscillator, ImpactOscillator, State};
use grazing_results::plane::PlanePoint;
use grazing_unfold::described::Prepared;
use grazing_unfold::long_time::{Horizon, LongOrbit, MotionKind};
use grazing_unfold::one_parameter::requested::SAMPLING;
use grazing_unfold::one_parameter::{Cut, Line, Sampling};
use grazing_unfold::place::{Place, Starts};
use grazing_unfold::progress::Silent;
use grazing_unfold::unfolded::Unfolded;

macro_rules! example {
    ($name:literal) => {
        Description::parse(include_str!(concat!("../../../../examples/", $name)), $name)
            .unwrap_or_else(|error| panic!("{error}"))
    };
}

fn constant(of: &Description, name: &str) -> f64 {
    of.constants().find(|(known, _)| *known == name).unwrap_or_else(|| panic!("{name}")).1
}

/// The rows of the curves of a kind in the plane of an example.
fn rows(of: &Description, kind: Bifurcation) -> Vec<PlanePoint> {
    let found = Unfolded::described(of, &Silent, &Stop::default(), &|_| ()).expect("there are curves");
    let mut rows = found.plane_diagram().curves;
    rows.retain(|row| row.kind == kind);
    rows
}

#[track_caller]
fn assert_near(found: f64, known: f64, relative: f64) {
    assert!((found / known - 1.0).abs() < relative, "{found:e} instead of {known:e}");
}

/// Motion u'' + 2du' + ku = F cos ωt between walls at u = ±1 with restitution r: one impact at either in a forcing
/// period, half a period apart, the second the mirror image of the first.
///
/// Its free part f, with the flow M over half a period h = π/ω, has f(h) = −f(0) and f'(h) = K f'(0),
/// K = M₁₁ − M₁₀M₀₁/(1 + M₀₀). The forced part P has P(h) = −P(0), P'(h) = −P'(0). At the upper wall u' jumps from y to −ry, and at
/// the lower one half a period later it arrives with −y: f'(0) + P'(0) = −ry, K f'(0) − P'(0) = −y. So all is
/// proportional to y: f(0) = φy, P'(0) = ψy, and P(0) = 1 − φy; P is the forced motion if
///
/// (F/R)² = (1 − φy)² + (ψy/ω)², R² = (k − ω²)² + (2dω)².
///
/// Over half a period, seen in the mirror, (y, z) is led to (y, z) with a derivative of determinant D = r² e^(−2dh) and trace
/// T = r (M₀₀ + M₁₁) − M₀₁ (1 + r) (F cos z − k)/y, where F cos z = P'' + 2dP' + kP = (k − ω²)(1 − φy) + 2dψy. Hence
///
/// - saddle-node, 1 − T + D = 0: where F is least, y = φ/(φ² + (ψ/ω)²), if φ > 0;
/// - pitchfork, 1 + T + D = 0: y = −M₀₁ (1 + r) ω² / (1 + D + r (M₀₀ + M₁₁) − M₀₁ (1 + r) (2dψ − (k − ω²)φ));
/// - no period doubling: the multipliers over a period are squares of those over half of it, and −1 is one of i and −i, whose
///   product is 1, not D < 1.
///
/// In other notation these are in S. W. Shaw and P. J. Holmes (1983), S. W. Shaw (1985) and F. Peterka (1974), and for a
/// container that moves, with k = 0, in S. F. Masri and T. K. Caughey (1966) and C. N. Bapat et al. (1983).
struct Mirrored {
    damping: f64,
    stiffness: f64,
    restitution: f64,
    omega: f64,
    flow: [[f64; 2]; 2],
    phi: f64,
    psi: f64,
}

impl Mirrored {
    fn new([damping, stiffness, restitution]: [f64; 3], omega: f64) -> Self {
        let (d, h, w) = (damping, PI / omega, (stiffness - damping * damping).sqrt());
        let [cos, sin] = [libm::cos(w * h), libm::sin(w * h) / w];
        let flow = [[cos + d * sin, sin], [-stiffness * sin, cos - d * sin]]
            .map(|row| row.map(|entry| libm::exp(-d * h) * entry));
        let k = flow[1][1] - flow[1][0] * flow[0][1] / (1.0 + flow[0][0]);
        let begins = -(1.0 + restitution) / (1.0 + k);
        let phi = -flow[0][1] * begins / (1.0 + flow[0][0]);
        Self { damping, stiffness, restitution, omega, flow, phi, psi: -restitution - begins }
    }

    /// The amplitude F at an impact velocity.
    fn amplitude(&self, y: f64) -> f64 {
        let [k, d, omega] = [self.stiffness, self.damping, self.omega];
        let response = 1.0 / libm::hypot(k - omega * omega, 2.0 * d * omega);
        libm::hypot(1.0 - self.phi * y, self.psi * y / omega) / response
    }

    /// Trace and determinant over half a period at an impact velocity.
    fn half(&self, y: f64) -> [f64; 2] {
        let Self { damping: d, stiffness: k, restitution: r, omega, flow: m, phi, psi } = self;
        let pull = (k - omega * omega) * (1.0 - phi * y) + 2.0 * d * psi * y - k;
        let trace = r * (m[0][0] + m[1][1]) - m[0][1] * (1.0 + r) * pull / y;
        [trace, r * r * libm::exp(-2.0 * d * PI / omega)]
    }

    fn saddle_node(&self) -> f64 {
        self.phi / (self.phi * self.phi + self.psi * self.psi / (self.omega * self.omega))
    }

    fn pitchfork(&self) -> f64 {
        let Self { damping: d, stiffness: k, restitution: r, omega, flow: m, phi, psi } = self;
        let [_, determinant] = self.half(1.0);
        let squared = omega * omega;
        let below = 1.0 + determinant + r * (m[0][0] + m[1][1])
            - m[0][1] * (1.0 + r) * (2.0 * d * psi - (k - squared) * phi);
        -m[0][1] * (1.0 + r) * squared / below
    }
}

/// Compares saddle-node and pitchfork of a one-parameter diagram at a secondary parameter, and the motion between them, with the
/// closed form, whose amplitude F is `forced` times the primary parameter.
fn assert_mirrored(of: &Description, constants: [f64; 3], at: f64, forced: f64) {
    let known = Mirrored::new(constants, at);
    let [fold, fork] = [known.saddle_node(), known.pitchfork()];
    // The fold is found twice: from the amplitude, and from the multipliers.
    let [trace, determinant] = known.half(fold);
    assert!((1.0 - trace + determinant).abs() < 1e-12, "{trace} {determinant}");
    let [trace, _] = known.half(fork);
    assert!((1.0 + trace + determinant).abs() < 1e-12, "{trace} {determinant}");

    let prepared = Prepared::of(of, &Stop::default());
    let units = prepared.axes.units;
    let line = Line {
        diagram: 1,
        primary_is_fixed: false,
        at: at / units.secondary,
        range: prepared.scope.window.primary,
    };
    let mut cut =
        Cut::follow(&prepared.oscillator, &prepared.scope, &[], line, &Silent).expect("nobody stops it");
    let sampling = Sampling { values: 24, impacts: 2, ..SAMPLING };
    let found = cut.simulated(&sampling, &[], &Silent);
    let mut seen = [0; 2];
    for row in found.bifurcations.iter().filter(|row| (row.impacts, row.loops) == (2, 1)) {
        let (y, which) = match row.kind {
            Bifurcation::SaddleNode if fold > 0.0 => (fold, 0),
            Bifurcation::Pitchfork => (fork, 1),
            // Solutions that begin at the pitchfork are not symmetric.
            _ => continue,
        };
        // Solutions are as exact as the flow, some 1e-12; at a fold the velocity has half the digits.
        assert_near(row.primary * units.primary, known.amplitude(y) / forced, 1e-9);
        assert_near(row.impact_velocity * units.velocity(), y, 1e-5);
        seen[which] += 1;
    }
    assert_eq!(seen, [usize::from(fold > 0.0), 1], "{:?}", found.bifurcations);
    // From the pitchfork on, to the saddle-node if there is one, symmetric motion attracts some of the random states.
    let speed = if fold > 0.0 { 0.5 * (fold + fork) } else { 1.3 * fork };
    let mu = known.amplitude(speed) / forced;
    let here = prepared.oscillator.with_parameters(prepared.without_dimensions([mu, at]));
    let starts = Starts { states: 12, lattice: [0, 0], ..Starts::default() };
    let place = Place::compute(&here, &prepared.scope, &starts, &Silent).expect("nobody stops it");
    let [y, _] = place
        .attractors
        .iter()
        .find(|one| one.fate.numbers() == Some((2, 1)) && one.fate.second == 1.0)
        .map(|one| one.strikes[0])
        .map(|[phase, speed]| [speed * units.velocity(), phase])
        .expect("it is one of the attractors");
    assert_near(y, speed, 1e-8);
}

#[test]
fn symmetric_motion_between_two_stops_loses_its_symmetry_where_the_closed_form_does() {
    let of = example!("two-stops.toml");
    let [zeta, r] = ["zeta", "r"].map(|name| constant(&of, name));
    assert_mirrored(&of, [zeta, 1.0, r], 0.7, 1.0);
}

#[test]
fn an_impact_damper_folds_and_loses_its_symmetry_where_the_closed_form_does() {
    let of = example!("impact-damper.toml");
    let [zeta, natural, r] = ["zeta", "Omega", "r"].map(|name| constant(&of, name));
    let omega = 1.0;
    // Seen from the container, its inertia is the force.
    assert_mirrored(&of, [zeta * natural, natural * natural, r], omega, omega * omega);
}

/// The tooth rests on the lower flank as long as this does not accelerate away from it faster than the drag
/// does: |W'' + cW'| ≤ T for all times, or aω √(ω² + c²) ≤ T. A rattle with one impact in a period: the tooth flies
/// with x'' = −cx' − T from the velocity V₀ to V₁ and is back after the period τ, so that
/// V₀ + T/c = Tτ/(1 − e^(−cτ)) and V₁ + T/c = e^(−cτ) (V₀ + T/c). With the flank's velocity W' it strikes with y = W' − V₁ and leaves with
/// V₀ − W' = ry: W' = (V₀ + rV₁)/(1 + r), and |W'| ≤ aω, with equality at the saddle-node.
#[test]
fn a_gear_lifts_off_where_inertia_exceeds_the_drag_and_rattles_on_one_flank_from_the_saddle_node_on() {
    let of = example!("gear-backlash.toml");
    let [c, drag, r] = ["c", "T", "r"].map(|name| constant(&of, name));
    let prepared = Prepared::of(&of, &Stop::default());
    for omega in [0.9, 1.2, 1.7] {
        let onset = drag / (omega * libm::hypot(omega, c));
        for (share, rests) in [(0.999, true), (1.001, false)] {
            let here =
                prepared.oscillator.with_parameters(prepared.without_dimensions([share * onset, omega]));
            let [gap, _] = here.gap(0.4);
            let start = State::at_rest(-0.99 * gap.value, 0.4);
            let orbit = LongOrbit::follow(&here, start, Horizon::drifting(100, 20));
            let resting = orbit.fate.kind == MotionKind::Resting;
            assert_eq!(resting, rests, "omega = {omega}, {share} of the onset: {:?}", orbit.fate);
            match Orbit::new(&here, start, 100.0 * TAU, 100_000).finish() {
                OrbitEnd::Resting { rest, held: true } => {
                    assert!(rests && rest.stop == 1, "it is the lower flank: {rest:?}");
                }
                _ => assert!(!rests),
            }
        }
    }
    let folds = rows(&of, Bifurcation::SaddleNode);
    for row in &folds {
        let decay = libm::exp(-c * TAU / row.at.secondary);
        let begins = drag * TAU / row.at.secondary / (1.0 - decay);
        let [before, after] = [begins * decay - drag / c, begins - drag / c];
        assert_near(row.at.primary * row.at.secondary, (after + r * before) / (1.0 + r), 1e-9);
        assert_near(row.at.impact_velocity, (after - before) / (1.0 + r), 1e-6);
        assert_eq!(row.wall, 2);
    }
    assert!(folds.len() > 20, "{}", folds.len());
}

/// Motion with one impact in a period 2π/ω: the flight takes V₀ = −V₁ = πg/ω, so that y = 2πg/(ω(1 + r)) and the velocity
/// of the table is W' = πg(1 − r)/(ω(1 + r)). With the table's acceleration W'' the derivative of (t, y) has the determinant r²
/// and the trace 1 + r² + (1 + r)² W''/g: saddle-node at W'' = 0, period doubling at W'' = −2g(1 + r²)/(1 + r)². Since
/// (W'ω)² + W''² = (aω²)², both are explicit.
///
/// P. J. Holmes (1982); J. M. Luck and A. Mehta (1993).
#[test]
fn a_ball_on_a_shaking_table_bounces_once_a_period_between_the_known_curves() {
    let of = example!("bouncing-ball.toml");
    let [g, r] = [1000.0 * constant(&of, "g"), constant(&of, "r")];
    let slope = PI * (1.0 - r) / (1.0 + r);
    let bent = 2.0 * (1.0 + r * r) / ((1.0 + r) * (1.0 + r));
    let kinds = [(Bifurcation::SaddleNode, slope), (Bifurcation::PeriodDoubling, libm::hypot(slope, bent))];
    for (kind, known) in kinds {
        let rows = rows(&of, kind);
        assert!(rows.len() > 20, "{}", rows.len());
        for row in rows {
            let omega = TAU * row.at.secondary;
            assert_near(row.at.primary * omega * omega / g, known, 1e-9);
            assert_near(row.at.impact_velocity, TAU * g / (omega * (1.0 + r)), 1e-6);
        }
    }
    // Beyond the period doubling there is one attractor, whatever it begins with.
    let prepared = Prepared::of(&of, &Stop::default());
    let here = prepared.oscillator.with_parameters(prepared.without_dimensions([0.9, 25.0]));
    let starts = Starts { states: 12, ..Starts::default() };
    let place = Place::compute(&here, &prepared.scope, &starts, &Silent).expect("nobody stops it");
    let fates: Vec<_> = place.attractors.iter().map(|one| one.fate.numbers()).collect();
    assert_eq!(fates, [Some((2, 2))]);
}

/// The ball leaves the table where this accelerates downwards with g, at cos z = g/(aω²) on its way up, and flies on a parabola.
#[test]
fn a_ball_is_released_where_the_table_falls_faster_and_chatters_as_parabolas_do() {
    let of = example!("bouncing-ball.toml");
    let [g, r] = [1000.0 * constant(&of, "g"), constant(&of, "r")];
    let mut compared = [0; 2];
    for (a, f) in [(0.45, 25.0), (0.5, 25.0), (0.4, 28.0), (0.55, 22.0), (0.6, 22.5)] {
        let omega = TAU * f;
        let table = |t: f64| [a * libm::cos(omega * t), -a * omega * libm::sin(omega * t)];
        let release = -libm::acos(g / (a * omega * omega)) / omega;
        // In units in which motion is of order one: flights of microseconds are too short otherwise.
        let units = of.units();
        let oscillator = of.counted([a / units.primary, f / units.secondary], &units, &Stop::default());
        let from = State { position: -0.3 / units.length, velocity: 0.0, phase: 0.3 };
        let flights: Vec<_> = Orbit::new(&oscillator, from, 12.0 / f / units.time, 100_000).collect();
        for (first, flight) in flights.iter().enumerate() {
            let Some(rest) = flight.rest else { continue };
            let late = libm::remainder(flight.from.phase - omega * release, TAU);
            // The force is a difference of numbers of the size of g, which vanishes linearly.
            assert!(late.abs() < 1e-9, "released {late} late");
            compared[0] += 1;
            // The flights on, in the time of the table.
            let (mut time, mut speed, mut left) = (release, 0.0, table(release)[1]);
            let origin = flight.start * units.time - release;
            for next in &flights[first..] {
                if next.start > flight.start && next.rest.is_some() {
                    // The rest of the sequence is geometric, up to the change of the table's acceleration.
                    let pull = g - a * omega * omega * libm::cos(omega * time);
                    let end = time + 2.0 * r * speed / (pull * (1.0 - r));
                    let apart = next.rest.map_or(f64::NAN, |rest| rest.start * units.time) - origin - end;
                    assert!(apart.abs() * f < 1e-6, "it rests {apart} late");
                    break;
                }
                let FlightEnd::Impact(impact) = next.end else { break };
                let height = |t: f64| table(time)[0] + left * t - 0.5 * g * t * t - table(time + t)[0];
                // The first crossing: no flight is shorter than the step, which is far below its time of free fall.
                let step = if speed > 0.0 { 0.02 * r * speed / g } else { 1e-3 / f };
                let mut high = if speed > 0.0 { 10.0 * step } else { 20.0 * step };
                while height(high) > 0.0 {
                    high += step;
                }
                let mut low = high - step;
                for _ in 0..80 {
                    let middle = 0.5 * (low + high);
                    if height(middle) > 0.0 { low = middle } else { high = middle }
                }
                time += high;
                speed = table(time)[1] - (left - g * high);
                left = table(time)[1] + r * speed;
                // A release that is 1e-9 late shifts what follows by more, as flights after it are short.
                let late = (next.start + next.duration) * units.time - origin - time;
                assert!(late.abs() * f < 1e-7, "{late} of {time}");
                assert!((impact.velocity * units.velocity() - speed).abs() < 1e-6 * a * omega, "{speed}");
                compared[1] += 1;
                if speed < 1e-3 * a * omega {
                    // Positions of the parabola are differences, which lose their digits.
                    break;
                }
            }
            assert!(rest.start < flight.start);
        }
    }
    assert!(compared[0] > 20 && compared[1] > 60, "{compared:?}");
}

/// The equation of motion of the clapper, with its constants and parameters, by Runge and Kutta's method.
struct Bell {
    zeta: f64,
    alpha: f64,
    r: f64,
    amplitude: f64,
    omega: f64,
}

impl Bell {
    /// Angle and velocity of the bell.
    fn bell(&self, t: f64) -> [f64; 2] {
        let [cos, sin] = [libm::cos(self.omega * t), libm::sin(self.omega * t)];
        let Self { amplitude, omega, .. } = *self;
        [amplitude * cos, -amplitude * omega * sin]
    }

    fn step(&self, t: f64, [x, v]: [f64; 2], h: f64) -> [f64; 2] {
        let slope = |t: f64, [x, v]: [f64; 2]| [v, -libm::sin(x) - 2.0 * self.zeta * (v - self.bell(t)[1])];
        let on = |[a, b]: [f64; 2], h: f64| [x + h * a, v + h * b];
        let first = slope(t, [x, v]);
        let second = slope(t + 0.5 * h, on(first, 0.5 * h));
        let third = slope(t + 0.5 * h, on(second, 0.5 * h));
        let fourth = slope(t + h, on(third, h));
        let sum = |k: usize| (first[k] + 2.0 * (second[k] + third[k]) + fourth[k]) / 6.0;
        on([sum(0), sum(1)], h)
    }

    /// The impacts, time, relative velocity and side, from a state at time zero.
    fn impacts(&self, mut at: [f64; 2], periods: u32) -> Vec<(f64, f64, bool)> {
        const STEPS: u32 = 600;
        let h = TAU / self.omega / f64::from(STEPS);
        let beyond = |t: f64, x: f64| (x - self.bell(t)[0]).abs() - self.alpha;
        let (mut t, mut hits) = (0.0, Vec::new());
        for _ in 0..periods * STEPS {
            let (mut from, mut begin) = (at, t);
            at = self.step(t, at, h);
            t += h;
            while beyond(t, at[0]) > 0.0 {
                let (mut low, mut high) = (0.0, t - begin);
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    let [x, _] = self.step(begin, from, middle);
                    if beyond(begin + middle, x) > 0.0 { high = middle } else { low = middle }
                }
                let [x, v] = self.step(begin, from, low);
                begin += low;
                let [angle, rate] = self.bell(begin);
                let speed = (v - rate).abs();
                hits.push((begin, speed, x > angle));
                from = [x, rate - self.r * (v - rate)];
                at = self.step(begin, from, t - begin);
            }
        }
        hits
    }
}

#[test]
fn a_clapper_rings_as_an_integration_by_other_means_has_it() {
    let of = example!("bell.toml");
    let [zeta, alpha, r] = ["zeta", "alpha", "r"].map(|name| constant(&of, name));
    let mut rings = 0;
    for (amplitude, omega) in [(0.8, 0.65), (0.9, 0.7), (0.95, 0.78), (1.0, 0.62), (0.7, 0.75)] {
        let bell = Bell { zeta, alpha, r, amplitude, omega };
        let here: AnyOscillator = of.oscillator([amplitude, omega]);
        let x = amplitude - 0.9 * alpha;
        let start = State { position: x - amplitude - alpha, velocity: 0.0, phase: 0.0 };
        let hits = bell.impacts([x, 0.0], 120);
        let orbit = LongOrbit::follow(&here, start, Horizon::drifting(80, 40));
        let (impacts, periods) = orbit.fate.numbers().unwrap_or_else(|| panic!("{:?}", orbit.fate));
        let begin = 80.0 * TAU / omega;
        let late: Vec<_> = hits.iter().filter(|(time, ..)| *time > begin).collect();
        assert!(
            (late.len() * periods as usize).abs_diff(40 * impacts) <= 2 * periods as usize,
            "{amplitude} {omega}: {:?}, {}",
            orbit.fate,
            late.len()
        );
        // The mirror image of a motion that is not its own is one, too, and a small error decides between both.
        let fastest = |speeds: [f64; 2]| [speeds[0].min(speeds[1]), speeds[0].max(speeds[1])];
        let ours = [0, 1].map(|stop| {
            let own = orbit.impacts.iter().filter(|hit| hit.stop == stop);
            own.map(|hit| hit.impact[0]).fold(0.0, f64::max)
        });
        let theirs = [true, false].map(|side| {
            let own = late.iter().filter(|(.., upper)| *upper == side);
            own.map(|(_, speed, _)| *speed).fold(0.0, f64::max)
        });
        let (ours, theirs) = (fastest(ours), fastest(theirs));
        for (a, b) in ours.iter().zip(theirs) {
            // Both have settled; the error of Runge and Kutta's method is of the fourth order in 1/100.
            assert!((a - b).abs() < 1e-6, "{amplitude} {omega}: {ours:?} for {theirs:?}");
        }
        rings += usize::from((impacts, orbit.fate.second) == (2, 1.0));
    }
    assert!(rings > 1, "{rings}");
}
