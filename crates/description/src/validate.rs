//! From the file as written to a description that can be computed with.

use std::sync::Arc;

use grazing_source::Source;
use toml::Spanned;

use crate::description::{Axis, Content, Description, Limits, Texts};
use crate::error::DescriptionError;
use crate::expression::Expression;
use crate::file::{self, File, MOST_LOOPS, REQUIREMENTS};
use crate::names;

/// More constants than this nobody names; every name in an expression is looked for among them.
const MOST_CONSTANTS: usize = 1000;

type Checked<T> = Result<T, DescriptionError>;

/// The keys of the four expressions with the variables that each may use beside the parameters, and how many of them, the
/// first ones, move while the others are held.
const FORCE: (&str, &[&str], usize) = ("motion.force", &["x", "v", "t"], 2);
const FREQUENCY: (&str, &[&str], usize) = ("motion.frequency", &[], 0);
const RESTITUTION: (&str, &[&str], usize) = ("impact.restitution", &["y", "z"], 2);
const DURATION: (&str, &[&str], usize) = ("impact.duration", &["y", "z"], 2);

/// Checks everything that can be checked without evaluating an expression.
pub(crate) fn description(raw: &File, source: &Source<'_>) -> Checked<Description> {
    let name = raw.name.get_ref().trim();
    if name.is_empty() {
        return Err(source.forbid("name", &raw.name, REQUIREMENTS.of("name").to_owned()).into());
    }
    if raw.parameters.len() > MOST_CONSTANTS {
        let last = raw.parameters.iter().max_by_key(|(name, _)| name.span().start);
        let allowed =
            format!("this is constant number {}: at most {MOST_CONSTANTS} are allowed", raw.parameters.len());
        if let Some((name, value)) = last {
            return Err(source.forbid(&format!("parameters.{}", name.get_ref()), value, allowed).into());
        }
    }
    names::check(raw, source)?;
    let mut constants = Vec::new();
    for (name, value) in &raw.parameters {
        if !value.get_ref().is_finite() {
            let key = format!("parameters.{}", name.get_ref());
            return Err(source.forbid(&key, value, REQUIREMENTS.of(&key).to_owned()).into());
        }
        constants.push((name.get_ref().clone(), *value.get_ref()));
    }
    let primary = axis("primary", &raw.primary, source)?;
    let secondary = axis("secondary", &raw.secondary, source)?;

    let mut used = [false; 2];
    let mut expression = |(key, variables, moving): (&'static str, &[&str], usize),
                          text: &Spanned<String>| {
        let axes = [primary.name.as_str(), secondary.name.as_str()];
        let variables = [variables, &axes].concat();
        let constants: Vec<_> = constants.iter().map(|(name, value)| (name.as_str(), *value)).collect();
        let (expression, uses) = Expression::parse_with_uses(text.get_ref(), &variables, moving, &constants)
            .map_err(|error| DescriptionError::in_expression(source, key, text, &error))?;
        for (used, place) in used.iter_mut().zip(variables.len() - 2..) {
            *used |= uses.contains(&place);
        }
        Ok::<_, DescriptionError>(expression)
    };
    let force = expression(FORCE, &raw.motion.force)?;
    let frequency = expression(FREQUENCY, &raw.motion.frequency)?;
    let restitution = expression(RESTITUTION, &raw.impact.restitution)?;
    let duration = expression(DURATION, &raw.impact.duration)?;
    let names = [("primary.name", &raw.primary.name), ("secondary.name", &raw.secondary.name)];
    for (used, (key, name)) in used.into_iter().zip(names) {
        if !used {
            let allowed = format!(
                "the name {} appears in none of the four expressions, so nothing depends on this parameter: use it in one, \
                 or name the parameter that is meant",
                name.get_ref()
            );
            return Err(source.forbid(key, name, allowed).into());
        }
    }
    let loops = loops(&raw.analysis.loops, source)?;
    let start = raw.analysis.start.as_ref().map(|start| finite(start, source)).transpose()?;
    let limits = limits(&raw.analysis, source)?;
    let name = name.to_owned();
    Ok(Description(Arc::new(Content {
        name,
        constants,
        primary,
        secondary,
        force,
        frequency,
        restitution,
        duration,
        texts: Texts {
            force: raw.motion.force.get_ref().clone(),
            frequency: raw.motion.frequency.get_ref().clone(),
            restitution: raw.impact.restitution.get_ref().clone(),
            duration: raw.impact.duration.get_ref().clone(),
        },
        loops,
        start,
        limits,
        notes: Vec::new(),
    })))
}

fn limits(raw: &file::Analysis, source: &Source<'_>) -> Checked<Limits> {
    let given = |key: &str, value: &Option<Spanned<f64>>, usual: f64| match value {
        None => Ok(usual),
        Some(value) if value.get_ref().is_finite() && *value.get_ref() > 0.0 => Ok(*value.get_ref()),
        Some(value) => Err(source.forbid(key, value, REQUIREMENTS.of(key).to_owned())),
    };
    Ok(Limits {
        time: given("analysis.time_limit", &raw.time_limit, Limits::USUAL.time)?,
        memory: given("analysis.memory_limit", &raw.memory_limit, Limits::USUAL.memory)?,
        steps: given("analysis.step_limit", &raw.step_limit, Limits::USUAL.steps)?,
    })
}

fn finite(start: &Spanned<Vec<f64>>, source: &Source<'_>) -> Checked<[f64; 2]> {
    let key = "analysis.start";
    match start.get_ref()[..] {
        [position, velocity] if position.is_finite() && velocity.is_finite() => Ok([position, velocity]),
        _ => Err(source.forbid(key, start, REQUIREMENTS.of(key).to_owned()).into()),
    }
}

fn axis(table: &str, raw: &file::Axis, source: &Source<'_>) -> Checked<Axis> {
    let key = format!("{table}.range");
    match raw.range.get_ref()[..] {
        [lower, upper]
            if lower < upper && lower.is_finite() && (upper - lower).is_infinite() && upper.is_finite() =>
        {
            let allowed =
                "the range is too wide to be computed with: upper - lower must be a finite number".to_owned();
            Err(source.forbid(&key, &raw.range, allowed).into())
        }
        [lower, upper] if lower.is_finite() && upper.is_finite() && lower < upper => {
            Ok(Axis { name: raw.name.get_ref().clone(), range: [lower, upper] })
        }
        [lower, upper] if lower > upper && lower.is_finite() && upper.is_finite() => {
            let allowed = format!("the range is reversed: write [{upper:?}, {lower:?}]");
            Err(source.forbid(&key, &raw.range, allowed).into())
        }
        _ => Err(source.forbid(&key, &raw.range, REQUIREMENTS.of(&key).to_owned()).into()),
    }
}

fn loops(raw: &Spanned<Vec<Spanned<u32>>>, source: &Source<'_>) -> Checked<Vec<u32>> {
    let key = "analysis.loops";
    let mut loops = Vec::new();
    for member in raw.get_ref() {
        let number = *member.get_ref();
        if !(1..=MOST_LOOPS).contains(&number) {
            return Err(source.forbid(key, member, REQUIREMENTS.of(key).to_owned()).into());
        }
        if loops.contains(&number) {
            let allowed = format!("{number} is listed twice: list each number once");
            return Err(source.forbid(key, raw, allowed).into());
        }
        loops.push(number);
    }
    if loops.is_empty() {
        return Err(source.forbid(key, raw, REQUIREMENTS.of(key).to_owned()).into());
    }
    Ok(loops)
}
