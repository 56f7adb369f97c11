//! The graph that the parser's arithmetic builds: equal parts are one node, and constants are
//! folded.

use std::cell::RefCell;
use std::collections::HashMap;
use std::mem::{Discriminant, discriminant};

use grazing_model::smooth::{Function, Scalar};
use nanoexpr::{ErrorKind, Number};

use super::Operation;

/// A part of an expression; operands are given by their number in the list of nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Node {
    Variable(usize),
    Operation(Operation<usize>),
}

/// A key that is the same for equal nodes only: the kind of operation, operands, and detail; for a
/// variable its number.
type Key = (Option<Discriminant<Operation<usize>>>, Vec<usize>, u64);

impl Node {
    fn key(&self) -> Key {
        match self {
            Node::Variable(number) => (None, vec![*number], 0),
            Node::Operation(operation) => {
                (Some(discriminant(operation)), operation.operands(), operation.detail())
            }
        }
    }
}

/// All nodes created so far, without repetition.
#[derive(Default)]
pub(super) struct Graph {
    nodes: RefCell<Vec<Node>>,
    /// The number of each node.
    numbers: RefCell<HashMap<Key, usize>>,
}

impl Graph {
    /// The term of a variable.
    pub(super) fn variable(&self, number: usize) -> Term<'_> {
        self.term(Node::Variable(number))
    }

    /// The node with a number.
    pub(super) fn node(&self, index: usize) -> Node {
        self.nodes.borrow()[index]
    }

    fn term(&self, node: Node) -> Term<'_> {
        let mut nodes = self.nodes.borrow_mut();
        let index = *self.numbers.borrow_mut().entry(node.key()).or_insert_with(|| {
            nodes.push(node);
            nodes.len() - 1
        });
        Term::Node(self, index)
    }

    fn operation(&self, operation: Operation<usize>) -> Term<'_> {
        self.term(Node::Operation(operation))
    }

    /// The number of a constant's node.
    fn constant(&self, value: f64) -> usize {
        match self.operation(Operation::Constant(value)) {
            Term::Node(_, index) => index,
            Term::Number(_) => unreachable!("an operation is a node"),
        }
    }

    /// The parts on which these terms depend, each once, operands first and the left one before the
    /// right one; and the place of each term among them. A number is a part.
    pub(super) fn parts(&self, terms: &[Term<'_>]) -> (Vec<Node>, Vec<usize>) {
        let root = |term: &Term<'_>| match term {
            Term::Number(value) => self.constant(*value),
            Term::Node(_, index) => *index,
        };
        let roots: Vec<usize> = terms.iter().map(root).collect();
        let nodes = self.nodes.borrow();
        let mut numbers = vec![None; nodes.len()];
        let mut parts: Vec<Node> = Vec::new();
        // An explicit stack: sums of thousands of terms are deep to the left.
        let mut waiting: Vec<(usize, bool)> = roots.iter().rev().map(|&root| (root, false)).collect();
        while let Some((index, ready)) = waiting.pop() {
            if numbers[index].is_some() {
                continue;
            }
            let Node::Operation(operation) = nodes[index] else {
                numbers[index] = Some(parts.len());
                parts.push(nodes[index]);
                continue;
            };
            if ready {
                numbers[index] = Some(parts.len());
                let operation = operation.on(|operand| numbers[operand].expect("operands come first"));
                parts.push(Node::Operation(operation));
            } else {
                waiting.push((index, true));
                waiting.extend(operation.operands().into_iter().rev().map(|operand| (operand, false)));
            }
        }
        let places = roots.iter().map(|&root| numbers[root].expect("it has been reached"));
        let places = places.collect();
        (parts, places)
    }
}

/// A value for the parser's arithmetic: a number, or a node of the graph.
#[derive(Clone, Copy)]
pub(super) enum Term<'g> {
    Number(f64),
    Node(&'g Graph, usize),
}

impl Default for Term<'_> {
    fn default() -> Self {
        Term::Number(0.0)
    }
}

/// A constant computed from constants, or the error that it is not finite.
fn number<'g>(value: f64) -> Result<Term<'g>, ErrorKind> {
    if value.is_finite() {
        Ok(Term::Number(value))
    } else if value.is_nan() {
        Err(ErrorKind::Domain)
    } else {
        Err(ErrorKind::Overflow)
    }
}

impl Term<'_> {
    /// The function of this term.
    pub(super) fn apply(self, function: Function) -> Result<Self, ErrorKind> {
        match self {
            Term::Number(value) => match Scalar::apply(value, function) {
                value if value.is_finite() => Ok(Term::Number(value)),
                // The logarithm has a pole at zero; everything else that is infinite is too large.
                value if value.is_infinite() && function != Function::Ln => Err(ErrorKind::Overflow),
                _ => Err(ErrorKind::Domain),
            },
            Term::Node(graph, a) => Ok(graph.operation(Operation::Apply(function, a))),
        }
    }

    fn scaled(self, factor: f64) -> Result<Self, ErrorKind> {
        match (self, factor) {
            (Term::Number(_), _) => self.multiply(Term::Number(factor)),
            (_, 0.0) => Ok(Term::Number(0.0)),
            (_, 1.0) => Ok(self),
            (_, -1.0) => self.negate(),
            (Term::Node(graph, a), _) => Ok(graph.operation(Operation::Scale(a, factor))),
        }
    }

    fn shifted(self, value: f64) -> Self {
        match self {
            Term::Node(graph, a) if value != 0.0 => graph.operation(Operation::Shift(a, value)),
            _ => self,
        }
    }

    /// The power exp(exponent · ln(self)).
    fn real_power(self, exponent: Self) -> Result<Self, ErrorKind> {
        exponent.multiply(self.apply(Function::Ln)?)?.apply(Function::Exp)
    }

    fn constant_power(self, exponent: f64) -> Result<Self, ErrorKind> {
        let Term::Node(graph, a) = self else {
            return self.power(Term::Number(exponent));
        };
        match exponent {
            0.0 => Ok(Term::Number(1.0)),
            0.5 => self.apply(Function::Sqrt),
            1.0 => Ok(self),
            2.0 => Ok(graph.operation(Operation::Square(a))),
            // No power of a double beyond this is of use.
            whole if whole == whole.trunc() && whole.abs() <= 1024.0 => {
                Ok(graph.operation(Operation::Power(a, whole as i32)))
            }
            _ => self.real_power(Term::Number(exponent)),
        }
    }
}

