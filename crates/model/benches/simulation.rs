//! Brute-force simulation with impacts: time per forcing period.

use core::hint::black_box;

use divan::Bencher;
use divan::counter::ItemsCount;
use grazing_model::orbit::Orbit;
use grazing_model::{ImpactOscillator, LinearOscillator, State};

fn main() {
    divan::main();
}

/// Forcing periods in one run.
const PERIODS: u32 = 10_000;

/// Forcing periods per item: one item is one forcing period, with all impacts in it.
#[divan::bench]
fn forcing_period_with_impacts(bencher: Bencher<'_, '_>) {
    let oscillator = LinearOscillator::new(0.02, 0.9, 0.3, 0.855).unwrap();
    let from = State::at_rest(-0.5, 0.1);
    let horizon = f64::from(PERIODS) * oscillator.forcing_period();
    // About one impact every two periods: the orbit is chaotic and does not stick.
    let impacts = Orbit::new(&oscillator, from, horizon, usize::MAX).map(black_box).count();
    assert!(impacts > PERIODS as usize / 4);
    bencher.counter(ItemsCount::new(PERIODS)).bench(|| {
        Orbit::new(black_box(&oscillator), black_box(from), horizon, usize::MAX).map(black_box).count()
    });
}
