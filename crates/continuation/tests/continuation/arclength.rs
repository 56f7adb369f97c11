//! The continuation engine on curves known in closed form.

use grazing_continuation::arclength::{Continuation, CurveEquations, Stall, StepControl};
use grazing_continuation::newton::{Linearisation, NewtonFailure};
use nalgebra::{Matrix2, Vector2};

use crate::specimens::assert_within;

/// A plane curve F(x, y) = 0 on the domain `defined`; it counts the accepted points.
#[derive(Debug)]
struct PlaneCurve {
    /// The values F, ∂F/∂x, ∂F/∂y.
    function: fn(f64, f64) -> [f64; 3],
    defined: fn(f64, f64) -> bool,
}

/// The error outside the domain of a [`PlaneCurve`].
#[derive(Clone, Copy, Debug, PartialEq)]
struct Outside;

impl core::fmt::Display for Outside {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("the curve is not defined here")
    }
}

impl CurveEquations for PlaneCurve {
    type Point = Vector2<f64>;
    type Carried = usize;
    type Failure = Outside;

    fn evaluate(
        &self,
        point: &Vector2<f64>,
        _carried: &mut usize,
    ) -> Result<Linearisation<Vector2<f64>>, Outside> {
        if !(self.defined)(point[0], point[1]) {
            return Err(Outside);
        }
        let [value, by_x, by_y] = (self.function)(point[0], point[1]);
        Ok(Linearisation { residual: Vector2::new(value, 0.0), jacobian: Matrix2::new(by_x, by_y, 0.0, 0.0) })
    }

    fn settle(&self, _point: &Vector2<f64>, carried: &mut usize) {
        *carried += 1;
    }
}

impl PlaneCurve {
    fn everywhere(function: fn(f64, f64) -> [f64; 3]) -> Self {
        Self { function, defined: |_, _| true }
    }

    fn start(
        &self,
        control: StepControl,
        at: [f64; 2],
        to: [f64; 2],
    ) -> Result<Continuation<'_, Self>, Stall<Outside>> {
        Continuation::new(self, control, Vector2::from(at), Vector2::from(to), 0)
    }
}

const CONTROL: StepControl =
    StepControl { first: 1e-3, longest: 0.2, shortest: 1e-8, turn: 0.035, ..StepControl::DRAWING };

#[test]
fn no_step_is_shorter_than_the_shortest_however_much_the_curve_turns() {
    let circle = PlaneCurve::everywhere(|x, y| [x * x + y * y - 1.0, 2.0 * x, 2.0 * y]);
    // Such a step turns the tangent by half a radian, fifteen times the target.
    let control = StepControl { first: 0.5, longest: 1.0, shortest: 0.5, ..CONTROL };
    let mut walker = circle.start(control, [1.0, 0.0], [0.0, 1.0]).unwrap();
    for _ in 0..30 {
        let before = walker.here().clone();
        let advance = before.tangent.dot(&(walker.advance().unwrap().point - before.point));
        // The plane that the corrector works in is met to rounding.
        assert!(advance > 0.5 - 1e-14, "{advance}");
    }
}

#[test]
fn a_circle_is_followed_round_and_round() {
    let circle = PlaneCurve::everywhere(|x, y| [x * x + y * y - 1.0, 2.0 * x, 2.0 * y]);
    let mut walker = circle.start(CONTROL, [1.0, 0.0], [0.0, 1.0]).unwrap();
    let (mut turned, mut before) = (0.0, 0.0);
    for _ in 0..500 {
        let station = walker.advance().unwrap();
        let [x, y] = [station.point[0], station.point[1]];
        // The last Newton step is below 1e-7 and the curvature one: half its square, and a few
        // roundings.
        assert_within(libm::hypot(x, y), 1.0, 6e-15);
        // The tangent is the linearisation's at the last iterate but one, off by the tolerance of
        // 1e-7 at most.
        assert_within((station.tangent - Vector2::new(-y, x)).norm(), 0.0, 1e-7);
        let angle = libm::atan2(y, x);
        let step = angle - before;
        turned += if step < -3.0 { step + core::f64::consts::TAU } else { step };
        before = angle;
    }
    // 500 steps of `turn` are 2.8 turns: four folds in x or y each. The first steps are shorter.
    assert!(
        turned > 2.0 * core::f64::consts::TAU && turned < 500.0 * 1.1 * CONTROL.turn,
        "turned by {turned}"
    );
}

#[test]
fn steps_follow_the_curvature() {
    // On a circle of radius r the tangent turns by s/r, so the steps settle at r times `turn`.
    let circle = PlaneCurve::everywhere(|x, y| [x * x + y * y - 4.0, 2.0 * x, 2.0 * y]);
    let mut walker = circle.start(CONTROL, [2.0, 0.0], [0.0, 1.0]).unwrap();
    for _ in 0..30 {
        walker.advance().unwrap();
    }
    let before = walker.here().point;
    let step = (walker.advance().unwrap().point - before).norm();
    // Chord against arc, and the control's own relaxation: well below a percent.
    assert_within(step / (2.0 * CONTROL.turn), 1.0, 0.01);
}

