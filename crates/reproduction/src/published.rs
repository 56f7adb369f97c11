//! The numbers that the paper prints, held against computed ones.
//!
//! They stand in `expected/published.toml` with the digits of the print, and only there.

use std::collections::{BTreeMap, BTreeSet};

use serde::Deserialize;
use thiserror::Error;

const FILE: &str = include_str!("../../../expected/published.toml");

/// What can be wrong with the list of published values.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PublishedError {
    /// The list is not TOML, or a key is missing, unknown or of the wrong type.
    #[error("expected/published.toml:{line}: {reason}")]
    Unreadable {
        /// The line, from 1.
        line: usize,
        /// What the TOML reader says.
        reason: String,
    },
    /// A value that is not a number in plain decimal notation.
    #[error(
        "expected/published.toml: {id} = \"{value}\": a number with its printed digits is expected, as \"-1.50\""
    )]
    NotDecimal {
        /// The identifier.
        id: String,
        /// The value as it stands there.
        value: String,
    },
    /// An identifier that stands there twice.
    #[error("expected/published.toml: {id} stands there twice")]
    Twice {
        /// The identifier.
        id: String,
    },
}

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
pub struct PublishedValue {
    id: String,
    quantity: String,
    label: String,
    #[serde(rename = "where")]
    place: String,
    value: String,
    rounding: Rounding,
}

impl PublishedValue {
    /// The name under which the reproduction gives the same quantity.
    pub fn id(&self) -> &str {
        &self.id
    }

    /// The quantity in the paper's symbols.
    pub fn quantity(&self) -> &str {
        &self.quantity
    }

    /// The LaTeX label of the figure, section or equation that the number belongs to.
    pub fn label(&self) -> &str {
        &self.label
    }

    /// Where the paper prints it.
    pub fn place(&self) -> &str {
        &self.place
    }

    /// The number with the digits of the print.
    pub fn printed(&self) -> &str {
        &self.value
    }

    /// How the print came from the number.
    pub fn rounding(&self) -> Rounding {
        self.rounding
    }

    /// The number of printed decimals.
    pub fn decimals(&self) -> usize {
        self.value.split_once('.').map_or(0, |(_, decimals)| decimals.len())
    }

    /// Whether the print is a sign at most, digits, and at most one point with digits on both sides.
    fn is_decimal(&self) -> bool {
        let unsigned = self.value.strip_prefix('-').unwrap_or(&self.value);
        let (whole, decimals) = unsigned.split_once('.').unwrap_or((unsigned, "0"));
        let digits = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
        digits(whole) && digits(decimals)
    }

    /// Whether a computed value, rounded to the printed decimals (to nearest, as its exact binary value demands), is
    /// the print; for [`Rounding::Exact`], whether it is the printed number itself. NaN never is.
    fn is_met_by(&self, computed: f64) -> bool {
        let printed: f64 = self.value.parse().unwrap_or(f64::NAN);
        match self.rounding {
            Rounding::Exact => computed == printed,
            Rounding::Significant => {
                let rounded = format!("{computed:.decimals$}", decimals = self.decimals());
                rounded.parse::<f64>().is_ok_and(|rounded| rounded == printed)
            }
        }
    }
}

/// What came of holding a computed value against the print.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Verdict {
    /// The computed value, rounded to the printed digits, is the print.
    Met {
        /// The computed value.
        computed: f64,
        /// Computed minus printed value.
        difference: f64,
    },
    /// It is not.
    Off {
        /// The computed value.
        computed: f64,
        /// Computed minus printed value.
        difference: f64,
    },
    /// Nothing was computed: under these parameters the quantity does not come up.
    NotComputed,
}

/// A published value with its verdict.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison<'a> {
    /// The published value.
    pub published: &'a PublishedValue,
    /// What came of it.
    pub verdict: Verdict,
}

impl Comparison<'_> {
    /// Whether the computed value is the print.
    pub fn is_met(&self) -> bool {
        matches!(self.verdict, Verdict::Met { .. })
    }
}

/// The list of published values, in the order of the file.
#[derive(Debug, Clone, PartialEq)]
pub struct Published {
    values: Vec<PublishedValue>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    value: Vec<PublishedValue>,
}

impl Published {
    /// The list of `expected/published.toml` as it stood when this program was built.
    ///
    /// # Errors
    /// [`PublishedError`] if that file is not as it should be.
    pub fn printed() -> Result<Published, PublishedError> {
        Published::parse(FILE)
    }

    /// The list that a text in the form of `expected/published.toml` holds.
    ///
    /// # Errors
    /// [`PublishedError`]: not TOML, an identifier that stands there twice, or a value that is no decimal number.
    pub fn parse(text: &str) -> Result<Published, PublishedError> {
        let file: File = toml::from_str(text).map_err(|error| {
            let start = error.span().map_or(0, |span| span.start);
            PublishedError::Unreadable {
                line: 1 + text[..start].matches('\n').count(),
                reason: error.message().to_owned(),
            }
        })?;
        let mut seen = BTreeSet::new();
        for value in &file.value {
            if !value.is_decimal() {
                return Err(PublishedError::NotDecimal { id: value.id.clone(), value: value.value.clone() });
            }
            if !seen.insert(&value.id) {
                return Err(PublishedError::Twice { id: value.id.clone() });
            }
        }
        Ok(Published { values: file.value })
    }

    /// The values in the order of the file.
    pub fn values(&self) -> &[PublishedValue] {
        &self.values
    }

    /// Holds computed values, by identifier, against the print: one verdict for each published value. Computed values
    /// that the paper does not print are passed over.
    pub fn compare(&self, computed: &BTreeMap<String, f64>) -> Vec<Comparison<'_>> {
        let compare = |published| Comparison { published, verdict: verdict(published, computed) };
        self.values.iter().map(compare).collect()
    }
}

fn verdict(published: &PublishedValue, computed: &BTreeMap<String, f64>) -> Verdict {
    let Some(&computed) = computed.get(&published.id) else {
        return Verdict::NotComputed;
    };
    let difference = computed - published.value.parse::<f64>().unwrap_or(f64::NAN);
    if published.is_met_by(computed) {
        Verdict::Met { computed, difference }
    } else {
        Verdict::Off { computed, difference }
    }
}
