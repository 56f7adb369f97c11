//! The diagrams that were asked for last.

use std::collections::VecDeque;
use std::sync::{Mutex, MutexGuard, PoisonError};

use grazing_unfold::Diagram;

use crate::answer::written;
use crate::model::{Model, View};

/// The texts of events in the order in which they were sent, without those of progress and of curves that were not all.
pub(crate) type Sent = Vec<String>;

/// Diagrams by model and view, newest first, each with what was sent of it.
type Last = VecDeque<(String, Vec<Diagram>, Sent)>;

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
        written(&(model, view))
    }

    /// The diagram of a view as each wall sees it, if it is among the last. Its oscillator moves no more: it ended with the
    /// request that it was computed for.
    pub(crate) fn find(&self, model: &Model, view: &View) -> Option<Vec<Diagram>> {
        let key = Self::key(model, view);
        self.all().iter().find(|(other, ..)| *other == key).map(|(_, diagram, _)| diagram.clone())
    }

    /// What was sent of the diagram of a view, if it is among the last; it then is the newest.
    pub(crate) fn sent(&self, model: &Model, view: &View) -> Option<Sent> {
        let key = Self::key(model, view);
        let mut all = self.all();
        let place = all.iter().position(|(other, _, sent)| *other == key && !sent.is_empty())?;
        let found = all.remove(place)?;
        let sent = found.2.clone();
        all.push_front(found);
        Some(sent)
    }

    pub(crate) fn add(&self, model: &Model, view: &View, seen: Vec<Diagram>, sent: Sent) {
        let key = Self::key(model, view);
        let mut all = self.all();
        all.retain(|(other, ..)| *other != key);
        all.push_front((key, seen, sent));
        all.truncate(Self::MOST);
    }
}
