//! The bifurcations as the frames name them, with the pen and the label each is drawn with.

use crate::DrawingError;
use crate::axes::Panel;
use crate::frames::{Table, runs};
use crate::plane::Plane;
use crate::sheet::Spot;
use crate::style::{
    Colour, GRAZ, MPS_AREA, MPS_GRAZING, NON_IMPACTING_AREA, PERIOD_DOUBLING, Pen, SADDLE_NODE, UNDECIDED,
};

/// A kind of codimension-one bifurcation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Grazing of the non-impacting solution.
    Graz,
    /// Saddle-node bifurcation of an MPS.
    SaddleNode,
    /// Period-doubling bifurcation of an MPS.
    PeriodDoubling,
    /// Grazing of an MPS.
    Grazing,
}

impl Kind {
    /// The words the column `kind` may hold.
    pub(crate) const KNOWN: &'static str = "graz, SN, PD, GZ";

    pub(crate) fn parse(word: &str) -> Option<Kind> {
        match word {
            "graz" => Some(Kind::Graz),
            "SN" => Some(Kind::SaddleNode),
            "PD" => Some(Kind::PeriodDoubling),
            "GZ" => Some(Kind::Grazing),
            _ => None,
        }
    }

    pub(crate) fn pen(self) -> Pen {
        match self {
            Kind::Graz => GRAZ,
            Kind::SaddleNode => SADDLE_NODE,
            Kind::PeriodDoubling => PERIOD_DOUBLING,
            Kind::Grazing => MPS_GRAZING,
        }
    }

    /// The colour of the label: the pen's, darkened where that would be too light for text.
    pub(crate) fn text_colour(self) -> Colour {
        match self {
            Kind::Graz => Colour(40, 120, 40),
            other => other.pen().colour,
        }
    }

    /// The label, in the markup of labels.
    pub(crate) fn label(self) -> &'static str {
        match self {
            Kind::Graz => r"$\mathcal{A}_{\mathrm{graz}}$",
            Kind::SaddleNode => "SN",
            Kind::PeriodDoubling => "PD",
            Kind::Grazing => "GZ",
        }
    }
}

/// What is known of a region.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Shown {
    /// The non-impacting solution is stable.
    NonImpacting,
    /// An MPS is stable.
    Mps,
    /// Not decided.
    Undecided,
}

/// A region of the parameter plane; vertices are (across, up).
pub(crate) struct Region {
    pub(crate) p: i64,
    pub(crate) shown: Shown,
    /// Its border and those of its holes.
    pub(crate) rings: Vec<Vec<(f64, f64)>>,
}

impl Region {
    /// Fills or hatches the region; returns its border on the sheet, if any of it shows.
    pub(crate) fn draw(&self, panel: &Panel<'_>) -> Result<Vec<Spot>, DrawingError> {
        match self.shown {
            Shown::NonImpacting => panel.area(&self.rings, NON_IMPACTING_AREA),
            Shown::Mps => panel.area(&self.rings, MPS_AREA),
            Shown::Undecided => panel.hatch(&self.rings, UNDECIDED).map(|()| Vec::new()),
        }
    }
}

/// Reads a frame of regions: rows of one `region` number are one region, those of one `ring` of it, in order, one polygon.
pub(crate) fn read_regions(table: Table<'_>, plane: &Plane<'_>) -> Result<Vec<Region>, DrawingError> {
    let (ids, rings) = (table.integers("region")?, table.integers("ring")?);
    let shown = table.words("kind", "non-impacting, mps, undecided", |word| match word {
        "non-impacting" => Some(Shown::NonImpacting),
        "mps" => Some(Shown::Mps),
        "undecided" => Some(Shown::Undecided),
        _ => None,
    })?;
    let p = table.integers("p")?;
    let points = plane.points(table)?;
    let region = |rows: std::ops::Range<usize>| Region {
        p: p[rows.start],
        shown: shown[rows.start],
        rings: runs(&rings[rows.clone()])
            .into_iter()
            .map(|ring| points[rows.clone()][ring].to_vec())
            .collect(),
    };
    let mut regions: Vec<Region> = runs(&ids).into_iter().map(region).collect();
    // Hatching lies above what is shaded.
    regions.sort_by_key(|region| region.shown == Shown::Undecided);
    Ok(regions)
}
