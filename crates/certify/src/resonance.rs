//! The resonances: where they are, what Theorems 2.4 and 2.5 ask for, and their coefficients.

use crate::ball::Ball;
use crate::orbit::Oscillator;

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
    /// The resonance with index `n`: `ν = n/2` for p = 1, `n + 1/(2p)` for p ≥ 2. Paper:
    /// `eq:resonance1`, `eq:resonancep`, `eq:coeffs1`, `eq:coeffsp`.
    pub fn new(oscillator: &Oscillator, p: u32, n: u32) -> Self {
        let whole = |n: u32| Ball::from(i64::from(n));
        let (one, two) = (Ball::ONE, whole(2));
        let Oscillator { zeta, epsilon, omega_1, decay } = *oscillator;
        let ratio = |n: u32, d: u32| Ball::ratio(n.into(), d.into());
        let nu = if p == 1 { ratio(n, 2) } else { ratio(2 * p * n + 1, 2 * p) };
        let omega = omega_1 * nu.inverse();
        let amplitude = oscillator.grazing_square(nu).sqrt();
        let decay_over = |p: u32| (-(Ball::PI * two * decay) * nu * whole(p)).exp();
        let (e_1, e_p) = (decay_over(1), decay_over(p));
        let (sine, cosine) = nu.turn();
        let (alpha, delta, tau) = (one + epsilon, e_1 * e_1, two * e_1 * cosine);
        let beta = (one + delta - tau) * amplitude.inverse();
        let gamma = omega * omega;
        let a_12 = omega * omega_1.inverse() * e_1 * sine;
        // cos 2πpν: neighbouring motion makes whole turns in p periods, or half a turn less.
        let turns = if p == 1 && n.is_multiple_of(2) { one } else { -one };
        let radians = two * Ball::PI * omega.inverse();
        // a₂₂ for p = 1, and −δ^(p/2) in its place for p ≥ 2.
        let entry = turns * e_p;
        let xi = entry * entry - entry;
        let last = alpha * alpha * gamma * xi * ((one - entry) * gamma).inverse();
        let s = |sign: Ball| (one - sign * entry) * (entry * epsilon * epsilon - sign) + last;
        let (s_plus, s_minus) = (s(one), s(-one));
        let slope = if p == 1 {
            -(radians * entry)
        } else {
            let half_loop = ratio(1, 2 * p).turn().0;
            let derivative = two * radians * omega_1 * omega.inverse() * e_1 * half_loop;
            let scale = two * half_loop * half_loop * (one + e_p);
            whole(p) * a_12 * e_p * e_1.inverse() * e_1.inverse() * derivative * scale.inverse()
        };
        let criticality = s_minus
            * ((one - epsilon * epsilon * entry) * (one + entry) * (one + entry) - alpha * alpha * xi);
        let unfolding = alpha * omega * slope;
        let factor = if p == 1 { one } else { one + delta - tau };
        let saddle_node = unfolding * unfolding * factor * (two * beta * gamma * s_plus).inverse();
        let ratio = s_plus * s_minus.inverse();
        let hypotheses = [
            ("(tau, delta) in T", (one - delta).is_positive() && (one + delta - tau).is_positive()),
            ("(tau, delta) in T", delta.is_positive() && (one + delta + tau).is_positive()),
            ("alpha > 0, or a_12 alpha > 0", if p == 1 { alpha } else { alpha * a_12 }.is_positive()),
            ("beta, not zero", beta.is_not_zero()),
            ("a_12' or kappa_p', not zero", slope.is_not_zero()),
            ("s^+ and s^-, not zero", s_plus.is_not_zero() && s_minus.is_not_zero()),
            ("zeta", zeta.is_positive()),
        ];
        let missing = hypotheses.into_iter().filter(|(_, holds)| !holds).map(|(name, _)| name).collect();
        let period_doubling = ratio * (two - ratio) * saddle_node;
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

    /// The coefficients by Propositions 3.2 and 3.3 (`eq:impFormula1odd`, `eq:impFormula1even`,
    /// `eq:impFormulap`), which must have numbers in common with those of the theorems.
    pub fn propositions(&self, oscillator: &Oscillator) -> [Ball; 2] {
        let (one, two) = (Ball::ONE, Ball::from(2));
        let p = Ball::from(i64::from(self.p));
        let nu = oscillator.omega_1 * self.omega.inverse();
        let decay = (-(Ball::PI * two * oscillator.decay) * nu * p).exp();
        let decay = if self.p == 1 && self.n.is_multiple_of(2) { -decay } else { decay };
        let rebound = oscillator.epsilon * decay;
        let (less, more) = ((one - rebound) * (one - rebound), (one + rebound) * (one + rebound));
        let fraction = (one + oscillator.epsilon) * decay * ((one - rebound) * (one + decay)).inverse();
        let radians = Ball::PI * p * fraction * self.omega.inverse();
        let saddle_node = -(two * radians * radians * self.amplitude);
        let bracket = more + two * (one + rebound * rebound);
        [saddle_node, -(less * bracket * (more * more).inverse() * saddle_node)]
    }
}
