//! Section 3.2: the two-parameter diagram, Figure 7.

use crate::*;
use grazing_continuation::curve::CurveEnd;
use grazing_theorems::LinearOscillator;

/// The range of frequencies, from below the lowest resonance labelled in Figure 7 to above the highest.
const FREQUENCIES: [f64; 2] = [0.36, 0.95];

checks! {
    /// To the left of the grazing curve simulated orbits approach φ_p; to the right φ_p is not a
    /// solution.
    non_impacting_region: drawn(151, 60) |sampler; cases: Votes| {
        let theory = LinearOscillator::new(printed("zeta"), printed("epsilon"))?;
        let omega = sampler.between(FREQUENCIES[0], FREQUENCIES[1]);
        let grazing = theory.grazing(omega)?;
        let share = sampler.between(0.1, 0.999);
        let oscillator = grazing.model().with_parameters([share * grazing.amplitude(), omega]);
        let phase = sampler.between(0.0, TAU);
        let start = oscillator.non_impacting_solution(phase);
        // The displacement is up to a tenth of the distance to the wall, in a norm that never grows.
        let off = 0.1 * (1.0 - share) * sampler.between(-1.0, 1.0);
        let from = State { position: start.position + off, ..start };
        let periods = libm::ceil(5.0 / theory.damping_ratio() / oscillator.forcing_period());
        let end = Orbit::new(&oscillator, from, periods * oscillator.forcing_period(), 5).finish();
        cases.see(match end {
            OrbitEnd::TimeIsUp(end) => {
                libm::hypot(end.position - start.position, end.velocity - start.velocity) < 0.05 * off.abs()
            }
            _ => false,
        });
        let beyond = oscillator.with_parameters([grazing.amplitude() / share, omega]);
        cases.see(beyond.non_impacting_solution(grazing.phase()).position > 0.0);
    } => cases.outcome("points left and right of the grazing curve, simulated");
}

/// At each resonance of Figure 7 SN and PD curves leave and a GZ curve closes the region; the MPS is
/// stable on one side of SN and PD and unstable on the other, also in simulation.
pub(crate) fn boundaries() -> CheckResult {
    let theory = LinearOscillator::new(printed("zeta"), printed("epsilon"))?;
    let mut cases = Votes::default();
    let route = Route {
        window: Window { primary: [0.0, 1.4], secondary: [0.3, 1.1] },
        control: StepControl::DRAWING,
        step_limit: 20_000,
        stop_at_events: true,
        pace: None,
    };
    for resonance in theory.resonances(&[1, 2, 3], FREQUENCIES[0], FREQUENCIES[1])? {
        let grazing = resonance.grazing();
        let located = ResonantGrazingPoint::find(&grazing.model(), resonance.loops(), grazing.phase())?;
        let unfolded = located.unfold(&route)?;
        for curve in [&unfolded.saddle_node, &unfolded.period_doubling] {
            // The curve ends at grazing of the MPS, or continues to another resonance.
            cases.see(match &curve.end {
                CurveEnd::Grazing => true,
                CurveEnd::Event(event) => event.condition == Condition::InteriorGrazing,
                _ => false,
            });
            // In the middle of the curve, one step of the impact velocity to either side.
            let middle = curve.points[curve.points.len() / 2].solution.unknowns;
            let equations = located.equations().with_formulation(Formulation::FixedPhase);
            let beside = |factor: f64| {
                let point = at_velocity(&equations, &middle, factor * middle[unknown::VELOCITY])?;
                Some(equations.solution(&point))
            };
            let (lower, upper) = beside(0.98).zip(beside(1.02)).ok_or("no MPS beside the curve")?;
            // One side is stable, the other is not; simulation agrees where the solution is admissible.
            cases.see(lower.stable() != upper.stable());
            for solution in [lower, upper] {
                if solution.admissible() {
                    cases.see((attracts(&equations, &solution.unknowns) == Some(true)) == solution.stable());
                }
            }
        }
        // The region is closed by grazing of the MPS, which holds along the whole third curve.
        cases.see(!unfolded.grazing.is_empty());
        for curve in &unfolded.grazing {
            let inner = &curve.points[1..];
            cases.see(inner.iter().all(|point| point.solution.ceiling().abs() < 1e-11));
        }
    }
    Ok(cases.outcome("SN, PD and GZ curves at the resonances of Figure 7, crossed in simulation"))
}
