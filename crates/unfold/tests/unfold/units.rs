//! The linear oscillator in other units of length and time.

use grazing_continuation::curve::Window;
use grazing_description::Description;
use grazing_model::smooth::Stop;
use grazing_unfold::Scope;

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

/// ω*, 𝒜_graz, c_SN and c_PD are those of the closed form at all resonances.
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
    for length in [1e-3, 1.0, 1e3] {
        for time in [1e-3, 1e3] {
            assert_closed_form([length, time], [0.3, 1.1], &[1, 2, 3]);
        }
    }
    // Up to n = 60.
    assert_closed_form([1e3, 1e-3], [0.0333, 0.034], &[1]);
    assert_closed_form([1e-3, 1e3], [0.0333, 0.034], &[1]);
    assert_closed_form([1e-3, 1e-3], [0.0165, 0.0169], &[2, 3]);
}
