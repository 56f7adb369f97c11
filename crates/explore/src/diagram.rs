//! The two-parameter diagram, sent while it is computed.

use std::collections::BTreeMap;

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo};
use grazing_continuation::mps::Multipliers;
use grazing_input::Mistake;
use grazing_model::smooth::Stop;
use grazing_results::plane::{
    CurveSource, OnCurve, OwnPoint, PlanePoint, RegionCorner, SequenceVertex, SpecialPoint,
};
use grazing_results::resonance::{CheckedResonance, Coefficients};
use grazing_results::{Dimensioned, Row};
use grazing_theorems::resonant_theorem::BifurcationCurve;
use grazing_unfold::described::Axes;
use grazing_unfold::described::Prepared;
use grazing_unfold::diagram::DiagramCurve;
use grazing_unfold::grazing::along::forgotten;
use grazing_unfold::magnification::approximation;
use grazing_unfold::nothing::Nothing;
use grazing_unfold::plane;
use grazing_unfold::progress::Progress;
use grazing_unfold::sequences::of_diagram;
use grazing_unfold::unfolded::AtResonance;
use grazing_unfold::{Diagram, UnfoldError};
use serde::Deserialize;

use crate::answer::{Cells, Problem, answers, told};
use crate::events::{Events, event};
use crate::kept::Sent;
use crate::model::{Model, View};
use crate::place::{self, Eigenvalues};

/// The request for a two-parameter diagram.
#[derive(Deserialize)]
pub(crate) struct DiagramRequest {
    model: Model,
    view: View,
    /// Whether only grazing curves, resonances and curves that leave them are requested, without regions.
    #[serde(default)]
    coarse: bool,
}

/// The diagram of a view with all its regions, as each wall sees it, which is not computed again if it was among the last.
pub(crate) fn known(
    model: &Model,
    view: &View,
    events: &Events,
    stop: &Stop,
) -> Result<(Axes, Vec<Diagram>), Problem> {
    let of = model.prepared(Some(view), stop)?;
    let axes = of.axes.clone();
    if let Some(kept) = events.kept.find(model, view) {
        let moving = kept.into_iter().zip(of.from_each_wall());
        return Ok((
            axes,
            moving.map(|(kept, view)| Diagram { oscillator: view.oscillator, ..kept }).collect(),
        ));
    }
    let seen = whole(&of, events)?;
    if stop.is_asked() {
        return Err(Problem::ended());
    }
    events.kept.add(model, view, seen.clone(), Sent::new());
    Ok((axes, seen))
}

/// The diagram with all its regions, as each wall sees it.
pub(crate) fn whole(of: &Prepared, progress: &dyn Progress) -> Result<Vec<Diagram>, Problem> {
    let seen = of.from_each_wall().map(|view| view.whole(progress)).collect::<Result<_, _>>();
    seen.map_err(|error| problem(&of.axes, error))
}

/// Why there is no diagram.
pub(crate) fn problem(axes: &Axes, error: UnfoldError) -> Problem {
    Problem::wrong(error.with_dimensions(&axes.units).to_string())
}

/// The kind of curves that a file asks for.
pub(crate) const OWN_CURVE: &str = "own";

