//! All p-loop MPSs of the linear oscillator at given parameters, without iteration.
//!
//! The condition to return to (0, y) after p forcing periods from (0, −εy) is linear in y and in (cos z, sin z). Solved for the
//! latter it reads (cos z, sin z) = a + b y, and cos² + sin² = 1 is a quadratic equation for y. Nothing of the program but
//! the search for maxima is used.

use core::f64::consts::TAU;

use grazing_model::motion::highest_maximum;
use grazing_model::{ImpactOscillator, LinearOscillator, State};
use nalgebra::{Matrix2, Vector2};

/// One of the at most two p-loop MPSs.
#[derive(Clone, Copy, Debug)]
pub struct Orbit {
    /// Impact velocity y.
    pub velocity: f64,
    /// Impact phase z.
    pub phase: f64,
    /// Trace T of the derivative of the map from impact to impact.
    pub trace: f64,
    /// Its determinant D.
    pub determinant: f64,
    /// The highest interior maximum of x; minus infinity without one.
    pub ceiling: f64,
}

impl Orbit {
    /// Both multipliers lie inside the unit circle; D is less than one for every oscillator of this kind.
    pub fn stable(&self) -> bool {
        self.trace.abs() - 1.0 < self.determinant
    }

    /// It has an impact, and no interior maximum lies above the wall.
    pub fn admissible(&self) -> bool {
        self.velocity > 0.0 && self.ceiling <= 0.0
    }
}

/// The MPSs with p = `loops` at the amplitude and frequency, virtual ones (y < 0) included.
pub fn orbits(zeta: f64, epsilon: f64, amplitude: f64, omega: f64, loops: u32) -> Vec<Orbit> {
    let time = TAU * f64::from(loops) / omega;
    let omega_1 = (1.0 - zeta * zeta).sqrt();
    let decay = libm::exp(-zeta * time);
    let (c, q) = (decay * libm::cos(omega_1 * time), decay * libm::sin(omega_1 * time) / omega_1);
    let propagator = Matrix2::new(c + zeta * q, q, -q, c - zeta * q);
    let (stiffness, loss) = (1.0 - omega * omega, 2.0 * zeta * omega);
    let scale = amplitude / (stiffness * stiffness + loss * loss);
    // Forced position and velocity from (cos z, sin z).
    let forced = Matrix2::new(stiffness, loss, omega * loss, -omega * stiffness) * scale;
    let (e1, e2) = (Vector2::new(1.0, 0.0), Vector2::new(0.0, 1.0));
    let rest = (Matrix2::identity() - propagator).try_inverse().expect("the free oscillator decays");
    let from_forced = forced.try_inverse().expect("the response is not zero");
    let a = from_forced * e1;
    let b = from_forced * (rest * (e2 + propagator * e2 * epsilon));
    let (half, constant) = (a.dot(&b) / b.dot(&b), (a.dot(&a) - 1.0) / b.dot(&b));
    let discriminant = half * half - constant;
    // At a fold that was located to 10⁻¹² it is zero up to that.
    if discriminant < -1e-12 * (half * half + a.dot(&a) / b.dot(&b)) {
        return Vec::new();
    }
    let root = discriminant.max(0.0).sqrt();
    [-half - root, -half + root]
        .into_iter()
        .map(|velocity| {
            let direction = a + b * velocity;
            let phase = libm::atan2(direction[1], direction[0]);
            // Derivatives of the return to the same phase, and of the return to the wall from it.
            let slope = Vector2::new(-direction[1], direction[0]);
            let by_velocity = propagator * e2 * -epsilon;
            let by_phase = (Matrix2::identity() - propagator) * (forced * slope);
            let acceleration = amplitude * direction[0] - 1.0 - 2.0 * zeta * velocity;
            let leak = (acceleration * by_velocity[0] + omega * by_phase[0]) / velocity;
            let oscillator =
                LinearOscillator::new(zeta, epsilon, amplitude, omega).expect("valid parameters");
            let motion = oscillator.motion(State::on_wall(-epsilon * velocity, phase));
            let ceiling =
                highest_maximum(&motion, time).map_or(f64::NEG_INFINITY, |maximum| maximum.position);
            Orbit {
                velocity,
                phase,
                trace: by_velocity[1] + 1.0 - leak,
                determinant: epsilon * epsilon * decay * decay,
                ceiling,
            }
        })
        .collect()
}
