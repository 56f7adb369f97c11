//! The numbers that the paper prints, compared with computed ones.
//!
//! They are in `expected/published.toml` with the printed digits. No Rust file contains one of more than
//! two digits, and only tests and benchmarks contain the damping ratio and the restitution, which have
//! fewer, side by side: elsewhere these are read from `figures/parameters.toml` or an example.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::LazyLock;

use serde::Deserialize;

/// The relation of the printed to the exact number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Rounding {
    /// Rounded to the printed digits, all of them significant.
    Significant,
    /// A chosen number, printed whole.
    Exact,
}

/// One number as the paper prints it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct PublishedValue {
    /// The name of the quantity in the results of the reproduction.
    pub id: String,
    /// The quantity in the paper's symbols.
    pub quantity: String,
    /// The LaTeX label of the figure, section or equation that the number belongs to.
    pub label: String,
    /// The place in the paper.
    #[serde(rename = "where")]
    pub place: String,
    /// The number with the printed digits.
    #[serde(rename = "value")]
    pub printed: String,
    /// The relation of the printed to the exact number.
    pub rounding: Rounding,
}

impl PublishedValue {
    /// The number of printed decimals.
    pub fn decimals(&self) -> usize {
        self.printed.split_once('.').map_or(0, |(_, decimals)| decimals.len())
    }

    fn number(&self) -> f64 {
        self.printed.parse().unwrap_or(f64::NAN)
    }
}

/// A published value with the value computed by the reproduction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PublishedComparison<'a> {
    /// The published value.
    pub published: &'a PublishedValue,
    /// The computed value; none if the quantity does not exist for these parameters.
    pub computed: Option<f64>,
}

impl PublishedComparison<'_> {
    /// Whether the computed value, rounded to the printed decimals (to nearest, by its exact value),
    /// equals the print; for [`Rounding::Exact`], whether it equals the printed number. False for NaN.
    pub fn is_met(&self) -> bool {
        let Self { published, computed: Some(computed) } = self else { return false };
        match published.rounding {
            Rounding::Exact => *computed == published.number(),
            Rounding::Significant => {
                let rounded = format!("{computed:.decimals$}", decimals = published.decimals());
                rounded.parse().is_ok_and(|rounded: f64| rounded == published.number())
            }
        }
    }

    /// Whether the number is a choice of the paper that the parameters reproduce, so that nothing is
    /// computed.
    pub fn is_input(&self) -> bool {
        self.published.rounding == Rounding::Exact
    }

    /// Computed minus printed value.
    pub fn difference(&self) -> Option<f64> {
        Some(self.computed? - self.published.number())
    }
}

/// The numbers of published values that are met: those that are computed and, counted separately, those
/// that are parameters.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Tally {
    /// The number of computed values that are met.
    pub met: usize,
    /// The number of computed values.
    pub computed: usize,
    /// The number of parameters that equal the printed ones.
    pub inputs_met: usize,
    /// The number of parameters.
    pub inputs: usize,
}

impl Tally {
    /// Counts the values that are met.
    pub fn of(comparisons: &[PublishedComparison<'_>]) -> Self {
        let mut tally = Self::default();
        for comparison in comparisons {
            let (met, all) = if comparison.is_input() {
                (&mut tally.inputs_met, &mut tally.inputs)
            } else {
                (&mut tally.met, &mut tally.computed)
            };
            *met += usize::from(comparison.is_met());
            *all += 1;
        }
        tally
    }

    /// Whether all are met, and at least one is computed.
    pub fn is_complete(&self) -> bool {
        self.computed > 0 && (self.met, self.inputs_met) == (self.computed, self.inputs)
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { met, computed, inputs_met, inputs } = self;
        if self.is_complete() {
            write!(
                formatter,
                "All {computed} computed published values are met; {inputs} more are parameters"
            )
        } else {
            write!(
                formatter,
                "{met} of {computed} computed published values are met, and {inputs_met} of {inputs} that are parameters"
            )
        }
    }
}

/// The list of published values.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct Published {
    /// The values in the order of the file.
    #[serde(rename = "value")]
    pub values: Vec<PublishedValue>,
}

impl Published {
    /// The list in `expected/published.toml` at the time when the program was built.
    pub fn printed() -> &'static Published {
        static PRINTED: LazyLock<Published> = LazyLock::new(|| {
            let file = include_str!("../../../expected/published.toml");
            toml::from_str(file).expect("a test holds that the list is right")
        });
        &PRINTED
    }

    /// Whether the number with this identifier is one that the paper chooses.
    pub fn is_parameter(id: &str) -> bool {
        let mut values = Published::printed().values.iter();
        values.any(|value| value.id == id && value.rounding == Rounding::Exact)
    }

    /// One comparison for each published value; computed values that are not printed are ignored.
    pub fn compare(&self, computed: &BTreeMap<String, f64>) -> Vec<PublishedComparison<'_>> {
        let of = |value: &PublishedValue| computed.get(&value.id).copied();
        self.values
            .iter()
            .map(|value| PublishedComparison { published: value, computed: of(value) })
            .collect()
    }
}

/// The printed number with this identifier, for checks that need it.
pub(crate) fn printed(id: &str) -> f64 {
    let value = Published::printed().values.iter().find(|value| value.id == id);
    value.unwrap_or_else(|| panic!("expected/published.toml has no number {id}")).number()
}

/// The printed values of a quantity at resonances: p, n, and the number `quantity_p…_n…`.
pub(crate) fn printed_at_resonances(quantity: &str) -> Vec<(u32, u32, f64)> {
    let at_resonance = |value: &PublishedValue| {
        let (loops, index) = value.id.strip_prefix(quantity)?.strip_prefix("_p")?.split_once("_n")?;
        Some((loops.parse().ok()?, index.parse().ok()?, value.number()))
    };
    Published::printed().values.iter().filter_map(at_resonance).collect()
}
