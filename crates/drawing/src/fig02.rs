//! Figure 2: the one-parameter bifurcation diagram, a magnification of it, and phase portraits above.

use grazing_results::branches::Figure2;

use crate::DrawingError;
use crate::axes::Panel;
use crate::branches::{Strand, diagram};
use crate::canvas::{Anchor, Canvas};
use crate::clip::checked;
use crate::labels::Labels;
use crate::magnified::panel_letter;
use crate::markup::Label;
use crate::portraits::{Portrait, ROW, SINGLE_ROW, draw_portraits};
use crate::sheet::{Bounds, Spot};
use crate::style::{BLACK, GUIDE, MAGNIFIER, MAGNIFIER_FRAME, SMALL_LABEL_SIZE, SheetWidth};
use crate::svg::POINTS_PER_MM;

/// Width in the paper.
const WIDTH_MM: f64 = 156.0;
/// Sheets at least this wide have all portraits in a row, and the magnification beside the diagram.
const SIDE_BY_SIDE_MM: f64 = 120.0;
/// Height of the diagram and of its magnification with their numbers and titles, in points.
const DIAGRAM_HEIGHT: f64 = 222.83;
const STACKED_HEIGHT: f64 = 162.0;
/// Room for the portraits' letters above the diagram, and above the magnification, in points.
const LETTERS: f64 = 18.0;
const STACKED_GAP: f64 = 8.0;
/// Room below a diagram for numbers and axis title, in points.
const BELOW: f64 = 31.0;
/// The tables of the diagram.
const SHOWN: [&str; 3] = ["fig02_bifurcations", "fig02_branches", "fig02_attractor"];

/// Draws Figure 2. Paper: fig:Z.
///
/// # Errors
/// [`DrawingError`] if a frame is empty, or there is no portrait or more than six.
pub fn draw_fig02(figure: &Figure2, width: SheetWidth) -> Result<String, DrawingError> {
    compose(figure, width)?.finish(
        "fig02",
        "One-parameter bifurcation diagram with phase portraits",
        "Below: forcing amplitude across, x-value of the return map up; thick curves are stable, thin ones unstable; \
         dots are long-term forward orbits. Framed: magnification. Above: phase portraits with the wall.",
    )
}

pub(crate) fn compose(figure: &Figure2, width: SheetWidth) -> Result<Canvas, DrawingError> {
    let frame = checked(figure.frame, "fig02")?;
    let magnification = checked(figure.magnified, "the magnification of fig02")?;
    let branches = Strand::all(&figure.branches);
    let cloud: Vec<(f64, f64)> = figure.attractor.iter().map(|point| (point.primary, point.x)).collect();
    let portraits = Portrait::all(&figure.portraits)?;

    let width = width.mm(WIDTH_MM);
    let stacked = width < SIDE_BY_SIDE_MM;
    // On a narrow sheet portraits stand in rows of two.
    let rows = if stacked { portraits.len().div_ceil(2) } else { 1 };
    let row = if rows == 1 { SINGLE_ROW } else { ROW };
    let portraits_end = rows as f64 * row;
    let height = portraits_end + if stacked { 2.0 * STACKED_HEIGHT + STACKED_GAP } else { DIAGRAM_HEIGHT };
    let canvas = Canvas::new(width, height / POINTS_PER_MM)?;
    draw_portraits(&canvas, &portraits, (rows, row))?;
    let (top, right) = (portraits_end + LETTERS, canvas.width - 6.0);
    let (whole, part) = if stacked {
        let middle = portraits_end + STACKED_HEIGHT;
        let below = Bounds { left: 38.0, top: middle + STACKED_GAP, right, bottom: canvas.height - BELOW };
        (Bounds { left: 38.0, top, right, bottom: middle - BELOW }, below)
    } else {
        let (split, bottom) = (0.59 * canvas.width, canvas.height - BELOW);
        (Bounds { left: 38.0, top, right: split, bottom }, Bounds { left: split + 44.0, top, right, bottom })
    };
    let whole = Panel { tables: &SHOWN, ..Panel::new(&canvas, frame, whole) };
    let part = Panel { tables: &SHOWN, ..Panel::new(&canvas, magnification, part) };

    let guides = letters(&whole, &portraits)?;
    let magnified = magnification.outline();
    whole.line(&magnified, MAGNIFIER);
    part.line(&magnified, MAGNIFIER_FRAME);
    for (panel, every_loop) in [(&whole, false), (&part, true)] {
        let mut labels = Labels::new(&canvas, panel.bounds);
        if !every_loop {
            guides.iter().for_each(|guide| labels.placer.keep_off_nameless(guide));
            labels.placer.keep_off_nameless(&magnified.map(|corner| panel.spot(corner)));
        }
        diagram(panel, labels, &branches, &figure.bifurcations, &cloud, every_loop)?;
        panel.axes(r"$\mathcal{A}$", if every_loop && !stacked { "" } else { "$x$" })?;
    }
    Ok(canvas)
}

/// The portraits' letters above the diagram, each over a guide at its amplitude; returns the guides.
fn letters(panel: &Panel<'_>, portraits: &[Portrait]) -> Result<Vec<Vec<Spot>>, DrawingError> {
    let mut marks: Vec<(f64, String)> = Vec::new();
    for portrait in portraits {
        let (x, _) = panel.spot((portrait.amplitude, panel.frame.y[0]));
        if x < panel.bounds.left || x > panel.bounds.right {
            continue;
        }
        match marks.iter_mut().find(|mark| mark.0 == x) {
            Some((_, text)) => text.push_str(&panel_letter(portrait.number)),
            None => marks.push((x, panel_letter(portrait.number))),
        }
    }
    marks.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut free_from = f64::NEG_INFINITY;
    let mut guides = Vec::new();
    for (x, text) in &marks {
        let label = Label::plain(text);
        let half = 0.5 * panel.canvas.fonts.measure(&label, SMALL_LABEL_SIZE)?.width;
        let middle = x.max(free_from + half);
        free_from = middle + half + 2.0;
        let (top, bottom) = (panel.bounds.top, panel.bounds.bottom);
        let guide = vec![(*x, bottom), (*x, top), (middle, top - 4.0)];
        panel.canvas.line(&guide, GUIDE);
        guides.push(guide);
        panel.canvas.text((middle, top - 6.0), text, SMALL_LABEL_SIZE, Anchor::Middle, BLACK)?;
    }
    Ok(guides)
}

#[cfg(test)]
mod tests {
    use grazing_results::Frame;
    use grazing_results::branches::{PortraitKind, PortraitPoint};

    use super::*;

    #[test]
    fn diagram_and_magnification_stand_one_above_the_other_in_one_column() {
        let (kind, time) = (PortraitKind::Periodic, f64::NAN);
        let point = |x, y| PortraitPoint { portrait: 1, loops: 0, primary: 0.8, kind, time, x, y };
        let figure = Figure2 {
            branches: Vec::new(),
            bifurcations: Vec::new(),
            attractor: Vec::new(),
            portraits: vec![point(-1.0, 0.5), point(-0.5, -0.5)],
            frame: Frame { x: [0.7, 1.6], y: [-0.6, 1.0] },
            magnified: Frame { x: [0.9, 1.3], y: [-0.3, 0.4] },
            notes: Vec::new(),
        };
        let size = |width| compose(&figure, width).map(|sheet| (sheet.width, sheet.height)).unwrap();
        let (one, paper) = (size(SheetWidth::OneColumn), size(SheetWidth::Paper));
        assert!(one.1 > 1.5 * one.0 && paper.0 > paper.1, "{one:?} {paper:?}");
    }
}
