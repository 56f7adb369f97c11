//! Tests of the entries in a diagram's legend, and of their pens.

use plotters::element::IntoDynElement;
use plotters_backend::BackendCoord;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_results::Stability;
use grazing_results::kinds::{Colour, CurveLook};
use grazing_results::measured::{Agreement, MeasuredPoint, SeenKind};
use grazing_results::plane::{PlanePoint, RegionKind};

use crate::ink::canvas::Canvas;
use crate::ink::legend::{hatching, line};
use crate::ink::markers::Marker;
use crate::ink::style::UNDECIDED;
use crate::plot::kinds::pen;
use crate::tests::inspection::paths;
use crate::tests::sample_oscillator::{SampleOscillator, sample};
use crate::{Sheet, SheetWidth, draw_diagram};

const WIDTH: SheetWidth = SheetWidth::Paper;

fn drawn(sample: &SampleOscillator) -> Sheet {
    draw_diagram(&sample.diagram, &sample.heading(), WIDTH).unwrap()
}

fn hexadecimal([red, green, blue]: Colour) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// A sample as the legend of a sheet has it.
fn sampled<E>(sample: impl Fn(BackendCoord) -> E) -> Option<String>
where
    E: IntoDynElement<'static, Canvas, BackendCoord>,
{
    let canvas = Canvas::new(10.0, 10.0).unwrap();
    canvas.explain("", |at| sample(at).into_dyn()).unwrap();
    canvas.finish("test", "", "").unwrap().legend.pop().map(|(_, drawing)| drawing)
}

/// The drawing of the sample for a meaning in the legend.
fn explained(sheet: &Sheet, meaning: &str) -> Option<String> {
    let (_, drawing) = sheet.legend.iter().find(|(words, _)| words == meaning)?;
    Some(drawing.clone())
}

#[test]
fn a_legend_shows_each_kind_with_the_pen_that_its_curves_are_drawn_with() {
    let mut sample = sample(3);
    let kinds = [
        (Bifurcation::SaddleNode, "saddle-node bifurcation (SN)"),
        (Bifurcation::PeriodDoubling, "period-doubling bifurcation (PD)"),
        (Bifurcation::Grazing, "grazing of a maximal periodic solution (GZ)"),
        (Bifurcation::NonImpactingGrazing, "grazing of the non-impacting solution"),
    ];
    let all = drawn(&sample);
    for (kind, meaning) in kinds {
        let colour = hexadecimal(CurveLook::of(kind).colours[0]);
        assert_eq!(explained(&all, meaning), sampled(line(pen(&CurveLook::of(kind)))), "{meaning}");
        assert!(
            sampled(line(pen(&CurveLook::of(kind)))).is_some_and(|line| line.contains(&colour)),
            "{meaning}"
        );
        assert!(!paths(&all.svg(), &colour).is_empty(), "{meaning}");
    }
    // Without its curves a kind has no ink and no entry, and other kinds are not affected.
    for (kind, meaning) in kinds {
        let before = sample.diagram.curves.clone();
        sample.diagram.curves.retain(|point| point.kind != kind);
        let sheet = drawn(&sample);
        for (other, words) in kinds {
            let colour = hexadecimal(CurveLook::of(other).colours[0]);
            assert_eq!(explained(&sheet, words).is_some(), other != kind, "{words} without {meaning}");
            assert_eq!(!paths(&sheet.svg(), &colour).is_empty(), other != kind, "{words} without {meaning}");
        }
        sample.diagram.curves = before;
    }
}

#[test]
fn what_is_undecided_is_hatched_and_never_shaded() {
    let mut sample = sample(3);
    let shaded = |sheet: &Sheet| {
        sheet.legend.iter().any(|(words, _)| words.starts_with("a maximal periodic solution is stable"))
    };
    let hatched = |sheet: &Sheet| explained(sheet, "stability is undecided");
    let mut mps = |kind: RegionKind| {
        let of_mps = sample.diagram.regions.iter_mut().filter(|vertex| vertex.loops > 0);
        of_mps.for_each(|vertex| vertex.kind = kind);
        drawn(&sample)
    };
    let decided = mps(RegionKind::Mps);
    assert!(shaded(&decided) && hatched(&decided).is_none());
    let undecided = mps(RegionKind::Undecided);
    assert_eq!(hatched(&undecided), sampled(hatching(UNDECIDED)));
    assert!(!shaded(&undecided));
    let lines = paths(&undecided.svg(), &hexadecimal(UNDECIDED.colour));
    assert!(lines.len() > paths(&decided.svg(), &hexadecimal(UNDECIDED.colour)).len());
}

