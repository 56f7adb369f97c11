//! The rows that the paper's own tables do not have: quantities along the grazing curve, hypotheses and
//! coefficients of any oscillator, in its own units.

use core::f64::consts::TAU;

use grazing_continuation::bifurcation::Pair;
use grazing_model::ImpactOscillator;
use grazing_results::{Stability, row};
use grazing_theorems::hypothesis::Hypothesis;
use grazing_theorems::{GrazingPoint, ResonantPoint, Unfolding, auxiliary};
use grazing_unfold::units::InUnits;

use super::{AtResonance, CurveFinding, Curves, Unfolded};

/// A point of the grazing curve, with the grazing orbit and the Poincaré map around it.
#[derive(Clone, Copy, Debug)]
pub struct GrazingRow {
    arc: u32,
    wall: u32,
    parameters: [f64; 2],
    phase: f64,
    point: GrazingPoint,
    stable: Stability,
    admissible: bool,
}

row! { GrazingRow, |row| {
    let (point, map) = (&row.point, &row.point.map);
} [
    ARC = row.arc,
    WALL = row.wall,
    SECONDARY = row.parameters[1],
    PRIMARY = row.parameters[0],
    GRAZING_PHASE = row.phase,
    FREQUENCY = point.forcing_frequency,
    A11 = map.a.m11,
    A12 = map.a.m12,
    A21 = map.a.m21,
    A22 = map.a.m22,
    B1 = map.b.x,
    B2 = map.b.y,
    TAU = map.trace(),
    DELTA = map.determinant(),
    ALPHA = point.alpha(),
    BETA = map.transversality(),
    GAMMA = point.gamma,
    PHI = point.phi,
    PSI = point.psi,
    STABLE = row.stable,
    ADMISSIBLE = row.admissible,
] }

/// The grazing orbit and the map around it, point by point along the curve.
pub(super) fn grazing(unfolded: &Unfolded) -> Vec<GrazingRow> {
    let units = &unfolded.axes.units;
    let mut rows = Vec::new();
    for (arc, curve) in (0..).zip(&unfolded.diagram.grazing) {
        // Phases are continuous along a curve, and begin between -pi and pi.
        let first = curve.states.first().map_or(0.0, |first| first.orbit.phase());
        let turns = TAU * libm::round(first / TAU);
        rows.extend(curve.states.iter().map(|state| GrazingRow {
            arc,
            wall: unfolded.diagram.wall,
            parameters: units.parameters(state.orbit.oscillator().parameters()),
            phase: state.orbit.phase() - turns,
            point: state.orbit.grazing_point().in_units(units),
            stable: Stability::of(state.multipliers),
            admissible: state.admissible,
        }));
    }
    rows
}

/// The quantities at a point of a grazing curve that depend on p.
#[derive(Clone, Copy, Debug)]
pub struct GrazingLoopRow {
    pub(super) arc: u32,
    pub(super) wall: u32,
    pub(super) parameters: [f64; 2],
    pub(super) point: ResonantPoint,
}

row! { GrazingLoopRow, |row| {
    let point = &row.point;
    let map = &point.grazing.map;
    let stability = point.stability_coefficients();
    let [a12_prime, kappa_prime] = slopes(point);
    let kappa = match point.loops() {
        1 => f64::NAN,
        loops => auxiliary::detuning(loops, map.trace(), map.determinant()),
    };
} [
    LOOPS = point.loops(),
    ARC = row.arc,
    WALL = row.wall,
    SECONDARY = row.parameters[1],
    PRIMARY = row.parameters[0],
    A12 = map.a.m12,
    KAPPA = kappa,
    A12_PRIME = a12_prime,
    KAPPA_PRIME = kappa_prime,
    XI = point.second_phase_derivative,
    S_PLUS = stability.plus,
    S_MINUS = stability.minus,
] }

/// a₁₂' for p = 1 or κ_p' for p ≥ 2; the other is NaN.
pub(crate) fn slopes(point: &ResonantPoint) -> [f64; 2] {
    let Unfolding { loops, derivative } = point.unfolding;
    if loops == 1 { [derivative, f64::NAN] } else { [f64::NAN, derivative] }
}

