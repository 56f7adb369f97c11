//! Oscillators defined by their force, in all the tests that the closed form passes.

use grazing_continuation::curve::Curve;
use grazing_continuation::cusp::cusps;
use grazing_continuation::fit;
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, PeriodicSolution, Unknowns, unknown};
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::ImpactOscillator;
use grazing_model::motion::Motion;
use grazing_model::smooth::Integrated;

use crate::specimens::{
    DUFFING, EPSILON, Spring, ZETA, assert_close, assert_within, duffing, located, resonances, route,
};

#[test]
fn the_linear_oscillator_given_by_its_force_has_the_curves_of_the_closed_form() {
    for closed_form in resonances(ZETA, EPSILON, &[1, 2], [0.5, 1.02]) {
        let closed = located(&closed_form);
        let phase = closed.orbit().phase();
        let [primary, secondary] = closed.orbit().oscillator().parameters();
        let oscillator = Integrated::new(Spring::LINEAR, [primary + 1e-4, secondary]);
        let integrated = ResonantGrazingPoint::find(&oscillator, closed_form.loops(), phase + 1e-4).unwrap();
        // Both are located to about 10⁻¹²; the coefficients come from second derivatives.
        assert_within((integrated.unknowns() - closed.unknowns()).amax(), 0.0, 1e-10);
        let window = route([0.0, 1.3], [secondary - 0.05, secondary + 0.05], true);
        let [a, b] = [integrated.unfold(&window).unwrap(), closed.unfold(&window).unwrap()];
        let mut compared = 0;
        let mut compare = |ours: &Curve, theirs: &Curve| {
            assert_eq!(ours.points.len(), theirs.points.len());
            for point in theirs.points.iter().step_by(5) {
                let unknowns = point.solution.unknowns.clone();
                let conditions = [theirs.condition, Condition::ImpactVelocity(unknowns[0])];
                let mut times = point.times.clone();
                // At y = 0, and at folds in y, these conditions do not define a point.
                let Ok(found) = locate(integrated.equations(), conditions, unknowns.clone(), &mut times)
                else {
                    continue;
                };
                if unknowns[0] > 1e-3 {
                    assert_within((found - unknowns).amax(), 0.0, 1e-8);
                    compared += 1;
                }
            }
        };
        compare(&a.saddle_node, &b.saddle_node);
        compare(&a.period_doubling, &b.period_doubling);
        assert_eq!(a.grazing.len(), b.grazing.len());
        for (a, b) in a.grazing.iter().zip(&b.grazing) {
            compare(a, b);
        }
        assert!(compared > 5, "{compared}");
    }
}

#[test]
fn coefficients_of_a_duffing_oscillator_are_those_of_the_theorem() {
    for (loops, near) in DUFFING {
        let resonance = duffing(loops, near);
        let theorem = resonance.theorem();
        for (condition, curve) in [
            (Condition::SADDLE_NODE, theorem.saddle_node()),
            (Condition::PERIOD_DOUBLING, theorem.period_doubling()),
        ] {
            let fitted = fit::quadratic_coefficient(&resonance, condition).unwrap();
            // Six digits, and no more than the error of the extrapolation.
            assert_close(fitted.value, curve.coefficient, 1e-6);
            assert!(fitted.error < 1e-5 * fitted.value.abs());
        }
    }
}

#[test]
fn a_branch_is_no_parabola_where_its_saddle_node_curve_turns_back_in_a_cusp() {
    // Near the resonance p = 2 of the cubic spring (empirical).
    let start = Integrated::new(Spring { varying: false, ..Spring::DUFFING }, [0.3983, 0.9134]);
    let resonance = ResonantGrazingPoint::find(&start, 2, 0.09).unwrap();
    let secondary = resonance.orbit().oscillator().parameters()[1];
    let curves = resonance.unfold(&route([0.0, 1.5], [secondary - 0.05, secondary + 0.05], true)).unwrap();
    let cusps = cusps(&resonance.curve(Condition::SADDLE_NODE).equations, &curves.saddle_node);
    assert_eq!(cusps.len(), 1);
    // Half the second derivative of μ in y along the branch of fixed η through a saddle-node, by
    // differences.
    let curvature = |solution: &PeriodicSolution| {
        let fold = solution.unknowns.clone();
        let step = 1e-3 * fold[unknown::VELOCITY];
        let at = |velocity: f64| {
            let conditions =
                [Condition::ImpactVelocity(velocity), Condition::Secondary(fold[unknown::SECONDARY])];
            locate(resonance.equations(), conditions, fold.clone(), &mut EventTimes::default()).unwrap()
        };
        let [behind, ahead] = [-step, step].map(|by| at(fold[unknown::VELOCITY] + by)[unknown::PRIMARY]);
        (0.5 * (behind + ahead) - fold[unknown::PRIMARY]) / (step * step)
    };
    let [before, after] = [cusps[0].index - 1, cusps[0].index + 1]
        .map(|index| curvature(&curves.saddle_node.points[index].solution));
    // The curvature changes by its own size within a step; the remainder is rounding over the
    // square of the step, and its square.
    assert!(before * after < 0.0, "{before} {after}");
    assert_within(curvature(&cusps[0].solution) / (before - after), 0.0, 1e-3);
}

#[test]
fn a_flight_takes_what_the_impact_leaves_of_the_periods() {
    for (loops, start) in DUFFING {
        let resonance = duffing(loops, start);
        let (equations, origin) = (resonance.equations(), resonance.unknowns());
        let (velocity, branch) = (0.05, resonance.theorem().branch());
        let offset = Unknowns::new(velocity, branch.k_1 * velocity, branch.parameter(velocity, 0.0), 0.0);
        let conditions =
            [Condition::ImpactVelocity(velocity), Condition::Secondary(origin[unknown::SECONDARY])];
        let point = locate(equations, conditions, origin + offset, &mut EventTimes::default()).unwrap();
        let oscillator = equations.oscillator_at(&point);
        let (departure, flight) = (equations.departure(&point), equations.flight(&point));
        // An impact takes Ψ y, some 0.0025 rad here; the flight still ends at the wall.
        let lag = departure.phase - point[unknown::PHASE];
        assert!(lag > 1e-3);
        let end = oscillator.motion(departure).at(flight);
        assert!(end.position.abs() < 1e-11 && (end.velocity - velocity).abs() < 1e-11, "{end:?}");
        let periods = f64::from(loops) * oscillator.forcing_period();
        let taken = lag / oscillator.forcing_frequency().value;
        assert!((flight + taken - periods).abs() < 1e-13 * periods);
    }
}
