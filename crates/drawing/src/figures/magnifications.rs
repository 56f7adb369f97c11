//! Magnifications about resonances, one panel each, like Figure 8.

use std::ops::Range;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_results::plane::{CurveSource, Magnifications, MagnifiedPanel, MagnifiedPoint};

use crate::error::DrawingError;
use crate::figures::diagram::Heading;
use crate::geometry::clip::checked;
use crate::geometry::sheet::Bounds;
use crate::ink::canvas::{Anchor, Canvas};
use crate::ink::font::Fonts;
use crate::ink::labels::Labels;
use crate::ink::markup::Label;
use crate::ink::style::{BLACK, LABEL_SIZE, SheetWidth, TICK_SIZE};
use crate::plot::axes::Panel;
use crate::plot::kinds::{Area, Trace, draw_curves, draw_points};
use crate::plot::magnified::panel_letter;
use crate::plot::panel_grid::{Grid, HEADING_LEADING, SUBHEADING_LEADING};
use crate::plot::ticks::measured;

/// A sheet of magnifications.
#[derive(Debug, Clone, PartialEq)]
pub struct MagnificationSheet {
    /// The text of its SVG file.
    pub svg: String,
    /// The numbers of its panels.
    pub panels: Vec<u32>,
}

/// Curves shorter than this on the sheet (points) stay without a label.
const LABELLED_LENGTH: f64 = 24.0;

/// Draws magnifications.
///
/// Panels stand three in a row, on narrow sheets one above the other, three rows on a sheet: as many sheets are drawn as
/// there have to be, all with about as many panels, none if there is no panel.
///
/// # Errors
/// [`DrawingError`] if a frame is empty.
pub fn draw_magnifications(
    figure: &Magnifications,
    heading: &Heading<'_>,
    width: SheetWidth,
) -> Result<Vec<MagnificationSheet>, DrawingError> {
    let canvases = compose(figure, heading, width)?;
    let svgs = Canvas::finish_all(canvases, heading.name, heading.title, heading.description)?;
    let sheets = Grid::sheets(width, figure.panels.len()).into_iter().zip(svgs);
    let numbers = |range: Range<usize>| figure.panels[range].iter().map(|panel| panel.panel).collect();
    Ok(sheets.map(|(range, svg)| MagnificationSheet { svg, panels: numbers(range) }).collect())
}

pub(crate) fn compose(
    figure: &Magnifications,
    heading: &Heading<'_>,
    width: SheetWidth,
) -> Result<Vec<Canvas>, DrawingError> {
    for panel in &figure.panels {
        checked(panel.frame, &format!("a panel of {}", heading.name))?;
    }
    let sheets = Grid::sheets(width, figure.panels.len());
    sheets.into_iter().map(|range| draw_sheet(figure, heading, range, width)).collect()
}

fn draw_sheet(
    figure: &Magnifications,
    heading: &Heading<'_>,
    panels: Range<usize>,
    width: SheetWidth,
) -> Result<Canvas, DrawingError> {
    let all = &figure.panels;
    let [across, up] = &heading.names.titles();
    let (panels, fonts) = (&all[panels], Fonts::load()?);
    let frames: Vec<_> = panels.iter().map(|panel| panel.frame).collect();
    let captions: Vec<Caption> = panels.iter().map(Caption::new).collect();
    let mut grid = Grid::new(&fonts, width, all.len(), &frames, &vec![up.as_str(); frames.len()])?;
    // All captions of a sheet are alike: if one needs two lines for its coefficients, each has two.
    let mut split = false;
    for (place, caption) in captions.iter().enumerate() {
        split |= !caption.fits(&fonts, grid.heading_room(place))?;
    }
    if split {
        grid.add_heading_line();
    }
    let canvas = Canvas::new(grid.width_mm, grid.height_mm())?;
    for (place, (shown, caption)) in panels.iter().zip(captions).enumerate() {
        let bounds = grid.bounds(place);
        let panel = Panel {
            tables: heading.tables,
            only: Some(("panel", shown.panel)),
            names: Some(heading.names),
            ..Panel::new(&canvas, shown.frame, bounds)
        };
        draw_panel(&panel, figure, heading, shown.panel)?;
        panel.axes(across, if grid.is_titled(place) { up } else { "" })?;
        caption.draw(&canvas, &bounds, grid.heading_rise(), split)?;
    }
    Ok(canvas)
}

