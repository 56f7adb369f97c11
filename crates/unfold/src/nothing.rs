//! Reasons why there is nothing to unfold, and remedies, with the parameters' own names.

use core::f64::consts::TAU;
use core::fmt::{self, Display, Formatter};

use crate::UnfoldError;
use crate::escape::Escape;
use crate::non_impacting::{Height, rest_positions};
use grazing_input::{Axis, Description};
use grazing_model::smooth::{SmoothOscillator, Stop};
use grazing_results::brief;

/// The reason why there is nothing to unfold.
#[derive(Clone, Debug)]
pub struct Nothing {
    /// That there is no grazing; empty where `found` says so itself.
    pub missing: &'static str,
    /// What was found instead of grazing.
    pub found: String,
    /// Free and forced frequencies, and whether they are meant, as a question; empty where the reason is another.
    pub question: String,
    /// The remedy; empty if there is none.
    pub remedy: String,
}

impl Display for Nothing {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        let Self { question, remedy, .. } = self;
        let found = self.sentence();
        match (question.is_empty(), remedy.is_empty()) {
            (_, true) => formatter.write_str(&found),
            (true, _) => write!(formatter, "{found}: {remedy}"),
            (false, _) => write!(formatter, "{found}. {question} If so, {remedy}"),
        }
    }
}

impl Nothing {
    fn plain(found: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self { missing: "", found: found.into(), question: String::new(), remedy: remedy.into() }
    }

    /// What was found, as a sentence that says that there is no grazing.
    pub fn sentence(&self) -> String {
        let Self { missing, found, .. } = self;
        if missing.is_empty() { found.clone() } else { format!("{missing}: {found}") }
    }

    /// The reason in words, for an error in the units of the file.
    pub fn new(error: &UnfoldError, description: &Description) -> Self {
        let at = |parameters| place(description, parameters);
        let axes = [description.primary(), description.secondary()];
        let ranges = axes.map(|axis| format!("{} = {}", axis.name(), written(axis.range()))).join(", ");
        let units = description.units();
        match error {
            UnfoldError::Stopped { stage } => Self::plain("cancelled at this stage", *stage),
            UnfoldError::NoGrazing { .. } | UnfoldError::Pushed { .. } if !moves(description) => {
                let [primary, secondary] = axes.map(Axis::name);
                let found = format!(
                    "motion without the wall does not depend on {primary}, which appears only in the impact, so it reaches the wall at \
                     the same values of {secondary} for every {primary}"
                );
                let remedy = format!(
                    "let primary.name be a parameter of motion.force, motion.frequency or wall.position, and make {primary} the \
                     secondary parameter or a constant"
                );
                Self { missing: "no grazing curve", ..Self::plain(found, remedy) }
            }
            UnfoldError::NoGrazing { lowest, highest, whole } => {
                let nearest = if highest.position < 0.0 { highest } else { lowest };
                let found = no_grazing([lowest, highest, nearest], *whole, (&ranges, axes), description);
                Self { question: question(description, nearest.parameters), ..found }
            }
            UnfoldError::Pushed { at: height } => {
                let place = at(height.parameters);
                let (missing, found, remedy) = if height.acceleration > -TURNED * units.acceleration() {
                    let pushed = height.acceleration < TURNED * units.acceleration();
                    let force = brief(if pushed { 0.0 } else { height.acceleration }, 4);
                    let side = description.wall().side().name();
                    (
                        "no grazing",
                        format!(
                            "at {place} periodic motion reaches the wall with F = {force}, so it rests at the wall or is \
                             pushed against it instead of turning back; where the motion grazes, the force must point away from the wall"
                        ),
                        format!(
                            "check the signs in motion.force (motion takes place {side} the wall), or exclude these parameters from the \
                             ranges"
                        ),
                    )
                } else {
                    let [distance, force] =
                        [height.position.abs(), height.acceleration].map(|value| brief(value, 4));
                    (
                        "no grazing was located",
                        format!(
                            "at {place} periodic motion comes within {distance} of the wall, with F = {force}, but \
                             no regular grazing orbit was found there"
                        ),
                        "move or narrow the ranges".to_owned(),
                    )
                };
                Self { missing, found, question: question(description, height.parameters), remedy }
            }
            UnfoldError::RunsAway { .. } | UnfoldError::NoOrbit if !has_spring(description) => Self::plain(
                "no periodic motion: motion.force does not depend on the position x, so nothing holds the oscillator near the wall. \
                 Grazing here means grazing of a periodic motion without impacts; a ball that bounces on the wall has no such motion, \
                 so this analysis does not apply to it",
                "",
            ),
            UnfoldError::RunsAway { escape } => escaped(escape, &at(escape.parameters), description),
            UnfoldError::NoOrbit => Self::plain(
                format!(
                    "no periodic motion with the period of the forcing was found without the wall for {ranges}: motion does not settle \
                     from any start that was tried"
                ),
                "start near such a motion with analysis.start = [x, v], move the ranges, or increase the damping",
            ),
        }
    }
}

