//! Oscillators with violent solutions without number, and analyses that a limit ends.

use grazing_continuation::curve::{CurveEnd, Window};
use grazing_model::smooth::{Stop, Stoppable};
use grazing_model::{AnyOscillator, LinearOscillator};
use grazing_unfold::Diagram;
use grazing_unfold::diagram::DiagramCurve;
use grazing_unfold::one_parameter::{Cut, Line};
use grazing_unfold::progress::Silent;
use grazing_unfold::regions::Doubt;

use crate::specimens::{described, scope};

/// A well from which motion escapes, with the wall at its top on the other side.
const WELL: &str = "-0.08*v - (x + 0.5) - 0.8*(x + 0.5)^2 + mu*cos(eta*t)";

#[test]
fn curves_that_creep_along_the_edge_of_escape_end_early() {
    let scope = scope([0.04, 0.4], [0.5, 0.7], &[2]);
    let Window { primary, secondary } = scope.window;
    let oscillator = described([WELL, "eta", "0"], 0.85, [primary, secondary]).oscillator([0.2, 0.6]);
    let diagram = Diagram::compute(&oscillator, &scope, &Silent).expect("there is grazing");
    for curve in &diagram.curves {
        let points = curve.curve.points.len();
        assert!(points < 2_000, "{points} points of {:?} to {:?}", curve.kind, curve.curve.end);
        assert!(!matches!(curve.curve.end, CurveEnd::EventNotLocated { .. }), "{:?}", curve.curve.end);
    }
    assert!(diagram.curves.iter().any(|curve| curve.loops == 2));
    let doubts: Vec<_> = diagram.regions.iter().filter_map(|region| region.doubt.as_ref()).collect();
    assert!(doubts.is_empty(), "{doubts:?}");
}

/// Branches lead through motion over the top of a well, and of a spring that gives way at x = 2.2 behind the wall. A point of a
/// sketch may be far off its curve there, and a step may lead to another curve beside it.
#[test]
fn branches_are_followed_through_motion_over_the_top_of_a_potential() {
    let spring = "-0.03358*v - (x + 1) + 0.10048*(x + 1)^3 + mu*cos(eta*t)";
    let cases = [
        (spring, 0.82187, scope([0.0, 2.0046], [0.4645, 1.2706], &[1])),
        (WELL, 0.85, scope([0.0, 0.55], [0.45, 1.75], &[2])),
    ];
    for (force, restitution, scope) in cases {
        let Window { primary, secondary } = scope.window;
        let described = described([force, "eta", "0"], restitution, [primary, secondary]);
        let diagram =
            Diagram::compute(&described.oscillator([0.2, 0.6]), &scope, &Silent).expect("there is grazing");
        let shaded = diagram.regions.iter().filter(|region| region.loops > 0 && region.doubt.is_none());
        assert!(shaded.count() > 0, "{force}");
        let doubts: Vec<_> = diagram.regions.iter().filter_map(|region| region.doubt.as_ref()).collect();
        assert!(doubts.is_empty(), "{force}: {doubts:?}");
    }
}

/// Two sheets of p = 3 come close at A = 0.248, ω = 1.037; a step may lead from one to the other, past a saddle-node that
/// belongs to neither, so that Newton's method finds one at A = 0.2005.
#[test]
fn no_branch_has_the_bifurcations_of_another_one_to_which_a_step_leads() {
    let scope = scope([0.0, 0.55], [0.45, 1.75], &[3]);
    let Window { primary, secondary } = scope.window;
    let oscillator = described([WELL, "eta", "0"], 0.85, [primary, secondary]).oscillator([0.2, 0.6]);
    let range = [0.15, 0.3];
    let line = Line { diagram: 1, primary_is_fixed: false, at: 1.036_969_5, range };
    let cut = Cut::follow(&oscillator, &scope, &[], line, &Silent).expect("nobody stops it");
    let diagram = cut.diagram();
    let steps = diagram.branches.windows(2).filter(|pair| pair[0].branch == pair[1].branch);
    let steps: Vec<f64> = steps.map(|pair| (pair[1].primary - pair[0].primary).abs()).collect();
    // A step is a tenth of the range at most, up to its error.
    let longest = 0.1 * (range[1] - range[0]) + 1e-6;
    assert!(steps.len() > 200 && steps.iter().all(|step| *step <= longest), "{steps:?}");
}

#[test]
fn what_is_decided_when_a_limit_is_reached_is_right_and_the_rest_is_not_finished() {
    let scope = scope([0.0, 1.2], [0.3, 1.1], &[2]);
    let computed = |stop: &Stop| {
        let linear = LinearOscillator::new(0.02, 0.9, 0.5, 0.8).expect("it is in the domain");
        let oscillator = AnyOscillator::new(Stoppable::new(linear, stop.clone()));
        Diagram::compute(&oscillator, &scope, stop).unwrap_or_else(|error| panic!("{error}"))
    };
    let all = Stop::default();
    let whole = computed(&all);
    let holds = |diagram: &Diagram, shaded: bool, at: [f64; 2]| {
        let mut regions = diagram.regions.iter().filter(|region| region.loops == 2);
        regions.any(|region| region.doubt.is_none() == shaded && region.contains(at))
    };
    let mut partly = 0;
    for share in (0..12).map(|k| 0.8 + 0.017 * f64::from(k)) {
        let cut = computed(&Stop::after((share * all.steps() as f64) as u64));
        // Steps are counted in lots, so the last limits may not be reached.
        if cut.unfinished.is_empty() {
            continue;
        }
        let mut doubts = cut.regions.iter().filter_map(|region| region.doubt.as_ref());
        assert!(doubts.all(|doubt| *doubt == Doubt::NotFinished), "{share}");
        for curve in cut.curves.iter().filter(|curve| curve.loops == 2) {
            // An end may be that of another curve, found later.
            let inner = |curve: &DiagramCurve| {
                let points = curve.curve.parameters();
                points[1..points.len() - 1].to_vec()
            };
            let same = |other: &&DiagramCurve| inner(other) == inner(curve);
            let complete = whole.curves.iter().find(same).map(|other| other.n);
            assert_eq!(complete, Some(curve.n), "{share}: {:?}", curve.kind);
        }
        let (mut shaded, mut hatched) = (0, 0);
        for place in (0..2_500).map(|k| [f64::from(k % 50), f64::from(k / 50)]) {
            let at = scope.window.parameters(place.map(|k| (k + 0.43) / 50.0));
            if holds(&cut, false, at) {
                hatched += 1;
            } else {
                assert_eq!(holds(&cut, true, at), holds(&whole, true, at), "{share}: {at:?}");
                shaded += u32::from(holds(&cut, true, at));
            }
        }
        partly += u32::from(shaded > 0 && hatched < 2_500);
    }
    assert!(partly > 0, "{partly}");
}
