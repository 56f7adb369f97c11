//! Codimension-two points at which a second interior maximum touches the wall.

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo};
use grazing_continuation::curve::CurveEnd;
use grazing_continuation::locate::{Condition, locate, same_point};
use grazing_continuation::mps::{Formulation, LoopEquations, unknown};
use grazing_model::motion::Motion;
use grazing_model::{ImpactOscillator, OnWall, State};
use grazing_unfold::Diagram;
use grazing_unfold::diagram::DiagramCurve;
use grazing_unfold::progress::Silent;

use crate::specimens::{assert_within, example, scope};

#[test]
fn grazing_goes_on_with_another_maximum_where_a_second_one_touches_the_wall() {
    let (oscillator, _) = example("varying-impact.toml");
    let scope = scope([0.0, 1.2], [0.4, 0.6], &[2]);
    let diagram = Diagram::compute(&oscillator, &scope, &Silent).unwrap();
    let meeting: Vec<_> = diagram
        .codimension_two
        .iter()
        .filter(|corner| corner.kind == CodimensionTwo::GrazingGrazing)
        .collect();
    let [corner] = meeting.as_slice() else { panic!("{} of them", meeting.len()) };
    let [velocity, phase, primary, secondary] = corner.unknowns().into();

    let meets = |curve: &&DiagramCurve| {
        let points = &curve.curve.points;
        let mut ends = [points.first(), points.last()].into_iter().flatten();
        curve.kind == Bifurcation::Grazing
            && ends.any(|end| same_point(&end.solution.unknowns, &corner.unknowns()))
    };
    let curves: Vec<_> = diagram.curves.iter().filter(meets).collect();
    let [before, after] = curves.as_slice() else { panic!("{} of them", curves.len()) };
    let [reached, begun] = [before.curve.points.last().unwrap(), &after.curve.points[0]];
    assert!(same_point(&reached.solution.unknowns, &corner.unknowns()));
    assert!(same_point(&begun.solution.unknowns, &corner.unknowns()));
    assert!(matches!(after.curve.end, CurveEnd::Grazing));

    // The maxima that touch the wall on the two curves are different ones, and both do at the
    // corner.
    let here = oscillator.with_parameters([primary, secondary]);
    let recoil = here.reset::<1>(OnWall::new(velocity, phase)).value;
    let motion = here.motion(State::on_wall(recoil[0], recoil[1]));
    let points = [&before.curve.points[before.curve.points.len() - 2], &after.curve.points[1]];
    let times = points.map(|point| point.solution.highest_interior_maximum.unwrap().time).map(|near| {
        (0..20).fold(near, |time, _| {
            let now = motion.at(time);
            time - now.velocity / now.acceleration
        })
    });
    assert!((times[0] - times[1]).abs() > 1.0);
    // Each curve holds its own maximum at the wall up to the corner.
    let equations = LoopEquations::new(oscillator.clone(), 2, Formulation::FixedPhase);
    for (end, beside) in [reached, begun].into_iter().zip(points) {
        let near = (&end.solution.unknowns + &beside.solution.unknowns) * 0.5;
        let conditions = [Condition::InteriorGrazing, Condition::Secondary(near[unknown::SECONDARY])];
        let found = [end, beside].map(|point| {
            locate(&equations, conditions, near.clone(), &mut point.times.clone())
                .expect("a point of the curve")
        });
        assert!((&found[0] - &found[1]).norm() < 1e-9, "{found:?}");
    }
    for time in times {
        // Located to the tolerance of Newton's method.
        assert_within(motion.at(time).position, 0.0, 1e-11);
    }
    for point in before.curve.points.iter().chain(&after.curve.points).skip(1) {
        assert!(point.solution.stable() || point.solution.impact_velocity() == 0.0);
        assert_within(point.solution.ceiling(), 0.0, 1e-11);
    }
    // Together they close the region of stable solutions.
    let closed = diagram.regions.iter().filter(|region| (region.loops, region.n) == (2, 2));
    let at_corner = |vertex: &[f64; 2]| libm::hypot(vertex[0] - primary, vertex[1] - secondary) < 1e-12;
    let corners = closed.filter(|region| region.rings.iter().flatten().any(at_corner));
    assert_eq!(corners.count(), 1);
}
