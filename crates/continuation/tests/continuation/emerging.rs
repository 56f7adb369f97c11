//! Curves of solutions with more loops that leave a one-loop resonance.
use crate::specimens::{EPSILON, ZETA, located, resonances, route};
use grazing_continuation::locate::Condition;

#[test]
fn show() {
    for resonance in resonances(ZETA, EPSILON, &[1], [0.35, 1.02]) {
        let located = located(&resonance);
        let (curves, missing) = located.unfold_iterated(2, &route([0.0, 1.3], [0.35, 1.02], true));
        println!("n {} {missing:?}", resonance.index());
        for c in &curves {
            println!(
                "{:?} {} points, begin {:?} end {:?}",
                c.condition,
                c.points.len(),
                c.beginning.as_ref().map(|e| format!("{e:?}").chars().take(300).collect::<String>()),
                format!("{:?}", c.end).chars().take(400).collect::<String>()
            );
            for p in [&c.points[0], &c.points[c.points.len() / 2], &c.points[c.points.len() - 1]] {
                println!(
                    "    {:?} {:?} {:e}",
                    p.solution.unknowns.as_slice(),
                    p.solution.multipliers,
                    p.solution.ceiling()
                );
            }
        }
    }
}
