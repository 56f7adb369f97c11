//! Tests that balls contain the right numbers, that the closed forms agree with the theorems and the
//! drawn curves, and that drawn objects lie within proved bounds.

use std::collections::BTreeMap;
use std::fs;
use std::sync::LazyLock;

use grazing_certify::ball::{Ball, Number};
use grazing_certify::orbit::Oscillator;
use grazing_certify::proof::IntervalMotions;
use grazing_certify::resonance::{EnclosedResonance, NAMES};
use grazing_certify::row::{Base, CertificateRow, Interval, IntervalVerdict, Reason};
use grazing_certify::series::Series;
use grazing_certify::statement::{Decimal, Statement};
use grazing_certify::{certificate, prove, summary};
use grazing_theorems::LinearOscillator;
use num_rational::Ratio;

/// The paper's constants, on the window of Figure 7.
static STATEMENT: LazyLock<Statement> = LazyLock::new(|| {
    let decimal = |x: f64| Decimal::new(x).expect("few digits");
    let (constants, frequency) = ([0.02, 0.9].map(decimal), [0.35, 1.02].map(decimal));
    Statement::new(constants, frequency, [0.0, 1.3].map(decimal), vec![1, 2, 3]).expect("under-damped")
});
static OSCILLATOR: LazyLock<Oscillator> = LazyLock::new(|| STATEMENT.oscillator);
static ROWS: LazyLock<Vec<CertificateRow>> = LazyLock::new(|| prove(&STATEMENT, |_| (), || (), || false));

/// A pseudorandom number between 0 and 1.
fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 53) as f64
}

#[test]
fn balls_contain_what_identities_demand() {
    let (mut seed, small) = (1, |x: Ball, digits: i32| x.radius() < libm::scalbn(1.0, -digits));
    for _ in 0..20_000 {
        let x = Ball::from(libm::scalbn(random(&mut seed) - 0.5, (random(&mut seed) * 12.0) as i32 - 6));
        let y = Ball::from(4.0 * random(&mut seed) + 1e-3);
        let (sine, cosine) = x.turn();
        let identities = [
            sine * sine + cosine * cosine - Ball::ONE,
            y * y.inverse() - Ball::ONE,
            y.sqrt() * y.sqrt() - y,
            y.exp() * (-y).exp() - Ball::ONE,
            (x + y).turn().0 - sine * y.turn().1 - cosine * y.turn().0,
        ];
        for (which, value) in identities.into_iter().enumerate() {
            assert!(value.contains(Ball::ZERO) && small(value, 60), "{which}: {x:?} {y:?} {value:?}");
        }
    }
}

#[test]
fn balls_hold_the_digits_of_constants_and_of_floating_point() {
    // Independent values: the digits of mathematical tables.
    assert!(Ball::PI.to_string().starts_with("3.1415926535897932384"));
    assert!(Ball::ONE.exp().to_string().starts_with("2.7182818284590452353"));
    assert!(Ball::from(2).sqrt().to_string().starts_with("1.4142135623730950488"));
    let mut seed = 7;
    for _ in 0..20_000 {
        let x = 20.0 * random(&mut seed) - 10.0;
        for (ball, number) in [(Ball::from(x).turn().0, x.turn().0), (Ball::from(x).exp(), libm::exp(x))] {
            // libm's functions are accurate to one or two units of the last digit.
            assert!((ball.to_f64() - number).abs() <= 1e-15 * number.abs().max(1.0), "{x} {ball} {number}");
        }
    }
}

/// Compares balls with exact fractions: n/d lies in a ball only if d times the ball, less n, contains
/// zero.
#[test]
fn balls_hold_exact_fractions() {
    let mut seed = 11;
    for _ in 0..20_000 {
        let mut whole = |size: f64| (size * (random(&mut seed) - 0.5)) as i64;
        let [a, b] = [0; 2].map(|_| (whole(2e4), whole(2e2).abs() + 1));
        let [x, y] = [a, b].map(|(n, d)| Ball::ratio(n, d));
        let [p, q] = [a, b].map(|(n, d)| Ratio::new(n, d));
        let cases = [(x + y, p + q), (x - y, p - q), (x * y, p * q)];
        let inverse = (a.0 != 0).then(|| (x.inverse(), p.recip()));
        for (ball, exact) in cases.into_iter().chain(inverse) {
            let difference = ball * Ball::from(*exact.denom()) - Ball::from(*exact.numer());
            assert!(difference.contains(Ball::ZERO) && difference.radius() < 1e-18, "{ball:?} {exact}");
        }
    }
}

