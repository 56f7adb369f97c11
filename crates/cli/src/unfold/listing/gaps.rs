//! Gaps in the diagram: what is missing or unknown, with the reasons.

use grazing_continuation::curve::{Curve, CurveEnd, CurvePoint};
use grazing_input::Description;
use grazing_model::smooth::Units;
use grazing_unfold::Diagram;
use grazing_unfold::diagram::DiagramCurve;
use grazing_unfold::grazing::GrazingEnd;
use grazing_unfold::nothing::place;
use grazing_unfold::own_curves::FoundCurve;
use grazing_unfold::unfolded::Unfolded;

use crate::layout::Layout;
use crate::unfold::reason;

/// The most findings of a kind that are listed one by one.
const LISTED: usize = 5;

/// Entries one by one if they are few; of many, a line that counts them and names the file that has them all.
pub(super) fn few(entries: Vec<(String, String)>, what: &str, file: &str) -> Vec<(String, String)> {
    if entries.len() <= LISTED {
        return entries;
    }
    vec![("  ".to_owned(), format!("{} {what}, in {file}", entries.len()))]
}

/// Resonances that could not be located, or whose curves could not be followed.
pub(super) fn missing(layout: Layout, description: &Description, units: &Units, diagram: &Diagram) -> String {
    let lost = reason::lost(description, units, diagram);
    layout
        .headed("Resonances that could not be unfolded", lost.map(|(what, why)| (format!("  {what}  "), why)))
}

/// What a limit or Ctrl-C has cut off.
pub(super) fn unfinished(
    layout: Layout,
    description: &Description,
    units: &Units,
    diagram: &Diagram,
) -> String {
    let cut = diagram.unfinished.iter();
    layout
        .headed("Not finished", cut.map(|cut| ("  ".to_owned(), reason::unfinished(description, units, cut))))
}

/// Curves that end neither at the edge of the ranges nor at a point of codimension two.
pub(super) fn odd_ends(layout: Layout, description: &Description, unfolded: &Unfolded) -> String {
    let lines = |of: String, curve: &Curve| {
        let ends = [curve.points.first(), curve.points.last()].into_iter().zip(curve.lost());
        let line = |(point, reason): (Option<&CurvePoint>, Option<String>)| {
            let parameters = unfolded.axes.units.parameters(point?.solution.parameters());
            Some((format!("  {of}  "), format!("at {}: {}", place(description, parameters), reason?)))
        };
        ends.filter_map(line).collect::<Vec<_>>()
    };
    let diagram = &unfolded.diagram;
    let bifurcations = diagram.curves.iter().flat_map(|DiagramCurve { kind, loops, n, curve }| {
        lines(format!("{} of p = {loops}, n = {n}", kind.name()), curve)
    });
    let own = diagram.own.curves.iter().flat_map(|FoundCurve { request, loops, curve }| {
        lines(format!("{} of p = {loops}", diagram.requested[*request].name), curve)
    });
    let both = unfolded.sequences.solutions.iter().filter(|found| found.stops.len() > 1);
    let both = both.flat_map(|found| {
        let walls = found.walls(diagram.wall);
        let of = move |curve: &DiagramCurve| {
            format!("{} of walls {walls}, p = {}", curve.kind.name(), curve.loops)
        };
        found.curves.iter().flat_map(|curve| lines(of(curve), &curve.curve)).collect::<Vec<_>>()
    });
    let bifurcations = bifurcations.chain(both);
    let ends = few(bifurcations.collect(), "ends of bifurcation curves; the curves are", "data/curves.csv")
        .into_iter();
    let own = few(own.collect(), "ends of curves that the file asks for; these are", "data/own_curves.csv");
    layout.headed("Curves that end unexpectedly", ends.chain(own))
}

/// Where it is not decided whether solutions are stable, with the reason.
pub(super) fn undecided(layout: Layout, description: &Description, unfolded: &Unfolded) -> String {
    let mut kinds: Vec<(_, Vec<String>)> = Vec::new();
    let own = unfolded.diagram.regions.iter().map(|region| (format!("p = {}", region.loops), region));
    let both = unfolded.sequences.solutions.iter().filter(|found| found.stops.len() > 1);
    let both = both.flat_map(|found| {
        let name = format!("walls {}, p = {}", found.walls(unfolded.diagram.wall), found.periods);
        found.regions.iter().map(move |region| (name.clone(), region))
    });
    for (name, region) in own.chain(both) {
        let Some(doubt) = &region.doubt else { continue };
        let Some(line) = reason::undecided(description, &unfolded.axes.units, region) else { continue };
        let kind = (name, doubt.kind());
        match kinds.iter_mut().find(|(known, ..)| *known == kind) {
            Some((_, alike)) => alike.push(line),
            None => kinds.push((kind, vec![line])),
        }
    }
    let entries = kinds.into_iter().flat_map(|((name, doubt), alike)| {
        let lines = if alike.len() <= LISTED {
            alike
        } else {
            vec![format!("{} regions, in {REGIONS}: {doubt}", alike.len())]
        };
        lines.into_iter().map(move |line| (format!("  {name}  "), line))
    });
    layout.headed("Stability not decided (hatched in the diagram)", entries)
}

