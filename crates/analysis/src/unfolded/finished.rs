//! What is known of a diagram while the rest of it is computed, for callers that save it or show it early.

use std::collections::BTreeMap;
use std::sync::mpsc::{self, Receiver};
use std::thread;

use grazing_results::Table;
use grazing_results::plane::{PlaneDiagram, PlanePoint};
use grazing_unfold::Diagram;
use grazing_unfold::diagram::DiagramCurve;
use grazing_unfold::progress::Progress;

use crate::plane::{self, Axes};

/// What is known of a diagram so far.
pub struct Draft<'a> {
    /// The table `curves` with the grazing curves and the curves of the resonances finished so far, in the
    /// order of the complete table, of which it is the beginning.
    pub curves: Table,
    /// Makes the diagram, in which regions that are not decided yet are undecided, without the phases on its
    /// bifurcation curves, which are not drawn and take long to compute.
    pub plane: &'a dyn Fn() -> PlaneDiagram,
}

/// A callback that receives what is known of a diagram so far: whenever a resonance's curves are finished, once all
/// of them are, and whenever the regions of a p are decided.
pub type Keep<'a> = &'a (dyn Fn(&Draft<'_>) + Sync);

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
        // it waits for the threads of the tables library. Where there is no room for it nothing is told early.
        let listener = thread::Builder::new().name("drafts".to_owned());
        let _ = listener.spawn_scoped(scope, move || pass_on(axes, &known, &news, keep));
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
    let rows = |curve: &DiagramCurve| plane::bifurcation_rows(axes, known, curve);
    let before = plane::grazing_rows(axes, known).into_iter().chain(known.curves.iter().map(rows));
    let before: Vec<Vec<PlanePoint>> = before.collect();
    let mut finished: BTreeMap<usize, Vec<(DiagramCurve, Vec<PlanePoint>)>> = BTreeMap::new();
    let mut whole: Option<Box<Diagram>> = None;
    for one in news {
        match one {
            News::Curves(resonance, curves) => {
                let curves = curves.into_iter().map(|curve| (curve.clone(), rows(&curve)));
                finished.insert(resonance, curves.collect());
            }
            News::Diagram(diagram) => whole = Some(diagram),
        }
        // Where there is nothing to unfold nothing is told, as there will be no results either.
        if whole.as_deref().unwrap_or(known).nothing().is_some() {
            continue;
        }
        let mut listed: Vec<&(DiagramCurve, Vec<PlanePoint>)> = Vec::new();
        for candidate in finished.values().flatten() {
            if !listed.iter().any(|(curve, _)| curve.is_same(&candidate.0)) {
                listed.push(candidate);
            }
        }
        let all = plane::numbered(before.iter().chain(listed.iter().map(|(_, rows)| rows)).cloned());
        let curves = Table::new("curves", &axes.names, &all);
        let plane = || {
            let followed = || known.draft(listed.iter().map(|(curve, _)| curve.clone()));
            // Phases count from those of the grazing curves.
            let shown = Diagram { grazing: Vec::new(), ..whole.as_deref().cloned().unwrap_or_else(followed) };
            let plane = plane::plane_diagram(axes, (&shown, None), Vec::new(), Vec::new());
            let others = plane.curves.chunk_by(|a, b| a.arc == b.arc).map(<[PlanePoint]>::to_vec);
            let grazing = before[..known.grazing.len()].iter().cloned();
            PlaneDiagram { curves: plane::numbered(grazing.chain(others)), ..plane }
        };
        keep(&Draft { curves, plane: &plane });
    }
}
