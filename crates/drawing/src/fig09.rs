//! Figure 9: an impact near the wall, and the points on the surfaces that it defines.

use grazing_results::space::{CurveKind, MarkKind, SurfaceKind};

use crate::DrawingError;
use crate::labels::{Labels, Wanted};
use crate::scene::{Scene, SpaceFigure, SpaceSheet, name_curve};
use crate::sheet::Bounds;
use crate::style::{
    BLACK, RESET_COLOUR, RETURN_COLOUR, SMALL_LABEL_SIZE, SPOT_RADIUS, SheetWidth, TITLE_SIZE,
};

pub(crate) const SHEET: SpaceSheet = SpaceSheet {
    name: "fig09",
    title: "Points on the impacting surface and on the section",
    description: "Solid: the orbit near the wall. Dashed: its virtual parts beyond the wall. Arrows: the reset law, and the global \
         map on the section.",
    width_mm: 120.0,
    margin: Bounds { left: 8.0, right: 20.0, top: 14.0, bottom: 8.0 },
    names,
};

/// Draws Figure 9. Paper: fig:Bb.
///
/// # Errors
/// [`DrawingError`] if a coordinate is not finite.
pub fn draw_fig09(figure: &SpaceFigure<'_>, width: SheetWidth) -> Result<String, DrawingError> {
    SHEET.draw(figure, width)
}

fn names(scene: &Scene, labels: &mut Labels<'_>) -> Result<(), DrawingError> {
    for (spot, mark) in &scene.points {
        let name = match mark.kind {
            MarkKind::Impact => r"$(0,y_{\mathrm{imp}},z_{\mathrm{imp}})$".to_owned(),
            MarkKind::Recoil => r"$(0,y_{\mathrm{rec}},z_{\mathrm{rec}})$".to_owned(),
            MarkKind::Virtual => r"$(\hat{x},0,\hat{z})$".to_owned(),
            MarkKind::Section => format!("$(x^{{({0})}},0,z^{{({0})}})$", mark.number),
            MarkKind::Graze => continue,
        };
        labels.add(&name, SMALL_LABEL_SIZE, BLACK, &Wanted::Around(*spot, SPOT_RADIUS + 0.5))?;
    }
    let arrows = [
        (CurveKind::Reset, "$R$", RESET_COLOUR),
        (CurveKind::Global, r"$P_{\mathrm{global}}$", RETURN_COLOUR),
    ];
    for (kind, name, colour) in arrows {
        for arrow in scene.longest(kind) {
            name_curve(labels, name, SMALL_LABEL_SIZE, colour, &arrow)?;
        }
    }
    for (kind, name) in [(SurfaceKind::Incoming, r"$\Sigma$"), (SurfaceKind::Section, r"$\Pi$")] {
        if let Some(piece) = scene.surfaces.iter().find(|piece| piece.kind == kind) {
            labels.add(name, TITLE_SIZE, BLACK, &Wanted::Within(&piece.spots()))?;
        }
    }
    Ok(())
}
