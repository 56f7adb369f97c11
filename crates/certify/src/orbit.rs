//! The closed forms: motion with one impact in p periods, its trace and determinant. `docs/proof.md`
//! derives them.
//!
//! Time is measured as the phase `θ = ω t` since the impact, and in turns `s = θ/(2π)`; the variable is
//! `ν = ω₁/ω`, in which the resonances are rational, and the velocity at impact is `v = dx/dθ = y/ω`.

use crate::ball::{Ball, Number};

/// The oscillator: the constants in the closed forms.
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

/// The motions with one impact in p periods at one ν, which differ only in `v`.
#[derive(Debug, Clone, Copy)]
pub struct MotionFamily<N> {
    /// `ω₁/ω`.
    pub nu: N,
    /// The coefficient of the free part's cosine, for `v = 1`.
    pub c: N,
    /// The coefficient of the free part's sine, for `v = 1`.
    pub e: N,
    /// `ε` plus the slope of the free part at the impact, for `v = 1`.
    pub w: N,
    /// The numerator of `b/v` in the trace `1 + D − P + b/v`, which is below `1 + D` where `P v − b > 0`.
    pub b: N,
    /// `P = (c² + w²) Δ`.
    pub big_p: N,
    /// `Q = 2 (1 + D) − P`; the trace is above `−(1 + D)` where `Q v + b > 0`.
    pub big_q: N,
}

/// A motion of a family:
/// `x(θ) = −1 + f₁ cos θ + f₂ sin θ + e^(−kνθ) (h₁ cos νθ + h₂ sin νθ)`.
#[derive(Debug, Clone, Copy)]
pub struct ClosedFormMotion<N> {
    /// `ω₁/ω`.
    pub nu: N,
    /// `f₁ = 1 − c v` and `f₂ = −w v`.
    pub forced: [N; 2],
    /// `h₁ = c v` and `h₂ = e v`.
    pub free: [N; 2],
}

impl Oscillator {
    /// The oscillator with these constants; nothing unless 0 < ζ < 1 and 0 < ε ≤ 1, so that motion
    /// contracts areas.
    pub fn new(zeta: Ball, epsilon: Ball) -> Option<Self> {
        let omega_1 = (Ball::ONE - zeta * zeta).sqrt();
        let decay = zeta * omega_1.inverse();
        let contracts = !(Ball::ONE - epsilon).bottom().is_negative();
        let valid = [zeta, omega_1, epsilon].into_iter().all(Ball::is_positive) && contracts;
        valid.then_some(Self { zeta, epsilon, omega_1, decay })
    }

    /// `ω₁/x`, which converts ω to ν and ν to ω.
    pub fn omega_1_over<N: Number>(&self, x: N) -> N {
        N::from(self.omega_1) * x.inverse()
    }

    /// `e^(−2πkν s)`, and the sine and cosine of `2πν s`.
    pub fn free<N: Number>(&self, nu: N, turns: N) -> (N, N, N) {
        let decay = (N::from(-(Ball::PI + Ball::PI) * self.decay) * nu * turns).exp();
        let (sine, cosine) = (nu * turns).turn();
        (decay, sine, cosine)
    }

    /// The motions with one impact in `p` periods.
    pub fn family<N: Number>(&self, p: i64, nu: N) -> MotionFamily<N> {
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
        MotionFamily { nu, c, e, w, b: c * delta, big_p, big_q }
    }

    /// The distance of the motion from the wall, `−x`, and its first derivatives in θ.
    pub fn distance<N: Number, const ORDERS: usize>(
        &self,
        motion: &ClosedFormMotion<N>,
        turns: N,
    ) -> [N; ORDERS] {
        let &ClosedFormMotion { nu, mut forced, mut free } = motion;
        let (k, mut constant) = (N::from(self.decay), N::from(Ball::ONE));
        let (decay, free_sine, free_cosine) = self.free(nu, turns);
        let (sine, cosine) = turns.turn();
        core::array::from_fn(|_| {
            let distance = constant
                - (forced[0] * cosine + forced[1] * sine)
                - decay * (free[0] * free_cosine + free[1] * free_sine);
            constant = Ball::ZERO.into();
            forced = [forced[1], -forced[0]];
            free = [nu * (free[1] - k * free[0]), -(nu * (k * free[1] + free[0]))];
            distance
        })
    }

    /// `A_graz² = (1 − ω²)² + 4 ζ² ω²`.
    pub fn grazing_square<N: Number>(&self, nu: N) -> N {
        let omega = self.omega_1_over(nu);
        let square = omega * omega;
        let rest = N::from(Ball::ONE) - square;
        let damping = self.zeta + self.zeta;
        rest * rest + N::from(damping * damping) * square
    }

    /// `A_graz² (c² + w²)`, an upper bound of the square of `dA/dv`.
    pub fn steepness_square<N: Number>(&self, MotionFamily { nu, c, w, .. }: &MotionFamily<N>) -> N {
        self.grazing_square(*nu) * (*c * *c + *w * *w)
    }

    /// The square of the amplitude at which the motion has this velocity: `A² = A_graz² (f₁² + f₂²)`.
    pub fn amplitude_square<N: Number>(&self, motion: &ClosedFormMotion<N>) -> N {
        let [cosine, sine] = motion.forced;
        self.grazing_square(motion.nu) * (cosine * cosine + sine * sine)
    }
}

impl<N: Number> MotionFamily<N> {
    /// The velocity at which a multiplier is 1 or −1.
    pub fn velocity_at(&self, multiplier: i8) -> N {
        if multiplier > 0 { self.b * self.big_p.inverse() } else { -(self.b * self.big_q.inverse()) }
    }

    /// The motion with velocity `v` at impact.
    pub fn motion(&self, v: N) -> ClosedFormMotion<N> {
        let free = [self.c * v, self.e * v];
        ClosedFormMotion { nu: self.nu, forced: [N::from(Ball::ONE) - free[0], -(self.w * v)], free }
    }
}
