//! A smooth expression in named variables, evaluated over any kind of number.
//!
//! # The parser
//! The text is parsed by [nanoexpr](https://docs.rs/nanoexpr), which passes every operation to a
//! number type of the caller's as it reads; ours builds a graph instead of computing. Reasons for
//! this choice: its precedence is that of mathematics (`-x^2` is −(x²), `2^-1` and `2^3^2` work,
//! `a/b/c` is (a/b)/c); every error has its place in the text; names and functions are supplied by
//! the caller, so that only ours are known; its licence is MIT; without its arithmetic, which is
//! not used, it has no dependencies and compiles in about a second. It is young (October 2026), but
//! tested with random input, and small enough to be maintained here. Of the others, exmex reads
//! `-x^2` as (−x)² and reports no places; the trees of mathlex and mathexpr have no places either,
//! and the former, made for LaTeX and tensors, is six times as large; fasteval and meval have had
//! no release for years; evalexpr is under the AGPL.
//!
//! # The tape
//! Constants are folded while the text is read, equal parts become one node, whole powers are
//! products, and a sum with all its constant factors is one instruction, because choosing the next
//! instruction takes longer than arithmetic. The result is a short list of instructions, each of
//! which appends one value to a list that begins with those of the variables.
//! [`Expression::evaluate`] runs it over plain numbers, jets or intervals alike. Instructions that
//! do not depend on the moving variables come first, so that [`Expression::hold`] can run them once
//! for many values of those variables.

mod assemble;
mod derivative;
mod fortran;
mod function;
mod graph;
mod linearity;
mod parse;
mod partials;
#[cfg(test)]
mod tests;

use std::borrow::Borrow;
use std::iter;
use std::ops::Range;
use std::sync::Arc;

use grazing_model::smooth::{Function, Scalar, Stop};
use thiserror::Error;

pub(crate) use function::{is_function, variable};
pub(crate) use parse::{expression as parse_with_uses, from_the_wall};

/// The largest number of instruction results that an evaluation keeps on the stack; an expression
/// with more of them allocates.
pub const MOST_VALUES_ON_STACK: usize = 24;

/// The first error in an expression.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{problem}")]
pub struct ExpressionError {
    /// The byte range of the error in the text; empty at the text's end.
    pub span: Range<usize>,
    /// The error and its remedy.
    pub problem: String,
}

/// An expression in variables that are known by name and number.
///
/// A clone shares everything with the original. A force has formulas for its derivatives beside its own.
#[derive(Debug, Clone, PartialEq)]
pub struct Expression(Arc<Tape>, Option<Arc<partials::ForceDerivatives>>);

#[derive(Debug, Default, PartialEq)]
struct Tape {
    variables: Vec<String>,
    whole: Code,
    /// The number of instructions that do not depend on the moving variables; they come first.
    held: usize,
    /// The number of variables that move; they come first.
    moving: usize,
    /// The slots of the held variables and results on which the other instructions depend.
    needed: Vec<Slot>,
    /// The other instructions; on their list the values of those slots replace the values from
    /// which they were computed.
    rest: Code,
}

/// Instructions in order.
#[derive(Debug, Default, PartialEq)]
struct Code {
    instructions: Vec<Instruction>,
    /// The terms of all sums.
    terms: Vec<(f64, Slot)>,
    /// The slots of the results.
    results: Vec<Slot>,
}

/// The slot of a value in the list: those of the variables come first, then one for each
/// instruction.
type Slot = usize;

/// The computation of one instruction.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Instruction {
    Plain(Operation<Slot>),
    /// A constant plus multiples of values, which are in the list of terms from `start` to before
    /// `end`.
    Sum {
        start: usize,
        end: usize,
        constant: f64,
    },
}

