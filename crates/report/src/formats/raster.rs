//! PNG: the figure in pixels, on white.

use resvg::tiny_skia::{Color, Pixmap, Transform};

use super::error::FormatError;
use super::figure::Drawing;

/// Points in an inch.
const POINTS_PER_INCH: f64 = 72.0;
/// Metres in an inch.
const METRES_PER_INCH: f64 = 0.0254;

impl Drawing {
    /// The figure as a PNG with `resolution` dots per inch, which the PNG records, so that it keeps its size.
    ///
    /// # Errors
    /// There would be no pixel, or more than memory holds, or the PNG could not be written.
    pub fn png(&self, resolution: f64) -> Result<Vec<u8>, FormatError> {
        encode(&self.pixels(resolution)?, resolution)
    }

    /// The most megabytes that making such a PNG takes: a pixel has four bytes on the canvas, three as it is
    /// encoded, and at most three in the file.
    pub fn png_megabytes(&self, resolution: f64) -> f64 {
        let (width, height) = self.size();
        let scale = resolution / POINTS_PER_INCH;
        1e-5 * scale * scale * width * height
    }

    /// The figure in pixels.
    pub(crate) fn pixels(&self, resolution: f64) -> Result<Pixmap, FormatError> {
        let scale = resolution / POINTS_PER_INCH;
        let (width, height) = self.size();
        let (width, height) = ((scale * width).round() as u32, (scale * height).round() as u32);
        let mut pixels = blank(width, height)?;
        pixels.fill(Color::WHITE);
        resvg::render(&self.tree, Transform::from_scale(scale as f32, scale as f32), &mut pixels.as_mut());
        Ok(pixels)
    }
}

/// A picture of this many pixels, all transparent.
pub(crate) fn blank(width: u32, height: u32) -> Result<Pixmap, FormatError> {
    let error = || FormatError(format!("a picture of {width} by {height} pixels cannot be drawn"));
    Pixmap::new(width, height).ok_or_else(error)
}

/// Pixels as PNG, without transparency: the sheet is white.
pub(crate) fn encode(pixels: &Pixmap, resolution: f64) -> Result<Vec<u8>, FormatError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, pixels.width(), pixels.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let per_metre = (resolution / METRES_PER_INCH).round() as u32;
    let unit = png::Unit::Meter;
    encoder.set_pixel_dims(Some(png::PixelDimensions { xppu: per_metre, yppu: per_metre, unit }));
    let colours: Vec<u8> =
        pixels.pixels().iter().flat_map(|pixel| [pixel.red(), pixel.green(), pixel.blue()]).collect();
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&colours)?;
    writer.finish()?;
    Ok(bytes)
}
