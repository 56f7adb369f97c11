//! Figure 9: an impact near the wall, and the points on the surfaces that it defines.

use polars::prelude::DataFrame;

use crate::DrawingError;
use crate::canvas::Canvas;
use crate::labels::Wanted;
use crate::scene::{CurveKind, Margin, PointKind, Scene, SurfaceKind};
use crate::style::{
    BLACK, LABEL_SIZE, RESET_COLOUR, RETURN_COLOUR, SMALL_LABEL_SIZE, SPOT_RADIUS, SheetWidth, TITLE_SIZE,
};

/// What Figure 9 shows.
///
/// Paper: Figure 9, fig:Bb.
#[derive(Debug, Clone, Copy)]
pub struct Figure09<'a> {
    /// Columns kind (orbit, virtual, reset, global), number, piece, layer, across, up, depth. Rows that follow each other
    /// with equal number and piece are one polyline.
    pub curves: &'a DataFrame,
    /// Columns kind (impact, recoil, virtual, section), number (of a point of the section: j of its superscript), layer, x,
    /// across, up, depth.
    pub points: &'a DataFrame,
    /// Columns as those of the curves; kind is incoming, outgoing, section (closed outlines), tangency, x_axis, y_axis or
    /// z_axis (lines).
    pub surfaces: &'a DataFrame,
}

/// Width in the paper.
const WIDTH_MM: f64 = 120.0;
const MARGIN: Margin = Margin { left: 8.0, right: 14.0, top: 14.0, bottom: 8.0 };

/// Draws Figure 9.
///
/// # Errors
/// [`DrawingError`] if a column is missing or of the wrong type, a kind is unknown, or a coordinate is missing.
pub fn draw_fig09(figure: &Figure09<'_>, width: SheetWidth) -> Result<String, DrawingError> {
    compose(figure, width)?.finish(
        "fig09",
        "Points on the impacting surface and on the section",
        "Solid: the orbit near the wall. Dashed: its virtual parts beyond the wall. Arrows: the reset law, and the global \
         map on the section.",
    )
}

pub(crate) fn compose(figure: &Figure09<'_>, width: SheetWidth) -> Result<Canvas, DrawingError> {
    let names = ["fig09_curves", "fig09_points", "fig09_surfaces"];
    let mut scene = Scene::read(names, [figure.curves, figure.points, figure.surfaces])?;
    let canvas = scene.fit("fig09", width.mm(WIDTH_MM), &MARGIN)?;
    scene.paint(&canvas)?;
    let mut labels = scene.labels(&canvas, TITLE_SIZE)?;
    for mark in &scene.points {
        let name = match mark.kind {
            PointKind::Impact => r"$(0,y_{\mathrm{imp}},z_{\mathrm{imp}})$".to_owned(),
            PointKind::Recoil => r"$(0,y_{\mathrm{rec}},z_{\mathrm{rec}})$".to_owned(),
            PointKind::Virtual => r"$(\hat{x},0,\hat{z})$".to_owned(),
            PointKind::Section => format!("$(x^{{({0})}},0,z^{{({0})}})$", mark.number),
            PointKind::Graze => continue,
        };
        labels.add(&name, LABEL_SIZE, BLACK, &Wanted::Around(mark.spot(), SPOT_RADIUS + 0.5))?;
    }
    for piece in &scene.curves {
        let (name, colour) = match piece.kind {
            CurveKind::Reset => ("$R$", RESET_COLOUR),
            CurveKind::Global => (r"$P_{\mathrm{global}}$", RETURN_COLOUR),
            _ => continue,
        };
        labels.add(name, SMALL_LABEL_SIZE, colour, &Wanted::Beside(&piece.spots()))?;
    }
    if let Some(incoming) = scene.surfaces.iter().find(|piece| piece.kind == SurfaceKind::Incoming) {
        labels.add(r"$\Sigma$", TITLE_SIZE, BLACK, &Wanted::Within(&incoming.spots()))?;
    }
    if let Some(section) = scene.surfaces.iter().find(|piece| piece.kind == SurfaceKind::Section) {
        labels.add(r"$\Pi$", TITLE_SIZE, BLACK, &Wanted::Within(&section.spots()))?;
    }
    labels.draw()?;
    Ok(canvas)
}
