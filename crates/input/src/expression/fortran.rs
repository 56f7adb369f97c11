//! Expressions as Fortran, for other programs.

use grazing_model::smooth::Function;

use super::{Expression, Instruction, Operation, Slot};

impl Expression {
    /// A Fortran 2003 function that computes the expression from the values of its variables, in
    /// the order of [`variables`](Self::variables): `FUNCTION name(a)`.
    pub fn fortran(&self, name: &str) -> String {
        let code = &self.0.whole;
        let variables = self.0.variables.len();
        let value = |slot: Slot| match slot.checked_sub(variables) {
            Some(index) => format!("b({})", index + 1),
            None => format!("a({})", slot + 1),
        };
        let statement = |instruction: &Instruction| match *instruction {
            Instruction::Plain(operation) => computed(operation.on(value)),
            Instruction::Sum { start, end, constant } => {
                let terms = code.terms[start..end]
                    .iter()
                    .map(|(factor, slot)| format!("({})*{}", number(*factor), value(*slot)));
                terms.chain([format!("({})", number(constant))]).collect::<Vec<_>>().join(" &\n      + ")
            }
        };
        let statements =
            (1..).zip(&code.instructions).map(|(k, it)| format!("    b({k}) = {}\n", statement(it)));
        format!(
            "  PURE DOUBLE PRECISION FUNCTION {name}(a)\n    DOUBLE PRECISION, INTENT(IN) :: a({variables})\n    \
             DOUBLE PRECISION :: b({})\n{}    {name} = {}\n  END FUNCTION {name}\n",
            code.instructions.len().max(1),
            statements.collect::<String>(),
            value(code.results[0]),
        )
    }
}

/// An operation on operands that are text.
fn computed(operation: Operation<String>) -> String {
    match operation {
        Operation::Constant(constant) => number(constant),
        Operation::Add(a, b) => format!("{a} + {b}"),
        Operation::Shift(a, constant) => format!("{a} + ({})", number(constant)),
        Operation::Subtract(a, b) => format!("{a} - {b}"),
        Operation::Negate(a) => format!("-{a}"),
        Operation::Multiply(a, b) => format!("{a}*{b}"),
        Operation::Scale(a, factor) => format!("{a}*({})", number(factor)),
        Operation::Divide(a, b) => format!("{a}/{b}"),
        Operation::Square(a) => format!("{a}**2"),
        Operation::Power(a, exponent) => format!("{a}**({exponent})"),
        Operation::Apply(function, a) => format!("{}({a})", of(function)),
    }
}

/// The number in double precision, to the last bit.
fn number(value: f64) -> String {
    format!("{value:e}").replace('e', "d")
}

/// The Fortran name of a function.
fn of(function: Function) -> &'static str {
    match function {
        Function::Sin => "sin",
        Function::Cos => "cos",
        Function::Tan => "tan",
        Function::Tanh => "tanh",
        Function::Atan => "atan",
        Function::Exp => "exp",
        Function::Ln => "log",
        Function::Sqrt => "sqrt",
    }
}
