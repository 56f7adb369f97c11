//! Theorems 2.2 to 2.5, tested on the hybrid system; if a hypothesis is violated the conclusion fails.

pub(super) mod general;

use self::general::{side_of_orbit, sides_of_curves};
use crate::sweep::closed_form::{LoopSolution, LoopSolutions};
use crate::sweep::resonant::FIT_TOLERANCE;
use crate::sweep::{Case, CaseVerdict, GenericRow, ResonantRow, generic_cases, resonant_cases, rows};
use crate::*;
use grazing_model::LinearOscillator;
use grazing_theorems::{HypothesesViolated, ResonantGrazing};

/// Damping ratio and restitution of the oscillator for cases with violated hypotheses.
const ZETA: f64 = 0.03;
const EPSILON: f64 = 0.8;

/// th:codim11.
pub(crate) fn generic_grazing_one_loop() -> CheckResult {
    let mut count = generic_votes(&[(1, 3)], |loops| loops == 1)?;
    // Impacts that take time, with α > 0, and with such a long time that α < 0: then the MPS is on the
    // other side.
    for shift in [0.05, -0.05] {
        for alpha in [0.5, -0.5] {
            let orbit = delayed(1.5 + shift, alpha)?;
            let map = orbit.grazing_point().map;
            let other = Existence::On(Side::of(-map.a.m12 * map.transversality()));
            count.see(generic_case(&orbit, 1, alpha > 0.0, Quantity::SquareRootFactor, other)?);
        }
    }
    Ok(count.outcome("oscillators at grazing to both sides of p = 1 resonances; hypotheses violated in turn"))
}

/// th:codim1p.
pub(crate) fn generic_grazing_p_loops() -> CheckResult {
    let mut count = generic_votes(&[(2, 1), (3, 1)], |loops| loops > 1)?;
    for p in [2, 3] {
        // With α < 0 MPSs require a₁₂ < 0 instead of a₁₂ > 0, on both sides of n − 1/(2p).
        for share in [0.94, 1.06] {
            let q = share * 0.5 / f64::from(p);
            for (ratio, negative) in [(2.0 - q, true), (1.0 + q, false)] {
                for alpha in [0.5, -0.5] {
                    let (orbit, applies) = (delayed(ratio, alpha)?, negative == (alpha < 0.0));
                    let violated = Quantity::OffDiagonalTimesSquareRootFactor;
                    count.see(generic_case(&orbit, p, applies, violated, Existence::Nowhere)?);
                }
            }
        }
    }
    Ok(count.outcome(
        "oscillators at grazing, p = 2 to 6, to both sides of g_p and h_p; hypotheses violated in turn",
    ))
}

/// th:codim21.
pub(crate) fn resonant_grazing_one_loop() -> CheckResult {
    let mut count = resonant_votes(|loops| loops == 1, &[(1, 2), (1, 3)])?;
    for n in [2, 3] {
        let ratio = 0.5 * f64::from(n);
        count.see(no_curve_away_from_resonance(1, theory()?.damped_natural_frequency() / (ratio + 0.05)));
        for alpha in [0.5, -0.5] {
            let orbit = delayed(ratio, alpha)?;
            // With α < 0 the curves exist for the other sign of η.
            let point = orbit.resonant_point(1)?;
            let stability = point.stability_coefficients();
            let others = [stability.plus, stability.minus]
                .map(|s| Existence::On(Side::of(-point.unfolding.derivative * s)));
            count.see(resonant_case(&orbit, 1, alpha > 0.0, Quantity::SquareRootFactor, others)?);
        }
    }
    Ok(count.outcome("p = 1 resonances, 1/E_p among the restitutions; hypotheses violated in turn"))
}

