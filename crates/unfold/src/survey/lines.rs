//! The lines that cut the window into faces.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::Window;
use grazing_continuation::mps::parameters;
use nalgebra::Vector2;

use super::Survey;
use crate::curves::{CodimensionTwoPoint, DiagramCurve};
use crate::faces::Point;
use crate::grazing::GrazingCurvePoint;
use crate::slices::near_chord;
use crate::tolerances::{CLEAR, DRAWN};
use crate::{Scope, close_curves};

/// Impact velocity below which a bifurcation curve runs beside the grazing curve, as long as it is near.
const BESIDE_GRAZING: f64 = 1e-3;

impl Survey<'_> {
    /// The lines that cut the window, as polylines.
    pub(crate) fn lines(&mut self) -> Vec<Vec<Point>> {
        let curves = &self.net.curves;
        let has_impacts = self.loops() > 0;
        let covered = |k: usize| curves[..k].iter().any(|earlier| covers(self.scope, earlier, &curves[k]));
        // With symmetric stops, motion without impacts touches both at once.
        let grazing: Vec<Vec<Point>> =
            self.grazing.iter().map(|curve| curve.parameters().collect()).collect();
        let touches_both = |k: usize| {
            curves[k].kind == Bifurcation::NonImpactingGrazing
                && grazing.iter().any(|line| lies_on(self.scope, line, &curves[k]))
        };
        let shown = |k: &usize| !self.images || !covered(*k) && !touches_both(*k);
        let shown: Vec<usize> = (0..curves.len()).filter(shown).collect();
        let levels: Vec<f64> = self.slices.iter().map(|slice| slice.secondary).collect();
        let mut lines: Vec<Vec<Point>> = Vec::new();
        if !has_impacts {
            lines.extend(grazing);
        }
        lines.extend(self.doublings());
        lines.extend(close_curves::polylines(
            &self.net.equations,
            curves,
            &shown,
            (self.scope.window, &levels),
            &mut self.vertices,
        ));
        if has_impacts {
            lines.extend(self.forgotten());
            self.meet_doublings(&mut lines);
        }
        // An NS curve ends there on another one.
        let on_other = |corner: &&CodimensionTwoPoint| corner.kind.curves()[1] == Bifurcation::Torus;
        for corner in self.net.meetings.iter().filter(on_other) {
            meet(&mut lines, parameters(&corner.unknowns()), self.scope.window);
        }
        lines
    }

    /// The stretches of grazing curves along which no bifurcation curve runs, as neighbouring motion is
    /// forgotten meanwhile: solutions with one loop are stable from there on. Curves that end beside
    /// grazing end on them.
    fn forgotten(&self) -> Vec<Vec<Point>> {
        let window = self.scope.window;
        let points = |curve: &DiagramCurve| {
            let points = curve.curve.points.iter().map(|point| point.solution.clone());
            points.map(|solution| (solution.parameters(), solution.impact_velocity())).collect::<Vec<_>>()
        };
        let curves: Vec<_> = self.net.curves.iter().map(points).collect();
        // GZ curves bound solutions on the other side.
        let kinds = self.net.curves.iter().map(|curve| curve.kind);
        let bounding = curves.iter().zip(kinds).filter(|(_, kind)| *kind != Bifurcation::Grazing);
        let beside: Vec<[Point; 2]> = bounding
            .flat_map(|(points, _)| points.windows(2))
            .filter(|pair| pair.iter().any(|(_, velocity)| *velocity < BESIDE_GRAZING))
            .map(|pair| [pair[0].0, pair[1].0])
            .collect();
        let mut lines: Vec<Vec<Point>> = Vec::new();
        for curve in &self.grazing {
            let turns = (self.loops() / curve.periods).min(2);
            let is_bare = |state: &GrazingCurvePoint| {
                let at = state.parameters();
                state.multipliers.forget(turns)
                    && !beside.iter().any(|chord| from_chord(window, at, chord) < CLEAR)
            };
            let bare: Vec<bool> = curve.states.iter().map(is_bare).collect();
            let mut after = 0;
            for run in bare.chunk_by(|a, b| a == b) {
                let first = after;
                after += run.len();
                if run[0] {
                    // With the neighbours, beside which a curve goes on.
                    let states = &curve.states[first.saturating_sub(1)..(after + 1).min(bare.len())];
                    lines.push(states.iter().map(GrazingCurvePoint::parameters).collect());
                }
            }
        }
        let ends = curves.iter().filter_map(|points| Some([points.first()?, points.last()?])).flatten();
        for (end, _) in ends.filter(|(_, velocity)| *velocity < BESIDE_GRAZING) {
            meet(&mut lines, *end, window);
        }
        lines
    }

    /// The curves of period doublings at which branches begin.
    fn doublings(&self) -> impl Iterator<Item = Vec<Point>> {
        let doublings = self.halved.iter().filter(|curve| curve.kind == Bifurcation::PeriodDoubling);
        doublings.map(|curve| curve.curve.parameters())
    }

    /// Makes ends of own curves at curves of period doublings their vertices: there a solution becomes one of
    /// half the time.
    fn meet_doublings(&self, lines: &mut [Vec<Point>]) {
        if self.halved.is_empty() {
            return;
        }
        let ends: Vec<Point> =
            self.net.curves.iter().flat_map(|curve| curve.ends().map(|end| parameters(&end))).collect();
        let is_loose = |end: &&Point| ends.iter().filter(|other| other == end).count() == 1;
        ends.iter().filter(is_loose).for_each(|end| meet(lines, *end, self.scope.window));
    }

    /// Curves at which branches begin, except grazing of motion over one forcing period.
    pub(crate) fn beginnings(&self) -> Vec<Vec<Point>> {
        let grazing = self.grazing.iter().filter(|curve| curve.periods > 1);
        grazing.map(|curve| curve.parameters().collect()).chain(self.doublings()).collect()
    }
}

