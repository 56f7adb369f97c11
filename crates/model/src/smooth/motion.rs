//! Motion of an integrated oscillator between impacts: nodes of the integration, and a step from
//! the nearest one.

use core::cell::RefCell;

use super::enclosure::{Cage, derivatives, enclose, estimate};
use super::integrator::{Node, Step};
use super::oscillator::{Accuracy, Integrated, SmoothOscillator};
use crate::motion::{BoundedMotion, DerivativeBounds, Enclosure, Kinematics, Walk};
use crate::state::State;
use crate::tolerances::MOST_STEPS;

/// Nodes of the solution from a state in one direction of time, computed on demand.
#[derive(Debug)]
struct Course {
    nodes: Vec<Node>,
    /// The cage of the motion between each node and the next.
    cages: Vec<Cage>,
    /// The solution cannot be continued beyond the last node.
    ended: bool,
}

impl Course {
    /// The number of nodes before a time or at it, times being counted away from the start.
    fn nodes_until(&self, start: f64, time: f64) -> usize {
        self.nodes.partition_point(|node| (node.time - start).abs() <= time)
    }

    /// The cages between two times, counted likewise, as far as they have been computed, with the
    /// nodes at their ends.
    fn cages_between(
        &mut self,
        start: f64,
        [begin, end]: [f64; 2],
    ) -> impl Iterator<Item = (&mut Cage, [&Node; 2])> {
        let first = self.nodes_until(start, begin).saturating_sub(1);
        let nodes = self.nodes.windows(2).map(|nodes| [&nodes[0], &nodes[1]]);
        let made = self.cages.iter_mut().zip(nodes).skip(first);
        made.take_while(move |(_, [node, _])| (node.time - start).abs() < end)
    }
}

/// A motion of an [`Integrated`] oscillator.
///
/// The motion exists up to where its solution escapes; beyond, all values are NaN.
#[derive(Debug)]
pub struct IntegratedMotion<M> {
    oscillator: Integrated<M>,
    /// The time t = z/ω at which the motion begins.
    start: f64,
    /// The course forwards in time, then the one backwards.
    courses: [RefCell<Course>; 2],
}

impl<M: SmoothOscillator> IntegratedMotion<M> {
    pub(super) fn new(oscillator: &Integrated<M>, from: State) -> Self {
        let start = from.phase / oscillator.frequency;
        let course = |sign: f64| {
            let first = oscillator.first_node(from, sign);
            RefCell::new(Course { nodes: vec![first], cages: Vec::new(), ended: false })
        };
        Self { oscillator: oscillator.clone(), start, courses: [course(1.0), course(-1.0)] }
    }

    fn course(&self, time: f64) -> &RefCell<Course> {
        &self.courses[usize::from(time < 0.0)]
    }

    /// Adds nodes until the last is as wanted.
    fn extend(&self, course: &mut Course, is_last: impl Fn(&Node) -> bool) {
        while !course.ended {
            let last = course.nodes[course.nodes.len() - 1];
            if is_last(&last) {
                return;
            }
            match self.oscillator.next_node(&last, last.proposal) {
                Some(node) if course.nodes.len() <= MOST_STEPS => course.nodes.push(node),
                _ => course.ended = true,
            }
        }
    }

    /// Adds nodes until the time is passed.
    fn pass(&self, course: &mut Course, time: f64) {
        self.extend(course, |last| (last.time - self.start).abs() > time.abs());
    }

    /// Adds nodes until the time is passed, and cages between them, which for rough motion are
    /// estimates.
    ///
    /// The solution counts as ended where there is no cage, as it is about to escape.
    fn make_cages(&self, course: &mut Course, time: f64) {
        self.pass(course, time);
        for k in course.cages.len()..course.nodes.len() - 1 {
            let [node, next] = [&course.nodes[k], &course.nodes[k + 1]];
            let rough = self.oscillator.accuracy == Accuracy::Rough;
            match if rough { estimate(next) } else { enclose(&self.oscillator, node, next) } {
                Some(cage) => course.cages.push(cage),
                None => {
                    course.nodes.truncate(k + 1);
                    course.ended = true;
                    return;
                }
            }
        }
    }

    /// The index of the last node before or at a time since the start, nodes being added until the
    /// time is passed; `None` if the solution does not get that far.
    fn node_before(&self, course: &mut Course, time: f64) -> Option<usize> {
        self.pass(course, time);
        let passed = course.nodes_until(self.start, time.abs());
        // No node is passed at a time that is NaN.
        (0 < passed && passed < course.nodes.len()).then(|| passed - 1)
    }

    /// Position and velocity at a time since the start; NaN where the solution has ended.
    fn state(&self, time: f64) -> [f64; 2] {
        let course = &mut *self.course(time).borrow_mut();
        let Some(k) = self.node_before(course, time) else { return [f64::NAN; 2] };
        let [node, next] = [&course.nodes[k], &course.nodes[k + 1]];
        let step = self.oscillator.step_between(node, next, self.start + time);
        step.map_or([f64::NAN; 2], |step| step.end(node.state))
    }

