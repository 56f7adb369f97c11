//! The diagrams that were asked for last.

use std::collections::VecDeque;
use std::sync::{Mutex, MutexGuard, PoisonError};

use grazing_unfold::Diagram;
use serde_json::json;

use crate::model::{Model, View};

/// Diagrams by model and view, newest first.
type Last = VecDeque<(String, Diagram)>;

/// The diagrams that were asked for last, with all their regions: they are sent again at once, and measurements are
/// compared with them.
pub(crate) struct Kept(Mutex<Last>);

impl Kept {
    /// The number of diagrams.
    const MOST: usize = 4;

    pub(crate) const fn none() -> Self {
        Self(Mutex::new(VecDeque::new()))
    }

    fn all(&self) -> MutexGuard<'_, Last> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn key(model: &Model, view: &View) -> String {
        json!([model, view]).to_string()
    }

    /// The diagram of a view, if it is among the last. Its oscillator moves no more: it ended with the request that
    /// it was computed for.
    pub(crate) fn find(&self, model: &Model, view: &View) -> Option<Diagram> {
        let key = Self::key(model, view);
        let mut all = self.all();
        let place = all.iter().position(|(other, _)| *other == key)?;
        let found = all.remove(place)?;
        let diagram = found.1.clone();
        all.push_front(found);
        Some(diagram)
    }

    pub(crate) fn add(&self, model: &Model, view: &View, diagram: Diagram) {
        let key = Self::key(model, view);
        let mut all = self.all();
        all.retain(|(other, _)| *other != key);
        all.push_front((key, diagram));
        all.truncate(Self::MOST);
    }
}
