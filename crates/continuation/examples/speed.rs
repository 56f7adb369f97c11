#![allow(clippy::all, missing_docs)]
use grazing_continuation::{arclength::*, curve::*, locate::*, mps::*};
use grazing_model::*;
use nalgebra::Vector4;
use std::hint::black_box;
use std::time::Instant;
fn main() {
    let osc = LinearOscillator::new(0.02, 0.9, 0.3, 0.8).unwrap();
    let n = 100000;
    let t = Instant::now();
    for i in 0..n { black_box(osc.with_parameters(black_box([0.3, 0.8 + 1e-9 * i as f64]))); }
    println!("with_parameters {:?}", t.elapsed() / n);
    let s = State::at_rest(-0.1, 0.3);
    let t = Instant::now();
    for _ in 0..n { black_box(osc.flow::<1>(black_box(s), 7.8)); }
    println!("flow1 {:?}", t.elapsed() / n);
    let t = Instant::now();
    for _ in 0..n { black_box(osc.flow::<2>(black_box(s), 7.8)); }
    println!("flow2 {:?}", t.elapsed() / n);
    let t = Instant::now();
    for _ in 0..n { black_box(maps::global_map::<_, 1>(&osc, black_box(-0.01), 0.1, Some(7.8)).unwrap()); }
    println!("global1 {:?}", t.elapsed() / n);
    let t = Instant::now();
    for _ in 0..n { black_box(maps::global_map::<_, 2>(&osc, black_box(-0.01), 0.1, Some(7.8)).unwrap()); }
    println!("global2 {:?}", t.elapsed() / n);
    let j = maps::global_map::<_, 2>(&osc, -0.01, 0.1, None).unwrap().jet;
    let t = Instant::now();
    for _ in 0..n { black_box(black_box(&j).after::<2>(black_box(&j))); }
    println!("after2 {:?}", t.elapsed() / n);
    let t = Instant::now();
    for _ in 0..n { black_box(black_box(&j).after::<1>(black_box(&j))); }
    println!("after1 {:?}", t.elapsed() / n);
    let mut m = Memory::default();
    for p in [1, 2, 3] { for f in [Formulation::Vivid, Formulation::FixedPhase] {
        let eq = LoopEquations::new(osc, p, f);
        let u = Vector4::new(0.1, 0.05, 0.37, 0.8);
        let t = Instant::now();
        for _ in 0..n { black_box(eq.pair::<1>(&black_box(u), &mut m).unwrap()); }
        print!("p {p} {f:?} pair1 {:?}", t.elapsed() / n);
        let t = Instant::now();
        for _ in 0..n { black_box(eq.pair::<2>(&black_box(u), &mut m).unwrap()); }
        print!(" pair2 {:?}", t.elapsed() / n);
        let pair = eq.pair::<2>(&u, &mut m).unwrap();
        let t = Instant::now();
        for _ in 0..n { black_box(eq.solution(&black_box(u))); }
        print!(" solution {:?}", t.elapsed() / n);
        let c = MpsCurve { equations: eq, condition: Condition::SADDLE_NODE };
        let mut k = m.clone();
        let t = Instant::now();
        for _ in 0..n { black_box(c.evaluate(&black_box(u), &mut k).unwrap()); }
        print!(" evaluate {:?}", t.elapsed() / n);
        let l = c.evaluate(&u, &mut k).unwrap();
        let mut jj = l.jacobian; jj[(3, 0)] = 1.0;
        let t = Instant::now();
        for _ in 0..n { black_box(black_box(jj).lu().solve(&l.residual)); }
        println!(" lu {:?}", t.elapsed() / n);
    } m = Memory::default(); }
    let t = Instant::now();
    let period = osc.forcing_period();
    let osc = osc.with_parameters([0.3, 0.854]);
    let mut o = orbit::Orbit::new(&osc, State::at_rest(-0.5, 0.1), 100000.0 * period, 10_000_000);
    for f in o.by_ref() { black_box(f.duration); }
    println!("simulate per period {:?}  impacts {}", t.elapsed() / 100000, o.impacts());
}
