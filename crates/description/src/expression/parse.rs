//! From text to expression, and from the parser's errors to ours.

use std::cell::RefCell;
use std::f64::consts;
use std::ops::Range;

use grazing_source::{nearest, shortened};
use nanoexpr::{Context, ErrorKind, Evaluator};

use super::graph::{Graph, Term, parts};
use super::{Expression, ExpressionError, Problem};
use super::{assemble, function};

/// Parentheses in parentheses beyond which nobody can read an expression.
const MOST_DEPTH: usize = 100;

/// An expression of more bytes than this comes from no person: some ten thousand terms.
const MOST_BYTES: usize = 100_000;

/// The most characters of a part of an expression that a message repeats.
const SHOWN: usize = 60;

/// The numbers that are known by name everywhere.
const NUMBERS: [(&str, f64); 2] = [("pi", consts::PI), ("e", consts::E)];

/// What the names in a text mean.
struct Names<'g, 'n> {
    graph: &'g Graph,
    variables: &'n [&'n str],
    constants: &'n [(&'n str, f64)],
    uses: RefCell<Vec<usize>>,
}

impl<'g> Context<Term<'g>> for Names<'g, '_> {
    fn variable(&self, name: &str) -> Option<Term<'g>> {
        if let Some(number) = self.variables.iter().position(|known| *known == name) {
            let mut uses = self.uses.borrow_mut();
            if !uses.contains(&number) {
                uses.push(number);
            }
            return Some(self.graph.variable(number));
        }
        let mut numbers = self.constants.iter().chain(&NUMBERS);
        numbers.find(|(known, _)| *known == name).map(|(_, value)| Term::Number(*value))
    }

    fn call(&self, name: &str, arguments: &[Term<'g>]) -> Option<Result<Term<'g>, ErrorKind>> {
        function::call(name, arguments)
    }
}

impl Names<'_, '_> {
    fn known(&self) -> Vec<&str> {
        let numbers = self.constants.iter().chain(&NUMBERS).map(|(name, _)| *name);
        self.variables.iter().copied().chain(numbers).collect()
    }

    fn problem(&self, text: &str, kind: ErrorKind, span: Range<usize>) -> Problem {
        let written = text[span.clone()].to_owned();
        let shown = shortened(&written, SHOWN);
        match kind {
            ErrorKind::UnknownVariable if function::is_function(&written) => {
                Problem::FunctionWithoutArgument { name: written }
            }
            ErrorKind::UnknownVariable => {
                let known = self.known();
                Problem::UnknownName {
                    nearest: nearest(&written, &known).map(str::to_owned),
                    name: written,
                    known: known.into_iter().map(str::to_owned).collect(),
                }
            }
            ErrorKind::UnknownFunction if function::is_not_smooth(&written) => {
                Problem::NotSmooth { what: format!("the function {written}") }
            }
            ErrorKind::UnknownFunction if self.known().contains(&written.as_str()) => {
                Problem::NumberWithArgument { name: written }
            }
            ErrorKind::UnknownFunction => {
                let known: Vec<&str> = function::functions().collect();
                let nearest = if written.starts_with("log") { Some("ln") } else { nearest(&written, &known) };
                Problem::UnknownFunction { nearest: nearest.map(str::to_owned), name: written }
            }
            ErrorKind::ArgumentCount | ErrorKind::TooManyArguments => {
                Problem::Arguments { name: written.split('(').next().unwrap_or_default().trim().to_owned() }
            }
            ErrorKind::Unsupported => Problem::NotSmooth {
                what: format!("{shown} (a remainder, a factorial, a comparison or a choice)"),
            },
            ErrorKind::InvalidNumber => Problem::Number { written: shown },
            ErrorKind::UnclosedParenthesis => Problem::Unclosed,
            ErrorKind::UnexpectedEnd => Problem::End,
            ErrorKind::UnexpectedCharacter => Problem::Character { written },
            ErrorKind::DivisionByZero => Problem::DivisionByZero,
            ErrorKind::Domain => Problem::Domain { written: shown },
            ErrorKind::Overflow | ErrorKind::Inexact => Problem::TooLarge { written: shown },
            ErrorKind::TooDeep | ErrorKind::TooLong => Problem::TooDeep { most: MOST_DEPTH },
            _ if !value_ends_before(text, span.start) => {
                Problem::Unexpected { written, expected: "a number, a name, a function or (" }
            }
            _ if written == ")" => Problem::Unopened,
            _ if value_begins(&written) => Problem::OperatorMissing,
            _ => Problem::Unexpected { written, expected: "an operator or the end" },
        }
    }
}

/// Whether a number, a name or a parenthesis ends right before this place.
fn value_ends_before(text: &str, position: usize) -> bool {
    text[..position].trim_end().ends_with(|character| is_value(character) || character == ')')
}

/// Whether a number, a name or a parenthesis begins with this.
fn value_begins(text: &str) -> bool {
    text.starts_with(|character| is_value(character) || character == '(')
}

fn is_value(character: char) -> bool {
    character.is_alphanumeric() || character == '_' || character == '.'
}

/// The expression with the numbers of the variables that its text names.
pub(super) fn expression(
    text: &str,
    variables: &[&str],
    moving: usize,
    constants: &[(&str, f64)],
) -> Result<(Expression, Vec<usize>), ExpressionError> {
    if text.len() > MOST_BYTES {
        let problem = Problem::TooLong { most: MOST_BYTES };
        return Err(ExpressionError { problem, span: 0..0 });
    }
    let graph = Graph::default();
    let names = Names { graph: &graph, variables, constants, uses: RefCell::default() };
    let term: Term<'_> =
        Evaluator::<_, 4>::new(&names).max_depth(MOST_DEPTH).evaluate(text).map_err(|error| {
            let span = error.span.start..error.span.end;
            ExpressionError { problem: names.problem(text, error.kind, span.clone()), span }
        })?;
    let variables = variables.iter().map(|&name| name.to_owned()).collect();
    let expression = assemble::expression(variables, moving, parts(term));
    Ok((expression, names.uses.into_inner()))
}
