//! The contents of an SVG appear in PDF and PNG, in the right places.

use std::io::Write;
use std::process::{Command, Stdio};

use grazing_report::{Drawing, FormatError};

use crate::picture::Picture;
use crate::reading::Reading;
use crate::{SAMPLE, TITLE, sample};

/// Pixels to a point at 288 dots per inch.
const SCALE: f64 = 4.0;
/// The resolution with that number of pixels to a point.
const RESOLUTION: f64 = 288.0;

impl Picture {
    fn of(figure: &Drawing) -> Picture {
        Picture::read(&figure.png(RESOLUTION).expect("it can be drawn"))
    }

    /// Red, green and blue at a place in points.
    fn at(&self, x: f64, y: f64) -> [u8; 3] {
        self.pixel((x * SCALE) as usize, (y * SCALE) as usize)
    }
}

const WHITE: [u8; 3] = [255, 255, 255];

#[test]
fn the_sheet_keeps_its_physical_size() {
    let picture = Picture::of(&sample());
    // 60 by 30 millimetres at 288 dots per inch, rounded to pixels; and 288 / 0.0254 dots per
    // metre.
    assert_eq!((picture.width, picture.height, picture.per_metre), (680, 340, 11339));
    let pdf = String::from_utf8_lossy(&sample().pdf(TITLE).expect("a PDF")).into_owned();
    let page = pdf.split_once("/MediaBox [0 0 ").expect("a page").1;
    let size: Vec<f64> =
        page.split_once(']').expect("its box").0.split(' ').map(|n| n.parse().expect("a length")).collect();
    // Points; the writer has 32-bit numbers.
    assert!((size[0] - 60.0 / 25.4 * 72.0).abs() < 1e-4 && (size[1] - 30.0 / 25.4 * 72.0).abs() < 1e-4);
}

#[test]
fn lines_dashes_opacity_and_clipping_are_drawn_where_they_stand() {
    let picture = Picture::of(&sample());
    for x in [12.0, 75.0, 148.0] {
        assert_eq!(picture.at(x, 30.0), [255, 0, 0], "a solid line at {x}");
        assert_eq!(picture.at(x, 32.5), WHITE, "beside it at {x}");
    }
    for dash in 0..7 {
        let x = 15.0 + 20.0 * f64::from(dash);
        assert_eq!(picture.at(x, 40.0), [0, 0, 255], "a dash at {x}");
        assert_eq!(picture.at(x + 10.0, 40.0), WHITE, "a gap at {}", x + 10.0);
    }
    // 0.3 of black on white, to a rounding of the blending.
    assert!(picture.at(35.0, 50.0).iter().all(|c| c.abs_diff(179) <= 1), "{:?}", picture.at(35.0, 50.0));
    assert_eq!(picture.at(40.0, 70.0), [0, 0, 0], "a line within its clip path");
    assert_eq!(picture.at(120.0, 70.0), WHITE, "the same line outside");
}

#[test]
fn labels_have_ink_within_their_boxes_and_scripts_their_rise_and_fall() {
    let (figure, picture) = (sample(), Picture::of(&sample()));
    let texts = figure.texts();
    let words: Vec<&str> = texts.iter().map(|text| text.text.as_str()).collect();
    assert_eq!(words, ["cSN = 12", "𝒜"]);
    let has_ink = |b: &grazing_drawing::Bounds| {
        let steps = |from: f64, to: f64| (0..=40).map(move |i| from + (to - from) * f64::from(i) / 40.0);
        steps(b.left, b.right).any(|x| steps(b.top, b.bottom).any(|y| picture.at(x, y)[0] < 128))
    };
    for glyph in texts.iter().flat_map(|text| &text.glyphs) {
        assert!(has_ink(glyph), "no ink in {glyph:?}");
    }
    let [c, s, _, equals, one, raised] = texts[0].glyphs[..] else { panic!("{:?}", texts[0].glyphs) };
    assert!(s.bottom > c.bottom + 1.0 && raised.bottom < one.bottom - 3.0, "scripts");
    assert!(c.left > 9.5 && s.left >= c.right - 1.0 && equals.left > s.right, "in order from x = 10");
    // The view box is rounded to 0.01 point, a scale of 1 to within 1e-4.
    let size = (texts[0].size, texts[0].smallest);
    assert!((size.0 - 10.0).abs() < 1e-3 && (size.1 - 7.2).abs() < 1e-3, "{size:?}");
    let script = texts[1].bounds().expect("ink");
    assert!((script.right - 160.0).abs() < 1.5, "it ends at its anchor: {script:?}");
}

