//! Figure 9: an impact near the wall, and the points on the surfaces that it defines.

use grazing_results::space::{CurveKind, MarkKind, SurfaceKind};

use crate::DrawingError;
use crate::canvas::Canvas;
use crate::labels::Wanted;
use crate::scene::{Margin, Scene, SpaceFigure, name_curve};
use crate::style::{
    BLACK, RESET_COLOUR, RETURN_COLOUR, SMALL_LABEL_SIZE, SPOT_RADIUS, SheetWidth, TITLE_SIZE,
};

/// Width in the paper.
const WIDTH_MM: f64 = 120.0;
const MARGIN: Margin = Margin { left: 8.0, right: 20.0, top: 14.0, bottom: 8.0 };

/// Draws Figure 9. Paper: fig:Bb.
///
/// # Errors
/// [`DrawingError`] if a coordinate is not finite.
pub fn draw_fig09(figure: &SpaceFigure<'_>, width: SheetWidth) -> Result<String, DrawingError> {
    compose(figure, width)?.finish(
        "fig09",
        "Points on the impacting surface and on the section",
        "Solid: the orbit near the wall. Dashed: its virtual parts beyond the wall. Arrows: the reset law, and the global \
         map on the section.",
    )
}

pub(crate) fn compose(figure: &SpaceFigure<'_>, width: SheetWidth) -> Result<Canvas, DrawingError> {
    let mut scene = Scene::new(figure);
    let canvas = scene.fit("fig09", width.mm(WIDTH_MM), &MARGIN)?;
    scene.paint(&canvas)?;
    let mut labels = scene.labels(&canvas, TITLE_SIZE)?;
    for mark in &scene.points {
        let name = match mark.kind {
            MarkKind::Impact => r"$(0,y_{\mathrm{imp}},z_{\mathrm{imp}})$".to_owned(),
            MarkKind::Recoil => r"$(0,y_{\mathrm{rec}},z_{\mathrm{rec}})$".to_owned(),
            MarkKind::Virtual => r"$(\hat{x},0,\hat{z})$".to_owned(),
            MarkKind::Section => format!("$(x^{{({0})}},0,z^{{({0})}})$", mark.number),
            MarkKind::Graze => continue,
        };
        labels.add(&name, SMALL_LABEL_SIZE, BLACK, &Wanted::Around(mark.spot(), SPOT_RADIUS + 0.5))?;
    }
    let arrows = [
        (CurveKind::Reset, "$R$", RESET_COLOUR),
        (CurveKind::Global, r"$P_{\mathrm{global}}$", RETURN_COLOUR),
    ];
    for (kind, name, colour) in arrows {
        for arrow in scene.longest(kind) {
            name_curve(&mut labels, name, SMALL_LABEL_SIZE, colour, &arrow)?;
        }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;
    use crate::style::{INCOMING_FACE, SECTION_FACE};

    fn with_data<T>(test: impl Fn(&SpaceFigure<'_>) -> T) -> T {
        let (curves, points, surfaces) = samples::scene("fig09");
        test(&SpaceFigure { curves: &curves, points: &points, surfaces: &surfaces })
    }

    #[test]
    fn no_two_labels_overlap_and_none_leaves_the_sheet() {
        for width in [SheetWidth::Paper, SheetWidth::OneColumn] {
            let misplaced = with_data(|figure| compose(figure, width).unwrap().misplaced_texts());
            assert!(misplaced.is_empty(), "{width:?}: {misplaced:?}");
        }
    }

    #[test]
    fn everything_is_named_at_every_width() {
        for width in [SheetWidth::Paper, SheetWidth::OneColumn, SheetWidth::TwoColumns] {
            let texts = with_data(|figure| compose(figure, width).unwrap().texts());
            for (label, times) in [
                ("$x$", 1),
                ("$y$", 1),
                ("$z$", 1),
                ("$R$", 1),
                (r"$\Pi$", 1),
                (r"$\Sigma$", 1),
                (r"$P_{\mathrm{global}}$", 2),
                (r"$(0,y_{\mathrm{imp}},z_{\mathrm{imp}})$", 1),
                (r"$(0,y_{\mathrm{rec}},z_{\mathrm{rec}})$", 1),
                (r"$(\hat{x},0,\hat{z})$", 1),
                ("$(x^{(0)},0,z^{(0)})$", 1),
                ("$(x^{(1)},0,z^{(1)})$", 1),
                ("$(x^{(2)},0,z^{(2)})$", 1),
            ] {
                let found = texts.iter().filter(|text| *text == label).count();
                assert_eq!(found, times, "{width:?}: {label} in {texts:?}");
            }
        }
    }

    #[test]
    fn what_lies_beyond_the_wall_is_painted_before_the_wall() {
        let svg = with_data(|figure| draw_fig09(figure, SheetWidth::Paper).unwrap());
        let wall = svg.rfind(&fill(INCOMING_FACE)).expect("the incoming set is painted");
        let dashed = "stroke-dasharray=\"3 2\"";
        assert!(svg.matches(dashed).count() >= 3, "three virtual parts");
        assert!(svg.rfind(dashed).is_some_and(|last| last < wall));
        assert!(svg.rfind(&fill(SECTION_FACE)).is_some_and(|front| wall < front));
    }

    fn fill(paint: crate::style::Paint) -> String {
        let crate::style::Colour(red, green, blue) = paint.colour;
        format!("fill=\"#{red:02x}{green:02x}{blue:02x}\"")
    }
}
