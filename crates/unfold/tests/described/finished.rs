//! What is passed on of a diagram while the rest is still being computed.

use std::sync::Mutex;

use grazing_continuation::curve::Window;
use grazing_model::{AnyOscillator, LinearOscillator};
use grazing_results::Table;
use grazing_results::plane::PlaneDiagram;
use grazing_unfold::Scope;
use grazing_unfold::described::Axes;
use grazing_unfold::progress::Silent;
use grazing_unfold::unfolded::{Draft, Unfolded};

#[test]
fn every_finished_resonance_and_then_the_regions_of_every_p_are_handed_on_until_nothing_is_missing() {
    let oscillator = LinearOscillator::new(0.05, 0.9, 0.5, 0.9).expect("it is in the domain");
    let oscillator = AnyOscillator::new(oscillator);
    let window = Window { primary: [0.0, 1.2], secondary: [0.6, 1.1] };
    let scope = Scope { window, loops: vec![2, 3], start: None };
    let kept = Mutex::new(Vec::new());
    let keep =
        |draft: &Draft<'_>| kept.lock().expect("nobody panics").push((draft.curves.clone(), (draft.plane)()));
    let unfolded = Unfolded::compute(&oscillator, (&scope, Vec::new()), Axes::of_the_paper(), &Silent, &keep)
        .expect("there is grazing in the window");
    let (tables, planes): (Vec<_>, Vec<_>) = kept.into_inner().expect("nobody panicked").into_iter().unzip();
    let resonances = unfolded.resonances.len();
    // For each p one more when all curves are known, and one when its regions are.
    assert_eq!(tables.len(), resonances + 2 * scope.loops.len());
    assert!(resonances > 1 && tables.iter().all(|table| table.name == "curves"));
    let whole = unfolded.plane_diagram();
    let all = Table::new("curves", &unfolded.axes.names, &whole.curves);
    let last = &tables.last().expect("there are some").rows;
    // Curves that begin at codimension-two points of the finished curves come after all of them. NaN
    // is not equal to itself, but its text is.
    assert_eq!(format!("{last:?}"), format!("{:?}", &all.rows[..last.len()]));
    assert!(tables[..resonances].windows(2).all(|pair| pair[0].rows.len() < pair[1].rows.len()));

    // Whether the regions of all p, of one, and of none are still open.
    let open = |plane: &PlaneDiagram| {
        let is_open = |loops: &&u32| {
            plane.regions.iter().any(|row| row.loops == **loops && row.at.reason.contains("not finished"))
        };
        scope.loops.iter().filter(is_open).count()
    };
    let counts: Vec<usize> = planes.iter().map(open).collect();
    let (before, after) = counts.split_at(resonances + scope.loops.len());
    assert!(before.iter().all(|count| *count == 2) && after == [1, 0], "{counts:?}");
    // In the end the regions are those of the whole diagram, in the same order.
    let last = planes.last().expect("there are some");
    assert_eq!(format!("{:?}", last.regions), format!("{:?}", whole.regions));
}
