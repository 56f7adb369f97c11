//! Compares shaded regions of the linear oscillator away from the paper's parameters with the closed
//! form; `cargo run -p grazing-trials` tests many more.

use grazing_continuation::curve::Window;
use grazing_trials::random::Random;
use grazing_trials::regions::compare;

/// Damping ratio, restitution, greatest amplitude, and numbers of loops.
const OSCILLATORS: [(f64, f64, f64, &[u32]); 4] = [
    // p = 2 has a grazing curve to which no resonance leads, p = 1 has interior maxima far above the
    // wall.
    (0.05, 0.9, 1.3, &[1, 2, 3]),
    // Beyond A = 1.8 there is a period doubling of p = 1 that no resonance in the window leads to.
    (0.02, 0.9, 3.0, &[1, 2]),
    (0.004, 0.72, 2.2, &[1, 4]),
    (0.25, 0.35, 1.1, &[1, 2]),
];

#[test]
fn what_is_shaded_is_where_the_closed_form_has_a_stable_admissible_solution() {
    let mut random = Random::new(5);
    for (zeta, epsilon, most, loops) in OSCILLATORS {
        let window = Window { primary: [0.0, most], secondary: [0.25, 1.3] };
        let outcome = compare(zeta, epsilon, window, loops, 1000, &mut random);
        assert!(outcome.missed.is_empty(), "{zeta}: {:?}", outcome.missed);
        assert!(outcome.false_shading.is_empty(), "{zeta}: {:?}", outcome.false_shading);
        assert!(outcome.hatched < 0.01, "{zeta}: {:?}", outcome.doubts);
        assert!(outcome.shaded > 100, "{zeta}: {} points decide something", outcome.shaded);
    }
}