/// An operation on operands that are given by number: of a node in the graph, or of a value's slot
/// on the tape.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Operation<P> {
    Constant(f64),
    Add(P, P),
    /// The operand plus a number.
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
    /// The operands from left to right.
    fn operands(&self) -> Vec<P> {
        let mut operands = Vec::new();
        self.on(|operand| operands.push(operand));
        operands
    }

    /// A key that distinguishes the operation from others of its kind on the same operands: the
    /// bits of its number, or the power or function.
    fn detail(&self) -> u64 {
        match *self {
            Operation::Constant(value) | Operation::Shift(_, value) | Operation::Scale(_, value) => {
                value.to_bits()
            }
            Operation::Power(_, exponent) => i64::from(exponent).cast_unsigned(),
            Operation::Apply(function, _) => function as u64,
            _ => 0,
        }
    }

    /// The operation on other operands.
    fn on<Q>(&self, mut slot: impl FnMut(P) -> Q) -> Operation<Q> {
        match *self {
            Operation::Constant(value) => Operation::Constant(value),
            Operation::Add(a, b) => Operation::Add(slot(a), slot(b)),
            Operation::Shift(a, value) => Operation::Shift(slot(a), value),
            Operation::Subtract(a, b) => Operation::Subtract(slot(a), slot(b)),
            Operation::Negate(a) => Operation::Negate(slot(a)),
            Operation::Multiply(a, b) => Operation::Multiply(slot(a), slot(b)),
            Operation::Scale(a, value) => Operation::Scale(slot(a), value),
            Operation::Divide(a, b) => Operation::Divide(slot(a), slot(b)),
            Operation::Square(a) => Operation::Square(slot(a)),
            Operation::Power(a, exponent) => Operation::Power(slot(a), exponent),
            Operation::Apply(function, a) => Operation::Apply(function, slot(a)),
        }
    }
}

impl Operation<Slot> {
    /// Computes the result from the operands, which are in slots.
    #[inline(always)]
    fn compute<'v, S: Scalar + 'v>(&self, result: &mut S, get: impl Fn(Slot) -> &'v S) {
        match *self {
            Operation::Constant(value) => *result = S::constant(value),
            Operation::Add(a, b) => into(result, get(a), get(b), |a, b| *a + *b),
            Operation::Shift(a, value) => into(result, get(a), &value, |a, value| *a + S::constant(*value)),
            Operation::Subtract(a, b) => into(result, get(a), get(b), |a, b| *a - *b),
            Operation::Negate(a) => into(result, get(a), &(), |a, ()| -*a),
            Operation::Multiply(a, b) => into(result, get(a), get(b), |a, b| *a * *b),
            Operation::Scale(a, value) => into(result, get(a), &value, |a, value| a.scale(*value)),
            Operation::Divide(a, b) => into(result, get(a), get(b), |a, b| *a / *b),
            Operation::Square(a) => into(result, get(a), &(), |a, ()| a.square()),
            Operation::Power(a, 3) => into(result, get(a), &(), |a, ()| a.square() * *a),
            Operation::Power(a, exponent) => {
                into(result, get(a), &exponent, |a, exponent| a.power(*exponent))
            }
            Operation::Apply(function, a) => {
                into(result, get(a), &function, |a, function| a.apply(*function))
            }
        }
    }
}

/// Writes a result to its slot. It is a separate function so that the compiler knows the slots to
/// differ, and copies nothing.
#[inline(never)]
fn into<S, T>(result: &mut S, a: &S, b: &T, compute: impl Fn(&S, &T) -> S) {
    *result = compute(a, b);
}

impl Expression {
    /// Parses an expression in these variables and constants.
    ///
    /// `variables` are the names whose values [`Expression::evaluate`] takes, in this order;
    /// `constants` are names with their values; `pi` and `e` are known as well. Operators are
    /// `+ - * / ^`; every function takes one argument.
    ///
    /// # Errors
    /// [`ExpressionError`], the first error in the text, with its place.
    pub fn parse(
        text: &str,
        variables: &[&str],
        constants: &[(&str, f64)],
    ) -> Result<Expression, ExpressionError> {
        let parsed = parse::expression(text, variables, variables.len(), constants, &Stop::default());
        parsed.map(|(expression, _)| expression)
    }

    /// The names of the variables, in the order of their values.
    pub fn variables(&self) -> &[String] {
        &self.0.variables
    }

    /// The number of instructions on the tape.
    pub fn instructions(&self) -> usize {
        self.0.whole.instructions.len()
    }

    /// The value at these values of the variables, in the order of [`Expression::variables`].
    ///
    /// # Panics
    /// With fewer values than variables.
    pub fn evaluate<S: Scalar>(&self, variables: &[S]) -> S {
        let Tape { variables: names, whole, .. } = &*self.0;
        let variables = &variables[..names.len()];
        with_space(whole.instructions.len(), |list| {
            whole.run(0..whole.instructions.len(), variables, variables.len(), (list, 0));
            *value(whole.results[0], variables, variables.len(), list)
        })
    }

