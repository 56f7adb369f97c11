//! The curve through a solution along which the velocity of its impact, the slowest of several, is constant.

use grazing_continuation::curve::Curve as Followed;
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{
    EventTimes, Formulation, LoopEquations, PeriodicSolution, Unknowns, unknown,
};
use grazing_model::OnWall;
use grazing_model::smooth::Stop;
use grazing_results::Dimensioned;
use grazing_results::plane::{CurveSource, Property};
use grazing_unfold::described::Prepared;
use grazing_unfold::own_curves::through;
use serde::Deserialize;

use crate::answer::Problem;
use crate::diagram::{OWN_CURVE, ShownCurve};
use crate::model::{Model, View};
use crate::place::{FARTHEST, Impact, Known};

/// The request for a curve through a solution.
#[derive(Deserialize)]
pub(crate) struct FollowRequest {
    model: Model,
    view: View,
    /// The place of the solution.
    at: [f64; 2],
    #[serde(flatten)]
    solution: Known,
}

pub(crate) fn compute(request: &FollowRequest, stop: &Stop) -> Result<Vec<ShownCurve>, Problem> {
    let &FollowRequest { ref model, ref view, at, ref solution } = request;
    let of = model.prepared(Some(view), stop)?;
    let [primary, secondary] = of.without_dimensions(at);
    let Prepared { oscillator, scope, axes, .. } = of;
    let units = axes.units;
    let known = solution.clone().without_dimensions(&units);
    let struck: Vec<OnWall> =
        known.impacts.iter().map(|&Impact([velocity, phase])| OnWall::new(velocity, phase)).collect();
    let is_sought = known.is_sought(&oscillator, &scope.loops);
    let near = Unknowns::of_impacts(&struck, [primary, secondary]);
    let moderate = near.iter().all(|number| number.abs() <= FARTHEST);
    if !(is_sought && scope.window.contains([primary, secondary]) && moderate) {
        return Err(Problem::wrong("the view contains no such solution"));
    }
    let equations = LoopEquations::new(oscillator, known.p, Formulation::FixedPhase).at_stops(known.stops);
    let (here, mut times) =
        ([Condition::Primary(primary), Condition::Secondary(secondary)], EventTimes::default());
    let start = locate(&equations, here, near, &mut times)
        .map_err(|_| Problem::wrong("the solution was not found again"))?;
    let property = Property::ImpactVelocity(start[unknown::VELOCITY]);
    let found = through(&equations, scope.window, (start, times), property);
    if stop.is_asked() {
        return Err(Problem::ended());
    }
    let one = |(rank, curve): (u32, &Followed)| {
        let bold =
            |solution: &PeriodicSolution| solution.stable() && solution.ceiling() <= PeriodicSolution::TOUCH;
        let points = curve.points.iter();
        let points =
            points.map(|point| (units.parameters(point.solution.parameters()), bold(&point.solution)));
        let multipliers = curve.points.iter().map(|point| point.solution.multipliers);
        ShownCurve::new(OWN_CURVE, [known.p, 0, rank], 0, CurveSource::Continuation, points)
            .with(multipliers, curve.lost().map(Option::unwrap_or_default))
    };
    Ok((0..).zip(&found).map(one).collect())
}
