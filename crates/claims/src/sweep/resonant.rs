//! Theorems 2.4 and 2.5: the saddle-node curve and the curve of multiplier −1 that leave a resonance.

use super::closed_form::{LoopSolution, LoopSolutions};
use super::generic::to_zero;
use super::{Case, CaseVerdict, NO_CURVE, VIRTUAL_ORBIT, first_points};
use crate::*;
use grazing_continuation::curve::Curve;
use grazing_continuation::fit::Estimate;
use grazing_model::LinearOscillator;
use grazing_theorems::hypothesis::Hypothesis;
use grazing_theorems::resonant_theorem::BifurcationCurve;
use grazing_theorems::{HypothesesViolated, ResonantGrazing};

/// A bifurcation curve, as predicted and as computed.
#[derive(Debug, Clone, Copy)]
pub struct CurveRow {
    /// The sign of η predicted by the theorem; `None` if a hypothesis fails.
    pub predicted: Option<Side>,
    /// The sign of η of the continued curve, where it is admissible with y > 0; `None` if the theorem is
    /// silent.
    pub continued: Option<Existence>,
    /// The sign of η for which simulation finds an MPS on either side of the curve.
    pub simulated: Existence,
    /// Whether the multiplier 1 or −1 is crossed, by simulated derivatives on either side of the curve.
    pub crossed: bool,
    /// Whether, if |D| < 1, simulated orbits near the MPS approach it on one side of the curve and leave
    /// it on the other; `None` if |D| ≥ 1, where no MPS near the resonance is stable.
    pub stability_changes: Option<bool>,
    /// The quadratic coefficient by the theorem, with the numerical P_global; NaN where the theorem is
    /// silent.
    pub theorem: f64,
    /// The quadratic coefficient by proposition 3.2 or 3.3; NaN for ω₁/ω = n − 1/(2p).
    pub proposition: f64,
    /// The quadratic coefficient measured on the continued curve.
    pub fit: Option<Estimate>,
    /// The limit of μ/η² on the curve given by the quadratic equation for y.
    pub quadratic_equation: f64,
}

/// The prediction of theorem 2.4 or 2.5 for a resonance, and the computed behaviour.
#[derive(Debug, Clone)]
pub struct ResonantRow {
    /// The case.
    pub case: Case,
    /// The data of the resonance that the theorem uses, from derivatives of the numerical P_global.
    pub point: ResonantPoint,
    /// The grazing amplitude 𝒜_graz at the resonance.
    pub amplitude: f64,
    /// The decay factor E_p.
    pub decay: f64,
    /// All hypotheses with their values.
    pub hypotheses: Vec<Hypothesis>,
    /// The saddle-node curve, and the curve of multiplier −1.
    pub curves: [CurveRow; 2],
}

/// The tolerance between closed forms, derivatives of the numerical map and the limit on the exact curve:
/// rounding of first and second derivatives, divided by s_p⁺ where that is small.
pub const EXACT_TOLERANCE: f64 = 1e-6;
/// The tolerance of fits: velocities up to several hundredths, with s_p⁺ as small as 0.002.
pub const FIT_TOLERANCE: f64 = 1e-4;
/// The bound below which a₁₂, κ_p or s_p^± from numerical derivatives counts as zero.
const ROUNDING: f64 = 1e-11;

impl ResonantRow {
    /// Computes a case.
    pub fn of(case: Case) -> Result<Self, CheckError> {
        let Case { zeta, epsilon, loops, n, negative, omega } = case;
        let theory = grazing_theorems::LinearOscillator::new(zeta, epsilon)?;
        let state = theory.grazing(omega)?;
        let start = state.model();
        let orbit = GrazingOrbit::find(&start, state.phase())?;
        let point = orbit.resonant_point(loops)?;
        let closed = if negative { None } else { Some(theory.resonance(loops, n)?) };
        let (theorem, hypotheses) = asked(&point);
        let unfold = |_: &ResonantGrazing| {
            let located = ResonantGrazingPoint::find(&start, loops, state.phase())?;
            let length = 1e-3 * omega.min(1.0);
            let unfolded = located.unfold(&first_points(length, 1e-4 * length, 0.1))?;
            Ok::<_, CheckError>((located, [unfolded.saddle_node, unfolded.period_doubling]))
        };
        let unfolded = theorem.as_ref().map(unfold).transpose()?;
        let stability = point.stability_coefficients();
        let curve = |k: usize| {
            let [multiplier, stability] = [[1.0, stability.plus], [-1.0, stability.minus]][k];
            Scene { case, point: &point, start, multiplier, stability }.curve(
                theorem.as_ref().map(|theorem| [theorem.saddle_node(), theorem.period_doubling()][k]),
                closed.map(|closed| {
                    [closed.saddle_node_coefficient(), closed.period_doubling_coefficient()][k]
                }),
                unfolded.as_ref().map(|(located, curves)| (located, &curves[k])),
            )
        };
        let curves = [curve(0)?, curve(1)?];
        Ok(Self { case, point, amplitude: state.amplitude(), decay: state.decay(loops), hypotheses, curves })
    }

