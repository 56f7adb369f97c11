//! The two-parameter diagram: grazing curves, resonances, the curves that leave them, and
//! codimension-two points.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::{Curve, Window};
use grazing_continuation::mps::{Formulation, LoopEquations};
use grazing_continuation::resonance::{ResonanceError, ResonantGrazingPoint, UnfoldedResonance};
use grazing_input::OwnCurve;
use grazing_model::smooth::Purpose;
use grazing_model::{AnyOscillator, ImpactOscillator};

pub use crate::curves::{CodimensionTwoPoint, DiagramCurve, route};
use crate::curves::{Net, drawn, within};
use crate::grazing::GrazingCurve;
use crate::non_impacting::{self, NonImpacting};
use crate::own_curves::{self, FoundCurve};
use crate::parallel;
use crate::progress::Progress;
use crate::regions::{self, Decided, Region};
use crate::resonances::{self, FoundResonance, Unlocated};
use crate::unfinished::Unfinished;
use crate::{Scope, UnfoldError};

/// A resonance with curves that could not be followed.
#[derive(Clone, Debug)]
pub struct NotUnfolded {
    /// Number of loops p of the resonance.
    pub loops: u32,
    /// The integer n of the resonance.
    pub n: u32,
    /// Number of loops of the solutions; it differs from p for solutions of more loops that leave a
    /// one-loop resonance.
    pub solutions: u32,
    /// The reason.
    pub reason: ResonanceError,
}

impl NotUnfolded {
    /// The name of the curves that could not be followed, such as `p = 1, n = 3` or
    /// `p = 1, n = 3, solutions of 2 loops`.
    pub fn name(&self) -> String {
        let Self { loops, n, solutions, .. } = self;
        let of = if solutions == loops { String::new() } else { format!(", solutions of {solutions} loops") };
        format!("p = {loops}, n = {n}{of}")
    }
}

/// The curves followed from a resonance.
#[derive(Clone, Debug)]
pub struct Followed {
    /// The index of the resonance in the diagram's list.
    pub resonance: usize,
    /// The curves that were found.
    pub curves: Vec<DiagramCurve>,
    /// The reasons why others are missing.
    pub missing: Vec<ResonanceError>,
}

/// The two-parameter diagram.
#[derive(Clone, Debug)]
pub struct Diagram {
    /// The scope of the analysis.
    pub scope: Scope,
    /// The oscillator, whose own parameters do not matter.
    pub oscillator: AnyOscillator,
    /// The number of the wall from which it is seen, 1 or 2, if there are two; 0 otherwise.
    pub wall: u32,
    /// The pieces of the curve of grazing bifurcations of the non-impacting solution.
    pub grazing: Vec<GrazingCurve>,
    /// Grazing curves of motion without impacts over two forcing periods, four, and so on, as far
    /// as solutions with impacts begin there.
    pub doubled: Vec<GrazingCurve>,
    /// The reason why there is no grazing curve, if there is none.
    pub no_grazing: Option<UnfoldError>,
    /// All resonances on the grazing curves, by p and along the curve.
    pub resonances: Vec<FoundResonance>,
    /// Resonances of one loop where p = 1 is not in the scope: solutions of more loops leave them
    /// as well.
    pub one_loop: Vec<FoundResonance>,
    /// Folds and period doublings of non-impacting motion (p = 0); then SN, PD and GZ curves of the
    /// MPSs, by p.
    pub curves: Vec<DiagramCurve>,
    /// Codimension-two points other than resonances.
    pub codimension_two: Vec<CodimensionTwoPoint>,
    /// Regions in which solutions are stable, and regions in which this is undecided.
    pub regions: Vec<Region>,
    /// Requests for further curves, along which solutions have a property.
    pub requested: Vec<OwnCurve>,
    /// The curves with these properties that were found.
    pub own: own_curves::FoundCurves,
    /// Resonances that were detected but could not be located.
    pub unlocated: Vec<Unlocated>,
    /// Resonances whose curves could not be followed.
    pub not_unfolded: Vec<NotUnfolded>,
    /// Parts that were not finished when the computation was cancelled.
    pub unfinished: Vec<Unfinished>,
}

/// The stage in which curves are followed from the resonances.
const CURVES: &str = "bifurcation curves";

/// In a window narrower than this, regions and curves are taken from a wider one: curves that touch
/// at a resonance are too close to each other there for slices to distinguish them from rounding,
/// as branches begin at impact velocities of the order of the root of its width.
const UNDECIDABLE_WIDTH: f64 = 1e-7;

