//! Motion at a place, integrated and in closed form.

use grazing_analysis::place::simulated;
use grazing_analysis::unfolded::{Prepared, axes};
use grazing_description::Description;
use grazing_model::smooth::Stop;

#[test]
fn simulated_motion_in_closed_form_is_that_which_is_integrated() {
    let text = include_str!("../../../../examples/paper.toml");
    let (description, stop) = (Description::parse(text, "paper.toml").expect("it is right"), Stop::default());
    let integrated = Prepared::new(&description, axes(&description), &stop);
    let closed = Prepared::of_the_paper(&description, &stop).expect("its constants are right");
    let (place, start) = ([0.8, 0.8], [-1.0, 0.1, 0.3]);
    let [a, b] = [&closed, &integrated].map(|of| simulated(of, place, start, 20.0).expect("it moves"));
    assert!(a.impacts.len() > 10 && a.impacts.len() == b.impacts.len() && a.end == b.end);
    for (a, b) in a.impacts.iter().zip(&b.impacts) {
        let apart = [a.time - b.time, a.impact_velocity - b.impact_velocity, a.impact_phase - b.impact_phase];
        // Integration is accurate to about 1e-13 per period, and errors grow at impacts.
        assert!(apart.iter().all(|apart| apart.abs() < 1e-9), "{apart:?}");
    }
    let first = &a.motion[0];
    let begins = [first.x - start[0], first.y - start[1], first.time - start[2]];
    assert!(begins.iter().all(|apart| apart.abs() < 1e-14), "{begins:?}");
    for wrong in [[0.1, 0.0, 0.0], [-1.0, f64::NAN, 0.0]] {
        assert!(simulated(&closed, place, wrong, 1.0).is_err());
    }
    assert!(simulated(&closed, [0.8, -0.8], start, 1.0).is_err());
    stop.ask();
    let ended = simulated(&integrated, place, start, 1.0).expect("it begins");
    assert_eq!((ended.end.as_str(), ended.impacts.len()), ("it cannot be followed", 0));
}
