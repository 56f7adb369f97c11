//! The resonances of the linear oscillator, and the coefficients there as printed in propositions
//! 3.2 and 3.3.

use core::f64::consts::PI;

use super::{GrazingState, LinearOscillator};
use crate::error::TheoryError;
use crate::unfolding::{ResonantPoint, StabilityCoefficients, Unfolding};

/// A resonant grazing bifurcation of the linear oscillator, with `mu = A - A_graz(omega)` and
/// `eta = omega - omega*`.
///
/// Computed by [`LinearOscillator::resonance`] and [`LinearOscillator::resonances`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resonance {
    grazing: GrazingState,
    loops: u32,
    index: u32,
}

impl Resonance {
    pub(super) fn new(oscillator: LinearOscillator, loops: u32, index: u32) -> Result<Self, TheoryError> {
        if loops == 0 {
            return Err(TheoryError::TooFewLoops { loops, minimum: 1 });
        }
        let minimum = Self::smallest_index(loops);
        if index < minimum {
            return Err(TheoryError::ResonanceIndex { loops, index, minimum });
        }
        let offset = if loops == 1 { 0.0 } else { 0.5 / f64::from(loops) };
        let ratio = f64::from(index) * Self::index_spacing(loops) + offset;
        let grazing = oscillator.grazing(oscillator.damped_natural_frequency() / ratio)?;
        Ok(Self { grazing, loops, index })
    }

    /// The step of `omega_1 / omega` from one index to the next.
    pub(super) fn index_spacing(loops: u32) -> f64 {
        if loops == 1 { 0.5 } else { 1.0 }
    }

    /// The smallest index that gives a positive frequency.
    pub(super) fn smallest_index(loops: u32) -> u32 {
        u32::from(loops == 1)
    }

    /// The number of loops, p.
    pub fn loops(&self) -> u32 {
        self.loops
    }

    /// The index, n.
    pub fn index(&self) -> u32 {
        self.index
    }

    /// The forcing frequency at the resonance, `omega*`, radians per unit of time.
    ///
    /// `2 omega_1 / n` for `p = 1`, `omega_1 / (n + 1 / (2 p))` for `p >= 2`. Paper: section 3, eq.
    /// (12) and (13), `eq:resonance1`, `eq:resonancep`.
    pub fn forcing_frequency(&self) -> f64 {
        self.grazing.forcing_frequency()
    }

    /// The grazing bifurcation at the frequency of the resonance.
    pub fn grazing(&self) -> GrazingState {
        self.grazing
    }

    /// The (1, 2) entry of `A`.
    ///
    /// 0 for `p = 1`; `exp(-2 pi zeta / omega) sin(pi / p) / (n + 1 / (2 p))` for `p >= 2`. Paper:
    /// section 3.4, after eq. (13).
    pub fn off_diagonal(&self) -> f64 {
        if self.loops == 1 {
            return 0.0;
        }
        let p = f64::from(self.loops);
        self.grazing.decay(1) * libm::sin(PI / p) / (f64::from(self.index) + 0.5 / p)
    }

    /// The second derivative in the phase of the position after `p` returns.
    ///
    /// `xi_1 = E_1 (E_1 - (-1)^n)`, `xi_p = E_p (E_p + 1)` for `p >= 2`. Paper: section B, eq. (7)
    /// and (11), `eq:xi1proof3`, `eq:xipproof3`.
    pub fn second_phase_derivative(&self) -> f64 {
        let decay = self.grazing.decay(self.loops);
        match self.rotation() {
            Rotation::HalfTurns => decay * (decay + 1.0),
            Rotation::WholeTurns => -decay * self.grazing.decay_complement(self.loops),
        }
    }

    /// The derivative in `eta` that unfolds the resonance.
    ///
    /// `a12' = 2 pi E_1 / omega` for `p = 1` and odd `n`, `a12' = -2 pi E_1 / omega` for `p = 1`
    /// and even `n`, `kappa_p' = (4 pi omega_1 / omega^2) exp(-2 pi zeta / omega) sin(pi / p)` for
    /// `p >= 2`. Paper: section 3, eq. (15) to (17), `eq:impFormula1odd`, `eq:impFormula1even`,
    /// `eq:impFormulap`.
    pub fn unfolding(&self) -> Unfolding {
        let omega = self.forcing_frequency();
        let decay = self.grazing.decay(1);
        let derivative = if self.loops == 1 {
            let magnitude = 2.0 * PI * decay / omega;
            match self.rotation() {
                Rotation::HalfTurns => magnitude,
                Rotation::WholeTurns => -magnitude,
            }
        } else {
            let omega_1 = self.grazing.oscillator().damped_natural_frequency();
            4.0 * PI * omega_1 / (omega * omega) * decay * libm::sin(PI / f64::from(self.loops))
        };
        Unfolding { loops: self.loops, derivative }
    }