/// What was found of motion that does not graze, and the remedy.
fn no_grazing(
    [lowest, highest, nearest]: [&Height; 3],
    whole: bool,
    (ranges, axes): (&str, [&Axis; 2]),
    description: &Description,
) -> Nothing {
    let at = |height: &Height| place(description, height.parameters);
    if lowest.position < 0.0 && highest.position > 0.0 {
        let found = format!(
            "no grazing was found for {ranges}, although periodic motion without the wall stays clear of it at {} and crosses it at {}",
            at(lowest),
            at(highest)
        );
        let remedy =
            "narrow the ranges to where it just reaches the wall, or start near it with analysis.start";
        return Nothing::plain(found, remedy);
    }
    let push = mean_force_at_wall(description, nearest.parameters);
    let rest = rest(description, nearest.parameters);
    if lowest.position > 0.0 && push > 0.0 && rest.is_none() {
        let found = format!(
            "periodic motion without the wall crosses it everywhere in {ranges}, because the oscillator's rest position lies \
             behind the wall: at {} it is pushed into the wall, with F = {} on average over a forcing period. Motion takes place {} the \
             wall",
            at(nearest),
            brief(push, 4),
            description.wall().side().name()
        );
        let remedy = "change wall.side or wall.position, or the signs in motion.force";
        return Nothing { missing: "no grazing", ..Nothing::plain(found, remedy) };
    }
    let distance = brief(nearest.position.abs(), 4);
    let (does, there) = match (highest.position < 0.0, rest) {
        (true, Some(rest)) => {
            let share = brief(100.0 * (1.0 - nearest.position / rest).max(0.0), 2);
            (
                "stays clear of it",
                format!("stays {distance} away from it, having come {share} % of the way from rest"),
            )
        }
        (true, None) => ("stays clear of it", format!("stays {distance} away from it")),
        (false, _) => ("crosses it", format!("goes {distance} beyond it")),
    };
    let start = "if there is another periodic motion, start near it with analysis.start = [x, v]";
    if whole {
        let found = format!(
            "periodic motion without the wall {does} everywhere in {ranges}; it is nearest to grazing at {}, where it {there}",
            at(nearest)
        );
        let remedy = format!("{}, or, {start}", widening(nearest, axes));
        return Nothing { missing: "no grazing", ..Nothing::plain(found, remedy) };
    }
    let found = format!(
        "no grazing was found for {ranges}: periodic motion without the wall {does} as far as it could be followed, but it could not be \
         followed through the whole range of {}; it is nearest to grazing at {}, where it {there}",
        axes[0].name(),
        at(nearest)
    );
    let remedy =
        format!("narrow the ranges, keep the motion away from poles, roots and logarithms, or, {start}");
    Nothing::plain(found, remedy)
}

/// The rest position nearest to the wall in front of it, seen from the wall.
fn rest(description: &Description, parameters: [f64; 2]) -> Option<f64> {
    let units = description.units();
    let place = units.without_dimensions(parameters);
    let found = rest_positions(&description.counted(place, &units, &Stop::default()));
    found.first().map(|position| position * units.length)
}

