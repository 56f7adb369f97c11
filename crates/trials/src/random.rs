//! Random numbers from a seed.

use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

/// Random numbers that are the same for the same seed on every machine.
#[derive(Clone, Debug)]
pub struct Random(Pcg64);

impl Random {
    /// The sequence of random numbers for a seed.
    pub fn new(seed: u64) -> Self {
        Self(Pcg64::new(u128::from(seed), 0))
    }

    /// The sequence of random numbers for a seed, starting at index `first`.
    pub fn from(seed: u64, first: u64) -> Self {
        let mut random = Self::new(seed);
        random.0.advance(u128::from(first));
        random
    }

    /// A random number distributed uniformly between two numbers.
    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.0.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A random number between two positive numbers whose logarithm is distributed uniformly.
    pub fn logarithmic(&mut self, low: f64, high: f64) -> f64 {
        low * libm::pow(high / low, self.uniform(0.0, 1.0))
    }
}
