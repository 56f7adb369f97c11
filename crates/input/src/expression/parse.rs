//! From text to expression, and from the parser's errors to ours.

use std::cell::RefCell;
use std::f64::consts;
use std::ops::Range;
use std::sync::Arc;

use grazing_model::smooth::Stop;
use nanoexpr::{Context, ErrorKind, Evaluator, Number};

use super::graph::{Graph, Term};
use super::partials::ForceDerivatives;
use super::{Expression, ExpressionError, assemble, function};
use crate::document::{nearest, shortened, suggestion};

/// The largest depth of nested parentheses: deeper expressions are unreadable.
const MOST_DEPTH: usize = 100;

/// The largest number of bytes of an expression, some ten thousand terms: no person writes a longer
/// one.
const MOST_BYTES: usize = 100_000;

/// The largest number of characters of a part of an expression that a message repeats.
const SHOWN: usize = 60;

/// The numbers that are known by name everywhere.
const NUMBERS: [(&str, f64); 2] = [("pi", consts::PI), ("e", consts::E)];

/// The meanings of the names in a text.
struct Names<'g, 'n> {
    variables: &'n [(&'n str, Term<'g>)],
    constants: &'n [(&'n str, f64)],
    uses: RefCell<Vec<usize>>,
    stop: &'n Stop,
}

impl<'g> Context<Term<'g>> for Names<'g, '_> {
    /// No name is known once the computation is cancelled, so that the text is read no further.
    fn variable(&self, name: &str) -> Option<Term<'g>> {
        if self.stop.is_asked() {
            return None;
        }
        if let Some(number) = self.variables.iter().position(|(known, _)| *known == name) {
            let mut uses = self.uses.borrow_mut();
            if !uses.contains(&number) {
                uses.push(number);
            }
            return Some(self.variables[number].1);
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
        self.variables.iter().map(|(name, _)| *name).chain(numbers).collect()
    }

    /// The error at a place of the text, with its remedy.
    fn problem(&self, text: &str, kind: ErrorKind, span: Range<usize>) -> String {
        let written = &text[span.clone()];
        let shown = shortened(written, SHOWN);
        let unexpected = |expected: &str| format!("{written} is not allowed here: {expected} is expected");
        let not_smooth = |what: &str, remedy: &str| {
            format!("{what} is not smooth: the theorems need functions with continuous derivatives; {remedy}")
        };
        if let Some(known) =
            [".^", ".*", "./"].into_iter().find(|known| text[span.start..].starts_with(known))
        {
            return format!("operators have no point in front of them: {} in place of {known}", &known[1..]);
        }
        match kind {
            ErrorKind::UnknownVariable if function::is_function(written) => {
                format!("{written} is a function: write its argument after it, as in {written}(x)")
            }
            ErrorKind::UnknownVariable => {
                let known = self.known();
                match function::variable(written) {
                    Some(meaning) => {
                        format!("{written}, {meaning}, cannot be used here. Known here: {}", listed(&known))
                    }
                    None => {
                        let nearest = suggestion(nearest(written, &known));
                        format!("unknown name {shown}{nearest} Known here: {}", listed(&known))
                    }
                }
            }
            ErrorKind::UnknownFunction if function::in_place_of(written).is_some() => {
                let remedy = function::in_place_of(written).unwrap_or_default();
                not_smooth(&format!("the function {written}"), remedy)
            }
            ErrorKind::UnknownFunction if ["pow", "power"].contains(&written) => {
                format!("powers are written with ^: {}", power(&text[span.end..]))
            }
            ErrorKind::UnknownFunction if self.known().contains(&written) => {
                format!("{written} is a number, not a function: for a product write {written}*(...)")
            }
            ErrorKind::UnknownFunction => {
                let known: Vec<&str> = function::functions().collect();
                let nearest = if written.starts_with("log") { Some("ln") } else { nearest(written, &known) };
                format!("unknown function {shown}{} Known: {}", suggestion(nearest), known.join(", "))
            }
            ErrorKind::ArgumentCount | ErrorKind::TooManyArguments => {
                let name = written.split('(').next().unwrap_or_default().trim();
                format!("wrong number of arguments: {name} takes one, as in {name}(x)")
            }
            ErrorKind::Unsupported => {
                let remedy = format!("for a choice or a comparison, {}", function::STEP);
                not_smooth(&format!("{shown} (a remainder, a factorial, a comparison or a choice)"), &remedy)
            }
            ErrorKind::InvalidNumber => format!("{shown} is too large a number to compute with"),
            ErrorKind::UnclosedParenthesis => "this parenthesis is not closed: a ) is missing".to_owned(),
            ErrorKind::UnexpectedEnd => {
                "the expression ends too early: a number, a name, a function or ( is expected".to_owned()
            }
            ErrorKind::UnexpectedCharacter if written == "'" => {
                "derivatives have names: v is the velocity x'".to_owned()
            }
            ErrorKind::UnexpectedCharacter => format!(
                "the character {written} means nothing here: names are of the letters a to z and A to Z, digits and _, operators are \
                 + - * / ^"
            ),
            ErrorKind::DivisionByZero => "division by zero".to_owned(),
            ErrorKind::Domain => format!(
                "{shown} has no real value: the logarithm and real powers need a positive number, roots one that is not negative"
            ),
            ErrorKind::Overflow | ErrorKind::Inexact => format!("{shown} is too large to compute with"),
            ErrorKind::TooDeep | ErrorKind::TooLong => format!(
                "more than {MOST_DEPTH} parentheses, functions and operators are nested here: shorten it"
            ),
            _ if written == "," && text[..span.start].ends_with(|c: char| c.is_ascii_digit()) => {
                "decimals are written with a point, as in 0.02".to_owned()
            }
            _ if !value_ends_before(text, span.start) => unexpected("a number, a name, a function or ("),
            _ if written == ")" => "this ) has no matching (: add a ( before it or remove it".to_owned(),
            _ if value_begins(written) => {
                "an operator is missing here: products are written with *, as in 2*x".to_owned()
            }
            _ => unexpected("an operator or the end"),
        }
    }
}

