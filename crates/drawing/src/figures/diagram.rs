//! A two-parameter bifurcation diagram, like Figure 7.

use grazing_continuation::bifurcation::CodimensionTwo;
use grazing_input::LabelKind;
use grazing_results::plane::{PlaneDiagram, RegionKind};
use grazing_results::{Dimensioned, Frame};

use crate::error::DrawingError;
use crate::figures::look::Look;
use crate::geometry::clip::checked;
use crate::geometry::sheet::{Bounds, Spot, area};
use crate::ink::canvas::Canvas;
use crate::ink::labels::{Labels, Site};
use crate::ink::legend;
use crate::ink::sheet::Sheet;
use crate::ink::style::{BLACK, LABEL_SIZE, SECTION, SMALL_LABEL_SIZE, THIN_SECTION};
use crate::plot::axes::{Heading, Panel, overhang, room_beside};
use crate::plot::kinds::{
    DrawnRegion, draw_curves, draw_ends, draw_points, draw_several, name_several, shown_curves,
};
use crate::plot::magnified::{OFF_TRIANGLE, letter, rectangle};
use crate::plot::measured::draw_measured;
use crate::plot::own::{draw_own, name_own};

/// The width of this figure in the paper.
const WIDTH_MM: f64 = 120.0;
/// The height as a fraction of the width, up to the greatest height that leaves room for a caption and
/// text on the page.
const HEIGHT_SHARE: f64 = 0.8;
const MOST_HEIGHT_MM: f64 = 118.0;
/// The least height; on narrow sheets the diagram is taller than its fraction of the width, so that
/// labels fit.
const LEAST_HEIGHT_MM: f64 = 78.0;
/// Room around the panel for common numbers and titles, in points; longer ones get more.
const MARGINS: Bounds = Bounds { left: 35.0, top: 5.0, right: 8.0, bottom: 30.0 };
/// The greatest length of a leader, in points, so that none crosses the plane.
const LONGEST_LEADER: f64 = 28.0;
/// Curves shorter than this on the sheet (points) have no label.
const LABELLED_LENGTH: f64 = 42.0;

