//! The search for grazing of motion without the wall: its results, and the errors where there is
//! none.

use core::f64::consts::{PI, TAU};

use grazing_model::maps::global_map;
use grazing_model::motion::Motion;
use grazing_model::smooth::Stop;
use grazing_model::{AtRest, ImpactOscillator, State};
use grazing_results::Dimensioned;
use grazing_theorems::from_map::GrazingOrbit;
use grazing_theorems::spectrum::in_trapesium;
use grazing_unfold::grazing::{GrazingCurve, GrazingCurvePoint, GrazingEnd};
use grazing_unfold::non_impacting::periodic_motion;
use grazing_unfold::{Scope, UnfoldError};

use crate::specimens::{
    DAMPED, EPSILON, ZETA, assert_within, closed_form, described, grazing_at, grazing_curve, grazing_curves,
    scope, written,
};

/// Tolerance: integration and Newton's method leave some 10⁻¹² each.
const EXACT: f64 = 1e-11;

/// Checks that every point is a grazing orbit inside the ranges, with the reported properties.
#[track_caller]
fn assert_grazes(curve: &GrazingCurve, scope: &Scope) {
    assert!(curve.states.len() > 10);
    for state in &curve.states {
        let (oscillator, phase) = (state.orbit.oscillator(), state.orbit.phase());
        let landing = global_map::<_, 1>(oscillator, AtRest::new(0.0, phase), None).unwrap().jet.value;
        assert_within(landing[0], 0.0, 1e-10);
        assert_within(landing[1], phase, 1e-10);
        let period = oscillator.forcing_period();
        let motion = oscillator.motion(State::on_wall(0.0, phase));
        let back = motion.at(period);
        // P_global alone could return at another time than after a period.
        assert_within(back.position, 0.0, 1e-10);
        assert_within(back.velocity, 0.0, 1e-10);
        let highest = motion.highest_maximum(period).map_or(0.0, |maximum| maximum.position);
        assert_eq!(state.admissible, highest <= 1e-11, "{highest:e}");
        let [primary, secondary] = oscillator.parameters();
        let within = |[low, high]: [f64; 2], value: f64| (low - 1e-12..=high + 1e-12).contains(&value);
        assert!(within(scope.window.primary, primary) && within(scope.window.secondary, secondary));
    }
}

/// The force of the paper's oscillator with a given amplitude and phase of the forcing.
fn linear(amplitude: &str, phase: &str) -> String {
    format!("-2*zeta*v - x - 1 + ({amplitude})*cos({phase})")
}

#[test]
fn the_grazing_curve_of_the_linear_oscillator_is_that_of_the_closed_form() {
    // From rest (no amplitude) to the pole of the response and beyond.
    let scope = scope([0.0, 9.0], [0.2, 3.0], &[]);
    let curve = grazing_curve(&closed_form(), &scope);
    assert_grazes(&curve, &scope);
    assert_eq!(curve.ends, [GrazingEnd::LeftWindow; 2]);
    let parameters: Vec<_> = curve.parameters().collect();
    assert_eq!([parameters[0][1], parameters[parameters.len() - 1][1]], scope.window.secondary);
    for state in &curve.states {
        let [amplitude, frequency] = state.orbit.oscillator().parameters();
        assert_within(amplitude, grazing_at(ZETA, frequency).amplitude(), EXACT);
        let gap = libm::remainder(state.orbit.phase() - grazing_at(ZETA, frequency).phase(), TAU);
        assert_within(gap, 0.0, EXACT);
        let slope = state.tangent[1] / state.tangent[2];
        // The tangent comes from Jacobians at the last iterate but one, which is 10⁻⁷ away at most.
        assert_within(slope, grazing_at(ZETA, frequency).amplitude_derivative(), 1e-6 * (1.0 + slope.abs()));
        assert!(state.multipliers.stable() && state.admissible);
    }
    for frequency in [0.2, 0.55, 1.0, 1.7, 3.0] {
        let place = curve.at(frequency).unwrap();
        assert_within(place.parameters[0], grazing_at(ZETA, frequency).amplitude(), EXACT);
        let there = curve.states[0].orbit.oscillator().with_parameters(place.parameters);
        assert!(curve.passes(&GrazingOrbit::at(there, place.phase).unwrap(), &scope));
    }
    assert!(curve.at(3.1).is_none());
}

