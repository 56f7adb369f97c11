//! A one-parameter diagram of any oscillator, with phase portraits above it, like Figure 2.

use grazing_results::Names;
use grazing_results::branches::OneParameter;

use crate::DrawingError;
use crate::axes::{Panel, overhang, room_beside};
use crate::branches::diagram;
use crate::canvas::Canvas;
use crate::clip::checked;
use crate::labels::Labels;
use crate::portraits::{Caption, draw_portraits, equation, letters, portraits, row_height};
use crate::sheet::Bounds;
use crate::style::SheetWidth;
use crate::svg::POINTS_PER_MM;
use crate::ticks::measured;

/// Width in the paper.
const WIDTH_MM: f64 = 156.0;
/// Portraits stand so many in a row, on sheets narrower than this two.
const IN_A_ROW: usize = 4;
const WIDE_MM: f64 = 120.0;
/// Height of the diagram with its numbers and title, in points.
const HEIGHT: f64 = 236.0;
/// Room above the diagram, with letters of portraits and without, and beside it, in points; numbers that need more get it.
const LETTERS: f64 = 18.0;
const ABOVE: f64 = 6.0;
const LEFT: f64 = 38.0;
const RIGHT: f64 = 9.0;
/// A value of more characters than this is rounded, to so many digits.
const LONGEST: usize = 8;
const DIGITS: usize = 6;
/// Room below the diagram for numbers and axis title, in points.
const BELOW: f64 = 31.0;

/// Draws a one-parameter diagram of an oscillator, whose parameters have these names, under a title.
///
/// # Errors
/// [`DrawingError`] if the frame is empty.
pub fn draw_one_parameter(
    figure: &OneParameter,
    names: &Names,
    title: &str,
    width: SheetWidth,
) -> Result<String, DrawingError> {
    compose(figure, names, width)?.finish(
        "diagram",
        title,
        "Below: the parameter across, x-value of the return map up; thick curves are stable, thin ones unstable; dots are \
         long-term forward orbits. Above: phase portraits with the wall.",
    )
}

/// A value as the file has it, unless that takes many digits.
fn plain(value: f64) -> String {
    let text = format!("{value}").replace('-', "−");
    if text.chars().count() <= LONGEST { text } else { measured(value, DIGITS) }
}

pub(crate) fn compose(
    figure: &OneParameter,
    names: &Names,
    width: SheetWidth,
) -> Result<Canvas, DrawingError> {
    let frame = checked(figure.frame, "a one-parameter diagram")?;
    let portraits = portraits(&figure.portraits);
    let ([across, held], [title, _]) = (figure.exchanged(names.shown()), figure.exchanged(names.titles()));
    let [_, unit] = figure.exchanged(names.parameter_units()).map(Option::unwrap_or_default);
    let [column, _] = figure.exchanged([&names.primary, &names.secondary]);
    let own = Names::new(column, "x");
    let x = if figure.from_the_wall { "$x$ from the wall" } else { "$x$" };

    let width = width.mm(WIDTH_MM);
    let columns = if width < WIDE_MM { IN_A_ROW / 2 } else { IN_A_ROW };
    let rows = portraits.len().div_ceil(columns);
    let portraits_end = rows as f64 * row_height(rows);
    let canvas = Canvas::new(width, (portraits_end + HEIGHT) / POINTS_PER_MM)?;
    if rows > 0 {
        let caption = Caption { across: &across, titles: [x, "$y$"], table: &["diagram_portraits"] };
        draw_portraits(&canvas, &portraits, &caption, rows)?;
    }
    let top = portraits_end + if rows > 0 { LETTERS } else { ABOVE };
    let bottom = canvas.height - BELOW;
    let left = room_beside(&canvas.fonts, frame.y, bottom - top, x)?.max(LEFT);
    let reach = overhang(&canvas.fonts, frame.x, canvas.width - left - RIGHT)? + 1.0;
    let bounds = Bounds { left, top, right: canvas.width - reach.max(RIGHT), bottom };
    let panel = Panel {
        tables: &["diagram_bifurcations", "diagram_branches", "diagram_attractor"],
        only: Some(("diagram", figure.diagram)),
        names: Some(&own),
        ..Panel::new(&canvas, frame, bounds)
    };
    let guides = letters(&panel, &portraits)?;
    let mut labels = Labels::new(&canvas, panel.bounds);
    guides.iter().for_each(|guide| labels.placer.keep_off_nameless(guide));
    diagram(&panel, labels, &figure.branches, &figure.bifurcations, &figure.attractor, &own, true)?;
    let at = equation(&held, &plain(figure.at));
    panel.axes(&format!("{title}  ({})", format!("{at} {unit}").trim_end()), x)?;
    Ok(canvas)
}

