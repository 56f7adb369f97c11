//! The integer n of curves, codimension-two points and regions: a property of the resonance that a
//! curve leaves, not of the way on which the curve was found.
//!
//! A SN or PD curve has the n of the resonance of its own p at one of its ends, the greater one if
//! there are two. A GZ curve and a point have the n of the curves that end there, a region that of
//! the curves on its border. A curve that leaves the window before it ends is followed further, so
//! that n does not depend on the window. Where there is no such resonance n is 0.

use core::f64::consts::PI;

use grazing_continuation::arclength::StepControl;
use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::{Curve, CurveEnd, CurvePoint, Route, SolutionCurve, Window};
use grazing_continuation::locate::same_point;
use grazing_continuation::mps::{LoopEquations, Unknowns, unknown};
use grazing_theorems::from_map::GrazingOrbit;

use crate::curves::{CodimensionTwoPoint, DiagramCurve, Net, route};
use crate::winding;

/// A curve with this many points outside the window is not followed further.
const FARTHEST: usize = 300;
/// The relative detuning |τ − g_p| / 2√δ below which a grazing point at the end of a curve is a
/// resonance of its p: it is 1 − cos(π/p) or more at those of one loop, and ends are located to
/// about 10⁻⁵.
const AT_RESONANCE: f64 = 1e-3;

impl Net {
    /// Gives each curve and each codimension-two point its n. Curves that leave the window are
    /// followed beyond it only if the window is given: diagrams without regions, which are made for
    /// each member of a family and while a window is dragged, do without.
    pub(crate) fn number(&mut self, window: Option<Window>) {
        if !self.equations.has_impacts() {
            return;
        }
        let route = window
            .map(|window| Route { step_limit: FARTHEST, ..route(around(window), StepControl::DRAWING) });
        let (equations, curves) = (&self.equations, &self.curves);
        // A curve is followed beyond the window once.
        let new = &curves[self.reached.len().min(curves.len())..];
        self.reached.extend(new.iter().map(|curve| ends(equations, curve, route.as_ref())));
        let ends = &self.reached;
        let is_grazing = |k: &usize| curves[*k].kind == Bifurcation::Grazing;
        let (grazing, others): (Vec<usize>, Vec<usize>) = (0..curves.len()).partition(is_grazing);
        let mut numbers = vec![0; curves.len()];
        for &k in &others {
            numbers[k] = ends[k].iter().map(|end| at_resonance(equations, end)).max().unwrap_or(0);
        }
        let ending_at = |place: &Unknowns, kind: &[usize], numbers: &[u32]| {
            let ending = kind.iter().filter(|k| ends[**k].iter().any(|end| same_point(end, place)));
            ending.map(|k| numbers[*k]).max()
        };
        for &k in &grazing {
            let met = ends[k].iter().filter_map(|end| ending_at(end, &others, &numbers));
            numbers[k] = met.max().unwrap_or(0);
        }
        let number = |point: &CodimensionTwoPoint| {
            let place = point.unknowns();
            let ending =
                ending_at(&place, &others, &numbers).or_else(|| ending_at(&place, &grazing, &numbers));
            ending.unwrap_or_else(|| numbers[passing(curves, equations, &place)])
        };
        let points: Vec<u32> = self.meetings.iter().map(number).collect();
        self.curves.iter_mut().zip(numbers).for_each(|(curve, n)| curve.n = n);
        self.meetings.iter_mut().zip(points).for_each(|(point, n)| point.n = n);
    }
}

/// The index of the curve other than GZ that comes closest to a point.
fn passing(curves: &[DiagramCurve], equations: &LoopEquations, place: &Unknowns) -> usize {
    let distance = |curve: &DiagramCurve| {
        let points = curve.curve.points.iter();
        points.map(|at| equations.gap(&at.solution.unknowns, place).norm()).fold(f64::INFINITY, f64::min)
    };
    let own = curves.iter().enumerate().filter(|(_, curve)| curve.kind != Bifurcation::Grazing);
    own.map(|(k, curve)| (k, distance(curve))).min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(k, _)| k)
}

/// The ends of a curve; with a route beyond the window, those to which it leads if it leaves the
/// window.
fn ends(equations: &LoopEquations, curve: &DiagramCurve, route: Option<&Route<'_>>) -> Vec<Unknowns> {
    let Curve { condition, points, beginning, end, .. } = &curve.curve;
    let [first, second, ..] = points.as_slice() else { return Vec::new() };
    let [.., before, last] = points.as_slice() else { return Vec::new() };
    let reached = |[before, at]: [&CurvePoint; 2], end: Option<&CurveEnd>| {
        let here = at.solution.unknowns.clone();
        let Some(route) = route.filter(|_| matches!(end, Some(CurveEnd::LeftWindow))) else { return here };
        let curve = SolutionCurve { equations: equations.clone(), condition: *condition };
        let further =
            curve.follow(here.clone(), &here - &before.solution.unknowns, at.times.clone(), route).ok();
        further.and_then(|further| Some(further.points.last()?.solution.unknowns.clone())).unwrap_or(here)
    };
    vec![reached([second, first], beginning.as_ref()), reached([before, last], Some(end))]
}

/// The n of the resonance of the equations' own p at a point with y = 0; 0 if it is none.
fn at_resonance(equations: &LoopEquations, at: &Unknowns) -> u32 {
    if at.impacts() > 1 || at[unknown::VELOCITY] != 0.0 {
        return 0;
    }
    let loops = equations.loops();
    let Ok(orbit) = GrazingOrbit::find(&equations.oscillator_at(at), at[unknown::PHASE]) else { return 0 };
    let map = orbit.grazing_point().map;
    let detuning = 0.5 * map.trace() / map.determinant().sqrt() - libm::cos(PI / f64::from(loops));
    // For one loop all grazing points at which curves end are resonances.
    if loops == 1 || detuning.abs() < AT_RESONANCE { winding::index(&orbit, loops) } else { 0 }
}

/// A window around this one: half as far to zero and twice as far from it, or three times as wide
/// if it contains zero.
fn around(window: Window) -> Window {
    let wider = |[low, high]: [f64; 2]| match () {
        () if low > 0.0 => [0.5 * low, 2.0 * high],
        () if high < 0.0 => [2.0 * low, 0.5 * high],
        () => [2.0 * low - high, 2.0 * high - low],
    };
    Window { primary: wider(window.primary), secondary: wider(window.secondary) }
}
