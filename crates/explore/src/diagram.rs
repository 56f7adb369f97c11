//! The two-parameter diagram, sent while it is computed.

use std::collections::BTreeMap;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::mps::Multipliers;
use grazing_input::Mistake;
use grazing_model::smooth::Stop;
use grazing_results::plane::{OwnPoint, PlanePoint, RegionCorner, SequenceVertex};
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
use serde_json::{Map, Value, json};

use crate::answer::{Problem, told};
use crate::events::Events;
use crate::kept::Sent;
use crate::model::{Model, View};
use crate::place;

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
        sent.iter().for_each(|(name, data)| events.send(name, data));
        return Ok(());
    }
    let mut sent: Sent = Vec::new();
    let mut tell = |name: &'static str, data: Value| {
        events.send(name, &data);
        sent.push((name, data));
    };
    let (description, mistake) = model.viewed(Some(view), stop)?;
    let of = model.prepare(&description, stop)?;
    let axes = of.axes.clone();
    if let Some(Mistake { message, .. }) = mistake {
        tell("part", json!({"view": View::of(&description), "reason": message}));
    }
    let mut all = Shown::default();
    let mut seen: Vec<Diagram> = Vec::new();
    for view in of.from_each_wall() {
        let located = view.located(events).map_err(|error| problem(&axes, error))?;
        let rows = plane::grazing_rows(&located)
            .with_dimensions(&axes.units)
            .into_iter()
            .filter(|rows| is_shown(rows, located.wall));
        let grazing = (0..).zip(rows).map(|(k, rows)| curve(&rows, k));
        events.send("curves", &grazing.collect::<Vec<_>>());
        all.resonances.extend(resonances(&axes, &located));
        // What the other of two walls sees comes after it, and is sent together with it.
        if seen.is_empty() {
            tell("resonances", json!(all.resonances));
        }
        let diagram = growing(&axes, located, *coarse, events);
        all.add(&axes, &diagram, *coarse);
        if !seen.is_empty() {
            tell("resonances", json!(all.resonances));
        }
        all.tell(*coarse, &mut tell);
        seen.push(diagram);
    }
    // Curves that were sent under a wrong name, since they were mistaken for others, are not among these.
    tell("keys", all.curves.iter().chain(&all.approximations).map(|curve| curve["key"].clone()).collect());
    let secondary = description.secondary().name();
    let grazing = seen.iter().flat_map(|diagram| &diagram.grazing);
    let forgotten = grazing.filter_map(|curve| forgotten(curve, secondary, &axes.units));
    let forgotten = forgotten.map(|words| format!("grazing curve: {words}"));
    tell("notes", seen.iter().flat_map(Diagram::lost).chain(forgotten).collect());
    let mut shown = all.regions;
    let of_one_impact = shown.len();
    if !coarse && (description.generations() > 1 || description.has_two_walls()) {
        let (regions, curves) = several(&axes, &seen[0], description.generations(), events);
        shown.extend(regions);
        tell("curves", json!(curves));
        tell("regions", json!(shown));
    }
    // Regions of stable solutions are shown all the same.
    let empty = shown.len() == of_one_impact && seen.iter().all(|diagram| diagram.nothing().is_some());
    if let Some(reason) = seen[0].nothing().filter(|_| empty) {
        let nothing = Nothing::new(&reason.clone().with_dimensions(&axes.units), &description);
        let sentence = nothing.sentence();
        tell("nothing", json!({"sentence": sentence, "found": nothing.found, "question": nothing.question}));
    }
    if !(*coarse || stop.is_asked()) {
        events.kept.add(model, view, seen, sent);
    }
    Ok(())
}

