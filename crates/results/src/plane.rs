//! Two-parameter diagrams, and magnifications of them.

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo, Pair};

use crate::cell::words;
use crate::table::rows;
use crate::{Frame, tables};

words! {
    /// What is known of a region of the parameter plane.
    RegionKind {
        /// The non-impacting solution is stable and admissible.
        NonImpacting = "non-impacting",
        /// An MPS is stable and admissible.
        Mps = "mps",
        /// Both are; only sketches have such a region.
        Both = "both",
        /// It could not be decided.
        Undecided = "undecided",
    }

    /// Where a curve of a magnification comes from.
    CurveSource {
        Continuation = "continuation",
        /// It is the quadratic approximation μ = μ_graz(η) + c (η − η*)².
        Quadratic = "quadratic",
    }
}

rows! {
    /// A point of a curve.
    PlanePoint {
        kind: Bifurcation = BIFURCATION,
        loops: u32 = LOOPS,
        n: u32 = RESONANCE_INDEX,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        impact_velocity: f64 = IMPACT_VELOCITY,
        impact_phase: f64 = IMPACT_PHASE,
        trace: f64 = TRACE,
        determinant: f64 = DETERMINANT,
        max_interior_x: f64 = MAX_INTERIOR_X,
        stable: bool = STABLE,
        admissible: bool = ADMISSIBLE,
        arc: u32 = ARC,
    }

    /// A resonance at which a theorem holds, or another codimension-two point.
    SpecialPoint {
        kind: CodimensionTwo = CODIMENSION_TWO,
        loops: u32 = LOOPS,
        n: u32 = RESONANCE_INDEX,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
    }

    /// A vertex of a region.
    RegionVertex {
        region: u32 = REGION,
        kind: RegionKind = REGION_KIND,
        loops: u32 = LOOPS,
        n: u32 = RESONANCE_INDEX,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        ring: u32 = RING,
        reason: String = REASON,
    }

    /// A point of a curve of a magnification about the resonance of p and n.
    MagnifiedPoint {
        panel: u32 = PANEL,
        loops: u32 = LOOPS,
        n: u32 = RESONANCE_INDEX,
        kind: Bifurcation = BIFURCATION,
        source: CurveSource = SOURCE,
        arc: u32 = ARC,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
    }
}

/// A panel of a magnification.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MagnifiedPanel {
    /// Its number, from 1; the letter (a) stands for the first.
    pub panel: u32,
    /// What it shows of the plane.
    pub frame: Frame,
    /// Number of loops p of the resonance about which it is.
    pub loops: u32,
    /// The integer n of that, if it is to be written.
    pub n: Option<u32>,
    /// c_SN and c_PD, in units of the primary parameter over the square of the secondary one; NaN is left out.
    pub coefficients: Pair<f64>,
}

tables! {
    /// What Figure 7 shows.
    Figure7 {
        /// The grazing curve of the non-impacting solution and the bifurcation curves of MPSs.
        curves: PlanePoint = "fig07_curves", "a point of a curve of the diagram",
        points: SpecialPoint = "fig07_points", "a resonance at which a theorem holds, or another codimension-two point",
        regions: RegionVertex = "fig07_regions", "a vertex of a region of stability",
        ;
        /// Amplitudes across and frequencies up.
        frame: Frame,
        /// The amplitudes and the frequency of Figure 2, if that can be made.
        section: Option<([f64; 2], f64)>,
        /// The panels of Figure 8, as far as they can be made.
        magnified: Vec<MagnifiedPanel>,
        /// What it lacks, in sentences.
        gaps: Vec<String>,
        /// What could not be decided, in sentences.
        notes: Vec<String>,
    }

    /// What Figure 8 shows.
    Figure8 {
        /// Continued curves and quadratic approximations, panel by panel.
        curves: MagnifiedPoint = "fig08_curves", "a point of a curve of a magnification",
        ;
        /// The points of Figure 7.
        points: Vec<SpecialPoint>,
        /// Its regions.
        regions: Vec<RegionVertex>,
        /// The panels, one to three.
        panels: Vec<MagnifiedPanel>,
        /// What is shown in the place of something else, in sentences.
        notes: Vec<String>,
    }
}
