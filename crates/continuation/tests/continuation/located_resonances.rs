//! Resonances located numerically, the directions in which curves leave them, and the coefficients
//! measured on the curves.

use grazing_continuation::arclength::{Continuation, StepControl};
use grazing_continuation::curve::SolutionCurve;
use grazing_continuation::fit::quadratic_coefficient;
use grazing_continuation::locate::Condition;
use grazing_continuation::mps::{EventTimes, Unknowns};
use grazing_theorems::Resonance;

use crate::specimens::{EPSILON, ZETA, assert_close, assert_within, located, resonances};

/// Every resonance with p = 1, …, 4 and 0.3 < ω < 2.
fn all() -> Vec<Resonance> {
    let list = resonances(ZETA, EPSILON, &[1, 2, 3, 4], [0.3, 2.0]);
    assert!(list.len() > 10);
    list
}

#[test]
fn resonances_lie_at_the_closed_form() {
    for resonance in all() {
        let point = located(&resonance).unknowns();
        // Roundings of numbers of order one, with the condition of det J = 0 on the grazing curve:
        // κ_p' and a₁₂' exceed one.
        assert_eq!(point[0], 0.0);
        assert_within(point[3], resonance.forcing_frequency(), 1e-13);
        assert_within(point[2], resonance.grazing().amplitude(), 1e-13);
        // dz/dω is up to a hundred, near ω = 1.
        assert_within(
            point[1],
            resonance.grazing().phase(),
            1e-13 * (1.0 + resonance.grazing().phase_derivative()),
        );
    }
}

const CONDITIONS: [Condition; 2] = [Condition::SADDLE_NODE, Condition::PERIOD_DOUBLING];

#[test]
fn curves_leave_in_the_direction_of_the_theory() {
    for resonance in all() {
        let located = located(&resonance);
        for condition in CONDITIONS {
            let curve = SolutionCurve { equations: located.equations().clone(), condition };
            let direction = located.direction(condition);
            let start = located.unknowns();
            // Started far from the theory's direction, but on its side.
            let aside = &direction + Unknowns::new(0.3, -0.2, 0.1, 0.0) * direction[0].signum();
            let walker =
                Continuation::new(&curve, StepControl::DRAWING, start, aside, EventTimes::default()).unwrap();
            let tangent = walker.here().tangent.clone();
            // Quotients of second derivatives that are right to 10⁻¹², and the condition of the
            // bordered system.
            assert_within((&tangent * tangent.dot(&direction).signum() - direction).norm(), 0.0, 1e-10);
        }
    }
}

#[test]
fn first_point_has_the_multiplier_of_its_curve() {
    // The limits of T and D at y = 0: D = φ² δ^p as everywhere, and 1 ∓ T + D = 0.
    for resonance in all() {
        let located = located(&resonance);
        let delta = resonance.grazing().determinant();
        let determinant = EPSILON * EPSILON * libm::pow(delta, f64::from(resonance.loops()));
        for (condition, sign) in CONDITIONS.into_iter().zip([1.0, -1.0]) {
            let solution =
                located.equations().limiting_solution(&located.unknowns(), &located.direction(condition));
            // Ratios of second derivatives: as for the direction.
            assert_within(solution.multipliers.determinant, determinant, 1e-10);
            assert_within(solution.multipliers.trace, sign * (1.0 + determinant), 1e-10);
        }
    }
}

#[test]
fn coefficients_measured_on_the_curves_are_the_printed_ones() {
    // Frequencies for which the fit's first impact velocity lies on the PD curves of p = 4 and of
    // even n.
    for resonance in resonances(ZETA, EPSILON, &[1, 2, 3, 4], [0.35, 2.0]) {
        let located = located(&resonance);
        let closed = [resonance.saddle_node_coefficient(), resonance.period_doubling_coefficient()];
        for (condition, expected) in CONDITIONS.into_iter().zip(closed) {
            let estimate = quadratic_coefficient(&located, condition).unwrap();
            // The estimate claims its error; that it is also small is a property of the scheme:
            // extrapolated to order eight.
            assert_within(estimate.value, expected, 3.0 * estimate.error);
            assert_close(estimate.value, expected, 1e-7);
            assert!(estimate.error < 1e-5 * expected.abs());
        }
    }
}
