//! Balls contain what they must, closed forms are those of the theorems and of the drawn curves, and
//! what is drawn lies within what is proved.

use std::collections::BTreeMap;
use std::fs;
use std::sync::LazyLock;

use grazing_certify::ball::Ball;
use grazing_certify::orbit::Oscillator;
use grazing_certify::proof::{Model, Velocity};
use grazing_certify::prove;
use grazing_certify::resonance::Resonance;
use grazing_certify::row::{Row, Verdict};
use grazing_certify::series::{Number, Series};
use grazing_certify::statement::{Decimal, Statement};
use grazing_theorems::LinearOscillator;

/// The paper's constants, on the window of Figure 7.
static STATEMENT: LazyLock<Statement> = LazyLock::new(|| {
    let decimal = |x: f64| Decimal::new(x).expect("few digits");
    Statement {
        zeta: decimal(0.02),
        epsilon: decimal(0.9),
        frequency: [0.35, 1.02].map(decimal),
        amplitude: decimal(1.3),
        loops: vec![1, 2, 3],
    }
});
static OSCILLATOR: LazyLock<Oscillator> = LazyLock::new(|| STATEMENT.oscillator().expect("under-damped"));
static ROWS: LazyLock<Vec<Row>> = LazyLock::new(|| prove(&STATEMENT, &OSCILLATOR, |_| (), || ()));

