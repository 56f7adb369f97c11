//! Nonlinear forces: properties that need no closed form.

use grazing_model::motion::{BoundedMotion, Enclosure, Motion};
use grazing_model::smooth::{Integrated, SmoothOscillator};
use grazing_model::{ImpactOscillator, State, flow_variable};

use crate::models::{Conservative, Dragged, Duffing, FROM, Saturating};

/// Compares derivatives of the flow with central differences of one order less.
fn assert_derivatives<M: SmoothOscillator>(oscillator: &Integrated<M>) {
    // Differences of order h²: the error is 1e-12 times third derivatives (up to a few hundred),
    // rounding 1e-14/h = 1e-8.
    let (step, tolerance) = (2e-6, 1e-7);
    let [mu, eta] = oscillator.parameters();
    let jet = |variable: usize, by: f64| {
        let mut arguments = [FROM.position, FROM.velocity, FROM.phase, 6.0, mu, eta];
        arguments[variable] += by;
        let [position, velocity, phase, duration, mu, eta] = arguments;
        oscillator.with_parameters([mu, eta]).flow::<2>(State { position, velocity, phase }, duration)
    };
    let here = jet(0, 0.0);
    for variable in 0..6 {
        let [above, below] = [jet(variable, step), jet(variable, -step)];
        let slope = (above.value - below.value) / (2.0 * step);
        assert!((slope - here.jacobian.column(variable)).amax() < tolerance, "{variable}");
        let bend = (above.jacobian - below.jacobian) / (2.0 * step);
        for i in 0..2 {
            let error = (bend.row(i) - here.hessians[i].row(variable)).amax();
            assert!(error < tolerance * (1.0 + here.hessians[i].amax()), "{variable}: {error:e}");
        }
    }
    let end = State {
        position: here.value[0],
        velocity: here.value[1],
        phase: FROM.phase + 6.0 * oscillator.forcing_frequency().value,
    };
    // ẏ = F, to rounding.
    assert!((here.jacobian[(1, flow_variable::DURATION)] - oscillator.acceleration(end)).abs() < 1e-14);
}

#[test]
fn derivatives_of_the_flow_are_those_of_differences() {
    assert_derivatives(&Integrated::new(Duffing, [0.6, 0.76]));
    assert_derivatives(&Integrated::new(Saturating, [0.6, 0.76]));
    assert_derivatives(&Integrated::new(Dragged, [0.6, 0.76]));
}

#[test]
fn flow_of_a_sum_of_times_is_the_composition() {
    let oscillator = Integrated::new(Duffing, [0.6, 0.76]);
    let whole = oscillator.flow::<1>(FROM, 8.0).value;
    let half = oscillator.flow::<1>(FROM, 3.3).value;
    let between = State { position: half[0], velocity: half[1], phase: FROM.phase + 3.3 * 0.76 };
    let rest = oscillator.flow::<1>(between, 4.7).value;
    let back = oscillator.flow::<1>(between, -3.3).value;
    // The two use different steps: the digits that they share are right.
    assert!((whole - rest).amax() < 1e-12);
    assert!((back[0] - FROM.position).abs().max((back[1] - FROM.velocity).abs()) < 1e-12);
}

#[test]
fn energy_of_a_conservative_oscillator_is_kept_over_a_hundred_periods() {
    let oscillator = Integrated::new(Conservative, [0.0, 1.0]);
    let energy = |x: f64, y: f64| 0.5 * y * y + x + 0.5 * x * x + x * x * x * x / 40.0;
    let motion = oscillator.motion(FROM);
    let start = energy(FROM.position, FROM.velocity);
    for k in 1..=100 {
        let here = motion.at(core::f64::consts::TAU * f64::from(k));
        // Roundings of 1e-16 in each of two thousand steps, and the truncation of each.
        assert!((energy(here.position, here.velocity) - start).abs() < 1e-12, "period {k}");
    }
}

