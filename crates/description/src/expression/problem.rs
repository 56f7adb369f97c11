//! What can be wrong with an expression.

use std::ops::Range;

use thiserror::Error;

use grazing_source::{shortened, suggestion};

use super::function::functions;

/// The first thing in an expression that is not right.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{problem}")]
pub struct ExpressionError {
    /// The bytes of the text that are not right; empty at the text's end.
    pub span: Range<usize>,
    /// What is wrong with them, and what would be right.
    pub problem: Problem,
}

/// What is wrong at one place of an expression, and what would be right.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Problem {
    /// A name that is not known.
    #[error("unknown name {}{} Known here: {}", shortened(name, SHOWN), suggestion(nearest.as_deref()), listed(known))]
    UnknownName {
        /// The name.
        name: String,
        /// The known name that is spelt like it, if there is one.
        nearest: Option<String>,
        /// All names that are known in this place.
        known: Vec<String>,
    },
    /// The name of a variable that this expression cannot depend on.
    #[error("{name}, {meaning}, cannot be used here. Known here: {}", listed(known))]
    NotHere {
        /// The name.
        name: String,
        /// What it means where it can be used.
        meaning: &'static str,
        /// All names that are known in this place.
        known: Vec<String>,
    },
    /// A function that is not known.
    #[error("unknown function {}{} Known: {}", shortened(name, SHOWN), suggestion(nearest.as_deref()), list())]
    UnknownFunction {
        /// The name.
        name: String,
        /// The known function that is spelt like it, if there is one.
        nearest: Option<String>,
    },
    /// A function or operator that is not smooth.
    #[error(
        "{what} is not smooth: the theorems need functions with continuous derivatives; \
         a smooth one that is close may do, as sqrt(x^2 + s^2) with a small s for the modulus of x"
    )]
    NotSmooth {
        /// The function or operator.
        what: String,
    },
    /// A function with too few or too many arguments.
    #[error("wrong number of arguments: {name} takes one, as in {name}(x)")]
    Arguments {
        /// The function.
        name: String,
    },
    /// A function that stands as a number would.
    #[error("{name} is a function: write its argument after it, as in {name}(x)")]
    FunctionWithoutArgument {
        /// The function.
        name: String,
    },
    /// A number that stands as a function would.
    #[error("{name} is a number, no function: for a product write {name}*(...)")]
    NumberWithArgument {
        /// The number's name.
        name: String,
    },
    /// Two values side by side.
    #[error("an operator is missing here: products are written with *, as in 2*x")]
    OperatorMissing,
    /// Something that cannot stand there.
    #[error("{written} cannot stand here: {expected} is expected")]
    Unexpected {
        /// What stands there.
        written: String,
        /// What could.
        expected: &'static str,
    },
    /// A character that means nothing.
    #[error(
        "the character {written} means nothing here: names are of the letters a to z and A to Z, digits and _, \
         operators are + - * / ^"
    )]
    Character {
        /// The character.
        written: String,
    },
    /// A number that is none, or too large for one.
    #[error("{written} is too large a number to be computed with")]
    Number {
        /// The number.
        written: String,
    },
    /// A parenthesis that is not closed.
    #[error("this parenthesis is not closed: a ) is missing")]
    Unclosed,
    /// A parenthesis that closes nothing.
    #[error("this parenthesis closes nothing: a ( is missing before it, or the ) is one too many")]
    Unopened,
    /// The text ends too early.
    #[error("the expression ends too early: a number, a name, a function or ( is expected")]
    End,
    /// Division by a constant that is zero.
    #[error("division by zero")]
    DivisionByZero,
    /// A constant outside the domain of a function.
    #[error(
        "{written} has no real value: the logarithm and real powers need a positive number, roots one that is not negative"
    )]
    Domain {
        /// The part of the expression.
        written: String,
    },
    /// A constant that is not finite.
    #[error("{written} is too large to be computed with")]
    TooLarge {
        /// The part of the expression.
        written: String,
    },
    /// More characters than anybody writes.
    #[error(
        "the expression has more than {most} bytes: shorten it, as by constants in [parameters] for parts that do not vary"
    )]
    TooLong {
        /// The most that are allowed.
        most: usize,
    },
    /// More parentheses in parentheses than are allowed.
    #[error(
        "more than {most} parentheses, functions and operators stand inside one another here: shorten it"
    )]
    TooDeep {
        /// The most that are allowed.
        most: usize,
    },
}

/// The most characters of a name that a message repeats, and the most names that it lists.
const SHOWN: usize = 60;
const LISTED: usize = 30;

/// Names, the first ones if they are many.
fn listed(names: &[String]) -> String {
    let rest = if names.len() > LISTED { ", ..." } else { "" };
    format!("{}{rest}", names[..names.len().min(LISTED)].join(", "))
}

fn list() -> String {
    functions().collect::<Vec<_>>().join(", ")
}