/// The natural frequency of small motion about rest, or at the wall where there is none in front of it, beside the
/// frequencies of the forcing; and whether they are meant.
fn question(description: &Description, parameters: [f64; 2]) -> String {
    let natural = description.natural_frequency(rest(description, parameters).unwrap_or(0.0), parameters);
    let [_, time, _] = description.unit_names();
    let (scale, unit, end) = match time {
        Some("s") => (TAU, " Hz".to_owned(), ""),
        Some("ms") => (TAU, " kHz".to_owned(), ""),
        Some(time) => (1.0, format!(" rad/{time}"), ""),
        None => (1.0, String::new(), ", in radians per unit of time"),
    };
    let of = |frequency: f64| brief(frequency / scale, 3);
    let free = match natural > 0.0 {
        true => format!("Free motion there has a frequency of {}{unit}, and the forcing", of(natural)),
        false => {
            "Nothing drives the oscillator back to rest there, and the forcing has a frequency of".to_owned()
        }
    };
    let [low, high] = description.forcing_frequencies().map(of);
    format!(
        "{free} {low} to {high}{unit}{end}: is that meant, and is everything in coherent units (kg with N and m, not g \
         or mm)?"
    )
}

/// The distance beyond which a motion has run away, in the oscillator's units.
const FAR: f64 = 1e3;
/// The force near the wall beyond which motion is on its way to a pole, in the oscillator's units.
const STEEP: f64 = 1e6;

/// The end of a motion in words, and the remedy.
fn escaped(escape: &Escape, parameters: &str, description: &Description) -> Nothing {
    let Escape { time, position, velocity, force, .. } = *escape;
    let units = description.units();
    let [x, v] = description.wall().outside([position, velocity], time, escape.parameters);
    let [t, x, v] = [time, x, v].map(|value| brief(value, 6));
    let place = format!("x = {x}, v = {v}, t = {t} at {parameters}");
    if !force.is_finite() {
        return Nothing::plain(
            format!(
                "no periodic motion: without the wall, motion reaches a point where motion.force has no finite value: it is {force} \
                 near {place}"
            ),
            "keep the motion away from poles, roots and logarithms, or start near a periodic motion with analysis.start = [x, v]",
        );
    }
    let way = if position.abs() > FAR * units.length {
        // The distance that was reached depends on the steps of the integration; the time of escape
        // hardly does.
        let (side, t) = (if position > 0.0 { "behind" } else { "away from" }, brief(time, 3));
        format!(
            "motion diverges from every start: for example {side} the wall within t = {t} at {parameters}"
        )
    } else {
        let pole = if force.abs() > STEEP * units.acceleration() { ", as at a pole" } else { "" };
        format!(
            "motion cannot be followed for a forcing period from any start: for example not beyond {place}, where F = {}{pole}",
            brief(force, 4)
        )
    };
    Nothing::plain(
        format!("no periodic motion: without the wall, {way}"),
        "check the signs and sizes in motion.force, or start near a periodic motion with analysis.start = [x, v]",
    )
}

/// The number of instants of a forcing period at which the force is evaluated.
const INSTANTS: u32 = 16;

/// Equidistant instants of a forcing period.
fn instants(description: &Description, [mu, eta]: [f64; 2]) -> impl Iterator<Item = f64> {
    let period = TAU / description.forcing_frequency(mu, eta);
    (0..INSTANTS).map(move |k| period * f64::from(k) / f64::from(INSTANTS))
}

/// The force at the wall, at rest, averaged over a forcing period.
fn mean_force_at_wall(description: &Description, [mu, eta]: [f64; 2]) -> f64 {
    let force = |t| description.force(0.0, 0.0, t, mu, eta);
    instants(description, [mu, eta]).map(force).sum::<f64>() / f64::from(INSTANTS)
}