/// A sequence that looks random.
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
    // By other means: the digits of mathematical tables.
    assert!(Ball::PI.to_string().starts_with("3.1415926535897932384"));
    assert!(Ball::ONE.exp().to_string().starts_with("2.7182818284590452353"));
    assert!(Ball::from(2).sqrt().to_string().starts_with("1.4142135623730950488"));
    let mut seed = 7;
    for _ in 0..20_000 {
        let x = 20.0 * random(&mut seed) - 10.0;
        for (ball, number) in [(Ball::from(x).turn().0, x.turn().0), (Ball::from(x).exp(), libm::exp(x))] {
            // libm's functions are right to a unit or two of the last digit.
            assert!((ball.to_f64() - number).abs() <= 1e-15 * number.abs().max(1.0), "{x} {ball} {number}");
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

/// Taylor coefficients against differences of the same function at two points.
#[test]
fn series_are_derivatives() {
    for nu in [1.1, 1.7, 2.3] {
        let family = OSCILLATOR.family(2, Series::variable(Ball::from(nu)));
        let step = 1e-4;
        let [low, high] = [nu - step, nu + step].map(|nu| OSCILLATOR.family(2, nu));
        for (series, difference) in [(family.c, high.c - low.c), (family.big_p, high.big_p - low.big_p)] {
            let slope = difference / (2.0 * step);
            // The next term of the difference is the third coefficient times the square of the step.
            let allowed = 1e-7 * (1.0 + series.0[3].to_f64().abs());
            assert!((series.0[1].to_f64() - slope).abs() < allowed, "{nu}: {slope} {series:?}");
        }
    }
}

/// The identity that makes the saddle-node the fold of A(v), `P = 1 + D − a`, in balls: the trace by
/// the saltation matrix, at velocities 1 and 2.
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
                let acceleration = -OSCILLATOR.distance(&family.motion(v), Ball::ZERO)[2];
                let force = acceleration - (k + k) * nu * epsilon * v;
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

#[test]
fn coefficients_of_theorems_and_propositions_agree_and_are_those_of_floating_point() {
    let theory = LinearOscillator::new(0.02, 0.9).expect("valid");
    let frequency = STATEMENT.frequency.map(Decimal::ball);
    let resonances = Resonance::in_window(&OSCILLATOR, &STATEMENT.loops, frequency);
    assert_eq!(resonances.len(), 8);
    for resonance in resonances {
        let Resonance { p, n, saddle_node, period_doubling, .. } = resonance;
        assert!(resonance.missing.is_empty(), "{resonance:?}");
        let point = theory.resonance(p, n).expect("a resonance");
        let ours = [resonance.omega, resonance.amplitude, saddle_node, period_doubling];
        let theirs = [
            point.forcing_frequency(),
            point.grazing().amplitude(),
            point.saddle_node_coefficient(),
            point.period_doubling_coefficient(),
        ];
        for (ball, number) in ours.into_iter().zip(theirs) {
            assert!((ball.to_f64() / number - 1.0).abs() < 1e-12, "p {p} n {n}: {ball} {number}");
        }
        let propositions = resonance.propositions(&OSCILLATOR);
        for (theorem, proposition) in [saddle_node, period_doubling].into_iter().zip(propositions) {
            assert!((theorem - proposition).contains(Ball::ZERO), "p {p} n {n}: {theorem} {proposition}");
            let digits = theorem.to_string().bytes().filter(u8::is_ascii_digit).count();
            assert!(digits >= 19, "p {p} n {n}: {theorem}");
        }
    }
}

/// Every vertex of a curve of `fig07_curves.csv` lies where it is proved to be: SN and PD vertices on
/// the closed forms, GZ vertices in tubes, all within 2e-9 for the rounding of continuation.
#[test]
fn drawn_curves_lie_within_what_is_proved() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../figures/data/fig07_curves.csv");
    let text = fs::read_to_string(file).expect("Figure 7's data");
    let (mut seen, mut within) = (BTreeMap::new(), 0);
    for line in text.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |column: usize| cells[column].parse::<f64>().expect("a number");
        let (kind, p) = (cells[0], number(1) as i64);
        if kind == "graz" {
            continue;
        }
        *seen.entry(kind).or_insert(0) += 1;
        let omega = Ball::from(number(3));
        let nu = OSCILLATOR.omega_1 * omega.inverse();
        let (family, velocity) = (OSCILLATOR.family(p, nu), Ball::from(number(5)) * omega.inverse());
        let amplitude = OSCILLATOR.amplitude_square(&family.motion(velocity)).sqrt();
        let near = |x: Ball| (x.to_f64().abs() + x.radius()) < 2e-9;
        assert!(near(amplitude - Ball::from(number(4))), "{line}");
        match kind {
            "SN" => assert!(near(velocity - family.b * family.big_p.inverse()), "{line}"),
            "PD" => assert!(near(velocity + family.b * family.big_q.inverse()), "{line}"),
            _ => {}
        }
        let row = ROWS.iter().find(|row| {
            let [left, right] = row.interval.ends();
            row.interval.p == p && !(left - nu).is_positive() && !(nu - right).is_positive()
        });
        let row = row.expect("the window is covered");
        if let (Verdict::Tube { lower, upper, .. }, "GZ") = (&row.verdict, kind) {
            let offset = (nu - row.interval.origin()).to_f64();
            let at = |witness: &[i128; 3]| {
                let [a, b, c] = witness.map(|w| libm::scalbn(w as f64, -64));
                a + offset * (b + offset * c)
            };
            let velocity = velocity.to_f64();
            assert!(at(lower) - 2e-9 <= velocity && velocity <= at(upper) + 2e-9, "{line}");
            within += 1;
        }
    }
    assert!(seen.len() == 3 && within * 10 >= seen["GZ"] * 9, "{seen:?}, {within} in tubes");
}

/// Every row of the window is decided, and a verdict that is false is not proved.
#[test]
fn the_window_is_decided_and_what_is_false_is_refused() {
    assert!(ROWS.iter().all(|row| !matches!(row.verdict, Verdict::Undecided(_))));
    let mut refused = 0;
    for row in ROWS.iter().step_by(17) {
        let model = Model::new(&OSCILLATOR, row.interval);
        if let Verdict::Tube { lower, upper, touch, .. } = row.verdict {
            let (lower, upper) = (Velocity::Witness(lower), Velocity::Witness(upper));
            assert!(model.stable(&lower) && model.beyond(&upper, touch) && !model.beyond(&lower, touch));
            assert!(!model.unstable(&lower) && !(1..row.interval.p).any(|turn| model.blocked(turn)));
            refused += 1;
        }
    }
    assert!(refused > 50, "{refused}");
}
