#![allow(clippy::all, clippy::disallowed_methods, clippy::print_stdout)]
use grazing_continuation::{arclength::StepControl, curve::*, locate::*, mps::*};
use grazing_model::*;
use nalgebra::Vector4;
fn main() {
    let (zeta, eps) = (0.02, 0.9);
    let w1 = (1.0f64 - zeta * zeta).sqrt();
    let window = Window { primary: [0.0, 1.3], secondary: [0.35, 1.02] };
    let route = Route { window, control: StepControl::DRAWING, step_limit: 5000, stop_at_events: true };
    let agraz = |w: f64| ((1.0 - w * w) * (1.0 - w * w) + 4.0 * zeta * zeta * w * w).sqrt();
    let t0 = std::time::Instant::now();
    let mut total = 0;
    for (p, n) in [(1u32, 2), (1, 3), (1, 4), (1, 5), (2, 1), (3, 1), (2, 2), (3, 2)] {
        let w = if p == 1 { 2.0 * w1 / n as f64 } else { w1 / (n as f64 + 0.5 / p as f64) };
        let start = Vector4::new(0.0, (2.0 * zeta * w).atan2(1.0 - w * w), agraz(w), w);
        let osc = LinearOscillator::new(zeta, eps, agraz(w), w).unwrap();
        for (name, c) in [("SN", Condition::SADDLE_NODE), ("PD", Condition::PERIOD_DOUBLING)] {
            let eq = LoopEquations::new(osc, p, Formulation::Vivid);
            let curve = MpsCurve { equations: eq.clone(), condition: c };
            let t = std::time::Instant::now();
            let r = curve.follow(start, Vector4::new(1.0, 0.0, 0.0, 0.0), Memory::default(), &route);
            let el = t.elapsed();
            match r {
                Ok(r) => {
                    total += r.points.len();
                    let l = r.points.last().unwrap();
                    let short = match &r.end {CurveEnd::Event(e)=>format!("Event {:?}",e.condition), o=>format!("{o:?}")}; println!("{p} {n} {name}: {} points {:.2} us/pt, end {:?}\n    first {:?}\n   last {:?} mult {:?} vivid_ended {:?}", r.points.len(), el.as_secs_f64() * 1e6 / r.points.len() as f64, short, r.points[0].multipliers, l.unknowns.as_slice(), l.multipliers, r.vivid_ended);
                    if let (CurveEnd::Event(e), true) = (&r.end, true) {
                        let m = e.solution.highest_interior_maximum.unwrap();
                        for d in [1.0, -1.0] {
                            let gz = MpsCurve { equations: eq.clone(), condition: Condition::InteriorGrazing };
                            let t = std::time::Instant::now();
                            let r = gz.follow(e.solution.unknowns, Vector4::new(d, 0.0, 0.0, 0.0), {let _=m; e.memory.clone()}, &route);
                            let el = t.elapsed();
                            match r { Ok(r) => { let short = match &r.end {CurveEnd::Event(e)=>format!("Event {:?}",e.condition), o=>format!("{o:?}")}; let l = r.points.last().unwrap();
                              println!("   GZ {d}: {} points {:.2} us/pt stable[1] {} end {:?} last {:?} {:?} vivid {:?}", r.points.len(), el.as_secs_f64() * 1e6 / r.points.len() as f64, r.points[1].stable(), short, l.unknowns.as_slice(), l.multipliers, r.vivid_ended); }
                              Err(e) => println!("   GZ {d} {e}") }
                        }
                    }
                }
                Err(e) => println!("{p} {n} {name}: {e}"),
            }
        }
    }
    println!("{total} points {:?}", t0.elapsed());
}
