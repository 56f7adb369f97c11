//! Rows of a two-parameter diagram, dimensionless.

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo};
use grazing_continuation::mps::PeriodicSolution;
use grazing_input::OwnCurve;
use grazing_model::ImpactOscillator;
use grazing_model::phase::centred;
use grazing_results::Stability;
use grazing_results::plane::{OnCurve, OwnPoint, PlaneDiagram, PlanePoint, RegionVertex, SpecialPoint};

use crate::curves::DiagramCurve;
use crate::diagram::Diagram;
use crate::grazing::{GrazingCurve, GrazingEnd};
use crate::own_curves::FoundCurve;
use crate::regions::Region;

/// The rows of a diagram, without panels that magnify it and lines along which one-parameter diagrams run; if there are
/// two walls, as the first sees it and then as the other does. Dimensionless, as all rows here.
pub fn rows(first: &Diagram, other: Option<&Diagram>) -> PlaneDiagram {
    let mut all = PlaneDiagram {
        curves: curves(first),
        points: points(first),
        regions: regions_of(first),
        frame: first.scope.window.into(),
        magnified: Vec::new(),
        sections: Vec::new(),
        own: own_curves(first),
        measured: Vec::new(),
        several: Vec::new(),
        at_both_walls: Vec::new(),
    };
    if let Some(other) = other {
        all.curves.retain(|row| is_shown(row, first.wall));
        let arcs = all.curves.last().map_or(0, |row| row.at.arc + 1);
        let own = curves(other).into_iter().filter(|row| is_shown(row, other.wall));
        all.curves.extend(own.map(|mut row| {
            row.at.arc += arcs;
            row
        }));
        all.points.extend(points(other).into_iter().filter(|row| counts(row.loops, other.wall)));
        let regions = all.regions.last().map_or(0, |row| row.region);
        let own = regions_of(other).into_iter().filter(|row| counts(row.loops, other.wall));
        all.regions.extend(own.map(|row| RegionVertex { region: regions + row.region, ..row }));
    }
    all
}

/// Whether a curve is shown as a wall sees it, by one of its points: of what bounds motion without impacts the first of
/// two walls shows all but grazing of the other, which is a curve of the other view; and the other one nothing but its own
/// grazing.
pub fn is_shown(row: &PlanePoint, wall: u32) -> bool {
    match wall {
        0 => true,
        1 => row.wall > 0 || row.kind != Bifurcation::NonImpactingGrazing,
        _ => row.wall > 0,
    }
}

/// Whether solutions of p loops count as a wall sees them: motion without impacts is the same to both, and counts for the
/// first.
pub fn counts(loops: u32, wall: u32) -> bool {
    loops > 0 || wall < 2
}

/// Grazing curves and bifurcation curves, point by point.
pub fn curves(diagram: &Diagram) -> Vec<PlanePoint> {
    let curves = diagram.curves.iter().map(|curve| bifurcation_rows(diagram, curve));
    numbered(grazing_rows(diagram).into_iter().chain(curves))
}

/// The points of several curves, which are numbered in order from 0.
pub fn numbered(curves: impl IntoIterator<Item = Vec<PlanePoint>>) -> Vec<PlanePoint> {
    let numbered = (0..).zip(curves);
    numbered
        .flat_map(|(arc, curve)| {
            curve.into_iter().map(move |point| PlanePoint { at: OnCurve { arc, ..point.at }, ..point })
        })
        .collect()
}

/// The pieces of the grazing curve, not yet numbered.
pub fn grazing_rows(diagram: &Diagram) -> Vec<Vec<PlanePoint>> {
    let wall = diagram.wall;
    let rows = |curve: &GrazingCurve| {
        let points = curve.states.iter().map(|state| {
            let [primary, secondary] = state.orbit.oscillator().parameters();
            let map = state.orbit.grazing_point().map;
            PlanePoint {
                kind: Bifurcation::NonImpactingGrazing,
                loops: 0,
                wall,
                n: 0,
                at: OnCurve {
                    secondary,
                    primary,
                    impact_velocity: 0.0,
                    impact_phase: 0.0,
                    trace: map.trace(),
                    determinant: map.determinant(),
                    max_interior_x: f64::NAN,
                    stable: Stability::of(state.multipliers),
                    admissible: state.admissible,
                    arc: 0,
                    lost: String::new(),
                },
            }
        });
        with_ends(points, curve.ends.each_ref().map(GrazingEnd::lost))
    };
    diagram.grazing.iter().map(rows).collect()
}

