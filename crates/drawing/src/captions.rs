//! What stands over a magnified panel: its letter, its resonance, and the coefficients.

use crate::DrawingError;
use crate::canvas::{Anchor, Canvas};
use crate::font::Fonts;
use crate::magnified::panel_letter;
use crate::markup::Label;
use crate::panel_grid::{HEADING_LEADING, SUBHEADING_LEADING};
use crate::sheet::Bounds;
use crate::style::{BLACK, LABEL_SIZE, TICK_SIZE};
use crate::ticks::measured;

/// The resonance about which a panel is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Heading {
    /// Number of loops p.
    pub p: u32,
    /// The integer n of the resonance, if it is to be written.
    pub n: Option<u32>,
    /// The coefficient c_SN, in units of the primary parameter over the square of the secondary one; NaN is left out.
    pub c_sn: f64,
    /// The coefficient c_PD, likewise.
    pub c_pd: f64,
}

/// Significant digits of coefficients.
const DIGITS: usize = 4;

/// What is written over a panel: its letter, p and n on the first line, and the coefficients.
pub(crate) struct Caption {
    first: String,
    coefficients: Vec<String>,
}

impl Caption {
    pub(crate) fn new(panel: u32, heading: Option<Heading>) -> Self {
        let letter = panel_letter(panel);
        let Some(Heading { p, n, c_sn, c_pd }) = heading else {
            return Caption { first: letter, coefficients: Vec::new() };
        };
        let n = n.map_or_else(String::new, |n| format!(", $n={n}$"));
        let known = [("SN", c_sn), ("PD", c_pd)].into_iter().filter(|(_, value)| value.is_finite());
        let written = |(kind, value)| format!(r"$c_{{\mathrm{{{kind},}}{p}}}={}$", measured(value, DIGITS));
        Caption { first: format!("{letter}  $p={p}${n}"), coefficients: known.map(written).collect() }
    }

    /// The coefficients on one line.
    fn joined(&self) -> String {
        self.coefficients.join(",  ")
    }

    /// Whether the coefficients fit on one line of so many points.
    pub(crate) fn fits(&self, fonts: &Fonts, room: f64) -> Result<bool, DrawingError> {
        Ok(fonts.measure(&Label::parse(&self.joined())?, TICK_SIZE)?.width <= room)
    }

    /// The coefficients on one line or, if they are to be split, on a line each.
    fn lines(self, split: bool) -> Vec<String> {
        let joined = self.joined();
        if split {
            self.coefficients
        } else {
            Some(joined).into_iter().filter(|joined| !joined.is_empty()).collect()
        }
    }

    /// Draws it, the baseline of the first line so many points above the panel.
    pub(crate) fn draw(
        self,
        canvas: &Canvas,
        bounds: &Bounds,
        rise: f64,
        split: bool,
    ) -> Result<(), DrawingError> {
        let mut baseline = bounds.top - rise;
        canvas.text((bounds.left, baseline), &self.first, LABEL_SIZE, Anchor::Start, BLACK)?;
        baseline += HEADING_LEADING;
        for line in self.lines(split) {
            canvas.text((bounds.left, baseline), &line, TICK_SIZE, Anchor::Start, BLACK)?;
            baseline += SUBHEADING_LEADING;
        }
        Ok(())
    }
}
