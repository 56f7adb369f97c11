//! Numbers of `expected/published.toml` that checks need, such as the parameters of Figure 2.

use serde::Deserialize;

const FILE: &str = include_str!("../../../expected/published.toml");

#[derive(Deserialize)]
struct File {
    value: Vec<Entry>,
}

#[derive(Deserialize)]
struct Entry {
    id: String,
    value: String,
}

impl Entry {
    fn number(&self) -> f64 {
        self.value.parse().unwrap_or_else(|_| panic!("expected/published.toml: {} is not a number", self.id))
    }
}

fn entries() -> Vec<Entry> {
    let file: File = toml::from_str(FILE).unwrap_or_else(|error| panic!("expected/published.toml: {error}"));
    file.value
}

/// The printed number with this identifier.
pub(crate) fn printed(id: &str) -> f64 {
    let entry = entries().into_iter().find(|entry| entry.id == id);
    entry.unwrap_or_else(|| panic!("expected/published.toml has no number {id}")).number()
}

/// The printed values of a quantity at resonances: p, n, and the number with identifier `quantity_p…_n…`.
pub(crate) fn printed_at_resonances(quantity: &str) -> Vec<(u32, u32, f64)> {
    let indices = |id: &str| {
        let (loops, index) = id.strip_prefix(quantity)?.strip_prefix("_p")?.split_once("_n")?;
        Some((loops.parse().ok()?, index.parse().ok()?))
    };
    let at_resonance = |entry: Entry| indices(&entry.id).map(|(p, n)| (p, n, entry.number()));
    entries().into_iter().filter_map(at_resonance).collect()
}
