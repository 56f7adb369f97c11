//! The bifurcations with the pen and the label each is drawn with, and the regions.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_results::plane::{RegionKind, RegionVertex};

use crate::axes::Panel;
use crate::sheet::Spot;
use crate::style::{
    Colour, GRAZ, MPS_AREA, MPS_GRAZING, NON_IMPACTING_AREA, PERIOD_DOUBLING, Pen, SADDLE_NODE, UNDECIDED,
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

/// The label, in the markup of labels.
pub(crate) fn label(bifurcation: Bifurcation) -> &'static str {
    match bifurcation {
        Bifurcation::NonImpactingGrazing => r"$\mathcal{A}_{\mathrm{graz}}$",
        other => other.name(),
    }
}

/// A region of the parameter plane; vertices are (across, up).
pub(crate) struct Region {
    pub(crate) p: u32,
    pub(crate) kind: RegionKind,
    /// Its border and those of its holes.
    pub(crate) rings: Vec<Vec<(f64, f64)>>,
}

impl Region {
    /// Regions from their vertices: those of one number are one region, those of one ring of it, in order, one polygon.
    pub(crate) fn all(vertices: &[RegionVertex]) -> Vec<Self> {
        let region = |vertices: &[RegionVertex]| Region {
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
            RegionKind::NonImpacting => panel.area(&self.rings, NON_IMPACTING_AREA),
            RegionKind::Mps | RegionKind::Both => panel.area(&self.rings, MPS_AREA),
            RegionKind::Undecided => {
                panel.hatch(&self.rings, UNDECIDED);
                Vec::new()
            }
        }
    }
}
