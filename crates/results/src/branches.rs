//! One-parameter diagrams: branches, bifurcations, long-time behaviour and phase portraits.

use grazing_continuation::bifurcation::Bifurcation;

use crate::readings::{MotionReading, Ordinate, Reading};
use crate::{Frame, Names, Table, Tables, rows, tables, words};

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
        diagram: u32 = DIAGRAM,
        loops: u32 = LOOPS,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        x: f64 = X_ON_SECTION,
        visit: u32 = LOOP,
        impact_velocity: f64 = IMPACT_VELOCITY,
        impact_phase: f64 = PHASE_OF_IMPACT,
        stable: bool = STABLE,
        admissible: bool = ADMISSIBLE,
        branch: u32 = BRANCH,
    }

    /// A bifurcation on a branch.
    BranchBifurcation {
        diagram: u32 = DIAGRAM,
        kind: Bifurcation = BIFURCATION,
        loops: u32 = LOOPS,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        impact_velocity: f64 = IMPACT_VELOCITY,
        x: f64 = X_ON_SECTION,
    }

    /// A visit to Π of an orbit that has settled.
    AttractorPoint {
        diagram: u32 = DIAGRAM,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        x: f64 = X_ON_SECTION,
    }

    /// A point of an orbit in the (x, y) plane.
    PortraitPoint {
        diagram: u32 = DIAGRAM,
        portrait: u32 = PORTRAIT,
        loops: u32 = LOOPS,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        kind: PortraitKind = PORTRAIT_KIND,
        time: f64 = TIME,
        x: f64 = X,
        y: f64 = Y,
    }
}

/// A row of a one-parameter diagram, whatever it is.
pub trait DiagramRow {
    /// Primary and secondary parameter.
    fn parameters(&self) -> [f64; 2];

    /// Puts others in their place.
    fn set_parameters(&mut self, parameters: [f64; 2]);

    /// Puts it into the diagram of a number, and its parameters into each other's place if they are
    /// exchanged.
    fn place(&mut self, diagram: u32, exchanged: bool);
}

macro_rules! diagram_rows {
    ($($row:ident),+) => {$(
        impl DiagramRow for $row {
            fn parameters(&self) -> [f64; 2] {
                [self.primary, self.secondary]
            }

            fn set_parameters(&mut self, parameters: [f64; 2]) {
                [self.primary, self.secondary] = parameters;
            }

            fn place(&mut self, diagram: u32, exchanged: bool) {
                self.diagram = diagram;
                if exchanged {
                    core::mem::swap(&mut self.primary, &mut self.secondary);
                }
            }
        }
    )+};
}

diagram_rows!(BranchPoint, BranchBifurcation, AttractorPoint, PortraitPoint, Reading, MotionReading);

tables! {
    /// A one-parameter diagram of an oscillator; Figure 2 is one.
    OneParameter {
        /// Those of p = 0 are non-impacting. Points that follow each other with equal p and branch
        /// are one curve.
        branches: BranchPoint = "diagram_branches",
            "a point of a branch of a one-parameter diagram, on one loop of the solution",
        /// They are of admissible solutions.
        bifurcations: BranchBifurcation = "diagram_bifurcations", "a bifurcation on such a branch",
        attractor: AttractorPoint = "diagram_attractor",
            "a visit to Π of an orbit that has settled, from a random state",
        /// Points are in order of time; one that is NaN breaks the line. There may be none.
        portraits: PortraitPoint = "diagram_portraits",
            "a point of an orbit in a phase portrait of a one-parameter diagram",
        ;
        /// Its number, from 1.
        diagram: u32,
        /// The primary parameter is held, and the secondary one across.
        primary_is_fixed: bool,
        /// The value of the parameter that is held.
        at: f64,
        /// The other parameter across and x on Π up.
        frame: Frame,
        /// The part of it that is magnified beside it, if any.
        magnified: Option<Frame>,
        /// x is counted from the wall, which is another one than x = 0 with the motion below it.
        from_the_wall: bool,
        /// What is on its vertical axis,
        ordinate: Ordinate,
        /// and what can be, along branches and of simulated motion, where that is asked for.
        readings: Vec<Reading>,
        /// Rows with equal sweep, parameters and orbit are one orbit.
        motion: Vec<MotionReading>,
        /// The number of simulated orbits that left no point, as they came to rest or could not be
        /// followed, and of all; none if simulation was not finished.
        resting: Option<[u32; 2]>,
        /// Where a branch of MPSs could not be followed to its end: p, the parameter across, and
        /// what happened.
        broken: Vec<(u32, f64, String)>,
        /// What is shown elsewhere than asked for, or not at all, in sentences.
        notes: Vec<String>,
    }
}

tables! {
    /// What else is read off one-parameter diagrams.
    Readings {
        readings: Reading = "diagram_readings", "a solution on a branch of a one-parameter diagram, with what is read off it",
        motion: MotionReading = "diagram_motion",
            "an impact of simulated motion that has settled, or motion without impacts, with what is read off it",
    }
}

/// Room below the lowest and above the highest point that is shown, as a part of the height
/// between.
const MARGIN: f64 = 0.06;

impl OneParameter {
    /// The tables of these diagrams, with these names of the parameters.
    pub fn tables_of(diagrams: &[Self], names: &Names) -> Vec<Table> {
        let [branches, bifurcations, attractor, portraits] = [0, 1, 2, 3].map(|k| Self::TABLES[k].name);
        vec![
            Table::new(branches, names, diagrams.iter().flat_map(|diagram| &diagram.branches)),
            Table::new(bifurcations, names, diagrams.iter().flat_map(|diagram| &diagram.bifurcations)),
            Table::new(attractor, names, diagrams.iter().flat_map(|diagram| &diagram.attractor)),
            Table::new(portraits, names, diagrams.iter().flat_map(|diagram| &diagram.portraits)),
        ]
    }

    /// Of what belongs to the primary and the secondary parameter: first that of the one across,
    /// then that of the one that is held. And back.
    pub fn exchanged<T>(&self, [first, second]: [T; 2]) -> [T; 2] {
        if self.primary_is_fixed { [second, first] } else { [first, second] }
    }

    /// The parameter across of a row.
    pub fn across(&self, row: &impl DiagramRow) -> f64 {
        let [across, _] = self.exchanged(row.parameters());
        across
    }

    /// Changes all rows.
    pub fn each_row(&mut self, change: &mut dyn FnMut(&mut dyn DiagramRow)) {
        self.branches.iter_mut().for_each(|row| change(row));
        self.bifurcations.iter_mut().for_each(|row| change(row));
        self.attractor.iter_mut().for_each(|row| change(row));
        self.portraits.iter_mut().for_each(|row| change(row));
        self.readings.iter_mut().for_each(|row| change(row));
        self.motion.iter_mut().for_each(|row| change(row));
    }

    /// The same with a frame that is as high as what it shows needs; lengths have no dimension.
    #[must_use]
    pub fn fitted(mut self) -> Self {
        let [low, high] = self.frame.x;
        let inside = |across: f64| low <= across && across <= high;
        let on_branches =
            self.branches.iter().filter(|point| point.admissible && inside(self.across(*point)));
        let shown = on_branches.map(|point| point.x).chain(self.attractor.iter().map(|point| point.x));
        let [lowest, highest] =
            shown.fold([0.0, 0.0], |[least, most]: [f64; 2], x| [least.min(x), most.max(x)]);
        let margin = MARGIN * if highest > lowest { highest - lowest } else { 1.0 };
        self.frame.y = [lowest - margin, highest + margin];
        self
    }
}
