//! The inequalities that prove a row. Each holds for all ν of an interval by Taylor's theorem: three
//! coefficients at its middle, and the fourth over all of it.

use crate::ball::Ball;
use crate::orbit::{Family, Motion, Oscillator};
use crate::row::{Base, Block, Clearance, Interval, WITNESS_BITS, Witness};
use crate::series::{Number, Series, TERMS};

/// The motions with one impact over an interval of ν.
pub struct Model<'a> {
    oscillator: &'a Oscillator,
    interval: Interval,
    at_origin: At,
    over_all: At,
}

/// The series at one ν, or at all of an interval.
pub struct At {
    family: Family<Series>,
    offset: Series,
}

impl At {
    fn new(oscillator: &Oscillator, interval: Interval, nu: Ball) -> Self {
        let variable = Series::variable(nu);
        let offset = variable - Series::from(interval.origin());
        Self { family: oscillator.family(interval.p, variable), offset }
    }

    /// A witness as a function of ν.
    pub fn witness<const N: usize>(&self, witness: Witness<N>) -> Series {
        witness.iter().rev().fold(Series::from(Ball::ZERO), |sum, &coefficient| {
            sum * self.offset + Ball::dyadic(coefficient, WITNESS_BITS).into()
        })
    }

    /// The motion with a velocity.
    pub fn motion(&self, velocity: &Velocity) -> Motion<Series> {
        self.family.motion(self.velocity(velocity))
    }

    fn velocity(&self, velocity: &Velocity) -> Series {
        match *velocity {
            Velocity::Witness(witness) => self.witness(witness),
            Velocity::SaddleNode(factor) => self.family.b * self.family.big_p.inverse() * factor.into(),
            Velocity::PeriodDoubling(factor) => -self.family.b * self.family.big_q.inverse() * factor.into(),
        }
    }
}

/// A velocity at impact, as a function of ν.
#[derive(Debug, Clone, Copy)]
pub enum Velocity {
    /// A polynomial.
    Witness(Witness<3>),
    /// That at which a multiplier is 1, times a factor.
    SaddleNode(Ball),
    /// That at which one is −1, likewise.
    PeriodDoubling(Ball),
}

/// Bounds that hold in a cell of time: of the distance from the wall and its derivatives.
struct Cell {
    distance: Ball,
    slope: Ball,
    curvature: Ball,
}

impl<'a> Model<'a> {
    /// Over this interval.
    pub fn new(oscillator: &'a Oscillator, interval: Interval) -> Self {
        let at = |nu: Ball| At::new(oscillator, interval, nu);
        Self { oscillator, interval, at_origin: at(interval.origin()), over_all: at(interval.all()) }
    }

    /// The velocity above which motion is stable at one ν, times a factor.
    pub fn limit(&self, nu: Ball, factor: Ball) -> Velocity {
        let saddle_node = self.oscillator.family(self.interval.p, nu).b.is_positive();
        if saddle_node { Velocity::SaddleNode(factor) } else { Velocity::PeriodDoubling(factor) }
    }

    /// What functions of ν may be anywhere in the interval. Each comes with its order: how often it
    /// vanishes at a resonance of one loop. There it is divided by that power of `|u|`.
    pub fn range<const N: usize>(&self, functions: impl Fn(&At) -> [(Series, usize); N]) -> [Ball; N] {
        let (origin, all) = (functions(&self.at_origin), functions(&self.over_all));
        let offset = self.interval.all() - self.interval.origin();
        let (resonance, flip) = match self.interval.base {
            Base::Left => (true, false),
            Base::Middle => (false, false),
            Base::Right => (true, true),
        };
        core::array::from_fn(|i| {
            let order = if resonance { origin[i].1 } else { 0 };
            let (vanishing, rest) = origin[i].0.0[..TERMS - 1].split_at(order);
            if vanishing.iter().any(|&coefficient| coefficient != Ball::ZERO) {
                return Ball::ANY;
            }
            let last = all[i].0.0[TERMS - 1];
            let sum = rest.iter().rev().fold(last, |sum, &coefficient| coefficient + offset * sum);
            if flip && order % 2 == 1 { -sum } else { sum }
        })
    }

    /// Whether the motion with this velocity is stable: `v > 0`, `P v − b > 0`, `Q v + b > 0`.
    pub fn stable(&self, velocity: &Velocity) -> bool {
        let conditions = self.range(|at| {
            let (v, family) = (at.velocity(velocity), &at.family);
            [(v, 1), (family.big_p * v - family.b, 1), (family.big_q * v + family.b, 1)]
        });
        conditions.into_iter().all(Ball::is_positive)
    }

