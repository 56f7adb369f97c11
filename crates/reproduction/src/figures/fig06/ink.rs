//! Drawing of Figure 6: the oscillator as a mechanical schematic.

use grazing_drawing::POINTS_PER_MM;
use grazing_drawing::geometry::clip::checked;
use grazing_drawing::geometry::sheet::{Bounds, Spot};
use grazing_drawing::ink::arrow::{arrow, double_arrow};
use grazing_drawing::ink::canvas::{Anchor, Canvas};
use grazing_drawing::ink::elements::{Area, Stroke};
use grazing_drawing::ink::style::{
    BLACK, GREY, LABEL_SIZE, Paint, Pen, SMALL_LABEL_SIZE, TICK_SIZE, TITLE_SIZE, WALL, WALL_FACE,
    WALL_HATCHING,
};
use grazing_results::{Frame, span};

use super::{Part, PartPoint, Schematic};
use crate::figure::prelude::*;

/// The paint of bodies in the schematic, and the pen of their outlines.
const BODY: Paint = Paint::opaque([222, 228, 236]);
const BODY_OUTLINE: Pen = Pen::solid(BLACK, 1.0);
/// The pen of wires, rods and housings.
const WIRE: Pen = Pen { round: true, ..Pen::solid(BLACK, 0.9) };
/// The pen of the piston in its cylinder.
const PISTON: Pen = Pen::solid(BLACK, 2.0);
/// The pen of lines that project positions onto an axis.
const PROJECTION: Pen = Pen::dashed(GREY, 0.5, &[2.0, 1.6]);
/// The pen of axes and dimensions that end in arrowheads.
const AXIS: Pen = Pen::solid(BLACK, 0.6);
/// The pen of a force, in a colour of its own.
const FORCE: Pen = Pen::solid([214, 47, 32], 1.3);

/// A polyline of a part, on the sheet.
struct Piece {
    part: Part,
    path: Vec<Spot>,
}

/// The width of this figure in the paper.
const WIDTH_MM: f64 = 90.0;
const MARGIN_BESIDE: f64 = 4.0;
/// Room for the numbers below the axis, in points.
const MARGIN_BELOW: f64 = 22.0;
const MARGIN_ABOVE: f64 = 15.0;

/// Draws Figure 6.
pub(super) fn draw(figure: &Schematic, width: SheetWidth) -> Result<Sheet, DrawingError> {
    let (canvas, pieces) = on_sheet(&figure.parts, width.mm(WIDTH_MM))?;
    for piece in &pieces {
        draw_piece(&canvas, piece)?;
    }
    label(&canvas, &pieces)?;
    canvas.finish(
        "fig06",
        "The impact oscillator",
        "A block on a spring and a dashpot, driven by a harmonic force. Its face is at x, its equilibrium at x = -1; from a \
         wall at x = 0 it rebounds with a fraction epsilon of its velocity.",
    )
}

fn draw_piece(canvas: &Canvas, Piece { part, path }: &Piece) -> Result<(), DrawingError> {
    let ends = [path[0], path[path.len() - 1]];
    let pen = match part {
        Part::AnchorHatching | Part::WallHatching => WALL_HATCHING,
        Part::Anchor | Part::Wall => WALL,
        Part::Floor => AXIS,
        Part::Guide => PROJECTION,
        Part::Tick => AXIS,
        Part::Spring | Part::Rod | Part::Cylinder => WIRE,
        Part::Piston => PISTON,
        Part::Wheel => return canvas.draw(&Area::ring(path.as_slice(), WALL_FACE, Some(AXIS))),
        Part::Block => return canvas.draw(&Area::ring(path.as_slice(), BODY, Some(BODY_OUTLINE))),
        Part::Axis => return arrow(canvas, &ends, 0.0, AXIS),
        Part::Force => return arrow(canvas, &ends, 0.0, FORCE),
        Part::Dimension => return double_arrow(canvas, ends, AXIS),
    };
    canvas.draw(&Stroke::new(path.as_slice(), pen))
}

