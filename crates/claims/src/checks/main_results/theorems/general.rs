//! Simulation of a specimen near grazing, without closed forms.

use crate::sweep::generic::small_velocity;
use crate::*;
use grazing_unfold::simulation::Suspect;

/// The side of generic grazing on which simulation finds the MPS that is a zero of V.
pub(crate) fn side_of_orbit(orbit: &Grazing, loops: u32) -> Result<Existence, CheckError> {
    let point = orbit.grazing_point();
    let emerging = point.emerging_orbit(loops)?;
    // So small that the expansion decides where the loops lie; close to h_p one loop is shallow.
    let depth = (1..loops).map(|j| emerging.visit_slope(j).x.abs()).fold(f64::INFINITY, f64::min);
    let slope = emerging.impact_velocity_slope.abs();
    let size = small_velocity(&point, loops).min(0.01 * depth / slope) / slope;
    let seen = |sign: f64| {
        let zero = zero(orbit, loops, sign * size)?;
        Some(followed(&equations(orbit, loops), &zero) == ReturnOutcome::Returns)
    };
    let (positive, negative) = seen(1.0).zip(seen(-1.0)).ok_or("no zero of V")?;
    Ok(Existence::of([positive, negative]))
}

/// The sign of η for which simulation finds each bifurcation, by MPSs on both sides of the multiplier's
/// crossing.
pub(super) fn sides_of_curves(orbit: &Grazing, loops: u32) -> Result<[Existence; 2], CheckError> {
    let point = orbit.resonant_point(loops)?;
    let saddle_node = side_of_curve(orbit, loops, &point, (1.0, point.saddle_node_velocity_slope()))?;
    let flip = side_of_curve(orbit, loops, &point, (-1.0, point.period_doubling_velocity_slope()))?;
    Ok([saddle_node, flip])
}

fn side_of_curve(
    orbit: &Grazing,
    loops: u32,
    point: &ResonantPoint,
    (multiplier, slope): (f64, f64),
) -> Result<Existence, CheckError> {
    let equations = equations(orbit, loops);
    let origin = unknowns(orbit, [0.0; 3]);
    let phase_slope = orbit.phase_slope() + slope * point.branch_expansion().k_1;
    let tangent = Unknowns::new(slope, phase_slope, orbit.primary_slope(), 1.0) / slope;
    const VELOCITY: f64 = 0.005;
    let mut seen = Vec::new();
    for velocity in [VELOCITY, -VELOCITY] {
        let conditions = [Condition::Multiplier(multiplier), Condition::ImpactVelocity(velocity)];
        let start = &origin + &tangent * velocity;
        let zero = located(&equations, conditions, start).ok_or("no point of a curve")?;
        let mut beside = [None; 2];
        for (beside, share) in beside.iter_mut().zip([0.7, 1.3]) {
            let mps = at_velocity(&equations, &zero, share * velocity).ok_or("no MPS beside a curve")?;
            let oscillator = equations.oscillator_at(&mps);
            let suspect = Suspect::of(&oscillator, loops, &mps);
            if suspect.follow() == ReturnOutcome::Returns {
                *beside = suspect.multipliers().map(|[t, d]| 1.0 - multiplier * t + d > 0.0);
            }
        }
        if matches!(beside, [Some(a), Some(b)] if a != b) {
            seen.push(Side::of(zero[3] - origin[3]));
        }
    }
    Ok(match seen[..] {
        [] => Existence::Nowhere,
        [side] => Existence::On(side),
        _ => Existence::Unclear,
    })
}