/// With so little damping A hardly changes where the phase turns by half a circle; this happens at
/// one of the values of omega at which grazing is looked for.
#[test]
fn a_grazing_curve_is_found_once_though_its_phase_turns_at_one_frequency() {
    let oscillator = crate::specimens::linear(1e-4, EPSILON, [0.5, 0.8]);
    let curves = grazing_curves(&oscillator, &scope([0.0, 1.2], [0.3, 1.1], &[])).unwrap();
    assert_eq!(curves.len(), 1);
}

#[test]
fn a_grazing_curve_that_leaves_through_the_side_ends_on_the_edge() {
    let scope = scope([0.3, 0.6], [0.2, 1.0], &[]);
    let curve = grazing_curve(&closed_form(), &scope);
    assert_grazes(&curve, &scope);
    assert_eq!(curve.ends, [GrazingEnd::LeftWindow; 2]);
    let parameters: Vec<_> = curve.parameters().collect();
    for (at, edge) in [(parameters[0], 0.6), (parameters[parameters.len() - 1], 0.3)] {
        assert_eq!(at[0], edge);
        assert_within(grazing_at(ZETA, at[1]).amplitude(), edge, EXACT);
    }
}

#[test]
fn amplitudes_of_both_signs_have_a_piece_of_grazing_curve_each() {
    let scope = scope([-1.0, 1.0], [0.5, 0.9], &[]);
    let curves = grazing_curves(&written(&linear("mu", "eta*t"), "eta", &scope), &scope).unwrap();
    assert_eq!(curves.len(), 2);
    let mut signs = Vec::new();
    for curve in &curves {
        assert_grazes(curve, &scope);
        let sign = curve.states[0].orbit.primary().signum();
        signs.push(sign);
        for state in &curve.states {
            let [amplitude, frequency] = state.orbit.oscillator().parameters();
            let grazing = grazing_at(DAMPED, frequency);
            assert_within(amplitude, sign * grazing.amplitude(), EXACT);
            let shift = if sign > 0.0 { 0.0 } else { PI };
            let gap = libm::remainder(state.orbit.phase() - grazing.phase() - shift, TAU);
            assert_within(gap, 0.0, EXACT);
        }
        assert_eq!(curve.states[0].orbit.grazing_point().map.transversality().signum(), sign);
    }
    signs.sort_by(f64::total_cmp);
    assert_eq!(signs, [-1.0, 1.0]);
}

#[test]
fn the_frequency_may_depend_on_both_parameters() {
    let scope = scope([0.1, 0.7], [0.55, 0.8], &[]);
    let frequency = "eta + 0.1*mu";
    let curve = grazing_curve(&written(&linear("mu", "(eta + 0.1*mu)*t"), frequency, &scope), &scope);
    assert_grazes(&curve, &scope);
    assert_eq!(curve.ends, [GrazingEnd::LeftWindow; 2]);
    for [mu, eta] in curve.parameters() {
        assert_within(mu, grazing_at(DAMPED, eta + 0.1 * mu).amplitude(), EXACT);
    }
}

#[test]
fn the_secondary_parameter_may_be_the_stiffness() {
    let scope = scope([0.0, 1.5], [0.8, 2.0], &[]);
    let force = "-2*zeta*v - eta*x - 1 + mu*cos(0.8*t)";
    let curve = grazing_curve(&written(force, "0.8", &scope), &scope);
    assert_grazes(&curve, &scope);
    for [mu, stiffness] in curve.parameters() {
        // The response to the forcing is as large as the distance of the wall from rest.
        let response = libm::hypot(stiffness - 0.64, 2.0 * DAMPED * 0.8);
        assert_within(mu, response / stiffness, EXACT);
    }
}

#[test]
fn a_grazing_curve_ends_where_motion_is_no_longer_turned_back() {
    let scope = scope([-4.0, 4.0], [0.4, 1.2], &[]);
    let force = "-0.1*v - x - 1 + 0.7*cos(eta*t) + 0.5*cos(2*eta*t + mu)";
    let curves = grazing_curves(&written(force, "eta", &scope), &scope).unwrap();
    let states = || curves.iter().flat_map(|curve| &curve.states);
    // A maximum at the wall becomes a point of inflection there.
    let gamma = |state: &GrazingCurvePoint| state.orbit.grazing_point().gamma;
    assert!(states().map(gamma).fold(f64::INFINITY, f64::min) < 0.01);
    assert!(states().all(|state| gamma(state) > 0.0 && state.multipliers.stable()));
}

