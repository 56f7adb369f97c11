//! The functions that an expression may use, and those that it must not.

use grazing_model::smooth::Function;
use nanoexpr::{ErrorKind, Number};

use super::graph::Term;

/// The computation of a named function.
type Compute = for<'g> fn(Term<'g>) -> Result<Term<'g>, ErrorKind>;

const KNOWN: [(&str, Compute); 10] = [
    ("sin", |x| x.apply(Function::Sin)),
    ("cos", |x| x.apply(Function::Cos)),
    ("tan", |x| x.apply(Function::Tan)),
    ("atan", |x| x.apply(Function::Atan)),
    // As the product of these two it is also exact near 0, where the difference of exponentials is
    // not.
    ("sinh", |x| x.apply(Function::Tanh)?.multiply(cosh(x)?)),
    ("cosh", cosh),
    ("tanh", |x| x.apply(Function::Tanh)),
    ("exp", |x| x.apply(Function::Exp)),
    ("ln", |x| x.apply(Function::Ln)),
    ("sqrt", |x| x.apply(Function::Sqrt)),
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

/// Whether the name is that of a function that is rejected because it is not smooth.
pub(super) fn is_not_smooth(name: &str) -> bool {
    NOT_SMOOTH.contains(&name)
}

/// The function's value; `None` if there is no function of this name.
pub(super) fn call<'g>(name: &str, arguments: &[Term<'g>]) -> Option<Result<Term<'g>, ErrorKind>> {
    let (_, compute) = KNOWN.iter().find(|(candidate, _)| *candidate == name)?;
    match arguments {
        [argument] => Some(compute(*argument)),
        _ => Some(Err(ErrorKind::ArgumentCount)),
    }
}

fn cosh(argument: Term<'_>) -> Result<Term<'_>, ErrorKind> {
    let growing = argument.apply(Function::Exp)?;
    let falling = argument.negate()?.apply(Function::Exp)?;
    growing.add(falling)?.multiply(Term::Number(0.5))
}

/// The meaning of a variable of force or reset law.
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
