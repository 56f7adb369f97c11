//! The inequalities that prove a row. Each holds for all ν of an interval by Taylor's theorem, with three
//! coefficients at the base and the fourth over the whole interval.

use core::array::from_fn;

use crate::ball::{Ball, Number};
use crate::orbit::{ClosedFormMotion, MotionFamily};
use crate::row::{Base, Block, CertificateRow, Clearance, Interval, IntervalVerdict, WITNESS_BITS, Witness};
use crate::series::Series;
use crate::statement::Statement;

/// The motions with one impact over an interval of ν, as functions of ν.
pub struct IntervalMotions<'a> {
    /// The statement to be proved.
    pub statement: &'a Statement,
    /// The interval.
    pub interval: Interval,
    family: MotionFamily<Series>,
    /// The offset `u = ν − m` from the base m.
    offset: Series,
}

/// A guess at the time, in turns, at which motion is nearest to the wall within a range of times.
pub type Guess<'g> = dyn Fn([f64; 2]) -> Witness<2> + 'g;

/// Only intervals of width at most `2^-FINE` may be claimed to contain a codimension-two point.
pub const FINE: u32 = 24;
/// Derivatives with respect to ν are counted in the width of the interval, or in `2^-FINEST_UNIT` if that is
/// greater: where damping is weak, third derivatives in units of ν are greater than balls can be, while what
/// is finer than this loses digits.
const FINEST_UNIT: u32 = 16;
/// The numbers of cells per period that are tried, and whether the distance is taken as a function of ν
/// in each cell, by Taylor's theorem, where the ranges of its coefficients are not enough.
const CELLS: [(i64, bool); 4] = [(64, false), (64, true), (256, true), (1024, true)];

impl<'a> IntervalMotions<'a> {
    /// The motions over an interval.
    pub fn over(statement: &'a Statement, interval: Interval) -> Self {
        Self::new(statement, interval, [interval.origin(), interval.all()])
    }

    /// The motions at one ν of the interval.
    pub fn at(statement: &'a Statement, interval: Interval, nu: Ball) -> Self {
        Self::new(statement, interval, [nu; 2])
    }

    fn new(statement: &'a Statement, interval: Interval, [at, over_all]: [Ball; 2]) -> Self {
        let nu = Series::variable(at, over_all, Ball::dyadic(1, interval.level.min(FINEST_UNIT)));
        let family = statement.oscillator.family(interval.p, nu);
        Self { statement, interval, family, offset: nu - interval.origin().into() }
    }

    /// A witness as a function of ν.
    pub fn witness<const N: usize>(&self, witness: Witness<N>) -> Series {
        let coefficients = witness.map(|coefficient| Ball::dyadic(coefficient, WITNESS_BITS).into());
        coefficients.into_iter().rev().fold(Ball::ZERO.into(), |sum, term| sum * self.offset + term)
    }

    /// The velocity above which motion is stable: if b is positive in the middle, `b/P`, where a
    /// multiplier is 1; otherwise `−b/Q`, where a multiplier is −1.
    pub fn limit(&self) -> Series {
        self.family.velocity_at(if self.family.b.0[0][0].is_positive() { 1 } else { -1 })
    }

    /// The range of a function of ν over the interval. `order` is the number of times the function
    /// vanishes at a resonance of one loop: there the function is divided by that power of `|u|`, u being
    /// counted in the unit of derivatives, and the result is the ball of all numbers unless the zeros are
    /// exact.
    fn values(&self, function: Series, order: usize) -> Ball {
        let ([near, far], [at, over_all]) = (function.0, self.family.nu.0);
        let at_resonance = self.interval.base != Base::Middle && self.offset.0[0][0] == Ball::ZERO;
        let order = if at_resonance { order } else { 0 };
        let offset = (over_all[0] - at[0]) * Ball::from(1_i64 << self.interval.level.min(FINEST_UNIT));
        if near[..order] != [Ball::ZERO; 4][..order] {
            return Ball::ANY;
        }
        let values = near[order..3].iter().rev().fold(far[3], |sum, &term| term + offset * sum);
        if self.interval.base == Base::Right && order % 2 == 1 { -values } else { values }
    }