/// The distance of a point from a chord, in fractions of the ranges.
fn from_chord(window: Window, point: Point, chord: &[Point]) -> f64 {
    let place = |at: Point| Vector2::from(window.shares(at)) - Vector2::from(window.shares(point));
    let [start, chord] = [place(chord[0]), place(chord[1]) - place(chord[0])];
    let along = (-start.dot(&chord) / chord.norm_squared()).clamp(0.0, 1.0);
    (start + chord * along).norm()
}

/// Makes an end of one line that lies on another a vertex of the other as well.
fn meet(lines: &mut [Vec<Point>], end: Point, window: Window) {
    let others =
        lines.iter().enumerate().filter(|(_, line)| ![line.first(), line.last()].contains(&Some(&end)));
    let chords = others.flat_map(|(k, line)| (1..).zip(line.windows(2)).map(move |(at, pair)| (k, at, pair)));
    let nearest =
        chords.map(|(k, at, pair)| (from_chord(window, end, pair), k, at)).min_by(|a, b| a.0.total_cmp(&b.0));
    if let Some((_, k, at)) = nearest.filter(|(distance, ..)| *distance < CLEAR) {
        lines[k].insert(at, end);
    }
}

/// Whether one curve lies on another in the plane, as do those of motion in both wells of a
/// symmetric force: only slivers would lie between them.
fn covers(scope: &Scope, known: &DiagramCurve, other: &DiagramCurve) -> bool {
    known.kind == other.kind && lies_on(scope, &known.curve.parameters(), other)
}

/// Whether a curve lies on a line.
fn lies_on(scope: &Scope, line: &[Point], curve: &DiagramCurve) -> bool {
    let places = |points: &[Point]| -> Vec<Vector2<f64>> {
        points.iter().map(|at| Vector2::from(scope.window.shares(*at))).collect()
    };
    let [line, points] = [places(line), places(&curve.curve.parameters())];
    let near = |point: &Vector2<f64>| {
        line.windows(2).any(|pair| {
            let chord = pair[1] - pair[0];
            near_chord(&(pair[0] - point), &chord, DRAWN / chord.norm())
        })
    };
    points.iter().all(near)
}
