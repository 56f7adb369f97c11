//! Legends of the figures.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_results::Names;
use grazing_results::kinds::{Colour, CurveLook};
use grazing_results::plane::RegionKind;

use crate::ink::legend::Sample;
use crate::ink::style::UNDECIDED;
use crate::plot::kinds::pen;
use crate::tests::inspection::paths;
use crate::tests::sample_oscillator::{SampleOscillator, sample};
use crate::tests::samples::study;
use crate::{
    DrawingError, Heading, Sheet, SheetWidth, draw_diagram, draw_fig01, draw_fig02, draw_fig03, draw_fig04,
    draw_fig05, draw_fig06, draw_fig09, draw_fig10, draw_magnifications,
};

const WIDTH: SheetWidth = SheetWidth::Paper;

fn meanings(sheet: Result<Sheet, DrawingError>) -> Vec<String> {
    sheet.unwrap().legend.into_iter().map(|(meaning, _)| meaning).collect()
}

#[test]
fn sketches_have_no_legends() {
    let study = study();
    for (sheet, figure) in [
        (draw_fig01(&study.fig01().unwrap(), WIDTH), 1),
        (draw_fig03(&study.fig03().unwrap(), WIDTH), 3),
        (draw_fig06(&study.fig06().unwrap(), WIDTH), 6),
        (draw_fig09(&study.fig09().unwrap(), WIDTH), 9),
        (draw_fig10(&study.fig10().unwrap(), WIDTH), 10),
    ] {
        assert_eq!(meanings(sheet), [""; 0], "figure {figure}");
    }
}

#[test]
fn diagrams_have_legends_of_what_they_show() {
    let study = study();
    let names = &Names::of_the_paper();
    let heading = Heading { name: "figure", title: "", description: "", names, tables: &[] };
    let [fig02, fig04] = [
        meanings(draw_fig02(&study.fig02().unwrap(), WIDTH)),
        meanings(draw_fig04(&study.fig04().unwrap(), WIDTH)),
    ];
    let fig05 = meanings(draw_fig05(&study.fig05().unwrap(), WIDTH));
    let fig07 = meanings(draw_diagram(&study.fig07().unwrap(), &heading, WIDTH));
    let magnified = draw_magnifications(&study.fig08().unwrap(), &heading, WIDTH);
    let fig08 = meanings(magnified.map(|mut sheets| sheets.remove(0)));
    for (legend, words, there) in [
        (&fig02, "unstable", true),
        (&fig02, "long-time behaviour", true),
        (&fig02, "$p=3$", true),
        (&fig02, "$p=6$", false),
        (&fig04, "$h_p$", true),
        (&fig04, "$p=6$", true),
        (&fig05, "period-doubling bifurcation", true),
        (&fig05, "(GZ)", false),
        (&fig05, "a maximal periodic solution is stable", true),
        (&fig07, "(GZ)", true),
        (&fig07, "where a one-parameter diagram runs", true),
        (&fig07, "quadratic approximation", false),
        (&fig07, "another codimension-two point", true),
        (&fig08, "quadratic approximation to PD", true),
        (&fig08, "the non-impacting solution is stable", true),
        (&fig08, "stability is not decided", false),
    ] {
        let found = legend.iter().any(|meaning| meaning.contains(words));
        assert_eq!(found, there, "{words}: {legend:?}");
    }
}

fn drawn(sample: &SampleOscillator) -> Sheet {
    draw_diagram(&sample.diagram, &sample.heading(), WIDTH).unwrap()
}

fn hexadecimal([red, green, blue]: Colour) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// What the drawing of a sample looks like in the legend.
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
        assert_eq!(explained(&all, meaning), Some(Sample::Line(pen(kind)).element()), "{meaning}");
        assert!(Sample::Line(pen(kind)).element().contains(&colour), "{meaning}");
        assert!(!paths(&all.svg(), &colour).is_empty(), "{meaning}");
    }
    // Without its curves a kind has no ink and no entry, and no other kind loses either.
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
fn unstable_solutions_that_graze_are_not_drawn() {
    let mut sample = sample(3);
    let colour = hexadecimal(CurveLook::of(Bifurcation::Grazing).colours[0]);
    let count = |sample: &SampleOscillator| paths(&drawn(sample).svg(), &colour).len();
    assert_eq!(count(&sample), 3);
    let of_grazing = |kind: Bifurcation| kind == Bifurcation::Grazing;
    sample.diagram.curves.iter_mut().filter(|at| of_grazing(at.kind)).for_each(|at| at.stable = false);
    assert_eq!(count(&sample), 0);
    // Of the other kinds nothing of the sort is asked.
    sample.diagram.curves.iter_mut().for_each(|at| at.stable = of_grazing(at.kind));
    assert_eq!(count(&sample), 3);
    let saddle_nodes = hexadecimal(CurveLook::of(Bifurcation::SaddleNode).colours[0]);
    assert_eq!(paths(&drawn(&sample).svg(), &saddle_nodes).len(), 3);
}

#[test]
fn what_is_undecided_is_hatched_and_never_shaded() {
    let mut sample = sample(3);
    let shaded = |sheet: &Sheet| {
        sheet.legend.iter().any(|(words, _)| words.starts_with("a maximal periodic solution is stable"))
    };
    let hatched = |sheet: &Sheet| explained(sheet, "stability is not decided");
    let mut mps = |kind: RegionKind| {
        let of_mps = sample.diagram.regions.iter_mut().filter(|vertex| vertex.loops > 0);
        of_mps.for_each(|vertex| vertex.kind = kind);
        drawn(&sample)
    };
    let decided = mps(RegionKind::Mps);
    assert!(shaded(&decided) && hatched(&decided).is_none());
    let undecided = mps(RegionKind::Undecided);
    assert_eq!(hatched(&undecided), Some(Sample::Hatching(UNDECIDED).element()));
    assert!(!shaded(&undecided));
    let lines = paths(&undecided.svg(), &hexadecimal(UNDECIDED.colour));
    assert!(lines.len() > paths(&decided.svg(), &hexadecimal(UNDECIDED.colour)).len());
}