/// The window around a narrow one in which curves are found and regions decided.
fn widened(window: Window) -> Option<Window> {
    let about = |[low, high]: [f64; 2]| {
        let room = (0.5 * (UNDECIDABLE_WIDTH - (high - low))).max(0.0);
        [low - room, high + room]
    };
    let [across, up] = window.widths();
    let wide = Window { primary: about(window.primary), secondary: about(window.secondary) };
    // Not widened again because of rounding.
    (across.min(up) < 0.5 * UNDECIDABLE_WIDTH).then_some(wide)
}

impl Diagram {
    /// Finds the grazing curves of an oscillator and all resonances on them, and follows the curves
    /// that leave these.
    ///
    /// The oscillator's own parameters do not matter. Resonances are unfolded in parallel; the
    /// result does not depend on the number of threads.
    ///
    /// # Errors
    /// As [`located`](Self::located) and [`found`](Self::found).
    pub fn compute(
        oscillator: &AnyOscillator,
        scope: &Scope,
        progress: &dyn Progress,
    ) -> Result<Self, UnfoldError> {
        let located = Self::located(oscillator, scope, progress)?;
        let followed = located.follow(progress, &|_, _| ());
        located.with(followed, progress).found()
    }

    /// The diagram, if it contains a grazing curve, or curves or regions of MPSs without one, as
    /// beside a piece of one of their curves in a small window.
    ///
    /// # Errors
    /// The reason why there is no grazing, if there is no curve of MPSs and no region either.
    pub fn found(self) -> Result<Self, UnfoldError> {
        match self.nothing() {
            Some(reason) => Err(reason.clone()),
            None => Ok(self),
        }
    }

    /// The reason why there is no grazing, if there is no curve of MPSs and no region either.
    pub fn nothing(&self) -> Option<&UnfoldError> {
        let is_empty = self.curves.iter().all(|curve| curve.loops == 0)
            && self.regions.iter().all(|region| region.loops == 0 || region.doubt.is_some());
        self.no_grazing.as_ref().filter(|_| is_empty)
    }

    /// The diagram, if there is a grazing curve.
    ///
    /// # Errors
    /// There is no grazing curve; the error describes the motion that was seen.
    pub fn with_grazing(self) -> Result<Self, UnfoldError> {
        self.no_grazing.clone().map_or(Ok(self), Err)
    }

    /// The first half of [`compute`](Self::compute): grazing curves and resonances, but no
    /// bifurcation curves. If the ranges contain no grazing the curves of MPSs may still cross
    /// them.
    ///
    /// # Errors
    /// The computation was cancelled before anything was found.
    pub fn located(
        oscillator: &AnyOscillator,
        scope: &Scope,
        progress: &dyn Progress,
    ) -> Result<Self, UnfoldError> {
        let NonImpacting { grazing, doubled, no_grazing, curves, regions, unfinished } =
            non_impacting::find(oscillator, scope, progress)?;
        let mut diagram = Self {
            scope: scope.clone(),
            oscillator: oscillator.clone(),
            wall: u32::from(oscillator.other_stop().is_some()),
            grazing,
            doubled,
            no_grazing,
            resonances: Vec::new(),
            one_loop: Vec::new(),
            curves,
            codimension_two: Vec::new(),
            regions,
            requested: Vec::new(),
            own: own_curves::FoundCurves::default(),
            unlocated: Vec::new(),
            not_unfolded: Vec::new(),
            unfinished,
        };
        for curve in &diagram.grazing {
            let on_curve = |scope| Purpose::Curves.during(|| resonances::on_curve(curve, scope, progress));
            let (mut found, mut lost) = on_curve(scope);
            diagram.resonances.append(&mut found);
            diagram.unlocated.append(&mut lost);
            if !scope.loops.contains(&1) {
                let one_loop = Scope { loops: vec![1], ..scope.clone() };
                diagram.one_loop.append(&mut on_curve(&one_loop).0);
            }
        }
        for found in [&mut diagram.resonances, &mut diagram.one_loop] {
            *found = resonances::distinct(core::mem::take(found), scope.window);
        }
        if progress.stopped() {
            diagram.unfinished.push(Unfinished::stage(resonances::STAGE));
        }
        let order = |loops| scope.loops.iter().position(|asked| *asked == loops);
        diagram.resonances.sort_by_key(|resonance| order(resonance.loops));
        Ok(diagram)
    }

    /// Descriptions of resonances that could not be located, and of those whose curves could not be followed.
    pub fn lost(&self) -> impl Iterator<Item = String> {
        let unlocated = self.unlocated.iter().map(|lost| format!("p = {}: {}", lost.loops, lost.reason));
        unlocated.chain(self.not_unfolded.iter().map(|lost| format!("{}: {}", lost.name(), lost.reason)))
    }

    /// The diagram with requests for further curves.
    #[must_use]
    pub fn requesting(self, requested: Vec<OwnCurve>) -> Self {
        Self { requested, ..self }
    }

