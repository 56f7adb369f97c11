//! The inequalities that prove a row. Each holds for all ν of an interval by Taylor's theorem: three
//! coefficients at its base, and the fourth over all of it.

use crate::ball::{Ball, Number};
use crate::orbit::{Family, Motion, Oscillator};
use crate::row::{Base, Block, Clearance, Interval, WITNESS_BITS, Witness};
use crate::series::Series;

/// The motions with one impact over an interval of ν.
pub struct Model<'a> {
    oscillator: &'a Oscillator,
    interval: Interval,
    at_origin: At,
    over_all: At,
    /// The values of `u`.
    offset: Ball,
}

/// The motions as functions of ν, by their Taylor coefficients at one ν, or over an interval.
#[derive(Clone, Copy)]
pub struct At {
    family: Family<Series>,
    offset: Series,
}

impl At {
    /// A witness as a function of ν.
    pub fn witness<const N: usize>(&self, witness: Witness<N>) -> Series {
        witness.iter().rev().fold(Ball::ZERO.into(), |sum: Series, &coefficient| {
            sum * self.offset + Ball::dyadic(coefficient, WITNESS_BITS).into()
        })
    }
}

/// A velocity at impact, as a function of ν.
pub type Velocity<'v> = dyn Fn(&At) -> Series + 'v;

/// Something that happens as the velocity increases from zero.
#[derive(Clone, Copy)]
enum Event<'b> {
    /// Motion becomes stable.
    Stability,
    /// It touches the wall in a block.
    Contact(&'b Block),
}

impl<'a> Model<'a> {
    /// Over an interval.
    pub fn over(oscillator: &'a Oscillator, interval: Interval) -> Self {
        Self::new(oscillator, interval, interval.origin(), interval.all())
    }

    /// At one ν of it.
    pub fn at(oscillator: &'a Oscillator, interval: Interval, nu: Ball) -> Self {
        Self { offset: Ball::ZERO, ..Self::new(oscillator, interval, nu, nu) }
    }

    fn new(oscillator: &'a Oscillator, interval: Interval, origin: Ball, all: Ball) -> Self {
        let [at_origin, over_all] = [origin, all].map(|nu| {
            let variable = Series::variable(nu);
            let offset = variable - interval.origin().into();
            At { family: oscillator.family(interval.p, variable), offset }
        });
        Self { oscillator, interval, at_origin, over_all, offset: all - origin }
    }

    /// Whether stability begins with a multiplier 1, at the velocity `b/P`; with −1, at `−b/Q`, otherwise.
    pub fn begins_at_saddle_node(&self) -> bool {
        self.at_origin.family.b.0[0].is_positive()
    }

    /// The velocity above which motion is stable.
    pub fn limit(&self) -> impl Fn(&At) -> Series {
        let saddle_node = self.begins_at_saddle_node();
        move |at| {
            let Family { b, big_p, big_q, .. } = at.family;
            if saddle_node { b * big_p.inverse() } else { -b * big_q.inverse() }
        }
    }

    /// What functions of ν may be anywhere in the interval. Each comes with its order: how often it
    /// vanishes at a resonance of one loop. There it is divided by that power of `|u|`.
    fn range<const N: usize>(&self, functions: impl Fn(&At) -> [(Series, usize); N]) -> [Ball; N] {
        let (origin, all) = (functions(&self.at_origin), functions(&self.over_all));
        core::array::from_fn(|i| {
            let order = if self.interval.base == Base::Middle { 0 } else { origin[i].1 };
            let quotient = origin[i].0.with_remainder(all[i].0).divided(order);
            let values = quotient.values(self.offset);
            if self.interval.base == Base::Right && order % 2 == 1 { -values } else { values }
        })
    }

    /// `v`, `b`, and the conditions of stability `P v − b > 0` and `Q v + b > 0`.
    fn conditions(&self, velocity: &Velocity<'_>) -> [Ball; 4] {
        self.range(|at| {
            let (v, Family { b, big_p, big_q, .. }) = (velocity(at), at.family);
            [v, b, big_p * v - b, big_q * v + b].map(|function| (function, 1))
        })
    }

    /// Whether the motion with this velocity is stable.
    pub fn stable(&self, velocity: &Velocity<'_>) -> bool {
        let [v, _, below, above] = self.conditions(velocity);
        [v, below, above].into_iter().all(Ball::is_positive)
    }

    /// Whether no motion with a velocity from 0 to this one is stable: one of the conditions, which
    /// are linear, fails at both ends.
    pub fn unstable(&self, velocity: &Velocity<'_>) -> bool {
        let [v, b, below, above] = self.conditions(velocity);
        let saddle_node = b.is_positive() && below.is_negative();
        let period_doubling = b.is_negative() && above.is_negative();
        v.is_positive() && (saddle_node || period_doubling)
    }

    /// Whether the motion with this velocity is beyond the wall at a time between its impacts. So are
    /// then all motions with greater velocities.
    pub fn beyond(&self, velocity: &Velocity<'_>, touch: Witness<2>) -> bool {
        self.beyond_at_order(velocity, touch, 2)
    }

