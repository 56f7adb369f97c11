//! Finds, in floating point, the rows and witnesses that [`Model`] then proves.

use core::cell::Cell;

use crate::ball::Ball;
use crate::orbit::{Family, Motion, Oscillator};
use crate::proof::{Model, Velocity};
use crate::row::{Base, Clearance, Interval, Row, Verdict, WITNESS_BITS, Witness};
use crate::series::Number;

/// What is asked for.
#[derive(Debug, Clone, Copy)]
pub struct Goal {
    /// Greatest width of a tube, in amplitude.
    pub width: Ball,
    /// The greatest amplitude of the window.
    pub amplitude: Ball,
    /// Intervals are halved down to width `2^-level`.
    pub finest: u32,
}

/// Intervals at most `2^-FINE` wide may hold a codimension-two point.
const FINE: u32 = 24;
/// Cells in a period that are tried.
const CELLS: [i64; 3] = [64, 256, 1024];

/// One ν, seen in floating point.
struct Sight {
    nu: f64,
    family: Family<f64>,
    /// The velocity above which motion is stable.
    limit: f64,
    /// The velocity up to which it is admissible, 0 if there is none, infinite if all are.
    graze: f64,
    /// When it touches the wall then, in turns.
    touch: f64,
}

impl Sight {
    fn new(oscillator: &Oscillator, p: i64, nu: f64) -> Self {
        let family = oscillator.family(p, nu);
        let Family { b, big_p, big_q, .. } = family;
        let limit = if b > 0.0 {
            b / big_p
        } else if big_q > 0.0 {
            -b / big_q
        } else {
            f64::INFINITY
        };
        let (graze, touch) = grazing(oscillator, p, &family);
        Self { nu, family, limit, graze, touch }
    }
}

/// The greatest value of `psi/(1 - cos)` over the time between impacts, as its inverse and its time.
fn grazing(oscillator: &Oscillator, p: i64, family: &Family<f64>) -> (f64, f64) {
    let motion = family.motion(1.0);
    let ratio = |turns: f64| {
        let half = (0.5 * turns).turn().0;
        let rise = 2.0 * half * half;
        (rise - oscillator.distance(&motion, turns)[0]) / rise
    };
    let whole = (1..p).find(|&turn| oscillator.distance(&motion, turn as f64)[0] <= 0.0);
    if let Some(turn) = whole {
        return (0.0, turn as f64);
    }
    let mut times: Vec<f64> = (1..p * 128).map(|n| n as f64 / 128.0).collect();
    for turn in 1..p {
        let near = (14..80).map(|n| libm::exp2(-0.5 * f64::from(n)));
        times.extend(near.flat_map(|offset| [turn as f64 - offset, turn as f64 + offset]));
    }
    times.retain(|time| time.fract() != 0.0);
    times.sort_by(f64::total_cmp);
    times.dedup();
    let ratios: Vec<f64> = times.iter().map(|&time| ratio(time)).collect();
    let peak = |index: usize| {
        let (mut low, mut high) = (times[index - 1], times[index + 1]);
        for _ in 0..70 {
            let third = (high - low) / 3.0;
            if ratio(low + third) < ratio(high - third) { low += third } else { high -= third }
        }
        let touch = 0.5 * (low + high);
        (ratio(touch), touch)
    };
    let peaks =
        (1..times.len() - 1).filter(|&i| ratios[i] >= ratios[i - 1] && ratios[i] >= ratios[i + 1]).map(peak);
    let (greatest, touch) = peaks.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((0.0, 0.5));
    (if greatest > 0.0 { 1.0 / greatest } else { f64::INFINITY }, touch)
}

/// Where the distance is least between two times, by the zero of its slope.
fn nearest(oscillator: &Oscillator, motion: &Motion<f64>, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if oscillator.distance(motion, middle)[1] < 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

fn witness(x: f64) -> i128 {
    libm::rint(libm::scalbn(x, WITNESS_BITS as i32)) as i128
}

/// The search over one interval.
struct Attempt<'a> {
    oscillator: &'a Oscillator,
    model: Model<'a>,
    interval: Interval,
    goal: Goal,
    sights: [Sight; 3],
    /// What it has cost, in the smallest number of cells.
    work: Cell<usize>,
}

impl<'a> Attempt<'a> {
    fn new(oscillator: &'a Oscillator, interval: Interval, goal: Goal) -> Self {
        let [left, right] = interval.ends().map(Ball::to_f64);
        let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
        // Three Chebyshev nodes.
        let sights = [-0.75f64.sqrt(), 0.0, 0.75f64.sqrt()]
            .map(|node| Sight::new(oscillator, interval.p, middle + node * half));
        Self {
            oscillator,
            model: Model::new(oscillator, interval),
            interval,
            goal,
            sights,
            work: Cell::new(1),
        }
    }

