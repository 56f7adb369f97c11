//! Magnifications about resonances, one panel each, like Figure 8; also in straightened coordinates, in
//! which curves that are tangent to each other are separate at any scale.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_input::LabelKind;
use grazing_results::Dimensioned;
use grazing_results::columns::{FROM_RESONANCE, SCALED_DISTANCE};
use grazing_results::plane::{
    CurveSource, Magnifications, MagnifiedPanel, MagnifiedPoint, StraightenedCurves, StraightenedPoint,
};

use crate::error::DrawingError;
use crate::figures::look::Look;
use crate::geometry::clip::checked;
use crate::geometry::sheet::{Spot, length};
use crate::ink::labels::{Labels, Site};
use crate::ink::sheet::Sheet;
use crate::ink::style::{LABEL_SIZE, SMALL_LABEL_SIZE, SheetWidth, TICK_SIZE};
use crate::plot::axes::{Heading, Panel};
use crate::plot::kinds::{DrawnRegion, Trace, TraceOf, draw_curves, draw_points, text_colour};
use crate::plot::magnified::panel_letter;
use crate::plot::numbers::Decades;
use crate::plot::panel_grid::{GridPanel, draw_panels};
use crate::plot::ticks::measured;

/// Curves shorter than this on the sheet (points) have no label.
const LABELLED_LENGTH: f64 = 24.0;
/// The number of significant digits of coefficients.
const DIGITS: usize = 4;

/// Draws magnifications.
///
/// There are three panels in a row, on narrow sheets one above the other, and three rows on a sheet.
/// Panels are spread evenly over the necessary number of sheets; without panels there are no sheets.
///
/// # Errors
/// [`DrawingError`] if a frame is empty.
pub fn draw_magnifications(
    figure: &Magnifications,
    heading: &Heading<'_>,
    look: impl Into<Look>,
) -> Result<Vec<Sheet>, DrawingError> {
    let look = &look.into();
    if look.style.swap {
        let names = heading.names.clone().swapped();
        let (heading, look) = (Heading { names: &names, ..*heading }, look.clone().unswapped());
        let mut figure = figure.clone();
        figure.exchange();
        return draw_magnifications(&figure, &heading, look);
    }
    let [across, up] = &heading.names.titles();
    let panel = |panel: &MagnifiedPanel| grid_panel(panel, heading, up, None);
    let panels: Vec<_> = figure.panels.iter().map(panel).collect::<Result<_, DrawingError>>()?;
    let style = (look.columns, look.style.colours.as_slice());
    draw_panels(heading, style, across, &panels, |panel, place| {
        draw_panel(panel, figure, heading, figure.panels[place].panel, look)
    })
}

/// The panel of a resonance, with p, n and coefficients above it; on an axis of decades its range is
/// converted.
fn grid_panel<'a>(
    panel: &MagnifiedPanel,
    heading: &Heading<'a>,
    up: &'a str,
    decades: Option<Decades>,
) -> Result<GridPanel<'a>, DrawingError> {
    let MagnifiedPanel { panel: number, loops, wall, n, coefficients, frame, .. } = panel;
    let n = n.map_or_else(String::new, |n| format!(", $n={n}$"));
    let wall = if *wall == 0 { String::new() } else { format!(", wall {wall}") };
    let known = coefficients.named().into_iter().filter(|(_, value)| value.is_finite());
    let written = |(kind, value): (Bifurcation, f64)| {
        format!(r"$c_{{\mathrm{{{},}}{loops}}}={}$", kind.name(), measured(value, DIGITS))
    };
    let mut frame = checked(*frame, &format!("a panel of {}", heading.name))?;
    if let Some(decades) = decades {
        frame.y = frame.y.map(|end| decades.at(end));
    }
    Ok(GridPanel {
        frame,
        up,
        decades,
        names: decades.is_none().then_some(heading.names),
        only: Some(("panel", *number)),
        first: (format!("{}  $p={loops}${n}{wall}", panel_letter(*number)), LABEL_SIZE),
        parts: (known.map(written).collect(), TICK_SIZE),
    })
}