/// A linear oscillator whose forcing is as strong as at grazing on the circle of radius 0.3 about
/// (0, 0), and stronger inside.
fn circle(scope: &Scope) -> GrazingCurve {
    let strongest = grazing_at(DAMPED, 0.7).amplitude() + 0.09;
    let force = linear(&format!("{strongest:?} - mu^2 - eta^2"), "0.7*t");
    grazing_curve(&written(&force, "0.7", scope), scope)
}

#[track_caller]
fn assert_on_circle(curve: &GrazingCurve) {
    for state in &curve.states {
        let [mu, eta] = state.orbit.oscillator().parameters();
        // The radius is at least a fifth as sensitive as the amplitude.
        assert_within(libm::hypot(mu, eta), 0.3, 5.0 * EXACT);
        // The tangent comes from Jacobians at the last iterate but one, which is 10⁻⁷ away at most.
        let [_, tangent_mu, tangent_eta] = state.tangent.into();
        let radial = (mu * tangent_mu + eta * tangent_eta) / (0.3 * libm::hypot(tangent_mu, tangent_eta));
        assert_within(radial, 0.0, 1e-6);
    }
}

#[test]
fn a_closed_grazing_curve_is_followed_once_round() {
    let scope = scope([-0.5, 0.6], [-0.45, 0.5], &[]);
    let curve = circle(&scope);
    assert_grazes(&curve, &scope);
    assert_on_circle(&curve);
    assert_eq!(curve.ends, [GrazingEnd::Closed; 2]);
    let parameters: Vec<_> = curve.parameters().collect();
    assert_eq!(parameters[0], parameters[parameters.len() - 1]);
    let turned: f64 = parameters
        .windows(2)
        .map(|pair| {
            let [a, b] = [pair[0], pair[1]].map(|[mu, eta]| libm::atan2(eta, mu));
            libm::remainder(b - a, TAU)
        })
        .sum();
    assert_within(turned.abs(), TAU, 1e-9);
    // At each η between the folds there are two grazing orbits, and both are on it.
    for eta in [-0.2, 0.0, 0.1] {
        let found = periodic_motion(curve.states[0].orbit.oscillator(), &scope, eta).grazing;
        assert_eq!(found.len(), 2);
        assert!(found.iter().all(|orbit| curve.passes(orbit, &scope)));
    }
}

#[test]
fn folds_of_the_grazing_curve_in_either_parameter_are_passed() {
    // The left half of the circle turns back in μ, as does the right half; the upper one in η.
    for (primary, secondary, axis) in
        [([-0.5, 0.0], [-0.5, 0.5], 0), ([0.0, 0.5], [-0.5, 0.5], 0), ([-0.5, 0.5], [0.0, 0.5], 1)]
    {
        let scope = scope(primary, secondary, &[]);
        let curve = circle(&scope);
        assert_grazes(&curve, &scope);
        assert_on_circle(&curve);
        assert_eq!(curve.ends, [GrazingEnd::LeftWindow; 2]);
        let reached = curve.parameters().map(|at| at[axis].abs()).fold(0.0, f64::max);
        // At most half a step from the fold: 0.005 in units of the ranges, squared over the
        // diameter.
        assert_within(reached, 0.3, 1e-4);
        let ends = [&curve.states[0], &curve.states[curve.states.len() - 1]];
        let [a, b] = ends.map(|state| state.orbit.oscillator().parameters());
        assert_within(a[axis], 0.0, EXACT);
        assert_within(b[axis], 0.0, EXACT);
        assert_within((a[1 - axis] - b[1 - axis]).abs(), 0.6, EXACT);
    }
}

/// A spring that stiffens about the position of rest, so strongly that there are two stable motions
/// at one amplitude.
const BISTABLE: &str = "-0.08*v - (x + 1) - 0.8*(x + 1)^3 + mu*cos(eta*t)";