/// th:codim2p.
pub(crate) fn resonant_grazing_p_loops() -> CheckResult {
    let mut count = resonant_votes(|loops| loops > 1, &[(2, 1), (3, 1)])?;
    for p in [2, 3] {
        let q = 0.5 / f64::from(p);
        count.see(no_curve_away_from_resonance(p, theory()?.damped_natural_frequency() / (1.04 + q)));
        // With α < 0 the resonances at n − 1/(2p) are real, and those at n + 1/(2p) virtual.
        for (ratio, negative) in [(1.0 + q, false), (2.0 - q, true)] {
            for alpha in [0.5, -0.5] {
                let (orbit, applies) = (delayed(ratio, alpha)?, negative == (alpha < 0.0));
                let violated = Quantity::OffDiagonalTimesSquareRootFactor;
                count.see(resonant_case(&orbit, p, applies, violated, [Existence::Nowhere; 2])?);
            }
        }
    }
    Ok(count.outcome(
        "resonances with p = 2 to 5, virtual ones and 1/E_p among the restitutions; hypotheses violated in turn",
    ))
}

/// Whether the MPS is on the side of theorem 2.2 or 2.3 where it applies, or this hypothesis alone is
/// violated.
fn generic_case(
    orbit: &Grazing,
    loops: u32,
    applies: bool,
    violated: Quantity,
    otherwise: Existence,
) -> Result<bool, CheckError> {
    let seen = side_of_orbit(orbit, loops)?;
    Ok(match GenericGrazing::check(&orbit.grazing_point(), loops) {
        Ok(theorem) => applies && seen == Existence::On(theorem.side()),
        Err(answer) => !applies && only(&answer, violated) && seen == otherwise,
    })
}

/// Whether both curves are as in theorem 2.4 or 2.5 where it applies, or this hypothesis alone is
/// violated.
fn resonant_case(
    orbit: &Grazing,
    loops: u32,
    applies: bool,
    violated: Quantity,
    otherwise: [Existence; 2],
) -> Result<bool, CheckError> {
    Ok(match ResonantGrazing::check(&orbit.resonant_point(loops)?, 1e-11) {
        Ok(theorem) => applies && holds(orbit, loops, &theorem)?,
        Err(answer) => !applies && only(&answer, violated) && sides_of_curves(orbit, loops)? == otherwise,
    })
}

/// Counts the cases of the sweep; if a hypothesis fails and the result has an explanation, the theorem is
/// silent.
fn swept(
    cases: Vec<Case>,
    wanted: impl Fn(u32) -> bool,
    count: &mut Votes,
    verdict: fn(Case) -> Result<CaseVerdict, CheckError>,
) -> Result<(), CheckError> {
    let cases: Vec<_> = cases.into_iter().filter(|case| wanted(case.loops)).collect();
    for verdict in rows(&cases, verdict, || ())? {
        match verdict {
            CaseVerdict::Agreement => count.see(true),
            CaseVerdict::Explained(_) => count.silent(),
            CaseVerdict::Unexplained => count.see(false),
        }
    }
    Ok(())
}

/// Oscillators at grazing that are not linear, with various forces, reset laws, β of either sign, and
/// real eigenvalues; and linear ones within 0.01 of τ = h_p and of δ = 1.
fn other_oscillators(wanted: impl Fn(u32) -> bool) -> Result<Vec<(Grazing, u32)>, CheckError> {
    let mut found = Vec::new();
    for orbit in specimens()? {
        found.extend((1..=4).map(|p| (orbit.clone(), p)));
    }
    for p in 3..=5 {
        for margin in [0.005, -0.005] {
            found.push((beside_the_boundary(p, margin)?, p));
        }
    }
    // δ = e^{−4πζ/ω}.
    let damping: f64 = 4e-4;
    let orbit = Law::varying(damping).grazing((1.0 - damping * damping).sqrt() / 1.1)?;
    // τ = 1.6 lies above h_p for these p, and a₁₂ > 0.
    found.extend((1..=4).map(|p| (orbit.clone(), p)));
    // β < 0 and a₁₂ > 0: μ = ω far above the natural frequency. h₃ < τ < g₃ and g₂ < τ.
    let law = Law { delay: Exponential::constant(0.05), ..Law::linear(0.05, 0.7) }.frequency_first();
    let orbit = law.grazing(4.5)?;
    found.extend((1..=3).map(|p| (orbit.clone(), p)));
    // β < 0 < b₁, which requires a primary parameter that changes both; τ = 1.2 and a₁₂ > 0.
    for (law, frequency) in [(Law::varying(0.05), 0.92), (Law::nonlinear(0.05), 1.1)] {
        let orbit = Law { pull: 1.2, ..law }.grazing(frequency)?;
        let map = orbit.grazing_point().map;
        if map.transversality() >= 0.0 || map.b.x <= 0.0 {
            return Err("b₁ and β have one sign".into());
        }
        found.extend((1..=3).map(|p| (orbit.clone(), p)));
    }
    found.retain(|(_, p)| wanted(*p));
    Ok(found)
}

