//! Figure 1: phase space with the impacting surface, orbits that reach it, and the reset law.

use polars::prelude::DataFrame;

use crate::DrawingError;
use crate::canvas::Canvas;
use crate::labels::Wanted;
use crate::scene::{CurveKind, Margin, Scene, SurfaceKind, name_curve};
use crate::style::{BLACK, LABEL_SIZE, RESET_COLOUR, SMALL_LABEL_SIZE, SheetWidth, TITLE_SIZE};

/// What Figure 1 shows.
///
/// Paper: Figure 1, fig:Bc.
#[derive(Debug, Clone, Copy)]
pub struct Figure01<'a> {
    /// Columns kind (orbit, reset), number, piece, layer, across, up, depth. Rows that follow each other with equal number
    /// and piece are one polyline.
    pub curves: &'a DataFrame,
    /// Columns kind (impact, recoil, graze), number, layer, x, across, up, depth.
    pub points: &'a DataFrame,
    /// Columns as those of the curves; kind is incoming, outgoing (closed outlines of faces), tangency, x_axis, y_axis or
    /// z_axis (lines).
    pub surfaces: &'a DataFrame,
}

/// Width in the paper.
const WIDTH_MM: f64 = 80.0;
const MARGIN: Margin = Margin { left: 5.0, right: 13.0, top: 14.0, bottom: 5.0 };

/// Draws Figure 1.
///
/// # Errors
/// [`DrawingError`] if a column is missing or of the wrong type, a kind is unknown, or a coordinate is missing.
pub fn draw_fig01(figure: &Figure01<'_>, width: SheetWidth) -> Result<String, DrawingError> {
    compose(figure, width)?.finish(
        "fig01",
        "Phase space of an impacting hybrid system",
        "The impacting surface, x = 0, with its incoming set above, its outgoing set below and the tangency set between \
         them. Solid: orbits. Dashed: the reset law from the incoming to the outgoing set.",
    )
}

pub(crate) fn compose(figure: &Figure01<'_>, width: SheetWidth) -> Result<Canvas, DrawingError> {
    let names = ["fig01_curves", "fig01_points", "fig01_surfaces"];
    let mut scene = Scene::read(names, [figure.curves, figure.points, figure.surfaces])?;
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

    fn with_data<T>(test: impl Fn(&Figure01<'_>) -> T) -> T {
        let [curves, points, surfaces] = samples::scene("fig01");
        test(&Figure01 { curves: &curves, points: &points, surfaces: &surfaces })
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
        let resets = with_data(|figure| {
            let names = ["fig01_curves", "fig01_points", "fig01_surfaces"];
            let scene = Scene::read(names, [figure.curves, figure.points, figure.surfaces]).unwrap();
            scene.longest(CurveKind::Reset).len()
        });
        assert_eq!(svg.matches("stroke-dasharray").count(), resets);
    }

    #[test]
    fn a_missing_coordinate_or_column_is_an_error() {
        with_data(|figure| {
            let points = figure.points.drop("depth").unwrap();
            let error = draw_fig01(&Figure01 { points: &points, ..*figure }, SheetWidth::Paper).unwrap_err();
            assert!(error.to_string().contains("`fig01_points` has no column `depth`"), "{error}");
            let mut curves = figure.curves.clone();
            let holes = polars::prelude::Column::new("up".into(), vec![None::<f64>; curves.height()]);
            curves.with_column(holes).unwrap();
            let error = draw_fig01(&Figure01 { curves: &curves, ..*figure }, SheetWidth::Paper).unwrap_err();
            assert!(matches!(&error, DrawingError::Window { window, .. } if window == "fig01"), "{error}");
        });
    }
}
