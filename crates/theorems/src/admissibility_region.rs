//! Where the p-loop maximal periodic solutions at a generic grazing bifurcation are admissible, over the
//! whole trapesium. Not in the paper, which has this for τ > h_p(δ), a₁₂α > 0.
//!
//! To first order in μ the visits of the p-loop MPS are at x⁽ʲ⁾ = (βμ/S_p) u⁽ʲ⁾, `eq:ujwj`, and its impact velocity
//! is y = (γ det K/(α a₁₂ ω S_p)) μ with det K of the sign of β, `eq:yStarpcodim1proof`. So y > 0 exactly if βμ/S_p
//! has the sign of a₁₂α, and **the MPS is admissible exactly if a₁₂α u⁽ʲ⁾ < 0 for 0 < j < p**
//! ([`admissibility_margin`]); it is then on the side of βμ a₁₂α S_p > 0.
//!
//! # As δ → 1
//!
//! Write τ = 2√δ cos 2πx, with 0 < x < ½ if a₁₂α > 0 and ½ < x < 1 if not: for the linear oscillator x is the fractional
//! part of ω₁/ω, since a₁₂ has the sign of sin 2πx. At δ = 1 the sums over S_j = sin 2πjx/sin 2πx are
//!
//! ```text
//! u⁽ʲ⁾ sin 2πx = − sin(πpx) sin(πjx) sin(π(p − j)x)/sin²(πx).
//! ```
//!
//! sin πjx has the sign of (−1)^⌊jx⌋, and ⌊jx⌋ + ⌊(p − j)x⌋ is ⌊px⌋ or one less. So the MPS is admissible exactly if it is
//! never one less, that is, with { } for fractional parts,
//!
//! ```text
//! {jx} ≤ {px} for 0 < j < p:
//! ```
//!
//! **p forcing periods bring the phase of free motion nearer to a whole turn, from below, than fewer do**
//! ([`is_closest_return`]): p is the denominator of a best approximation m/p > x. Those x lie between m/p, for any m that
//! has no divisor in common with p, and the greatest fraction below it with a smaller denominator, the left neighbour l of
//! m/p in Farey's sequence. There is one [`AdmissibilityRegion`] for each of these m. The one of m = 1 is that of
//! Theorem 2.3, between h_p and the side τ = δ + 1: h_p → 2 cos(2π/p).
//!
//! S_p = 0 at multiples of 1/(2p), but m/p − l = 1/(pq), q < p the denominator of l: no resonance lies in a region unless
//! q = 1, which is m = 1. In all others {px} > ½, so that βμ < 0: **these MPSs coexist with the stable non-impacting motion.**
//!
//! # For δ < 1
//!
//! Each region is bounded by one curve, on which the visit p − q touches the wall ([`AdmissibilityRegion::touching_visit`];
//! computed for p ≤ 12, not derived), and by a slanted side if l is 0 or ½. For m = 1 the curve is h_p. Where l = ½, p is odd,
//! and the region reaches down to δ = 0 along τ = −(δ + 1): there u⁽ʲ⁾ has the sign of δʲ − δᵖ for odd j and of 1 − δʲ for
//! even j. The curve of any other hangs down from both its ends at δ = 1 ([`AdmissibilityRegion::lowest_determinant`]).

use core::f64::consts::PI;

use crate::auxiliary::{lucas_partial_sum, lucas_sequence, resonance_boundary};
use crate::generic_theorem::Side;

/// How far the `p`-loop MPS is from an interior visit to the wall, and which visit is nearest: the least of
/// −u⁽ʲ⁾ times the sign of a₁₂α over 0 < j < p. The MPS is admissible where it is positive.
///
/// `p` ≥ 2. `tau`, `delta`: in the trapesium. Dimensionless.
pub fn admissibility_margin(p: u32, tau: f64, delta: f64, factor: Side) -> (f64, u32) {
    let [last, whole] = [lucas_sequence(p, tau, delta), lucas_partial_sum(p, tau, delta)];
    let (mut before, mut here, mut sum) = (0.0, 1.0, 0.0);
    let mut nearest = (f64::INFINITY, 0);
    for j in 1..p {
        // −u⁽ʲ⁾ = S_j T_p − S_p T_j.
        let margin = factor.signum() * (here * whole - last * sum);
        if margin < nearest.0 {
            nearest = (margin, j);
        }
        sum += here;
        (before, here) = (here, tau * here - delta * before);
    }
    nearest
}

/// Whether `p` returns bring a rotation by `x` turns nearer to a whole number of turns, from below,
/// than any smaller number of returns: {jx} ≤ {px} for 0 < j < p.
pub fn is_closest_return(p: u32, x: f64) -> bool {
    let part = |j: u32| (f64::from(j) * x).fract();
    (1..p).all(|j| part(j) <= part(p))
}

/// The part of the trapesium in which p-loop MPSs are admissible that ends at x = m/p on its side δ = 1.
/// Where l = ½ its width goes as δᵖ⁻², which rounding hides for the least δ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AdmissibilityRegion {
    /// The number of loops p, at least 2.
    pub loops: u32,
    /// The number of turns m: between 0 and p, without a divisor in common with it.
    pub turns: u32,
}

