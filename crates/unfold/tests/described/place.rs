//! Motion at a place, integrated and in closed form, and what its attractors and basins cost.

use std::collections::BTreeMap;
use std::sync::Mutex;

use grazing_input::Description;
use grazing_model::smooth::{Stop, Stoppable};
use grazing_model::{AnyOscillator, ImpactOscillator, LinearOscillator};
use grazing_unfold::described::{Axes, Prepared};
use grazing_unfold::long_time::MotionKind;
use grazing_unfold::place::simulated;
use grazing_unfold::place::{Place, Starts};
use grazing_unfold::progress::Progress;

#[test]
fn simulated_motion_in_closed_form_is_that_which_is_integrated() {
    let text = include_str!("../../../../examples/paper.toml");
    let (description, stop) = (Description::parse(text, "paper.toml").expect("it is right"), Stop::default());
    let integrated = Prepared::of(&description, &stop);
    let oscillator = LinearOscillator::new(0.02, 0.9, 0.5, 0.8).expect("it is in the domain");
    let closed = Prepared {
        oscillator: AnyOscillator::new(Stoppable::new(oscillator, stop.clone())),
        ..Prepared::new(&description, Axes::of_the_paper(), &stop)
    };
    let (place, start) = ([0.8, 0.8], [-1.0, 0.1, 0.3]);
    let [a, b] = [&closed, &integrated].map(|of| simulated(of, place, start, 20.0).expect("it moves"));
    assert!(a.impacts.len() > 10 && a.impacts.len() == b.impacts.len() && a.end == b.end);
    for (a, b) in a.impacts.iter().zip(&b.impacts) {
        let apart = [a.time - b.time, a.impact_velocity - b.impact_velocity, a.impact_phase - b.impact_phase];
        // Integration is accurate to about 1e-13 per period, and errors grow at impacts.
        assert!(apart.iter().all(|apart| apart.abs() < 1e-9), "{apart:?}");
    }
    let first = &a.motion[0];
    let begins = [first.x - start[0], first.y - start[1], first.time - start[2]];
    assert!(begins.iter().all(|apart| apart.abs() < 1e-14), "{begins:?}");
    for wrong in [[0.1, 0.0, 0.0], [-1.0, f64::NAN, 0.0]] {
        assert!(simulated(&closed, place, wrong, 1.0).is_err());
    }
    assert!(simulated(&closed, [0.8, -0.8], start, 1.0).is_err());
    // Nothing begins beyond the other of two walls, 2 away from the first.
    let text = include_str!("../../../../examples/two-stops.toml");
    let between = Description::parse(text, "two-stops.toml").expect("it is right");
    let between = Prepared::of(&between, &Stop::default());
    assert!(simulated(&between, [0.7, 0.7], [-1.99, 0.0, 0.0], 1.0).is_ok());
    assert!(
        simulated(&between, [0.7, 0.7], [-2.01, 0.0, 0.0], 1.0).is_err_and(|why| why.contains("other wall"))
    );
    stop.ask();
    let ended = simulated(&integrated, place, start, 1.0).expect("it begins");
    assert_eq!((ended.end.as_str(), ended.impacts.len()), ("it cannot be followed", 0));
}

/// The stages that have begun, with the steps that were announced and those that were made, and
/// whether they have ended.
#[derive(Default)]
struct Stages(Mutex<BTreeMap<String, (u64, u64, bool)>>);

impl Stages {
    fn change(&self, what: &str, change: impl FnOnce(&mut (u64, u64, bool))) {
        change(self.0.lock().expect("nobody panics").entry(what.to_owned()).or_default());
    }
}

impl Progress for Stages {
    fn begin(&self, what: &str, steps: u64) {
        self.change(what, |stage| *stage = (stage.0 + steps, stage.1, false));
    }

    fn step(&self, what: &str) {
        self.change(what, |stage| stage.1 += 1);
    }

    fn end(&self, what: &str) {
        self.change(what, |stage| stage.2 = true);
    }
}

#[test]
fn basins_of_irregular_motion_cost_some_periods_a_state_and_every_stage_has_a_name_and_steps() {
    let text = include_str!("../../../cli/src/new/si.toml");
    let description = Description::parse(text, "si.toml").expect("it is right");
    // The number of integration steps for a lattice.
    let cost = |at: [f64; 2], lattice: [u32; 2]| {
        let (stop, stages) = (Stop::default(), Stages::default());
        let of = Prepared::of(&description, &stop);
        let here = of.oscillator.with_parameters(of.without_dimensions(at));
        let starts = Starts { states: 2, lattice, ..Starts::default() };
        let before = stop.steps();
        let place = Place::compute(&here, &of.scope, &starts, &stages).expect("nobody stops it");
        assert_eq!(place.attractors[0].fate.kind, MotionKind::Chaotic);
        let [all, in_basin] = [lattice[0] * lattice[1], place.basins.len() as u32];
        assert_eq!(all, in_basin);
        assert!(place.basins.iter().all(|(_, basin)| basin.is_some()));
        let stages = stages.0.into_inner().expect("nobody panics");
        assert_eq!(stages.len(), 6, "{stages:?}");
        for (name, (announced, made, ended)) in stages {
            assert!(announced > 0 && made == announced && ended, "{name}: {made} of {announced}");
        }
        stop.steps() - before
    };
    let stop = Stop::default();
    let of = Prepared::of(&description, &stop);
    for at in [[1.2, 15.2], [1.3, 15.0]] {
        let before = stop.steps();
        simulated(&of, at, [-0.001, 0.0, 0.0], 200.0).expect("it moves");
        let period = (stop.steps() - before) as f64 / 200.0;
        let more = cost(at, [20, 12]) as f64 - cost(at, [10, 6]) as f64;
        // No state is followed for longer than twice the average, and the same few for very long.
        let periods = more / period / 180.0;
        assert!(periods < 250.0, "{at:?}: {periods} periods a state");
    }
}
