//! What is known of a diagram while the rest of it is computed, for callers that save it or show it early.

use std::collections::BTreeMap;
use std::sync::mpsc::{self, Receiver};
use std::thread;

use crate::Diagram;
use crate::diagram::DiagramCurve;
use crate::progress::Progress;
use crate::regions::Region;
use grazing_results::plane::{PlaneDiagram, PlanePoint};
use grazing_results::{Dimensioned, Table};

use crate::described::Axes;
use crate::plane;

/// What is known of a diagram so far.
pub struct Draft<'a> {
    /// The table `curves` with the grazing curves and the curves of the resonances finished so far, in the
    /// order of the complete table, of which it is the beginning.
    pub curves: Table,
    /// Makes the diagram, in which regions that are not decided yet are undecided, without the phases on its
    /// bifurcation curves, which are not drawn and take long to compute.
    pub plane: &'a dyn Fn() -> PlaneDiagram,
}

/// A callback that receives what is known of a diagram so far: whenever the curves of a resonance are finished, all
/// curves of a p, or its regions.
pub type Keep<'a> = &'a (dyn Fn(&Draft<'_>) + Sync);

/// What becomes known: the curves of a resonance, with its index in the diagram's list, or all curves and the
/// regions of a p.
enum News {
    Curves(usize, Vec<DiagramCurve>),
    Decided(u32, Vec<DiagramCurve>, Vec<Region>),
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
        located.with_drafts(followed, progress, &|loops, curves: &[DiagramCurve], regions: &[Region]| {
            let _ = sender.send(News::Decided(loops, curves.to_vec(), regions.to_vec()));
        })
    })
}

fn pass_on(axes: &Axes, known: &Diagram, news: &Receiver<News>, keep: Keep<'_>) {
    let rows = |curve: &DiagramCurve| plane::bifurcation_rows(known, curve).with_dimensions(&axes.units);
    let grazing = plane::grazing_rows(known).with_dimensions(&axes.units);
    let before = grazing.into_iter().chain(known.curves.iter().map(rows));
    let before: Vec<Vec<PlanePoint>> = before.collect();
    let mut finished: BTreeMap<usize, Vec<(DiagramCurve, Vec<PlanePoint>)>> = BTreeMap::new();
    let open = |loops: &u32| (*loops, (Vec::new(), vec![Region::not_finished(known.scope.window, *loops)]));
    let mut decided: BTreeMap<u32, (Vec<DiagramCurve>, Vec<Region>)> =
        known.scope.loops.iter().map(open).collect();
    for one in news {
        match one {
            News::Curves(resonance, curves) => {
                let curves = curves.into_iter().map(|curve| (curve.clone(), rows(&curve)));
                finished.insert(resonance, curves.collect());
            }
            News::Decided(loops, curves, regions) => _ = decided.insert(loops, (curves, regions)),
        }
        // Phases count from those of the grazing curves.
        let mut shown = Diagram { grazing: Vec::new(), ..known.clone() };
        for (curves, regions) in known.scope.loops.iter().filter_map(|loops| decided.get(loops)) {
            shown.curves.extend(curves.iter().cloned());
            shown.regions.extend(regions.iter().cloned());
        }
        // Where there is nothing to unfold nothing is told, as there will be no results either.
        if shown.nothing().is_some() {
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
        // Until all curves of a p are known those of its resonances are shown.
        let is_open = |curve: &DiagramCurve| decided.get(&curve.loops).is_none_or(|(all, _)| all.is_empty());
        shown.curves.extend(listed.iter().map(|(curve, _)| curve.clone()).filter(is_open));
        let plane = || {
            let plane = plane::rows(&shown, None).with_dimensions(&axes.units);
            let others = plane.curves.chunk_by(|a, b| a.at.arc == b.at.arc).map(<[PlanePoint]>::to_vec);
            let grazing = before[..known.grazing.len()].iter().cloned();
            PlaneDiagram { curves: plane::numbered(grazing.chain(others)), ..plane }
        };
        keep(&Draft { curves, plane: &plane });
    }
}
