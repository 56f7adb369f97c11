//! Two-parameter diagrams, and magnifications of them.

use std::mem::swap;

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo, Pair};

use crate::measured::MeasuredPoint;
use crate::{Frame, rows, tables, words};

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
        lost: String = LOST,
    }

    /// A point of a curve that the file asks for.
    OwnPoint {
        name: String = CURVE_NAME,
        property: String = PROPERTY,
        loops: u32 = LOOPS,
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
        lost: String = LOST,
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

impl PlanePoint {
    /// Whether a region may end at a point of a curve: it may not where a grazing curve is that of
    /// an unstable solution. At an end of a GZ curve, a codimension-two point, stability is marginal
    /// and its flag a toss-up.
    pub fn bounds(curve: &[Self], index: usize) -> bool {
        let ends = index == 0 || index + 1 == curve.len();
        match curve[index].kind {
            Bifurcation::NonImpactingGrazing => curve[index].stable,
            Bifurcation::Grazing => curve[index].stable || ends,
            _ => true,
        }
    }
}

impl PlaneDiagram {
    /// The diagram with its axes exchanged: the secondary parameter stands for the primary one.
    #[must_use]
    pub fn swapped(mut self) -> Self {
        self.curves.iter_mut().for_each(|row| swap(&mut row.primary, &mut row.secondary));
        self.points.iter_mut().for_each(|row| swap(&mut row.primary, &mut row.secondary));
        self.regions.iter_mut().for_each(|row| swap(&mut row.primary, &mut row.secondary));
        self.own.iter_mut().for_each(|row| swap(&mut row.primary, &mut row.secondary));
        for row in &mut self.measured {
            swap(&mut row.primary, &mut row.secondary);
            swap(&mut row.primary_error, &mut row.secondary_error);
        }
        self.magnified.iter_mut().for_each(|panel| panel.frame = panel.frame.swapped());
        self.sections.iter_mut().for_each(|section| section.ends = section.ends.map(|(a, b)| (b, a)));
        self.frame = self.frame.swapped();
        self
    }
}

impl Magnifications {
    /// The same with the axes exchanged.
    #[must_use]
    pub fn swapped(mut self) -> Self {
        self.curves.iter_mut().for_each(|row| swap(&mut row.primary, &mut row.secondary));
        self.points.iter_mut().for_each(|row| swap(&mut row.primary, &mut row.secondary));
        self.regions.iter_mut().for_each(|row| swap(&mut row.primary, &mut row.secondary));
        self.panels.iter_mut().for_each(|panel| panel.frame = panel.frame.swapped());
        self
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
    /// Its number, from 1; the letter (a) stands for the first.
    pub panel: u32,
    /// What it shows of the plane.
    pub frame: Frame,
    /// Number of loops p of the resonance about which it is.
    pub loops: u32,
    /// The integer n of that, if it is to be written.
    pub n: Option<u32>,
    /// c_SN and c_PD, in units of the primary parameter over the square of the secondary one; NaN
    /// is left out.
    pub coefficients: Pair<f64>,
}

/// Where a one-parameter diagram runs in the plane.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// The ends of the line: primary and secondary parameter.
    pub ends: [(f64, f64); 2],
    /// What the one-parameter diagram is called, as `Fig. 2`.
    pub name: String,
    /// Whether the line is one of many that may be long: it is thin then.
    pub thin: bool,
}

tables! {
    /// What a two-parameter diagram shows; Figure 7 is one.
    PlaneDiagram {
        /// The grazing curve of the non-impacting solution and the bifurcation curves of MPSs.
        /// Points that follow each other with equal kind, p, n and arc are one curve.
        curves: PlanePoint = "curves", "a point of a curve of the diagram",
        points: SpecialPoint = "points", "a resonance at which a theorem holds, or another codimension-two point",
        regions: RegionVertex = "regions", "a vertex of a region of stability",
        ;
        /// What is shown of the plane: the primary parameter across and the secondary one up.
        frame: Frame,
        /// The panels of its magnifications, whose frames are drawn.
        magnified: Vec<MagnifiedPanel>,
        /// Where one-parameter diagrams run.
        sections: Vec<Section>,
        /// The curves that the file asks for.
        own: Vec<OwnPoint>,
        /// What was measured in it.
        measured: Vec<MeasuredPoint>,
    }

    /// The curves that a file asks for.
    OwnCurves {
        own: OwnPoint = "own_curves", "a point of a curve of `[[curves]]`",
    }

    /// What magnifications of a two-parameter diagram show; Figure 8 is one sheet of them.
    Magnifications {
        /// Continued curves and quadratic approximations. Points that follow each other with equal
        /// panel, kind, source and arc are one curve.
        curves: MagnifiedPoint = "magnifications", "a point of a curve of a magnification",
        ;
        /// The points of the diagram.
        points: Vec<SpecialPoint>,
        /// Its regions.
        regions: Vec<RegionVertex>,
        /// The panels in the order in which they are drawn, row by row.
        panels: Vec<MagnifiedPanel>,
    }

    /// The curves that leave resonances in straightened coordinates: the distance from the grazing
    /// curve over η² across, and η up.
    StraightenedCurves {
        /// Points that follow each other with equal panel, kind, p and arc are one curve.
        curves: StraightenedPoint = "straightened",
            "a point of a curve that leaves a resonance, in straightened coordinates",
        ;
        /// The panels in the order in which they are drawn, with what they show in these
        /// coordinates.
        panels: Vec<MagnifiedPanel>,
    }
}