/// Draws a two-parameter bifurcation diagram.
///
/// Inadmissible points are not drawn, and grazing curves are dotted where the grazing solution is
/// unstable. Resonances of a p without a region have p written beside them.
///
/// # Errors
/// [`DrawingError`] if a frame is empty.
pub fn draw_diagram(
    diagram: &PlaneDiagram,
    heading: &Heading<'_>,
    look: impl Into<Look>,
) -> Result<Sheet, DrawingError> {
    let look = &look.into();
    if look.style.swap {
        let names = heading.names.clone().swapped();
        let (heading, look) = (Heading { names: &names, ..*heading }, look.clone().unswapped());
        let mut diagram = diagram.clone();
        diagram.exchange();
        return draw_diagram(&diagram, &heading, look);
    }
    let frame = checked(diagram.frame, heading.name)?;
    for magnified in &diagram.magnified {
        checked(magnified.frame, &format!("a rectangle of {}", heading.name))?;
    }
    let names = heading.names;
    let [across, up] = &names.titles();

    let width = look.width_mm(WIDTH_MM);
    let usual = (HEIGHT_SHARE * width).clamp(LEAST_HEIGHT_MM, MOST_HEIGHT_MM);
    let canvas = Canvas::new(width, look.style.height.unwrap_or(usual))?.coloured(&look.style.colours);
    let bounds = bounds(&canvas, &frame, up)?;
    let mut panel =
        Panel { tables: heading.tables, columns: names.columns(), ..Panel::new(&canvas, frame, bounds)? };
    let mut labels = Labels::new(&canvas, bounds);
    labels.farthest = LONGEST_LEADER;

    let mut shapes: Vec<(u32, Vec<Spot>)> = Vec::new();
    for region in DrawnRegion::all(&diagram.regions).into_iter().filter(|region| look.shows(region.kind)) {
        let shape = region.draw(&mut panel)?;
        if region.kind == RegionKind::Mps && !shape.is_empty() {
            shapes.push((region.p, shape));
        }
    }
    let shaded = look.shows(RegionKind::SeveralImpacts);
    let several = if shaded { draw_several(&mut panel, &mut labels, &diagram.several)? } else { Vec::new() };
    let mut shown = shown_curves(&diagram.curves);
    shown.extend(shown_curves(&diagram.at_both_walls));
    let drawn = draw_curves(&mut panel, &mut labels, shown)?;
    let own = draw_own(&mut panel, &mut labels, &diagram.own)?;
    let mut sections = Vec::new();
    for section in diagram.sections.iter().filter(|_| look.names(LabelKind::Diagrams)) {
        let pen = if section.thin { THIN_SECTION } else { SECTION };
        let line = panel.draw_series(panel.curve(&section.ends, pen))?;
        for piece in line.label("line of a one-parameter diagram").legend(legend::line(pen))?.pieces {
            if section.thin {
                labels.placer.keep_off_nameless(&piece);
            } else {
                labels.placer.keep_off(&piece);
            }
            sections.push((section, piece));
        }
    }
    let mut unnamed: Vec<(u32, Spot)> = Vec::new();
    for (point, spot) in draw_points(&mut panel, &mut labels, &diagram.points)? {
        let p = point.loops;
        if point.kind == CodimensionTwo::Resonance && !shapes.iter().any(|(known, _)| *known == p) {
            unnamed.push((p, spot));
        }
    }
    let curves = diagram.curves.iter().chain(&diagram.at_both_walls);
    let lost = curves.filter(|point| !point.at.lost.is_empty());
    let lost_own = diagram.own.iter().filter(|point| !point.at.lost.is_empty());
    let lost = lost.map(|point| (point.at.primary, point.at.secondary));
    let lost = lost.chain(lost_own.map(|point| (point.at.primary, point.at.secondary)));
    draw_ends(&mut panel, &mut labels, lost)?;
    let mut boxes = Vec::new();
    for magnified in diagram.magnified.iter().filter(|_| look.names(LabelKind::Magnifications)) {
        let outline = rectangle(&mut panel, &magnified.frame, &mut labels)?;
        boxes.extend(outline.map(|outline| (magnified.panel, outline)));
    }
    draw_measured(&mut panel, &mut labels, &diagram.measured)?;
    panel.axes(across, up)?;

    for (number, outline) in &boxes {
        letter(&mut labels, *number, outline)?;
    }
    for (section, line) in &sections {
        let beside =
            section.thin && labels.add(&section.name, SMALL_LABEL_SIZE, BLACK, &Site::Beside(line))?;
        if let (false, Some(&end)) = (beside, line.last()) {
            labels.add(&section.name, SMALL_LABEL_SIZE, BLACK, &Site::Around(end, 2.5))?;
        }
    }
    let named = look.names(LabelKind::Regions);
    for (p, shape) in by_area(&shapes).into_iter().filter(|_| named) {
        let text = format!("$p={p}$");
        let inside = labels.add(&text, LABEL_SIZE, BLACK, &Site::Within(shape))?
            || labels.add(&text, SMALL_LABEL_SIZE, BLACK, &Site::Within(shape))?;
        if !inside && let Some(spot) = labels.placer.deep_inside(shape) {
            labels.add(&text, SMALL_LABEL_SIZE, BLACK, &Site::Around(spot, 1.0))?;
        }
    }
    if named {
        name_several(&mut labels, bounds, &several)?;
    }
    for (p, spot) in unnamed.iter().filter(|_| named) {
        labels.add(&format!("$p={p}$"), SMALL_LABEL_SIZE, BLACK, &Site::Around(*spot, OFF_TRIANGLE))?;
    }
    if look.names(LabelKind::Curves) {
        name_own(&mut labels, &own)?;
        labels.name_curves(drawn, LABELLED_LENGTH, &names.grazing_title())?;
    }
    labels.draw()?;
    canvas.finish(heading.name, heading.title, heading.description)
}

