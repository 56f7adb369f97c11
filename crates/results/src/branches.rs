//! One-parameter diagrams: branches, bifurcations, long-time behaviour and phase portraits.

use grazing_continuation::bifurcation::Bifurcation;

use crate::cell::words;
use crate::table::rows;
use crate::{Frame, row, tables};

words! {
    /// What a phase portrait shows.
    PortraitKind {
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

/// A one-parameter diagram of an oscillator.
#[derive(Clone, Debug, PartialEq)]
pub struct OneParameter {
    /// Its number, from 1.
    pub diagram: u32,
    /// The primary parameter is held, and the secondary one across, which is the `primary` of its rows then.
    pub primary_is_fixed: bool,
    /// The value of the parameter that is held.
    pub at: f64,
    /// The other parameter across and x on Π up.
    pub frame: Frame,
    /// x is counted from the wall, which is another one than x = 0 with the motion below it.
    pub from_the_wall: bool,
    /// As those of [`Figure2`], but that `impact_phase` is z itself.
    pub branches: Vec<BranchPoint>,
    /// Likewise.
    pub bifurcations: Vec<BranchBifurcation>,
    /// Likewise.
    pub attractor: Vec<AttractorPoint>,
    /// Likewise; there may be none.
    pub portraits: Vec<PortraitPoint>,
    /// The number of simulated orbits that left no point, as they came to rest or could not be followed, and of all; none if simulation was not finished.
    pub resting: Option<[u32; 2]>,
    /// Where a branch of MPSs could not be followed to its end: p, the parameter across, and what happened.
    pub broken: Vec<(u32, f64, String)>,
}

impl OneParameter {
    /// Of what belongs to the primary and the secondary parameter: first that of the one across, then that of the one that is held.
    /// And back.
    pub fn exchanged<T>(&self, [first, second]: [T; 2]) -> [T; 2] {
        if self.primary_is_fixed { [second, first] } else { [first, second] }
    }
}

/// A row of a one-parameter diagram among those of others.
#[derive(Clone, Debug, PartialEq)]
pub struct InDiagram<R> {
    diagram: u32,
    /// Primary and secondary parameter.
    parameters: [f64; 2],
    row: R,
}

row! { InDiagram<BranchPoint>, |at| { let row = &at.row; } [
    DIAGRAM = at.diagram,
    LOOPS = row.loops,
    SECONDARY = at.parameters[1],
    PRIMARY = at.parameters[0],
    X_ON_SECTION = row.x,
    LOOP = row.visit,
    IMPACT_VELOCITY = row.impact_velocity,
    PHASE_OF_IMPACT = row.impact_phase,
    STABLE = row.stable,
    ADMISSIBLE = row.admissible,
    BRANCH = row.branch,
] }

row! { InDiagram<BranchBifurcation>, |at| { let row = &at.row; } [
    DIAGRAM = at.diagram,
    BIFURCATION = row.kind,
    LOOPS = row.loops,
    SECONDARY = at.parameters[1],
    PRIMARY = at.parameters[0],
    IMPACT_VELOCITY = row.impact_velocity,
    X_ON_SECTION = row.x,
] }

row! { InDiagram<AttractorPoint>, |at| {} [
    DIAGRAM = at.diagram,
    SECONDARY = at.parameters[1],
    PRIMARY = at.parameters[0],
    X_ON_SECTION = at.row.x,
] }

row! { InDiagram<PortraitPoint>, |at| { let row = &at.row; } [
    DIAGRAM = at.diagram,
    PORTRAIT = row.portrait,
    LOOPS = row.loops,
    SECONDARY = at.parameters[1],
    PRIMARY = at.parameters[0],
    PORTRAIT_KIND = row.kind,
    TIME = row.time,
    X = row.x,
    Y = row.y,
] }

tables! {
    /// What all one-parameter diagrams of an oscillator show.
    OneParameterRows {
        branches: InDiagram<BranchPoint> = "diagram_branches",
            "a point of a branch of a one-parameter diagram, on one loop of the solution",
        bifurcations: InDiagram<BranchBifurcation> = "diagram_bifurcations", "a bifurcation on such a branch",
        attractor: InDiagram<AttractorPoint> = "diagram_attractor",
            "a visit to Π of an orbit that has settled, from a random state",
        portraits: InDiagram<PortraitPoint> = "diagram_portraits",
            "a point of an orbit in a phase portrait of a one-parameter diagram",
    }
}

impl OneParameterRows {
    /// The rows of these diagrams.
    pub fn of(diagrams: &[OneParameter]) -> Self {
        fn gathered<R: Clone>(
            diagrams: &[OneParameter],
            rows: impl Fn(&OneParameter) -> &[R],
            across: impl Fn(&R) -> f64,
        ) -> Vec<InDiagram<R>> {
            let mut all = Vec::new();
            for diagram in diagrams {
                all.extend(rows(diagram).iter().map(|row| InDiagram {
                    diagram: diagram.diagram,
                    parameters: diagram.exchanged([across(row), diagram.at]),
                    row: row.clone(),
                }));
            }
            all
        }
        Self {
            branches: gathered(diagrams, |diagram| &diagram.branches, |row| row.primary),
            bifurcations: gathered(diagrams, |diagram| &diagram.bifurcations, |row| row.primary),
            attractor: gathered(diagrams, |diagram| &diagram.attractor, |row| row.primary),
            portraits: gathered(diagrams, |diagram| &diagram.portraits, |row| row.primary),
        }
    }
}
