//! Figure 8: magnifications about three resonances of the paper's oscillator, with the quadratic approximations.

use grazing_results::plane::{MagnifiedPoint, RegionVertex, SpecialPoint};

use crate::DrawingError;
use crate::fig07::forcing_plane;
use crate::magnifications::{Magnifications, MagnifiedPanel, draw_magnifications};
use crate::plane::Plane;
use crate::style::SheetWidth;

/// What Figure 8 shows.
///
/// Paper: Figure 8, fig:Y.
#[derive(Debug, Clone, Copy)]
pub struct Figure08<'a> {
    /// As [`Magnifications::curves`].
    pub curves: &'a [MagnifiedPoint],
    /// The points of Figure 7.
    pub points: &'a [SpecialPoint],
    /// The regions of Figure 7.
    pub regions: &'a [RegionVertex],
    /// One to three panels in order, with their headings.
    pub panels: &'a [MagnifiedPanel],
}

/// As many panels as stand in a row.
const MOST_PANELS: usize = 3;

/// Draws Figure 8.
///
/// # Errors
/// [`DrawingError`] if a window is empty or their number is not one to three.
pub fn draw_fig08(figure: &Figure08<'_>, width: SheetWidth) -> Result<String, DrawingError> {
    if !(1..=MOST_PANELS).contains(&figure.panels.len()) {
        let found = figure.panels.len();
        return Err(DrawingError::PanelCount { figure: "fig08", wanted: "one to three panels", found });
    }
    let sheets = draw_magnifications(&magnifications(figure, &forcing_plane()), width)?;
    Ok(sheets.concat())
}

fn magnifications<'a>(figure: &Figure08<'a>, plane: &'a Plane) -> Magnifications<'a> {
    Magnifications {
        name: "fig08",
        title: "Magnifications about three resonant grazing bifurcations",
        description: "Forcing amplitude across, forcing frequency up. Dashed: the quadratic approximations to the \
             saddle-node and period-doubling curves.",
        plane,
        table: "fig08_curves",
        curves: figure.curves,
        points: figure.points,
        regions: figure.regions,
        panels: figure.panels,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::canvas::Canvas;
    use crate::magnifications::compose;
    use crate::samples;

    fn with_sample<T>(test: impl Fn(&Figure08<'_>) -> T) -> T {
        let (curves, panels) = (samples::fig08_curves(), samples::fig08_panels());
        let (points, regions) = (samples::fig07_points(), samples::fig07_regions());
        test(&Figure08 { curves: &curves, points: &points, regions: &regions, panels: &panels })
    }

    fn composed(figure: &Figure08<'_>, width: SheetWidth) -> Canvas {
        let mut sheets = compose(&magnifications(figure, &forcing_plane()), width).unwrap();
        assert_eq!(sheets.len(), 1);
        sheets.remove(0)
    }

    #[test]
    fn no_two_labels_overlap_and_none_leaves_the_sheet_however_wide_it_is() {
        for width in [SheetWidth::OneColumn, SheetWidth::Paper, SheetWidth::TwoColumns] {
            let misplaced = with_sample(|figure| composed(figure, width).misplaced_texts());
            assert!(misplaced.is_empty(), "{width:?}: {misplaced:?}");
        }
    }

    #[test]
    fn panels_stand_one_above_the_other_in_one_column() {
        let size = |width| {
            with_sample(|figure| {
                let sheet = composed(figure, width);
                (sheet.width, sheet.height)
            })
        };
        let (one, paper) = (size(SheetWidth::OneColumn), size(SheetWidth::Paper));
        assert!(one.1 > 2.0 * one.0 && paper.0 > 2.0 * paper.1, "{one:?} {paper:?}");
    }

    #[test]
    fn coefficients_are_printed_to_four_figures() {
        let svg = with_sample(|figure| draw_fig08(figure, SheetWidth::Paper).unwrap());
        for number in ["−123.5", "98.77", "−9876", "1234"] {
            assert!(svg.contains(number), "{number}");
        }
    }

    #[test]
    fn only_approximations_are_plainly_dashed() {
        let svg = with_sample(|figure| draw_fig08(figure, SheetWidth::Paper).unwrap());
        // Two approximations in each of three panels.
        assert_eq!(svg.matches("stroke-dasharray=\"3.2 2\"").count(), 6);
    }

    #[test]
    fn one_panel_at_least_there_must_be() {
        with_sample(|figure| {
            let with = |panels| draw_fig08(&Figure08 { panels, ..*figure }, SheetWidth::Paper);
            assert!(with(&figure.panels[..2]).is_ok());
            assert!(matches!(with(&[]).unwrap_err(), DrawingError::PanelCount { found: 0, .. }));
        });
    }
}
