//! The bifurcation curves of the p-loop MPSs of one p, and the codimension-two points at which they
//! meet.

use grazing_continuation::arclength::StepControl;
use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo};
use grazing_continuation::curve::{Curve, CurveEnd, Event, Route, Window};
use grazing_continuation::cusp::cusps;
use grazing_continuation::locate::same_point;
use grazing_continuation::mps::{LoopEquations, Unknowns, unknown};

use crate::beyond_grazing;
use crate::copies::without_copies;

/// A curve with this many points is lost.
const STEP_LIMIT: usize = 20_000;

/// Ends at y = 0 closer than this are at one resonance: GZ curves may be off by as much where waves
/// of an integrated oscillator are short (4 · 10⁻⁷ was seen), and resonances lie farther apart.
const AT_ONE_RESONANCE: f64 = 1e-5;

/// The route through a window to the first event.
pub fn route(window: Window, control: StepControl) -> Route<'static> {
    Route { window, control, step_limit: STEP_LIMIT, stop_at_events: true, pace: None }
}

/// The route of curves that are drawn: in a small window steps are also small, down to where curves
/// are straight.
pub(crate) fn drawn(window: Window) -> Route<'static> {
    let control = StepControl::DRAWING;
    let [across, up] = window.widths();
    // A chord of long steps across the shorter side of a long window would deviate too far from its
    // curve.
    let size = across.max(up).min(LONG_WINDOW * across.min(up));
    let longest = control.longest * size.min(1.0);
    route(window, StepControl { longest: longest.max(LEAST_STEPS * control.shortest), ..control })
}

/// Ratio of the sides above which a window is long.
const LONG_WINDOW: f64 = 2.0;
/// Smallest ratio of the longest steps to the shortest.
const LEAST_STEPS: f64 = 10.0;

/// A bifurcation curve of the diagram.
#[derive(Clone, Debug)]
pub struct DiagramCurve {
    /// The bifurcation along the curve.
    pub kind: Bifurcation,
    /// Number of loops p.
    pub loops: u32,
    /// The integer n of the resonance that the curve leaves, for a GZ curve that of the SN and PD
    /// curves that end on it; 0 without one.
    pub n: u32,
    /// The curve.
    pub curve: Curve,
}

impl DiagramCurve {
    /// Whether two curves are the same, perhaps followed from different ends.
    pub fn is_same(&self, other: &Self) -> bool {
        let ([first, last], [start, end]) = (self.ends(), other.ends());
        let same = |a, b| same_point(&first, a) && same_point(&last, b);
        self.kind == other.kind && self.loops == other.loops && (same(&start, &end) || same(&end, &start))
    }

    /// The pieces of the curve that cross a window, each with its first point outside at either
    /// end.
    pub(crate) fn within(&self, window: Window) -> Vec<Self> {
        within(&self.curve, window).into_iter().map(|curve| Self { curve, ..*self }).collect()
    }

    /// Moves an end of a GZ curve at y = 0 to that of a curve of another kind, where both leave one
    /// resonance: its own end is a simple zero of a determinant, which is known to fewer digits.
    fn end_with(&mut self, other: &Self) {
        if self.kind != Bifurcation::Grazing || other.kind == Bifurcation::Grazing {
            return;
        }
        let at_grazing = |at: &Unknowns| at[unknown::VELOCITY] == 0.0;
        for place in other.ends().into_iter().filter(at_grazing) {
            let [first, .., last] = self.curve.points.as_mut_slice() else { continue };
            for end in [first, last].map(|point| &mut point.solution.unknowns) {
                let gap = |index: usize| (end[index] - place[index]).abs();
                if at_grazing(end) && gap(unknown::PRIMARY).max(gap(unknown::SECONDARY)) < AT_ONE_RESONANCE {
                    *end = place.clone();
                }
            }
        }
    }

    /// The first and the last point.
    pub(crate) fn ends(&self) -> [Unknowns; 2] {
        let points = &self.curve.points;
        [points[0].solution.unknowns.clone(), points[points.len() - 1].solution.unknowns.clone()]
    }
}

/// The pieces of a curve that cross a window, each with its first point outside at either end.
pub(crate) fn within(curve: &Curve, window: Window) -> Vec<Curve> {
    let places = curve.parameters();
    let chords = places.windows(2).map(|pair| crosses(window, [pair[0], pair[1]]));
    let mut pieces: Vec<[usize; 2]> = Vec::new();
    for (k, _) in chords.enumerate().filter(|(_, crosses)| *crosses) {
        match pieces.last_mut() {
            Some([_, last]) if *last == k => *last = k + 1,
            _ => pieces.push([k, k + 1]),
        }
    }
    let Curve { points, end, beginning, .. } = curve;
    let left = || CurveEnd::LeftWindow;
    let piece = |[first, last]: [usize; 2]| Curve {
        condition: curve.condition,
        points: points[first..=last].to_vec(),
        events: Vec::new(),
        end: if last + 1 == points.len() { end.clone() } else { left() },
        beginning: if first == 0 { beginning.clone() } else { Some(left()) },
    };
    pieces.into_iter().map(piece).collect()
}

/// Whether a chord between two points (μ, η) has a part in a window.
fn crosses(window: Window, ends: [[f64; 2]; 2]) -> bool {
    let [from, to] = ends.map(|end| window.shares(end));
    let mut part = [0.0, 1.0];
    for k in 0..2 {
        // Fractions at which the chord enters and leaves; a chord parallel to an edge does not
        // cross it.
        let at = [0.0, 1.0].map(|edge| (edge - from[k]) / (to[k] - from[k]));
        if to[k] != from[k] {
            part = [f64::max(part[0], at[0].min(at[1])), f64::min(part[1], at[0].max(at[1]))];
        } else if !(0.0..=1.0).contains(&from[k]) {
            return false;
        }
    }
    part[0] <= part[1]
}