#[test]
fn balls_that_do_not_fit_prove_nothing() {
    let large = Ball::from(1e9);
    for unknown in [large * large, Ball::ZERO.inverse(), (-Ball::ONE).sqrt(), Ball::from(f64::NAN)] {
        assert!(!unknown.is_positive() && !unknown.is_negative() && unknown.contains(large));
        assert!(!(unknown - unknown).is_positive() && !Ball::ONE.contains(unknown));
    }
    assert_eq!(Ball::ratio(-1, 4), -Ball::dyadic(1, 2));
    assert!(
        Ball::ratio(1, 3).contains(Ball::ratio(1, 3)) && !Ball::ratio(1, 3).contains(Ball::from(1.0 / 3.0))
    );
}

/// Compares Taylor coefficients with differences of the same function at two points.
#[test]
fn series_are_derivatives() {
    for nu in [1.1, 1.7, 2.3] {
        let family = OSCILLATOR.family(2, Series::variable(Ball::from(nu), Ball::from(nu), Ball::ONE));
        let step = 1e-4;
        let [low, high] = [nu - step, nu + step].map(|nu| OSCILLATOR.family(2, nu));
        for (series, difference) in [(family.c, high.c - low.c), (family.big_p, high.big_p - low.big_p)] {
            let slope = difference / (2.0 * step);
            // The next term of the difference is the third coefficient times the square of the step.
            let allowed = 1e-7 * (1.0 + series.0[0][3].to_f64().abs());
            assert!((series.0[0][1].to_f64() - slope).abs() < allowed, "{nu}: {slope} {series:?}");
        }
    }
}

/// The identity by which the saddle-node is the fold of A(v), `P = 1 + D − a`, in balls: the trace is
/// computed with the saltation matrix, at velocities 1 and 2.
#[test]
fn the_trace_is_that_of_the_saltation_matrix() {
    let mut seed = 3;
    for p in [1, 2, 3, 7] {
        for _ in 0..50 {
            let nu = Ball::from(0.6 + 2.0 * random(&mut seed));
            let family = OSCILLATOR.family(p, nu);
            let (one, turns) = (Ball::ONE, Ball::from(p));
            let (k, epsilon) = (OSCILLATOR.decay, OSCILLATOR.epsilon);
            let decay = (-(Ball::PI + Ball::PI) * k * nu * turns).exp();
            let (sine, cosine) = (nu * turns).turn();
            for v in [1, 2].map(Ball::from) {
                let [_, _, departure] = OSCILLATOR.distance(&family.motion(v), Ball::ZERO);
                let force = -departure - (k + k) * nu * epsilon * v;
                let diagonal = -(epsilon * v * (decay * cosine + decay * cosine));
                let scaled_trace = diagonal + (one + epsilon) * decay * sine * nu.inverse() * force;
                let determinant = epsilon * epsilon * decay * decay;
                let below = v * (one + determinant) - scaled_trace;
                let above = v * (one + determinant) + scaled_trace;
                for difference in
                    [below - (family.big_p * v - family.b), above - (family.big_q * v + family.b)]
                {
                    assert!(difference.contains(Ball::ZERO) && difference.radius() < 1e-18, "{difference:?}");
                }
            }
        }
    }
}

/// Compares the coefficients, which are those of the propositions, with the formulas of the theorems.
#[test]
fn coefficients_are_those_of_the_theorems_in_floating_point() {
    let theory = LinearOscillator::new(0.02, 0.9).expect("valid");
    let frequency = STATEMENT.frequency.map(Decimal::ball);
    let resonances = EnclosedResonance::in_window(&OSCILLATOR, &STATEMENT.loops, frequency);
    assert_eq!(resonances.len(), 8);
    for resonance in resonances {
        let EnclosedResonance { p, n, .. } = resonance;
        assert!(resonance.missing.is_empty(), "{resonance:?}");
        let point = theory.resonance(p, n).expect("a resonance");
        let theorem = point.resonant_point();
        let stability = theorem.stability_coefficients();
        let theirs = [
            point.forcing_frequency(),
            point.grazing().amplitude(),
            stability.plus,
            stability.minus,
            theorem.saddle_node_coefficient(),
            theorem.period_doubling_coefficient(),
        ];
        for ((name, ball), number) in NAMES.into_iter().zip(resonance.numbers).zip(theirs) {
            assert!((ball.to_f64() / number - 1.0).abs() < 1e-12, "p {p} n {n} {name}: {ball} {number}");
            let digits = ball.to_string().bytes().filter(u8::is_ascii_digit).count();
            assert!(digits >= 19, "p {p} n {n} {name}: {ball}");
        }
    }
}