    /// Completes a row with the verdict that its witnesses prove, or returns none; `nearest` guesses when
    /// motion with velocity `lower` is nearest to the wall in a block.
    pub fn prove(&self, row: CertificateRow, nearest: &Guess<'_>) -> Option<CertificateRow> {
        let [lower, upper] = [row.lower, row.upper].map(|side| side.map(|side| self.witness(side)));
        let clearance = |velocities| {
            CELLS.into_iter().find_map(|(cells, closely)| self.clearance(velocities, cells, closely, nearest))
        };
        if self.interval.base != Base::Middle && (self.interval.p == 1 || !self.crosses_at_resonance()) {
            return None;
        }
        if row.verdict == IntervalVerdict::Thin {
            let thin = self.is_narrow([0; 3], row.upper?) && self.beyond(upper?, row.touch?, 2);
            return thin.then_some(row);
        }
        let Some(lower) = lower else {
            let none = match (upper, row.touch) {
                // One of the two conditions, which are linear in v, fails at velocity 0 and at `upper`.
                (Some(upper), touch) => {
                    let [b, below, above] = self.conditions(upper);
                    let unstable =
                        (b.is_positive() && below.is_negative()) || (b.is_negative() && above.is_negative());
                    let outside = || below.is_positive() && self.leaves(upper);
                    unstable && touch.map_or_else(outside, |touch| self.beyond(upper, touch, 2))
                }
                // At a whole turn the distance is proportional to v, so `v = 1` suffices.
                (None, Some([turn, 0])) if turn % (1 << WITNESS_BITS) == 0 => {
                    self.beyond(Ball::ONE.into(), [turn, 0], 1)
                }
                _ => false,
            };
            return none.then_some(CertificateRow { verdict: IntervalVerdict::None, ..row });
        };
        let [b, below, above] = self.conditions(lower);
        let stable = below.is_positive() && above.is_positive();
        let Some(upper) = upper else {
            let ends = self.leaves(lower) || self.end_below(lower).is_some();
            let begins = stable || (b.is_positive() && below.is_positive());
            let clearance = (begins && ends).then(|| clearance([lower; 2]))??;
            return Some(CertificateRow {
                verdict: IntervalVerdict::Stable,
                clearance: Some(clearance),
                ..row
            });
        };
        let fine = self.interval.level >= FINE;
        let proved =
            (stable || fine) && self.is_narrow(row.lower?, row.upper?) && self.beyond(upper, row.touch?, 2);
        let clearance = proved.then(|| clearance([lower, upper]))??;
        let [_, _, above] = self.conditions(upper);
        let verdict = match (stable, above.is_positive(), clearance.open) {
            (true, true, 1) => IntervalVerdict::Stable,
            (true, true, 2) => IntervalVerdict::Point("GZ-GZ"),
            (true, false, 1) if b.is_positive() => IntervalVerdict::Point("GZ-PD"),
            (false, true, 1) if b.is_positive() => IntervalVerdict::Point("SN-GZ"),
            (false, _, 1) if b.is_negative() => IntervalVerdict::Point("PD-GZ"),
            _ => return None,
        };
        let holds =
            verdict == IntervalVerdict::Stable || (fine && self.is_point(verdict, row.upper?, &clearance));
        holds.then_some(CertificateRow { verdict, clearance: Some(clearance), ..row })
    }

    /// Whether a row has a point that may be in the window or beyond it.
    pub fn is_on_edge(&self, row: &CertificateRow) -> bool {
        let place = || row.lower.and_then(|lower| self.is_in_window(lower));
        matches!(row.verdict, IntervalVerdict::Point(_)) && place().is_none()
    }

    /// Whether the point of a row is in the window; nothing if that is not known. Its velocity is between
    /// those of the tube, and so its amplitude within the tube's width of that for the lower one.
    pub fn is_in_window(&self, lower: Witness<3>) -> Option<bool> {
        let Statement { frequency, amplitude, .. } = self.statement;
        let omega = self.statement.oscillator.omega_1_over(self.interval.all());
        let at_point = self.amplitude(self.witness(lower)) + Statement::width().size();
        let places = [(omega, frequency), (at_point, amplitude)].map(|(x, range)| {
            let [low, high] = range.map(|end| end.ball());
            let [above, below] = [x - low, high - x];
            [above.is_negative() || below.is_negative(), above.is_positive() && below.is_positive()]
        });
        match places {
            [[true, _], _] | [_, [true, _]] => Some(false),
            [[_, true], [_, true]] => Some(true),
            _ => None,
        }
    }

    /// The number `b`, and the left sides of the conditions of stability `P v − b > 0` and `Q v + b > 0`.
    fn conditions(&self, v: Series) -> [Ball; 3] {
        let MotionFamily { b, big_p, big_q, .. } = self.family;
        [b, big_p * v - b, big_q * v + b].map(|function| self.values(function, 1))
    }

