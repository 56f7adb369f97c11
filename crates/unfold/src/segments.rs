//! Segments of branches on which solutions are stable and admissible, the borders between them,
//! and the points where a branch breaks off.

use grazing_continuation::curve::{Curve, CurveEnd, Event};
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, LoopEquations, PeriodicSolution};
use grazing_results::span;

/// A piece of a branch on which stability and admissibility do not change.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BranchPiece {
    /// The primary parameter at its ends.
    pub(crate) primary: [f64; 2],
    /// Whether the MPSs are stable and admissible.
    pub(crate) good: bool,
}

/// A point at which MPSs begin or cease to be stable or admissible.
#[derive(Clone, Debug)]
pub(crate) struct Border<'a> {
    pub(crate) primary: f64,
    /// The bifurcation; `None` where it was not located.
    pub(crate) event: Option<&'a Event>,
    /// The extent in both parameters of the stable, admissible MPSs beside it, unless grazing
    /// bounds them.
    pub(crate) reach: Option<[f64; 2]>,
}

/// A point of a branch: one of the curve's points, or an event.
pub(crate) struct BranchVertex<'a> {
    pub(crate) solution: &'a PeriodicSolution,
    pub(crate) event: Option<&'a Event>,
}

/// The points of a branch with its events in their places.
pub(crate) fn vertices(branch: &Curve) -> Vec<BranchVertex<'_>> {
    fn happens(event: &Event) -> BranchVertex<'_> {
        BranchVertex { solution: &event.solution, event: Some(event) }
    }
    let mut vertices = Vec::with_capacity(branch.points.len() + branch.events.len());
    let mut events = branch.events.iter().peekable();
    for (index, point) in branch.points.iter().enumerate() {
        while let Some(event) = events.next_if(|event| event.index <= index) {
            vertices.push(happens(event));
        }
        vertices.push(BranchVertex { solution: &point.solution, event: None });
    }
    vertices.extend(events.map(happens));
    vertices
}

/// The segments of a branch and the borders between them, where MPSs are stable and admissible on
/// one of both sides.
pub(crate) fn segments<'a>(
    equations: &LoopEquations,
    branch: &'a Curve,
) -> (Vec<BranchPiece>, Vec<Border<'a>>) {
    let vertices = vertices(branch);
    // A multiplier is 1 there.
    let first = vertices.first().filter(|_| matches!(branch.beginning, Some(CurveEnd::Halved)));
    let first = first.map(|vertex| vertex.solution);
    let is_border = |vertex: &BranchVertex<'_>| {
        vertex.event.is_some() || first.is_some_and(|first| core::ptr::eq(first, vertex.solution))
    };
    let status = |pair: &[BranchVertex<'_>]| {
        let [a, b] = [&pair[0], &pair[1]];
        match [is_border(a), is_border(b)] {
            [false, _] => a.solution.attracts(),
            [_, false] => b.solution.attracts(),
            // Between two successive events the solution in the middle decides.
            _ => middle_of(equations, a.solution, b.solution).is_some_and(|solution| solution.attracts()),
        }
    };
    let primary = |vertex: &BranchVertex<'_>| vertex.solution.parameters()[0];
    let segments: Vec<BranchPiece> = vertices
        .windows(2)
        .map(|pair| BranchPiece { primary: [primary(&pair[0]), primary(&pair[1])], good: status(pair) })
        .collect();
    let mut borders: Vec<Border<'a>> = Vec::new();
    let mut end = 0;
    for run in segments.chunk_by(|a, b| a.good == b.good) {
        let start = end;
        end += run.len();
        if run[0].good {
            let all = &vertices[start..=end];
            // Grazing may bound as short a segment, and is kept.
            let grazes = |vertex: &BranchVertex<'_>| {
                vertex.event.is_some_and(|it| it.condition == Condition::InteriorGrazing)
            };
            let extent = |k: usize| {
                let [least, greatest] = span(all.iter().map(|vertex| vertex.solution.parameters()[k]));
                greatest - least
            };
            let reach = (!all.iter().any(grazes)).then(|| [0, 1].map(extent));
            let inner = [start, end].into_iter().filter(|k| 0 < *k && *k < segments.len());
            borders.extend(inner.map(|k| Border {
                primary: primary(&vertices[k]),
                event: vertices[k].event,
                reach,
            }));
        }
    }
    (segments, borders)
}

/// The solution half-way between two neighbours on a branch.
fn middle_of(
    equations: &LoopEquations,
    a: &PeriodicSolution,
    b: &PeriodicSolution,
) -> Option<PeriodicSolution> {
    let middle = (&a.unknowns + &b.unknowns) * 0.5;
    let conditions = Condition::beside(equations, &middle);
    let found = locate(equations, conditions, middle, &mut EventTimes::default()).ok()?;
    Some(equations.solution(&found))
}

/// A branch whose multipliers exceed this may end anywhere: it runs into motion that escapes, over
/// a hill of a potential for instance, and nearby solutions are so sensitive to parameters that any
/// stable segments are shorter than a diagram shows (empirical: none was seen by simulation).
const BROKEN_BY_VIOLENCE: f64 = 1e3;

/// The primary parameters at which a branch could not be followed to its end, with the reason;
/// motion without impacts beyond the wall is ignored.
pub(crate) fn broken_at(branch: &Curve) -> impl Iterator<Item = (f64, String)> {
    let ends = [branch.points.first(), branch.points.last()].into_iter().zip(branch.lost());
    ends.filter_map(|(point, reason)| {
        let last = &point?.solution;
        let matters = last.has_impacts() || last.admissible();
        let violent = last.multipliers.size() > BROKEN_BY_VIOLENCE;
        reason.filter(|_| matters && !violent).map(|reason| (last.parameters()[0], reason))
    })
}
