//! The resonances: where they are, what Theorems 2.4 and 2.5 ask for, and their coefficients.

use crate::ball::{Ball, Number as _};
use crate::orbit::Oscillator;
use crate::series::Series;

/// A resonance, with what is proved of it.
#[derive(Debug, Clone)]
pub struct Resonance {
    /// Its number of loops.
    pub p: u32,
    /// Its index.
    pub n: u32,
    /// Its frequency.
    pub omega: Ball,
    /// The grazing amplitude there.
    pub amplitude: Ball,
    /// `s_p^+`: its sign says on which side of the SN curve motion is stable.
    pub s_plus: Ball,
    /// `s_p^-`, likewise for the PD curve.
    pub s_minus: Ball,
    /// `c_SN,p`.
    pub saddle_node: Ball,
    /// `c_PD,p`.
    pub period_doubling: Ball,
    /// `C s⁻`: near the resonance period doubling is supercritical just if it is negative.
    /// `docs/beyond.md`, section 2, with the limit map's `r = a φ²`, `k = α² ξ_p` and `d`.
    pub criticality: Ball,
    /// The hypotheses of Theorem 2.4 or 2.5 that could not be shown: none if all hold.
    pub missing: Vec<&'static str>,
}

impl Resonance {
    /// The resonance with index `n`: `ν = n/2` for p = 1, `n + 1/(2p)` for p ≥ 2 (`eq:resonance1`,
    /// `eq:resonancep`), with the coefficients of Propositions 3.2 and 3.3 (`eq:impFormula1odd`,
    /// `eq:impFormula1even`, `eq:impFormulap`).
    pub fn new(oscillator: &Oscillator, p: u32, n: u32) -> Self {
        let (one, two, loops) = (Ball::ONE, Ball::from(2), i64::from(p));
        let Oscillator { epsilon, omega_1, .. } = *oscillator;
        let index = i64::from(n);
        let nu = if p == 1 { Ball::ratio(index, 2) } else { Ball::ratio(2 * loops * index + 1, 2 * loops) };
        let omega = omega_1 * nu.inverse();
        let amplitude = oscillator.grazing_square(nu).sqrt();
        // The resonance is where the free oscillation makes whole or half turns in p periods, and is
        // multiplied by σ: a₂₂ for p = 1, −δ^(p/2) for p ≥ 2.
        let (decay, _, cosine) = oscillator.free(nu, loops.into());
        let sigma = decay * cosine;
        let (alpha, rebound) = (one + epsilon, -(epsilon * sigma));
        let fraction = alpha * sigma * ((one - rebound) * (one - sigma)).inverse();
        let radians = Ball::PI * Ball::from(loops) * fraction * omega.inverse();
        let saddle_node = -(two * radians * radians * amplitude);
        let (less, more) = ((one - rebound) * (one - rebound), (one + rebound) * (one + rebound));
        let (s_plus, s_minus) = (-less, more);
        let bracket = more + two * (one + rebound * rebound);
        let period_doubling = -(less * bracket * (more * more).inverse() * saddle_node);
        let criticality = (one - epsilon * epsilon * sigma) * (one + sigma) * (one + sigma)
            - alpha * alpha * sigma * (sigma - one);

        let (decay, sine, cosine) = oscillator.free(nu, one);
        let (delta, tau) = (decay * decay, two * decay * cosine);
        let trapesium = [delta, one - delta, one + delta - tau, one + delta + tau];
        let off_diagonal = oscillator.family(loops, Series::variable(nu)).b;
        let beta = (one + delta - tau) * amplitude.inverse();
        let hypotheses = [
            ("(tau, delta) in T", trapesium.into_iter().all(Ball::is_positive)),
            ("alpha > 0, or a_12 alpha > 0", if p == 1 { alpha } else { sine * alpha }.is_positive()),
            ("beta, not zero", beta.is_not_zero()),
            ("a_12' or kappa_p', not zero", off_diagonal.0[1].is_not_zero()),
            ("s^+ and s^-, not zero", s_plus.is_not_zero() && s_minus.is_not_zero()),
        ];
        let missing = hypotheses.into_iter().filter(|(_, holds)| !holds).map(|(name, _)| name).collect();
        let criticality = s_minus * criticality;
        let mut found = Self {
            p,
            n,
            omega,
            amplitude,
            s_plus,
            s_minus,
            saddle_node,
            period_doubling,
            criticality,
            missing,
        };
        if found.numbers().iter().any(|(_, number)| number.units().is_none()) {
            found.missing.push("a number is too large for the balls");
        }
        found
    }

    /// Its numbers, by their names.
    pub fn numbers(&self) -> [(&'static str, Ball); 7] {
        [
            ("omega*", self.omega),
            ("A_graz", self.amplitude),
            ("s^+", self.s_plus),
            ("s^-", self.s_minus),
            ("c_SN", self.saddle_node),
            ("c_PD", self.period_doubling),
            ("C s^-", self.criticality),
        ]
    }

    /// Those of some numbers of loops in a window, by frequency.
    pub fn in_window(oscillator: &Oscillator, loops: &[u32], [lowest, highest]: [Ball; 2]) -> Vec<Self> {
        let mut found: Vec<Self> = Vec::new();
        for &p in loops {
            for n in u32::from(p == 1).. {
                let resonance = Self::new(oscillator, p, n);
                if (lowest - resonance.omega).is_positive() {
                    break;
                }
                if !(resonance.omega - highest).is_positive() {
                    found.push(resonance);
                }
            }
        }
        found.sort_by(|a, b| a.omega.to_f64().total_cmp(&b.omega.to_f64()));
        found
    }
}
