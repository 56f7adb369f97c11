//! The curves that are finished while others are being followed, for whoever wants to keep them.

use std::collections::BTreeMap;
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread;

use grazing_model::ImpactOscillator;
use grazing_unfold::Diagram;
use grazing_unfold::diagram::{DiagramCurve, Followed};
use grazing_unfold::progress::{Progress, Silent};

use crate::plane::{self, Axes, CurveRows};
use crate::table::Table;

/// Hears of the progress of an analysis, and gets what is finished; called from any thread.
pub trait Observer: Progress {
    /// The table `curves` with the grazing curves and the curves of those resonances that are done, in the order of the whole one.
    fn curves(&self, _finished: &Table) {}
}

impl Observer for Silent {}

/// The curves of a resonance, by its place in the diagram's list.
type Done = (usize, Vec<(DiagramCurve, CurveRows)>);

/// Follows the curves of a diagram whose resonances are located, and hands on those that are finished.
pub(super) fn follow<O: ImpactOscillator>(
    observer: &dyn Observer,
    axes: &Axes,
    located: &Diagram<O>,
) -> Vec<Followed> {
    let (sender, receiver) = mpsc::channel();
    thread::scope(|scope| {
        // A thread of its own: one that follows curves would begin with those of another resonance while it waits for the tables
        // library's threads.
        scope.spawn(move || hand_on(observer, axes, located, &receiver));
        // The sender goes when the last curve is followed, and with it the thread.
        located.follow(&Finished { observer, diagram: located, sender })
    })
}

fn hand_on<O: ImpactOscillator>(
    observer: &dyn Observer,
    axes: &Axes,
    located: &Diagram<O>,
    receiver: &Receiver<Done>,
) {
    let mut finished = BTreeMap::new();
    for (resonance, curves) in receiver {
        finished.insert(resonance, curves);
        let mut listed: Vec<&(DiagramCurve, CurveRows)> = Vec::new();
        for candidate in finished.values().flatten() {
            if !listed.iter().any(|(curve, _)| curve.is_same(&candidate.0)) {
                listed.push(candidate);
            }
        }
        let rows = listed.into_iter().map(|(_, rows)| rows.clone());
        let all = plane::grazing_rows(located).into_iter().chain(rows);
        // A table that cannot be made now cannot be made at the end either, where this is told.
        if let Ok(table) = plane::joined("curves", axes, all) {
            observer.curves(&table);
        }
    }
}

/// Passes on what it hears, and sends the curves of resonances as they finish.
struct Finished<'a, O> {
    observer: &'a dyn Observer,
    diagram: &'a Diagram<O>,
    sender: Sender<Done>,
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
        // The receiver goes last.
        let _ = self.sender.send((resonance, curves.iter().map(rows).collect()));
    }
}
