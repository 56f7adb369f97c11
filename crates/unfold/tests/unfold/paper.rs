//! The paper's oscillator from its text file, integrated, compared with its closed form: Figures 2,
//! 7 and 8 to 10⁻⁸.
//!
//! Both go through the same search, continuation and magnification. Every point of the integrated
//! oscillator is then solved for with the closed form, holding that one of y, μ and η that changes
//! most along the curve.

use std::sync::LazyLock;

use core::f64::consts::TAU;

use grazing_continuation::arclength::StepControl;
use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::{Curve, CurveEnd, Route, SolutionCurve, Window};
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns, unknown};
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::ImpactOscillator;
use grazing_results::plane::{CurveSource, MagnifiedPoint};
use grazing_unfold::diagram::route;
use grazing_unfold::magnification::magnify;
use grazing_unfold::progress::Silent;
use grazing_unfold::resonances::FoundResonance;
use grazing_unfold::{Diagram, Scope};
use rayon::prelude::*;

use crate::specimens::{EPSILON, ZETA, assert_within, closed_form, example, file, grazing_at};

/// Tolerance: integration and Newton's method leave far less, magnified where a curve is
/// ill-conditioned.
const AGREEMENT: f64 = 1e-8;

pub(crate) static PARAMETERS: LazyLock<toml::Table> =
    LazyLock::new(|| std::fs::read_to_string(file("figures/parameters.toml")).unwrap().parse().unwrap());

fn number(value: &toml::Value) -> f64 {
    value.as_float().unwrap()
}

fn range(table: &toml::Value, key: &str) -> [f64; 2] {
    let ends = table[key].as_array().unwrap();
    [number(&ends[0]), number(&ends[1])]
}

fn window(table: &toml::Value) -> Window {
    Window { primary: range(table, "amplitude"), secondary: range(table, "frequency") }
}

fn loops(table: &toml::Value) -> Vec<u32> {
    table["loops"].as_array().unwrap().iter().map(|p| p.as_integer().unwrap() as u32).collect()
}

/// The cells of a committed table, row by row, by the names of its columns.
fn rows(name: &str, columns: &[&str]) -> Vec<Vec<String>> {
    let text = std::fs::read_to_string(file("figures/data").join(name)).unwrap();
    let mut lines = text.lines();
    let names: Vec<_> = lines.next().unwrap().split(',').collect();
    let places: Vec<_> =
        columns.iter().map(|column| names.iter().position(|name| name == column).unwrap()).collect();
    lines
        .map(|line| {
            let cells: Vec<_> = line.split(',').collect();
            places.iter().map(|place| cells[*place].to_owned()).collect()
        })
        .collect()
}

/// The diagram of Figure 7, integrated and in closed form.
static DIAGRAMS: LazyLock<(Diagram, Diagram)> = LazyLock::new(|| {
    let (oscillator, _) = example("paper.toml");
    let figure = &PARAMETERS["fig07"];
    let scope = Scope { window: window(figure), loops: loops(figure), start: None };
    let integrated = Diagram::compute(&oscillator, &scope, &Silent).unwrap();
    (integrated, Diagram::compute(&closed_form(), &scope, &Silent).unwrap())
});

#[track_caller]
fn assert_same(integrated: &Unknowns, closed: &Unknowns) {
    let mut gap = integrated - closed;
    gap[unknown::PHASE] = libm::remainder(gap[unknown::PHASE], TAU);
    assert_within(gap.amax(), 0.0, AGREEMENT);
}

/// The conditions that hold y, μ or η, first the one that changes most along the curve at a point.
fn held(before: &Unknowns, here: &Unknowns, after: &Unknowns) -> [Condition; 3] {
    let gap = after - before;
    let change = [0, 1, 2, 3].map(|index: usize| gap[index].abs());
    let mut held = [
        (change[unknown::VELOCITY], Condition::ImpactVelocity(here[unknown::VELOCITY])),
        (change[unknown::PRIMARY], Condition::Primary(here[unknown::PRIMARY])),
        (change[unknown::SECONDARY], Condition::Secondary(here[unknown::SECONDARY])),
    ];
    held.sort_by(|a, b| b.0.total_cmp(&a.0));
    held.map(|(_, condition)| condition)
}

