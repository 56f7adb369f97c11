//! Drawing of the atlas of the limit map.

use grazing_drawing::geometry::sheet::Bounds;
use grazing_drawing::ink::canvas::{Anchor, Canvas};
use grazing_drawing::ink::labels::{Labels, Site};
use grazing_drawing::ink::legend;
use grazing_drawing::ink::markers::Marker;
use grazing_drawing::ink::style::{BLACK, GREY, LABEL_SIZE, Paint, Pen, SMALL_LABEL_SIZE, branch_pen};
use grazing_drawing::plot::axes::Panel;
use grazing_reproduction::prelude::*;
use grazing_results::Frame;

use super::{Atlas, AtlasNode};

/// The width in the paper and the height, in millimetres; room around panels, in points.
const WIDTH_MM: f64 = 156.0;
const HEIGHT_MM: f64 = 132.0;
const LEFT: f64 = 42.0;
const GAP: f64 = 20.0;
const ABOVE: f64 = 16.0;
const BELOW: f64 = 31.0;
const RIGHT: f64 = 8.0;
/// The quantity that is shown along a line of the lattice.
type Ratio = fn(&AtlasNode) -> f64;
/// The shade that each boundary adds to the area beyond it, and the pens of boundaries and of the ε of
/// Figure 7.
const SHADE: Paint = Paint { colour: [45, 70, 105], opacity: 0.17 };
const EDGE: Pen = Pen::solid([45, 70, 105], 0.6);
const OWN: Pen = Pen::dashed(GREY, 0.6, &[4.0, 1.6]);
/// The width, in points, below which an area is not labelled.
const SEEN: f64 = 2.0;
/// The range of the ratios that are shown.
const RATIOS: [f64; 2] = [-1.6, 1.25];

impl Atlas {
    /// Draws the atlas: the orbits that begin stable, for p = 1 and p ≥ 2, and the ratios below.
    pub(super) fn draw(&self, width: SheetWidth) -> Result<Sheet, DrawingError> {
        let canvas = Canvas::new(width.mm(WIDTH_MM), HEIGHT_MM)?;
        let room = canvas.width - LEFT - GAP - RIGHT;
        let middle = 0.5 * canvas.height;
        // Equal scales, or on narrow sheets a greater one where resonances are dense.
        let parting = LEFT + room * if width == SheetWidth::OneColumn { 0.44 } else { 2.0 / 3.0 };
        let columns = [
            (1, [LEFT, parting], [-1.0, 1.0], [r"(a)  $p=1$", "(c)"]),
            (2, [parting + GAP, canvas.width - RIGHT], [-1.0, 0.0], [r"(b)  $p\ge 2$", "(d)"]),
        ];
        for (loops, [left, right], across, [above, below]) in columns {
            let titles = if loops == 1 { [r"$\epsilon$", r"$c/c_{\mathrm{PD}}$"] } else { [""; 2] };
            let panel = |top: f64, y, tables| {
                let bounds = Bounds { left, top: top + ABOVE, right, bottom: top + middle - BELOW };
                let mut panel = Panel::new(&canvas, Frame { x: across, y }, bounds)?;
                (panel.tables, panel.numbers_beside) = (tables, loops == 1);
                Ok::<_, DrawingError>(panel)
            };
            let mut map = panel(0.0, [0.0, 1.0], &["beyond_atlas", "beyond_atlas_resonances"])?;
            self.draw_map(&mut map, loops)?;
            map.axes(r"$\sigma$", titles[0])?;
            let mut ratios = panel(middle, RATIOS, &["beyond_atlas_lattice"])?;
            self.draw_ratios(&mut ratios, loops)?;
            ratios.axes(r"$\sigma$", titles[1])?;
            canvas.text((left, ABOVE - 5.0), above, LABEL_SIZE, Anchor::Start, BLACK)?;
            let below = format!(r"{below}  $\epsilon={}$", self.epsilon);
            canvas.text((left, middle + ABOVE - 5.0), &below, LABEL_SIZE, Anchor::Start, BLACK)?;
        }
        canvas.finish(
            "beyond_atlas",
            "Atlas of the limit map of linear oscillators",
            "Above: sigma across, coefficient of restitution up. The darker, the more stable orbits, with 2, 4, 8 and 16 impacts, emerge in turn as the \
             parameter moves beyond the period doubling; white: the period doubling is subcritical. Triangles: resonances of Figure~7. Below: where \
             saddle-nodes, second period doublings and grazing of period-doubled orbits are, in units of c_PD.",
        )
    }