/// The bounds of the panel: within the margins, or wider ones if the numbers or the title need them.
fn bounds(canvas: &Canvas, frame: &Frame, up: &str) -> Result<Bounds, DrawingError> {
    let (top, bottom) = (MARGINS.top, canvas.height - MARGINS.bottom);
    let left = room_beside(&canvas.fonts, frame.y, bottom - top, up)?.max(MARGINS.left);
    let beyond = overhang(&canvas.fonts, frame.x, canvas.width - left - MARGINS.right)?;
    let right = canvas.width - MARGINS.right.max(beyond + 2.0);
    Ok(Bounds { left, top, right, bottom })
}

/// The shapes in order of decreasing area; equal areas keep their order. Of shapes that lie in the same place, as those of
/// mirror images between two like walls, the first stands for all.
fn by_area(shapes: &[(u32, Vec<Spot>)]) -> Vec<(u32, &[Spot])> {
    let mut sorted: Vec<(u32, &[Spot])> = Vec::new();
    for (p, shape) in shapes {
        if !sorted.iter().any(|(known, other)| known == p && coincide(other, shape)) {
            sorted.push((*p, shape));
        }
    }
    sorted.sort_by(|a, b| area(b.1).total_cmp(&area(a.1)));
    sorted
}

/// Whether two shapes have the same extent, to a part of a point that nobody sees.
fn coincide(one: &[Spot], other: &[Spot]) -> bool {
    let extent = |shape: &[Spot]| {
        let none = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
        shape.iter().fold(none, |[left, top, right, bottom], &(x, y)| {
            [left.min(x), top.min(y), right.max(x), bottom.max(y)]
        })
    };
    extent(one).into_iter().zip(extent(other)).all(|(a, b)| (a - b).abs() < 0.1)
}

#[cfg(test)]
mod tests {
    use grazing_continuation::bifurcation::Bifurcation;
    use grazing_results::plane::DiagramLine;

    use super::*;
    use crate::SheetWidth;
    use crate::ink::style::TRIANGLE_SIZE;
    use crate::tests::sample_oscillator::{SampleOscillator, UNIT, oscillators, sample};
    use crate::tests::samples::WIDTHS;

    fn texts(sample: &SampleOscillator) -> Vec<String> {
        let sheet = draw_diagram(&sample.diagram, &sample.heading(), SheetWidth::Paper).unwrap();
        sheet.assert_well_placed(&sample.names);
        sheet.texts()
    }

    #[test]
    fn no_two_labels_overlap_and_none_leaves_the_sheet_for_any_oscillator_at_any_width() {
        for sample in oscillators() {
            for width in WIDTHS {
                let sheet = draw_diagram(&sample.diagram, &sample.heading(), width).unwrap();
                sheet.assert_well_placed(&(&sample.names, width));
                // Every magnification has its letter and its rectangle.
                let letters = sheet.texts().iter().filter(|text| text.starts_with('(')).count();
                let rectangles = crate::tests::inspection::paths(&sheet.svg(), "#f08200").len();
                let magnified = sample.diagram.magnified.len();
                assert_eq!([letters, rectangles], [magnified; 2], "{:?} {width:?}", sample.names);
            }
        }
    }

    #[test]
    fn inadmissible_rows_are_not_drawn() {
        let mut sample = sample(3);
        let count = |sample: &SampleOscillator| {
            let svg = draw_diagram(&sample.diagram, &sample.heading(), SheetWidth::Paper).unwrap().svg();
            crate::tests::inspection::paths(&svg, "#1946be").len()
        };
        assert_eq!(count(&sample), 3, "saddle-node curves");
        sample.diagram.curves.iter_mut().for_each(|point| point.at.admissible = false);
        assert_eq!(count(&sample), 0);
    }

