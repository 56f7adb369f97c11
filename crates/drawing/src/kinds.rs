//! The bifurcations as the frames name them, with the pen and the label each is drawn with.

use crate::DrawingError;
use crate::frames::{Table, runs};
use crate::plane::Plane;
use crate::style::{Colour, GRAZ, MPS_GRAZING, PERIOD_DOUBLING, Pen, SADDLE_NODE};

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

/// A closed region of the parameter plane; vertices are (across, up).
pub(crate) struct Region {
    pub(crate) p: i64,
    pub(crate) impacting: bool,
    pub(crate) vertices: Vec<(f64, f64)>,
}

/// Reads a frame of regions: rows of one `region` number, in order, are one polygon.
pub(crate) fn read_regions(table: Table<'_>, plane: &Plane<'_>) -> Result<Vec<Region>, DrawingError> {
    let ids = table.integers("region")?;
    let impacting = table.words("kind", "non-impacting, mps", |word| match word {
        "non-impacting" => Some(false),
        "mps" => Some(true),
        _ => None,
    })?;
    let p = table.integers("p")?;
    let points = plane.points(table)?;
    Ok(runs(&ids)
        .into_iter()
        .map(|rows| Region {
            p: p[rows.start],
            impacting: impacting[rows.start],
            vertices: points[rows].to_vec(),
        })
        .collect())
}
