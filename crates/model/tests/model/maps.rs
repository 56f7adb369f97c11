//! The maps between Σ and Π: their asymptotics, their derivatives, and how they fit together.

use grazing_model::maps::{
    MapError, discontinuity_map, global_iterate, global_map, to_phase, virtual_map, virtual_preimage,
};
use grazing_model::{AtPhase, AtRest, ImpactOscillator, LinearOscillator, MapJet, OnWall, State};
use nalgebra::Vector2;

const ZETA: f64 = 0.02;
const EPSILON: f64 = 0.9;
const OMEGA: f64 = 0.855;

/// The oscillator at its grazing bifurcation (eq:Agraz), and the grazing phase.
fn at_grazing(omega: f64) -> (LinearOscillator, f64) {
    let (stiffness, loss) = (1.0 - omega * omega, 2.0 * ZETA * omega);
    let amplitude = libm::hypot(stiffness, loss);
    (LinearOscillator::new(ZETA, EPSILON, amplitude, omega).unwrap(), libm::atan2(loss, stiffness))
}

/// The observed order of convergence of an error as its scale is halved: log₂ of the ratio.
fn order(errors: [f64; 2]) -> f64 {
    libm::log2(errors[0] / errors[1])
}

/// An oscillator near grazing, with y, z − z_graz and μ all of the size ε, as in the O(·) terms of
/// Lemma 4.1.
fn near_grazing(size: f64) -> (LinearOscillator, f64, f64, f64) {
    let (oscillator, graz) = at_grazing(OMEGA);
    let [amplitude, omega] = oscillator.parameters();
    let near = oscillator.with_parameters([amplitude + 0.6 * size, omega]);
    (near, size, graz - 0.7 * size, graz)
}

#[test]
fn virtual_point_of_an_impact_has_the_printed_expansion() {
    // eq:xHatzHat: third order in x, second order in z. Slack of 0.1: higher-order terms at these
    // sizes.
    let (gamma, omega) = (OMEGA * OMEGA, OMEGA);
    let errors = |size: f64| {
        let (oscillator, y, z, _) = near_grazing(size);
        let point = virtual_map::<_, 1>(&oscillator, OnWall::new(y, z), None).unwrap().jet.value;
        [(point[0] - y * y / (2.0 * gamma)).abs(), (point[1] - (omega * y / gamma + z)).abs()]
    };
    let (coarse, fine) = (errors(2e-3), errors(1e-3));
    assert!((order([coarse[0], fine[0]]) - 3.0).abs() < 0.1);
    assert!((order([coarse[1], fine[1]]) - 2.0).abs() < 0.1);
}

#[test]
fn virtual_point_of_the_recoil_has_the_printed_expansion() {
    // eq:x0z0 with φ = ε and α = 1 + ε.
    let (gamma, omega, alpha) = (OMEGA * OMEGA, OMEGA, 1.0 + EPSILON);
    let errors = |size: f64| {
        let (oscillator, y, z, _) = near_grazing(size);
        let recoil = oscillator.reset::<1>(OnWall::new(y, z)).image();
        let point = virtual_map::<_, 1>(&oscillator, recoil, None).unwrap().jet.value;
        let x = EPSILON * EPSILON * y * y / (2.0 * gamma);
        [(point[0] - x).abs(), (point[1] - (omega * (1.0 - alpha) / gamma * y + z)).abs()]
    };
    let (coarse, fine) = (errors(2e-3), errors(1e-3));
    assert!((order([coarse[0], fine[0]]) - 3.0).abs() < 0.1);
    assert!((order([coarse[1], fine[1]]) - 2.0).abs() < 0.1);
}

