//! The rows that only an oscillator in general has: quantities along the grazing curve, hypotheses, coefficients.

use core::f64::consts::TAU;

use grazing_continuation::bifurcation::Pair;
use grazing_continuation::criticality::coefficient_at_resonance;
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::ImpactOscillator;
use grazing_results::resonances::{Asked, GrazingLoops, GrazingPoint, Resonance};
use grazing_theorems::hypothesis::Hypothesis;
use grazing_theorems::{ResonantPoint, Unfolding};
use grazing_unfold::resonances;
use grazing_unfold::units::InUnits;

use super::{Along, AtResonance, Unfolded};

/// A resonance with what the theorem says of it.
type Found<'a, O> = (&'a resonances::Resonance<O>, &'a ResonantGrazingPoint<O>);

/// The grazing orbit and the map around it, point by point along the curve.
pub(super) fn grazing<O: ImpactOscillator>(unfolded: &Unfolded<O>) -> Vec<GrazingPoint> {
    let units = &unfolded.axes.units;
    let mut rows = Vec::new();
    for (arc, curve) in (0..).zip(&unfolded.diagram.grazing) {
        // Phases are continuous along a curve, and begin between -pi and pi.
        let first = curve.states.first().map_or(0.0, |first| first.orbit.phase());
        let turns = TAU * libm::round(first / TAU);
        rows.extend(curve.states.iter().map(|state| {
            let [primary, secondary] = units.parameters(state.orbit.oscillator().parameters());
            let point = state.orbit.grazing_point().in_units(units);
            let (a, b) = (point.map.a, point.map.b);
            GrazingPoint {
                arc,
                secondary,
                primary,
                phase: state.orbit.phase() - turns,
                frequency: point.forcing_frequency,
                a11: a.m11,
                a12: a.m12,
                a21: a.m21,
                a22: a.m22,
                b1: b.x,
                b2: b.y,
                tau: point.map.trace(),
                delta: point.map.determinant(),
                alpha: point.alpha(),
                beta: point.map.transversality(),
                gamma: point.gamma,
                phi: point.phi,
                psi: point.psi,
                stable: state.stable,
                admissible: state.admissible,
            }
        }));
    }
    rows
}

/// What depends on p, along the grazing curve for each p.
pub(super) fn grazing_loops<O: ImpactOscillator>(unfolded: &Unfolded<O>) -> Vec<GrazingLoops> {
    let units = &unfolded.axes.units;
    let row = |Along { arc, parameters, point }: &Along| {
        let ([primary, secondary], point) = (units.parameters(*parameters), point.in_units(units));
        let stability = point.stability_coefficients();
        let [a12_prime, kappa_prime] = slopes(&point);
        let map = &point.grazing.map;
        let kappa = match point.loops() {
            1 => f64::NAN,
            loops => grazing_theorems::auxiliary::detuning(loops, map.trace(), map.determinant()),
        };
        GrazingLoops {
            loops: point.loops(),
            arc: *arc,
            secondary,
            primary,
            a12: map.a.m12,
            kappa,
            a12_prime,
            kappa_prime,
            xi: point.second_phase_derivative,
            s_plus: stability.plus,
            s_minus: stability.minus,
        }
    };
    unfolded.along.iter().map(row).collect()
}

/// a₁₂' and κ_p', whichever belongs to p; the other is NaN.
fn slopes(point: &ResonantPoint) -> [f64; 2] {
    let Unfolding { loops, derivative } = point.unfolding;
    if loops == 1 { [derivative, f64::NAN] } else { [f64::NAN, derivative] }
}

/// The resonances at which a theorem holds.
pub(super) fn coefficients<O: ImpactOscillator>(unfolded: &Unfolded<O>) -> Vec<Resonance> {
    let units = &unfolded.axes.units;
    let resonances = unfolded.diagram.unfolding().zip(&unfolded.resonances);
    let row = |((resonance, point), at): (Found<'_, O>, &AtResonance)| {
        let [_, _, primary, secondary] = point.unknowns().into();
        let [primary, secondary] = units.parameters([primary, secondary]);
        let known = &point.resonant_point().in_units(units);
        let stability = known.stability_coefficients();
        let [a12_prime, kappa_prime] = slopes(known);
        let Pair { saddle_node: sn, period_doubling: pd } = &at.coefficients;
        let verdicts = at.coefficients.map(|coefficient| coefficient.verdict());
        let simulated = at.sides.as_ref();
        Resonance {
            loops: resonance.loops,
            n: resonance.n,
            secondary,
            primary,
            s_plus: stability.plus,
            s_minus: stability.minus,
            c_sn: sn.theorem.value,
            c_pd: pd.theorem.value,
            c_sn_error: sn.theorem.error,
            c_pd_error: pd.theorem.error,
            c_sn_fit: sn.measured().value,
            c_pd_fit: pd.measured().value,
            c_sn_fit_error: sn.measured().error,
            c_pd_fit_error: pd.measured().error,
            sn_verdict: verdicts.saddle_node.name(),
            sn_reason: verdicts.saddle_node.reason(),
            pd_verdict: verdicts.period_doubling.name(),
            pd_reason: verdicts.period_doubling.reason(),
            tau: known.grazing.map.trace(),
            delta: known.grazing.map.determinant(),
            alpha: known.grazing.alpha(),
            beta: known.grazing.map.transversality(),
            gamma: known.grazing.gamma,
            xi: known.second_phase_derivative,
            a12_prime,
            kappa_prime,
            pd_criticality: coefficient_at_resonance(known),
            sn_as_simulated: simulated.saddle_node.name(),
            sn_simulation_reason: simulated.saddle_node.reason(),
            pd_as_simulated: simulated.period_doubling.name(),
            pd_simulation_reason: simulated.period_doubling.reason(),
        }
    };
    resonances.map(row).collect()
}

/// For every resonance what its theorem asks, one by one.
pub(super) fn hypotheses<O: ImpactOscillator>(unfolded: &Unfolded<O>) -> Vec<Asked> {
    let units = &unfolded.axes.units;
    let mut rows = Vec::new();
    for resonance in &unfolded.diagram.resonances {
        let [primary, secondary] = units.parameters(resonance.located.orbit().oscillator().parameters());
        let asked: &[Hypothesis] = match &resonance.theorem {
            Ok(point) => point.theorem().hypotheses(),
            Err(violated) => &violated.hypotheses,
        };
        rows.extend(asked.iter().map(|hypothesis| Asked {
            loops: resonance.loops,
            n: resonance.n,
            secondary,
            primary,
            theorem: if resonance.loops == 1 { "2.4" } else { "2.5" },
            hypothesis: hypothesis.statement().to_string(),
            value: hypothesis.in_units(units).value,
            holds: hypothesis.holds(),
        }));
    }
    rows
}