    /// The diagram with the curves followed from its resonances, in the order of their list, and
    /// everything that follows from them: the curves that begin where they end, those to which no
    /// resonance leads, and the regions.
    pub fn with(self, followed: Vec<Followed>, progress: &dyn Progress) -> Self {
        self.with_drafts(followed, progress, &|_, _, _| ())
    }

    /// The same; `decided` receives, p by p, curves and regions as they are known: once all curves from resonances
    /// are known, with nothing decided, and again as soon as the regions of a p are decided.
    pub fn with_drafts(
        mut self,
        followed: Vec<Followed>,
        progress: &dyn Progress,
        decided: Decided<'_>,
    ) -> Self {
        let known = self.nets(followed);
        let mut nets = known.clone();
        let followed: Vec<usize> = nets.iter().map(|net| net.curves.len()).collect();
        self.follow_iterated(&mut nets);
        self.grow(&mut nets);
        let grazing = [self.grazing.as_slice(), &self.doubled].concat();
        for net in &nets {
            let open = Region::not_finished(self.scope.window, net.loops());
            decided(net.loops(), &net.curves, &[open]);
        }
        let requested = (&self.scope, self.requested.as_slice());
        let of_mps = regions::of_mps(&self.oscillator, requested, &grazing, &mut nets, progress, decided);
        if progress.stopped() {
            self.unfinished.push(Unfinished::stage(regions::STAGE));
        }
        for ((net, known), (regions, own)) in nets.iter_mut().zip(known).zip(of_mps) {
            let regions = regions.unwrap_or_else(|| {
                // The part in progress at the moment of cancellation is meaningless.
                *net = known;
                vec![Region::not_finished(self.scope.window, net.loops())]
            });
            self.regions.extend(regions);
            self.own.extend(own);
        }
        self.take(nets, &followed);
        if let Some(window) = widened(self.scope.window) {
            let scope = Scope { window, ..self.scope.clone() };
            if let Ok(wide) = Self::located(&self.oscillator, &scope, progress) {
                let wide = wide.requesting(self.requested.clone());
                let followed = wide.follow(progress, &|_, _| ());
                let wide = wide.with(followed, progress);
                // The same holds for curves, to which no resonance in the window need lead.
                let window = self.scope.window;
                self.regions = wide.regions.iter().flat_map(|region| region.within(window)).collect();
                self.curves = wide.curves.iter().flat_map(|curve| curve.within(window)).collect();
                let inside = |point: &CodimensionTwoPoint| window.contains(point.event.solution.parameters());
                let pieces = |found: &FoundCurve| {
                    let pieces = within(&found.curve, window);
                    pieces.into_iter().map(|curve| FoundCurve { curve, ..*found }).collect::<Vec<_>>()
                };
                let own = wide.own.curves.iter().flat_map(pieces).collect();
                self.own = own_curves::FoundCurves { curves: own, lost: wide.own.lost };
                self.codimension_two = wide.codimension_two.into_iter().filter(inside).collect();
                self.unfinished.extend(wide.unfinished);
            }
        }
        self
    }

    /// The diagram with these curves and those that begin where they end, but without regions, and
    /// therefore without curves to which no resonance leads.
    pub fn with_curves(mut self, followed: Vec<Followed>) -> Self {
        let mut nets = self.nets(followed);
        let followed: Vec<usize> = nets.iter().map(|net| net.curves.len()).collect();
        self.follow_iterated(&mut nets);
        self.grow(&mut nets);
        nets.iter_mut().for_each(|net| net.number(None));
        self.take(nets, &followed);
        self
    }

    /// The curves that were followed, by p; missing ones are recorded.
    fn nets(&mut self, followed: Vec<Followed>) -> Vec<Net> {
        let cut = self.resonances.iter().enumerate().filter(|(index, resonance)| {
            resonance.theorem.is_ok() && followed.iter().all(|followed| followed.resonance != *index)
        });
        let cut = cut.map(|(_, resonance)| Unfinished::at(CURVES, resonance)).collect::<Vec<_>>();
        self.unfinished.extend(cut);
        let mut nets: Vec<Net> =
            self.scope.loops.iter().map(|&loops| Net::new(self.equations(loops))).collect();
        for Followed { resonance, curves, missing } in followed {
            let (loops, n) = (self.resonances[resonance].loops, self.resonances[resonance].n);
            let failed = |reason| NotUnfolded { loops, n, solutions: loops, reason };
            self.not_unfolded.extend(missing.into_iter().map(failed));
            if let Some(net) = nets.iter_mut().find(|net| net.loops() == loops) {
                curves.into_iter().for_each(|curve| net.add(curve));
            }
        }
        nets
    }

