//! The two-parameter diagram: grazing curves, resonances, the curves that leave them, and codimension-two points.

use grazing_continuation::arclength::StepControl;
use grazing_continuation::curve::{Curve, CurveEnd, Event, Route, Window};
use grazing_continuation::cusp::cusps;
use grazing_continuation::locate::Condition;
use grazing_continuation::mps::Unknowns;
use grazing_continuation::resonance::{ResonanceError, ResonantGrazingPoint, UnfoldedResonance, same_point};
use grazing_model::ImpactOscillator;
use rayon::prelude::*;

use crate::free::{self, Survey};
use crate::grazing::GrazingCurve;
use crate::progress::Progress;
use crate::resonances::{self, Resonance, Unlocated};
use crate::{Scope, UnfoldError};

/// Kinds of bifurcation curves, by the names the figures use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Saddle-node bifurcations of MPSs.
    SaddleNode,
    /// Period-doubling bifurcations of MPSs.
    PeriodDoubling,
    /// Grazing bifurcations of MPSs: an interior maximum touches the wall.
    Grazing,
}

impl Kind {
    /// SN, PD or GZ.
    pub const fn name(self) -> &'static str {
        match self {
            Self::SaddleNode => "SN",
            Self::PeriodDoubling => "PD",
            Self::Grazing => "GZ",
        }
    }

    /// The kind of a condition that a curve or an event can have.
    pub fn of(condition: Condition) -> Option<Self> {
        match condition {
            Condition::Multiplier(multiplier) if multiplier > 0.0 => Some(Self::SaddleNode),
            Condition::Multiplier(_) => Some(Self::PeriodDoubling),
            Condition::InteriorGrazing => Some(Self::Grazing),
            _ => None,
        }
    }
}

/// A bifurcation curve of the diagram.
#[derive(Clone, Debug)]
pub struct DiagramCurve {
    /// What happens along it.
    pub kind: Kind,
    /// Number of loops p.
    pub loops: u32,
    /// The integer n of the resonance from which the curve, or the point at which it starts, was reached.
    pub n: u32,
    /// The curve.
    pub curve: Curve,
}

impl DiagramCurve {
    /// Whether it is another one, perhaps followed from its other end.
    pub fn is_same(&self, other: &Self) -> bool {
        let ([first, last], [start, end]) = (self.ends(), other.ends());
        let same = |a, b| same_point(&first, a) && same_point(&last, b);
        self.kind == other.kind && self.loops == other.loops && (same(&start, &end) || same(&end, &start))
    }

    /// First and last point.
    fn ends(&self) -> [Unknowns; 2] {
        let points = &self.curve.points;
        [points[0].solution.unknowns, points[points.len() - 1].solution.unknowns]
    }
}

/// A codimension-two point other than a resonance.
#[derive(Clone, Debug)]
pub struct Corner {
    /// The two bifurcations that meet there: SN-GZ, PD-GZ or GZ-GZ; `cusp` where an SN curve turns back.
    pub kind: &'static str,
    /// Number of loops p.
    pub loops: u32,
    /// The integer n of the resonance from which it was reached.
    pub n: u32,
    /// The event on the curve on which it was reached: its end, but for cusps.
    pub event: Event,
}

impl Corner {
    /// (y, z, μ, η).
    pub fn unknowns(&self) -> Unknowns {
        self.event.solution.unknowns
    }
}

/// A resonance one of whose curves, or all of them, could not be followed.
#[derive(Clone, Debug)]
pub struct NotUnfolded {
    /// Number of loops p.
    pub loops: u32,
    /// The integer n.
    pub n: u32,
    /// What happened.
    pub reason: ResonanceError,
}

/// What came of following the curves from a resonance.
#[derive(Clone, Debug)]
pub struct Followed {
    /// The place of the resonance in the diagram's list.
    pub resonance: usize,
    /// Its curves.
    pub curves: Vec<DiagramCurve>,
    /// Why others are not there.
    pub missing: Vec<ResonanceError>,
}

/// Everything in the diagram.
#[derive(Clone, Debug)]
pub struct Diagram<O> {
    /// What was asked for.
    pub scope: Scope,
    /// The pieces of the curve of grazing bifurcations of the non-impacting solution.
    pub grazing: Vec<GrazingCurve<O>>,
    /// All resonances on it, by p and along the curve.
    pub resonances: Vec<Resonance<O>>,
    /// SN, PD and GZ curves from the resonances at which a theorem holds.
    pub curves: Vec<DiagramCurve>,
    /// Codimension-two points other than resonances.
    pub corners: Vec<Corner>,
    /// Resonances that were seen and could not be located.
    pub unlocated: Vec<Unlocated>,
    /// Resonances whose curves could not be followed.
    pub not_unfolded: Vec<NotUnfolded>,
}

/// The kind of a point at which a saddle-node curve turns back.
const CUSP: &str = "cusp";

