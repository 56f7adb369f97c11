//! One-parameter diagrams of any oscillator, with phase portraits above them; Figure 2 is one, with a
//! magnification.

use grazing_results::branches::OneParameter;
use grazing_results::readings::Ordinate;
use grazing_results::{Frame, Names};

use crate::error::DrawingError;
use crate::geometry::clip::checked;
use crate::geometry::sheet::Bounds;
use crate::ink::canvas::Canvas;
use crate::ink::elements::Stroke;
use crate::ink::font::Fonts;
use crate::ink::labels::Labels;
use crate::ink::sheet::Sheet;
use crate::ink::style::{MAGNIFIER, MAGNIFIER_FRAME, SheetWidth};
use crate::ink::svg::POINTS_PER_MM;
use crate::plot::axes::{Heading, Panel, overhang, room_beside};
use crate::plot::branches::diagram;
use crate::plot::portraits::{PortraitTexts, Portraits, equation, letters};
use crate::plot::ticks::measured;

/// The width of this figure in the paper.
const WIDTH_MM: f64 = 156.0;
/// The number of portraits in a row; sheets narrower than [`WIDE_MM`] have two, and wider ones have the
/// magnification beside the diagram.
const IN_A_ROW: usize = 4;
const WIDE_MM: f64 = 120.0;
/// The height of the diagram with its numbers and title, in points: alone, beside its magnification, and
/// above it.
const HEIGHT: f64 = 236.0;
const MAGNIFIED_HEIGHT: f64 = 222.83;
const STACKED_HEIGHT: f64 = 121.0;
/// Room above the magnification when it is below the diagram, in points.
const STACKED_GAP: f64 = 8.0;
/// Room above the diagram, with and without letters of portraits, and beside it, alone and magnified, in
/// points; longer numbers get more.
const LETTERS: f64 = 18.0;
const ABOVE: f64 = 6.0;
const LEFT: f64 = 38.0;
const RIGHT: f64 = 9.0;
const MAGNIFIED_RIGHT: f64 = 6.0;
/// The fraction of the width that a diagram takes beside its magnification, and the room between them in
/// points.
const SPLIT: f64 = 0.59;
const BETWEEN: f64 = 44.0;
/// A value of more characters than [`LONGEST`] is rounded to [`DIGITS`] digits.
const LONGEST: usize = 8;
const DIGITS: usize = 6;
/// Room below the diagram for numbers and axis title, in points.
const BELOW: f64 = 31.0;

/// A value with all its digits, unless there are too many.
fn plain(value: f64) -> String {
    let text = format!("{value}").replace('-', "−");
    if text.chars().count() <= LONGEST { text } else { measured(value, DIGITS) }
}

