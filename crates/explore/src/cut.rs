//! The one-parameter diagram along a line of the plane: its branches first, then what simulation
//! comes to.

use grazing_model::smooth::Stop;
use grazing_reproduction::one_parameter::SAMPLING;
use grazing_results::branches::{BranchPoint, OneParameter};
use grazing_unfold::one_parameter::{Cut, Line, Sampling};
use grazing_unfold::units::InUnits;
use serde::Deserialize;
use serde_json::{Value, json};

use crate::answer::Problem;
use crate::model::{Model, View};
use crate::stream::Events;

/// What is asked for.
#[derive(Deserialize)]
pub(crate) struct CutRequest {
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

/// The range of the parameter that is held, as a part of the file's: only its lower end is looked
/// at.
const HELD: f64 = 0.01;

pub(crate) fn compute(request: &CutRequest, events: &Events, stop: &Stop) -> Result<(), Problem> {
    let CutRequest { model, fixed, at, range } = request;
    // The parameter that is held needs a range, too: a small part of the file's.
    let own = model.description(None, stop)?;
    let primary_is_fixed = *fixed == Fixed::Primary;
    let axis = if primary_is_fixed { own.primary() } else { own.secondary() };
    let [low, high] = axis.range();
    let held = [*at, *at + HELD * (high - low)];
    let [primary, secondary] = if primary_is_fixed { [held, *range] } else { [*range, held] };
    let view = View { primary, secondary };
    let line = Line { diagram: 1, primary_is_fixed, at: *at, range: *range };
    let of = model.prepared(Some(&view), stop)?;
    // As in the diagrams that a file asks for, but fewer dots: it is to be looked at at once.
    let sampling = Sampling { recorded: 16, ..SAMPLING };
    let line = line.without_dimensions(&of.axes.units);
    let cut = Cut::follow(&of.oscillator, &of.scope, &[], line, events).ok_or_else(Problem::ended)?;
    events.send("branches", &event(&cut.diagram().in_units(&of.axes.units)));
    let found = cut.simulated(&sampling, &[], events).in_units(&of.axes.units);
    let dots: Vec<[f64; 2]> = found.attractor.iter().map(|dot| [found.across(dot), dot.x]).collect();
    events.send(
        "dots",
        &json!({"frame": found.frame.y, "dots": dots, "values": sampling.values, "resting": found.resting}),
    );
    Ok(())
}

/// Strands and the bifurcations on them.
fn event(found: &OneParameter) -> Value {
    let strand = |rows: &[BranchPoint]| {
        let point = |row: &BranchPoint| {
            json!([found.across(row), row.x, u8::from(row.stable), u8::from(row.admissible)])
        };
        json!({"p": rows[0].loops, "points": rows.iter().map(point).collect::<Vec<_>>()})
    };
    let bifurcations = found
        .bifurcations
        .iter()
        .map(|row| json!({"kind": row.kind.name(), "p": row.loops, "at": found.across(row), "x": row.x}));
    // A strand is broken where a visit is not known.
    let pieces = found.branches.chunk_by(|a, b| a.branch == b.branch && a.x.is_nan() == b.x.is_nan());
    json!({
        "frame": found.frame.y,
        "strands": pieces.filter(|rows| !rows[0].x.is_nan()).map(strand).collect::<Vec<_>>(),
        "bifurcations": bifurcations.collect::<Vec<_>>(),
    })
}
