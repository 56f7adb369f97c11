//! Lines about an oscillator and its resonances on the terminal.

mod gaps;
mod one_parameter;
mod resonances;
mod window;

use std::path::Path;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::mps::PeriodicSolution;
use grazing_input::{Axis, Description};
use grazing_results::Dimensioned;
use grazing_results::{Stability, brief, span, with_unit};
use grazing_unfold::Diagram;
use grazing_unfold::grazing::along::{along_curve, forgotten};
use grazing_unfold::grazing::{GrazingCurve, GrazingCurvePoint, GrazingEnd};
use grazing_unfold::nothing::place;
use grazing_unfold::sequences::Sequence;
use grazing_unfold::unfolded::Unfolded;

use super::numbers::{range, significant};
use crate::layout::Layout;
pub(crate) use gaps::incomplete;
use gaps::{missing, odd_ends, thin, undecided, unfinished};
pub(crate) use one_parameter::one_parameter;
pub(crate) use resonances::contradictions;
use resonances::{failing_theorems, resonances};

/// Digits of parameters, and of other quantities.
const PARAMETER: usize = 8;
const QUANTITY: usize = 5;

/// The oscillator as the file has it.
pub(crate) fn oscillator(layout: Layout, description: &Description, file: &Path) -> String {
    let texts = description.texts();
    let constants: Vec<String> =
        description.constants().map(|(name, value)| format!("{name} = {value}")).collect();
    let (primary, secondary) = (description.primary(), description.secondary());
    let title = format!("{} ({})", description.name(), file.display());
    let mut text = format!("{}\n", layout.wrapped("", &title));
    let lines = [
        (
            "motion",
            format!("x'' = {} {} the wall, where v = x'", texts.force, description.wall().side().name()),
        ),
        (
            "wall",
            format!("x = {}{}", texts.wall, if description.has_two_walls() { "; it is wall 1" } else { "" }),
        ),
        ("frequency", texts.frequency.clone()),
        (
            "impact",
            "velocity y relative to the wall, phase z = frequency*t: y -> -y*Phi, z -> z + y*Psi".to_owned(),
        ),
        ("", format!("Phi = {}, Psi = {}", texts.restitution, texts.duration)),
        ("constants", if constants.is_empty() { "none".to_owned() } else { constants.join(", ") }),
        ("primary", along(primary)),
        ("secondary", along(secondary)),
        ("loops", format!("p = {}", loops(description))),
    ];
    let notes = description.notes().iter().map(|note| ("note", note.to_string()));
    let other = description.from_each_wall().skip(1).map(|seen| {
        let texts = seen.texts();
        let (side, wall) = (seen.wall().side().name(), &texts.wall);
        let impact = format!("Phi = {}, Psi = {}", texts.restitution, texts.duration);
        (
            "wall 2",
            format!("x = {wall} with the motion {side} it; {impact}; x and v in tables are seen from wall 1"),
        )
    });
    for (word, content) in lines.into_iter().chain(other).chain(notes) {
        text.push_str(&layout.wrapped(&format!("  {word:11}"), &content));
    }
    text
}

/// A parameter with its range and unit.
fn along(axis: &Axis) -> String {
    let unit = axis.unit().map_or(String::new(), |unit| format!(" {unit}"));
    format!("{} from {}{unit}", axis.name(), range(axis.range()))
}

fn loops(description: &Description) -> String {
    description.loops().iter().map(u32::to_string).collect::<Vec<_>>().join(", ")
}

/// Everything that was found, in the order in which it was.
pub(crate) fn results(layout: Layout, description: &Description, unfolded: &Unfolded) -> String {
    let (units, diagram) = (&unfolded.axes.units, &unfolded.diagram);
    let parts = [
        grazing_curves(layout, description, unfolded),
        resonances(layout, description, unfolded),
        failing_theorems(layout, description, unfolded),
        missing(layout, description, units, diagram),
        unfinished(layout, description, units, diagram),
        corners(layout, description, unfolded),
        own_curves(layout, description, unfolded),
        several_impacts(layout, unfolded),
        odd_ends(layout, description, unfolded),
        undecided(layout, description, unfolded),
        thin(layout, description, unfolded),
    ];
    let mut text = parts.concat();
    let names = &unfolded.axes.names;
    text.extend(unfolded.diagrams.iter().map(|diagram| one_parameter(layout, description, names, diagram)));
    text.push_str(&window::suggested(layout, unfolded));
    text
}

