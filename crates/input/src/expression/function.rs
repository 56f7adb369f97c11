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

/// Functions that have a corner, a jump or a cut, and what may do in their place.
const NOT_SMOOTH: [(&[&str], &str); 9] = [
    (&["abs", "fabs"], "sqrt(x^2 + s^2) with a small s is close to the modulus of x"),
    (&["sign", "signum", "sgn"], "tanh(x/s) with a small s is close to the sign of x"),
    (&["max"], "(a + b + sqrt((a - b)^2 + s^2))/2 with a small s is close to the greater of a and b"),
    (&["min"], "(a + b - sqrt((a - b)^2 + s^2))/2 with a small s is close to the lesser of a and b"),
    (&["heaviside", "step", "if"], STEP),
    (&["clamp"], "c + d*tanh((x - c)/d) stays between c - d and c + d"),
    (&["cbrt"], "x/(x^2 + s^2)^(1/3) with a small s is close to the cube root of x"),
    (&["hypot"], "sqrt(a^2 + b^2 + s^2) with a small s is close to the length of (a, b)"),
    (
        &["floor", "ceil", "round", "trunc", "int", "frac", "fract", "mod", "fmod", "rem", "atan2"],
        "it jumps, and no smooth function is close; periodic forcing is written with sines and cosines",
    ),
];

/// What may do in place of a choice or a comparison.
pub(super) const STEP: &str = "(1 + tanh(x/s))/2 with a small s is close to a step from 0 to 1 at x = 0";

/// The names of all functions.
pub(super) fn functions() -> impl Iterator<Item = &'static str> {
    KNOWN.iter().map(|(name, _)| *name)
}

/// Whether the name is that of a function, known or refused.
pub(crate) fn is_function(name: &str) -> bool {
    functions().any(|known| known == name) || in_place_of(name).is_some()
}

/// What may do in place of a function that is rejected because it is not smooth.
pub(super) fn in_place_of(name: &str) -> Option<&'static str> {
    NOT_SMOOTH.iter().find(|(names, _)| names.contains(&name)).map(|(_, remedy)| *remedy)
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
