//! Figure 7: the two-parameter bifurcation diagram of the paper's oscillator.

use polars::prelude::DataFrame;

use crate::DrawingError;
use crate::clip::Window;
use crate::diagram::{Diagram, Section, draw_diagram};
use crate::frames::Table;
use crate::magnified::Magnified;
use crate::plane::{Axis, Plane};
use crate::style::SheetWidth;

/// What Figure 7 shows.
///
/// Paper: Figure 7, fig:G.
#[derive(Debug, Clone, Copy)]
pub struct Figure07<'a> {
    /// As [`Diagram::curves`], the parameters in columns amplitude and omega.
    pub curves: &'a DataFrame,
    /// As [`Diagram::points`], likewise.
    pub points: &'a DataFrame,
    /// As [`Diagram::regions`], likewise.
    pub regions: &'a DataFrame,
    /// Amplitudes (horizontal) and frequencies (vertical) shown.
    pub window: Window,
    /// The rectangles of Figure 8.
    pub magnified: &'a [Magnified],
    /// The line of Figure 2.
    pub sections: &'a [Section],
}

/// Draws Figure 7.
///
/// # Errors
/// [`DrawingError`] if a column is missing or of the wrong type, a kind is unknown or a window is empty.
pub fn draw_fig07(figure: &Figure07<'_>, width: SheetWidth) -> Result<String, DrawingError> {
    draw_diagram(&diagram(figure, &forcing_plane()), width)
}

/// Forcing amplitude across, forcing frequency up.
pub(crate) fn forcing_plane() -> Plane<'static> {
    Plane {
        across: Axis { column: "amplitude", title: r"$\mathcal{A}$".to_owned() },
        up: Axis { column: "omega", title: r"$\omega$".to_owned() },
        grazing: r"$\mathcal{A}_{\mathrm{graz}}$".to_owned(),
    }
}

fn diagram<'a>(figure: &Figure07<'a>, plane: &'a Plane<'a>) -> Diagram<'a> {
    Diagram {
        name: "fig07",
        title: "Two-parameter bifurcation diagram",
        description: "Forcing amplitude across, forcing frequency up. Grazing curve of the non-impacting solution; \
             saddle-node, period-doubling and grazing bifurcations of maximal periodic solutions; regions of stability \
             in grey.",
        plane,
        curves: Table::new("fig07_curves", figure.curves),
        points: Table::new("fig07_points", figure.points),
        regions: Some(Table::new("fig07_regions", figure.regions)),
        window: figure.window,
        magnified: figure.magnified,
        sections: figure.sections,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagram::compose;
    use crate::samples;

    fn with_sample<T>(test: impl Fn(&Figure07<'_>) -> T) -> T {
        let (curves, points, regions) =
            (samples::fig07_curves(), samples::fig07_points(), samples::fig07_regions());
        test(&Figure07 {
            curves: &curves,
            points: &points,
            regions: &regions,
            window: samples::WINDOW,
            magnified: &samples::magnified(),
            sections: &[samples::section()],
        })
    }

    #[test]
    fn no_two_labels_overlap_and_none_leaves_the_sheet_however_wide_it_is() {
        for width in [SheetWidth::OneColumn, SheetWidth::Paper, SheetWidth::TwoColumns] {
            let misplaced = with_sample(|figure| {
                compose(&diagram(figure, &forcing_plane()), width).unwrap().misplaced_texts()
            });
            assert!(misplaced.is_empty(), "{width:?}: {misplaced:?}");
        }
    }

    #[test]
    fn all_things_of_the_caption_are_labelled() {
        let svg = with_sample(|figure| draw_fig07(figure, SheetWidth::Paper).unwrap());
        for label in [">SN<", ">PD<", ">GZ<", ">Fig. 2<", ">(a)<", ">(b)<", ">(c)<", ">graz</tspan>"] {
            assert!(svg.contains(label), "{label}");
        }
        for p in 1..=3 {
            assert!(svg.contains(&format!(">p</tspan>\u{2009}=\u{2009}{p}<")), "p = {p}");
        }
    }

    #[test]
    fn inadmissible_rows_are_not_drawn() {
        with_sample(|figure| {
            let all = draw_fig07(figure, SheetWidth::Paper).unwrap();
            let none = vec![false; figure.curves.height()];
            let mut curves = figure.curves.clone();
            curves.with_column(polars::prelude::Column::new("admissible".into(), none)).unwrap();
            let without = draw_fig07(&Figure07 { curves: &curves, ..*figure }, SheetWidth::Paper).unwrap();
            let blue = "stroke=\"#1946be\"";
            assert!(all.contains(blue) && !without.contains(blue));
        });
    }

    #[test]
    fn a_missing_column_and_a_reversed_window_are_errors() {
        with_sample(|figure| {
            let curves = figure.curves.drop("arc").unwrap();
            let error = draw_fig07(&Figure07 { curves: &curves, ..*figure }, SheetWidth::Paper).unwrap_err();
            assert!(matches!(
                error,
                DrawingError::MissingColumn { frame: "fig07_curves", column, .. } if column == "arc"
            ));
            let window = Window { x: [1.0, 0.0], ..figure.window };
            let error = draw_fig07(&Figure07 { window, ..*figure }, SheetWidth::Paper).unwrap_err();
            assert!(matches!(error, DrawingError::Window { window, .. } if window == "fig07"));
        });
    }
}