/// Checks that sampled derivatives stay within the proved bounds, and that these are tight enough
/// to be useful.
fn assert_bounded<M: SmoothOscillator>(oscillator: &Integrated<M>) {
    for (from, to) in [(0.0, 12.0), (0.0, -2.5), (4.0, 5.0)] {
        let motion = oscillator.motion(FROM);
        let enclosure = motion.enclose(to);
        let bounds = enclosure.bounds_between(from, to);
        assert!(from != 0.0 || bounds == enclosure.bounds());
        // No bounds are known outside, though the motion itself is known there.
        for outside in [[0.0, 1.01 * to], [0.0, -0.1 * to]] {
            assert!(motion.at(outside[1]).position.is_finite());
            assert_eq!(enclosure.bounds_between(outside[0], outside[1]).acceleration, f64::INFINITY);
        }
        let mut largest = [0.0_f64; 3];
        // The snap by a central difference of the jerk, of order h².
        let step = 1e-4;
        for k in 0..=300 {
            let time = from + (to - from) * f64::from(k) / 300.0;
            let here = motion.at(time);
            let snap = (motion.at(time + step).jerk - motion.at(time - step).jerk) / (2.0 * step);
            for (largest, sampled) in largest.iter_mut().zip([here.acceleration, here.jerk, snap]) {
                *largest = largest.max(sampled.abs());
            }
        }
        for (bound, sampled) in [bounds.acceleration, bounds.jerk, bounds.snap].into_iter().zip(largest) {
            assert!(sampled <= bound + 1e-6, "{sampled} exceeds {bound}");
            // Boxes are a tenth of a period long: intervals lose the relation between position and
            // velocity.
            assert!(bound < 40.0 * sampled, "{bound} for {sampled}");
        }
    }
}

#[test]
fn bounds_hold_and_are_not_idle() {
    assert_bounded(&Integrated::new(Duffing, [0.6, 0.76]));
    assert_bounded(&Integrated::new(Saturating, [0.6, 0.76]));
    assert_bounded(&Integrated::new(Dragged, [0.6, 0.76]));
}

/// The bounds of rough motion are estimates, which leave room for what the steps' polynomials leave out.
fn assert_roughly_bounded<M: SmoothOscillator>(oscillator: &Integrated<M>) {
    for velocity in [-0.1, -0.7, -1.5, -4.0] {
        let from = State::on_wall(velocity, 0.3);
        let (motion, rough) = (oscillator.motion(from), oscillator.roughly().motion(from));
        let enclosure = rough.enclose(20.0);
        for k in 0..400 {
            let time = 0.05 * f64::from(k);
            let bounds = enclosure.bounds_between(time, time + 0.01);
            let here = motion.at(time);
            let snap = (motion.at(time + 1e-4).jerk - motion.at(time - 1e-4).jerk) / 2e-4;
            for (bound, size) in
                [(bounds.acceleration, here.acceleration), (bounds.jerk, here.jerk), (bounds.snap, snap)]
            {
                // Rough motion is off by less than 1e-7, its second derivative of the acceleration by more.
                assert!(size.abs() <= bound + 1e-5, "at {time}: {size} exceeds {bound}");
            }
        }
    }
}

#[test]
fn bounds_of_rough_motion_hold_where_it_is_sampled() {
    assert_roughly_bounded(&Integrated::new(Duffing, [0.6, 0.76]));
    assert_roughly_bounded(&Integrated::new(Saturating, [0.6, 0.76]));
    assert_roughly_bounded(&Integrated::new(Dragged, [0.6, 0.76]));
}

#[test]
fn maxima_are_where_samples_show_them() {
    let oscillator = Integrated::new(Duffing, [0.9, 0.45]);
    let motion = oscillator.motion(FROM);
    let maxima = motion.local_maxima(60.0);
    for maximum in &maxima {
        let here = motion.at(maximum.time);
        // Rounding of the velocity.
        assert!(here.velocity.abs() < 1e-12 && here.acceleration < 0.0);
        assert!((here.position - maximum.position).abs() < 1e-12);
    }
    let falls = |time: f64| motion.at(time).velocity > 0.0 && motion.at(time + 0.01).velocity <= 0.0;
    let sampled = (0..6000).filter(|&k| falls(0.01 * f64::from(k))).count();
    assert_eq!(maxima.len(), sampled);
}

/// Rough motion is made of half as many steps, and right to seven digits, with its first
/// derivatives.
#[test]
fn rough_motion_is_rough_and_right_to_seven_digits() {
    let oscillator = Integrated::new(Duffing, [0.6, 0.8]);
    let rough = oscillator.roughly().with_parameters([0.6, 0.8]);
    for velocity in [-0.2, -1.0, -2.0] {
        let from = State::on_wall(velocity, 0.3);
        let time = 2.0 * oscillator.forcing_period();
        let [exact, near] = [&oscillator, &rough].map(|oscillator| oscillator.flow::<1>(from, time));
        let error = (exact.jacobian - near.jacobian).amax() / exact.jacobian.amax();
        let error = error.max((exact.value - near.value).amax());
        assert!(error > 0.0 && error < 1e-7, "{error:e}");
        let [many, few] = [&oscillator, &rough].map(|oscillator| {
            let motion = oscillator.motion(from);
            motion.enclose(time).strides()
        });
        assert!(2 * few < many, "{few} of {many}");
    }
}