    /// The amplitude at which stability ends with a multiplier −1, if this happens below a velocity: the
    /// amplitude for the velocity `−b/Q`, where `Q < 0 < b`.
    pub fn end_below(&self, v: Series) -> Option<Ball> {
        let [b, _, above] = self.conditions(v);
        (b.is_positive() && above.is_negative()).then(|| self.amplitude(self.family.velocity_at(-1)))
    }

    /// Whether the motion with this velocity is beyond the wall at a time between its impacts; `order` is
    /// that of the distance, as in `values`. All motions with greater velocities are then beyond the
    /// wall, too.
    fn beyond(&self, v: Series, touch: Witness<2>, order: usize) -> bool {
        let time = self.witness(touch);
        let [distance] = self.distance(v, time);
        let (v, time) = (self.values(v, order - 1), self.values(time, 0));
        let rest = Ball::from(self.interval.p) - time;
        self.values(distance, order).is_negative() && [v, time, rest].into_iter().all(Ball::is_positive)
    }

    /// The distance of the motion with a velocity from the wall at a time, and its derivatives in θ.
    fn distance<const ORDERS: usize>(&self, v: Series, time: Series) -> [Series; ORDERS] {
        self.statement.oscillator.distance(&self.family.motion(v), time)
    }

    /// Whether all motions cross the wall at the first whole turn, at a resonance of one loop; there they
    /// all reach it at that time, whatever their velocity.
    fn crosses_at_resonance(&self) -> bool {
        let [_, slope] = self.distance(Ball::ONE.into(), Ball::ONE.into());
        !slope.0[0][0].contains(Ball::ZERO)
    }

    /// The amplitude at which motion has this velocity.
    pub fn amplitude(&self, v: Series) -> Ball {
        self.values(self.statement.oscillator.amplitude_square(&self.family.motion(v)), 0).sqrt()
    }

    /// Whether the amplitude for this velocity is beyond the window. Where `P v > b` it increases with v.
    fn leaves(&self, v: Series) -> bool {
        (self.amplitude(v) - self.statement.amplitude[1].ball()).is_positive()
    }

    /// Whether the amplitude changes by less than the width of a tube from one velocity to another:
    /// `dA/dv ≤ A_graz √(c² + w²)`. The difference of the velocities is computed from that of their
    /// coefficients, since the difference of their ranges would be too wide.
    fn is_narrow(&self, lower: Witness<3>, upper: Witness<3>) -> bool {
        let step = self.witness::<3>(from_fn(|i| upper[i] - lower[i]));
        let steepness = self.statement.oscillator.steepness_square(&self.family);
        let width = Statement::width();
        (width * width - self.values(steepness * step * step, 0)).is_positive()
    }

    /// Bounds for the motions with velocities from one to another, over all ν of the interval.
    fn motion(&self, velocities: [Series; 2]) -> ClosedFormMotion<Ball> {
        let all = velocities.map(|v| {
            let ClosedFormMotion { forced, free, .. } = self.family.motion(v);
            [forced, free].map(|parts| parts.map(|function| self.values(function, 0)))
        });
        let [forced, free] = [0, 1].map(|i| [0, 1].map(|j| Ball::between(all[0][i][j], all[1][i][j])));
        ClosedFormMotion { nu: self.interval.all(), forced, free }
    }

    /// Bounds of the distance from the wall and of its first two derivatives in θ, in one cell of time, from
    /// those at its middle.
    fn cell(
        &self,
        motion: &ClosedFormMotion<Ball>,
        [value, first, second]: [Ball; 3],
        middle: Ball,
        cells: i64,
    ) -> [Ball; 3] {
        let oscillator = &self.statement.oscillator;
        let [_, _, _, third] = oscillator.distance(motion, middle + Ball::ratio(1, 2 * cells).size());
        let offset = (Ball::PI * Ball::ratio(1, cells)).size();
        let [half, third_part] = [2, 3].map(|n| offset * Ball::ratio(1, n));
        [
            value + offset * (first + half * (second + third_part * third)),
            first + offset * (second + half * third),
            second + offset * third,
        ]
    }