/// Draws curves that leave resonances in straightened coordinates: μ/η² on the horizontal axis, η on a
/// vertical axis of decades, where μ is the distance from the grazing curve and η that from the
/// resonance. Dashed lines show the theoretical limits.
///
/// # Errors
/// As [`draw_magnifications`].
pub fn draw_straightened(
    figure: &StraightenedCurves,
    heading: &Heading<'_>,
    width: SheetWidth,
) -> Result<Vec<Sheet>, DrawingError> {
    let least = figure.curves.iter().map(|row| row.eta.abs()).fold(f64::INFINITY, f64::min);
    let decades = Decades { least: libm::round(libm::log10(least)) as i32 };
    let across = heading.names.titled(r"$\mu/\eta^{2}$", SCALED_DISTANCE.unit);
    let up = heading.names.titled(r"$\eta$", FROM_RESONANCE.unit);
    let panel = |panel: &MagnifiedPanel| grid_panel(panel, heading, &up, Some(decades));
    let panels: Vec<_> = figure.panels.iter().map(panel).collect::<Result<_, DrawingError>>()?;
    let heading = Heading { tables: &[], ..*heading };
    draw_panels(&heading, (width, &[]), &across, &panels, |panel, place| {
        let MagnifiedPanel { panel: number, loops, .. } = figure.panels[place];
        let mut labels = Labels::new(panel.canvas, panel.bounds);
        let grazing = vec![(0.0, panel.frame.y[0]), (0.0, panel.frame.y[1])];
        let grazing =
            Trace { kind: Bifurcation::NonImpactingGrazing, of: TraceOf::Bifurcation, points: grazing };
        let at_grazing = draw_curves(panel, &mut labels, vec![grazing])?;
        let mut named: Vec<(Bifurcation, String, Vec<Spot>)> = Vec::new();
        let curve = |a: &StraightenedPoint, b: &StraightenedPoint| (a.panel, a.arc) == (b.panel, b.arc);
        for rows in figure.curves.chunk_by(curve).filter(|rows| rows[0].panel == number) {
            let (kind, own) = (rows[0].kind, rows[0].loops == loops);
            let place = |row: &StraightenedPoint| (row.distance, decades.at(row.eta));
            let points: Vec<_> = rows.iter().map(place).collect();
            let limit = [0.0, decades.at(rows[rows.len() - 1].eta)].map(|up| (rows[0].limit, up));
            let traces = [(TraceOf::Bifurcation, points), (TraceOf::Approximation, limit.to_vec())];
            let traces = traces.map(|(of, points)| Trace { kind, of, points });
            let drawn = draw_curves(panel, &mut labels, traces.into())?;
            let longest = drawn.into_iter().max_by(|a, b| length(&a.1).total_cmp(&length(&b.1)));
            let of = if own { String::new() } else { format!(", $p={}$", rows[0].loops) };
            let label = format!("{}{of}", kind.name());
            named.extend(longest.map(|(_, piece)| (kind, label, piece)));
        }
        // Everything that labels avoid has been drawn.
        for (kind, label, piece) in named.iter().filter(|named| length(&named.2) >= LABELLED_LENGTH) {
            labels.add(label, SMALL_LABEL_SIZE, text_colour(*kind), &Site::Beside(piece))?;
        }
        labels.name_curves(at_grazing, LABELLED_LENGTH, &heading.names.grazing_title())?;
        labels.draw()
    })
}

fn draw_panel(
    panel: &mut Panel<'_>,
    figure: &Magnifications,
    heading: &Heading<'_>,
    number: u32,
    look: &Look,
) -> Result<(), DrawingError> {
    let mut labels = Labels::new(panel.canvas, panel.bounds);
    for region in DrawnRegion::all(&figure.regions).into_iter().filter(|region| look.shows(region.kind)) {
        region.draw(panel)?;
    }
    let drawn = draw_curves(panel, &mut labels, curves(&figure.curves, number))?;
    draw_points(panel, &mut labels, &figure.points)?;
    if look.names(LabelKind::Curves) {
        labels.name_curves(drawn, LABELLED_LENGTH, &heading.names.grazing_title())?;
    }
    labels.draw()
}

/// The curves of a panel.
fn curves(points: &[MagnifiedPoint], panel: u32) -> Vec<Trace> {
    let place = |point: &MagnifiedPoint| (point.panel, point.kind, point.source, point.arc);
    let curve = |points: &[MagnifiedPoint]| Trace {
        kind: points[0].kind,
        of: match points[0].source {
            CurveSource::Quadratic => TraceOf::Approximation,
            CurveSource::Continuation => TraceOf::Bifurcation,
        },
        points: points.iter().map(|point| (point.primary, point.secondary)).collect(),
    };
    let all = points.chunk_by(|a, b| place(a) == place(b));
    all.filter(|points| points[0].panel == panel).map(curve).collect()
}

#[cfg(test)]
mod tests {
    use grazing_continuation::bifurcation::Pair;
    use grazing_results::UnitNames;

    use super::*;
    use crate::SheetWidth;
    use crate::tests::sample_oscillator::{Affine, SampleOscillator, UNIT, oscillators, sample};
    use crate::tests::samples::WIDTHS;

