//! Requested curves, compared with simulation, closed forms and one-parameter branches.

use core::f64::consts::{PI, TAU};

use grazing_continuation::curve::{Curve, CurveEnd, Window};
use grazing_continuation::locate::Condition;
use grazing_continuation::mps::{PeriodicSolution, unknown};
use grazing_input::OwnCurve;
use grazing_model::motion::Motion;
use grazing_model::{AnyOscillator, ImpactOscillator, LinearOscillator, OnWall};
use grazing_results::plane::Property;
use grazing_unfold::one_parameter::{Cut, Line};
use grazing_unfold::own_curves::FoundCurve;
use grazing_unfold::progress::Silent;
use grazing_unfold::simulation::{ReturnOutcome, Suspect};
use grazing_unfold::{Diagram, Scope};

use crate::specimens::example;

const ZETA: f64 = 0.02;
const EPSILON: f64 = 0.9;
const WINDOW: Window = Window { primary: [0.0, 1.2], secondary: [0.6, 1.1] };

fn oscillator() -> AnyOscillator {
    AnyOscillator::new(LinearOscillator::new(ZETA, EPSILON, 0.5, 0.8).expect("it is in the domain"))
}

fn diagram(oscillator: &AnyOscillator, scope: &Scope, property: Property) -> Diagram {
    let requested = vec![OwnCurve { name: String::new(), loops: scope.loops.clone(), property }];
    let located =
        Diagram::located(oscillator, scope, &Silent).expect("nobody stops it").requesting(requested);
    let followed = located.follow(&Silent, &|_, _| ());
    let diagram = located.with(followed, &Silent);
    assert!(diagram.own.lost.is_empty(), "{:?}", diagram.own.lost);
    diagram
}

fn scope(loops: &[u32]) -> Scope {
    Scope { window: WINDOW, loops: loops.to_vec(), start: None }
}

/// The solutions of curves, each with its oscillator.
fn solutions<'a>(
    diagram: &'a Diagram,
    curves: &'a [FoundCurve],
) -> impl Iterator<Item = (AnyOscillator, PeriodicSolution)> + 'a {
    let points = curves.iter().flat_map(|found| &found.curve.points).map(|point| point.solution.clone());
    points.map(|solution| (diagram.equations(1).oscillator_at(&solution.unknowns), solution))
}

#[test]
fn along_curves_of_an_impact_velocity_simulated_orbits_hit_the_wall_at_it() {
    let (duffing, whole) = example("duffing.toml");
    let narrow =
        Scope { window: Window { primary: [0.0, 1.0], secondary: [0.5, 1.0] }, loops: vec![1], ..whole };
    for (oscillator, scope) in [(oscillator(), scope(&[1, 2])), (duffing, narrow)] {
        let diagram = diagram(&oscillator, &scope, Property::ImpactVelocity(0.1));
        let mut followed = 0;
        for (oscillator, solution) in solutions(&diagram, &diagram.own.curves) {
            assert_eq!(solution.impact_velocity(), 0.1);
            // Where the solution grazes simulation hits the wall.
            if solution.admissible() && solution.ceiling() < -1e-9 {
                let suspect = Suspect::of(&oscillator, solution.loops, &solution.unknowns);
                assert_eq!(suspect.follow(), ReturnOutcome::Returns, "{solution:?}");
                followed += 1;
            }
        }
        assert!(followed > 100, "{followed}");
    }
}

#[test]
fn curves_of_an_impact_velocity_cross_a_line_where_branches_have_it() {
    // Between the first slices.
    let at = 0.7113;
    let velocity = 0.3;
    let diagram = diagram(&oscillator(), &scope(&[1, 2]), Property::ImpactVelocity(velocity));
    let line = Line { diagram: 1, primary_is_fixed: false, at, range: WINDOW.primary };
    let cut = Cut::follow(&oscillator(), &diagram.scope, &[], line, &Silent).expect("nobody stops it");
    let crossings = |points: Vec<[f64; 2]>, value: f64| -> Vec<f64> {
        let between = |pair: &[[f64; 2]]| {
            let share = (value - pair[0][1]) / (pair[1][1] - pair[0][1]);
            (0.0..1.0).contains(&share).then(|| pair[0][0] + share * (pair[1][0] - pair[0][0]))
        };
        points.windows(2).filter_map(between).collect()
    };
    for loops in [1, 2] {
        let branches = cut.branches().iter().filter(|branch| branch.equations.loops() == loops);
        let on_branches = branches.flat_map(|branch| {
            let place = |solution: &PeriodicSolution| [solution.parameters()[0], solution.impact_velocity()];
            let points = branch.curve.points.iter().map(|point| place(&point.solution));
            crossings(points.collect(), velocity)
        });
        let own = diagram.own.curves.iter().filter(|found| found.loops == loops);
        let on_curves = own.flat_map(|found| crossings(found.curve.parameters(), at));
        let sorted = |mut values: Vec<f64>| {
            values.sort_by(f64::total_cmp);
            values
        };
        let (expected, found) = (sorted(on_branches.collect()), sorted(on_curves.collect()));
        assert!(!expected.is_empty());
        assert_eq!(expected.len(), found.len(), "{loops}: {expected:?} {found:?}");
        for (expected, found) in expected.iter().zip(&found) {
            // The tolerance of chords of drawn curves.
            assert!((expected - found).abs() < 1e-3, "{loops}: {expected} {found}");
        }
    }
}

