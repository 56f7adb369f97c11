//! What each kind of curve, point and region is called, and how it looks: one table, which the
//! figures, the report and the explorer read.

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo};

use crate::branches::PortraitKind;
use crate::plane::RegionKind;

/// Red, green and blue.
pub type Colour = [u8; 3];

/// What a curve of a kind is called, and how it is drawn.
///
/// The colours are the paper's, but lightness and strokes differ as well, so that kinds can be told
/// apart without colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurveLook {
    /// What the curve is.
    pub meaning: &'static str,
    /// On light and on dark ground.
    pub colours: [Colour; 2],
    /// Its quadratic approximation on dark ground; on light ground see
    /// [`approximation`](Self::approximation).
    approximation_on_dark: Colour,
    /// Its label on light ground: the line's colour, darker where that would be too light for text.
    pub text: Colour,
    /// In points.
    pub width: f64,
    /// Lengths of ink and gap in turn, in points; none for a solid line.
    pub dashes: &'static [f64],
}

impl CurveLook {
    /// The width of an approximation, in points.
    pub const APPROXIMATION_WIDTH: f64 = 0.9;
    /// Its dashes. Plain dashes are left to approximations.
    pub const APPROXIMATION_DASHES: &'static [f64] = &[3.2, 2.0];

    /// The look of a kind of curve.
    pub const fn of(kind: Bifurcation) -> Self {
        const GREEN: Colour = [0, 88, 56];
        const RED: Colour = [214, 47, 32];
        const BLUE: Colour = [25, 70, 190];
        const PURPLE: Colour = [122, 28, 140];
        match kind {
            Bifurcation::NonImpactingGrazing => Self {
                meaning: "grazing of the non-impacting solution",
                colours: [[120, 200, 110], [111, 191, 102]],
                approximation_on_dark: [169, 224, 162],
                text: [40, 120, 40],
                width: 2.2,
                dashes: &[],
            },
            Bifurcation::SaddleNode => Self {
                meaning: "saddle-node bifurcation",
                colours: [BLUE, [140, 171, 255]],
                approximation_on_dark: [195, 211, 255],
                text: BLUE,
                width: 1.15,
                dashes: &[],
            },
            Bifurcation::PeriodDoubling => Self {
                meaning: "period-doubling bifurcation",
                colours: [RED, [255, 125, 110]],
                approximation_on_dark: [255, 185, 176],
                text: RED,
                width: 1.15,
                dashes: &[],
            },
            Bifurcation::Grazing => Self {
                meaning: "grazing of a maximal periodic solution",
                colours: [GREEN, [87, 207, 159]],
                approximation_on_dark: [165, 236, 208],
                text: GREEN,
                width: 1.15,
                dashes: &[5.0, 1.2, 1.2, 1.2],
            },
            Bifurcation::Torus => Self {
                meaning: "torus (Neimark-Sacker) bifurcation",
                colours: [PURPLE, [214, 160, 245]],
                approximation_on_dark: [231, 201, 250],
                text: PURPLE,
                width: 1.15,
                dashes: &[1.2, 1.2],
            },
        }
    }

    /// The colours of its quadratic approximation, on light ground darker than the curve, so that
    /// it shows on top of that.
    pub const fn approximation(&self) -> [Colour; 2] {
        const fn darker(channel: u8) -> u8 {
            (channel as u16 * 11 / 20) as u8
        }
        let [red, green, blue] = self.colours[0];
        [[darker(red), darker(green), darker(blue)], self.approximation_on_dark]
    }
}

/// How a region of a kind is filled or hatched, on light and on dark ground: colour and opacity.
/// Regions that overlap come out darker.
pub const fn region_inks(kind: RegionKind) -> [(Colour, f64); 2] {
    match kind {
        RegionKind::NonImpacting => [([233, 233, 233], 1.0), ([43, 47, 54], 1.0)],
        RegionKind::Mps | RegionKind::Both => [([40, 40, 40], 0.3), ([225, 225, 225], 0.2)],
        RegionKind::Undecided => [([110, 110, 110], 1.0), ([140, 140, 140], 1.0)],
    }
}

/// Codimension-two points, and their rims, on light and on dark ground.
pub const MARKER: [Colour; 2] = [[0, 0, 0], [242, 240, 234]];
/// See [`MARKER`].
pub const MARKER_RIM: [Colour; 2] = [[255, 255, 255], [27, 30, 35]];

/// A branch of solutions by its number of loops, on light and on dark ground: first motion without
/// impacts, as which more loops than are here look, too.
pub const BRANCHES: [[Colour; 2]; 7] = [
    [[0, 0, 0], [242, 240, 234]],
    [[190, 95, 0], [240, 160, 75]],
    [[25, 70, 190], [140, 171, 255]],
    [[150, 30, 110], [228, 138, 198]],
    [[0, 120, 105], [79, 209, 189]],
    [[175, 60, 35], [255, 156, 130]],
    [[95, 95, 0], [208, 207, 106]],
];

/// What a point of a kind is.
pub const fn point_meaning(kind: CodimensionTwo) -> &'static str {
    match kind {
        CodimensionTwo::Resonance => "resonant grazing bifurcation",
        CodimensionTwo::SaddleNodeGrazing => "saddle-node and grazing",
        CodimensionTwo::PeriodDoublingGrazing => "period-doubling and grazing",
        CodimensionTwo::GrazingGrazing => "two maxima graze",
        CodimensionTwo::Cusp => "cusp of a saddle-node curve",
        CodimensionTwo::SaddleNodeTorus => "saddle-node and torus: both multipliers are 1",
        CodimensionTwo::PeriodDoublingTorus => "period-doubling and torus: both multipliers are -1",
        CodimensionTwo::TorusGrazing => "torus and grazing",
    }
}

/// What is known in a region of a kind.
pub const fn region_meaning(kind: RegionKind) -> &'static str {
    match kind {
        RegionKind::NonImpacting => "the non-impacting solution is stable",
        RegionKind::Mps => "a maximal periodic solution is stable",
        RegionKind::Both => "both are stable",
        RegionKind::Undecided => "stability is not decided",
    }
}

/// What a phase portrait of a kind shows.
pub const fn portrait_meaning(kind: PortraitKind) -> &'static str {
    match kind {
        PortraitKind::Periodic => "periodic solution",
        PortraitKind::Attractor => "attractor",
    }
}

/// The words by which tables call kinds of curves, points and portraits, and regions of MPSs, with
/// what they mean.
pub fn meanings() -> Vec<(&'static str, &'static str)> {
    let points = CodimensionTwo::ALL;
    let portraits = [PortraitKind::Periodic, PortraitKind::Attractor];
    let regions = [RegionKind::NonImpacting, RegionKind::Mps, RegionKind::Both, RegionKind::Undecided];
    let mut all = Vec::from(Bifurcation::ALL.map(|kind| (kind.name(), CurveLook::of(kind).meaning)));
    all.extend(points.map(|kind| (kind.name(), point_meaning(kind))));
    all.extend(portraits.map(|kind| (kind.name(), portrait_meaning(kind))));
    all.extend(regions.map(|kind| (kind.name(), region_meaning(kind))));
    all
}
