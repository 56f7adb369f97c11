//! Growth of perturbations in the hybrid system itself, with impacts located one by one.

use crate::*;

/// The next impact (y, z), with its phase near that of this one; `None` if it is not p periods later.
pub(super) fn next_impact(oscillator: &Specimen, loops: u32, impact: Vector2<f64>) -> Option<Vector2<f64>> {
    let period = oscillator.forcing_period();
    let expected = f64::from(loops) * period;
    let start = State::on_wall(impact[0], impact[1]);
    let flight = Orbit::new(oscillator, start, expected + 0.5 * period, usize::MAX).next()?;
    let FlightEnd::Impact(next) = flight.end else { return None };
    if (flight.duration - expected).abs() > 0.25 * period {
        return None;
    }
    let turns = libm::round((next.phase - impact[1]) / TAU);
    Some(Vector2::new(next.velocity, next.phase - turns * TAU))
}

/// Admissible MPSs near a resonance, with impact velocities that are small but not tiny.
pub(super) fn admissible(place: &ResonantSpecimen) -> Vec<Near> {
    let mut found = Vec::new();
    for y in [0.02, 0.05, 0.1] {
        for eta in [-0.004, -0.001, 0.0, 0.001, 0.004] {
            let Some(near) = place.on_branch(y, eta) else { continue };
            let solution = place.solution(&near);
            if solution.admissible() && solution.ceiling() < -1e-3 * y {
                found.push(near);
            }
        }
    }
    found
}

checks! {
    /// eq:U: its eigenvalues are the multipliers, by the growth of perturbations from impact to impact.
    // Rounding of 10⁻¹⁵ over steps down to 6·10⁻⁵, and products of two for the determinant.
    multipliers: everywhere(ANY) |place; largest: Deviations| {
        for near in admissible(place) {
            let solution = place.solution(&near);
            let (oscillator, impact) = (near.oscillator(), near.impact());
            // Steps are proportional to the velocity, on whose scale the map varies.
            let column = |direction: Vector2<f64>| {
                slope(3e-3 * impact[0], |h| next_impact(&oscillator, place.loops(), impact + direction * h))
                    .ok_or("an admissible MPS does not return in simulation")
            };
            let simulated = Matrix2::from_columns(&[column(Vector2::x())?, column(Vector2::y())?]);
            let scale = 1.0 + solution.multipliers.trace.abs();
            largest.compare(simulated.trace(), solution.multipliers.trace, scale);
            largest.compare(simulated.determinant(), solution.multipliers.determinant, scale);
        }
    } => largest.outcome(1e-7, "admissible MPSs near resonances, followed from impact to impact");
}