/// The table of all regions.
const REGIONS: &str = "data/regions.csv";

/// Regions that are in the diagram but too thin to be seen.
pub(super) fn thin(layout: Layout, description: &Description, unfolded: &Unfolded) -> String {
    let regions = reason::thin(description, &unfolded.axes.units, &unfolded.diagram);
    let entries = regions.into_iter().map(|(loops, line)| (format!("  p = {loops}  "), line));
    let entries = few(entries.collect(), "regions", REGIONS);
    layout.headed(
        &format!("Regions of stability thinner than 1e-4 of the ranges (all are in {REGIONS})"),
        entries,
    )
}

/// The gaps in the diagram that are not due to a limit, as `1 of 3 resonances could not be
/// unfolded`; none if nothing is missing.
pub(crate) fn incomplete(diagram: &Diagram) -> Option<String> {
    let lost = diagram.unlocated.len() + diagram.not_unfolded.len();
    let all = diagram.unlocated.len() + diagram.resonances.len();
    let ends = diagram.curves.iter().flat_map(|curve| curve.curve.beginning.iter().chain([&curve.curve.end]));
    let grazing_ends = diagram.grazing.iter().flat_map(|curve| curve.ends);
    let endless = ends.filter(|end| matches!(end, CurveEnd::StepLimit)).count()
        + grazing_ends.filter(|end| *end == GrazingEnd::StepLimit).count();
    let mut parts = Vec::new();
    if lost > 0 {
        parts.push(format!("{lost} of {all} resonances could not be unfolded"));
    }
    if endless > 0 {
        let ends =
            if endless == 1 { "1 end of a curve was" } else { &format!("{endless} ends of curves were") };
        parts.push(format!("{ends} not reached within the greatest number of points"));
    }
    (!parts.is_empty()).then(|| parts.join(" and "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use grazing_continuation::curve::Window;
    use grazing_continuation::locate::LocateFailure;
    use grazing_continuation::resonance::ResonanceError;
    use grazing_unfold::Scope;
    use grazing_unfold::diagram::NotUnfolded;
    use grazing_unfold::grazing::GrazingCurve;
    use grazing_unfold::own_curves::FoundCurves;
    use grazing_unfold::resonances::Unlocated;
    use grazing_unfold::unfinished::Unfinished;

    #[test]
    fn resonances_that_could_not_be_unfolded_are_named_with_the_reason() {
        let description =
            Description::parse(include_str!("../../../../../examples/duffing.toml"), "examples/duffing.toml")
                .unwrap();
        let window = Window { primary: [0.0, 1.0], secondary: [0.0, 1.0] };
        let failure = LocateFailure::Elsewhere { distance: 0.5, step: 0.001 };
        let diagram = Diagram {
            scope: Scope { window, loops: vec![1], start: None },
            oscillator: description.oscillator([0.5, 0.75]),
            wall: 0,
            grazing: Vec::new(),
            doubled: Vec::new(),
            no_grazing: None,
            resonances: Vec::new(),
            one_loop: Vec::new(),
            curves: Vec::new(),
            codimension_two: Vec::new(),
            regions: Vec::new(),
            requested: Vec::new(),
            own: FoundCurves::default(),
            unlocated: vec![Unlocated {
                loops: 1,
                near: [0.25, 0.5],
                reason: ResonanceError::NotLocated(failure),
            }],
            not_unfolded: vec![NotUnfolded {
                solutions: 2,
                loops: 2,
                n: 3,
                reason: ResonanceError::NotStarted {
                    curve: "saddle-node",
                    reason: "it ends at once".to_owned(),
                },
            }],
            unfinished: vec![Unfinished {
                stage: "bifurcation curves".into(),
                resonance: Some([2, 1]),
                at: Some([0.5, 0.75]),
            }],
        };
        let cut = unfinished(Layout::default(), &description, &Units::ONE, &diagram);
        assert_eq!(cut, "\nNot finished\n  bifurcation curves of p = 2, n = 1 at A = 0.5, omega = 0.75\n");
        let line = missing(Layout::default(), &description, &Units::ONE, &diagram);
        let words = line.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(
            words,
            "Resonances that could not be unfolded \
             p = 1 near A = 0.25, omega = 0.5: the resonance was not located: the point found lies 5.0e-1 away, on a step \
             of length 1.0e-3 \
             p = 2, n = 3 the saddle-node curve cannot be started: it ends at once"
        );
        assert_eq!(incomplete(&diagram).as_deref(), Some("2 of 1 resonances could not be unfolded"));
        let endless = GrazingCurve {
            states: Vec::new(),
            ends: [GrazingEnd::LeftWindow, GrazingEnd::StepLimit],
            periods: 1,
        };
        let endless =
            Diagram { unlocated: Vec::new(), not_unfolded: Vec::new(), grazing: vec![endless], ..diagram };
        assert_eq!(missing(Layout::default(), &description, &Units::ONE, &endless), "");
        assert_eq!(
            incomplete(&endless).as_deref(),
            Some("1 end of a curve was not reached within the greatest number of points")
        );
        assert_eq!(incomplete(&Diagram { grazing: Vec::new(), ..endless }), None);
    }
}
