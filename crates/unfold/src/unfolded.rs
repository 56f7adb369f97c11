//! All results on the resonant grazing bifurcations of any oscillator, as rows of tables.

mod finished;
mod resonance;
mod tables;

use grazing_continuation::fit::CoefficientError;
use grazing_input::{Description, OwnCurve};
use grazing_model::AnyOscillator;
use grazing_model::smooth::{Purpose, Stop};
use grazing_results::Dimensioned;
use grazing_results::branches::OneParameter;
use grazing_results::grazing::{AlongGrazing, GrazingLoopRow};
use grazing_results::plane::{
    DiagramLine, Magnifications, MagnifiedPanel, PlaneDiagram, SequenceDiagram, StraightenedCurves,
};
use grazing_results::resonance::AtResonances;

use crate::described::{Axes, Prepared};
use crate::one_parameter::requested;
use crate::progress::Progress;
use crate::sequences::{REGIONS as SEQUENCES, Sequence, Sequences, of_diagram};
use crate::unfinished::Unfinished;
use crate::{Diagram, Scope, UnfoldError, magnification, parallel, plane, straightened};
pub use finished::{Draft, Keep};
use resonance::curves_from;
pub use resonance::{AtResonance, CurveFinding, Curves, curves, straightened_at};
pub(crate) use tables::measured;

/// The analysis of an oscillator: its diagram and, at every resonance where a theorem holds,
/// coefficients, simulation and a magnification.
#[derive(Clone, Debug)]
pub struct Unfolded {
    /// The names of the parameters, and the oscillator's own units.
    pub axes: Axes,
    /// Grazing curves, resonances, bifurcation curves, codimension-two points and regions, all
    /// dimensionless.
    pub diagram: Diagram,
    /// All resonances, in the order in which they were found; in the oscillator's own units.
    pub resonances: Vec<AtResonance>,
    /// The one-parameter diagrams that were requested, as far as they were finished, in the oscillator's
    /// own units.
    pub diagrams: Vec<OneParameter>,
    /// What is seen from the other of two walls.
    pub other: Option<Box<Unfolded>>,
    /// Solutions with several impacts, if the file asks for more than one generation, or there are two walls;
    /// dimensionless.
    pub sequences: Sequences,
    /// Quantities along the grazing curves that depend on p, one p after the other, in the oscillator's
    /// own units.
    along: Vec<GrazingLoopRow>,
}

impl Unfolded {
    /// Analyses an oscillator from a text file; `stop` cancels the analysis, and `keep` receives what
    /// is known so far, now and then.
    ///
    /// # Errors
    /// There is no grazing in the ranges.
    pub fn described(
        description: &Description,
        progress: &dyn Progress,
        stop: &Stop,
        keep: Keep<'_>,
    ) -> Result<Self, UnfoldError> {
        Self::prepared(description, Prepared::of(description, stop), progress, stop, keep)
    }

    /// Analyses a prepared oscillator, with the one-parameter diagrams that its file requests.
    ///
    /// # Errors
    /// There is no grazing in the ranges.
    pub fn prepared(
        description: &Description,
        of: Prepared,
        progress: &dyn Progress,
        stop: &Stop,
        keep: Keep<'_>,
    ) -> Result<Self, UnfoldError> {
        let (axes, units) = (&of.axes, of.axes.units);
        let nothing: Keep<'_> = &|_| ();
        let mut seen = of.from_each_wall().map(|view| {
            let keep: Keep<'_> = if view.wall < 2 { keep } else { nothing };
            Ok(Self::of_located(view.located(progress)?, axes.clone(), progress, keep))
        });
        let first = seen.next().ok_or(UnfoldError::NoOrbit).flatten();
        let other = seen.next().and_then(Result::ok).filter(|other| other.diagram.nothing().is_none());
        let several = |diagram: &mut Diagram| {
            let found = of_diagram(diagram, description.generations(), progress);
            if progress.stopped() && (description.generations() > 1 || diagram.wall > 0) {
                diagram.unfinished.push(Unfinished::stage(SEQUENCES));
            }
            found
        };
        let first = first.and_then(|mut first| {
            first.sequences = several(&mut first.diagram);
            first.found()
        });
        let unfolded = match (first, other) {
            (Ok(unfolded), other) => Ok(Self { other: other.map(Box::new), ..unfolded }),
            // Only the other wall is met in the ranges.
            (Err(_), Some(other)) => Ok(other),
            (Err(error), None) => Err(error),
        };
        let mut unfolded = unfolded.map_err(|error| error.with_dimensions(&units));
        if let Ok(Self { diagram, diagrams, .. }) = &mut unfolded {
            // Diagrams are seen from the first wall.
            let curves = if diagram.wall < 2 { diagram.curves.as_slice() } else { &[] };
            let (found, unfinished) = requested::diagrams(description, curves, stop, progress);
            *diagrams = found;
            diagram.unfinished.extend(unfinished);
        }
        // The finished results can still be written.
        stop.withdraw();
        unfolded
    }
}

