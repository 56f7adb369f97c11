//! A comparison of the theorem's quadratic coefficients with those of the continued curves,
//! including whether they can be compared.

use grazing_continuation::bifurcation::Pair;
use grazing_continuation::fit::{CoefficientError, Estimate, Measurement, Straightened};
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::maps::global_iterate;
use grazing_model::{AtRest, ImpactOscillator};
use grazing_results::{Dimension, Dimensioned};
use grazing_theorems::ResonantPoint;
use grazing_theorems::from_map::GrazingOrbit;
use nalgebra::Matrix2;

/// A quadratic coefficient by Theorem 2.4 or 2.5, and measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficient {
    /// The number s_p⁺ for c_SN, s_p⁻ for c_PD, whose reciprocal occurs in the coefficient.
    pub stability: f64,
    /// The value by the theorem, with the error due to the quantities in its formula.
    pub theorem: Estimate,
    /// The limit of μ/η² on the continued curve.
    pub fit: Result<Measurement, CoefficientError>,
}

impl Dimensioned for Coefficient {
    fn each_number(&mut self, visit: &mut dyn FnMut(Dimension, &mut f64)) {
        let Self { theorem: Estimate { value, error }, fit, .. } = self;
        [value, error].into_iter().for_each(|number| visit(Dimension::of("{primary}/{secondary}^2"), number));
        match fit {
            Ok(measurement) => measurement.each_number(visit),
            Err(CoefficientError::NoPoint { velocity, .. }) => visit(Dimension::of("length/time"), velocity),
            Err(CoefficientError::GrazingOrbit(_) | CoefficientError::NotFinished) => {}
        }
    }
}

/// The result of comparing theorem and curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// The values agree within their errors, which are small.
    Agree,
    /// One of the values is not known well enough.
    NotMeasurable(Obstacle),
    /// The values differ by more than their errors.
    Contradict,
}

/// The reason why a coefficient cannot be compared.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Obstacle {
    /// The curve could not be followed close to the resonance.
    #[error("the curve could not be followed to the resonance: {0}")]
    NoCurve(CoefficientError),
    /// Where μ is clear of rounding it is not yet quadratic in η: the measured value has this
    /// relative error at best.
    #[error(
        "where the eta^2 term dominates, it is lost in rounding; measured up to |eta| = {eta:.1e}, the value has a relative error of {error:.1e}"
    )]
    Rounding {
        /// The relative error.
        error: f64,
        /// The largest |η| at which it was measured.
        eta: f64,
    },
    /// A quantity in the theorem's formula, most likely s_p^±, is so near to zero that its value
    /// has this relative error.
    #[error(
        "the theorem's own value has a relative error of {error:.1e}: s = {stability:.1e} is too close to 0, or a derivative in the formula is not accurate enough"
    )]
    NearlyDegenerate {
        /// The coefficient s_p⁺ or s_p⁻.
        stability: f64,
        /// The relative error.
        error: f64,
    },
}

impl Verdict {
    /// The verdict in a word or two.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Agree => "agree",
            Self::NotMeasurable(_) => "not measurable",
            Self::Contradict => "contradict",
        }
    }

    /// The reason for the verdict in words; empty where theorem and curve agree.
    pub fn reason(&self) -> String {
        match self {
            Self::Agree => String::new(),
            Self::NotMeasurable(obstacle) => obstacle.to_string(),
            Self::Contradict => "theorem and curve differ by more than their errors".to_owned(),
        }
    }
}

/// Relative error above which an agreement would mean little: two digits are the least.
const LARGEST_SHARE: f64 = 0.01;

impl Coefficient {
    /// The value measured on the curve; NaN if there is none.
    pub fn measured(&self) -> Estimate {
        self.fit.as_ref().map_or(Estimate { value: f64::NAN, error: f64::NAN }, |fit| fit.coefficient)
    }

    /// The measured value, and the number of digits that it has in common with the theorem's value,
    /// 0 to 15: the order of magnitude of their relative difference. `None` where they cannot be
    /// compared.
    pub fn compared(&self) -> Option<(f64, u32)> {
        let (theorem, measured) = (self.theorem.value, self.measured().value);
        let difference = (theorem - measured).abs() / theorem.abs().max(measured.abs());
        let digits = libm::floor(-libm::log10(difference.max(1e-15))).clamp(0.0, 15.0) as u32;
        (!matches!(self.verdict(), Verdict::NotMeasurable(_))).then_some((measured, digits))
    }

