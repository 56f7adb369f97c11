//! The one style of all figures: colours, stroke widths, font sizes and physical sizes.
//!
//! The bifurcation curves keep the paper's colours, but their lightness and their strokes differ as
//! well, so that they can be distinguished without colour: grazing of the non-impacting solution is
//! light and wide, saddle-node solid and dark, period-doubling solid and of middle lightness,
//! grazing of an MPS dark with dots between its dashes. Plain dashes are left to approximations.

pub use grazing_results::kinds::Colour;
use grazing_results::kinds::{self, region_inks};
use grazing_results::plane::RegionKind;

/// How a line is drawn; lengths in points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pen {
    /// The colour.
    pub colour: Colour,
    /// The width.
    pub width: f64,
    /// Lengths of ink and gap in turn; empty for a solid line.
    pub dashes: &'static [f64],
    /// Round instead of cut ends.
    pub round: bool,
}

/// How an area is filled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Paint {
    /// The colour.
    pub colour: Colour,
    /// How much of what is below it covers, from 0 to 1.
    pub opacity: f64,
}

impl Pen {
    /// A solid line.
    pub const fn solid(colour: Colour, width: f64) -> Self {
        Pen { colour, width, dashes: &[], round: false }
    }

    /// A dashed line.
    pub const fn dashed(colour: Colour, width: f64, dashes: &'static [f64]) -> Self {
        Pen { colour, width, dashes, round: false }
    }
}

impl Paint {
    /// What hides all below it.
    pub const fn opaque(colour: Colour) -> Self {
        Paint { colour, opacity: 1.0 }
    }

    const fn of_region(kind: RegionKind) -> Self {
        let [(colour, opacity), _] = region_inks(kind);
        Paint { colour, opacity }
    }
}

/// How wide a figure is drawn. Text and lines keep their sizes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SheetWidth {
    /// As wide as the paper has this figure.
    #[default]
    Paper,
    /// One column of a journal with two: 86 mm.
    OneColumn,
    /// Both columns: 178 mm.
    TwoColumns,
}

impl SheetWidth {
    /// The width in millimetres of a figure that is `paper` millimetres wide in the paper.
    pub const fn mm(self, paper: f64) -> f64 {
        match self {
            Self::Paper => paper,
            Self::OneColumn => 86.0,
            Self::TwoColumns => 178.0,
        }
    }
}

/// Text, frames, and most lines.
pub const BLACK: Colour = [0, 0, 0];
/// The ground, and rims of what must be told apart from anything.
pub const WHITE: Colour = [255, 255, 255];
const ORANGE: Colour = [240, 130, 0];
/// Thin lines that only lead the eye.
pub const GREY: Colour = [110, 110, 110];

/// Axis titles, in points.
pub const TITLE_SIZE: f64 = 10.0;
/// Labels of curves, in points.
pub const LABEL_SIZE: f64 = 9.0;
/// Labels inside crowded panels, in points.
pub const SMALL_LABEL_SIZE: f64 = 8.0;
/// Numbers at the ticks, in points.
pub const TICK_SIZE: f64 = 7.5;

pub(crate) const FRAME: Pen = Pen::solid(BLACK, 0.6);
pub(crate) const TICK: Pen = Pen::solid(BLACK, 0.5);
pub(crate) const LEADER: Pen = Pen::solid(BLACK, 0.4);
pub(crate) const TICK_LENGTH: f64 = 3.0;
pub(crate) const MINOR_TICK_LENGTH: f64 = 1.7;

/// Where the non-impacting solution is stable.
pub const NON_IMPACTING_AREA: Paint = Paint::of_region(RegionKind::NonImpacting);
/// Where an MPS is stable; overlapping regions come out darker.
pub(crate) const MPS_AREA: Paint = Paint::of_region(RegionKind::Mps);

/// Hatching where it is not decided whether a solution is stable, and the distance of its lines in
/// points.
pub(crate) const UNDECIDED: Pen = Pen::solid(Paint::of_region(RegionKind::Undecided).colour, 0.45);
pub(crate) const HATCHING: f64 = 3.6;