fn draw_panel(
    panel: &Panel<'_>,
    figure: &Magnifications,
    heading: &Heading<'_>,
    number: u32,
) -> Result<(), DrawingError> {
    let mut labels = Labels::new(panel.canvas, panel.bounds);
    for region in Area::all(&figure.regions) {
        region.draw(panel);
    }
    let drawn = draw_curves(panel, &mut labels, curves(&figure.curves, number));
    draw_points(panel, &mut labels, &figure.points);
    labels.name_curves(drawn, LABELLED_LENGTH, &heading.names.grazing_title())?;
    labels.draw()
}

/// The curves of a panel.
fn curves(points: &[MagnifiedPoint], panel: u32) -> Vec<Trace> {
    let place = |point: &MagnifiedPoint| (point.panel, point.kind, point.source, point.arc);
    let curve = |points: &[MagnifiedPoint]| Trace {
        kind: points[0].kind,
        approximate: points[0].source == CurveSource::Quadratic,
        points: points.iter().map(|point| (point.primary, point.secondary)).collect(),
    };
    let all = points.chunk_by(|a, b| place(a) == place(b));
    all.filter(|points| points[0].panel == panel).map(curve).collect()
}

/// Significant digits of coefficients.
const DIGITS: usize = 4;

/// What is written over a panel: its letter, p and n on the first line, and the coefficients.
struct Caption {
    first: String,
    coefficients: Vec<String>,
}

impl Caption {
    fn new(panel: &MagnifiedPanel) -> Self {
        let MagnifiedPanel { panel, loops, n, coefficients, .. } = panel;
        let n = n.map_or_else(String::new, |n| format!(", $n={n}$"));
        let known = coefficients.named().into_iter().filter(|(_, value)| value.is_finite());
        let written = |(kind, value): (Bifurcation, f64)| {
            format!(r"$c_{{\mathrm{{{},}}{loops}}}={}$", kind.name(), measured(value, DIGITS))
        };
        let first = format!("{}  $p={loops}${n}", panel_letter(*panel));
        Caption { first, coefficients: known.map(written).collect() }
    }

    /// The coefficients on one line.
    fn joined(&self) -> String {
        self.coefficients.join(",  ")
    }

    /// Whether the coefficients fit on one line of so many points.
    fn fits(&self, fonts: &Fonts, room: f64) -> Result<bool, DrawingError> {
        Ok(fonts.measure(&Label::parse(&self.joined())?, TICK_SIZE)?.width <= room)
    }

