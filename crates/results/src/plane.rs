//! Two-parameter diagrams, and magnifications of them.

use core::f64::consts::TAU;
use core::fmt::{self, Display, Formatter};

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo, Pair};

use crate::measured::MeasuredPoint;
use crate::{Cell, Dimension, Dimensioned, Field, Frame, Stability, dimensioned, row, rows, tables, words};

words! {
    /// The kinds of regions of the parameter plane, by the solutions that are stable and admissible
    /// there.
    RegionKind {
        /// The non-impacting solution is stable and admissible.
        NonImpacting = "non-impacting",
        /// An MPS is stable and admissible.
        Mps = "mps",
        /// The non-impacting solution and an MPS are both stable and admissible; only sketches have such
        /// a region.
        Both = "both",
        /// A periodic solution with several impacts is stable and admissible.
        SeveralImpacts = "several-impacts",
        /// The stability could not be decided.
        Undecided = "undecided",
    }

    /// The source of a curve in a magnification.
    CurveSource {
        Continuation = "continuation",
        /// The quadratic approximation μ = μ_graz(η) + c (η − η*)².
        Quadratic = "quadratic",
    }
}

rows! {
    /// A place on a curve, with the solution there.
    OnCurve {
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        impact_velocity: f64 = IMPACT_VELOCITY,
        impact_phase: f64 = IMPACT_PHASE,
        trace: f64 = TRACE,
        determinant: f64 = DETERMINANT,
        max_interior_x: f64 = MAX_INTERIOR_X,
        stable: Stability = STABLE,
        admissible: bool = ADMISSIBLE,
        arc: u32 = ARC,
        lost: String = LOST,
    }

    /// A corner of a region.
    RegionCorner {
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        ring: u32 = RING,
        reason: String = REASON,
    }

    /// A point of a curve.
    PlanePoint {
        kind: Bifurcation = BIFURCATION,
        loops: u32 = LOOPS,
        wall: u32 = WALL,
        n: u32 = RESONANCE_INDEX,
        at: OnCurve,
    }

    /// A point of a curve that the file requests.
    OwnPoint {
        name: String = CURVE_NAME,
        property: Property,
        loops: u32 = LOOPS,
        at: OnCurve,
    }

    /// A resonance at which a theorem holds, or another codimension-two point.
    SpecialPoint {
        kind: CodimensionTwo = CODIMENSION_TWO,
        loops: u32 = LOOPS,
        wall: u32 = WALL,
        n: u32 = RESONANCE_INDEX,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
    }

    /// A vertex of a region.
    RegionVertex {
        region: u32 = REGION,
        kind: RegionKind = REGION_KIND,
        loops: u32 = LOOPS,
        wall: u32 = WALL,
        n: u32 = RESONANCE_INDEX,
        at: RegionCorner,
    }

    /// A point of a curve in a magnification about the resonance of p and n.
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

rows! {
    /// A resonance on a curve along which solutions with impacts graze.
    SequenceResonance {
        number: u32 = LATER_NUMBER,
        base_impacts: u32 = LATER_BASE_IMPACTS,
        base_periods: u32 = LATER_BASE_PERIODS,
        rounds: u32 = LATER_ROUNDS,
        impacts: u32 = LATER_IMPACTS,
        periods: u32 = LATER_PERIODS,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        saddle_node: f64 = C_SN,
        period_doubling: f64 = C_PD,
        fails: String = LATER_FAILS,
    }

    /// A point of a curve of solutions with several impacts.
    SequencePoint {
        impacts: u32 = LATER_IMPACTS,
        periods: u32 = LATER_PERIODS,
        walls: WallSequence = LATER_WALLS,
        kind: Bifurcation = BIFURCATION,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        impact_velocity: f64 = LATER_VELOCITY,
        trace: f64 = TRACE,
        determinant: f64 = DETERMINANT,
        max_interior_x: f64 = MAX_INTERIOR_X,
        stable: Stability = STABLE,
        admissible: bool = ADMISSIBLE,
        arc: u32 = ARC,
        lost: String = LOST,
    }

    /// A vertex of a region of solutions with several impacts.
    SequenceVertex {
        region: u32 = REGION,
        kind: RegionKind = REGION_KIND,
        impacts: u32 = LATER_IMPACTS,
        periods: u32 = LATER_PERIODS,
        walls: WallSequence = LATER_WALLS,
        at: RegionCorner,
    }
}

/// A property that holds along a curve that a file requests; all numbers are positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Property {
    /// The impact velocity y.
    ImpactVelocity(f64),
    /// The larger modulus of the two multipliers: the factor by which displacements change in p
    /// forcing periods. The curve consists of pieces on which one multiplier is this, or minus
    /// this, or both are complex with the square of this as their product.
    Modulus(f64),
    /// The distance from the wall, in one of the p periods, when the forcing is at a phase.
    Distance {
        /// The phase, in radians, from 0 to less than 2π.
        phase: f64,
        /// The distance.
        distance: f64,
    },
}