    /// Adds the curves of solutions with more loops that leave the resonances of one loop.
    fn follow_iterated(&mut self, nets: &mut [Net]) {
        let route = drawn(self.scope.window);
        for net in nets.iter_mut().filter(|net| net.loops() > 1) {
            let loops = net.loops();
            let one_loop = self.resonances.iter().filter(|resonance| resonance.loops == 1);
            for resonance in one_loop.chain(&self.one_loop).filter(|resonance| !resonance.is_forgotten(loops))
            {
                let unfold = || resonance.located.unfold_iterated(loops, &route);
                let (curves, missing) = Purpose::Curves.during(unfold);
                for curve in curves {
                    if let Some(kind) = Bifurcation::of(curve.condition, loops) {
                        net.add(DiagramCurve { kind, loops, n: 0, curve });
                    }
                }
                let failed = |reason| NotUnfolded { loops: 1, n: resonance.n, solutions: loops, reason };
                self.not_unfolded.extend(missing.into_iter().map(failed));
            }
        }
    }

    fn grow(&self, nets: &mut [Net]) {
        let route = drawn(self.scope.window);
        nets.iter_mut().for_each(|net| Purpose::Curves.during(|| net.grow(&route)));
    }

    /// Stores curves and codimension-two points: first all that come from resonances, in the order
    /// in which they are listed while others are being followed.
    fn take(&mut self, nets: Vec<Net>, followed: &[usize]) {
        let (mut first, mut then) = (Vec::new(), Vec::new());
        for (mut net, followed) in nets.into_iter().zip(followed) {
            then.extend(net.curves.split_off(*followed));
            first.extend(net.curves);
            self.codimension_two.extend(net.meetings);
        }
        self.curves.extend(first);
        self.curves.extend(then);
    }

    /// The equations of the p-loop MPSs; of solutions without impacts for p = 0.
    pub fn equations(&self, loops: u32) -> LoopEquations {
        match loops {
            0 => non_impacting::equations(&self.oscillator, self.scope.window),
            _ => LoopEquations::new(self.oscillator.clone(), loops, Formulation::FixedPhase),
        }
    }

    /// The resonances at which a theorem holds, with the theorem.
    pub fn unfolding(&self) -> impl Iterator<Item = (&FoundResonance, &ResonantGrazingPoint)> {
        self.resonances.iter().filter_map(|resonance| Some((resonance, resonance.theorem.as_ref().ok()?)))
    }

    /// The grazing phase z_graz at a value of η; `None` where there is no grazing curve.
    pub fn grazing_phase(&self, secondary: f64) -> Option<f64> {
        self.grazing.iter().find_map(|curve| curve.at(secondary)).map(|place| place.phase)
    }

    /// The curves from every resonance at which a theorem holds, each resonance separately, in the
    /// order of the list; those that were not finished when the computation was cancelled are left
    /// out. `finished` receives the curves of each resonance, by its index in the list, as soon as
    /// they are complete: others may take longer.
    pub fn follow(
        &self,
        progress: &dyn Progress,
        finished: &(dyn Fn(usize, &[DiagramCurve]) + Sync),
    ) -> Vec<Followed> {
        let route = drawn(self.scope.window);
        let points: Vec<_> =
            self.resonances.iter().enumerate().filter(|(_, found)| found.theorem.is_ok()).collect();
        progress.begin(CURVES, points.len() as u64);
        let followed = parallel::map(points, |(index, resonance)| {
            let point = resonance.theorem.as_ref().ok()?;
            let none = |missing| Followed { resonance: index, curves: Vec::new(), missing };
            let followed = match resonance.is_forgotten(resonance.loops) {
                true => none(Vec::new()),
                false => match Purpose::Curves.during(|| point.unfold(&route)) {
                    Ok(unfolded) => listed(index, resonance, unfolded),
                    Err(reason) => none(vec![reason]),
                },
            };
            if progress.stopped() {
                return None;
            }
            finished(index, &followed.curves);
            progress.step(CURVES);
            Some(followed)
        });
        let followed = followed.into_iter().flatten().collect();
        progress.end(CURVES);
        followed
    }
}

/// The curves of a resonance in the order in which they are listed.
fn listed(index: usize, resonance: &FoundResonance, unfolded: UnfoldedResonance) -> Followed {
    let (loops, n) = (resonance.loops, resonance.n);
    let curve = |curve: &Curve| {
        let kind = Bifurcation::of(curve.condition, loops)?;
        Some(DiagramCurve { kind, loops, n, curve: curve.clone() })
    };
    Followed {
        resonance: index,
        curves: unfolded.curves().filter_map(curve).collect(),
        missing: unfolded.missing,
    }
}