/// The rows of one of Figure 7's data files, split into cells.
fn drawn(name: &str) -> Vec<Vec<String>> {
    let file = format!("{}/../../figures/data/fig07_{name}.csv", env!("CARGO_MANIFEST_DIR"));
    let text = fs::read_to_string(file).expect("Figure 7's data");
    text.lines().skip(1).map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

fn number(cell: &str) -> f64 {
    cell.parse().expect("a number")
}

fn row_at(p: i64, nu: Ball) -> &'static CertificateRow {
    summary::row_at(&ROWS, p, nu).expect("the window is covered")
}

/// The amplitude at which stable motion is proved to begin, and the two sides of the tube in which it
/// ends.
fn proved(p: i64, omega: f64) -> Option<[f64; 3]> {
    let nu = OSCILLATOR.omega_1_over(Ball::from(omega));
    let row = row_at(p, nu);
    let (begins, lower, upper) = summary::ends(&STATEMENT, row, nu)?;
    Some([begins.to_f64(), lower.to_f64(), upper.map_or(f64::INFINITY, Ball::to_f64)])
}

/// At places throughout the window, a region is drawn if stable motion is proved to exist, and none if it
/// is proved not to exist. (`beyond_proofs.csv` counts the vertices that lie within proved bounds.)
#[test]
fn drawn_regions_are_those_that_are_proved() {
    let (window, top) = ([0.35, 1.02], 1.3);
    let mut rings: BTreeMap<(i64, String, String), Vec<[f64; 2]>> = BTreeMap::new();
    for cells in drawn("regions") {
        let [omega, amplitude] = [4, 5].map(|column| number(&cells[column]));
        let ring = (number(&cells[2]) as i64, cells[0].clone(), cells[6].clone());
        rings.entry(ring).or_default().push([omega, amplitude]);
    }
    let inside = |p: i64, [omega, amplitude]: [f64; 2]| {
        let crossings = rings.iter().filter(|(key, _)| key.0 == p).flat_map(|(_, ring)| {
            let next = ring.iter().cycle().skip(1);
            ring.iter().zip(next).filter(|(a, b)| {
                let share = (omega - a[0]) / (b[0] - a[0]);
                (a[0] > omega) != (b[0] > omega) && a[1] + share * (b[1] - a[1]) > amplitude
            })
        });
        crossings.count() % 2 == 1
    };
    let (mut tested, mut beside) = ([0; 2], 0);
    for (p, i) in (1..4).flat_map(|p| (0..240).map(move |i| (p, i))) {
        let omega = window[0] + (f64::from(i) + 0.5) / 240.0 * (window[1] - window[0]);
        let ends = proved(p, omega);
        for j in 0..240 {
            let amplitude = (f64::from(j) + 0.5) / 240.0 * top;
            let exists = ends.is_some_and(|[limit, lower, _]| limit < amplitude && amplitude < lower);
            let unknown = ends.is_some_and(|[_, lower, upper]| lower <= amplitude && amplitude <= upper);
            tested[usize::from(exists)] += 1;
            if unknown || inside(p, [omega, amplitude]) == exists {
                continue;
            }
            // Chords deviate from curves by less than the width of the drawn line.
            let near = ends.is_some_and(|ends| ends.iter().any(|end| (end - amplitude).abs() < 1e-4));
            assert!(near, "p = {p}, omega = {omega}, A = {amplitude}: {ends:?}");
            beside += 1;
        }
    }
    assert!(tested.iter().all(|&count| count > 10_000) && beside < 20, "{tested:?}, {beside} beside");
}

