//! Whether the curves of one p are all there: slices of the plane in which every bifurcation must lie on a known curve.
//!
//! One that does not starts a new curve, until none is left unexplained.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::{Curve, Event, MpsCurve, Route, Window};
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{Unknowns, unknown};
use grazing_model::ImpactOscillator;
use rayon::prelude::*;

use crate::curves::{DiagramCurve, Net};
use crate::faces::Point;
use crate::progress::Progress;
use crate::regions::{Doubt, Sight, Surveyor};
use crate::slices::{Border, Slice, Slicer, broken_at, spread, steps, stretches};

/// The slices through the surface of p-loop MPSs, in the order of η.
pub(crate) struct Survey<'a, O> {
    net: &'a mut Net<O>,
    slicer: Slicer<'a, O>,
    route: Route,
    slices: Vec<Slice<Curve>>,
    /// Slices of constant μ have been looked at.
    crossed: bool,
    /// MPSs on the slices to begin with to which nothing may lead.
    found: Vec<Unknowns>,
}

/// Slices of constant μ divide the range of μ into so many parts; the first and the last are the window's edges.
const ACROSS: u32 = 8;
/// Bifurcations closer than this, in (y, z) and shares of the range of μ, are one: both were located to some 10⁻¹⁰.
const SAME: f64 = 1e-6;
/// Where good solutions extend no farther than this share of the ranges, which is how well curves are drawn, nothing is looked for that bounds them, and nothing
/// is left undecided for want of it: beside the way over a hill of the potential there is any number of such slivers, one thinner than the other.
/// Where they are wider other slices see them.
const SLIVER: f64 = 1e-4;
/// A bifurcation this far from a chord between two points of a curve may be one of the curve.
const NEAR: f64 = 0.05;

impl<'a, O: ImpactOscillator> Survey<'a, O> {
    pub(crate) fn new(
        net: &'a mut Net<O>,
        route: Route,
        grazing: &'a (dyn Fn(f64) -> Vec<[f64; 2]> + Sync),
        found: Vec<Unknowns>,
    ) -> Self {
        let slicer = Slicer::new(&net.equations, route.window, steps(route.window), grazing);
        Self { net, slicer, route, slices: Vec::new(), crossed: false, found }
    }

    /// Takes branches to all slices and starts the curves that are missing, until neither is left.
    fn complete(&mut self, progress: &dyn Progress) {
        loop {
            spread(&mut self.slices, progress, |from, to| self.slicer.carry(from, to));
            self.explain(progress);
            let curves = &self.net.curves;
            let fresh: Vec<bool> =
                self.slices.par_iter_mut().map(|slice| self.slicer.through_curves(slice, curves)).collect();
            if progress.stopped() {
                break;
            }
            if !fresh.contains(&true) {
                if self.found.is_empty() {
                    break;
                }
                // Only now that all are known to which something leads.
                let found = core::mem::take(&mut self.found);
                self.slices.par_iter_mut().for_each(|slice| {
                    let secondary = slice.secondary;
                    let here = found.iter().filter(|solution| solution[unknown::SECONDARY] == secondary);
                    self.slicer.through(slice, here.copied());
                });
            }
        }
    }

    /// Starts a curve at every bifurcation that lies on none.
    fn explain(&mut self, progress: &dyn Progress) {
        for slice in &mut self.slices {
            explain(self.net, slice.take_new(), &self.route, progress);
        }
        let [left, right] = self.route.window.primary;
        if !core::mem::replace(&mut self.crossed, true) {
            let places: Vec<f64> =
                (0..=ACROSS).map(|k| left + (right - left) * f64::from(k) / f64::from(ACROSS)).collect();
            let found: Vec<_> =
                places.par_iter().map(|primary| self.slicer.across(&self.slices, *primary)).collect();
            for branches in found {
                explain(self.net, &branches, &self.route, progress);
            }
        }
    }
}

/// Whether the good solutions beside a border extend farther than can be drawn, or grazing bounds them.
fn is_wide(border: &Border<'_>, window: Window) -> bool {
    let widths = window.widths();
    border.reach.is_none_or(|reach| [0, 1].iter().any(|&k| reach[k] > SLIVER * widths[k]))
}

/// Starts a curve at every bifurcation on some branches that lies on none.
fn explain<O: ImpactOscillator>(
    net: &mut Net<O>,
    branches: &[Curve],
    route: &Route,
    progress: &dyn Progress,
) {
    for branch in branches {
        let (_, borders) = stretches(&net.equations, branch);
        let wide = borders.iter().filter(|border| is_wide(border, route.window));
        for event in wide.filter_map(|border| border.event) {
            if !progress.stopped() && !explained(net, event, route.window.primary) {
                start(net, event, route);
            }
        }
    }
}

