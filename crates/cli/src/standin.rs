//! Stand-in until the computation arrives.
#![allow(missing_docs, dead_code)]
use grazing_reproduction::parameters::Parameters;
use polars::prelude::*;
use std::collections::BTreeMap;
pub trait Progress: Sync {
    fn begin(&self, what: &str, steps: u64);
    fn step(&self, what: &str);
    fn end(&self, what: &str);
}
pub struct Table {
    pub name: &'static str,
    pub frame: DataFrame,
}
pub struct Study<'a> {
    p: Parameters,
    progress: Option<&'a dyn Progress>,
}
pub struct Frames(Vec<&'static str>);
impl Frames {
    pub fn tables(&self) -> Vec<Table> {
        self.0.iter().map(|n| Table { name: n, frame: df!("kind" => ["GZ","SN"], "x" => [0.1, f64::NAN], "y" => [-0.0, 1.0/3.0], "n" => [1u32,2], "ok"=>[true,false]).unwrap() }).collect()
    }
}
impl<'a> Study<'a> {
    pub fn new(p: &Parameters) -> Study<'a> {
        Study {
            p: p.clone(),
            progress: None,
        }
    }
    pub fn with_progress(mut self, progress: &'a dyn Progress) -> Study<'a> {
        self.progress = Some(progress);
        self
    }
    fn go(&self, what: &'static str, t: &[&'static str]) -> Result<Frames, std::io::Error> {
        if let Some(p) = self.progress {
            p.begin(what, 10);
            for _ in 0..10 {
                p.step(what);
                std::thread::sleep(std::time::Duration::from_millis(10));
            }
            p.end(what);
        }
        Ok(Frames(t.to_vec()))
    }
    pub fn coefficients(&self) -> Result<Frames, std::io::Error> {
        self.go("coefficients", &["coefficients"])
    }
    pub fn fig02(&self) -> Result<Frames, std::io::Error> {
        self.go(
            "fig02",
            &["fig02_branches", "fig02_bifurcations", "fig02_attractor"],
        )
    }
    pub fn fig07(&self) -> Result<Frames, std::io::Error> {
        self.go("fig07", &["fig07_curves", "fig07_points"])
    }
    pub fn fig08(&self) -> Result<Frames, std::io::Error> {
        self.go("fig08", &["fig08_curves"])
    }
    pub fn published_values(&self) -> Result<BTreeMap<&'static str, f64>, std::io::Error> {
        Ok(BTreeMap::from([
            ("zeta", self.p.zeta()),
            ("epsilon", self.p.epsilon()),
            ("fig02_tau", 0.82471),
        ]))
    }
}
