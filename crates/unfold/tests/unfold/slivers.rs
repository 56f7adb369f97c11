use grazing_continuation::curve::Window;
use grazing_model::{AnyOscillator, LinearOscillator};
use grazing_trials::{lines, random::Random};
use grazing_unfold::progress::Silent;
use grazing_unfold::{Diagram, Scope};

#[test]
fn show() {
    let mut random = Random::new(7);
    let mut run = |zeta: f64, eps: f64, window: Window, name: String| {
        let scope = Scope { window, loops: vec![1, 2, 3], start: None };
        let o = AnyOscillator::new(LinearOscillator::new(zeta, eps, 0.5, 0.8).unwrap());
        let t = std::time::Instant::now();
        let d = match Diagram::compute(&o, &scope, &Silent) {
            Ok(d) => d,
            Err(e) => {
                println!("{name}: {e}");
                return;
            }
        };
        let t = t.elapsed();
        for r in d.regions.iter().filter(|r| r.doubt.is_some()) {
            println!("  hatched {} {:?} {:?}", r.loops, r.doubt, r.extent());
        }
        let etas: Vec<f64> =
            (0..2000).map(|_| random.uniform(window.secondary[0], window.secondary[1])).collect();
        let wrong = lines::compare(&d, [zeta, eps], window, etas.into_iter());
        println!(
            "{name} {zeta} {eps} {window:?}: {} wrong {:?}; {} regions",
            wrong.len(),
            t,
            d.regions.len()
        );
        for w in wrong.iter().take(6) {
            println!("    {w:?}");
        }
    };
    run(0.02, 0.9, Window { primary: [0.0, 1.3], secondary: [0.35, 1.02] }, "fig7".into());
    if std::env::var_os("GRAZING_DEBUG").is_some() {
        return;
    }
    run(0.02, 0.9, Window { primary: [0.0, 1.4], secondary: [0.36, 1.0] }, "fig7b".into());
    let mut r2 = Random::new(8);
    for k in 0..12 {
        let (a, b) = (r2.uniform(0.0, 1.3), r2.uniform(0.0, 1.3));
        let (c, e) = (r2.uniform(0.35, 1.02), r2.uniform(0.35, 1.02));
        run(
            0.02,
            0.9,
            Window { primary: [a.min(b), a.max(b)], secondary: [c.min(e), c.max(e)] },
            format!("sub {k}"),
        );
    }
    for k in 0..8 {
        let (zeta, epsilon) = (r2.logarithmic(0.003, 0.3), r2.uniform(0.3, 1.0));
        run(
            zeta,
            epsilon,
            Window { primary: [0.0, r2.uniform(1.0, 3.0)], secondary: [0.25, 1.3] },
            format!("other {k}"),
        );
    }
}

#[test]
fn debug() {
    let window = Window { primary: [0.058646204591092654, 0.7807141949162433], secondary: [0.41927435061721935, 0.7365060240642822] };
    let scope = Scope { window, loops: vec![3], start: None };
    let o = AnyOscillator::new(LinearOscillator::new(0.02, 0.9, 0.5, 0.8).unwrap());
    let d = Diagram::compute(&o, &scope, &Silent).unwrap();
    let eta = 0.4991989326488868;
    println!("exact {:?}", lines::exact(0.02, 0.9, [0.0, 1.3], eta, 2));
    let window = Window { primary: [0.0, 1.3], secondary: [0.35, 1.02] };
    let scope = Scope { window, loops: vec![1, 2, 3], start: None };
    let o = AnyOscillator::new(LinearOscillator::new(0.02, 0.9, 0.5, 0.8).unwrap());
    let d = Diagram::compute(&o, &scope, &Silent).unwrap();
    println!("shown {:?}", lines::shown(&d, 2, eta));
    for c in d.curves.iter().filter(|c| c.loops == 2) {
        for pair in c.curve.parameters().windows(2) {
            if (pair[0][1] - eta) * (pair[1][1] - eta) <= 0.0 {
                println!("{:?} {} {:?}", c.kind, c.n, pair);
            }
        }
    }
}
