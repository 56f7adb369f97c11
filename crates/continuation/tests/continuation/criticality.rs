//! Normal forms of the bifurcations of MPSs against what is created there, solved for and simulated.

use core::f64::consts::TAU;

use grazing_continuation::criticality::{
    CriticalityError, coefficient_at_resonance, generalised_period_doublings, period_doubling, saddle_node,
};
use grazing_continuation::curve::Curve;
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{Formulation, LoopEquations, Memory, Unknowns, unknown};
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::orbit::{FlightEnd, Orbit};
use grazing_model::smooth::{Function, Integrated, Scalar, SmoothOscillator};
use grazing_model::{ImpactOscillator, LinearOscillator, State, ThirdOrder};
use nalgebra::Vector2;

use crate::doubled::doubled;
use crate::specimens::{
    EPSILON, ZETA, assert_close, assert_vanishes, assert_within, located, resonances, route,
};

/// A cubic spring with restitution and impact duration that vary, with positions in units of `length`.
#[derive(Clone, Debug)]
struct Duffing {
    length: f64,
}

impl SmoothOscillator for Duffing {
    fn force<S: Scalar>(&self, x: S, y: S, t: S, amplitude: S, omega: S) -> S {
        let (x, y) = (x.scale(self.length), y.scale(self.length));
        let force = amplitude * (omega * t).apply(Function::Cos)
            - y.scale(2.0 * ZETA)
            - x
            - x.power(3).scale(0.1)
            - S::constant(1.0);
        force.scale(1.0 / self.length)
    }

    fn forcing_frequency<S: Scalar>(&self, _: S, omega: S) -> S {
        omega
    }

    fn restitution<S: Scalar>(&self, y: S, z: S, _: S, _: S) -> S {
        S::constant(EPSILON) - y.scale(0.1 * self.length) - z.apply(Function::Sin).scale(0.02)
    }

    fn impact_duration<S: Scalar>(&self, y: S, _: S, _: S, _: S) -> S {
        (S::constant(0.05) + y.scale(0.01 * self.length)).scale(self.length)
    }
}

/// Resonances of the Duffing oscillator, as p and where Newton's method starts (empirical, by homotopy from the linear one).
const DUFFING: [(u32, [f64; 3]); 2] = [(1, [0.0668, 0.6734, 0.7597]), (2, [0.0868, 0.3983, 0.9134])];

fn duffing(loops: u32, [phase, amplitude, omega]: [f64; 3]) -> ResonantGrazingPoint<Integrated<Duffing>> {
    let oscillator = Integrated::new(Duffing { length: 1.0 }, [amplitude, omega]);
    ResonantGrazingPoint::find(&oscillator, loops, phase).unwrap()
}

/// The SN and PD curves of a resonance.
fn curves<O: ImpactOscillator>(resonance: &ResonantGrazingPoint<O>) -> [Curve; 2] {
    let unfolded = resonance.unfold(&route([0.0, 1.3], [0.35, 1.02], true)).unwrap();
    [unfolded.saddle_node, unfolded.period_doubling]
}

/// Points of a curve away from y = 0, evenly spread over its length.
fn spread(curve: &Curve, count: usize) -> Vec<Unknowns> {
    let all: Vec<Unknowns> = curve.points.iter().map(|point| point.solution.unknowns).collect();
    let away: Vec<Unknowns> = all.into_iter().filter(|point| point[unknown::VELOCITY] > 3e-2).collect();
    (0..count).map(|k| away[k * (away.len() - 1) / (count - 1)]).collect()
}

/// An even function of s without its term of second order, from values at two sizes one of which is half the other.
fn extrapolated([coarse, fine]: [f64; 2]) -> f64 {
    (4.0 * fine - coarse) / 3.0
}

