//! A place exactly on a curve of the diagram, and the solution there.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns};
use grazing_model::ImpactOscillator;
use grazing_model::smooth::Stop;
use grazing_theorems::from_map::GrazingPlace;
use grazing_unfold::described::Prepared;
use serde::Deserialize;

use crate::answer::{Problem, answers};
use crate::model::{Model, View};
use crate::place::{Eigenvalues, FARTHEST, eigenvalues};

/// The request for a place exactly on a curve.
#[derive(Deserialize)]
pub(crate) struct ExactRequest {
    model: Model,
    view: View,
    /// The name of the curve's kind, and its number of loops.
    kind: String,
    p: u32,
    /// The wall that sees it, from 1, if there are two.
    #[serde(default)]
    wall: u32,
    /// Approximate values of the first two unknowns there, nondimensional.
    start: [f64; 2],
    /// The approximate place, in the oscillator's units.
    at: [f64; 2],
}

answers! {
    /// A place on a curve, with the multipliers of the solution there, unless it is known by its grazing.
    ExactPlace { at: [f64; 2], multipliers: Option<Eigenvalues>, }
}

/// The greatest distance of the place from where it was looked for, as a share of the view.
const NEAR: f64 = 0.1;

pub(crate) fn compute(request: &ExactRequest, stop: &Stop) -> Result<ExactPlace, Problem> {
    let ExactRequest { model, view, kind, p, wall, start: [first, second], at } = request;
    let of = model.prepared(Some(view), stop)?;
    let [primary, secondary] = of.without_dimensions(*at);
    let Prepared { oscillator, scope, axes, .. } = of;
    let oscillator = match wall {
        2 => oscillator.other_stop().ok_or_else(|| Problem::wrong("there is no second wall"))?,
        _ => oscillator,
    };
    let units = axes.units;
    let unknown = || Problem::wrong(format!("{kind} is not a kind of curve with {p} loops"));
    let kind = Bifurcation::named(kind).ok_or_else(unknown)?;
    let moderate = first.abs().max(second.abs()) <= FARTHEST;
    if !(moderate && scope.window.contains([primary, secondary])) {
        return Err(Problem::wrong("the place lies outside the view, or the motion there is too fast"));
    }
    let lost = || Problem::wrong("no solution was found exactly on the curve");
    let near = |found: [f64; 2]| {
        let [from, to] = [[primary, secondary], found].map(|place| scope.window.shares(place));
        (0..2).all(|k| (from[k] - to[k]).abs() <= NEAR)
    };
    if kind == Bifurcation::NonImpactingGrazing {
        let here = oscillator.with_parameters([primary, secondary]);
        let found = GrazingPlace::find(&here, *second).map_err(|_| lost())?;
        let found = found.parameters;
        let exact = ExactPlace { at: units.parameters(found), multipliers: None };
        return near(found).then_some(exact).ok_or_else(lost);
    }
    let equations = match p {
        0 => grazing_unfold::non_impacting::equations(&oscillator, scope.window),
        _ if scope.loops.contains(p) => LoopEquations::new(oscillator, *p, Formulation::FixedPhase),
        _ => return Err(unknown()),
    };
    let start = Unknowns::new(*first, *second, primary, secondary);
    let time = equations.solution(&start).highest_interior_maximum.map_or(0.0, |maximum| maximum.time);
    // Where the curve runs along a line of one parameter, a line of the other one crosses it.
    let held = [Condition::Secondary(secondary), Condition::Primary(primary)];
    let mut found = held.into_iter().filter_map(|held| {
        let mut times = EventTimes::default().touching(time);
        let point = locate(&equations, [kind.condition(), held], start.clone(), &mut times).ok()?;
        Some(equations.solution(&point)).filter(|solution| near(solution.parameters()))
    });
    let solution = found.next().ok_or_else(lost)?;
    let multipliers = Some(eigenvalues(&solution.multipliers));
    Ok(ExactPlace { at: units.parameters(solution.parameters()), multipliers })
}
