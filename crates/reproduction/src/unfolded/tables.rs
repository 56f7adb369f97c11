//! The tables that only an oscillator in general has: quantities along the grazing curve, hypotheses, coefficients.

use core::f64::consts::TAU;

use grazing_continuation::criticality::coefficient_at_resonance;
use grazing_model::ImpactOscillator;
use grazing_theorems::hypothesis::Hypothesis;
use grazing_theorems::{ResonantPoint, Unfolding};
use grazing_unfold::units::InUnits;
use grazing_unfold::verdict::Coefficient;

use super::{Along, Unfolded};
use crate::StudyError;
use crate::table::{Table, columns, row};

/// `grazing.csv`: the grazing orbit and the map around it, point by point along the curve.
pub(super) fn grazing<O: ImpactOscillator>(unfolded: &Unfolded<O>) -> Result<Table, StudyError> {
    let [primary, secondary] = unfolded.axes.names();
    let units = &unfolded.axes.units;
    let mut columns = columns! {
        "arc": 0, secondary: 0.0, primary: 0.0, "phase": 0.0, "frequency": 0.0, "a11": 0.0, "a12": 0.0, "a21": 0.0,
        "a22": 0.0, "b1": 0.0, "b2": 0.0, "tau": 0.0, "delta": 0.0, "alpha": 0.0, "beta": 0.0, "gamma": 0.0, "phi": 0.0,
        "psi": 0.0, "stable": false, "admissible": false,
    };
    for (arc, curve) in (0..).zip(&unfolded.diagram.grazing) {
        // Phases are continuous along a curve, and begin between -pi and pi.
        let first = curve.states.first().map_or(0.0, |first| first.orbit.phase());
        let turns = TAU * libm::round(first / TAU);
        for state in &curve.states {
            let [primary, secondary] = units.parameters(state.orbit.oscillator().parameters());
            let point = state.orbit.grazing_point().in_units(units);
            let (a, b) = (point.map.a, point.map.b);
            columns.push(row![
                arc,
                secondary,
                primary,
                state.orbit.phase() - turns,
                point.forcing_frequency,
                a.m11,
                a.m12,
                a.m21,
                a.m22,
                b.x,
                b.y,
                point.map.trace(),
                point.map.determinant(),
                point.alpha(),
                point.map.transversality(),
                point.gamma,
                point.phi,
                point.psi,
                state.stable,
                state.admissible,
            ]);
        }
    }
    Ok(columns.finish("grazing")?)
}

/// `grazing_loops.csv`: what depends on p, along the grazing curve for each p.
pub(super) fn grazing_loops<O: ImpactOscillator>(unfolded: &Unfolded<O>) -> Result<Table, StudyError> {
    let [primary, secondary] = unfolded.axes.names();
    let units = &unfolded.axes.units;
    let mut columns = columns! {
        "p": 0, "arc": 0, secondary: 0.0, primary: 0.0, "a12": 0.0, "kappa": 0.0, "a12_prime": 0.0, "kappa_prime": 0.0,
        "xi": 0.0, "s_plus": 0.0, "s_minus": 0.0,
    };
    for Along { arc, parameters, point } in &unfolded.along {
        let ([primary, secondary], point) = (units.parameters(*parameters), point.in_units(units));
        let stability = point.stability_coefficients();
        let [a12_prime, kappa_prime] = slopes(&point);
        let map = &point.grazing.map;
        let kappa = match point.loops() {
            1 => f64::NAN,
            loops => grazing_theorems::auxiliary::detuning(loops, map.trace(), map.determinant()),
        };
        columns.push(row![
            point.loops(),
            *arc,
            secondary,
            primary,
            map.a.m12,
            kappa,
            a12_prime,
            kappa_prime,
            point.second_phase_derivative,
            stability.plus,
            stability.minus,
        ]);
    }
    Ok(columns.finish("grazing_loops")?)
}

/// a₁₂' and κ_p', whichever belongs to p; the other is not a number.
fn slopes(point: &ResonantPoint) -> [f64; 2] {
    match point.unfolding {
        Unfolding::OneLoop { off_diagonal_derivative } => [off_diagonal_derivative, f64::NAN],
        Unfolding::MultiLoop { detuning_derivative, .. } => [f64::NAN, detuning_derivative],
    }
}

