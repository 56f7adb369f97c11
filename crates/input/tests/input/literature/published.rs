//! The list of published results, and the examples to which they refer.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use grazing_input::{Description, Expression};
use serde::Deserialize;

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The content of `expected/published_examples.toml`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Published {
    source: BTreeMap<String, Source>,
    formula: Vec<Formula>,
    pub(crate) bifurcation: Vec<Bifurcation>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Source {
    read: String,
    of: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Formula {
    id: String,
    example: String,
    quantity: String,
    expression: String,
    source: String,
    place: String,
}

/// A bifurcation of a single-impact orbit, as printed.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Bifurcation {
    pub(crate) id: String,
    pub(crate) example: String,
    pub(crate) loops: u32,
    pub(crate) kind: Kind,
    pub(crate) secondary: String,
    pub(crate) primary: String,
    pub(crate) impact_velocity: String,
    pub(crate) impact_time: String,
    pub(crate) multipliers: [String; 2],
    source: String,
    place: String,
}

#[derive(Clone, Copy, Deserialize)]
pub(crate) enum Kind {
    #[serde(rename = "saddle-node")]
    SaddleNode,
    #[serde(rename = "period doubling")]
    PeriodDoubling,
}

impl Published {
    pub(crate) fn read() -> Self {
        let path = repository().join("expected/published_examples.toml");
        let text = fs::read_to_string(path).expect("expected/published_examples.toml is text");
        toml::from_str(&text).unwrap_or_else(|error| panic!("expected/published_examples.toml: {error}"))
    }

    /// The published formula with this name, at these values of its letters.
    ///
    /// The formulas are evaluated in the order of the list, each with all preceding ones, up to the
    /// requested one.
    pub(crate) fn formula(&self, example: &str, id: &str, letters: &[(&str, f64)]) -> f64 {
        let mut known = letters.to_vec();
        for formula in self.formula.iter().filter(|formula| formula.example == example) {
            // A formula with a letter that has no value here, such as one for a given clearance, is
            // skipped.
            let Ok(expression) = Expression::parse(&formula.expression, &[], &known) else {
                continue;
            };
            let value = expression.evaluate::<f64>(&[]);
            if formula.id == id {
                return value;
            }
            known.push((&formula.id, value));
        }
        panic!("no formula {id} for {example} in {letters:?}")
    }
}

/// The text of an example.
pub(crate) fn text(example: &str) -> String {
    fs::read_to_string(repository().join("examples").join(example)).expect("an example is text")
}

/// The description of an example.
pub(crate) fn description(example: &str) -> Description {
    Description::parse(&text(example), example).unwrap_or_else(|error| panic!("{error}"))
}

/// A number as printed.
pub(crate) fn number(printed: &str) -> f64 {
    printed.parse().unwrap_or_else(|_| panic!("{printed} is no number"))
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

#[test]
fn everything_published_says_where_it_was_read() {
    let published = Published::read();
    let formulas =
        published.formula.iter().map(|formula| (&formula.example, &formula.source, &formula.place));
    let bifurcations = published.bifurcation.iter().map(|row| (&row.example, &row.source, &row.place));
    for (example, source, place) in formulas.chain(bifurcations) {
        description(example);
        let source = &published.source[source];
        assert!(source.read.contains("commit ") && !source.of.is_empty() && !place.is_empty());
    }
    assert!(published.formula.iter().all(|formula| !formula.quantity.is_empty()));
}
