//! Figure 5 (fig:E): the quadratic unfolding of a resonant grazing bifurcation in the case c_SN < 0
//! < c_PD, β > 0.
//!
//! The curves are those of Theorems 2.4 and 2.5 at a resonance of the linear oscillator, without the
//! O(η³) terms.
//!
//! # Where a p-loop MPS is stable
//!
//! Near the resonance the MPSs are μ = k₂ y² + k₃ η y with impact velocity y > 0 (eq:ZM), and to
//! leading order a multiplier is +1 where y = Υ⁺η and −1 where y = Υ⁻η (eq:Upsilon1, eq:Upsilonp):
//! y (T − D − 1) = s⁺ (y − Υ⁺η) and y (T + D + 1) = s⁻ (y − Υ⁻η). An MPS is stable where the first
//! is negative and the second positive (D < 1 there, by eq:yD1 and eq:yDp). In the case s⁺ < 0 < s⁻
//! that is y > Υ⁺η and y > Υ⁻η, of which one bound is positive and one negative, whatever the sign
//! of η, since Υ⁺ and Υ⁻ are inversely proportional to s⁺ and s⁻. Where k₂ > 0, which here means
//! β > 0, μ has its least value over y at y = Υ⁺η and grows beyond. So there is exactly one stable
//! MPS where μ > c_SN η² on the side of η with the saddle-node curve, and where μ > c_PD η² on the
//! other side: one region, beyond the grazing line but for the strip between it and the saddle-node
//! curve, where the non-impacting solution is stable too.

mod ink;

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo};
use grazing_input::kind::count;
use grazing_results::plane::RegionKind;
use grazing_results::{Frame, rows, tables};
use grazing_theorems::ResonantGrazing;
use grazing_theorems::resonant_theorem::BifurcationCurve;

use crate::figure::prelude::*;
use crate::parameters::limits::{INDEX, MOST_LOOPS, MOST_N, around_zero};

/// The number of samples of a curve from the resonance to the edge of the window.
const SAMPLES: u32 = 100;

/// The |κ_p| or |a₁₂| that counts as zero in the closed form of a resonance, as in the theorem's own
/// example.
const RESONANCE_TOLERANCE: f64 = 1e-12;

keys! {
    /// Figure 5: the unfolding of one resonance.
    ///
    /// Any will do: at all resonances of the linear oscillator s_p⁺ < 0 < s_p⁻ (both are squares up
    /// to their signs, by eq:impFormula1odd to eq:impFormulap) and β > 0, so that c_SN < 0 < c_PD,
    /// as the caption has it, and the curves lie on opposite sides of η = 0.
    pub struct Figure5 {
        /// The loops p of the resonance.
        loops: u32 = count(1..=MOST_LOOPS), "the number of loops must be a whole number from {} to {}";
        /// The integer n of the resonance (eq:resonance1 for p = 1, eq:resonancep with the plus
        /// sign for p >= 2).
        n: u32 = count(0..=MOST_N), INDEX;
        /// The values of mu across.
        mu: [f64; 2] = around_zero(), "the values of mu must be a range [lower, upper] with lower < 0 < upper";
        /// The values of eta up.
        eta: [f64; 2] = around_zero(), "the values of eta must be a range [lower, upper] with lower < 0 < upper";
    }
}

rows! {
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
}

tables! {
    /// The contents of Figure 5.
    UnfoldingSketch {
        /// The curves are the line of grazing bifurcations and the quadratic SN and PD curves.
        curves: UnfoldingPoint = "fig05_curves", "a point of a curve",
        points: UnfoldingResonance = "fig05_points", "the resonance" as Points,
        /// The regions are those where the non-impacting solution is stable, where an MPS is, and where
        /// both are.
        regions: UnfoldingVertex = "fig05_regions", "a vertex of a region" as Areas,
        ;
        /// The ranges of μ on the horizontal axis and of η on the vertical one.
        frame: Frame,
    }
}

