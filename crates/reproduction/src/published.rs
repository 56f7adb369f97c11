//! The numbers that the paper prints, held against computed ones.
//!
//! They stand in `expected/published.toml` with the digits of the print, and only there.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

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

    /// Whether the print is a sign at most, digits, and at most one point with digits on both sides.
    fn is_decimal(&self) -> bool {
        let unsigned = self.printed.strip_prefix('-').unwrap_or(&self.printed);
        let (whole, decimals) = unsigned.split_once('.').unwrap_or((unsigned, "0"));
        let digits = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
        digits(whole) && digits(decimals)
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
    /// Whether the computed value, rounded to the printed decimals (to nearest, as its exact binary value demands), is the print; for
    /// [`Rounding::Exact`], whether it is the printed number itself. NaN never is, nor is what was not computed.
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

    /// Computed minus printed value.
    pub fn difference(&self) -> Option<f64> {
        Some(self.computed? - self.published.number())
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
    ///
    /// # Errors
    /// [`PublishedError`] if that file is not as it should be.
    pub fn printed() -> Result<&'static Published, PublishedError> {
        static PRINTED: LazyLock<Result<Published, PublishedError>> =
            LazyLock::new(|| Published::parse(FILE));
        PRINTED.as_ref().map_err(Clone::clone)
    }

    /// The list that a text in the form of `expected/published.toml` holds.
    ///
    /// # Errors
    /// [`PublishedError`]: not TOML, an identifier that stands there twice, or a value that is no decimal number.
    pub fn parse(text: &str) -> Result<Published, PublishedError> {
        let published: Published = toml::from_str(text).map_err(|error| {
            let start = error.span().map_or(0, |span| span.start);
            PublishedError::Unreadable {
                line: 1 + text[..start].matches('\n').count(),
                reason: error.message().to_owned(),
            }
        })?;
        let mut seen = BTreeSet::new();
        for value in &published.values {
            if !value.is_decimal() {
                return Err(PublishedError::NotDecimal {
                    id: value.id.clone(),
                    value: value.printed.clone(),
                });
            }
            if !seen.insert(&value.id) {
                return Err(PublishedError::Twice { id: value.id.clone() });
            }
        }
        Ok(published)
    }

    /// Holds computed values, by identifier, against the print: one comparison for each published value. Computed values
    /// that the paper does not print are passed over.
    pub fn compare(&self, computed: &BTreeMap<String, f64>) -> Vec<Comparison<'_>> {
        let of = |value: &PublishedValue| computed.get(&value.id).copied();
        self.values.iter().map(|value| Comparison { published: value, computed: of(value) }).collect()
    }
}
