//! Names and appearance of each kind of curve, point and region: one table, read by the figures, the
//! report and the explorer.

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo};

use crate::branches::PortraitKind;
use crate::plane::RegionKind;

/// Red, green and blue.
pub type Colour = [u8; 3];

/// The description of a kind of curve, and how it is drawn.
///
/// The colours are the paper's; lightness and strokes differ as well, so that kinds can be distinguished
/// without colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurveLook {
    /// A description of the curve in words.
    pub meaning: &'static str,
    /// The same in short, beside its name in a legend.
    pub brief: &'static str,
    /// The place in the order in which curves are painted on the page of the explorer: later ones on top.
    pub layer: u8,
    /// The colours on light and on dark ground.
    pub colours: [Colour; 2],
    /// The colour of the quadratic approximation on dark ground; for light ground see
    /// [`approximation`](Self::approximation).
    approximation_on_dark: Colour,
    /// The colour of the label on light ground: that of the line, darker where it would be too light for
    /// text.
    pub text: Colour,
    /// The width of the line in points.
    pub width: f64,
    /// Lengths of dashes and gaps in turn, in points; empty for a solid line.
    pub dashes: &'static [f64],
}

impl CurveLook {
    /// The width of an approximation, in points.
    pub const APPROXIMATION_WIDTH: f64 = 0.9;
    /// The dashes of an approximation. Plain dashes are reserved for approximations.
    pub const APPROXIMATION_DASHES: &'static [f64] = &[3.2, 2.0];

    /// The width of dots along a grazing curve where the grazing solution is unstable, in points.
    pub const DOT: f64 = 1.1;
    /// Lengths of dots and of the gaps between them.
    pub const DOTS: &'static [f64] = &[1.1, 2.2];

    /// The look of a kind of curve.
    pub const fn of(kind: Bifurcation) -> Self {
        const GREEN: Colour = [0, 88, 56];
        const RED: Colour = [214, 47, 32];
        const BLUE: Colour = [25, 70, 190];
        const PURPLE: Colour = [122, 28, 140];
        const VIOLET: Colour = [99, 15, 254];
        match kind {
            Bifurcation::NonImpactingGrazing => Self {
                meaning: "grazing of the non-impacting solution",
                brief: "grazing",
                layer: 0,
                colours: [[120, 200, 110], [68, 157, 31]],
                approximation_on_dark: [152, 201, 132],
                text: [40, 120, 40],
                width: 2.2,
                dashes: &[],
            },
            Bifurcation::SaddleNode => Self {
                meaning: "saddle-node bifurcation",
                brief: "saddle-node",
                layer: 5,
                colours: [BLUE, [109, 123, 252]],
                approximation_on_dark: [175, 183, 253],
                text: BLUE,
                width: 1.15,
                dashes: &[],
            },
            Bifurcation::PeriodDoubling => Self {
                meaning: "period-doubling bifurcation",
                brief: "period doubling",
                layer: 4,
                colours: [RED, [223, 109, 108]],
                approximation_on_dark: [237, 175, 174],
                text: RED,
                width: 1.15,
                dashes: &[],
            },
            Bifurcation::Grazing => Self {
                meaning: "grazing of a maximal periodic solution",
                brief: "grazing of an MPS",
                layer: 1,
                colours: [GREEN, [109, 255, 170]],
                approximation_on_dark: [175, 255, 208],
                text: GREEN,
                width: 1.15,
                dashes: &[5.0, 1.2, 1.2, 1.2],
            },
            Bifurcation::Torus => Self {
                meaning: "torus (Neimark-Sacker) bifurcation",
                brief: "torus",
                layer: 2,
                colours: [PURPLE, [195, 161, 227]],
                approximation_on_dark: [222, 203, 240],
                text: PURPLE,
                width: 1.15,
                dashes: &[1.2, 1.2],
            },
            Bifurcation::Pitchfork => Self {
                meaning: "pitchfork bifurcation of symmetric motion",
                brief: "pitchfork",
                layer: 3,
                colours: [VIOLET, [151, 29, 254]],
                approximation_on_dark: [203, 145, 254],
                text: VIOLET,
                width: 1.15,
                dashes: &[5.0, 1.2],
            },
        }
    }

    /// The same look in another colour on light ground.
    #[must_use]
    pub const fn coloured(self, colour: Colour) -> Self {
        Self { colours: [colour, self.colours[1]], text: colour, ..self }
    }

    /// The colours of the quadratic approximation on light and on dark ground; on light ground it is
    /// darker than the curve, so that it is visible on top of it.
    pub const fn approximation(&self) -> [Colour; 2] {
        [darker(self.colours[0]), self.approximation_on_dark]
    }
}

/// The colour, on light ground, of an approximation to a curve of this colour.
const fn darker([red, green, blue]: Colour) -> Colour {
    const fn channel(channel: u8) -> u8 {
        (channel as u16 * 11 / 20) as u8
    }
    [channel(red), channel(green), channel(blue)]
}

