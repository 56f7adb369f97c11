//! Figure 3: the return map to the section near a grazing periodic solution.

use grazing_results::space::{CurveKind, MarkKind, SurfaceKind};

use crate::DrawingError;
use crate::canvas::Canvas;
use crate::labels::Wanted;
use crate::scene::{Margin, Scene, SpaceFigure, name_curve};
use crate::style::{BLACK, LABEL_SIZE, RETURN_COLOUR, SMALL_LABEL_SIZE, SPOT_RADIUS, SheetWidth, TITLE_SIZE};

/// Width in the paper.
const WIDTH_MM: f64 = 120.0;
const MARGIN: Margin = Margin { left: 12.0, right: 52.0, top: 8.0, bottom: 8.0 };

/// Draws Figure 3. Paper: fig:Ba.
///
/// # Errors
/// [`DrawingError`] if a coordinate is not finite.
pub fn draw_fig03(figure: &SpaceFigure<'_>, width: SheetWidth) -> Result<String, DrawingError> {
    compose(figure, width)?.finish(
        "fig03",
        "The return map near a grazing periodic solution",
        "Phase space with the phase as an angle. The grazing periodic solution meets the section once; the orbit of a \
         point of the section returns to it after one turn.",
    )
}

pub(crate) fn compose(figure: &SpaceFigure<'_>, width: SheetWidth) -> Result<Canvas, DrawingError> {
    let mut scene = Scene::new(figure);
    let canvas = scene.fit("fig03", width.mm(WIDTH_MM), &MARGIN)?;
    scene.paint(&canvas)?;
    let mut labels = scene.labels(&canvas, TITLE_SIZE)?;
    for mark in &scene.points {
        let name = match (mark.kind, mark.number) {
            (MarkKind::Graze, _) => r"$(0,0,z_{\mathrm{graz}})$",
            (MarkKind::Section, 0) => "$(x,0,z)$",
            (MarkKind::Section, 1) => "$(x',0,z')$",
            _ => continue,
        };
        labels.add(name, LABEL_SIZE, BLACK, &Wanted::Around(mark.spot(), SPOT_RADIUS + 0.5))?;
    }
    for map in scene.longest(CurveKind::Global) {
        name_curve(&mut labels, r"$P_{\mathrm{global}}$", LABEL_SIZE, RETURN_COLOUR, &map)?;
    }
    for periodic in scene.longest(CurveKind::Periodic) {
        name_curve(&mut labels, r"$\Gamma$", TITLE_SIZE, BLACK, &periodic)?;
    }
    for piece in scene.surfaces.iter().filter(|piece| piece.kind == SurfaceKind::Section) {
        labels.add(r"$\Pi$", TITLE_SIZE, BLACK, &Wanted::Within(&piece.spots()))?;
    }
    for piece in scene.surfaces.iter().filter(|piece| piece.kind == SurfaceKind::Circle) {
        name_curve(&mut labels, "$x=y=0$", SMALL_LABEL_SIZE, BLACK, &piece.spots())?;
    }
    labels.draw()?;
    Ok(canvas)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;

    fn with_data<T>(test: impl Fn(&SpaceFigure<'_>) -> T) -> T {
        let (curves, points, surfaces) = samples::scene("fig03");
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
                (r"$\Pi$", 1),
                (r"$\Gamma$", 1),
                (r"$P_{\mathrm{global}}$", 1),
                (r"$(0,0,z_{\mathrm{graz}})$", 1),
                ("$(x,0,z)$", 1),
                ("$(x',0,z')$", 1),
                ("$x=y=0$", 1),
            ] {
                let found = texts.iter().filter(|text| *text == label).count();
                assert_eq!(found, times, "{width:?}: {label} in {texts:?}");
            }
        }
    }
}
