//! Lines about an oscillator and its resonances on the terminal.

mod gaps;
mod one_parameter;
mod window;

use std::path::Path;

use grazing_analysis::along::{along_curve, forgotten};
use grazing_analysis::nothing::place;
use grazing_analysis::sequences::walls;
use grazing_analysis::unfolded::{AtResonance, CurveFinding, curves};
use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::mps::PeriodicSolution;
use grazing_input::{Axis, Description};
use grazing_results::{Stability, brief, span, with_unit};
use grazing_unfold::Diagram;
use grazing_unfold::grazing::{GrazingCurve, GrazingEnd, GrazingState};
use grazing_unfold::resonances;
use grazing_unfold::sequences::Sequence;
use grazing_unfold::units::InUnits;
use grazing_unfold::verdict::Verdict;
use grazing_unfold::verification::Simulated;

use super::analysis::Analysis;
use super::numbers::{fixed, range, significant};
use crate::layout::{KEPT, Layout};
pub(crate) use gaps::incomplete;
use gaps::{few, missing, odd_ends, thin, undecided, unfinished};
pub(crate) use one_parameter::one_parameter;

/// Digits of parameters, of coefficients, and of other quantities.
const PARAMETER: usize = 8;
const COEFFICIENT: usize = 9;
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
    let notes = description.notes().iter().map(|note| ("note", note.clone()));
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
pub(crate) fn results(layout: Layout, description: &Description, unfolded: &Analysis) -> String {
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

fn grazing_curves(layout: Layout, description: &Description, unfolded: &Analysis) -> String {
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
fn stability(state: &GrazingState) -> &'static str {
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

/// Resonances at which a theorem holds, and the coefficients there.
fn resonances(layout: Layout, description: &Description, unfolded: &Analysis) -> String {
    let (primary, secondary) = (description.primary().name(), description.secondary().name());
    let [secondary_head, primary_head] = parameter_heads(description);
    let all = &unfolded.resonances;
    if all.is_empty() {
        let loops = loops(description);
        let searched = !unfolded.diagram.unfinished.iter().any(|part| part.stage == resonances::STAGE);
        let found = if searched { "none on the grazing curve" } else { "the search was not finished" };
        return format!("\nResonant grazing bifurcations\n  {found} for p = {loops}\n");
    }
    let found: Vec<&AtResonance> = all.iter().filter(|at| at.curves.is_some()).collect();
    let heading = format!(
        "Resonant grazing bifurcations: {}; Theorem 2.4 (p = 1) or 2.5 (p >= 2) applies at {} of them",
        all.len(),
        found.len()
    );
    let mut text = format!("\n{}", layout.wrapped("", &heading));
    if found.is_empty() {
        return text;
    }
    let rows = found.iter().map(|at| {
        let ([mu, eta], grazing) = (at.parameters, &at.point.grazing);
        let mut row = vec![at.loops.to_string(), at.n.to_string()];
        row.extend([eta, mu].map(|value| significant(value, PARAMETER)));
        // Where p = 2, tau is zero but for rounding.
        row.extend([grazing.map.trace(), grazing.map.determinant()].map(|value| fixed(value, QUANTITY)));
        row.extend([grazing.alpha(), grazing.map.transversality()].map(|value| significant(value, QUANTITY)));
        row
    });
    let names = &unfolded.axes.names;
    let beta = with_unit("beta", names.named_unit("length/{primary}").as_deref());
    let header = ["p", "n", &secondary_head, &primary_head, "tau", "delta", "alpha", &beta];
    text.push_str(&layout.aligned(&header, rows));
    text.push('\n');
    let formula = format!("{primary} = {primary}_graz({secondary}) + c eta^2 + ...,").replace(' ', KEPT);
    let content = format!(
        "{formula} where eta is {secondary} minus its value at the resonance; digits: how many of both values of c agree; \
         simulation: whether it agrees with the theorem"
    );
    text.push_str(&layout.wrapped("SN and PD curves:  ", &content));
    let unit_of_c = names.named_unit("{primary}/{secondary}^2");
    let [theorem, measured] = ["c (theorem)", "c (measured)"].map(|head| match &unit_of_c {
        Some(unit) => head.replace(')', &format!(", {unit})")),
        None => head.to_owned(),
    });
    let header = ["p", "n", &secondary_head, "curve", &theorem, &measured, "digits", "simulation"];
    text.push_str(&layout.aligned(&header, curves(all).map(coefficient)));
    text.extend(curves(all).map(|curve| reasons(layout, secondary, curve)));
    text
}

/// An SN or PD curve with what is known of it, and the resonance that it leaves.
type CurveAt<'a> = (&'a AtResonance, Bifurcation, &'a CurveFinding);

/// Why a coefficient was not measured or simulation is not as predicted; nothing if all is well.
fn reasons(layout: Layout, secondary: &str, (at, kind, known): CurveAt<'_>) -> String {
    let mark = format!(
        "  p = {}, n = {}, {secondary} = {}, {}:  ",
        at.loops,
        at.n,
        significant(at.parameters[1], QUANTITY),
        kind.name()
    );
    known.doubts().map(|(doubt, reason)| layout.wrapped(&mark, &format!("{doubt}: {reason}"))).collect()
}

/// A sentence for every coefficient and simulation that contradicts the theorem.
pub(crate) fn contradictions(resonances: &[AtResonance]) -> Vec<String> {
    let mut found = Vec::new();
    for (at, kind, CurveFinding { coefficient, simulated }) in curves(resonances) {
        let what = format!("p = {}, n = {}", at.loops, at.n);
        if let (Verdict::Contradict, Ok(fit)) = (coefficient.verdict(), &coefficient.fit) {
            let number = |value: f64| brief(value, COEFFICIENT);
            found.push(format!(
                "{what}: c_{} is {} by the theorem (error {:.0e}) but {} on the continued curve (error {:.0e})",
                kind.name(),
                number(coefficient.theorem.value),
                coefficient.theorem.error,
                number(fit.coefficient.value),
                fit.coefficient.error
            ));
        }
        if let Simulated::Against(sides) = simulated {
            found.push(format!("{what}: beside the {} curve, {sides}", kind.name()));
        }
    }
    found
}

/// The row of a coefficient: by the theorem, measured, and whether simulation agrees.
fn coefficient((at, kind, CurveFinding { coefficient, simulated }): CurveAt<'_>) -> Vec<String> {
    let theorem = coefficient.theorem.value;
    let (measured, digits) = match coefficient.compared() {
        Some((value, digits)) => (significant(value, COEFFICIENT), digits.to_string()),
        None => (coefficient.verdict().name().to_owned(), "-".to_owned()),
    };
    vec![
        at.loops.to_string(),
        at.n.to_string(),
        // Enough to tell resonances with the same p and n apart.
        significant(at.parameters[1], QUANTITY),
        kind.name().to_owned(),
        significant(theorem, COEFFICIENT),
        measured,
        digits,
        simulated.name().to_owned(),
    ]
}

/// Resonances at which no theorem applies, with the hypotheses that fail and their values.
fn failing_theorems(layout: Layout, description: &Description, unfolded: &Analysis) -> String {
    let failing = unfolded.resonances.iter().filter(|at| at.curves.is_none());
    let entries = failing.map(|at| {
        let failing: Vec<String> = at.failing().collect();
        let content = format!("{}: {}", place(description, at.parameters), failing.join(", "));
        (format!("  p = {}, n = {}  ", at.loops, at.n), content)
    });
    let entries = few(entries.collect(), "resonances", "data/hypotheses.csv");
    layout.headed("Resonances at which the theorem does not apply (no curves are followed there)", entries)
}

fn corners(layout: Layout, description: &Description, unfolded: &Analysis) -> String {
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
fn several_impacts(layout: Layout, unfolded: &Analysis) -> String {
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
        let walls = between.then(|| walls(found, *wall));
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
fn own_curves(layout: Layout, description: &Description, unfolded: &Analysis) -> String {
    let (units, diagram) = (&unfolded.axes.units, &unfolded.diagram);
    let names = [description.primary().name(), description.secondary().name()];
    let levels = diagram.asked.iter().enumerate();
    let each =
        levels.flat_map(|(number, level)| level.loops.iter().map(move |&loops| (number, level, loops)));
    let entries = each.map(|(number, level, loops)| {
        let own = diagram.levels.curves.iter().filter(|found| found.level == number && found.loops == loops);
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
        (format!("  {}, p = {loops}  ", level.name), format!("{}: {content}", level.property.in_units(units)))
    });
    let entries: Vec<_> = entries.collect();
    let lost = diagram.levels.lost.iter().map(|lost| {
        let name = &diagram.asked[lost.level].name;
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
    use grazing_analysis::unfolded::{Curves, Unfolded};
    use grazing_continuation::bifurcation::Pair;
    use grazing_continuation::curve::Window;
    use grazing_continuation::fit::{Estimate, Measurement};
    use grazing_model::smooth::Stop;
    use grazing_theorems::LinearOscillator;
    use grazing_theorems::hypothesis::Theorem;
    use grazing_unfold::progress::Silent;
    use grazing_unfold::regions::{Doubt, Region};
    use grazing_unfold::simulation::ReturnOutcome;
    use grazing_unfold::verdict::{Coefficient, Obstacle, Verdict};
    use grazing_unfold::verification::{Inconclusive, Sides};

    /// A resonance whose saddle-node coefficient is measured with an error, and what simulation
    /// shows beside that curve.
    fn resonance(error: f64, simulated: Simulated) -> AtResonance {
        let finding = |error, simulated| CurveFinding {
            coefficient: Coefficient {
                stability: 1.0,
                theorem: Estimate { value: -2.5, error: 1e-9 },
                fit: Ok(Measurement {
                    coefficient: Estimate { value: -2.25, error },
                    eta: [1.0, 0.0],
                    mu: [-2.25, 0.0],
                    velocity: 0.01,
                }),
            },
            simulated,
        };
        let undecided = Simulated::Undecided(Inconclusive::NotMeasured);
        let findings =
            Pair { saddle_node: finding(error, simulated), period_doubling: finding(1.0, undecided) };
        let window = Window { primary: [0.0, 1.0], secondary: [0.0, 1.0] };
        let point = LinearOscillator::new(0.05, 0.8).and_then(|oscillator| oscillator.resonance(2, 3));
        AtResonance {
            loops: 2,
            wall: 0,
            n: 3,
            parameters: [0.5, 0.75],
            point: point.expect("they are in the domain").resonant_point(),
            theorem: Theorem::ResonantMultiLoop,
            hypotheses: Vec::new(),
            curves: Some(Curves {
                findings,
                doubled_grazing: f64::NAN,
                window,
                magnified: Vec::new(),
                straightened: Vec::new(),
            }),
        }
    }

    #[test]
    fn contradictions_are_told_with_both_values_and_errors_and_doubts_with_their_reasons() {
        let sides = Sides {
            velocity: 0.001,
            predicted: [false, true],
            seen: [ReturnOutcome::Returns; 2],
            attracts: [Some(false); 2],
            gone_beyond: Some(true),
        };
        let bad = resonance(1e-7, Simulated::Against(sides));
        let words = contradictions(std::slice::from_ref(&bad));
        let file = std::path::Path::new("test.toml");
        for missing in [None, Some("something is missing".to_owned())] {
            let failure = super::super::verdict(file, std::slice::from_ref(&bad), missing);
            assert_eq!(failure.expect_err("it is contradicted").exit_code(), 1);
        }
        assert_eq!(
            words,
            [
                "p = 2, n = 3: c_SN is -2.5 by the theorem (error 1e-9) but -2.25 on the continued curve (error 1e-7)",
                "p = 2, n = 3: beside the SN curve, at impact velocity 1e-3 the faster solution is predicted to be stable \
                 but repels",
            ]
        );
        let doubtful =
            resonance(1.0, Simulated::Undecided(Inconclusive::TooSlow { leading: 1e-9, least: 1e-6 }));
        assert!(contradictions(std::slice::from_ref(&doubtful)).is_empty());
        assert!(super::super::verdict(file, std::slice::from_ref(&doubtful), None).is_ok());
        let doubtful = [doubtful];
        let curve = curves(&doubtful).next().expect("the theorem applies");
        assert!(matches!(curve.2.coefficient.verdict(), Verdict::NotMeasurable(Obstacle::Rounding { .. })));
        let words = reasons(Layout::default(), "omega", curve);
        for wanted in
            ["p = 2, n = 3, omega = 0.75000, SN:  not measurable: where", "simulation undecided: the leading"]
        {
            assert!(words.contains(wanted), "{words}");
        }
    }

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