/// Beyond the paper's window, stable motion may end at a PD curve, which a GZ curve meets, and may begin
/// outside the window: both cases are decided.
#[test]
fn motion_that_ends_or_begins_elsewhere_is_decided() {
    let decimal = |x: f64| Decimal::new(x).expect("few digits");
    let constants = [0.0286, 0.975].map(decimal);
    let statement = Statement::new(constants, [2.05, 2.6].map(decimal), [0.0, 4.0].map(decimal), vec![1, 2]);
    let statement = statement.expect("under-damped");
    let rows = prove(&statement, |_| (), || (), || false);
    assert!(rows.iter().all(|row| !matches!(row.verdict, IntervalVerdict::Undecided(_))));
    let points: Vec<&CertificateRow> = summary::points(&statement, &rows).map(|(_, row)| row).collect();
    assert!(
        matches!(points[..], [CertificateRow { verdict: IntervalVerdict::Point("GZ-PD"), .. }]),
        "{points:?}"
    );
    // At greater frequencies motion ends at a PD velocity, in closed form; at lower ones it ends in a
    // tube. Both are tested a thousand widths away.
    let interval = points[0].interval;
    let ends = interval.ends().map(|nu| {
        let beside = nu + (nu - interval.middle()) * Ball::from(2_000);
        summary::row_at(&rows, interval.p, beside).expect("the window is covered").upper.is_some()
    });
    assert_eq!(ends, [false, true]);
    let outside = |row: &&CertificateRow| {
        row.verdict == IntervalVerdict::None && row.upper.is_some() && row.touch.is_none()
    };
    let outside: Vec<&CertificateRow> = rows.iter().filter(outside).collect();
    assert!(!outside.is_empty());
    for row in outside {
        let omega = statement.oscillator.omega_1_over(row.interval.middle());
        let family = statement.oscillator.family(row.interval.p, row.interval.middle());
        let begins = family.motion(family.velocity_at(-1));
        let beyond = statement.oscillator.amplitude_square(&begins).sqrt() - statement.amplitude[1].ball();
        assert!(family.big_q.is_negative() || beyond.is_positive(), "omega = {omega}: {beyond}");
    }
}

/// Every row of the window is decided, and a row with exchanged or missing witnesses is not proved.
#[test]
fn the_window_is_decided_and_what_is_false_is_refused() {
    assert!(ROWS.iter().all(|row| !matches!(row.verdict, IntervalVerdict::Undecided(_))));
    // Motion that gains energy at impacts may be unstable although its trace is small.
    let oscillator = |epsilon| Oscillator::new(STATEMENT.zeta.ball(), epsilon);
    assert!(oscillator(Ball::ONE).is_some() && oscillator(Ball::ratio(6, 5)).is_none());
    // With one loop, some tubes are at the window's edge, where an upper velocity is not needed for the
    // proof.
    let is_tube = |row: &&CertificateRow| {
        row.verdict == IntervalVerdict::Stable && row.upper.is_some() && row.interval.p > 1
    };
    let tubes = ROWS.iter().filter(is_tube);
    let mut tried = 0;
    for row in tubes.step_by(17) {
        let model = IntervalMotions::over(&STATEMENT, row.interval);
        let touch = row.touch.expect("a time at which motion is beyond the wall");
        for wrong in [
            CertificateRow { lower: row.upper, upper: row.lower, ..row.clone() },
            CertificateRow { lower: None, ..row.clone() },
            CertificateRow { upper: None, ..row.clone() },
            CertificateRow { lower: None, upper: None, ..row.clone() },
        ] {
            assert_eq!(model.prove(wrong, &|_| touch), None);
        }
        tried += 1;
    }
    assert!(tried > 50, "{tried}");
}

/// The statement about an oscillator in a window.
fn statement(constants: [f64; 2], frequency: [f64; 2], amplitude: [f64; 2], loops: &[u32]) -> Statement {
    let decimal = |x: f64| Decimal::new(x).expect("few digits");
    let [constants, frequency, amplitude] =
        [constants, frequency, amplitude].map(|numbers| numbers.map(decimal));
    Statement::new(constants, frequency, amplitude, loops.to_vec()).expect("under-damped")
}

/// The points of the rows in a window of the paper's oscillator.
fn points_in(frequency: [f64; 2], amplitude: [f64; 2]) -> usize {
    let statement = statement([0.02, 0.9], frequency, amplitude, &[1, 2, 3]);
    summary::points(&statement, &ROWS).count()
}