    /// The expression as a function of the variables that move, for these values of the others,
    /// which may be of a simpler number type.
    ///
    /// # Panics
    /// With fewer values than there are variables that do not move.
    pub(crate) fn hold<'a, T: Scalar, S: Scalar + From<T>>(
        &'a self,
        others: &[T],
    ) -> impl FnMut(&[&S]) -> S + use<'a, T, S> {
        let tape = &*self.0;
        let mut list: Vec<S> = tape.held(others);
        move |moving| {
            tape.run_rest(1, moving, &mut list);
            *tape.rest_result(0, moving, &list)
        }
    }
}

impl Tape {
    /// One list for all values of the variables that move: what the instructions that move need, then space
    /// for their results.
    fn held<T: Scalar, S: Scalar + From<T>>(&self, others: &[T]) -> Vec<S> {
        let others = &others[..self.variables.len() - self.moving];
        with_space(others.len() + self.held, |held| {
            held[..others.len()].copy_from_slice(others);
            self.whole.run::<T, T>(0..self.held, &[], self.moving, (held, others.len()));
            let needed = self.needed.iter().map(|slot| S::from(held[slot - self.moving]));
            needed.chain(iter::repeat_n(S::constant(0.0), self.rest.instructions.len())).collect()
        })
    }

    /// Runs the instructions that move, as far as the first of the results need them.
    #[inline(always)]
    fn run_rest<S: Scalar>(&self, results: usize, moving: &[&S], list: &mut [S]) {
        let before = self.needed.len();
        let count = self.rest.needed_for(results, self.moving + before);
        self.rest.run(0..count, &moving[..self.moving], self.moving, (list, before));
    }

    /// A result of these.
    #[inline(always)]
    fn rest_result<'v, S: Scalar>(&self, index: usize, moving: &'v [&S], list: &'v [S]) -> &'v S {
        value(self.rest.results[index], moving, self.moving, list)
    }
}

/// Provides space for a list of `count` values to a computation.
#[inline(always)]
fn with_space<S: Scalar, R>(count: usize, compute: impl FnOnce(&mut [S]) -> R) -> R {
    let zero = S::constant(0.0);
    match count {
        0..=4 => compute(&mut [zero; 4]),
        5..=8 => compute(&mut [zero; 8]),
        9..=MOST_VALUES_ON_STACK => compute(&mut [zero; MOST_VALUES_ON_STACK]),
        more => compute(&mut vec![zero; more]),
    }
}

/// The value at a slot: one of the first `free` variables, or one on the list.
#[inline(always)]
fn value<'v, S, V: Borrow<S>>(slot: Slot, variables: &'v [V], free: usize, list: &'v [S]) -> &'v S {
    match slot.checked_sub(free) {
        Some(index) => &list[index],
        None => variables[slot].borrow(),
    }
}

/// Writes a constant plus multiples of values to its slot.
///
/// Factors of one and minus one change no bit, and having no branch is faster than a mispredicted
/// one.
#[inline(never)]
fn add_up<'v, S: Scalar + 'v>(
    result: &mut S,
    terms: &[(f64, Slot)],
    constant: f64,
    get: impl Fn(Slot) -> &'v S,
) {
    let [(factor, slot), rest @ ..] = terms else { unreachable!("a sum has a term") };
    let mut sum = get(*slot).scale(*factor);
    for (factor, slot) in rest {
        sum = sum.plus(*factor, get(*slot));
    }
    *result = sum + S::constant(constant);
}

impl Code {
    /// The number of instructions up to the last of the first results, whose slots come after these others.
    fn needed_for(&self, results: usize, others: usize) -> usize {
        self.results[..results].iter().map(|slot| (slot + 1).saturating_sub(others)).max().unwrap_or(0)
    }

    /// Runs a range of the instructions, in order, on a list that already holds some values before
    /// the results.
    fn run<S: Scalar, V: Borrow<S>>(
        &self,
        which: Range<usize>,
        variables: &[V],
        free: usize,
        (list, before): (&mut [S], usize),
    ) {
        for index in which {
            let (known, results) = list.split_at_mut(before + index);
            let get = |slot: Slot| value(slot, variables, free, known);
            let result = &mut results[0];
            match &self.instructions[index] {
                Instruction::Plain(operation) => operation.compute(result, get),
                Instruction::Sum { start, end, constant } => {
                    add_up(result, &self.terms[*start..*end], *constant, get);
                }
            }
        }
    }
}
