//! What is known of a diagram while the rest of it is computed, for callers that save it or show it early.

use std::collections::BTreeMap;
use std::sync::mpsc::{self, Receiver};
use std::thread;

use grazing_results::Table;
use grazing_results::plane::PlaneDiagram;
use grazing_unfold::Diagram;
use grazing_unfold::diagram::DiagramCurve;
use grazing_unfold::progress::Progress;

use crate::plane::{self, Axes};

/// What is known of a diagram so far.
pub struct Draft {
    /// The table `curves` with the grazing curves and the curves of the resonances finished so far, in the
    /// order of the complete table, of which it is the beginning.
    pub curves: Table,
    /// The diagram, in which regions that are not decided yet are undecided.
    pub plane: PlaneDiagram,
}

/// A callback that receives what is known of a diagram so far: whenever a resonance's curves are finished, once all
/// of them are, and whenever the regions of a p are decided.
pub type Keep<'a> = &'a (dyn Fn(&Draft) + Sync);

/// What becomes known: the curves of a resonance, with its index in the diagram's list, or more of the
/// diagram.
enum News {
    Curves(usize, Vec<DiagramCurve>),
    Diagram(Box<Diagram>),
}

/// Follows the curves of a diagram whose resonances are located, decides its regions, and passes on what is
/// known on the way.
pub(super) fn complete(axes: &Axes, located: Diagram, progress: &dyn Progress, keep: Keep<'_>) -> Diagram {
    let (sender, news) = mpsc::channel();
    let known = located.clone();
    thread::scope(|scope| {
        // A separate thread: a worker that follows curves would start on those of another resonance while
        // it waits for the threads of the tables library.
        scope.spawn(move || pass_on(axes, &known, &news, keep));
        // The sender is dropped when all is computed, and the thread then ends; it outlives the sender.
        let sender = sender;
        let followed = located.follow(progress, &|resonance, curves: &[DiagramCurve]| {
            let _ = sender.send(News::Curves(resonance, curves.to_vec()));
        });
        located.with_drafts(followed, progress, &|draft| {
            let _ = sender.send(News::Diagram(Box::new(draft)));
        })
    })
}

fn pass_on(axes: &Axes, known: &Diagram, news: &Receiver<News>, keep: Keep<'_>) {
    let mut finished = BTreeMap::new();
    let mut whole: Option<Box<Diagram>> = None;
    for one in news {
        match one {
            News::Curves(resonance, curves) => _ = finished.insert(resonance, curves),
            News::Diagram(diagram) => whole = Some(diagram),
        }
        let mut listed: Vec<&DiagramCurve> = Vec::new();
        for candidate in finished.values().flatten() {
            if !listed.iter().any(|curve| curve.is_same(candidate)) {
                listed.push(candidate);
            }
        }
        let followed = known.draft(listed.into_iter().cloned());
        let curves = Table::new("curves", &axes.names, &plane::curves(axes, &followed));
        let shown = whole.as_deref().unwrap_or(&followed);
        keep(&Draft { curves, plane: plane::plane_diagram(axes, (shown, None), Vec::new(), Vec::new()) });
    }
}
