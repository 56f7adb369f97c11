//! The one style of all figures: colours, stroke widths, font sizes and physical sizes.
//!
//! The bifurcation curves have the paper's colours; their lightness and strokes differ as well, so that
//! they can be distinguished without colour: grazing of the non-impacting solution is light and wide,
//! saddle-node solid and dark, period-doubling solid and of medium lightness, grazing of an MPS dark with
//! dots between its dashes. Plain dashes are reserved for approximations.

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
    /// Lengths of dashes and gaps in turn; empty for a solid line.
    pub dashes: &'static [f64],
    /// Whether the ends are round rather than cut off.
    pub round: bool,
}

/// How an area is filled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Paint {
    /// The colour.
    pub colour: Colour,
    /// The fraction of the background that is covered, from 0 to 1.
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
    /// A paint that hides everything below it.
    pub const fn opaque(colour: Colour) -> Self {
        Paint { colour, opacity: 1.0 }
    }

    const fn of_region(kind: RegionKind) -> Self {
        let [(colour, opacity), _] = region_inks(kind);
        Paint { colour, opacity }
    }
}

/// The width at which a figure is drawn. Text and lines keep their sizes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SheetWidth {
    /// The width of the figure in the paper.
    #[default]
    Paper,
    /// One column of a two-column journal: 86 mm.
    OneColumn,
    /// Both columns of a two-column journal: 178 mm.
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

/// The colour of text, frames, and most lines.
pub const BLACK: Colour = [0, 0, 0];
/// The colour of the background, and of rims around objects that must stand out.
pub const WHITE: Colour = [255, 255, 255];
const ORANGE: Colour = [240, 130, 0];
/// The colour of thin auxiliary lines.
pub const GREY: Colour = [110, 110, 110];

/// The font size of axis titles, in points.
pub const TITLE_SIZE: f64 = 10.0;
/// The font size of labels of curves, in points.
pub const LABEL_SIZE: f64 = 9.0;
/// The font size of labels inside crowded panels, in points.
pub const SMALL_LABEL_SIZE: f64 = 8.0;
/// The font size of numbers at the ticks, in points.
pub const TICK_SIZE: f64 = 7.5;

pub(crate) const FRAME: Pen = Pen::solid(BLACK, 0.6);
pub(crate) const TICK: Pen = Pen::solid(BLACK, 0.5);
pub(crate) const LEADER: Pen = Pen::solid(BLACK, 0.4);
pub(crate) const TICK_LENGTH: f64 = 3.0;
pub(crate) const MINOR_TICK_LENGTH: f64 = 1.7;

/// The paint of regions where the non-impacting solution is stable.
pub const NON_IMPACTING_AREA: Paint = Paint::of_region(RegionKind::NonImpacting);
/// The paint of regions where an MPS is stable; overlapping regions appear darker.
pub(crate) const MPS_AREA: Paint = Paint::of_region(RegionKind::Mps);

/// The paint of regions where a solution with several impacts is stable.
pub(crate) const SEVERAL_AREA: Paint = Paint::of_region(RegionKind::SeveralImpacts);

/// The hatching of regions where stability is undecided, and the distance of its lines in points.
pub(crate) const UNDECIDED: Pen = Pen::solid(Paint::of_region(RegionKind::Undecided).colour, 0.45);
pub(crate) const HATCHING: f64 = 3.6;

/// The pens of the curves with the name of this number that a file requests: where solutions are stable,
/// and where they are not. Dash patterns repeat in the order of the file.
pub(crate) fn own_pens(number: usize) -> [Pen; 2] {
    const DASHES: [&[f64]; 4] = [&[], &[7.0, 1.5], &[7.0, 1.2, 1.2, 1.2, 1.2, 1.2], &[3.0, 1.2]];
    kinds::OWN_WIDTHS.map(|width| Pen::dashed(kinds::OWN[0], width, DASHES[number % DASHES.len()]))
}
/// The colour of labels of requested curves: darker, for legibility.
pub(crate) const OWN_TEXT: Colour = [112, 62, 160];