/// A curve of this many points has lost its way.
const STEP_LIMIT: usize = 20_000;

/// The route through a window to the first event.
pub fn route(window: Window, control: StepControl) -> Route {
    Route { window, control, step_limit: STEP_LIMIT, stop_at_events: true, through_grazing: false }
}

/// Values of η, as shares of its range, at which grazing of the free motion is looked for; those in the middle first.
const SURVEYED: [f64; 9] = [0.5, 0.25, 0.75, 0.0, 1.0, 0.125, 0.375, 0.625, 0.875];

impl<O: ImpactOscillator> Diagram<O> {
    /// Finds the grazing curves of an oscillator and all resonances on them, and follows the curves that leave these.
    ///
    /// The oscillator's own parameters do not matter. Grazing is looked for at nine values of η; a piece of the grazing curve that none of
    /// them meets is not seen. Resonances are unfolded in parallel; the result does not depend on the number of threads.
    ///
    /// # Errors
    /// There is no grazing in the ranges, with what was seen instead.
    pub fn compute(oscillator: &O, scope: &Scope, progress: &dyn Progress) -> Result<Self, UnfoldError> {
        let located = Self::located(oscillator, scope, progress)?;
        let followed = located.follow(progress);
        Ok(located.with(followed))
    }

    /// The first half of [`compute`](Self::compute): grazing curves and resonances, no bifurcation curve yet.
    ///
    /// # Errors
    /// There is no grazing in the ranges, with what was seen instead.
    pub fn located(oscillator: &O, scope: &Scope, progress: &dyn Progress) -> Result<Self, UnfoldError> {
        let grazing = grazing_curves(oscillator, scope, progress)?;
        let mut diagram = Self {
            scope: scope.clone(),
            grazing,
            resonances: Vec::new(),
            curves: Vec::new(),
            corners: Vec::new(),
            unlocated: Vec::new(),
            not_unfolded: Vec::new(),
        };
        for curve in &diagram.grazing {
            let (mut found, mut lost) = resonances::on_curve(curve, scope);
            diagram.resonances.append(&mut found);
            diagram.unlocated.append(&mut lost);
        }
        let order = |loops| scope.loops.iter().position(|asked| *asked == loops);
        diagram.resonances.sort_by_key(|resonance| order(resonance.loops));
        Ok(diagram)
    }

    /// The diagram with what came of following the curves from its resonances, in the order of their list.
    pub fn with(mut self, followed: Vec<Followed>) -> Self {
        for Followed { resonance, curves, missing } in followed {
            let (loops, n) = (self.resonances[resonance].loops, self.resonances[resonance].n);
            let failed = |reason| NotUnfolded { loops, n, reason };
            self.not_unfolded.extend(missing.into_iter().map(failed));
            for curve in curves {
                self.add(curve);
            }
        }
        self.grow();
        self
    }

    /// Follows what is missing of the two curves that meet at each codimension-two point, and so on from where that ends.
    fn grow(&mut self) {
        let route = route(self.scope.window, StepControl::DRAWING);
        let mut next = 0;
        while let Some(Corner { kind: meeting, loops, n, event }) = self.corners.get(next).cloned() {
            next += 1;
            let Some(kind) = Kind::of(event.condition).filter(|_| meeting != CUSP) else { continue };
            let corner = event.solution.unknowns;
            let there = self.curves.iter().filter(|curve| {
                curve.kind == kind
                    && curve.loops == loops
                    && curve.ends().iter().any(|end| same_point(end, &corner))
            });
            let known = there.count() >= if meeting == "GZ-GZ" { 2 } else { 1 };
            let point = self.unfolding().find(|(resonance, _)| resonance.loops == loops && resonance.n == n);
            // A curve that bounds no region of stable solutions there is not part of the diagram.
            if let Some((_, point)) = point
                && !known
                && let Ok(curve) = point.branch_off(&event, &route)
            {
                self.add(DiagramCurve { kind, loops, n, curve });
            }
        }
    }

    /// The resonances at which a theorem holds, with their places in the list of all.
    pub fn unfolding(&self) -> impl Iterator<Item = (&Resonance<O>, &ResonantGrazingPoint<O>)> {
        self.resonances.iter().filter_map(|resonance| Some((resonance, resonance.theorem.as_ref().ok()?)))
    }

    /// The grazing phase z_graz at a value of η; none where no grazing curve is.
    pub fn grazing_phase(&self, secondary: f64) -> Option<f64> {
        self.grazing.iter().find_map(|curve| curve.at(secondary)).map(|orbit| orbit.phase())
    }

