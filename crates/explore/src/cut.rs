//! The one-parameter diagram along a line of the plane.

use std::collections::BTreeMap;

use grazing_reproduction::unfolded;
use grazing_unfold::one_parameter::{OneParameter, Plan, Wanted};
use grazing_unfold::stop::Stop;
use serde::Deserialize;
use serde_json::{Value, json};

use crate::answer::Problem;
use crate::model::{Model, View};

/// What is asked for.
#[derive(Deserialize)]
pub(crate) struct Asked {
    model: Model,
    fixed: Fixed,
    at: f64,
    range: [f64; 2],
}

/// The parameter that is held.
#[derive(Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Fixed {
    Primary,
    Secondary,
}

/// As in the diagrams that a file asks for, but fewer values: it is to be looked at at once.
const PLAN: Plan = Plan { values: 160, orbits: 2, transient: 150, recorded: 16, seed: 1 };

/// The range of the parameter that is held, as a part of the file's: only its lower end is looked at.
const HELD: f64 = 0.01;

pub(crate) fn compute(asked: &Asked, stop: &Stop) -> Result<Value, Problem> {
    let Asked { model, fixed, at, range } = asked;
    // The parameter that is held needs a range, too: a small part of the file's.
    let own = model.description(None)?;
    let axis = match fixed {
        Fixed::Primary => own.primary(),
        Fixed::Secondary => own.secondary(),
    };
    let [low, high] = axis.range();
    let held = [*at, *at + HELD * (high - low)];
    let view = match fixed {
        Fixed::Primary => View { primary: held, secondary: *range },
        Fixed::Secondary => View { primary: *range, secondary: held },
    };
    // Only the oscillator of a text has its parameters exchanged.
    let description = model.in_view(&view).map_err(Problem::wrong)?;
    let description = match fixed {
        Fixed::Primary => description.exchanged(),
        Fixed::Secondary => description,
    };
    let units = description.units();
    let (oscillator, scope) = unfolded::prepared(&description, &units, stop);
    let wanted = Wanted {
        secondary: at / units.secondary,
        range: range.map(|end| end / units.primary),
        portraits: Vec::new(),
        plan: PLAN,
    };
    let found = OneParameter::compute(&oscillator, &scope, &[], &wanted, stop).ok_or_else(Problem::ended)?;
    let place = |parameter: f64, x: f64| [parameter * units.primary, x * units.length];
    let strands: Vec<Value> = found
        .strands
        .iter()
        .map(|strand| {
            let points = strand.points.iter().map(|point| {
                let [parameter, x] = place(point.primary, point.x);
                json!([parameter, x, u8::from(point.stable), u8::from(point.admissible)])
            });
            json!({"p": strand.loops, "points": points.collect::<Vec<_>>()})
        })
        .collect();
    let bifurcations: Vec<Value> = found
        .bifurcations
        .iter()
        .map(|found| {
            let [parameter, x] = place(found.primary, found.x);
            json!({"kind": found.kind.name(), "p": found.loops, "at": parameter, "x": x})
        })
        .collect();
    let dots: Vec<[f64; 2]> = found.visits.iter().map(|[parameter, x]| place(*parameter, *x)).collect();
    let shown = found.strands.iter().flat_map(|strand| &strand.points).filter(|point| point.admissible);
    let heights = shown.map(|point| point.x * units.length).chain(dots.iter().map(|dot| dot[1]));
    let [low, high] = heights.fold([0.0, 0.0], |[low, high]: [f64; 2], x| [low.min(x), high.max(x)]);
    let room = 0.06 * if high > low { high - low } else { units.length };
    let frame = BTreeMap::from([("x", *range), ("y", [low - room, high + room])]);
    Ok(json!({"frame": frame, "strands": strands, "bifurcations": bifurcations, "dots": dots}))
}