#[test]
fn discontinuity_map_has_a_square_root() {
    // z⁽⁰⁾ − ẑ = −αω√2/√γ √x̂ to leading order, so its error is of order x̂; x⁽⁰⁾ = φ² x̂ with an
    // error of order x̂^{3/2}.
    let (oscillator, graz) = at_grazing(OMEGA);
    let errors = |x: f64| {
        let image = discontinuity_map::<_, 1>(&oscillator, AtRest::new(x, graz)).unwrap().value;
        let root = -(1.0 + EPSILON) * OMEGA * (2.0 * x).sqrt() / OMEGA;
        [(image[0] - EPSILON * EPSILON * x).abs(), (image[1] - graz - root).abs()]
    };
    let (coarse, fine) = (errors(2e-6), errors(1e-6));
    assert!((order([coarse[0], fine[0]]) - 1.5).abs() < 0.05);
    assert!((order([coarse[1], fine[1]]) - 1.0).abs() < 0.05);
}

#[test]
fn preimage_under_the_virtual_map_is_the_impact() {
    let (oscillator, graz) = at_grazing(OMEGA);
    for (y, z) in [(1e-6, graz), (0.05, graz + 0.1), (0.6, graz - 0.3)] {
        let top = virtual_map::<_, 1>(&oscillator, OnWall::new(y, z), None).unwrap().jet.image();
        let back = virtual_preimage(&oscillator, top).unwrap();
        // y is the square root of x: rounding of x of order one costs 1e-16/y.
        assert!((back.velocity - y).abs() < 1e-14 + 4e-16 / y, "{back:?} {y}");
        assert!((back.phase - z).abs() < 1e-14 + 4e-16 / y);
    }
    assert_eq!(virtual_preimage(&oscillator, AtRest::new(0.0, graz)), Ok(OnWall::new(0.0, graz)));
    assert_eq!(
        virtual_preimage(&oscillator, AtRest::new(-0.1, graz)),
        Err(MapError::BelowTheWall { position: -0.1 })
    );
}

#[test]
fn every_point_near_grazing_beyond_the_wall_has_a_preimage() {
    let (oscillator, graz) = at_grazing(OMEGA);
    for exponent in 2..=14 {
        for share in 0..500 {
            let position = libm::pow(10.0, -f64::from(exponent)) * (1.0 + 0.01 * f64::from(share));
            let phase = graz + 1e-3 * f64::from(share - 250);
            let preimage = virtual_preimage(&oscillator, AtRest::new(position, phase)).unwrap();
            let image = virtual_map::<_, 1>(&oscillator, preimage, None).unwrap().jet.value;
            // Roundings of the position, of order one, and of the phase.
            assert!((image[0] - position).abs() < 1e-14 && (image[1] - phase).abs() < 1e-14);
        }
    }
}

#[test]
fn grazing_is_a_fixed_point_of_the_global_map() {
    for omega in [0.4, 0.5, 0.67, 0.85, 0.99] {
        let (oscillator, graz) = at_grazing(omega);
        let image = global_map::<_, 1>(&oscillator, AtRest::new(0.0, graz), None).unwrap();
        assert!((image.jet.value - Vector2::new(0.0, graz)).norm() < 1e-13);
        assert!((image.time - oscillator.forcing_period()).abs() < 1e-12);
    }
}

/// Central differences of a map in all four variables, of sixth order, and the noise of the values
/// divided by the step.
fn differences<A: Copy, B: Copy>(map: impl Fn([f64; 4]) -> MapJet<A, B>, at: [f64; 4]) -> [MapJet<A, B>; 2] {
    let step = 4e-4;
    let weights = [(1.0, 3.0 / 4.0), (2.0, -3.0 / 20.0), (3.0, 1.0 / 60.0)];
    let exact = map(at);
    let mut approximate = exact;
    approximate.jacobian.fill(0.0);
    approximate.hessians.iter_mut().for_each(|hessian| hessian.fill(0.0));
    for k in 0..4 {
        for (reach, weight) in weights {
            for side in [1.0, -1.0] {
                let mut shifted = at;
                shifted[k] += side * reach * step;
                let value = map(shifted);
                let share = side * weight / step;
                for i in 0..2 {
                    approximate.jacobian[(i, k)] += share * value.value[i];
                    for a in 0..4 {
                        approximate.hessians[i][(a, k)] += share * value.jacobian[(i, a)];
                    }
                }
            }
        }
    }
    [exact, approximate]
}

