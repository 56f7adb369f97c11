//! Drawing of the solutions of more loops at one-loop resonances.

use grazing_drawing::geometry::sheet::Bounds;
use grazing_drawing::ink::canvas::{Anchor, Canvas};
use grazing_drawing::ink::labels::{Labels, Site};
use grazing_drawing::ink::legend;
use grazing_drawing::ink::markers::Marker;
use grazing_drawing::ink::style::{BLACK, LABEL_SIZE, Paint, THRESHOLD, branch_pen};
use grazing_drawing::plot::axes::Panel;
use grazing_reproduction::prelude::*;
use grazing_results::Frame;

use super::MoreLoops;

const WIDTH_MM: f64 = 165.0;
const HEIGHT_MM: f64 = 82.0;
/// The frames of the panels: σ on the horizontal axis, powers of ten on the vertical one.
const WIDTHS: Frame = Frame { x: [-1.0, 1.0], y: [-4.0, 4.0] };
const PLACES: Frame = Frame { x: [0.0, 0.7], y: [-6.0, 2.0] };

/// The greatest k that is labelled beside its width.
const NAMED: u32 = 3;

/// Draws the figure.
pub(super) fn draw(figure: &MoreLoops, width: SheetWidth) -> Result<Sheet, DrawingError> {
    let canvas = Canvas::new(width.mm(WIDTH_MM), HEIGHT_MM)?;
    let middle = 0.5 * canvas.width;
    let bounds = |left: f64, right: f64| Bounds { left, top: 22.0, right, bottom: canvas.height - 30.0 };
    let mut widths = Panel::new(&canvas, WIDTHS, bounds(37.0, middle - 8.0))?;
    let mut places = Panel::new(&canvas, PLACES, bounds(middle + 37.0, canvas.width - 8.0))?;
    for (panel, up) in [(&mut widths, "log10_m_width"), (&mut places, "log10_m_slowest")] {
        panel.tables = &["beyond_loops"];
        panel.columns = Some(["sigma", up].map(str::to_owned));
    }
    let mut labels = [Labels::new(&canvas, widths.bounds), Labels::new(&canvas, places.bounds)];

    let (mut lines, mut areas) = (Vec::new(), Vec::new());
    let zero = widths.curve(&[(0.0, WIDTHS.y[0]), (0.0, WIDTHS.y[1])], THRESHOLD);
    for line in widths.draw_series(zero)?.pieces {
        labels[0].placer.keep_off_nameless(&line);
    }
    for rows in figure.intervals.chunk_by(|a, b| a.loops == b.loops && (a.sigma < 0.0) == (b.sigma < 0.0)) {
        let (loops, pen) = (rows[0].loops, branch_pen(rows[0].loops, 1.1));
        let name = format!("${loops}$");
        let width: Vec<(f64, f64)> = rows.iter().map(|row| (row.sigma, row.log_width)).collect();
        for line in widths.draw_series(widths.curve(&width, pen))?.pieces {
            labels[0].placer.keep_off(&line);
            // The other curves are below each other, too close for labels.
            if loops <= NAMED {
                lines.push((line, name.clone(), pen.colour));
            }
        }
        if rows[0].sigma > 0.0 {
            let up = |value: f64| libm::log10(value);
            let from: Vec<_> = rows.iter().map(|row| (row.sigma, row.log_from)).collect();
            let to: Vec<_> = rows.iter().map(|row| (row.sigma, up(row.to))).collect();
            let outline: Vec<_> = from.iter().chain(to.iter().rev()).copied().collect();
            let area = places.area(&[outline], Paint { colour: pen.colour, opacity: 0.25 });
            areas.extend(area.iter().map(|area| (places.spots(area.border()), name.clone(), pen.colour)));
            places.draw_series(area)?;
            for (side, pen) in [(from, pen), (to, branch_pen(loops, 0.6))] {
                let lines = places.draw_series(places.curve(&side, pen))?.pieces;
                lines.iter().for_each(|line| labels[1].placer.keep_off(line));
            }
        }
    }
    for row in &figure.measured {
        let [from, to] = [row.m_from, row.m_to];
        widths.mark(&mut labels[0], [(row.sigma, libm::log10(to - from))], Marker::Disc)?;
        let ends = [from, to].into_iter().filter(|_| row.sigma > 0.0);
        let ends = ends.map(|place| (row.sigma, libm::log10(place)));
        places.mark(&mut labels[1], ends, Marker::Disc)?;
    }
    for (line, name, colour) in &lines {
        labels[0].add(name, LABEL_SIZE, *colour, &Site::Beside(line))?;
    }
    for (area, name, colour) in &areas {
        labels[1].add(name, LABEL_SIZE, *colour, &Site::Within(area))?;
    }
    canvas.explain("stable $k$-loop MPSs", legend::line(branch_pen(2, 1.1)))?;
    widths.axes(r"$\sigma$", r"$\mathrm{log}_{10}$ of the width in $M$")?;
    places.axes(r"$\sigma$", r"$\mathrm{log}_{10}\,M$")?;
    for (panel, letter) in [(&widths, "(a)"), (&places, "(b)")] {
        let Bounds { left, top, .. } = panel.bounds;
        canvas.text((left, top - 5.0), letter, LABEL_SIZE, Anchor::Start, BLACK)?;
    }
    for labels in labels {
        labels.draw()?;
    }
    canvas.finish(
        "beyond_loops",
        "Solutions with more loops at one-loop resonances",
        "Sigma across. (a) The width in the scaled parameter M of the regions in which k-loop solutions are stable and \
         admissible, numbered by k. (b) Where these lie for positive sigma, from the period doubling (bold) to where the last \
         visit touches the wall. Discs: measured on the curves of oscillators.",
    )
}