    fn beyond_at_order(&self, velocity: &Velocity<'_>, touch: Witness<2>, order: usize) -> bool {
        let [v, distance, time] = self.range(|at| {
            let (v, time) = (velocity(at), at.witness(touch));
            [(v, order - 1), (self.oscillator.distance(&at.family.motion(v), time, 0), order), (time, 0)]
        });
        let rest = Ball::from(self.interval.p) - time;
        distance.is_negative() && [v, time, rest].into_iter().all(Ball::is_positive)
    }

    /// Whether all motions are beyond the wall at this time, a whole turn: at `v = 1` is enough, since
    /// the distance there is proportional to v.
    pub fn blocked(&self, turn: Witness<2>) -> bool {
        self.beyond_at_order(&|_| Ball::ONE.into(), turn, 1)
    }

    /// At a resonance of one loop the wall is reached at the first whole turn whatever the velocity:
    /// whether all motions cross it there.
    pub fn crosses_at_resonance(&self) -> bool {
        let family = self.oscillator.family(self.interval.p, self.interval.origin());
        self.oscillator.distance(&family.motion(Ball::ONE), Ball::ONE, 1).is_not_zero()
    }

    /// The amplitude at which motion has this velocity.
    pub fn amplitude(&self, velocity: &Velocity<'_>) -> Ball {
        let square = |at: &At| self.oscillator.amplitude_square(&at.family.motion(velocity(at)));
        let [square] = self.range(|at| [(square(at), 0)]);
        square.sqrt()
    }

    /// An upper bound of the square of how much the amplitude changes from one velocity to another with
    /// this difference: `dA/dv ≤ A_graz √(c² + w²)`.
    pub fn amplitude_step_square(&self, difference: Witness<3>) -> Ball {
        let [square] = self.range(|at| {
            let (Family { nu, c, w, .. }, step) = (at.family, at.witness(difference));
            [(self.oscillator.grazing_square(nu) * (c * c + w * w) * step * step, 0)]
        });
        square.top()
    }