    /// The verdict on the case.
    pub fn verdict(&self) -> CaseVerdict {
        if self.curves[0].predicted.is_some() {
            let agrees = self.curves.iter().all(CurveRow::agrees);
            return if agrees { CaseVerdict::Agreement } else { CaseVerdict::Unexplained };
        }
        let stability = self.point.stability_coefficients();
        let vanishes = [stability.plus, stability.minus].map(|s| s.abs() <= ROUNDING);
        let nowhere = [0, 1].map(|k| self.curves[k].simulated == Existence::Nowhere);
        // Otherwise the curve whose coefficient vanishes does not exist; the other one does.
        if self.case.negative && nowhere == [true; 2] {
            CaseVerdict::Explained(VIRTUAL_ORBIT)
        } else if !self.case.negative && vanishes[0] != vanishes[1] && nowhere == vanishes {
            CaseVerdict::Explained(NO_CURVE)
        } else {
            CaseVerdict::Unexplained
        }
    }
}

impl CurveRow {
    /// The largest relative difference of proposition and exact curve from the theorem.
    pub fn difference(&self) -> f64 {
        let off = |other: f64| (other - self.theorem) / self.theorem;
        Deviations::of([self.proposition, self.quadratic_equation].map(off)).largest()
    }

    /// The relative difference of the fit from the theorem's coefficient.
    pub fn fit_difference(&self) -> f64 {
        self.fit.map_or(f64::NAN, |fit| ((fit.value - self.theorem) / self.theorem).abs())
    }

    /// Whether everything that the theorem predicts is observed.
    pub fn agrees(&self) -> bool {
        let Some(side) = self.predicted else { return false };
        let on = Existence::On(side);
        self.continued == Some(on)
            && self.simulated == on
            && self.crossed
            && self.stability_changes != Some(false)
            && self.difference() < EXACT_TOLERANCE
            && self.fit_difference() < FIT_TOLERANCE
    }
}

/// The theorem, with values of s_p^± that are zero up to rounding taken as zero.
fn asked(point: &ResonantPoint) -> (Option<ResonantGrazing>, Vec<Hypothesis>) {
    let stability = point.stability_coefficients();
    match ResonantGrazing::check(point, ROUNDING) {
        Ok(theorem) => {
            let zero = stability.plus.abs() <= ROUNDING || stability.minus.abs() <= ROUNDING;
            let hypotheses = theorem.hypotheses().to_vec();
            (Some(theorem).filter(|_| !zero), hypotheses)
        }
        Err(HypothesesViolated { hypotheses, .. }) => (None, hypotheses),
    }
}

/// A bifurcation curve of a resonance, for tests.
struct Scene<'a> {
    case: Case,
    point: &'a ResonantPoint,
    start: LinearOscillator,
    /// The multiplier: 1 on the saddle-node curve, −1 on the other.
    multiplier: f64,
    /// The coefficient s_p⁺ or s_p⁻.
    stability: f64,
}

/// The distance of the simulated MPSs from the curve, in units of the impact velocity on it.
const ASIDE: f64 = 0.5;