/// `coefficients.csv`: the resonances at which a theorem holds.
pub(super) fn coefficients<O: ImpactOscillator>(unfolded: &Unfolded<O>) -> Result<Table, StudyError> {
    let (primary, secondary) =
        (format!("{}_graz", unfolded.axes.primary), format!("{}_star", unfolded.axes.secondary));
    let units = &unfolded.axes.units;
    let mut columns = columns! {
        "p": 0, "n": 0, secondary: 0.0, primary: 0.0, "s_plus": 0.0, "s_minus": 0.0, "c_sn": 0.0, "c_pd": 0.0,
        "c_sn_error": 0.0, "c_pd_error": 0.0, "c_sn_fit": 0.0, "c_pd_fit": 0.0, "c_sn_fit_error": 0.0,
        "c_pd_fit_error": 0.0, "sn_verdict": "", "sn_reason": "", "pd_verdict": "", "pd_reason": "", "tau": 0.0, "delta": 0.0,
        "alpha": 0.0, "beta": 0.0, "gamma": 0.0, "xi": 0.0, "a12_prime": 0.0, "kappa_prime": 0.0,
        "pd_criticality": 0.0, "sn_as_simulated": "", "sn_simulation_reason": "", "pd_as_simulated": "",
        "pd_simulation_reason": "",
    };
    for ((resonance, point), at) in unfolded.diagram.unfolding().zip(&unfolded.resonances) {
        let [_, _, primary, secondary] = point.unknowns().into();
        let [primary, secondary] = units.parameters([primary, secondary]);
        let known = &point.resonant_point().in_units(units);
        let stability = known.stability_coefficients();
        let [a12_prime, kappa_prime] = slopes(known);
        let theorem = at.coefficients.each_ref().map(|coefficient| coefficient.theorem);
        let fit = at.coefficients.each_ref().map(Coefficient::measured);
        let verdicts = at.coefficients.map(|coefficient| coefficient.verdict());
        columns.push(row![
            resonance.loops,
            resonance.n,
            secondary,
            primary,
            stability.plus,
            stability.minus,
            theorem[0].value,
            theorem[1].value,
            theorem[0].error,
            theorem[1].error,
            fit[0].value,
            fit[1].value,
            fit[0].error,
            fit[1].error,
            verdicts[0].name(),
            verdicts[0].reason(),
            verdicts[1].name(),
            verdicts[1].reason(),
            known.grazing.map.trace(),
            known.grazing.map.determinant(),
            known.grazing.alpha(),
            known.grazing.map.transversality(),
            known.grazing.gamma,
            known.second_phase_derivative,
            a12_prime,
            kappa_prime,
            coefficient_at_resonance(known),
            at.sides[0].name(),
            at.sides[0].reason(),
            at.sides[1].name(),
            at.sides[1].reason(),
        ]);
    }
    Ok(columns.finish("coefficients")?)
}

/// `hypotheses.csv`: for every resonance what its theorem asks, one by one.
pub(super) fn hypotheses<O: ImpactOscillator>(unfolded: &Unfolded<O>) -> Result<Table, StudyError> {
    let [primary, secondary] = unfolded.axes.names();
    let units = &unfolded.axes.units;
    let mut columns = columns! {
        "p": 0, "n": 0, secondary: 0.0, primary: 0.0, "theorem": "", "hypothesis": "", "value": 0.0, "holds": false,
    };
    for resonance in &unfolded.diagram.resonances {
        let [primary, secondary] = units.parameters(resonance.located.orbit().oscillator().parameters());
        let asked: &[Hypothesis] = match &resonance.theorem {
            Ok(point) => point.theorem().hypotheses(),
            Err(violated) => &violated.hypotheses,
        };
        let theorem = if resonance.loops == 1 { "2.4" } else { "2.5" };
        for hypothesis in asked {
            let condition = hypothesis.statement();
            let (n, value, holds) = (resonance.n, hypothesis.in_units(units).value, hypothesis.holds());
            columns.push(row![resonance.loops, n, secondary, primary, theorem, condition, value, holds]);
        }
    }
    Ok(columns.finish("hypotheses")?)
}
