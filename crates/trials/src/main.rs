//! Runs the long trials.

use std::time::Instant;

use grazing_continuation::curve::Window;
use grazing_trials::random::Random;
use grazing_trials::regions::compare;

#[expect(clippy::print_stdout, reason = "a program's output")]
fn main() {
    let arguments: Vec<u64> = std::env::args().skip(1).filter_map(|a| a.parse().ok()).collect();
    let (count, seed) = (arguments.first().copied().unwrap_or(40), arguments.get(1).copied().unwrap_or(1));
    let mut random = Random::new(seed);
    let (mut wrong, mut hatched) = (0, Vec::new());
    for number in 1..=count {
        let (zeta, epsilon) = (random.logarithmic(0.003, 0.3), random.uniform(0.3, 1.0));
        let window = Window { primary: [0.0, random.uniform(1.0, 3.0)], secondary: [0.25, 1.3] };
        let start = Instant::now();
        let outcome = compare(zeta, epsilon, window, &[1, 2, 3, 4], 2000, &mut random);
        wrong += outcome.missed.len() + outcome.false_shading.len();
        hatched.push(outcome.hatched);
        println!(
            "{number:3} zeta {zeta:.5} epsilon {epsilon:.4} A < {:.3}: shaded {}, missed {}, false {}, hatched {:.4}, {:.2} s",
            window.primary[1],
            outcome.shaded,
            outcome.missed.len(),
            outcome.false_shading.len(),
            outcome.hatched,
            start.elapsed().as_secs_f64(),
        );
        for (name, list) in [("missed", &outcome.missed), ("false", &outcome.false_shading)] {
            for (p, [a, w]) in list.iter().take(3) {
                println!("    {name} p = {p} at A = {a:.5}, omega = {w:.5}");
            }
        }
        for doubt in outcome.doubts.iter().take(6) {
            println!("    {doubt}");
        }
    }
    hatched.sort_by(f64::total_cmp);
    println!(
        "{wrong} wrong; hatched: median {:.4}, most {:.4}",
        hatched[hatched.len() / 2],
        hatched[hatched.len() - 1]
    );
}
