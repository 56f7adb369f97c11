//! Curves that are passed on while others are still being followed.

use std::sync::Mutex;

use grazing_analysis::plane::Axes;
use grazing_analysis::unfolded::Unfolded;
use grazing_continuation::curve::Window;
use grazing_model::{AnyOscillator, LinearOscillator};
use grazing_results::Table;
use grazing_unfold::Scope;
use grazing_unfold::progress::Silent;

#[test]
fn every_finished_resonance_is_handed_on_until_the_table_is_the_beginning_of_the_whole_one() {
    let oscillator = LinearOscillator::new(0.05, 0.9, 0.5, 0.9).expect("it is in the domain");
    let oscillator = AnyOscillator::new(oscillator);
    let window = Window { primary: [0.0, 1.2], secondary: [0.6, 1.1] };
    let scope = Scope { window, loops: vec![2, 3], start: None };
    let kept = Mutex::new(Vec::new());
    let keep = |finished: &Table| kept.lock().expect("nobody panics").push(finished.clone());
    let unfolded = Unfolded::compute(&oscillator, (&scope, Vec::new()), Axes::of_the_paper(), &Silent, &keep)
        .expect("there is grazing in the window");
    let tables = kept.into_inner().expect("nobody panicked");
    assert!(tables.iter().all(|table| table.name == "curves"));
    assert_eq!(tables.len(), unfolded.resonances.len(), "one table a resonance");
    assert!(tables.len() > 1);
    let whole = Table::new("curves", &unfolded.axes.names, &unfolded.plane_diagram().curves);
    let last = &tables.last().expect("there are some").rows;
    // Curves that begin at codimension-two points of the finished curves come after all of them. NaN
    // is not equal to itself, but its text is.
    assert_eq!(format!("{last:?}"), format!("{:?}", &whole.rows[..last.len()]));
    assert!(tables.windows(2).all(|pair| pair[0].rows.len() < pair[1].rows.len()));
}
