//! Rows of a two-parameter diagram for any oscillator and names of its parameters.

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo};
use grazing_continuation::mps::PeriodicSolution;
use grazing_model::ImpactOscillator;
use grazing_model::phase::centred;
use grazing_model::smooth::Units;
use grazing_results::plane::{
    MagnifiedPanel, MagnifiedPoint, OnCurve, OwnPoint, PlaneDiagram, PlanePoint, RegionVertex, Section,
    SpecialPoint, StraightenedCurves, StraightenedPoint,
};
use grazing_results::{Dimensioned, Frame, Names, Stability, TablePlan};
use grazing_unfold::diagram::{Diagram, DiagramCurve};
use grazing_unfold::grazing::{GrazingCurve, GrazingEnd};
use grazing_unfold::own_curves::{Level, LevelCurve};
use grazing_unfold::regions::Region;

/// The names of the two parameters, which head their columns, and the units of the tables, to which
/// dimensionless results are converted.
#[derive(Clone, Debug, PartialEq)]
pub struct Axes {
    /// The names; a name that is already that of another column has `_` appended.
    pub names: Names,
    /// The oscillator's own units.
    pub units: Units,
}

impl Axes {
    /// The axes of the paper's oscillator: amplitude and frequency.
    pub fn of_the_paper() -> Self {
        Self { names: Names::of_the_paper(), units: Units::ONE }
    }
}

/// The name of a parameter as a header in tables, with `_` appended while another column has that name.
pub(crate) fn own_header<'a>(name: &str, tables: impl Iterator<Item = &'a TablePlan>) -> String {
    let taken: Vec<_> = tables.flat_map(|table| table.columns).map(|column| column.name).collect();
    let mut name = name.to_owned();
    while taken.contains(&name.as_str()) {
        name.push('_');
    }
    name
}