    /// All motions with velocities from one to another, for all ν of the interval at once, as functions
    /// of another variable.
    fn motion(&self, velocities: [&Velocity<'_>; 2]) -> Motion<Series> {
        let [a, b] = velocities.map(|velocity| {
            self.range(|at| {
                let Motion { forced, free, .. } = at.family.motion(velocity(at));
                [forced[0], forced[1], free[0], free[1]].map(|function| (function, 0))
            })
        });
        let [cosine, sine, c, e] = core::array::from_fn(|i| Ball::between(a[i], b[i]).into());
        Motion { nu: self.interval.all().into(), forced: [cosine, sine], free: [c, e] }
    }

    /// Bounds, in a cell of time, of the distance from the wall and its first two derivatives in θ.
    fn cell(&self, motion: &Motion<Series>, index: i64, cells: i64) -> [Ball; 3] {
        let middle = Ball::ratio(2 * index + 1, 2 * cells);
        let all = middle + Ball::ratio(1, 2 * cells).size();
        let [at_middle, over_all] = [middle, all].map(|turns| {
            let in_angle = Series([turns, (Ball::PI + Ball::PI).inverse(), Ball::ZERO, Ball::ZERO]);
            self.oscillator.distance(motion, in_angle, 0)
        });
        let distance = at_middle.with_remainder(over_all);
        let (slope, offset) = (distance.derivative(), (Ball::PI * Ball::ratio(1, cells)).size());
        [distance, slope, slope.derivative()].map(|function| function.values(offset))
    }

    /// Shows, if it can, that motion with velocities from `lower` to `upper` touches the wall nowhere
    /// between its impacts but in blocks, where the distance has a positive second derivative, so that
    /// there is one contact in each at most; and that at `lower` it touches it nowhere. Each period is cut
    /// into this many cells; `nearest` guesses when a block, by its ends, is nearest.
    pub fn clearance(
        &self,
        [lower, upper]: [&Velocity<'_>; 2],
        cells: i64,
        nearest: impl Fn([i64; 2]) -> Witness<2>,
    ) -> Option<Clearance> {
        let motion = self.motion([lower, upper]);
        let bounds: Vec<[Ball; 3]> =
            (0..self.interval.p * cells).map(|index| self.cell(&motion, index, cells)).collect();
        let clear = |[distance, ..]: &[Ball; 3]| distance.is_positive();
        let start = bounds.iter().position(clear)?;
        let end = bounds.iter().rposition(clear)? + 1;
        let departs = |(index, [_, slope, curvature]): (usize, &[Ball; 3])| {
            let at_impact = index == 0 || index + 1 == bounds.len();
            let away = if index < start { slope.is_positive() } else { slope.is_negative() };
            (start..end).contains(&index) || away || (at_impact && curvature.is_positive())
        };
        let runs = bounds[start..end].chunk_by(|a, b| clear(a) == clear(b));
        let mut blocks = Vec::new();
        let mut first = start as i64;
        for run in runs {
            let end = first + run.len() as i64;
            if !clear(&run[0]) {
                let curvature = run.iter().map(|bounds| bounds[2]).reduce(Ball::between)?.bottom();
                let (last, nearest) = (end - 1, nearest([first, end]));
                let [[_, _, a, time], [_, _, b, _]] =
                    [lower, upper].map(|velocity| self.approach(velocity, nearest));
                // The slope changes by at least the curvature from that time to the contact.
                let away = Ball::between(a, b) * (curvature * (Ball::PI + Ball::PI)).inverse();
                let contact = time + away.size();
                blocks.push(Block { first, last, nearest, curvature, contact });
            }
            first = end;
        }
        let convex = |block: &Block| block.curvature.is_positive() && self.is_clear(lower, block, cells);
        if !(bounds.iter().enumerate().all(departs) && blocks.iter().all(convex)) {
            return None;
        }
        blocks.sort_by_key(|block| self.is_clear(upper, block, cells));
        let open = blocks.iter().filter(|block| !self.is_clear(upper, block, cells)).count();
        Some(Clearance { cells, start: start as i64, end: end as i64, blocks, open })
    }

    /// `v`, the distance from the wall at this time, its derivative, and the time.
    fn approach(&self, velocity: &Velocity<'_>, time: Witness<2>) -> [Ball; 4] {
        self.range(|at| {
            let (v, time) = (velocity(at), at.witness(time));
            let motion = at.family.motion(v);
            let [distance, slope] =
                [0, 1].map(|derivative| self.oscillator.distance(&motion, time, derivative));
            [(v, 1), (distance, 2), (slope, 1), (time, 0)]
        })
    }

    /// Whether motion does not touch the wall in a block. Where the second derivative is at least μ > 0,
    /// the distance is at least `f − g²/(2μ)`, f and g being the distance and its derivative at a time
    /// of the block.
    fn is_clear(&self, velocity: &Velocity<'_>, block: &Block, cells: i64) -> bool {
        let [v, distance, slope, time] = self.approach(velocity, block.nearest);
        let turns = time * Ball::from(cells);
        let twice = distance.bottom() * (block.curvature + block.curvature);
        let slope = slope.size().top();
        [v, turns - Ball::from(block.first), Ball::from(block.last + 1) - turns, twice - slope * slope]
            .into_iter()
            .all(Ball::is_positive)
    }

    /// `ψ/(1 − cos θ)` at a time: the inverse of the velocity at which motion touches the wall then.
    fn ratio(&self, at: &At, time: Series) -> Series {
        let [rise, distance] =
            [Ball::ZERO, Ball::ONE].map(|v| self.oscillator.distance(&at.family.motion(v.into()), time, 0));
        (rise - distance) * rise.inverse()
    }

    /// Which point a row with one open block, or two, may hold, if stability begins and contact is made, or
    /// both contacts, at the same velocity at exactly one ν.
    pub fn point(&self, clearance: &Clearance) -> Option<&'static str> {
        let (events, name) = match &clearance.blocks[..clearance.open] {
            [one] if self.begins_at_saddle_node() => ([Event::Stability, Event::Contact(one)], "SN-GZ"),
            [one] => ([Event::Stability, Event::Contact(one)], "PD-GZ"),
            [one, two] => ([Event::Contact(one), Event::Contact(two)], "GZ-GZ"),
            _ => return None,
        };
        self.changes_order_once(events, clearance.cells).then_some(name)
    }

    /// Whether two events have another order at one end of the interval than at the other, and the
    /// inverses of their velocities change with ν at different rates, so that they are one at
    /// exactly one ν. Contact in a block is made at the inverse of the greatest ratio in it, which
    /// changes as the ratio does at some time of the block.
    fn changes_order_once(&self, [one, two]: [Event<'_>; 2], cells: i64) -> bool {
        let limit = self.limit();
        let rate = |event| match event {
            Event::Stability => limit(&self.over_all).inverse().0[1],
            Event::Contact(block) => self.ratio(&self.over_all, block.contact.into()).0[1],
        };
        let [left, right] = self.interval.ends().map(|nu| Self::at(self.oscillator, self.interval, nu));
        // Whether one comes before the other. A block touches the wall at its time not before it does.
        let before = |model: &Self, first, second| match (first, second) {
            (Event::Stability, Event::Contact(block)) => model.is_clear(&limit, block, cells),
            (Event::Contact(first), Event::Contact(second)) => {
                let contact = |at: &At| self.ratio(at, at.witness(first.nearest)).inverse();
                model.is_clear(&contact, second, cells)
            }
            (Event::Contact(block), Event::Stability) => model.beyond(&limit, block.nearest),
            (Event::Stability, Event::Stability) => false,
        };
        (rate(one) - rate(two)).is_not_zero()
            && ((before(&left, one, two) && before(&right, two, one))
                || (before(&left, two, one) && before(&right, one, two)))
    }
}
