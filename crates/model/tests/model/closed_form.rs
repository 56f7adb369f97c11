//! The linear oscillator, integrated, compared with its closed form.

use grazing_model::maps::{self, global_map, virtual_map};
use grazing_model::motion::{BoundedMotion, Enclosure, Motion, Walk};
use grazing_model::orbit::Orbit;
use grazing_model::{ImpactOscillator, MapJet, OnWall, State};

use crate::models::{FROM, both};

/// Over a period the closed form itself has errors of 1e-14 or so, and second derivatives, up to
/// 80, of 1e-13.
const TOLERANCE: f64 = 1e-12;

#[test]
fn flow_and_its_derivatives_are_those_of_the_closed_form() {
    let (integrated, closed) = both();
    for duration in [-7.8, -5.0, -0.3, 0.0, 1e-7, 0.2, 3.0, 7.8] {
        let [a, b] = [integrated.flow::<2>(FROM, duration), closed.flow::<2>(FROM, duration)];
        assert!((a.value - b.value).amax() < TOLERANCE, "{duration}");
        assert!((a.jacobian - b.jacobian).amax() < TOLERANCE, "{duration}");
        for i in 0..2 {
            assert!((a.hessians[i] - b.hessians[i]).amax() < TOLERANCE, "{duration}");
        }
        let first = integrated.flow::<1>(FROM, duration);
        // One iteration of Newton's method fewer; the first has left no more than rounding.
        assert!((first.value - a.value).amax() < 1e-14);
        assert!((first.jacobian - a.jacobian).amax() < TOLERANCE);
        assert!(first.hessians.iter().all(|hessian| hessian.amax() == 0.0));
    }
}

#[test]
fn flow_along_a_motion_is_the_flow() {
    let (integrated, _) = both();
    let motion = integrated.motion(FROM);
    // The motion is already known beyond the time that is needed, and in the other direction.
    assert!(motion.at(30.0).position.is_finite() && motion.at(-20.0).position.is_finite());
    for duration in [-6.0, 0.0, 0.4, 9.0] {
        let along = integrated.flow_along::<2>(&motion, FROM, duration);
        assert_eq!(along, integrated.flow::<2>(FROM, duration));
    }
}

#[test]
fn motion_is_that_of_the_closed_form_in_both_directions_of_time() {
    let (integrated, closed) = both();
    let (a, b) = (integrated.motion(FROM), closed.motion(FROM));
    // In arbitrary order, as nodes are computed on demand.
    for time in [3.1, -2.0, 0.0, 11.0, 0.7, -9.0, 10.9] {
        let [a, b] = [a.at(time), b.at(time)];
        assert!((a.position - b.position).abs() < TOLERANCE);
        assert!((a.velocity - b.velocity).abs() < TOLERANCE);
        assert!((a.acceleration - b.acceleration).abs() < TOLERANCE);
        assert!((a.jerk - b.jerk).abs() < TOLERANCE);
    }
    let enclosure = a.enclose(20.0);
    let mut walk = enclosure.walk();
    assert!(enclosure.strides() > 20 && enclosure.time_after(enclosure.strides()) <= 20.0);
    for k in 0..enclosure.strides() {
        let time = enclosure.time_after(k);
        assert!((walk.position() - b.at(time).position).abs() < TOLERANCE);
        assert!((walk.kinematics().jerk - b.at(time).jerk).abs() < TOLERANCE);
        walk.advance();
    }
}

#[test]
fn events_are_those_of_the_closed_form() {
    let (integrated, closed) = both();
    for phase in [0.3, 1.1, 2.9, 5.0] {
        let from = State { phase, ..FROM };
        let (a, b) = (integrated.motion(from), closed.motion(from));
        let (left, right) = (a.local_maxima(40.0), b.local_maxima(40.0));
        assert!(left.len() == right.len() && left.len() > 4);
        for (a, b) in left.iter().zip(&right) {
            assert!((a.time - b.time).abs() < TOLERANCE && (a.position - b.position).abs() < TOLERANCE);
        }
        let [a_top, b_top] = [a.highest_maximum(40.0), b.highest_maximum(40.0)].map(Option::unwrap);
        assert!((a_top.time - b_top.time).abs() < TOLERANCE);
        let [a_hit, b_hit] = [a.first_crossing(40.0), b.first_crossing(40.0)];
        assert_eq!(a_hit.is_some(), b_hit.is_some());
        if let (Some(a), Some(b)) = (a_hit, b_hit) {
            assert!((a.time - b.time).abs() < TOLERANCE && (a.velocity - b.velocity).abs() < TOLERANCE);
        }
        for forwards in [true, false] {
            let [a, b] = [a.first_rest(forwards, 8.0), b.first_rest(forwards, 8.0)].map(Option::unwrap);
            assert!((a - b).abs() < TOLERANCE);
        }
    }
}

fn assert_same<A, B>(a: &MapJet<A, B>, b: &MapJet<A, B>) {
    assert!((a.value - b.value).amax() < TOLERANCE);
    // Divided by accelerations of 0.1 and more, twice for the second derivatives.
    assert!((a.jacobian - b.jacobian).amax() < 10.0 * TOLERANCE);
    for (a, b) in a.hessians.iter().zip(&b.hessians) {
        assert!((a - b).amax() < 100.0 * TOLERANCE * (1.0 + b.amax()));
    }
}

#[test]
fn maps_between_the_surfaces_are_those_of_the_closed_form() {
    let (integrated, closed) = both();
    for (velocity, phase) in [(0.2, 0.3), (-0.2, 0.1), (0.05, -0.4)] {
        let [a, b] = [
            virtual_map::<_, 2>(&integrated, OnWall::new(velocity, phase), None).unwrap().jet,
            virtual_map::<_, 2>(&closed, OnWall::new(velocity, phase), None).unwrap().jet,
        ];
        assert_same(&a, &b);
        let from = b.image();
        let a = global_map::<_, 2>(&integrated, from, None).unwrap();
        let b = global_map::<_, 2>(&closed, from, None).unwrap();
        assert!((a.time - b.time).abs() < TOLERANCE);
        assert_same(&a.jet, &b.jet);
        let target = phase + core::f64::consts::TAU;
        let from = State::on_wall(velocity, phase);
        let a = maps::to_phase::<_, 2, OnWall>(&integrated, &integrated.motion(from), from, target);
        assert_same(&a, &maps::to_phase::<_, 2, _>(&closed, &closed.motion(from), from, target));
    }
}

#[test]
fn orbits_with_impacts_are_those_of_the_closed_form() {
    let (integrated, closed) = both();
    let a: Vec<_> = Orbit::new(&integrated, FROM, 200.0, 6).collect();
    let b: Vec<_> = Orbit::new(&closed, FROM, 200.0, 6).collect();
    assert!(a.len() == b.len() && a.len() > 2, "{}", a.len());
    for (a, b) in a.iter().zip(&b) {
        // Impacts of low velocity enlarge errors, by less than a thousand in these few.
        assert!((a.duration - b.duration).abs() < 1e-9, "{} {}", a.duration, b.duration);
        assert!((a.from.velocity - b.from.velocity).abs() < 1e-9);
    }
}
