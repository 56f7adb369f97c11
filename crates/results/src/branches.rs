//! One-parameter diagrams: branches, bifurcations, long-time behaviour and phase portraits.

use grazing_continuation::bifurcation::Bifurcation;

use crate::readings::{MotionReading, Ordinate, Reading, Sweep};
use crate::{Dimension, Dimensioned, Frame, Stability, columns, rows, tables, words};

words! {
    /// The kinds of phase portraits.
    PortraitKind {
        Periodic = "periodic",
        /// An attractor: the long-term behaviour of an orbit.
        Attractor = "attractor",
    }
}

rows! {
    /// A point of a branch, on one of the loops of the solution.
    BranchPoint {
        diagram: u32 = DIAGRAM,
        loops: u32 = LOOPS,
        impacts: u32 = SOLUTION_IMPACTS,
        wall: u32 = WALL,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        x: f64 = X_ON_SECTION,
        visit: u32 = LOOP,
        impact_velocity: f64 = IMPACT_VELOCITY,
        impact_phase: f64 = PHASE_OF_IMPACT,
        stable: Stability = STABLE,
        admissible: bool = ADMISSIBLE,
        branch: u32 = BRANCH,
    }

    /// A bifurcation on a branch.
    BranchBifurcation {
        diagram: u32 = DIAGRAM,
        kind: Bifurcation = BIFURCATION,
        loops: u32 = LOOPS,
        impacts: u32 = SOLUTION_IMPACTS,
        wall: u32 = WALL,
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

/// A row of a one-parameter diagram, of any type.
pub trait DiagramRow: Dimensioned {
    /// Primary and secondary parameter.
    fn parameters(&self) -> [f64; 2];

    /// Assigns the row to the diagram with this number, and exchanges its two parameters if `exchanged`.
    fn place(&mut self, diagram: u32, exchanged: bool);
}

macro_rules! diagram_rows {
    ($($row:ident),+) => {$(
        impl DiagramRow for $row {
            fn parameters(&self) -> [f64; 2] {
                [self.primary, self.secondary]
            }

            fn place(&mut self, diagram: u32, exchanged: bool) {
                self.diagram = diagram;
                if exchanged {
                    self.exchange();
                }
            }
        }
    )+};
}

diagram_rows!(BranchPoint, BranchBifurcation, AttractorPoint, PortraitPoint, Reading, MotionReading);

/// Numbers of simulated orbits, and of those among them that leave no points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Orbits {
    /// All orbits.
    pub all: u32,
    /// Orbits that rest at the wall, where the force holds them for a whole period.
    pub resting: u32,
    /// Orbits that cannot be followed.
    pub escaping: u32,
}

impl Orbits {
    /// The sums of the numbers.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            all: self.all + other.all,
            resting: self.resting + other.resting,
            escaping: self.escaping + other.escaping,
        }
    }

    /// The orbits that are left out, in words, by reason.
    pub fn left_out(&self) -> Vec<String> {
        let Self { all, resting, escaping } = *self;
        let reasons = [
            (resting, "the force holds them at rest at the wall"),
            (escaping, "they run away, or cannot be followed"),
        ];
        let some = reasons.into_iter().filter(|(count, _)| *count > 0);
        some.map(|(count, reason)| format!("{count} of {all} simulated orbits: {reason}")).collect()
    }
}

tables! {
    /// A one-parameter diagram of an oscillator; Figure 2 is one.
    OneParameter {
        /// Branches with p = 0 are non-impacting. Consecutive points with equal p, impacts and branch form
        /// one curve.
        branches: BranchPoint = "diagram_branches",
            "a point of a branch of a one-parameter diagram, on one loop of the solution",
        /// They are of admissible solutions.
        bifurcations: BranchBifurcation = "diagram_bifurcations", "a bifurcation on a branch of a one-parameter diagram",
        attractor: AttractorPoint = "diagram_attractor",
            "a visit to Π by an orbit from a random state, after transients" as Cloud,
        /// Points are in order of time; one that is NaN breaks the line. There may be none.
        portraits: PortraitPoint = "diagram_portraits",
            "a point of an orbit in a phase portrait of a one-parameter diagram",
        ;
        /// The number of the diagram, from 1.
        diagram: u32,
        /// Whether the primary parameter is fixed and the secondary one is on the horizontal axis.
        primary_is_fixed: bool,
        /// The value of the fixed parameter.
        at: f64,
        /// The part that is shown: the varying parameter on the horizontal axis, x on Π on the vertical
        /// one.
        frame: Frame,
        /// The part of the frame that is magnified beside it, if any.
        magnified: Option<Frame>,
        /// Whether x is measured from the wall because the wall is not at x = 0 with the motion below it.
        from_the_wall: bool,
        /// The quantity on the vertical axis.
        ordinate: Ordinate,
        /// The quantities that can be on the vertical axis, along branches; empty unless requested.
        readings: Vec<Reading>,
        /// The quantities of simulated motion, likewise; rows with equal sweep, parameters and orbit form one
        /// orbit.
        motion: Vec<MotionReading>,
        /// The numbers of simulated orbits; none if the simulation was not completed.
        simulated: Option<Orbits>,
        /// Branches of solutions with impacts that could not be followed to their end: the numbers of impacts
        /// and of forcing periods, the varying parameter there, and the reason.
        broken: Vec<([u32; 2], f64, String)>,
        /// Sentences about items that are shown elsewhere than requested, or not at all.
        notes: Vec<String>,
    }
}

