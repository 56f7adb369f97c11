use grazing_continuation::arclength::StepControl;
use grazing_continuation::curve::{Route, Window};
use grazing_continuation::fit;
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::ImpactOscillator;
use grazing_model::smooth::*;
use grazing_theorems::auxiliary::detuning;
use grazing_theorems::from_map::GrazingOrbit;

#[derive(Clone, Debug)]
struct Duffing {
    kappa: f64,
}
impl SmoothOscillator for Duffing {
    fn force<S: Scalar>(&self, x: S, y: S, t: S, a: S, w: S) -> S {
        a * (w * t).apply(Function::Cos)
            - y.scale(0.04)
            - x
            - x.square() * x.scale(self.kappa)
            - S::constant(1.0)
    }
    fn forcing_frequency<S: Scalar>(&self, _: S, w: S) -> S {
        w
    }
    fn restitution<S: Scalar>(&self, y: S, _: S, _: S, _: S) -> S {
        S::constant(0.9) - y.scale(0.1)
    }
    fn impact_duration<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
        S::constant(0.05)
    }
}
fn main() {
    // homotopy in kappa at fixed omega
    let lin = grazing_theorems::LinearOscillator::new(0.02, 0.9).unwrap();
    for (p, n) in [(1, 3), (2, 1)] {
        let r = lin.resonance(p, n).unwrap();
        let g = r.grazing();
        let mut phase = g.phase();
        let mut par = [g.amplitude(), r.forcing_frequency()];
        for k in 0..=10 {
            let o = Integrated::new(Duffing { kappa: 0.01 * f64::from(k) }, par);
            let orbit = GrazingOrbit::find(&o, phase).unwrap();
            phase = orbit.phase();
            par = orbit.oscillator().parameters();
        }
        // scan omega for resonance
        let mut last: Option<f64> = None;
        let mut w = par[1];
        for k in 0..80 {
            let o = Integrated::new(Duffing { kappa: 0.1 }, [par[0], w + 0.005 * f64::from(k)]);
            let orbit = match GrazingOrbit::find(&o, phase) {
                Ok(o) => o,
                Err(e) => {
                    println!("{e}");
                    break;
                }
            };
            phase = orbit.phase();
            par[0] = orbit.primary();
            let gp = orbit.grazing_point();
            let q = if p == 1 { gp.map.a[(0, 1)] } else { detuning(p, gp.map.trace(), gp.map.determinant()) };
            if let Some(l) = last
                && l * q <= 0.0
            {
                w = w + 0.005 * f64::from(k);
                println!("p={p} near {w} a12={q} A={}", par[0]);
                let o = Integrated::new(Duffing { kappa: 0.1 }, [par[0], w]);
                let t = std::time::Instant::now();
                match ResonantGrazingPoint::find(&o, p, phase) {
                    Ok(res) => {
                        println!("{:?} {:?} {:?}", res.unknowns(), res.theorem().saddle_node(), t.elapsed());
                        let [a, w] = [res.unknowns()[2], res.unknowns()[3]];
                        let route = Route {
                            window: Window { primary: [0.5 * a, 1.5 * a], secondary: [w - 0.1, w + 0.1] },
                            control: StepControl::DRAWING,
                            step_limit: 3000,
                            stop_at_events: true,
                            through_grazing: false,
                        };
                        let t = std::time::Instant::now();
                        match res.unfold(&route) {
                            Ok(u) => {
                                let e = t.elapsed();
                                println!(
                                    "SN {} points {:?}; PD {} points {:?}; GZ {:?}",
                                    u.saddle_node.points.len(),
                                    u.saddle_node.end,
                                    u.period_doubling.points.len(),
                                    u.period_doubling.end,
                                    u.grazing
                                        .iter()
                                        .map(|c| (c.points.len(), c.end.clone()))
                                        .collect::<Vec<_>>()
                                        .len()
                                );
                                let n: usize = u.saddle_node.points.len()
                                    + u.period_doubling.points.len()
                                    + u.grazing.iter().map(|c| c.points.len()).sum::<usize>();
                                println!("time {e:?} per point {:?}", e / n as u32);
                            }
                            Err(e) => println!("{e}"),
                        }
                        for (c, name) in [
                            (grazing_continuation::locate::Condition::SADDLE_NODE, "SN"),
                            (grazing_continuation::locate::Condition::PERIOD_DOUBLING, "PD"),
                        ] {
                            println!("{name} {:?}", fit::quadratic_coefficient(&res, c));
                        }
                        println!(
                            "theory {:?} {:?}",
                            res.theorem().saddle_node().coefficient,
                            res.theorem().period_doubling().coefficient
                        );
                    }
                    Err(e) => println!("{e}"),
                }
                break;
            }
            last = Some(q);
        }
    }
}