impl Unfolded {
    /// The results, if there are any: grazing, or curves or regions of solutions that hit a wall.
    ///
    /// # Errors
    /// The reason why there is no grazing.
    fn found(self) -> Result<Self, UnfoldError> {
        let decided = |found: &Sequence| found.regions.iter().any(|region| region.doubt.is_none());
        let several = self.sequences.solutions.iter().any(|found| !found.curves.is_empty() || decided(found));
        match self.diagram.nothing() {
            Some(reason) if !several => Err(reason.clone()),
            _ => Ok(self),
        }
    }

    /// Analyses any oscillator, given with its scope and the requested curves in the units of `axes`; the
    /// oscillator's own parameter values are not used.
    ///
    /// # Errors
    /// There is no grazing in the ranges.
    pub fn compute(
        oscillator: &AnyOscillator,
        (scope, requested): (&Scope, Vec<OwnCurve>),
        axes: Axes,
        progress: &dyn Progress,
        keep: Keep<'_>,
    ) -> Result<Self, UnfoldError> {
        let located = Diagram::located(oscillator, scope, progress)?.requesting(requested);
        Self::of_located(located, axes, progress, keep).found()
    }

    /// The results for a diagram of which grazing curves and resonances are located, in the units of `axes`.
    fn of_located(located: Diagram, axes: Axes, progress: &dyn Progress, keep: Keep<'_>) -> Self {
        let mut diagram = finished::complete(&axes, located, progress, keep);
        let units = axes.units;
        let what = "coefficients and magnifications";
        progress.begin(what, diagram.unfolding().count() as u64);
        // Each resonance is computed by itself; the results are in the order of the list, independent of
        // the threads.
        let resonances = parallel::map(&diagram.resonances, |resonance| {
            let found = AtResonance::new(resonance, diagram.wall);
            let Ok(point) = &resonance.theorem else { return (found.with_dimensions(&units), None) };
            let measured = || curves_from(&diagram, resonance, point, &units);
            let mut curves = Purpose::Coefficients.during(measured);
            let stopped = progress.stopped();
            if stopped {
                // After cancellation nothing more can be computed, so the whole result is marked as
                // missing, including parts that may have been finished.
                curves = measured();
                for known in [&mut curves.findings.saddle_node, &mut curves.findings.period_doubling] {
                    known.coefficient.fit = Err(CoefficientError::NotFinished);
                }
            }
            let found = AtResonance { curves: Some(curves), ..found };
            progress.step(what);
            (found.with_dimensions(&units), stopped.then(|| Unfinished::at(what, resonance)))
        });
        progress.end(what);
        let (resonances, unfinished): (Vec<_>, Vec<_>) = resonances.into_iter().unzip();
        diagram.unfinished.extend(unfinished.into_iter().flatten());
        let along = tables::along(&diagram, progress).with_dimensions(&units);
        if progress.stopped() {
            diagram.unfinished.push(Unfinished::stage(tables::ALONG));
        }
        let (diagrams, sequences, other) = Default::default();
        Self { axes, diagram, resonances, diagrams, other, sequences, along }
    }

    /// The results as each wall sees them, the first and then the other, if there are two.
    pub fn from_each_wall(&self) -> impl Iterator<Item = &Self> {
        [Some(self), self.other.as_deref()].into_iter().flatten()
    }

    /// The diagrams as the first wall and the other of two see them, and the solutions with several impacts.
    pub fn known(&self) -> (&Diagram, Option<&Diagram>, &[Sequence]) {
        (&self.diagram, self.other.as_ref().map(|other| &other.diagram), &self.sequences.solutions)
    }