/// Draws a one-parameter diagram and its portraits. The tables of the heading are those of bifurcations,
/// branches, attractor and portraits; for an ordinate other than x, those of readings and portraits. If
/// `says_where` is set, the title of the horizontal axis states the value of the fixed parameter.
///
/// # Errors
/// [`DrawingError`] if a frame is empty.
pub fn draw_one_parameter(
    figure: &OneParameter,
    heading: &Heading<'_>,
    says_where: bool,
    width: SheetWidth,
) -> Result<Sheet, DrawingError> {
    let figure = &figure.seen();
    let (names, (tables, portrait_tables)) =
        (heading.names, heading.tables.split_at(heading.tables.len().saturating_sub(1)));
    let frame = checked(figure.frame, "a one-parameter diagram")?;
    let magnified = figure.magnified.map(|part| checked(part, "its magnification")).transpose()?;
    let ([across, held], [axis, _]) = (figure.exchanged(names.shown()), figure.exchanged(names.titles()));
    let [_, unit] = figure.exchanged(names.parameter_units()).map(Option::unwrap_or_default);
    let [column, _] = figure.exchanged([&names.primary, &names.secondary]);
    let (header, unit_of_ordinate) = figure.ordinate.column();
    let own = Names::new(column, header);
    let titled = figure.ordinate == Ordinate::X && names.columns().is_none();
    let columns = (!titled).then(|| [own.primary.clone(), own.secondary.clone()]);
    let x = if figure.from_the_wall { "$x$ from the wall" } else { "$x$" };
    let (x, y) = (names.titled(x, "length"), names.titled("$y$", "length/time"));
    let up = match figure.ordinate {
        Ordinate::X => x.clone(),
        other => names.titled(other.name(), unit_of_ordinate),
    };

    let width = width.mm(WIDTH_MM);
    let narrow = width < WIDE_MM;
    let in_a_row = if narrow { IN_A_ROW / 2 } else { IN_A_ROW };
    let plane = names.columns().map(|_| ["x", "y"].map(str::to_owned));
    let caption = PortraitTexts { across: &across, titles: [&x, &y], columns: plane, table: portrait_tables };
    let portraits = Portraits::new(&Fonts::load()?, figure, caption, in_a_row, width * POINTS_PER_MM)?;
    let portraits_end = portraits.height();
    let height = match magnified {
        None => HEIGHT,
        Some(_) if narrow => 2.0 * STACKED_HEIGHT + STACKED_GAP,
        Some(_) => MAGNIFIED_HEIGHT,
    };
    let canvas = Canvas::new(width, (portraits_end + height) / POINTS_PER_MM)?;
    portraits.draw(&canvas)?;
    let top = portraits_end + if portraits.shown.is_empty() { ABOVE } else { LETTERS };
    let panel = |(frame, bounds)| {
        let only = Some(("diagram", figure.diagram));
        Ok(Panel { tables, only, columns: columns.clone(), ..Panel::new(&canvas, frame, bounds)? })
    };
    let panels = bounds(&canvas, frame, magnified, [top, portraits_end], &up)?.into_iter();
    let mut panels: Vec<Panel<'_>> = panels.map(panel).collect::<Result<_, DrawingError>>()?;
    let guides = letters(&panels[0], figure, &portraits.shown)?;
    if let [whole, part] = &mut panels[..] {
        let outline = part.frame.outline();
        whole.draw_series(whole.curve(&outline, MAGNIFIER))?;
        // The line surrounds the panel, so that half of its width lies outside.
        part.draw_series([Stroke::new(outline, MAGNIFIER_FRAME)])?;
    }
    let at = equation(&held, &plain(figure.at));
    let place = format!("{axis}  ({})", format!("{at} {unit}").trim_end());
    // The symbol of the primary parameter at grazing may differ from the one derived from its name.
    let grazing = if figure.primary_is_fixed { &own } else { names };
    let count = panels.len();
    for (number, panel) in panels.iter_mut().enumerate() {
        let last = number + 1 == count;
        let mut labels = Labels::new(&canvas, panel.bounds);
        if number == 0 {
            guides.iter().for_each(|guide| labels.placer.keep_off_nameless(guide));
            if let Some(part) = magnified {
                labels.placer.keep_off_nameless(&part.outline().map(|corner| panel.spot(corner)));
            }
        }
        diagram(panel, labels, figure, grazing, last)?;
        let beside = number > 0 && !narrow;
        panel.axes(if says_where { &place } else { &axis }, if beside { "" } else { &up })?;
    }
    canvas.finish(heading.name, heading.title, heading.description)
}

/// The frames of a diagram and of its magnification, and their bounds on the sheet.
fn bounds(
    canvas: &Canvas,
    frame: Frame,
    magnified: Option<Frame>,
    [top, portraits_end]: [f64; 2],
    x: &str,
) -> Result<Vec<(Frame, Bounds)>, DrawingError> {
    let bottom = canvas.height - BELOW;
    let left = room_beside(&canvas.fonts, frame.y, bottom - top, x)?.max(LEFT);
    let Some(part) = magnified else {
        let reach = overhang(&canvas.fonts, frame.x, canvas.width - left - RIGHT)? + 1.0;
        let right = canvas.width - reach.max(RIGHT);
        return Ok(vec![(frame, Bounds { left, top, right, bottom })]);
    };
    let right = canvas.width - MAGNIFIED_RIGHT;
    if canvas.width < WIDE_MM * POINTS_PER_MM {
        let middle = portraits_end + STACKED_HEIGHT;
        let below = Bounds { left, top: middle + STACKED_GAP, right, bottom };
        return Ok(vec![(frame, Bounds { left, top, right, bottom: middle - BELOW }), (part, below)]);
    }
    let split = SPLIT * canvas.width;
    let beside = Bounds { left: split + BETWEEN, top, right, bottom };
    Ok(vec![(frame, Bounds { left, top, right: split, bottom }), (part, beside)])
}

