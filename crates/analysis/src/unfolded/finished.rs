//! Curves that are finished while others are still being followed, for callers that save them early.

use std::collections::BTreeMap;
use std::sync::mpsc;
use std::thread;

use grazing_results::Table;
use grazing_results::plane::PlanePoint;
use grazing_unfold::Diagram;
use grazing_unfold::diagram::{DiagramCurve, Followed};
use grazing_unfold::progress::Progress;

use crate::plane::{self, Axes};

/// A callback that receives the table `curves` with the grazing curves and the curves of the resonances
/// finished so far, in the order of the complete table.
pub type Keep<'a> = &'a (dyn Fn(&Table) + Sync);

/// The curves of a resonance, with its index in the diagram's list.
type Done = (usize, Vec<(DiagramCurve, Vec<PlanePoint>)>);

/// Follows the curves of a diagram whose resonances are located, and passes on each resonance's curves
/// when they are finished.
pub(super) fn follow(
    axes: &Axes,
    located: &Diagram,
    progress: &dyn Progress,
    keep: Keep<'_>,
) -> Vec<Followed> {
    let (sender, receiver) = mpsc::channel();
    thread::scope(|scope| {
        // A separate thread: a worker that follows curves would start on those of another resonance while
        // it waits for the threads of the tables library.
        scope.spawn(move || hand_on(axes, located, receiver, keep));
        // The sender is dropped when the last curve has been followed, and the thread then ends.
        located.follow(progress, &move |resonance, curves: &[DiagramCurve]| {
            let rows = |curve: &DiagramCurve| (curve.clone(), plane::bifurcation_rows(axes, located, curve));
            // The receiver outlives the sender.
            let _ = sender.send((resonance, curves.iter().map(rows).collect()));
        })
    })
}

fn hand_on(axes: &Axes, located: &Diagram, receiver: impl IntoIterator<Item = Done>, keep: Keep<'_>) {
    let free = located.curves.iter().map(|curve| plane::bifurcation_rows(axes, located, curve));
    let before: Vec<Vec<PlanePoint>> = plane::grazing_rows(axes, located).into_iter().chain(free).collect();
    let mut finished = BTreeMap::new();
    for (resonance, curves) in receiver {
        finished.insert(resonance, curves);
        let mut listed: Vec<&(DiagramCurve, Vec<PlanePoint>)> = Vec::new();
        for candidate in finished.values().flatten() {
            if !listed.iter().any(|(curve, _)| curve.is_same(&candidate.0)) {
                listed.push(candidate);
            }
        }
        let rows = listed.into_iter().map(|(_, rows)| rows.clone());
        let all = plane::numbered(before.iter().cloned().chain(rows));
        keep(&Table::new("curves", &axes.names, &all));
    }
}
