//! Figure 1: phase space with the impacting surface, orbits that reach it, and the reset law.

use grazing_results::space::{CurveKind, SurfaceKind};

use crate::DrawingError;
use crate::labels::{Labels, Wanted};
use crate::scene::{Scene, SpaceFigure, SpaceSheet, name_curve};
use crate::sheet::Bounds;
use crate::style::{BLACK, LABEL_SIZE, RESET_COLOUR, SMALL_LABEL_SIZE, SheetWidth, TITLE_SIZE};

pub(crate) const SHEET: SpaceSheet = SpaceSheet {
    name: "fig01",
    title: "Phase space of an impacting hybrid system",
    description: "The impacting surface, x = 0, with its incoming set above, its outgoing set below and the tangency set between \
         them. Solid: orbits. Dashed: the reset law from the incoming to the outgoing set.",
    width_mm: 80.0,
    margin: Bounds { left: 5.0, right: 13.0, top: 14.0, bottom: 5.0 },
    names,
};

/// Draws Figure 1. Paper: fig:Bc.
///
/// # Errors
/// [`DrawingError`] if a coordinate is not finite.
pub fn draw_fig01(figure: &SpaceFigure<'_>, width: SheetWidth) -> Result<String, DrawingError> {
    SHEET.draw(figure, width)
}

fn names(scene: &Scene, labels: &mut Labels<'_>) -> Result<(), DrawingError> {
    for reset in scene.longest(CurveKind::Reset) {
        name_curve(labels, "$R$", LABEL_SIZE, RESET_COLOUR, &reset)?;
    }
    for piece in &scene.surfaces {
        let spots = piece.spots();
        match piece.kind {
            SurfaceKind::Incoming => {
                labels.add("incoming set", SMALL_LABEL_SIZE, BLACK, &Wanted::Within(&spots))?;
                labels.add(r"$\Sigma$", TITLE_SIZE, BLACK, &Wanted::Within(&spots))?;
            }
            SurfaceKind::Outgoing => {
                labels.add("outgoing set", SMALL_LABEL_SIZE, BLACK, &Wanted::Within(&spots))?;
            }
            SurfaceKind::Tangency => {
                name_curve(labels, "tangency set", SMALL_LABEL_SIZE, BLACK, &spots)?;
            }
            _ => {}
        }
    }
    Ok(())
}
