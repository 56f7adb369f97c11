//! Theorems 2.2 and 2.3: the side of grazing on which the unstable MPS emerges.

use super::closed_form::LoopSolutions;
use super::{
    Case, CaseVerdict, INTERIOR_LOOP, ORBIT_BELOW_THE_BOUNDARY, ORBIT_WITH_NEGATIVE_FACTOR, POINTS,
    VIRTUAL_ORBIT, first_points,
};
use crate::solutions::branch;
use crate::*;
use grazing_continuation::curve::Curve;
use grazing_model::LinearOscillator;
use grazing_theorems::HypothesesViolated;
use grazing_theorems::hypothesis::Hypothesis;

/// The prediction of theorem 2.2 or 2.3 for a case, and the computed behaviour.
#[derive(Debug, Clone)]
pub struct GenericRow {
    /// The case.
    pub case: Case,
    /// The data of the grazing point that the theorem uses, from derivatives of the numerical P_global.
    pub point: GrazingPoint,
    /// All hypotheses with their values.
    pub hypotheses: Vec<Hypothesis>,
    /// The side predicted by the theorem; `None` if a hypothesis fails.
    pub predicted: Option<Side>,
    /// The side on which, to first order in μ, y > 0 and no interior loop meets the wall.
    pub first_order: Existence,
    /// The result of continuation from the grazing point.
    pub continued: Existence,
    /// The result of simulation of all candidates at small μ of both signs.
    pub simulated: Existence,
    /// Whether the MPS is unstable: by its multipliers along the branch, and by simulation where it is an
    /// MPS.
    pub unstable: [bool; 2],
    /// dy/dμ and dz/dμ: by section 4 with the numerical P_global, by closed form, and along the branch.
    pub slopes: [[f64; 2]; 3],
}

/// The tolerance between slopes along the branch and first-order terms: fourth-order extrapolation to y =
/// 0.
pub const SLOPE_TOLERANCE: f64 = 1e-5;

impl GenericRow {
    /// Computes a case.
    pub fn of(case: Case) -> Result<Self, CheckError> {
        let Case { zeta, epsilon, loops, omega, .. } = case;
        let closed = grazing_theorems::LinearOscillator::new(zeta, epsilon)?.grazing(omega)?;
        let start = closed.model();
        let orbit = GrazingOrbit::find(&start, closed.phase())?;
        let point = orbit.grazing_point();
        let (predicted, hypotheses) = match GenericGrazing::check(&point, loops) {
            Ok(theorem) => (Some(theorem.side()), theorem.hypotheses().to_vec()),
            Err(HypothesesViolated { hypotheses, .. }) => (None, hypotheses),
        };
        let emerging = point.emerging_orbit(loops)?;
        let solutions = LoopSolutions::new(zeta, epsilon, omega, loops);
        let velocity = small_velocity(&point, loops);
        let route = first_points(velocity, 1e-3 * velocity, core::f64::consts::PI);
        let curve = branch(orbit.oscillator(), orbit.phase(), loops, &route)?;
        let (simulated, repels) = simulate(&start, &solutions, loops, velocity);
        Ok(Self {
            case,
            point,
            hypotheses,
            predicted,
            first_order: first_order(&point, loops)?,
            continued: Existence::along(&curve, 0, orbit.primary(), POINTS),
            simulated,
            unstable: [curve.points.iter().skip(1).all(|point| !point.solution.stable()), repels],
            slopes: [
                [emerging.impact_velocity_slope, emerging.impact_phase_slope],
                solutions.slopes(),
                followed_slopes(&curve, orbit.primary(), orbit.phase()),
            ],
        })
    }

    /// The largest relative difference of the other slopes from the first-order terms.
    pub fn slope_difference(&self) -> f64 {
        let [theory, others @ ..] = &self.slopes;
        let scale = libm::hypot(theory[0], theory[1]);
        let off = |other: &[f64; 2]| libm::hypot(other[0] - theory[0], other[1] - theory[1]) / scale;
        Deviations::of(others.iter().map(off)).largest()
    }

    /// The verdict on the case.
    pub fn verdict(&self) -> CaseVerdict {
        let same = self.continued == self.simulated && self.simulated == self.first_order;
        let close = self.slope_difference() < SLOPE_TOLERANCE;
        if !(same && close) {
            return CaseVerdict::Unexplained;
        }
        // Other hypotheses hold in all cases: a violation of theirs would have no explanation.
        let map = self.point.map;
        let positive = map.a.m12 * self.point.alpha() > 0.0;
        let boundary = admissibility_boundary(self.case.loops, map.determinant());
        let below = boundary.is_ok_and(|boundary| map.trace() <= boundary);
        match (self.predicted, self.simulated) {
            (Some(side), Existence::On(seen)) if side == seen && self.unstable == [true; 2] => {
                CaseVerdict::Agreement
            }
            (None, Existence::Nowhere) if positive && below => CaseVerdict::Explained(INTERIOR_LOOP),
            (None, Existence::Nowhere) if !positive && self.case.loops > 1 => {
                CaseVerdict::Explained(VIRTUAL_ORBIT)
            }
            (None, Existence::On(_)) if positive && below => CaseVerdict::Explained(ORBIT_BELOW_THE_BOUNDARY),
            (None, Existence::On(_)) if below => CaseVerdict::Explained(ORBIT_WITH_NEGATIVE_FACTOR),
            _ => CaseVerdict::Unexplained,
        }
    }
}

