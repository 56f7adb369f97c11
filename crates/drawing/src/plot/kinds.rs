//! Objects of a parameter plane: bifurcation curves with the pen and the label of each kind,
//! codimension-two points, regions.

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo};
use grazing_results::Stability;
use grazing_results::kinds::{CurveLook, point_meaning, region_meaning};
use grazing_results::plane::{
    PlanePoint, RegionCorner, RegionKind, RegionVertex, SequenceVertex, SpecialPoint,
};

use crate::error::DrawingError;
use crate::geometry::sheet::{Bounds, Spot, along, area, length, near};
use crate::ink::elements::Filling;
use crate::ink::labels::{Labels, Site};
use crate::ink::legend;
use crate::ink::markers::Marker;
use crate::ink::style::{
    BLACK, Colour, LABEL_SIZE, MPS_AREA, NON_IMPACTING_AREA, Pen, SEVERAL_AREA, SMALL_LABEL_SIZE, UNDECIDED,
};
use crate::plot::axes::Panel;

pub(crate) fn pen(look: &CurveLook) -> Pen {
    Pen::dashed(look.colours[0], look.width, look.dashes)
}

/// The pen of the quadratic approximation to a curve.
fn approximation(look: &CurveLook) -> Pen {
    let [on_light, _] = look.approximation();
    Pen::dashed(on_light, CurveLook::APPROXIMATION_WIDTH, CurveLook::APPROXIMATION_DASHES)
}

/// The pen of a grazing curve where the grazing solution is not stable.
fn dotted(look: &CurveLook) -> Pen {
    Pen::dashed(look.colours[0], CurveLook::DOT, CurveLook::DOTS)
}

/// The colour of the label of a curve.
pub fn text_colour(bifurcation: Bifurcation) -> Colour {
    CurveLook::of(bifurcation).text
}

/// A description of a kind of curve in words, with its label.
fn meaning(bifurcation: Bifurcation) -> String {
    let meaning = CurveLook::of(bifurcation).meaning;
    match bifurcation {
        Bifurcation::NonImpactingGrazing => meaning.to_owned(),
        _ => format!("{meaning} ({})", bifurcation.name()),
    }
}

/// The label of a kind of curve, in markup; `grazing` is the name of the grazing curve of the
/// non-impacting solution.
pub fn label(bifurcation: Bifurcation, grazing: &str) -> &str {
    match bifurcation {
        Bifurcation::NonImpactingGrazing => grazing,
        other => other.name(),
    }
}

/// The kinds of lines in the parameter plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum TraceOf {
    /// A bifurcation curve.
    Bifurcation,
    /// A part of a grazing curve along which the grazing solution is unstable: no region ends there.
    UnstableGrazing,
    /// The same where it is neutral.
    NeutralGrazing,
    /// The quadratic approximation to a curve.
    Approximation,
}

/// A curve of the parameter plane; points are (across, up).
pub struct Trace {
    /// The bifurcation along the curve.
    pub kind: Bifurcation,
    /// The kind of line.
    pub of: TraceOf,
    /// The points of the line; a point that is NaN breaks it.
    pub points: Vec<(f64, f64)>,
}

/// The admissible parts of curves, as lines.
pub fn shown_curves(points: &[PlanePoint]) -> Vec<Trace> {
    let place = |point: &PlanePoint| (point.kind, point.loops, point.n, point.at.arc);
    points.chunk_by(|a, b| place(a) == place(b)).flat_map(traces).collect()
}

/// A curve as lines: where the grazing solution, if any, is stable, where it is unstable and where it is neutral.
fn traces(points: &[PlanePoint]) -> Vec<Trace> {
    let kind = points[0].kind;
    let last = points.len() - 1;
    let bounds = |index: usize| PlanePoint::bounds(points, index);
    let shown = |of, drawn: &dyn Fn(usize) -> bool| {
        let spot = |(index, point): (usize, &PlanePoint)| match point.at.admissible && drawn(index) {
            true => (point.at.primary, point.at.secondary),
            false => (f64::NAN, f64::NAN),
        };
        Trace { kind, of, points: points.iter().enumerate().map(spot).collect() }
    };
    let dotted = [(TraceOf::UnstableGrazing, false), (TraceOf::NeutralGrazing, true)].into_iter();
    let grazing = dotted.filter_map(|(of, neutral)| {
        let is = |index: usize| !bounds(index) && (points[index].at.stable == Stability::Neutral) == neutral;
        // The dotted part extends to the points at which the solid line begins.
        let near = |index: usize| (index.saturating_sub(1)..=last.min(index + 1)).any(is);
        (0..=last).any(is).then(|| shown(of, &near))
    });
    [shown(TraceOf::Bifurcation, &bounds)].into_iter().chain(grazing).collect()
}