/// Whether the hypotheses of Theorem 2.2 or 2.3 hold, as printed in the paper.
fn speaks(point: &GrazingPoint, p: u32) -> Result<bool, CheckError> {
    let GrazingPoint { map: LinearisedMap { a, b }, forcing_frequency, gamma, phi, psi } = *point;
    let alpha = 1.0 + phi - gamma * psi / forcing_frequency;
    let (tau, delta) = (a.m11 + a.m22, a.m11 * a.m22 - a.m12 * a.m21);
    let beta = (1.0 - a.m22) * b.x + a.m12 * b.y;
    let settles = 0.0 < delta && delta < 1.0 && tau.abs() < delta + 1.0;
    Ok(settles
        && beta != 0.0
        && match p {
            1 => alpha > 0.0 && a.m12 != 0.0,
            _ => {
                a.m12 * alpha > 0.0
                    && tau > admissibility_boundary(p, delta)?
                    && tau != resonance_boundary(f64::from(p), delta)
            }
        })
}

/// An oscillator with τ above h_p(δ) by this margin, and a₁₂ > 0: 1 + 1/(2p) < ω₁/ω < 1 + 1/p.
fn beside_the_boundary(p: u32, margin: f64) -> Result<Grazing, CheckError> {
    let theory = theory()?;
    let omega = |ratio: f64| theory.damped_natural_frequency() / ratio;
    let (mut near, mut far) = (1.0 + 0.5 / f64::from(p), 1.0 + 1.0 / f64::from(p));
    // τ decreases with the ratio. After forty bisections the interval is negligible.
    for _ in 0..40 {
        let middle = 0.5 * (near + far);
        let grazing = theory.grazing(omega(middle))?;
        let above = grazing.trace() - admissibility_boundary(p, grazing.determinant())? > margin;
        if above { near = middle } else { far = middle }
    }
    Law::varying(ZETA).grazing(omega(near))
}

/// Tests theorem 2.2 or 2.3 on the sweep's oscillators by continuation and simulation, and on others by
/// simulation.
fn generic_votes(resonances: &[(u32, u32)], wanted: impl Fn(u32) -> bool) -> Result<Votes, CheckError> {
    let mut count = Votes::default();
    for &(p, n) in resonances {
        // a₁₂ = 0 or κ_p = 0: the MPS that emerges is not unstable.
        let omega = theory()?.resonance(p, n)?.forcing_frequency();
        count.see(attracts(p, omega));
        count.see(exists_for_both_signs_of_the_root(p, 0.97 * omega));
    }
    swept(generic_cases()?, &wanted, &mut count, |case| Ok(GenericRow::of(case)?.verdict()))?;
    for (orbit, p) in other_oscillators(wanted)? {
        let point = orbit.grazing_point();
        match (GenericGrazing::check(&point, p), speaks(&point, p)?) {
            (Ok(theorem), true) => {
                count.see(side_of_orbit(&orbit, p)? == Existence::On(theorem.side()));
            }
            (Err(_), false) => count.silent(),
            _ => count.see(false),
        }
    }
    Ok(count)
}

/// Tests theorem 2.4 or 2.5 on the sweep's oscillators, and on these resonances of a nonlinear one.
fn resonant_votes(wanted: impl Fn(u32) -> bool, others: &[(u32, u32)]) -> Result<Votes, CheckError> {
    let mut count = Votes::default();
    swept(resonant_cases()?, &wanted, &mut count, |case| Ok(ResonantRow::of(case)?.verdict()))?;
    for &(p, n) in others {
        let located = Law::nonlinear(damping_for_decay(p, n, 0.5)).resonance(p, n)?;
        count.see(holds(located.orbit(), p, located.checked()?.theorem())?);
    }
    Ok(count)
}

