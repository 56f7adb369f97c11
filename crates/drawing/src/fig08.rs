//! Figure 8: magnifications about three resonances of the paper's oscillator, with the quadratic approximations.

use polars::prelude::DataFrame;

use crate::DrawingError;
use crate::captions::Heading;
use crate::fig07::forcing_plane;
use crate::frames::Table;
use crate::magnifications::{Magnifications, MagnifiedPanel, draw_magnifications};
use crate::magnified::Magnified;
use crate::plane::Plane;
use crate::style::SheetWidth;

/// What Figure 8 shows.
///
/// Paper: Figure 8, fig:Y.
#[derive(Debug, Clone, Copy)]
pub struct Figure08<'a> {
    /// As [`Magnifications::curves`], the parameters in columns amplitude and omega.
    pub curves: &'a DataFrame,
    /// The points of Figure 7.
    pub points: &'a DataFrame,
    /// The regions of Figure 7.
    pub regions: &'a DataFrame,
    /// Columns panel, p, c_sn, c_pd.
    pub coefficients: &'a DataFrame,
    /// The windows, one to three panels in order.
    pub panels: &'a [Magnified],
}

/// As many panels as stand in a row.
const MOST_PANELS: usize = 3;

/// Draws Figure 8.
///
/// # Errors
/// [`DrawingError`] if a column is missing or of the wrong type, a kind is unknown, a window is empty or their
/// number is not one to three.
pub fn draw_fig08(figure: &Figure08<'_>, width: SheetWidth) -> Result<String, DrawingError> {
    let panels = panels(figure)?;
    let sheets = draw_magnifications(&magnifications(figure, &forcing_plane(), &panels), width)?;
    Ok(sheets.concat())
}

fn magnifications<'a>(
    figure: &Figure08<'a>,
    plane: &'a Plane<'a>,
    panels: &'a [MagnifiedPanel],
) -> Magnifications<'a> {
    Magnifications {
        name: "fig08",
        title: "Magnifications about three resonant grazing bifurcations",
        description: "Forcing amplitude across, forcing frequency up. Dashed: the quadratic approximations to the \
             saddle-node and period-doubling curves.",
        plane,
        curves: Table::new("fig08_curves", figure.curves),
        points: Table::new("fig07_points", figure.points),
        regions: Some(Table::new("fig07_regions", figure.regions)),
        panels,
    }
}

/// The panels, each with the coefficients of its row.
fn panels(figure: &Figure08<'_>) -> Result<Vec<MagnifiedPanel>, DrawingError> {
    if !(1..=MOST_PANELS).contains(&figure.panels.len()) {
        let found = figure.panels.len();
        return Err(DrawingError::PanelCount { figure: "fig08", wanted: "one to three panels", found });
    }
    let table = Table::new("fig08_coefficients", figure.coefficients);
    let (panel, p) = (table.integers("panel")?, table.integers("p")?);
    let (c_sn, c_pd) = (table.numbers("c_sn")?, table.numbers("c_pd")?);
    let headed = |shown: &Magnified| {
        let row = panel.iter().position(|&number| number == i64::from(shown.panel));
        let heading = row.map(|i| Heading { p: p[i], n: None, c_sn: c_sn[i], c_pd: c_pd[i] });
        MagnifiedPanel { shown: *shown, heading }
    };
    Ok(figure.panels.iter().map(headed).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::canvas::Canvas;
    use crate::magnifications::compose;
    use crate::samples;

    fn with_sample<T>(test: impl Fn(&Figure08<'_>) -> T) -> T {
        let (curves, coefficients) = (samples::fig08_curves(), samples::fig08_coefficients());
        let (points, regions) = (samples::fig07_points(), samples::fig07_regions());
        test(&Figure08 {
            curves: &curves,
            points: &points,
            regions: &regions,
            coefficients: &coefficients,
            panels: &samples::magnified(),
        })
    }

    fn composed(figure: &Figure08<'_>, width: SheetWidth) -> Canvas {
        let panels = panels(figure).unwrap();
        let mut sheets = compose(&magnifications(figure, &forcing_plane(), &panels), width).unwrap();
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