/// A diagram with the panels that magnify it and the lines along which one-parameter diagrams run; if there are two
/// walls, as the first sees it and then as the other does.
pub fn plane_diagram(
    axes: &Axes,
    (first, other): (&Diagram, Option<&Diagram>),
    magnified: Vec<MagnifiedPanel>,
    sections: Vec<Section>,
) -> PlaneDiagram {
    let mut all = PlaneDiagram {
        curves: curves(axes, first),
        points: points(axes, first),
        regions: regions_of(axes, first),
        frame: first.scope.window.with_dimensions(&axes.units).into(),
        magnified,
        sections,
        own: own_curves(axes, first),
        measured: Vec::new(),
        several: Vec::new(),
        at_both_walls: Vec::new(),
    };
    if let Some(other) = other {
        all.curves.retain(|row| is_shown(row, first.wall));
        let arcs = all.curves.last().map_or(0, |row| row.at.arc + 1);
        let own = curves(axes, other).into_iter().filter(|row| is_shown(row, other.wall));
        all.curves.extend(own.map(|mut row| {
            row.at.arc += arcs;
            row
        }));
        all.points.extend(points(axes, other).into_iter().filter(|row| counts(row.loops, other.wall)));
        let regions = all.regions.last().map_or(0, |row| row.region);
        let own = regions_of(axes, other).into_iter().filter(|row| counts(row.loops, other.wall));
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
pub fn curves(axes: &Axes, diagram: &Diagram) -> Vec<PlanePoint> {
    let curves = diagram.curves.iter().map(|curve| bifurcation_rows(axes, diagram, curve));
    numbered(grazing_rows(axes, diagram).into_iter().chain(curves))
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
pub fn grazing_rows(axes: &Axes, diagram: &Diagram) -> Vec<Vec<PlanePoint>> {
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
        with_ends(&axes.units, points, curve.ends.each_ref().map(GrazingEnd::lost))
    };
    diagram.grazing.iter().map(rows).collect()
}

/// A bifurcation curve, not yet numbered. It need not be in the diagram yet; the grazing curves must be.
pub fn bifurcation_rows(axes: &Axes, diagram: &Diagram, curve: &DiagramCurve) -> Vec<PlanePoint> {
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
    with_ends(&axes.units, points, curve.curve.lost())
}

/// A solution on a curve of this kind, dimensionless, with the velocity and the phase of its impact; the curve has no number yet.
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

/// The dimensionless points of a curve in these units; the first and the last carry the reason why the curve was
/// followed no further.
pub(crate) fn with_ends(
    units: &Units,
    points: impl Iterator<Item = PlanePoint>,
    [first, last]: [Option<String>; 2],
) -> Vec<PlanePoint> {
    let mut points: Vec<PlanePoint> = points.map(|point| point.with_dimensions(units)).collect();
    if let (Some(point), Some(reason)) = (points.first_mut(), first) {
        point.at.lost = reason;
    }
    if let (Some(point), Some(reason)) = (points.last_mut(), last) {
        point.at.lost = reason;
    }
    points
}

/// The requested curves, point by point.
pub fn own_curves(axes: &Axes, diagram: &Diagram) -> Vec<OwnPoint> {
    let mut rows = Vec::new();
    for (arc, LevelCurve { level, loops, curve }) in (0..).zip(&diagram.levels.curves) {
        let Level { name, property, .. } = &diagram.asked[*level];
        let property = property.with_dimensions(&axes.units).to_string();
        // The kind of bifurcation is not used here.
        let curve = DiagramCurve { kind: Bifurcation::SaddleNode, loops: *loops, n: 0, curve: curve.clone() };
        rows.extend(bifurcation_rows(axes, diagram, &curve).into_iter().map(|point| OwnPoint {
            name: name.clone(),
            property: property.clone(),
            loops: point.loops,
            at: OnCurve { arc, ..point.at },
        }));
    }
    rows
}

/// Resonances at which a theorem holds, and other codimension-two points.
pub fn points(axes: &Axes, diagram: &Diagram) -> Vec<SpecialPoint> {
    let point = |kind, loops, n, [primary, secondary]: [f64; 2]| {
        let wall = if loops > 0 { diagram.wall } else { 0 };
        SpecialPoint { kind, loops, wall, n, secondary, primary }.with_dimensions(&axes.units)
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
fn regions_of(axes: &Axes, diagram: &Diagram) -> Vec<RegionVertex> {
    let mut rows = regions(axes, &diagram.regions);
    rows.iter_mut().filter(|row| row.loops > 0).for_each(|row| row.wall = diagram.wall);
    rows
}

/// Regions of stability, vertex by vertex.
pub fn regions(axes: &Axes, regions: &[Region]) -> Vec<RegionVertex> {
    let rows = (1..).zip(regions).flat_map(|(number, region)| {
        let &Region { loops, n, .. } = region;
        let row = move |at| RegionVertex { region: number, kind: region.kind(), loops, wall: 0, n, at };
        region.vertices().map(row)
    });
    rows.map(|row| row.with_dimensions(&axes.units)).collect()
}

/// Descriptions of resonances that could not be located, and of those whose curves could not be followed.
pub fn lost(diagram: &Diagram) -> impl Iterator<Item = String> {
    let unlocated = diagram.unlocated.iter().map(|lost| format!("p = {}: {}", lost.loops, lost.reason));
    unlocated.chain(diagram.not_unfolded.iter().map(|lost| format!("{}: {}", lost.name(), lost.reason)))
}

/// Curves of magnifications, panel by panel from 1.
pub fn magnified_curves<'a>(
    panels: impl IntoIterator<Item = &'a Vec<MagnifiedPoint>>,
) -> Vec<MagnifiedPoint> {
    let panels = (1..).zip(panels);
    panels
        .flat_map(|(panel, points)| points.iter().map(move |point| MagnifiedPoint { panel, ..point.clone() }))
        .collect()
}

/// The leading digits of the |η| at which curves are straightened, for each decade.
const PER_DECADE: [f64; 5] = [1.0, 1.6, 2.5, 4.0, 6.3];
/// The number of decades.
const DECADES: i32 = 8;

/// Values of |η| over eight decades up to the largest power of ten within a range of the secondary
/// parameter, all in the parameter's own unit, in which they are round numbers.
pub fn straightened_etas([low, high]: [f64; 2]) -> Vec<f64> {
    let top = libm::floor(libm::log10(high - low)) as i32;
    let decade = |power: i32| PER_DECADE.map(|digits| round(digits, power));
    (top - DECADES..top).flat_map(decade).chain([round(1.0, top)]).collect()
}

/// The number `digits`·10^`power`, correctly rounded.
fn round(digits: f64, power: i32) -> f64 {
    format!("{digits}e{power}").parse().unwrap_or(f64::NAN)
}

/// Margin of a panel as a fraction of the extent of the limits.
const STRAIGHTENED_MARGIN: f64 = 0.25;

/// Curves in straightened coordinates, with a panel for each resonance that has curves; the frames of the
/// panels are chosen here. All in the oscillator's own units.
pub fn straightened<'a>(
    panels: impl IntoIterator<Item = (MagnifiedPanel, &'a [StraightenedPoint])>,
) -> StraightenedCurves {
    let (mut rows, mut shown) = (Vec::new(), Vec::new());
    for (panel, points) in panels {
        rows.extend(points.iter().map(|point| StraightenedPoint { panel: panel.panel, ..point.clone() }));
        let limits = || points.iter().map(|point| point.limit);
        let [low, high] = [limits().fold(0.0, f64::min), limits().fold(0.0, f64::max)];
        let margin = STRAIGHTENED_MARGIN * (high - low);
        let farthest = points.iter().map(|point| point.eta.abs()).fold(0.0, f64::max);
        if farthest > 0.0 && margin > 0.0 {
            let frame = Frame { x: [low - margin, high + margin], y: [-farthest, farthest] };
            shown.push(MagnifiedPanel { frame, ..panel });
        }
    }
    StraightenedCurves { curves: rows, panels: shown }
}