impl Scene<'_> {
    fn curve(
        &self,
        theorem: Option<BifurcationCurve>,
        closed: Option<f64>,
        continued: Option<(&ResonantGrazingPoint<LinearOscillator>, &Curve)>,
    ) -> Result<CurveRow, CheckError> {
        let condition = Condition::Multiplier(self.multiplier);
        let fit = continued.map(|(located, _)| quadratic_coefficient(located, condition)).transpose()?;
        let eta = self.small_eta();
        let seen = [1.0, -1.0].map(|sign| self.beside(sign * eta));
        let there = seen.into_iter().flatten().next();
        Ok(CurveRow {
            predicted: theorem.map(|curve| curve.eta_side),
            continued: continued.map(|(_, curve)| Existence::along(curve, 1, self.case.omega, 1)),
            simulated: Existence::of(seen.map(|seen| seen.is_some())),
            crossed: there.is_some_and(|(crossed, _)| crossed),
            stability_changes: there.and_then(|(_, changes)| changes),
            theorem: theorem.map_or(f64::NAN, |curve| curve.coefficient),
            proposition: closed.unwrap_or(f64::NAN),
            fit,
            quadratic_equation: self.limit(eta),
        })
    }

    fn solutions(&self, eta: f64) -> LoopSolutions {
        let Case { zeta, epsilon, loops, omega, .. } = self.case;
        LoopSolutions::new(zeta, epsilon, omega + eta, loops)
    }

    fn bifurcation(&self, eta: f64) -> LoopSolution {
        let solutions = self.solutions(eta);
        if self.multiplier > 0.0 { solutions.saddle_node() } else { solutions.period_doubling() }
    }

    /// An impact velocity that is small compared with the frequency over 1 + ε (since an impact shifts
    /// the phase), and smaller where s_p^± is small, so that terms of higher order are negligible.
    fn small_velocity(&self) -> f64 {
        let Case { epsilon, omega, .. } = self.case;
        let root = self.stability.abs().sqrt().min(1.0);
        // Where it is zero there is no small scale to respect.
        let root = if root < 1e-5 { 1.0 } else { root };
        0.03 * root * (omega / (1.0 + epsilon)).min(1.0)
    }

    /// The η > 0 at which the bifurcation has about this |y|, limited to values that are small compared
    /// with the change of frequency by which the free oscillation turns by a radian in p periods, and
    /// with 𝒜_graz.
    fn small_eta(&self) -> f64 {
        let factor = self.point.grazing.alpha() * self.point.grazing.forcing_frequency;
        let slope = factor * self.point.off_diagonal_slope() / self.stability.abs().max(1e-4);
        let turn = self.case.omega * self.case.omega / (TAU * f64::from(self.case.loops));
        (self.small_velocity() / slope.abs()).min(3e-3 * turn).min(0.01 * self.start.amplitude())
    }

    /// The limit of μ/η² on the curve as η goes to zero.
    fn limit(&self, eta: f64) -> f64 {
        let at: Vec<f64> = [1.0, -1.0, 0.5, -0.5, 0.25, -0.25].iter().map(|size| size * eta).collect();
        let ratios = at.iter().map(|eta| self.bifurcation(*eta).mu / (eta * eta)).collect();
        to_zero(&at, ratios)
    }

    /// Whether the multiplier is crossed between MPSs on both sides, and whether stability changes if |D|
    /// < 1.
    fn beside(&self, eta: f64) -> Option<(bool, Option<bool>)> {
        let solutions = self.solutions(eta);
        let middle = self.bifurcation(eta);
        // Unless its velocity vanishes with η, the curve does not emerge from the resonance.
        let nearer = self.bifurcation(0.25 * eta);
        if nearer.velocity.abs() > 0.5 * middle.velocity.abs() {
            return None;
        }
        let both = [1.0 - ASIDE, 1.0 + ASIDE].map(|size| solutions.with_velocity(size * middle.velocity));
        let oscillators =
            both.map(|solution| self.start.with_parameters([solution.amplitude, self.case.omega + eta]));
        let suspects = [0, 1].map(|k| both[k].suspect(&oscillators[k], self.case.loops));
        if suspects.iter().any(|suspect| suspect.follow() != ReturnOutcome::Returns) {
            return None;
        }
        let side =
            suspects.map(|suspect| suspect.multipliers().map(|[t, d]| 1.0 - self.multiplier * t + d > 0.0));
        let crossed = matches!(side, [Some(a), Some(b)] if a != b);
        // With |D| ≥ 1 all nearby orbits leave.
        let stability_changes = (solutions.determinant() < 1.0)
            .then(|| matches!(suspects.map(|suspect| suspect.attracts()), [Some(a), Some(b)] if a != b));
        Some((crossed, stability_changes))
    }
}
