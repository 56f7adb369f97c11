//! Measurements, and their comparison with the part of the diagram in view.

use grazing_measured::{Observation, Setup, compare, read};
use grazing_model::smooth::Stop;
use grazing_results::measured::Comparison;
use grazing_unfold::Diagram;
use grazing_unfold::described::Axes;
use grazing_unfold::progress::Progress;
use serde::Deserialize;
use serde_json::{Value, json};

use crate::answer::{Problem, told};
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

/// The measurements as they are in the file, before anything is computed.
pub(crate) fn read(request: &ReadRequest, stop: &Stop) -> Result<Value, Problem> {
    let ReadRequest { model, measured } = request;
    let point = |one: &Observation| {
        json!({
            "line": one.line,
            "at": one.at,
            "errors": one.errors,
            "kind": one.seen.kind().name(),
            "seen": one.seen.words(),
        })
    };
    let (points, columns) = measured.read(model, stop)?;
    Ok(json!({ "points": points.iter().map(point).collect::<Vec<_>>(), "columns": columns }))
}

/// Compares measurements with the diagram of a view, which is not computed again if it was among the last.
pub(crate) fn compute(request: &CompareRequest, events: &Events, stop: &Stop) -> Result<(), Problem> {
    let CompareRequest { model, view, measured } = request;
    let (axes, diagrams) = diagram::known(model, view, events, stop)?;
    events.send("measured", &beside(&measured.beside(model, (&axes, &diagrams), events, stop)?));
    Ok(())
}

/// A comparison, for the page.
fn beside((compared, outside): &(Comparison, usize)) -> Value {
    json!({
        "points": compared.points.iter().map(told).collect::<Vec<_>>(),
        "counts": compared.counts.iter().map(told).collect::<Vec<_>>(),
        "outside": outside,
    })
}