impl FileSection for Figure5 {
    const NAME: &'static str = "fig05";
    const REQUIREMENT: &'static str = "the table [fig05] says what Figure 5 shows";

    fn checked(self, section: &Section<'_>, parameters: &Parameters) -> Result<Self, ParameterError> {
        parameters.oscillator()?.resonance(self.loops, self.n).map_err(|_| section.refusal("n"))?;
        Ok(self)
    }
}

impl StudyFigure for Figure5 {
    const LABEL: &'static str = "fig:E";
    const TITLE: Title<&'static str> = Title::figure(5, "unfolding of a resonant grazing bifurcation");
    const TABLES: &'static [TablePlan] = UnfoldingSketch::TABLES;
    const REMEDY: &'static str = "fig05.loops or fig05.n";
    type Shown = UnfoldingSketch;

    fn compute(&self, study: &Study) -> Result<UnfoldingSketch, StudyError> {
        let oscillator = study.parameters.oscillator()?;
        let resonance = oscillator.resonance(self.loops, self.n)?;
        let theorem = ResonantGrazing::check(&resonance.resonant_point(), RESONANCE_TOLERANCE)?;
        let saddle_node = half_parabola(theorem.saddle_node(), self);
        let period_doubling = half_parabola(theorem.period_doubling(), self);

        let (mu, eta) = (self.mu, self.eta);
        let grazing = vec![[0.0, eta[0]], [0.0, eta[1]]];
        let curves = [
            (Bifurcation::NonImpactingGrazing, &grazing),
            (Bifurcation::SaddleNode, &saddle_node),
            (Bifurcation::PeriodDoubling, &period_doubling),
        ];
        let points = |(kind, points): (Bifurcation, &Vec<[f64; 2]>)| {
            let points = points.iter().map(move |&[mu, eta]| UnfoldingPoint { kind, mu, eta });
            points.collect::<Vec<_>>()
        };
        let curves = curves.into_iter().flat_map(points).collect();
        let (kind, loops, n) = (CodimensionTwo::Resonance, self.loops, self.n);
        let points = vec![UnfoldingResonance { kind, loops, n, mu: 0.0, eta: 0.0 }];

        let corner = |points: &[[f64; 2]]| [mu[1], points[points.len() - 1][1]];
        let beyond = [corner(&period_doubling), corner(&saddle_node)];
        let stable = saddle_node.iter().rev().chain(&period_doubling[1..]).chain(&beyond);
        let before = [[mu[0], eta[1]], [mu[0], eta[0]]];
        let on_the_line = [[0.0, saddle_node[saddle_node.len() - 1][1]]];
        let polygons: [(RegionKind, Vec<[f64; 2]>); 3] = [
            (RegionKind::NonImpacting, grazing.iter().chain(&before).copied().collect()),
            (RegionKind::Mps, stable.copied().collect()),
            (RegionKind::Both, saddle_node.iter().chain(&on_the_line).copied().collect()),
        ];
        let regions = (1..).zip(polygons).flat_map(|(region, (kind, vertices))| {
            vertices.into_iter().map(move |[mu, eta]| UnfoldingVertex { region, kind, mu, eta })
        });
        Ok(UnfoldingSketch { curves, points, regions: regions.collect(), frame: Frame { x: mu, y: eta } })
    }

    fn draw(shown: &UnfoldingSketch, width: SheetWidth) -> Result<Sheet, DrawingError> {
        ink::draw(shown, width)
    }
}

/// The curve μ = c η² from the resonance to the edge of the window, on the side of η given by theory, as
/// points (μ, η).
fn half_parabola(curve: BifurcationCurve, shown: &Figure5) -> Vec<[f64; 2]> {
    let edge = if curve.eta_side.signum() < 0.0 { shown.eta[0] } else { shown.eta[1] };
    let eta = |k: u32| edge * (f64::from(k) / f64::from(SAMPLES));
    (0..=SAMPLES).map(eta).filter_map(|eta| Some([curve.parameter(eta)?, eta])).collect()
}