#[test]
fn steps_on_a_straight_line_grow_to_the_longest_and_no_further() {
    let line = PlaneCurve::everywhere(|x, y| [y - 0.5 * x, -0.5, 1.0]);
    let mut walker = line.start(CONTROL, [0.0, 0.0], [1.0, 0.0]).unwrap();
    let mut steps = Vec::new();
    for _ in 0..30 {
        let before = walker.here().point;
        steps.push((walker.advance().unwrap().point - before).norm());
    }
    assert_within(steps[0], CONTROL.first, 1e-15);
    assert_within(steps[29], CONTROL.longest, 1e-13);
    // Steps grow by less than doubling each, so that one flat place does not lead to a leap.
    assert!(steps.windows(2).all(|pair| pair[1] <= 2.0 * pair[0]), "{steps:?}");
    assert!(steps.windows(2).all(|pair| pair[1] >= pair[0] * (1.0 - 1e-12)), "{steps:?}");
}

#[test]
fn both_folds_of_a_cubic_are_passed() {
    // x³ − x = μ with folds at x = ∓1/√3, μ = ±2/(3√3).
    let cubic = PlaneCurve::everywhere(|mu, x| [x * x * x - x - mu, -1.0, 3.0 * x * x - 1.0]);
    let mut walker = cubic.start(CONTROL, [-6.0, -2.0], [1.0, 1.0]).unwrap();
    let mut folds = Vec::new();
    let mut before = walker.here().clone();
    while before.point[1] < 2.0 {
        let after = walker.advance().unwrap().clone();
        assert!(after.point[1] > before.point[1], "x must grow all along the curve");
        let [mu, x] = [after.point[0], after.point[1]];
        // A last Newton step of 1e-7 with second derivative 6x ≤ 12: half of 12e-14, and rounding
        // errors of six.
        assert_within(x * x * x - x, mu, 7e-14);
        let angle = libm::acos(before.tangent.dot(&after.tangent).min(1.0));
        assert!(angle <= 3.0 * CONTROL.turn + 1e-7, "the tangent turned by {angle} at once");
        if before.tangent[0] * after.tangent[0] < 0.0 {
            folds.push([0.5 * (before.point[0] + mu), 0.5 * (before.point[1] + x)]);
        }
        before = after;
    }
    let at = 1.0 / 3f64.sqrt();
    assert_eq!(folds.len(), 2, "{folds:?}");
    for (fold, x) in folds.iter().zip([-at, at]) {
        // The mid-point of a step; near a fold of radius of curvature 1/6|x| = 0.29 steps are 0.01
        // to 0.03 long.
        assert_within(fold[1], x, 0.03);
        assert_within(fold[0], x * x * x - x, 0.001);
    }
}

#[test]
fn a_sharp_bend_is_met_with_short_steps() {
    // The hyperbola xy = 10⁻³ bends with a radius of √(2·10⁻³) = 0.045. Its other branch is 0.09
    // away there, and steps have to be shorter than that: only the step length keeps a corrector
    // away from the other branch.
    let bend = PlaneCurve::everywhere(|x, y| [x * y - 1e-3, y, x]);
    let control = StepControl { longest: 0.05, ..CONTROL };
    let mut walker = bend.start(control, [1.0, 1e-3], [-1.0, 0.0]).unwrap();
    let mut shortest = f64::INFINITY;
    while walker.here().point[1] < 1.0 {
        let before = walker.here().clone();
        let after = walker.advance().unwrap();
        assert!(after.point[0] > 0.0 && after.point[1] > 0.0, "the other branch was jumped to");
        // The rule of the step control, with the tolerance of the tangents.
        assert!(libm::acos(before.tangent.dot(&after.tangent).min(1.0)) <= 3.0 * CONTROL.turn + 1e-7);
        shortest = shortest.min((after.point - before.point).norm());
    }
    // About the radius times `turn`: the control overshoots, by halving a step that turned too far.
    assert_within(shortest / (0.045 * CONTROL.turn), 0.8, 0.4);
}

#[test]
fn no_step_leads_to_a_parallel_curve() {
    // Two curves 0.13 apart drop by 0.1 within some 0.01. A step across the drop arrives nearer to the other one,
    // whose tangent is the same.
    fn drop(x: f64) -> [f64; 2] {
        let tanh = libm::tanh((x - 1.0) / 0.005);
        [-0.05 * (1.0 + tanh), -10.0 * (1.0 - tanh * tanh)]
    }
    let curves = PlaneCurve::everywhere(|x, y| {
        let [own, slope] = drop(x);
        let [a, b] = [y - own, y - own - 0.13];
        [a * b, -slope * (a + b), a + b]
    });
    let mut walker = curves.start(CONTROL, [0.0, 0.0], [1.0, 0.0]).unwrap();
    while walker.here().point[0] < 2.0 {
        let [x, y] = walker.advance().unwrap().point.into();
        // The last Newton step is below 1e-7, and the drop's second derivative is 1540: half of its square times that, and room
        // for the product of the two curves.
        assert_within(y, drop(x)[0], 1e-10);
    }
}

