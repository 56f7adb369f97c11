//! An expression as text, which gives the same expression when it is read again.

use std::fmt;

use grazing_model::smooth::Function;

use super::graph::Node;
use super::{Expression, Operation};

/// How tightly the outermost operator binds.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Strength {
    Sum,
    Product,
    Sign,
    Power,
    Atom,
}

impl fmt::Display for Expression {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut texts: Vec<(String, Strength)> = Vec::new();
        for node in &self.0.nodes {
            let text = match node {
                Node::Variable(number) => (self.0.variables[*number].clone(), Strength::Atom),
                Node::Operation(operation) => operation_text(operation, &texts),
            };
            texts.push(text);
        }
        let (text, _) = texts.last().expect("an expression has at least one part");
        formatter.write_str(text)
    }
}

fn operation_text(operation: &Operation<usize>, texts: &[(String, Strength)]) -> (String, Strength) {
    // The operand, in parentheses if it binds less tightly than `least`.
    let text = |index: usize, least: Strength| {
        let (text, strength) = &texts[index];
        if *strength < least { format!("({text})") } else { text.clone() }
    };
    match *operation {
        Operation::Constant(value) => constant(value),
        Operation::Add(a, b) => {
            (format!("{} + {}", text(a, Strength::Sum), text(b, Strength::Product)), Strength::Sum)
        }
        Operation::Shift(a, value) if value < 0.0 => {
            (format!("{} - {:?}", text(a, Strength::Sum), -value), Strength::Sum)
        }
        Operation::Shift(a, value) => (format!("{} + {value:?}", text(a, Strength::Sum)), Strength::Sum),
        Operation::Subtract(a, b) => {
            (format!("{} - {}", text(a, Strength::Sum), text(b, Strength::Product)), Strength::Sum)
        }
        Operation::Negate(a) => (format!("-{}", text(a, Strength::Power)), Strength::Sign),
        Operation::Multiply(a, b) => {
            (format!("{}*{}", text(a, Strength::Product), text(b, Strength::Sign)), Strength::Product)
        }
        Operation::Scale(a, value) => {
            (format!("{}*{}", constant(value).0, text(a, Strength::Sign)), Strength::Product)
        }
        Operation::Divide(a, b) => {
            (format!("{}/{}", text(a, Strength::Product), text(b, Strength::Sign)), Strength::Product)
        }
        Operation::Square(a) => (format!("{}^2", text(a, Strength::Atom)), Strength::Power),
        Operation::Power(a, exponent) => (format!("{}^{exponent}", text(a, Strength::Atom)), Strength::Power),
        Operation::Apply(function, a) => {
            (format!("{}({})", name(function), text(a, Strength::Sum)), Strength::Atom)
        }
    }
}

fn constant(value: f64) -> (String, Strength) {
    let strength = if value.is_sign_negative() { Strength::Sign } else { Strength::Atom };
    (format!("{value:?}"), strength)
}

fn name(function: Function) -> &'static str {
    match function {
        Function::Sin => "sin",
        Function::Cos => "cos",
        Function::Tan => "tan",
        Function::Tanh => "tanh",
        Function::Atan => "atan",
        Function::Exp => "exp",
        Function::Ln => "ln",
        Function::Sqrt => "sqrt",
    }
}