/// The pen of rectangles that another figure magnifies.
pub(crate) const MAGNIFIED: Pen = Pen::solid(ORANGE, 1.0);
/// The pen of rectangles around areas that are too small to be drawn.
pub(crate) const AROUND_MAGNIFIED: Pen = Pen::dashed(ORANGE, 1.0, &[1.0, 1.0]);
/// The colour of labels of those rectangles: darker than the rectangle, for legibility.
pub const MAGNIFIED_TEXT: Colour = [176, 84, 0];
/// The pen of the line in the two-parameter diagram along which the one-parameter diagram runs.
pub(crate) const SECTION: Pen = Pen { round: true, ..Pen::solid(BLACK, 1.5) };
pub(crate) const THIN_SECTION: Pen = Pen::dashed(BLACK, 0.5, &[4.0, 1.6]);

pub(crate) const MARKER: Paint = Paint::opaque(kinds::MARKER[0]);
/// The inside of rings.
pub(crate) const HOLLOW: Paint = Paint::opaque(kinds::MARKER_RIM[0]);
/// The rim of rings.
pub(crate) const HOLLOW_RIM: Pen = Pen::solid(kinds::MARKER[0], 0.8);
pub(crate) const MARKER_RIM: Pen = Pen::solid(kinds::MARKER_RIM[0], 0.5);
pub(crate) const TRIANGLE_SIZE: f64 = 6.4;
/// The radius of a disc that marks a point, in points.
pub const DISC_RADIUS: f64 = 2.1;
/// The size of the mark of a measurement, in points; the filling of marks that do not agree, and the rim.
pub(crate) const MEASURED_SIZE: f64 = 4.4;
pub(crate) const MEASURED_OPEN: Paint = Paint::opaque(WHITE);
pub(crate) const MEASURED_RIM: Pen = Pen::solid(BLACK, 0.7);
/// The cross over marks that disagree, and the rim of its strokes.
pub(crate) const DISAGREES: Pen = Pen { round: true, ..Pen::solid(BLACK, 1.1) };
pub(crate) const DISAGREES_RIM: Pen = Pen { round: true, ..Pen::solid(WHITE, 2.3) };
pub(crate) const ERROR_BAR: Pen = Pen::solid(GREY, 0.5);
pub(crate) const STAR_RADIUS: f64 = 3.8;

/// The pen of a branch in the one-parameter diagram by its number of loops, 0 for the non-impacting
/// solution.
pub const fn branch_pen(p: u32, width: f64) -> Pen {
    Pen::solid(kinds::loops_colours(p)[0], width)
}

/// The pen of branches of solutions with several impacts, whatever their numbers.
pub(crate) const fn several_pen(width: f64) -> Pen {
    Pen::solid(kinds::SEVERAL[0], width)
}

pub(crate) const STABLE_WIDTH: f64 = 1.7;
pub(crate) const UNSTABLE_WIDTH: f64 = 0.55;
pub(crate) const NEUTRAL_WIDTH: f64 = 1.1;
pub(crate) const NEUTRAL_DASHES: &[f64] = &[6.0, 1.4];
/// The paint of an attractor's points, by the number in one bin: 1, 2 to 3, more.
pub(crate) const CLOUD: [Paint; 3] = [
    Paint { colour: CLOUD_COLOUR, opacity: 0.6 },
    Paint { colour: CLOUD_COLOUR, opacity: 0.85 },
    Paint { colour: CLOUD_COLOUR, opacity: 1.0 },
];
const CLOUD_COLOUR: Colour = [45, 70, 105];
/// The side of a bin of an attractor's points, in points.
pub(crate) const CLOUD_BIN: f64 = 0.36;

/// The pens and the size of the arrowheads that mark long-term behaviour as the parameter increases and
/// decreases.
pub(crate) const SWEEP_UP: Pen = Pen::solid(BLACK, 0.4);
pub(crate) const SWEEP_DOWN: Pen = Pen::solid(GREY, 0.4);
pub(crate) const SWEEP_SIZE: f64 = 1.6;