    /// The curves from every resonance at which a theorem holds, each resonance by itself, in the order of the list.
    pub fn follow(&self, progress: &dyn Progress) -> Vec<Followed> {
        let what = "bifurcation curves";
        let route = route(self.scope.window, StepControl::DRAWING);
        let points: Vec<_> =
            self.resonances.iter().enumerate().filter(|(_, found)| found.theorem.is_ok()).collect();
        progress.begin(what, points.len() as u64);
        let followed = points
            .into_par_iter()
            .filter_map(|(index, resonance)| {
                let point = resonance.theorem.as_ref().ok()?;
                let followed = match point.unfold(&route) {
                    Ok(unfolded) => listed(index, resonance, unfolded),
                    Err(reason) => Followed { resonance: index, curves: Vec::new(), missing: vec![reason] },
                };
                progress.unfolded(index, &followed.curves);
                progress.step(what);
                Some(followed)
            })
            .collect();
        progress.end(what);
        followed
    }

    /// Adds a curve unless it is one of those that are there, followed from its other end.
    fn add(&mut self, new: DiagramCurve) {
        if self.curves.iter().any(|old| old.is_same(&new)) {
            return;
        }
        if let CurveEnd::Event(event) = &new.curve.end {
            let pair = [Some(new.kind), Kind::of(event.condition)];
            let kind = match pair {
                [Some(Kind::SaddleNode), Some(Kind::Grazing)]
                | [Some(Kind::Grazing), Some(Kind::SaddleNode)] => "SN-GZ",
                [Some(Kind::PeriodDoubling), Some(Kind::Grazing)]
                | [Some(Kind::Grazing), Some(Kind::PeriodDoubling)] => "PD-GZ",
                _ => "GZ-GZ",
            };
            let unknowns = event.solution.unknowns;
            if !self.corners.iter().any(|corner| same_point(&corner.unknowns(), &unknowns)) {
                self.corners.push(Corner { kind, loops: new.loops, n: new.n, event: event.clone() });
            }
        }
        for event in self.cusps(&new) {
            self.corners.push(Corner { kind: CUSP, loops: new.loops, n: new.n, event });
        }
        self.curves.push(new);
    }

    /// The cusps of a saddle-node curve; other curves have none.
    fn cusps(&self, new: &DiagramCurve) -> Vec<Event> {
        let own = self.unfolding().find(|(resonance, _)| resonance.loops == new.loops);
        match (new.kind, own) {
            (Kind::SaddleNode, Some((_, point))) => cusps(point.equations(), &new.curve),
            _ => Vec::new(),
        }
    }
}

/// The curves of a resonance in the order in which they are listed.
fn listed<O>(index: usize, resonance: &Resonance<O>, unfolded: UnfoldedResonance) -> Followed {
    let of_kind = |kind, curve| DiagramCurve { kind, loops: resonance.loops, n: resonance.n, curve };
    let own = [
        of_kind(Kind::SaddleNode, unfolded.saddle_node),
        of_kind(Kind::PeriodDoubling, unfolded.period_doubling),
    ];
    let grazing = unfolded.grazing.into_iter().map(|curve| of_kind(Kind::Grazing, curve));
    let curves = own.into_iter().chain(grazing).collect();
    Followed { resonance: index, curves, missing: unfolded.missing }
}

/// The pieces of the grazing curve in the ranges.
fn grazing_curves<O: ImpactOscillator>(
    oscillator: &O,
    scope: &Scope,
    progress: &dyn Progress,
) -> Result<Vec<GrazingCurve<O>>, UnfoldError> {
    let what = "grazing of free motion";
    progress.begin(what, SURVEYED.len() as u64);
    let surveys: Vec<Survey<O>> = SURVEYED
        .par_iter()
        .map(|share| {
            let secondary = scope.parameters([0.0, *share])[1];
            let survey = free::survey(oscillator, scope, secondary);
            progress.step(what);
            survey
        })
        .collect();
    progress.end(what);
    let mut curves: Vec<GrazingCurve<O>> = Vec::new();
    for orbit in surveys.iter().flat_map(|survey| &survey.grazing) {
        if !curves.iter().any(|curve| curve.passes(orbit, scope))
            && let Ok(curve) = GrazingCurve::through(orbit, scope)
        {
            curves.push(curve);
        }
    }
    if curves.is_empty() { Err(explanation(&surveys)) } else { Ok(curves) }
}

/// Why no survey has seen grazing.
fn explanation<O>(surveys: &[Survey<O>]) -> UnfoldError {
    if let Some(at) = surveys.iter().flat_map(|survey| &survey.pushed).next() {
        return UnfoldError::Pushed { at: *at };
    }
    let extremes =
        surveys.iter().filter_map(|survey| survey.extremes).reduce(|[low, high], [lower, higher]| {
            [
                if lower.position < low.position { lower } else { low },
                if higher.position > high.position { higher } else { high },
            ]
        });
    let ran_away = surveys.iter().find_map(|survey| survey.ran_away);
    match (extremes, ran_away) {
        (Some([lowest, highest]), _) => UnfoldError::NoGrazing { lowest, highest },
        (None, Some(at)) => UnfoldError::RunsAway { at },
        (None, None) => UnfoldError::NoOrbit,
    }
}