    /// Whether no motion with a velocity from 0 to this one is stable: one of the conditions, which
    /// are linear, fails at both ends.
    pub fn unstable(&self, velocity: &Velocity) -> bool {
        let [v, b, below, above] = self.range(|at| {
            let (v, family) = (at.velocity(velocity), &at.family);
            let below = (family.big_p * v - family.b, 1);
            [(v, 1), (family.b, 1), below, (family.big_q * v + family.b, 1)]
        });
        let saddle_node = b.is_positive() && below.is_negative();
        let period_doubling = b.is_negative() && above.is_negative();
        v.is_positive() && (saddle_node || period_doubling)
    }

    /// Whether the motion with this velocity is beyond the wall at the time `touch`, which lies
    /// between its impacts. So are then all motions with greater velocities.
    pub fn beyond(&self, velocity: &Velocity, touch: Witness<2>) -> bool {
        self.beyond_at_order(velocity, touch, 2)
    }

    fn beyond_at_order(&self, velocity: &Velocity, touch: Witness<2>, order: usize) -> bool {
        let [distance, time] = self.range(|at| {
            let time = at.witness(touch);
            [(self.oscillator.distance(&at.motion(velocity), time)[0], order), (time, 0)]
        });
        distance.is_negative() && time.is_positive() && (time - Ball::from(self.interval.p)).is_negative()
    }

    /// Whether all motions are beyond the wall at a whole turn: at `v = 1` is enough, since the
    /// distance there is proportional to v.
    pub fn blocked(&self, turn: i64) -> bool {
        let one = Velocity::Witness([1 << WITNESS_BITS, 0, 0]);
        (1..self.interval.p).contains(&turn)
            && self.beyond_at_order(&one, [i128::from(turn) << WITNESS_BITS, 0], 1)
    }

    /// At a resonance of one loop the wall is reached at the first whole turn whatever the velocity:
    /// whether all motions cross it there.
    pub fn crosses_at_resonance(&self) -> bool {
        let family = self.oscillator.family(self.interval.p, self.interval.origin());
        let slope = self.oscillator.distance(&family.motion(Ball::ONE), Ball::ONE)[1];
        slope.is_not_zero()
    }

    /// The amplitude at which motion has this velocity, all over the interval.
    pub fn amplitude(&self, velocity: &Velocity) -> Ball {
        let [square] = self.range(|at| [(self.oscillator.amplitude_square(&at.motion(velocity)), 0)]);
        square.sqrt()
    }

