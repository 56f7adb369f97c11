//! Motion in closed form against integrated motion, for random linear forces.

use core::f64::consts::TAU;

use grazing_model::motion::{BoundedMotion, Enclosure, Motion};
use grazing_model::smooth::{Exact, ExactMotion, Function, Integrated, Scalar, SmoothOscillator};
use grazing_model::{FlowJet, ImpactOscillator, State};
use proptest::prelude::*;

/// ẍ = −k x − c ẋ − 1 + μ cos ωt + b μ² sin 2ωt, in which k and ω vary with both parameters.
#[derive(Clone, Debug)]
struct Linear {
    stiffness: f64,
    damping: f64,
    second: f64,
}

impl SmoothOscillator for Linear {
    fn force<S: Scalar>(&self, x: S, y: S, t: S, mu: S, eta: S) -> S {
        let Self { stiffness, damping, second } = *self;
        let phase = self.forcing_frequency(mu, eta) * t;
        let [cosine, sine] = [phase.apply(Function::Cos), phase.scale(2.0).apply(Function::Sin)];
        let slopes = (mu * eta + 1.0) * (x.scale(-stiffness) - y.scale(damping));
        slopes - 1.0 + mu * cosine + mu.square().scale(second) * sine
    }

    fn forcing_frequency<S: Scalar>(&self, mu: S, eta: S) -> S {
        eta + mu.square().scale(0.1)
    }

    fn restitution<S: Scalar>(&self, y: S, z: S, mu: S, _: S) -> S {
        (y.scale(0.02) + z.apply(Function::Cos).scale(0.1)) * mu + 0.8
    }

    fn impact_duration<S: Scalar>(&self, _: S, _: S, mu: S, eta: S) -> S {
        mu * eta * 0.01
    }

    fn harmonics(&self) -> Option<u32> {
        Some(2)
    }
}

/// The largest difference of two jets, and their largest entry.
fn compared(a: &FlowJet, b: &FlowJet) -> [f64; 2] {
    let entries = |jet: &FlowJet| -> Vec<f64> {
        let matrices = jet.hessians.iter().flat_map(|hessian| hessian.iter());
        jet.value.iter().chain(jet.jacobian.iter()).chain(matrices).copied().collect()
    };
    let (a, b) = (entries(a), entries(b));
    let largest = a.iter().fold(1.0, |most: f64, entry| most.max(entry.abs()));
    [a.iter().zip(&b).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())), largest]
}