fn grazing_curves(layout: Layout, description: &Description, unfolded: &Unfolded) -> String {
    let units = &unfolded.axes.units;
    let (primary, secondary) = (description.primary().name(), description.secondary().name());
    let words = |(arc, curve): (usize, &GrazingCurve)| {
        let points: Vec<[f64; 2]> = curve.parameters().map(|at| units.parameters(at)).collect();
        let extent = |index: usize| range(span(points.iter().map(|point| point[index])));
        let content = format!(
            "{secondary} from {}, {primary} from {}, {} points; {}; {}{}",
            extent(1),
            extent(0),
            points.len(),
            ends(&curve.ends),
            along_curve(curve, secondary, units, |state| Some(stability(state))),
            forgotten(curve, secondary, units).map_or(String::new(), |words| format!("; {words}"))
        );
        (format!("  curve {arc:<5}"), content)
    };
    layout
        .headed("Grazing of the non-impacting motion", unfolded.diagram.grazing.iter().enumerate().map(words))
}

fn ends(ends: &[GrazingEnd; 2]) -> String {
    let words = |end: &GrazingEnd| match end {
        GrazingEnd::LeftWindow => "leaves the ranges".to_owned(),
        GrazingEnd::Closed => "is closed".to_owned(),
        GrazingEnd::Stopped => "was not followed further".to_owned(),
        end @ (GrazingEnd::Stalled(_) | GrazingEnd::StepLimit) => {
            format!("could not be followed further ({})", end.lost().unwrap_or_default())
        }
    };
    let [first, last] = ends.each_ref().map(words);
    match ends {
        [GrazingEnd::Closed, _] | [_, GrazingEnd::Closed] => "closed".to_owned(),
        _ if first == last => format!("{first} at both ends"),
        _ => format!("{first} at its beginning and {last} at its end"),
    }
}

/// The stability of the solution at a point of a grazing curve.
fn stability(state: &GrazingCurvePoint) -> &'static str {
    match (Stability::of(state.multipliers), state.admissible) {
        (Stability::Neutral, true) => "neutral (neither stable nor unstable)",
        (stability, true) => stability.name(),
        (Stability::Stable, false) => "stable, but inadmissible (beyond the wall at another phase)",
        (Stability::Neutral, false) => "neutral and inadmissible (beyond the wall at another phase)",
        (Stability::Unstable, false) => "unstable and inadmissible (beyond the wall at another phase)",
    }
}

/// The secondary and the primary parameter as heads of columns, with their units.
fn parameter_heads(description: &Description) -> [String; 2] {
    [description.secondary(), description.primary()].map(|axis| with_unit(axis.name(), axis.unit()))
}

fn corners(layout: Layout, description: &Description, unfolded: &Unfolded) -> String {
    let (units, corners) = (&unfolded.axes.units, &unfolded.diagram.codimension_two);
    if corners.is_empty() {
        return String::new();
    }
    let rows = corners.iter().map(|corner| {
        let velocity = corner.unknowns()[0] * units.velocity();
        let [primary, secondary] = units.parameters(corner.event.solution.parameters());
        let mut row = vec![corner.kind.name().to_owned(), corner.loops.to_string(), corner.n.to_string()];
        row.extend([secondary, primary, velocity].map(|value| significant(value, PARAMETER)));
        row
    });
    let [secondary, primary] = parameter_heads(description);
    let velocity = with_unit("impact velocity", unfolded.axes.names.named_unit("length/time").as_deref());
    let table = layout.aligned(&["kind", "p", "n", &secondary, &primary, &velocity], rows);
    format!("\nCodimension-two points on these curves\n{table}")
}

/// The solutions with several impacts, each with the part of the window in which they are stable; between two walls with
/// those that they hit, and their curves.
fn several_impacts(layout: Layout, unfolded: &Unfolded) -> String {
    let Diagram { wall, scope, .. } = &unfolded.diagram;
    let between = *wall > 0;
    let row = |found: &Sequence| {
        let percent = |decided: bool| {
            let regions = found.regions.iter().filter(|region| region.doubt.is_none() == decided);
            brief(100.0 * regions.map(|region| region.share(scope.window)).sum::<f64>(), 3)
        };
        let regions = found.regions.iter().filter(|region| region.doubt.is_none()).count();
        let numbers = [found.impacts, found.periods as usize, regions].map(|number| number.to_string());
        let curves = Bifurcation::ALL.into_iter().filter_map(|kind| {
            let count = found.curves.iter().filter(|curve| curve.kind == kind).count();
            (count > 0).then(|| format!("{count} {}", kind.name()))
        });
        let curves = between.then(|| curves.collect::<Vec<_>>().join(", "));
        let walls = between.then(|| found.walls(*wall).to_string());
        let all = numbers.into_iter().chain([percent(true), percent(false)]);
        walls.into_iter().chain(all).chain(curves).collect()
    };
    let solutions = &unfolded.sequences.solutions;
    if solutions.is_empty() {
        return String::new();
    }
    let (first, last) = (between.then_some("<walls"), between.then_some("<curves"));
    let usual = ["impacts", "periods", "regions", "% stable", "% undecided"];
    let header: Vec<&str> = first.into_iter().chain(usual).chain(last).collect();
    let table = layout.aligned(&header, solutions.iter().map(row));
    format!("\nSolutions with several impacts (data/sequence_regions.csv)\n{table}")
}

