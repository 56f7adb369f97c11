//! The curves that are finished while others are being followed, for whoever wants to keep them.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use grazing_model::ImpactOscillator;
use grazing_unfold::Diagram;
use grazing_unfold::diagram::DiagramCurve;
use grazing_unfold::progress::{Progress, Silent};

use crate::plane::{self, Axes, CurveRows};
use crate::table::Table;

/// Hears of the progress of an analysis, and gets what is finished; called from any thread.
pub trait Observer: Progress {
    /// The table `curves` with the grazing curves and the curves of those resonances that are done, in the order of the whole one.
    fn curves(&self, _finished: &Table) {}
}

impl Observer for Silent {}

/// Collects the curves of resonances as they finish, and hands them on as a table.
pub(super) struct Finished<'a, O> {
    observer: &'a dyn Observer,
    axes: &'a Axes,
    /// Grazing curves and resonances are known.
    diagram: &'a Diagram<O>,
    /// By the place of the resonance.
    curves: Mutex<BTreeMap<usize, Vec<(DiagramCurve, CurveRows)>>>,
}

impl<'a, O: ImpactOscillator> Finished<'a, O> {
    pub(super) fn new(observer: &'a dyn Observer, axes: &'a Axes, diagram: &'a Diagram<O>) -> Self {
        Self { observer, axes, diagram, curves: Mutex::default() }
    }
}

impl<O: ImpactOscillator> Progress for Finished<'_, O> {
    fn begin(&self, what: &str, steps: u64) {
        self.observer.begin(what, steps);
    }

    fn step(&self, what: &str) {
        self.observer.step(what);
    }

    fn end(&self, what: &str) {
        self.observer.end(what);
    }

    fn unfolded(&self, resonance: usize, curves: &[DiagramCurve]) {
        let rows = |curve: &DiagramCurve| (curve.clone(), plane::bifurcation_rows(self.diagram, curve));
        let new = curves.iter().map(rows).collect();
        // Held while the table is handed on, so that a later one never comes before an earlier one.
        let mut finished = self.curves.lock().unwrap_or_else(PoisonError::into_inner);
        finished.insert(resonance, new);
        let mut listed: Vec<&(DiagramCurve, CurveRows)> = Vec::new();
        for candidate in finished.values().flatten() {
            if !listed.iter().any(|(curve, _)| curve.is_same(&candidate.0)) {
                listed.push(candidate);
            }
        }
        let rows = listed.into_iter().map(|(_, rows)| rows.clone());
        let all = plane::grazing_rows(self.diagram).into_iter().chain(rows);
        // A table that cannot be made now cannot be made at the end either, where this is told.
        if let Ok(table) = plane::joined("curves", self.axes, all) {
            self.observer.curves(&table);
        }
    }
}
