//! The curves from all resonances of the two-parameter diagram: their ends, where they meet, and a
//! comparison of every point with the simulated hybrid system.

use std::sync::OnceLock;

use grazing_continuation::curve::{Curve, CurveEnd, CurvePoint, Event, Route, SolutionCurve};
use grazing_continuation::locate::Condition;
use grazing_continuation::locate::same_point;
use grazing_continuation::mps::{PeriodicSolution, Unknowns};
use grazing_continuation::resonance::{ResonantGrazingPoint, UnfoldedResonance};
use grazing_model::LinearOscillator;
use grazing_theorems::Resonance;

use crate::hybrid::{assert_returns, assert_touches, simulated_multipliers};
use crate::specimens::{EPSILON, ZETA, assert_within, at_grazing, located, resonances, route};

const FREQUENCIES: [f64; 2] = [0.35, 1.02];

struct Unfolded {
    closed_form: Resonance,
    located: ResonantGrazingPoint<LinearOscillator>,
    curves: UnfoldedResonance,
}

fn window() -> Route<'static> {
    route([0.0, 1.3], FREQUENCIES, true)
}

/// All resonances with p = 1, 2, 3 and their curves.
fn unfolded() -> &'static [Unfolded] {
    static ALL: OnceLock<Vec<Unfolded>> = OnceLock::new();
    ALL.get_or_init(|| {
        let unfold = |closed_form: Resonance| {
            let located = located(&closed_form);
            let curves = located.unfold(&window()).unwrap();
            Unfolded { closed_form, located, curves }
        };
        resonances(ZETA, EPSILON, &[1, 2, 3], FREQUENCIES).into_iter().map(unfold).collect()
    })
}

impl Unfolded {
    fn all(&self) -> impl Iterator<Item = &Curve> {
        self.curves.curves()
    }

    fn name(&self) -> (u32, u32) {
        (self.closed_form.loops(), self.closed_form.index())
    }
}

/// The kinds of ends that a curve can have if all is well.
#[derive(Debug, PartialEq)]
enum Kind {
    /// An end at an interior grazing: SN-GZ or PD-GZ.
    InteriorGrazing,
    /// The end of a GZ curve at a period doubling: PD-GZ.
    PeriodDoubling,
    /// An end at y = 0 on the grazing curve.
    Grazing,
    Edge,
}

fn kind(curve: &Curve) -> Kind {
    match &curve.end {
        CurveEnd::Event(event) if event.condition == Condition::InteriorGrazing => Kind::InteriorGrazing,
        CurveEnd::Event(event) if event.condition == Condition::PERIOD_DOUBLING => Kind::PeriodDoubling,
        CurveEnd::Grazing => Kind::Grazing,
        CurveEnd::LeftWindow => Kind::Edge,
        end => panic!("{:?} ends in {end:?}", curve.condition),
    }
}

#[test]
fn every_curve_ends_where_the_diagram_has_it_end() {
    use Kind::{Edge, Grazing, InteriorGrazing, PeriodDoubling};
    for unfolded in unfolded() {
        let ends = unfolded.all().map(kind).collect::<Vec<_>>();
        let expected = match unfolded.name() {
            // The three highest regions reach beyond the window or to the resonance of all p near
            // ω = 1.
            (1, 2) => vec![Edge, Grazing],
            (1, 3) => vec![InteriorGrazing, Grazing, Edge],
            (2, 1) => vec![InteriorGrazing, Grazing, Grazing],
            // All others are closed: resonance, SN-GZ, PD-GZ.
            _ => vec![InteriorGrazing, InteriorGrazing, PeriodDoubling],
        };
        assert_eq!(ends, expected, "{:?}", unfolded.name());
    }
    let names = unfolded().iter().map(Unfolded::name).collect::<Vec<_>>();
    assert_eq!(names, [(1, 5), (2, 2), (3, 2), (1, 4), (1, 3), (2, 1), (3, 1), (1, 2)]);
}

fn codimension_two_end(curve: &Curve) -> Option<&Event> {
    match &curve.end {
        CurveEnd::Event(event) => Some(event),
        _ => None,
    }
}

#[test]
fn grazing_curve_starts_at_the_end_of_sn_and_arrives_at_the_end_of_pd() {
    for unfolded in unfolded() {
        let UnfoldedResonance { saddle_node, period_doubling, grazing, missing } = &unfolded.curves;
        assert!(missing.is_empty(), "{missing:?}");
        for curve in grazing {
            let start = &codimension_two_end(saddle_node).unwrap().solution.unknowns;
            assert!(same_point(start, &curve.points[0].solution.unknowns));
            if let (Some(from_pd), Some(from_gz)) =
                (codimension_two_end(period_doubling), codimension_two_end(curve))
            {
                // Two routes to one point, each located to rounding with a condition of the system
                // below 10³.
                assert_within((&from_pd.solution.unknowns - &from_gz.solution.unknowns).norm(), 0.0, 1e-11);
            }
        }
    }
}

