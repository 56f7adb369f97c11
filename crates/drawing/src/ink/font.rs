//! The embedded fonts: their bytes, the style sheet that contains them, and the size of a label set in
//! them.
//!
//! STIX Two Text (upright and italic) and some signs of STIX Two Math, reduced to ASCII, Greek and
//! mathematical signs. They have no kerning tables, so that viewers set labels at the sizes measured
//! here. SIL Open Font License 1.1, see `fonts/OFL.txt`.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt::Write;

use base64::prelude::{BASE64_STANDARD, Engine};
use ttf_parser::Face;

use crate::error::DrawingError;
use crate::ink::markup::{FontFace, Label, Run};

/// Font files for converters (PDF, PNG) that must not use the system's fonts: name and bytes.
pub const FONT_FILES: [(&str, &[u8]); 3] = [
    ("STIXTwoText-Regular.ttf", include_bytes!("../../fonts/STIXTwoText-Regular.ttf")),
    ("STIXTwoText-Italic.ttf", include_bytes!("../../fonts/STIXTwoText-Italic.ttf")),
    ("STIXTwoMath-Signs.ttf", include_bytes!("../../fonts/STIXTwoMath-Signs.ttf")),
];

/// The font of formulas on pages: the letters and signs that `fonts/README.md` lists, with what MathML needs
/// to set them.
pub const FORMULA_FONT: &[u8] = include_bytes!("../../fonts/STIXTwoMath-Formulas.woff2");

/// Font families for signs, the embedded one first.
pub(crate) const SIGN_FAMILY: &str = "'STIX Two Math','STIX Two Text','STIXGeneral',serif";

/// The shape of a circumflex, in units of the font size, modelled on the font's own accents: its rise
/// above the letter's ink, its height, half its width, and its shift to the right of the letter's middle
/// over italics.
const HAT_RISE: f64 = 0.07;
const HAT_HEIGHT: f64 = 0.13;
const HAT_HALF_WIDTH: f64 = 0.15;
const HAT_SLANT: f64 = 0.07;

/// The extent of a label, in points: its width, and how far its ink reaches above and below the baseline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extent {
    /// The width of the label.
    pub width: f64,
    /// The reach of its ink above the baseline.
    pub ascent: f64,
    /// The reach of its ink below the baseline.
    pub descent: f64,
}

/// The factor by which labels may be wider where embedded fonts are ignored: they are with DejaVu Serif,
/// but not with fonts like Times.
const FALLBACK: f64 = 1.2;

impl Extent {
    /// The width reserved for the label.
    pub(crate) fn room(&self) -> f64 {
        FALLBACK * self.width
    }

    pub(crate) fn height(&self) -> f64 {
        self.ascent + self.descent
    }
}

/// The parsed fonts.
pub struct Fonts {
    faces: [Face<'static>; 3],
    /// Glyphs measured so far; reading a glyph's outline is slow.
    glyphs: RefCell<BTreeMap<(usize, char), Glyph>>,
}

/// The advance of a character and the vertical extent of its ink, if it has any, in units of the font.
#[derive(Clone, Copy)]
struct Glyph {
    advance: u16,
    ink: Option<(i16, i16)>,
}

impl Fonts {
    pub(crate) fn load() -> Result<Self, DrawingError> {
        let parse = |i: usize| {
            let (font, bytes) = FONT_FILES[i];
            Face::parse(bytes, 0).map_err(|reason| DrawingError(format!("embedded font {font}: {reason}")))
        };
        Ok(Fonts { faces: [parse(0)?, parse(1)?, parse(2)?], glyphs: RefCell::default() })
    }

    fn glyph(&self, index: usize, character: char) -> Option<Glyph> {
        if let Some(&known) = self.glyphs.borrow().get(&(index, character)) {
            return Some(known);
        }
        let face = &self.faces[index];
        let id = face.glyph_index(character)?;
        let glyph = Glyph {
            advance: face.glyph_hor_advance(id).unwrap_or(0),
            ink: face.glyph_bounding_box(id).map(|ink| (ink.y_min, ink.y_max)),
        };
        self.glyphs.borrow_mut().insert((index, character), glyph);
        Some(glyph)
    }