/// The largest number of names that a message lists.
const LISTED: usize = 30;

/// Names, separated by commas; only the first ones if there are many.
fn listed(names: &[&str]) -> String {
    let rest = if names.len() > LISTED { ", ..." } else { "" };
    format!("{}{rest}", names[..names.len().min(LISTED)].join(", "))
}

/// The power that is meant by the arguments of a call, such as `(x, 3)`: x^3.
fn power(call: &str) -> String {
    let inside = call.trim_start().strip_prefix('(').and_then(|rest| rest.split_once(')'));
    let arguments = inside.and_then(|(inside, _)| inside.split_once(','));
    let [base, exponent] = arguments.map_or(["x", "3"], |(base, exponent)| [base.trim(), exponent.trim()]);
    let bracketed =
        |part: &str| if part.chars().all(is_value) { part.to_owned() } else { format!("({part})") };
    // Further brackets inside are not paired here.
    if base.contains('(') {
        "x^3 for pow(x, 3)".to_owned()
    } else {
        format!("{}^{}", bracketed(base), bracketed(exponent))
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

/// The expression, with the numbers of the variables that its text names; the first `moving`
/// variables are those that [`Expression::hold`] leaves free. An error once the computation is
/// cancelled.
pub(crate) fn expression(
    text: &str,
    variables: &[&str],
    moving: usize,
    constants: &[(&str, f64)],
    stop: &Stop,
) -> Result<(Expression, Vec<usize>), ExpressionError> {
    let graph = Graph::default();
    let (term, uses) = term(text, &numbered(&graph, variables), constants, stop)?;
    Ok((assembled(&graph, term, variables, moving), uses))
}

/// The variables as terms of the graph, each with its own number.
pub(super) fn numbered<'g, 'n>(graph: &'g Graph, variables: &[&'n str]) -> Vec<(&'n str, Term<'g>)> {
    variables.iter().enumerate().map(|(number, name)| (*name, graph.variable(number))).collect()
}

pub(super) fn assembled(graph: &Graph, term: Term<'_>, variables: &[&str], moving: usize) -> Expression {
    let (nodes, results) = graph.parts(&[term]);
    Expression(Arc::new(assemble::tape(variables, moving, &nodes, &results)), None)
}

/// The term of a text in which variables stand for these terms, and the numbers of the variables
/// that it names.
pub(super) fn term<'g>(
    text: &str,
    variables: &[(&str, Term<'g>)],
    constants: &[(&str, f64)],
    stop: &Stop,
) -> Result<(Term<'g>, Vec<usize>), ExpressionError> {
    if text.len() > MOST_BYTES {
        let problem = format!(
            "the expression has more than {MOST_BYTES} bytes: shorten it, for instance by constants in [parameters] for parts that do not vary"
        );
        return Err(ExpressionError { problem, span: 0..0 });
    }
    let names = Names { variables, constants, uses: RefCell::default(), stop };
    let term: Term<'_> =
        Evaluator::<_, 4>::new(&names).max_depth(MOST_DEPTH).evaluate(text).map_err(|error| {
            let span = error.span.start..error.span.end;
            ExpressionError { problem: names.problem(text, error.kind, span.clone()), span }
        })?;
    Ok((term, names.uses.into_inner()))
}

/// A force seen from the wall: the acceleration of u = s(x − W(t)) as an expression in u, u̇, t, μ,
/// η, and x and v as others.
///
/// W is the position of the wall, s = 1 for motion below it and −1 for motion above it: ü = s(F(W +
/// su, Ẇ + su̇, t) − Ẅ).
///
/// # Errors
/// The first error in one of the texts; if each is correct by itself, the two together have numbers
/// that are too large. Any error, once the computation is cancelled.
pub(crate) fn from_the_wall(
    force: &str,
    wall: &str,
    sign: f64,
    variables: &[&str; 5],
    constants: &[(&str, f64)],
    stop: &Stop,
) -> Result<[Expression; 3], ExpressionError> {
    let too_large = |_| {
        ExpressionError {
        problem:
            "together with the motion of the wall in wall.position the expression has a number that is too large to compute with"
                .to_owned(),
        span: 0..0,
    }
    };
    let graph = Graph::default();
    let own = numbered(&graph, variables);
    let [gap, speed] = [own[0].1, own[1].1];
    let (position, _) = term(wall, &own[2..], constants, stop)?;
    let velocity = graph.derivative(position, TIME, stop).map_err(too_large)?;
    let acceleration = graph.derivative(velocity, TIME, stop).map_err(too_large)?;
    let x = gap.multiply(Term::Number(sign)).and_then(|gap| gap.add(position)).map_err(too_large)?;
    let v = speed.multiply(Term::Number(sign)).and_then(|speed| speed.add(velocity)).map_err(too_large)?;
    let outside = [&[(variables[0], x), (variables[1], v)], &own[2..]].concat();
    let (force, _) = term(force, &outside, constants, stop)?;
    let seen = force
        .subtract(acceleration)
        .and_then(|force| force.multiply(Term::Number(sign)))
        .map_err(too_large)?;
    let [mut force, x, v] = [seen, x, v].map(|term| assembled(&graph, term, variables, 2));
    force.1 = ForceDerivatives::of(&graph, seen, &force, variables, stop).map(Arc::new);
    Ok([force, x, v])
}

/// The number of the time among the variables of a force.
const TIME: usize = 2;
