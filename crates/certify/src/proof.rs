//! The inequalities that prove a row. Each holds for all ν of an interval by Taylor's theorem: three
//! coefficients at its base, and the fourth over all of it.

use crate::ball::{Ball, Number};
use crate::orbit::{Family, Motion, Oscillator};
use crate::row::{Base, Block, Clearance, Interval, Row, Verdict, WITNESS_BITS, Witness};
use crate::series::Series;
use crate::statement::Statement;

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

/// A stretch of time, in turns.
pub type Turns = [f64; 2];

/// Intervals at most `2^-FINE` wide may hold a codimension-two point.
pub const FINE: u32 = 24;
/// Cells in a period that are tried.
const CELLS: [i64; 3] = [64, 256, 1024];

fn is_whole(turn: Witness<2>) -> bool {
    turn.map(|coefficient| coefficient & ((1 << WITNESS_BITS) - 1)) == [0; 2] && turn[1] == 0
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

    /// The velocity above which motion is stable: `b/P`, where a multiplier is 1, if b is positive in the
    /// middle; `−b/Q`, where one is −1, otherwise.
    pub fn limit(&self) -> impl Fn(&At) -> Series {
        let saddle_node = self.begins_at_saddle_node();
        move |at| {
            let Family { b, big_p, big_q, .. } = at.family;
            if saddle_node { b * big_p.inverse() } else { -b * big_q.inverse() }
        }
    }

    fn begins_at_saddle_node(&self) -> bool {
        self.at_origin.family.b.0[0].is_positive()
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

    /// Completes a row by what its witnesses prove, if they prove anything; `nearest` guesses when motion
    /// with velocity `lower` is nearest to the wall in a block.
    pub fn prove(
        &self,
        row: Row,
        statement: &Statement,
        nearest: impl Fn(Turns) -> Witness<2>,
    ) -> Option<Row> {
        let side = |witness: Witness<3>| move |at: &At| at.witness(witness);
        let clearance = |lower, upper| {
            let velocities: [&Velocity<'_>; 2] = [&side(lower), &side(upper)];
            CELLS.into_iter().find_map(|cells| self.clearance(velocities, cells, &nearest))
        };
        if self.interval.base != Base::Middle && !self.crosses_at_resonance() {
            return None;
        }
        let Some(lower) = row.lower else {
            let none = match (row.upper, row.touch?) {
                // One of the conditions, which are linear, fails at velocity 0 and at `upper`.
                (Some(upper), touch) => {
                    let [b, below, above] = self.conditions(&side(upper));
                    let unstable =
                        (b.is_positive() && below.is_negative()) || (b.is_negative() && above.is_negative());
                    unstable && self.beyond(&side(upper), touch, 2)
                }
                // At a whole turn the distance is proportional to v: at `v = 1` is enough.
                (None, turn) => is_whole(turn) && self.beyond(&|_| Ball::ONE.into(), turn, 1),
            };
            return none.then_some(Row { verdict: Verdict::None, ..row });
        };
        let [b, below, above] = self.conditions(&side(lower));
        let stable = below.is_positive() && above.is_positive();
        let Some(upper) = row.upper else {
            let ends = self.end_below(&side(lower)).is_some();
            let begins = stable || (b.is_positive() && below.is_positive());
            let leaves = (self.amplitude(&side(lower)) - statement.amplitude.ball()).is_positive();
            let proved = begins && (ends || leaves);
            let clearance = proved.then(|| clearance(lower, lower))??;
            return Some(Row { verdict: Verdict::Stable, clearance: Some(clearance), ..row });
        };
        let fine = self.interval.level >= FINE;
        let proved = (stable || fine)
            && self.is_narrow(core::array::from_fn(|i| upper[i] - lower[i]), statement.width())
            && self.beyond(&side(upper), row.touch?, 2);
        let clearance = proved.then(|| clearance(lower, upper))??;
        let verdict = match (stable, clearance.open) {
            (true, 1) => Verdict::Stable,
            (true, 2) | (false, 1) if fine => Verdict::Point(self.point(&clearance)?),
            _ => return None,
        };
        Some(Row { verdict, clearance: Some(clearance), ..row })
    }

    /// `b`, and the conditions of stability `P v − b > 0` and `Q v + b > 0`.
    fn conditions(&self, velocity: &Velocity<'_>) -> [Ball; 3] {
        self.range(|at| {
            let (v, Family { b, big_p, big_q, .. }) = (velocity(at), at.family);
            [b, big_p * v - b, big_q * v + b].map(|function| (function, 1))
        })
    }

    /// The amplitude at which stability ends, at a multiplier −1, if it does so below a velocity: that of
    /// the velocity `−b/Q`, where `Q < 0 < b`.
    pub fn end_below(&self, velocity: &Velocity<'_>) -> Option<Ball> {
        let [b, _, above] = self.conditions(velocity);
        let end = |at: &At| -at.family.b * at.family.big_q.inverse();
        (b.is_positive() && above.is_negative()).then(|| self.amplitude(&end))
    }

    /// Whether the motion with this velocity is beyond the wall at a time between its impacts, where the
    /// distance is of this order. So are then all motions with greater velocities.
    fn beyond(&self, velocity: &Velocity<'_>, touch: Witness<2>, order: usize) -> bool {
        let [v, distance, time] = self.range(|at| {
            let (v, time) = (velocity(at), at.witness(touch));
            let [distance] = self.oscillator.distance(&at.family.motion(v), time);
            [(v, order - 1), (distance, order), (time, 0)]
        });
        let rest = Ball::from(self.interval.p) - time;
        distance.is_negative() && [v, time, rest].into_iter().all(Ball::is_positive)
    }

    /// At a resonance of one loop the wall is reached at the first whole turn whatever the velocity:
    /// whether all motions cross it there.
    fn crosses_at_resonance(&self) -> bool {
        let family = self.oscillator.family(self.interval.p, self.interval.origin());
        let [_, slope] = self.oscillator.distance(&family.motion(Ball::ONE), Ball::ONE);
        slope.is_not_zero()
    }

    /// The amplitude at which motion has this velocity.
    pub fn amplitude(&self, velocity: &Velocity<'_>) -> Ball {
        let square = |at: &At| self.oscillator.amplitude_square(&at.family.motion(velocity(at)));
        let [square] = self.range(|at| [(square(at), 0)]);
        square.sqrt()
    }

    /// Whether the amplitude changes by less than a width between velocities with this difference:
    /// `dA/dv ≤ A_graz √(c² + w²)`.
    fn is_narrow(&self, difference: Witness<3>, width: Ball) -> bool {
        let [square] = self.range(|at| {
            let (Family { nu, c, w, .. }, step) = (at.family, at.witness(difference));
            [(self.oscillator.grazing_square(nu) * (c * c + w * w) * step * step, 0)]
        });
        (width * width - square).is_positive()
    }

    /// All motions with velocities from one to another, for all ν of the interval at once.
    fn motion(&self, velocities: [&Velocity<'_>; 2]) -> Motion<Ball> {
        let [a, b] = velocities.map(|velocity| {
            self.range(|at| {
                let Motion { forced, free, .. } = at.family.motion(velocity(at));
                [forced[0], forced[1], free[0], free[1]].map(|function| (function, 0))
            })
        });
        let [cosine, sine, c, e] = core::array::from_fn(|i| Ball::between(a[i], b[i]));
        Motion { nu: self.interval.all(), forced: [cosine, sine], free: [c, e] }
    }

    /// Bounds, in a cell of time, of the distance from the wall and its first two derivatives in θ.
    fn cell(&self, motion: &Motion<Ball>, index: i64, cells: i64) -> [Ball; 3] {
        let middle = Ball::ratio(2 * index + 1, 2 * cells);
        let [value, first, second] = self.oscillator.distance(motion, middle);
        let [_, _, _, third] = self.oscillator.distance(motion, middle + Ball::ratio(1, 2 * cells).size());
        let distance = Series::of_derivatives([value, first, second, third]);
        let (slope, offset) = (distance.derivative(), (Ball::PI * Ball::ratio(1, cells)).size());
        [distance, slope, slope.derivative()].map(|function| function.values(offset))
    }

    /// Shows, if it can, that motion with velocities from `lower` to `upper` touches the wall nowhere
    /// between its impacts but in blocks, where the distance has a positive second derivative, so that
    /// there is one contact in each at most; and that at `lower` it touches it nowhere.
    fn clearance(
        &self,
        [lower, upper]: [&Velocity<'_>; 2],
        cells: i64,
        nearest: &dyn Fn(Turns) -> Witness<2>,
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
        if !bounds.iter().enumerate().all(departs) {
            return None;
        }
        let (mut blocks, mut first) = (Vec::new(), start as i64);
        for run in bounds[start..end].chunk_by(|a, b| clear(a) == clear(b)) {
            let last = first + run.len() as i64 - 1;
            if !clear(&run[0]) {
                let curvature = run.iter().map(|bounds| bounds[2]).reduce(Ball::between)?.bottom();
                let nearest = nearest([first, last + 1].map(|cell| cell as f64 / cells as f64));
                let block = Block { first, last, nearest, curvature, contact: Ball::ANY };
                let [[least, one], [_, other]] = [lower, upper].map(|v| self.minimum(v, &block, cells));
                least
                    .is_positive()
                    .then(|| blocks.push(Block { contact: Ball::between(one, other), ..block }))?;
            }
            first = last + 1;
        }
        let is_open = |block: &Block| !self.minimum(upper, block, cells)[0].is_positive();
        blocks.sort_by_key(|block| !is_open(block));
        let open = blocks.iter().filter(|block| is_open(block)).count();
        Some(Clearance { cells, start: start as i64, end: end as i64, blocks, open })
    }

    /// The least distance from the wall in a block, at least, and when it is reached, in turns. Where the
    /// second derivative is at least μ > 0, that is at least `f − g²/(2μ)`, no farther than `|g|/μ`
    /// from a time of the block, f and g being the distance and its derivative then.
    fn minimum(&self, velocity: &Velocity<'_>, block: &Block, cells: i64) -> [Ball; 2] {
        let [v, distance, slope, time] = self.range(|at| {
            let (v, time) = (velocity(at), at.witness(block.nearest));
            let [distance, slope] = self.oscillator.distance(&at.family.motion(v), time);
            [(v, 1), (distance, 2), (slope, 1), (time, 0)]
        });
        let turns = time * Ball::from(cells);
        let [before, after] = [turns - Ball::from(block.first), Ball::from(block.last + 1) - turns];
        if ![v, before, after, block.curvature].into_iter().all(Ball::is_positive) {
            return [Ball::ANY; 2];
        }
        let (slope, curvature) = (slope.size(), block.curvature.inverse());
        let away = slope * curvature * (Ball::PI + Ball::PI).inverse();
        [distance - slope.top() * slope.top() * curvature * Ball::ratio(1, 2), time + away]
    }

    /// `ψ/(1 − cos θ)` at a time: the inverse of the velocity at which motion touches the wall then.
    fn ratio(&self, at: &At, time: Series) -> Series {
        let [[rise], [distance]] =
            [Ball::ZERO, Ball::ONE].map(|v| self.oscillator.distance(&at.family.motion(v.into()), time));
        (rise - distance) * rise.inverse()
    }

    /// The point that a row holds, if two events have another order at one end of the interval than at the
    /// other, and the inverses of their velocities change with ν at different rates, so that they are one at
    /// exactly one ν. The events are contact in a block, and contact in another or that stability begins
    /// (`None`). Contact in a block is made at the inverse of the greatest ratio in it, which changes as
    /// the ratio does at some time of contact.
    fn point(&self, Clearance { cells, blocks, open, .. }: &Clearance) -> Option<&'static str> {
        let (one, two, name) = match &blocks[..*open] {
            [one] if self.begins_at_saddle_node() => (one, None, "SN-GZ"),
            [one] => (one, None, "PD-GZ"),
            [one, two] => (one, Some(two), "GZ-GZ"),
            _ => return None,
        };
        let limit = self.limit();
        let rate = |event: Option<&Block>| match event {
            Some(block) => self.ratio(&self.over_all, block.contact.into()).0[1],
            None => limit(&self.over_all).inverse().0[1],
        };
        let [left, right] = self.interval.ends().map(|nu| Self::at(self.oscillator, self.interval, nu));
        // Whether one event comes before the other. Motion is in contact at the time of a block not before the block is.
        let before = |model: &Self, first: Option<&Block>, second: Option<&Block>| {
            let velocity = |at: &At| match first {
                Some(block) => self.ratio(at, at.witness(block.nearest)).inverse(),
                None => limit(at),
            };
            match second {
                Some(block) => model.minimum(&velocity, block, *cells)[0].is_positive(),
                None => model.beyond(&limit, one.nearest, 2),
            }
        };
        let swap =
            |model: &Self, other: &Self| before(model, Some(one), two) && before(other, two, Some(one));
        let once = (rate(Some(one)) - rate(two)).is_not_zero();
        (once && (swap(&left, &right) || swap(&right, &left))).then_some(name)
    }
}