/// An impact velocity that is small compared with that of the next bifurcation, with γ/(ω (1 + φ)) (since
/// an impact shifts the phase), and with 1.
pub(crate) fn small_velocity(point: &GrazingPoint, loops: u32) -> f64 {
    let off_diagonal = point.map.iterate(loops).a.m12.abs();
    // Section 5: bifurcations lie at α ω |(Aᵖ)₁₂| / |s_p|, |s_p| up to (1 + φ E_p)² ≤ 4.
    let bifurcation = point.alpha().abs() * point.forcing_frequency * off_diagonal / 4.0;
    let shift = point.gamma / (point.forcing_frequency * (1.0 + point.phi));
    0.01 * bifurcation.min(shift).min(1.0)
}

/// The side on which y > 0 and all interior loops have x < 0, to first order in μ.
fn first_order(point: &GrazingPoint, loops: u32) -> Result<Existence, CheckError> {
    let emerging = point.emerging_orbit(loops)?;
    let positive = |sign: f64| {
        sign * emerging.impact_velocity_slope > 0.0
            && (1..loops).all(|j| sign * emerging.visit_slope(j)[0] < 0.0)
    };
    Ok(Existence::of([1.0, -1.0].map(positive)))
}

/// dy/dμ and dz/dμ at grazing, extrapolated from the points of the branch.
fn followed_slopes(curve: &Curve, grazing: f64, phase: f64) -> [f64; 2] {
    let rows: Vec<[f64; 3]> = curve
        .points
        .iter()
        .skip(1)
        .map(|point| {
            let [y, z, amplitude, _]: [f64; 4] = point.solution.unknowns.clone().into();
            // Both are smooth in y and finite at y = 0.
            [y, (amplitude - grazing) / y, (z - phase) / y]
        })
        .collect();
    let at: Vec<f64> = rows.iter().map(|row| row[0]).collect();
    let limit = |k: usize| to_zero(&at, rows.iter().map(|row| row[k]).collect());
    let (by_velocity, phase_by_velocity) = (limit(1), limit(2));
    [1.0 / by_velocity, phase_by_velocity / by_velocity]
}

/// The value at zero of the polynomial through all points (Neville's scheme).
pub(super) fn to_zero(at: &[f64], mut values: Vec<f64>) -> f64 {
    for order in 1..values.len() {
        for i in (order..values.len()).rev() {
            let weight = at[i] / (at[i - order] - at[i]);
            values[i] += weight * (values[i] - values[i - 1]);
        }
    }
    values.last().copied().unwrap_or(f64::NAN)
}

/// The side on which the hybrid system has an MPS at small μ, and whether nearby orbits leave it.
fn simulate(
    oscillator: &LinearOscillator,
    solutions: &LoopSolutions,
    loops: u32,
    velocity: f64,
) -> (Existence, bool) {
    let scale = velocity / solutions.slopes()[0].abs();
    let mut repels = true;
    let mut found = |side: Side| -> Option<bool> {
        let at_sizes = [1.0, 0.5, 0.25].map(|size| {
            let mu = side.signum() * scale * size;
            // Solutions that do not shrink with μ do not emanate from grazing.
            let near: Vec<_> = solutions
                .at(mu)
                .into_iter()
                .filter(|solution| solution.velocity.abs() < 10.0 * velocity * size)
                .collect();
            let [solution] = near[..] else { return None };
            let at = oscillator.with_parameters([solution.amplitude, oscillator.frequency()]);
            let suspect = solution.suspect(&at, loops);
            let seen = suspect.follow();
            if seen == ReturnOutcome::Returns {
                repels &= suspect.repels_at_once();
            }
            match seen {
                ReturnOutcome::Returns => Some(true),
                ReturnOutcome::NoImpact | ReturnOutcome::MeetsTheWall => Some(false),
                ReturnOutcome::GoesElsewhere | ReturnOutcome::HitsTheOtherStop => None,
            }
        });
        let [first, rest @ ..] = at_sizes;
        rest.iter().all(|other| *other == first).then_some(first).flatten()
    };
    let existence = match [Side::Positive, Side::Negative].map(&mut found) {
        [Some(positive), Some(negative)] => Existence::of([positive, negative]),
        _ => Existence::Unclear,
    };
    (existence, repels)
}
