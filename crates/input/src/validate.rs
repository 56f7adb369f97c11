//! From the file as written to a description for computation.

use core::f64::consts::TAU;
use std::sync::{Arc, OnceLock};

use grazing_model::smooth::Stop;
use grazing_results::plane::Property;

use crate::description::{
    Content, Description, Expressions, Formulas, OneParameterRequest, OwnCurve, Wall, WallView,
};
use crate::document::{Keys, Section, SourceError};
use crate::error::{DescriptionError, KeyPlace};
use crate::expression::{Expression, ExpressionError, from_the_wall, parse_with_uses};
use crate::file::{
    Axis, File, WallSide, WrittenCurve, WrittenDiagram, WrittenImpact, WrittenStop, WrittenWall,
};
use crate::names;

/// The largest number of constants; every name in an expression is looked up among them.
const MOST_CONSTANTS: usize = 1000;
/// Places, as fractions of the ranges, at which the harmonics of a force are counted.
const HARMONICS_SEEN_AT: [[f64; 2]; 3] = [[0.381, 0.627], [0.873, 0.214], [0.559, 0.918]];

/// The key of an expression, the variables that it may use besides the parameters, and the number
/// of these, the first ones, that move while the others are held.
type Kind = (&'static str, &'static [&'static str], usize);

const FORCE: Kind = ("motion.force", &["x", "v", "t"], 2);
const POSITION: Kind = ("wall.position", &["t"], 0);
const FREQUENCY: Kind = ("motion.frequency", &[], 0);
const RESTITUTION: Kind = ("impact.restitution", &["y", "z"], 2);
const MASS: Kind = ("impact.mass", &[], 0);
const DURATION: Kind = ("impact.duration", &["y", "z"], 2);

/// The names of the parameters, the constants, and the flag that cancels the reading.
struct Known<'a>([&'a str; 2], Vec<(&'a str, f64)>, &'a Stop);

impl<'a> Known<'a> {
    fn new(file: &'a File, stop: &'a Stop) -> Self {
        let constants = file.parameters.iter().map(|(name, value)| (name.as_str(), *value)).collect();
        Self([&file.primary, &file.secondary].map(Axis::name), constants, stop)
    }

    /// The expression, and the numbers of the variables in it, the last two of which are the
    /// parameters.
    fn parse(&self, text: &str, (_, own, moving): Kind) -> Result<(Expression, Vec<usize>), ExpressionError> {
        parse_with_uses(text, &[own, &self.0].concat(), moving, &self.1, self.2)
    }
}

/// The formulas of an oscillator with the parameters and constants of a file, and the number of harmonics if
/// motion is known in closed form.
pub(crate) fn formulas(
    texts: &Expressions<String>,
    side: WallSide,
    file: &File,
    stop: &Stop,
) -> Result<(Formulas, Option<u32>), ExpressionError> {
    let known = Known::new(file, stop);
    let parse = |text, kind| Ok(known.parse(text, kind)?.0);
    let names = ["x", "v", "t", known.0[0], known.0[1]];
    let [force, x, v] = from_the_wall(&texts.force, &texts.wall, side.sign(), &names, &known.1, stop)?;
    let frequency = parse(&texts.frequency, FREQUENCY)?;
    let inside = |share: f64, axis: &Axis| axis.range[0] + share * (axis.range[1] - axis.range[0]);
    let places = HARMONICS_SEEN_AT.map(|[mu, eta]| [inside(mu, &file.primary), inside(eta, &file.secondary)]);
    let harmonics = force.harmonics(&frequency, &places);
    let formulas = Formulas {
        force,
        wall: Wall { side, outside: [x, v] },
        frequency,
        restitution: parse(&texts.restitution, RESTITUTION)?,
        duration: parse(&texts.duration, DURATION)?,
    };
    Ok((formulas, harmonics))
}

/// The mass that hits the wall, if the file has one.
pub(crate) fn mass(
    text: Option<&String>,
    file: &File,
    stop: &Stop,
) -> Result<Option<Expression>, ExpressionError> {
    let known = Known::new(file, stop);
    text.map(|text| Ok(known.parse(text, MASS)?.0)).transpose()
}

/// A wall as written, with the keys of its expressions: position, restitution, duration, mass.
struct Written {
    position: Option<String>,
    side: Option<WallSide>,
    impact: [(Option<String>, String); 3],
    key: String,
}

/// The walls of a file: one, or two in their order.
fn walls(section: &Section<'_>, file: &File) -> Result<Vec<Written>, SourceError> {
    let common = |name: &str| {
        let of = |impact: &WrittenImpact| match name {
            "restitution" => impact.restitution.clone(),
            "duration" => impact.duration.clone(),
            _ => impact.mass.clone(),
        };
        (file.impact.as_ref().and_then(of), format!("impact.{name}"))
    };
    let names = ["restitution", "duration", "mass"];
    let mut walls: Vec<Written> = Vec::new();
    for (number, WrittenStop { position, side, restitution, duration, mass }) in (1..).zip(&file.walls) {
        let own = [restitution, duration, mass].into_iter().zip(names);
        let own = own.map(|(text, name)| match text {
            Some(text) => (Some(text.clone()), format!("walls[{number}].{name}")),
            None => common(name),
        });
        let impact: Vec<_> = own.collect();
        let impact = impact.try_into().expect("there are three");
        let key = format!("walls[{number}].position");
        walls.push(Written { position: Some(position.clone()), side: *side, impact, key });
    }
    if file.wall.is_some() && !walls.is_empty() {
        let allowed = "there are both [wall] and [[walls]]: one wall is a table [wall], two walls are two tables [[walls]]";
        return Err(section.forbid("walls", allowed.to_owned()));
    }
    if walls.is_empty() {
        let (position, side, key) = match &file.wall {
            Some(WrittenWall { position, side }) => (Some(position.clone()), *side, POSITION.0),
            // The place of the wall's expression is that of the force.
            None => (None, WallSide::Below, FORCE.0),
        };
        let impact = names.map(common);
        walls.push(Written { position, side: Some(side), impact, key: key.to_owned() });
    }
    for (text, key) in walls.iter().flat_map(|wall| &wall.impact[..2]) {
        if text.is_none() {
            let name = key.trim_start_matches("impact.");
            return Err(match file.impact {
                Some(_) => section.table("impact")?.lack(name),
                None => section.lack("impact"),
            });
        }
    }
    Ok(walls)
}

/// The sides of two walls on which the motion is: between them.
fn sides(section: &Section<'_>, walls: &[Written], positions: &[f64]) -> Result<Vec<WallSide>, SourceError> {
    let written: Vec<Option<WallSide>> = walls.iter().map(|wall| wall.side).collect();
    let [first, second] = written[..] else { return Ok(vec![written[0].unwrap_or(WallSide::Below)]) };
    let first = match (first, second) {
        (Some(first), Some(second)) if first == second => {
            let allowed = "the motion is between two walls: below one of them and above the other".to_owned();
            return Err(section.forbid("walls[2].side", allowed));
        }
        (Some(first), _) => first,
        (None, Some(second)) => second.opposite(),
        (None, None) if positions[0] > positions[1] => WallSide::Below,
        (None, None) => WallSide::Above,
    };
    Ok(vec![first, first.opposite()])
}

/// Checks everything that can be checked without evaluating an expression; returns some error once
/// the computation is cancelled. If the file has no wall, the place of the wall's expression is
/// that of the force.
pub(crate) fn description(section: &Section<'_>, stop: &Stop) -> Result<Description, DescriptionError> {
    let mut file = File::read(section)?;
    names::check(section, &file)?;
    check_number(section, &file)?;
    file.parameters.sort_by(|(a, _), (b, _)| a.cmp(b));
    let axes = [&file.primary, &file.secondary];
    let known = Known::new(&file, stop);
    let mut used = [false; 2];
    let mut forced = false;
    let mut checked = |text: &String, kind: Kind, key: &str| {
        let (_, uses) = known
            .parse(text, kind)
            .map_err(|error| DescriptionError::in_expression(section, key, text, &error))?;
        for (used, place) in used.iter_mut().zip(kind.1.len()..) {
            *used |= uses.contains(&place);
        }
        let of_phase = |(place, own): (usize, &&str)| ["t", "z"].contains(own) && uses.contains(&place);
        forced |= kind.1.iter().enumerate().any(of_phase);
        Ok::<_, DescriptionError>((text.clone(), KeyPlace::new(section, key)))
    };
    let middle = axes.map(|axis| axis.range[0] + 0.5 * (axis.range[1] - axis.range[0]));
    let written = walls(section, &file)?;
    let mut seen = Vec::new();
    let mut positions = Vec::new();
    for wall in &written {
        let text = |text: &Option<String>| text.clone().unwrap_or_else(|| "0".to_owned());
        let [restitution, duration, _] = &wall.impact;
        let position = match &wall.position {
            Some(position) => checked(position, POSITION, &wall.key)?,
            None => ("0".to_owned(), KeyPlace::new(section, FORCE.0)),
        };
        positions.push(
            known
                .parse(&position.0, POSITION)
                .map_or(f64::NAN, |(position, _)| position.evaluate(&[0.0, middle[0], middle[1]])),
        );
        let checked = Expressions {
            wall: position,
            force: checked(&file.motion.force, FORCE, FORCE.0)?,
            frequency: checked(&file.motion.frequency, FREQUENCY, FREQUENCY.0)?,
            restitution: checked(&text(&restitution.0), RESTITUTION, &restitution.1)?,
            duration: checked(&text(&duration.0), DURATION, &duration.1)?,
        };
        seen.push((checked, wall));
    }
    if written.len() == 2 {
        if file.analysis.generations > 1 {
            let allowed = "solutions with several impacts are sought at one wall alone: with two [[walls]] leave generations out, \
                           and simulated motion shows them (--at, [[diagrams]])";
            return Err(section.forbid("analysis.generations", allowed.to_owned()).into());
        }
        if !file.curves.is_empty() {
            let allowed = "own curves are for one wall: with two [[walls]] leave them out";
            return Err(section.forbid("curves", allowed.to_owned()).into());
        }
    }
    let sides = sides(section, &written, &positions)?;
    let mut stops = Vec::new();
    for ((checked, wall), side) in seen.into_iter().zip(sides) {
        let (texts, places) =
            (checked.map(|(text, _)| text.clone()), checked.map(|(_, place)| place.clone()));
        // Each text is correct by itself.
        let (formulas, harmonics) = formulas(&texts, side, &file, stop).map_err(|error| {
            DescriptionError::Value { place: places.wall.clone(), problem: error.problem }
        })?;
        let (mass_text, key) = wall.impact[2].clone();
        let mass = mass(mass_text.as_ref(), &file, stop).map_err(|error| {
            DescriptionError::in_expression(section, &key, mass_text.as_deref().unwrap_or_default(), &error)
        })?;
        if let Some(mass) = &mass {
            let positive = |mu: f64| axes[1].range.iter().all(|eta| mass.evaluate(&[mu, *eta]) > 0.0);
            if !axes[0].range.iter().all(|mu| positive(*mu)) {
                return Err(section.forbid(&key, "it must be positive over the ranges".to_owned()).into());
            }
        }
        stops.push(WallView { texts, places, side, mass_text, formulas, mass, harmonics });
    }
    if !forced {
        let places = &stops[0].places;
        let problem = "nothing depends on the time t: only forced oscillators are analysed, in which the force or the wall recurs \
                       with the frequency of motion.frequency, as with A*cos(omega*t) in the force; self-excited motion has no \
                       phase";
        return Err(DescriptionError::Value { place: places.force.clone(), problem: problem.to_owned() });
    }
    for ((used, key), axis) in used.into_iter().zip(["primary.name", "secondary.name"]).zip(axes) {
        if !used {
            let allowed = format!(
                "{} appears in none of the expressions, so nothing depends on this parameter: use it in an expression, or name \
                 another parameter",
                axis.name
            );
            return Err(section.forbid(key, allowed).into());
        }
    }
    let wall = &stops[0].formulas.wall;
    let start = file.analysis.start.map(|start| wall.inside(start, 0.0, middle));
    let diagram = |(written, number): (&WrittenDiagram, u32)| {
        diagram(written, axes, |name, allowed| section.forbid(&format!("diagrams[{number}].{name}"), allowed))
    };
    let diagrams = file.diagrams.iter().zip(1..).map(diagram).collect::<Result<_, _>>()?;
    let without_mass = |(written, _): &(&WrittenDiagram, u32)| {
        written.ordinate.needs_mass() && stops.iter().any(|seen| seen.mass.is_none())
    };
    if let Some((_, number)) = file.diagrams.iter().zip(1..).find(without_mass) {
        let allowed = "it needs the mass that hits the wall: write impact.mass, as mass = \"0.5\"".to_owned();
        return Err(section.forbid(&format!("diagrams[{number}].ordinate"), allowed).into());
    }
    let curve = |(written, number): (&WrittenCurve, usize)| {
        let forbid = |name: &str, allowed| section.forbid(&format!("curves[{number}].{name}"), allowed);
        if file.curves[..number - 1].iter().any(|other| other.name == written.name) {
            return Err(forbid(
                "name",
                "another curve has this name: give each curve its own name".to_owned(),
            ));
        }
        own_curve(written, &file.analysis.loops, forbid)
    };
    let curves = file.curves.iter().zip(1..).map(curve).collect::<Result<_, _>>()?;
    let (notes, units) = (Vec::new(), OnceLock::new());
    let content = Content { file, stops, start, curves, diagrams, notes, units };
    Ok(Description(Arc::new(content), 0))
}

/// Rejects too many constants.
fn check_number(section: &Section<'_>, file: &File) -> Result<(), SourceError> {
    let count = file.parameters.len();
    match file.parameters.last() {
        Some((last, _)) if count > MOST_CONSTANTS => {
            let allowed = format!("this is constant number {count}: at most {MOST_CONSTANTS} are allowed");
            Err(section.table("parameters")?.forbid(last, allowed))
        }
        _ => Ok(()),
    }
}

fn own_curve(
    written: &WrittenCurve,
    analysed: &[u32],
    forbid: impl Fn(&str, String) -> SourceError,
) -> Result<OwnCurve, SourceError> {
    let WrittenCurve { name, impact_velocity, modulus, distance, phase, loops } = written.clone();
    let property = match (impact_velocity, modulus, distance, phase) {
        (Some(velocity), None, None, None) => Property::ImpactVelocity(velocity),
        (None, Some(modulus), None, None) => Property::Modulus(modulus),
        (None, None, Some(distance), Some(phase)) => Property::Distance { phase: TAU * phase, distance },
        (None, None, Some(_), None) => {
            return Err(forbid(
                "distance",
                "give the phase as well, in forcing periods, such as phase = 0.25".to_owned(),
            ));
        }
        (.., Some(_)) => return Err(forbid("phase", "it is given only together with distance".to_owned())),
        _ => {
            let allowed =
                "write one of impact_velocity, modulus, and distance with phase, no more and no less";
            return Err(forbid("name", allowed.to_owned()));
        }
    };
    let loops = loops.unwrap_or_else(|| analysed.to_vec());
    if let Some(other) = loops.iter().find(|loops| !analysed.contains(loops)) {
        let allowed = format!("{other} is not in analysis.loops: add it there or leave it out here");
        return Err(forbid("loops", allowed));
    }
    Ok(OwnCurve { name: name.trim().to_owned(), loops, property })
}

fn diagram(
    written: &WrittenDiagram,
    [primary, secondary]: [&Axis; 2],
    forbid: impl Fn(&str, String) -> SourceError,
) -> Result<OneParameterRequest, SourceError> {
    let WrittenDiagram { fixed, at, range, portraits, seed, ordinate, sweeps, impacts } = written.clone();
    let primary_is_fixed = fixed == primary.name;
    let (held, other) = if primary_is_fixed { (primary, secondary) } else { (secondary, primary) };
    if fixed != held.name {
        let allowed =
            format!("the parameters are {} and {}: one of them is fixed", primary.name, secondary.name);
        return Err(forbid("fixed", allowed));
    }
    let range = range.unwrap_or(other.range);
    for (name, values, axis, [lower, upper]) in [
        ("at", &[at][..], held, held.range),
        ("range", &range, other, other.range),
        ("portraits", &portraits, other, range),
    ] {
        if !values.iter().all(|value| lower <= *value && *value <= upper) {
            let allowed =
                format!("the range of {} is [{lower:?}, {upper:?}]: stay inside it or widen it", axis.name);
            return Err(forbid(name, allowed));
        }
    }
    Ok(OneParameterRequest { primary_is_fixed, at, range, portraits, seed, ordinate, sweeps, impacts })
}