#[cfg(test)]
mod tests {
    use grazing_continuation::bifurcation::Bifurcation;
    use grazing_results::branches::{
        AttractorPoint, BranchBifurcation, BranchPoint, PortraitKind, PortraitPoint,
    };

    use grazing_results::{Frame, UnitNames};

    use super::*;
    use crate::tests::samples::{WIDTHS, empty};

    /// A sample diagram of these widths on both axes, with a number of portraits.
    fn sample([across, up]: [f64; 2], portraits: u32) -> OneParameter {
        let branch = |k: u32| {
            let share = f64::from(k % 101) / 100.0;
            BranchPoint {
                diagram: 2,
                loops: k / 101,
                impacts: u32::from(k >= 101),
                wall: 0,
                secondary: 0.855,
                primary: share * across,
                x: (share * f64::from(k / 101) - 0.4) * up,
                visit: 1,
                impact_velocity: f64::NAN,
                impact_phase: f64::NAN,
                stable: (k % 101 < 60).into(),
                admissible: true,
                branch: k / 101,
            }
        };
        let orbit = |k: u32| {
            let share = f64::from(k % 40) / 40.0;
            PortraitPoint {
                diagram: 2,
                portrait: 1 + k / 40,
                loops: k / 40 % 4,
                secondary: 0.855,
                primary: across * (0.2 + 0.1 * f64::from(k / 80)),
                kind: if k / 40 % 4 == 3 { PortraitKind::Attractor } else { PortraitKind::Periodic },
                time: share,
                x: -4.0 * share * (1.0 - share) * up,
                y: (share - 0.5) * up,
            }
        };
        let (diagram, secondary) = (2, 0.855);
        let (kind, loops, impact_velocity) = (Bifurcation::SaddleNode, 2, 0.1);
        OneParameter {
            diagram,
            branches: (0..404).map(branch).collect(),
            bifurcations: vec![BranchBifurcation {
                diagram,
                kind,
                loops,
                impacts: 1,
                wall: 0,
                secondary,
                primary: 0.5 * across,
                impact_velocity,
                x: 0.6 * up,
            }],
            attractor: (0..500)
                .map(|k| AttractorPoint {
                    diagram,
                    secondary,
                    primary: 0.9 * across,
                    x: f64::from(k) * 0.001 * up,
                })
                .collect(),
            portraits: (0..40 * portraits).map(orbit).collect(),
            ..empty(Frame { x: [0.0, across], y: [-0.5 * up, 2.0 * up] })
        }
    }

    /// The diagram as it is, and with the roles of its parameters exchanged.
    fn in_both_roles(figure: OneParameter) -> [OneParameter; 2] {
        let mut other = OneParameter { primary_is_fixed: true, ..figure.clone() };
        other.each_row(&mut |row| row.place(figure.diagram, true));
        [figure, other]
    }

    /// The diagram with a title that states the value of the fixed parameter.
    fn drawn(figure: &OneParameter, names: &Names, width: SheetWidth) -> Sheet {
        let tables = &["diagram_bifurcations", "diagram_branches", "diagram_attractor", "diagram_portraits"];
        let heading = Heading { name: "diagram", title: "", description: "", names, tables };
        draw_one_parameter(figure, &heading, true, width).unwrap()
    }

    #[test]
    fn diagram_and_magnification_stand_one_above_the_other_in_one_column() {
        let frame = Frame { x: [0.2, 0.7], y: [-0.3, 0.4] };
        let figure = OneParameter { magnified: Some(frame), ..sample([1.0, 1.0], 1) };
        let names = Names::new("A", "omega");
        let size = |width| drawn(&figure, &names, width).size;
        let (one, paper) = (size(SheetWidth::OneColumn), size(SheetWidth::Paper));
        assert!(one.1 > 1.5 * one.0 && paper.0 > paper.1, "{one:?} {paper:?}");
    }

