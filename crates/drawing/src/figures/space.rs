//! Figures 1, 3 and 9: what is named in each of these scenes in phase space.

use grazing_results::space::{CurveKind, MarkKind, Scene, SurfaceKind};

use crate::error::DrawingError;
use crate::geometry::sheet::Bounds;
use crate::ink::sheet::Sheet;
use crate::ink::style::{
    BLACK, LABEL_SIZE, RESET_COLOUR, RETURN_COLOUR, SMALL_LABEL_SIZE, SheetWidth, TITLE_SIZE,
};
use crate::plot::scene::{NamedPart, SpaceSheet};

pub(crate) const FIG01: SpaceSheet = SpaceSheet {
    name: "fig01",
    title: "Phase space of an impacting hybrid system",
    description: "The impacting surface, x = 0, with its incoming set above, its outgoing set below and the tangency set between \
         them. Solid: orbits. Dashed: the reset law from the incoming to the outgoing set.",
    width_mm: 80.0,
    margin: Bounds { left: 5.0, right: 13.0, top: 14.0, bottom: 5.0 },
    mark_size: LABEL_SIZE,
    mark: |_| None,
    names: &[
        (NamedPart::Curves(CurveKind::Reset), "$R$", LABEL_SIZE, RESET_COLOUR),
        (NamedPart::Face(SurfaceKind::Incoming), "incoming set", SMALL_LABEL_SIZE, BLACK),
        (NamedPart::Face(SurfaceKind::Incoming), r"$\Sigma$", TITLE_SIZE, BLACK),
        (NamedPart::Face(SurfaceKind::Outgoing), "outgoing set", SMALL_LABEL_SIZE, BLACK),
        (NamedPart::Line(SurfaceKind::Tangency), "tangency set", SMALL_LABEL_SIZE, BLACK),
    ],
};

pub(crate) const FIG03: SpaceSheet = SpaceSheet {
    name: "fig03",
    title: "The return map near a grazing periodic solution",
    description: "Phase space with the phase as an angle. The grazing periodic solution meets the section once; the orbit of a \
         point of the section returns to it after one turn.",
    width_mm: 120.0,
    margin: Bounds { left: 12.0, right: 52.0, top: 8.0, bottom: 8.0 },
    mark_size: LABEL_SIZE,
    mark: |mark| match (mark.kind, mark.number) {
        (MarkKind::Graze, _) => Some(r"$(0,0,z_{\mathrm{graz}})$".to_owned()),
        (MarkKind::Section, 0) => Some("$(x,0,z)$".to_owned()),
        (MarkKind::Section, 1) => Some("$(x',0,z')$".to_owned()),
        _ => None,
    },
    names: &[
        (NamedPart::Curves(CurveKind::Global), r"$P_{\mathrm{global}}$", LABEL_SIZE, RETURN_COLOUR),
        (NamedPart::Curves(CurveKind::Periodic), r"$\Gamma$", TITLE_SIZE, BLACK),
        (NamedPart::Face(SurfaceKind::Section), r"$\Pi$", TITLE_SIZE, BLACK),
        (NamedPart::Line(SurfaceKind::Circle), "$x=y=0$", SMALL_LABEL_SIZE, BLACK),
    ],
};

pub(crate) const FIG09: SpaceSheet = SpaceSheet {
    name: "fig09",
    title: "Points on the impacting surface and on the section",
    description: "Solid: the orbit near the wall. Dashed: its virtual parts beyond the wall. Arrows: the reset law, and the global \
         map on the section.",
    width_mm: 120.0,
    margin: Bounds { left: 8.0, right: 20.0, top: 14.0, bottom: 8.0 },
    mark_size: SMALL_LABEL_SIZE,
    mark: |mark| match mark.kind {
        MarkKind::Impact => Some(r"$(0,y_{\mathrm{imp}},z_{\mathrm{imp}})$".to_owned()),
        MarkKind::Recoil => Some(r"$(0,y_{\mathrm{rec}},z_{\mathrm{rec}})$".to_owned()),
        MarkKind::Virtual => Some(r"$(\hat{x},0,\hat{z})$".to_owned()),
        MarkKind::Section => Some(format!("$(x^{{({0})}},0,z^{{({0})}})$", mark.number)),
        MarkKind::Graze => None,
    },
    names: &[
        (NamedPart::Curves(CurveKind::Reset), "$R$", SMALL_LABEL_SIZE, RESET_COLOUR),
        (NamedPart::Curves(CurveKind::Global), r"$P_{\mathrm{global}}$", SMALL_LABEL_SIZE, RETURN_COLOUR),
        (NamedPart::Face(SurfaceKind::Incoming), r"$\Sigma$", TITLE_SIZE, BLACK),
        (NamedPart::Face(SurfaceKind::Section), r"$\Pi$", TITLE_SIZE, BLACK),
    ],
};

/// Draws Figure 1. Paper: fig:Bc.
pub fn draw_fig01(scene: &Scene, width: SheetWidth) -> Result<Sheet, DrawingError> {
    FIG01.draw(scene, width)
}

/// Draws Figure 3. Paper: fig:Ba.
pub fn draw_fig03(scene: &Scene, width: SheetWidth) -> Result<Sheet, DrawingError> {
    FIG03.draw(scene, width)
}

/// Draws Figure 9. Paper: fig:Bb.
pub fn draw_fig09(scene: &Scene, width: SheetWidth) -> Result<Sheet, DrawingError> {
    FIG09.draw(scene, width)
}
