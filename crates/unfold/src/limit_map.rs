//! Beyond the paper: the limit map at resonances, and solutions computed near them.

use crate::resonances::FoundResonance;
use grazing_continuation::doubled::DoubledEquations;
use grazing_continuation::mps::unknown;
use grazing_continuation::resonance::LocatedResonance;
use grazing_results::{row, tables};
use grazing_theorems::ResonantPoint;

tables! {
    /// The limit map at resonances, by p and increasing frequency.
    LimitTable {
        rows: AtLimit = "beyond_limits", "a resonance of Figure 7",
    }
}

/// The limit map at a resonance, with the distance of computed grazing orbits from it.
#[derive(Clone, Debug)]
pub struct AtLimit {
    /// The integer n of the resonance.
    pub n: u32,
    /// The resonance.
    pub point: ResonantPoint,
    /// The relative errors of c_2GZ where y_PD = 0.01, 0.001 and 0.0001; NaN where no orbit was found.
    pub errors: [f64; 3],
}

row! { AtLimit, |this| {
    let map = this.point.limit_map();
} [
    LOOPS = this.point.loops(),
    RESONANCE_INDEX = this.n,
    SIGMA = map.numbers()[2],
    M_SN = map.saddle_node()[1],
    M_PD = map.period_doubling()[1],
    M_2GZ = map.doubled_grazing(),
    M_DOUBLED_PD = map.doubled_doubling().unwrap_or(f64::NAN),
    C_2GZ = this.point.doubled_grazing_coefficient(),
    C_2GZ_ERROR_2 = this.errors[0],
    C_2GZ_ERROR_3 = this.errors[1],
    C_2GZ_ERROR_4 = this.errors[2],
] }

impl AtLimit {
    /// The limit map at a resonance, with grazing orbits solved for near it.
    pub fn of(resonance: &FoundResonance) -> Self {
        let point = *resonance.located.resonant_point();
        let limit = point.doubled_grazing_coefficient();
        let error = |size: f64| Some((doubled_grazing(&resonance.located, size)? / limit - 1.0).abs());
        let errors = [1e-2, 1e-3, 1e-4].map(|size| error(size).unwrap_or(f64::NAN));
        Self { n: resonance.n, point, errors }
    }
}

/// The limit of [`doubled_grazing`] at a resonance, extrapolated from two distances; none where no orbit
/// is found.
pub(crate) fn measured_doubled_grazing(resonance: &LocatedResonance) -> Option<f64> {
    let [far, near] = [1e-3, 5e-4].map(|size| doubled_grazing(resonance, size));
    Some(2.0 * near? - far?)
}

/// (μ − μ_graz)/η² at which the orbits with two impacts that begin at the period doubling graze, solved
/// for where the period doubling has impact velocity `size` to leading order.
fn doubled_grazing(resonance: &LocatedResonance, size: f64) -> Option<f64> {
    let point = resonance.resonant_point();
    let (map, scale) = (point.limit_map(), point.limit_scale());
    let [velocity, _] = map.period_doubling();
    let eta = size / (scale.velocity * velocity);
    let equations = DoubledEquations::new(resonance.equations());
    let guess = equations.near_resonance(resonance, eta, map.grazing_gap()).ok()?;
    let (grazing, _) = equations.grazing(guess)?;
    let (still, _) = map.fixed_point(velocity);
    let from = resonance.near(eta, 0.0, still).ok()?[unknown::PRIMARY];
    Some((grazing[unknown::PRIMARY] - from) / (eta * eta))
}