pub(crate) fn compute(request: &DiagramRequest, events: &Events, stop: &Stop) -> Result<(), Problem> {
    let DiagramRequest { model, view, coarse } = request;
    if !coarse && let Some(sent) = events.kept.sent(model, view) {
        sent.into_iter().for_each(|event| events.say(event));
        return Ok(());
    }
    let mut sent = Sent::new();
    let mut tell = |event: String| {
        events.say(event.clone());
        sent.push(event);
    };
    let (description, mistake) = model.viewed(Some(view), stop)?;
    let of = model.prepare(&description, stop)?;
    let axes = of.axes.clone();
    if let Some(Mistake { message, .. }) = mistake {
        tell(event("part", &ValidPart { view: View::of(&description), reason: message }));
    }
    let mut all = Shown::default();
    let mut seen: Vec<Diagram> = Vec::new();
    for view in of.from_each_wall() {
        let located = view.located(events).map_err(|error| problem(&axes, error))?;
        let rows = plane::grazing_rows(&located)
            .with_dimensions(&axes.units)
            .into_iter()
            .filter(|rows| is_shown(rows, located.wall));
        let grazing = (0..).zip(rows).map(|(k, rows)| ShownCurve::of(&rows, k));
        events.send("curves", &grazing.collect::<Vec<_>>());
        all.resonances.extend(resonances(&axes, &located));
        // What the other of two walls sees comes after it, and is sent together with it.
        if seen.is_empty() {
            tell(event("resonances", &all.resonances));
        }
        let diagram = growing(&axes, located, *coarse, events);
        all.add(&axes, &diagram, *coarse);
        if !seen.is_empty() {
            tell(event("resonances", &all.resonances));
        }
        all.tell(*coarse, &mut tell);
        seen.push(diagram);
    }
    // Curves that were sent under a wrong name, since they were mistaken for others, are not among these.
    let curves = all.curves.iter().chain(&all.approximations);
    tell(event("keys", &curves.map(|curve| &*curve.key).collect::<Vec<_>>()));
    let secondary = description.secondary().name();
    let grazing = seen.iter().flat_map(|diagram| &diagram.grazing);
    let forgotten = grazing.filter_map(|curve| forgotten(curve, secondary, &axes.units));
    let forgotten = forgotten.map(|words| format!("grazing curve: {words}"));
    tell(event("notes", &seen.iter().flat_map(Diagram::lost).chain(forgotten).collect::<Vec<_>>()));
    let mut shown = all.regions;
    let of_one_impact = shown.len();
    if !coarse && (description.generations() > 1 || description.has_two_walls()) {
        let (regions, curves) = several(&axes, &seen[0], description.generations(), events);
        shown.extend(regions);
        tell(event("curves", &curves));
        tell(event("regions", &shown));
    }
    // Regions of stable solutions are shown all the same.
    let empty = shown.len() == of_one_impact && seen.iter().all(|diagram| diagram.nothing().is_some());
    if let Some(reason) = seen[0].nothing().filter(|_| empty) {
        let nothing = Nothing::new(&reason.clone().with_dimensions(&axes.units), &description);
        let sentence = nothing.sentence();
        tell(event("nothing", &Empty { sentence, found: nothing.found, question: nothing.question }));
    }
    if !(*coarse || stop.is_asked()) {
        events.kept.add(model, view, seen, sent);
    }
    Ok(())
}

