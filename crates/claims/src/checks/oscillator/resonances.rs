//! Section 3.4: points of resonance.

use super::diagram::Figure7Window;
use crate::*;
use grazing_theorems::LinearOscillator;

/// The data of the numerical grazing orbit at a frequency, as the theorems use them.
fn measured(theory: &LinearOscillator, omega: f64) -> Result<GrazingPoint, CheckError> {
    let law = Law::linear(theory.damping_ratio(), theory.coefficient_of_restitution());
    Ok(law.grazing(omega)?.grazing_point())
}

/// All zeros in a range of ω₁/ω: sign changes over a fine grid, refined by bisection.
fn zeros(
    value: impl Fn(f64) -> Result<f64, CheckError>,
    [first, last]: [f64; 2],
) -> Result<Vec<f64>, CheckError> {
    const CELLS: i32 = 400;
    // An irregular grid: none of its points is a zero.
    let at = |k: i32| first + (last - first) * (f64::from(k) + 0.137) / f64::from(CELLS);
    let mut found = Vec::new();
    let mut before = value(at(0))?;
    for k in 1..CELLS {
        let here = value(at(k))?;
        if before * here < 0.0 {
            let (mut low, mut high) = (at(k - 1), at(k));
            for _ in 0..45 {
                let middle = 0.5 * (low + high);
                if value(middle)? * before > 0.0 { low = middle } else { high = middle }
            }
            found.push(0.5 * (low + high));
        }
        before = here;
    }
    Ok(found)
}

/// The range of ω₁/ω in which zeros are sought; its ends are not resonances.
const RATIOS: [f64; 2] = [0.22, 3.63];

/// Compares the zeros of a function of ω₁/ω with those of a list that lie in the range, both ways;
/// returns their number.
fn only_zeros(
    largest: &mut Deviations,
    theory: &LinearOscillator,
    value: impl Fn(&GrazingPoint) -> f64,
    list: impl Iterator<Item = f64>,
) -> Result<usize, CheckError> {
    let mut expected: Vec<f64> = list.filter(|ratio| (RATIOS[0]..RATIOS[1]).contains(ratio)).collect();
    expected.sort_by(f64::total_cmp);
    let omega_1 = theory.damped_natural_frequency();
    let found = zeros(|ratio| Ok(value(&measured(theory, omega_1 / ratio)?)), RATIOS)?;
    if found.len() != expected.len() {
        largest.see(f64::INFINITY);
    }
    for (found, expected) in found.iter().zip(&expected) {
        largest.compare(*found, *expected, 1.0);
    }
    Ok(expected.len())
}

/// The printed frequencies of Figure 7 belong to its indices n; of the other resonances in its window only
/// p = 1, n = 2 has curves, at the upper edge.
pub(crate) fn indices() -> CheckResult {
    let theory = super::diagram::theory()?;
    let omega_1 = theory.damped_natural_frequency();
    let mut cases = Votes::default();
    for (loops, index, frequency) in printed_at_resonances("omega") {
        let ratio =
            if loops == 1 { 0.5 * f64::from(index) } else { f64::from(index) + 0.5 / f64::from(loops) };
        // Half a unit of the fourth decimal, relative to 0.39, and ratios up to 2.5.
        cases.see((omega_1 / frequency - ratio).abs() < 5e-4);
    }
    let Figure7Window { frequency: [lowest, highest], loops, .. } = Figure7Window::read()?;
    for p in loops {
        let labelled = if p == 1 { vec![3, 4, 5] } else { vec![1, 2] };
        let found = theory.resonances(&[p], lowest, highest)?;
        let mut found: Vec<u32> = found.iter().map(Resonance::index).collect();
        found.sort_unstable();
        cases.see(labelled.iter().all(|index| found.contains(index)));
        found.retain(|index| !labelled.contains(index));
        cases.see(found == if p == 1 { vec![2] } else { vec![] });
        // Each is a resonance of the numerical map at which the hypotheses hold.
        let law = Law::linear(printed("zeta"), printed("epsilon"));
        labelled.into_iter().for_each(|index| cases.see(ResonantSpecimen::find(law, p, index).is_ok()));
    }
    Ok(cases.outcome("printed frequencies, and all resonances with p = 1, 2, 3 in the window of Figure 7"))
}