tables! {
    /// Further quantities along the branches of one-parameter diagrams and in simulated motion.
    Readings {
        readings: Reading = "diagram_readings", "a solution on a branch of a one-parameter diagram, with quantities derived from it",
        motion: MotionReading = "diagram_motion",
            "an impact of simulated motion after transients, or motion without impacts, with quantities derived from it",
    }
}

impl Dimensioned for OneParameter {
    fn each_number(&mut self, visit: &mut dyn FnMut(Dimension, &mut f64)) {
        self.each_row(&mut |row| row.each_number(visit));
        let [across, held] =
            self.exchanged([columns::PRIMARY, columns::SECONDARY].map(|column| column.dimension));
        visit(held, &mut self.at);
        for frame in self.magnified.iter_mut().chain([&mut self.frame]) {
            frame.x.iter_mut().for_each(|end| visit(across, end));
            frame.y.iter_mut().for_each(|end| visit(columns::X.dimension, end));
        }
        self.broken.iter_mut().for_each(|(_, at, _)| visit(across, at));
    }
}

/// Room below the lowest and above the highest point shown, as a fraction of the height between them.
const MARGIN: f64 = 0.06;

impl OneParameter {
    /// Reorders a pair from (primary, secondary) to (varying, fixed) parameter, or back.
    pub fn exchanged<T>(&self, [first, second]: [T; 2]) -> [T; 2] {
        if self.primary_is_fixed { [second, first] } else { [first, second] }
    }

    /// The value in a row of the parameter on the horizontal axis.
    pub fn across(&self, row: &impl DiagramRow) -> f64 {
        let [across, _] = self.exchanged(row.parameters());
        across
    }

    /// Applies a change to every row.
    pub fn each_row(&mut self, change: &mut dyn FnMut(&mut dyn DiagramRow)) {
        self.branches.iter_mut().for_each(|row| change(row));
        self.bifurcations.iter_mut().for_each(|row| change(row));
        self.attractor.iter_mut().for_each(|row| change(row));
        self.portraits.iter_mut().for_each(|row| change(row));
        self.readings.iter_mut().for_each(|row| change(row));
        self.motion.iter_mut().for_each(|row| change(row));
    }

    /// The diagram with the height of its frame fitted to the points shown; lengths are dimensionless.
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

    /// The diagram with the chosen ordinate in place of x.
    #[must_use]
    pub fn seen(&self) -> Self {
        let ordinate = self.ordinate;
        if ordinate == Ordinate::X {
            return self.clone();
        }
        let point = |row: &Reading| BranchPoint {
            diagram: row.diagram,
            loops: row.loops,
            impacts: row.impacts,
            wall: row.wall,
            secondary: row.secondary,
            primary: row.primary,
            x: row.read(ordinate),
            visit: 1,
            impact_velocity: row.impact_velocity,
            impact_phase: row.impact_phase,
            stable: row.stable,
            admissible: row.admissible,
            branch: row.branch,
        };
        let mut seen = self.clone();
        seen.branches = self.readings.iter().map(point).collect();
        for found in &mut seen.bifurcations {
            // A bifurcation is also a point of a branch; the ordinate is that of the nearest reading.
            let far = |row: &Reading| {
                let velocity = row.impact_velocity - found.impact_velocity;
                let aside = [row.primary - found.primary, row.secondary - found.secondary].map(f64::abs);
                aside[0] + aside[1] + if velocity.is_nan() { 0.0 } else { velocity.abs() }
            };
            let same =
                self.readings.iter().filter(|row| (row.loops, row.impacts) == (found.loops, found.impacts));
            let nearest = same.min_by(|a, b| far(a).total_cmp(&far(b)));
            found.x = nearest.map_or(f64::NAN, |row| row.read(ordinate));
        }
        let random = self.motion.iter().filter(|row| row.sweep == Sweep::Random);
        let dot = |row: &MotionReading| AttractorPoint {
            diagram: row.diagram,
            secondary: row.secondary,
            primary: row.primary,
            x: row.read(ordinate),
        };
        seen.attractor = random.map(dot).collect();
        seen.fitted()
    }

    /// The varying parameter and the ordinate of simulated motion for one kind of sweep.
    pub fn swept(&self, sweep: Sweep) -> impl Iterator<Item = (f64, f64)> {
        let rows = self.motion.iter().filter(move |row| row.sweep == sweep);
        rows.map(|row| (self.across(row), row.read(self.ordinate))).filter(|(_, value)| value.is_finite())
    }
}
