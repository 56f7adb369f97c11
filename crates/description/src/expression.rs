//! A smooth expression in named variables, evaluated over any kind of number.
//!
//! # The parser
//! The text is parsed by [nanoexpr](https://docs.rs/nanoexpr), which hands every operation to a number type of the caller's
//! as it reads; ours builds a graph instead of computing. Why this one: its precedence is that of mathematics
//! (`-x^2` is −(x²), `2^-1` and `2^3^2` work, `a/b/c` is (a/b)/c); every error has its place in the text; names and functions
//! are asked of the caller, so that none is known but ours; its licence is MIT; without its arithmetic, which is not used,
//! it brings along no other crate and compiles in about a second. It is young (October 2026), but tested with random input,
//! and small enough to be kept by whoever keeps this. Of the others, exmex reads `-x^2` as (−x)² and tells no places; the
//! trees of mathlex and mathexpr have no places either, and the former, made for LaTeX and tensors, is six times as
//! large; fasteval and meval have had no release for years; evalexpr is under the AGPL.
//!
//! # The tape
//! Constants are folded while the text is read, equal parts become one node, whole powers are products, and a sum with all
//! its constant factors is one instruction, for choosing the next instruction takes longer than arithmetic. What is left is
//! a short list of instructions on a few values, which [`Expression::evaluate`] runs over plain numbers,
//! jets or intervals alike; with up to [`MOST_VALUES_ON_STACK`] values at a time it allocates nothing.

mod assemble;
mod function;
mod graph;
mod parse;
mod print;
mod problem;

use std::sync::Arc;

use grazing_model::smooth::{Function, Scalar};

pub(crate) use function::is_function;
use graph::Node;
pub use problem::{ExpressionError, Problem};

/// The most values, those of the variables and those that wait for their use, that an evaluation keeps on the stack; an
/// expression that needs more of them allocates.
///
/// Few values wait at a time: in (1 + x)(2 + x)(3 + x)…, written out, never more than two.
pub const MOST_VALUES_ON_STACK: usize = 32;

/// An expression in variables that are known by name and number.
///
/// A clone shares everything with the original.
#[derive(Debug, Clone, PartialEq)]
pub struct Expression(Arc<Tape>);

#[derive(Debug, PartialEq)]
struct Tape {
    variables: Vec<String>,
    /// All parts of the expression, each after those it is made of; the last one is the whole.
    nodes: Vec<Node>,
    instructions: Vec<Instruction>,
    /// The terms of all sums.
    terms: Vec<(f64, Slot)>,
    /// The number of slots: the variables come first.
    slots: usize,
    /// The slot of the result.
    result: Slot,
}

/// The number of a value while an expression is evaluated.
type Slot = u32;

#[derive(Debug, Clone, Copy, PartialEq)]
struct Instruction {
    step: Step,
    target: Slot,
}

/// What one instruction computes.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Step {
    Plain(Operation<Slot>),
    /// A constant and slots times numbers, which stand in the list of terms from `start` to before `end`.
    Sum {
        start: u32,
        end: u32,
        constant: f64,
    },
}

/// An operation on operands that are given by number: of a node in the graph, of a slot on the tape.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Operation<P> {
    Constant(f64),
    Add(P, P),
    /// A number added to the operand.
    Shift(P, f64),
    Subtract(P, P),
    Negate(P),
    Multiply(P, P),
    /// The operand times a number.
    Scale(P, f64),
    Divide(P, P),
    Square(P),
    Power(P, i32),
    Apply(Function, P),
}

impl<P: Copy> Operation<P> {
    /// The operands from left to right; both places hold the same one where there is only one.
    fn operands(&self) -> Option<(P, P)> {
        match *self {
            Operation::Constant(_) => None,
            Operation::Add(a, b)
            | Operation::Subtract(a, b)
            | Operation::Multiply(a, b)
            | Operation::Divide(a, b) => Some((a, b)),
            Operation::Shift(a, _)
            | Operation::Negate(a)
            | Operation::Scale(a, _)
            | Operation::Square(a)
            | Operation::Power(a, _)
            | Operation::Apply(_, a) => Some((a, a)),
        }
    }

    /// The same operation on other operands.
    fn on<Q>(&self, mut place: impl FnMut(P) -> Q) -> Operation<Q> {
        match *self {
            Operation::Constant(value) => Operation::Constant(value),
            Operation::Add(a, b) => Operation::Add(place(a), place(b)),
            Operation::Shift(a, value) => Operation::Shift(place(a), value),
            Operation::Subtract(a, b) => Operation::Subtract(place(a), place(b)),
            Operation::Negate(a) => Operation::Negate(place(a)),
            Operation::Multiply(a, b) => Operation::Multiply(place(a), place(b)),
            Operation::Scale(a, value) => Operation::Scale(place(a), value),
            Operation::Divide(a, b) => Operation::Divide(place(a), place(b)),
            Operation::Square(a) => Operation::Square(place(a)),
            Operation::Power(a, exponent) => Operation::Power(place(a), exponent),
            Operation::Apply(function, a) => Operation::Apply(function, place(a)),
        }
    }
}

