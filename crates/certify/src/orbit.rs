//! The closed forms: motion with one impact in p periods, its trace and determinant. `docs/proof.md`
//! derives them.
//!
//! Time is counted as the phase `θ = ω t` since the impact, and as turns `s = θ/(2π)`; the variable
//! is `ν = ω₁/ω`, in which the resonances are rational, and the velocity at impact is
//! `v = dx/dθ = y/ω`.

use crate::ball::Ball;
use crate::series::Number;

/// The oscillator: what the closed forms take from its constants.
#[derive(Debug, Clone, Copy)]
pub struct Oscillator {
    /// ζ, the damping ratio.
    pub zeta: Ball,
    /// ε, the coefficient of restitution.
    pub epsilon: Ball,
    /// `ω₁ = √(1 − ζ²)`.
    pub omega_1: Ball,
    /// `k = ζ/ω₁`.
    pub decay: Ball,
}

/// The motions with one impact in p periods at one ν, which differ in `v` alone:
/// `x(θ) = −1 + (1 − c v) cos θ − w v sin θ + v e^(−kνθ) (c cos νθ + e sin νθ)`.
#[derive(Debug, Clone, Copy)]
pub struct Family<N> {
    /// `ω₁/ω`.
    pub nu: N,
    /// The free part's cosine, for `v = 1`.
    pub c: N,
    /// Its sine.
    pub e: N,
    /// `ε` and the free part's slope at the impact.
    pub w: N,
    /// The trace is `1 + D − P + b/v`: it is below `1 + D` where `P v − b > 0`.
    pub b: N,
    /// `P = (c² + w²) Δ`.
    pub big_p: N,
    /// It is above `−(1 + D)` where `Q v + b > 0`.
    pub big_q: N,
}

/// One of these motions: `c v`, `e v` and `w v`.
#[derive(Debug, Clone, Copy)]
pub struct Motion<N> {
    /// `ω₁/ω`.
    pub nu: N,
    /// `c v`.
    pub c: N,
    /// `e v`.
    pub e: N,
    /// `w v`.
    pub w: N,
}

impl Oscillator {
    /// With these constants; nothing if they are not within 0 < ζ < 1 and 0 < ε.
    pub fn new(zeta: Ball, epsilon: Ball) -> Option<Self> {
        let omega_1 = (Ball::ONE - zeta * zeta).sqrt();
        let decay = zeta * omega_1.inverse();
        let valid = zeta.is_positive() && omega_1.is_positive() && epsilon.is_positive();
        valid.then_some(Self { zeta, epsilon, omega_1, decay })
    }

    /// `e^(−2πkν s)`, and the sine and cosine of `2πν s`.
    fn free<N: Number>(&self, nu: N, turns: N) -> (N, N, N) {
        let decay = (N::from(-(Ball::PI + Ball::PI) * self.decay) * nu * turns).exp();
        let (sine, cosine) = (nu * turns).turn();
        (decay, sine, cosine)
    }

    /// The motions with one impact in `p` periods.
    pub fn family<N: Number>(&self, p: i64, nu: N) -> Family<N> {
        let [one, k, epsilon] = [Ball::ONE, self.decay, self.epsilon].map(N::from);
        let (decay, sine, cosine) = self.free(nu, Ball::from(p).into());
        let (x, z) = (one - decay * cosine, decay * sine);
        let delta = x * x + z * z;
        let both = N::from(Ball::ONE + self.epsilon) * delta.inverse();
        let over_nu = both * nu.inverse();
        let (c, e) = (-(over_nu * z), -(over_nu * x));
        let w = epsilon - both * (x - k * z);
        let determinant = epsilon * epsilon * decay * decay;
        let big_p = delta * (c * c + w * w);
        let big_q = (one + determinant) + (one + determinant) - big_p;
        Family { nu, c, e, w, b: c * delta, big_p, big_q }
    }

    /// How far the motion is from the wall, `−x`, and the first three derivatives of that in θ.
    pub fn distance<N: Number>(&self, motion: &Motion<N>, turns: N) -> [N; 4] {
        let &Motion { nu, c, e, w } = motion;
        let [one, k] = [Ball::ONE, self.decay].map(N::from);
        let (decay, free_sine, free_cosine) = self.free(nu, turns);
        let (sine, cosine) = turns.turn();
        let along = |c: N, e: N| decay * (c * free_cosine + e * free_sine);
        let derivative = |c: N, e: N| (nu * (e - k * c), -(nu * (k * e + c)));
        let (c1, e1) = derivative(c, e);
        let (c2, e2) = derivative(c1, e1);
        let (c3, e3) = derivative(c2, e2);
        let forced = one - c;
        [
            one - forced * cosine + w * sine - along(c, e),
            forced * sine + w * cosine - along(c1, e1),
            forced * cosine - w * sine - along(c2, e2),
            -(forced * sine + w * cosine) - along(c3, e3),
        ]
    }

    /// `A_graz² = (1 − ω²)² + 4 ζ² ω²`.
    pub fn grazing_square<N: Number>(&self, nu: N) -> N {
        let omega = N::from(self.omega_1) * nu.inverse();
        let square = omega * omega;
        let rest = N::from(Ball::ONE) - square;
        let damping = self.zeta + self.zeta;
        rest * rest + N::from(damping * damping) * square
    }

    /// The square of the amplitude at which the motion has this velocity:
    /// `A² = A_graz² ((1 − c v)² + (w v)²)`.
    pub fn amplitude_square<N: Number>(&self, motion: &Motion<N>) -> N {
        let forced = N::from(Ball::ONE) - motion.c;
        self.grazing_square(motion.nu) * (forced * forced + motion.w * motion.w)
    }
}

impl<N: Number> Family<N> {
    /// The motion with velocity `v` at impact.
    pub fn motion(&self, v: N) -> Motion<N> {
        Motion { nu: self.nu, c: self.c * v, e: self.e * v, w: self.w * v }
    }
}
