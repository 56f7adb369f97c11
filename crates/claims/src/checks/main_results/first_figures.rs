//! Section 1: the statements about Figure 2 and about the Jacobian near grazing.

use crate::solutions;
use crate::*;
use grazing_continuation::curve::{Curve, CurvePoint};

/// The branch of p-loop MPSs that leaves grazing in Figure 2, its equations and 𝒜_graz.
fn branch(loops: u32) -> Result<(LoopEquations<Specimen>, Curve, f64), CheckError> {
    let omega = printed("fig02_frequency");
    let grazing = Law::linear(printed("zeta"), printed("epsilon")).grazing(omega)?;
    let amplitude = grazing.primary();
    let route = Route {
        // A quarter on either side contains everything in Figure 2.
        window: Window { primary: [0.75 * amplitude, 1.25 * amplitude], secondary: [0.0, 2.0 * omega] },
        control: StepControl::DRAWING,
        step_limit: 5_000,
        stop_at_events: false,
        pace: None,
    };
    let curve = solutions::branch(grazing.oscillator(), grazing.phase(), loops, &route)?;
    Ok((equations(&grazing, loops), curve, amplitude))
}

/// Two loops gain stability at a PD, three loops at an SN and lose it at a GZ, to the left of that PD;
/// between GZ and PD none of the branches p = 1, 2, 3 has a stable solution.
pub(crate) fn stability_gained() -> CheckResult {
    let mut cases = Votes::default();
    let mut located = Vec::new();
    for (loops, gained) in [(2, Condition::PERIOD_DOUBLING), (3, Condition::SADDLE_NODE)] {
        let (equations, curve, _) = branch(loops)?;
        let stable = |index: usize| curve.points.get(index).map(|point| point.solution.stable());
        let event =
            curve.events.iter().find(|event| event.solution.admissible() && event.condition == gained);
        let event = event.ok_or("the event of Figure 2 was not found")?;
        cases.see(stable(event.index - 1) == Some(false) && stable(event.index) == Some(true));
        // A point well past the event attracts in simulation, one well before it does not.
        for (index, attracting) in [(event.index + 5, true), (event.index.saturating_sub(5), false)] {
            let solution = &curve.points.get(index).ok_or("the branch ends beside the event")?.solution;
            cases.see(attracts(&equations, &solution.unknowns) == Some(attracting));
        }
        located.push(event.solution.parameters()[0]);
        if loops == 3 {
            let grazing = curve.events.iter().find(|event| event.condition == Condition::InteriorGrazing);
            let grazing = grazing.ok_or("the grazing bifurcation of the three-loop MPS was not found")?;
            // Admissible before, not admissible after.
            let admissible = |index: usize| curve.points.get(index).map(|point| point.solution.admissible());
            cases
                .see(admissible(grazing.index - 1) == Some(true) && admissible(grazing.index) == Some(false));
            located.push(grazing.solution.parameters()[0]);
        }
    }
    // From left to right: 𝒜_graz, ..., GZ, PD; SN lies left of GZ.
    let [pd, sn, gz] = located[..] else {
        return Err("three bifurcations were expected".into());
    };
    cases.see(sn < gz && gz < pd);
    for loops in 1..=3 {
        let (_, curve, _) = branch(loops)?;
        for CurvePoint { solution, .. } in &curve.points {
            let [amplitude, _] = solution.parameters();
            if gz < amplitude && amplitude < pd {
                cases.see(!(solution.stable() && solution.admissible()));
            }
        }
    }
    Ok(cases.outcome("PD of two loops, SN and GZ of three loops on the branches of Figure 2, and what lies between GZ and PD"))
}

checks! {
    /// MPSs with p = 1 and 2 emanate to the right, p = 3 to the left; all are unstable there.
    emanating_solutions: over(1..=3) |loops; cases: Votes| {
        let (equations, curve, amplitude) = branch(loops)?;
        for CurvePoint { solution, .. } in curve.points.iter().skip(1).take(3) {
            let point = &solution.unknowns;
            cases.see((solution.parameters()[0] > amplitude) == (loops < 3));
            cases.see(solution.admissible() && followed(&equations, point) == ReturnOutcome::Returns);
            cases.see(!solution.stable() && attracts(&equations, point) == Some(false));
        }
    } => cases.outcome("the first points of the branches p = 1, 2, 3 of Figure 2");
    /// The Jacobian of P_disc grows like x̂^(−1/2): its entry times √x̂ tends to −αω/√(2γ).
    // First order in √x̂; slack for the second.
    singular_jacobian: at_grazing(83, 100) |_, orbit; least: Smallest| {
        let point = orbit.grazing_point();
        let limit = -point.alpha() * point.forcing_frequency / (2.0 * point.gamma).sqrt();
        least.see_resolved(order(|h| {
            let jet =
                discontinuity_map::<_, 1>(orbit.oscillator(), AtRest::new(h * h, orbit.phase())).ok()?;
            // The velocity at the wall is known to a relative accuracy of 10⁻¹⁶/h.
            Some((jet.jacobian[(1, 0)] * h - limit, 1e-15 / h))
        }));
    } => least.order(1.0, 0.3, "∂z⁽⁰⁾/∂x̂ times √x̂ for random oscillators with ψ ≠ 0");
}
