//! Resonances on curves at which motion that already has impacts grazes.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::Window;
use grazing_model::{AnyOscillator, ImpactOscillator};
use grazing_unfold::grazing::GrazingCurve;
use grazing_unfold::progress::Silent;
use grazing_unfold::{Diagram, Scope};

#[test]
fn scratch() {
    let oscillator: AnyOscillator = crate::specimens::closed_form();
    let window = Window { primary: [0.0, 1.3], secondary: [0.35, 1.02] };
    let scope = Scope { window, loops: vec![1, 2], start: None };
    let located = Diagram::located(&oscillator, &scope, &Silent).unwrap();
    let followed = located.follow(&Silent, &|_, _| ());
    let diagram = located.with_curves(followed);
    for curve in diagram.curves.iter().filter(|curve| curve.kind == Bifurcation::Grazing) {
        let grazing = GrazingCurve::of_impacting(&diagram.equations(curve.loops), &curve.curve, &scope);
        println!("{} {}: {} points, {} states", curve.loops, curve.n, curve.curve.points.len(), grazing.states.len());
        let step = (grazing.states.len() / 12).max(1);
        for state in grazing.states.iter().step_by(step) {
            let map = state.orbit.grazing_point().map;
            let [a, w] = state.parameters();
            println!("  {a:.6} {w:.6} a12 {:.5} tau {:.5} delta {:.5} ok {} {:.1e}", map.a.m12, map.trace(), map.determinant(), state.admissible, state.orbit.ceiling());
        }
        for q in 1..=4 {
            for pair in grazing.states.windows(2) {
                let zero = |k: usize| pair[k].orbit.detuning(q, &nalgebra::Matrix2::zeros())[0];
                if zero(0) * zero(1) < 0.0 {
                    let s = zero(0) / (zero(0) - zero(1));
                    let at: [f64; 2] = core::array::from_fn(|k| pair[0].parameters()[k] * (1.0 - s) + pair[1].parameters()[k] * s);
                    let mut orbit = pair[0].orbit.clone();
                    for _ in 0..8 {
                        let [value, slope] = orbit.detuning(q, &orbit.derivative_of_map());
                        let eta = orbit.oscillator().parameters()[1] - value / slope;
                        let Ok(place) = orbit.place().moved(orbit.oscillator(), eta) else { println!("lost"); break };
                        orbit = grazing_theorems::from_map::GrazingOrbit::of(orbit.oscillator(), place).unwrap();
                    }
                    let point = orbit.resonant_point(q).unwrap();
                    let theorem = grazing_theorems::ResonantGrazing::check(&point, 1e-9);
                    println!("  q = {q} near {at:?}: {:?} c {:?} {:?} {}", orbit.oscillator().parameters(), point.saddle_node_coefficient(), point.period_doubling_coefficient(), theorem.err().map(|e| e.to_string()).unwrap_or_default());
                }
            }
        }
    }
}