#[cfg(test)]
mod tests {
    use grazing_continuation::bifurcation::Bifurcation;
    use grazing_results::branches::{
        AttractorPoint, BranchBifurcation, BranchPoint, PortraitKind, PortraitPoint,
    };

    use grazing_results::{Frame, UnitNames};

    use super::*;
    use crate::samples::WIDTHS;

    /// A diagram of these widths across and up, with so many portraits.
    fn sample([across, up]: [f64; 2], portraits: u32) -> OneParameter {
        let branch = |k: u32| {
            let share = f64::from(k % 101) / 100.0;
            BranchPoint {
                loops: k / 101,
                primary: share * across,
                x: (share * f64::from(k / 101) - 0.4) * up,
                visit: 1,
                impact_velocity: f64::NAN,
                impact_phase: f64::NAN,
                stable: k % 101 < 60,
                admissible: true,
                branch: k / 101,
            }
        };
        let orbit = |k: u32| {
            let share = f64::from(k % 40) / 40.0;
            PortraitPoint {
                portrait: 1 + k / 40,
                loops: k / 40 % 4,
                primary: across * (0.2 + 0.1 * f64::from(k / 80)),
                kind: if k / 40 % 4 == 3 { PortraitKind::Attractor } else { PortraitKind::Periodic },
                time: share,
                x: -4.0 * share * (1.0 - share) * up,
                y: (share - 0.5) * up,
            }
        };
        let (kind, loops, impact_velocity) = (Bifurcation::SaddleNode, 2, 0.1);
        OneParameter {
            diagram: 2,
            primary_is_fixed: false,
            at: 0.854,
            frame: Frame { x: [0.0, across], y: [-0.5 * up, 2.0 * up] },
            from_the_wall: false,
            branches: (0..404).map(branch).collect(),
            bifurcations: vec![BranchBifurcation {
                kind,
                loops,
                primary: 0.5 * across,
                impact_velocity,
                x: 0.6 * up,
            }],
            attractor: (0..500)
                .map(|k| AttractorPoint { primary: 0.9 * across, x: f64::from(k) * 0.001 * up })
                .collect(),
            portraits: (0..40 * portraits).map(orbit).collect(),
            resting: None,
            broken: Vec::new(),
        }
    }

    #[test]
    fn no_two_labels_overlap_for_any_parameters_units_and_portraits_at_any_width() {
        for names in [["A", "omega"], ["F_0", "forcing_frequency"]] {
            let names = Names::new(names[0], names[1]);
            for (scale, portraits) in [([1.0, 1.0], 0), ([1e-4, 1e3], 1), ([250.0, 2e-5], 3), ([1.0, 1.0], 7)]
            {
                for width in WIDTHS {
                    let sheet = compose(&sample(scale, portraits), &names, width).unwrap();
                    sheet.assert_well_placed(&(scale, portraits, width));
                }
            }
        }
    }

    #[test]
    fn titles_name_the_parameters_in_their_roles_and_what_x_is_counted_from() {
        let names = Names::new("A", "omega");
        let texts = |figure: &OneParameter| compose(figure, &names, SheetWidth::Paper).unwrap().texts();
        let mut figure = sample([1.0, 1.0], 1);
        assert!(texts(&figure).contains(&"long-time behaviour".to_owned()), "the dots are named");
        assert!(texts(&figure).contains(&r"$A$  ($\omega=0.854$)".to_owned()), "{:?}", texts(&figure));
        (figure.primary_is_fixed, figure.from_the_wall) = (true, true);
        let found = texts(&figure);
        for title in [r"$\omega$  ($A=0.854$)", "$x$ from the wall", "$y$"] {
            assert!(found.iter().any(|text| text == title), "{title}: {found:?}");
        }
        let [primary, secondary] = ["N", "rad/s"].map(|unit| Some(unit.to_owned()));
        let named = names.clone().with_units(UnitNames { primary, secondary, ..UnitNames::default() });
        let texts = compose(&figure, &named, SheetWidth::Paper).unwrap().texts();
        assert!(texts.contains(&r"$\omega$ (rad/s)  ($A=0.854$ N)".to_owned()), "{texts:?}");
    }

    #[test]
    fn panels_say_whose_rows_they_show() {
        let svg =
            draw_one_parameter(&sample([1.0, 1.0], 2), &Names::new("A", "omega"), "t", SheetWidth::Paper);
        let svg = svg.unwrap();
        assert!(svg.contains("data-only=\"diagram 2\" data-columns=\"A x\""));
        assert!(svg.contains("data-tables=\"diagram_portraits\" data-only=\"portrait 2\""));
    }
}