/// The colours of curves that a file requests, on light and on dark ground.
pub const OWN: [Colour; 2] = [[162, 108, 216], [165, 53, 205]];
/// The widths of such a curve in points where solutions are stable, and where they are not.
pub const OWN_WIDTHS: [f64; 2] = [1.15, 0.5];

/// The fill or hatching of a kind of region on light and on dark ground: colour and opacity. Overlapping
/// regions appear darker.
pub const fn region_inks(kind: RegionKind) -> [(Colour, f64); 2] {
    match kind {
        RegionKind::NonImpacting => [([233, 233, 233], 1.0), ([43, 47, 54], 1.0)],
        RegionKind::Mps | RegionKind::Both => [([40, 40, 40], 0.3), ([225, 225, 225], 0.2)],
        RegionKind::SeveralImpacts => [([150, 160, 40], 0.4), ([190, 200, 90], 0.3)],
        RegionKind::Undecided => [([110, 110, 110], 1.0), ([140, 140, 140], 1.0)],
    }
}

/// The colour of codimension-two points on light and on dark ground.
pub const MARKER: [Colour; 2] = [[0, 0, 0], [242, 240, 234]];
/// The colour of the rim of codimension-two points, on light and on dark ground.
pub const MARKER_RIM: [Colour; 2] = [[255, 255, 255], [27, 30, 35]];

/// The colours of solutions by number of loops, on light and on dark ground, where the hue is the same: first
/// those of motion without impacts; the last entry is for that number of loops or more.
pub const LOOPS: [[Colour; 2]; 5] = [
    [[0, 0, 0], [242, 240, 234]],
    [[222, 132, 14], [234, 184, 46]],
    [[1, 151, 176], [120, 150, 169]],
    [[152, 27, 102], [202, 44, 179]],
    [[105, 53, 19], [146, 98, 62]],
];

/// The colours of solutions with p loops.
pub const fn loops_colours(p: u32) -> [Colour; 2] {
    let last = LOOPS.len() - 1;
    LOOPS[if (p as usize) < last { p as usize } else { last }]
}

/// The colours of branches of solutions with several impacts, on light and on dark ground.
pub const SEVERAL: [Colour; 2] = [[108, 138, 58], [216, 208, 104]];
/// The colours of periodic motion other than an MPS, on light and on dark ground.
pub const PERIODIC: [Colour; 2] = [[169, 167, 147], [96, 96, 108]];
/// The colours of motion that is not periodic, or not within the time followed, on light and on dark
/// ground.
pub const IRREGULAR: [Colour; 2] = [[58, 53, 64], [168, 192, 204]];
/// The colours of a place that is pointed at, on light and on dark ground.
pub const PLACE: [Colour; 2] = [[220, 44, 144], [244, 33, 146]];

/// The description of a kind of codimension-two point.
pub const fn point_meaning(kind: CodimensionTwo) -> &'static str {
    match kind {
        CodimensionTwo::Resonance => "resonant grazing bifurcation",
        CodimensionTwo::SaddleNodeGrazing => "saddle-node and grazing",
        CodimensionTwo::PeriodDoublingGrazing => "period-doubling and grazing",
        CodimensionTwo::GrazingGrazing => "two maxima graze",
        CodimensionTwo::Cusp => "cusp of a saddle-node curve",
        CodimensionTwo::SaddleNodeTorus => "saddle-node and torus: both multipliers are 1",
        CodimensionTwo::PeriodDoublingTorus => "period-doubling and torus: both multipliers are -1",
        CodimensionTwo::PitchforkTorus => "pitchfork and torus: both multipliers are 1",
        CodimensionTwo::TorusGrazing => "torus and grazing",
        CodimensionTwo::PitchforkGrazing => "pitchfork and grazing",
    }
}

/// The description of a kind of region.
pub const fn region_meaning(kind: RegionKind) -> &'static str {
    match kind {
        RegionKind::NonImpacting => "the non-impacting solution is stable",
        RegionKind::Mps => "a maximal periodic solution is stable",
        RegionKind::Both => "both are stable",
        RegionKind::SeveralImpacts => "a periodic solution with several impacts is stable",
        RegionKind::Undecided => "stability is undecided",
    }
}

/// The description of a kind of phase portrait.
pub const fn portrait_meaning(kind: PortraitKind) -> &'static str {
    match kind {
        PortraitKind::Periodic => "periodic solution",
        PortraitKind::Attractor => "attractor",
    }
}

/// The words for kinds of curves, points and portraits, and for regions of MPSs, as in tables, with their
/// meanings.
pub fn meanings() -> Vec<(&'static str, &'static str)> {
    let points = CodimensionTwo::ALL;
    let portraits = [PortraitKind::Periodic, PortraitKind::Attractor];
    let regions = RegionKind::ALL;
    let mut all = Vec::from(Bifurcation::ALL.map(|kind| (kind.name(), CurveLook::of(kind).meaning)));
    all.extend(points.map(|kind| (kind.name(), point_meaning(kind))));
    all.extend(portraits.map(|kind| (kind.name(), portrait_meaning(kind))));
    all.extend(regions.iter().map(|&kind| (kind.name(), region_meaning(kind))));
    all
}