/// Checks that every point of a curve with y > 0 lies on the curve of the closed form; returns
/// their number.
///
/// Integrated motion is followed without virtual points all the way.
fn assert_on_closed_form(curve: &Curve, loops: u32) -> usize {
    let equations = LoopEquations::new(closed_form(), loops, Formulation::FixedPhase);
    let unknowns: Vec<_> = curve.points.iter().map(|point| point.solution.unknowns.clone()).collect();
    let mut compared = 0;
    for (index, point) in curve.points.iter().enumerate() {
        let here = unknowns[index].clone();
        // At y = 0 the curve of interior grazing is singular; resonances and ends are compared as
        // points.
        if here[unknown::VELOCITY] == 0.0 {
            continue;
        }
        let after = &unknowns[(index + 1).min(unknowns.len() - 1)];
        let [most, ..] = held(&unknowns[index.max(1) - 1], &here, after);
        let mut times = point.times.clone();
        let found = locate(&equations, [curve.condition, most], here.clone(), &mut times)
            .unwrap_or_else(|failure| panic!("{:?} at {here:?}: {failure}", curve.condition));
        assert_same(&here, &found);
        compared += 1;
    }
    compared
}

#[test]
fn the_text_file_has_the_constants_of_the_figures() {
    let shared = &PARAMETERS["oscillator"];
    assert_eq!([number(&shared["zeta"]), number(&shared["epsilon"])], [ZETA, EPSILON]);
    let description = crate::specimens::described_example("paper.toml");
    let constants: Vec<_> = description.constants().collect();
    assert_eq!(constants, [("epsilon", EPSILON), ("zeta", ZETA)]);
}

#[test]
fn grazing_and_resonances_of_figure_7_are_those_of_the_closed_form() {
    let (integrated, closed) = &*DIAGRAMS;
    let [curve] = integrated.grazing.as_slice() else { panic!("{} pieces", integrated.grazing.len()) };
    for state in &curve.states {
        let [amplitude, frequency] = state.orbit.oscillator().parameters();
        assert_within(amplitude, grazing_at(ZETA, frequency).amplitude(), AGREEMENT);
        let gap = state.orbit.phase() - grazing_at(ZETA, frequency).phase();
        assert_within(libm::remainder(gap, TAU), 0.0, AGREEMENT);
        assert!(state.multipliers.stable() && state.admissible);
    }
    assert!(integrated.unlocated.is_empty() && integrated.not_unfolded.is_empty());
    assert_eq!(integrated.resonances.len(), closed.resonances.len());
    for (ours, theirs) in integrated.resonances.iter().zip(&closed.resonances) {
        assert_eq!((ours.loops, ours.n), (theirs.loops, theirs.n));
        let [a, b] = [
            ours.located.orbit().oscillator().parameters(),
            theirs.located.orbit().oscillator().parameters(),
        ];
        assert_within(a[0], b[0], AGREEMENT);
        assert_within(a[1], b[1], AGREEMENT);
        assert_eq!(ours.theorem.is_ok(), theirs.theorem.is_ok());
        let (Ok(ours), Ok(theirs)) = (&ours.theorem, &theirs.theorem) else { continue };
        let [a, b] = [ours.theorem(), theirs.theorem()]
            .map(|theorem| [theorem.saddle_node().coefficient, theorem.period_doubling().coefficient]);
        for (a, b) in a.into_iter().zip(b) {
            assert_within(a / b, 1.0, AGREEMENT);
        }
    }
}

#[test]
fn curves_of_figure_7_lie_on_those_of_the_closed_form() {
    let (integrated, closed) = &*DIAGRAMS;
    let kind = |diagram: &[grazing_unfold::diagram::DiagramCurve]| -> Vec<_> {
        diagram.iter().map(|curve| (curve.kind, curve.loops, curve.n)).collect()
    };
    assert_eq!(kind(&integrated.curves), kind(&closed.curves));
    let compared: usize =
        integrated.curves.par_iter().map(|curve| assert_on_closed_form(&curve.curve, curve.loops)).sum();
    let points: usize = integrated.curves.iter().map(|curve| curve.curve.points.len()).sum();
    // At most two ends of a curve have y = 0.
    assert!(compared + 2 * integrated.curves.len() >= points);
    for (ours, theirs) in integrated.curves.iter().zip(&closed.curves) {
        assert_eq!(std::mem::discriminant(&ours.curve.end), std::mem::discriminant(&theirs.curve.end));
        assert!(!matches!(ours.curve.end, CurveEnd::Stalled(_) | CurveEnd::StepLimit));
        let [a, b] = [&ours.curve, &theirs.curve].map(|curve| curve.points.last().unwrap().solution.clone());
        assert_same(&a.unknowns, &b.unknowns);
    }
}