impl Operation<Slot> {
    #[inline]
    fn compute<S: Scalar>(&self, slots: &[S]) -> S {
        let get = |slot: Slot| slots[slot as usize];
        match *self {
            Operation::Constant(value) => S::constant(value),
            Operation::Add(a, b) => get(a) + get(b),
            Operation::Shift(a, value) => get(a) + S::constant(value),
            Operation::Subtract(a, b) => get(a) - get(b),
            Operation::Negate(a) => -get(a),
            Operation::Multiply(a, b) => get(a) * get(b),
            Operation::Scale(a, value) => get(a).scale(value),
            Operation::Divide(a, b) => get(a) / get(b),
            Operation::Square(a) => get(a).square(),
            Operation::Power(a, 3) => get(a).square() * get(a),
            Operation::Power(a, exponent) => get(a).power(exponent),
            Operation::Apply(function, a) => get(a).apply(function),
        }
    }
}

impl Expression {
    /// The expression that a text gives, in these variables and constants.
    ///
    /// `variables` are the names whose values [`Expression::evaluate`] takes, in this order; `constants` are names with their
    /// values; `pi` and `e` are known besides. Operators are `+ - * / ^`; every function takes one argument.
    ///
    /// # Errors
    /// [`ExpressionError`], the first thing in the text that is not right, with its place.
    pub fn parse(
        text: &str,
        variables: &[&str],
        constants: &[(&str, f64)],
    ) -> Result<Expression, ExpressionError> {
        parse::expression(text, variables, constants).map(|(expression, _)| expression)
    }

    /// As [`Expression::parse`], with the numbers of the variables that the text names.
    pub(crate) fn parse_with_uses(
        text: &str,
        variables: &[&str],
        constants: &[(&str, f64)],
    ) -> Result<(Expression, Vec<usize>), ExpressionError> {
        parse::expression(text, variables, constants)
    }

    /// The names of the variables, in the order of their values.
    pub fn variables(&self) -> &[String] {
        &self.0.variables
    }

    /// The number of instructions on the tape.
    pub fn instructions(&self) -> usize {
        self.0.instructions.len()
    }

    /// The most values that there are at one time: those of the variables and those that wait for their use.
    pub fn values(&self) -> usize {
        self.0.slots
    }

    /// The value at these values of the variables, in the order of [`Expression::variables`].
    ///
    /// # Panics
    /// With fewer values than variables.
    #[inline]
    pub fn evaluate<S: Scalar>(&self, variables: &[S]) -> S {
        let tape = &*self.0;
        let variables = &variables[..tape.variables.len()];
        match tape.slots {
            0..=8 => tape.run(&mut on_stack::<S, 8>(variables)),
            9..=16 => tape.run(&mut on_stack::<S, 16>(variables)),
            17..=MOST_VALUES_ON_STACK => tape.run(&mut on_stack::<S, MOST_VALUES_ON_STACK>(variables)),
            more => {
                let mut slots = vec![S::constant(0.0); more];
                slots[..variables.len()].copy_from_slice(variables);
                tape.run(&mut slots)
            }
        }
    }
}

impl Tape {
    #[inline]
    fn run<S: Scalar>(&self, slots: &mut [S]) -> S {
        for instruction in &self.instructions {
            slots[instruction.target as usize] = match instruction.step {
                Step::Plain(operation) => operation.compute(slots),
                Step::Sum { start, end, constant } => {
                    let terms = &self.terms[start as usize..end as usize];
                    sum(terms, slots) + S::constant(constant)
                }
            };
        }
        slots[self.result as usize]
    }
}

/// The sum of slots times numbers; there is at least one.
#[inline]
fn sum<S: Scalar>(terms: &[(f64, Slot)], slots: &[S]) -> S {
    // Factors of one and minus one change no bit, and no branch is faster than one that is guessed wrong.
    let product = |(factor, slot): (f64, Slot)| slots[slot as usize].scale(factor);
    terms[1..].iter().fold(product(terms[0]), |sum, &term| sum + product(term))
}

/// As many slots, with the variables in the first ones.
#[inline]
fn on_stack<S: Scalar, const SLOTS: usize>(variables: &[S]) -> [S; SLOTS] {
    let mut slots = [S::constant(0.0); SLOTS];
    slots[..variables.len()].copy_from_slice(variables);
    slots
}
