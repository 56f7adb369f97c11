//! Regions of stability in windows that take long.

use grazing_continuation::curve::CurveEnd;
use grazing_model::ImpactOscillator;
use grazing_trials::random::Random;
use grazing_trials::{closed_form, simulation};
use grazing_unfold::Diagram;
use grazing_unfold::progress::Silent;
use grazing_unfold::regions::Region;

use crate::specimens::{EPSILON, LAYER, ZETA, counted, forced, grazing_at, random, scope};

#[test]
fn a_region_that_ends_at_a_resonance_where_waves_are_short_is_closed_there() {
    // A spring with a layer that attracts and repels. The region lies between a PD curve and one of grazing, which both end
    // at the resonance p = 1, n = 6, but with different digits.
    let ranges = [[0.8, 1.0], [0.4, 0.43]];
    let model = forced(&format!("-0.06*v - (x + 1) + {LAYER} + mu*cos(eta*t)"), "0", 0.7, ranges);
    let scope = scope(ranges[0], ranges[1], &[2]);
    let diagram = Diagram::compute(&model.oscillator([1.0, 0.4]), &scope, &Silent).expect("it grazes");
    let strip = |eta: f64| -> Vec<[f64; 2]> {
        diagram
            .regions
            .iter()
            .filter(|region| region.loops == 2)
            .flat_map(|region| region.chords(eta))
            .collect()
    };
    let [wide, narrow] = [0.412, 0.419_876].map(strip);
    let ([[from, to]], [_]) = (&wide[..], &narrow[..]) else { panic!("{wide:?} {narrow:?}") };
    // The two-loop solution on which random motion settles, only inside the region.
    let settles = |mu: f64| {
        let oscillator = model.oscillator([mu, 0.412]);
        let mut random = Random::new(27);
        (0..20).any(|_| simulation::settled(&oscillator, &mut random).is_some_and(|it| it.loops == 2))
    };
    let aside = 0.1 * (to - from);
    // Where the region is wide, one state in ten settles there.
    assert!(settles(from + aside) && settles(0.5 * (from + to)), "{from} {to}");
    assert!(!settles(from - aside) && !settles(to + aside), "{from} {to}");
    assert!(diagram.regions.iter().all(|region| region.loops == 0 || region.doubt.is_none()));
}

#[test]
fn narrow_windows_about_a_resonance_are_shaded_as_the_closed_form_says() {
    let oscillator = crate::specimens::closed_form();
    let whole = scope([0.0, 1.3], [0.35, 1.02], &[1, 2, 3]);
    let diagram = Diagram::located(&oscillator, &whole, &Silent).unwrap();
    let mut looked_at = 0;
    for ((resonance, point), half) in
        diagram.unfolding().flat_map(|unfolding| [1e-9, 1e-6, 1e-4].map(|half| (unfolding, half)))
    {
        let about = |centre: f64| [centre - half, centre + half];
        let [primary, secondary] = point.orbit().oscillator().parameters().map(about);
        let narrow = scope(primary, secondary, &[resonance.loops]);
        let regions = Diagram::compute(&oscillator, &narrow, &Silent).unwrap().regions;
        // An undecided region makes no claim.
        let undecided = |region: &Region| region.doubt.is_some();
        if regions.iter().any(undecided) {
            continue;
        }
        looked_at += 1;
        for share in [0.05, 0.25, 0.75, 0.95] {
            for up in [0.2, 0.5, 0.8] {
                let at = narrow.window.parameters([share, up]);
                let grazing = grazing_at(ZETA, at[1]).amplitude();
                // Closer to the curve than this only rounding remains.
                if (at[0] - grazing).abs() < 0.1 * half {
                    continue;
                }
                let shaded =
                    |loops: u32| regions.iter().any(|region| region.loops == loops && region.contains(at));
                let stable = closed_form::orbits(ZETA, EPSILON, at[0], at[1], resonance.loops)
                    .iter()
                    .any(|orbit| orbit.stable() && orbit.admissible());
                assert_eq!(shaded(0), at[0] < grazing, "{at:?}");
                assert_eq!(shaded(resonance.loops), stable, "p = {} at {at:?}", resonance.loops);
            }
        }
    }
    assert!(looked_at >= 19, "{looked_at}");
}

#[test]
fn nothing_beside_a_pole_of_the_force_is_undecided() {
    let (oscillator, scope, _) = counted("afm.toml");
    let diagram = Diagram::compute(&oscillator, &scope, &Silent).expect("there is grazing");
    let undecided = |region: &&Region| region.doubt.is_some();
    assert_eq!(diagram.regions.iter().find(undecided).map(|region| &region.doubt), None);
}

#[test]
fn sketches_of_branches_beside_a_hill_leave_nothing_undecided() {
    let scope = scope([0.0, 1.3708], [0.475, 1.2857], &[3]);
    let oscillator = random(1, 20_261_123).oscillator([0.1, 0.7]);
    let diagram = Diagram::compute(&oscillator, &scope, &Silent).unwrap();
    assert!(diagram.regions.iter().all(|region| region.doubt.is_none()));
}

/// Beside the path over the hill of a softening spring there is any number of folds.
#[test]
fn no_curve_beside_a_hill_is_followed_without_end() {
    let ranges = [[0.0, 1.2], [0.4, 1.2]];
    let scope = scope(ranges[0], ranges[1], &[2]);
    let model = forced("-0.08*v - x - 1 + 0.05*x^3 + mu*cos(eta*t)", "0", 0.8, ranges);
    let diagram = Diagram::compute(&model.oscillator([0.6, 0.8]), &scope, &Silent).unwrap();
    let ends = diagram.curves.iter().map(|curve| (curve.curve.points.len(), &curve.curve.end));
    assert!(ends.clone().count() > 5);
    for (points, end) in ends {
        assert!(!matches!(end, CurveEnd::StepLimit), "{points} points");
    }
}
