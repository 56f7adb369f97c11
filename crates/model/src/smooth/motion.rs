//! Motion of an integrated oscillator between impacts: nodes of the integration, and a step from the nearest one.

use core::cell::RefCell;

use super::integrator::{Node, step};
use super::interval::Interval;
use super::scalar::Scalar;
use super::series::Series;
use super::{Integrated, SmoothOscillator};
use crate::motion::{Bounds, Kinematics, Motion, Walk};
use crate::oscillator::State;

/// Nodes of the solution from a state in one direction of time, found when they are needed.
#[derive(Debug)]
struct Course {
    nodes: Vec<Node>,
    /// Bounds of the derivatives between a node and the next.
    bounds: Vec<Bounds>,
    /// The solution cannot be continued beyond the last node.
    ended: bool,
}

/// A motion of an [`Integrated`] oscillator.
#[derive(Debug)]
pub struct IntegratedMotion<M> {
    oscillator: Integrated<M>,
    /// The time t = z/ω at which it begins.
    start: f64,
    frequency: f64,
    /// Forwards and backwards.
    courses: [RefCell<Course>; 2],
}

/// Strides of the walk along a motion in one forcing period (empirical; any number finds the same events).
const STRIDES: f64 = 16.0;

impl<M: SmoothOscillator> IntegratedMotion<M> {
    pub(super) fn new(oscillator: &Integrated<M>, from: State) -> Self {
        let frequency = oscillator.frequency;
        let period = core::f64::consts::TAU / frequency;
        let start = from.phase / frequency;
        let course = |sign: f64| {
            let first = Node {
                time: start,
                state: [from.position, from.velocity],
                proposal: sign * period / STRIDES,
            };
            RefCell::new(Course { nodes: vec![first], bounds: Vec::new(), ended: false })
        };
        Self { oscillator: oscillator.clone(), start, frequency, courses: [course(1.0), course(-1.0)] }
    }

    fn force(&self, x: f64, y: f64, t: f64) -> f64 {
        let [mu, eta] = self.oscillator.parameters;
        self.oscillator.model.force(x, y, t, mu, eta)
    }

    /// Makes nodes until the time is passed.
    fn extend(&self, course: &mut Course, time: f64) {
        let forwards = time >= 0.0;
        while !course.ended {
            let last = course.nodes[course.nodes.len() - 1];
            let reached = last.time - self.start;
            if (forwards && reached > time) || (!forwards && reached < time) {
                return;
            }
            match last.next(&|x, y, t| self.force(x, y, t), last.proposal) {
                Some(node) => course.nodes.push(node),
                None => course.ended = true,
            }
        }
    }

    /// Position and velocity at a time since the start; not numbers where the solution has ended.
    fn state(&self, time: f64) -> [f64; 2] {
        let mut course = self.courses[usize::from(time < 0.0)].borrow_mut();
        self.extend(&mut course, time);
        let target = self.start + time;
        let passed = course.nodes.partition_point(|node| (node.time - self.start).abs() <= time.abs());
        if passed == course.nodes.len() && course.ended {
            return [f64::NAN; 2];
        }
        let node = course.nodes[passed.max(1) - 1];
        step(&|x, y, t| self.force(x, y, t), node.state, node.time, target - node.time)
    }
}

impl<M: SmoothOscillator> Motion for IntegratedMotion<M> {
    fn at(&self, time: f64) -> Kinematics {
        let [position, velocity] = self.state(time);
        let t = self.start + time;
        let acceleration = self.force(position, velocity, t);
        let [_, jerk, _] = derivatives(&self.oscillator, position, velocity, acceleration, t);
        Kinematics { position, velocity, acceleration, jerk }
    }