    /// The coefficients of the impact velocity in the conditions for stability multipliers 1
    /// and -1.
    ///
    /// `s_p^+ = -(1 - epsilon E_p)^2`, `s_p^- = (1 + epsilon E_p)^2`; for `p = 1` and even `n` with
    /// `E_1` replaced by `-E_1`. Paper: section 3, eq. (15) to (17), `eq:impFormula1odd`,
    /// `eq:impFormula1even`, `eq:impFormulap` (which prints `s_1` for `s_p`).
    pub fn stability_coefficients(&self) -> StabilityCoefficients {
        let (lessened, raised) = (self.one_minus_rebound(), 1.0 + self.rebound());
        match self.rotation() {
            Rotation::HalfTurns => {
                StabilityCoefficients { plus: -lessened * lessened, minus: raised * raised }
            }
            Rotation::WholeTurns => {
                StabilityCoefficients { plus: -raised * raised, minus: lessened * lessened }
            }
        }
    }

    /// The quadratic coefficient of the saddle-node curve.
    ///
    /// `c_SN,p = -(2 pi^2 p^2 A_graz / omega^2) ((1 + epsilon) E_p / ((1 - epsilon E_p) (1 +
    /// E_p)))^2`; for `p = 1` and even `n` the denominator is `(1 + epsilon E_1) (1 - E_1)`. Paper:
    /// section 3, eq. (15) to (17), `eq:impFormula1odd`, `eq:impFormula1even`, `eq:impFormulap`.
    /// Negative.
    pub fn saddle_node_coefficient(&self) -> f64 {
        let omega = self.forcing_frequency();
        let p = f64::from(self.loops);
        let decay = self.grazing.decay(self.loops);
        let denominator = match self.rotation() {
            Rotation::HalfTurns => self.one_minus_rebound() * (1.0 + decay),
            Rotation::WholeTurns => (1.0 + self.rebound()) * self.grazing.decay_complement(self.loops),
        };
        let fraction = (1.0 + self.grazing.oscillator().coefficient_of_restitution()) * decay / denominator;
        -2.0 * PI * PI * p * p * self.grazing.amplitude() / (omega * omega) * fraction * fraction
    }

    /// The quadratic coefficient of the period-doubling curve.
    ///
    /// `c_PD,p = -(1 - epsilon E_p)^2 ((1 + epsilon E_p)^2 + 2 (1 + epsilon^2 E_p^2))
    ///           / (1 + epsilon E_p)^4 c_SN,p`; for `p = 1` and even `n` with `E_1`
    /// replaced by `-E_1` in the fraction. Paper: section 3, eq. (15) to (17), `eq:impFormula1odd`,
    /// `eq:impFormula1even`, `eq:impFormulap`. Positive.
    pub fn period_doubling_coefficient(&self) -> f64 {
        let (lessened, raised) = (self.one_minus_rebound(), 1.0 + self.rebound());
        let (numerator, denominator) = match self.rotation() {
            Rotation::HalfTurns => (lessened * lessened, raised * raised),
            Rotation::WholeTurns => (raised * raised, lessened * lessened),
        };
        let bracket = denominator + 2.0 * (1.0 + self.rebound() * self.rebound());
        -numerator * bracket / (denominator * denominator) * self.saddle_node_coefficient()
    }

    /// The arguments of the general formulas: `A`, `b`, `phi`, `psi`, `gamma` of section 3, the
    /// second derivative `xi_p` in its general form (section B, eq. (6) and (10)), and the
    /// derivative that unfolds the resonance.
    pub fn resonant_point(&self) -> ResonantPoint {
        ResonantPoint {
            grazing: self.grazing.grazing_point(),
            second_phase_derivative: self.grazing.second_phase_derivative(self.loops),
            unfolding: self.unfolding(),
        }
    }

    /// The rotation of the free oscillation in `p` forcing periods.
    fn rotation(&self) -> Rotation {
        if self.loops == 1 && self.index.is_multiple_of(2) {
            Rotation::WholeTurns
        } else {
            Rotation::HalfTurns
        }
    }

    /// `epsilon E_p`.
    fn rebound(&self) -> f64 {
        self.grazing.oscillator().coefficient_of_restitution() * self.grazing.decay(self.loops)
    }

    /// `1 - epsilon E_p = (1 - epsilon) + epsilon (1 - E_p)`, without cancellation.
    fn one_minus_rebound(&self) -> f64 {
        let epsilon = self.grazing.oscillator().coefficient_of_restitution();
        (1.0 - epsilon) + epsilon * self.grazing.decay_complement(self.loops)
    }
}

/// The angle by which the free oscillation turns in `p` forcing periods, `2 pi p omega_1 / omega`:
/// its cosine distinguishes the formulas for even `n` from the others.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Rotation {
    /// An odd number of half turns, cosine -1: `p = 1` with odd `n`, and all `p >= 2`.
    HalfTurns,
    /// A whole number of turns, cosine 1: `p = 1` with even `n`.
    WholeTurns,
}
