//! Drawing of the cascades side by side, with the limit on the right.

use core::iter::repeat_n;

use grazing_drawing::geometry::sheet::Bounds;
use grazing_drawing::ink::canvas::{Anchor, Canvas};
use grazing_drawing::ink::style::{BLACK, GREY, LABEL_SIZE, Pen, SMALL_LABEL_SIZE};
use grazing_drawing::plot::axes::Panel;
use grazing_drawing::plot::cloud::draw_cloud;
use grazing_reproduction::prelude::*;
use grazing_results::{Frame, span};

use super::{CascadePoint, Cascades, SHOWN};

/// The greatest impact velocity shown, in units of the velocity at the period doubling.
const FASTEST: f64 = 2.0;
/// The width in the paper and the height of a row in millimetres, and room around panels in points.
const WIDTH_MM: f64 = 156.0;
const ROW_MM: f64 = 52.0;
const LEFT: f64 = 36.0;
const GAP: f64 = 7.0;
/// Room above panels for the resonance of their row and, on a line of its own, what each shows.
const ABOVE: f64 = 26.0;
const LINE: f64 = 10.0;
const BELOW: f64 = 31.0;
/// The pen that marks where orbits with more impacts begin.
const ONSET: Pen = Pen::dashed(GREY, 0.45, &[0.8, 1.6]);

impl Cascades {
    /// Draws the figure: a row for each resonance, with the limit on the right.
    pub(super) fn draw(&self, width: SheetWidth) -> Result<Sheet, DrawingError> {
        let rows: Vec<_> = self.panels.chunk_by(|a, b| (a.loops, a.n) == (b.loops, b.n)).collect();
        let width = width.mm(WIDTH_MM);
        let canvas = Canvas::new(width, ROW_MM * rows.len().max(1) as f64)?;
        let row = canvas.height / rows.len().max(1) as f64;
        let column = (canvas.width - LEFT - GAP) / rows.first().map_or(1, |row| row.len()) as f64;
        let narrow = width < WIDTH_MM;
        let columns = ["scaled_parameter", "scaled_velocity"].map(str::to_owned);
        for (panels, top) in rows.iter().zip((0..).map(|number| row * f64::from(number))) {
            let of_row = |point: &&CascadePoint| panels.iter().any(|panel| panel.panel == point.panel);
            let [low, high] = span(self.points.iter().filter(of_row).map(|point| point.scaled));
            let [slowest, fastest] = span(self.points.iter().filter(of_row).map(|point| point.velocity));
            let room = 0.01 * (high - low);
            let frame =
                Frame { x: [low - room, high + room], y: [0.9 * slowest, FASTEST.min(1.05 * fastest)] };
            for (panel, left) in panels.iter().zip((0..).map(|number| LEFT + column * f64::from(number))) {
                let bounds =
                    Bounds { left, top: top + ABOVE, right: left + column - GAP, bottom: top + row - BELOW };
                let mut drawn = Panel::new(&canvas, frame, bounds)?;
                drawn.tables = &["beyond_cascade_attractor"];
                drawn.only = Some(("panel", panel.panel));
                drawn.columns = Some(columns.clone());
                drawn.numbers_beside = left == LEFT;
                let own = self.onsets.iter().filter(|at| (at.point.loops(), at.n) == (panel.loops, panel.n));
                for onset in
                    own.flat_map(|at| (0..at.cascade.onsets.len()).map(|place| at.cascade.fraction(place)))
                {
                    drawn.draw_series(drawn.curve(&[(onset, frame.y[0]), (onset, frame.y[1])], ONSET))?;
                }
                let own: Vec<&CascadePoint> =
                    self.points.iter().filter(|point| point.panel == panel.panel).collect();
                // The points of periodic motion count as often as they would be shown without their
                // reduction to one period.
                let weighed = own.chunk_by(|a, b| a.scaled == b.scaled).flat_map(|at| {
                    let places = at.iter().map(|point| (point.scaled, point.velocity));
                    places.flat_map(|place| repeat_n(place, SHOWN / at.len()))
                });
                draw_cloud(&mut drawn, &weighed.collect::<Vec<_>>())?;
                drawn.axes(r"$M/M_{\mathrm{PD}}$", if left == LEFT { r"$y/y_{\mathrm{PD}}$" } else { "" })?;
                let size = if panel.size > 0.0 {
                    format!(r"$y_{{\mathrm{{PD}}}}={}$", panel.size)
                } else {
                    "limit map".to_owned()
                };
                let text = if narrow { SMALL_LABEL_SIZE - 1.0 } else { LABEL_SIZE };
                let write = |rise: f64, heading: &str| {
                    canvas.text((left, top + ABOVE - rise), heading, text, Anchor::Start, BLACK)
                };
                if left == LEFT {
                    write(5.0 + LINE, &format!("$p={}$, $n={}$", panel.loops, panel.n))?;
                }
                write(5.0, &size)?;
            }
        }
        canvas.finish(
            "beyond_cascade",
            "What follows the period doubling near three resonances",
            "Impact velocity of simulated motion against M, the distance of the parameter from grazing, both in units of their values at the period doubling. From left \
             to right: closer to the resonance; the last column is the limit map. Dotted: onset of orbits with 2, 4, 8 and 16 impacts. Impacts more than twice as fast are left out.",
        )
    }
}
