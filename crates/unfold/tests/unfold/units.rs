//! The linear oscillator in other units of length and time.

use grazing_continuation::curve::Window;
use grazing_description::Description;
use grazing_model::ImpactOscillator;
use grazing_model::smooth::{Dimensionless, Integrated};
use grazing_theorems::LinearOscillator as Theory;
use grazing_unfold::Scope;
use grazing_unfold::progress::Silent;
use grazing_unfold::resonances::on_curve;

use crate::specimens::{EPSILON, ZETA, grazing_curves};

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
    let oscillator = Integrated::new(Dimensionless::new(description, units), [0.0, 1.0]);
    let curves = grazing_curves(&oscillator, &scope).unwrap();
    let [curve] = curves.as_slice() else { panic!("{} pieces", curves.len()) };
    let (found, lost) = on_curve(curve, &scope, &Silent);
    assert!(lost.is_empty(), "{lost:?}");
    let known =
        Theory::new(ZETA, EPSILON).unwrap().resonances(loops, frequencies[0], frequencies[1]).unwrap();
    assert!(known.len() > 1);
    for known in known {
        let (p, n) = (known.loops(), known.index());
        let resonance = found.iter().find(|found| found.loops == p && found.n == n && found.theorem.is_ok());
        let Some(Ok(point)) = resonance.map(|found| &found.theorem) else {
            panic!("p = {p}, n = {n} is missing");
        };
        let [amplitude, frequency] = units.parameters(point.orbit().oscillator().parameters());
        let theorem = point.theorem();
        let coefficient = units.primary / (units.secondary * units.secondary);
        for (computed, exact) in [
            (frequency * time, known.forcing_frequency()),
            (amplitude * time * time / length, known.grazing().amplitude()),
            // A has the unit length/time², omega the unit 1/time.
            (theorem.saddle_node().coefficient * coefficient / length, known.saddle_node_coefficient()),
            (
                theorem.period_doubling().coefficient * coefficient / length,
                known.period_doubling_coefficient(),
            ),
        ] {
            // As in the units in which the oscillator is of the order of one.
            assert!((computed / exact - 1.0).abs() < 1e-9, "p = {p}, n = {n}: {computed:e} {exact:e}");
        }
    }
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