    /// The quadratic through values at the three nodes; at a resonance, where they vanish, the line.
    fn quadratic(&self, values: [f64; 3]) -> Witness<3> {
        if self.interval.base != Base::Middle {
            return [0, witness(values[1] / self.offset()), 0];
        }
        let step = self.sights[2].nu - self.sights[1].nu;
        let slope = (values[2] - values[0]) / (2.0 * step);
        let bend = (values[2] - 2.0 * values[1] + values[0]) / (2.0 * step * step);
        [values[1], slope, if self.interval.level >= FINE { 0.0 } else { bend }].map(witness)
    }

    /// The line through values at the nodes; at a resonance, from an integer to that in the middle;
    /// the value in the middle where contact jumps from one time to another.
    fn line(&self, values: [f64; 3]) -> Witness<2> {
        if self.interval.base != Base::Middle {
            let whole = libm::rint(values[1]);
            return [whole, (values[1] - whole) / self.offset()].map(witness);
        }
        let step = self.sights[2].nu - self.sights[1].nu;
        let jumps = self.interval.level >= FINE && (values[2] - values[0]).abs() > 0.01;
        let slope = if jumps { 0.0 } else { (values[2] - values[0]) / (2.0 * step) };
        [values[1], slope].map(witness)
    }

    /// From the base to the middle.
    fn offset(&self) -> f64 {
        self.sights[1].nu - self.interval.origin().to_f64()
    }

    /// When motion with these velocities is nearest to the wall, between two times.
    fn nearest(&self, velocities: [f64; 3], [low, high]: [f64; 2]) -> Witness<2> {
        self.line(core::array::from_fn(|i| {
            let motion = self.sights[i].family.motion(velocities[i]);
            nearest(self.oscillator, &motion, low, high)
        }))
    }

    fn at_sights(&self, value: impl Fn(&Sight) -> f64) -> [f64; 3] {
        core::array::from_fn(|i| value(&self.sights[i]))
    }

    fn all(&self, condition: impl Fn(&Sight) -> bool) -> bool {
        self.sights.iter().all(condition)
    }

    /// Clearance at velocities, whose values at the sights are given also.
    fn clearance(
        &self,
        velocities: [&Velocity; 2],
        values: [f64; 3],
        cells: i64,
        crossing: bool,
    ) -> Option<Clearance> {
        self.work.update(|work| work + (cells / CELLS[0]) as usize);
        let guess = |first: i64, last: i64| {
            self.nearest(values, [first, last + 1].map(|cell| cell as f64 / cells as f64))
        };
        self.model.clearance(velocities, cells, guess, crossing)
    }

    /// The verdict, if one can be proved at this width.
    fn verdict(&self) -> Option<Verdict> {
        if self.interval.base != Base::Middle && !self.model.crosses_at_resonance() {
            return None;
        }
        let turn = self.sights[1].touch as i64;
        if self.all(|sight| sight.graze == 0.0) && self.model.blocked(turn) {
            return Some(Verdict::Blocked { turn });
        }
        if self.all(|sight| sight.graze < sight.limit) {
            self.empty()
        } else if self.all(|sight| sight.graze > sight.limit) {
            self.edge().or_else(|| self.tube())
        } else {
            None
        }
        .or_else(|| if self.interval.level >= FINE { self.crossing() } else { None })
    }

    fn empty(&self) -> Option<Verdict> {
        // Half-way to the limit, or nearer to it where that is not beyond the wall.
        let values = self.at_sights(|sight| {
            let limit = if sight.limit.is_finite() { sight.limit } else { 4.0 * sight.graze };
            (0.5 * limit).max((limit * sight.graze).sqrt())
        });
        let upper = self.quadratic(values);
        let middle = self.sights[1].touch;
        let touch = self.nearest(values, [middle - 0.125, middle + 0.125]);
        let velocity = Velocity::Witness(upper);
        let proved = self.model.unstable(&velocity) && self.model.beyond(&velocity, touch);
        proved.then_some(Verdict::Empty { upper, touch })
    }

    fn edge(&self) -> Option<Verdict> {
        let amplitude = self.goal.amplitude.to_f64();
        let values = self.at_sights(|sight| {
            let Family { nu, c, w, .. } = sight.family;
            let grazing = self.oscillator.grazing_square(nu).sqrt();
            (1.0 + 1.01 * amplitude / grazing) / (c * c + w * w).sqrt()
        });
        if !(0..3).all(|i| values[i] < self.sights[i].graze) {
            return None;
        }
        let lower = self.quadratic(values);
        let velocity = Velocity::Witness(lower);
        let beyond = (self.model.amplitude(&velocity) - self.goal.amplitude).is_positive();
        let proved = beyond && self.model.stable(&velocity);
        let clear = |cells| self.clearance([&velocity; 2], values, cells, false);
        let clearance = proved.then(|| CELLS.into_iter().find_map(clear))??;
        Some(Verdict::Edge { lower, clearance })
    }

