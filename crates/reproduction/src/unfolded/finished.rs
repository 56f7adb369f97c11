//! The curves that are finished while others are being followed, for whoever wants to keep them.

use std::collections::BTreeMap;
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread;

use grazing_model::ImpactOscillator;
use grazing_results::Table;
use grazing_results::plane::CurvePoint;
use grazing_unfold::Diagram;
use grazing_unfold::diagram::{DiagramCurve, Followed};
use grazing_unfold::progress::{Progress, Silent};
use grazing_unfold::stop::Stop;

use crate::plane::{self, Axes};

/// Hears of the progress of an analysis, and gets what is finished; called from any thread.
pub trait Observer: Progress {
    /// The table `curves` with the grazing curves and the curves of those resonances that are done, in the order of the whole one.
    fn curves(&self, _finished: &Table) {}
    /// The mark by which the analysis can be ended; [`Progress::stopped`] tells whether it is set.
    fn stop(&self) -> Stop {
        Stop::default()
    }
}

impl Observer for Silent {}

/// The curves of a resonance, by its place in the diagram's list.
type Done = (usize, Vec<(DiagramCurve, Vec<CurvePoint>)>);

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
        located.follow(&Finished { observer, axes, diagram: located, sender })
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
        let mut listed: Vec<&(DiagramCurve, Vec<CurvePoint>)> = Vec::new();
        for candidate in finished.values().flatten() {
            if !listed.iter().any(|(curve, _)| curve.is_same(&candidate.0)) {
                listed.push(candidate);
            }
        }
        let rows = listed.into_iter().map(|(_, rows)| rows.clone());
        let free = located.curves.iter().map(|curve| plane::bifurcation_rows(axes, located, curve));
        let all = plane::grazing_rows(axes, located).into_iter().chain(free).chain(rows);
        observer.curves(&Table::new("curves", &axes.names, &plane::numbered(all)));
    }
}

/// Passes on what it hears, and sends the curves of resonances as they finish.
struct Finished<'a, O> {
    observer: &'a dyn Observer,
    axes: &'a Axes,
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

    fn stopped(&self) -> bool {
        self.observer.stopped()
    }

    fn unfolded(&self, resonance: usize, curves: &[DiagramCurve]) {
        let rows =
            |curve: &DiagramCurve| (curve.clone(), plane::bifurcation_rows(self.axes, self.diagram, curve));
        // The receiver goes last.
        let _ = self.sender.send((resonance, curves.iter().map(rows).collect()));
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Mutex;

    use grazing_continuation::curve::Window;
    use grazing_model::LinearOscillator;
    use grazing_unfold::Scope;

    use super::*;
    use crate::unfolded::Unfolded;

    /// Remembers what was handed on.
    #[derive(Default)]
    struct Collector(Mutex<Vec<Table>>);

    impl Progress for Collector {
        fn begin(&self, _: &str, _: u64) {}
        fn step(&self, _: &str) {}
        fn end(&self, _: &str) {}
    }

    impl Observer for Collector {
        fn curves(&self, finished: &Table) {
            assert_eq!(finished.name, "curves");
            self.0.lock().expect("nobody panics").push(finished.clone());
        }
    }

    #[test]
    fn every_finished_resonance_is_handed_on_until_the_table_is_the_beginning_of_the_whole_one() {
        let oscillator = LinearOscillator::new(0.05, 0.9, 0.5, 0.9).expect("it is in the domain");
        let window = Window { primary: [0.0, 1.2], secondary: [0.6, 1.1] };
        let scope = Scope { window, loops: vec![2, 3], start: None };
        let collector = Collector::default();
        let unfolded = Unfolded::compute(&oscillator, &scope, Axes::of_the_paper(), &collector)
            .expect("there is grazing in the window");
        let tables = collector.0.into_inner().expect("nobody panicked");
        assert_eq!(tables.len(), unfolded.resonances.len(), "one table a resonance");
        assert!(tables.len() > 1);
        let whole = Table::new("curves", &unfolded.axes.names, &unfolded.rows().curves);
        let last = &tables.last().expect("there are some").rows;
        // What begins at codimension-two points of the finished curves comes after all of them. NaN is not equal to itself, its text is.
        assert_eq!(format!("{last:?}"), format!("{:?}", &whole.rows[..last.len()]));
        assert!(tables.windows(2).all(|pair| pair[0].rows.len() < pair[1].rows.len()));
    }
}
