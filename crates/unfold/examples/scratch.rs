use grazing_continuation::curve::Window;
use grazing_description::Description;
use grazing_model::smooth::Integrated;
use grazing_model::{ImpactOscillator, LinearOscillator};
use grazing_unfold::diagram::{Coefficients, Diagram, Kind};
use grazing_unfold::{Scope, magnification, regions, sides};
use std::time::Instant;
struct P;
impl grazing_unfold::progress::Progress for P {
    fn begin(&self, w: &str, n: u64) {
        println!("begin {w} {n}");
    }
    fn step(&self, _: &str) {}
    fn end(&self, w: &str) {
        println!("end {w}");
    }
}
fn run<O: ImpactOscillator>(o: &O, scope: &Scope) {
    let t = Instant::now();
    if std::env::var("SURVEY").is_ok() {
        for k in 0..5 {
            let t = Instant::now();
            let e = scope.window.secondary;
            let s = grazing_unfold::free::survey(o, scope, e[0] + (e[1] - e[0]) * k as f64 / 4.0);
            println!(
                "survey {k} {:?} grazing {} ran away {:?} extremes {:?}",
                t.elapsed(),
                s.grazing.len(),
                s.ran_away,
                s.extremes
            );
        }
    }
    let d = match Diagram::compute(o, scope, &P) {
        Ok(d) => d,
        Err(e) => {
            println!("ERR {e}");
            return;
        }
    };
    println!("computed in {:?}", t.elapsed());
    for g in &d.grazing {
        let a = g.states.first().unwrap().orbit.oscillator().parameters();
        let b = g.states.last().unwrap().orbit.oscillator().parameters();
        println!(
            "grazing {} points {:?} {:?} ends {:?} adm {} stable {}",
            g.states.len(),
            a,
            b,
            g.ends,
            g.states.iter().filter(|s| s.admissible).count(),
            g.states.iter().filter(|s| s.stable).count()
        );
    }
    for r in &d.resonances {
        let [mu, eta] = r.located.orbit().oscillator().parameters();
        print!("p={} n={} eta={eta:.10} mu={mu:.10} ", r.loops, r.n);
        match &r.theorem {
            Ok(point) => {
                let t = Instant::now();
                let c = Coefficients::of(point);
                let f: Vec<f64> = c.fit.iter().map(|f| f.as_ref().map_or(f64::NAN, |e| e.value)).collect();
                print!(
                    "c {:?} fit rel {:.1e} {:.1e}",
                    c.theorem,
                    (f[0] / c.theorem[0] - 1.0).abs(),
                    (f[1] / c.theorem[1] - 1.0).abs()
                );
                let t1 = t.elapsed();
                for k in [Kind::SaddleNode, Kind::PeriodDoubling] {
                    match sides::simulate(point, k) {
                        Ok(s) => print!(
                            " {} {:?}",
                            s.as_predicted(),
                            if s.as_predicted() { None } else { Some(s) }
                        ),
                        Err(e) => print!(" {e}"),
                    }
                }
                println!("  {t1:?} {:?}", t.elapsed());
                let w = magnification::window_about(&d, r, point);
                let un = point
                    .unfold(&grazing_unfold::diagram::route(
                        w,
                        grazing_continuation::arclength::StepControl {
                            first: 1e-4,
                            longest: 4e-3,
                            shortest: 1e-6,
                            turn: 0.02,
                        },
                    ))
                    .unwrap();
                println!(
                    "   magnified SN {} {:?} last {:?} vivid ended {:?}",
                    un.saddle_node.points.len(),
                    un.saddle_node.end,
                    un.saddle_node.points.last().unwrap().solution.unknowns,
                    un.saddle_node.vivid_ended
                );
                println!("      window {:?}", magnification::window_about(&d, r, point));
            }
            Err(v) => println!("{v}"),
        }
    }
    println!("unlocated {:?}", d.unlocated);
    println!("not unfolded {:?}", d.not_unfolded);
    for c in &d.curves {
        println!(
            "{} p={} n={} {} points {:?} {:?} end {}",
            c.kind.name(),
            c.loops,
            c.n,
            c.curve.points.len(),
            c.curve.parameters()[0],
            c.curve.parameters().last(),
            format!("{:?}", c.curve.end).chars().take(60).collect::<String>()
        );
    }
    for c in &d.corners {
        println!("{} p={} n={} {:?}", c.kind, c.loops, c.n, c.unknowns());
    }
    for p in regions::all(&d) {
        println!("region {} p={} n={} {} vertices", p.kind, p.loops, p.n, p.vertices.len());
    }
    println!("total {:?}", t.elapsed());
}
fn main() {
    let file = std::env::args().nth(1).unwrap();
    if file == "linear" {
        let scope = Scope {
            window: Window { primary: [0.0, 1.2], secondary: [0.4, 1.02] },
            loops: vec![1, 2, 3],
            start: None,
        };
        run(&LinearOscillator::new(0.02, 0.9, 0.5, 0.8).unwrap(), &scope);
        return;
    }
    let d = Description::from_file(std::path::Path::new(&file)).unwrap();
    let scope = Scope {
        window: Window { primary: d.primary().range(), secondary: d.secondary().range() },
        loops: d.loops().to_vec(),
        start: None,
    };
    run(&Integrated::new(d, [0.5, 0.8]), &scope);
}