/// Compares first derivatives with differences of values, second ones with differences of first
/// ones.
///
/// Tolerance: the differences' own error is about step⁶ times a seventh derivative (which for
/// P_disc is large) plus 1e-15/step.
fn assert_derivatives<A: Copy, B: Copy>(map: impl Fn([f64; 4]) -> MapJet<A, B>, at: [f64; 4]) {
    let [exact, approximate] = differences(map, at);
    let scale = |value: f64| 1e-9 * (1.0 + value.abs());
    for i in 0..2 {
        for a in 0..4 {
            let (hand, numeric) = (exact.jacobian[(i, a)], approximate.jacobian[(i, a)]);
            assert!((hand - numeric).abs() < scale(hand), "d{i}/d{a}: {hand} {numeric}");
            for b in 0..4 {
                let (hand, numeric) = (exact.hessians[i][(a, b)], approximate.hessians[i][(a, b)]);
                assert!((hand - numeric).abs() < scale(hand), "d2{i}/d{a}d{b}: {hand} {numeric}");
            }
        }
    }
}

#[test]
fn implicit_derivatives_of_all_maps_are_right() {
    let (oscillator, graz) = at_grazing(OMEGA);
    let [amplitude, omega] = oscillator.parameters();
    let at = |v: [f64; 4]| oscillator.with_parameters([v[2], v[3]]);
    let wall = |v: [f64; 4]| OnWall::new(v[0], v[1]);
    let rest = |v: [f64; 4]| AtRest::new(v[0], v[1]);
    let here = [0.3, graz - 0.1, amplitude + 0.02, omega];
    assert_derivatives(|v| virtual_map::<_, 2>(&at(v), wall(v), None).unwrap().jet, here);
    assert_derivatives(
        |v| {
            let reset = at(v).reset::<2>(wall(v));
            virtual_map::<_, 2>(&at(v), reset.image(), None).unwrap().jet.after::<2, _>(&reset)
        },
        here,
    );
    let flown = |v, from: State| (at(v), at(v).motion(from), from);
    let landed = |v| {
        let (oscillator, motion, from) = flown(v, wall(v).into());
        to_phase::<_, 2, OnWall>(&oscillator, &motion, from, 6.0)
    };
    assert_derivatives(landed, here);
    let on_section = [-0.05, graz + 0.1, amplitude, omega];
    assert_derivatives(|v| global_map::<_, 2>(&at(v), rest(v), None).unwrap().jet, on_section);
    assert_derivatives(|v| global_iterate::<_, 2>(&at(v), 3, rest(v)).unwrap(), on_section);
    let beyond_the_wall = [0.08, graz + 0.1, amplitude, omega];
    assert_derivatives(|v| discontinuity_map::<_, 2>(&at(v), rest(v)).unwrap(), beyond_the_wall);
    let anywhere = [-0.4, 0.2, amplitude, omega];
    let around = |v: [f64; 4]| {
        let (oscillator, motion, from) = flown(v, AtPhase::new(v[0], v[1]).at_phase_zero());
        to_phase::<_, 2, AtPhase>(&oscillator, &motion, from, core::f64::consts::TAU)
    };
    assert_derivatives(around, anywhere);
}

#[test]
fn a_virtual_maximum_that_is_not_there_is_an_error() {
    // 𝒜 > 1 and phase 0: at the wall the force pushes outwards, and x grows beyond the wall without
    // a maximum nearby before the wall; backwards from the recoil there is none within a period.
    let oscillator = LinearOscillator::new(ZETA, EPSILON, 3.0, 0.1).unwrap();
    assert!(oscillator.acceleration(State::on_wall(0.0, 0.0)) > 0.0);
    let missing = virtual_map::<_, 1>(&oscillator, OnWall::new(1e-3, 0.0), Some(0.01));
    assert!(missing.is_err(), "{missing:?}");
}