/// c from the doubled orbits, twice: from the parameter at which they are, and from their stability.
///
/// The impacts of a doubled orbit are X(±s), 2qs apart but for terms of third order. With λ = −1 + λ'δ, −s = λs + c s³ gives
/// δ = −c s²/λ', and the derivative of g∘g there, (λ + 3cs²)² = 1 − 4cs² + …, makes c from 1 − T + D, in which the other
/// multiplier is the square of the MPS's. Returns y² times the greatest difference.
fn difference_from_doubled_orbits<O: ThirdOrder>(equations: &LoopEquations<O>, flip: &Unknowns) -> f64 {
    let normal_form = period_doubling(equations, flip).unwrap();
    let determinant = equations.solution(flip).0.multipliers.determinant;
    let measured = [32.0, 64.0].map(|part| {
        let s = flip[unknown::VELOCITY] / part;
        let orbit = doubled(equations, flip, normal_form.direction, s).unwrap();
        let moved = orbit.impacts[0][unknown::PRIMARY] - flip[unknown::PRIMARY];
        let product = 1.0 - orbit.multipliers.trace + orbit.multipliers.determinant;
        let slope = normal_form.multiplier_slopes[0];
        [-slope * moved, 0.25 * product / (1.0 - determinant * determinant)].map(|value| value / (s * s))
    });
    let velocity = flip[unknown::VELOCITY];
    let differences = [0, 1].map(|i| extrapolated(measured.map(|m| m[i])) - normal_form.coefficient);
    velocity * velocity * differences[0].abs().max(differences[1].abs())
}

/// What extrapolation leaves is of fourth order in s/y = 1/32. Rounding is 10⁻¹⁴ (y/s)²/y or so, for impact velocities of 0.03 and
/// more. Values of y² c are 10⁻³ and more, but next to a change of sign.
const BY_EXTRAPOLATION: f64 = 1e-6;

#[test]
fn coefficient_of_a_period_doubling_is_that_of_the_doubled_orbits() {
    for closed_form in resonances(ZETA, EPSILON, &[1, 2, 3], [0.35, 1.02]) {
        let resonance = located(&closed_form);
        let [_, flips] = curves(&resonance);
        for flip in spread(&flips, 7) {
            let difference = difference_from_doubled_orbits(resonance.equations(), &flip);
            assert_within(difference, 0.0, BY_EXTRAPOLATION);
        }
    }
}

#[test]
fn coefficient_is_that_of_the_doubled_orbits_of_a_duffing_oscillator_with_a_varying_reset_law() {
    for (loops, place) in DUFFING {
        let resonance = duffing(loops, place);
        let [_, flips] = curves(&resonance);
        for flip in spread(&flips, 5) {
            let difference = difference_from_doubled_orbits(resonance.equations(), &flip);
            assert_within(difference, 0.0, BY_EXTRAPOLATION);
        }
    }
}

/// The point of a resonance's curve with the impact velocity y.
fn at_velocity<O: ImpactOscillator>(
    resonance: &ResonantGrazingPoint<O>,
    condition: Condition,
    y: f64,
) -> Unknowns {
    let direction = resonance.direction(condition);
    let start = resonance.unknowns() + direction * (y / direction[0]);
    let equations = resonance.equations().with_formulation(Formulation::FixedPhase);
    let conditions = [condition, Condition::ImpactVelocity(y)];
    locate(&equations, conditions, start, &mut Memory::default()).unwrap()
}

/// y² c at points of a resonance's PD curve tends to the closed form in proportion to y. Returns that.
fn assert_limit<O: ThirdOrder>(resonance: &ResonantGrazingPoint<O>) -> f64 {
    let limit = coefficient_at_resonance(resonance.resonant_point());
    // Digits of c are lost in proportion to 1/y.
    assert_vanishes(1.0, 1e-8, |y| {
        if y < 6e-5 {
            return None;
        }
        let flip = at_velocity(resonance, Condition::PERIOD_DOUBLING, y);
        let normal_form = period_doubling(resonance.equations(), &flip).unwrap();
        assert_eq!(normal_form.supercritical(), limit > 0.0);
        // From s along q to s in the impact velocity.
        let q_y = normal_form.direction[0];
        Some(y * y * normal_form.coefficient / (q_y * q_y * limit) - 1.0)
    });
    limit
}

#[test]
fn coefficient_tends_to_its_closed_form_at_a_resonance() {
    for closed_form in resonances(ZETA, EPSILON, &[1, 2, 3], [0.35, 1.02]) {
        let limit = assert_limit(&located(&closed_form));
        // What section 6 has otherwise, and ERRATA.md.
        let even = closed_form.loops() == 1 && closed_form.index() % 2 == 0;
        assert_eq!(limit < 0.0, even, "{closed_form:?}");
    }
    for (loops, place) in DUFFING {
        assert!(assert_limit(&duffing(loops, place)) > 0.0);
    }
}