    #[test]
    fn no_two_labels_overlap_for_any_parameters_units_and_portraits_at_any_width() {
        for names in [["A", "omega"], ["F_0", "forcing_frequency"], ["amplitude_of_the_exciter", "Omega"]] {
            let names = Names::new(names[0], names[1]);
            for (scale, portraits) in [([1.0, 1.0], 0), ([1e-4, 1e3], 1), ([250.0, 2e-5], 3), ([1.0, 1.0], 7)]
            {
                for (figure, width) in in_both_roles(sample(scale, portraits))
                    .iter()
                    .flat_map(|figure| WIDTHS.map(|width| (figure, width)))
                {
                    let sheet = drawn(figure, &names, width);
                    sheet.assert_well_placed(&(scale, portraits, width, figure.primary_is_fixed));
                }
            }
        }
    }

    #[test]
    fn titles_name_the_parameters_in_their_roles_and_what_x_is_counted_from() {
        let names = Names::new("A", "omega");
        let texts = |figure: &OneParameter| drawn(figure, &names, SheetWidth::Paper).texts();
        let [figure, mut other] = in_both_roles(sample([1.0, 1.0], 1));
        assert!(texts(&figure).contains(&"long-time behaviour".to_owned()), "the dots are named");
        assert!(texts(&figure).contains(&r"$A$  ($\omega=0.855$)".to_owned()), "{:?}", texts(&figure));
        other.from_the_wall = true;
        let found = texts(&other);
        for title in [r"$\omega$  ($A=0.855$)", "$x$ from the wall", "$y$"] {
            assert!(found.iter().any(|text| text == title), "{title}: {found:?}");
        }
        let [primary, secondary] = ["N", "rad/s"].map(|unit| Some(unit.to_owned()));
        let [length, time] = ["mm", "s"].map(|unit| Some(unit.to_owned()));
        let named = names.clone().with_units(UnitNames { length, time, mass: None, primary, secondary });
        let texts = drawn(&other, &named, SheetWidth::Paper).texts();
        for title in ["$x$ from the wall (mm)", "$y$ (mm/s)"] {
            assert!(texts.iter().any(|text| text == title), "{title}: {texts:?}");
        }
        assert!(texts.contains(&r"$\omega$ (rad/s)  ($A=0.855$ N)".to_owned()), "{texts:?}");
    }

    #[test]
    fn portraits_name_their_columns_whatever_the_unit() {
        let [figure, _] = in_both_roles(sample([1.0, 1.0], 2));
        let [length, time] = ["mm", "s"].map(|unit| Some(unit.to_owned()));
        for names in [
            Names::new("A", "omega"),
            Names::new("A", "omega").with_units(UnitNames { length, time, ..UnitNames::default() }),
        ] {
            let svg = drawn(&figure, &names, SheetWidth::Paper).svg();
            assert!(svg.contains("data-only=\"portrait 2\" data-columns=\"x y\""), "{svg}");
        }
        // Those of the paper are named by their titles.
        assert!(!drawn(&figure, &Names::of_the_paper(), SheetWidth::Paper).svg().contains("data-columns"));
    }

    #[test]
    fn panels_say_whose_rows_they_show_and_all_is_in_the_same_place_in_both_roles() {
        let figures = in_both_roles(sample([1.0, 1.0], 2));
        let [one, other] = figures
            .each_ref()
            .map(|figure| drawn(figure, &Names::new("A", "omega"), SheetWidth::Paper).svg());
        assert!(one.contains("data-only=\"diagram 2\" data-columns=\"A x\""));
        assert!(other.contains("data-only=\"diagram 2\" data-columns=\"omega x\""));
        assert!(one.contains("data-tables=\"diagram_portraits\" data-only=\"portrait 2\""));
        let paths = |svg: &str| {
            let drawn = svg.lines().filter(|line| line.contains("<path") || line.contains("<circle"));
            drawn.map(str::to_owned).collect::<Vec<_>>()
        };
        assert_eq!(paths(&one), paths(&other));
    }
}
