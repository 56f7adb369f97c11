//! The flow of an oscillator from a file, whose force has formulas for its derivatives, against that of the same
//! force, differentiated automatically.

use grazing_input::Description;
use grazing_model::smooth::{Dimensionless, Integrated, Scalar, SmoothOscillator, Units};
use grazing_model::{ImpactOscillator, State};

use crate::examples;
use crate::messages::RIGHT;

/// A force without formulas for its derivatives.
#[derive(Clone)]
struct Plain(Description);

impl SmoothOscillator for Plain {
    fn force<S: Scalar>(&self, x: S, y: S, t: S, mu: S, eta: S) -> S {
        self.0.force(x, y, t, mu, eta)
    }

    fn forcing_frequency<S: Scalar>(&self, mu: S, eta: S) -> S {
        self.0.forcing_frequency(mu, eta)
    }

    fn restitution<S: Scalar>(&self, y: S, z: S, mu: S, eta: S) -> S {
        self.0.restitution(y, z, mu, eta)
    }

    fn impact_duration<S: Scalar>(&self, y: S, z: S, mu: S, eta: S) -> S {
        self.0.impact_duration(y, z, mu, eta)
    }
}

/// Relative difference of derivatives of a flow: rounding, which the flow stretches (at most 8e-15 in the examples).
const ROUNDING: f64 = 1e-13;

/// Every entry of the jet of the flow over most of a forcing period from a state, and its distance from
/// that of the plain force.
fn compared(description: &Description, units: Units, from: State) -> Vec<[f64; 2]> {
    let middle = |[low, high]: [f64; 2]| 0.4 * low + 0.6 * high;
    let parameters = [description.primary(), description.secondary()].map(|axis| middle(axis.range()));
    let parameters = units.without_dimensions(parameters);
    let known = Integrated::new(Dimensionless::new(description.clone(), units), parameters);
    let plain = Integrated::new(Dimensionless::new(Plain(description.clone()), units), parameters);
    let duration = 0.9 * known.forcing_period();
    let [known, plain] = [known.flow::<2>(from, duration), plain.flow::<2>(from, duration)];
    let entries = known.value.iter().chain(&known.jacobian).chain(known.hessians.iter().flatten());
    let others = plain.value.iter().chain(&plain.jacobian).chain(plain.hessians.iter().flatten());
    entries.zip(others).map(|(a, b)| [*b, (a - b).abs()]).collect()
}

/// Checks the flow from several states; the error of a derivative is relative to the largest one, beside which
/// it may be a difference.
fn check(name: &str, description: &Description) {
    // In the file's own units, in those of the motion, and in some that differ from all of these.
    let own = Units { length: 4.0, time: 0.25, primary: 16.0, secondary: 4.0 };
    for units in [Units::ONE, description.units(), own] {
        let mut compared_anything = false;
        for (velocity, phase) in [(-0.6, 0.3), (0.4, 2.9), (-1.1, 5.0)] {
            let unit = description.units();
            let [length, velocity] =
                [unit.length / units.length, velocity * unit.velocity() / units.velocity()];
            let from = State { position: -0.3 * length, velocity, phase };
            let entries = compared(description, units, from);
            let size = entries.iter().fold(1.0, |size: f64, [entry, _]| size.max(entry.abs()));
            if !entries.iter().all(|[entry, _]| entry.is_finite()) {
                continue;
            }
            compared_anything = true;
            for [entry, gap] in entries {
                assert!(gap <= ROUNDING * size, "{name}: {entry} is off by {gap}, others are up to {size}");
            }
        }
        assert!(compared_anything, "{name}: no flow exists");
    }
}

#[test]
fn formulas_of_the_force_give_the_flow_that_automatic_differentiation_gives() {
    for path in examples::files() {
        let description = Description::from_file(&path).unwrap_or_else(|error| panic!("{error}"));
        let name = path.display().to_string();
        assert!(description.slopes_at(0.1, 0.2, 0.3).is_some(), "{name}: no formulas");
        check(&name, &description);
    }
}

#[test]
fn the_time_of_a_force_may_depend_on_both_parameters() {
    let text = RIGHT
        .replace(
            "-2*zeta*v - x - kappa*x^3 - 1 + A*cos(omega*t)",
            "A*cos(sqrt(omega + A)*t)*(1 + kappa*x*v) - omega*sin(x) - 1 - zeta*omega*A*v^3*exp(zeta*x)",
        )
        .replace("frequency = \"omega\"", "frequency = \"sqrt(omega + A)\"");
    let description = Description::parse(&text, "test.toml").unwrap_or_else(|error| panic!("{error}"));
    check("test.toml", &description);
}
