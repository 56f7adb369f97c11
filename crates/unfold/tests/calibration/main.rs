use std::io::Write as _;
use grazing_continuation::fit::measure;
use grazing_continuation::locate::Condition;
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_continuation::curve::Window;
use grazing_model::smooth::Integrated;
use grazing_description::Description;
use grazing_model::{ImpactOscillator, LinearOscillator};
use grazing_unfold::{Diagram, Scope};
use grazing_unfold::progress::Silent;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::Rng;

struct Source(Pcg64Mcg);
impl Source {
    fn between(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * ((self.0.next_u64() >> 11) as f64 * libm::ldexp(1.0, -53))
    }
    fn log(&mut self, a: f64, b: f64) -> f64 { libm::exp(self.between(libm::log(a), libm::log(b))) }
}

fn rows<O: ImpactOscillator>(kind: &str, n: u32, exact: Option<[f64; 2]>, point: &ResonantGrazingPoint<O>, out: &mut impl std::io::Write) {
    let s = point.resonant_point().stability_coefficients();
    let th = point.theorem();
    let c = [th.saddle_node().coefficient, th.period_doubling().coefficient];
    for (k, cond) in [Condition::SADDLE_NODE, Condition::PERIOD_DOUBLING].into_iter().enumerate() {
        let ex = exact.map_or(f64::NAN, |e| e[k]);
        let s = [s.plus, s.minus][k];
        match measure(point, cond) {
            Ok(m) => writeln!(out, "{kind},{},{n},{k},{s:e},{:e},{:e},{:e},{:e},{:e},{:e},{:e},{:e},{:e}", point.loops(), c[k], ex, m.coefficient.value, m.coefficient.error, m.velocity, m.eta[0], m.eta[1], m.mu[0], m.mu[1]).unwrap(),
            Err(e) => writeln!(out, "{kind},{},{n},{k},{s:e},{:e},{:e},nan,nan,nan,nan,nan,nan,nan,{e}", point.loops(), c[k], ex).unwrap(),
        }
    }
}

#[test]
fn calibration() {
    let mut source = Source(Pcg64Mcg::new(1));
    let count: usize = std::env::var("GRAZING_RESONANCES").ok().and_then(|t| t.parse().ok()).unwrap_or(60);
    let nonlinear: usize = std::env::var("GRAZING_NONLINEAR").ok().and_then(|t| t.parse().ok()).unwrap_or(1);
    let mut out = std::io::BufWriter::new(std::fs::File::create("/tmp/verdicts/cal.csv").unwrap());
    let mut found = 0;
    while found < count {
        let (zeta, eps) = (source.log(0.003, 0.3), source.between(0.3, 1.0));
        let (p, n) = (source.between(1.0, 5.0) as u32, source.between(1.0, 7.0) as u32);
        let theory = grazing_theorems::LinearOscillator::new(zeta, eps).unwrap();
        let Ok(res) = theory.resonance(p, n) else { continue };
        let g = res.grazing();
        let o = LinearOscillator::new(zeta, eps, g.amplitude(), res.forcing_frequency()).unwrap();
        match ResonantGrazingPoint::find(&o, p, g.phase()) {
            Ok(point) => { found += 1; rows(&format!("lin{zeta:.4}/{eps:.3}"), n, Some([res.saddle_node_coefficient(), res.period_doubling_coefficient()]), &point, &mut out); }
            Err(e) => { let _ = writeln!(out, "#lost {zeta} {eps} {p} {n} {e}"); }
        }
    }
    for k in 0..nonlinear {
        let zeta = source.log(0.003, 0.3);
        let force = match k % 3 {
            0 => format!("-2*{zeta}*v - x - {}*x^3 - 1 + A*cos(omega*t)", source.between(-0.1, 0.6)),
            1 => format!("-2*{zeta}*v - {}*v*sqrt(v^2 + {}) - x - 1 + A*cos(omega*t)", source.between(0.0, 0.3), source.log(0.01,0.3)),
            _ => format!("-2*{zeta}*v - x - {}*x^2- 1 + A*cos(omega*t)", source.between(0.0, 0.2)),
        };
        let (rest, dur) = (format!("{}*exp(-{}*y) + {}*sin(z)", source.between(0.3, 0.9), source.between(0.0, 1.0), source.between(0.0, 0.1)), format!("{}/(1+y)", source.between(-0.1, 0.3)));
        let text = format!("name = \"T\"\n[parameters]\n[primary]\nname = \"A\"\nrange = [0.0, 2.0]\n[secondary]\nname = \"omega\"\nrange = [0.4, 1.2]\n[motion]\nforce = \"{force}\"\nfrequency = \"omega\"\n[impact]\nrestitution = \"{rest}\"\nduration = \"{dur}\"\n[analysis]\nloops = [1,2,3]\n");
        let d = Description::parse(&text, "t").unwrap_or_else(|e| panic!("{e}"));
        let o = Integrated::new(d, [1.0, 0.8]);
        let scope = Scope { window: Window { primary: [0.0, 2.0], secondary: [0.4, 1.2] }, loops: vec![1, 2, 3], start: None };
        let t0 = std::time::Instant::now();
        match Diagram::located(&o, &scope, &Silent) {
            Ok(diagram) => {
                let t1 = t0.elapsed();
                let mut c = 0;
                for (r, point) in diagram.unfolding() { c += 1; rows(&format!("non{k}/{zeta:.3}"), r.n, None, point, &mut out); }
                eprintln!("{k} located {t1:?} fits {:?} of {c}", t0.elapsed() - t1);
            }
            Err(e) => eprintln!("{k} {e}"),
        }
    }
}
