//! Closed forms for the harmonically forced linear oscillator with a wall (section 3 and appendix B
//! of the paper).
//!
//! `x'' + 2 zeta x' + x + 1 = A cos(omega t)` for `x <= 0`, and `y -> -epsilon y` at `x = 0`;
//! `mu = A - A_graz(omega)` and
//! `eta = omega - omega*`. Paper: section 3, eq. (1) and (2), `eq:oscf`, `eq:oscResetLaw`.

mod grazing_curve;
mod resonance;

pub use grazing_curve::GrazingState;
pub use resonance::Resonance;

use crate::error::TheoryError;

/// The largest number of resonances of one `p` that [`LinearOscillator::resonances`] lists. They
/// accumulate at frequency zero, where the decay over one period makes their coefficients vanish;
/// longer lists have no use.
const LARGEST_LIST: u32 = 100_000;

/// The linear impact oscillator: its damping ratio and its coefficient of restitution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearOscillator {
    zeta: f64,
    epsilon: f64,
}

impl LinearOscillator {
    /// An oscillator with damping ratio `zeta` in (0, 1) and coefficient of restitution `epsilon`,
    /// positive and finite, both dimensionless.
    ///
    /// The theorems require only `phi > 0`, and the paper considers `epsilon = 1 / E_p`, which is
    /// greater than 1.
    ///
    /// # Errors
    /// [`TheoryError::DampingRatio`], [`TheoryError::CoefficientOfRestitution`] outside of these
    /// intervals.
    pub fn new(zeta: f64, epsilon: f64) -> Result<Self, TheoryError> {
        if !(0.0 < zeta && zeta < 1.0) {
            return Err(TheoryError::DampingRatio { zeta });
        }
        if !(0.0 < epsilon && epsilon.is_finite()) {
            return Err(TheoryError::CoefficientOfRestitution { epsilon });
        }
        Ok(Self { zeta, epsilon })
    }

    /// The damping ratio, zeta, dimensionless.
    pub fn damping_ratio(&self) -> f64 {
        self.zeta
    }

    /// The coefficient of restitution, epsilon, dimensionless.
    pub fn coefficient_of_restitution(&self) -> f64 {
        self.epsilon
    }

    /// The damped natural frequency.
    ///
    /// `omega_1 = sqrt(1 - zeta^2)`. Paper: section 3.1. Radians per unit of (non-dimensional)
    /// time.
    pub fn damped_natural_frequency(&self) -> f64 {
        ((1.0 - self.zeta) * (1.0 + self.zeta)).sqrt()
    }

    /// The oscillator at the grazing bifurcation with forcing frequency `omega` (radians per unit
    /// of time, positive).
    ///
    /// # Errors
    /// [`TheoryError::ForcingFrequency`] unless `omega` is positive and finite.
    pub fn grazing(&self, omega: f64) -> Result<GrazingState, TheoryError> {
        GrazingState::new(*self, omega)
    }

    /// The resonance of the `p`-loop maximal periodic solution with index `n`.
    ///
    /// `omega_1 / omega = n / 2` for `p = 1`, `omega_1 / omega = n + 1 / (2 p)` for `p >= 2`.
    /// Paper: section 3, eq. (12) and (13), `eq:resonance1`, `eq:resonancep` with the plus sign.
    ///
    /// `p >= 1`. `n >= 1` for `p = 1`; `n >= 0` for `p >= 2`, where proposition 3.3 requires
    /// `n >= 1` but its proof does not: `n = 0`, `omega = 2 p omega_1`, is a resonance like the
    /// others.
    ///
    /// # Errors
    /// [`TheoryError::TooFewLoops`], [`TheoryError::ResonanceIndex`] for smaller `p` or `n`.
    pub fn resonance(&self, p: u32, n: u32) -> Result<Resonance, TheoryError> {
        Resonance::new(*self, p, n)
    }

    /// The forcing frequency at which `tau = g_p(delta)` but the maximal periodic solutions are
    /// virtual, since `a12 alpha < 0`.
    ///
    /// `omega_1 / omega = n - 1 / (2 p)`. Paper: section 3, eq. (13), `eq:resonancep` with the
    /// minus sign. `p >= 2`, `n >= 1`.
    ///
    /// # Errors
    /// [`TheoryError::TooFewLoops`], [`TheoryError::ResonanceIndex`] for smaller `p` or `n`.
    pub fn virtual_resonance_frequency(&self, p: u32, n: u32) -> Result<f64, TheoryError> {
        if p < 2 {
            return Err(TheoryError::TooFewLoops { loops: p, minimum: 2 });
        }
        if n < 1 {
            return Err(TheoryError::ResonanceIndex { loops: p, index: n, minimum: 1 });
        }
        Ok(self.damped_natural_frequency() / (f64::from(n) - 0.5 / f64::from(p)))
    }

    /// All resonances of the given numbers of loops with `lowest <= omega <= highest`, by
    /// increasing frequency.
    ///
    /// Paper: section 3, eq. (12) and (13), `eq:resonance1`, `eq:resonancep`.
    ///
    /// `loops`: the values of p, each at least 1; repetitions count once. `lowest`, `highest`:
    /// forcing frequencies. The list is empty when the window holds none.
    ///
    /// # Errors
    /// [`TheoryError::FrequencyWindow`] unless `0 < lowest <= highest < infinity`;
    /// [`TheoryError::TooFewLoops`] when a p is zero; [`TheoryError::TooManyResonances`] when more
    /// than 100 000 of one p lie in the window.
    pub fn resonances(
        &self,
        loops: &[u32],
        lowest: f64,
        highest: f64,
    ) -> Result<Vec<Resonance>, TheoryError> {
        if !(0.0 < lowest && lowest <= highest && highest.is_finite()) {
            return Err(TheoryError::FrequencyWindow { lowest, highest });
        }
        let mut loops = loops.to_vec();
        loops.sort_unstable();
        loops.dedup();
        let omega_1 = self.damped_natural_frequency();
        let mut found = Vec::new();
        for p in loops {
            if p == 0 {
                return Err(TheoryError::TooFewLoops { loops: p, minimum: 1 });
            }
            let spacing = Resonance::index_spacing(p);
            let count = (omega_1 / lowest - omega_1 / highest) / spacing;
            let last = omega_1 / lowest / spacing + 1.0;
            if !(count <= f64::from(LARGEST_LIST) && last < f64::from(u32::MAX)) {
                return Err(TheoryError::TooManyResonances { loops: p, count, limit: LARGEST_LIST });
            }
            // One index more at either end than the quotients give: membership is decided by the
            // frequency itself.
            let first = (omega_1 / highest / spacing - 1.0).max(0.0) as u32;
            for n in first.max(Resonance::smallest_index(p))..=last as u32 {
                let resonance = self.resonance(p, n)?;
                if (lowest..=highest).contains(&resonance.forcing_frequency()) {
                    found.push(resonance);
                }
            }
        }
        found.sort_by(|a, b| a.forcing_frequency().total_cmp(&b.forcing_frequency()));
        Ok(found)
    }
}
