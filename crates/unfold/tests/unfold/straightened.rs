//! Curves in straightened coordinates, compared with the quadratic equation of the linear
//! oscillator solved with twice the digits, and with theory.

mod double;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_results::plane::StraightenedPoint;
use grazing_unfold::straightened::straighten;
use grazing_unfold::verdict::near;
use grazing_unfold::{Diagram, Scope, progress::Silent};

use crate::specimens::{EPSILON, ZETA, closed_form, example, scope};
use double::Double;

/// Values of |η| from 1e-9 to 1e-1.
fn etas() -> Vec<f64> {
    let decade = |power: i32| ["1", "2", "5"].map(|digit| format!("{digit}e{power}").parse().unwrap());
    (-9..=-2).flat_map(decade).chain([0.1]).collect()
}

/// The curves from each resonance at which a theorem holds, with its p and n.
fn straightened(
    oscillator: &grazing_model::AnyOscillator,
    scope: &Scope,
) -> Vec<([u32; 2], Vec<Vec<StraightenedPoint>>)> {
    let located = Diagram::located(oscillator, scope, &Silent).unwrap();
    let followed = located.follow(&Silent, &|_, _| ());
    let diagram = located.with_curves(followed);
    let found = diagram.unfolding();
    let curves = |at, point| {
        let points = straighten(&diagram, (at, point), &near(point), &etas());
        points.chunk_by(|a, b| a.arc == b.arc).map(<[_]>::to_vec).collect()
    };
    found.map(|(at, point)| ([at.loops, at.n], curves(at, point))).collect()
}

/// The error of a distance.
fn error(point: &StraightenedPoint) -> f64 {
    point.error * point.distance.abs()
}

fn assert_known(point: &StraightenedPoint, wanted: f64, digits: f64, place: &dyn core::fmt::Debug) {
    let (value, error) = (point.distance, error(point));
    assert!((value - wanted).abs() <= error, "{place:?}: {value} +- {error:.1e} instead of {wanted}");
    assert!((value / wanted - 1.0).abs() <= digits, "{place:?}: {value} instead of {wanted}");
}

/// The value of (𝒜 − 𝒜_graz)/η² on the SN or PD curve of p loops at ω = ω* + η: 𝒜² is a quadratic
/// function of the impact velocity, whose least value is at the fold; −1 is a multiplier where a
/// linear one vanishes.
fn wanted(kind: Bifurcation, [loops, n]: [u32; 2], eta: f64) -> f64 {
    let [zeta, epsilon, one] = [ZETA, EPSILON, 1.0].map(Double::from);
    let omega_1 = (one - zeta * zeta).sqrt();
    let ratio = match loops {
        1 => Double::from(f64::from(n)) / 2.0.into(),
        _ => Double::from(f64::from(n)) + one / (2.0 * f64::from(loops)).into(),
    };
    let omega = omega_1 / ratio + eta.into();
    let time = Double::TAU * f64::from(loops).into() / omega;
    let decay = (-zeta * time).exp();
    let (sine, cosine) = (omega_1 * time).sin_cos();
    let (c, q) = (decay * cosine, decay * sine / omega_1);
    // The free motion of (x, y) over p periods is [[m11, q], [−q, m22]].
    let (m11, m22) = (c + zeta * q, c - zeta * q);
    let (stiffness, loss) = (one - omega * omega, Double::from(2.0) * zeta * omega);
    let square = stiffness * stiffness + loss * loss;
    // The displacement of the response at the impact: (1 − M)⁻¹ (0, y (1 + ε m22) + …), here per y.
    let determinant = (one - m11) * (one - m22) + q * q;
    let kick = [epsilon * q, one + epsilon * m22];
    let x = ((one - m22) * kick[0] + q * kick[1]) / determinant;
    let v = ((one - m11) * kick[1] - q * kick[0]) / determinant;
    let (a, b) = ([stiffness, loss], [stiffness * x + loss * v / omega, loss * x - stiffness * v / omega]);
    let product = a[0] * b[0] + a[1] * b[1];
    let norm = b[0] * b[0] + b[1] * b[1];
    let velocity = match kind {
        Bifurcation::SaddleNode => -product / norm,
        _ => {
            // y (1 + T + D) is linear in y.
            let scaled = |y: Double| {
                let direction = [a[0] + b[0] * y, a[1] + b[1] * y];
                let response = [
                    (loss * direction[0] - stiffness * direction[1]) / square,
                    -omega * (loss * direction[1] + stiffness * direction[0]) / square,
                ];
                let by_phase = (one - m11) * response[0] - q * response[1];
                let acceleration = direction[0] - one - Double::from(2.0) * zeta * y;
                let leak = omega * by_phase - epsilon * q * acceleration;
                let rebound = epsilon * decay;
                (Double::from(2.0) - epsilon * m22 + rebound * rebound) * y - leak
            };
            let constant = scaled(Double::from(0.0));
            constant / (constant - scaled(one))
        }
    };
    let excess = (Double::from(2.0) * product + norm * velocity) * velocity;
    let distance = excess / ((square + excess).sqrt() + square.sqrt());
    (distance / (Double::from(eta) * eta.into())).into()
}