/// Rows beyond an edge of the window may have points, too; these are not counted.
#[test]
fn points_are_counted_in_the_window_alone() {
    let all: Vec<Ball> =
        summary::points(&STATEMENT, &ROWS).map(|(_, row)| summary::amplitudes(&STATEMENT, row)).collect();
    let below =
        |edge: f64| all.iter().filter(|amplitude| (**amplitude - Ball::from(edge)).is_negative()).count();
    assert_eq!(points_in([0.35, 1.02], [0.0, 1.3]), all.len());
    for edge in [0.5, 0.8, 1.05] {
        assert!(below(edge) < all.len(), "the edge at {edge} cuts points off");
        assert_eq!(points_in([0.35, 1.02], [0.0, edge]), below(edge));
        assert_eq!(points_in([0.35, 1.02], [edge, 1.3]), all.len() - below(edge));
    }
    let parts = [[0.35, 0.45], [0.45, 0.6], [0.6, 1.02]].map(|frequency| points_in(frequency, [0.0, 1.3]));
    assert!(parts.iter().all(|&count| count > 0) && parts.iter().sum::<usize>() == all.len(), "{parts:?}");
}

/// A point on the edge of a window is in no count, whether the edge is one of frequency or of amplitude.
#[test]
fn a_point_on_the_edge_of_the_window_is_undecided() {
    let (_, row) = summary::points(&STATEMENT, &ROWS).next().expect("a point");
    let (lower, place) = (row.lower.expect("a velocity"), summary::amplitudes(&STATEMENT, row).to_f64());
    let [low, high] = summary::frequencies(&STATEMENT, std::slice::from_ref(row)).map(Ball::to_f64);
    let inside = 0.5 * (low + high);
    for (frequency, amplitude) in [([inside, 1.02], [0.0, 1.3]), ([0.35, 1.02], [0.0, place])] {
        let nearest = |x: f64| libm::rint(x * 1e12) / 1e12;
        let cut = statement([0.02, 0.9], frequency.map(nearest), amplitude.map(nearest), &[1, 2, 3]);
        assert_eq!(
            IntervalMotions::over(&cut, row.interval).is_in_window(lower),
            None,
            "{frequency:?} {amplitude:?}"
        );
        assert!(IntervalMotions::over(&cut, row.interval).is_on_edge(row));
    }
}

/// What needs deep intervals at one place leaves the rest decided: where the free oscillation is gone
/// after a period, what may exist is next to the grazing curve.
#[test]
fn strong_damping_leaves_nothing_undecided() {
    let statement = statement([0.9, 0.3], [0.37, 0.45], [0.0, 1.3], &[1, 2, 3]);
    let rows = prove(&statement, |_| (), || (), || false);
    let undecided: Vec<&CertificateRow> =
        rows.iter().filter(|row| matches!(row.verdict, IntervalVerdict::Undecided(_))).collect();
    assert!(undecided.is_empty(), "{undecided:?}");
    assert!(rows.len() < 500, "{}", rows.len());
    assert!(rows.iter().any(|row| row.verdict == IntervalVerdict::Thin));
    assert!(rows.iter().any(|row| row.verdict == IntervalVerdict::None));
}

/// Where the time of contact changes fast, beside a PD-GZ point of weakly damped motion; where third
/// derivatives are greater than balls can be, beside a resonance; and where motion touches the wall next to a
/// whole turn, at velocities of 10⁻⁶.
#[test]
fn weak_and_strong_damping_are_decided_where_they_are_hardest() {
    for (constants, frequency, p) in [
        ([0.006, 0.99], [0.49997, 0.49998], 1),
        ([0.0042, 0.05], [0.9985, 0.9986], 1),
        ([0.001, 0.3], [1.0001, 1.0002], 1),
        ([0.5, 0.05], [0.692585, 0.692605], 3),
        ([0.3, 0.0001], [0.423889, 0.423891], 3),
    ] {
        let statement = statement(constants, frequency, [0.0, 1.3], &[p]);
        let rows = prove(&statement, |_| (), || (), || false);
        let undecided: Vec<&CertificateRow> =
            rows.iter().filter(|row| matches!(row.verdict, IntervalVerdict::Undecided(_))).collect();
        assert!(undecided.is_empty(), "{constants:?}: {undecided:?}");
    }
}

