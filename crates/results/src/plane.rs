//! Two-parameter diagrams, and magnifications of them.

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo};

use crate::cell::words;
use crate::table::rows;

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
    Source {
        /// It was continued.
        Continuation = "continuation",
        /// It is the quadratic approximation μ = μ_graz(η) + c (η − η*)².
        Quadratic = "quadratic",
    }
}

rows! {
    /// A point of a curve.
    CurvePoint {
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
        source: Source = SOURCE,
        arc: u32 = ARC,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
    }
}
