//! A survey that checks whether the curves of one p are complete: slices of the plane in which
//! every bifurcation must lie on a known curve.
//!
//! A bifurcation that does not starts a new curve, until none is left unexplained. Solutions
//! without impacts, p = 0, are surveyed like all others; their grazing is the grazing curve.

mod evidence;
mod explain;
mod lines;
#[cfg(test)]
mod tests;

use grazing_continuation::arclength::StepControl;
use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::{Curve, CurvePoint, Event, Pace, Route};
use grazing_continuation::mps::{EventTimes, LoopEquations, Unknowns, parameters, unknown};
use grazing_input::OwnCurve;
use grazing_model::ImpactOscillator;
use grazing_model::smooth::Purpose;
use grazing_theorems::from_map::GrazingOrbit;

use self::explain::{bounding, explained, start};
use crate::Scope;
use crate::close_curves::Vertices;
use crate::curves::{DiagramCurve, Net, route};
use crate::entering_curves;
use crate::grazing::GrazingCurve;
use crate::own_curves;
use crate::parallel;
use crate::progress::Progress;
use crate::slices::{FREE_STEPS, Slice, Slicer, precise, spread, steps};

/// The slices through the surface of solutions with p loops, in the order of η.
pub(crate) struct Survey<'a> {
    net: &'a mut Net,
    pub(crate) slicer: Slicer,
    scope: &'a Scope,
    route: Route<'static>,
    /// The grazing curves at which branches begin; without impacts those found on the way are
    /// added.
    pub(crate) grazing: Vec<GrazingCurve>,
    /// The number of forcing periods after which motion without impacts recurs.
    periods: u32,
    /// The curves of solutions of half the period, at whose period doublings branches begin.
    halved: &'a [DiagramCurve],
    slices: Vec<Slice>,
    /// Branches at constant μ, through the range of η.
    columns: Vec<Curve>,
    /// Whether columns have been followed.
    crossed: bool,
    /// Whether solutions may have mirror images, whose curves lie on theirs in the plane.
    images: bool,
    /// MPSs on the first slices to which no known curve may lead.
    found: Vec<Unknowns>,
    /// Bifurcations on curves that enter the window from resonances outside, until they have been looked at.
    entering: Vec<Event>,
    /// The vertices of lines that have been located.
    vertices: Vertices,
}

/// Number of parts into which columns of constant μ divide its range; the first and the last are
/// the window's edges.
const COLUMNS: u32 = 8;
/// Number of parts without impacts: in the steps that the narrowest resonance requires columns take
/// longer. They find structures between slices, such as these resonances and folds that no slice
/// comes near.
const FREE_COLUMNS: u32 = 2;
/// Tolerance for an orbit on the edge, which lies inside up to rounding.
const ON_THE_EDGE: f64 = 1e-9;

impl<'a> Survey<'a> {
    pub(crate) fn new(
        net: &'a mut Net,
        scope: &'a Scope,
        grazing: &[GrazingCurve],
        found: Vec<Unknowns>,
    ) -> Self {
        let has_impacts = net.equations.has_impacts();
        let images = !has_impacts || found.iter().any(|like| net.equations.have_images(like));
        let control = match (has_impacts, images) {
            (true, false) => steps(scope.window),
            (true, true) => precise(steps(scope.window)),
            (false, _) => FREE_STEPS,
        };
        // Without impacts curves continue beyond the wall.
        let route = route(scope.window, StepControl::DRAWING);
        let pace: Option<&'static Pace<'static>> = if has_impacts { None } else { Some(&in_sight) };
        let route = Route { stop_at_events: has_impacts, pace, ..route };
        let slicer = Slicer::new(net.equations.clone(), scope.window, control);
        let loops = net.loops();
        let grazing = grazing.iter().filter(|curve| loops.is_multiple_of(curve.periods)).cloned().collect();
        Self {
            net,
            slicer,
            scope,
            route,
            grazing,
            periods: 1,
            halved: &[],
            slices: Vec::new(),
            columns: Vec::new(),
            crossed: false,
            images,
            found,
            entering: Vec::new(),
            vertices: Vertices::default(),
        }
    }

    /// A survey of motion without impacts over `periods` forcing periods, twice as many as that of
    /// `halved`.
    pub(crate) fn of_doubled(net: &'a mut Net, scope: &'a Scope, periods: u32, halved: &'a Net) -> Self {
        let mut survey = Self::new(net, scope, &[], Vec::new());
        survey.periods = periods;
        survey.slicer.halved = Some(halved.equations.clone());
        survey.halved = &halved.curves;
        survey
    }

