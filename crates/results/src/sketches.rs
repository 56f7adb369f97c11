//! Sketches: the boundaries of Figure 4, the unfolding of Figure 5, the oscillator of Figure 6, the
//! path of Figure 10.

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo};

use crate::cell::words;
use crate::plane::RegionKind;
use crate::table::rows;
use crate::{Frame, tables};

words! {
    /// The curves of Figure 4.
    Boundary {
        Trapesium = "trapesium",
        /// τ = 2 √δ, the limit of both families.
        Limit = "limit",
        /// τ = g_p(δ).
        Resonance = "g",
        /// τ = h_p(δ).
        Admissibility = "h",
    }

    /// The parts of the drawing of the oscillator.
    Part {
        /// Behind the anchor.
        AnchorHatching = "anchor hatching",
        /// The line to which spring and dashpot are fixed.
        Anchor = "anchor",
        /// Behind the wall.
        WallHatching = "wall hatching",
        Wall = "wall",
        Floor = "floor",
        /// Lines from the block, the equilibrium and the wall to the axis of x.
        Guide = "guide",
        Axis = "axis",
        Tick = "tick",
        Spring = "spring",
        /// Cylinder, rods and piston are those of the dashpot.
        Cylinder = "cylinder",
        Rod = "rod",
        Piston = "piston",
        Wheel = "wheel",
        Block = "block",
        /// The arrow of the force.
        Force = "force",
        /// The distance between equilibrium and wall.
        Dimension = "dimension",
    }
}

rows! {
    /// A point of a curve of Figure 4.
    BoundaryPoint {
        kind: Boundary = BOUNDARY,
        loops: u32 = LOOPS,
        tau: f64 = TAU,
        delta: f64 = DELTA,
    }

    /// The point that Figure 4 marks.
    Star {
        kind: &'static str = STAR,
        tau: f64 = TAU,
        delta: f64 = DELTA,
    }

    /// A point of a curve of Figure 5.
    UnfoldingPoint {
        kind: Bifurcation = BIFURCATION,
        mu: f64 = MU,
        eta: f64 = ETA,
    }

    /// The resonance of Figure 5.
    UnfoldingResonance {
        kind: CodimensionTwo = CODIMENSION_TWO,
        loops: u32 = LOOPS,
        n: u32 = RESONANCE_INDEX,
        mu: f64 = MU,
        eta: f64 = ETA,
    }

    /// A vertex of a region of Figure 5.
    UnfoldingVertex {
        region: u32 = REGION,
        kind: RegionKind = REGION_KIND,
        mu: f64 = MU,
        eta: f64 = ETA,
    }

    /// A point of the drawing of the oscillator.
    PartPoint {
        part: Part = PART,
        piece: u32 = PIECE,
        x: f64 = X,
        height: f64 = HEIGHT,
    }

    /// A vertex of the path of Figure 10.
    Visit {
        visit: u32 = VISIT,
        u: f64 = U,
        w: f64 = W,
    }
}

tables! {
    /// What Figure 4 shows.
    Figure4 {
        /// The trapesium's outline, the curves τ = g_p(δ) and τ = h_p(δ), and their limit τ = 2√δ. Points that follow each other with
        /// equal kind and p are one curve; the outline is closed, every other curve ends on its top side.
        curves: BoundaryPoint = "fig04_curves", "a point of a curve",
        /// The grazing bifurcation of Figure 2.
        points: Star = "fig04_points", "a point that is marked",
    }

    /// What Figure 5 shows.
    Figure5 {
        /// The line of grazing bifurcations and the quadratic SN and PD curves.
        curves: UnfoldingPoint = "fig05_curves", "a point of a curve",
        points: UnfoldingResonance = "fig05_points", "the resonance",
        /// Where the non-impacting solution is stable, where an MPS is, and where both are.
        regions: UnfoldingVertex = "fig05_regions", "a vertex of a region",
        ;
        /// Values of μ across and of η up.
        frame: Frame,
    }

    /// What Figure 6 shows.
    Figure6 {
        /// The parts of the drawing as polylines of (x, height); outlines end where they begin. The ticks are those of the face, the
        /// equilibrium and the wall.
        parts: PartPoint = "fig06_parts", "a point of the drawing",
    }

    /// What Figure 10 shows.
    Figure10 {
        /// The vertices (u⁽ʲ⁾, w⁽ʲ⁾), j = 0, …, p.
        path: Visit = "fig10_path", "a vertex of the path",
    }
}