/// A resonance at which the theorem holds, with the results for its SN and PD curves, and c_2GZ as
/// measured.
#[derive(Clone, Debug)]
pub struct CoefficientRow(AtResonance, Pair<CurveFinding>, f64, u32);

/// The resonances at which a theorem holds.
pub(super) fn coefficients(unfolded: &Unfolded) -> Vec<CoefficientRow> {
    let row = |(at, curves): (&AtResonance, &Curves)| {
        CoefficientRow(at.clone(), curves.findings, curves.doubled_grazing, unfolded.diagram.wall)
    };
    unfolded.unfolding().map(row).collect()
}

row! { CoefficientRow, |this| {
    let CoefficientRow(row, findings, doubled_grazing, wall) = this;
    let point = &row.point;
    let [_, _, sigma] = point.limit_map().numbers();
    let stability = point.stability_coefficients();
    let [a12_prime, kappa_prime] = slopes(point);
    let [sn, pd] = findings.map(|known| known.coefficient).into_array();
    let [sn_verdict, pd_verdict] = [sn.verdict(), pd.verdict()];
    let [sn_side, pd_side] = findings.map(|known| known.simulated).into_array();
} [
    LOOPS = row.loops,
    WALL = *wall,
    RESONANCE_INDEX = row.n,
    SECONDARY_AT_RESONANCE = row.parameters[1],
    PRIMARY_AT_GRAZING = row.parameters[0],
    S_PLUS = stability.plus,
    S_MINUS = stability.minus,
    C_SN = sn.theorem.value,
    C_PD = pd.theorem.value,
    C_SN_ERROR = sn.theorem.error,
    C_PD_ERROR = pd.theorem.error,
    C_SN_FIT = sn.measured().value,
    C_PD_FIT = pd.measured().value,
    C_SN_FIT_ERROR = sn.measured().error,
    C_PD_FIT_ERROR = pd.measured().error,
    SN_VERDICT = sn_verdict.name(),
    SN_REASON = sn_verdict.reason(),
    PD_VERDICT = pd_verdict.name(),
    PD_REASON = pd_verdict.reason(),
    TAU = point.grazing.map.trace(),
    DELTA = point.grazing.map.determinant(),
    ALPHA = point.grazing.alpha(),
    BETA = point.grazing.map.transversality(),
    GAMMA = point.grazing.gamma,
    XI = point.second_phase_derivative,
    A12_PRIME = a12_prime,
    KAPPA_PRIME = kappa_prime,
    SIGMA = sigma,
    PD_CRITICALITY = point.limit_map().criticality(),
    C_2GZ = point.doubled_grazing_coefficient(),
    C_2GZ_FIT = *doubled_grazing,
    SN_AS_SIMULATED = sn_side.name(),
    SN_SIMULATION_REASON = sn_side.reason(),
    PD_AS_SIMULATED = pd_side.name(),
    PD_SIMULATION_REASON = pd_side.reason(),
] }

/// A hypothesis of the theorem at a resonance, whether or not all of them hold.
#[derive(Clone, Debug)]
pub struct CheckedHypothesis {
    loops: u32,
    wall: u32,
    n: u32,
    parameters: [f64; 2],
    hypothesis: Hypothesis,
}

row! { CheckedHypothesis, |row| {} [
    LOOPS = row.loops,
    WALL = row.wall,
    RESONANCE_INDEX = row.n,
    SECONDARY = row.parameters[1],
    PRIMARY = row.parameters[0],
    THEOREM = if row.loops == 1 { "2.4" } else { "2.5" },
    HYPOTHESIS = row.hypothesis.statement().to_string(),
    HYPOTHESIS_VALUE = row.hypothesis.value,
    HOLDS = row.hypothesis.holds(),
] }

/// The hypotheses of the theorem at every resonance, one by one.
pub(super) fn hypotheses(unfolded: &Unfolded) -> Vec<CheckedHypothesis> {
    let wall = unfolded.diagram.wall;
    let asked = |at: &AtResonance| {
        let AtResonance { loops, n, parameters, .. } = *at;
        let checked = |hypothesis: &Hypothesis| CheckedHypothesis {
            loops,
            wall,
            n,
            parameters,
            hypothesis: *hypothesis,
        };
        at.hypotheses.iter().map(checked).collect::<Vec<_>>()
    };
    unfolded.resonances.iter().flat_map(asked).collect()
}
