//! The rows of an analysis that the paper's own tables do not have, in the oscillator's own units.

use core::f64::consts::TAU;

use grazing_continuation::bifurcation::Pair;
use grazing_model::ImpactOscillator;
use grazing_results::grazing::{GrazingLoopRow, GrazingRow};
use grazing_results::resonance::{CheckedHypothesis, CoefficientRow, Coefficients, Measured};
use grazing_results::{Dimensioned, Stability};

use super::{AtResonance, Curves, Unfolded};
use crate::diagram::Diagram;
use crate::parallel;
use crate::progress::Progress;
use crate::verdict::Coefficient;

/// The grazing orbit and the map around it, point by point along the curve.
pub(super) fn grazing(unfolded: &Unfolded) -> Vec<GrazingRow> {
    let mut rows = Vec::new();
    for (arc, curve) in (0..).zip(&unfolded.diagram.grazing) {
        // Phases are continuous along a curve, and begin between -pi and pi.
        let first = curve.states.first().map_or(0.0, |first| first.orbit.phase());
        let turns = TAU * libm::round(first / TAU);
        rows.extend(curve.states.iter().map(|state| {
            let [primary, secondary] = state.orbit.oscillator().parameters();
            GrazingRow {
                arc,
                wall: unfolded.diagram.wall,
                secondary,
                primary,
                phase: state.orbit.phase() - turns,
                point: state.orbit.grazing_point(),
                stable: Stability::of(state.multipliers),
                admissible: state.admissible,
            }
        }));
    }
    rows.with_dimensions(&unfolded.axes.units)
}

/// The stage in which quantities along the grazing curves are computed.
pub(super) const ALONG: &str = "quantities along the grazing curve";

/// The quantities that depend on p at each point of the grazing curves, dimensionless; empty if the computation is
/// cancelled.
pub(super) fn along(diagram: &Diagram, progress: &dyn Progress) -> Vec<GrazingLoopRow> {
    let states = (0..)
        .zip(&diagram.grazing)
        .flat_map(|(arc, curve)| curve.states.iter().map(move |state| (arc, state)));
    let states: Vec<_> = states.collect();
    progress.begin(ALONG, diagram.scope.loops.len() as u64);
    let mut all = Vec::new();
    for &loops in &diagram.scope.loops {
        // Where an iterate of P_global has no maximum near Π, these quantities do not exist.
        let found = parallel::map(&states, |(arc, state)| {
            let point = state.orbit.resonant_point(loops).ok()?;
            let [primary, secondary] = state.orbit.oscillator().parameters();
            Some(GrazingLoopRow { loops, arc: *arc, wall: diagram.wall, secondary, primary, point })
        });
        all.extend(found.into_iter().flatten());
        progress.step(ALONG);
    }
    progress.end(ALONG);
    if progress.stopped() { Vec::new() } else { all }
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

/// The resonances at which a theorem holds, as one wall sees them.
pub(super) fn coefficients(unfolded: &Unfolded) -> Vec<CoefficientRow> {
    let row = |(at, curves): (&AtResonance, &Curves)| {
        let (point, known) = (&at.point, curves.findings.map(|finding| finding.coefficient));
        let Pair { saddle_node: sn, period_doubling: pd } = known;
        let simulated = curves.findings.map(|finding| finding.simulated);
        let [_, _, sigma] = point.limit_map().numbers();
        CoefficientRow {
            loops: at.loops,
            wall: at.wall,
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
    unfolded.with_curves().map(row).collect()
}

/// The hypotheses of the theorem at every resonance, one by one.
pub(super) fn hypotheses(unfolded: &Unfolded) -> Vec<CheckedHypothesis> {
    let wall = unfolded.diagram.wall;
    let asked = |at: &AtResonance| {
        let &AtResonance { loops, n, parameters: [primary, secondary], .. } = at;
        let theorem = if loops == 1 { "2.4" } else { "2.5" };
        let rows = at.hypotheses.iter();
        let row =
            move |&hypothesis| CheckedHypothesis { loops, wall, n, secondary, primary, theorem, hypothesis };
        rows.map(row).collect::<Vec<_>>()
    };
    unfolded.resonances.iter().flat_map(asked).collect()
}