    fn bounds(&self, from: f64, to: f64) -> Bounds {
        let mut largest = Bounds { acceleration: 0.0, jerk: 0.0, snap: 0.0 };
        for (course, end) in self.courses.iter().zip([from.max(to).max(0.0), from.min(to).min(0.0)]) {
            let mut course = course.borrow_mut();
            if end == 0.0 {
                continue;
            }
            self.extend(&mut course, end);
            let begin = if from * to > 0.0 { from.abs().min(to.abs()) } else { 0.0 };
            for k in 0..course.nodes.len() - 1 {
                let (node, next) = (course.nodes[k], course.nodes[k + 1]);
                if course.bounds.len() == k {
                    course.bounds.push(enclose(&self.oscillator, &node, &next));
                }
                let here = course.bounds[k];
                let reaches = |node: &Node| (node.time - self.start).abs();
                if reaches(&next) >= begin && reaches(&node) <= end.abs() {
                    largest.acceleration = largest.acceleration.max(here.acceleration);
                    largest.jerk = largest.jerk.max(here.jerk);
                    largest.snap = largest.snap.max(here.snap);
                }
            }
        }
        largest
    }

    fn stride(&self) -> f64 {
        core::f64::consts::TAU / (self.frequency * STRIDES)
    }

    fn walk(&self) -> impl Walk {
        Steps { motion: self, index: 0.0 }
    }
}

/// A walk along the motion.
#[derive(Debug)]
struct Steps<'a, M> {
    motion: &'a IntegratedMotion<M>,
    index: f64,
}

impl<M> Clone for Steps<'_, M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M> Copy for Steps<'_, M> {}

impl<M: SmoothOscillator> Walk for Steps<'_, M> {
    fn position(&self) -> f64 {
        self.motion.state(self.index * self.motion.stride())[0]
    }

    fn kinematics(&self) -> Kinematics {
        self.motion.at(self.index * self.motion.stride())
    }

    fn advance(&mut self) {
        self.index += 1.0;
    }
}

/// ẍ, d³x/dt³ and d⁴x/dt⁴ at a point of the motion, or their ranges, from position, velocity, and acceleration.
fn derivatives<M: SmoothOscillator, C: super::scalar::Coefficient>(
    oscillator: &Integrated<M>,
    x: C,
    y: C,
    acceleration: C,
    t: C,
) -> [C; 3] {
    let zero = C::constant(0.0);
    let [mu, eta] = oscillator.parameters.map(Series::constant);
    let time = Series([t, C::constant(1.0), zero]);
    let force = |x, y| oscillator.model.force(Series(x), Series(y), time, mu, eta).0;
    let [_, jerk, _] = force([x, y, zero], [y, acceleration, zero]);
    let [_, _, snap] = force([x, y, acceleration.scale(0.5)], [y, acceleration, jerk.scale(0.5)]);
    [acceleration, jerk, snap.scale(2.0)]
}

/// A box is tried and grown this often before nothing is said to be known.
const TRIALS: usize = 40;

/// Bounds of the derivatives between two nodes, from a box that the solution cannot leave (Picard's criterion): with F taken
/// over the box, velocity and position stay inside it.
fn enclose<M: SmoothOscillator>(oscillator: &Integrated<M>, node: &Node, next: &Node) -> Bounds {
    let [mu, eta] = oscillator.parameters.map(Interval::constant);
    let time = Interval::new(node.time, next.time);
    let duration = Interval::new(0.0, next.time - node.time);
    let start = node.state.map(Interval::constant);
    let mut guess = [0, 1].map(|i| Interval::new(node.state[i], next.state[i]).grown(0.05));
    for _ in 0..TRIALS {
        let [x, y] = guess;
        let acceleration = oscillator.model.force(x, y, time, mu, eta);
        let reached = [start[0] + duration * y, start[1] + duration * acceleration];
        if guess[0].holds(&reached[0]) && guess[1].holds(&reached[1]) {
            let [x, y] = reached;
            let acceleration = oscillator.model.force(x, y, time, mu, eta);
            let [a, jerk, snap] = derivatives(oscillator, x, y, acceleration, time).map(|c| c.modulus());
            return Bounds { acceleration: a, jerk, snap };
        }
        // Only what is too small grows: the one that is large enough would drive the other on.
        for (guess, reached) in guess.iter_mut().zip(&reached) {
            if !guess.holds(reached) {
                *guess = guess.joined(reached).grown(0.1);
            }
        }
    }
    Bounds { acceleration: f64::INFINITY, jerk: f64::INFINITY, snap: f64::INFINITY }
}
