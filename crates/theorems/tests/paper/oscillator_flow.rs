//! The flow of the linear oscillator in any kind of number, and its return map by Newton's method: an
//! independent source of every derivative.

use num_dual::{DualNum, DualNumCopy};

/// Real, dual and hyper-dual numbers.
pub(crate) trait Number: DualNumCopy + DualNum<Primitive = f64> {}
impl<D: DualNumCopy + DualNum<Primitive = f64>> Number for D {}

/// The unconstrained oscillator `x'' + 2 zeta x' + x + 1 = A cos(omega t)`; eq. (3) and (4) of section 3.
pub(crate) struct Flow<D> {
    pub(crate) zeta: f64,
    pub(crate) omega: D,
    pub(crate) amplitude: D,
}

impl<D: Number> Flow<D> {
    /// The amplitude at which the periodic solution grazes, plus `mu`.
    pub(crate) fn near_grazing(zeta: f64, omega: D, mu: D) -> Self {
        let amplitude = grazing_amplitude(zeta, omega) + mu;
        Self { zeta, omega, amplitude }
    }

    /// The periodic solution and its velocity.
    fn periodic(&self, time: D) -> (D, D) {
        let (in_phase, quadrature) = (-self.omega * self.omega + 1.0, self.omega * (2.0 * self.zeta));
        let gain = self.amplitude / (in_phase * in_phase + quadrature * quadrature);
        let (sine, cosine) = (self.omega * time).sin_cos();
        let position = gain * (in_phase * cosine + quadrature * sine) - 1.0;
        (position, gain * self.omega * (quadrature * cosine - in_phase * sine))
    }

    /// Position and velocity a time `elapsed` after they were `start` at time `time`.
    pub(crate) fn flow(&self, start: (D, D), time: D, elapsed: D) -> (D, D) {
        let omega_1 = (1.0 - self.zeta * self.zeta).sqrt();
        let (sine, cosine) = (elapsed * omega_1).sin_cos();
        let decay = (elapsed * -self.zeta).exp();
        let (before, after) = (self.periodic(time), self.periodic(time + elapsed));
        let (x, y) = (start.0 - before.0, start.1 - before.1);
        let ratio = self.zeta / omega_1;
        (
            decay * ((cosine + sine * ratio) * x + sine * y / omega_1) + after.0,
            decay * ((cosine - sine * ratio) * y - sine * x / omega_1) + after.1,
        )
    }

    /// Position and phase (not reduced) at the extremum next to the time `guess` after `start` at phase
    /// `phase`.
    pub(crate) fn extremum(&self, start: (D, D), phase: D, guess: D) -> (D, D) {
        let time = phase / self.omega;
        let mut elapsed = guess;
        // Each step doubles the correct digits of the value and then those of each order of derivatives.
        for _ in 0..12 {
            let (x, y) = self.flow(start, time, elapsed);
            let forcing = self.amplitude * (self.omega * (time + elapsed)).cos();
            let acceleration = forcing - y * (2.0 * self.zeta) - x - 1.0;
            elapsed -= y / acceleration;
        }
        (self.flow(start, time, elapsed).0, self.omega * (time + elapsed))
    }

    /// The `p`-th iterate of `P_global`: position, and phase less `2 pi p`.
    pub(crate) fn returned(&self, p: u32, x: D, phase: D) -> (D, D) {
        let turns = 2.0 * core::f64::consts::PI * f64::from(p);
        let guess = self.omega.recip() * turns;
        let (position, end) = self.extremum((x, D::from(0.0)), phase, guess);
        (position, end - turns)
    }

    /// `P_virt`, forwards for positive and backwards for negative velocity.
    pub(crate) fn virtual_maximum(&self, velocity: D, phase: D) -> (D, D) {
        // To leading order the extremum is velocity / gamma away, gamma = omega^2 at grazing.
        self.extremum((D::from(0.0), velocity), phase, velocity / (self.omega * self.omega))
    }
}

/// The maximum of the periodic solution is 0: eq. (5) of section 3, from the gain in eq. (4).
pub(crate) fn grazing_amplitude<D: Number>(zeta: f64, omega: D) -> D {
    let in_phase = -omega * omega + 1.0;
    (in_phase * in_phase + omega * omega * (4.0 * zeta * zeta)).sqrt()
}

/// The phase of the maximum, in (0, pi).
pub(crate) fn grazing_phase<D: Number>(zeta: f64, omega: D) -> D {
    ((-omega * omega + 1.0) / grazing_amplitude(zeta, omega)).acos()
}
