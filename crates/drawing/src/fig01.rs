//! Figure 1: phase space with the impacting surface, orbits that reach it, and the reset law.

use grazing_results::space::{CurveKind, SurfaceKind};

use crate::DrawingError;
use crate::canvas::Canvas;
use crate::labels::Wanted;
use crate::scene::{Margin, Scene, SpaceFigure, name_curve};
use crate::style::{BLACK, LABEL_SIZE, RESET_COLOUR, SMALL_LABEL_SIZE, SheetWidth, TITLE_SIZE};

/// Width in the paper.
const WIDTH_MM: f64 = 80.0;
const MARGIN: Margin = Margin { left: 5.0, right: 13.0, top: 14.0, bottom: 5.0 };

/// Draws Figure 1. Paper: fig:Bc.
///
/// # Errors
/// [`DrawingError`] if a coordinate is not finite.
pub fn draw_fig01(figure: &SpaceFigure<'_>, width: SheetWidth) -> Result<String, DrawingError> {
    compose(figure, width)?.finish(
        "fig01",
        "Phase space of an impacting hybrid system",
        "The impacting surface, x = 0, with its incoming set above, its outgoing set below and the tangency set between \
         them. Solid: orbits. Dashed: the reset law from the incoming to the outgoing set.",
    )
}

pub(crate) fn compose(figure: &SpaceFigure<'_>, width: SheetWidth) -> Result<Canvas, DrawingError> {
    let mut scene = Scene::new(figure);
    let canvas = scene.fit("fig01", width.mm(WIDTH_MM), &MARGIN)?;
    scene.paint(&canvas)?;
    let mut labels = scene.labels(&canvas, TITLE_SIZE)?;
    for reset in scene.longest(CurveKind::Reset) {
        name_curve(&mut labels, "$R$", LABEL_SIZE, RESET_COLOUR, &reset)?;
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
                name_curve(&mut labels, "tangency set", SMALL_LABEL_SIZE, BLACK, &spots)?;
            }
            _ => {}
        }
    }
    labels.draw()?;
    Ok(canvas)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;

    fn with_data<T>(test: impl Fn(&SpaceFigure<'_>) -> T) -> T {
        let (curves, points, surfaces) = samples::scene("fig01");
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
                ("$R$", 2),
                (r"$\Sigma$", 1),
                ("incoming set", 1),
                ("outgoing set", 1),
                ("tangency set", 1),
            ] {
                let found = texts.iter().filter(|text| *text == label).count();
                assert_eq!(found, times, "{width:?}: {label} in {texts:?}");
            }
        }
    }

    #[test]
    fn orbits_are_solid_and_only_the_reset_law_is_dashed() {
        let svg = with_data(|figure| draw_fig01(figure, SheetWidth::Paper).unwrap());
        let resets = with_data(|figure| Scene::new(figure).longest(CurveKind::Reset).len());
        assert_eq!(svg.matches("stroke-dasharray").count(), resets);
    }

    #[test]
    fn a_missing_coordinate_is_an_error() {
        with_data(|figure| {
            let mut curves = figure.curves.to_vec();
            curves[3].place[1] = f64::NAN;
            let error =
                draw_fig01(&SpaceFigure { curves: &curves, ..*figure }, SheetWidth::Paper).unwrap_err();
            assert!(matches!(&error, DrawingError::Window { window, .. } if window == "fig01"), "{error}");
        });
    }
}
