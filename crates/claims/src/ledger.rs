//! `expected/claims.toml`: what the paper states, label by label.

use std::collections::BTreeSet;
use std::fmt;

use serde::Deserialize;
use thiserror::Error;

use crate::checks::{self, Check};

const FILE: &str = include_str!("../../../expected/claims.toml");

/// What can be wrong with the ledger.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum LedgerError {
    /// The file is not TOML, or a key is missing, unknown or of the wrong type.
    #[error("expected/claims.toml:{line}: {reason}")]
    Unreadable {
        /// The line, from 1.
        line: usize,
        /// What the TOML reader says.
        reason: String,
    },
    /// A label that stands there twice.
    #[error("expected/claims.toml: {label} stands there twice")]
    Twice {
        /// The label.
        label: String,
    },
    /// A claim with no test, or with several kinds of it.
    #[error("expected/claims.toml: {label} needs exactly one of check, published and unchecked")]
    Test {
        /// The label.
        label: String,
    },
    /// A misprint that is said to be the same as one that is not listed before it.
    #[error("expected/claims.toml: {label}: the misprint of {other} is not listed before it")]
    NoMisprint {
        /// The label.
        label: String,
        /// The label of the other.
        other: String,
    },
    /// A check that does not exist.
    #[error("expected/claims.toml: {label}: there is no check {check} in grazing_claims::checks")]
    NoCheck {
        /// The label.
        label: String,
        /// The name of the check.
        check: String,
    },
}

/// What kind of statement a claim is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ClaimKind {
    /// It says what a symbol stands for.
    Definition,
    /// What is assumed.
    Assumption,
    /// Two expressions are equal.
    Identity,
    /// An expression up to a remainder of stated order.
    Expansion,
    /// Something is positive, or lies between bounds.
    Inequality,
    /// A lemma, proposition or theorem, or a statement in words.
    Theorem,
    /// A printed number.
    Number,
}

impl ClaimKind {
    /// All kinds.
    pub const ALL: [Self; 7] = [
        Self::Definition,
        Self::Assumption,
        Self::Identity,
        Self::Expansion,
        Self::Inequality,
        Self::Theorem,
        Self::Number,
    ];

    /// The word for it in the ledger.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Definition => "definition",
            Self::Assumption => "assumption",
            Self::Identity => "identity",
            Self::Expansion => "expansion",
            Self::Inequality => "inequality",
            Self::Theorem => "theorem",
            Self::Number => "number",
        }
    }

    /// What it means, in a few words.
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Definition => "what a symbol stands for",
            Self::Assumption => "what is assumed",
            Self::Identity => "two expressions are equal",
            Self::Expansion => "an expression up to a remainder of stated order",
            Self::Inequality => "something is positive, or lies between bounds",
            Self::Theorem => "a lemma, proposition or theorem, or a statement in words",
            Self::Number => "a printed number",
        }
    }
}

impl fmt::Display for ClaimKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// One statement of the paper.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Claim {
    /// The LaTeX label, such as `eq:gp`; for what has none a name such as `sub:2/period-doubling`, made of the label that
    /// it stands under and a word.
    pub label: String,
    /// Where it stands: "section 2.4, eq. (15)". Equation numbers start anew in each section.
    pub place: String,
    /// The kind of statement.
    pub kind: ClaimKind,
    /// The statement in words and Unicode.
    pub says: String,
    /// The formula in LaTeX, without dollars, in standard commands only.
    pub formula: Option<String>,
    /// The public items that hold it, as `grazing_theorems::auxiliary::resonance_boundary`, which its check calls.
    #[serde(default)]
    pub holds: Vec<String>,
    /// The figures that show it, as `fig04`.
    #[serde(default)]
    pub figures: Vec<String>,
    #[serde(default)]
    check: Option<String>,
    #[serde(default)]
    published: Vec<String>,
    #[serde(default)]
    unchecked: Option<String>,
    /// The misprint, if print and mathematics differ.
    pub misprint: Option<Misprint>,
}

