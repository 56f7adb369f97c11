//! MPSs of any oscillator near grazing: zeros of V, and the behaviour of the hybrid system there.

use crate::*;
use grazing_continuation::arclength::Stall;
use grazing_continuation::curve::{Curve, SolutionCurve};
use grazing_continuation::locate::locate;
use grazing_unfold::simulation::Suspect;

/// The equations of p-loop MPSs.
pub(crate) fn equations(grazing: &Grazing, p: u32) -> LoopEquations<Specimen> {
    LoopEquations::new(grazing.oscillator().clone(), p, Formulation::Vivid)
}

/// The point (y, z; μ), with z and μ relative to grazing.
pub(crate) fn unknowns(grazing: &Grazing, [y, dz, dmu]: [f64; 3]) -> Unknowns {
    let [primary, secondary] = grazing.oscillator().parameters();
    Unknowns::new(y, grazing.phase() + dz, primary + dmu, secondary)
}

/// The branch of p-loop MPSs with y > 0 that leaves the grazing point of an oscillator.
pub(crate) fn branch<O: ImpactOscillator>(
    oscillator: &O,
    phase: f64,
    p: u32,
    route: &Route<'_>,
) -> Result<Curve, Stall<MapError>> {
    let [primary, secondary] = oscillator.parameters();
    let equations = LoopEquations::new(oscillator.clone(), p, Formulation::Vivid);
    let curve = SolutionCurve { equations, condition: Condition::Secondary(secondary) };
    let start = Unknowns::new(0.0, phase, primary, secondary);
    curve.follow(start, Unknowns::new(1.0, 0.0, 0.0, 0.0), EventTimes::default(), route)
}

/// V at a point.
pub(crate) fn vivid(equations: &LoopEquations<Specimen>, point: &Unknowns) -> Option<Vector2<f64>> {
    Some(equations.maps::<1>(point, &mut EventTimes::default()).ok()?.first().difference().0)
}

/// The MPS that satisfies two conditions, by Newton's method from a start.
pub(crate) fn located<O: ImpactOscillator>(
    equations: &LoopEquations<O>,
    conditions: [Condition; 2],
    start: Unknowns,
) -> Option<Unknowns> {
    locate(equations, conditions, start, &mut EventTimes::default()).ok()
}

/// The MPS at the parameters of a start.
pub(crate) fn at_parameters(equations: &LoopEquations<Specimen>, start: Unknowns) -> Option<Unknowns> {
    let [_, _, primary, secondary] = start.clone().into();
    located(equations, [Condition::Primary(primary), Condition::Secondary(secondary)], start)
}

/// The MPS with this impact velocity, at the η of a nearby MPS.
pub(crate) fn at_velocity<O: ImpactOscillator>(
    equations: &LoopEquations<O>,
    near: &Unknowns,
    velocity: f64,
) -> Option<Unknowns> {
    let mut start = near.clone();
    start[unknown::VELOCITY] = velocity;
    let conditions = [Condition::ImpactVelocity(velocity), Condition::Secondary(start[unknown::SECONDARY])];
    located(equations, conditions, start)
}

/// The zero of V at μ, by Newton's method from its expansion.
pub(crate) fn zero(grazing: &Grazing, p: u32, mu: f64) -> Option<Unknowns> {
    let emerging = grazing.grazing_point().emerging_orbit(p).ok()?;
    let [y, dz] = [emerging.impact_velocity_slope, emerging.impact_phase_slope].map(|slope| slope * mu);
    at_parameters(&equations(grazing, p), unknowns(grazing, [y, dz, mu]))
}

/// The behaviour of an MPS in the hybrid system, followed from its impact.
pub(crate) fn followed<O: ImpactOscillator>(equations: &LoopEquations<O>, point: &Unknowns) -> ReturnOutcome {
    Suspect::of(&equations.oscillator_at(point), equations.loops(), point).follow()
}

/// Whether simulated orbits near an MPS approach it in the long term.
pub(crate) fn attracts<O: ImpactOscillator>(equations: &LoopEquations<O>, point: &Unknowns) -> Option<bool> {
    Suspect::of(&equations.oscillator_at(point), equations.loops(), point).attracts()
}
