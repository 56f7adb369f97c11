//! Oscillators with random constants and windows, as the text files that `grazing unfold` reads.

use core::fmt::Write;
use std::collections::BTreeMap;
use std::sync::LazyLock;

use serde::Deserialize;

use crate::random::Random;

/// A kind of oscillator: expressions, and the ranges of their random constants.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Family {
    name: String,
    force: String,
    restitution: String,
    duration: String,
    /// Constants with their ranges, in addition to ζ and ε.
    constants: Vec<(String, [f64; 2])>,
    /// Name and lower end of the primary parameter, and the range of its upper end.
    primary: (String, f64, [f64; 2]),
    /// Name of the secondary parameter, and the ranges of its two ends.
    secondary: (String, [f64; 2], [f64; 2]),
}

/// All kinds.
static FAMILIES: LazyLock<Vec<Family>> = LazyLock::new(|| {
    let file: BTreeMap<String, Vec<Family>> =
        toml::from_str(include_str!("../families.toml")).expect("a test reads it");
    file.into_values().flatten().collect()
});

/// The greatest number of random numbers that an oscillator uses.
const MOST_NUMBERS: u64 = 16;

/// The random oscillator of a seed and a number, as text; successive numbers cycle through all kinds.
pub fn description(seed: u64, number: u64) -> String {
    let family = &FAMILIES[number as usize % FAMILIES.len()];
    let mut random = Random::from(seed, number * MOST_NUMBERS);
    let always = [("zeta", [0.01, 0.1]), ("epsilon", [0.5, 0.95])];
    let mut constants = String::new();
    let own = family.constants.iter().map(|(name, range)| (name.as_str(), *range));
    for (name, [low, high]) in always.into_iter().chain(own) {
        writeln!(constants, "{name} = {:.5}", random.logarithmic(low, high)).expect("a string takes all");
    }
    let Family { name, force, restitution, duration, primary, secondary, .. } = family;
    let (primary, from, [least, most]) = primary;
    let to = random.uniform(*least, *most);
    let (secondary, below, above) = secondary;
    let [low, high] = [below, above].map(|[least, most]| random.uniform(*least, *most));
    format!(
        "name = \"{name}\"\n\n[parameters]\n{constants}\n\
         [primary]\nname = \"{primary}\"\nrange = [{from:.1}, {to:.4}]\n\n\
         [secondary]\nname = \"{secondary}\"\nrange = [{low:.4}, {high:.4}]\n\n\
         [motion]\nforce = \"{force}\"\nfrequency = \"omega\"\n\n\
         [impact]\nrestitution = \"{restitution}\"\nduration = \"{duration}\"\n\n\
         [analysis]\nloops = [1, 2, 3]\n"
    )
}