/// Draws curves, with the wide grazing curve at the bottom and approximations above the curves that they
/// approximate; returns the pieces of all lines except approximations, which labels avoid.
///
/// # Errors
/// As [`Panel::draw_series`].
pub fn draw_curves(
    panel: &mut Panel<'_>,
    labels: &mut Labels<'_>,
    mut curves: Vec<Trace>,
) -> Result<Vec<(Bifurcation, Vec<Spot>)>, DrawingError> {
    curves.sort_by_key(|curve| (curve.kind != Bifurcation::NonImpactingGrazing, curve.of));
    let mut drawn = Vec::new();
    for Trace { kind, of, points } in &curves {
        let look = panel.canvas.look(*kind);
        let (pen, meaning) = match of {
            TraceOf::Bifurcation => (pen(&look), meaning(*kind)),
            TraceOf::UnstableGrazing | TraceOf::NeutralGrazing => {
                let stability = if *of == TraceOf::NeutralGrazing { "neutral" } else { "unstable" };
                (dotted(&look), format!("{}, where that is {stability}", look.meaning))
            }
            TraceOf::Approximation => {
                (approximation(&look), format!("quadratic approximation to {}", kind.name()))
            }
        };
        let lines = panel.curve(points, pen);
        for piece in panel.draw_series(lines)?.label(&meaning).legend(legend::line(pen))?.pieces {
            if *of == TraceOf::Approximation {
                labels.placer.keep_off_nameless(&piece);
            } else {
                labels.placer.keep_off(&piece);
                drawn.push((*kind, piece));
            }
        }
    }
    Ok(drawn)
}

/// Marks the places where curves were followed no further.
pub(crate) fn draw_ends(
    panel: &mut Panel<'_>,
    labels: &mut Labels<'_>,
    ends: impl Iterator<Item = (f64, f64)>,
) -> Result<(), DrawingError> {
    let meaning = "a curve could not be followed further (reason in its table)";
    panel.mark(labels, ends, Marker::Ring)?.label(meaning).legend(Marker::Ring.sample())?;
    Ok(())
}

impl Labels<'_> {
    /// Labels bifurcation curves with their kind, the longest first; those shorter than `least` (points)
    /// are not labelled.
    ///
    /// A curve is labelled once, even if it occurs twice, followed from its two ends. `grazing` is the
    /// name of the grazing curve of the non-impacting solution.
    ///
    /// # Errors
    /// The markup of a label is invalid.
    pub fn name_curves(
        &mut self,
        mut curves: Vec<(Bifurcation, Vec<Spot>)>,
        least: f64,
        grazing: &str,
    ) -> Result<(), DrawingError> {
        curves.sort_by(|a, b| length(&b.1).total_cmp(&length(&a.1)));
        let mut named: Vec<(Bifurcation, Vec<Spot>)> = Vec::new();
        for (kind, piece) in curves.into_iter().filter(|(_, piece)| length(piece) >= least) {
            let middle = along(&piece, 0.5).map(|(spot, _)| spot);
            let again = |other: &(Bifurcation, Vec<Spot>)| {
                other.0 == kind && middle.is_some_and(|spot| near(&other.1, spot, 1.5))
            };
            if named.iter().any(again) {
                continue;
            }
            let large = kind == Bifurcation::NonImpactingGrazing;
            let size = if large { LABEL_SIZE } else { SMALL_LABEL_SIZE };
            let colour = self.canvas.look(kind).text;
            self.add(label(kind, grazing), size, colour, &Site::Beside(&piece))?;
            named.push((kind, piece));
        }
        Ok(())
    }
}

/// Marks codimension-two points, resonances above the others; returns the visible ones with their places on the sheet.
///
/// # Errors
/// As [`Panel::draw_series`].
pub fn draw_points<'a>(
    panel: &mut Panel<'_>,
    labels: &mut Labels<'_>,
    points: &'a [SpecialPoint],
) -> Result<Vec<(&'a SpecialPoint, Spot)>, DrawingError> {
    let place = |point: &&SpecialPoint| (point.primary, point.secondary);
    let visible = points.iter().filter(|point| panel.frame.contains(place(point)));
    let (resonances, others): (Vec<_>, Vec<_>) =
        visible.partition(|point| point.kind == CodimensionTwo::Resonance);
    let mut drawn = Vec::new();
    for (points, marker, meaning) in [
        (others, Marker::Disc, "other codimension-two point"),
        (resonances, Marker::Triangle, point_meaning(CodimensionTwo::Resonance)),
    ] {
        let marks = panel.mark(labels, points.iter().map(place), marker)?;
        let marks = marks.label(meaning).legend(marker.sample())?;
        drawn.extend(points.into_iter().zip(marks.pieces.concat()));
    }
    Ok(drawn)
}