#[test]
fn grazing_of_what_is_unstable_is_dotted_and_lost_ends_have_rings() {
    let mut sample = sample(3);
    let grazing = CurveLook::of(Bifurcation::Grazing);
    let unstable = format!("{}, where that is unstable", grazing.meaning);
    let lines = |sample: &SampleOscillator| {
        let svg = drawn(sample).svg();
        let dots = format!("stroke-dasharray=\"{} {}\"", CurveLook::DOTS[0], CurveLook::DOTS[1]);
        svg.matches(&dots).count()
    };
    let ring = "a curve could not be followed further (reason in its table)";
    assert_eq!([explained(&drawn(&sample), &unstable), explained(&drawn(&sample), ring)], [None, None]);
    // Stability is marginal at the ends of GZ curves.
    let own = |point: &PlanePoint| (point.kind == Bifurcation::Grazing).then_some(point.at.arc);
    let arc = sample.diagram.curves.iter().find_map(own).unwrap();
    let indices: Vec<usize> = (0..)
        .zip(&sample.diagram.curves)
        .filter(|(_, point)| own(point) == Some(arc))
        .map(|(index, _)| index)
        .collect();
    let (first, last) = (indices[0], indices[indices.len() - 1]);
    for index in [first, last] {
        sample.diagram.curves[index].at.stable = false.into();
    }
    assert_eq!(lines(&sample), 0);
    let [neutral, meaning] = [Stability::Neutral, false.into()].map(|stability| {
        for index in &indices[20..60] {
            sample.diagram.curves[*index].at.stable = stability;
        }
        assert_eq!(lines(&sample), 2, "once in the figure and once in its legend");
        let sheet = drawn(&sample);
        [explained(&sheet, &unstable), explained(&sheet, &unstable.replace("unstable", "neutral"))]
    });
    assert!(matches!((neutral, meaning), ([None, Some(_)], [Some(_), None])));
    let sheet = drawn(&sample);
    assert!(explained(&sheet, &unstable).unwrap().contains(&hexadecimal(grazing.colours[0])));
    // Once in the figure and once in its legend.
    assert_eq!(lines(&sample), 2);
    sample.diagram.curves[last].at.lost = "no further point was found".to_owned();
    assert_eq!(explained(&drawn(&sample), ring), sampled(Marker::Ring.sample()));
    // For other kinds of curves stability is ignored.
    let before = lines(&sample);
    let others =
        |at: &&mut PlanePoint| matches!(at.kind, Bifurcation::SaddleNode | Bifurcation::PeriodDoubling);
    sample.diagram.curves.iter_mut().filter(others).for_each(|at| at.at.stable = false.into());
    assert_eq!(lines(&sample), before);
}

#[test]
fn marks_of_measurements_tell_what_was_seen_and_whether_it_agrees_without_colour() {
    let mut sample = sample(3);
    let frame = sample.diagram.frame;
    let kinds = [SeenKind::NonImpacting, SeenKind::Loops, SeenKind::Other, SeenKind::Bifurcation];
    let verdicts = [Agreement::Agrees, Agreement::Disagrees, Agreement::Silent];
    let all = kinds.iter().flat_map(|kind| verdicts.map(|agreement| (*kind, agreement)));
    let at = |[low, high]: [f64; 2], share: f64| low + (high - low) * share;
    let point = |(index, (kind, agreement)): (u32, (SeenKind, Agreement))| MeasuredPoint {
        line: index,
        secondary: at(frame.y, 0.9),
        secondary_error: f64::NAN,
        primary: at(frame.x, 0.1 + 0.05 * f64::from(index)),
        primary_error: 0.01 * (frame.x[1] - frame.x[0]),
        kind,
        seen: String::new(),
        agreement,
        theory: String::new(),
        regions: String::new(),
        distance: f64::NAN,
        reason: String::new(),
    };
    let before = drawn(&sample).svg().matches("<path").count();
    sample.diagram.measured = (0..).zip(all).map(point).collect();
    let sheet = drawn(&sample);
    sheet.assert_well_placed(&"measured");
    let meanings: Vec<&str> = sheet
        .legend
        .iter()
        .map(|(words, _)| words.as_str())
        .filter(|words| words.starts_with("measured"))
        .collect();
    let mut marks: Vec<&str> = sheet
        .legend
        .iter()
        .filter(|(words, _)| words.starts_with("measured"))
        .map(|(_, drawing)| drawing.as_str())
        .collect();
    assert_eq!(marks.len(), 12, "{meanings:?}");
    marks.sort_unstable();
    marks.dedup();
    assert_eq!(marks.len(), 12, "two look alike");
    // Each has an outline and an error bar, and those that disagree have four strokes more.
    assert!(sheet.svg().matches("<path").count() >= before + 2 * 12 + 4 * 4);
    // Measurements outside the frame are not drawn.
    sample.diagram.measured.iter_mut().for_each(|point| point.primary = frame.x[1] + 1.0);
    assert_eq!(drawn(&sample).svg().matches("<path").count(), before);
}
