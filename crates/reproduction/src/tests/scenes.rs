//! Tests of scenes in phase space: names, and the order of painting.

use std::collections::BTreeSet;
use std::sync::Arc;

use grazing_drawing::SheetWidth;
use grazing_drawing::ink::style::{INCOMING_FACE, SECTION_FACE};
use grazing_drawing::ink::svg::fill;
use grazing_results::space::CurveKind;

use super::study;
use crate::figures::fig01::{self, Figure1};
use crate::figures::fig03::{self, Figure3};
use crate::figures::fig09::{self, Figure9};

const WIDTHS: [SheetWidth; 3] = [SheetWidth::OneColumn, SheetWidth::Paper, SheetWidth::TwoColumns];

#[test]
fn everything_is_named_at_every_width() {
    let study = study();
    for (sheet, scene) in [
        (fig01::SHEET, study.shown::<Figure1>()),
        (fig03::SHEET, study.shown::<Figure3>()),
        (fig09::SHEET, study.shown::<Figure9>()),
    ] {
        let scene = scene.unwrap();
        let marks = scene.points.iter().filter_map(sheet.mark);
        let names = sheet.names.iter().map(|(_, name, ..)| (*name).to_owned());
        let axes = ["$x$", "$y$", "$z$"].map(str::to_owned);
        let wanted: BTreeSet<String> = marks.chain(names).chain(axes).collect();
        for width in WIDTHS {
            let found = sheet.draw(&scene, width).unwrap().texts.into_iter().map(|(text, _)| text);
            assert_eq!(BTreeSet::from_iter(found), wanted, "{} {width:?}", sheet.name);
        }
    }
}

#[test]
fn orbits_are_solid_and_only_the_reset_law_is_dashed() {
    let sample = study().shown::<Figure1>().unwrap();
    let svg = fig01::SHEET.draw(&sample, SheetWidth::Paper).unwrap().svg();
    let resets = sample.curves.iter().filter(|vertex| vertex.kind == CurveKind::Reset);
    let resets: BTreeSet<u32> = resets.map(|vertex| vertex.number).collect();
    assert_eq!(svg.matches("stroke-dasharray").count(), resets.len());
}

#[test]
fn what_lies_beyond_the_wall_is_painted_before_the_wall() {
    let svg = fig09::SHEET.draw(&study().shown::<Figure9>().unwrap(), SheetWidth::Paper).unwrap().svg();
    let wall = svg.rfind(&fill(INCOMING_FACE)).expect("the incoming set is painted");
    let dashed = "stroke-dasharray=\"3 2\"";
    assert!(svg.matches(dashed).count() >= 3, "three virtual parts");
    assert!(svg.rfind(dashed).is_some_and(|last| last < wall));
    assert!(svg.rfind(&fill(SECTION_FACE)).is_some_and(|front| wall < front));
}

#[test]
fn a_missing_coordinate_is_an_error() {
    let mut sample = Arc::unwrap_or_clone(study().shown::<Figure1>().unwrap());
    sample.curves[3].place[1] = f64::NAN;
    let error = fig01::SHEET.draw(&sample, SheetWidth::Paper).unwrap_err();
    assert!(error.to_string().contains("range of fig01"), "{error}");
}