#[test]
fn where_multipliers_are_complex_a_modulus_is_that_of_the_closed_form() {
    // Between two impacts areas shrink by exp(−2ζ 2πp/ω), by an impact by ε².
    let modulus = 0.75;
    let diagram = diagram(&oscillator(), &scope(&[1, 2]), Property::Modulus(modulus));
    let mut seen = [0; 2];
    for FoundCurve { loops, curve, .. } in &diagram.own.curves {
        let Condition::Product(product) = curve.condition else { continue };
        assert_eq!(product, modulus * modulus);
        let omega = 4.0 * PI * ZETA * f64::from(*loops) / libm::log(EPSILON * EPSILON / product);
        for point in &curve.points {
            let multipliers = point.solution.multipliers;
            assert!(
                multipliers.complex() || multipliers.trace.abs() < 2.0 * modulus + 1e-9,
                "{multipliers:?}"
            );
            assert!((point.solution.unknowns[unknown::SECONDARY] - omega).abs() < 1e-9);
            seen[*loops as usize - 1] += 1;
        }
    }
    assert!(seen[0] > 10, "{seen:?}");
}

#[test]
fn along_curves_of_a_modulus_simulated_perturbations_decay_by_it() {
    let modulus = 0.9;
    let diagram = diagram(&oscillator(), &scope(&[1]), Property::Modulus(modulus));
    let mut pieces = [0, 0];
    for FoundCurve { curve, .. } in &diagram.own.curves {
        let middle = curve.points[curve.points.len() / 2].solution.clone();
        if !middle.admissible() || middle.impact_velocity() < 0.05 {
            continue;
        }
        let oscillator = diagram.equations(1).oscillator_at(&middle.unknowns);
        let simulated = Suspect::of(&oscillator, 1, &middle.unknowns).multipliers();
        let [trace, determinant] = simulated.expect("it returns");
        let root = trace * trace - 4.0 * determinant;
        let larger = if root < 0.0 { determinant.sqrt() } else { 0.5 * (trace.abs() + root.sqrt()) };
        // Differences of displacements of 3e-4.
        assert!((larger - modulus).abs() < 2e-3, "{larger} {middle:?}");
        match curve.condition {
            Condition::Multiplier(multiplier) => pieces[usize::from(multiplier < 0.0)] += 1,
            other => panic!("{other:?}: at these frequencies multipliers are real there"),
        }
    }
    assert!(pieces[0] > 0 && pieces[1] > 0, "{pieces:?}");
}

#[test]
fn pieces_of_a_modulus_meet_where_both_multipliers_are_equal() {
    let diagram = diagram(&oscillator(), &scope(&[1]), Property::Modulus(0.75));
    let curves = diagram.own.curves.iter();
    let ends = curves.flat_map(|found| {
        let Curve { points, beginning, end, .. } = &found.curve;
        let ends = [(points.first(), beginning.as_ref()), (points.last(), Some(end))];
        ends.into_iter().filter(|(_, end)| matches!(end, Some(CurveEnd::Event(_))))
    });
    let corners: Vec<PeriodicSolution> =
        ends.filter_map(|(point, _)| Some(point?.solution.clone())).collect();
    assert!(!corners.is_empty());
    for corner in &corners {
        let multipliers = corner.multipliers;
        // A double zero of the characteristic polynomial.
        let gap = multipliers.trace * multipliers.trace - 4.0 * multipliers.determinant;
        assert!(gap.abs() < 1e-6, "{multipliers:?}");
        let here = corners.iter().filter(|other| (&other.unknowns - &corner.unknowns).norm() < 1e-6);
        assert_eq!(here.count(), 2, "{corner:?}");
    }
}

#[test]
fn along_curves_of_a_distance_motion_is_that_far_from_the_wall_at_the_phase() {
    let (phase, distance) = (2.0, 0.4);
    let diagram = diagram(&oscillator(), &scope(&[1, 2]), Property::Distance { phase, distance });
    let mut seen = [0; 2];
    for (oscillator, solution) in solutions(&diagram, &diagram.own.curves) {
        let [velocity, impact] = [unknown::VELOCITY, unknown::PHASE].map(|k| solution.unknowns[k]);
        let recoil = oscillator.reset::<1>(OnWall::new(velocity, impact)).image();
        let motion = oscillator.motion(recoil.into());
        // The impact takes no time.
        let first = (phase - impact).rem_euclid(TAU);
        let times = (0..solution.loops).map(|turn| first + TAU * f64::from(turn));
        let nearest = times.map(|angle| {
            let time = angle / oscillator.forcing_frequency().value;
            (motion.at(time).position + distance).abs()
        });
        assert!(nearest.fold(f64::INFINITY, f64::min) < 1e-9, "{solution:?}");
        seen[solution.loops as usize - 1] += 1;
    }
    assert!(seen.iter().all(|points| *points > 20), "{seen:?}");
}
