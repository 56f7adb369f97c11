//! Springs that are much faster than their forcing, and forces that are steep.

use grazing_model::motion::{BoundedMotion, Enclosure, Motion};
use grazing_model::smooth::{Function, Integrated, Scalar, SmoothOscillator, Taylor};
use grazing_model::{FlowJet, ImpactOscillator, LinearOscillator, State, ThirdOrder, flow_variable};
use nalgebra::{Matrix2x6, Matrix6};

use crate::models::{Bouncing, FROM, forced};

/// The damping ratio: transients live for hundreds of turns.
const ZETA: f64 = 1e-4;

/// The paper's oscillator in other units: `rate` is the number of its units of time in one of
/// these, `size` its unit of length in these. Slow forcing of a stiff spring.
#[derive(Clone, Debug)]
struct Stiff {
    rate: f64,
    size: f64,
}

forced!(impl Stiff { rate, size }, |x, y, forcing| {
    let spring = forcing - S::constant(1.0) - x.scale(1.0 / size) - y.scale(2.0 * ZETA / (rate * size));
    spring.scale(rate * rate * size)
});

impl Stiff {
    /// The units of x, y, z, s, μ, η in terms of those of the paper's oscillator, in the order of a
    /// flow's variables.
    fn units(&self) -> [f64; 6] {
        let mut units = [1.0; 6];
        units[flow_variable::POSITION] = self.size;
        units[flow_variable::VELOCITY] = self.size * self.rate;
        units[flow_variable::DURATION] = 1.0 / self.rate;
        units[flow_variable::SECONDARY] = self.rate;
        units
    }

    /// A jet of the flow converted to the units of the paper's oscillator.
    fn converted(&self, jet: &FlowJet) -> FlowJet {
        let units = self.units();
        FlowJet {
            value: jet.value.map_with_location(|i, _, value| value / units[i]),
            jacobian: Matrix2x6::from_fn(|i, a| jet.jacobian[(i, a)] * units[a] / units[i]),
            hessians: [0, 1]
                .map(|i| Matrix6::from_fn(|a, b| jet.hessians[i][(a, b)] * units[a] * units[b] / units[i])),
        }
    }
}

/// Amplitude and, in the units of the paper's oscillator, duration of a flight: not quite a forcing
/// period of any.
const AMPLITUDE: f64 = 0.7;
const SHARE_OF_PERIOD: f64 = 0.83;

/// An oscillator in both forms, the duration of its flight, and the error that is allowed relative
/// to the largest value of its kind: 2e-14 for each radian of unforced motion, as the steps allow,
/// and rounding.
fn flights(rate: f64, size: f64) -> (Integrated<Stiff>, LinearOscillator, f64, f64) {
    let stiff = Integrated::new(Stiff { rate, size }, [AMPLITUDE, 0.9]);
    let closed = LinearOscillator::new(ZETA, 1.0, AMPLITUDE, 0.9 / rate).unwrap();
    let duration = SHARE_OF_PERIOD * closed.forcing_period();
    (stiff, closed, duration, 3e-14 * duration + 1e-12)
}

#[test]
fn flows_of_stiff_springs_are_those_of_the_closed_form_in_values_and_two_derivatives() {
    for rate in [1.0, 3.0, 10.0, 30.0, 100.0, 1000.0] {
        for size in [1e-3, 1.0, 1e3] {
            let (stiff, closed, duration, tolerance) = flights(rate, size);
            let from =
                State { position: FROM.position * size, velocity: FROM.velocity * size * rate, ..FROM };
            let computed = stiff.flow::<2>(from, duration / rate);
            let computed = stiff.model().converted(&computed);
            let expected = closed.flow::<2>(FROM, duration);
            assert!((computed.value - expected.value).amax() < tolerance, "{rate} {size}");
            for a in 0..6 {
                let [one, other] = [computed, expected].map(|jet| jet.jacobian.column(a).into_owned());
                // Relative to the largest of a column: the one for ω grows with time.
                assert!((one - other).amax() < tolerance * (1.0 + other.amax()), "{rate} {size}: {a}");
            }
            for (one, other) in computed.hessians.iter().zip(&expected.hessians) {
                assert!((one - other).amax() < tolerance * (1.0 + other.amax()), "{rate} {size}");
            }
        }
    }
}