/// A label: its part, its text, its size, and the anchor and position relative to the part.
type Name = (Part, &'static str, f64, Anchor, fn(&Bounds) -> Spot);

const NAMES: [Name; 7] = [
    (Part::Spring, "unit stiffness", SMALL_LABEL_SIZE, Anchor::Middle, |at| (at.centre().0, at.top - 4.5)),
    (Part::Cylinder, r"damping $2\zeta$", SMALL_LABEL_SIZE, Anchor::Middle, |at| {
        (at.centre().0, at.bottom + 9.5)
    }),
    (Part::Block, "unit", SMALL_LABEL_SIZE, Anchor::Middle, |at| (at.centre().0, at.centre().1 - 1.5)),
    (Part::Block, "mass", SMALL_LABEL_SIZE, Anchor::Middle, |at| (at.centre().0, at.centre().1 + 8.0)),
    (Part::Force, r"$\mathcal{A}\,\mathrm{cos}(\omega t)$", LABEL_SIZE, Anchor::Start, |at| {
        (at.left + 2.0, at.top - 5.0)
    }),
    (Part::Dimension, "1", LABEL_SIZE, Anchor::Middle, |at| (at.centre().0, at.top - 3.5)),
    (Part::Wall, r"restitution $\epsilon$", SMALL_LABEL_SIZE, Anchor::End, |at| {
        (at.right + 11.0, at.top - 5.0)
    }),
];

/// Labels the parts.
fn label(canvas: &Canvas, pieces: &[Piece]) -> Result<(), DrawingError> {
    let whole = |part: Part| {
        let own = pieces.iter().filter(|piece| piece.part == part);
        own.map(|piece| Bounds::around(&piece.path)).reduce(Bounds::joined)
    };
    for (part, text, size, anchor, spot) in NAMES {
        let colour = if part == Part::Force { FORCE.colour } else { BLACK };
        if let Some(bounds) = whole(part) {
            canvas.text(spot(&bounds), text, size, anchor, colour)?;
        }
    }
    let below = |spot: Spot, text: &str, size: f64| canvas.text(spot, text, size, Anchor::Middle, BLACK);
    let ticks: Vec<&Piece> = pieces.iter().filter(|piece| piece.part == Part::Tick).collect();
    for (tick, text) in ticks.iter().zip([r"$x(t)$", "$-1$", "$0$"]) {
        if let Some(&(x, y)) = tick.path.first() {
            below((x, y + 9.5), text, SMALL_LABEL_SIZE)?;
        }
    }
    if let (Some(tick), Some(axis)) = (ticks.get(1).and_then(|tick| tick.path.first()), whole(Part::Axis)) {
        below((tick.0, tick.1 + 18.5), "equilibrium", TICK_SIZE)?;
        below((axis.right - 1.0, axis.bottom + 9.5), "$x$", TITLE_SIZE)?;
    }
    Ok(())
}

/// Places the parts on a sheet of the given width, as high as necessary, at the same scale in both
/// directions.
fn on_sheet(parts: &[PartPoint], width_mm: f64) -> Result<(Canvas, Vec<Piece>), DrawingError> {
    let (x, y) = (span(parts.iter().map(|point| point.x)), span(parts.iter().map(|point| point.height)));
    let frame = checked(Frame { x, y }, "fig06")?;
    let [[left, right], [low, high]] = [frame.x, frame.y];
    let scale = (width_mm * POINTS_PER_MM - 2.0 * MARGIN_BESIDE) / (right - left);
    let sheet_height = (high - low) * scale + MARGIN_ABOVE + MARGIN_BELOW;
    let canvas = Canvas::new(width_mm, sheet_height / POINTS_PER_MM)?;
    let spot = |point: &PartPoint| {
        (MARGIN_BESIDE + (point.x - left) * scale, MARGIN_ABOVE + (high - point.height) * scale)
    };
    let piece =
        |points: &[PartPoint]| Piece { part: points[0].part, path: points.iter().map(spot).collect() };
    let pieces = parts.chunk_by(|a, b| (a.part, a.piece) == (b.part, b.piece)).map(piece).collect();
    Ok((canvas, pieces))
}
