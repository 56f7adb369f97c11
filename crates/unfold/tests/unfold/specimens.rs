//! Oscillators for tests, and functions that analyse them.

use std::path::{Path, PathBuf};

use grazing_continuation::curve::Window;
use grazing_input::Description;
use grazing_model::smooth::{Stop, Units};
use grazing_model::{AnyOscillator, ImpactOscillator, LinearOscillator};
use grazing_results::Dimensioned;
use grazing_theorems::GrazingState;
use grazing_unfold::grazing::GrazingCurve;
use grazing_unfold::progress::Silent;
use grazing_unfold::resonances::{FoundResonance, on_curve};
use grazing_unfold::{Diagram, Scope, UnfoldError};

/// The damping ratio and the coefficient of restitution of the paper's figures.
pub(crate) const ZETA: f64 = 0.02;
pub(crate) const EPSILON: f64 = 0.9;

/// A damping ratio at which motion settles quickly.
pub(crate) const DAMPED: f64 = 0.1;

/// A file of the repository.
pub(crate) fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(name)
}

pub(crate) fn scope(primary: [f64; 2], secondary: [f64; 2], loops: &[u32]) -> Scope {
    Scope { window: Window { primary, secondary }, loops: loops.to_vec(), start: None }
}

/// The paper's oscillator; its own parameters do not matter.
pub(crate) fn closed_form() -> AnyOscillator {
    linear(ZETA, EPSILON, [0.5, 0.8])
}

/// The linear oscillator with ζ, ε and (𝒜, ω).
pub(crate) fn linear(zeta: f64, epsilon: f64, [amplitude, frequency]: [f64; 2]) -> AnyOscillator {
    AnyOscillator::new(LinearOscillator::new(zeta, epsilon, amplitude, frequency).unwrap())
}

/// The closed form of grazing of the linear oscillator.
pub(crate) fn grazing_at(zeta: f64, frequency: f64) -> GrazingState {
    grazing_theorems::LinearOscillator::new(zeta, EPSILON).unwrap().grazing(frequency).unwrap()
}

/// The description of an example from its file.
pub(crate) fn described_example(name: &str) -> Description {
    Description::from_file(&file("examples").join(name)).unwrap_or_else(|error| panic!("{error}"))
}

/// The oscillator of an example, and the scope that its file requests.
pub(crate) fn example(name: &str) -> (AnyOscillator, Scope) {
    let description = described_example(name);
    let [primary, secondary] = [description.primary(), description.secondary()].map(|axis| axis.range());
    let mut scope = scope(primary, secondary, description.loops());
    scope.start = description.start();
    (description.oscillator([primary[1], secondary[1]]), scope)
}

/// The nondimensional oscillator and scope of an [`example`], with its units.
pub(crate) fn counted(name: &str) -> (AnyOscillator, Scope, Units) {
    let (description, (_, scope)) = (described_example(name), example(name));
    let units = description.units();
    let scope = scope.without_dimensions(&units);
    let Window { primary, secondary } = scope.window;
    (description.counted([primary[1], secondary[1]], &units, &Stop::default()), scope, units)
}

/// A constant of an example.
pub(crate) fn constant(example: &str, name: &str) -> f64 {
    let description = described_example(example);
    description.constants().find(|(known, _)| *known == name).unwrap_or_else(|| panic!("{name}")).1
}

/// An oscillator with parameters `mu` and `eta`, a constant `zeta` for its damping, and a wall.
pub(crate) fn described(
    [force, frequency, wall]: [&str; 3],
    restitution: f64,
    [primary, secondary]: [[f64; 2]; 2],
) -> Description {
    let text = format!(
        "name = \"Test\"\n[parameters]\nzeta = {DAMPED}\n[primary]\nname = \"mu\"\nrange = {primary:?}\n\
         [secondary]\nname = \"eta\"\nrange = {secondary:?}\n[motion]\nforce = \"{force}\"\n\
         frequency = \"{frequency}\"\n[wall]\nposition = \"{wall}\"\n\
         [impact]\nrestitution = \"{restitution}\"\nduration = \"0\"\n[analysis]\nloops = [1]\n"
    );
    Description::parse(&text, "test.toml").unwrap_or_else(|error| panic!("{error}"))
}

