//! Tables of a two-parameter diagram, whatever the oscillator and its parameters are called.

use core::f64::consts::{PI, TAU};

use grazing_continuation::curve::CurvePoint;
use grazing_continuation::mps::MaximalPeriodicSolution;
use grazing_model::ImpactOscillator;
use grazing_model::smooth::Units;
use grazing_unfold::diagram::{Diagram, DiagramCurve};
use grazing_unfold::grazing::{GrazingCurve, GrazingState};
use grazing_unfold::magnification::Polyline;
use grazing_unfold::regions::{Region, RegionKind};
use grazing_unfold::units::InUnits;

use crate::StudyError;
use crate::table::{Cell, Columns, Table, columns, row};

/// The names of the two parameters, which head their columns, and the units in which the tables count what was found without dimensions.
#[derive(Clone, Debug, PartialEq)]
pub struct Axes {
    /// The primary parameter μ.
    pub primary: String,
    /// The secondary parameter η.
    pub secondary: String,
    /// The oscillator's own units.
    pub units: Units,
}

/// Names of columns of these tables, which a parameter's column must not repeat.
const TAKEN: &[&str] = &[
    "kind",
    "p",
    "n",
    "arc",
    "region",
    "panel",
    "ring",
    "reason",
    "source",
    "impact_velocity",
    "impact_phase",
    "trace",
    "determinant",
    "max_interior_x",
    "stable",
    "admissible",
    "phase",
    "a11",
    "a12",
    "a21",
    "a22",
    "b1",
    "b2",
    "frequency",
    "tau",
    "delta",
    "alpha",
    "beta",
    "gamma",
    "phi",
    "psi",
    "kappa",
    "xi",
    "a12_prime",
    "kappa_prime",
    "s_plus",
    "s_minus",
    "c_sn",
    "c_pd",
    "theorem",
    "hypothesis",
    "value",
    "holds",
];

impl Axes {
    /// The columns of parameters with these names; `_` is added to one that names another column.
    pub fn new(primary: &str, secondary: &str, units: Units) -> Self {
        let column = |name: &str| {
            let mut column = name.to_owned();
            while TAKEN.contains(&column.as_str()) {
                column.push('_');
            }
            column
        };
        Self { primary: column(primary), secondary: column(secondary), units }
    }

    /// The forcing amplitude and frequency of the paper's oscillator.
    pub fn of_the_paper() -> Self {
        Self::new("amplitude", "omega", Units::ONE)
    }

    pub(crate) fn names(&self) -> [&str; 2] {
        [&self.primary, &self.secondary]
    }
}

/// Grazing curves and bifurcation curves, point by point.
///
/// # Errors
/// The table could not be made.
pub fn curves<O: ImpactOscillator>(
    name: &'static str,
    axes: &Axes,
    diagram: &Diagram<O>,
) -> Result<Table, StudyError> {
    let curves = diagram.curves.iter().map(|curve| bifurcation_rows(axes, diagram, curve));
    joined(name, axes, grazing_rows(axes, diagram).into_iter().chain(curves))
}

/// The rows of a curve but for its number.
pub(crate) type CurveRows = Vec<[Cell; 12]>;

/// The table of curves, numbered in their order.
pub(crate) fn joined(
    name: &'static str,
    axes: &Axes,
    curves: impl IntoIterator<Item = CurveRows>,
) -> Result<Table, StudyError> {
    let [primary, secondary] = axes.names();
    let mut columns = columns! {
        "kind": "", "p": 0, "n": 0, secondary: 0.0, primary: 0.0, "impact_velocity": 0.0, "impact_phase": 0.0,
        "trace": 0.0, "determinant": 0.0, "max_interior_x": 0.0, "stable": false, "admissible": false, "arc": 0,
    };
    for (arc, curve) in (0..).zip(curves) {
        for [
            kind,
            p,
            n,
            secondary,
            primary,
            velocity,
            phase,
            trace,
            determinant,
            ceiling,
            stable,
            admissible,
        ] in curve
        {
            columns.push([
                kind,
                p,
                n,
                secondary,
                primary,
                velocity,
                phase,
                trace,
                determinant,
                ceiling,
                stable,
                admissible,
                Cell::Integer(arc),
            ]);
        }
    }
    Ok(columns.finish(name)?)
}