    /// Tries to prove that motion with velocities from `lower` to `upper` does not touch the wall between
    /// its impacts outside certain blocks, in which the distance has a positive second derivative, so
    /// that each has at most one contact; and that motion with velocity `lower` does not touch it at all.
    fn clearance(
        &self,
        [lower, upper]: [Series; 2],
        cells: i64,
        closely: bool,
        nearest: &Guess<'_>,
    ) -> Option<Clearance> {
        let motion = self.motion([lower, upper]);
        let clear = |[distance, ..]: &[Ball; 3]| distance.is_positive();
        let bounds = |index| {
            let middle = Ball::ratio(2 * index + 1, 2 * cells);
            let roughly = self.statement.oscillator.distance(&motion, middle);
            let bounds = self.cell(&motion, roughly, middle, cells);
            if !closely || clear(&bounds) {
                return bounds;
            }
            let [one, other] = [lower, upper]
                .map(|v| self.distance::<3>(v, middle.into()).map(|function| self.values(function, 0)));
            self.cell(&motion, from_fn(|i| Ball::between(one[i], other[i])), middle, cells)
        };
        let bounds: Vec<[Ball; 3]> = (0..self.interval.p * cells).map(bounds).collect();
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

    /// A lower bound of the distance from the wall in a block, and the time of the minimum, in turns. If
    /// the second derivative is at least μ > 0, the minimum is at least `f − g²/(2μ)` and lies within
    /// `|g|/μ` of a time in the block, where f and g are the distance and its derivative at that time.
    fn minimum(&self, v: Series, block: &Block, cells: i64) -> [Ball; 2] {
        let time = self.witness(block.nearest);
        let [distance, slope] = self.distance(v, time);
        let (distance, slope) = (self.values(distance, 2), self.values(slope, 1).size());
        let (v, time) = (self.values(v, 1), self.values(time, 0));
        let turns = time * Ball::from(cells);
        let [before, after] = [turns - Ball::from(block.first), Ball::from(block.last + 1) - turns];
        if ![v, before, after, block.curvature].into_iter().all(Ball::is_positive) {
            return [Ball::ANY; 2];
        }
        let curvature = block.curvature.inverse();
        let away = slope * curvature * (Ball::PI + Ball::PI).inverse();
        [distance - slope.top() * slope.top() * curvature * Ball::ratio(1, 2), time + away]
    }

    /// `(1 − cos θ)/ψ` at a time: the velocity at which motion touches the wall at that time. Beside a whole
    /// turn `1 − cos θ = 2 sin² (θ/2)` is known to more digits for a range of times than the difference is, and
    /// the inverse of the velocity would be too great for balls.
    fn contact(&self, time: Series) -> Series {
        let [[rise], [distance]] = [Ball::ZERO, Ball::ONE].map(|v| self.distance(v.into(), time));
        let (sine, _) = (time * Ball::ratio(1, 2).into()).turn();
        (sine * sine + sine * sine) * (rise - distance).inverse()
    }

    /// Whether a row contains exactly one point. Two events must occur in opposite orders at the two ends
    /// of the interval, and their velocities must change with ν at different rates, so that they coincide
    /// at exactly one ν. The events are contact in a block, and either contact in another block or the
    /// beginning or end of stability (`None`). Contact in a block occurs at the least of the velocities at
    /// its times, which changes at the rate of the velocity at a time of contact.
    fn is_point(&self, verdict: IntervalVerdict, upper: Witness<3>, clearance: &Clearance) -> bool {
        let Clearance { cells, blocks, open, .. } = clearance;
        let (one, two) = (&blocks[0], blocks[..*open].get(1));
        let multiplier = if verdict == IntervalVerdict::Point("SN-GZ") { 1 } else { -1 };
        let limit = |model: &Self| model.family.velocity_at(multiplier);
        let rate = |event: Option<&Block>| {
            let velocity = event.map_or_else(|| limit(self), |block| self.contact(block.contact.into()));
            velocity.0[1][1]
        };
        let [left, right] = self.interval.ends().map(|nu| Self::at(self.statement, self.interval, nu));
        // Whether one event comes before the other. At the time `nearest` of a block, motion is not in
        // contact at a lower velocity than the block is; the block's curvature is a bound for velocities
        // up to `upper`.
        let before = |model: &Self, first: Option<&Block>, second: Option<&Block>| {
            let contact = |block: &Block| model.contact(model.witness(block.nearest));
            let velocity = first.map_or_else(|| limit(model), contact);
            let room = || model.values(model.witness(upper) - velocity, 0);
            second.map_or_else(
                || model.beyond(limit(model), one.nearest, 2),
                |block| room().is_positive() && model.minimum(velocity, block, *cells)[0].is_positive(),
            )
        };
        let swap =
            |model: &Self, other: &Self| before(model, Some(one), two) && before(other, two, Some(one));
        let once = !(rate(Some(one)) - rate(two)).contains(Ball::ZERO);
        once && (swap(&left, &right) || swap(&right, &left))
    }
}
