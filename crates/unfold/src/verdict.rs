//! Whether the theorem's quadratic coefficients are those of the continued curves, and where that cannot be told.

use grazing_continuation::fit::{Estimate, FitError, Measurement, measure};
use grazing_continuation::locate::Condition;
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::ImpactOscillator;
use grazing_theorems::{ResonantPoint, Unfolding};

/// A quadratic coefficient by Theorem 2.4 or 2.5, and measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficient {
    /// s_p⁺ for c_SN, s_p⁻ for c_PD, in whose reciprocal the coefficient is.
    pub stability: f64,
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
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Obstacle {
    /// The curve could not be followed close to the resonance.
    #[error("the curve could not be followed to the resonance: {0}")]
    NoCurve(FitError),
    /// Where μ stands clear of rounding it is not yet quadratic in η: the measured value has this relative error at best.
    #[error("where the term in eta^2 leads it is lost in rounding: measured up to |eta| = {eta:.1e}, the value has a relative error of {error:.1e}")]
    Rounding {
        /// The relative error.
        error: f64,
        /// |η| up to which it was measured.
        eta: f64,
    },
    /// A quantity in the theorem's formula, most likely s_p^±, is so near to zero that its value has this relative error.
    #[error("the theorem's own value has a relative error of {error:.1e}, as near to 0 as its s = {stability:.1e} is")]
    NearlyDegenerate {
        /// s_p⁺ or s_p⁻.
        stability: f64,
        /// The relative error.
        error: f64,
    },
}

impl Verdict {
    /// In a word or two.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Agree => "agree",
            Self::NotMeasurable(_) => "not measurable",
            Self::Contradict => "contradict",
        }
    }

    /// Why it is not better, in words; empty where they agree.
    pub fn reason(&self) -> String {
        match self {
            Self::Agree => String::new(),
            Self::NotMeasurable(obstacle) => obstacle.to_string(),
            Self::Contradict => "theorem and curve differ by more than their errors".to_owned(),
        }
    }
}

/// A larger error than this share of the value would make an agreement mean little: two digits are the least.
const LARGEST_SHARE: f64 = 0.01;

impl Coefficient {
    /// Whether theorem and curve agree.
    pub fn verdict(&self) -> Verdict {
        let Self { stability, theorem, fit } = self;
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
            return Verdict::NotMeasurable(Obstacle::NearlyDegenerate {
                stability: *stability,
                error: shares[0],
            });
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
    let stability = point.resonant_point().stability_coefficients();
    let curves = [
        (point.theorem().saddle_node(), stability.plus, Condition::SADDLE_NODE),
        (point.theorem().period_doubling(), stability.minus, Condition::PERIOD_DOUBLING),
    ];
    core::array::from_fn(|k| {
        let (curve, stability, condition) = curves[k];
        Coefficient {
            stability,
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