answers! {
    /// The part of the view that is shown, and what is wrong in the rest.
    ValidPart { view: View, reason: String, }

    /// Why there is nothing in the view.
    Empty { sentence: String, found: String, question: String, }

    /// A curve.
    #[derive(Default)]
    ShownCurve {
        /// A name that stays the same while constants move: its number in the group of its kind.
        key: String,
        group: String,
        kind: &'static str,
        p: u32, n: u32, wall: u32,
        source: &'static str,
        points: Vec<[f64; 2]>,
        /// Whether a region may end at each point; of a curve that the file asks for, whether it is bold there.
        bounds: Vec<bool>,
        /// The first two unknowns at each point, from which `exact` finds places exactly on the curve.
        starts: Option<Vec<[f64; 2]>>,
        /// The multipliers at each point.
        multipliers: Option<Vec<Eigenvalues>>,
        /// Why it was not followed farther at either end.
        lost: Option<[String; 2]>,
        /// The name in the file, and the property that holds along it.
        name: Option<String>, property: Option<String>,
        /// What it is, if its kind does not say that.
        tells: Option<&'static str>,
    }

    /// A resonance or another codimension-two point, with the multipliers there, unless they are limits.
    Point { #[serde(flatten)] row: Cells, multipliers: Option<Eigenvalues>, }

    /// A region: what its vertices have in common, its border, and its name if it is one of several impacts.
    ShownRegion { #[serde(flatten)] row: Cells, rings: Vec<Vec<(f64, f64)>>, name: Option<String>, }
}

/// What the page shows of the plane, as one wall sees it, and then as the other does as well.
#[derive(Default)]
struct Shown {
    resonances: Vec<Cells>,
    curves: Vec<ShownCurve>,
    points: Vec<Point>,
    regions: Vec<ShownRegion>,
    approximations: Vec<ShownCurve>,
}

impl Shown {
    /// Adds a finished diagram. It contains everything that was sent before, and the curves that begin elsewhere.
    fn add(&mut self, axes: &Axes, diagram: &Diagram, coarse: bool) {
        let rows = plane::curves(diagram).with_dimensions(&axes.units);
        let mut counts: BTreeMap<(&str, u32, u32), u32> = BTreeMap::new();
        let arcs = rows.chunk_by(|a, b| a.at.arc == b.at.arc).zip(starts(diagram));
        self.curves.extend(arcs.filter(|(rows, _)| is_shown(rows, diagram.wall)).map(|(rows, starts)| {
            let first = &rows[0];
            let count = counts.entry((first.kind.name(), first.loops, first.n)).or_default();
            *count += 1;
            let found = ShownCurve { starts: Some(starts), ..ShownCurve::of(rows, *count - 1) };
            if coarse { found } else { found.along(rows.iter().map(|row| &row.at)) }
        }));
        self.curves.extend(
            plane::own_curves(diagram)
                .with_dimensions(&axes.units)
                .chunk_by(|a, b| a.at.arc == b.at.arc)
                .map(ShownCurve::own),
        );
        let known = diagram.unfolding().map(|_| None);
        let others = diagram.codimension_two.iter();
        let known =
            known.chain(others.map(|other| Some(place::eigenvalues(&other.event.solution.multipliers))));
        let rows = plane::points(diagram).with_dimensions(&axes.units);
        let points = rows.iter().zip(known).filter(|(row, _)| plane::counts(row.loops, diagram.wall));
        self.points.extend(points.map(|(row, multipliers)| Point { row: told(row), multipliers }));
        if !coarse {
            let rows = plane::regions(&diagram.regions).with_dimensions(&axes.units);
            let regions = rows.chunk_by(|a, b| a.region == b.region);
            let own = regions.filter(|rows| plane::counts(rows[0].loops, diagram.wall));
            self.regions.extend(own.map(|rows| ShownRegion::of(rows, |row| &row.at)));
        }
        self.approximations.extend(approximations(axes, diagram));
    }

    fn tell(&self, coarse: bool, tell: &mut impl FnMut(String)) {
        tell(event("curves", &self.curves));
        tell(event("points", &self.points));
        if !coarse {
            tell(event("regions", &self.regions));
        }
        tell(event("curves", &self.approximations));
    }
}

/// Whether a curve is shown as a wall sees it.
fn is_shown(rows: &[PlanePoint], wall: u32) -> bool {
    rows.first().is_some_and(|first| plane::is_shown(first, wall))
}

/// The diagram of what is located, whose curves are sent as they are found; with its regions unless it is coarse.
fn growing(axes: &Axes, located: Diagram, coarse: bool, events: &Events) -> Diagram {
    let ranks = ranks(&located);
    let followed = located.follow(events, &|resonance, curves: &[DiagramCurve]| {
        // A resonance has one SN curve, one PD curve, and up to two GZ curves.
        let mut grazing = 0;
        let one = |found: &DiagramCurve| {
            let mut rank = ranks[resonance];
            if found.kind == Bifurcation::Grazing {
                rank = 2 * rank + grazing;
                grazing += 1;
            }
            ShownCurve::of(&plane::bifurcation_rows(&located, found).with_dimensions(&axes.units), rank)
        };
        events.send("curves", &curves.iter().map(one).collect::<Vec<_>>());
    });
    match coarse {
        true => located.with_curves(followed),
        false => located.with(followed, events),
    }
}

/// The place of each resonance among those with the same p and n whose curves are followed.
fn ranks(diagram: &Diagram) -> Vec<u32> {
    let mut counts: BTreeMap<(u32, u32), u32> = BTreeMap::new();
    let rank = |resonance: &grazing_unfold::resonances::FoundResonance| {
        let count = counts.entry((resonance.loops, resonance.n)).or_default();
        let rank = *count;
        *count += u32::from(resonance.theorem.is_ok());
        rank
    };
    diagram.resonances.iter().map(rank).collect()
}

impl ShownCurve {
    /// A curve with these points, each with whether regions may end there.
    pub(crate) fn new(
        kind: &'static str,
        [p, n, rank]: [u32; 3],
        wall: u32,
        source: CurveSource,
        points: impl Iterator<Item = ([f64; 2], bool)>,
    ) -> Self {
        let (points, bounds) = points.unzip();
        let of_wall = if wall > 1 { format!("wall {wall} ") } else { String::new() };
        let group = format!("{kind} {p} {n} {of_wall}");
        let quadratic = if source == CurveSource::Quadratic { " quadratic" } else { "" };
        let key = format!("{group}#{rank}{quadratic}");
        Self { key, group, kind, p, n, wall, source: source.name(), points, bounds, ..Self::default() }
    }

    /// A curve of the diagram, which has points.
    fn of(rows: &[PlanePoint], rank: u32) -> Self {
        let PlanePoint { kind, loops, wall, n, .. } = rows[0];
        let bounds = |index: usize| rows[index].at.admissible && PlanePoint::bounds(rows, index);
        let points = rows.iter().enumerate();
        let points = points.map(|(index, row)| ([row.at.primary, row.at.secondary], bounds(index)));
        Self::new(kind.name(), [loops, n, rank], wall, CurveSource::Continuation, points)
    }

    /// A curve that the file asks for, which is bold where solutions are stable and admissible.
    fn own(rows: &[OwnPoint]) -> Self {
        let OwnPoint { name, property, loops, at } = &rows[0];
        let bold = |at: &OnCurve| at.stable.is_stable() && at.admissible;
        let points = rows.iter().map(|row| ([row.at.primary, row.at.secondary], bold(&row.at)));
        let found = Self::new(OWN_CURVE, [*loops, 0, at.arc], 0, CurveSource::Continuation, points);
        let found = found.along(rows.iter().map(|row| &row.at));
        Self { name: Some(name.clone()), property: Some(property.to_string()), ..found }
    }

    /// The curve with the multipliers at its points, and why it was not followed farther at either end.
    fn along<'a>(self, points: impl DoubleEndedIterator<Item = &'a OnCurve> + Clone) -> Self {
        let why = |point: Option<&OnCurve>| point.map_or(String::new(), |point| point.lost.clone());
        let lost = [why(points.clone().next()), why(points.clone().next_back())];
        self.with(points.map(|&OnCurve { trace, determinant, .. }| Multipliers { trace, determinant }), lost)
    }

    /// The curve with these multipliers at its points, and these reasons why it ends.
    pub(crate) fn with(self, multipliers: impl Iterator<Item = Multipliers>, lost: [String; 2]) -> Self {
        Self { multipliers: Some(multipliers.map(|one| rounded(&one)).collect()), lost: Some(lost), ..self }
    }
}

/// The eigenvalues with these multipliers, real and imaginary parts, rounded to the digits that are shown.
fn rounded(multipliers: &Multipliers) -> Eigenvalues {
    place::eigenvalues(multipliers).map(|one| one.map(|part| (part * ROUNDED).round() / ROUNDED))
}

const ROUNDED: f64 = 1e4;

/// The first two unknowns at the points of all curves, from which `exact` finds places exactly on them.
fn starts(diagram: &Diagram) -> impl Iterator<Item = Vec<[f64; 2]>> {
    let grazing = diagram.grazing.iter();
    let grazing = grazing.map(|curve| curve.states.iter().map(|state| [0.0, state.orbit.phase()]).collect());
    let others = diagram.curves.iter().map(|curve| {
        let points = curve.curve.points.iter();
        points.map(|point| [point.solution.unknowns[0], point.solution.unknowns[1]]).collect()
    });
    grazing.chain(others)
}

impl ShownRegion {
    fn of<R: Row>(rows: &[R], at: fn(&R) -> &RegionCorner) -> Self {
        Self { row: told(&rows[0]), rings: RegionCorner::rings(rows.iter().map(at)), name: None }
    }
}

/// The regions of solutions with several impacts, and the curves of those that hit both of two walls.
fn several(
    axes: &Axes,
    diagram: &Diagram,
    generations: u32,
    progress: &dyn Progress,
) -> (Vec<ShownRegion>, Vec<ShownCurve>) {
    let found = of_diagram(diagram, generations, progress);
    let regions = found.rows(diagram.wall).regions.with_dimensions(&axes.units);
    let one = |rows: &[SequenceVertex]| ShownRegion {
        name: Some(rows[0].name()),
        ..ShownRegion::of(rows, |row| &row.at)
    };
    let both = found.at_both_walls().with_dimensions(&axes.units);
    let both = both.chunk_by(|a, b| a.at.arc == b.at.arc).map(|rows| {
        let PlanePoint { kind, loops, at: OnCurve { arc, .. }, .. } = rows[0];
        let group = format!("{} {loops} both walls ", kind.name());
        let found = ShownCurve { key: format!("{group}#{arc}"), group, ..ShownCurve::of(rows, arc) };
        found.along(rows.iter().map(|row| &row.at))
    });
    (regions.chunk_by(|a, b| a.region == b.region).map(one).collect(), both.collect())
}

/// All resonances, with the coefficients that the theorem gives where it holds.
fn resonances(axes: &Axes, diagram: &Diagram) -> impl Iterator<Item = Cells> {
    diagram.resonances.iter().map(|resonance| {
        let at = AtResonance::new(resonance, diagram.wall).with_dimensions(&axes.units);
        let (kind, [primary, secondary], holds) =
            (CodimensionTwo::Resonance, at.parameters, resonance.theorem.is_ok());
        let mut coefficients = Coefficients::from(&at.point);
        if !holds {
            [coefficients.c_sn, coefficients.c_pd] = [f64::NAN; 2];
        }
        told(&CheckedResonance {
            at: SpecialPoint { kind, loops: at.loops, wall: at.wall, n: at.n, secondary, primary },
            coefficients,
            holds,
            failing: at.failing().collect::<Vec<_>>().join("; "),
        })
    })
}

/// The quadratic approximations to the SN and PD curves of the resonances in the diagram, and to
/// the curve on which period-doubled solutions graze, as far as they lie in the view.
fn approximations(axes: &Axes, diagram: &Diagram) -> Vec<ShownCurve> {
    let ranks = ranks(diagram);
    let unfolding = diagram.resonances.iter().zip(ranks);
    let of = |(resonance, rank): (&grazing_unfold::resonances::FoundResonance, u32)| {
        let point = resonance.theorem.as_ref().ok()?;
        let shown = |(kind, curve): (Bifurcation, BifurcationCurve)| {
            let points = approximation(point, curve, diagram.scope.window);
            let points = points.into_iter().map(|point| (axes.units.parameters(point), true));
            let known = [resonance.loops, resonance.n, rank];
            ShownCurve::new(kind.name(), known, diagram.wall, CurveSource::Quadratic, points)
        };
        let [saddle_node, period_doubling] = point.leading().named();
        // Period-doubled solutions begin at the period doubling, on its side.
        let coefficient = point.resonant_point().doubled_grazing_coefficient();
        let doubled = (Bifurcation::Grazing, BifurcationCurve { coefficient, ..period_doubling.1 });
        let tells = Some("2GZ: quadratic approximation to where period-doubled solutions graze");
        Some([shown(saddle_node), shown(period_doubling), ShownCurve { tells, ..shown(doubled) }])
    };
    unfolding.filter_map(of).flatten().collect()
}
