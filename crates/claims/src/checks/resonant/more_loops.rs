//! Solutions of more loops at one-loop resonances, which Theorem 2.5 does not cover.

use crate::*;
use grazing_theorems::iterated::{IteratedResonance, last_visit_margin};

checks! {
    /// Compares the closed form for linear oscillators with the forms of the visits.
    ///
    /// MPSs of two to five loops near one-loop resonances are stable and admissible at the impact
    /// velocities and on the side of η that theory gives, and at no others: by multipliers and maxima,
    /// and in simulation.
    emerging: everywhere(ONE) |place; votes: Votes| {
        let point = place.point();
        let [_, _, sigma] = point.limit_map().numbers();
        for (loops, epsilon) in (2..=12).flat_map(|loops| [0.1, 0.4, 0.7, 1.0].map(|epsilon| (loops, epsilon))) {
            for sigma in [sigma, sigma * sigma] {
                let leave = !IteratedResonance::of_linear_oscillator(loops, sigma, epsilon).emerging().is_empty();
                votes.see(leave == (loops == 2 || (sigma > 0.0 && last_visit_margin(loops, sigma, epsilon) > 0.0)));
            }
        }
        for loops in 2..=5 {
            let equations = LoopEquations::new(place.resonance.orbit().oscillator().clone(), loops, Formulation::Vivid);
            let iterated = place.resonance.iterated(loops).ok_or("it has one loop")?;
            let (emerging, branch) = (iterated.emerging(), iterated.point().branch_expansion());
            for side in [Side::Negative, Side::Positive] {
                let found = emerging.iter().find(|solutions| solutions.side == side);
                let ends = found.map(|found| {
                    let [slowest, fastest] = [Some(found.slowest), found.fastest].map(|bound| bound.map(|at| at.velocity_slope.abs()));
                    [slowest.unwrap_or(0.0), fastest.unwrap_or(f64::INFINITY)]
                });
                // On both sides of the ends, between them, and on the scale of the limit map.
                let beside = |[slow, fast]: [f64; 2]| [0.9 * slow, 0.5 * (slow + fast), 1.1 * fast];
                let wide = [0.1, 0.3, 3.0].map(|share| share * point.limit_scale().velocity.abs());
                for slope in ends.map(beside).into_iter().flatten().chain(wide).filter(|slope| slope.is_finite()) {
                    let is_near = |end: f64| (slope / end - 1.0).abs() < 0.02;
                    if ends.is_some_and(|ends| ends.into_iter().any(is_near)) {
                        continue;
                    }
                    let stated = ends.is_some_and(|[slow, fast]| slow < slope && slope < fast);
                    // So small that leading terms decide, but so large that heights exceed rounding.
                    let y = 1e-3 * slope.min(point.limit_scale().velocity.abs());
                    let eta = side.signum() * y / slope;
                    let near = place.near([y, branch.k_1 * y, branch.parameter(y, eta), eta]).ok_or("no grazing orbit")?;
                    let conditions = [Condition::ImpactVelocity(y), Condition::Secondary(near.unknowns[unknown::SECONDARY])];
                    let found = located(&equations, conditions, near.unknowns).ok_or("no MPS of more loops")?;
                    let solution = equations.solution(&found);
                    votes.see((solution.stable() && solution.admissible()) == stated);
                    votes.see((followed(&equations, &found) == ReturnOutcome::Returns) == solution.admissible());
                    if let (true, Some(attracts)) = (solution.admissible(), attracts(&equations, &found)) {
                        votes.see(attracts == solution.stable());
                    }
                }
            }
        }
    } => votes.outcome("MPSs of two to five loops at and around the ends of their intervals, one-loop resonances of oscillators of all kinds");
}
