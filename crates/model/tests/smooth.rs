//! An integrated oscillator against the closed form of the linear one.

use grazing_model::motion::{Motion, first_crossing, local_maxima};
use grazing_model::smooth::{Function, Integrated, Scalar, SmoothOscillator};
use grazing_model::{ImpactOscillator, LinearOscillator, State};

/// The linear oscillator, given by its force.
#[derive(Clone, Debug)]
struct Linear {
    zeta: f64,
    epsilon: f64,
}

impl SmoothOscillator for Linear {
    fn force<S: Scalar>(&self, x: S, y: S, t: S, amplitude: S, omega: S) -> S {
        amplitude * (omega * t).apply(Function::Cos) - y.scale(2.0 * self.zeta) - x - S::constant(1.0)
    }

    fn forcing_frequency<S: Scalar>(&self, _: S, omega: S) -> S {
        omega
    }

    fn restitution<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
        S::constant(self.epsilon)
    }

    fn impact_duration<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
        S::constant(0.0)
    }
}

fn both() -> (Integrated<Linear>, LinearOscillator) {
    let (zeta, epsilon, parameters) = (0.02, 0.9, [0.3, 0.8]);
    let closed = LinearOscillator::new(zeta, epsilon, parameters[0], parameters[1]).unwrap();
    (Integrated::new(Linear { zeta, epsilon }, parameters), closed)
}

#[test]
fn flow_and_its_derivatives_are_those_of_the_closed_form() {
    let (integrated, closed) = both();
    for duration in [-5.0, -0.3, 0.0, 0.2, 7.8, 24.0] {
        let from = State { position: -0.4, velocity: 0.7, phase: 1.1 };
        let [a, b] = [integrated.flow::<2>(from, duration), closed.flow::<2>(from, duration)];
        println!(
            "{duration}: {:e} {:e} {:e} {:e}",
            (a.value - b.value).amax(),
            (a.jacobian - b.jacobian).amax(),
            (a.hessians[0] - b.hessians[0]).amax(),
            (a.hessians[1] - b.hessians[1]).amax()
        );
        assert!((a.value - b.value).amax() < 1e-12);
        assert!((a.jacobian - b.jacobian).amax() < 1e-11);
        for i in 0..2 {
            assert!((a.hessians[i] - b.hessians[i]).amax() < 1e-10 * (1.0 + b.hessians[i].amax()));
        }
    }
}

#[test]
fn events_are_those_of_the_closed_form() {
    let (integrated, closed) = both();
    let from = State { position: -0.4, velocity: 0.7, phase: 1.1 };
    let [a, b] = [local_maxima(&integrated.motion(from), 40.0), local_maxima(&closed.motion(from), 40.0)];
    assert_eq!(a.len(), b.len());
    for (a, b) in a.iter().zip(&b) {
        println!("{:e} {:e}", a.time - b.time, a.position - b.position);
        assert!((a.time - b.time).abs() < 1e-11 && (a.position - b.position).abs() < 1e-12);
    }
    let [a, b] = [first_crossing(&integrated.motion(from), 40.0), first_crossing(&closed.motion(from), 40.0)];
    println!("{a:?} {b:?}");
    assert!((a.unwrap().time - b.unwrap().time).abs() < 1e-11);
    let [a, b] = [integrated.motion(from).bounds(0.0, 40.0), closed.motion(from).bounds(0.0, 40.0)];
    println!("{a:?} {b:?}");
}

#[test]
fn timing() {
    let (integrated, _) = both();
    let from = State { position: -0.4, velocity: 0.7, phase: 1.1 };
    let t = std::time::Instant::now();
    let mut s = 0.0;
    for k in 0..200 {
        s += integrated.flow::<2>(from, 7.8 + 1e-3 * f64::from(k)).value[0];
    }
    println!("flow2 {:?} {s}", t.elapsed() / 200);
    let t = std::time::Instant::now();
    for k in 0..200 {
        s += integrated.flow::<1>(from, 7.8 + 1e-3 * f64::from(k)).value[0];
    }
    println!("flow1 {:?} {s}", t.elapsed() / 200);
    let t = std::time::Instant::now();
    for k in 0..200 {
        s += local_maxima(&integrated.motion(from), 7.8 + 1e-3 * f64::from(k)).len() as f64;
    }
    println!("maxima {:?} {s}", t.elapsed() / 200);
}
