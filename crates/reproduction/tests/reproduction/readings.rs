//! Compares readings of one-parameter diagrams with sampled motion and with balances.

use core::f64::consts::TAU;
use std::sync::LazyLock;

use grazing_input::Description;
use grazing_model::motion::Motion;
use grazing_model::smooth::Stop;
use grazing_model::{ImpactOscillator, OnWall};
use grazing_results::branches::OneParameter;
use grazing_results::readings::{MotionReading, Ordinate, Reading, Sweep};
use grazing_unfold::progress::Silent;
use grazing_unfold::unfolded::Unfolded;

/// The mass of the file below.
const MASS: f64 = 2.0;

/// The paper's oscillator with a mass, about the line of Figure 2, and the diagram on that line.
static DESCRIBED: LazyLock<(Description, OneParameter)> = LazyLock::new(|| {
    let paper = include_str!("../../../../examples/paper.toml");
    let about = [("[0.0, 1.2]", "[0.25, 0.37]"), ("[0.3, 1.1]", "[0.84, 0.86]")];
    let narrow = about.iter().fold(paper.to_owned(), |text, (old, new)| text.replacen(old, new, 1));
    let head = narrow.replacen("[impact]", "[impact]\nmass = \"2\"", 1);
    let diagram = "fixed = \"omega\"\nat = 0.855\nrange = [0.26, 0.36]\nordinate = \"mean force\"\nsweeps = true\nimpacts = 4";
    let description = Description::parse(&format!("{head}\n[[diagrams]]\n{diagram}\n"), "weighed.toml");
    let description = description.unwrap_or_else(|error| panic!("{error}"));
    let unfolded = Unfolded::described(&description, &Silent, &Stop::default(), &|_| ());
    let mut diagrams = unfolded.expect("there is grazing").diagrams;
    (description, diagrams.remove(0))
});

#[test]
fn forces_balance_what_else_acts_and_peaks_are_those_of_sampled_motion() {
    let (description, diagram) = &*DESCRIBED;
    let shown: Vec<&Reading> = diagram
        .readings
        .iter()
        .filter(|row| row.impacts == 1 && row.admissible && row.impact_velocity > 0.05)
        .step_by(3)
        .collect();
    assert!(shown.len() > 20 && shown.iter().any(|row| row.loops == 3), "{}", shown.len());
    for row in shown {
        let oscillator = description.oscillator([row.primary, row.secondary]);
        let recoil = oscillator.reset::<1>(OnWall::new(row.impact_velocity, row.impact_phase)).image();
        let motion = oscillator.motion(recoil.into());
        let flight = f64::from(row.loops) * TAU / row.secondary;
        // Simpson's rule.
        let steps = 4000_u32;
        let position = |k: u32| motion.at(flight * f64::from(k) / f64::from(steps)).position;
        let weight = |k: u32| if k == 0 || k == steps { 1.0 } else { 2.0 + 2.0 * f64::from(k % 2) };
        let mean = (0..=steps).map(|k| weight(k) * position(k)).sum::<f64>() / (3.0 * f64::from(steps));
        // Over a cycle the mean of the spring force -x - 1 and that of the wall cancel: damping and
        // forcing have zero mean.
        let spring = -mean - 1.0;
        assert!((row.force - MASS * spring).abs() < 1e-6 * MASS, "{} {} {row:?}", row.force, MASS * spring);
        let lowest = (0..=steps).map(position).fold(0.0, f64::min);
        assert!((row.peak_to_peak + lowest).abs() < 1e-5, "{row:?}");
        // The losses for a restitution of 0.9.
        let power = 0.5 * MASS * (1.0 - 0.81) * row.impact_velocity * row.impact_velocity / flight;
        assert!((row.power - power).abs() < 1e-12, "{row:?}");
    }
}

#[test]
fn simulated_motion_has_the_readings_of_the_solution_that_it_has_come_to() {
    let (_, diagram) = &*DESCRIBED;
    let mut compared = [0; 2];
    let struck = |row: &MotionReading| (row.impacts * row.periods).round();
    let few = |row: &&MotionReading| row.motion == "periodic" && (1.0..=4.0).contains(&struck(row));
    for row in diagram.motion.iter().filter(few) {
        let own = diagram.readings.windows(2).filter(|pair| {
            let across = |k: usize| pair[k].primary - row.primary;
            pair[0].branch == pair[1].branch
                && f64::from(pair[0].loops) == row.periods
                && f64::from(pair[0].impacts) == struck(row)
                && pair[0].stable.is_stable()
                && across(0) * across(1) <= 0.0
        });
        let near = own.map(|pair| {
            let share = (row.primary - pair[0].primary) / (pair[1].primary - pair[0].primary);
            let between = |of: fn(&Reading) -> f64| of(&pair[0]) + share * (of(&pair[1]) - of(&pair[0]));
            let gap = |of: fn(&Reading) -> f64, value: f64| (between(of) - value).abs();
            gap(|row| row.force, row.force)
                + gap(|row| row.power, row.power)
                + gap(|row| row.peak_to_peak, row.peak_to_peak)
        });
        // Readings lie between points of a drawn branch.
        let gap = near.fold(f64::INFINITY, f64::min);
        assert!(gap < 2e-2, "{gap} {row:?}");
        compared[usize::from(struck(row) > 1.5)] += 1;
    }
    assert!(compared.iter().all(|count| *count > 50), "{compared:?}");
    // Without impacts there is no force.
    let free = diagram.motion.iter().find(|row| row.sweep == Sweep::Up && row.motion == "non-impacting");
    assert_eq!(free.map(|row| (row.force, row.power)), Some((0.0, 0.0)));
}

#[test]
fn a_diagram_is_seen_by_its_ordinate() {
    let (_, diagram) = &*DESCRIBED;
    assert_eq!(diagram.ordinate, Ordinate::Force);
    let seen = diagram.seen();
    assert_eq!(seen.branches.len(), diagram.readings.len());
    assert!(
        seen.branches
            .iter()
            .zip(&diagram.readings)
            .all(|(point, row)| point.x.to_bits() == row.force.to_bits())
    );
    for found in seen.bifurcations.iter().filter(|found| found.impacts < 2) {
        let mass_times = found.impact_velocity * MASS * 1.9;
        let force = mass_times / (f64::from(found.loops.max(1)) * TAU / found.secondary);
        assert!((found.x - force).abs() < 1e-9, "{found:?}");
    }
    let highest = seen.attractor.iter().map(|dot| dot.x).fold(0.0, f64::max);
    assert!(seen.frame.y[1] > highest && seen.frame.y[0] < 0.0);
}
