//! The resonances: their locations, the hypotheses of Theorems 2.4 and 2.5, and their coefficients.

use crate::ball::{Ball, Number as _};
use crate::orbit::Oscillator;
use crate::series::Series;

/// The names of the numbers of a resonance: its frequency; the grazing amplitude there; `s_p^+` and
/// `s_p^-`, whose signs determine on which side of the SN curve and of the PD curve motion is stable;
/// `c_SN,p` and `c_PD,p`; and `C s⁻`: near the resonance, period doubling is supercritical if and only if
/// this is negative. `docs/beyond.md`, section 2, derives that, with the limit map's `r = a φ²`,
/// `k = α² ξ_p` and `d`.
pub const NAMES: [&str; 7] =
    ["omega_star", "amplitude_graz", "s_plus", "s_minus", "c_sn", "c_pd", "criticality"];

/// A resonance, with proved enclosures of its numbers.
#[derive(Debug, Clone)]
pub struct EnclosedResonance {
    /// The number of loops p.
    pub p: u32,
    /// The index n.
    pub n: u32,
    /// The numbers of the resonance, in the order of [`NAMES`].
    pub numbers: [Ball; NAMES.len()],
    /// The hypotheses of Theorem 2.4 or 2.5 that could not be proved, without commas, and whether there are numbers
    /// of which no digit is certain; empty if all hold and there are none.
    pub missing: Vec<&'static str>,
}

impl EnclosedResonance {
    /// The resonance with index `n`: `ν = n/2` for p = 1, `n + 1/(2p)` for p ≥ 2 (`eq:resonance1`,
    /// `eq:resonancep`), with the coefficients of Propositions 3.2 and 3.3 (`eq:impFormula1odd`,
    /// `eq:impFormula1even`, `eq:impFormulap`).
    pub fn new(oscillator: &Oscillator, p: u32, n: u32) -> Self {
        let (one, two, loops, index) = (Ball::ONE, Ball::from(2), i64::from(p), i64::from(n));
        let epsilon = oscillator.epsilon;
        let nu = if p == 1 { Ball::ratio(index, 2) } else { Ball::ratio(2 * loops * index + 1, 2 * loops) };
        let omega = oscillator.omega_1_over(nu);
        let amplitude = oscillator.grazing_square(nu).sqrt();
        // At the resonance the free oscillation makes whole or half turns in p periods, and is multiplied
        // by σ: a₂₂ for p = 1, −δ^(p/2) for p ≥ 2.
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
        let off_diagonal = oscillator.family(loops, Series::variable(nu, nu, one)).b;
        let beta = (one + delta - tau) * amplitude.inverse();
        let hypotheses = [
            ("(tau; delta) in T", trapesium.into_iter().all(Ball::is_positive)),
            (
                if p == 1 { "alpha > 0" } else { "a_12 alpha > 0" },
                if p == 1 { alpha } else { sine * alpha }.is_positive(),
            ),
            ("beta not zero", !beta.contains(Ball::ZERO)),
            (
                if p == 1 { "a_12' not zero" } else { "kappa_p' not zero" },
                !off_diagonal.0[0][1].contains(Ball::ZERO),
            ),
            ("s^+ and s^- not zero", !s_plus.contains(Ball::ZERO) && !s_minus.contains(Ball::ZERO)),
        ];
        let numbers =
            [omega, amplitude, s_plus, s_minus, saddle_node, period_doubling, s_minus * criticality];
        // Some are too great for balls, or less than these can tell from zero.
        let known = ("a digit of each number", numbers.iter().all(|number| number.to_string() != "?"));
        let missing = hypotheses.into_iter().chain([known]).filter(|(_, holds)| !holds).map(|(name, _)| name);
        Self { p, n, numbers, missing: missing.collect() }
    }

    /// The resonances with these numbers of loops in a window, by frequency.
    pub fn in_window(oscillator: &Oscillator, loops: &[u32], [lowest, highest]: [Ball; 2]) -> Vec<Self> {
        // The frequency decreases with n.
        let of = |&p: &u32| {
            (u32::from(p == 1)..)
                .map(move |n| Self::new(oscillator, p, n))
                .skip_while(|above| (above.numbers[0] - highest).is_positive())
                .take_while(|within| !(lowest - within.numbers[0]).is_positive())
        };
        let mut found: Vec<Self> = loops.iter().flat_map(of).collect();
        found.sort_by(|a, b| a.numbers[0].to_f64().total_cmp(&b.numbers[0].to_f64()));
        found
    }
}
