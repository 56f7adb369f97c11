//! All p-loop solutions of the linear oscillator at one frequency, with their folds and flips.
//!
//! Returning to (0, y) after p forcing periods from (0, −εy) is a condition linear in y and in 𝒜
//! (cos z, sin z): 𝒜 (cos z, sin z) = a + b y. So 𝒜² = |a + b y|² gives all solutions, at most two
//! at each amplitude, with a fold where y = −a·b/|b|². A multiplier is −1 where an expression
//! linear in y vanishes. Simulation decides which are MPSs. Only the equations of motion are used.

use crate::*;
use grazing_unfold::simulation::Suspect;

/// The p-loop solutions at one frequency, for all amplitudes.
#[derive(Clone, Copy, Debug)]
pub struct LoopSolutions {
    zeta: f64,
    epsilon: f64,
    omega: f64,
    /// The free motion of (x, y) over p forcing periods.
    propagator: Matrix2<f64>,
    /// Position and velocity of the forced response, as a linear function of 𝒜 (cos z, sin z).
    response: Matrix2<f64>,
    a: Vector2<f64>,
    b: Vector2<f64>,
    decay: f64,
}

/// One solution: an MPS of the hybrid system if y > 0 and no loop meets the wall in between.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoopSolution {
    /// Impact velocity y.
    pub velocity: f64,
    /// Impact phase z in (−π, π].
    pub phase: f64,
    /// Forcing amplitude 𝒜.
    pub amplitude: f64,
    /// The difference 𝒜 − 𝒜_graz, computed without cancellation.
    pub mu: f64,
    /// The trace T of eq:TD.
    pub trace: f64,
    /// The determinant D of eq:TD.
    pub determinant: f64,
}

impl LoopSolution {
    /// The impact of the solution, for tests in the hybrid system.
    pub(crate) fn suspect<'a, O>(&self, oscillator: &'a O, loops: u32) -> Suspect<'a, O> {
        Suspect { oscillator, loops, velocity: self.velocity, phase: self.phase }
    }
}

impl LoopSolutions {
    /// The solutions for damping ratio ζ, restitution ε, forcing frequency ω and p = `loops`.
    ///
    /// The arguments must satisfy 0 < ζ < 1 and ε, ω > 0; otherwise the results are NaN.
    pub fn new(zeta: f64, epsilon: f64, omega: f64, loops: u32) -> Self {
        let time = TAU * f64::from(loops) / omega;
        let omega_1 = (1.0 - zeta * zeta).sqrt();
        let decay = libm::exp(-zeta * time);
        let (c, q) = (decay * libm::cos(omega_1 * time), decay * libm::sin(omega_1 * time) / omega_1);
        let propagator = Matrix2::new(c + zeta * q, q, -q, c - zeta * q);
        let (stiffness, loss) = (1.0 - omega * omega, 2.0 * zeta * omega);
        let square = stiffness * stiffness + loss * loss;
        let response = Matrix2::new(stiffness, loss, omega * loss, -omega * stiffness) / square;
        // The response times its transpose is diagonal, so that there is no division by a small
        // determinant.
        let from_response = Matrix2::new(stiffness, loss / omega, loss, -stiffness / omega);
        let rest = Matrix2::identity() - propagator;
        let determinant = rest.determinant();
        let inverse = Matrix2::new(rest[(1, 1)], -rest[(0, 1)], -rest[(1, 0)], rest[(0, 0)]) / determinant;
        let velocity = Vector2::new(0.0, 1.0);
        let a = from_response * Vector2::new(1.0, 0.0);
        let b = from_response * (inverse * (velocity + propagator * velocity * epsilon));
        Self { zeta, epsilon, omega, propagator, response, a, b, decay }
    }

    /// The grazing amplitude 𝒜_graz.
    pub fn grazing_amplitude(&self) -> f64 {
        self.a.norm()
    }

    /// The solution with a given impact velocity of either sign.
    pub fn with_velocity(&self, velocity: f64) -> LoopSolution {
        let direction = self.a + self.b * velocity;
        let amplitude = direction.norm();
        let excess = (2.0 * self.a.dot(&self.b) + self.b.norm_squared() * velocity) * velocity;
        LoopSolution {
            velocity,
            phase: libm::atan2(direction[1], direction[0]),
            amplitude,
            mu: excess / (amplitude + self.grazing_amplitude()),
            trace: self.propagated_velocity() + 1.0 - self.leak(velocity) / velocity,
            determinant: self.determinant(),
        }
    }

    /// All solutions at 𝒜 = 𝒜_graz + μ, the one with the smaller |y| first: none, or two.
    pub fn at(&self, mu: f64) -> Vec<LoopSolution> {
        let (half, square) = (self.a.dot(&self.b), self.b.norm_squared());
        let excess = mu * (2.0 * self.grazing_amplitude() + mu);
        let discriminant = half * half + square * excess;
        if discriminant < 0.0 {
            return Vec::new();
        }
        // The root of larger modulus has no cancellation.
        let sum = half + libm::copysign(discriminant.sqrt(), half);
        [excess / sum, -sum / square].map(|velocity| self.with_velocity(velocity)).to_vec()
    }

    /// The fold, where two solutions merge, at y of either sign.
    pub fn saddle_node(&self) -> LoopSolution {
        self.with_velocity(-self.a.dot(&self.b) / self.b.norm_squared())
    }

    /// The solution with multiplier −1, at y of either sign.
    pub fn period_doubling(&self) -> LoopSolution {
        // y (1 + T + D) is linear in y.
        let scaled = |y: f64| (self.propagated_velocity() + 2.0 + self.determinant()) * y - self.leak(y);
        let constant = scaled(0.0);
        self.with_velocity(constant / (constant - scaled(1.0)))
    }

    /// dy/dμ and dz/dμ of the solution that passes through grazing.
    pub fn slopes(&self) -> [f64; 2] {
        let square = self.a.norm_squared();
        let velocity = square.sqrt() / self.a.dot(&self.b);
        [velocity, velocity * (self.a[0] * self.b[1] - self.a[1] * self.b[0]) / square]
    }

    /// The determinant D = ε² E_p².
    pub fn determinant(&self) -> f64 {
        let rebound = self.epsilon * self.decay;
        rebound * rebound
    }

    /// ∂(velocity after p periods)/∂(impact velocity).
    fn propagated_velocity(&self) -> f64 {
        -self.epsilon * self.propagator[(1, 1)]
    }

    /// The difference in the trace, times y, due to the return to the wall instead of to the impact
    /// phase.
    fn leak(&self, velocity: f64) -> f64 {
        let direction = self.a + self.b * velocity;
        let turned = Vector2::new(-direction[1], direction[0]);
        let by_phase = (Matrix2::identity() - self.propagator) * (self.response * turned);
        let acceleration = direction[0] - 1.0 - 2.0 * self.zeta * velocity;
        -self.epsilon * self.propagator[(0, 1)] * acceleration + self.omega * by_phase[0]
    }
}
