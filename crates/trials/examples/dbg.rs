use grazing_continuation::curve::Window;
use grazing_description::Description;
use grazing_model::smooth::Integrated;
use grazing_unfold::{Diagram, Scope, progress::Silent};
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let d = Description::from_file(std::path::Path::new(&a[1])).unwrap();
    let loops: Vec<u32> = a[2].split(',').map(|p| p.parse().unwrap()).collect();
    let window = Window { primary: d.primary().range(), secondary: d.secondary().range() };
    let scope = Scope { window, loops, start: d.start() };
    let o = Integrated::new(d.clone(), [window.primary[0], window.secondary[0]]);
    let dia = Diagram::compute(&o, &scope, &Silent).unwrap();
    for c in &dia.curves {
        println!(
            "{} p={} n={} {} points {:?}..{:?}",
            c.kind.name(),
            c.loops,
            c.n,
            c.curve.points.len(),
            c.curve.points[0].solution.parameters(),
            c.curve.points.last().unwrap().solution.parameters()
        );
    }
    for r in &dia.regions {
        println!("{:?} p={} n={} {}", r.kind, r.loops, r.n, r.rings[0].len());
    }
}