#[test]
fn points_of_a_sketch_are_as_good_as_its_steps_are_short() {
    // On y = x²/2 as the zeros of the exponential of a thousand times the difference, less one.
    let stiff = PlaneCurve::everywhere(|x, y| {
        let value = libm::exp(1e3 * (y - 0.5 * x * x));
        [value - 1.0, -1e3 * x * value, 1e3 * value]
    });
    let control = StepControl { tolerance: 1e-3, first: 1e-2, longest: 1e-2, ..CONTROL };
    let mut walker = stiff.start(control, [0.0, 0.0], [1.0, 0.0]).unwrap();
    for _ in 0..50 {
        let [x, y] = walker.advance().unwrap().point.into();
        // The last Newton step is no longer than a thousandth of the step; half its square, times a thousand.
        assert_within(y, 0.5 * x * x, 0.5 * 1e3 * 1e-5 * 1e-5);
    }
}

#[test]
fn a_curve_that_ends_stalls_with_the_cause_and_the_shortest_step() {
    // The diagonal up to x = 1 and nothing beyond.
    let curve = PlaneCurve { function: |x, y| [y - x, -1.0, 1.0], defined: |x, _| x <= 1.0 };
    let mut walker = curve.start(CONTROL, [0.0, 0.0], [1.0, 1.0]).unwrap();
    let stall = loop {
        if let Err(stall) = walker.advance() {
            break stall;
        }
    };
    assert!(stall.step <= CONTROL.shortest);
    let NewtonFailure::Undefined { cause: Outside, .. } = stall.failure else {
        panic!("{stall:?}");
    };
    // The last point lies within about a step of the shortest length from the end.
    assert_within(walker.here().point[0], 1.0, 4.0 * CONTROL.shortest);
}

#[test]
fn a_corrector_that_does_not_converge_stalls_with_its_residual() {
    // The line y = 0 up to x = 1, and no zero beyond: 1 + (y − 0.3)² is at least one.
    let broken = PlaneCurve::everywhere(|x, y| {
        if x <= 1.0 { [y, 0.0, 1.0] } else { [1.0 + (y - 0.3) * (y - 0.3), 0.0, 2.0 * (y - 0.3)] }
    });
    let mut walker = broken.start(CONTROL, [0.0, 0.0], [1.0, 0.0]).unwrap();
    let stall = loop {
        if let Err(stall) = walker.advance() {
            break stall;
        }
    };
    assert!(stall.step <= CONTROL.shortest);
    let NewtonFailure::NoConvergence { residual, .. } = stall.failure else {
        panic!("{stall:?}");
    };
    assert!(residual >= 1.0);
    let message = stall.to_string();
    assert!(message.contains("equations are met to 1") && message.contains("step length"), "{message}");
}

#[test]
fn a_start_without_a_unique_tangent_is_refused() {
    let cross = PlaneCurve::everywhere(|x, y| [x * y, y, x]);
    let stall = cross.start(CONTROL, [0.0, 0.0], [1.0, 1.0]).unwrap_err();
    assert!(matches!(stall.failure, NewtonFailure::Singular { .. }), "{stall:?}");
}

#[test]
fn an_undefined_start_is_refused_with_its_cause() {
    let nowhere = PlaneCurve { function: |x, y| [x - y, 1.0, -1.0], defined: |_, _| false };
    let stall = nowhere.start(CONTROL, [0.0, 0.0], [1.0, 1.0]).unwrap_err();
    assert!(matches!(stall.failure, NewtonFailure::Undefined { cause: Outside, .. }), "{stall:?}");
}

#[test]
fn the_direction_decides_which_way_the_curve_is_followed() {
    let circle = PlaneCurve::everywhere(|x, y| [x * x + y * y - 1.0, 2.0 * x, 2.0 * y]);
    for side in [1.0, -1.0] {
        // The direction is far from tangent; only its side matters.
        let mut walker = circle.start(CONTROL, [1.0, 0.0], [5.0, side]).unwrap();
        assert!(side * walker.advance().unwrap().point[1] > 0.0);
    }
}

#[test]
fn the_memory_of_failed_attempts_is_dropped() {
    let circle = PlaneCurve::everywhere(|x, y| [x * x + y * y - 1.0, 2.0 * x, 2.0 * y]);
    // A first step of half a turn is rejected a few times before one is accepted.
    let control = StepControl { first: 2.0, longest: 2.0, ..CONTROL };
    let mut walker = circle.start(control, [1.0, 0.0], [0.0, 1.0]).unwrap();
    for accepted in 1..=5 {
        // One more than the points after the start: the start itself was settled as well.
        assert_eq!(walker.here().carried, accepted);
        walker.advance().unwrap();
    }
}
