//! Whether the theorem's quadratic coefficients are those of the continued curves, and where that cannot be told.

use grazing_continuation::fit::{Estimate, FitError, Measurement, measure};
use grazing_continuation::locate::Condition;
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::ImpactOscillator;
use grazing_theorems::{ResonantPoint, Unfolding};

/// A quadratic coefficient by Theorem 2.4 or 2.5, and measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficient {
    /// By the theorem, with the error that the quantities in its formula leave.
    pub theorem: Estimate,
    /// The limit of μ/η² on the continued curve.
    pub fit: Result<Measurement, FitError>,
}

/// What comes of comparing the two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// They agree within their errors, which are small.
    Agree,
    /// One of them is not known well enough.
    NotMeasurable(Obstacle),
    /// They differ by more than their errors.
    Contradict,
}

/// Why a coefficient cannot be compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Obstacle {
    /// The curve could not be followed close to the resonance.
    NoCurve(FitError),
    /// Where μ stands clear of rounding it is not yet quadratic in η: the measured value has this relative error at best.
    Rounding {
        /// The relative error.
        error: f64,
        /// |η| up to which it was measured.
        eta: f64,
    },
    /// s_p^± or another quantity is so near to zero that the theorem's value has this relative error.
    NearlyDegenerate {
        /// The relative error.
        error: f64,
    },
}

/// A larger error than this share of the value would make an agreement mean little: two digits are the least.
const LARGEST_SHARE: f64 = 0.01;

impl Coefficient {
    /// Whether theorem and curve agree.
    pub fn verdict(&self) -> Verdict {
        let Self { theorem, fit } = self;
        let fit = match fit {
            Ok(fit) => fit,
            Err(error) => return Verdict::NotMeasurable(Obstacle::NoCurve(*error)),
        };
        let measured = fit.coefficient;
        let larger = theorem.value.abs().max(measured.value.abs());
        let shares = [theorem.error, measured.error].map(|error| error / larger);
        // Not a number counts as too large.
        let known = shares.map(|share| share <= LARGEST_SHARE);
        if !known[0] {
            return Verdict::NotMeasurable(Obstacle::NearlyDegenerate { error: shares[0] });
        }
        if !known[1] {
            let [e1, e2] = fit.eta;
            let eta = (e1 + e2 * fit.velocity).abs() * fit.velocity;
            return Verdict::NotMeasurable(Obstacle::Rounding { error: shares[1], eta });
        }
        let deviation = (theorem.value - measured.value).abs();
        if deviation <= theorem.error + measured.error { Verdict::Agree } else { Verdict::Contradict }
    }
}

/// c_SN and c_PD at a resonance.
pub fn coefficients<O: ImpactOscillator>(point: &ResonantGrazingPoint<O>) -> [Coefficient; 2] {
    let errors = theorem_errors(point);
    let curves = [
        (point.theorem().saddle_node(), Condition::SADDLE_NODE),
        (point.theorem().period_doubling(), Condition::PERIOD_DOUBLING),
    ];
    core::array::from_fn(|k| {
        let (curve, condition) = curves[k];
        Coefficient {
            theorem: Estimate { value: curve.coefficient, error: errors[k] },
            fit: measure(point, condition),
        }
    })
}

/// Relative errors of first and second derivatives of the flow: those of integrated motion, whose values are right to some 10⁻¹³
/// (empirical; the closed form's are smaller).
const FIRST_DERIVATIVES: f64 = 1e-12;
const SECOND_DERIVATIVES: f64 = 1e-10;

/// How far c_SN and c_PD move when what they are computed from moves by its error, one quantity after the other.
fn theorem_errors<O: ImpactOscillator>(point: &ResonantGrazingPoint<O>) -> [f64; 2] {
    let known = point.resonant_point();
    let values =
        |point: &ResonantPoint| [point.saddle_node_coefficient(), point.period_doubling_coefficient()];
    let [saddle_node, period_doubling] = values(known);
    let map = known.grazing.map;
    let (matrix, rate) = (map.a.norm(), point.orbit().derivative_of_map().norm());
    let mut errors = [0.0; 2];
    let mut moved = |change: &dyn Fn(&mut ResonantPoint)| {
        let mut moved = *known;
        change(&mut moved);
        for (error, (value, there)) in
            errors.iter_mut().zip([saddle_node, period_doubling].into_iter().zip(values(&moved)))
        {
            *error += (there - value).abs();
        }
    };
    for index in 0..4 {
        moved(&|point| point.grazing.map.a[index] += FIRST_DERIVATIVES * matrix);
    }
    for index in 0..2 {
        moved(&|point| point.grazing.map.b[index] += FIRST_DERIVATIVES * map.b.norm());
    }
    moved(&|point| point.grazing.gamma *= 1.0 + FIRST_DERIVATIVES);
    // Two factors matrix: ξ_p is a second derivative of an iterate.
    moved(&|point| point.second_phase_derivative *= 1.0 + SECOND_DERIVATIVES);
    moved(&|point| match &mut point.unfolding {
        Unfolding::OneLoop { off_diagonal_derivative } => {
            *off_diagonal_derivative += SECOND_DERIVATIVES * rate;
        }
        Unfolding::MultiLoop { detuning_derivative, .. } => {
            *detuning_derivative += SECOND_DERIVATIVES * rate.max(detuning_derivative.abs());
        }
    });
    errors
}