impl Number for Term<'_> {
    fn parse(literal: &str) -> Option<Self> {
        literal.parse().ok().filter(|value: &f64| value.is_finite()).map(Term::Number)
    }

    fn add(self, rhs: Self) -> Result<Self, ErrorKind> {
        match (self, rhs) {
            (Term::Number(a), Term::Number(b)) => number(a + b),
            (node, Term::Number(value)) | (Term::Number(value), node) => Ok(node.shifted(value)),
            (Term::Node(graph, a), Term::Node(_, b)) => Ok(graph.operation(Operation::Add(a, b))),
        }
    }

    fn subtract(self, rhs: Self) -> Result<Self, ErrorKind> {
        match (self, rhs) {
            (Term::Number(a), Term::Number(b)) => number(a - b),
            (node, Term::Number(value)) => Ok(node.shifted(-value)),
            (Term::Number(0.0), node) => node.negate(),
            (Term::Number(value), Term::Node(graph, b)) => {
                Ok(graph.operation(Operation::Subtract(graph.constant(value), b)))
            }
            (Term::Node(graph, a), Term::Node(_, b)) => Ok(graph.operation(Operation::Subtract(a, b))),
        }
    }

    fn multiply(self, rhs: Self) -> Result<Self, ErrorKind> {
        match (self, rhs) {
            (Term::Number(a), Term::Number(b)) => number(a * b),
            (node, Term::Number(value)) | (Term::Number(value), node) => node.scaled(value),
            (Term::Node(graph, a), Term::Node(_, b)) if a == b => Ok(graph.operation(Operation::Square(a))),
            (Term::Node(graph, a), Term::Node(_, b)) => Ok(graph.operation(Operation::Multiply(a, b))),
        }
    }

    fn divide(self, rhs: Self) -> Result<Self, ErrorKind> {
        match (self, rhs) {
            (_, Term::Number(0.0)) => Err(ErrorKind::DivisionByZero),
            (Term::Number(a), Term::Number(b)) => number(a / b),
            (Term::Node(..), Term::Number(value)) if is_power_of_two(value) => self.scaled(1.0 / value),
            (Term::Node(graph, a), Term::Number(value)) => {
                Ok(graph.operation(Operation::Divide(a, graph.constant(value))))
            }
            (Term::Number(0.0), Term::Node(..)) => Ok(self),
            (Term::Number(value), Term::Node(graph, b)) => {
                Ok(graph.operation(Operation::Divide(graph.constant(value), b)))
            }
            (Term::Node(graph, a), Term::Node(_, b)) => Ok(graph.operation(Operation::Divide(a, b))),
        }
    }

    fn remainder(self, _: Self) -> Result<Self, ErrorKind> {
        Err(ErrorKind::Unsupported)
    }

    fn power(self, rhs: Self) -> Result<Self, ErrorKind> {
        match (self, rhs) {
            (Term::Number(base), Term::Number(exponent)) if base == 0.0 && exponent < 0.0 => {
                Err(ErrorKind::DivisionByZero)
            }
            (Term::Number(base), Term::Number(exponent)) => number(libm::pow(base, exponent)),
            (Term::Node(..), Term::Number(exponent)) => self.constant_power(exponent),
            (Term::Number(std::f64::consts::E), Term::Node(..)) => rhs.apply(Function::Exp),
            (Term::Number(base), Term::Node(..)) if base > 0.0 => self.real_power(rhs),
            (Term::Number(_), Term::Node(..)) => Err(ErrorKind::Domain),
            (Term::Node(..), Term::Node(..)) => self.real_power(rhs),
        }
    }

    fn negate(self) -> Result<Self, ErrorKind> {
        Ok(match self {
            Term::Number(value) => Term::Number(-value),
            Term::Node(graph, a) => match graph.node(a) {
                Node::Operation(Operation::Negate(inner)) => Term::Node(graph, inner),
                Node::Operation(Operation::Scale(inner, factor)) => {
                    graph.operation(Operation::Scale(inner, -factor))
                }
                _ => graph.operation(Operation::Negate(a)),
            },
        })
    }

    fn factorial(self) -> Result<Self, ErrorKind> {
        Err(ErrorKind::Unsupported)
    }
}

/// Whether division by the number is exactly multiplication by its reciprocal.
fn is_power_of_two(value: f64) -> bool {
    let (fraction, _) = libm::frexp(value);
    fraction.abs() == 0.5 && (1.0 / value).is_finite()
}