#[test]
fn third_derivatives_of_flows_of_stiff_springs_are_those_of_the_closed_form() {
    for rate in [1.0, 20.0, 300.0] {
        let (stiff, closed, duration, tolerance) = flights(rate, 1.0);
        let units = stiff.model().units();
        let [dx, dy, dz, ds] = [[0.3, 0.5, 0.1], [-0.5, 0.2, -0.6], [0.7, -0.4, 0.2], [0.4, 0.3, 0.5]];
        let along =
            |value: f64, [a, b, c]: [f64; 3], unit: f64| Taylor::new([value, a, b, c].map(|c| c * unit));
        let series = |oscillator: &dyn Fn([Taylor; 3], Taylor) -> [Taylor; 2], units: [f64; 6]| {
            let [x, y] = [flow_variable::POSITION, flow_variable::VELOCITY].map(|i| units[i]);
            let from = [along(FROM.position, dx, x), along(FROM.velocity, dy, y), along(FROM.phase, dz, 1.0)];
            let [position, velocity] = oscillator(from, along(duration, ds, units[flow_variable::DURATION]));
            [position.scale(1.0 / x), velocity.scale(1.0 / y)]
        };
        let computed = series(&|from, time| stiff.flow_series(from, time), units);
        let expected = series(&|from, time| closed.flow_series(from, time), [1.0; 6]);
        for (one, other) in computed.iter().zip(&expected) {
            for (one, other) in one.coefficients().into_iter().zip(other.coefficients()) {
                assert!((one - other).abs() < tolerance * (1.0 + other.abs()), "{rate}: {one} {other}");
            }
        }
    }
}

#[test]
fn rest_under_a_stiff_spring_takes_long_steps_and_stays_rest() {
    for size in [1e-6, 1.0, 1e6] {
        let stiff = Integrated::new(Stiff { rate: 100.0, size }, [0.0, 1.0]);
        let at_rest = State { position: -size, velocity: 0.0, phase: 0.4 };
        let motion = stiff.motion(at_rest);
        let strides = motion.enclose(core::f64::consts::TAU).strides();
        // A step of 0.85 in the spring's own time.
        assert!((strides as f64) < 100.0 * core::f64::consts::TAU / 0.8, "{strides}");
        assert!((motion.at(core::f64::consts::TAU).position / -size - 1.0).abs() < 1e-13);
    }
}

#[test]
fn energy_is_kept_by_a_wall_that_is_soft() {
    let oscillator = Integrated::new(Bouncing, [0.0, 1.0]);
    let motion = oscillator.motion(FROM);
    let energy = |x: f64, y: f64| 0.5 * (y * y + x * x) + 0.05 * libm::exp(20.0 * x);
    let start = energy(FROM.position, FROM.velocity);
    for k in 1..=200 {
        let here = motion.at(0.5 * f64::from(k));
        // Some thousand steps, each of which leaves 1e-14 or so.
        assert!((energy(here.position, here.velocity) - start).abs() < 1e-10, "after {k} halves");
    }
}

#[test]
fn a_motion_of_too_many_steps_is_not_a_number_in_the_end() {
    let stiff = Integrated::new(Stiff { rate: 1e8, size: 1.0 }, [0.5, 1.0]);
    let motion = stiff.motion(FROM);
    assert!(motion.at(1e-6).position.is_finite());
    assert!(motion.at(1.0).position.is_nan());
    assert!(stiff.flow::<1>(FROM, 1.0).jacobian[(0, 0)].is_nan());
}
