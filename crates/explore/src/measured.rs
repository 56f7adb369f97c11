//! Measurements beside the part of the diagram in view.

use grazing_analysis::plane::Axes;
use grazing_measured::{Observation, compare, read};
use grazing_model::smooth::Stop;
use grazing_results::measured::{Comparison, MeasuredCount, MeasuredPoint};
use grazing_unfold::Diagram;
use serde::Deserialize;
use serde_json::{Value, json};

use crate::answer::Problem;
use crate::model::Model;

/// A file of measurements.
#[derive(Deserialize)]
pub(crate) struct Measured {
    name: String,
    text: String,
}

impl Measured {
    /// Compares the measurements in the view with the diagram there, and counts those that lie outside.
    ///
    /// # Errors
    /// The first mistake in the file.
    pub(crate) fn beside(
        &self,
        model: &Model,
        axes: &Axes,
        diagram: &Diagram,
        stop: &Stop,
    ) -> Result<(Comparison, usize), Problem> {
        let description = model.description(None, stop)?;
        let own = [description.primary().name(), description.secondary().name()];
        // The paper's oscillator has other names than the text that describes it.
        let names = if model.text.is_some() { own } else { [&*axes.names.primary, &*axes.names.secondary] };
        let all = read::points_of(&self.text, &self.name, names)
            .map_err(|error| Problem::wrong(error.to_string()))?;
        let window = diagram.scope.window;
        let seen = |one: &Observation| {
            let [primary, secondary] = one.at;
            window.contains([primary / axes.units.primary, secondary / axes.units.secondary])
        };
        let (inside, outside): (Vec<_>, Vec<_>) = all.into_iter().partition(seen);
        Ok((compare(&inside, axes, diagram, stop), outside.len()))
    }
}

/// A comparison, for the page.
pub(crate) fn told((compared, outside): &(Comparison, usize)) -> Value {
    let point = |row: &MeasuredPoint| {
        json!({
            "line": row.line,
            "at": [row.primary, row.secondary],
            "errors": [row.primary_error, row.secondary_error],
            "kind": row.kind.name(),
            "seen": row.seen,
            "agreement": row.agreement.name(),
            "theory": row.theory,
            "reason": row.reason,
        })
    };
    let count = |row: &MeasuredCount| {
        json!({
            "region": row.region,
            "kind": row.kind,
            "p": row.loops,
            "counts": [row.points, row.agree, row.within_error, row.disagree, row.undecided],
        })
    };
    json!({
        "points": compared.points.iter().map(point).collect::<Vec<_>>(),
        "counts": compared.counts.iter().map(count).collect::<Vec<_>>(),
        "outside": outside,
    })
}