impl<O: ImpactOscillator> Surveyor for Survey<'_, O> {
    fn look_at(&mut self, levels: &[f64], progress: &dyn Progress) {
        let found: Vec<_> = levels.par_iter().map(|level| self.slicer.beginning_at_grazing(*level)).collect();
        self.slices.extend(found);
        self.complete(progress);
    }

    fn lines(&self) -> Vec<Vec<Point>> {
        self.net.curves.iter().map(|curve| curve.curve.parameters()).collect()
    }

    fn curves(&self) -> &[DiagramCurve] {
        &self.net.curves
    }

    fn sights(&self) -> Vec<Sight> {
        let sight = |slice: &Slice<Curve>| {
            let mut sight = Sight::of(slice);
            for branch in &slice.branches {
                let (stretches, borders) = stretches(&self.net.equations, branch);
                for stretch in stretches.iter().filter(|stretch| stretch.good) {
                    sight.see(stretch.primary);
                }
                let unnamed = borders.iter().filter(|border| border.event.is_none());
                for border in unnamed.filter(|border| is_wide(border, self.route.window)) {
                    sight.doubt(border.primary, Doubt::UnnamedChange);
                }
                for (primary, reason) in broken_at(branch) {
                    sight.doubt(primary, Doubt::Broken(reason));
                }
            }
            sight
        };
        self.slices.iter().map(sight).collect()
    }
}

/// Whether a bifurcation on a slice lies on a known curve.
fn explained<O: ImpactOscillator>(net: &Net<O>, event: &Event, [left, right]: [f64; 2]) -> bool {
    let Some(kind) = Bifurcation::of(event.condition) else { return true };
    let here = event.solution.unknowns;
    let secondary = here[unknown::SECONDARY];
    let distance = |point: &Unknowns| {
        let mut gap = point - here;
        gap[unknown::PHASE] = libm::remainder(gap[unknown::PHASE], core::f64::consts::TAU);
        gap[unknown::PRIMARY] /= right - left;
        gap[unknown::SECONDARY] = 0.0;
        gap.norm()
    };
    net.curves.iter().filter(|curve| curve.kind == kind).any(|curve| {
        curve.curve.points.windows(2).any(|pair| {
            let [a, b] = [pair[0].solution.unknowns, pair[1].solution.unknowns];
            let [from, to] = [a[unknown::SECONDARY] - secondary, b[unknown::SECONDARY] - secondary];
            if from * to > 0.0 {
                return false;
            }
            let way = if from == to { 0.0 } else { from / (from - to) };
            let mut near = a + (b - a) * way;
            near[unknown::SECONDARY] = secondary;
            if distance(&near) > NEAR {
                return false;
            }
            let mut times = pair[0].times.clone();
            let found =
                locate(&net.equations, [event.condition, Condition::Secondary(secondary)], near, &mut times);
            found.is_ok_and(|found| distance(&found) < SAME) || distance(&near) < SAME
        })
    })
}

/// Follows the curve through a bifurcation that lies on none that is known.
fn start<O: ImpactOscillator>(net: &mut Net<O>, event: &Event, route: &Route) {
    let Some(kind) = Bifurcation::of(event.condition) else { return };
    let curve = MpsCurve { equations: net.equations.clone(), condition: event.condition };
    // Across the slice.
    let upwards = Unknowns::new(0.0, 0.0, 0.0, 1.0);
    if let Ok(curve) = curve.follow_both_ways(event.solution.unknowns, upwards, &event.times, route) {
        net.add(DiagramCurve { kind, loops: net.loops(), n: 0, curve });
        net.grow(route);
    }
}

#[cfg(test)]
mod tests {
    use grazing_continuation::arclength::StepControl;
    use grazing_continuation::mps::{Formulation, LoopEquations};
    use grazing_description::Description;
    use grazing_model::smooth::Integrated;

    use super::*;
    use crate::diagram::route;
    use crate::progress::Silent;
    use crate::search;

    /// What is seen of p-loop MPSs on slices through a random oscillator to which nothing leads from grazing, and the number of curves.
    fn seen(number: u64, seed: u64, loops: u32, window: Window, levels: &[f64]) -> (usize, Vec<Sight>) {
        let text = grazing_trials::oscillators::description(seed, number);
        let model = Description::parse(&text, "two wells").expect("what is made at random is right");
        let oscillator = Integrated::new(model, [window.primary[0], window.secondary[0]]);
        let found = search::on_slices(&oscillator, &[loops], window, levels, 2.0, &Silent);
        let found = found.into_iter().map(|(_, solution)| solution).collect();
        let mut net = Net::new(LoopEquations::new(oscillator, loops, Formulation::FixedPhase));
        let mut survey = Survey::new(&mut net, route(window, StepControl::DRAWING), &|_| Vec::new(), found);
        survey.look_at(levels, &Silent);
        (survey.lines().len(), survey.sights())
    }

    #[test]
    fn a_sheet_of_solutions_between_two_points_of_the_edge_is_found() {
        // Two wells: inside this window nothing leads from grazing to these MPSs.
        let window = Window { primary: [0.7, 0.7616], secondary: [0.4483, 0.4917] };
        let (lines, sights) = seen(2, 1, 1, window, &[0.48, 0.4917]);
        assert_eq!(lines, 3);
        // Simulation settles on a solution with one loop here.
        assert!(sights.iter().all(|sight| sight.share([0.73, 0.736]) == 1.0), "{sights:?}");
    }

    #[test]
    fn a_sheet_that_begins_where_motion_of_twice_the_period_grazes_is_found() {
        let window = Window { primary: [0.0, 0.5266], secondary: [0.5533, 0.5834] };
        let (_, sights) = seen(2, 20_261_122, 2, window, &[0.5533, 0.580_712_5]);
        // Simulation settles on solutions with two loops here.
        for place in [[0.2575, 0.269], [0.4135, 0.425]] {
            assert_eq!(sights[1].share(place), 1.0, "{sights:?}");
        }
    }
}