    /// The resonances at which a theorem holds, with the results for their curves, at the first wall and at the
    /// other, if there are two. Where both are alike each resonance is one at either, and shown at the first.
    fn unfolding(&self) -> impl Iterator<Item = (&AtResonance, &Curves)> {
        let others = self.other.iter().flat_map(|other| other.with_curves());
        let is_new =
            move |(at, _): &(&AtResonance, &Curves)| !self.with_curves().any(|(known, _)| at.is_like(known));
        self.with_curves().chain(others.filter(is_new))
    }

    /// The resonances at which a theorem holds, as one wall sees them, with the results for their curves.
    fn with_curves(&self) -> impl Iterator<Item = (&AtResonance, &Curves)> {
        self.resonances.iter().filter_map(|at| Some((at, at.curves.as_ref()?)))
    }

    /// The wall at which a resonance is named: none if it is the same at the other one, or there is only one.
    fn named_wall(&self, at: &AtResonance) -> u32 {
        let mut others = self.from_each_wall().flat_map(|seen| &seen.resonances);
        if others.any(|other| other.wall != at.wall && other.is_like(at)) { 0 } else { at.wall }
    }

    /// The two-parameter diagram, with a panel for each resonance that has curves, numbered as in the
    /// table of magnifications, and lines for the one-parameter diagrams.
    pub fn plane_diagram(&self) -> PlaneDiagram {
        let is_range = |[low, high]: [f64; 2]| low.is_finite() && high.is_finite() && low < high;
        let panels = (1..).zip(self.unfolding()).filter_map(|(panel, (at, curves))| {
            let Curves { window, magnified, .. } = curves;
            let shown = !magnified.is_empty() && is_range(window.primary) && is_range(window.secondary);
            shown.then(|| panel_of(panel, (at, self.named_wall(at)), curves))
        });
        let sections = self.diagrams.iter().map(|diagram| DiagramLine {
            ends: diagram.frame.x.map(|across| diagram.exchanged([across, diagram.at]).into()),
            name: format!("diagram {}", diagram.diagram),
            thin: true,
        });
        let (units, other) = (&self.axes.units, self.other.as_ref().map(|other| &other.diagram));
        PlaneDiagram {
            magnified: panels.collect(),
            sections: sections.collect(),
            several: self.sequences().regions,
            at_both_walls: self.sequences.at_both_walls().with_dimensions(units),
            ..plane::rows(&self.diagram, other).with_dimensions(units)
        }
    }

    /// The rows of solutions with several impacts.
    pub fn sequences(&self) -> SequenceDiagram {
        self.sequences.rows(self.diagram.wall).with_dimensions(&self.axes.units)
    }

    /// The magnifications for the panels of the diagram.
    pub fn magnifications(&self, diagram: &PlaneDiagram) -> Magnifications {
        Magnifications {
            curves: magnification::numbered(self.unfolding().map(|(_, curves)| &curves.magnified)),
            points: diagram.points.clone(),
            regions: diagram.regions.clone(),
            panels: diagram.magnified.clone(),
        }
    }

    /// The curves in straightened coordinates; panels have the numbers of the magnifications.
    pub fn straightened(&self) -> StraightenedCurves {
        straightened::panels((1..).zip(self.unfolding()).map(|(panel, (at, curves))| {
            let panel = panel_of(panel, (at, self.named_wall(at)), curves);
            (panel, curves.straightened.as_slice())
        }))
    }

    /// The rows of quantities along the grazing curve.
    pub fn along_grazing(&self) -> AlongGrazing {
        AlongGrazing {
            grazing: self.from_each_wall().flat_map(tables::grazing).collect(),
            grazing_loops: self.from_each_wall().flat_map(|seen| seen.along.clone()).collect(),
        }
    }

    /// The rows of results at resonances.
    pub fn at_resonances(&self) -> AtResonances {
        AtResonances {
            coefficients: self.from_each_wall().flat_map(tables::coefficients).collect(),
            hypotheses: self.from_each_wall().flat_map(tables::hypotheses).collect(),
        }
    }
}

/// The panel that magnifies a resonance, at one of two walls that are unlike.
fn panel_of(panel: u32, (at, wall): (&AtResonance, u32), curves: &Curves) -> MagnifiedPanel {
    let coefficients = curves.findings.map(|known| known.coefficient.theorem.value);
    let (loops, n) = (at.loops, Some(at.n));
    MagnifiedPanel { panel, frame: curves.window.into(), loops, wall, n, coefficients }
}
