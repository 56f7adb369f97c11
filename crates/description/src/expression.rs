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
//! Constants are folded while the text is read, equal parts become one node, and whole powers are products. What is left is
//! a short list of instructions on a few registers, which [`Expression::evaluate`] runs over plain numbers,
//! jets or intervals alike; up to [`MOST_REGISTERS_ON_STACK`] registers it allocates nothing.

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

/// The most registers that an evaluation keeps on the stack; an expression that needs more of them allocates.
///
/// A register is a value that waits for its use: even (1 + x)(2 + x)…, written out, needs but two at a time.
pub const MOST_REGISTERS_ON_STACK: usize = 32;

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
    registers: usize,
    result: Place,
}

/// Where an operand stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Place {
    Register(u32),
    Variable(u32),
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Instruction {
    operation: Operation<Place>,
    target: u32,
}

/// An operation on operands of some kind: nodes in the graph, places on the tape.
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

impl Operation<Place> {
    #[inline]
    fn compute<S: Scalar>(&self, variables: &[S], registers: &[S]) -> S {
        let get = |place: Place| match place {
            Place::Register(index) => registers[index as usize],
            Place::Variable(index) => variables[index as usize],
        };
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

    /// The number of values that wait for their use at most at one time.
    pub fn registers(&self) -> usize {
        self.0.registers
    }

    /// The value at these values of the variables, in the order of [`Expression::variables`].
    ///
    /// # Panics
    /// With fewer values than variables.
    #[inline]
    pub fn evaluate<S: Scalar>(&self, variables: &[S]) -> S {
        assert!(variables.len() >= self.0.variables.len(), "a value for every variable");
        match self.0.registers {
            0..=4 => self.run(variables, &mut [S::constant(0.0); 4]),
            5..=8 => self.run(variables, &mut [S::constant(0.0); 8]),
            9..=MOST_REGISTERS_ON_STACK => {
                self.run(variables, &mut [S::constant(0.0); MOST_REGISTERS_ON_STACK])
            }
            more => self.run(variables, &mut vec![S::constant(0.0); more]),
        }
    }

    #[inline]
    fn run<S: Scalar>(&self, variables: &[S], registers: &mut [S]) -> S {
        for instruction in &self.0.instructions {
            registers[instruction.target as usize] = instruction.operation.compute(variables, registers);
        }
        match self.0.result {
            Place::Register(index) => registers[index as usize],
            Place::Variable(index) => variables[index as usize],
        }
    }

    /// The tape of nodes of which each stands after those it is made of, and the last one is the whole.
    fn assemble(variables: Vec<String>, nodes: Vec<Node>) -> Expression {
        let mut last_use = vec![usize::MAX; nodes.len()];
        for (index, node) in nodes.iter().enumerate() {
            if let Node::Operation(operation) = node
                && let Some((a, b)) = operation.operands()
            {
                last_use[a] = index;
                last_use[b] = index;
            }
        }
        let mut places: Vec<Place> = Vec::with_capacity(nodes.len());
        let mut free = Vec::new();
        let mut registers = 0;
        let mut instructions = Vec::new();
        for (index, node) in nodes.iter().enumerate() {
            let operation = match node {
                Node::Variable(number) => {
                    places.push(Place::Variable(*number as u32));
                    continue;
                }
                Node::Operation(operation) => operation,
            };
            if let Some((a, b)) = operation.operands() {
                for (operand, repeated) in [(a, false), (b, a == b)] {
                    if let Place::Register(register) = places[operand]
                        && last_use[operand] == index
                        && !repeated
                    {
                        free.push(register);
                    }
                }
            }
            let target = free.pop().unwrap_or_else(|| {
                registers += 1;
                registers - 1
            });
            instructions.push(Instruction { operation: operation.on(|operand| places[operand]), target });
            places.push(Place::Register(target));
        }
        let result = *places.last().expect("an expression has at least one part");
        Expression(Arc::new(Tape { variables, nodes, instructions, registers: registers as usize, result }))
    }
}