/// The pieces of the grazing curve.
pub(crate) fn grazing_rows<O: ImpactOscillator>(axes: &Axes, diagram: &Diagram<O>) -> Vec<CurveRows> {
    let rows = |curve: &GrazingCurve<O>| {
        let row = |state: &GrazingState<O>| {
            let [primary, secondary] = axes.units.parameters(state.orbit.oscillator().parameters());
            let map = state.orbit.grazing_point().map;
            let (stable, admissible) = (state.stable, state.admissible);
            let (trace, determinant) = (map.trace(), map.determinant());
            row!["graz", 0, 0, secondary, primary, 0.0, 0.0, trace, determinant, f64::NAN, stable, admissible]
        };
        curve.states.iter().map(row).collect()
    };
    diagram.grazing.iter().map(rows).collect()
}

/// A bifurcation curve, which need not be in the diagram yet; its grazing curves are.
pub(crate) fn bifurcation_rows<O: ImpactOscillator>(
    axes: &Axes,
    diagram: &Diagram<O>,
    curve: &DiagramCurve,
) -> CurveRows {
    let units = &axes.units;
    let row = |point: &CurvePoint| {
        let solution = &point.solution;
        let [velocity, phase, _, eta] = solution.unknowns.into();
        let [primary, secondary] = units.parameters(solution.parameters());
        row![
            curve.kind.name(),
            curve.loops,
            curve.n,
            secondary,
            primary,
            velocity * units.velocity(),
            diagram.grazing_phase(eta).map_or(f64::NAN, |graz| centred(phase - graz)),
            solution.multipliers.trace,
            solution.multipliers.determinant,
            solution.ceiling() * units.length,
            solution.stable(),
            solution.ceiling() <= MaximalPeriodicSolution::TOUCH,
        ]
    };
    curve.curve.points.iter().map(row).collect()
}

/// Resonances at which a theorem holds, and other codimension-two points.
///
/// # Errors
/// The table could not be made.
pub fn points<O: ImpactOscillator>(
    name: &'static str,
    axes: &Axes,
    diagram: &Diagram<O>,
) -> Result<Table, StudyError> {
    let [primary, secondary] = axes.names();
    let mut columns = columns! { "kind": "", "p": 0, "n": 0, secondary: 0.0, primary: 0.0 };
    for (resonance, point) in diagram.unfolding() {
        let [_, _, primary, secondary] = point.unknowns().into();
        let [primary, secondary] = axes.units.parameters([primary, secondary]);
        columns.push(row!["resonance", resonance.loops, resonance.n, secondary, primary]);
    }
    for corner in &diagram.corners {
        let [primary, secondary] = axes.units.parameters(corner.event.solution.parameters());
        columns.push(row![corner.kind, corner.loops, corner.n, secondary, primary]);
    }
    Ok(columns.finish(name)?)
}

/// Regions of stability, corner by corner.
///
/// # Errors
/// The table could not be made.
pub fn regions(name: &'static str, axes: &Axes, regions: &[Region]) -> Result<Table, StudyError> {
    let [primary, secondary] = axes.names();
    let mut columns = columns! {
        "region": 0, "kind": "", "p": 0, "n": 0, secondary: 0.0, primary: 0.0, "ring": 0, "reason": "",
    };
    for (number, region) in (1..).zip(regions) {
        let reason = match &region.kind {
            RegionKind::Undecided(doubt) => doubt.in_units(&axes.units).to_string(),
            _ => String::new(),
        };
        for (ring, vertices) in (0..).zip(&region.rings) {
            for vertex in vertices {
                let [primary, secondary] = axes.units.parameters(*vertex);
                let (kind, reason) = (region.kind.name(), reason.as_str());
                columns.push(row![number, kind, region.loops, region.n, secondary, primary, ring, reason]);
            }
        }
    }
    Ok(columns.finish(name)?)
}

/// Curves of magnifications, panel by panel from 1; their points are in the oscillator's own units.
///
/// # Errors
/// The table could not be made.
pub fn magnifications(
    name: &'static str,
    axes: &Axes,
    panels: &[Vec<Polyline>],
) -> Result<Table, StudyError> {
    let [primary, secondary] = axes.names();
    let mut columns: Columns =
        columns! { "panel": 0, "kind": "", "source": "", "arc": 0, secondary: 0.0, primary: 0.0 };
    for (panel, polylines) in (1..).zip(panels) {
        for (arc, polyline) in (1..).zip(polylines) {
            for [primary, secondary] in &polyline.points {
                let (kind, source) = (polyline.kind_name(), polyline.source.name());
                columns.push(row![panel, kind, source, arc, *secondary, *primary]);
            }
        }
    }
    Ok(columns.finish(name)?)
}

/// An angle brought into (−π, π].
pub(crate) fn centred(angle: f64) -> f64 {
    let turned = angle - TAU * libm::floor(angle / TAU);
    if turned > PI { turned - TAU } else { turned }
}
