//! One-parameter diagrams: branches, bifurcations, long-time behaviour and phase portraits.

use grazing_continuation::bifurcation::Bifurcation;

use crate::cell::words;
use crate::table::rows;
use crate::{Frame, tables};

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

tables! {
    /// What Figure 2 shows.
    Figure2 {
        /// The non-impacting solution (p = 0) and the branches of MPSs. Points that follow each other with equal p and branch are one curve.
        branches: BranchPoint = "fig02_branches", "a point of a branch, on one loop of the solution",
        /// Grazing of the non-impacting solution, PD, SN and GZ of MPSs.
        bifurcations: BranchBifurcation = "fig02_bifurcations", "a bifurcation on a branch",
        /// Long-time behaviour of forward orbits between GZ and PD.
        attractor: AttractorPoint = "fig02_attractor", "a visit to Π of an orbit that has settled",
        /// Orbits in the (x, y) plane, in order of time; a point that is NaN breaks the line.
        portraits: PortraitPoint = "fig02_portraits", "a point of an orbit in a phase portrait",
        ;
        /// Amplitudes across and x on Π up.
        frame: Frame,
        /// The part of it that is magnified.
        magnified: Frame,
        /// What is shown elsewhere than the parameters ask for, or not at all, in sentences.
        notes: Vec<String>,
    }
}
