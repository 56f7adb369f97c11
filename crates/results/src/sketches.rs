//! Sketches: the boundaries of Figure 4, the unfolding of Figure 5, the oscillator of Figure 6, the path of Figure 10.

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo};

use crate::cell::words;
use crate::plane::RegionKind;
use crate::table::rows;

words! {
    /// The curves of Figure 4.
    Boundary {
        /// The outline of the trapesium.
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
        /// Hatching behind the anchor.
        AnchorHatching = "anchor hatching",
        /// The line to which spring and dashpot are fixed.
        Anchor = "anchor",
        /// Hatching behind the wall.
        WallHatching = "wall hatching",
        /// The wall.
        Wall = "wall",
        /// The floor.
        Floor = "floor",
        /// Lines from the block, the equilibrium and the wall to the axis.
        Guide = "guide",
        /// The axis of x.
        Axis = "axis",
        /// Its ticks.
        Tick = "tick",
        /// The spring.
        Spring = "spring",
        /// The dashpot's cylinder.
        Cylinder = "cylinder",
        /// The dashpot's rods.
        Rod = "rod",
        /// The dashpot's piston.
        Piston = "piston",
        /// The wheels.
        Wheel = "wheel",
        /// The block.
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