/// The property as text, such as `impact velocity = 0.1`.
impl Display for Property {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::ImpactVelocity(velocity) => write!(formatter, "impact velocity = {velocity}"),
            Self::Modulus(modulus) => write!(formatter, "larger modulus of the multipliers = {modulus}"),
            Self::Distance { phase, distance } => {
                write!(
                    formatter,
                    "distance from the wall = {distance} at {} of the forcing period",
                    phase / TAU
                )
            }
        }
    }
}

impl Dimensioned for Property {
    fn each_number(&mut self, visit: &mut dyn FnMut(Dimension, &mut f64)) {
        match self {
            Self::ImpactVelocity(velocity) => visit(Dimension::of("length/time"), velocity),
            Self::Modulus(_) => {}
            Self::Distance { distance, .. } => visit(Dimension::of("length"), distance),
        }
    }
}

row! { Property, |own| {} [
    PROPERTY = own.to_string(),
] }

/// The walls that the impacts of a solution hit, from 1, one after the other; none with one wall.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WallSequence(pub Vec<usize>);

impl Display for WallSequence {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        let walls: Vec<_> = self.0.iter().map(usize::to_string).collect();
        formatter.write_str(&walls.join("-"))
    }
}

impl Field for WallSequence {}

impl From<WallSequence> for Cell {
    fn from(walls: WallSequence) -> Self {
        walls.to_string().into()
    }
}

impl SequenceVertex {
    /// The name of its region: K/P for K impacts in P forcing periods, between two walls K₁+K₂/P.
    pub fn name(&self) -> String {
        let Self { impacts, periods, walls: WallSequence(walls), .. } = self;
        let at = |wall: usize| walls.iter().filter(|hit| **hit == wall).count();
        if walls.is_empty() {
            format!("{impacts}/{periods}")
        } else {
            format!("{}+{}/{periods}", at(1), at(2))
        }
    }
}

impl RegionCorner {
    /// The border of a region and those of its holes, as (primary, secondary) in order.
    pub fn rings<'a>(corners: impl IntoIterator<Item = &'a Self>) -> Vec<Vec<(f64, f64)>> {
        let corners: Vec<_> = corners.into_iter().collect();
        let rings = corners.chunk_by(|a, b| a.ring == b.ring);
        rings.map(|ring| ring.iter().map(|corner| (corner.primary, corner.secondary)).collect()).collect()
    }
}

impl PlanePoint {
    /// Whether a region may end at a point of a curve. It may not on a grazing curve of an unstable
    /// solution. At an end of a GZ curve, a codimension-two point, stability is marginal and its flag
    /// arbitrary, so a region may end there.
    pub fn bounds(curve: &[Self], index: usize) -> bool {
        let ends = index == 0 || index + 1 == curve.len();
        match curve[index].kind {
            Bifurcation::NonImpactingGrazing => curve[index].at.stable.is_stable(),
            Bifurcation::Grazing => curve[index].at.stable.is_stable() || ends,
            _ => true,
        }
    }
}

rows! {
    /// A point of a curve in straightened coordinates.
    StraightenedPoint {
        panel: u32 = PANEL,
        loops: u32 = LOOPS,
        n: u32 = RESONANCE_INDEX,
        kind: Bifurcation = BIFURCATION,
        arc: u32 = ARC,
        eta: f64 = FROM_RESONANCE,
        distance: f64 = SCALED_DISTANCE,
        error: f64 = RELATIVE_ERROR,
        limit: f64 = SCALED_LIMIT,
    }
}

