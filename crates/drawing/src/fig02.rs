//! Figure 2: the one-parameter bifurcation diagram, a magnification of it, and phase portraits above.

use polars::prelude::DataFrame;

use crate::DrawingError;
use crate::axes::Panel;
use crate::canvas::{Bounds, Canvas, Ink, Spot};
use crate::clip::Window;
use crate::cloud::draw_cloud;
use crate::fig07::panel_letter;
use crate::frames::{Table, runs};
use crate::kinds::Kind;
use crate::labels::{Labels, Wanted};
use crate::placement::length;
use crate::portraits::{Portrait, draw_portraits, read_portraits};
use crate::style::{
    BLACK, GUIDE, LABEL_SIZE, MAGNIFIER, MAGNIFIER_FRAME, POINT_RADIUS, POINT_RIM, Paint, SMALL_LABEL_SIZE,
    STABLE_WIDTH, THRESHOLD, UNSTABLE_WIDTH, WIDE_MM, branch_pen,
};
use crate::svg_backend::Anchor;

/// What Figure 2 shows.
///
/// Paper: Figure 2, fig:Z.
#[derive(Debug, Clone, Copy)]
pub struct Figure02<'a> {
    /// Columns p (0: non-impacting), branch, amplitude, x, stable, admissible. Rows that follow each other with equal
    /// p and branch are one curve; inadmissible rows are not drawn.
    pub branches: &'a DataFrame,
    /// Columns kind (graz, SN, PD, GZ), p, amplitude, x: one row for each loop.
    pub bifurcations: &'a DataFrame,
    /// Columns amplitude, x: points of forward orbits.
    pub attractor: &'a DataFrame,
    /// Columns portrait (1, 2, …), p, amplitude, kind (periodic, attractor), x, y: orbits in order of time; a row that is
    /// not a number breaks the line.
    pub portraits: &'a DataFrame,
    /// Amplitudes (horizontal) and values of x (vertical) of the whole diagram.
    pub window: Window,
    /// The same of the magnification.
    pub magnification: Window,
}

struct Branch {
    p: i64,
    points: Vec<(f64, f64)>,
    stable: Vec<bool>,
}

struct Bifurcation {
    kind: Kind,
    p: i64,
    point: (f64, f64),
}

const HEIGHT_MM: f64 = 128.0;

/// Draws Figure 2.
///
/// # Errors
/// [`DrawingError`] if a column is missing or of the wrong type, a kind is unknown, a window is empty, or there is no
/// portrait or more than six.
pub fn draw_fig02(figure: &Figure02<'_>) -> Result<String, DrawingError> {
    compose(figure)?.finish(
        "fig02",
        "One-parameter bifurcation diagram with phase portraits",
        "Below: forcing amplitude across, x-value of the return map up; thick curves are stable, thin ones unstable; \
         dots are long-term forward orbits. Right: magnification. Above: phase portraits with the wall.",
    )
}

pub(crate) fn compose(figure: &Figure02<'_>) -> Result<Canvas, DrawingError> {
    let window = figure.window.checked("fig02")?;
    let magnification = figure.magnification.checked("the magnification of fig02")?;
    let branches = read_branches(Table::new("fig02_branches", figure.branches))?;
    let bifurcations = read_bifurcations(Table::new("fig02_bifurcations", figure.bifurcations))?;
    let attractor = Table::new("fig02_attractor", figure.attractor);
    let amplitudes = attractor.numbers("amplitude")?;
    let cloud: Vec<(f64, f64)> = amplitudes.into_iter().zip(attractor.numbers("x")?).collect();
    let portraits = read_portraits(Table::new("fig02_portraits", figure.portraits))?;

    let canvas = Canvas::new(WIDE_MM, HEIGHT_MM)?;
    draw_portraits(&canvas, &portraits)?;
    let (top, bottom) = (158.0, canvas.height - 31.0);
    let split = 0.59 * canvas.width;
    let whole = Panel::new(
        &canvas,
        window,
        Bounds {
            left: 38.0,
            top,
            right: split,
            bottom,
        },
    );
    let part = Panel::new(
        &canvas,
        magnification,
        Bounds {
            left: split + 44.0,
            top,
            right: canvas.width - 6.0,
            bottom,
        },
    );
    letters(&whole, &portraits)?;
    magnifier(&whole, &part)?;
    for (panel, every_loop) in [(&whole, false), (&part, true)] {
        diagram(
            panel,
            &branches,
            &bifurcations,
            &cloud,
            every_loop,
            &magnification,
        )?;
        panel.axes(r"$\mathcal{A}$", if every_loop { "" } else { "$x$" })?;
    }
    Ok(canvas)
}

