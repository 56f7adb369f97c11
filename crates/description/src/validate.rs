//! From the file as written to a description that can be computed with.

use std::sync::Arc;

use grazing_source::{Section, SourceError};

use crate::description::{
    Axis, Content, Description, Expressions, Formulas, Limits, OneParameter, Side, Wall,
};
use crate::error::{DescriptionError, KeyPlace};
use crate::expression::{Expression, ExpressionError, from_the_wall};
use crate::file::{MOST_DIAGRAMS, MOST_LOOPS, MOST_PORTRAITS};
use crate::names;

/// More constants than this nobody names; every name in an expression is looked for among them.
const MOST_CONSTANTS: usize = 1000;

/// The most characters of a unit: it stands beside a name on an axis.
const LONGEST_UNIT: usize = 20;

/// The key of an expression with the variables that it may use beside the parameters, and how many of them, the first ones,
/// move while the others are held.
type Kind = (&'static str, &'static [&'static str], usize);

const FORCE: Kind = ("force", &["x", "v", "t"], 2);
const POSITION: Kind = ("position", &["t"], 0);
const FREQUENCY: Kind = ("frequency", &[], 0);
const RESTITUTION: Kind = ("restitution", &["y", "z"], 2);
const DURATION: Kind = ("duration", &["y", "z"], 2);

/// The names of the parameters, and the constants.
struct Known<'a>([&'a str; 2], Vec<(&'a str, f64)>);

impl<'a> Known<'a> {
    fn new(axes: [&'a Axis; 2], constants: &'a [(String, f64)]) -> Self {
        let constants = constants.iter().map(|(name, value)| (name.as_str(), *value)).collect();
        Self(axes.map(Axis::name), constants)
    }

    /// The expression, and the numbers of the variables in it, the last two of which are the parameters.
    fn parse(&self, text: &str, (_, own, moving): Kind) -> Result<(Expression, Vec<usize>), ExpressionError> {
        Expression::parse_with_uses(text, &[own, &self.0].concat(), moving, &self.1)
    }
}

/// The formulas of an oscillator with these parameters and constants.
pub(crate) fn formulas(
    texts: &Expressions<String>,
    side: Side,
    axes: [&Axis; 2],
    constants: &[(String, f64)],
) -> Result<Formulas, ExpressionError> {
    let known = Known::new(axes, constants);
    let parse = |text, kind| Ok(known.parse(text, kind)?.0);
    let names = ["x", "v", "t", known.0[0], known.0[1]];
    let [force, x, v] = from_the_wall(&texts.force, &texts.wall, side.sign(), &names, &known.1)?;
    Ok(Formulas {
        force,
        wall: Wall { side, outside: [x, v] },
        frequency: parse(&texts.frequency, FREQUENCY)?,
        restitution: parse(&texts.restitution, RESTITUTION)?,
        duration: parse(&texts.duration, DURATION)?,
    })
}

/// Checks everything that can be checked without evaluating an expression. Where there is no wall in the file, its expression stands
/// where that of the force does.
pub(crate) fn description(
    file: &Section<'_>,
) -> Result<(Description, Expressions<KeyPlace>), DescriptionError> {
    let name = file.value::<String>("name")?.trim().to_owned();
    if name.is_empty() {
        return Err(file.refusal("name").into());
    }
    let parameters = file.table("parameters")?;
    let axes = [file.table("primary")?, file.table("secondary")?];
    names::check(&parameters, &axes)?;
    let constants = constants(&parameters)?;
    let [primary, secondary] = [axis(&axes[0])?, axis(&axes[1])?];

    let known = Known::new([&primary, &secondary], &constants);
    let mut used = [false; 2];
    let mut written = |section: &Section<'_>, kind: Kind| {
        let text: String = section.value(kind.0)?;
        let (_, uses) = known
            .parse(&text, kind)
            .map_err(|error| DescriptionError::in_expression(section, kind.0, &text, &error))?;
        for (used, place) in used.iter_mut().zip(kind.1.len()..) {
            *used |= uses.contains(&place);
        }
        Ok::<_, DescriptionError>((text, KeyPlace::new(section, kind.0)))
    };
    let (motion, impact) = (file.table("motion")?, file.table("impact")?);
    let (side, wall) = if file.has("wall") {
        let section = file.table("wall")?;
        let position = written(&section, POSITION)?;
        (side(&section)?, position)
    } else {
        (Side::Below, ("0".to_owned(), KeyPlace::new(&motion, FORCE.0)))
    };
    let written = Expressions {
        wall,
        force: written(&motion, FORCE)?,
        frequency: written(&motion, FREQUENCY)?,
        restitution: written(&impact, RESTITUTION)?,
        duration: written(&impact, DURATION)?,
    };
    let (texts, places) = (written.map(|(text, _)| text.clone()), written.map(|(_, place)| place.clone()));
    // Each by itself is right.
    let formulas = formulas(&texts, side, [&primary, &secondary], &constants)
        .map_err(|error| DescriptionError::Value { place: places.wall.clone(), problem: error.problem })?;
    for (used, (axis, name)) in used.into_iter().zip(axes.iter().zip([&primary.name, &secondary.name])) {
        if !used {
            let allowed = format!(
                "the name {name} appears in none of the expressions, so nothing depends on this parameter: use it in one, \
                 or name the parameter that is meant"
            );
            return Err(axis.forbid("name", allowed).into());
        }
    }
    let analysis = file.table("analysis")?;
    let start = analysis.has("start").then(|| analysis.numbers("start", |_| true)).transpose()?;
    let middle = [&primary, &secondary].map(|axis| axis.range[0] + 0.5 * (axis.range[1] - axis.range[0]));
    let start = start.map(|start| formulas.wall.inside(start, 0.0, middle));
    let units = file.has("units").then(|| file.table("units")).transpose()?;
    let named = |name: &str| units.as_ref().map_or(Ok(None), |units| unit(units, name));
    let diagrams = diagrams(file, [&primary, &secondary])?;
    let content = Content {
        unit_names: [named("length")?, named("time")?],
        name,
        constants,
        primary,
        secondary,
        formulas,
        texts,
        loops: analysis.counts("loops", 1..=MOST_LOOPS)?,
        start,
        limits: Limits {
            time: limit(&analysis, "time_limit", Limits::USUAL.time)?,
            memory: limit(&analysis, "memory_limit", Limits::USUAL.memory)?,
            steps: limit(&analysis, "step_limit", Limits::USUAL.steps)?,
        },
        diagrams,
        notes: Vec::new(),
    };
    Ok((Description(Arc::new(content)), places))
}

fn side(wall: &Section<'_>) -> Result<Side, SourceError> {
    match wall.optional::<String>("side")?.as_deref() {
        None | Some("below") => Ok(Side::Below),
        Some("above") => Ok(Side::Above),
        Some(_) => Err(wall.refusal("side")),
    }
}

/// The constants in the order of the alphabet.
fn constants(parameters: &Section<'_>) -> Result<Vec<(String, f64)>, SourceError> {
    let names = parameters.names();
    if let Some(last) = names.last().filter(|_| names.len() > MOST_CONSTANTS) {
        let allowed =
            format!("this is constant number {}: at most {MOST_CONSTANTS} are allowed", names.len());
        return Err(parameters.forbid(last, allowed));
    }
    let mut constants = Vec::new();
    for name in names {
        constants.push((name.to_owned(), parameters.number(name, |_| true)?));
    }
    constants.sort_by(|(a, _), (b, _)| a.cmp(b));
    Ok(constants)
}

fn limit(analysis: &Section<'_>, name: &str, usual: f64) -> Result<f64, SourceError> {
    if analysis.has(name) { analysis.number(name, |value| value > 0.0) } else { Ok(usual) }
}

/// The one-parameter diagrams of an oscillator with these two parameters.
fn diagrams(file: &Section<'_>, axes: [&Axis; 2]) -> Result<Vec<OneParameter>, SourceError> {
    let asked = if file.has("diagrams") { file.tables("diagrams")? } else { Vec::new() };
    if asked.len() > MOST_DIAGRAMS {
        return Err(file.refusal("diagrams"));
    }
    asked.iter().map(|section| diagram(section, axes)).collect()
}

fn diagram(section: &Section<'_>, [primary, secondary]: [&Axis; 2]) -> Result<OneParameter, SourceError> {
    let fixed: String = section.value("fixed")?;
    let primary_is_fixed = fixed == primary.name;
    let (held, other) = if primary_is_fixed { (primary, secondary) } else { (secondary, primary) };
    if fixed != held.name {
        let allowed =
            format!("the parameters are {} and {}: one of these is held", primary.name, secondary.name);
        return Err(section.forbid("fixed", allowed));
    }
    let inside = |axis: &Axis, value: f64| axis.range[0] <= value && value <= axis.range[1];
    let outside = |name: &str, axis: &Axis, [lower, upper]: [f64; 2]| {
        let allowed =
            format!("the range of {} is [{lower:?}, {upper:?}]: stay inside, or widen that", axis.name);
        section.forbid(name, allowed)
    };
    let at = section.number("at", |_| true)?;
    if !inside(held, at) {
        return Err(outside("at", held, held.range));
    }
    let range = if section.has("range") { self::range(section)? } else { other.range };
    if !range.iter().all(|end| inside(other, *end)) {
        return Err(outside("range", other, other.range));
    }
    let mut portraits: Vec<f64> = section.optional("portraits")?.unwrap_or_default();
    portraits.sort_by(f64::total_cmp);
    let twice = portraits.windows(2).any(|pair| pair[0] == pair[1]);
    if portraits.len() > MOST_PORTRAITS || twice || !portraits.iter().all(|value| value.is_finite()) {
        return Err(section.refusal("portraits"));
    }
    if !portraits.iter().all(|value| range[0] <= *value && *value <= range[1]) {
        return Err(outside("portraits", other, range));
    }
    let seed = section.optional::<u64>("seed")?.unwrap_or(1);
    Ok(OneParameter { primary_is_fixed, at, range, portraits, seed })
}

fn axis(section: &Section<'_>) -> Result<Axis, SourceError> {
    Ok(Axis { name: section.value("name")?, range: range(section)?, unit: unit(section, "unit")? })
}

fn range(section: &Section<'_>) -> Result<[f64; 2], SourceError> {
    let range: Vec<f64> = section.value("range")?;
    let [lower, upper] = range[..] else { return Err(section.refusal("range")) };
    if !(lower.is_finite() && upper.is_finite() && lower != upper) {
        return Err(section.refusal("range"));
    }
    if lower > upper {
        let allowed = format!("the range is reversed: write [{upper:?}, {lower:?}]");
        return Err(section.forbid("range", allowed));
    }
    if (upper - lower).is_infinite() {
        let allowed = "the range is too wide to be computed with: upper - lower must be a finite number";
        return Err(section.forbid("range", allowed.to_owned()));
    }
    Ok([lower, upper])
}

/// The name of a unit, if there is one.
fn unit(section: &Section<'_>, name: &str) -> Result<Option<String>, SourceError> {
    let Some(unit) = section.optional::<String>(name)? else { return Ok(None) };
    // Those that the fonts of the figures have.
    let greek = |character: char| ('α'..='ω').contains(&character) || ('Α'..='Ω').contains(&character);
    let shown = |character: char| {
        character.is_ascii_alphanumeric() || greek(character) || " /^*-.()°µ%·²³⁻¹".contains(character)
    };
    let right = !unit.trim().is_empty() && unit.chars().count() <= LONGEST_UNIT && unit.chars().all(shown);
    if right { Ok(Some(unit.trim().to_owned())) } else { Err(section.refusal(name)) }
}
