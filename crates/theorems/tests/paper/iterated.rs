//! Solutions of more loops at a one-loop resonance.

use grazing_theorems::LinearOscillator;
use grazing_theorems::iterated::IteratedResonance;

#[test]
fn show() {
    let oscillator = LinearOscillator::new(0.02, 0.9).unwrap();
    for n in 1..=6 {
        let r = oscillator.resonance(1, n).unwrap();
        for k in 1..=4 {
            let it = IteratedResonance::new(&r.resonant_point(), k);
            println!("n {n} k {k} omega {} A {}", r.forcing_frequency(), r.grazing().amplitude());
            let b = it.point().branch_expansion();
            for e in it.emerging() {
                let c = |v: f64| b.parameter(v, 1.0);
                println!(
                    "   {:?} {:?} c {} .. {:?} c {:?}",
                    e.side,
                    e.slowest,
                    c(e.slowest.velocity_slope),
                    e.fastest,
                    e.fastest.map(|f| c(f.velocity_slope))
                );
            }
        }
    }
}
