use crate::specimens::*;
use grazing_continuation::mps::*;
#[test]
fn explore() {
    for k in 0..70 {
        let w = 0.3 + 0.01 * k as f64;
        for p in 1..=4 {
            for side in [1.0] {
                let r = route([0.0, 1.8], [0.1, 2.0], false);
                let (_, c) = branch([ZETA, EPSILON, w], p, Formulation::Vivid, side, &r);
                if let Some(i) = c.vivid_ended {
                    println!(
                        "w {w:.2} p {p} n {} end {} at {i} {:?} adm {} ceil {} stable {} then admissible {} ",
                        c.points.len(),
                        format!("{:?}", c.end).chars().take(20).collect::<String>(),
                        c.points[i].solution.unknowns.as_slice(),
                        c.points[i].solution.admissible(),
                        c.points[i].solution.ceiling(),
                        c.points[i].solution.stable(),
                        c.points[i..].iter().filter(|p| p.solution.admissible()).count()
                    );
                }
            }
        }
    }
}
