//! The curves and points of the two-parameter diagram, which Figures 7 and 8 and the table share.

use grazing_continuation::arclength::StepControl;
use grazing_continuation::curve::{Curve, CurveEnd, Route, Window};
use grazing_continuation::locate::Condition;
use grazing_continuation::mps::Unknowns;
use grazing_continuation::resonance::{ResonantGrazingPoint, same_point};
use grazing_model::LinearOscillator;
use grazing_theorems::Resonance;
use rayon::prelude::*;

use crate::StudyError;
use crate::parameters::{Parameters, Range, Rectangle};
use crate::progress::Progress;

/// Kinds of bifurcation curves, by the names the figures use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    SaddleNode,
    PeriodDoubling,
    Grazing,
}

impl Kind {
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::SaddleNode => "SN",
            Self::PeriodDoubling => "PD",
            Self::Grazing => "GZ",
        }
    }

    /// The kind of a condition that a curve or an event can have.
    pub(crate) fn of(condition: Condition) -> Option<Self> {
        match condition {
            Condition::Multiplier(multiplier) if multiplier > 0.0 => Some(Self::SaddleNode),
            Condition::Multiplier(_) => Some(Self::PeriodDoubling),
            Condition::InteriorGrazing => Some(Self::Grazing),
            _ => None,
        }
    }
}

/// A resonance in the closed form of section 3 and as located numerically.
#[derive(Clone, Debug)]
pub(crate) struct DiagramResonance {
    pub(crate) closed_form: Resonance,
    pub(crate) located: ResonantGrazingPoint<LinearOscillator>,
}

/// A bifurcation curve of the diagram.
#[derive(Clone, Debug)]
pub(crate) struct DiagramCurve {
    pub(crate) kind: Kind,
    pub(crate) loops: u32,
    /// The integer n of the resonance from which the curve, or the point at which it starts, was reached.
    pub(crate) n: u32,
    pub(crate) curve: Curve,
}

impl DiagramCurve {
    /// First and last point.
    pub(crate) fn ends(&self) -> [Unknowns; 2] {
        let points = &self.curve.points;
        [points[0].solution.unknowns, points[points.len() - 1].solution.unknowns]
    }
}

/// A codimension-two point other than a resonance.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Corner {
    pub(crate) kind: &'static str,
    pub(crate) loops: u32,
    pub(crate) n: u32,
    pub(crate) unknowns: Unknowns,
}

/// Everything in the diagram.
#[derive(Clone, Debug)]
pub(crate) struct Diagram {
    pub(crate) resonances: Vec<DiagramResonance>,
    pub(crate) curves: Vec<DiagramCurve>,
    pub(crate) corners: Vec<Corner>,
}

/// A curve of this many points has lost its way.
const STEP_LIMIT: usize = 20_000;

/// The route through a rectangle of amplitudes and frequencies, to the first event.
pub(crate) fn route(window: Rectangle, control: StepControl) -> Route {
    Route {
        window: Window { primary: ends(window.amplitude()), secondary: ends(window.frequency()) },
        control,
        step_limit: STEP_LIMIT,
        stop_at_events: true,
        through_grazing: false,
    }
}

/// The route along a branch of fixed frequency through a range of amplitudes, past all events.
pub(crate) fn branch_route(amplitude: Range) -> Route {
    Route {
        window: Window { primary: ends(amplitude), secondary: [0.0, f64::INFINITY] },
        control: StepControl::DRAWING,
        step_limit: STEP_LIMIT,
        stop_at_events: false,
        through_grazing: false,
    }
}

fn ends(range: Range) -> [f64; 2] {
    [range.lower(), range.upper()]
}

impl Diagram {
    /// Locates all resonances in the window of Figure 7 and follows the curves that bound the regions of stable MPSs.
    pub(crate) fn compute(parameters: &Parameters, progress: &dyn Progress) -> Result<Self, StudyError> {
        let window = parameters.fig07().window();
        let theory = grazing_theorems::LinearOscillator::new(parameters.zeta(), parameters.epsilon())?;
        let frequencies = window.frequency();
        let mut closed_forms =
            theory.resonances(parameters.fig07().loops(), frequencies.lower(), frequencies.upper())?;
        closed_forms.retain(|resonance| window.amplitude().contains(resonance.grazing().amplitude()));
        // By p, and by increasing frequency for each.
        closed_forms.sort_by_key(|resonance| resonance.loops());

        let what = "bifurcation curves";
        progress.begin(what, closed_forms.len() as u64);
        let route = route(window, StepControl::DRAWING);
        // Each resonance by itself; the order of the results is that of the list, whatever the threads do.
        let unfolded: Vec<_> = closed_forms
            .into_par_iter()
            .map(|closed_form| {
                let located = locate(parameters, &closed_form)?;
                let unfolded =
                    located.unfold(&route).map_err(|source| StudyError::resonance(&closed_form, source))?;
                progress.step(what);
                Ok((DiagramResonance { closed_form, located }, unfolded))
            })
            .collect::<Result<_, StudyError>>()?;
        progress.end(what);

        let mut diagram = Self { resonances: Vec::new(), curves: Vec::new(), corners: Vec::new() };
        for (resonance, unfolded) in unfolded {
            let (loops, n) = (resonance.closed_form.loops(), resonance.closed_form.index());
            diagram.resonances.push(resonance);
            let of_kind = |kind, curve| DiagramCurve { kind, loops, n, curve };
            diagram.add(of_kind(Kind::SaddleNode, unfolded.saddle_node));
            diagram.add(of_kind(Kind::PeriodDoubling, unfolded.period_doubling));
            for curve in unfolded.grazing {
                diagram.add(of_kind(Kind::Grazing, curve));
            }
        }
        Ok(diagram)
    }

    /// Adds a curve unless it is one of those that are there, followed from its other end.
    fn add(&mut self, new: DiagramCurve) {
        let [start, end] = new.ends();
        let known = self.curves.iter().any(|old| {
            let [first, last] = old.ends();
            let same = |a, b| same_point(&first, a) && same_point(&last, b);
            old.kind == new.kind && old.loops == new.loops && (same(&start, &end) || same(&end, &start))
        });
        if known {
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
            if !self.corners.iter().any(|corner| same_point(&corner.unknowns, &unknowns)) {
                self.corners.push(Corner { kind, loops: new.loops, n: new.n, unknowns });
            }
        }
        self.curves.push(new);
    }
}

/// Locates a resonance numerically, starting at its closed form.
pub(crate) fn locate(
    parameters: &Parameters,
    closed_form: &Resonance,
) -> Result<ResonantGrazingPoint<LinearOscillator>, StudyError> {
    let grazing = closed_form.grazing();
    let oscillator = LinearOscillator::new(
        parameters.zeta(),
        parameters.epsilon(),
        grazing.amplitude(),
        grazing.forcing_frequency(),
    )?;
    ResonantGrazingPoint::find(&oscillator, closed_form.loops(), grazing.phase())
        .map_err(|source| StudyError::resonance(closed_form, source))
}