fn theory() -> Result<grazing_theorems::LinearOscillator, CheckError> {
    Ok(grazing_theorems::LinearOscillator::new(ZETA, EPSILON)?)
}

/// Whether this hypothesis, and no other, is violated.
pub(super) fn only(violated: &HypothesesViolated, quantity: Quantity) -> bool {
    violated.violated().map(|hypothesis| hypothesis.quantity).eq([quantity])
}

/// The grazing orbit at ω₁/ω = `ratio` of an oscillator with impacts of finite duration and this α.
fn delayed(ratio: f64, alpha: f64) -> Result<Grazing, CheckError> {
    let omega = theory()?.damped_natural_frequency() / ratio;
    let with = |size: f64| Law { delay: Exponential { size, ..DELAY }, ..Law::varying(ZETA) }.grazing(omega);
    let unit = with(1.0)?.grazing_point();
    let wanted = (1.0 + unit.phi - alpha) * unit.forcing_frequency / unit.gamma;
    with(wanted / unit.psi)
}

/// The behaviour of a solution in the hybrid system, and whether nearby simulated orbits approach it.
fn seen(solution: LoopSolution, loops: u32, omega: f64) -> Option<(ReturnOutcome, Option<bool>)> {
    let oscillator = LinearOscillator::new(ZETA, EPSILON, solution.amplitude, omega).ok()?;
    let suspect = solution.suspect(&oscillator, loops);
    Some((suspect.follow(), suspect.attracts()))
}

/// Whether the MPS that emerges from grazing at this frequency exists and attracts simulated orbits.
fn attracts(loops: u32, omega: f64) -> bool {
    let solution = LoopSolutions::new(ZETA, EPSILON, omega, loops).with_velocity(0.01);
    seen(solution, loops, omega) == Some((ReturnOutcome::Returns, Some(true)))
}

/// Whether, for 𝒜 = 𝒜_graz ± μ² with β = 0, the MPS exists for both signs of μ or for none.
fn exists_for_both_signs_of_the_root(loops: u32, omega: f64) -> bool {
    let solutions = LoopSolutions::new(ZETA, EPSILON, omega, loops);
    let size = 1e-4 / solutions.slopes()[0].abs();
    let [above, below] = [size, -size].map(|square| {
        let nearest = solutions.at(square).into_iter().next();
        let seen = nearest.and_then(|solution| seen(solution, loops, omega));
        seen.is_some_and(|(seen, _)| seen == ReturnOutcome::Returns)
    });
    above != below
}

/// Whether, away from resonance, no SN or PD curve emerges from grazing, also at nearby frequencies.
fn no_curve_away_from_resonance(loops: u32, omega: f64) -> bool {
    [0.0, 1e-4, -1e-4].iter().all(|eta| {
        let solutions = LoopSolutions::new(ZETA, EPSILON, omega + eta, loops);
        solutions.saddle_node().velocity.abs() > 0.01 && solutions.period_doubling().velocity.abs() > 0.01
    })
}

/// Whether both curves exist for the stated sign of η, with the stated coefficients.
fn holds(orbit: &Grazing, loops: u32, theorem: &ResonantGrazing) -> Result<bool, CheckError> {
    let located = ResonantGrazingPoint::find(orbit.oscillator(), loops, orbit.phase())?;
    let stated = [theorem.saddle_node(), theorem.period_doubling()];
    let mut all = sides_of_curves(orbit, loops)? == stated.map(|curve| Existence::On(curve.eta_side));
    for (curve, condition) in stated.iter().zip([Condition::SADDLE_NODE, Condition::PERIOD_DOUBLING]) {
        let fit = quadratic_coefficient(&located, condition)?;
        all &= (fit.value / curve.coefficient - 1.0).abs() < FIT_TOLERANCE;
    }
    Ok(all)
}
