//! Tests of exported figures: what PDF and PNG contain, and where.

mod comparison;
mod figure;
mod pdf;
mod picture;
mod reading;
mod sheet;

use grazing_report::Drawing;

/// An SVG with all features that the figures use; lengths in points.
const SAMPLE: &str = include_str!("sample.svg");
/// A title for the sample.
const TITLE: &str = "A sample & its features";

fn sample() -> Drawing {
    Drawing::read(SAMPLE).expect("the sample can be read")
}