    /// Measures a label set at `size` points.
    ///
    /// # Errors
    /// A character is missing from the embedded fonts.
    pub fn measure(&self, label: &Label, size: f64) -> Result<Extent, DrawingError> {
        let mut extent = Extent { width: 0.0, ascent: 0.0, descent: 0.0 };
        for run in &label.runs {
            let index = match run.face {
                FontFace::Upright => 0,
                FontFace::Italic => 1,
                FontFace::Signs => 2,
            };
            let (scale, rise) = run.level.size_and_rise(size);
            let em = scale / f64::from(self.faces[index].units_per_em());
            for character in run.text.chars() {
                let glyph = self.glyph(index, character).ok_or_else(|| lacking(&label.source, character))?;
                extent.width += em * f64::from(glyph.advance);
                if let Some((low, high)) = glyph.ink {
                    extent.ascent = extent.ascent.max(rise + em * f64::from(high));
                    extent.descent = extent.descent.max(-rise - em * f64::from(low));
                    if run.hat {
                        let top = rise + em * f64::from(high) + (HAT_RISE + HAT_HEIGHT) * scale;
                        extent.ascent = extent.ascent.max(top);
                    }
                }
            }
        }
        Ok(extent)
    }
}

fn lacking(label: &str, character: char) -> DrawingError {
    DrawingError(format!(
        "label `{label}` needs the character `{character}`, which the embedded fonts do not have"
    ))
}

/// A circumflex as three spots, relative to the label's start on its baseline, to the right and
/// downwards.
pub(crate) type Hat = [(f64, f64); 3];

impl Fonts {
    /// The circumflexes over a label set at `size` points.
    ///
    /// They are drawn as lines, because the fonts of viewers may lack an accent over an italic letter.
    ///
    /// # Errors
    /// As [`measure`](Self::measure).
    pub(crate) fn hats(&self, label: &Label, size: f64) -> Result<Vec<Hat>, DrawingError> {
        let mut hats = Vec::new();
        for (index, run) in label.runs.iter().enumerate().filter(|(_, run)| run.hat) {
            let part = |runs: &[Run]| Label { source: label.source.clone(), runs: runs.to_vec() };
            let before = self.measure(&part(&label.runs[..index]), size)?.width;
            let letter = self.measure(&part(&label.runs[index..=index]), size)?;
            let (scale, _) = run.level.size_and_rise(size);
            let [height, half, slant] = [HAT_HEIGHT, HAT_HALF_WIDTH, HAT_SLANT].map(|share| share * scale);
            let middle = before + 0.5 * letter.width + slant;
            let (top, foot) = (-letter.ascent, height - letter.ascent);
            hats.push([(middle - half, foot), (middle, top), (middle + half, foot)]);
        }
        Ok(hats)
    }
}

/// The style sheet that embeds the fonts as data.
pub fn style_sheet() -> String {
    let mut sheet = String::new();
    for ((_, bytes), (family, style)) in FONT_FILES.iter().zip([
        ("STIX Two Text", "normal"),
        ("STIX Two Text", "italic"),
        ("STIX Two Math", "normal"),
    ]) {
        // Writing to a String cannot fail.
        let _ = writeln!(
            sheet,
            "@font-face{{font-family:'{family}';font-style:{style};src:url(data:font/ttf;base64,{})format('truetype')}}",
            BASE64_STANDARD.encode(bytes)
        );
    }
    sheet
}

#[cfg(test)]
mod tests {
    use super::*;

    fn width(source: &str, size: f64) -> f64 {
        Fonts::load().unwrap().measure(&Label::parse(source).unwrap(), size).unwrap().width
    }

    #[test]
    fn widths_add_up_and_grow_with_the_size() {
        // There is no kerning table, so widths add; 1e-12 allows for the order of additions.
        assert!((width("VA", 8.0) - width("V", 8.0) - width("A", 8.0)).abs() < 1e-12);
        assert!((width("grazing", 16.0) - 2.0 * width("grazing", 8.0)).abs() < 1e-12);
        // Digits are tabular: columns of tick labels align.
        assert!((width("1111", 8.0) - width("0000", 8.0)).abs() < 1e-12);
    }

    #[test]
    fn subscripts_are_narrower_and_reach_below_the_line() {
        let fonts = Fonts::load().unwrap();
        let measure = |s: &str| fonts.measure(&Label::parse(s).unwrap(), 10.0).unwrap();
        let (plain, lowered) = (measure(r"$x\mathrm{x}$"), measure(r"$x_\mathrm{x}$"));
        assert!(lowered.width < plain.width);
        assert!(lowered.descent > plain.descent + 1.0);
        assert_eq!(lowered.ascent, plain.ascent);
    }

    #[test]
    fn a_hat_stands_over_its_letter_within_the_label() {
        let fonts = Fonts::load().unwrap();
        let parse = |s: &str| Label::parse(s).unwrap();
        let (bare, hatted) = (parse("$(x,0)$"), parse(r"$(\hat{x},0)$"));
        let extent = fonts.measure(&hatted, 10.0).unwrap();
        assert_eq!(extent.width, fonts.measure(&bare, 10.0).unwrap().width);
        let hats = fonts.hats(&hatted, 10.0).unwrap();
        let (left, right) = (fonts.measure(&parse("$($"), 10.0).unwrap().width, extent.width);
        assert_eq!(hats.len(), 1);
        for (x, y) in hats[0] {
            assert!(left < x && x < right && -extent.ascent <= y && y < -4.0, "{x} {y}");
        }
        assert!(fonts.hats(&bare, 10.0).unwrap().is_empty());
    }

    #[test]
    fn a_character_outside_the_fonts_is_an_error_that_names_it() {
        let fonts = Fonts::load().unwrap();
        let error = fonts.measure(&Label::parse("雪").unwrap(), 8.0).unwrap_err();
        assert!(error.to_string().contains('雪'));
    }

    #[test]
    fn every_command_of_the_markup_has_a_glyph() {
        for (name, _) in grazing_results::GREEK {
            assert!(width(&format!(r"$\{name}$"), 8.0) > 1.0, "{name}");
        }
        assert!(width(r"$\le\ge\approx\ast\sqrt\times\pm\cdot\,-='\mathcal{APV}$", 8.0) > 40.0);
    }
}
