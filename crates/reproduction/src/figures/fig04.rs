//! Figure 4 (fig:D): the boundaries g_p and h_p in the trapesium of stable, orientation-preserving
//! grazing orbits.

mod ink;

use grazing_input::kind::counts;
use grazing_results::{rows, tables, words};
use grazing_theorems::admissibility_boundary::admissibility_boundary;
use grazing_theorems::auxiliary::resonance_boundary;

use super::fig02;
use crate::figure::prelude::*;
use crate::parameters::limits::MOST_LOOPS;

/// The number of samples of each curve.
const SAMPLES: u32 = 200;

/// The corners (τ, δ) of the trapesium. Paper: eq:cT.
const CORNERS: [[f64; 2]; 4] = [[-1.0, 0.0], [1.0, 0.0], [2.0, 1.0], [-2.0, 1.0]];

keys! {
    /// Figure 4: the boundaries g_p and h_p in the trapesium.
    pub struct Figure4 {
        /// The numbers of loops p whose boundaries are drawn.
        loops: Vec<u32> = counts(2..=MOST_LOOPS),
            "the numbers of loops must be a list of different whole numbers from {} to {}, as [2, 3, 4]";
    }
}

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
}

tables! {
    /// The contents of Figure 4.
    Boundaries {
        /// The curves are the trapesium's outline, τ = g_p(δ), τ = h_p(δ), and their limit τ = 2√δ.
        /// Consecutive points with equal kind and p form one curve; the outline is closed, every other
        /// curve ends on its top side.
        curves: BoundaryPoint = "fig04_curves", "a point of a curve",
        /// The point is the grazing bifurcation of Figure 2.
        points: Star = "fig04_points", "a point that is marked" as Points,
    }
}

impl FileSection for Figure4 {
    const NAME: &'static str = "fig04";
    const REQUIREMENT: &'static str = "the table [fig04] says what Figure 4 shows";
}

impl StudyFigure for Figure4 {
    const LABEL: &'static str = "fig:D";
    const TITLE: Title<&'static str> = Title::figure(4, "the boundaries g_p and h_p in the trapesium");
    const TABLES: &'static [TablePlan] = Boundaries::TABLES;
    const REMEDY: &'static str = "fig04.loops";
    type Shown = Boundaries;

    fn compute(&self, study: &Study) -> Result<Boundaries, StudyError> {
        let mut curves = Vec::new();
        for [tau, delta] in CORNERS.into_iter().chain([CORNERS[0]]) {
            curves.push(BoundaryPoint { kind: Boundary::Trapesium, loops: 0, tau, delta });
        }
        // The limit of both families as p grows: the cosine in eq:gp tends to 1, and h_p lies
        // between two of the g.
        sample(&mut curves, Boundary::Limit, 0, |delta| Ok(2.0 * delta.sqrt()))?;
        for &p in &self.loops {
            sample(&mut curves, Boundary::Resonance, p, |delta| Ok(resonance_boundary(f64::from(p), delta)))?;
            sample(&mut curves, Boundary::Admissibility, p, |delta| {
                extended_admissibility_boundary(p, delta)
            })?;
        }

        let oscillator = study.parameters.oscillator()?;
        let grazing = oscillator.grazing(fig02::frequency(&study.parameters)?)?;
        let star = Star { kind: "fig02", tau: grazing.trace(), delta: grazing.determinant() };
        Ok(Boundaries { curves, points: vec![star] })
    }

    fn draw(shown: &Boundaries, width: SheetWidth) -> Result<Sheet, DrawingError> {
        ink::draw(shown, width)
    }
}

/// One curve from δ = 0 to δ = 1, sampled evenly in √δ: near δ = 0 the curves are parabolas about the
/// τ-axis.
fn sample(
    curves: &mut Vec<BoundaryPoint>,
    kind: Boundary,
    loops: u32,
    tau: impl Fn(f64) -> Result<f64, StudyError>,
) -> Result<(), StudyError> {
    for k in 0..=SAMPLES {
        let root = f64::from(k) / f64::from(SAMPLES);
        let delta = root * root;
        curves.push(BoundaryPoint { kind, loops, tau: tau(delta)?, delta });
    }
    Ok(())
}

/// h_p(δ), with its limits at the ends of 0 < δ < 1, outside which h_p is not defined.
///
/// As δ → 0, h_p tends to 0, since [`le:admissibilityBoundary`](admissibility_boundary) bounds it on both
/// sides. At δ = 1
/// the eigenvalues are e^{±iθ}, the sum H_p is T_p, which is sin((p−1)θ/2) sin(pθ/2) / (sin(θ/2)
/// sin θ), and its largest zero τ = 2 cos θ is at θ = 2π/p: the limit is g_{p/2}(1).
fn extended_admissibility_boundary(p: u32, delta: f64) -> Result<f64, StudyError> {
    if delta == 0.0 {
        return Ok(0.0);
    }
    if delta == 1.0 {
        return Ok(resonance_boundary(0.5 * f64::from(p), 1.0));
    }
    Ok(admissibility_boundary(p, delta)?)
}