#[test]
fn grazing_curve_from_the_end_of_pd_comes_back_to_the_end_of_sn() {
    let mut compared = 0;
    for unfolded in unfolded() {
        let UnfoldedResonance { saddle_node, period_doubling, .. } = &unfolded.curves;
        let (Some(sn), Some(pd)) = (codimension_two_end(saddle_node), codimension_two_end(period_doubling))
        else {
            continue;
        };
        let arrived = [1.0, -1.0].into_iter().any(|side| {
            let curve = SolutionCurve {
                equations: unfolded.located.equations().clone(),
                condition: Condition::InteriorGrazing,
            };
            let direction = Unknowns::new(side, 0.0, 0.0, 0.0);
            let curve =
                curve.follow(pd.solution.unknowns.clone(), direction, pd.times.clone(), &window()).unwrap();
            codimension_two_end(&curve).is_some_and(|end| {
                end.condition == Condition::SADDLE_NODE
                    && (&end.solution.unknowns - &sn.solution.unknowns).norm() < 1e-11
            })
        });
        assert!(arrived, "{:?}", unfolded.name());
        compared += 1;
    }
    assert_eq!(compared, 5);
}

#[test]
fn curves_that_end_at_grazing_end_at_resonances() {
    for unfolded in unfolded() {
        for curve in unfolded.all().filter(|curve| matches!(curve.end, CurveEnd::Grazing)) {
            let end = curve.points.last().unwrap().solution.unknowns.clone();
            let (grazing, _) = at_grazing(ZETA, EPSILON, end[3]);
            assert_eq!(end[0], 0.0);
            assert_within(end[2], grazing.amplitude(), 1e-12);
            // det J = α a₁₂ ω S_p / γ vanishes there.
            assert_within(grazing.grazing_point().impact_jacobian_determinant(unfolded.name().0), 0.0, 1e-10);
        }
    }
}

#[test]
fn every_point_fulfils_the_condition_of_its_curve() {
    for unfolded in unfolded() {
        for curve in unfolded.all() {
            // The last point of a GZ curve at y = 0 is a branch point and has no multipliers.
            for CurvePoint { solution, .. } in
                curve.points.iter().filter(|point| point.solution.impact_velocity() > 0.0)
            {
                let multipliers = solution.multipliers;
                match curve.condition {
                    // The points solve det(L − λR) = 0 to 10⁻¹⁴ or so; T and D follow from it by
                    // division by y ≥ 10⁻⁴.
                    Condition::Multiplier(value) => {
                        assert_within(1.0 - value * multipliers.trace + multipliers.determinant, 0.0, 1e-9);
                    }
                    _ => assert_within(solution.ceiling(), 0.0, PeriodicSolution::TOUCH),
                }
            }
        }
    }
}

#[test]
fn every_point_is_an_orbit_of_the_hybrid_system() {
    let (mut returned, mut touched) = (0, 0);
    for unfolded in unfolded() {
        for curve in unfolded.all() {
            // Below y = 10⁻³ the time of the impact is no longer known to 10⁻⁹.
            for CurvePoint { solution, .. } in
                curve.points.iter().filter(|point| point.solution.impact_velocity() > 1e-3)
            {
                let oscillator = unfolded.located.equations().oscillator_at(&solution.unknowns);
                if solution.ceiling() < -PeriodicSolution::TOUCH {
                    assert_returns(&oscillator, solution);
                    returned += 1;
                } else {
                    assert_touches(&oscillator, solution);
                    touched += 1;
                }
            }
        }
    }
    assert!(returned > 500 && touched > 500, "{returned} {touched}");
}

#[test]
fn multipliers_are_those_of_the_simulated_stroboscopic_map() {
    let mut compared = 0;
    for unfolded in unfolded() {
        for curve in [&unfolded.curves.saddle_node, &unfolded.curves.period_doubling] {
            for CurvePoint { solution, .. } in &curve.points {
                let velocity = solution.impact_velocity();
                // The displaced orbits must not reach the wall in another loop.
                if velocity < 5e-3 || solution.ceiling() > -1e-4 {
                    continue;
                }
                let oscillator = unfolded.located.equations().oscillator_at(&solution.unknowns);
                // A displacement δ changes the square of the impact velocity by about 2γδ: the map
                // is smooth on the scale y². The error of the differences is (h/y²)² ≤ 10⁻⁶ and
                // 10⁻¹⁵/(h y) ≤ 10⁻⁵.
                let step = (1e-3 * velocity * velocity).min(1e-6);
                let simulated = simulated_multipliers(&oscillator, solution, step).unwrap();
                let scale = 1.0 + solution.multipliers.trace.abs();
                assert_within(simulated.trace, solution.multipliers.trace, 1e-5 * scale);
                assert_within(simulated.determinant, solution.multipliers.determinant, 1e-5 * scale);
                compared += 1;
            }
        }
    }
    assert!(compared > 500, "{compared}");
}