    fn tube(&self) -> Option<Verdict> {
        let smallest =
            |value: &dyn Fn(&Sight) -> f64| self.at_sights(value).into_iter().fold(f64::INFINITY, f64::min);
        // At a resonance the tube is twice as wide at the end as in the middle.
        let share = if self.interval.base == Base::Middle { 0.49 } else { 0.22 };
        let slope = self.model.amplitude_step_square([1 << WITNESS_BITS, 0, 0]).to_f64().sqrt();
        let width = share * self.goal.width.to_f64() / slope;
        let room = smallest(&|sight| 0.1 * (sight.graze - sight.limit).min(sight.graze));
        let half_width = width.min(room);
        let values = self.at_sights(|sight| sight.graze);
        let [lower, upper] =
            [-half_width, half_width].map(|offset| self.quadratic(values.map(|value| value + offset)));
        let touch = self.line(self.at_sights(|sight| sight.touch));
        let velocities = [lower, upper].map(Velocity::Witness);
        let step_square = self.model.amplitude_step_square(core::array::from_fn(|i| upper[i] - lower[i]));
        let proved = (self.goal.width * self.goal.width - step_square).is_positive()
            && self.model.stable(&velocities[0])
            && self.model.beyond(&velocities[1], touch);
        let values = values.map(|value| value - half_width);
        let clear = |cells| {
            let clearance = self.clearance(velocities.each_ref(), values, cells, false)?;
            let open: Vec<_> = clearance.blocks.iter().filter(|block| block.open).collect();
            let double = match open[..] {
                [_] => false,
                [one, two] => self.model.changes_contact_once([one, two], cells).then_some(true)?,
                _ => return None,
            };
            Some(Verdict::Tube { lower, upper, touch, clearance, double })
        };
        proved.then(|| CELLS.into_iter().find_map(clear))?
    }

    fn crossing(&self) -> Option<Verdict> {
        let factors = [Ball::ONE, Ball::A_LITTLE_ABOVE_ONE];
        let limits = factors.map(|factor| self.model.limit(self.interval.middle(), factor));
        CELLS.into_iter().find_map(|cells| {
            let values = self.at_sights(|sight| sight.limit);
            let clearance = self.clearance(limits.each_ref(), values, cells, true)?;
            let proved = self.model.crosses_once(limits.each_ref(), &clearance);
            proved.then_some(Verdict::Crossing { clearance })
        })
    }

    /// Why nothing could be proved of the finest interval.
    fn reason(&self) -> &'static str {
        if self.all(|sight| sight.limit < 1e-6) {
            "a resonance of one loop: stability begins at velocity zero, and so does contact"
        } else if self.all(|sight| (sight.graze - sight.limit).abs() < 1e-6) {
            "motion touches the wall where it becomes stable"
        } else {
            "the bounds are too wide"
        }
    }
}

/// The rows that tile an interval, of which with so much work at most.
pub fn rows(oscillator: &Oscillator, interval: Interval, goal: Goal, mut work: usize) -> Vec<Row> {
    let mut rows = Vec::new();
    tile(oscillator, interval, goal, &mut rows, &mut work);
    rows
}

fn tile(oscillator: &Oscillator, interval: Interval, goal: Goal, rows: &mut Vec<Row>, left: &mut usize) {
    let mut undecided = |reason| rows.push(Row { interval, verdict: Verdict::Undecided(reason) });
    if *left == 0 {
        return undecided("too many intervals were tried beside it");
    }
    let mut tried = |interval| {
        let attempt = Attempt::new(oscillator, interval, goal);
        let verdict = attempt.verdict();
        *left = left.saturating_sub(attempt.work.get());
        (attempt.reason(), verdict.map(|verdict| Row { interval, verdict }))
    };
    let (reason, mut row) = tried(interval);
    if let Some(base) = interval.resonance().filter(|_| interval.p > 1 && interval.level >= FINE) {
        row = row.or_else(|| tried(Interval { base, ..interval }).1);
    }
    match row {
        Some(row) => rows.push(row),
        None if interval.level >= goal.finest => undecided(reason),
        None => interval.halves().into_iter().for_each(|half| tile(oscillator, half, goal, rows, left)),
    }
}
