//! The lists of cases.

use grazing_theorems::{LinearOscillator, TheoryError};

/// A linear oscillator on its curve of grazing bifurcations, at a resonance or away from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Case {
    /// Damping ratio ζ.
    pub zeta: f64,
    /// Coefficient of restitution ε.
    pub epsilon: f64,
    /// Number of loops p of the MPS.
    pub loops: u32,
    /// The integer n of the resonance or of the nearest one: ω₁/ω ≈ n/2 for p = 1, in (n, n + 1) for p ≥
    /// 2.
    pub n: u32,
    /// Whether the resonance is at ω₁/ω = n − 1/(2p) instead of n + 1/(2p), so that a₁₂ α < 0.
    pub negative: bool,
    /// Forcing frequency ω.
    pub omega: f64,
}

/// The damping ratios of the cases.
const ZETA: [f64; 4] = [0.005, 0.03, 0.08, 0.3];

/// A coefficient of restitution, or one over 1/E_p, where s_p⁺ vanishes (s_1⁻ for even n).
#[derive(Debug, Clone, Copy)]
enum Restitution {
    Plain(f64),
    OverDecay(f64),
}

use Restitution::{OverDecay, Plain};

const RESTITUTION: [Restitution; 6] =
    [Plain(0.1), Plain(0.8), OverDecay(0.95), Plain(0.5), Plain(1.0), OverDecay(1.05)];

impl Restitution {
    /// The value of ε, unless it is too large or the decay too strong.
    fn value(self, decay: f64) -> Option<f64> {
        match self {
            Plain(epsilon) => (decay >= LEAST_DECAY).then_some(epsilon),
            OverDecay(share) => (decay >= 10.0 * LEAST_DECAY).then_some(share / decay),
        }
    }
}

/// The least decay factor over p periods: below it, p loops differ only at velocities near rounding;
/// below ten times this value, ε near 1/E_p is far too large.
const LEAST_DECAY: f64 = 0.02;

/// Values of ω₁/ω − n for p ≥ 2: about the resonance q = 1/(2p); on both sides of h_p, between 1/(2(p−1))
/// and 1/p by lemma 2.1; where p = 5 has MPSs below h_p; and similar ones with a₁₂ < 0.
fn fractions(p: f64) -> [f64; 14] {
    let (q, before) = (0.5 / p, 0.5 / (p - 1.0));
    let above = 0.5 * (q + before);
    let below = 1.06 / p;
    [
        0.5 * q,
        0.96 * q,
        1.04 * q,
        above,
        below,
        0.36,
        0.46,
        0.58,
        0.64,
        0.77,
        1.0 - above,
        1.0 - 1.04 * q,
        1.0 - 0.96 * q,
        1.0 - 0.5 * q,
    ]
}

/// Values of ω₁/ω − n/2 for p = 1.
const SHIFTS: [f64; 8] = [-0.22, -0.12, -0.05, -0.02, 0.02, 0.05, 0.12, 0.22];

impl Case {
    /// A case with this restitution, unless the restitution is too large or the decay too strong.
    fn of(
        free: &LinearOscillator,
        [loops, n]: [u32; 2],
        omega: f64,
        restitution: Restitution,
        negative: bool,
    ) -> Result<Option<Self>, TheoryError> {
        let (zeta, decay) = (free.damping_ratio(), free.grazing(omega)?.decay(loops));
        Ok(restitution.value(decay).map(|epsilon| Self { zeta, epsilon, loops, n, negative, omega }))
    }
}

/// Grazing bifurcations away from resonances, for theorems 2.2 and 2.3.
///
/// # Errors
/// A parameter of the lists outside its domain: an error in the program.
pub fn generic_cases() -> Result<Vec<Case>, TheoryError> {
    let mut cases = Vec::new();
    let mut restitutions = RESTITUTION.into_iter().cycle();
    for zeta in ZETA {
        let free = LinearOscillator::new(zeta, 1.0)?;
        for loops in 1..=6 {
            for n in first_n(zeta, loops)..=3 {
                let (from, shifts) = if loops == 1 {
                    (0.5 * f64::from(n), SHIFTS.to_vec())
                } else {
                    (f64::from(n), fractions(f64::from(loops)).to_vec())
                };
                for (shift, restitution) in shifts.into_iter().zip(&mut restitutions) {
                    let omega = free.damped_natural_frequency() / (from + shift);
                    cases.extend(Case::of(&free, [loops, n], omega, restitution, false)?);
                }
            }
        }
    }
    Ok(cases)
}

/// Resonances for theorems 2.4 and 2.5, including ones with ω₁/ω = n − 1/(2p) and ε = 1/E_p.
///
/// # Errors
/// A parameter of the lists outside its domain: an error in the program.
pub fn resonant_cases() -> Result<Vec<Case>, TheoryError> {
    let mut cases = Vec::new();
    let mut turn = 0;
    for zeta in ZETA {
        let free = LinearOscillator::new(zeta, 1.0)?;
        for loops in 1..=5 {
            for n in first_n(zeta, loops)..=4 {
                let omega = free.resonance(loops, n)?.forcing_frequency();
                // Half of the restitutions are used here, the other half at the next resonance.
                turn += 1;
                let half = RESTITUTION.into_iter().skip(turn % 2).step_by(2);
                for restitution in half.chain([OverDecay(1.0)]) {
                    cases.extend(Case::of(&free, [loops, n], omega, restitution, false)?);
                }
                if loops > 1 && n > 0 {
                    let omega = free.virtual_resonance_frequency(loops, n)?;
                    for restitution in [Plain(0.8), OverDecay(1.05)] {
                        cases.extend(Case::of(&free, [loops, n], omega, restitution, true)?);
                    }
                }
            }
        }
    }
    Ok(cases)
}

/// The first n: with strong damping the resonances with p ≥ 2 are distinct only at high frequencies, n =
/// 0.
fn first_n(zeta: f64, loops: u32) -> u32 {
    u32::from(loops == 1 || zeta < 0.2)
}
