//! `expected/claims.toml`: the statements of the paper, label by label.

use std::fmt;

use serde::Deserialize;

use crate::checks::{CHECKS, Check};
use crate::published::Published;

const FILE: &str = include_str!("../../../expected/claims.toml");

/// Declares the kinds of statements, each with its word in the ledger and its meaning.
macro_rules! kinds {
    ($($name:ident = $word:literal, $meaning:literal;)*) => {
        /// The kind of a claim's statement.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
        pub enum ClaimKind { $(#[serde(rename = $word)] #[doc = $meaning] $name,)* }

        impl ClaimKind {
            /// All kinds.
            pub const ALL: [Self; [$($word),*].len()] = [$(Self::$name),*];
            /// The word for the kind in the ledger.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$name => $word,)* }
            }

            /// The meaning of the kind, in a few words.
            pub const fn meaning(self) -> &'static str {
                match self { $(Self::$name => $meaning,)* }
            }
        }
    };
}

kinds! {
    Definition = "definition", "what a symbol stands for";
    Assumption = "assumption", "what is assumed";
    Identity = "identity", "two expressions are equal";
    Expansion = "expansion", "an expression up to a remainder of stated order";
    Inequality = "inequality", "something is positive, or lies between bounds";
    Theorem = "theorem", "a lemma, proposition or theorem, or a statement in words";
    Number = "number", "a printed number";
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
    /// The LaTeX label, as `eq:gp`; for a statement without a label, a name such as
    /// `sub:2/period-doubling`.
    pub label: String,
    /// The place of the statement: "section 2.4, eq. (15)". Equation numbers restart in each section.
    pub place: String,
    /// The kind of statement.
    pub kind: ClaimKind,
    /// The statement in words and Unicode.
    pub says: String,
    /// The formula in LaTeX, without dollars, in standard commands only.
    pub formula: Option<String>,
    /// The public items that implement it, as `grazing_theorems::auxiliary::resonance_boundary`.
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

/// A difference between print and mathematics.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Misprint {
    /// The printed form, in words with LaTeX between dollars.
    pub printed: String,
    /// The corrected form, in words with LaTeX between dollars.
    pub corrected: String,
    /// The reason, and the consequences.
    pub reason: String,
    /// The computation that decides it, in words; the measurements are those of the check.
    pub decided: String,
    /// The kind of misprint.
    #[serde(default)]
    pub kind: MisprintKind,
    /// The label of the claim at which the same misprint is described.
    pub same_as: Option<String>,
}

/// The kinds of differences between print and mathematics, the most substantial first.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum MisprintKind {
    /// A statement does not hold; the computation shows that the printed form fails.
    Observation,
    /// A formula or a condition is misprinted; the printed form fails.
    #[default]
    Formula,
    /// A condition or a reason is missing; if it can be measured, the printed form fails.
    Judged,
    /// A misprint of notation or wording, decided by reading: there is no printed value that could fail.
    Wording,
}

impl Misprint {
    /// Whether the check measures the printed form too; nothing if it may or may not.
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
    /// A check of this crate.
    Check(&'static Check),
    /// A comparison of computed numbers with `expected/published.toml`, under these names.
    Published(&'a [String]),
    /// Parameters that the paper chooses, under these names: the computation begins with them, so that
    /// there is nothing to compare.
    Given(&'a [String]),
    /// No numerical test, for this reason.
    Unchecked(&'a str),
}

impl Claim {
    /// The name of the check, if the claim has one.
    pub fn check_name(&self) -> Option<&str> {
        self.check.as_deref()
    }

    /// Whether exactly one way to test the claim is given.
    pub fn has_one_test(&self) -> bool {
        let given = [self.check.is_some(), !self.published.is_empty(), self.unchecked.is_some()];
        given.iter().filter(|given| **given).count() == 1
    }

    /// The way to test the claim.
    ///
    /// # Panics
    /// Never for a claim of [`Ledger::of_the_paper`], from which the table of checks is generated.
    pub fn test(&self) -> Test<'_> {
        match (&self.check, &self.unchecked) {
            (Some(name), _) => {
                let check = CHECKS.iter().find(|check| check.name == name);
                Test::Check(check.expect("the table of checks is made of the ledger"))
            }
            (None, Some(reason)) => Test::Unchecked(reason),
            (None, None) if self.published.iter().all(|id| Published::is_parameter(id)) => {
                Test::Given(&self.published)
            }
            (None, None) => Test::Published(&self.published),
        }
    }
}

/// The complete list of claims, in the order of the paper.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ledger {
    /// The claims.
    #[serde(rename = "claim", default)]
    pub claims: Vec<Claim>,
}

impl Ledger {
    /// The ledger of this project at the time when the program was built.
    ///
    /// # Panics
    /// Never: the file is a part of the program, and a test reads it.
    pub fn of_the_paper() -> Self {
        toml::from_str(FILE).unwrap_or_else(|error| panic!("expected/claims.toml: {error}"))
    }
}
