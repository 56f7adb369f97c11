//! What a parameter plane shows: bifurcation curves with the pen and the label of each kind, codimension-two points, regions.

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo};
use grazing_results::plane::{RegionKind, RegionVertex, SpecialPoint};

use crate::axes::{Marker, Panel};
use crate::labels::Labels;
use crate::legend::Sample;
use crate::sheet::{Bounds, Spot};
use crate::style::{
    Colour, GRAZ, MPS_AREA, MPS_GRAZING, NON_IMPACTING_AREA, PERIOD_DOUBLING, Paint, Pen, SADDLE_NODE,
    UNDECIDED, approximation,
};

pub(crate) fn pen(bifurcation: Bifurcation) -> Pen {
    match bifurcation {
        Bifurcation::NonImpactingGrazing => GRAZ,
        Bifurcation::SaddleNode => SADDLE_NODE,
        Bifurcation::PeriodDoubling => PERIOD_DOUBLING,
        Bifurcation::Grazing => MPS_GRAZING,
    }
}

/// The colour of the label: the pen's, darkened where that would be too light for text.
pub(crate) fn text_colour(bifurcation: Bifurcation) -> Colour {
    match bifurcation {
        Bifurcation::NonImpactingGrazing => Colour(40, 120, 40),
        other => pen(other).colour,
    }
}

/// What a curve is, in words.
fn meaning(bifurcation: Bifurcation) -> &'static str {
    match bifurcation {
        Bifurcation::NonImpactingGrazing => "grazing of the non-impacting solution",
        Bifurcation::SaddleNode => "saddle-node bifurcation (SN)",
        Bifurcation::PeriodDoubling => "period-doubling bifurcation (PD)",
        Bifurcation::Grazing => "grazing of a maximal periodic solution (GZ)",
    }
}

/// The label, in the markup of labels; `grazing` names the grazing curve of the non-impacting solution.
pub(crate) fn label(bifurcation: Bifurcation, grazing: &str) -> &str {
    match bifurcation {
        Bifurcation::NonImpactingGrazing => grazing,
        other => other.name(),
    }
}

/// A curve of the parameter plane; points are (across, up).
pub(crate) struct Trace {
    pub(crate) kind: Bifurcation,
    /// Not the curve itself, but its quadratic approximation.
    pub(crate) approximate: bool,
    pub(crate) points: Vec<(f64, f64)>,
}

/// Draws curves, the wide grazing curve lowest, approximations on top of what they approximate; returns the pieces of the others, from which
/// labels are kept off.
pub(crate) fn draw_curves(
    panel: &Panel<'_>,
    labels: &mut Labels<'_>,
    mut curves: Vec<Trace>,
) -> Vec<(Bifurcation, Vec<Spot>)> {
    curves.sort_by_key(|curve| (curve.kind != Bifurcation::NonImpactingGrazing, curve.approximate));
    let mut drawn = Vec::new();
    for Trace { kind, approximate, points } in &curves {
        let pen = if *approximate { approximation(pen(*kind)) } else { pen(*kind) };
        for piece in panel.line(points, pen) {
            let approximation = || format!("quadratic approximation to {}", kind.name());
            let meaning = if *approximate { &approximation() } else { meaning(*kind) };
            panel.canvas.explain(meaning, Sample::Line(pen));
            if *approximate {
                labels.placer.keep_off_nameless(&piece);
            } else {
                labels.placer.keep_off(&piece);
                drawn.push((*kind, piece));
            }
        }
    }
    drawn
}

/// Marks codimension-two points, resonances above the others; returns those that are seen, with the boxes that they take.
pub(crate) fn draw_points<'a>(
    panel: &Panel<'_>,
    labels: &mut Labels<'_>,
    points: &'a [SpecialPoint],
) -> Vec<(&'a SpecialPoint, Bounds)> {
    let mut drawn = Vec::new();
    for (marker, resonances) in [(Marker::Disc, false), (Marker::Triangle, true)] {
        let (meaning, sample) = match resonances {
            true => ("resonant grazing bifurcation", Sample::Triangle),
            false => ("another codimension-two point", Sample::Disc),
        };
        for point in points.iter().filter(|point| (point.kind == CodimensionTwo::Resonance) == resonances) {
            if let Some(taken) = panel.marker((point.primary, point.secondary), marker) {
                panel.canvas.explain(meaning, sample);
                labels.placer.block(taken.grown(0.5));
                drawn.push((point, taken));
            }
        }
    }
    drawn
}

/// A region of the parameter plane; vertices are (across, up).
pub(crate) struct Area {
    pub(crate) p: u32,
    pub(crate) kind: RegionKind,
    /// Its border and those of its holes.
    pub(crate) rings: Vec<Vec<(f64, f64)>>,
}

impl Area {
    /// Regions from their vertices: those of one number are one region, those of one ring of it, in order, one polygon.
    pub(crate) fn all(vertices: &[RegionVertex]) -> Vec<Self> {
        let region = |vertices: &[RegionVertex]| Area {
            p: vertices[0].loops,
            kind: vertices[0].kind,
            rings: vertices
                .chunk_by(|a, b| a.ring == b.ring)
                .map(|ring| ring.iter().map(|vertex| (vertex.primary, vertex.secondary)).collect())
                .collect(),
        };
        let mut regions: Vec<_> = vertices.chunk_by(|a, b| a.region == b.region).map(region).collect();
        // Hatching lies above what is shaded.
        regions.sort_by_key(|region| region.kind == RegionKind::Undecided);
        regions
    }

    /// Fills or hatches the region; returns its border on the sheet, if any of it shows.
    pub(crate) fn draw(&self, panel: &Panel<'_>) -> Vec<Spot> {
        match self.kind {
            RegionKind::Undecided => {
                panel.canvas.explain("stability is not decided", Sample::Hatching(UNDECIDED));
                panel.hatch(&self.rings, UNDECIDED);
                Vec::new()
            }
            kind => panel.area(&self.rings, shade(panel, kind)),
        }
    }
}

/// The shade of a region in which something is stable, which the legend explains.
pub(crate) fn shade(panel: &Panel<'_>, kind: RegionKind) -> Paint {
    let (meaning, paint) = match kind {
        RegionKind::NonImpacting => ("the non-impacting solution is stable", NON_IMPACTING_AREA),
        _ => ("a maximal periodic solution is stable; darker where several are", MPS_AREA),
    };
    panel.canvas.explain(meaning, Sample::Area(paint));
    paint
}
