//! The functions that an expression may use, and those that it may not.

use grazing_model::smooth::Function;
use nanoexpr::{ErrorKind, Number};

use super::graph::Term;

/// What a name followed by a parenthesis computes.
#[derive(Clone, Copy)]
enum Known {
    Elementary(Function),
    Sinh,
    Cosh,
}

const KNOWN: [(&str, Known); 10] = [
    ("sin", Known::Elementary(Function::Sin)),
    ("cos", Known::Elementary(Function::Cos)),
    ("tan", Known::Elementary(Function::Tan)),
    ("atan", Known::Elementary(Function::Atan)),
    ("sinh", Known::Sinh),
    ("cosh", Known::Cosh),
    ("tanh", Known::Elementary(Function::Tanh)),
    ("exp", Known::Elementary(Function::Exp)),
    ("ln", Known::Elementary(Function::Ln)),
    ("sqrt", Known::Elementary(Function::Sqrt)),
];

/// Functions that have a corner, a jump or a cut.
const NOT_SMOOTH: [&str; 24] = [
    "abs",
    "fabs",
    "sign",
    "signum",
    "sgn",
    "min",
    "max",
    "floor",
    "ceil",
    "round",
    "trunc",
    "int",
    "frac",
    "fract",
    "mod",
    "fmod",
    "rem",
    "heaviside",
    "step",
    "clamp",
    "cbrt",
    "hypot",
    "atan2",
    "if",
];

/// The names of all functions.
pub(super) fn functions() -> impl Iterator<Item = &'static str> {
    KNOWN.iter().map(|(name, _)| *name)
}

/// Whether the name is that of a function, known or refused.
pub(crate) fn is_function(name: &str) -> bool {
    functions().any(|known| known == name) || is_not_smooth(name)
}

/// Whether the name is that of a function which is refused because it is not smooth.
pub(super) fn is_not_smooth(name: &str) -> bool {
    NOT_SMOOTH.contains(&name)
}

/// The function's value; `None` if there is no function of this name.
pub(super) fn call<'g>(name: &str, arguments: &[Term<'g>]) -> Option<Result<Term<'g>, ErrorKind>> {
    let (_, known) = KNOWN.iter().find(|(candidate, _)| *candidate == name)?;
    let [argument] = arguments else {
        return Some(Err(ErrorKind::ArgumentCount));
    };
    Some(match known {
        Known::Elementary(function) => argument.apply(*function),
        Known::Cosh => cosh(*argument),
        // As the product of these two it is exact near 0 as well, where the difference of
        // exponentials is not.
        Known::Sinh => argument
            .apply(Function::Tanh)
            .and_then(|tanh| cosh(*argument).and_then(|cosh| tanh.multiply(cosh))),
    })
}

fn cosh(argument: Term<'_>) -> Result<Term<'_>, ErrorKind> {
    let growing = argument.apply(Function::Exp)?;
    let falling = argument.negate()?.apply(Function::Exp)?;
    growing.add(falling)?.multiply(Term::Number(0.5))
}

/// What the name of a variable of force or reset law means.
pub(crate) fn variable(name: &str) -> Option<&'static str> {
    Some(match name {
        "x" => "the position",
        "v" => "the velocity",
        "t" => "the time",
        "y" => "the impact velocity",
        "z" => "the impact phase",
        _ => return None,
    })
}
