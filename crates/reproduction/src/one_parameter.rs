//! One-parameter diagrams of an oscillator from a text file.

use grazing_description::Description;
use grazing_model::smooth::Stop;
use grazing_results::branches::OneParameter;
use grazing_unfold::diagram::DiagramCurve;
use grazing_unfold::one_parameter::{Cut, Line, Sampling, Subject};
use grazing_unfold::progress::Progress;
use grazing_unfold::unfinished::Unfinished;
use grazing_unfold::units::InUnits;

use crate::described::prepared;

/// How long-time behaviour is sampled: at as many values as columns of dots can be told apart in a
/// figure, after a transient that is longer where damping is weak.
pub const SAMPLING: Sampling =
    Sampling { values: 240, between: None, orbits: 2, transient: 150, recorded: 24, lowest: None, seed: 1 };

/// The one-parameter diagrams that a file asks for, in the oscillator's own units, and what is
/// missing.
pub(crate) fn diagrams(
    description: &Description,
    curves: &[DiagramCurve],
    stop: &Stop,
    progress: &dyn Progress,
) -> (Vec<OneParameter>, Vec<Unfinished>) {
    let (mut diagrams, mut unfinished) = (Vec::new(), Vec::new());
    let units = description.units();
    let (oscillator, scope) = prepared(description, &units, stop);
    for (diagram, setting) in (1..).zip(description.diagrams()) {
        let &grazing_description::OneParameter { primary_is_fixed, at, range, seed, .. } = setting;
        let line = Line { diagram, primary_is_fixed, at, range }.without_dimensions(&units);
        let unit = if primary_is_fixed { units.secondary } else { units.primary };
        let subject = |across: &f64| Subject { across: across / unit, loops: None };
        let subjects: Vec<Subject> = setting.portraits.iter().map(subject).collect();
        let sampling = Sampling { seed, ..SAMPLING };
        let cut = Cut::follow(&oscillator, &scope, curves, line, progress);
        let found = cut.map(|cut| cut.simulated(&sampling, &subjects, progress).in_units(&units));
        let missing = match &found {
            None => Some(format!("one-parameter diagram {diagram}")),
            Some(found) if found.resting.is_none() => {
                Some(format!("long-time behaviour and phase portraits of one-parameter diagram {diagram}"))
            }
            Some(_) => None,
        };
        unfinished.extend(missing.map(Unfinished::stage));
        let from_the_wall = !description.wall().is_usual();
        diagrams.extend(found.map(|found| OneParameter { from_the_wall, ..found }));
    }
    (diagrams, unfinished)
}
