//! What stands over a magnified panel: its letter, its resonance, and the coefficients.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_results::plane::MagnifiedPanel;

use crate::DrawingError;
use crate::canvas::{Anchor, Canvas};
use crate::font::Fonts;
use crate::magnified::panel_letter;
use crate::markup::Label;
use crate::panel_grid::{HEADING_LEADING, SUBHEADING_LEADING};
use crate::sheet::Bounds;
use crate::style::{BLACK, LABEL_SIZE, TICK_SIZE};
use crate::ticks::measured;

/// Significant digits of coefficients.
const DIGITS: usize = 4;

/// What is written over a panel: its letter, p and n on the first line, and the coefficients.
pub(crate) struct Caption {
    first: String,
    coefficients: Vec<String>,
}

impl Caption {
    pub(crate) fn new(panel: &MagnifiedPanel) -> Self {
        let MagnifiedPanel { panel, loops, n, coefficients, .. } = panel;
        let n = n.map_or_else(String::new, |n| format!(", $n={n}$"));
        let known = coefficients.named().into_iter().filter(|(_, value)| value.is_finite());
        let written = |(kind, value): (Bifurcation, f64)| {
            format!(r"$c_{{\mathrm{{{},}}{loops}}}={}$", kind.name(), measured(value, DIGITS))
        };
        let first = format!("{}  $p={loops}${n}", panel_letter(*panel));
        Caption { first, coefficients: known.map(written).collect() }
    }

    /// The coefficients on one line.
    fn joined(&self) -> String {
        self.coefficients.join(",  ")
    }

    /// Whether the coefficients fit on one line of so many points.
    pub(crate) fn fits(&self, fonts: &Fonts, room: f64) -> Result<bool, DrawingError> {
        Ok(fonts.measure(&Label::parse(&self.joined())?, TICK_SIZE)?.width <= room)
    }

    /// Draws it, the baseline of the first line so many points above the panel, each coefficient on a line of its own if they are split.
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
        let lines = if split { self.coefficients } else { vec![self.joined()] };
        for line in lines {
            canvas.text((bounds.left, baseline), &line, TICK_SIZE, Anchor::Start, BLACK)?;
            baseline += SUBHEADING_LEADING;
        }
        Ok(())
    }
}