/// A codimension-two point other than a resonance.
#[derive(Clone, Debug)]
pub struct CodimensionTwoPoint {
    /// The bifurcation at the point.
    pub kind: CodimensionTwo,
    /// Number of loops p.
    pub loops: u32,
    /// The integer n of the resonance that the curves leave which meet there; 0 without one.
    pub n: u32,
    /// The event on the curve on which the point was reached: its end, except for cusps.
    pub event: Event,
}

impl CodimensionTwoPoint {
    /// The unknowns (y, z, μ, η).
    pub fn unknowns(&self) -> Unknowns {
        self.event.solution.unknowns.clone()
    }
}

/// The known curves of one p, 0 without impacts.
#[derive(Clone, Debug)]
pub(crate) struct Net {
    pub(crate) equations: LoopEquations,
    pub(crate) curves: Vec<DiagramCurve>,
    pub(crate) meetings: Vec<CodimensionTwoPoint>,
    /// The number of codimension-two points from which further curves have been followed.
    grown: usize,
    /// The ends of the first curves, beyond the window if need be.
    pub(crate) reached: Vec<Vec<Unknowns>>,
}

impl Net {
    pub(crate) fn new(equations: LoopEquations) -> Self {
        Self { equations, curves: Vec::new(), meetings: Vec::new(), grown: 0, reached: Vec::new() }
    }

    pub(crate) fn loops(&self) -> u32 {
        self.equations.loops()
    }

    /// Adds a curve, unless it is one of the known curves followed from its other end.
    pub(crate) fn add(&mut self, new: DiagramCurve) {
        let mut new = DiagramCurve { curve: without_copies(&self.equations, new.curve), ..new };
        for known in &mut self.curves {
            new.end_with(known);
            known.end_with(&new);
        }
        if self.curves.iter().any(|old| old.is_same(&new)) {
            return;
        }
        for end in [new.curve.beginning.as_ref(), Some(&new.curve.end)] {
            if let Some(CurveEnd::Event(event)) = end {
                self.meet(&new, event);
            }
        }
        if new.kind == Bifurcation::SaddleNode {
            for event in cusps(&self.equations, &new.curve) {
                self.meetings.push(CodimensionTwoPoint {
                    kind: CodimensionTwo::Cusp,
                    loops: new.loops,
                    n: new.n,
                    event,
                });
            }
        }
        self.curves.push(new);
    }

    /// Adds the codimension-two point at an end of a curve, unless it is known.
    fn meet(&mut self, curve: &DiagramCurve, event: &Event) {
        let other = Bifurcation::of(event.condition, curve.loops).unwrap_or(Bifurcation::Grazing);
        let kind = CodimensionTwo::of_meeting(curve.kind, other);
        let unknowns = event.solution.unknowns.clone();
        if !self.meetings.iter().any(|corner| same_point(&corner.unknowns(), &unknowns)) {
            self.meetings.push(CodimensionTwoPoint {
                kind,
                loops: curve.loops,
                n: curve.n,
                event: event.clone(),
            });
        }
    }

    /// Forgets what has been found since these were its curves.
    pub(crate) fn return_to(&mut self, curves: Vec<DiagramCurve>) {
        self.curves = curves;
        let ends: Vec<Unknowns> = self.curves.iter().flat_map(DiagramCurve::ends).collect();
        let known = |point: &CodimensionTwoPoint| {
            let place = point.unknowns();
            point.kind == CodimensionTwo::Cusp || ends.iter().any(|end| same_point(end, &place))
        };
        self.meetings.retain(known);
    }

    /// Follows the missing ones of the two curves that meet at each codimension-two point, and
    /// continues from their ends.
    pub(crate) fn grow(&mut self, route: &Route<'_>) {
        while let Some(CodimensionTwoPoint { kind: meeting, loops, n, event }) =
            self.meetings.get(self.grown).cloned()
        {
            self.grown += 1;
            let kind = Bifurcation::of(event.condition, loops);
            // Where none grazes, the other curve passes through the point.
            let grazes = meeting.curves().contains(&Bifurcation::Grazing);
            let Some(kind) = kind.filter(|_| grazes) else { continue };
            let corner = event.solution.unknowns.clone();
            let there = self.curves.iter().filter(|curve| {
                curve.kind == kind && curve.ends().iter().any(|end| same_point(end, &corner))
            });
            let known = there.count() >= if meeting == CodimensionTwo::GrazingGrazing { 2 } else { 1 };
            // A curve that bounds no region of stable solutions there is not part of the diagram.
            if !known && let Ok(curve) = self.equations.branch_off(&event, route) {
                self.add(DiagramCurve { kind, loops, n, curve });
            }
            if self.equations.has_impacts() {
                self.grow_beyond(&corner, route);
            }
        }
    }

    /// Adds the farther pieces of the SN and PD curves that end at a point of a GZ curve.
    fn grow_beyond(&mut self, corner: &Unknowns, route: &Route<'_>) {
        let mut farther = Vec::new();
        for ended in &self.curves {
            let points = &ended.curve.points;
            let [.., before, last] = points.as_slice() else { continue };
            let ways = [[&points[1], &points[0]], [before, last]];
            for way in ways.into_iter().filter(|[_, end]| same_point(&end.solution.unknowns, corner)) {
                if ended.kind != Bifurcation::Grazing {
                    let again =
                        beyond_grazing::admissible_again(&self.equations, ended.kind.condition(), way, route);
                    farther.extend(again.into_iter().map(|curve| DiagramCurve { curve, ..*ended }));
                }
            }
        }
        farther.into_iter().for_each(|curve| self.add(curve));
    }
}