    #[test]
    fn no_two_labels_overlap_and_sheets_fit_a_page_for_any_oscillator_at_any_width() {
        for sample in oscillators() {
            for width in WIDTHS {
                for sheet in draw_magnifications(&sample.magnifications, &sample.magnified(), width).unwrap()
                {
                    sheet.assert_well_placed(&(&sample.names, width));
                    // A4 minus margins of 30 mm above and below, and 30 mm for the caption.
                    assert!(sheet.size.1 < (297.0 - 90.0) * crate::ink::svg::POINTS_PER_MM);
                }
            }
        }
    }

    #[test]
    fn straightened_axes_have_the_units_of_both_parameters() {
        let mut sample = sample(2);
        for (units, titles) in [
            ([None, None], [r"$\mu/\eta^{2}$", r"$\eta$"]),
            ([None, Some("rad/s")], [r"$\mu/\eta^{2}$", r"$\eta$ (rad/s)"]),
            ([Some("N"), Some("rad/s")], [r"$\mu/\eta^{2}$ (N/(rad/s)$^{2}$)", r"$\eta$ (rad/s)"]),
        ] {
            let [primary, secondary] = units.map(|unit| unit.map(str::to_owned));
            let units = UnitNames { primary, secondary, ..UnitNames::default() };
            sample.names = sample.names.with_units(units);
            for width in WIDTHS {
                let sheets = draw_straightened(&sample.straightened, &sample.magnified(), width).unwrap();
                sheets.iter().for_each(|sheet| sheet.assert_well_placed(&(titles, width)));
                let first = sheets[0].panels().next().unwrap();
                assert_eq!(first.titles, titles, "{width:?}");
            }
        }
    }

    #[test]
    fn straightened_curves_keep_their_labels_apart_at_any_width() {
        for sample in oscillators() {
            for width in WIDTHS {
                for sheet in draw_straightened(&sample.straightened, &sample.magnified(), width).unwrap() {
                    sheet.assert_well_placed(&(&sample.names, width));
                }
            }
        }
    }

    #[test]
    fn decades_of_either_sign_stand_in_order_and_are_named() {
        let decades = Decades { least: -9 };
        let places = [-0.1, -1e-5, -1e-9, -1e-12, 0.0, 1e-12, 1e-9, 2e-9, 1e-2].map(|eta| decades.at(eta));
        assert!(places.is_sorted() && places[3] == 0.0 && places[4] == 0.0, "{places:?}");
        assert_eq!(places[7] - places[6], libm::log10(2e-9) - libm::log10(1e-9));
        let sample = sample(3);
        let sheet =
            &draw_straightened(&sample.straightened, &sample.magnified(), SheetWidth::TwoColumns).unwrap()[0];
        let texts = sheet.texts();
        for text in ["$10^{-9}$", "$−10^{-9}$", "SN", "PD", "GZ, $p=2$"] {
            assert!(texts.iter().any(|found| found == text), "{text} in {texts:?}");
        }
        // Three curves in each of three panels, with their limits.
        assert_eq!(sheet.short_body().matches("stroke-dasharray=\"3.2 2\"").count(), 9);
    }

    #[test]
    fn every_resonance_has_its_panel_on_one_of_the_sheets() {
        for (count, sheets) in [(0, 0), (1, 1), (5, 1), (9, 1), (20, 3), (30, 4)] {
            let sample = sample(count);
            let found =
                draw_magnifications(&sample.magnifications, &sample.magnified(), SheetWidth::TwoColumns)
                    .unwrap();
            assert_eq!(found.len(), sheets);
            let texts: Vec<String> = found.iter().flat_map(Sheet::texts).collect();
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
        let numbers: Vec<_> = sheets[0].panels().map(|panel| panel.only.unwrap().1).collect();
        assert_eq!(numbers, [1, 2, 3]);
        // Two approximations in each of three panels.
        assert_eq!(sheets[0].short_body().matches("stroke-dasharray=\"3.2 2\"").count(), 6);
    }

    #[test]
    fn one_sheet_of_several_says_which_it_is() {
        let titles = |count| -> Vec<String> {
            let sample = sample(count);
            let sheets =
                draw_magnifications(&sample.magnifications, &sample.magnified(), SheetWidth::Paper).unwrap();
            sheets.into_iter().map(|sheet| sheet.title).collect()
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
        let sheets =
            draw_magnifications(&sample.magnifications, &sample.magnified(), SheetWidth::Paper).unwrap();
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
            let sheets =
                draw_magnifications(&sample.magnifications, &sample.magnified(), SheetWidth::Paper).unwrap();
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
        let texts = draw_magnifications(&sample.magnifications, &sample.magnified(), SheetWidth::Paper)
            .unwrap()[0]
            .texts();
        assert!(texts.iter().any(|text| text.starts_with("(b)")));
        assert_eq!(texts.iter().filter(|text| text.contains("graz")).count(), 1);
    }
}
