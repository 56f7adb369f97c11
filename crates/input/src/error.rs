//! Errors in a description.

use std::ops::Range;

use thiserror::Error;

use crate::document::{Mistake, Section, SourceError, SourcePlace};
use crate::expression::ExpressionError;
use crate::file::REQUIREMENTS;

/// The first error in a description, with its remedy.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum DescriptionError {
    /// The file cannot be read, is not TOML, or has a wrong key or value.
    #[error(transparent)]
    Source(#[from] SourceError),
    /// An expression is wrong.
    #[error("{place}: {problem}\n{excerpt}")]
    Expression {
        /// The key and place of the expression.
        place: Box<KeyPlace>,
        /// The error and its remedy.
        problem: String,
        /// The line of the expression with a mark under the error.
        excerpt: String,
    },
    /// An expression has a value that is not allowed.
    #[error("{place}: {problem}")]
    Value {
        /// The key and place of the expression.
        place: KeyPlace,
        /// The error, its place in the ranges, and its remedy.
        problem: String,
    },
    /// The reading was cancelled before the file was read and checked.
    #[error("it was not checked to its end")]
    Ended,
    /// Numbers of loops that replace those of the file are wrong.
    #[error("loops {}: {}", loops.iter().map(u32::to_string).collect::<Vec<_>>().join(","), REQUIREMENTS.of("analysis.loops"))]
    Loops {
        /// The numbers.
        loops: Vec<u32>,
    },
}

/// A key with its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeyPlace {
    at: SourcePlace,
    pub(crate) key: String,
}

impl std::fmt::Display for KeyPlace {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{}: {}", self.at, self.key)
    }
}

impl KeyPlace {
    fn mistake(&self, problem: &str) -> Mistake {
        Mistake { key: Some(self.key.clone()), ..self.at.mistake(format!("{}: {problem}", self.key)) }
    }

    pub(crate) fn new(section: &Section<'_>, name: &str) -> KeyPlace {
        KeyPlace { at: section.place(name), key: section.key(name) }
    }
}

/// A note on an expression that is allowed but perhaps not intended.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Note {
    pub(crate) place: KeyPlace,
    pub(crate) remark: String,
}

impl std::fmt::Display for Note {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{}: {}", self.place, self.remark)
    }
}

impl Note {
    /// The note and its place, separately, as those of a mistake.
    pub fn mistake(&self) -> Mistake {
        self.place.mistake(&self.remark)
    }
}

/// The value to six digits, without trailing zeros, and with an exponent where there would be many
/// zeros.
pub(crate) fn rounded(value: f64) -> String {
    let value: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    let plain = value == 0.0 || (1e-5..1e9).contains(&value.abs()) || !value.is_finite();
    if plain { value.to_string() } else { format!("{value:e}") }
}

impl From<DescriptionError> for Mistake {
    fn from(error: DescriptionError) -> Self {
        error.mistake()
    }
}

impl DescriptionError {
    /// The message and its place, separately.
    pub fn mistake(&self) -> Mistake {
        match self {
            Self::Source(error) => error.mistake(),
            Self::Expression { place, problem, .. } => place.mistake(problem),
            Self::Value { place, problem } => place.mistake(problem),
            Self::Ended | Self::Loops { .. } => Mistake::new(self.to_string()),
        }
    }

    /// The error of an expression in a file.
    pub(crate) fn in_expression(
        section: &Section<'_>,
        name: &str,
        text: &str,
        error: &ExpressionError,
    ) -> DescriptionError {
        let at = section.place_in(name, text, &error.span);
        let place = Box::new(KeyPlace { at, key: section.key(name) });
        let excerpt = excerpt(text, &error.span);
        let problem = error.problem.clone();
        DescriptionError::Expression { place, problem, excerpt }
    }
}

/// The largest number of characters of a line that are shown.
const SHOWN: usize = 120;

/// The line of the text in which the span begins, with a mark under the span.
fn excerpt(text: &str, span: &Range<usize>) -> String {
    let start = text[..span.start].rfind('\n').map_or(0, |newline| newline + 1);
    let end = text[span.start..].find('\n').map_or(text.len(), |length| span.start + length);
    let line = &text[start..end];
    if line.trim().is_empty() {
        return "    \"\"\n    ^".to_owned();
    }
    let before = text[start..span.start].chars().count();
    let marked = text[span.start..span.end.min(end).max(span.start)].chars().count().max(1);
    // A long line is cut to the part about the mark.
    let skipped = if line.chars().count() > SHOWN { before.saturating_sub(SHOWN / 3) } else { 0 };
    let (left, right) =
        [skipped > 0, line.chars().count() > skipped + SHOWN].map(|cut| if cut { "..." } else { "" }).into();
    let part: String = line.chars().skip(skipped).take(SHOWN).collect();
    let before = before - skipped + left.len();
    let marked = marked.min((left.len() + SHOWN).saturating_sub(before).max(1));
    format!("    {left}{part}{right}\n    {}^{}", " ".repeat(before), "~".repeat(marked - 1))
}