    /// Draws it, the baseline of the first line so many points above the panel, each coefficient on a line of its own if they are split.
    fn draw(self, canvas: &Canvas, bounds: &Bounds, rise: f64, split: bool) -> Result<(), DrawingError> {
        let mut baseline = bounds.top - rise;
        canvas.text((bounds.left, baseline), &self.first, LABEL_SIZE, Anchor::Start, BLACK)?;
        baseline += HEADING_LEADING;
        let lines = if split { self.coefficients } else { vec![self.joined()] };
        for line in lines {
            canvas.text((bounds.left, baseline), &line, TICK_SIZE, Anchor::Start, BLACK)?;
            baseline += SUBHEADING_LEADING;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use grazing_continuation::bifurcation::Pair;

    use super::*;
    use crate::tests::sample_oscillator::{Affine, SampleOscillator, UNIT, oscillators, sample};
    use crate::tests::samples::WIDTHS;

    #[test]
    fn no_two_labels_overlap_and_sheets_fit_a_page_for_any_oscillator_at_any_width() {
        for sample in oscillators() {
            for width in WIDTHS {
                for sheet in compose(&sample.magnifications, &sample.magnified(), width).unwrap() {
                    sheet.assert_well_placed(&(&sample.names, width));
                    // A4 less margins of 30 mm above and below, and 30 mm for the caption.
                    assert!(sheet.height < (297.0 - 90.0) * crate::ink::svg::POINTS_PER_MM);
                }
            }
        }
    }

    #[test]
    fn every_resonance_has_its_panel_on_one_of_the_sheets() {
        for (count, sheets) in [(0, 0), (1, 1), (5, 1), (9, 1), (20, 3), (30, 4)] {
            let sample = sample(count);
            let found = compose(&sample.magnifications, &sample.magnified(), SheetWidth::TwoColumns).unwrap();
            assert_eq!(found.len(), sheets);
            let texts: Vec<String> = found.iter().flat_map(Canvas::texts).collect();
            for panel in &sample.magnifications.panels {
                let letter = panel_letter(panel.panel);
                let line = format!("{letter}  $p={}$, $n={}$", panel.loops, panel.n.unwrap());
                assert!(texts.contains(&line), "{line}: {texts:?}");
            }
        }
    }

    #[test]
    fn only_approximations_are_plainly_dashed() {
        let sample = sample(3);
        let sheets =
            draw_magnifications(&sample.magnifications, &sample.magnified(), SheetWidth::Paper).unwrap();
        assert_eq!(sheets[0].panels, [1, 2, 3]);
        // Two approximations in each of three panels.
        let drawn = sheets[0].svg.split("<defs").next().unwrap();
        assert_eq!(drawn.matches("stroke-dasharray=\"3.2 2\"").count(), 6);
    }

    #[test]
    fn one_sheet_of_several_says_which_it_is() {
        let titles = |count| -> Vec<String> {
            let sample = sample(count);
            let sheets =
                draw_magnifications(&sample.magnifications, &sample.magnified(), SheetWidth::Paper).unwrap();
            let title = |sheet: &MagnificationSheet| {
                sheet.svg.split("<title>").nth(1)?.split("</title>").next().map(str::to_owned)
            };
            sheets.iter().filter_map(title).collect()
        };
        assert_eq!(titles(2), ["Magnifications"]);
        assert_eq!(titles(10), ["Magnifications (1 of 2)", "Magnifications (2 of 2)"]);
    }

    #[test]
    fn coefficients_of_any_magnitude_find_room_and_missing_ones_are_left_out() {
        let mut sample = sample(3);
        for (panel, (c_sn, c_pd)) in sample.magnifications.panels.iter_mut().zip([
            (-1.234_56e8, 9.876_54e-5),
            (f64::NAN, 0.5),
            (f64::NAN, f64::NAN),
        ]) {
            panel.loops = 12;
            panel.coefficients = Pair { saddle_node: c_sn, period_doubling: c_pd };
        }
        let sheets = compose(&sample.magnifications, &sample.magnified(), SheetWidth::Paper).unwrap();
        sheets[0].assert_well_placed(&"coefficients");
        let texts = sheets[0].texts();
        let written: Vec<&str> =
            texts.iter().filter(|text| text.starts_with("$c_")).map(String::as_str).collect();
        assert_eq!(
            written,
            [
                r"$c_{\mathrm{SN,}12}=−1.235\,\times\,10^{8}$",
                r"$c_{\mathrm{PD,}12}=9.877\,\times\,10^{-5}$",
                r"$c_{\mathrm{PD,}12}=0.5000$",
            ]
        );
    }

    #[test]
    fn axes_that_are_printed_less_a_number_have_titles_of_their_own() {
        let count = |up| {
            let sample = SampleOscillator::new(["A", "omega"], UNIT, up, 3);
            let sheets = compose(&sample.magnifications, &sample.magnified(), SheetWidth::Paper).unwrap();
            sheets[0].texts().iter().filter(|text| text.contains(r"\omega")).count()
        };
        assert_eq!(count(UNIT), 1);
        assert_eq!(count(Affine(1e-6, 4321.0)), 3);
    }

    #[test]
    fn panels_may_be_without_curves_and_regions() {
        let mut sample = sample(4);
        // The first 201 rows are the grazing curve in the first panel.
        sample.magnifications.curves.truncate(201);
        sample.magnifications.regions.clear();
        let texts =
            compose(&sample.magnifications, &sample.magnified(), SheetWidth::Paper).unwrap()[0].texts();
        assert!(texts.iter().any(|text| text.starts_with("(b)")));
        assert_eq!(texts.iter().filter(|text| text.contains("graz")).count(), 1);
    }
}
