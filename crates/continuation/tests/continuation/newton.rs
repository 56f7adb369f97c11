//! Newton's method: its rate of convergence, and the errors that it returns.

use grazing_continuation::newton::{Linearisation, NewtonFailure, solve};
use grazing_continuation::tolerances::STEP;
use nalgebra::{Matrix1, Matrix2, Vector1, Vector2};

use crate::specimens::assert_within;

/// The equations x² + y² = 4 and xy = 1.
fn circle_and_hyperbola(u: &Vector2<f64>) -> Linearisation<Vector2<f64>> {
    let [x, y] = [u[0], u[1]];
    Linearisation {
        residual: Vector2::new(x * x + y * y - 4.0, x * y - 1.0),
        jacobian: Matrix2::new(2.0 * x, 2.0 * y, y, x),
    }
}

/// One equation f(x) = 0 with its derivative.
fn scalar(value: f64, derivative: f64) -> Linearisation<Vector1<f64>> {
    Linearisation { residual: Vector1::new(value), jacobian: Matrix1::new(derivative) }
}

#[test]
fn convergence_is_quadratic_and_ends_at_rounding() {
    // (x + y)² = 6 and (x − y)² = 2.
    let (sum, difference) = (6f64.sqrt(), 2f64.sqrt());
    let root = Vector2::new(0.5 * (sum + difference), 0.5 * (sum - difference));
    let mut errors = Vec::new();
    let solution = solve(Vector2::new(2.5, 0.1), 20, |u| {
        errors.push((u - root).norm());
        Ok::<_, ()>(circle_and_hyperbola(u))
    })
    .unwrap();
    // ½ |D²F| |DF⁻¹| is at most 1 here: |D²F| ≤ 2 on unit vectors of either component, |DF⁻¹| < 0.6
    // along the way.
    let squared = errors.windows(2).filter(|pair| pair[0] < 0.3 && pair[1] > 1e-14).collect::<Vec<_>>();
    assert!(squared.len() >= 2, "too few steps to judge: {errors:?}");
    for pair in squared {
        assert!(pair[1] <= pair[0] * pair[0], "{errors:?}");
    }
    // A few roundings of numbers of size two.
    assert_within((solution.point - root).norm(), 0.0, 4e-15);
    assert_eq!(solution.iterations, errors.len());
}

#[test]
fn the_last_factors_were_taken_within_the_step_tolerance() {
    let solution = solve(Vector2::new(2.5, 0.1), 20, |u| Ok::<_, ()>(circle_and_hyperbola(u))).unwrap();
    let at_the_end = circle_and_hyperbola(&solution.point);
    // The Jacobian is linear in u with a coefficient of at most 2 in each of four entries.
    let identity = solution.factors.solve(&at_the_end.jacobian).unwrap();
    let inverse = at_the_end.jacobian.try_inverse().unwrap().norm();
    let difference = (identity - nalgebra::Matrix2::identity()).norm();
    assert_within(difference, 0.0, 4.0 * STEP * inverse);
}

#[test]
fn a_singular_jacobian_is_named_with_its_residual() {
    let failure =
        solve(Vector1::new(0.0), 20, |u| Ok::<_, ()>(scalar(u[0] * u[0] + 0.25, 2.0 * u[0]))).unwrap_err();
    assert_eq!(failure, NewtonFailure::Singular { iteration: 1, residual: 0.25 });
}

#[test]
fn a_residual_that_is_not_a_number_is_no_solution() {
    let failure = solve(Vector1::new(0.0), 20, |_| Ok::<_, ()>(scalar(f64::NAN, 1.0))).unwrap_err();
    assert!(matches!(failure, NewtonFailure::Singular { iteration: 1, .. }), "{failure:?}");
}

#[test]
fn an_undefined_iterate_is_named_with_its_cause() {
    // log x = 0 from x = 3: the first step leads to 3 (1 − log 3) < 0.
    let failure = solve(Vector1::new(3.0), 20, |u| {
        if u[0] > 0.0 {
            Ok(scalar(libm::log(u[0]), 1.0 / u[0]))
        } else {
            Err("logarithm of a negative number")
        }
    });
    let cause = "logarithm of a negative number";
    assert_eq!(failure.unwrap_err(), NewtonFailure::Undefined { iteration: 2, cause });
}

#[test]
fn no_zero_is_no_convergence() {
    // x² + 1 from an irrational start: the iteration is chaotic and never singular.
    let failure =
        solve(Vector1::new(2f64.sqrt()), 20, |u| Ok::<_, ()>(scalar(u[0] * u[0] + 1.0, 2.0 * u[0])))
            .unwrap_err();
    let NewtonFailure::NoConvergence { iterations: 20, residual } = failure else {
        panic!("{failure:?}");
    };
    assert!(residual >= 1.0);
}