/// The zero of the VIVID function with a small y > 0.
fn near_grazing(orbit: &Grazing, loops: u32) -> Result<Unknowns, CheckError> {
    let slope = orbit.grazing_point().emerging_orbit(loops)?.impact_velocity_slope;
    Ok(zero(orbit, loops, 1e-4 / slope).ok_or("no zero of the VIVID function")?)
}

/// A random oscillator, p, n, and the relative distance of the frequency from that of a resonance.
fn beside_resonance(sampler: &mut Sampler) -> (Law, u32, u32, f64) {
    let law = Law::linear(sampler.between(0.005, 0.05), sampler.between(0.5, 1.0));
    (law, sampler.one_of(&[2, 3, 4]), sampler.one_of(&[1, 2]), sampler.between(0.002, 0.01))
}

/// The frequencies with ω₁/ω = n + 1/(2p) and n − 1/(2p).
fn frequencies(law: &Law, p: u32, n: u32) -> Result<[f64; 2], CheckError> {
    let theory = LinearOscillator::new(law.damping, 1.0)?;
    Ok([theory.resonance(p, n)?.forcing_frequency(), theory.virtual_resonance_frequency(p, n)?])
}

/// Close to p = 2, n = 1, where theorem 2.5 holds, a stable two-loop MPS attracts beyond grazing.
pub(crate) fn stable_two_loops() -> CheckResult {
    let place = ResonantSpecimen::find(Law::linear(printed("zeta"), printed("epsilon")), 2, 1)?;
    let theorem = place.resonance.theorem();
    let mut cases = Votes::default();
    cases.see(theorem.saddle_node().coefficient < 0.0);
    let equations = place.resonance.equations().with_formulation(Formulation::FixedPhase);
    let [_, omega] = place.resonance.orbit().oscillator().parameters();
    for k in -2..=2 {
        // Frequencies so close that the quadratic unfolding of size cη² is below 𝒜 − 𝒜_graz.
        let eta = omega * 5e-4 * f64::from(k);
        let amplitude = place.grazing(eta).ok_or("no grazing orbit")?.primary();
        for share in [0.01, 0.02, 0.04] {
            let (mu, branch) = (share * amplitude, theorem.branch());
            // At resonance μ = k₂y² to leading order.
            let velocity = (mu / branch.k_2).sqrt();
            let start = place.near([velocity, branch.k_1 * velocity, mu, eta]).ok_or("no grazing orbit")?;
            let zero = at_parameters(&equations, start.unknowns).ok_or("no MPS past grazing")?;
            let solution = equations.solution(&zero);
            cases.see(
                solution.admissible()
                    && solution.stable()
                    && followed(&equations, &zero) == ReturnOutcome::Returns
                    && attracts(&equations, &zero) == Some(true),
            );
        }
    }
    Ok(cases.outcome("frequencies at the p = 2, n = 1 resonance, amplitudes 1 to 4 per cent past grazing"))
}