#[test]
fn grazing_on_the_upper_branch_of_a_bistable_oscillator_is_found_beyond_two_folds() {
    let scope = scope([0.0, 0.4], [1.2, 1.3], &[]);
    let oscillator = written(BISTABLE, "eta", &scope);
    let found = periodic_motion(&oscillator, &scope, 1.25).grazing;
    let [orbit] = found.as_slice() else { panic!("{} orbits", found.len()) };
    // Harmonic balance, whose error is the third harmonic, some 0.8/4/8/1.25² of the amplitude.
    let balance = libm::hypot(1.0 - 1.25 * 1.25 + 0.75 * 0.8, 0.08 * 1.25);
    assert_within(orbit.primary(), balance, 0.03);
    // The branch that the motion follows from rest ends in its first fold at a greater amplitude.
    let square: f64 = (1.25 * 1.25 - 1.0) / (3.0 * 0.75 * 0.8);
    let fold: f64 = (1.0 - 1.25 * 1.25 + 0.75 * 0.8 * square) * square.sqrt();
    assert!(orbit.primary() < 0.6 * fold.abs());
    let map = orbit.grazing_point().map;
    assert!(in_trapesium(map.trace(), map.determinant()));
}

/// Attraction that exceeds the spring at the wall but not slightly farther off, with ranges in
/// which forcing nevertheless turns motion back from the wall: with a pole behind the wall, and
/// with another well there that captures motion.
const ADHESIVE: [(&str, [[f64; 2]; 2]); 2] = [
    ("25*(0.5/(0.5 - x))^2", [[5.0, 25.0], [1.7, 1.8]]),
    ("22/(1 + ((x - 0.1)/0.1)^2)", [[1.0, 9.0], [1.2, 1.3]]),
];

#[test]
fn motion_relaxes_about_rest_in_front_of_a_wall_that_attracts_more_than_the_spring() {
    for (attraction, ranges) in ADHESIVE {
        let force = format!("-2*zeta*v - x - 10 + {attraction} + mu*cos(eta*t)");
        let description = described([&force, "eta", "0"], EPSILON, ranges);
        let units = description.units();
        let scope = scope(ranges[0], ranges[1], &[]).without_dimensions(&units);
        let [primary, secondary] = scope.window.parameters([1.0, 0.5]);
        let oscillator = description.counted([primary, secondary], &units, &Stop::default());
        let begun = Scope { start: Some([-10.0 / units.length, 0.0]), ..scope.clone() };
        let orbits = |scope| periodic_motion(&oscillator, scope, secondary).grazing;
        let both = [&scope, &begun].map(orbits);
        let [[found], [wanted]] = both.each_ref().map(Vec::as_slice) else {
            panic!("{attraction}: {both:?}")
        };
        assert_within(found.primary(), wanted.primary(), EXACT);
        assert!(grazing_curve(&oscillator, &scope).passes(found, &scope), "{attraction}");
    }
}

#[test]
fn a_grazing_curve_loses_its_stability_where_the_free_motion_folds() {
    let scope = scope([0.0, 0.4], [1.2, 1.4], &[]);
    let curve = grazing_curve(&written(BISTABLE, "eta", &scope), &scope);
    assert_grazes(&curve, &scope);
    let stable: Vec<_> = curve.states.iter().map(|state| state.multipliers.stable()).collect();
    let changes: Vec<_> = (1..stable.len()).filter(|k| stable[*k] != stable[k - 1]).collect();
    let [change] = changes.as_slice() else { panic!("{} changes", changes.len()) };
    assert!(stable[0] && !stable[stable.len() - 1]);
    // β = det(A − I) is zero where a multiplier of the free motion is one; its sign gives the side
    // of the fold.
    for state in &curve.states {
        let map = state.orbit.grazing_point().map;
        assert_eq!(state.multipliers.stable(), 1.0 - map.trace() + map.determinant() > 0.0);
    }
    let eta = curve.states[*change].orbit.oscillator().parameters()[1];
    // Harmonic balance: the amplitude 1 is that of the lower fold at ω² = 1 + 3/4 κ.
    assert_within(eta, 1.6_f64.sqrt(), 0.03);
}

#[test]
fn motion_that_runs_away_is_said_to() {
    let scope = scope([0.0, 1.0], [0.5, 1.0], &[]);
    let error =
        grazing_curves(&written("5 + x^3 - 0.1*v + mu*cos(eta*t)", "eta", &scope), &scope).unwrap_err();
    let UnfoldError::RunsAway { escape } = error else { panic!("{error}") };
    let at = escape.parameters;
    assert!((0.0..=1.0).contains(&at[0]) && (0.5..=1.0).contains(&at[1]));
    assert!(escape.position > 1e3 && escape.time > 0.0, "{escape:?}");
}