/// Draws regions of solutions with several impacts, and makes labels avoid hatching; returns the name and the
/// border of each that is decided and visible.
///
/// # Errors
/// As [`Panel::draw_series`].
pub fn draw_several(
    panel: &mut Panel<'_>,
    labels: &mut Labels<'_>,
    vertices: &[SequenceVertex],
) -> Result<Vec<(String, Vec<Spot>)>, DrawingError> {
    let region = |vertices: &[SequenceVertex]| {
        let rings = RegionCorner::rings(vertices.iter().map(|vertex| &vertex.at));
        (vertices[0].name(), DrawnRegion { p: 0, kind: vertices[0].kind, rings })
    };
    let mut regions: Vec<_> = vertices.chunk_by(|a, b| a.region == b.region).map(region).collect();
    regions.sort_by_key(|(_, region)| region.is_hatched());
    let mut named = Vec::new();
    for (name, region) in regions {
        let border = region.draw(panel)?;
        if region.is_hatched() {
            region.rings.iter().for_each(|ring| labels.placer.keep_off_nameless(&panel.spots(ring)));
        } else if !border.is_empty() {
            named.push((name, border));
        }
    }
    Ok(named)
}

/// The least fraction of a panel that a region with a name fills; smaller ones have no room for it in a narrow
/// figure.
const NAMED_SHARE: f64 = 0.016;

/// Writes the names of such regions into the larger ones of a panel, or beside them.
///
/// # Errors
/// A name cannot be set in the embedded fonts.
pub fn name_several(
    labels: &mut Labels<'_>,
    panel: Bounds,
    regions: &[(String, Vec<Spot>)],
) -> Result<(), DrawingError> {
    let least = NAMED_SHARE * (panel.right - panel.left) * (panel.bottom - panel.top);
    for (name, shape) in regions.iter().filter(|(_, shape)| area(shape) >= least) {
        let inside = labels.add(name, SMALL_LABEL_SIZE, BLACK, &Site::Within(shape))?;
        if !inside && let Some(spot) = labels.placer.deep_inside(shape) {
            labels.add(name, SMALL_LABEL_SIZE, BLACK, &Site::Around(spot, 1.0))?;
        }
    }
    Ok(())
}

/// A region of the parameter plane; vertices are (across, up).
pub(crate) struct DrawnRegion {
    pub(crate) p: u32,
    pub kind: RegionKind,
    /// The border of the region and those of its holes.
    pub(crate) rings: Vec<Vec<(f64, f64)>>,
}

impl DrawnRegion {
    /// Regions from their vertices: vertices with the same number form a region.
    pub(crate) fn all(vertices: &[RegionVertex]) -> Vec<Self> {
        let region = |vertices: &[RegionVertex]| DrawnRegion {
            p: vertices[0].loops,
            kind: vertices[0].kind,
            rings: RegionCorner::rings(vertices.iter().map(|vertex| &vertex.at)),
        };
        let mut regions: Vec<_> = vertices.chunk_by(|a, b| a.region == b.region).map(region).collect();
        regions.sort_by_key(Self::is_hatched);
        regions
    }

    /// Whether the region is hatched, above all that are shaded.
    fn is_hatched(&self) -> bool {
        self.kind == RegionKind::Undecided
    }

    /// Fills or hatches the region; returns its border on the sheet if any of it is visible.
    pub(crate) fn draw(&self, panel: &mut Panel<'_>) -> Result<Vec<Spot>, DrawingError> {
        if self.kind != RegionKind::Undecided {
            return shade(panel, &self.rings, self.kind);
        }
        let hatched = panel.draw_series(panel.area(&self.rings, Filling::Hatching(UNDECIDED)))?;
        hatched.label(region_meaning(self.kind)).legend(legend::hatching(UNDECIDED))?;
        Ok(Vec::new())
    }
}

/// Shades a region in which a solution is stable; returns its border on the sheet if any of it is visible.
///
/// # Errors
/// As [`Panel::draw_series`].
pub fn shade(
    panel: &mut Panel<'_>,
    rings: &[Vec<(f64, f64)>],
    kind: RegionKind,
) -> Result<Vec<Spot>, DrawingError> {
    let (more, paint) = match kind {
        RegionKind::NonImpacting => ("", NON_IMPACTING_AREA),
        RegionKind::SeveralImpacts => ("; K/P: K impacts in P periods", SEVERAL_AREA),
        _ => ("; darker where several are", MPS_AREA),
    };
    let area = panel.area(rings, paint);
    let border = area.as_ref().map_or_else(Vec::new, |area| panel.spots(area.border()));
    let meaning = format!("{}{more}", region_meaning(kind));
    panel.draw_series(area)?.label(&meaning).legend(legend::area(paint))?;
    Ok(border)
}