/// The curves of a name that the file asks for where solutions are stable, and where they are not;
/// names come again in the order of the file.
pub(crate) fn own_pens(number: usize) -> [Pen; 2] {
    const DASHES: [&[f64]; 4] = [&[], &[7.0, 1.5], &[7.0, 1.2, 1.2, 1.2, 1.2, 1.2], &[3.0, 1.2]];
    kinds::OWN_WIDTHS.map(|width| Pen::dashed(kinds::OWN[0], width, DASHES[number % DASHES.len()]))
}
/// Their labels: darker, to be readable.
pub(crate) const OWN_TEXT: Colour = [112, 62, 160];

/// Rectangles that another figure magnifies.
pub(crate) const MAGNIFIED: Pen = Pen::solid(ORANGE, 1.0);
/// Labels of those rectangles: darker than the rectangle, to be readable.
pub(crate) const MAGNIFIED_TEXT: Colour = [176, 84, 0];
/// The line in the two-parameter diagram along which the one-parameter diagram runs.
pub(crate) const SECTION: Pen = Pen { round: true, ..Pen::solid(BLACK, 1.5) };
pub(crate) const THIN_SECTION: Pen = Pen::dashed(BLACK, 0.5, &[4.0, 1.6]);

pub(crate) const MARKER: Paint = Paint::opaque(kinds::MARKER[0]);
/// Rings, inside and out.
pub(crate) const HOLLOW: Paint = Paint::opaque(kinds::MARKER_RIM[0]);
/// See [`HOLLOW`].
pub(crate) const HOLLOW_RIM: Pen = Pen::solid(kinds::MARKER[0], 0.8);
pub(crate) const MARKER_RIM: Pen = Pen::solid(kinds::MARKER_RIM[0], 0.5);
pub(crate) const TRIANGLE_SIZE: f64 = 6.4;
/// A disc that marks a point, in points.
pub const DISC_RADIUS: f64 = 2.1;
/// The size of the mark of a measurement, in points; what fills one that does not agree, and the rim.
pub(crate) const MEASURED_SIZE: f64 = 4.4;
pub(crate) const MEASURED_OPEN: Paint = Paint::opaque(WHITE);
pub(crate) const MEASURED_RIM: Pen = Pen::solid(BLACK, 0.7);
/// The cross over what disagrees, and the rim about its strokes.
pub(crate) const DISAGREES: Pen = Pen { round: true, ..Pen::solid(BLACK, 1.1) };
pub(crate) const DISAGREES_RIM: Pen = Pen { round: true, ..Pen::solid(WHITE, 2.3) };
pub(crate) const ERROR_BAR: Pen = Pen::solid(GREY, 0.5);
pub(crate) const STAR_RADIUS: f64 = 3.8;

/// A branch of the one-parameter diagram by its number of loops, 0 for the non-impacting solution.
pub const fn branch_pen(p: u32, width: f64) -> Pen {
    Pen::solid(kinds::loops_colours(p)[0], width)
}

pub(crate) const STABLE_WIDTH: f64 = 1.7;
pub(crate) const UNSTABLE_WIDTH: f64 = 0.55;
/// The attractor's points, by how many fall into one bin: 1, 2 to 3, more.
pub(crate) const CLOUD: [Paint; 3] = [
    Paint { colour: CLOUD_COLOUR, opacity: 0.6 },
    Paint { colour: CLOUD_COLOUR, opacity: 0.85 },
    Paint { colour: CLOUD_COLOUR, opacity: 1.0 },
];
const CLOUD_COLOUR: Colour = [45, 70, 105];
/// Side of a bin of the attractor, in points.
pub(crate) const CLOUD_BIN: f64 = 0.36;

/// What motion comes to as the parameter goes up, and down: heads of arrows, so large.
pub(crate) const SWEEP_UP: Pen = Pen::solid(BLACK, 0.4);
pub(crate) const SWEEP_DOWN: Pen = Pen::solid(GREY, 0.4);
pub(crate) const SWEEP_SIZE: f64 = 1.6;