#[test]
fn criticality_changes_where_two_ways_along_one_curve_say_that_it_does() {
    let mut found = Vec::new();
    for closed_form in resonances(ZETA, EPSILON, &[1, 2, 3], [0.35, 1.02]) {
        let resonance = located(&closed_form);
        let [_, flips] = curves(&resonance);
        for point in generalised_period_doublings(resonance.equations(), &flips.points) {
            let point = point.unwrap();
            let flip = point.unknowns;
            let y = flip[unknown::VELOCITY];
            // To rounding of c, whose terms are of the order of y⁻².
            assert_within(y * y * point.normal_form.coefficient, 0.0, 1e-11);
            let ends = [point.index - 1, point.index].map(|k| {
                let end = flips.points[k].solution.unknowns;
                period_doubling(resonance.equations(), &end).unwrap().supercritical()
            });
            assert_ne!(ends[0], ends[1]);
            // Doubled orbits are then at the parameters of the MPS to higher order.
            let difference = difference_from_doubled_orbits(resonance.equations(), &flip);
            assert_within(difference, 0.0, BY_EXTRAPOLATION);
            found.push((closed_form.loops(), closed_form.index(), flip));
        }
    }
    let names: Vec<(u32, u32)> = found.iter().map(|(loops, index, _)| (*loops, *index)).collect();
    assert_eq!(names, [(1, 4), (1, 3), (2, 1), (1, 2)]);
    // The curve from the resonance with n = 3 is that from the one with n = 2.
    assert_within((found[1].2 - found[3].2).amax(), 0.0, 1e-9);
}

/// The next impact p periods after one of the hybrid system; `None` if the wall is met at another time.
fn next_impact<O: ImpactOscillator>(
    oscillator: &O,
    loops: u32,
    impact: Vector2<f64>,
) -> Option<Vector2<f64>> {
    let period = oscillator.forcing_period();
    let expected = f64::from(loops) * period;
    let start = State::on_wall(impact[0], impact[1]);
    let flight = Orbit::new(oscillator, start, expected + 0.5 * period, usize::MAX).next()?;
    let FlightEnd::Impact(next) = flight.end else { return None };
    let turns = libm::round((next.phase - impact[1]) / TAU);
    ((flight.duration - expected).abs() < 0.25 * period)
        .then(|| Vector2::new(next.velocity, next.phase - turns * TAU))
}

/// Half the distance between successive impacts after many, in units of what it is for the doubled orbit.
///
/// From shares of it; infinite where the loops are left. Parameters are those at which the doubled orbit has impacts X(±s) with
/// s a `part` of y.
fn simulated(
    resonance: &ResonantGrazingPoint<LinearOscillator>,
    y: f64,
    part: f64,
    impacts: usize,
    shares: [f64; 2],
) -> [f64; 2] {
    let flip = at_velocity(resonance, Condition::PERIOD_DOUBLING, y);
    let normal_form = period_doubling(resonance.equations(), &flip).unwrap();
    let s = part * y;
    let primary = flip[unknown::PRIMARY] - normal_form.coefficient * s * s / normal_form.multiplier_slopes[0];
    let conditions = [Condition::Primary(primary), Condition::Secondary(flip[unknown::SECONDARY])];
    let solution = locate(resonance.equations(), conditions, flip, &mut Memory::default()).unwrap();
    assert!(resonance.equations().solution(&solution).0.admissible());
    let oscillator = resonance.equations().oscillator_at(&solution);
    shares.map(|share| {
        let mut here = solution.fixed_rows::<2>(0) + normal_form.direction * (share * s);
        let mut apart = f64::NAN;
        for _ in 0..impacts {
            let Some(next) = next_impact(&oscillator, resonance.loops(), here) else { return f64::INFINITY };
            apart = 0.5 * (next - here).norm() / s;
            here = next;
        }
        apart
    })
}

/// The located resonance with one loop and an index.
fn one_loop(index: u32) -> ResonantGrazingPoint<LinearOscillator> {
    let all = resonances(ZETA, EPSILON, &[1], [0.35, 1.02]);
    located(all.iter().find(|resonance| resonance.index() == index).unwrap())
}

#[test]
fn simulated_orbits_settle_on_the_orbit_that_a_supercritical_period_doubling_creates() {
    // From within and from without. Each impact takes 2c s² off, here 0.008; terms of higher order are (s/y)² = 0.0025.
    let ends = simulated(&one_loop(3), 0.05, 0.05, 2_000, [0.3, 1.6]);
    for end in ends {
        assert_within(end, 1.0, 0.01);
    }
}

#[test]
fn simulated_orbits_beside_a_subcritical_period_doubling_return_or_leave() {
    // The unstable doubled orbit lies between; c is small here, so that many impacts are needed.
    let [within, without] = simulated(&one_loop(4), 0.01, 0.2, 40_000, [0.8, 1.2]);
    assert!(within < 0.4, "{within}");
    assert!(without > 2.4, "{without}");
}