/// Whether the force, or its frequency, depends on the primary parameter anywhere near the wall.
fn moves(description: &Description) -> bool {
    let [primary, secondary] = [description.primary(), description.secondary()].map(Axis::range);
    let units = description.units();
    // In the middle of the range and at irregular places of it: a force may be periodic.
    let of_range = |[low, high]: [f64; 2], share: f64| low + share * (high - low);
    let eta = of_range(secondary, 0.5);
    let [mu, others @ ..] = [0.5, 0.0, 0.37, 0.83, 1.0].map(|share| [of_range(primary, share), eta]);
    let frequency = |[mu, eta]: [f64; 2]| description.forcing_frequency(mu, eta);
    let force = |[mu, eta]: [f64; 2], t: f64, x: f64, v: f64| {
        description.force(x * units.length, v * units.velocity(), t, mu, eta)
    };
    others.into_iter().any(|other| {
        frequency(mu) != frequency(other)
            || instants(description, mu).any(|t| {
                [-1.0, -0.37, 0.0]
                    .iter()
                    .any(|&x| [0.3, 0.0, -0.3].iter().any(|&v| force(mu, t, x, v) != force(other, t, x, v)))
            })
    })
}

/// Whether the force depends on the position.
fn has_spring(description: &Description) -> bool {
    let [mu, eta] = [description.primary(), description.secondary()].map(|axis| {
        let [low, high] = axis.range();
        low + 0.5 * (high - low)
    });
    let units = description.units();
    // At a single velocity the dependence on position may be lost in rounding, or the force may
    // have no value.
    let differs = |t: f64, v: f64| {
        let force = |x: f64| description.force(x * units.length, v * units.velocity(), t, mu, eta);
        [-1.0, -0.37, -30.0].iter().any(|x| force(*x) != force(0.0))
    };
    instants(description, [mu, eta]).any(|t| [0.3, 0.0, -0.3].iter().any(|v| differs(t, *v)))
}

/// Values of both parameters, as `A = 0.5, omega = 0.8`.
pub fn place(description: &Description, parameters: [f64; 2]) -> String {
    let value = |(axis, value): (&Axis, f64)| {
        let [low, high] = axis.range();
        // What is nothing but rounding beside the range is zero.
        let value = if value.abs() < ROUNDING * (high - low) { 0.0 } else { value };
        format!("{} = {}", axis.name(), brief(value, 6))
    };
    let [primary, secondary] = parameters;
    let [first, second] = [(description.primary(), primary), (description.secondary(), secondary)].map(value);
    format!("{first}, {second}")
}

/// The share of a range below which a parameter is zero but for rounding.
const ROUNDING: f64 = 1e-12;

/// The deceleration below which there is none but for rounding, in the oscillator's units.
const TURNED: f64 = 1e-9;

/// A range, with the digits in which its ends differ.
fn written([low, high]: [f64; 2]) -> String {
    let size = low.abs().max(high.abs()) / (high - low);
    let digits = (6..17).find(|digits| size < libm::pow(10.0, f64::from(*digits) - 3.0)).unwrap_or(17);
    format!("[{}, {}]", brief(low, digits as usize), brief(high, digits as usize))
}

/// The distance from an end of a range that counts as being there, as a share of the width.
const EDGE: f64 = 0.05;

/// The range to widen, and to which side.
fn widening(nearest: &Height, axes: [&Axis; 2]) -> String {
    let keys = ["primary.range", "secondary.range"];
    let sides: Vec<String> = (0..2)
        .filter_map(|index| {
            let [low, high] = axes[index].range();
            let share = (nearest.parameters[index] - low) / (high - low);
            let name = axes[index].name();
            let beyond = if share > 1.0 - EDGE {
                format!("above {}", brief(high, 6))
            } else if share < EDGE {
                format!("below {}", brief(low, 6))
            } else {
                return None;
            };
            Some(format!("{} ({name}) {beyond}", keys[index]))
        })
        .collect();
    let widen = if sides.is_empty() {
        format!("{} ({}) or {} ({})", keys[0], axes[0].name(), keys[1], axes[1].name())
    } else {
        sides.join(" or ")
    };
    format!("widen {widen}")
}