/// A panel of a magnification.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MagnifiedPanel {
    /// The number of the panel, from 1; the first is (a).
    pub panel: u32,
    /// The part of the plane that the panel shows.
    pub frame: Frame,
    /// The number of loops p of the resonance that the panel is about.
    pub loops: u32,
    /// The wall that the motion grazes there, if there are two; 0 otherwise.
    pub wall: u32,
    /// The integer n of that resonance, if it is to be written.
    pub n: Option<u32>,
    /// c_SN and c_PD, in units of the primary parameter over the square of the secondary one; NaN is not
    /// written.
    pub coefficients: Pair<f64>,
}

// A panel of the plane of the two parameters.
dimensioned! {
    MagnifiedPanel, |own| {
        own.frame,
        own.coefficients.saddle_node => "{primary}/{secondary}^2",
        own.coefficients.period_doubling => "{primary}/{secondary}^2",
    }
}

/// The line along which a one-parameter diagram runs in the plane.
#[derive(Debug, Clone, PartialEq)]
pub struct DiagramLine {
    /// The ends of the line, as (primary, secondary) parameter.
    pub ends: [(f64, f64); 2],
    /// The name of the one-parameter diagram, as `Fig. 2`.
    pub name: String,
    /// Whether to draw the line thin, as one of many that may be long.
    pub thin: bool,
}

dimensioned! {
    DiagramLine, |own| {
        own.ends[0].0 => "{primary}",
        own.ends[0].1 => "{secondary}",
        own.ends[1].0 => "{primary}",
        own.ends[1].1 => "{secondary}",
    }
}

tables! {
    /// The contents of a two-parameter diagram, such as Figure 7.
    PlaneDiagram: Dimensioned {
        /// The curves are the grazing curve of the non-impacting solution and the bifurcation curves of
        /// MPSs. Consecutive points with equal kind, p, n and arc form one curve.
        curves: PlanePoint = "curves", "a point of a curve of the diagram",
        points: SpecialPoint = "points", "a resonance at which a theorem holds, or another codimension-two point" as Points,
        regions: RegionVertex = "regions", "a vertex of a region of stability" as Areas,
        ;
        /// The part of the plane that is shown: primary parameter horizontal, secondary parameter
        /// vertical.
        frame: Frame,
        /// The panels of the magnifications, whose frames are drawn.
        magnified: Vec<MagnifiedPanel>,
        /// The lines along which one-parameter diagrams run.
        sections: Vec<DiagramLine>,
        /// The curves that the file requests.
        own: Vec<OwnPoint>,
        /// The measurements within the diagram.
        measured: Vec<MeasuredPoint>,
        /// Regions of solutions with several impacts.
        several: Vec<SequenceVertex>,
        /// Curves of solutions that hit both of two walls.
        at_both_walls: Vec<PlanePoint>,
    }

    /// Solutions with several impacts.
    SequenceDiagram: Dimensioned {
        resonances: SequenceResonance = "sequence_resonances", "a resonance on a curve along which solutions with impacts graze",
        curves: SequencePoint = "sequence_curves", "a point of a curve of solutions with several impacts",
        regions: SequenceVertex = "sequence_regions", "a vertex of a region of stability of solutions with several impacts" as Areas,
    }

    /// The curves that a file requests.
    OwnCurves: Dimensioned {
        own: OwnPoint = "own_curves", "a point of a curve of `[[curves]]`",
    }

    /// The contents of the magnifications of a two-parameter diagram; Figure 8 is one sheet of them.
    Magnifications: Dimensioned {
        /// The curves are continued curves and quadratic approximations. Consecutive points with equal
        /// panel, kind, source and arc form one curve.
        curves: MagnifiedPoint = "magnifications", "a point of a curve of a magnification",
        ;
        /// The special points of the diagram.
        points: Vec<SpecialPoint>,
        /// The regions of the diagram.
        regions: Vec<RegionVertex>,
        /// The panels in the order in which they are drawn, row by row.
        panels: Vec<MagnifiedPanel>,
    }

    /// The curves that leave resonances, in straightened coordinates: the distance from the grazing curve
    /// over η² on the horizontal axis, η on the vertical one.
    StraightenedCurves {
        /// Consecutive points with equal panel, kind, p and arc form one curve.
        curves: StraightenedPoint = "straightened",
            "a point of a curve that leaves a resonance, in straightened coordinates",
        ;
        /// The panels in the order in which they are drawn, with their frames in these coordinates.
        panels: Vec<MagnifiedPanel>,
    }
}
