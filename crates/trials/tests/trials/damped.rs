//! Random oscillators from hardly damped to overdamped ones; `cargo run -p grazing-trials -- damped` unfolds many.

use grazing_input::Description;
use grazing_trials::damped::{DAMPING, Damped, FREQUENCY, unfold};

#[test]
fn random_oscillators_are_of_all_kinds_and_the_same_for_the_same_seed() {
    let all: Vec<Damped> = (1..=200).map(|number| Damped::new(7, number)).collect();
    let within = |[low, high]: [f64; 2], of: fn(&Damped) -> f64| {
        assert!(all.iter().all(|one| (low..=high).contains(&of(one))));
        // To within a factor of two of both ends.
        assert!(all.iter().any(|one| of(one) < 2.0 * low) && all.iter().any(|one| of(one) > 0.5 * high));
    };
    within(DAMPING, |one| one.damping);
    within(FREQUENCY, |one| one.frequency);
    for (number, one) in (1..).zip(&all[..8]) {
        let text = one.description();
        assert_eq!(text, Damped::new(7, number).description());
        Description::parse(&text, "random").unwrap_or_else(|error| panic!("{error}\n{text}"));
    }
}

#[test]
fn a_strongly_damped_oscillator_is_decided_and_one_that_takes_too_long_fails() {
    // Damping ratio 0.31, forced seven times as fast as it swings.
    let text = Damped::new(1, 19).description();
    let outcome = unfold(&text, f64::INFINITY);
    assert!(outcome.passes() && outcome.hatched == 0.0 && outcome.reasons.is_empty(), "{outcome}");
    let cut = unfold(&text, 0.0);
    assert!(cut.stopped && !cut.passes(), "{cut}");
}