pub(crate) const PERIODIC_ORBIT: Pen = Pen::solid(BLACK, 0.9);
pub(crate) const ATTRACTOR_ORBIT: Pen = Pen::solid([70, 95, 130], 0.25);
/// The pen of impacts in phase portraits, and of the gap in the wall's line behind its dashes.
pub(crate) const IMPACT: Pen = Pen::dashed(BLACK, 1.1, &[1.8, 1.5]);
pub(crate) const WALL_GAP: Pen = Pen::solid(WHITE, 1.1);
/// The pen of the wall.
pub const WALL: Pen = Pen::solid(BLACK, 0.9);
/// The paint of the area behind the wall.
pub const WALL_FACE: Paint = Paint::opaque([244, 244, 244]);
/// The hatching of the area behind the wall.
pub const WALL_HATCHING: Pen = Pen::solid(GREY, 0.45);
/// The pen of the level x = 0, above which there are impacts.
pub const THRESHOLD: Pen = Pen::solid([170, 170, 170], 0.4);
/// The pen of thin lines from a portrait's letter into the diagram.
pub(crate) const GUIDE: Pen = Pen::dashed(GREY, 0.45, &[0.8, 1.6]);
/// The pen of the frame that is magnified.
pub(crate) const MAGNIFIER: Pen = Pen::solid(ORANGE, 0.8);
/// The pen of the frame of the magnification: a rim around the black one.
pub(crate) const MAGNIFIER_FRAME: Pen = Pen::solid(ORANGE, 1.9);
/// The radius and the rim of bifurcations in the one-parameter diagram.
pub(crate) const POINT_RADIUS: f64 = 1.9;
pub(crate) const POINT_RIM: Pen = Pen::solid(BLACK, 0.4);

/// The pen of a circumflex over a letter of this size.
pub(crate) fn hat_pen(size: f64, colour: Colour) -> Pen {
    Pen::solid(colour, 0.06 * size)
}

/// The pen of orbits in phase space.
pub(crate) const FLOW: Pen = Pen { round: true, ..Pen::solid(FLOW_COLOUR, 1.1) };
pub(crate) const FLOW_COLOUR: Colour = [20, 50, 140];
/// The pen of orbits continued as if there were no wall.
pub(crate) const VIRTUAL_FLOW: Pen = Pen::dashed(FLOW_COLOUR, 0.95, &[3.0, 2.0]);
/// The pen of the grazing periodic solution.
pub(crate) const PERIODIC_FLOW: Pen = Pen { round: true, ..Pen::solid(BLACK, 1.5) };
/// The pen of the reset law, from impact to recoil.
pub(crate) const RESET: Pen = Pen::dashed(RESET_COLOUR, 1.0, &[1.6, 1.5]);
/// The colour of the reset law and of its name.
pub const RESET_COLOUR: Colour = [178, 34, 24];
/// The pen of a return map, from a point to its image.
pub(crate) const RETURN: Pen = Pen::solid(RETURN_COLOUR, 0.8);
/// The colour of a return map and of its name.
pub const RETURN_COLOUR: Colour = [0, 105, 75];
/// The pens of axes of phase space, and of thin lines on its surfaces.
pub(crate) const SPACE_AXIS: Pen = Pen::solid(BLACK, 0.55);
pub(crate) const TANGENCY: Pen = Pen::solid(BLACK, 0.8);
pub(crate) const CIRCLE: Pen = Pen::dashed(GREY, 0.5, &[0.8, 1.8]);
/// The pen of outlines of surfaces.
pub(crate) const FACE_EDGE: Pen = Pen::solid([120, 120, 120], 0.4);
/// The paint of the incoming set: darker than the outgoing set, so that they differ without colour.
pub const INCOMING_FACE: Paint = Paint { colour: [120, 155, 210], opacity: 0.5 };
pub(crate) const OUTGOING_FACE: Paint = Paint { colour: [236, 204, 150], opacity: 0.5 };
/// The paint of the Poincaré section.
pub const SECTION_FACE: Paint = Paint { colour: [160, 208, 176], opacity: 0.5 };
/// The radius, paint and rim of points of orbits; virtual points are open.
pub(crate) const SPOT_RADIUS: f64 = 1.8;
pub(crate) const SPOT: Paint = Paint::opaque(BLACK);
pub(crate) const OPEN_SPOT: Paint = Paint::opaque(WHITE);
pub(crate) const SPOT_RIM: Pen = Pen::solid(BLACK, 0.7);

/// The greatest size of a figure, in bytes.
pub(crate) const SIZE_LIMIT: usize = 2_000_000;
