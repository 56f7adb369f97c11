#![allow(clippy::all, missing_docs)]
use grazing_continuation::{arclength::StepControl, curve::*, fit::*, locate::*, mps::*, resonance::*};
use grazing_model::*;
use grazing_theorems::LinearOscillator as Th;
fn main() {
    let th = Th::new(0.02, 0.9).unwrap();
    let window = Window { primary: [0.0, 1.3], secondary: [0.35, 1.02] };
    let route = Route { window, control: StepControl::DRAWING, step_limit: 5000, stop_at_events: true };
    for r in th.resonances(&[1, 2, 3], 0.35, 1.02).unwrap() {
        let w = r.forcing_frequency();
        let osc = grazing_model::LinearOscillator::new(0.02, 0.9, r.grazing().amplitude(), w).unwrap();
        let res = ResonantGrazingPoint::find(&osc, r.loops(), r.grazing().phase()).unwrap();
        let u = res.unknowns();
        println!("p {} n {} omega {} err {:e} A err {:e}", r.loops(), r.index(), w, u[3] - w, u[2] - r.grazing().amplitude());
        let sn = quadratic_coefficient(&res, Condition::SADDLE_NODE).unwrap();
        let pd = quadratic_coefficient(&res, Condition::PERIOD_DOUBLING).unwrap();
        let t = res.theorem();
        println!("  SN {} {:e} fit {} +- {:e} actual {:e}", r.saddle_node_coefficient(), t.saddle_node().coefficient / r.saddle_node_coefficient() - 1.0, sn.value, sn.error, sn.value - r.saddle_node_coefficient());
        println!("  PD {} {:e} fit {} +- {:e} actual {:e}", r.period_doubling_coefficient(), t.period_doubling().coefficient / r.period_doubling_coefficient() - 1.0, pd.value, pd.error, pd.value - r.period_doubling_coefficient());
        let unf = res.unfold(&route).unwrap();
        for c in [&unf.saddle_node, &unf.period_doubling].into_iter().chain(&unf.grazing) {
            let l = c.points.last().unwrap();
            let short = match &c.end { CurveEnd::Event(e) => format!("Event {:?}", e.condition), o => format!("{o:?}") };
            println!("    {:?} {} points end {short} {:?} vivid {:?}", c.condition, c.points.len(), &l.solution.unknowns.as_slice(), c.vivid_ended);
        }
    }
}