    /// Whether theorem and curve agree.
    pub fn verdict(&self) -> Verdict {
        let Self { stability, theorem, fit } = self;
        let fit = match fit {
            Ok(fit) => fit,
            Err(error) => return Verdict::NotMeasurable(Obstacle::NoCurve(*error)),
        };
        let measured = fit.coefficient;
        let larger = theorem.value.abs().max(measured.value.abs());
        // The measured value may be nothing but rounding, far below the true one.
        let shares = [theorem.error / larger, measured.error / measured.value.abs()];
        // NaN counts as too large.
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

/// The coefficients c_SN and c_PD at a resonance.
pub fn coefficients(point: &ResonantGrazingPoint) -> Pair<Coefficient> {
    coefficients_on(point, &near(point))
}

/// The SN and the PD curve near a resonance.
pub fn near(point: &ResonantGrazingPoint) -> Pair<Result<Straightened, CoefficientError>> {
    Pair::CONDITIONS.map(|condition| point.leaving(condition).straightened())
}

/// The coefficients c_SN and c_PD at a resonance near which the curves are known.
pub fn coefficients_on(
    point: &ResonantGrazingPoint,
    near: &Pair<Result<Straightened, CoefficientError>>,
) -> Pair<Coefficient> {
    let stability = point.resonant_point().stability_coefficients();
    let stability = Pair { saddle_node: stability.plus, period_doubling: stability.minus };
    let known = point.leading().zip(stability).zip(theorem_errors(point)).zip(near.as_ref());
    known.map(|(((curve, stability), error), near)| Coefficient {
        stability,
        theorem: Estimate { value: curve.coefficient, error },
        fit: near.as_ref().map(|near| near.measurement).map_err(|error| *error),
    })
}

/// Best relative errors of first derivatives of the flow, and of differences of them (empirical:
/// integrated motion is right to some 10⁻¹³).
const FIRST_DERIVATIVES: f64 = 1e-12;
const DIFFERENCES: f64 = 1e-10;

/// The errors of c_SN and c_PD that follow from the errors of the quantities in their formulas,
/// varied one after the other.
fn theorem_errors(point: &ResonantGrazingPoint) -> Pair<f64> {
    let known = point.resonant_point();
    let values =
        |point: &ResonantPoint| [point.saddle_node_coefficient(), point.period_doubling_coefficient()];
    let stated = values(known);
    let map = known.grazing.map;
    let (matrix, rate) = (map.a.norm(), point.orbit().derivative_of_map().norm());
    let [curvature, unfolding] = second_derivative_errors(point);
    let mut errors = [0.0; 2];
    let mut moved = |change: &dyn Fn(&mut ResonantPoint)| {
        let mut moved = *known;
        change(&mut moved);
        let there = values(&moved);
        for k in 0..2 {
            errors[k] += (there[k] - stated[k]).abs();
        }
    };
    for index in 0..4 {
        moved(&|point| point.grazing.map.a[index] += FIRST_DERIVATIVES * matrix);
    }
    for index in 0..2 {
        moved(&|point| point.grazing.map.b[index] += FIRST_DERIVATIVES * map.b.norm());
    }
    moved(&|point| point.grazing.gamma *= 1.0 + FIRST_DERIVATIVES);
    moved(&|point| {
        point.second_phase_derivative += curvature + DIFFERENCES * known.second_phase_derivative.abs();
    });
    moved(&|point| {
        let slope = &mut point.unfolding.derivative;
        *slope += unfolding + DIFFERENCES * rate.max(slope.abs());
    });
    let [saddle_node, period_doubling] = errors;
    Pair { saddle_node, period_doubling }
}

/// Widths of differences, as fractions of a radian, and of the distance in η over which P_global
/// changes by its own size: wide ones lose least to rounding, narrow ones stay where maps are
/// defined, as near a fold of the grazing curve.
const WIDTHS: [f64; 3] = [3e-3, 3e-4, 3e-5];

/// Factor on the errors of second derivatives: the curve's own derivatives have errors like those
/// at the resonance, but at other places.
const ELSEWHERE: f64 = 3.0;

/// The errors of ξ_p and of a₁₂' or κ_p', as their deviations from differences of first
/// derivatives. Infinite where maps beside the resonance are not defined.
///
/// The steps of integrated motion are chosen for its values, and where the force bends within a
/// step second derivatives lose accuracy first.
fn second_derivative_errors(point: &ResonantGrazingPoint) -> [f64; 2] {
    let (orbit, known, loops) = (point.orbit(), point.resonant_point(), point.loops());
    let slope = |phase: f64| {
        global_iterate::<_, 1>(orbit.oscillator(), loops, AtRest::new(0.0, orbit.phase() + phase))
            .map_or(f64::NAN, |jet| jet.jacobian[(0, 1)])
    };
    let [primary, secondary] = orbit.oscillator().parameters();
    let detuning = |eta: f64| {
        let parameters = [primary + orbit.primary_slope() * eta, secondary + eta];
        let beside = orbit.oscillator().with_parameters(parameters);
        GrazingOrbit::find(&beside, orbit.phase() + orbit.phase_slope() * eta)
            .map_or(f64::NAN, |orbit| orbit.detuning(loops, &Matrix2::zeros())[0])
    };
    let turn = known.grazing.map.a.norm() / orbit.derivative_of_map().norm();
    let closest = |function: &dyn Fn(f64) -> f64, scale: f64, stated: f64| {
        let differences = WIDTHS.map(|width| (derivative(function, width * scale) - stated).abs());
        ELSEWHERE * differences.into_iter().fold(f64::INFINITY, f64::min)
    };
    [
        closest(&slope, 1.0, known.second_phase_derivative),
        closest(&detuning, turn, known.unfolding.derivative),
    ]
}

/// The derivative at zero by central differences, extrapolated twice.
fn derivative(function: impl Fn(f64) -> f64, width: f64) -> f64 {
    let [a, b, c] = [1.0, 0.5, 0.25].map(|part| {
        let at = part * width;
        (function(at) - function(-at)) / (2.0 * at)
    });
    (a - 20.0 * b + 64.0 * c) / 45.0
}
