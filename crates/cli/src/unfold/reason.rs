//! Reasons why there is nothing to unfold, and remedies, with the parameters' own names.

use std::f64::consts::TAU;

use grazing_description::{Axis, Description};
use grazing_model::smooth::{SmoothOscillator, Stop, Units};
use grazing_results::brief;
use grazing_unfold::escape::Escape;
use grazing_unfold::non_impacting::{Height, rest_positions};
use grazing_unfold::regions::Region;
use grazing_unfold::unfinished::Unfinished;
use grazing_unfold::{Diagram, UnfoldError};

/// The reason in words: what was found instead of grazing, and the remedy.
pub(crate) fn of(error: &UnfoldError, description: &Description) -> String {
    let at = |parameters| place(description, parameters);
    let axes = [description.primary(), description.secondary()];
    let ranges = axes.map(|axis| format!("{} = {}", axis.name(), written(axis.range()))).join(", ");
    let units = description.units();
    match error {
        UnfoldError::Stopped { stage } => format!("cancelled at this stage: {stage}"),
        UnfoldError::NoGrazing { .. } | UnfoldError::Pushed { .. } if !moves(description) => format!(
            "no grazing curve: motion without the wall does not depend on {primary}, which appears only in the impact, so it reaches \
             the wall at the same values of {secondary} for every {primary}: let primary.name be a parameter of motion.force, \
             motion.frequency or wall.position, and make {primary} the secondary parameter or a constant",
            primary = axes[0].name(),
            secondary = axes[1].name(),
        ),
        UnfoldError::NoGrazing { lowest, highest, whole } => {
            let nearest = if highest.position < 0.0 { highest } else { lowest };
            if lowest.position < 0.0 && highest.position > 0.0 {
                return format!(
                    "no grazing was found for {ranges}, although periodic motion without the wall stays clear of it at {} and \
                     crosses it at {}: narrow the ranges to where it just reaches the wall, or start near it with analysis.start",
                    at(lowest.parameters),
                    at(highest.parameters)
                );
            }
            let push = mean_force_at_wall(description, nearest.parameters);
            if lowest.position > 0.0 && push > 0.0 && !rests_in_front(description, nearest.parameters) {
                return format!(
                    "no grazing: periodic motion without the wall crosses it everywhere in {ranges}, because the oscillator's rest \
                     position lies behind the wall: at {} it is pushed into the wall, with F = {} on average over a forcing period. Motion \
                     takes place {} the wall: change wall.side or wall.position, or the signs in motion.force",
                    at(nearest.parameters),
                    brief(push, 4),
                    description.wall().side().name()
                );
            }
            let distance = brief(nearest.position.abs(), 4);
            let (does, there) = match highest.position < 0.0 {
                true => ("stays clear of it", format!("stays {distance} away from it")),
                false => ("crosses it", format!("goes {distance} beyond it")),
            };
            let nearest_at = at(nearest.parameters);
            if !whole {
                return format!(
                    "no grazing was found for {ranges}: periodic motion without the wall {does} as far as it could be followed, but it could not \
                     be followed through the whole range of {}; it is nearest to grazing at {nearest_at}, where it {there}: narrow the ranges, \
                     keep the motion away from poles, roots and logarithms, or, if there is another periodic motion, start near it with \
                     analysis.start = [x, v]",
                    axes[0].name()
                );
            }
            format!(
                "no grazing: periodic motion without the wall {does} everywhere in {ranges}; it is nearest to grazing at {nearest_at}, where it \
                 {there}: {}",
                widening(nearest, axes)
            )
        }
        UnfoldError::Pushed { at: height } if height.acceleration > -TURNED * units.acceleration() => format!(
            "no grazing: at {} periodic motion reaches the wall with F = {}, so it rests at the wall or is pushed against \
             it instead of turning back; where the motion grazes, the force must point away from the wall: check the signs in motion.force \
             (motion takes place {} the wall), or exclude these parameters from the ranges",
            at(height.parameters),
            brief(if height.acceleration < TURNED * units.acceleration() { 0.0 } else { height.acceleration }, 4),
            description.wall().side().name()
        ),
        UnfoldError::Pushed { at: height } => format!(
            "no grazing was located: at {} periodic motion comes within {} of the wall, with F = {}, but no regular grazing orbit \
             was found there: move or narrow the ranges",
            at(height.parameters),
            brief(height.position.abs(), 4),
            brief(height.acceleration, 4)
        ),
        UnfoldError::RunsAway { .. } | UnfoldError::NoOrbit if !has_spring(description) => {
            "no periodic motion: motion.force does not depend on the position x, so nothing holds the oscillator near the wall. \
             Grazing here means grazing of a periodic motion without impacts; a ball that bounces on the wall has no such motion, so \
             this analysis does not apply to it"
                .to_owned()
        }
        UnfoldError::RunsAway { escape } => escaped(escape, &at(escape.parameters), description),
        UnfoldError::NoOrbit => format!(
            "no periodic motion with the period of the forcing was found without the wall for {ranges}: motion does not settle \
             from any start that was tried: start near such a motion with analysis.start = [x, v], move the ranges, \
             or increase the damping"
        ),
    }
}