/// What the page shows of the plane, as one wall sees it, and then as the other does as well.
#[derive(Default)]
struct Shown {
    resonances: Vec<Value>,
    curves: Vec<Value>,
    points: Vec<Value>,
    regions: Vec<Value>,
    approximations: Vec<Value>,
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
            let mut found = curve(rows, *count - 1);
            found["starts"] = json!(starts);
            if !coarse {
                along(&mut found, rows.iter().map(|row| ([row.at.trace, row.at.determinant], &*row.at.lost)));
            }
            found
        }));
        self.curves.extend(
            plane::own_curves(diagram)
                .with_dimensions(&axes.units)
                .chunk_by(|a, b| a.at.arc == b.at.arc)
                .map(own),
        );
        let known = diagram.unfolding().map(|_| Value::Null);
        let known = known.chain(
            diagram
                .codimension_two
                .iter()
                .map(|other| json!(place::eigenvalues(&other.event.solution.multipliers))),
        );
        let rows = plane::points(diagram).with_dimensions(&axes.units);
        let points = rows.iter().zip(known).filter(|(row, _)| plane::counts(row.loops, diagram.wall));
        self.points.extend(points.map(|(row, multipliers)| {
            let mut point = told(row);
            point.insert("multipliers".to_owned(), multipliers);
            Value::Object(point)
        }));
        if !coarse {
            let rows = plane::regions(&diagram.regions).with_dimensions(&axes.units);
            let regions = rows.chunk_by(|a, b| a.region == b.region);
            let own = regions.filter(|rows| plane::counts(rows[0].loops, diagram.wall));
            self.regions.extend(own.map(|rows| Value::Object(region(rows, |row| &row.at))));
        }
        self.approximations.extend(approximations(axes, diagram));
    }

    fn tell(&self, coarse: bool, tell: &mut impl FnMut(&'static str, Value)) {
        tell("curves", json!(self.curves));
        tell("points", json!(self.points));
        if !coarse {
            tell("regions", json!(self.regions));
        }
        tell("curves", json!(self.approximations));
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
            curve(&plane::bifurcation_rows(&located, found).with_dimensions(&axes.units), rank)
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

fn curve(rows: &[PlanePoint], rank: u32) -> Value {
    let Some(first) = rows.first() else { return Value::Null };
    let wall = first.wall;
    let bounds = |index: usize| rows[index].at.admissible && PlanePoint::bounds(rows, index);
    let points = rows
        .iter()
        .enumerate()
        .map(|(index, row)| ([row.at.primary, row.at.secondary], bounds(index)))
        .unzip();
    named(first.kind.name(), [first.loops, first.n, rank], wall, "continuation", points)
}

/// Adds details along a curve: the multipliers at its points, and why it was not followed farther
/// at either end.
fn along<'a>(curve: &mut Value, rows: impl DoubleEndedIterator<Item = ([f64; 2], &'a str)> + Clone) {
    let why = |row: Option<([f64; 2], &'a str)>| row.map_or("", |(_, lost)| lost);
    curve["lost"] = json!([why(rows.clone().next()), why(rows.clone().next_back())]);
    let multipliers = rows.map(|([trace, determinant], _)| eigenvalues(&Multipliers { trace, determinant }));
    curve["multipliers"] = multipliers.collect();
}

/// A curve, under a key that stays the same while constants move: its number in the group of its kind.
pub(crate) fn named(
    kind: &str,
    [p, n, rank]: [u32; 3],
    wall: u32,
    source: &str,
    (points, bounds): (Vec<[f64; 2]>, Vec<bool>),
) -> Value {
    let of_wall = if wall > 1 { format!("wall {wall} ") } else { String::new() };
    let group = format!("{kind} {p} {n} {of_wall}");
    let key = format!("{group}#{rank}");
    let key = if source == "quadratic" { format!("{key} {source}") } else { key };
    json!({"key": key, "group": group, "kind": kind, "p": p, "n": n, "wall": wall, "source": source, "points": points, "bounds": bounds})
}

/// A curve that the file asks for, which is bold where solutions are stable and admissible.
fn own(rows: &[OwnPoint]) -> Value {
    let first = &rows[0];
    let points = rows
        .iter()
        .map(|row| ([row.at.primary, row.at.secondary], row.at.stable.is_stable() && row.at.admissible))
        .unzip();
    let mut found = named(OWN_CURVE, [first.loops, 0, first.at.arc], 0, "continuation", points);
    found["name"] = json!(first.name);
    found["property"] = json!(first.property.to_string());
    along(&mut found, rows.iter().map(|row| ([row.at.trace, row.at.determinant], &*row.at.lost)));
    found
}

/// The eigenvalues with these multipliers, real and imaginary parts, rounded to the digits that are shown.
pub(crate) fn eigenvalues(multipliers: &Multipliers) -> Value {
    let rounded = |part: f64| (part * ROUNDED).round() / ROUNDED;
    json!(place::eigenvalues(multipliers).map(|one| one.map(rounded)))
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

/// A region, with what its vertices have in common and its border.
fn region<R: Row>(rows: &[R], at: fn(&R) -> &RegionCorner) -> Map<String, Value> {
    let mut region = told(&rows[0]);
    region.insert("rings".to_owned(), json!(RegionCorner::rings(rows.iter().map(at))));
    region
}

/// The regions of solutions with several impacts, and the curves of those that hit both of two walls.
fn several(
    axes: &Axes,
    diagram: &Diagram,
    generations: u32,
    progress: &dyn Progress,
) -> (Vec<Value>, Vec<Value>) {
    let found = of_diagram(diagram, generations, progress);
    let regions = found.rows(diagram.wall).regions.with_dimensions(&axes.units);
    let one = |rows: &[SequenceVertex]| {
        let mut region = region(rows, |row| &row.at);
        region.insert("name".to_owned(), json!(rows[0].name()));
        Value::Object(region)
    };
    let both = found.at_both_walls().with_dimensions(&axes.units);
    let both = both.chunk_by(|a, b| a.at.arc == b.at.arc).map(|rows| {
        let mut found = curve(rows, rows[0].at.arc);
        let group = format!("{} {} both walls ", rows[0].kind.name(), rows[0].loops);
        found["key"] = json!(format!("{group}#{}", rows[0].at.arc));
        found["group"] = json!(group);
        along(&mut found, rows.iter().map(|row| ([row.at.trace, row.at.determinant], &*row.at.lost)));
        found
    });
    (regions.chunk_by(|a, b| a.region == b.region).map(one).collect(), both.collect())
}

/// All resonances, with the coefficients that the theorem gives where it holds.
fn resonances(axes: &Axes, diagram: &Diagram) -> Vec<Value> {
    let one = |resonance: &grazing_unfold::resonances::FoundResonance| {
        let (at, holds) = (
            AtResonance::new(resonance, diagram.wall).with_dimensions(&axes.units),
            resonance.theorem.is_ok(),
        );
        let [primary, secondary] = at.parameters;
        let coefficient = |value| if holds { value } else { f64::NAN };
        json!({
            "p": at.loops,
            "n": at.n,
            "primary": primary,
            "secondary": secondary,
            "c_sn": coefficient(at.point.saddle_node_coefficient()),
            "c_pd": coefficient(at.point.period_doubling_coefficient()),
            "holds": holds,
            "failing": at.failing().collect::<Vec<_>>().join("; "),
        })
    };
    diagram.resonances.iter().map(one).collect()
}

/// The quadratic approximations to the SN and PD curves of the resonances in the diagram, and to
/// the curve on which period-doubled solutions graze, as far as they lie in the view.
fn approximations(axes: &Axes, diagram: &Diagram) -> Vec<Value> {
    let ranks = ranks(diagram);
    let unfolding = diagram.resonances.iter().zip(ranks);
    let of = |(resonance, rank): (&grazing_unfold::resonances::FoundResonance, u32)| {
        let point = resonance.theorem.as_ref().ok()?;
        let shown = |(kind, curve): (Bifurcation, BifurcationCurve)| {
            let points = approximation(point, curve, diagram.scope.window);
            let points = points.into_iter().map(|point| (axes.units.parameters(point), true)).unzip();
            named(kind.name(), [resonance.loops, resonance.n, rank], diagram.wall, "quadratic", points)
        };
        let [saddle_node, period_doubling] = point.leading().named();
        // Period-doubled solutions begin at the period doubling, on its side.
        let coefficient = point.resonant_point().doubled_grazing_coefficient();
        let mut doubled =
            shown((Bifurcation::Grazing, BifurcationCurve { coefficient, ..period_doubling.1 }));
        doubled["tells"] = json!("2GZ: quadratic approximation to where period-doubled solutions graze");
        Some([shown(saddle_node), shown(period_doubling), doubled])
    };
    unfolding.filter_map(of).flatten().collect()
}