    /// Calls `visit` with the start time and the solution of each step up to a time since the
    /// start.
    pub(super) fn for_each_step(&self, time: f64, mut visit: impl FnMut(f64, &Step)) -> Option<()> {
        if time == 0.0 {
            return Some(());
        }
        let course = &mut *self.course(time).borrow_mut();
        let end = self.start + time;
        // The last step ends where the time does, so no node is needed beyond.
        self.extend(course, |last| (last.time + last.proposal - self.start).abs() > time.abs());
        let inside = course.nodes_until(self.start, time.abs());
        for ends in course.nodes[..inside].windows(2) {
            visit(ends[0].time, ends[1].last.as_ref()?);
        }
        let mut node = course.nodes[inside.checked_sub(1)?];
        if let Some(next) = course.nodes.get(inside) {
            if node.time != end {
                visit(node.time, &self.oscillator.step_between(&node, next, end)?);
            }
            return Some(());
        }
        for _ in inside..=MOST_STEPS {
            if node.time == end {
                return Some(());
            }
            let next = self.oscillator.next_node(&node, end - node.time)?;
            visit(node.time, next.last.as_ref()?);
            node = next;
        }
        None
    }

    fn kinematics(&self, [position, velocity]: [f64; 2], t: f64) -> Kinematics {
        let [acceleration, jerk] = derivatives(&self.oscillator, [position, velocity], t);
        Kinematics { position, velocity, acceleration, jerk }
    }
}

impl<M: SmoothOscillator> BoundedMotion for IntegratedMotion<M> {
    fn kinematics_at(&self, time: f64) -> Kinematics {
        self.kinematics(self.state(time), self.start + time)
    }

    fn enclose(&self, horizon: f64) -> impl Enclosure {
        let course = self.course(horizon);
        if horizon != 0.0 {
            self.make_cages(&mut course.borrow_mut(), horizon);
        }
        Boxes { motion: self, course, horizon: horizon.abs() }
    }

    /// The time to the first node beyond the wall: the force farther on is not evaluated, as its
    /// author may not have considered it.
    fn foresight(&self) -> f64 {
        let period = core::f64::consts::TAU / self.oscillator.frequency;
        let mut course = self.courses[0].borrow_mut();
        for k in 1.. {
            let last = course.nodes[k - 1].time - self.start;
            self.pass(&mut course, last);
            match course.nodes.get(k) {
                Some(node) if node.time - self.start >= period => break,
                Some(node) if node.state[0] > 0.0 => return node.time - self.start,
                Some(_) => {}
                None => break,
            }
        }
        period
    }
}

/// An enclosure in which boxes between nodes have been proved to hold the motion.
struct Boxes<'a, M> {
    motion: &'a IntegratedMotion<M>,
    course: &'a RefCell<Course>,
    /// How far the enclosure reaches.
    horizon: f64,
}

impl<M: SmoothOscillator> Boxes<'_, M> {
    /// Bounds between two times, counted away from the start.
    fn joined_bounds(&self, times: [f64; 2]) -> DerivativeBounds {
        let mut course = self.course.borrow_mut();
        let cages = course.cages_between(self.motion.start, times);
        cages.fold(DerivativeBounds::NO_TIME, |all, (cage, nodes)| {
            all.joined(&cage.bounds(&self.motion.oscillator, nodes))
        })
    }
}

impl<M: SmoothOscillator> Enclosure for Boxes<'_, M> {
    fn bounds(&self) -> DerivativeBounds {
        self.joined_bounds([0.0, self.horizon])
    }

    fn acceleration(&self) -> f64 {
        let mut course = self.course.borrow_mut();
        let cages = course.cages_between(self.motion.start, [0.0, self.horizon]);
        cages.fold(0.0, |largest, (cage, _)| cage.acceleration().max(largest))
    }

    fn bounds_between(&self, from: f64, to: f64) -> DerivativeBounds {
        let reached = from.abs() <= to.abs() && to.abs() <= self.horizon;
        if !reached || !core::ptr::eq(self.course, self.motion.course(to)) {
            return DerivativeBounds::UNKNOWN;
        }
        self.joined_bounds([from.abs(), to.abs()])
    }

    fn stride(&self) -> f64 {
        let course = self.course.borrow();
        let boxed = &course.nodes[..=course.cages.len()];
        boxed.windows(2).fold(0.0, |longest, ends| (ends[1].time - ends[0].time).abs().max(longest))
    }

    fn strides(&self) -> usize {
        self.course.borrow().nodes_until(self.motion.start, self.horizon).saturating_sub(1)
    }

    fn time_after(&self, strides: usize) -> f64 {
        self.course.borrow().nodes[strides].time - self.motion.start
    }

    fn walk(&self) -> impl Walk {
        Nodes { motion: self.motion, course: self.course, index: 0 }
    }
}

/// A walk along the motion from node to node, within the part that is enclosed.
#[derive(Debug)]
struct Nodes<'a, M> {
    motion: &'a IntegratedMotion<M>,
    course: &'a RefCell<Course>,
    index: usize,
}

impl<M> Clone for Nodes<'_, M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M> Copy for Nodes<'_, M> {}

impl<M> Nodes<'_, M> {
    fn node(&self) -> Node {
        self.course.borrow().nodes[self.index]
    }
}

impl<M: SmoothOscillator> Walk for Nodes<'_, M> {
    fn position(&self) -> f64 {
        self.node().state[0]
    }

    fn kinematics(&self) -> Kinematics {
        let node = self.node();
        self.motion.kinematics(node.state, node.time)
    }

    fn advance(&mut self) {
        self.index += 1;
    }
}
