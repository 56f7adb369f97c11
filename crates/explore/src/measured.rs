//! Measurements, and their comparison with the part of the diagram in view.

use grazing_measured::{Observation, Setup, compare, read};
use grazing_model::smooth::Stop;
use grazing_results::measured::Comparison;
use grazing_unfold::Diagram;
use grazing_unfold::described::Axes;
use grazing_unfold::progress::Progress;
use serde::Deserialize;

use crate::answer::{Cells, Problem, answers, told};
use crate::diagram;
use crate::events::Events;
use crate::model::{Model, View};

/// A file of measurements.
#[derive(Deserialize)]
pub(crate) struct Measured {
    name: String,
    text: String,
}

/// The request to read a file of measurements.
#[derive(Deserialize)]
pub(crate) struct ReadRequest {
    model: Model,
    measured: Measured,
}

/// The request to compare measurements with the diagram of a view.
#[derive(Deserialize)]
pub(crate) struct CompareRequest {
    model: Model,
    view: View,
    measured: Measured,
}

answers! {
    /// Measurements as they were read, before anything is computed, and the columns that hold them.
    Read { points: Vec<Point>, columns: Vec<String>, }

    /// A measurement at a place, with the standard errors of both parameters, and what was seen there, in words.
    Point { line: u32, at: [f64; 2], errors: [f64; 2], kind: &'static str, seen: String, }

    /// Measurements beside the diagram, how many agree, and how many lie outside the view.
    Beside { points: Vec<Cells>, counts: Vec<Cells>, outside: usize, }
}

impl Measured {
    /// The measurements, and the columns that hold them.
    ///
    /// # Errors
    /// The first mistake in the file.
    fn read(&self, model: &Model, stop: &Stop) -> Result<(Vec<Observation>, Vec<String>), Problem> {
        let description = model.description(None, stop)?;
        let own = [description.primary().name(), description.secondary().name()];
        // The paper's oscillator has other names than the text that describes it.
        let paper = Axes::of_the_paper().names;
        let names = if model.text.is_some() { own } else { [&*paper.primary, &*paper.secondary] };
        let setup = Setup { names, two_walls: description.has_two_walls() };
        read::points_of(&self.text, &self.name, setup, &[]).map_err(|error| Problem::wrong(error.to_string()))
    }

    /// Compares the measurements in the view with the diagram there, and counts those that lie outside.
    ///
    /// # Errors
    /// The first mistake in the file.
    pub(crate) fn beside(
        &self,
        model: &Model,
        (axes, diagrams): (&Axes, &[Diagram]),
        progress: &dyn Progress,
        stop: &Stop,
    ) -> Result<(Comparison, usize), Problem> {
        let (all, _) = self.read(model, stop)?;
        let diagram = &diagrams[0];
        let window = diagram.scope.window;
        let seen = |one: &Observation| {
            let [primary, secondary] = one.at;
            window.contains([primary / axes.units.primary, secondary / axes.units.secondary])
        };
        let (inside, outside): (Vec<_>, Vec<_>) = all.into_iter().partition(seen);
        Ok((compare(&inside, axes, (diagram, diagrams.get(1), &[]), progress, stop), outside.len()))
    }
}

/// The measurements as they are in the file.
pub(crate) fn read(request: &ReadRequest, stop: &Stop) -> Result<Read, Problem> {
    let ReadRequest { model, measured } = request;
    let (all, columns) = measured.read(model, stop)?;
    let point = |Observation { line, at, errors, seen }| Point {
        line,
        at,
        errors,
        kind: seen.kind().name(),
        seen: seen.words(),
    };
    Ok(Read { points: all.into_iter().map(point).collect(), columns })
}

/// Compares measurements with the diagram of a view, which is not computed again if it was among the last.
pub(crate) fn compute(request: &CompareRequest, events: &Events, stop: &Stop) -> Result<(), Problem> {
    let CompareRequest { model, view, measured } = request;
    let (axes, diagrams) = diagram::known(model, view, events, stop)?;
    let (compared, outside) = measured.beside(model, (&axes, &diagrams), events, stop)?;
    let points = compared.points.iter().map(told).collect();
    events.send("measured", &Beside { points, counts: compared.counts.iter().map(told).collect(), outside });
    Ok(())
}
