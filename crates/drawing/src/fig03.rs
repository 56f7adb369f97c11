//! Figure 3: the return map to the section near a grazing periodic solution.

use grazing_results::space::{CurveKind, MarkKind, SurfaceKind};

use crate::DrawingError;
use crate::labels::{Labels, Wanted};
use crate::scene::{Scene, SpaceFigure, SpaceSheet, name_curve};
use crate::sheet::Bounds;
use crate::style::{BLACK, LABEL_SIZE, RETURN_COLOUR, SMALL_LABEL_SIZE, SPOT_RADIUS, SheetWidth, TITLE_SIZE};

pub(crate) const SHEET: SpaceSheet = SpaceSheet {
    name: "fig03",
    title: "The return map near a grazing periodic solution",
    description: "Phase space with the phase as an angle. The grazing periodic solution meets the section once; the orbit of a \
         point of the section returns to it after one turn.",
    width_mm: 120.0,
    margin: Bounds { left: 12.0, right: 52.0, top: 8.0, bottom: 8.0 },
    names,
};

/// Draws Figure 3. Paper: fig:Ba.
///
/// # Errors
/// [`DrawingError`] if a coordinate is not finite.
pub fn draw_fig03(figure: &SpaceFigure<'_>, width: SheetWidth) -> Result<String, DrawingError> {
    SHEET.draw(figure, width)
}

fn names(scene: &Scene, labels: &mut Labels<'_>) -> Result<(), DrawingError> {
    for (spot, mark) in &scene.points {
        let name = match (mark.kind, mark.number) {
            (MarkKind::Graze, _) => r"$(0,0,z_{\mathrm{graz}})$",
            (MarkKind::Section, 0) => "$(x,0,z)$",
            (MarkKind::Section, 1) => "$(x',0,z')$",
            _ => continue,
        };
        labels.add(name, LABEL_SIZE, BLACK, &Wanted::Around(*spot, SPOT_RADIUS + 0.5))?;
    }
    for map in scene.longest(CurveKind::Global) {
        name_curve(labels, r"$P_{\mathrm{global}}$", LABEL_SIZE, RETURN_COLOUR, &map)?;
    }
    for periodic in scene.longest(CurveKind::Periodic) {
        name_curve(labels, r"$\Gamma$", TITLE_SIZE, BLACK, &periodic)?;
    }
    for piece in scene.surfaces.iter().filter(|piece| piece.kind == SurfaceKind::Section) {
        labels.add(r"$\Pi$", TITLE_SIZE, BLACK, &Wanted::Within(&piece.spots()))?;
    }
    for piece in scene.surfaces.iter().filter(|piece| piece.kind == SurfaceKind::Circle) {
        name_curve(labels, "$x=y=0$", SMALL_LABEL_SIZE, BLACK, &piece.spots())?;
    }
    Ok(())
}