/// A coefficient of the order of e⁻⁹⁰ has no digit that balls could show, which is said.
#[test]
fn a_number_without_a_digit_is_not_shown() {
    let [weak, strong] = [0.02, 0.9].map(|zeta| statement([zeta, 0.3], [0.37, 0.38], [0.0, 1.3], &[3]));
    let missing = |statement: &Statement| EnclosedResonance::new(&statement.oscillator, 3, 1).missing;
    assert_eq!(missing(&weak), Vec::<&str>::new());
    assert_eq!(missing(&strong), ["a digit of each number"]);
}

/// For four loops, stability and contact begin at velocity zero at resonances of one and of two loops.
#[test]
fn resonances_are_those_of_the_right_number_of_loops() {
    let at = |p, nu: f64| {
        let left = libm::floor(libm::scalbn(nu, 32)) as i64;
        Interval { p, left, level: 32, base: Base::Middle }.resonance_within()
    };
    assert_eq!(at(4, 1.25), Some([2, 1]));
    assert_eq!(at(4, 1.125), Some([4, 1]));
    assert_eq!(at(4, 1.5), Some([1, 3]));
    assert_eq!(at(6, 7.0 / 6.0), Some([3, 1]));
    assert_eq!(at(4, 1.75), None);
    assert_eq!(at(4, 1.3), None);
    // There, too, what may exist is next to the grazing curve.
    let statement = statement([0.02, 0.9], [0.79981, 0.79989], [0.0, 1.3], &[4]);
    let rows = prove(&statement, |_| (), || (), || false);
    assert!(rows.iter().all(|row| !matches!(row.verdict, IntervalVerdict::Undecided(_))), "{rows:?}");
    let thin = rows.iter().find(|row| row.verdict == IntervalVerdict::Thin).expect("the resonance");
    assert!(summary::sentence(&statement, std::slice::from_ref(thin)).contains("p = 2, n = 1"));
}

/// A run that is stopped has rows for the whole window, and those that it has proved are kept.
#[test]
fn a_stopped_run_keeps_its_rows() {
    let statement = statement([0.02, 0.9], [0.8, 0.9], [0.0, 1.3], &[1]);
    let calls = std::sync::atomic::AtomicU32::new(0);
    let stopped = || calls.fetch_add(1, std::sync::atomic::Ordering::Relaxed) >= 20;
    let [stopped, whole] =
        [prove(&statement, |_| (), || (), stopped), prove(&statement, |_| (), || (), || false)];
    let is_left = |row: &&CertificateRow| row.verdict == IntervalVerdict::Undecided(Reason::Interruption);
    let left = stopped.iter().filter(is_left).count();
    assert!(left > 0 && left < stopped.len(), "{left} of {}", stopped.len());
    assert!(stopped.iter().filter(|row| !is_left(row)).all(|row| whole.contains(row)));
    assert!(stopped.windows(2).all(|pair| pair[0].interval.ends()[1] == pair[1].interval.ends()[0]));
}

/// Every row has as many cells as there are columns, whatever its reason.
#[test]
fn no_cell_of_the_certificate_has_a_comma() {
    let interval = Interval { p: 4, left: 80, level: 6, base: Base::Middle };
    let reasons = [
        Reason::Resonance { p: 2, n: 1 },
        Reason::Coincidence,
        Reason::Edge,
        Reason::Width,
        Reason::Number,
        Reason::Interruption,
    ];
    let rows: Vec<CertificateRow> = reasons
        .into_iter()
        .map(|reason| CertificateRow::new(interval, IntervalVerdict::Undecided(reason)))
        .collect();
    // An oscillator so weakly damped that nothing of its resonances is shown.
    let weak = statement([1e-9, 0.9], [0.79, 0.81], [0.0, 1.3], &[1, 2]).oscillator;
    let resonances = [EnclosedResonance::new(&weak, 1, 2), EnclosedResonance::new(&weak, 2, 1)];
    assert!(resonances.iter().any(|resonance| !resonance.missing.is_empty()), "{resonances:?}");
    for text in [certificate::rows(&rows), certificate::resonances(&resonances)] {
        let counts: Vec<usize> = text.lines().map(|line| line.split(',').count()).collect();
        assert!(counts.iter().all(|&count| count == counts[0]), "{text}");
    }
}
