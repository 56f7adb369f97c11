//! Seeded samples of domains, and adversarial search for the smallest value of a function.

use core::f64::consts::TAU;
use core::ops::RangeInclusive;

use grazing_model::State;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::Rng;

use crate::CheckError;

/// A seeded source of numbers: the same seed gives the same numbers on every machine.
pub struct Sampler(Pcg64Mcg);

impl Sampler {
    /// The source with this seed.
    pub fn new(seed: u64) -> Self {
        Self(Pcg64Mcg::new(u128::from(seed)))
    }

    /// A number between the two bounds, which are both possible up to rounding.
    pub fn between(&mut self, lower: f64, upper: f64) -> f64 {
        // 53 random bits: all doubles of that grid in [0, 1) are equally likely.
        let share = (self.0.next_u64() >> 11) as f64 * libm::ldexp(1.0, -53);
        lower + (upper - lower) * share
    }

    /// Returns one of the items.
    ///
    /// # Panics
    /// If there are no items, which is an error in the program.
    pub fn one_of<T: Copy>(&mut self, items: &[T]) -> T {
        let index = (self.between(0.0, 1.0) * items.len() as f64) as usize;
        items[index.min(items.len() - 1)]
    }

    /// A random state on the free side of the wall.
    pub fn state(&mut self) -> State {
        State {
            position: self.between(-2.0, 0.0),
            velocity: self.between(-1.0, 1.0),
            phase: self.between(0.0, TAU),
        }
    }

    /// A pair (τ, δ) in the trapesium of eq:cT, at a relative distance of at least 10⁻⁶ from its slanted
    /// sides.
    pub fn trapesium(&mut self) -> (f64, f64) {
        let delta = self.between(0.001, 0.999);
        (self.between(-0.999_999, 0.999_999) * (delta + 1.0), delta)
    }
}

/// The tally of measurements over these subjects.
pub fn over<I, T: Default>(
    subjects: impl IntoIterator<Item = I>,
    mut measure: impl FnMut(I, &mut T) -> Result<(), CheckError>,
) -> Result<T, CheckError> {
    let mut tally = T::default();
    subjects.into_iter().try_for_each(|subject| measure(subject, &mut tally))?;
    Ok(tally)
}

/// The tally of measurements over these subjects, with random numbers from one source.
pub fn drawn_over<I, T: Default>(
    seed: u64,
    subjects: impl IntoIterator<Item = I>,
    mut measure: impl FnMut(&mut Sampler, I, &mut T) -> Result<(), CheckError>,
) -> Result<T, CheckError> {
    let mut sampler = Sampler::new(seed);
    over(subjects, |subject, tally| measure(&mut sampler, subject, tally))
}

/// The tally of `samples` random samples, all from one source.
pub fn drawn<T: Default>(
    seed: u64,
    samples: usize,
    mut sample: impl FnMut(&mut Sampler, &mut T) -> Result<(), CheckError>,
) -> Result<T, CheckError> {
    drawn_over(seed, 0..samples, |sampler, _, tally| sample(sampler, tally))
}

/// The tally of `samples` random samples, with numbers of loops that cycle through a range.
pub fn sampled<T: Default>(
    seed: u64,
    samples: usize,
    loops: RangeInclusive<u32>,
    sample: impl FnMut(&mut Sampler, u32, &mut T) -> Result<(), CheckError>,
) -> Result<T, CheckError> {
    drawn_over(seed, loops.cycle().take(samples), sample)
}

/// The smallest value on the unit cube found by local searches from seeded starts, and its position.
///
/// Each search tries a step along every axis and every diagonal pair, moves on success, and otherwise
/// halves its step, down to 10⁻⁶. NaN means outside the domain.
pub fn smallest<const N: usize>(
    seed: u64,
    starts: usize,
    value: impl Fn([f64; N]) -> f64,
) -> (f64, [f64; N]) {
    let mut sampler = Sampler::new(seed);
    let value = |point| match value(point) {
        found if found.is_nan() => f64::INFINITY,
        found => found,
    };
    let mut best = (f64::INFINITY, [0.5; N]);
    for _ in 0..starts {
        let start = core::array::from_fn(|_| sampler.between(0.0, 1.0));
        let found = descend(start, &value);
        if found.0 < best.0 {
            best = found;
        }
    }
    best
}

fn descend<const N: usize>(start: [f64; N], value: &impl Fn([f64; N]) -> f64) -> (f64, [f64; N]) {
    let mut best = (value(start), start);
    let mut step = 0.25;
    while step > 1e-6 {
        let mut better = best;
        for axis in 0..N {
            for (other, turn) in [(axis, 0.0), ((axis + 1) % N, 1.0), ((axis + 1) % N, -1.0)] {
                for side in [step, -step] {
                    let mut point = best.1;
                    point[axis] += side;
                    if other != axis {
                        point[other] += turn * side;
                    }
                    let point = point.map(|x| x.clamp(0.0, 1.0));
                    let found = value(point);
                    if found < better.0 {
                        better = (found, point);
                    }
                }
            }
        }
        if better.0 < best.0 {
            best = better;
        } else {
            step *= 0.5;
        }
    }
    best
}
