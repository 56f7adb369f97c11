//! Figure 2: the one-parameter bifurcation diagram, a magnification of it, and phase portraits above.

use grazing_results::Names;
use grazing_results::branches::Figure2;

use crate::DrawingError;
use crate::axes::Panel;
use crate::branches::diagram;
use crate::canvas::Canvas;
use crate::clip::checked;
use crate::labels::Labels;
use crate::portraits::{Caption, draw_portraits, letters, portraits, row_height};
use crate::sheet::Bounds;
use crate::style::{MAGNIFIER, MAGNIFIER_FRAME, SheetWidth};
use crate::svg::POINTS_PER_MM;

/// Width in the paper.
const WIDTH_MM: f64 = 156.0;
/// Sheets at least this wide have all portraits in a row, and the magnification beside the diagram.
const SIDE_BY_SIDE_MM: f64 = 120.0;
/// Height of the diagram and of its magnification with their numbers and titles, in points.
const DIAGRAM_HEIGHT: f64 = 222.83;
const STACKED_HEIGHT: f64 = 121.0;
/// Room for the portraits' letters above the diagram, and above the magnification, in points.
const LETTERS: f64 = 18.0;
const STACKED_GAP: f64 = 8.0;
/// Room below a diagram for numbers and axis title, in points.
const BELOW: f64 = 31.0;
const MOST: usize = 6;
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
    let portraits = portraits(&figure.portraits);
    if portraits.is_empty() || portraits.len() > MOST {
        let found = portraits.len();
        return Err(DrawingError(format!("fig02 has one to six phase portraits, but {found} were given")));
    }

    let width = width.mm(WIDTH_MM);
    let stacked = width < SIDE_BY_SIDE_MM;
    // On a narrow sheet portraits stand in rows of two.
    let rows = if stacked { portraits.len().div_ceil(2) } else { 1 };
    let portraits_end = rows as f64 * row_height(rows);
    let height = portraits_end + if stacked { 2.0 * STACKED_HEIGHT + STACKED_GAP } else { DIAGRAM_HEIGHT };
    let canvas = Canvas::new(width, height / POINTS_PER_MM)?;
    let caption = Caption { across: r"$\mathcal{A}$", titles: ["$x$", "$y$"], table: &["fig02_portraits"] };
    draw_portraits(&canvas, &portraits, &caption, rows)?;
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
    let (magnified, names) = (magnification.outline(), Names::of_the_paper());
    whole.line(&magnified, MAGNIFIER);
    // Around the panel, so that half of it lies outside.
    canvas.line(&magnified.map(|corner| part.spot(corner)), MAGNIFIER_FRAME);
    for (panel, every_loop) in [(&whole, false), (&part, true)] {
        let mut labels = Labels::new(&canvas, panel.bounds);
        if !every_loop {
            guides.iter().for_each(|guide| labels.placer.keep_off_nameless(guide));
            labels.placer.keep_off_nameless(&magnified.map(|corner| panel.spot(corner)));
        }
        let (branches, bifurcations) = (&figure.branches, &figure.bifurcations);
        diagram(panel, labels, branches, bifurcations, &figure.attractor, &names, every_loop)?;
        panel.axes(caption.across, if every_loop && !stacked { "" } else { "$x$" })?;
    }
    Ok(canvas)
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
