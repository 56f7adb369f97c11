//! Legends of the figures.

use grazing_results::Names;

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
