//! Derivatives of expressions, as parts of one graph.

use grazing_model::smooth::{Function, Stop};
use nanoexpr::{ErrorKind, Number};

use super::Operation;
use super::graph::{Graph, Node, Term};

const ZERO: Term<'_> = Term::Number(0.0);
const ONE: Term<'_> = Term::Number(1.0);

impl Graph {
    /// The derivative of a term with respect to a variable.
    ///
    /// # Errors
    /// A constant in it is too large for computation, or the computation is cancelled.
    pub(super) fn derivative<'g>(
        &'g self,
        of: Term<'g>,
        variable: usize,
        stop: &Stop,
    ) -> Result<Term<'g>, ErrorKind> {
        let Term::Node(_, root) = of else { return Ok(ZERO) };
        // Operands come before the nodes that use them.
        let mut parts = vec![false; root + 1];
        parts[root] = true;
        for index in (0..=root).rev() {
            if let (true, Node::Operation(operation)) = (parts[index], self.node(index)) {
                operation.operands().into_iter().for_each(|operand| parts[operand] = true);
            }
        }
        let mut slopes: Vec<Term<'g>> = Vec::with_capacity(root + 1);
        for (index, part) in parts.into_iter().enumerate() {
            if stop.is_asked() {
                return Err(ErrorKind::TooLong);
            }
            let slope = match self.node(index) {
                Node::Variable(number) if number == variable => ONE,
                Node::Operation(operation) if part => {
                    let whole = Term::Node(self, index);
                    self.slope(operation, whole, |operand| slopes[operand])?
                }
                _ => ZERO,
            };
            slopes.push(slope);
        }
        Ok(slopes[root])
    }

    /// The derivative of an operation, whose result is `whole`, from the derivatives of its
    /// operands.
    fn slope<'g>(
        &'g self,
        operation: Operation<usize>,
        whole: Term<'g>,
        slope: impl Fn(usize) -> Term<'g>,
    ) -> Result<Term<'g>, ErrorKind> {
        let term = |operand: usize| Term::Node(self, operand);
        match operation {
            Operation::Constant(_) => Ok(ZERO),
            Operation::Add(a, b) => slope(a).add(slope(b)),
            Operation::Shift(a, _) => Ok(slope(a)),
            Operation::Subtract(a, b) => slope(a).subtract(slope(b)),
            Operation::Negate(a) => slope(a).negate(),
            Operation::Multiply(a, b) => {
                let (left, right) = (slope(a).multiply(term(b))?, term(a).multiply(slope(b))?);
                left.add(right)
            }
            Operation::Scale(a, factor) => slope(a).multiply(Term::Number(factor)),
            Operation::Divide(a, b) => slope(a).subtract(whole.multiply(slope(b))?)?.divide(term(b)),
            Operation::Square(a) => slope(a).multiply(term(a))?.multiply(Term::Number(2.0)),
            Operation::Power(a, exponent) => {
                let lower = term(a).power(Term::Number(f64::from(exponent - 1)))?;
                lower.multiply(Term::Number(f64::from(exponent)))?.multiply(slope(a))
            }
            Operation::Apply(function, a) => {
                let outer = match function {
                    Function::Sin => term(a).apply(Function::Cos)?,
                    Function::Cos => term(a).apply(Function::Sin)?.negate()?,
                    Function::Tan => whole.multiply(whole)?.add(ONE)?,
                    Function::Tanh => ONE.subtract(whole.multiply(whole)?)?,
                    Function::Atan => ONE.divide(term(a).multiply(term(a))?.add(ONE)?)?,
                    Function::Exp => whole,
                    Function::Ln => ONE.divide(term(a))?,
                    Function::Sqrt => Term::Number(0.5).divide(whole)?,
                };
                outer.multiply(slope(a))
            }
        }
    }
}
