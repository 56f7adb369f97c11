//! The curve of grazing bifurcations of the non-impacting solution, and phases relative to it.

use core::f64::consts::{PI, TAU};

use crate::StudyError;
use crate::parameters::Parameters;

/// The grazing curve 𝒜 = 𝒜_graz(ω), sampled evenly in ω. Paper: eq:Agraz.
pub(crate) struct GrazingCurve {
    pub(crate) states: Vec<grazing_theorems::GrazingState>,
}

/// Samples of the grazing curve across a window: straight pieces between them stay within 10⁻⁵ of it.
const GRAZING_SAMPLES: u32 = 400;

impl GrazingCurve {
    pub(crate) fn sample(parameters: &Parameters, lower: f64, upper: f64) -> Result<Self, StudyError> {
        let theory = grazing_theorems::LinearOscillator::new(parameters.zeta(), parameters.epsilon())?;
        let frequency = |k| {
            let share = f64::from(k) / f64::from(GRAZING_SAMPLES);
            lower + (upper - lower) * share
        };
        let states = (0..=GRAZING_SAMPLES).map(|k| theory.grazing(frequency(k))).collect::<Result<_, _>>()?;
        Ok(Self { states })
    }
}

/// An angle brought into (−π, π].
pub(crate) fn centred(angle: f64) -> f64 {
    let turned = angle - TAU * libm::floor(angle / TAU);
    if turned > PI { turned - TAU } else { turned }
}
