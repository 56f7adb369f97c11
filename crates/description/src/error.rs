//! What can be wrong with a description.

use std::ops::Range;

use grazing_source::{Section, SourceError};
use thiserror::Error;

use crate::expression::{ExpressionError, Problem};
use crate::file::REQUIREMENTS;
use crate::names::variable;

/// The first thing in a description that is not right, and what would be.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum DescriptionError {
    /// The file cannot be read, is no TOML, or has a key or value that is not right.
    #[error(transparent)]
    Source(#[from] SourceError),
    /// An expression is not right.
    #[error("{place}: {problem}\n{excerpt}")]
    Expression {
        /// Where it stands.
        place: Place,
        /// What is wrong, and what would be right.
        problem: Box<Problem>,
        /// The line of the expression with a mark under what is wrong.
        excerpt: String,
    },
    /// An expression has no finite value at a point of the ranges.
    #[error(
        "{place}: the value is {value} at {at}: it must be a finite number {}",
        where_finite(&place.key)
    )]
    NotFinite {
        /// Where the expression stands.
        place: Place,
        /// Its value.
        value: f64,
        /// The values of the variables.
        at: Values,
    },
    /// The frequency is not positive over the ranges.
    #[error(
        "{place}: the frequency is {} at {at}: it must be positive over the ranges of both parameters",
        rounded(*.value)
    )]
    Frequency {
        /// Where the expression stands.
        place: Place,
        /// The frequency.
        value: f64,
        /// The values of the parameters.
        at: Values,
    },
    /// The restitution is not positive over the ranges.
    #[error(
        "{place}: the restitution is {} at {at}: it must be positive, for the rebound to leave the wall",
        rounded(*.value)
    )]
    Restitution {
        /// Where the expression stands.
        place: Place,
        /// The restitution.
        value: f64,
        /// The values of the variables.
        at: Values,
    },
    /// Numbers of loops that were asked for instead of the file's are not right.
    #[error("{}: {}", loops.iter().map(u32::to_string).collect::<Vec<_>>().join(","), REQUIREMENTS.of("analysis.loops"))]
    Loops {
        /// The numbers.
        loops: Vec<u32>,
    },
    /// An expression has not the period of the forcing.
    #[error(
        "{place}: not periodic with the forcing: the value changes by {} from {at} over one period, to \
         {variable} + {}; {variable} must enter as {}",
        rounded(*.change),
        rounded(*.period),
        entry(.variable)
    )]
    Period {
        /// Where the expression stands.
        place: Place,
        /// The change over one period.
        change: f64,
        /// The values of the variables before it.
        at: Values,
        /// The variable that grows by the period, t or z.
        variable: &'static str,
        /// The period: 2π/ω in t, 2π in z.
        period: f64,
    },
}

/// A key with its line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// File and line.
    at: String,
    key: String,
}

impl std::fmt::Display for Place {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{}: {}", self.at, self.key)
    }
}

impl Place {
    pub(crate) fn new(section: &Section<'_>, name: &str) -> Place {
        Place { at: section.place(name), key: section.key(name) }
    }
}

/// Where an expression must have a finite value.
fn where_finite(key: &str) -> &'static str {
    match key {
        "motion.force" => {
            "at the wall and close to it in x < 0, where motion takes place, over the ranges of both parameters"
        }
        _ => "over the ranges of both parameters",
    }
}

/// Names with their values.
#[derive(Debug, Clone, PartialEq)]
pub struct Values(pub Vec<(String, f64)>);

impl std::fmt::Display for Values {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (index, (name, value)) in self.0.iter().enumerate() {
            let comma = if index == 0 { "" } else { ", " };
            write!(formatter, "{comma}{name} = {}", rounded(*value))?;
        }
        Ok(())
    }
}

/// How t or z must enter an expression that has the period of the forcing.
fn entry(variable: &str) -> &'static str {
    match variable {
        "t" => {
            "cos(omega*t) or sin(omega*t), where omega is the frequency of motion.frequency, or with multiples of omega"
        }
        _ => "cos(z) or sin(z), or with multiples of z",
    }
}

/// The value to six digits, without zeros at the end, and with an exponent where there were many in it.
pub(crate) fn rounded(value: f64) -> String {
    let value: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    let plain = value == 0.0 || (1e-5..1e9).contains(&value.abs()) || !value.is_finite();
    if plain { value.to_string() } else { format!("{value:e}") }
}

impl DescriptionError {
    /// The error of an expression that stands in a file.
    pub(crate) fn in_expression(
        section: &Section<'_>,
        name: &str,
        text: &str,
        error: &ExpressionError,
    ) -> DescriptionError {
        let mut place = Place::new(section, name);
        // With escapes in it, the text's lines are not those of the file.
        if let Some(start) = section.raw(name).find(text) {
            place.at = section.place_within(name, start + error.span.start);
        }
        let excerpt = excerpt(text, &error.span);
        let problem = match error.problem.clone() {
            Problem::UnknownName { name, nearest, known } => match variable(&name) {
                Some(meaning) => Problem::NotHere { name, meaning, known },
                None => Problem::UnknownName { name, nearest, known },
            },
            problem => problem,
        };
        DescriptionError::Expression { place, problem: Box::new(problem), excerpt }
    }
}

/// The most characters of a line that are shown.
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
    // Of a long line the part about the mark.
    let skipped = if line.chars().count() > SHOWN { before.saturating_sub(SHOWN / 3) } else { 0 };
    let (left, right) =
        [skipped > 0, line.chars().count() > skipped + SHOWN].map(|cut| if cut { "..." } else { "" }).into();
    let part: String = line.chars().skip(skipped).take(SHOWN).collect();
    let before = before - skipped + left.len();
    let marked = marked.min((left.len() + SHOWN).saturating_sub(before).max(1));
    format!("    {left}{part}{right}\n    {}^{}", " ".repeat(before), "~".repeat(marked - 1))
}
