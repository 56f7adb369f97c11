//! Two versions of a figure side by side.

use grazing_report::{Drawing, comparison};

use crate::picture::Picture;

/// A figure of a width in points that contains a rectangle. Twelve points are 25 pixels of a comparison.
fn figure(width: u32, rectangle: &str) -> Drawing {
    let svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"12\">{rectangle}</svg>"
    );
    Drawing::read(&svg).expect("an SVG")
}

/// Space around each picture, in pixels.
const MARGIN: usize = 40;

#[test]
fn what_is_gone_is_red_and_what_is_new_is_blue() {
    let before = figure(48, "<rect width=\"24\" height=\"12\"/>");
    let after = figure(48, "<rect x=\"12\" width=\"24\" height=\"12\"/>");
    let picture = Picture::read(&comparison(&before, &after).expect("a picture"));
    assert_eq!((picture.width, picture.height), (4 * 40 + 3 * 100, 2 * 40 + 25));
    let row =
        |left: usize| -> Vec<[u8; 3]> { (0..100).map(|x| picture.pixel(left + x, MARGIN + 12)).collect() };
    let [old, new, difference] = [0, 1, 2].map(|place| row(MARGIN + place * (100 + MARGIN)));
    let (black, white, red, blue) = ([0; 3], [255; 3], [214, 47, 32], [25, 70, 190]);
    assert!(old[..50].iter().all(|colour| *colour == black) && old[50..].iter().all(|it| *it == white));
    assert!(new[25..75].iter().all(|colour| *colour == black) && new[75..].iter().all(|it| *it == white));
    assert!(difference[..25].iter().all(|colour| *colour == red), "{difference:?}");
    assert!(difference[50..75].iter().all(|colour| *colour == blue), "{difference:?}");
    assert!(difference[25..50].iter().chain(&difference[75..]).all(|[r, g, b]| r == g && g == b));
}

#[test]
fn figures_of_different_sizes_can_be_compared() {
    let small = figure(12, "<rect width=\"4\" height=\"12\"/>");
    let large = Drawing::read("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"30\" height=\"5\"/>");
    let picture = comparison(&small, &large.expect("an SVG")).expect("a picture");
    assert_eq!(picture[..8], *b"\x89PNG\r\n\x1a\n");
}