/// Branches, attractor and bifurcations of one panel, with their labels.
fn diagram(
    panel: &Panel<'_>,
    branches: &[Branch],
    bifurcations: &[Bifurcation],
    cloud: &[(f64, f64)],
    every_loop: bool,
    magnification: &Window,
) -> Result<(), DrawingError> {
    let mut labels = Labels::new(panel.canvas, panel.bounds);
    if !every_loop {
        let (a, b) = (
            panel.spot((magnification.x[0], magnification.y[1])),
            panel.spot((magnification.x[1], magnification.y[0])),
        );
        labels.placer.keep_off(&[a, (b.0, a.1), b, (a.0, b.1), a]);
    }
    panel.line(&[(panel.window.x[0], 0.0), (panel.window.x[1], 0.0)], THRESHOLD)?;
    draw_cloud(panel, cloud)?;
    labels.placer.avoid(
        cloud
            .iter()
            .filter(|&&p| panel.window.contains(p))
            .map(|&p| panel.spot(p)),
    );
    let mut longest: Vec<(i64, Vec<Spot>)> = Vec::new();
    for branch in branches {
        for piece in branch_pieces(panel, branch)? {
            labels.placer.keep_off(&piece);
            match longest.iter_mut().find(|(p, _)| *p == branch.p) {
                Some((_, best)) if length(best) >= length(&piece) => {}
                Some((_, best)) => *best = piece,
                None => longest.push((branch.p, piece)),
            }
        }
    }
    let mut named: Vec<(Kind, i64)> = Vec::new();
    let visible: Vec<&Bifurcation> = bifurcations
        .iter()
        .filter(|b| panel.window.contains(b.point))
        .collect();
    for bifurcation in &visible {
        let spot = panel.spot(bifurcation.point);
        let paint = Paint {
            colour: bifurcation.kind.pen().colour,
            opacity: 1.0,
        };
        panel
            .canvas
            .draw(&[spot], Ink::Disc(POINT_RADIUS, paint, Some(POINT_RIM)))?;
        labels
            .placer
            .block(Bounds::about(spot, 2.0 * POINT_RADIUS, 2.0 * POINT_RADIUS));
    }
    for bifurcation in &visible {
        let name = (bifurcation.kind, bifurcation.p);
        if !every_loop && named.contains(&name) {
            continue;
        }
        named.push(name);
        let (kind, spot) = (bifurcation.kind, panel.spot(bifurcation.point));
        labels.add(
            kind.label(),
            LABEL_SIZE,
            kind.text_colour(),
            &Wanted::Around(spot, POINT_RADIUS + 0.5),
        )?;
    }
    for (p, piece) in &longest {
        let text = if *p == 0 {
            "non-impacting".to_owned()
        } else {
            format!("$p={p}$")
        };
        labels.add(
            &text,
            SMALL_LABEL_SIZE,
            branch_pen(*p, 1.0).colour,
            &Wanted::Beside(piece),
        )?;
    }
    labels.draw()
}

/// Draws a branch, thick where stable and thin where unstable, without gaps between; returns what was drawn.
fn branch_pieces(panel: &Panel<'_>, branch: &Branch) -> Result<Vec<Vec<Spot>>, DrawingError> {
    let mut pieces = Vec::new();
    for rows in runs(&branch.stable) {
        let width = if branch.stable[rows.start] {
            STABLE_WIDTH
        } else {
            UNSTABLE_WIDTH
        };
        let end = (rows.end + 1).min(branch.points.len());
        pieces.extend(panel.line(&branch.points[rows.start..end], branch_pen(branch.p, width))?);
    }
    Ok(pieces)
}

/// The portraits' letters above the diagram, each over a guide at its amplitude.
fn letters(panel: &Panel<'_>, portraits: &[Portrait]) -> Result<(), DrawingError> {
    let mut marks: Vec<(f64, String)> = Vec::new();
    for portrait in portraits {
        let (x, _) = panel.spot((portrait.amplitude, panel.window.y[0]));
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
    for (x, text) in &marks {
        let label = crate::markup::Label::plain(text);
        let half = 0.5 * panel.canvas.measure(&label, SMALL_LABEL_SIZE)?.width;
        let middle = x.max(free_from + half);
        free_from = middle + half + 2.0;
        let (top, bottom) = (panel.bounds.top, panel.bounds.bottom);
        panel
            .canvas
            .draw(&[(*x, bottom), (*x, top), (middle, top - 4.0)], Ink::Line(GUIDE))?;
        panel
            .canvas
            .text((middle, top - 6.0), text, SMALL_LABEL_SIZE, Anchor::Middle, BLACK)?;
    }
    Ok(())
}

/// The magnified window in the whole diagram, and the magnification in a frame of the same colour.
fn magnifier(whole: &Panel<'_>, part: &Panel<'_>) -> Result<(), DrawingError> {
    let [[left, right], [low, high]] = [part.window.x, part.window.y];
    let outline = [
        (left, low),
        (right, low),
        (right, high),
        (left, high),
        (left, low),
    ];
    whole.line(&outline, MAGNIFIER)?;
    part.line(&outline, MAGNIFIER_FRAME)?;
    Ok(())
}

fn read_branches(table: Table<'_>) -> Result<Vec<Branch>, DrawingError> {
    let (p, branch) = (table.integers("p")?, table.integers("branch")?);
    let (amplitude, x) = (table.numbers("amplitude")?, table.numbers("x")?);
    let (stable, admissible) = (table.flags("stable")?, table.flags("admissible")?);
    let keys: Vec<_> = p.iter().zip(&branch).collect();
    Ok(runs(&keys)
        .into_iter()
        .map(|rows| Branch {
            p: p[rows.start],
            stable: stable[rows.clone()].to_vec(),
            points: rows
                .map(|i| {
                    if admissible[i] {
                        (amplitude[i], x[i])
                    } else {
                        (f64::NAN, f64::NAN)
                    }
                })
                .collect(),
        })
        .collect())
}

fn read_bifurcations(table: Table<'_>) -> Result<Vec<Bifurcation>, DrawingError> {
    let kinds = table.words("kind", Kind::KNOWN, Kind::parse)?;
    let p = table.integers("p")?;
    let (amplitude, x) = (table.numbers("amplitude")?, table.numbers("x")?);
    let rows = kinds.into_iter().enumerate();
    Ok(rows
        .map(|(i, kind)| Bifurcation {
            kind,
            p: p[i],
            point: (amplitude[i], x[i]),
        })
        .collect())
}
