//! The rows that the paper's own tables do not have: quantities along the grazing curve, hypotheses and
//! coefficients of any oscillator, in its own units.

use core::f64::consts::TAU;

use grazing_continuation::bifurcation::Pair;
use grazing_model::ImpactOscillator;
use grazing_results::resonance::{Coefficients, Measured, Quantities, slopes};
use grazing_results::{Dimensioned, Stability, row, rows};
use grazing_theorems::hypothesis::Hypothesis;
use grazing_theorems::{GrazingPoint, ResonantPoint, auxiliary};
use grazing_unfold::verdict::Coefficient;

use super::{AtResonance, Curves, Unfolded};

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
            point: state.orbit.grazing_point().with_dimensions(units),
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

rows! {
    /// A resonance at which the theorem holds, with the results for its SN and PD curves, and c_2GZ as
    /// measured.
    CoefficientRow {
        loops: u32 = LOOPS,
        wall: u32 = WALL,
        n: u32 = RESONANCE_INDEX,
        secondary: f64 = SECONDARY_AT_RESONANCE,
        primary: f64 = PRIMARY_AT_GRAZING,
        coefficients: Coefficients,
        measured: Measured,
        c_sn_fit_error: f64 = C_SN_FIT_ERROR,
        c_pd_fit_error: f64 = C_PD_FIT_ERROR,
        sn_verdict: &'static str = SN_VERDICT,
        sn_reason: String = SN_REASON,
        pd_verdict: &'static str = PD_VERDICT,
        pd_reason: String = PD_REASON,
        quantities: Quantities,
        sigma: f64 = SIGMA,
        pd_criticality: f64 = PD_CRITICALITY,
        c_2gz: f64 = C_2GZ,
        c_2gz_fit: f64 = C_2GZ_FIT,
        sn_as_simulated: &'static str = SN_AS_SIMULATED,
        sn_simulation_reason: String = SN_SIMULATION_REASON,
        pd_as_simulated: &'static str = PD_AS_SIMULATED,
        pd_simulation_reason: String = PD_SIMULATION_REASON,
    }
}

/// What was measured of the coefficients.
pub(crate) fn measured(known: &Pair<Coefficient>) -> Measured {
    let Pair { saddle_node: sn, period_doubling: pd } = known;
    Measured {
        c_sn_error: sn.theorem.error,
        c_pd_error: pd.theorem.error,
        c_sn_fit: sn.measured().value,
        c_pd_fit: pd.measured().value,
    }
}

/// The resonances at which a theorem holds.
pub(super) fn coefficients(unfolded: &Unfolded) -> Vec<CoefficientRow> {
    let row = |(at, curves): (&AtResonance, &Curves)| {
        let (point, known) = (&at.point, curves.findings.map(|finding| finding.coefficient));
        let Pair { saddle_node: sn, period_doubling: pd } = known;
        let simulated = curves.findings.map(|finding| finding.simulated);
        let [_, _, sigma] = point.limit_map().numbers();
        CoefficientRow {
            loops: at.loops,
            wall: unfolded.diagram.wall,
            n: at.n,
            secondary: at.parameters[1],
            primary: at.parameters[0],
            coefficients: Coefficients { c_sn: sn.theorem.value, c_pd: pd.theorem.value, ..point.into() },
            measured: measured(&known),
            c_sn_fit_error: sn.measured().error,
            c_pd_fit_error: pd.measured().error,
            sn_verdict: sn.verdict().name(),
            sn_reason: sn.verdict().reason(),
            pd_verdict: pd.verdict().name(),
            pd_reason: pd.verdict().reason(),
            quantities: point.into(),
            sigma,
            pd_criticality: point.limit_map().criticality(),
            c_2gz: point.doubled_grazing_coefficient(),
            c_2gz_fit: curves.doubled_grazing,
            sn_as_simulated: simulated.saddle_node.name(),
            sn_simulation_reason: simulated.saddle_node.reason(),
            pd_as_simulated: simulated.period_doubling.name(),
            pd_simulation_reason: simulated.period_doubling.reason(),
        }
    };
    unfolded.unfolding().map(row).collect()
}

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