/// Where print and mathematics differ.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Misprint {
    /// The print, LaTeX between dollars in words.
    pub printed: String,
    /// The corrected form, likewise.
    pub corrected: String,
    /// Why, and what follows from it.
    pub reason: String,
    /// The computation that decides it, in words; its measurements are the check's.
    pub decided: String,
    /// What kind it is.
    #[serde(default)]
    pub kind: MisprintKind,
    /// The label of the claim whose misprint is the same one: it is told there.
    pub same_as: Option<String>,
}

/// How print and mathematics differ.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum MisprintKind {
    /// A formula, a condition or a statement is misprinted; a computation decides, and the print fails.
    #[default]
    Formula,
    /// What is printed was observed, and is not so; a computation decides likewise.
    Observation,
    /// Judged as printed: a condition is missing, or a reason; where there is something to measure, the print fails.
    Judged,
    /// One of notation or wording, decided by reading: there is no printed value that could fail.
    Wording,
}

impl Misprint {
    /// Whether its check measures the print too; nothing if it may or may not.
    pub fn measured(&self) -> Option<bool> {
        match self.kind {
            MisprintKind::Formula | MisprintKind::Observation => Some(true),
            MisprintKind::Judged => None,
            MisprintKind::Wording => Some(false),
        }
    }
}

/// How a claim is tested.
#[derive(Debug, Clone, Copy)]
pub enum Test<'a> {
    /// By a check of this crate.
    Check(&'static Check),
    /// By comparison with `expected/published.toml`, under these names.
    Published(&'a [String]),
    /// Not numerically; the reason.
    Unchecked(&'a str),
}

impl Claim {
    /// The name of its check, if a check tests it.
    pub fn check_name(&self) -> Option<&str> {
        self.check.as_deref()
    }

    /// How it is tested.
    ///
    /// # Panics
    /// Never for a claim of a [`Ledger`], which was validated.
    pub fn test(&self) -> Test<'_> {
        match (&self.check, &self.unchecked) {
            (Some(name), _) => {
                Test::Check(checks::all().find(|check| check.name == name).expect("the ledger was validated"))
            }
            (None, Some(reason)) => Test::Unchecked(reason),
            (None, None) => Test::Published(&self.published),
        }
    }
}

/// The whole list, in the order of the paper.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ledger {
    /// The claims.
    #[serde(rename = "claim", default)]
    pub claims: Vec<Claim>,
}

impl Ledger {
    /// The ledger of this project.
    ///
    /// # Errors
    /// [`LedgerError`].
    pub fn of_the_paper() -> Result<Self, LedgerError> {
        Self::read(FILE)
    }

    /// The ledger in this text, validated.
    ///
    /// # Errors
    /// [`LedgerError`].
    pub fn read(text: &str) -> Result<Self, LedgerError> {
        let ledger: Self = toml::from_str(text).map_err(|error| {
            let start = error.span().map_or(0, |span| span.start);
            let line = text.get(..start).map_or(1, |before| before.matches('\n').count() + 1);
            LedgerError::Unreadable { line, reason: error.message().to_owned() }
        })?;
        let mut labels = BTreeSet::new();
        for claim in &ledger.claims {
            let label = claim.label.clone();
            if !labels.insert(&claim.label) {
                return Err(LedgerError::Twice { label });
            }
            let tests = [claim.check.is_some(), !claim.published.is_empty(), claim.unchecked.is_some()];
            if tests.iter().filter(|given| **given).count() != 1 {
                return Err(LedgerError::Test { label });
            }
            if let Some(other) = claim.misprint.as_ref().and_then(|misprint| misprint.same_as.as_ref())
                && !labels.contains(other)
            {
                return Err(LedgerError::NoMisprint { label, other: other.clone() });
            }
            if let Some(check) = &claim.check
                && !checks::all().any(|known| known.name == check)
            {
                return Err(LedgerError::NoCheck { label, check: check.clone() });
            }
        }
        Ok(ledger)
    }
}
