//! Beyond the paper: the limit map at the resonances of Figure 7.

use grazing_continuation::doubled::{Doubled, DoubledEquations};
use grazing_continuation::mps::unknown;
use grazing_results::{row, tables};
use grazing_theorems::ResonantPoint;
use grazing_unfold::resonances::Resonance;

use crate::{Study, StudyError};

tables! {
    /// The limit map at all resonances of Figure 7, by p and increasing frequency.
    LimitTable {
        rows: AtLimit = "beyond_limits", "a resonance of Figure 7",
    }
}

/// The limit map at a resonance, with how far grazing orbits are from it.
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

impl Study {
    /// The limit map at all resonances of Figure 7.
    ///
    /// # Errors
    /// There is no grazing in the window.
    pub fn limits(&self) -> Result<LimitTable, StudyError> {
        let found = self.diagram()?.unfolding();
        Ok(LimitTable { rows: found.map(|(resonance, _)| AtLimit::of(resonance)).collect() })
    }
}

impl AtLimit {
    fn of(resonance: &Resonance) -> Self {
        let point = resonance.located.resonant_point();
        let equations = DoubledEquations::new(resonance.located.equations());
        let (map, scale) = (point.limit_map(), point.limit_scale());
        let (gap, [velocity, _]) = (map.grazing_gap(), map.period_doubling());
        let error = |size: f64| {
            let eta = size / (scale.velocity * velocity);
            let guess = Doubled::near_resonance(&resonance.located, eta, gap).ok()?;
            let (grazing, _) = equations.grazing(guess)?;
            let (still, _) = map.fixed_point(velocity);
            let from = resonance.located.near(eta, 0.0, still).ok()?[unknown::PRIMARY];
            let limit = point.doubled_grazing_coefficient();
            Some(((grazing.primary() - from) / (eta * eta * limit) - 1.0).abs())
        };
        let errors = [1e-2, 1e-3, 1e-4].map(|size| error(size).unwrap_or(f64::NAN));
        Self { n: resonance.n, point: *point, errors }
    }
}