    #[test]
    fn axes_and_grazing_curve_bear_the_names_of_the_parameters() {
        let sample = SampleOscillator::new(["F_0", "Omega"], UNIT, UNIT, 3);
        let texts = texts(&sample);
        for title in ["$F_{0}$", r"$\Omega$", r"$F_{0,\mathrm{graz}}$"] {
            assert!(texts.iter().any(|text| text == title), "{title}: {texts:?}");
        }
        let svg = draw_diagram(&sample.diagram, &sample.heading(), SheetWidth::Paper).unwrap().svg();
        assert!(svg.contains("data-tables=\"points curves\" data-columns=\"F_0 Omega\""));
    }

    #[test]
    fn regions_of_two_like_walls_that_coincide_have_one_name() {
        let mut sample = sample(3);
        let count =
            |sample: &SampleOscillator| texts(sample).iter().filter(|text| text.starts_with("$p=")).count();
        let once = count(&sample);
        let mut mirrored = sample.diagram.regions.clone();
        let most = mirrored.iter().map(|vertex| vertex.region).max().expect("there are regions");
        mirrored.iter_mut().for_each(|vertex| (vertex.region, vertex.wall) = (vertex.region + most + 1, 2));
        sample.diagram.regions.extend(mirrored);
        assert_eq!(count(&sample), once);
    }

    #[test]
    fn a_resonance_without_a_region_has_its_p_beside_it() {
        let mut sample = sample(5);
        let count = |texts: &[String]| texts.iter().filter(|text| text.starts_with("$p=")).count();
        assert_eq!(count(&texts(&sample)), 5);
        sample.diagram.regions.clear();
        assert_eq!(count(&texts(&sample)), 5);
        let svg = draw_diagram(&sample.diagram, &sample.heading(), SheetWidth::Paper).unwrap().svg();
        assert!(!svg.contains("fill-opacity"), "no region is filled");
    }

    #[test]
    fn without_a_resonance_the_grazing_curve_stands_alone() {
        let mut sample = sample(0);
        sample.diagram.regions.clear();
        assert!(sample.diagram.points.is_empty());
        let texts = texts(&sample);
        assert!(texts.contains(&r"$A_{\mathrm{graz}}$".to_owned()));
        assert!(!texts.iter().any(|text| ["SN", "PD", "GZ"].contains(&text.as_str())), "{texts:?}");
    }

    #[test]
    fn resonances_may_come_without_their_curves() {
        let mut sample = sample(4);
        // The first 201 rows are the grazing curve.
        sample.diagram.curves.truncate(201);
        sample.diagram.regions.clear();
        let svg = draw_diagram(&sample.diagram, &sample.heading(), SheetWidth::Paper).unwrap().svg();
        // A triangle is a path with three corners.
        let triangles = svg.lines().filter(|line| line.contains('Z') && line.matches('L').count() == 2);
        assert_eq!(triangles.count(), 4);
    }

    #[test]
    fn the_grazing_curve_may_fold_back_and_fall_into_pieces() {
        let mut sample = sample(0);
        let share = |i: i32| f64::from(i) / 50.0 - 1.0;
        let fold = |(arc, middle): (u32, f64)| {
            let points = (0..=100).map(|i| (middle + 0.2 * share(i) * share(i), 0.65 + 0.3 * share(i)));
            (Bifurcation::NonImpactingGrazing, 0, 0, arc, points.collect())
        };
        let pieces: Vec<_> = [(0, 0.2), (1, 0.7)].map(fold).to_vec();
        sample.diagram.curves = crate::tests::sample_oscillator::curve_rows(pieces);
        sample.diagram.regions.clear();
        let svg = draw_diagram(&sample.diagram, &sample.heading(), SheetWidth::Paper).unwrap().svg();
        let curves = crate::tests::inspection::paths(&svg, "#78c86e");
        assert_eq!(curves.len(), 2);
        // Each curve runs left, turns and runs back to the right: its ends are one above the other.
        for curve in &curves {
            let (first, last) = (curve[0], curve[curve.len() - 1]);
            assert!((first.0 - last.0).abs() < 0.02 && (first.1 - last.1).abs() > 50.0);
            assert!(curve.iter().any(|spot| spot.0 < first.0 - 20.0));
        }
        assert!(texts(&sample).iter().filter(|text| text.contains("graz")).count() == 2);
    }

