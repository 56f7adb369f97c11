use grazing_certify::{ball::Ball, orbit::Oscillator, row::*, search::*};
fn main() {
    let r = |a: i64, b: i64| Ball::from(a) * Ball::from(b).inverse();
    let o = Oscillator::new(r(1, 50), r(9, 10)).unwrap();
    println!("{:?} {:?}", o.omega_1, Ball::PI);
    let goal = Goal { width: 1e-6, amplitude: 1.3, finest: std::env::var("FINEST").map_or(36, |x| x.parse().unwrap()) };
    let a: Vec<i64> = std::env::args().skip(1).map(|x| x.parse().unwrap()).collect();
    let mut all = vec![];
    for p in a[0]..=a[1] {
        let t = std::time::Instant::now();
        let mut n = std::collections::BTreeMap::new();
        for left in a[2]..a[3] {
            for row in rows(&o, Interval { p, left, level: 6, base: Base::Middle }, goal) {
                all.push(row.clone());
                let w = libm::scalbn(1.0, -(row.interval.level as i32));
                let e = n.entry(row.verdict.name()).or_insert((0, 0.0));
                e.0 += 1; e.1 += w;
                let om = o.omega_1.to_f64() / row.interval.all().to_f64();
                match row.verdict {
                    Verdict::Undecided(why) => println!("undecided p {p} omega {om:.12} level {} {why}", row.interval.level),
                    Verdict::Crossing{..} => println!("crossing p {p} omega {om:.12} level {}", row.interval.level),
                    _ => if row.interval.base != Base::Middle { println!("resonance {} {om:.12} {:?}", row.verdict.name(), row.interval.base) }
                }
            }
        }
        println!("{p} {n:?} {:?}", t.elapsed());
    }
    let text = grazing_certify::certificate::rows(&all);
    std::fs::write("/tmp/proto/rows.csv", &text).unwrap();
    std::fs::write("/tmp/proto/statement.csv", format!("name,value\nzeta,1/50\nepsilon,9/10\nomega_lowest,7/20\nomega_highest,51/50\namplitude,13/10\nwidth,1/1000000\nloops,1 2 3\nchecksum,{}\n", grazing_certify::certificate::checksum(&text))).unwrap();
}
