//! Tests of scenes in phase space: names, and the order of painting.

use std::collections::BTreeSet;
use std::sync::Arc;

use grazing_drawing::SheetWidth;
use grazing_drawing::ink::style::{INCOMING_FACE, SECTION_FACE};
use grazing_drawing::ink::svg::fill;
use grazing_reproduction::StudyFigure;
use grazing_reproduction::figures::fig01::Figure1;
use grazing_reproduction::figures::fig03::Figure3;
use grazing_reproduction::figures::fig09::Figure9;
use grazing_results::space::{CurveKind, Mark, MarkKind, Scene};

use super::made;

fn scene<F: StudyFigure<Shown = Scene>>() -> Arc<Scene> {
    made().study.shown::<F>().expect("it can be computed")
}

fn svg<F: StudyFigure<Shown = Scene>>(scene: &Scene) -> String {
    F::draw(scene, SheetWidth::Paper).expect("it can be drawn").svg()
}

const WIDTHS: [SheetWidth; 3] = [SheetWidth::OneColumn, SheetWidth::Paper, SheetWidth::TwoColumns];

/// Tests that a figure has the names of its marks, these names and those of the axes at every width.
fn assert_named<F: StudyFigure<Shown = Scene>>(mark: impl Fn(&Mark) -> Option<String>, names: &[&str]) {
    let scene = scene::<F>();
    let others = names.iter().chain(&["$x$", "$y$", "$z$"]).map(|name| (*name).to_owned());
    let wanted: BTreeSet<String> = scene.points.iter().filter_map(mark).chain(others).collect();
    for width in WIDTHS {
        let found = F::draw(&scene, width).unwrap().texts.into_iter().map(|(text, _)| text);
        assert_eq!(BTreeSet::from_iter(found), wanted, "{} {width:?}", F::NAME);
    }
}

#[test]
fn everything_is_named_at_every_width() {
    assert_named::<Figure1>(|_| None, &["$R$", "incoming set", r"$\Sigma$", "outgoing set", "tangency set"]);
    let marks = [r"$(0,0,z_{\mathrm{graz}})$", "$(x,0,z)$", "$(x',0,z')$"];
    let names = [r"$P_{\mathrm{global}}$", r"$\Gamma$", r"$\Pi$", "$x=y=0$"];
    assert_named::<Figure3>(|_| None, &[&marks[..], &names].concat());
    let mark = |mark: &Mark| match mark.kind {
        MarkKind::Section => Some(format!("$(x^{{({0})}},0,z^{{({0})}})$", mark.number)),
        _ => None,
    };
    let marks = [
        r"$(0,y_{\mathrm{imp}},z_{\mathrm{imp}})$",
        r"$(0,y_{\mathrm{rec}},z_{\mathrm{rec}})$",
        r"$(\hat{x},0,\hat{z})$",
    ];
    let names = ["$R$", r"$P_{\mathrm{global}}$", r"$\Sigma$", r"$\Pi$"];
    assert_named::<Figure9>(mark, &[&marks[..], &names].concat());
}

#[test]
fn orbits_are_solid_and_only_the_reset_law_is_dashed() {
    let sample = scene::<Figure1>();
    let svg = svg::<Figure1>(&sample);
    let resets = sample.curves.iter().filter(|vertex| vertex.kind == CurveKind::Reset);
    let resets: BTreeSet<u32> = resets.map(|vertex| vertex.number).collect();
    assert_eq!(svg.matches("stroke-dasharray").count(), resets.len());
}

#[test]
fn what_lies_beyond_the_wall_is_painted_before_the_wall() {
    let svg = svg::<Figure9>(&scene::<Figure9>());
    let wall = svg.rfind(&fill(INCOMING_FACE)).expect("the incoming set is painted");
    let dashed = "stroke-dasharray=\"3 2\"";
    assert!(svg.matches(dashed).count() >= 3, "three virtual parts");
    assert!(svg.rfind(dashed).is_some_and(|last| last < wall));
    assert!(svg.rfind(&fill(SECTION_FACE)).is_some_and(|front| wall < front));
}

#[test]
fn a_missing_coordinate_is_an_error() {
    let mut sample = Arc::unwrap_or_clone(scene::<Figure1>());
    sample.curves[3].place[1] = f64::NAN;
    let error = Figure1::draw(&sample, SheetWidth::Paper).unwrap_err();
    assert!(error.to_string().contains("range of fig01"), "{error}");
}