/// a from the branch of MPSs through a saddle-node.
///
/// At the impact velocities y ± q_y s the primary parameter is −(a/b) s² away, but for terms of third order, which cancel in
/// the sum of both, and of fourth. Returns the difference in proportion to a.
fn difference_from_branch<O: ThirdOrder>(equations: &LoopEquations<O>, fold: &Unknowns) -> f64 {
    let normal_form = saddle_node(equations, fold).unwrap();
    let (velocity, q_y) = (fold[unknown::VELOCITY], normal_form.direction[0]);
    let equations = equations.with_formulation(Formulation::FixedPhase);
    let measured = [32.0, 64.0].map(|part| {
        let dy = velocity / part;
        let moved = [dy, -dy].map(|dy| {
            let conditions =
                [Condition::Secondary(fold[unknown::SECONDARY]), Condition::ImpactVelocity(velocity + dy)];
            let found = locate(&equations, conditions, *fold, &mut Memory::default()).unwrap();
            found[unknown::PRIMARY] - fold[unknown::PRIMARY]
        });
        let s = dy / q_y;
        -0.5 * normal_form.parameter_slopes[0] * (moved[0] + moved[1]) / (s * s)
    });
    extrapolated(measured) / normal_form.coefficient - 1.0
}

#[test]
fn coefficient_of_a_saddle_node_is_the_curvature_of_the_branch() {
    for closed_form in resonances(ZETA, EPSILON, &[1, 2, 3], [0.35, 1.02]) {
        let resonance = located(&closed_form);
        let [folds, _] = curves(&resonance);
        for fold in spread(&folds, 5) {
            let difference = difference_from_branch(resonance.equations(), &fold);
            assert_within(difference, 0.0, BY_EXTRAPOLATION);
        }
    }
    for (loops, place) in DUFFING {
        let resonance = duffing(loops, place);
        let [folds, _] = curves(&resonance);
        for fold in spread(&folds, 5) {
            let difference = difference_from_branch(resonance.equations(), &fold);
            assert_within(difference, 0.0, BY_EXTRAPOLATION);
        }
    }
}

/// The slope dμ/dη of a curve at a point, by central differences.
fn slope<O: ImpactOscillator>(equations: &LoopEquations<O>, condition: Condition, point: &Unknowns) -> f64 {
    let equations = equations.with_formulation(Formulation::FixedPhase);
    // Curves bend within parameter changes of the order of y.
    let h = 1e-4 * point[unknown::VELOCITY];
    let primary = |eta: f64| {
        let conditions = [condition, Condition::Secondary(eta)];
        locate(&equations, conditions, *point, &mut Memory::default()).unwrap()[unknown::PRIMARY]
    };
    let eta = point[unknown::SECONDARY];
    (primary(eta + h) - primary(eta - h)) / (2.0 * h)
}

#[test]
fn parameter_slopes_vanish_along_the_curves() {
    let resonance = duffing(DUFFING[0].0, DUFFING[0].1);
    for y in [0.02, 0.05, 0.1] {
        let fold = at_velocity(&resonance, Condition::SADDLE_NODE, y);
        let flip = at_velocity(&resonance, Condition::PERIOD_DOUBLING, y);
        let equations = resonance.equations();
        for (slopes, slope) in [
            (
                saddle_node(equations, &fold).unwrap().parameter_slopes,
                slope(equations, Condition::SADDLE_NODE, &fold),
            ),
            (
                period_doubling(equations, &flip).unwrap().multiplier_slopes,
                slope(equations, Condition::PERIOD_DOUBLING, &flip),
            ),
        ] {
            // Differences with h = 10⁻⁴ y: (h/y)² times some hundred, and rounding of μ, 10⁻¹⁴/h.
            assert_within(slopes[0] * slope + slopes[1], 0.0, 1e-5 * slopes.norm());
        }
    }
}

