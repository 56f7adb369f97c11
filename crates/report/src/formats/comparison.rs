//! Two versions of a figure side by side, and what differs.

use resvg::tiny_skia::{Color, Pixmap, PixmapPaint, PremultipliedColorU8, Transform};

use super::error::FormatError;
use super::figure::Drawing;
use super::raster::{blank, encode};

/// A resolution at which the labels can be read.
const COMPARISON_DPI: f64 = 150.0;
/// Space around each picture and height of its heading, in pixels.
const MARGIN: u32 = 40;

/// A PNG of both versions and of their difference: before, after, and after in grey with each pixel
/// that differs in red where ink is gone or paler and in blue where it is new or darker.
///
/// # Errors
/// One of the pictures cannot be drawn.
pub fn comparison(before: &Drawing, after: &Drawing) -> Result<Vec<u8>, FormatError> {
    let (before, after) = (before.pixels(COMPARISON_DPI)?, after.pixels(COMPARISON_DPI)?);
    let difference = difference(&before, &after)?;
    let pictures = [("before", before), ("after", after), ("difference", difference)];
    let width = pictures.iter().map(|(_, picture)| picture.width() + MARGIN).sum::<u32>() + MARGIN;
    let height = pictures.iter().map(|(_, picture)| picture.height()).max().unwrap_or(0) + 2 * MARGIN;
    let mut sheet = blank(width, height)?;
    sheet.fill(Color::from_rgba8(225, 225, 225, 255));
    let mut left = MARGIN;
    for (heading, picture) in &pictures {
        draw(&mut sheet, &heading_picture(heading)?, left, 4);
        draw(&mut sheet, picture, left, MARGIN);
        left += picture.width() + MARGIN;
    }
    encode(&sheet, COMPARISON_DPI)
}

fn draw(sheet: &mut Pixmap, picture: &Pixmap, left: u32, top: u32) {
    let (left, top) = (i32::try_from(left).unwrap_or(0), i32::try_from(top).unwrap_or(0));
    let (paint, transform) = (PixmapPaint::default(), Transform::identity());
    sheet.draw_pixmap(left, top, picture.as_ref(), &paint, transform, None);
}

/// The picture of a word in the figures' font.
fn heading_picture(word: &str) -> Result<Pixmap, FormatError> {
    let svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"80\" height=\"16\"><rect width=\"80\" height=\"16\" \
         fill=\"#e1e1e1\"/><text x=\"0\" y=\"12\" font-family=\"STIX Two Text\" font-size=\"12\">{word}</text></svg>"
    );
    Drawing::read(&svg)?.pixels(COMPARISON_DPI)
}

/// The difference of two pictures; outside of either one the sheet counts as white.
fn difference(before: &Pixmap, after: &Pixmap) -> Result<Pixmap, FormatError> {
    let (width, height) = (before.width().max(after.width()), before.height().max(after.height()));
    let mut difference = blank(width, height)?;
    let white = PremultipliedColorU8::from_rgba(255, 255, 255, 255);
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    for (pixel, (x, y)) in difference.pixels_mut().iter_mut().zip(places) {
        let [old, new] = [before, after].map(|picture| picture.pixel(x, y).or(white));
        let colour = match (old, new) {
            (Some(old), Some(new)) if old == new => {
                // Pale enough to make a change stand out.
                let grey = 200 + lightness(new) / 14;
                [grey, grey, grey]
            }
            (Some(old), Some(new)) if lightness(old) < lightness(new) => [214, 47, 32],
            _ => [25, 70, 190],
        };
        let [red, green, blue] = colour.map(|channel| u8::try_from(channel).unwrap_or(255));
        *pixel = PremultipliedColorU8::from_rgba(red, green, blue, 255).unwrap_or(*pixel);
    }
    Ok(difference)
}

fn lightness(pixel: PremultipliedColorU8) -> u32 {
    (u32::from(pixel.red()) + u32::from(pixel.green()) + u32::from(pixel.blue())) / 3
}
