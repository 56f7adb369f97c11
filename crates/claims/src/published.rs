//! The numbers that the paper prints, held against computed ones.
//!
//! They stand in `expected/published.toml` with the digits of the print. No Rust file has one of
//! more than two digits, and none but tests and benchmarks the damping ratio and the restitution,
//! which have fewer, side by side: those are read from `figures/parameters.toml` or an example.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::LazyLock;

use serde::Deserialize;

/// How the print came from the number.
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
    /// The name under which the reproduction gives the same quantity.
    pub id: String,
    /// The quantity in the paper's symbols.
    pub quantity: String,
    /// The LaTeX label of the figure, section or equation that the number belongs to.
    pub label: String,
    /// Where the paper prints it.
    #[serde(rename = "where")]
    pub place: String,
    /// The number with the digits of the print.
    #[serde(rename = "value")]
    pub printed: String,
    /// How the print came from the number.
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

/// A published value with what the reproduction gives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Comparison<'a> {
    /// The published value.
    pub published: &'a PublishedValue,
    /// The computed value; none if under these parameters the quantity does not come up.
    pub computed: Option<f64>,
}

impl Comparison<'_> {
    /// Whether the computed value, rounded to the printed decimals (to nearest, by its exact
    /// value), is the print; for [`Rounding::Exact`], whether it is the printed number. NaN never
    /// is.
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

    /// Whether the print chose the number, which the parameters give back: nothing is computed.
    pub fn is_input(&self) -> bool {
        self.published.rounding == Rounding::Exact
    }

    /// Computed minus printed value.
    pub fn difference(&self) -> Option<f64> {
        Some(self.computed? - self.published.number())
    }
}

/// How many published values are met: those that are computed, and apart from them those that the
/// parameters give back.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Tally {
    /// Computed ones that are met.
    pub met: usize,
    /// Computed ones.
    pub computed: usize,
    /// Parameters that are the printed ones.
    pub inputs_met: usize,
    /// Parameters.
    pub inputs: usize,
}

impl Tally {
    /// Counts what is met.
    pub fn of(comparisons: &[Comparison<'_>]) -> Self {
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

    /// Whether all are met, and any is computed.
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
    /// The list of `expected/published.toml` as it stood when this program was built.
    pub fn printed() -> &'static Published {
        static PRINTED: LazyLock<Published> = LazyLock::new(|| {
            let file = include_str!("../../../expected/published.toml");
            toml::from_str(file).expect("a test holds that the list is right")
        });
        &PRINTED
    }

    /// One comparison for each published value; what is computed and not printed is passed over.
    pub fn compare(&self, computed: &BTreeMap<String, f64>) -> Vec<Comparison<'_>> {
        let of = |value: &PublishedValue| computed.get(&value.id).copied();
        self.values.iter().map(|value| Comparison { published: value, computed: of(value) }).collect()
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