#[test]
fn motion_that_drifts_has_no_periodic_orbit() {
    // The drift is so slow that the motion seems to have settled.
    let scope = scope([0.0, 1.0], [0.5, 1.0], &[]);
    let error = grazing_curves(&written("1e-4 - v + mu*cos(eta*t)", "eta", &scope), &scope).unwrap_err();
    assert_eq!(error, UnfoldError::NoOrbit);
}

#[test]
fn motion_that_stays_below_the_wall_is_described_by_its_highest_points() {
    let scope = scope([0.0, 0.05], [0.5, 0.6], &[]);
    let error = grazing_curves(&closed_form(), &scope).unwrap_err();
    let UnfoldError::NoGrazing { lowest, highest, whole: true } = error else { panic!("{error}") };
    // At rest without forcing; the response grows with the amplitude and towards ω = 1.
    assert_within(lowest.position, -1.0, EXACT);
    assert_eq!(lowest.parameters[0], 0.0);
    assert_eq!(highest.parameters, [0.05, 0.6]);
    assert_within(highest.position, 0.05 / grazing_at(ZETA, 0.6).amplitude() - 1.0, EXACT);
    assert!(highest.acceleration < 0.0);
}

#[test]
fn motion_that_stays_beyond_the_wall_is_described_by_its_highest_points() {
    let scope = scope([0.0, 0.05], [0.5, 0.6], &[]);
    let error =
        grazing_curves(&written("-2*zeta*v - x + 1 + mu*cos(eta*t)", "eta", &scope), &scope).unwrap_err();
    let UnfoldError::NoGrazing { lowest, highest, whole: true } = error else { panic!("{error}") };
    assert_within(lowest.position, 1.0, EXACT);
    assert_within(highest.position, 1.0 + 0.05 / grazing_at(DAMPED, 0.6).amplitude(), EXACT);
}

#[test]
fn motion_that_cannot_be_followed_through_the_range_is_not_said_to_have_been() {
    // The motion reaches x = −2.2, where the force has no value, before it reaches the wall.
    let scope = scope([0.0, 1.2], [0.95, 1.05], &[]);
    let force = "-2*zeta*v - ln(x + 2.2) - 1 + mu*cos(eta*t)";
    let error = grazing_curves(&written(force, "eta", &scope), &scope).unwrap_err();
    let UnfoldError::NoGrazing { highest, whole: false, .. } = error else { panic!("{error}") };
    assert!(highest.position < 0.0 && highest.parameters[0] < 1.0, "{highest:?}");
}

#[test]
fn rest_that_is_carried_through_the_wall_does_not_graze() {
    // Forcing of no size: the position of rest is μ, and where it reaches the wall F = 0.
    let scope = scope([-0.5, 0.55], [0.5, 1.0], &[]);
    let error =
        grazing_curves(&written("-0.1*v - x + mu + 0*cos(eta*t)", "eta", &scope), &scope).unwrap_err();
    let UnfoldError::Pushed { at } = error else { panic!("{error}") };
    assert_within(at.acceleration, 0.0, EXACT);
    // The nearer of two points of the branch, one step apart.
    assert_within(at.parameters[0], 0.0, 0.05);
}

#[test]
fn a_start_of_ones_own_leads_to_motion_that_the_usual_ones_miss() {
    // Two wells, at −2 and −10; all usual starts fall into the one nearer to the wall, from which
    // there is no grazing here.
    let force = "-0.2*v - 0.05*(x + 2)*(x + 6)*(x + 10) + mu*cos(eta*t)";
    let scope = scope([0.0, 0.02], [0.9, 1.0], &[]);
    let oscillator = written(force, "eta", &scope);
    let highest = |scope: &Scope| match grazing_curves(&oscillator, scope).unwrap_err() {
        UnfoldError::NoGrazing { lowest, highest, .. } => [lowest.position, highest.position],
        error => panic!("{error}"),
    };
    let usual = highest(&scope);
    assert!(usual.iter().all(|position| (position + 2.0).abs() < 0.5), "{usual:?}");
    let both = highest(&Scope { start: Some([-10.0, 0.0]), ..scope.clone() });
    assert!((both[0] + 10.0).abs() < 0.5 && (both[1] - usual[1]).abs() < 1e-9, "{both:?}");
}