    #[test]
    fn only_rectangles_that_are_seen_have_their_letters() {
        let mut sample = sample(4);
        let whole = sample.diagram.frame;
        sample.diagram.frame.x[1] = sample.diagram.magnified[0].frame.x[0] - 0.01;
        let letters = texts(&sample).into_iter().filter(|text| text.starts_with('(')).collect::<Vec<_>>();
        assert_eq!(letters, ["(b)", "(c)", "(d)"]);
        sample.diagram.frame = whole;
        assert!(texts(&sample).contains(&"(a)".to_owned()));
    }

    #[test]
    fn a_rectangle_too_small_to_be_drawn_is_dotted_around_its_place() {
        let mut sample = sample(3);
        // All rectangles, and those that are dotted.
        let rectangles = |sample: &SampleOscillator| {
            let svg = draw_diagram(&sample.diagram, &sample.heading(), SheetWidth::Paper).unwrap().svg();
            let dotted = svg.lines().filter(|line| line.contains("#f08200") && line.contains("dasharray"));
            let all = crate::tests::inspection::paths(&svg, "#f08200");
            for outline in &all {
                let Bounds { left, top, right, bottom } = Bounds::around(outline);
                assert!(right - left > TRIANGLE_SIZE && bottom - top > TRIANGLE_SIZE, "{outline:?}");
            }
            // One dotted rectangle is in the legend.
            [all.len(), dotted.count().saturating_sub(1)]
        };
        assert_eq!(rectangles(&sample), [3, 0]);
        let Frame { x: [left, _], y: [low, _] } = sample.diagram.magnified[1].frame;
        // A thousandth of the range is a third of a point on the sheet.
        sample.diagram.magnified[1].frame = Frame { x: [left, left + 0.001], y: [low, low + 0.001] };
        assert_eq!(rectangles(&sample), [3, 1]);
        assert!(texts(&sample).contains(&"(b)".to_owned()));
        // Wide, but no higher than the line is thick.
        let Frame { x: [left, right], y: [low, _] } = sample.diagram.magnified[2].frame;
        sample.diagram.magnified[2].frame = Frame { x: [left, right], y: [low, low + 0.002] };
        assert_eq!(rectangles(&sample), [3, 2]);
        assert!(texts(&sample).contains(&"(c)".to_owned()));
    }

    #[test]
    fn one_parameter_diagrams_are_shown_where_they_run() {
        let mut sample = sample(3);
        let ends = [(0.25, 0.0), (0.25, 1.0)];
        sample.diagram.sections.push(DiagramLine { ends, name: "diagram 1".to_owned(), thin: true });
        for width in WIDTHS {
            let sheet = draw_diagram(&sample.diagram, &sample.heading(), width).unwrap();
            sheet.assert_well_placed(&width);
            assert!(sheet.texts().contains(&"diagram 1".to_owned()), "{:?}", sheet.texts());
            let svg = sheet.svg();
            assert!(svg.contains("aria-label=\"line of a one-parameter diagram\""));
        }
    }

    #[test]
    fn an_empty_rectangle_is_an_error_that_names_the_diagram() {
        let mut sample = sample(2);
        sample.diagram.magnified[1].frame.y = [0.5, 0.5];
        let error = draw_diagram(&sample.diagram, &sample.heading(), SheetWidth::Paper).unwrap_err();
        assert!(error.to_string().contains("a rectangle of diagram"), "{error}");
    }
}