/// The curves that the file asks for, each with its extent.
fn own_curves(layout: Layout, description: &Description, unfolded: &Unfolded) -> String {
    let (units, diagram) = (&unfolded.axes.units, &unfolded.diagram);
    let names = [description.primary().name(), description.secondary().name()];
    let requested = diagram.requested.iter().enumerate();
    let each = requested.flat_map(|(number, own)| own.loops.iter().map(move |&loops| (number, own, loops)));
    let entries = each.map(|(number, request, loops)| {
        let own = diagram.own.curves.iter().filter(|found| (found.request, found.loops) == (number, loops));
        let points = own.clone().flat_map(|found| &found.curve.points).map(|point| &point.solution);
        let extent = |shown: &dyn Fn(&PeriodicSolution) -> bool| {
            let places = points.clone().filter(|solution| shown(solution));
            let places: Vec<[f64; 2]> =
                places.map(|solution| units.parameters(solution.parameters())).collect();
            let along = |axis: usize| range(span(places.iter().map(|place| place[axis])));
            (!places.is_empty())
                .then(|| format!("{} from {}, {} from {}", names[1], along(1), names[0], along(0)))
        };
        let stable = extent(&PeriodicSolution::attracts)
            .map_or("nowhere stable".to_owned(), |extent| format!("stable for {extent}"));
        let content = match extent(&PeriodicSolution::admissible) {
            None => "nowhere in the ranges".to_owned(),
            Some(extent) => format!("{extent}; {stable}"),
        };
        (
            format!("  {}, p = {loops}  ", request.name),
            format!("{}: {content}", request.property.with_dimensions(units)),
        )
    });
    let entries: Vec<_> = entries.collect();
    let lost = diagram.own.lost.iter().map(|lost| {
        let name = &diagram.requested[lost.request].name;
        let at = place(description, units.parameters(lost.near));
        (
            format!("  {name}, p = {}  ", lost.loops),
            format!("passes near {at}, but was not located there: {}", lost.reason),
        )
    });
    layout.headed("Curves that the file asks for", entries.into_iter().chain(lost))
}

#[cfg(test)]
mod widths;

#[cfg(test)]
mod tests {
    use super::*;
    use grazing_model::smooth::Stop;
    use grazing_unfold::progress::Silent;
    use grazing_unfold::regions::{Doubt, Region};

    #[test]
    fn undecided_regions_are_listed_with_their_place_and_their_reason() {
        let text = "name = \"Test\"\n[parameters]\n[primary]\nname = \"A\"\nrange = [0.4, 0.8]\n\
                    [secondary]\nname = \"omega\"\nrange = [0.6, 0.7]\n\
                    [motion]\nforce = \"-0.1*v - x - 1 + A*cos(omega*t)\"\nfrequency = \"omega\"\n\
                    [impact]\nrestitution = \"0.8\"\nduration = \"0\"\n[analysis]\nloops = [1]\n";
        let description = Description::parse(text, "test.toml").expect("it is right");
        let unfolded = Unfolded::described(&description, &Silent, &Stop::default(), &|_| ());
        let mut unfolded = unfolded.expect("there is grazing");
        unfolded.diagram.regions.retain(|region| region.doubt.is_none());
        assert!(!results(Layout::default(), &description, &unfolded).contains("not decided"));
        let units = unfolded.axes.units;
        let corner = |primary: f64, secondary: f64| units.without_dimensions([primary, secondary]);
        for doubt in [Doubt::Disagreement, Doubt::UnnamedChange, Doubt::ManyBranches, Doubt::Unseen] {
            let ring = vec![corner(0.5, 0.625), corner(0.75, 0.625), corner(0.75, 0.6875)];
            let region = Region { loops: 1, n: 3, rings: vec![ring], doubt: Some(doubt.clone()) };
            unfolded.diagram.regions.push(region);
            let words = results(Layout::default(), &description, &unfolded).replace('\n', " ");
            let words = words.split_whitespace().collect::<Vec<_>>().join(" ");
            let told = format!("p = 1 from A = 0.5, omega = 0.625 to A = 0.75, omega = 0.6875: {doubt}");
            assert!(
                words.contains("Stability not decided (hatched") && words.contains(&told),
                "{told}: {words}"
            );
        }
    }
}
