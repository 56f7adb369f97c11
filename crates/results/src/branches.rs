//! One-parameter diagrams: branches, bifurcations, long-time behaviour and phase portraits.

use grazing_continuation::bifurcation::Bifurcation;

use crate::cell::words;
use crate::table::rows;

words! {
    /// What a phase portrait shows.
    PortraitKind {
        /// A periodic orbit.
        Periodic = "periodic",
        /// What an orbit comes to in the long run.
        Attractor = "attractor",
    }
}

rows! {
    /// A point of a branch, on one of the loops of the solution.
    BranchPoint {
        loops: u32 = LOOPS,
        primary: f64 = PRIMARY,
        x: f64 = X_ON_SECTION,
        visit: u32 = LOOP,
        impact_velocity: f64 = IMPACT_VELOCITY,
        impact_phase: f64 = IMPACT_PHASE,
        stable: bool = STABLE,
        admissible: bool = ADMISSIBLE,
        branch: u32 = BRANCH,
    }

    /// A bifurcation on a branch.
    BranchBifurcation {
        kind: Bifurcation = BIFURCATION,
        loops: u32 = LOOPS,
        primary: f64 = PRIMARY,
        impact_velocity: f64 = IMPACT_VELOCITY,
        x: f64 = X_ON_SECTION,
    }

    /// A visit to Π of an orbit that has settled.
    AttractorPoint {
        primary: f64 = PRIMARY,
        x: f64 = X_ON_SECTION,
    }

    /// A point of an orbit in the (x, y) plane.
    PortraitPoint {
        portrait: u32 = PORTRAIT,
        loops: u32 = LOOPS,
        primary: f64 = PRIMARY,
        kind: PortraitKind = PORTRAIT_KIND,
        time: f64 = TIME,
        x: f64 = X,
        y: f64 = Y,
    }
}
