//! Derivatives along curves to third order: the closed form compared with automatic
//! differentiation, the integrated flow with the closed form and with differences.

use grazing_model::smooth::{Function, Integrated, Scalar, SmoothOscillator, Taylor};
use grazing_model::{ImpactOscillator, OnWall, State, ThirdOrder, maps};
use nalgebra::{SVector, Vector4};
use num_dual::{Dual3_64, third_derivative};

use crate::models::{Bouncing, Dragged, Duffing, FROM, Saturating, Sticking, both};
use crate::printed::printed_flow;

/// Curves of (x₀, y₀, z₀, s): generic coefficients of the first to the third order.
const CURVES: [[[f64; 4]; 3]; 3] = [
    [[0.3, -0.5, 0.7, 0.4], [0.0; 4], [0.0; 4]],
    [[-0.2, 0.6, 0.1, -0.8], [0.5, 0.2, -0.4, 0.3], [0.1, -0.6, 0.2, 0.5]],
    [[0.0, 0.4, -0.9, 0.0], [0.3, 0.0, 0.7, -0.2], [0.0, 0.2, 0.0, 0.4]],
];

/// Times of either sign, and zero.
const DURATIONS: [f64; 5] = [-5.0, -0.3, 0.0, 1.3, 9.0];

/// (x₀, y₀, z₀, s) along a curve.
fn along(duration: f64, curve: &[[f64; 4]; 3]) -> [Taylor; 4] {
    let start = [FROM.position, FROM.velocity, FROM.phase, duration];
    [0, 1, 2, 3].map(|i| Taylor::new([start[i], curve[0][i], curve[1][i], curve[2][i]]))
}

fn series(oscillator: &impl ThirdOrder, duration: f64, curve: &[[f64; 4]; 3]) -> [Taylor; 2] {
    let [x, y, z, s] = along(duration, curve);
    oscillator.flow_series([x, y, z], s)
}

/// The flow as printed along a curve, in dual numbers.
fn printed(parameters: [f64; 2], duration: f64, curve: &[[f64; 4]; 3], s: Dual3_64) -> [Dual3_64; 2] {
    let [x, y, z, time] = along(duration, curve).map(|component| {
        let [value, first, second, third] = component.coefficients();
        ((s * third + second) * s + first) * s + value
    });
    let [amplitude, omega] = parameters.map(Dual3_64::from);
    printed_flow(0.02, [x, y, z, time, amplitude, omega])
}

#[test]
fn closed_form_is_the_printed_solution_under_automatic_differentiation() {
    let (_, oscillator) = both();
    for curve in &CURVES {
        for duration in DURATIONS {
            let computed = series(&oscillator, duration, curve);
            for i in 0..2 {
                let (value, first, second, third) =
                    third_derivative(|s| printed(oscillator.parameters(), duration, curve, s)[i], 0.0);
                let expected = [value, first, second / 2.0, third / 6.0];
                for (computed, expected) in computed[i].coefficients().into_iter().zip(expected) {
                    // Roundings of terms of order ten.
                    assert!((computed - expected).abs() < 1e-13, "{duration}: {computed} {expected}");
                }
            }
        }
    }
}

#[test]
fn integrated_flow_is_that_of_the_closed_form() {
    let (integrated, closed) = both();
    for curve in &CURVES {
        for duration in DURATIONS {
            let [a, b] = [series(&integrated, duration, curve), series(&closed, duration, curve)];
            for (a, b) in a.iter().zip(&b) {
                for (a, b) in a.coefficients().into_iter().zip(b.coefficients()) {
                    // The tolerance of derivatives of the first two orders, which this integrator
                    // has to 1e-12 over a period.
                    assert!((a - b).abs() < 1e-12, "{duration}: {a} {b}");
                }
            }
        }
    }
}

/// Compares coefficients along straight lines: the first two orders with the exact derivatives in
/// all directions, the third with central differences of the exact second one.
fn assert_series<M: SmoothOscillator>(oscillator: &Integrated<M>) {
    let direction = Vector4::new(0.3, -0.5, 0.7, 0.4);
    let line = [direction.into(), [0.0; 4], [0.0; 4]];
    for duration in [-3.0, 0.0, 6.0] {
        let jet = |parameter: f64| {
            let moved = direction * parameter;
            let from = State {
                position: FROM.position + moved[0],
                velocity: FROM.velocity + moved[1],
                phase: FROM.phase + moved[2],
            };
            oscillator.flow::<2>(from, duration + moved[3])
        };
        let q: SVector<f64, 6> =
            SVector::from([direction[0], direction[1], direction[2], direction[3], 0.0, 0.0]);
        let bend = |parameter: f64, i: usize| 0.5 * q.dot(&(jet(parameter).hessians[i] * q));
        let here = jet(0.0);
        let computed = series(oscillator, duration, &line);
        for (i, component) in computed.iter().enumerate() {
            let [value, first, second, third] = component.coefficients();
            // The steps are whole ones and parts of them: as exact as either.
            assert!((value - here.value[i]).abs() < 1e-13);
            assert!((first - (here.jacobian.row(i) * q)[0]).abs() < 1e-12);
            assert!((second - bend(0.0, i)).abs() < 1e-11);
            // Steps h and h/2 extrapolated: an error of h⁴/4 = 6e-15 times a fifth derivative, and
            // rounding, 1e-12/h.
            let difference = |h: f64| (bend(h, i) - bend(-h, i)) / (2.0 * h) / 3.0;
            let h = 4e-4;
            let extrapolated = (4.0 * difference(0.5 * h) - difference(h)) / 3.0;
            let error = third - extrapolated;
            assert!(error.abs() < 1e-8 * (1.0 + third.abs()), "{duration}: {third} {extrapolated}");
        }
    }
}

