//! The curve through a solution along which the velocity of its impact, the slowest of several, is constant.

use grazing_continuation::curve::Curve;
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{
    EventTimes, Formulation, LoopEquations, PeriodicSolution, Unknowns, unknown,
};
use grazing_model::OnWall;
use grazing_model::smooth::Stop;
use grazing_results::plane::Property;
use grazing_unfold::described::Prepared;
use grazing_unfold::own_curves::through;
use serde::Deserialize;
use serde_json::{Value, json};

use crate::answer::Problem;
use crate::diagram::{OWN_CURVE, eigenvalues, named};
use crate::model::{Model, View};
use crate::place::{FARTHEST, are_stops, is_sought};

/// The request for a curve through a solution.
#[derive(Deserialize)]
pub(crate) struct FollowRequest {
    model: Model,
    view: View,
    /// The place of a solution that recurs after p forcing periods, with velocities and phases of its impacts.
    at: [f64; 2],
    p: u32,
    impacts: Vec<[f64; 2]>,
    /// The walls that they hit, from 0, if there are two.
    #[serde(default)]
    stops: Vec<usize>,
}

pub(crate) fn compute(request: &FollowRequest, stop: &Stop) -> Result<Value, Problem> {
    let &FollowRequest { ref model, ref view, at, p, ref impacts, ref stops } = request;
    let of = model.prepared(Some(view), stop)?;
    let [primary, secondary] = of.without_dimensions(at);
    let Prepared { oscillator, scope, axes, .. } = of;
    let units = axes.units;
    let struck: Vec<OnWall> =
        impacts.iter().map(|[velocity, phase]| OnWall::new(velocity / units.velocity(), *phase)).collect();
    let known = is_sought(&scope.loops, p, impacts) && scope.window.contains([primary, secondary]);
    let near = Unknowns::of_impacts(&struck, [primary, secondary]);
    let known = known && are_stops(&oscillator, impacts, stops);
    if !(known && near.iter().all(|number| number.abs() <= FARTHEST)) {
        return Err(Problem::wrong("the view contains no such solution"));
    }
    let equations =
        LoopEquations::new(oscillator, p, Formulation::FixedPhase).at_stops(stops.iter().copied());
    let (here, mut times) =
        ([Condition::Primary(primary), Condition::Secondary(secondary)], EventTimes::default());
    let start = locate(&equations, here, near, &mut times)
        .map_err(|_| Problem::wrong("the solution was not found again"))?;
    let property = Property::ImpactVelocity(start[unknown::VELOCITY]);
    let found = through(&equations, scope.window, (start, times), property);
    if stop.is_asked() {
        return Err(Problem::ended());
    }
    let one = |(rank, curve): (u32, &Curve)| {
        let bold =
            |solution: &PeriodicSolution| solution.stable() && solution.ceiling() <= PeriodicSolution::TOUCH;
        let points = curve.points.iter();
        let points =
            points.map(|point| (units.parameters(point.solution.parameters()), bold(&point.solution)));
        let mut told = named(OWN_CURVE, [p, 0, rank], 0, "continuation", points.unzip());
        let multipliers = curve.points.iter().map(|point| eigenvalues(&point.solution.multipliers));
        told["multipliers"] = multipliers.collect();
        told["lost"] = json!(curve.lost());
        told
    };
    Ok(json!((0..).zip(&found).map(one).collect::<Vec<_>>()))
}