#[test]
fn points_of_figure_7_are_the_committed_ones() {
    let (integrated, closed) = &*DIAGRAMS;
    let mut ours: Vec<(String, [f64; 2])> = integrated
        .unfolding()
        .map(|(resonance, point)| {
            (
                format!("resonance {} {}", resonance.loops, resonance.n),
                point.orbit().oscillator().parameters(),
            )
        })
        .collect();
    assert_eq!(integrated.codimension_two.len(), closed.codimension_two.len());
    for (corner, theirs) in integrated.codimension_two.iter().zip(&closed.codimension_two) {
        assert_eq!(
            (corner.kind.name(), corner.loops, corner.n),
            (theirs.kind.name(), theirs.loops, theirs.n)
        );
        assert_same(&corner.unknowns(), &theirs.unknowns());
        let [_, _, primary, secondary] = corner.unknowns().into();
        ours.push((format!("{} {} {}", corner.kind.name(), corner.loops, corner.n), [primary, secondary]));
    }
    let committed = rows("fig07_points.csv", &["kind", "p", "n", "amplitude", "omega"]);
    assert_eq!(committed.len(), ours.len());
    for row in committed {
        let name = row[..3].join(" ");
        let at: [f64; 2] = [3, 4].map(|place| row[place].parse().unwrap());
        let distance = |place: &[f64; 2]| libm::hypot(place[0] - at[0], place[1] - at[1]);
        // Several points have the same name where they belong to no resonance of their own p.
        let named = ours.iter().filter(|(known, _)| *known == name).map(|(_, place)| distance(place));
        assert_within(named.fold(f64::INFINITY, f64::min), 0.0, AGREEMENT);
    }
}

/// A resonance of a diagram and the theorem that holds there.
fn resonance(diagram: &Diagram, loops: u32, n: u32) -> (&FoundResonance, &ResonantGrazingPoint) {
    diagram.unfolding().find(|(found, _)| (found.loops, found.n) == (loops, n)).unwrap()
}

/// A curve of a magnification: its kind and its source, and its points (μ, η).
type Line = ((Bifurcation, CurveSource), Vec<[f64; 2]>);

/// The curves of a magnification.
fn lines(points: &[MagnifiedPoint]) -> Vec<Line> {
    let place = |point: &MagnifiedPoint| [point.primary, point.secondary];
    let lines = points.chunk_by(|a, b| a.arc == b.arc);
    lines.map(|line| ((line[0].kind, line[0].source), line.iter().map(place).collect())).collect()
}

/// Checks that the points of a line lie on one of the curves of a kind in closed form, of which
/// many points are known; returns the number of points compared.
fn assert_near(line: &[[f64; 2]], condition: Condition, known: &[&Curve], loops: u32) -> usize {
    let mut compared = 0;
    for (index, here) in line.iter().enumerate() {
        let gap = |unknowns: &Unknowns| {
            libm::hypot(unknowns[unknown::PRIMARY] - here[0], unknowns[unknown::SECONDARY] - here[1])
        };
        let nearest = known
            .iter()
            .flat_map(|curve| &curve.points)
            .min_by(|a, b| gap(&a.solution.unknowns).total_cmp(&gap(&b.solution.unknowns)))
            .unwrap();
        let start = nearest.solution.unknowns.clone();
        // The steps of both are the same up to rounding, mostly.
        if gap(&start) < AGREEMENT {
            compared += 1;
            continue;
        }
        // At the resonance y = 0, which is compared elsewhere.
        if start[unknown::VELOCITY] == 0.0 {
            continue;
        }
        let last = line.len() - 1;
        let [before, after] = [line[index.max(1) - 1], line[(index + 1).min(last)]];
        let steep = (after[0] - before[0]).abs() > (after[1] - before[1]).abs();
        let most = if steep { Condition::Primary(here[0]) } else { Condition::Secondary(here[1]) };
        let equations = LoopEquations::new(closed_form(), loops, Formulation::FixedPhase);
        let found = locate(&equations, [condition, most], start, &mut nearest.times.clone()).unwrap();
        assert_within(gap(&found), 0.0, AGREEMENT);
        compared += 1;
    }
    compared
}