#[test]
fn third_derivatives_of_nonlinear_flows_are_those_of_differences() {
    assert_series(&Integrated::new(Duffing, [0.6, 0.76]));
    assert_series(&Integrated::new(Saturating, [0.6, 0.76]));
}

/// Compares the flow for a time that moves along a curve with the flow in many short flights, which
/// also move along it and take steps of their own; to second order also with the derivatives in all
/// directions.
fn assert_composition<M: SmoothOscillator>(oscillator: &Integrated<M>, tolerance: f64) {
    const FLIGHTS: u32 = 200;
    let assert_same = |a: f64, b: f64, order: usize| {
        let error = (a - b).abs() / (1.0 + b.abs());
        assert!(error < tolerance, "order {order}: {a} {b}, {error:e}");
    };
    for duration in [-3.0, 6.0] {
        let jet = oscillator.flow::<2>(FROM, duration);
        for curve in &CURVES {
            let whole = series(oscillator, duration, curve);
            let [mut x, mut y, mut z, s] = along(duration, curve);
            let part = s.scale(1.0 / f64::from(FLIGHTS));
            for _ in 0..FLIGHTS {
                [x, y] = oscillator.flow_series([x, y, z], part);
                z = z + part.scale(oscillator.forcing_frequency().value);
            }
            let [first, second] =
                [curve[0], curve[1]].map(|[a, b, c, d]| SVector::from([a, b, c, d, 0.0, 0.0]));
            for (i, parts) in [x, y].iter().enumerate() {
                let parts = parts.coefficients();
                for (order, (a, b)) in whole[i].coefficients().into_iter().zip(parts).enumerate() {
                    assert_same(a, b, order);
                }
                let slopes = jet.jacobian.row(i).transpose();
                let bend = slopes.dot(&second) + 0.5 * first.dot(&(jet.hessians[i] * first));
                for (order, exact) in [jet.value[i], slopes.dot(&first), bend].into_iter().enumerate() {
                    assert_same(exact, parts[order], order);
                }
            }
        }
    }
}

#[test]
fn flow_along_a_curve_is_that_of_many_short_flights() {
    // Roundings of many flights.
    assert_composition(&Integrated::new(Duffing, [0.6, 0.76]), 1e-12);
    assert_composition(&Integrated::new(Saturating, [0.6, 0.76]), 1e-12);
    // Steps follow the solution and its first derivatives: each order has errors some thirty times
    // as large as the one before, of about 1e-13 to begin with, and three times that where the
    // force itself bends on the length of a step, as drag does.
    assert_composition(&Integrated::new(Bouncing, [0.6, 0.76]), 3e-11);
    assert_composition(&Integrated::new(Sticking, [0.6, 0.76]), 3e-11);
    assert_composition(&Integrated::new(Dragged, [0.6, 0.76]), 1e-10);
}

/// A reset law that is nonlinear in both arguments.
#[derive(Clone, Debug)]
struct Bent;

impl SmoothOscillator for Bent {
    fn force<S: Scalar>(&self, x: S, y: S, t: S, amplitude: S, omega: S) -> S {
        Duffing.force(x, y, t, amplitude, omega)
    }

    fn forcing_frequency<S: Scalar>(&self, _: S, omega: S) -> S {
        omega
    }

    fn restitution<S: Scalar>(&self, y: S, z: S, mu: S, _: S) -> S {
        S::constant(0.9) - (y * z).apply(Function::Tanh) * mu
    }

    fn impact_duration<S: Scalar>(&self, y: S, z: S, _: S, eta: S) -> S {
        (y - z).apply(Function::Sin) * eta
    }
}

#[test]
fn impact_and_flight_to_a_plane_of_constant_phase_agree_with_differences() {
    let oscillator = Integrated::new(Bent, [0.6, 0.76]);
    let (point, direction, target) = ([0.4, 0.2], [0.6, -0.8], 7.0);
    let image = |[y, z]: [Taylor; 2]| {
        let recoil = oscillator.reset_series(y, z);
        oscillator.to_phase_series(recoil, target)
    };
    let [y, z] = [0, 1].map(|i| Taylor::new([point[i], direction[i], 0.0, 0.0]));
    let computed = image([y, z]);
    let bend = |parameter: f64, i: usize| {
        let [y, z] = [0, 1].map(|k: usize| point[k] + parameter * direction[k]);
        let reset = oscillator.reset::<2>(OnWall::new(y, z));
        let from = State::from(reset.image());
        let flight = maps::to_phase::<_, 2, _>(&oscillator, &oscillator.motion(from), from, target);
        let q = Vector4::new(direction[0], direction[1], 0.0, 0.0);
        0.5 * q.dot(&(flight.after::<2, _>(&reset).hessians[i] * q))
    };
    for (i, component) in computed.iter().enumerate() {
        let [.., second, third] = component.coefficients();
        assert!((second - bend(0.0, i)).abs() < 1e-11);
        // Same method as for the Duffing oscillator's flow, with a longer step.
        let difference = |h: f64| (bend(h, i) - bend(-h, i)) / (2.0 * h) / 3.0;
        let h = 1e-3;
        let extrapolated = (4.0 * difference(0.5 * h) - difference(h)) / 3.0;
        let error = third - extrapolated;
        assert!(error.abs() < 1e-8 * (1.0 + third.abs()), "{third} {extrapolated}");
    }
}

#[test]
fn a_solution_that_escapes_is_not_a_number() {
    let oscillator = Integrated::new(crate::models::Escaping, [0.6, 0.76]);
    let [x, y] = series(&oscillator, 40.0, &CURVES[0]);
    assert!(x.value().is_nan() && y.value().is_nan());
}