    /// A survey of solutions with several impacts, some of which are known, and which may branch off these of
    /// half their time.
    pub(crate) fn of_several(
        net: &'a mut Net,
        scope: &'a Scope,
        found: Vec<Unknowns>,
        halved: Option<(LoopEquations, &'a [DiagramCurve])>,
    ) -> Self {
        let mut survey = Self::new(net, scope, &[], found);
        if let Some((equations, curves)) = halved {
            survey.slicer.halved = Some(equations);
            survey.halved = curves;
        }
        survey
    }

    /// The number of loops p; 0 without impacts.
    pub(crate) fn loops(&self) -> u32 {
        self.net.loops()
    }

    /// Adds a slice whose branches are known.
    pub(crate) fn add_slice(&mut self, slice: Slice) {
        self.slices.push(slice);
    }

    /// Adds slices at more values of η, with the branches that begin on them.
    pub(crate) fn look_at(&mut self, levels: &[f64]) {
        let begun = |level: &f64| {
            let places = self.grazing.iter().flat_map(|curve| {
                // Impacts count phases in turns of the forcing.
                let turns = if self.loops() > 0 { f64::from(curve.periods) } else { 1.0 };
                curve.all_at(*level).map(move |place| [turns * place.phase, place.parameters[0]])
            });
            let mut slice = self.slicer.beginning_at_grazing(*level, places);
            self.slicer.beginning_at_doublings(&mut slice, self.halved);
            slice
        };
        let begun: Vec<Slice> = parallel::map(levels, begun);
        self.slices.extend(begun);
    }

    /// Carries branches to all slices and starts the curves that are missing then; returns whether there may
    /// be more of either.
    pub(crate) fn goes_on(&mut self, progress: &dyn Progress) -> bool {
        spread(&mut self.slices, progress, |from, to| self.slicer.carry(from, to));
        let new = self.slices.iter_mut().flat_map(Slice::take_new);
        let events: Vec<Event> =
            new.flat_map(|branch| bounding(self.net, branch, self.scope.window, self.periods > 1)).collect();
        self.explain(&events, progress);
        self.follow_columns(progress);
        let (curves, columns, slicer) = (&self.net.curves, &self.columns, &self.slicer);
        let has_impacts = self.net.equations.has_impacts();
        let through = |slice: &mut Slice| {
            let by_curves = slicer.through_curves(slice, curves);
            // Without impacts a column is met by the slices on which it was started.
            has_impacts && slicer.through_columns(slice, columns) || by_curves
        };
        let fresh = parallel::map(&mut self.slices, through);
        if progress.stopped() {
            return false;
        }
        if !fresh.contains(&true) {
            if self.found.is_empty() {
                return false;
            }
            // Only now that all solutions with a known lead are found.
            let found = core::mem::take(&mut self.found);
            self.follow_edges(&found, progress);
            // Branches through these solutions are to be followed across as well.
            self.crossed = false;
            parallel::map(&mut self.slices, |slice| {
                let secondary = slice.secondary;
                let here = found.iter().filter(|solution| solution[unknown::SECONDARY] == secondary);
                self.slicer.through(slice, here.cloned());
            });
        }
        true
    }

    /// Looks out for curves that enter the window from resonances outside of it, once nothing else leads to any.
    pub(crate) fn look_outside(&mut self, about: &Scope, grazing: &[GrazingCurve]) {
        let entering = || entering_curves::entering(&self.net.equations, self.scope, about, grazing);
        self.entering = Purpose::Curves.during(entering);
    }

    /// Starts the curves that enter the window and are not known, once; returns whether there are any.
    pub(crate) fn enters(&mut self, progress: &dyn Progress) -> bool {
        let entering = core::mem::take(&mut self.entering);
        let known = self.net.curves.len();
        self.explain(&entering, progress);
        self.net.curves.len() > known
    }

    /// Follows the branches of slices through the range of η where they meet a column, MPSs once,
    /// and starts curves at the events on them.
    pub(crate) fn follow_columns(&mut self, progress: &dyn Progress) {
        let parts = match self.net.equations.has_impacts() {
            true if self.crossed => return,
            true => COLUMNS,
            false => FREE_COLUMNS,
        };
        self.crossed = true;
        let [left, right] = self.scope.window.primary;
        let places = (0..=parts).map(|k| left + (right - left) * f64::from(k) / f64::from(parts));
        let found = parallel::map(places, |primary| self.slicer.across(&self.slices, primary, &self.columns));
        found.into_iter().flatten().for_each(|column| self.add_column(column, progress));
    }

    /// Follows the edges of the window with the least and the greatest μ through solutions there to
    /// which no curve may lead: a sheet cut off by a corner may lie between two slices.
    fn follow_edges(&mut self, found: &[Unknowns], progress: &dyn Progress) {
        let on_an_edge = |solution: &&Unknowns| {
            let [share, _] = self.scope.window.shares(parameters(solution));
            share.abs().min((share - 1.0).abs()) < ON_THE_EDGE
        };
        for solution in found.iter().filter(on_an_edge) {
            if !self.columns.iter().any(|column| self.slicer.passes(column, solution)) {
                self.follow_column(solution, progress);
            }
        }
    }

    /// Adds a column through a solution.
    pub(crate) fn follow_column(&mut self, through: &Unknowns, progress: &dyn Progress) {
        if let Some(column) = self.slicer.upwards(through, &EventTimes::default()) {
            self.add_column(column, progress);
        }
    }

    fn add_column(&mut self, column: Curve, progress: &dyn Progress) {
        let events = bounding(self.net, &column, self.scope.window, self.periods > 1);
        self.columns.push(column);
        self.explain(&events, progress);
    }

    /// Starts a curve at every bifurcation that lies on none.
    fn explain(&mut self, events: &[Event], progress: &dyn Progress) {
        for event in events {
            if progress.stopped() {
                break;
            }
            Purpose::Curves.during(|| self.explain_one(event));
        }
    }

    fn explain_one(&mut self, event: &Event) {
        let Some(kind) = Bifurcation::of(event.condition, self.loops()) else { return };
        // Grazing of the other stop is a curve like others that bound solutions.
        let at_other_stop = self.net.equations.is_nearest_to_other_stop(&event.solution);
        if kind == Bifurcation::NonImpactingGrazing && !at_other_stop {
            let oscillator = self.net.equations.oscillator_at(&event.solution.unknowns);
            let [_, phase] = self.net.equations.impact(&event.solution);
            let orbit = GrazingOrbit::find(&oscillator, phase);
            if let Ok(orbit) = orbit.or_else(|_| GrazingOrbit::at(oscillator, phase)) {
                self.add_grazing(&orbit);
            }
        } else if !explained(self.net, kind, event, self.scope.window) {
            start(self.net, kind, event, &self.route);
        }
    }

    /// Adds the grazing curve through an orbit unless it is known, and returns whether it did.
    pub(crate) fn add_grazing(&mut self, orbit: &GrazingOrbit) -> bool {
        let shares = self.scope.window.shares(orbit.oscillator().parameters());
        if shares.iter().all(|share| (-ON_THE_EDGE..=1.0 + ON_THE_EDGE).contains(share))
            && !self.grazing.iter().any(|curve| curve.passes(orbit, self.scope))
            && let Ok(curve) =
                Purpose::Curves.during(|| GrazingCurve::through(orbit, self.scope, self.periods))
            && !curve.states.is_empty()
        {
            self.grazing.push(curve);
            return true;
        }
        false
    }

    /// Numbers the bifurcation curves by the resonances that they leave.
    pub(crate) fn number(&mut self) {
        self.net.number(Some(self.scope.window));
    }

    /// Forgets what has been found since these were the bifurcation curves.
    pub(crate) fn return_to(&mut self, curves: Vec<DiagramCurve>) {
        self.net.return_to(curves);
    }

    /// The bifurcation curves.
    pub(crate) fn curves(&self) -> &[DiagramCurve] {
        &self.net.curves
    }

    /// The requested curves, along which the solutions have a property.
    pub(crate) fn own_curves(
        &self,
        requested: &[OwnCurve],
        progress: &dyn Progress,
    ) -> own_curves::FoundCurves {
        let branches = self.slices.iter().flat_map(|slice| &slice.branches).chain(&self.columns);
        let sources: Vec<&Curve> = branches.chain(self.net.curves.iter().map(|curve| &curve.curve)).collect();
        let route = Route { stop_at_events: false, ..self.route };
        let mut all = own_curves::FoundCurves::default();
        let of_these = |(_, request): &(usize, &OwnCurve)| request.loops.contains(&self.loops());
        for request in requested.iter().enumerate().filter(of_these) {
            all.extend(own_curves::find(&self.slicer, &sources, &route, request, progress));
        }
        all
    }
}

/// Number of points behind the wall after which a curve of motion without impacts is followed no further:
/// next to a pole of the force behind it a curve may have any number. Where it comes back into sight,
/// slices see it.
const OUT_OF_SIGHT: usize = 300;

/// The longest step of a curve of motion without impacts: any, as long as it has lately been in sight.
fn in_sight(points: &[CurvePoint], _: &Unknowns) -> Option<f64> {
    let hidden = points.iter().rev().take_while(|point| !point.solution.admissible()).count();
    (hidden < OUT_OF_SIGHT).then_some(f64::INFINITY)
}