    fn draw_map(&self, panel: &mut Panel<'_>, loops: u32) -> Result<(), DrawingError> {
        let mut labels = Labels::new(panel.canvas, panel.bounds);
        let curves = self.boundaries.chunk_by(|a, b| (a.loops, a.impacts) == (b.loops, b.impacts));
        let curves: Vec<Vec<(f64, f64)>> = curves
            .filter(|curve| curve[0].loops == loops)
            .map(|curve| curve.iter().map(|point| (point.sigma, point.epsilon)).collect())
            .collect();
        let mut edges = Vec::new();
        for (number, curve) in curves.iter().enumerate() {
            // The area begins at the lower end of the panel, where the first row is drawn.
            let lowest = (curve[0].0, 0.0);
            let area: Vec<_> =
                [(-1.0, 0.0), lowest].into_iter().chain(curve.iter().copied()).chain([(-1.0, 1.0)]).collect();
            let edge = panel.curve(&area[1..area.len() - 1], EDGE);
            let shade = Paint { opacity: 1.0 - libm::pow(1.0 - SHADE.opacity, 1.0 + number as f64), ..SHADE };
            let drawn = panel.draw_series(panel.area(&[area], SHADE))?;
            drawn.label(MEANINGS[number]).legend(legend::area(shade))?;
            edges.extend(panel.draw_series(edge)?.pieces);
        }
        let own = panel.draw_series(panel.curve(&[(-1.0, self.epsilon), (1.0, self.epsilon)], OWN))?;
        let own = own.label("the ε of Figure 7").legend(legend::line(OWN))?;
        own.pieces.iter().for_each(|piece| labels.placer.keep_off(piece));
        let mut marked = Vec::new();
        for place in self.places.iter().filter(|place| place.loops.min(2) == loops) {
            let at = (place.sigma, place.epsilon);
            for spot in panel.mark(&mut labels, [at], Marker::Triangle)?.pieces.concat() {
                marked.push((format!("{}, {}", place.loops, place.n), spot));
            }
        }
        edges.iter().for_each(|edge| labels.placer.keep_off(edge));
        for (name, spot) in &marked {
            let taken = Marker::Triangle.around(*spot);
            let (spots, reach) = ([taken.centre()], 0.5 * (taken.right - taken.left));
            // Closest first; over lines rather than not at all.
            let sites = [
                Site::Around(spots[0], reach),
                Site::Around(spots[0], reach + 1.0),
                Site::Anyhow(&spots, reach),
            ];
            for site in &sites {
                if labels.add(name, SMALL_LABEL_SIZE - 1.0, BLACK, site)? {
                    break;
                }
            }
        }
        // Each name is in the area between a boundary and the next.
        let beyond: Vec<(f64, f64)> =
            curves.first().into_iter().flatten().map(|&(_, epsilon)| (panel.frame.x[1], epsilon)).collect();
        let none: Vec<(f64, f64)> =
            curves.first().into_iter().flatten().map(|&(_, epsilon)| (-1.0, epsilon)).collect();
        let all: Vec<&Vec<(f64, f64)>> = [&beyond].into_iter().chain(&curves).chain([&none]).collect();
        for (pair, name) in all.windows(2).zip(NAMES) {
            let ring: Vec<_> =
                pair[0].iter().chain(pair[1].iter().rev()).map(|&point| panel.spot(point)).collect();
            let across =
                pair[0].iter().zip(pair[1]).map(|(one, two)| panel.spot(*one).0 - panel.spot(*two).0);
            let is_seen = across.fold(0.0, f64::max) > SEEN;
            if !labels.add(name, SMALL_LABEL_SIZE, BLACK, &Site::Within(&ring))? && is_seen {
                let between = |(one, two): (&(f64, f64), &(f64, f64))| {
                    let (one, two) = (panel.spot(*one), panel.spot(*two));
                    (0.5 * (one.0 + two.0), 0.5 * (one.1 + two.1))
                };
                let band: Vec<_> = pair[0].iter().zip(pair[1]).map(between).collect();
                labels.add(name, SMALL_LABEL_SIZE, BLACK, &Site::Led(&band))?;
            }
        }
        labels.draw()
    }

    fn draw_ratios(&self, panel: &mut Panel<'_>, loops: u32) -> Result<(), DrawingError> {
        let mut labels = Labels::new(panel.canvas, panel.bounds);
        let own: Vec<&AtlasNode> =
            self.lattice.iter().filter(|node| node.epsilon == self.epsilon && node.loops == loops).collect();
        let curves: [(Pen, &str, Ratio); 4] = [
            (Pen::solid(BLACK, 0.8), "PD", |_| 1.0),
            (branch_pen(loops, 1.1), "2GZ", AtlasNode::grazing),
            (Pen::dashed(BLACK, 0.8, &[2.6, 1.3]), "second PD", |node| {
                node.in_units(node.map.doubled_doubling().unwrap_or(f64::NAN))
            }),
            (Pen::solid(GREY, 0.8), "SN", |node| node.in_units(node.map.saddle_node()[1])),
        ];
        let mut pieces = Vec::new();
        for (pen, name, ratio) in curves {
            let points: Vec<_> = own.iter().map(|node| (node.sigma, ratio(node))).collect();
            for piece in panel.draw_series(panel.curve(&points, pen))?.pieces {
                labels.placer.keep_off(&piece);
                pieces.push((name, pen.colour, piece));
            }
        }
        for (name, colour, piece) in &pieces {
            labels.add(name, SMALL_LABEL_SIZE, *colour, &Site::Pieces(&[piece]))?;
        }
        for place in self.places.iter().filter(|place| place.loops.min(2) == loops) {
            let tick = [(place.sigma, RATIOS[0]), (place.sigma, RATIOS[0] + 0.08)];
            panel.draw_series(panel.curve(&tick, Pen::solid(BLACK, 0.5)))?;
        }
        labels.draw()
    }
}

const MEANINGS: [&str; 4] = [
    "the period doubling is supercritical",
    "orbits with 4 impacts emerge stable",
    "with 8 impacts",
    "with 16 impacts",
];
const NAMES: [&str; 5] = ["subcritical", "2", "4", "8", r"$\ge 16$"];
