//! Measured motion with several impacts beside the regions of such solutions.

use grazing_continuation::curve::Window;
use grazing_measured::{Behaviour, Observation, compare};
use grazing_model::smooth::Stop;
use grazing_model::{AnyOscillator, LinearOscillator};
use grazing_results::measured::Agreement;
use grazing_unfold::described::Axes;
use grazing_unfold::progress::Silent;
use grazing_unfold::sequences::sequences;
use grazing_unfold::{Diagram, Scope};

#[test]
fn motion_with_several_impacts_agrees_by_its_region_or_else_by_simulation() {
    let linear = LinearOscillator::new(0.02, 0.9, 0.7, 0.7).expect("it is in the domain");
    let window = Window { primary: [0.6, 1.0], secondary: [0.6, 0.75] };
    let scope = Scope { window, loops: vec![1, 2], start: None };
    let diagram = Diagram::compute(&AnyOscillator::new(linear), &scope, &Silent).expect("it grazes");
    let known = sequences(&diagram, &[1], 2, &Silent).solutions;
    let places =
        || (0..=400).map(|k| window.parameters([f64::from(k % 20) / 20.0, f64::from(k / 20) / 20.0]));
    // A place at which one of these solutions is stable.
    let (found, at) = known
        .iter()
        .find_map(|found| {
            let decided = found.regions.iter().filter(|region| region.doubt.is_none());
            let inside = decided.flat_map(|region| places().filter(|place| region.contains(*place)));
            Some((found, inside.into_iter().next()?))
        })
        .expect("there are such regions");
    let seen = Behaviour::Periodic { periods: found.periods, impacts: found.impacts as u32 };
    let observation = [Observation { line: 2, at, errors: [0.0; 2], seen }];
    let verdict = |several| {
        let told = compare(
            &observation,
            &Axes::of_the_paper(),
            (&diagram, None, several),
            &Silent,
            &Stop::default(),
        );
        let point = &told.points[0];
        (point.agreement, point.theory.clone(), point.reason.clone())
    };
    let (agreement, theory, reason) = verdict(&known);
    assert_eq!((agreement, reason.as_str()), (Agreement::Agrees, ""));
    assert!(theory.contains(&format!("{} impacts in {} period", found.impacts, found.periods)), "{theory}");
    // Without the region simulation decides, and says the same or that no state reaches it.
    let (agreement, _, reason) = verdict(&[]);
    assert!(
        agreement != Agreement::Disagrees && reason.contains("simulated states")
            || reason.contains("by simulation")
    );
}
