//! Figure 7: the two-parameter bifurcation diagram of the paper's oscillator.

use grazing_results::plane::{CurvePoint, RegionVertex, SpecialPoint};

use crate::DrawingError;
use crate::clip::Window;
use crate::diagram::{Diagram, Section, draw_diagram};
use crate::magnified::Magnified;
use crate::plane::{Axis, Plane};
use crate::style::SheetWidth;

/// What Figure 7 shows.
///
/// Paper: Figure 7, fig:G.
#[derive(Debug, Clone, Copy)]
pub struct Figure07<'a> {
    /// As [`Diagram::curves`].
    pub curves: &'a [CurvePoint],
    /// As [`Diagram::points`].
    pub points: &'a [SpecialPoint],
    /// As [`Diagram::regions`].
    pub regions: &'a [RegionVertex],
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
/// [`DrawingError`] if a window is empty.
pub fn draw_fig07(figure: &Figure07<'_>, width: SheetWidth) -> Result<String, DrawingError> {
    draw_diagram(&diagram(figure, &forcing_plane()), width)
}

/// Forcing amplitude across, forcing frequency up.
pub(crate) fn forcing_plane() -> Plane {
    Plane {
        across: Axis { column: "amplitude".to_owned(), title: r"$\mathcal{A}$".to_owned() },
        up: Axis { column: "omega".to_owned(), title: r"$\omega$".to_owned() },
        grazing: r"$\mathcal{A}_{\mathrm{graz}}$".to_owned(),
    }
}

fn diagram<'a>(figure: &Figure07<'a>, plane: &'a Plane) -> Diagram<'a> {
    Diagram {
        name: "fig07",
        title: "Two-parameter bifurcation diagram",
        description: "Forcing amplitude across, forcing frequency up. Grazing curve of the non-impacting solution; \
             saddle-node, period-doubling and grazing bifurcations of maximal periodic solutions; regions of stability \
             in grey.",
        plane,
        tables: ["fig07_points", "fig07_curves"],
        curves: figure.curves,
        points: figure.points,
        regions: figure.regions,
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
            let inadmissible = |point: &CurvePoint| CurvePoint { admissible: false, ..point.clone() };
            let curves: Vec<_> = figure.curves.iter().map(inadmissible).collect();
            let without = draw_fig07(&Figure07 { curves: &curves, ..*figure }, SheetWidth::Paper).unwrap();
            let blue = "stroke=\"#1946be\"";
            assert!(all.contains(blue) && !without.contains(blue));
        });
    }

    #[test]
    fn a_reversed_window_is_an_error() {
        with_sample(|figure| {
            let window = Window { x: [1.0, 0.0], ..figure.window };
            let error = draw_fig07(&Figure07 { window, ..*figure }, SheetWidth::Paper).unwrap_err();
            assert!(matches!(error, DrawingError::Window { window, .. } if window == "fig07"));
        });
    }
}
