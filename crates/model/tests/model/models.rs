//! Oscillators to test with.

use grazing_model::smooth::{Function, Integrated, Scalar, SmoothOscillator};
use grazing_model::{LinearOscillator, State};

/// Defines an oscillator by its force alone, as a new type or one with fields; the parameters are
/// the forcing's amplitude and frequency, impacts are elastic.
macro_rules! forced {
    ($(#[$doc:meta])* $name:ident, |$x:ident, $y:ident, $forcing:ident| $force:expr) => {
        $(#[$doc])*
        #[derive(Clone, Debug)]
        pub(crate) struct $name;

        forced!(impl $name {}, |$x, $y, $forcing| $force);
    };
    (impl $name:ident { $($field:ident),* }, |$x:ident, $y:ident, $forcing:ident| $force:expr) => {
        impl SmoothOscillator for $name {
            fn force<S: Scalar>(&self, $x: S, $y: S, t: S, amplitude: S, omega: S) -> S {
                let Self { $($field),* } = *self;
                let $forcing = amplitude * (omega * t).apply(Function::Cos);
                $force
            }

            fn forcing_frequency<S: Scalar>(&self, _: S, omega: S) -> S {
                omega
            }

            fn restitution<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
                S::constant(1.0)
            }

            fn impact_duration<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
                S::constant(0.0)
            }
        }
    };
}
pub(crate) use forced;

forced!(
    /// The paper's oscillator, eq:oscf, with ζ = 0.02.
    Linear,
    |x, y, forcing| forcing - y.scale(0.04) - x - S::constant(1.0)
);
forced!(
    /// With a cubic spring.
    Duffing,
    |x, y, forcing| forcing - y.scale(0.04) - x - x.power(3).scale(0.1) - S::constant(1.0)
);
forced!(
    /// A spring of finite strength with saturating damping.
    Saturating,
    |x, y, forcing| forcing - y.apply(Function::Tanh).scale(0.3) - x.apply(Function::Atan) - S::constant(0.2)
);
forced!(
    /// A force that depends on the velocity through all of it.
    Dragged,
    |x, y, forcing| {
        let speed = (y.square() + S::constant(0.01)).apply(Function::Sqrt);
        forcing - y * speed.scale(0.2) - x / (S::constant(1.0) + y.square()) - S::constant(0.5)
    }
);
forced!(
    /// Without loss and, at amplitude zero, without forcing: ẏ² /2 + x²/2 + x⁴/40 + x is kept.
    Conservative,
    |x, _y, forcing| forcing - x - x.power(3).scale(0.1) - S::constant(1.0)
);
forced!(
    /// Repelled by its own displacement: solutions escape in finite time.
    Escaping,
    |x, _y, forcing| forcing + x.power(3)
);

forced!(
    /// Thrown back by a soft wall, ẏ²/2 + x²/2 + e^{20x}/20 being kept without forcing.
    Bouncing,
    |x, _y, forcing| forcing - x - x.scale(20.0).apply(Function::Exp)
);
forced!(
    /// With friction that changes its sign within a fiftieth of the usual velocities.
    Sticking,
    |x, y, forcing| forcing - y.scale(50.0).apply(Function::Tanh).scale(0.3) - x
);

/// The paper's oscillator with impacts that last, the longer the faster they are.
#[derive(Clone, Debug)]
pub(crate) struct Lasting;

impl Lasting {
    /// Ψ.
    pub(crate) const PSI: f64 = 0.3;
}

impl SmoothOscillator for Lasting {
    fn force<S: Scalar>(&self, x: S, y: S, t: S, amplitude: S, omega: S) -> S {
        Linear.force(x, y, t, amplitude, omega)
    }

    fn forcing_frequency<S: Scalar>(&self, _: S, omega: S) -> S {
        omega
    }

    fn restitution<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
        S::constant(0.9)
    }

    fn impact_duration<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
        S::constant(Self::PSI)
    }
}

/// A generic state.
pub(crate) const FROM: State = State { position: -0.4, velocity: 0.7, phase: 1.1 };

/// The paper's oscillator, defined by its force and in closed form.
pub(crate) fn both() -> (Integrated<Linear>, LinearOscillator) {
    let parameters = [0.3, 0.8];
    let closed = LinearOscillator::new(0.02, 1.0, parameters[0], parameters[1]).unwrap();
    (Integrated::new(Linear, parameters), closed)
}