/// An oscillator with a given force and frequency and the wall at x = 0.
pub(crate) fn written(force: &str, frequency: &str, scope: &Scope) -> AnyOscillator {
    let Window { primary, secondary } = scope.window;
    let description = described([force, frequency, "0"], EPSILON, [primary, secondary]);
    description.oscillator([primary[1], secondary[1]])
}

/// The pieces of the grazing curve.
pub(crate) fn grazing_curves(
    oscillator: &AnyOscillator,
    scope: &Scope,
) -> Result<Vec<GrazingCurve>, UnfoldError> {
    let only_grazing = Scope { loops: Vec::new(), ..scope.clone() };
    Diagram::compute(oscillator, &only_grazing, &Silent).map(|diagram| diagram.grazing)
}

/// The grazing curve, which has one piece.
#[track_caller]
pub(crate) fn grazing_curve(oscillator: &AnyOscillator, scope: &Scope) -> GrazingCurve {
    let mut curves = grazing_curves(oscillator, scope).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(curves.len(), 1);
    curves.remove(0)
}

/// The resonances on the grazing curve, all of which are located.
#[track_caller]
pub(crate) fn resonances(oscillator: &AnyOscillator, scope: &Scope) -> Vec<FoundResonance> {
    let (found, lost) = on_curve(&grazing_curve(oscillator, scope), scope, &Silent);
    assert!(lost.is_empty(), "{lost:?}");
    found
}

/// Checks that every resonance known in closed form in a range is among those found, with the same
/// values to nine digits: ω*, 𝒜_graz, c_SN and c_PD, which `scaled` converts to the units of the
/// test.
///
/// Integration leaves 1e-11 over sixty turns of neighbouring motion.
#[track_caller]
pub(crate) fn assert_closed_form(
    found: &[FoundResonance],
    [lowest, highest]: [f64; 2],
    loops: &[u32],
    scaled: impl Fn([f64; 4]) -> [f64; 4],
) {
    let theory = grazing_theorems::LinearOscillator::new(ZETA, EPSILON).unwrap();
    let known = theory.resonances(loops, lowest, highest).unwrap();
    let unfolding = found.iter().filter(|resonance| resonance.theorem.is_ok()).count();
    assert!(known.len() > 1 && unfolding == known.len(), "{unfolding} of {}", known.len());
    for known in known {
        let (p, n) = (known.loops(), known.index());
        let resonance = found.iter().find(|found| found.loops == p && found.n == n && found.theorem.is_ok());
        let Some(Ok(point)) = resonance.map(|found| &found.theorem) else {
            panic!("p = {p}, n = {n} is missing");
        };
        let [amplitude, frequency] = point.orbit().oscillator().parameters();
        let [c_sn, c_pd] = point.leading().map(|curve| curve.coefficient).into_array();
        let exact = [
            known.forcing_frequency(),
            known.grazing().amplitude(),
            known.saddle_node_coefficient(),
            known.period_doubling_coefficient(),
        ];
        for (computed, exact) in scaled([frequency, amplitude, c_sn, c_pd]).into_iter().zip(exact) {
            assert!((computed / exact - 1.0).abs() < 1e-9, "p = {p}, n = {n}: {computed:e} {exact:e}");
        }
    }
}

/// Fails unless the numbers differ by at most `bound`.
#[track_caller]
pub(crate) fn assert_within(computed: f64, expected: f64, bound: f64) {
    let difference = (computed - expected).abs();
    assert!(
        difference <= bound,
        "{computed:e} instead of {expected:e}: off by {difference:e}, more than {bound:e}"
    );
}

/// An oscillator forced with the frequency `eta`, beside a wall.
pub(crate) fn forced(force: &str, wall: &str, restitution: f64, ranges: [[f64; 2]; 2]) -> Description {
    described([force, "eta", wall], restitution, ranges)
}

/// A random oscillator of the trials.
pub(crate) fn random(number: u64, seed: u64) -> Description {
    let text = grazing_trials::oscillators::description(seed, number);
    Description::parse(&text, "random.toml").expect("what is made at random is right")
}

/// A layer that attracts and then repels (Morse).
pub(crate) const LAYER: &str = "0.3*4*(exp(4*(x + 0.25)) - exp(8*(x + 0.25)))";