pub(crate) const PERIODIC_ORBIT: Pen = Pen::solid(BLACK, 0.9);
pub(crate) const ATTRACTOR_ORBIT: Pen = Pen::solid([70, 95, 130], 0.25);
pub(crate) const IMPACT: Pen = Pen::dashed(BLACK, 0.55, &[1.6, 1.2]);
/// The wall.
pub const WALL: Pen = Pen::solid(BLACK, 0.9);
/// What lies behind the wall.
pub const WALL_FACE: Paint = Paint::opaque([244, 244, 244]);
/// The hatching of that.
pub const WALL_HATCHING: Pen = Pen::solid(GREY, 0.45);
/// The level x = 0 above which there are impacts.
pub const THRESHOLD: Pen = Pen::solid([170, 170, 170], 0.4);
/// Thin lines from a portrait's letter into the diagram.
pub(crate) const GUIDE: Pen = Pen::dashed(GREY, 0.45, &[0.8, 1.6]);
/// The frame that is magnified.
pub(crate) const MAGNIFIER: Pen = Pen::solid(ORANGE, 0.8);
/// Frame of the magnification: a rim around the black one.
pub(crate) const MAGNIFIER_FRAME: Pen = Pen::solid(ORANGE, 1.9);
/// Bifurcations in the one-parameter diagram.
pub(crate) const POINT_RADIUS: f64 = 1.9;
pub(crate) const POINT_RIM: Pen = Pen::solid(BLACK, 0.4);

/// A circumflex over a letter of the size.
pub(crate) fn hat_pen(size: f64, colour: Colour) -> Pen {
    Pen::solid(colour, 0.06 * size)
}

/// Orbits in phase space.
pub(crate) const FLOW: Pen = Pen { round: true, ..Pen::solid(FLOW_COLOUR, 1.1) };
pub(crate) const FLOW_COLOUR: Colour = [20, 50, 140];
/// Where an orbit goes on as if there were no wall.
pub(crate) const VIRTUAL_FLOW: Pen = Pen::dashed(FLOW_COLOUR, 0.95, &[3.0, 2.0]);
/// The grazing periodic solution.
pub(crate) const PERIODIC_FLOW: Pen = Pen { round: true, ..Pen::solid(BLACK, 1.5) };
/// The reset law, from impact to recoil.
pub(crate) const RESET: Pen = Pen::dashed(RESET_COLOUR, 1.0, &[1.6, 1.5]);
/// Its colour, also for its name.
pub const RESET_COLOUR: Colour = [178, 34, 24];
/// A return map, from a point to its image.
pub(crate) const RETURN: Pen = Pen::solid(RETURN_COLOUR, 0.8);
/// Its colour, also for its name.
pub const RETURN_COLOUR: Colour = [0, 105, 75];
/// Axes of phase space, and thin lines on its surfaces.
pub(crate) const SPACE_AXIS: Pen = Pen::solid(BLACK, 0.55);
pub(crate) const TANGENCY: Pen = Pen::solid(BLACK, 0.8);
pub(crate) const CIRCLE: Pen = Pen::dashed(GREY, 0.5, &[0.8, 1.8]);
/// Outlines of surfaces.
pub(crate) const FACE_EDGE: Pen = Pen::solid([120, 120, 120], 0.4);
/// The incoming set: darker than the outgoing set, so that they differ without colour.
pub const INCOMING_FACE: Paint = Paint { colour: [120, 155, 210], opacity: 0.5 };
pub(crate) const OUTGOING_FACE: Paint = Paint { colour: [236, 204, 150], opacity: 0.5 };
/// The Poincaré section.
pub const SECTION_FACE: Paint = Paint { colour: [160, 208, 176], opacity: 0.5 };
/// Points of orbits; virtual ones are open.
pub(crate) const SPOT_RADIUS: f64 = 1.8;
pub(crate) const SPOT: Paint = Paint::opaque(BLACK);
pub(crate) const OPEN_SPOT: Paint = Paint::opaque(WHITE);
pub(crate) const SPOT_RIM: Pen = Pen::solid(BLACK, 0.7);

/// No figure may be heavier than this, in bytes.
pub(crate) const SIZE_LIMIT: usize = 2_000_000;