#[test]
fn another_unit_of_length_changes_coefficients_as_it_must() {
    let length = 2.5;
    for (loops, place) in DUFFING {
        let resonance = duffing(loops, place);
        let other = Integrated::new(Duffing { length }, [place[1], place[2]]);
        let other = LoopEquations::new(other, loops, Formulation::FixedPhase);
        let moved = |point: &Unknowns| {
            let mut point = *point;
            point[unknown::VELOCITY] /= length;
            point
        };
        // How long a unit vector of the one is in the other.
        let stretch = |q: Vector2<f64>| Vector2::new(length * q[0], q[1]).norm();
        for y in [0.02, 0.1] {
            let flip = at_velocity(&resonance, Condition::PERIOD_DOUBLING, y);
            let ours = period_doubling(resonance.equations(), &flip).unwrap();
            let theirs = period_doubling(&other, &moved(&flip)).unwrap();
            let factor = stretch(theirs.direction);
            // Both are integrated to 10⁻¹² or so, divided by y² at most.
            assert_close(theirs.coefficient, ours.coefficient * factor * factor, 1e-7);
            assert_eq!(theirs.supercritical(), ours.supercritical());
            let fold = at_velocity(&resonance, Condition::SADDLE_NODE, y);
            let ours = saddle_node(resonance.equations(), &fold).unwrap();
            let theirs = saddle_node(&other, &moved(&fold)).unwrap();
            assert_close(theirs.coefficient, ours.coefficient * stretch(theirs.direction), 1e-7);
        }
    }
}

#[test]
fn integrated_and_closed_form_have_the_same_normal_forms() {
    let closed = one_loop(3);
    let integrated = LoopEquations::new(
        Integrated::new(Linear, closed.orbit().oscillator().parameters()),
        1,
        Formulation::FixedPhase,
    );
    for y in [0.01, 0.1, 0.3] {
        let flip = at_velocity(&closed, Condition::PERIOD_DOUBLING, y);
        let [a, b] = [period_doubling(closed.equations(), &flip), period_doubling(&integrated, &flip)];
        // Derivatives agree to 10⁻¹², and are divided by y² at most.
        assert_close(b.unwrap().coefficient, a.unwrap().coefficient, 1e-8);
    }
}

/// The paper's oscillator, given by its force.
#[derive(Clone, Debug)]
struct Linear;

impl SmoothOscillator for Linear {
    fn force<S: Scalar>(&self, x: S, y: S, t: S, amplitude: S, omega: S) -> S {
        amplitude * (omega * t).apply(Function::Cos) - y.scale(2.0 * ZETA) - x - S::constant(1.0)
    }

    fn forcing_frequency<S: Scalar>(&self, _: S, omega: S) -> S {
        omega
    }

    fn restitution<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
        S::constant(EPSILON)
    }

    fn impact_duration<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
        S::constant(0.0)
    }
}

#[test]
fn points_that_are_no_simple_bifurcation_have_no_normal_form() {
    let resonance = one_loop(3);
    let equations = resonance.equations();
    assert_eq!(period_doubling(equations, &resonance.unknowns()), Err(CriticalityError::Grazing));

    let flip = at_velocity(&resonance, Condition::PERIOD_DOUBLING, 0.1);
    let off = flip + Unknowns::new(0.0, 0.01, 0.0, 0.0);
    let Err(CriticalityError::NotPeriodic { distance }) = period_doubling(equations, &off) else {
        panic!("a point that is no MPS has a normal form");
    };
    assert!(distance > 1e-4);

    let Err(CriticalityError::NotABifurcation { multiplier, distance }) = saddle_node(equations, &flip)
    else {
        panic!("a period doubling is taken for a saddle-node");
    };
    // The other multiplier −D is smaller than 1, and the one at −1 is no nearer.
    let determinant = equations.solution(&flip).0.multipliers.determinant;
    assert_eq!(multiplier, 1.0);
    assert_within(distance, 2.0 * (1.0 + determinant) / (1.0 - determinant), 1e-6);

    // With a restitution that makes up for the loss of energy, D = 1, both multipliers are −1 there.
    let omega = flip[unknown::SECONDARY];
    let elastic = libm::exp(TAU * ZETA / omega);
    let mut point = flip;
    for k in 1..=20 {
        let epsilon = EPSILON + (elastic - EPSILON) * f64::from(k) / 20.0;
        let oscillator = LinearOscillator::new(ZETA, epsilon, point[unknown::PRIMARY], omega).unwrap();
        let equations = LoopEquations::new(oscillator, 1, Formulation::FixedPhase);
        let conditions = [Condition::PERIOD_DOUBLING, Condition::Secondary(omega)];
        point = locate(&equations, conditions, point, &mut Memory::default()).unwrap();
        let outcome = period_doubling(&equations, &point);
        let degenerate = matches!(outcome, Err(CriticalityError::Degenerate { .. }));
        assert_eq!(degenerate, k == 20, "{outcome:?}");
    }
}