/// The distance beyond which a motion has run away, in the oscillator's [`Units`].
const FAR: f64 = 1e3;
/// The force near the wall beyond which motion is on its way to a pole, in the oscillator's [`Units`].
const STEEP: f64 = 1e6;

/// The end of a motion in words, and the remedy.
fn escaped(escape: &Escape, parameters: &str, description: &Description) -> String {
    let Escape { time, position, velocity, force, .. } = *escape;
    let units = description.units();
    let [x, v] = description.wall().outside([position, velocity], time, escape.parameters);
    let [t, x, v] = [time, x, v].map(|value| brief(value, 6));
    let place = format!("x = {x}, v = {v}, t = {t} at {parameters}");
    if !force.is_finite() {
        return format!(
            "no periodic motion: without the wall, motion reaches a point where motion.force has no finite value: it is {force} near \
             {place}: keep the motion away from poles, roots and logarithms, or start near a periodic motion with \
             analysis.start = [x, v]"
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
    format!(
        "no periodic motion: without the wall, {way}: check the signs and sizes in motion.force, or start near a periodic motion \
         with analysis.start = [x, v]"
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

/// Whether the oscillator has a rest position in front of the wall.
fn rests_in_front(description: &Description, [mu, eta]: [f64; 2]) -> bool {
    let units = description.units();
    let place = units.without_dimensions([mu, eta]);
    !rest_positions(&description.counted(place, &units, &Stop::default())).is_empty()
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

/// Resonances that could not be located, or whose curves could not be followed: which, and why.
pub(crate) fn lost(
    description: &Description,
    units: &Units,
    diagram: &Diagram,
) -> impl Iterator<Item = (String, String)> {
    let unlocated = diagram.unlocated.iter().map(|lost| {
        let at = place(description, units.parameters(lost.near));
        (format!("p = {}", lost.loops), format!("near {at}: {}", lost.reason))
    });
    let not_unfolded = diagram.not_unfolded.iter().map(|lost| (lost.name(), lost.reason.to_string()));
    unlocated.chain(not_unfolded)
}

/// The unfinished work, as `bifurcation curves of p = 2, n = 1 at A = 0.5, omega = 0.8`.
pub(crate) fn unfinished(description: &Description, units: &Units, cut: &Unfinished) -> String {
    let mut text = cut.stage.to_string();
    if let Some([loops, n]) = cut.resonance {
        text.push_str(&format!(" of p = {loops}, n = {n}"));
    }
    if let Some(at) = cut.at {
        text.push_str(&format!(" at {}", place(description, units.parameters(at))));
    }
    text
}

/// The extent of a region in which stability is undecided, and the reason; none if it is decided.
pub(crate) fn undecided(description: &Description, units: &Units, region: &Region) -> Option<String> {
    let doubt = region.doubt.as_ref()?;
    let [from, to] = region.extent().map(|corner| place(description, units.parameters(corner)));
    Some(format!("from {from} to {to}: {doubt}"))
}

/// Regions that are too thin to be drawn, with their extent.
pub(crate) fn thin(description: &Description, units: &Units, diagram: &Diagram) -> Vec<(u32, String)> {
    let regions = diagram.regions.iter().filter(|region| region.is_thin(diagram.scope.window));
    let line = |region: &Region| {
        let [from, to] = region.extent().map(|corner| place(description, units.parameters(corner)));
        (region.loops, format!("from {from} to {to}"))
    };
    regions.map(line).collect()
}

/// Values of both parameters, as `A = 0.5, omega = 0.8`.
pub(crate) fn place(description: &Description, [primary, secondary]: [f64; 2]) -> String {
    let (first, second) = (description.primary().name(), description.secondary().name());
    format!("{first} = {}, {second} = {}", brief(primary, 6), brief(secondary, 6))
}

/// The deceleration below which there is none but for rounding, in the oscillator's [`Units`].
const TURNED: f64 = 1e-9;

fn written([low, high]: [f64; 2]) -> String {
    format!("[{}, {}]", brief(low, 6), brief(high, 6))
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
    format!(
        "widen {widen}, or, if there is another periodic motion, start near it with analysis.start = [x, v]"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An oscillator with this force and a wall at x = 0, in r and omega.
    fn file(force: &str, restitution: &str) -> Description {
        let text = format!(
            "parameters = {{}}\nprimary = {{ name = \"r\", range = [0.5, 0.9] }}\n\
             secondary = {{ name = \"omega\", range = [0.5, 0.95] }}\n\
             motion = {{ force = \"-0.06*v - x + {force}*cos(omega*t)\", frequency = \"omega\" }}\n\
             wall = {{ position = \"0\", side = \"below\" }}\n\
             impact = {{ restitution = \"{restitution}\", duration = \"0\" }}\n\
             analysis = {{ loops = [1] }}\nname = \"Test\"\n"
        );
        Description::parse(&text, "test.toml").unwrap()
    }

    fn no_grazing([lowest, highest]: [f64; 2]) -> UnfoldError {
        let height = |position| Height { position, parameters: [0.5, 0.75], acceleration: -1.0 };
        UnfoldError::NoGrazing { lowest: height(lowest), highest: height(highest), whole: true }
    }

    #[test]
    fn a_primary_parameter_of_the_impact_alone_is_named_as_the_reason() {
        let error = no_grazing([-0.3, 3.4]);
        let words = of(&error, &file("-1 + 0.5", "r"));
        assert!(words.contains("does not depend on r") && words.contains("let primary.name be"), "{words}");
        let words = of(&error, &file("-1 + r", "0.9"));
        assert!(words.contains("narrow the ranges"), "{words}");
    }

    #[test]
    fn rest_is_said_to_lie_behind_the_wall_only_where_none_lies_in_front() {
        let error = no_grazing([0.3, 3.4]);
        let behind = "rest position lies behind the wall";
        let words = of(&error, &file("1 + r", "0.9"));
        assert!(words.contains(behind), "{words}");
        // Attraction that exceeds the spring at the wall leaves the rest at x = -0.97 in place.
        let words = of(&error, &file("-1 + 3/(1 + ((x - 0.1)/0.1)^2) + r", "0.9"));
        assert!(!words.contains(behind) && words.contains("crosses it everywhere"), "{words}");
    }

    #[test]
    fn motion_that_ends_is_told_with_its_place_and_the_force() {
        let escape = |position, velocity, force| Escape {
            parameters: [0.5, 0.75],
            time: 1.5,
            position,
            velocity,
            force,
        };
        let paper =
            Description::parse(include_str!("../../../../examples/paper.toml"), "paper.toml").unwrap();
        let words = |escape| escaped(&escape, "A = 0.5, omega = 0.75", &paper);
        let away = words(escape(-2e9, -4e5, 1e3));
        assert!(
            away.contains("diverges") && away.contains("away from the wall within t = 1.5 at A = 0.5"),
            "{away}"
        );
        let pole = words(escape(-0.5, -7437.38, -1.5e8));
        assert!(pole.contains("not beyond x = -0.5") && pole.contains("F = -1.5e8, as at a pole"), "{pole}");
        let edge = words(escape(-0.9, -1.0, f64::NAN));
        assert!(
            edge.contains("no finite value: it is NaN near x = -0.9, v = -1, t = 1.5 at A = 0.5"),
            "{edge}"
        );
    }
}