#[test]
fn distances_of_the_linear_oscillators_curves_have_ten_digits_from_1e_minus_9_to_where_they_end() {
    let scope = scope([0.0, 1.2], [0.39, 1.05], &[1, 2, 3]);
    let mut compared = 0;
    for (resonance, curves) in straightened(&closed_form(), &scope) {
        let known = grazing_theorems::LinearOscillator::new(ZETA, EPSILON).unwrap();
        let known = known.resonance(resonance[0], resonance[1]).unwrap();
        for points in curves {
            let StraightenedPoint { kind, loops, limit: coefficient, .. } = points[0];
            if loops != resonance[0] {
                continue;
            }
            let limit = match kind {
                Bifurcation::SaddleNode => known.saddle_node_coefficient(),
                _ => known.period_doubling_coefficient(),
            };
            assert!((coefficient / limit - 1.0).abs() < 1e-11);
            let (_, steps) = points.split_last().unwrap();
            assert_eq!(points[0].eta.abs(), 1e-9);
            for point in steps {
                let at = (resonance, kind, point.eta);
                assert_known(point, wanted(kind, resonance, point.eta), 1e-10, &at);
                compared += 1;
            }
        }
    }
    assert!(compared > 200, "{compared}");
}

#[test]
fn curves_of_a_nonlinear_oscillator_go_to_theorys_constants_with_as_many_digits_at_any_scale() {
    let (oscillator, scope) = example("duffing.toml");
    let all = straightened(&oscillator, &scope);
    let (mut own, mut grazing) = (0, 0);
    for (resonance, points) in all
        .into_iter()
        .flat_map(|(resonance, curves)| curves.into_iter().map(move |curve| (resonance, curve)))
    {
        let StraightenedPoint { kind, loops, limit: coefficient, .. } = points[0];
        let place = (resonance, kind, loops);
        own += usize::from(loops == resonance[0]);
        // GZ curves belong to two loops at a resonance of one.
        grazing += usize::from(kind == Bifurcation::Grazing);
        let nearest = &points[..points.len().min(7)];
        assert_eq!(nearest[0].eta.abs(), 1e-9, "{place:?}");
        // Theory's constant has an error of its own, from second derivatives of integrated motion.
        let limit = nearest[0].distance;
        assert!((limit / coefficient - 1.0).abs() < 2e-5, "{place:?}: {limit} {coefficient}");
        let departure = |point: &StraightenedPoint| point.distance / limit - 1.0;
        let from = nearest[0].eta;
        let slope = departure(&nearest[6]) / (nearest[6].eta - from);
        for point in nearest {
            // The remainder beyond the constant is linear in η, up to the error at every η.
            let error = 2.0 * error(point) / coefficient.abs();
            let bent = 1e-2 * (slope * point.eta).abs();
            let rest = (departure(point) - slope * (point.eta - from)).abs();
            assert!(rest <= error + bent + 1e-9, "{place:?} {point:?}: {rest:e}, {error:e}");
            assert!(error < 1e-7, "{place:?} {point:?}");
        }
        // No jump where differences of places take over from interpolants.
        let [_, inner @ ..] = &points[..] else { panic!("{place:?}") };
        for three in inner.windows(3).take_while(|three| three[2].eta.abs() < 1e-3) {
            let [a, b, c] = [0, 1, 2].map(|k| three[k].distance);
            let between = (three[1].eta - three[0].eta) / (three[2].eta - three[0].eta);
            let chord = a + (c - a) * between;
            assert!((b - chord).abs() <= 0.5 * (c - a).abs() + 4.0 * error(&three[1]), "{place:?}");
        }
    }
    assert!(own >= 12 && grazing >= 3, "{own} {grazing}");
}

#[test]
fn curves_of_two_loops_leave_a_one_loop_resonance_as_theory_has_it_from_1e_minus_9_on() {
    let mut compared = 0;
    for (resonance, curves) in straightened(&closed_form(), &scope([0.3, 0.8], [0.6, 0.75], &[1, 2])) {
        for points in curves.into_iter().filter(|curve| curve[0].loops > resonance[0]) {
            let StraightenedPoint { kind, distance, limit: coefficient, .. } = points[0];
            compared += 1;
            assert!((distance / coefficient - 1.0).abs() < 1e-6, "{resonance:?} {kind:?}");
            // Linear in η: a tenth at a tenth of it.
            let [near, far] = [1e-7, 1e-6].map(|eta: f64| {
                let point = points.iter().find(|point| point.eta.abs() == eta).unwrap();
                point.distance / coefficient - 1.0
            });
            assert!((far / near - 10.0).abs() < 0.05, "{resonance:?} {kind:?}: {near:e} {far:e}");
        }
    }
    assert!(compared >= 2, "{compared}");
}
