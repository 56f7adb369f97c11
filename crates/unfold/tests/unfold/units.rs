//! The linear oscillator in other units of length and time.

use grazing_continuation::curve::Window;
use grazing_continuation::fit::{Estimate, Measurement};
use grazing_input::Description;
use grazing_model::smooth::{Stop, Units};
use grazing_results::Dimensioned;
use grazing_unfold::escape::Escape;
use grazing_unfold::non_impacting::Height;
use grazing_unfold::simulation::ReturnOutcome;
use grazing_unfold::verdict::Coefficient;
use grazing_unfold::verification::{Inconclusive, Sides, Simulated};
use grazing_unfold::{Scope, UnfoldError};

use crate::specimens::{self, EPSILON, ZETA, resonances};

/// The linear oscillator at rest at x = −`length`, its free motion slowed down by `time`.
fn stretched(length: f64, time: f64, frequencies: [f64; 2]) -> Description {
    let (frequency, force) = (1.0 / time, length / (time * time));
    let text = format!(
        "name = \"Test\"\n[parameters]\nw = {frequency:e}\nd = {length:e}\n\
         [primary]\nname = \"A\"\nrange = [0, {:e}]\n[secondary]\nname = \"omega\"\nrange = [{:e}, {:e}]\n\
         [motion]\nforce = \"-2*{ZETA}*w*v - w^2*(x + d) + A*cos(omega*t)\"\nfrequency = \"omega\"\n\
         [impact]\nrestitution = \"{EPSILON}\"\nduration = \"0\"\n[analysis]\nloops = [1]\n",
        1.2 * force,
        frequencies[0] * frequency,
        frequencies[1] * frequency,
    );
    Description::parse(&text, "test.toml").unwrap_or_else(|error| panic!("{error}"))
}

/// Checks that ω*, 𝒜_graz, c_SN and c_PD are those of the closed form at all resonances.
fn assert_closed_form([length, time]: [f64; 2], frequencies: [f64; 2], loops: &[u32]) {
    let description = stretched(length, time, frequencies);
    let units = description.units();
    let window =
        Window { primary: description.primary().range(), secondary: description.secondary().range() };
    let scope = Scope { window, loops: loops.to_vec(), start: None }.without_dimensions(&units);
    let oscillator = description.counted([0.0, 1.0], &units, &Stop::default());
    // A has the unit length/time², omega the unit 1/time; digits are those in the units in which
    // the oscillator is of the order of one.
    let coefficient = units.primary / (units.secondary * units.secondary) / length;
    specimens::assert_closed_form(
        &resonances(&oscillator, &scope),
        frequencies,
        loops,
        |[omega, amplitude, c_sn, c_pd]| {
            let [amplitude, frequency] = units.parameters([amplitude, omega]);
            let force = length / (time * time);
            [frequency * time, amplitude / force, c_sn * coefficient, c_pd * coefficient]
        },
    );
}

#[test]
fn stretched_oscillators_have_the_resonances_of_the_closed_form() {
    assert_closed_form([1e-3, 1e3], [0.3, 1.1], &[1, 2, 3]);
    for (others, loops) in [([1e-3, 1e-3], [1, 2]), ([1e3, 1e-3], [1, 3]), ([1e3, 1e3], [2, 3])] {
        assert_closed_form(others, [0.6, 1.1], &loops);
    }
    // Up to n = 60.
    assert_closed_form([1e3, 1e-3], [0.0333, 0.034], &[1]);
    assert_closed_form([1e-3, 1e3], [0.0333, 0.034], &[1]);
    assert_closed_form([1e-3, 1e-3], [0.0165, 0.0169], &[2, 3]);
}

/// Units that are powers of four, as those of oscillators are, no two of which, and no two of whose products that stand
/// for a unit, are the same.
const UNITS: Units = Units { length: 1024.0, time: 0.0625, primary: 64.0, secondary: 0.25 };

#[test]
fn what_is_reported_of_motion_is_in_the_units_of_the_file() {
    let escape = Escape { parameters: [1.0, 1.0], time: 1.0, position: 1.0, velocity: 1.0, force: 1.0 };
    let Units { length, time, primary, secondary } = UNITS;
    let own = Escape {
        parameters: [primary, secondary],
        time,
        position: length,
        velocity: length / time,
        force: length / (time * time),
    };
    assert_eq!(escape.with_dimensions(&UNITS), own);
    let height = Height { position: 1.0, parameters: [1.0, 1.0], acceleration: 1.0 };
    let in_own =
        Height { position: length, parameters: [primary, secondary], acceleration: length / (time * time) };
    assert_eq!(height.with_dimensions(&UNITS), in_own);
    let errors = [
        (UnfoldError::RunsAway { escape }, UnfoldError::RunsAway { escape: own }),
        (UnfoldError::Pushed { at: height }, UnfoldError::Pushed { at: in_own }),
        (
            UnfoldError::NoGrazing { lowest: height, highest: height, whole: true },
            UnfoldError::NoGrazing { lowest: in_own, highest: in_own, whole: true },
        ),
    ];
    for (error, own) in errors {
        assert_eq!(error.with_dimensions(&UNITS).to_string(), own.to_string());
    }
}

#[test]
fn coefficients_and_simulations_are_in_the_units_of_the_file() {
    let estimate = |unit: f64| Estimate { value: 2.0 * unit, error: 0.5 * unit };
    let Units { length, time, primary, secondary } = UNITS;
    let velocity = length / time;
    let coefficient = |unit: f64, [e1, e2]: [f64; 2], [m2, m3]: [f64; 2], velocity: f64| Coefficient {
        stability: 1.0,
        theorem: estimate(unit),
        fit: Ok(Measurement { coefficient: estimate(unit), eta: [e1, e2], mu: [m2, m3], velocity }),
    };
    let found = coefficient(1.0, [1.0, 1.0], [1.0, 1.0], 1.0).with_dimensions(&UNITS);
    // The coefficient of μ/η², and those of η = e₁ y + e₂ y², μ = m₂ y² + m₃ y³.
    let wanted = coefficient(
        primary / (secondary * secondary),
        [secondary / velocity, secondary / velocity / velocity],
        [primary / (velocity * velocity), primary / (velocity * velocity) / velocity],
        velocity,
    );
    assert_eq!(found, wanted);
    let sides = |velocity| Sides {
        velocity,
        predicted: [false, true],
        seen: [ReturnOutcome::Returns; 2],
        attracts: [None; 2],
        gone_beyond: None,
    };
    let slow = |unit| Inconclusive::TooSlow { leading: 2.0 * unit, least: 3.0 * unit };
    let here = |unit| Inconclusive::OnlyHere { velocity: unit };
    let convergence = |unit| Inconclusive::SlowConvergence { velocity: unit, returns: 7 };
    for (one, own) in [
        (Simulated::Against(sides(1.0)), Simulated::Against(sides(velocity))),
        (Simulated::AsPredicted(sides(1.0)), Simulated::AsPredicted(sides(velocity))),
        (Simulated::Undecided(slow(1.0)), Simulated::Undecided(slow(velocity))),
        (Simulated::Undecided(here(1.0)), Simulated::Undecided(here(velocity))),
        (Simulated::Undecided(convergence(1.0)), Simulated::Undecided(convergence(velocity))),
    ] {
        assert_eq!(one.with_dimensions(&UNITS), own);
    }
}