#[test]
fn magnified_curves_of_figure_8_lie_on_those_of_the_closed_form() {
    let (integrated, closed) = &*DIAGRAMS;
    let panels = PARAMETERS["fig08"]["panels"].as_array().unwrap();
    assert_eq!(panels.len(), 3);
    panels.par_iter().for_each(|panel| {
        let [loops, n] = ["loops", "n"].map(|key| panel[key].as_integer().unwrap() as u32);
        let window = window(&panel["near"]);
        let (found, point) = resonance(integrated, loops, n);
        let (theirs, closed_point) = resonance(closed, loops, n);
        let ours = lines(&magnify(integrated, found, point, window).unwrap());
        let closed_lines = lines(&magnify(closed, theirs, closed_point, window).unwrap());
        let shape = |lines: &[Line]| -> Vec<_> { lines.iter().map(|(what, _)| *what).collect() };
        assert_eq!(shape(&ours), shape(&closed_lines));
        // Steps such that Newton's method has a short way from the nearest point.
        let control =
            StepControl { first: 1e-4, longest: 4e-3, shortest: 1e-9, turn: 0.02, ..StepControl::DRAWING };
        let unfolded = closed_point.unfold(&route(window, control)).unwrap();
        let mut own = vec![Bifurcation::SaddleNode, Bifurcation::PeriodDoubling, Bifurcation::Grazing];
        for ((what, line), (_, theirs)) in ours.iter().zip(&closed_lines) {
            let kind = match *what {
                (Bifurcation::NonImpactingGrazing, _) => {
                    for [amplitude, frequency] in line {
                        assert_within(*amplitude, grazing_at(ZETA, *frequency).amplitude(), AGREEMENT);
                    }
                    continue;
                }
                (_, CurveSource::Quadratic) => {
                    // Sampled at the same η; the last sample may lie on either side of the edge.
                    assert!(
                        line.len().abs_diff(theirs.len()) <= 1 && line.len() > 10,
                        "{} {}",
                        line.len(),
                        theirs.len()
                    );
                    for (a, b) in line.iter().zip(theirs) {
                        assert_within(a[0], b[0], AGREEMENT);
                        assert_within(a[1], b[1], AGREEMENT);
                    }
                    continue;
                }
                (kind, CurveSource::Continuation) => kind,
            };
            // A resonance's own curves are followed by those of its neighbours, which are curves of
            // Figure 7.
            let Some(place) = own.iter().position(|own| *own == kind) else { continue };
            own.remove(place);
            let (condition, known): (_, Vec<&Curve>) = match kind {
                Bifurcation::SaddleNode => (Condition::SADDLE_NODE, vec![&unfolded.saddle_node]),
                Bifurcation::PeriodDoubling => (Condition::PERIOD_DOUBLING, vec![&unfolded.period_doubling]),
                _ => (Condition::InteriorGrazing, unfolded.grazing.iter().collect()),
            };
            if !known.is_empty() {
                let compared = assert_near(line, condition, &known, loops);
                assert!(compared + 5 >= line.len() && compared > 5, "{kind:?} {compared} {}", line.len());
            }
        }
    });
}

#[test]
fn branches_and_bifurcations_of_figure_2_are_those_of_the_closed_form() {
    let figure = &PARAMETERS["fig02"];
    let frequency = number(&figure["frequency"]);
    let window = Window { primary: range(figure, "near"), secondary: [0.0, f64::INFINITY] };
    let route = Route { stop_at_events: false, ..route(window, StepControl::DRAWING) };
    let grazing = grazing_at(ZETA, frequency);
    let start = Unknowns::new(0.0, grazing.phase(), grazing.amplitude(), frequency);
    let (integrated, _) = example("paper.toml");
    let follow = |loops| {
        let equations = LoopEquations::new(integrated.clone(), loops, Formulation::Vivid);
        let curve = SolutionCurve { equations, condition: Condition::Secondary(frequency) };
        curve.follow(start, Unknowns::new(1.0, 0.0, 0.0, 0.0), EventTimes::default(), &route).unwrap()
    };
    let branches: Vec<_> =
        loops(figure).into_par_iter().map(|loops| (loops, follow.clone()(loops))).collect();
    let mut bifurcations = vec![("graz".to_owned(), 0, grazing.amplitude(), 0.0)];
    for (loops, curve) in &branches {
        // All points but the start.
        assert_eq!(assert_on_closed_form(curve, *loops), curve.points.len() - 1);
        let equations = LoopEquations::new(closed_form(), *loops, Formulation::Vivid);
        let written = LoopEquations::new(integrated.clone(), *loops, Formulation::Vivid);
        for point in &curve.points {
            let [ours, theirs] = [
                written.visits(&point.solution.unknowns, &point.times),
                equations.visits(&point.solution.unknowns, &point.times),
            ];
            // Beyond the end of VIVID a loop has no point on Π in either form.
            assert_eq!(ours.is_ok(), theirs.is_ok());
            for (ours, theirs) in ours.into_iter().flatten().zip(theirs.into_iter().flatten()) {
                assert_within((ours - theirs).amax(), 0.0, AGREEMENT);
            }
        }
        for event in curve.events.iter().filter(|event| event.solution.admissible()) {
            let Some(kind) = Bifurcation::of(event.condition, *loops) else { continue };
            let unknowns = event.solution.unknowns.clone();
            bifurcations.push((
                kind.name().to_owned(),
                *loops,
                unknowns[unknown::PRIMARY],
                unknowns[unknown::VELOCITY],
            ));
        }
    }
    let committed = rows("fig02_bifurcations.csv", &["kind", "p", "amplitude", "impact_velocity"]);
    assert_eq!(committed.len(), bifurcations.len());
    for (ours, row) in bifurcations.iter().zip(committed) {
        assert_eq!((ours.0.as_str(), ours.1), (row[0].as_str(), row[1].parse().unwrap()));
        assert_within(ours.2, row[2].parse().unwrap(), AGREEMENT);
        assert_within(ours.3, row[3].parse().unwrap(), AGREEMENT);
    }
}