fn assert_alike(model: &Linear, parameters: [f64; 2], from: State, duration: f64) {
    let exact = Exact::new(model.clone(), parameters);
    let integrated = Integrated::new(model.clone(), parameters);
    let [first, second] = [exact.flow::<2>(from, duration), integrated.flow::<2>(from, duration)];
    let [difference, largest] = compared(&first, &second);
    assert!(
        difference < 1e-10 * largest,
        "{difference:e} of {largest:e}: {model:?} {parameters:?} {from:?} {duration}"
    );
    // First derivatives by themselves are the same ones.
    let [difference, _] =
        compared(&FlowJet { hessians: first.hessians, ..exact.flow::<1>(from, duration) }, &first);
    assert!(difference < 1e-13 * largest, "{difference:e}");

    let [motion, other] = [exact.motion(from), ExactMotion::Integrated(integrated.motion(from))];
    let horizon = 2.0 * exact.forcing_period();
    let [a, b] = [&motion, &other].map(|motion| motion.highest_maximum(horizon));
    let apart = a.zip(b).map_or(0.0, |(a, b)| (a.position - b.position).abs());
    assert!(a.is_some() == b.is_some() && apart < 1e-10 * largest, "{a:?} {b:?}");
    let [a, b] = [&motion, &other].map(|motion| motion.local_maxima(horizon));
    assert_eq!(a.len(), b.len(), "{a:?} {b:?}");
    let at = |time: f64| {
        let [a, b] = [&motion, &other].map(|motion| motion.at(time));
        let apart = [
            a.position - b.position,
            a.velocity - b.velocity,
            a.acceleration - b.acceleration,
            a.jerk - b.jerk,
        ];
        let size = largest
            + [a.position, a.velocity, a.acceleration, a.jerk].map(f64::abs).into_iter().fold(0.0, f64::max);
        assert!(apart.iter().all(|apart| apart.abs() < 1e-10 * size), "{a:?} {b:?}");
        a
    };
    at(-0.3 * duration);
    let begun = at(0.0);
    assert!(
        (begun.position - from.position).abs() < 1e-12 * largest
            && (begun.velocity - from.velocity).abs() < 1e-12 * largest
    );
    // Bounds hold.
    let ExactMotion::Closed(formula) = &motion else { panic!("it is in closed form") };
    for ends in [[0.0, horizon], [0.2 * horizon, 0.3 * horizon]] {
        let bounds = formula.enclose(horizon).bounds_between(ends[0], ends[1]);
        for k in 0..=20 {
            let time = ends[0] + (ends[1] - ends[0]) * f64::from(k) / 20.0;
            let here = motion.at(time);
            assert!(
                here.acceleration.abs() <= bounds.acceleration * (1.0 + 1e-12) + 1e-12,
                "{here:?} {bounds:?}"
            );
            assert!(here.jerk.abs() <= bounds.jerk * (1.0 + 1e-12) + 1e-12, "{here:?} {bounds:?}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, rng_seed: proptest::test_runner::RngSeed::Fixed(44), ..ProptestConfig::default() })]

    #[test]
    fn motion_in_closed_form_is_integrated_motion(
        (kind, stiffness, damping, second) in (0..5_u8, 0.3..3.0_f64, 0.01..0.4_f64, -0.5..0.5_f64),
        (amplitude, frequency, share) in (-1.0..1.0_f64, 0.5..2.5_f64, -0.4..1.5_f64),
        (position, velocity, phase) in (-2.0..0.0_f64, -2.0..2.0_f64, -7.0..7.0_f64),
    ) {
        let model = match kind {
            // Turning, overdamped, about a position that repels, only slowed down, and falling freely.
            0 => Linear { stiffness, damping, second },
            1 => Linear { stiffness, damping: 2.5 * stiffness.sqrt() + damping, second },
            2 => Linear { stiffness: -stiffness, damping, second },
            3 => Linear { stiffness: 0.0, damping: 0.3 + damping, second },
            _ => Linear { stiffness: 0.0, damping: 0.0, second },
        };
        let from = State { position, velocity, phase };
        prop_assume!(Exact::new(model.clone(), [amplitude, frequency]).is_closed());
        assert_alike(&model, [amplitude, frequency], from, share * TAU / frequency);
    }
}

#[test]
fn the_shortest_flights_keep_their_digits() {
    let model = Linear { stiffness: 1.1, damping: 0.05, second: 0.2 };
    let (exact, integrated) = (Exact::new(model.clone(), [0.7, 0.9]), Integrated::new(model, [0.7, 0.9]));
    for velocity in [-1e-3, -1e-6, -1e-9, 0.0] {
        let from = State::on_wall(velocity, 0.4);
        let [motion, other] = [exact.motion(from), ExactMotion::Integrated(integrated.motion(from))];
        for time in [0.01, 0.1, 0.14, 0.16] {
            let [a, b] = [&motion, &other].map(|motion| motion.at(time).position);
            assert!((a - b).abs() < 1e-11 * b.abs(), "{velocity} {time}: {a:e} {b:e}");
        }
        // Integration knows the acceleration in so short a time to some six digits alone.
        let start = motion.at(0.0);
        assert_eq!([start.position, start.velocity], [0.0, velocity]);
        for time in [1e-7, 1e-5] {
            let [a, b] = [motion.at(time).position, velocity * time + 0.5 * start.acceleration * time * time];
            // What is left is a sixth of the jerk times the cube of the time.
            assert!(
                (a - b).abs() < 0.2 * start.jerk.abs() * time * time * time,
                "{velocity} {time}: {a:e} {b:e}"
            );
        }
    }
}

#[test]
fn motion_that_loses_digits_in_closed_form_is_integrated() {
    let closed = |stiffness: f64, damping: f64| {
        Exact::new(Linear { stiffness, damping, second: 0.0 }, [0.0, 1.3]).is_closed()
    };
    // At critical damping, at a resonance with the second harmonic without damping, and at a distant position of rest.
    assert!(!closed(1.0, 2.0) && !closed(4.0 * 1.69, 0.0) && !closed(1e-9, 0.01));
    assert!(closed(1.0, 1.5) && closed(4.0 * 1.69, 0.1) && closed(0.0, 0.0));
    let critical = Linear { stiffness: 1.0, damping: 2.0, second: 0.3 };
    let [exact, integrated] = [
        Exact::new(critical.clone(), [0.0, 1.3]).flow::<2>(State::at_rest(-1.0, 0.2), 3.0),
        Integrated::new(critical, [0.0, 1.3]).flow::<2>(State::at_rest(-1.0, 0.2), 3.0),
    ];
    assert_eq!(exact, integrated);
}