    /// The same at one ν.
    pub fn amplitude_at(&self, nu: Ball, velocity: &Velocity) -> Ball {
        let motion = At::new(self.oscillator, self.interval, nu).motion(velocity);
        self.oscillator.amplitude_square(&motion).0[0].sqrt()
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

    /// The motion for all ν of the interval at once.
    fn motion_over_all(&self, velocity: &Velocity) -> Motion<Ball> {
        let [c, e, w] = self.range(|at| {
            let Motion { c, e, w, .. } = at.motion(velocity);
            [(c, 0), (e, 0), (w, 0)]
        });
        Motion { nu: self.interval.all(), c, e, w }
    }

    fn cell(&self, motion: &Motion<Ball>, index: i64, cells: i64) -> Cell {
        let middle = Ball::ratio(2 * index + 1, 2 * cells);
        let all = middle + Ball::ratio(1, 2 * cells).size();
        let [distance, slope, curvature, _] = self.oscillator.distance(motion, middle);
        let [.., third] = self.oscillator.distance(motion, all);
        let offset = (Ball::PI * Ball::ratio(1, cells)).size();
        let [half, one_third] = [2, 3].map(|n| Ball::ratio(1, n));
        Cell {
            distance: distance + offset * (slope + offset * half * (curvature + offset * one_third * third)),
            slope: slope + offset * (curvature + offset * half * third),
            curvature: curvature + offset * third,
        }
    }

    /// Shows, if it can, that motion with velocities from `lower` to `upper` touches the wall nowhere
    /// between its impacts but in blocks, where the distance has a positive second derivative, so that
    /// there is one contact in each at most; and that at `lower` it touches it nowhere. Each period is cut
    /// into this many cells; `nearest` guesses when a block is nearest. With `crossing` the motion
    /// with `lower` may touch the wall in the one block, see [`Model::crosses_once`].
    pub fn clearance(
        &self,
        [lower, upper]: [&Velocity; 2],
        cells: i64,
        nearest: impl Fn(i64, i64) -> Witness<2>,
        crossing: bool,
    ) -> Option<Clearance> {
        let [a, b] = [lower, upper].map(|velocity| self.motion_over_all(velocity));
        let [c, e, w] = [(a.c, b.c), (a.e, b.e), (a.w, b.w)].map(|(a, b)| Ball::between(a, b));
        let motion = Motion { c, e, w, ..a };
        let bounds: Vec<Cell> =
            (0..self.interval.p * cells).map(|index| self.cell(&motion, index, cells)).collect();
        let clear = |cell: &Cell| cell.distance.is_positive();
        let start = bounds.iter().position(clear)?;
        let end = bounds.iter().rposition(clear)? + 1;
        let leaves = bounds[..start]
            .iter()
            .enumerate()
            .all(|(index, cell)| cell.slope.is_positive() || (index == 0 && cell.curvature.is_positive()));
        let returns =
            bounds[end..].iter().rev().enumerate().all(|(index, cell)| {
                cell.slope.is_negative() || (index == 0 && cell.curvature.is_positive())
            });
        let mut blocks = Vec::new();
        let mut index = start;
        while index < end {
            let length = bounds[index..end].iter().take_while(|cell| !clear(cell)).count();
            if length > 0 {
                let (first, last) = (index as i64, (index + length - 1) as i64);
                let mut block = Block { first, last, nearest: nearest(first, last), open: true };
                let curved = bounds[index..index + length].iter().all(|cell| cell.curvature.is_positive());
                let cleared = curved && (crossing || self.block_is_clear(lower, &block, &bounds, cells));
                block.open = cleared && !self.block_is_clear(upper, &block, &bounds, cells);
                cleared.then(|| blocks.push(block))?;
            }
            index += length + 1;
        }
        let (start, end) = (start as i64, end as i64);
        (leaves && returns).then_some(Clearance { cells, start, end, blocks })
    }

    /// In a block, where the second derivative is at least μ > 0, the distance is at least
    /// `f − g²/(2μ)`, f and g being the distance and its derivative at a time of the block.
    fn block_is_clear(&self, velocity: &Velocity, block: &Block, bounds: &[Cell], cells: i64) -> bool {
        let [distance, slope, time] = self.range(|at| {
            let time = at.witness(block.nearest);
            let [distance, slope, ..] = self.oscillator.distance(&at.motion(velocity), time);
            [(distance, 2), (slope, 1), (time, 0)]
        });
        let turns = time * Ball::from(cells);
        let within = !(turns - Ball::from(block.first)).is_negative()
            && Ball::between(Ball::from(block.first), Ball::from(block.last + 1)).contains(turns);
        let slope = slope.size().top();
        within
            && bounds[block.first as usize..=block.last as usize].iter().all(|cell| {
                let curvature = cell.curvature.bottom();
                let twice = distance.bottom() * (curvature + curvature);
                (twice - slope * slope).is_positive()
            })
    }

    /// Whether, along a stability limit, the distance from the wall increases or decreases with ν at
    /// every time of a block, and a little above the limit motion is beyond the wall in it.
    pub fn crosses_once(&self, [limit, above]: [&Velocity; 2], clearance: &Clearance) -> bool {
        let [block] = clearance.blocks.as_slice() else { return false };
        let [velocity, b] = self.range(|at| [(at.velocity(limit), 1), (at.family.b, 1)]);
        let motion = self.over_all.motion(limit);
        let change = block
            .times(clearance.cells)
            .map(|time| self.oscillator.distance(&motion, time.into())[0].0[1])
            .reduce(Ball::between);
        velocity.is_positive()
            && b.is_not_zero()
            && change.is_some_and(Ball::is_not_zero)
            && self.beyond(above, block.nearest)
    }

    /// Where motion may touch the wall in two blocks: whether it does so at one ν at most. In each
    /// block the greatest `ψ/(1 − cos θ)`, whose inverse is the velocity at which motion touches the
    /// wall there, changes with ν as `ψ_ν/(1 − cos θ)` does at some time of the block: these are of
    /// different size in the two.
    pub fn changes_contact_once(&self, [one, two]: [&Block; 2], cells: i64) -> bool {
        let motion = self.over_all.family.motion(Ball::ONE.into());
        let rate = |time: Ball| {
            let sine = (time * Ball::ratio(1, 2)).turn().0;
            let change = -self.oscillator.distance(&motion, time.into())[0].0[1];
            change * (sine * sine + sine * sine).inverse()
        };
        let [one, two] = [one, two].map(|block| block.times(cells).map(rate).reduce(Ball::between));
        one.zip(two).is_some_and(|(one, two)| (one - two).is_not_zero())
    }
}