checks! {
    /// eq:resonance1: a₁₂ of the numerical map vanishes at ω₁/ω = n/2 and nowhere else.
    // a₁₂ is accurate to 10⁻¹⁴, and its slope in ω₁/ω is about ten times E₁, with E₁ above 0.01.
    one_loop: drawn(121, 4) |sampler; largest: Deviations| {
        let theory = LinearOscillator::new(sampler.between(0.01, 0.2), 0.7)?;
        let halves = (1..8).map(|n| 0.5 * f64::from(n));
        let expected = only_zeros(largest, &theory, |point| point.map.a.m12, halves)?;
        let omega_1 = theory.damped_natural_frequency();
        let listed = theory.resonances(&[1], omega_1 / RATIOS[1], omega_1 / RATIOS[0])?;
        largest.require(listed.len() == expected);
        for resonance in listed {
            let ratio = omega_1 / resonance.forcing_frequency();
            largest.compare(ratio, 0.5 * f64::from(resonance.index()), 1.0);
        }
    } => largest.outcome(1e-13, "zeros of the numerical a₁₂ in a range of ω₁/ω, by bracketing");
    /// eq:resonancep: κ_p of the numerical map vanishes at ω₁/ω = n ± 1/(2p) and nowhere else.
    // The tolerance is derived as for one loop.
    many_loops: drawn_over(122, [2, 3, 4, 7]) |sampler, p; largest: Deviations| {
        let theory = LinearOscillator::new(sampler.between(0.01, 0.2), 0.7)?;
        let offset = 0.5 / f64::from(p);
        let expected = (0..=4).flat_map(|n| [f64::from(n) - offset, f64::from(n) + offset]);
        let kappa = |point: &GrazingPoint| {
            let map = point.map;
            map.trace() - 2.0 * map.determinant().sqrt() * libm::cos(PI / f64::from(p))
        };
        only_zeros(largest, &theory, kappa, expected)?;
        for n in 1..5 {
            let omega_1 = theory.damped_natural_frequency();
            largest.compare(
                omega_1 / theory.resonance(p, n)?.forcing_frequency(),
                f64::from(n) + offset,
                1.0,
            );
            largest.compare(omega_1 / theory.virtual_resonance_frequency(p, n)?, f64::from(n) - offset, 1.0);
        }
    } => largest.outcome(1e-14, "zeros of the numerical κ_p in a range of ω₁/ω, p = 2, 3, 4, 7, by bracketing");
    /// The display after eq:resonancep: a₁₂ at the resonances of either sign, and the sign of a₁₂α.
    // The tolerance is that of A.
    off_diagonal: drawn(123, 60) |sampler; largest: Deviations| {
        let theory = LinearOscillator::new(sampler.between(0.005, 0.2), sampler.between(0.1, 1.0))?;
        let (p, n) = (sampler.one_of(&[2, 3, 4, 5, 8]), sampler.one_of(&[1, 2, 3]));
        for sign in [1.0, -1.0] {
            let omega = if sign > 0.0 {
                theory.resonance(p, n)?.forcing_frequency()
            } else {
                theory.virtual_resonance_frequency(p, n)?
            };
            let decay = libm::exp(-2.0 * PI * theory.damping_ratio() / omega);
            let stated =
                sign * decay / (f64::from(n) + sign * 0.5 / f64::from(p)) * libm::sin(PI / f64::from(p));
            let point = measured(&theory, omega)?;
            largest.compare(point.map.a.m12, stated, 1.0);
            if sign > 0.0 {
                largest.compare(theory.resonance(p, n)?.off_diagonal(), stated, 1.0);
            }
            largest.require(point.map.a.m12 * point.alpha() * sign > 0.0);
        }
    } => largest.outcome(1e-13, "resonances with either sign of random oscillators");
    /// At ω₁/ω = n − 1/(2p) the hypothesis a₁₂α > 0 fails, and the nearby zero of V with y > 0 is
    /// virtual: its orbit meets the wall too early. At n + 1/(2p) neither is the case.
    virtual_solutions: drawn(124, 40) |sampler; cases: Votes| {
        let (law, p, n, beside) = beside_resonance(sampler);
        let off = 1.0 + sampler.one_of(&[-1.0, 1.0]) * beside;
        for (frequency, real) in frequencies(&law, p, n)?.into_iter().zip([true, false]) {
            let orbit = law.grazing(frequency * off)?;
            cases.see(match GenericGrazing::check(&orbit.grazing_point(), p) {
                Ok(_) => real,
                Err(violated) => {
                    let only = Quantity::OffDiagonalTimesSquareRootFactor;
                    !real && violated.violated().all(|hypothesis| hypothesis.quantity == only)
                }
            });
            let (equations, zero) = (equations(&orbit, p), near_grazing(&orbit, p)?);
            cases.see(zero[0] > 0.0 && equations.solution(&zero).admissible() == real);
            let expected = if real { ReturnOutcome::Returns } else { ReturnOutcome::MeetsTheWall };
            cases.see(followed(&equations, &zero) == expected);
        }
    } => cases.outcome("random oscillators beside n ± 1/(2p): hypotheses, admissibility, simulation");
    /// Nordmark's conjecture: near n ± 1/(2p) the zero of V is an MPS if and only if a₁₂α > 0.
    conjecture: drawn(125, 40) |sampler; (cases, printed): (Votes, Votes)| {
        let (law, p, n, beside) = beside_resonance(sampler);
        for frequency in frequencies(&law, p, n)? {
            for off in [1.0 - beside, 1.0 + beside] {
                let orbit = law.grazing(frequency * off)?;
                let (point, zero) = (orbit.grazing_point(), near_grazing(&orbit, p)?);
                let seen = zero[0] > 0.0 && equations(&orbit, p).solution(&zero).admissible();
                cases.see(seen == (point.map.a.m12 * point.alpha() > 0.0));
                printed.see(seen);
            }
        }
    } =>
        cases.outcome("random oscillators to both sides of g_p, p = 2 to 4, with either sign of a₁₂α")
            .against_print(printed.measure());
}
