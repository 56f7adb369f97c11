//! Reset laws, and with them the derivatives of every operation and function, compared with
//! automatic differentiation.

use grazing_model::smooth::{Function, Integrated, Scalar, SmoothOscillator};
use grazing_model::{ImpactOscillator, OnWall};
use nalgebra::{Const, SVector};
use num_dual::{Dual2Vec, DualNum, hessian};

type Dual = Dual2Vec<f64, Const<4>>;

/// A law in which every operation and one function occurs.
#[derive(Clone, Debug)]
struct Law(Function);

impl SmoothOscillator for Law {
    fn force<S: Scalar>(&self, x: S, _: S, _: S, _: S, _: S) -> S {
        -x
    }

    fn forcing_frequency<S: Scalar>(&self, mu: S, eta: S) -> S {
        S::constant(1.0) + mu * eta.square()
    }

    fn restitution<S: Scalar>(&self, y: S, z: S, mu: S, eta: S) -> S {
        (y * z + mu).apply(self.0) - eta / (S::constant(2.0) + y.square())
    }

    fn impact_duration<S: Scalar>(&self, y: S, z: S, mu: S, eta: S) -> S {
        (-z).scale(0.3) + y.power(-3) * eta.power(5) - mu.power(0)
    }
}

/// The image under the law, in dual numbers.
fn image(function: Function, [y, z, mu, eta]: [Dual; 4]) -> [Dual; 2] {
    let constant = Dual::from_re;
    let inner = y * z + mu;
    let outer = match function {
        Function::Sin => inner.sin(),
        Function::Cos => inner.cos(),
        Function::Tan => inner.tan(),
        Function::Tanh => inner.tanh(),
        Function::Atan => inner.atan(),
        Function::Exp => inner.exp(),
        Function::Ln => inner.ln(),
        Function::Sqrt => inner.sqrt(),
    };
    let restitution = outer - eta / (constant(2.0) + y * y);
    let duration = -z * 0.3 + eta * eta * eta * eta * eta / (y * y * y) - 1.0;
    [-y * restitution, z + y * duration]
}

#[test]
fn reset_jets_are_those_of_automatic_differentiation() {
    let point = [0.7, 0.9, 0.2, 1.3];
    for function in Function::ALL {
        let oscillator = Integrated::new(Law(function), [point[2], point[3]]);
        let impact = OnWall::new(point[0], point[1]);
        let (jet, first) = (oscillator.reset::<2>(impact), oscillator.reset::<1>(impact));
        for i in 0..2 {
            let at = SVector::from(point);
            let (value, gradient, second) = hessian(|v| image(function, v.data.0[0])[i], &at);
            // Roundings of terms of size up to a few hundred.
            let tolerance = 1e-12;
            assert!((jet.value[i] - value).abs() < tolerance, "{function:?}");
            assert!((jet.jacobian.row(i).transpose() - gradient).amax() < tolerance, "{function:?}");
            assert!((jet.hessians[i] - second).amax() < tolerance, "{function:?}");
        }
        assert_eq!((first.value, first.jacobian), (jet.value, jet.jacobian));
    }
}

#[test]
fn frequency_may_depend_on_both_parameters() {
    let (mu, eta) = (0.2, 1.3);
    let jet = Integrated::new(Law(Function::Exp), [mu, eta]).forcing_frequency();
    // ω = 1 + μη², to a rounding of each.
    let error = |computed: f64, exact: f64| (computed - exact).abs();
    assert!(error(jet.value, 1.0 + mu * eta * eta) < 1e-15);
    assert!(error(jet.gradient[0], eta * eta) < 1e-15 && error(jet.gradient[1], 2.0 * mu * eta) < 1e-15);
    assert!(error(jet.hessian[(0, 0)], 0.0) < 1e-15 && error(jet.hessian[(1, 1)], 2.0 * mu) < 1e-15);
    assert!(error(jet.hessian[(0, 1)], 2.0 * eta) < 1e-15 && jet.hessian[(0, 1)] == jet.hessian[(1, 0)]);
}