#[test]
fn shapes_tell_their_stroke_and_what_a_clip_path_leaves_of_them() {
    let shapes = sample().shapes();
    let found: Vec<_> = shapes
        .iter()
        .map(|shape| (shape.stroke.map(f64::round), shape.bounds.right.round(), shape.filled))
        .collect();
    let wanted = [
        (None, 170.0, true),
        (Some(2.0), 150.0, false),
        (Some(2.0), 150.0, false),
        (None, 60.0, true),
        (Some(4.0), 85.0, false),
    ];
    assert_eq!(found, wanted, "in points");
}

#[test]
fn text_stays_text_in_the_pdf_with_the_fonts_embedded() {
    let pdf = String::from_utf8_lossy(&sample().pdf(TITLE).expect("a PDF")).into_owned();
    for font in ["STIXTwoText-Regular", "STIXTwoText-Italic", "STIXTwoMath"] {
        assert!(pdf.contains(&format!("+{font}")), "{font}");
    }
    assert_eq!(pdf.matches("/FontFile2 ").count(), 3);
    // The tables with which a reader turns glyphs back into characters.
    for character in "cSN=12𝒜".chars() {
        let units: String =
            character.encode_utf16(&mut [0; 2]).iter().map(|unit| format!("{unit:04X}")).collect();
        assert!(pdf.contains(&format!("> <{units}>")), "{character} cannot be copied from the PDF");
    }
    assert!(pdf.contains(&format!("/Title ({TITLE})")));
    let greek = String::from_utf8_lossy(&sample().pdf("aω").expect("a PDF")).into_owned();
    assert!(greek.contains("/Title <FEFF006103C9>"));
}

#[test]
fn equal_figures_give_equal_bytes_without_a_date() {
    // Twelve times, because the variations to be excluded come from random hash seeds.
    let first = sample().pdf(TITLE).expect("a PDF");
    for _ in 0..12 {
        assert!(sample().pdf(TITLE).expect("a PDF") == first);
    }
    let text = String::from_utf8_lossy(&first);
    assert!(!text.contains("Date") && !text.contains("/ID"));
    assert!(sample().png(96.0).expect("a PNG") == sample().png(96.0).expect("a PNG"));
}

#[test]
fn the_objects_of_the_pdf_lie_where_its_table_says() {
    let pdf = sample().pdf(TITLE).expect("a PDF");
    let text = String::from_utf8_lossy(&pdf[pdf.len() - 2000..]).into_owned();
    let start: usize = text
        .split_once("startxref\n")
        .expect("an end")
        .1
        .lines()
        .next()
        .expect("a line")
        .parse()
        .expect("a place");
    let table = String::from_utf8_lossy(&pdf[start..]).into_owned();
    let places: Vec<usize> = table
        .lines()
        .filter(|line| line.ends_with(" n"))
        .map(|line| line[..10].parse().expect("a place"))
        .collect();
    assert!(places.len() > 10);
    for (place, number) in places.iter().zip(1..) {
        assert!(pdf[*place..].starts_with(format!("{number} 0 obj\n").as_bytes()), "object {number}");
    }
    assert!(table.contains(&format!("/Size {}", places.len() + 1)));
}

#[test]
fn another_reader_of_pdf_finds_the_text() {
    let reader = Command::new("pdftotext")
        .args(["-layout", "-", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn();
    let Ok(mut reader) = reader else {
        return writeln!(std::io::stderr(), "SKIPPED: there is no pdftotext")
            .expect("a message can be written");
    };
    let mut input = reader.stdin.take().expect("it is piped");
    input.write_all(&sample().pdf(TITLE).expect("a PDF")).expect("pdftotext reads");
    drop(input);
    let output = reader.wait_with_output().expect("pdftotext ends");
    let text = String::from_utf8(output.stdout).expect("text");
    // pdftotext puts sub- and superscripts into the line or into lines of their own.
    for part in ["c", "SN", "=", "1", "2", "𝒜"] {
        assert!(text.contains(part), "`{part}` is missing in {text}");
    }
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let told = |error: Option<FormatError>| error.expect("it cannot be drawn").to_string();
    assert!(told(Drawing::read("old").err()).starts_with("not a drawable SVG"));
    let snow = SAMPLE.replace("𝒜", "雪");
    assert!(told(Drawing::read(&snow).err()).starts_with("label `雪` needs"));
    assert!(told(sample().png(1e-3).err()).starts_with("a picture of 0 by"));
}

#[test]
fn outlines_look_as_text_does() {
    let outlines = Drawing::read(&sample().outlines()).expect("what is written can be read");
    assert!(outlines.texts().is_empty() && !sample().texts().is_empty());
    let [text, paths] = [Picture::of(&sample()), Picture::of(&outlines)];
    assert_eq!((text.width, text.height), (paths.width, paths.height));
    // Coordinates are rounded to thousandths of a point, and with them shades at edges.
    let differ = text.colours.iter().zip(&paths.colours).filter(|(one, other)| one.abs_diff(**other) > 32);
    assert_eq!(differ.count(), 0);
}