/// A bifurcation curve, not yet numbered. It need not be in the diagram yet; the grazing curves must be.
pub fn bifurcation_rows(diagram: &Diagram, curve: &DiagramCurve) -> Vec<PlanePoint> {
    let equations = diagram.equations(curve.loops);
    let points = curve.curve.points.iter().map(|point| {
        let solution = &point.solution;
        let [velocity, phase] = equations.impact(solution);
        let [_, secondary] = solution.parameters();
        let phase = diagram.grazing_phase(secondary).map_or(f64::NAN, |graz| centred(phase - graz));
        PlanePoint {
            kind: curve.kind,
            loops: curve.loops,
            wall: if curve.loops > 0 { diagram.wall } else { 0 },
            n: curve.n,
            at: on_curve(curve.kind, solution, [velocity, phase]),
        }
    });
    with_ends(points, curve.curve.lost())
}

/// A solution on a curve of this kind, with the velocity and the phase of its impact; the curve has no number yet.
pub(crate) fn on_curve(
    kind: Bifurcation,
    solution: &PeriodicSolution,
    [velocity, phase]: [f64; 2],
) -> OnCurve {
    let [primary, secondary] = solution.parameters();
    OnCurve {
        secondary,
        primary,
        impact_velocity: velocity,
        impact_phase: phase,
        trace: solution.multipliers.trace,
        determinant: solution.multipliers.determinant,
        max_interior_x: solution.ceiling(),
        // At a torus bifurcation the multipliers are on the unit circle by definition.
        stable: match kind {
            Bifurcation::Torus => solution.stable().into(),
            _ => Stability::of(solution.multipliers),
        },
        admissible: solution.ceiling() <= PeriodicSolution::TOUCH,
        arc: 0,
        lost: String::new(),
    }
}

/// The points of a curve, of which the first and the last carry the reason why the curve was followed no further.
pub(crate) fn with_ends(
    points: impl Iterator<Item = PlanePoint>,
    [first, last]: [Option<String>; 2],
) -> Vec<PlanePoint> {
    let mut points: Vec<PlanePoint> = points.collect();
    if let (Some(point), Some(reason)) = (points.first_mut(), first) {
        point.at.lost = reason;
    }
    if let (Some(point), Some(reason)) = (points.last_mut(), last) {
        point.at.lost = reason;
    }
    points
}

/// The requested curves, point by point.
pub fn own_curves(diagram: &Diagram) -> Vec<OwnPoint> {
    let mut rows = Vec::new();
    for (arc, FoundCurve { request, loops, curve }) in (0..).zip(&diagram.own.curves) {
        let &OwnCurve { ref name, property, .. } = &diagram.requested[*request];
        // The kind of bifurcation is not used here.
        let curve = DiagramCurve { kind: Bifurcation::SaddleNode, loops: *loops, n: 0, curve: curve.clone() };
        rows.extend(bifurcation_rows(diagram, &curve).into_iter().map(|point| OwnPoint {
            name: name.clone(),
            property,
            loops: point.loops,
            at: OnCurve { arc, ..point.at },
        }));
    }
    rows
}

/// Resonances at which a theorem holds, and other codimension-two points.
pub fn points(diagram: &Diagram) -> Vec<SpecialPoint> {
    let point = |kind, loops, n, [primary, secondary]: [f64; 2]| {
        let wall = if loops > 0 { diagram.wall } else { 0 };
        SpecialPoint { kind, loops, wall, n, secondary, primary }
    };
    let resonances = diagram.unfolding().map(|(resonance, at)| {
        let [_, _, primary, secondary] = at.unknowns().into();
        point(CodimensionTwo::Resonance, resonance.loops, resonance.n, [primary, secondary])
    });
    let others = diagram
        .codimension_two
        .iter()
        .map(|other| point(other.kind, other.loops, other.n, other.event.solution.parameters()));
    resonances.chain(others).collect()
}

/// The regions of a diagram, with the wall that solutions hit.
fn regions_of(diagram: &Diagram) -> Vec<RegionVertex> {
    let mut rows = regions(&diagram.regions);
    rows.iter_mut().filter(|row| row.loops > 0).for_each(|row| row.wall = diagram.wall);
    rows
}

/// Regions of stability, vertex by vertex.
pub fn regions(regions: &[Region]) -> Vec<RegionVertex> {
    let rows = (1..).zip(regions).flat_map(|(number, region)| {
        let &Region { loops, n, .. } = region;
        let row = move |at| RegionVertex { region: number, kind: region.kind(), loops, wall: 0, n, at };
        region.vertices().map(row)
    });
    rows.collect()
}