/// Number of traces at which the margin is evaluated to find its maximum, and number of halvings of
/// an interval.
const SAMPLES: u32 = 64;
const HALVINGS: u32 = 52;

impl AdmissibilityRegion {
    /// All regions of `p` ≥ 2, by m.
    pub fn all(p: u32) -> Vec<Self> {
        let of = |turns| Self { loops: p, turns };
        (1..p).map(of).filter(|region| region.inverse().is_some()).collect()
    }

    /// The denominator q of l: mq = 1 modulo p.
    fn inverse(&self) -> Option<u32> {
        (1..self.loops).find(|q| self.turns * q % self.loops == 1)
    }

    /// The rotations x between which the region lies at δ = 1: l and m/p.
    pub fn rotations(&self) -> [f64; 2] {
        let q = self.inverse().unwrap_or(1);
        let left = (self.turns * q - 1) / self.loops;
        [f64::from(left) / f64::from(q), f64::from(self.turns) / f64::from(self.loops)]
    }

    /// The number of the visit that touches the wall on the boundary of the region, p − q.
    pub fn touching_visit(&self) -> u32 {
        self.loops - self.inverse().unwrap_or(1)
    }

    /// The sign of a₁₂α in the region.
    pub fn factor(&self) -> Side {
        if 2 * self.turns <= self.loops { Side::Positive } else { Side::Negative }
    }

    /// Traces between which the region must lie: rotations as at δ = 1, and the slanted sides.
    fn bracket(&self, delta: f64) -> [f64; 2] {
        let trace = |x: f64| match x {
            0.0 => 1.0 + delta,
            0.5 => -1.0 - delta,
            _ => resonance_boundary(0.5 / x.min(1.0 - x), delta),
        };
        let [low, high] = self.rotations().map(trace);
        [low.min(high), low.max(high)]
    }

    /// The trace at which the margin is largest.
    fn deepest(&self, delta: f64) -> f64 {
        let [low, high] = self.bracket(delta);
        let margin = |tau: &f64| admissibility_margin(self.loops, *tau, delta, self.factor()).0;
        let step = (high - low) / f64::from(SAMPLES);
        let samples = (0..=SAMPLES).map(|k| low + step * f64::from(k));
        let best = samples.max_by(|a, b| margin(a).total_cmp(&margin(b))).unwrap_or(low);
        // The least of several smooth functions has a kink at its maximum, so the interval shrinks
        // by thirds.
        let (mut from, mut to) = ((best - step).max(low), (best + step).min(high));
        for _ in 0..HALVINGS {
            let third = (to - from) / 3.0;
            let inner = [from + third, to - third];
            if margin(&inner[0]) < margin(&inner[1]) { from = inner[0] } else { to = inner[1] }
        }
        // A slanted side is an end of the bracket, where the margin need not be zero.
        let candidates = [0.5 * (from + to), best, low, high];
        candidates.into_iter().max_by(|a, b| margin(a).total_cmp(&margin(b))).unwrap_or(best)
    }

    /// The traces between which the region lies at 0 < `delta` < 1, if it reaches that far down,
    /// each with the number of the visit that touches the wall there; `None` for the visit at a
    /// slanted side of the trapesium.
    pub fn traces(&self, delta: f64) -> Option<[(f64, Option<u32>); 2]> {
        let middle = self.deepest(delta);
        let margin = |tau: f64| admissibility_margin(self.loops, tau, delta, self.factor());
        (margin(middle).0 > 0.0).then(|| {
            self.bracket(delta).map(|end| {
                if margin(end).0 > 0.0 {
                    return (end, None);
                }
                let (mut inside, mut outside) = (middle, end);
                for _ in 0..HALVINGS {
                    let half = 0.5 * (inside + outside);
                    if margin(half).0 > 0.0 { inside = half } else { outside = half }
                }
                (inside, Some(margin(outside).1))
            })
        })
    }

    /// The determinant at the lower end of the region; 0 where it reaches all the way down.
    pub fn lowest_determinant(&self) -> f64 {
        let [left, _] = self.rotations();
        if left == 0.0 || left == 0.5 {
            return 0.0;
        }
        let is_there =
            |delta: f64| admissibility_margin(self.loops, self.deepest(delta), delta, self.factor()).0 > 0.0;
        let (mut below, mut above) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let half = 0.5 * (below + above);
            if is_there(half) { above = half } else { below = half }
        }
        above
    }
}

/// The rotation x of grazing orbits with complex eigenvalues: τ = 2√δ cos 2πx, beyond ½ where a₁₂α < 0.
/// Not a number if eigenvalues are real.
pub fn rotation(tau: f64, delta: f64, factor: Side) -> f64 {
    let x = libm::acos(0.5 * tau / delta.sqrt()) / (2.0 * PI);
    if factor == Side::Positive { x } else { 1.0 - x }
}
