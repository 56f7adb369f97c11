//! Finds, in floating point, the rows and witnesses that [`Model`] then proves.

use core::cell::Cell;

use crate::ball::{Ball, Number};
use crate::orbit::{Family, Oscillator};
use crate::proof::{At, Model};
use crate::row::{Base, Clearance, Interval, Row, Verdict, WITNESS_BITS, Witness};

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
    /// The velocities at which motion with increasing velocity touches the wall, and when, in turns.
    contacts: Vec<[f64; 2]>,
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
        Self { nu, family, limit, contacts: contacts(oscillator, p, &family) }
    }

    /// The velocity up to which motion is admissible: 0 if there is none, infinite if all are.
    fn graze(&self) -> f64 {
        self.contacts[0][0]
    }

    /// The contact whose time is nearest to this.
    fn contact_near(&self, time: f64) -> [f64; 2] {
        let nearer = |a: &&[f64; 2], b: &&[f64; 2]| (a[1] - time).abs().total_cmp(&(b[1] - time).abs());
        self.contacts.iter().min_by(nearer).copied().unwrap_or(self.contacts[0])
    }
}

/// Where `psi/(1 - cos)` is greatest between impacts, as its inverse and its time.
fn contacts(oscillator: &Oscillator, p: i64, family: &Family<f64>) -> Vec<[f64; 2]> {
    let motion = family.motion(1.0);
    let ratio = |turns: f64| {
        let half = (0.5 * turns).turn().0;
        let rise = 2.0 * half * half;
        (rise - oscillator.distance(&motion, turns, 0)) / rise
    };
    let whole = (1..p).find(|&turn| oscillator.distance(&motion, turn as f64, 0) <= 0.0);
    if let Some(turn) = whole {
        return vec![[0.0, turn as f64]];
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
        [1.0 / ratio(touch), touch]
    };
    let greatest = |&i: &usize| ratios[i] > 0.0 && ratios[i] >= ratios[i - 1] && ratios[i] >= ratios[i + 1];
    let mut contacts: Vec<[f64; 2]> = (1..times.len() - 1).filter(greatest).map(peak).collect();
    contacts.sort_by(|a, b| a[0].total_cmp(&b[0]));
    if contacts.is_empty() { vec![[f64::INFINITY, 0.5]] } else { contacts }
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
        let model = Model::over(oscillator, interval);
        Self { oscillator, model, interval, goal, sights, work: Cell::new(1) }
    }

    /// The polynomial through values at the three nodes. With the base at a resonance, where velocities
    /// vanish and contact is at a whole turn, the line from `whole` to the value in the middle.
    fn polynomial(&self, values: [f64; 3], whole: f64) -> Witness<3> {
        if self.interval.base != Base::Middle {
            let offset = self.sights[1].nu - self.interval.origin().to_f64();
            return [whole, (values[1] - whole) / offset, 0.0].map(witness);
        }
        let step = self.sights[2].nu - self.sights[1].nu;
        let slope = (values[2] - values[0]) / (2.0 * step);
        let bend = (values[2] - 2.0 * values[1] + values[0]) / (2.0 * step * step);
        [values[1], slope, if self.interval.level >= FINE { 0.0 } else { bend }].map(witness)
    }

    fn velocity(&self, values: [f64; 3]) -> Witness<3> {
        self.polynomial(values, 0.0)
    }

    fn time(&self, values: [f64; 3]) -> Witness<2> {
        let [constant, slope, _] = self.polynomial(values, libm::rint(values[1]));
        [constant, slope]
    }

    /// When motion with these velocities is nearest to the wall between two times: where the slope of the
    /// distance is zero.
    fn nearest(&self, velocities: [f64; 3], [first, last]: [f64; 2]) -> Witness<2> {
        let times = core::array::from_fn(|i| {
            let motion = self.sights[i].family.motion(velocities[i]);
            let (mut low, mut high) = (first, last);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                let falls = self.oscillator.distance(&motion, middle, 1) < 0.0;
                if falls { low = middle } else { high = middle }
            }
            0.5 * (low + high)
        });
        self.time(times)
    }

    fn at_sights(&self, value: impl Fn(&Sight) -> f64) -> [f64; 3] {
        self.sights.each_ref().map(value)
    }

    fn all(&self, condition: impl Fn(&Sight) -> bool) -> bool {
        self.sights.iter().all(condition)
    }

    fn least(&self, value: impl Fn(&Sight) -> f64) -> f64 {
        self.at_sights(value).into_iter().fold(f64::INFINITY, f64::min)
    }

    /// Clearance at velocities up to that of a second witness, whose values at the sights are given also.
    fn clearance(&self, [lower, upper]: [Witness<3>; 2], values: [f64; 3]) -> Option<Clearance> {
        CELLS.into_iter().find_map(|cells| {
            self.work.update(|work| work + (cells / CELLS[0]) as usize);
            // A block is not nearest just at its ends.
            let guess = |[first, end]: [i64; 2]| {
                let inside = [first as f64 + 1e-3, end as f64 - 1e-3];
                self.nearest(values, inside.map(|cell| cell / cells as f64))
            };
            self.model.clearance([&|at| at.witness(lower), &|at| at.witness(upper)], cells, guess)
        })
    }

    /// The row, if one can be proved at this width.
    fn row(&self) -> Option<Row> {
        if self.interval.base != Base::Middle && !self.model.crosses_at_resonance() {
            return None;
        }
        self.blocked().or_else(|| self.empty()).or_else(|| self.edge()).or_else(|| self.tube())
    }

    fn blocked(&self) -> Option<Row> {
        let turn = [witness(self.sights[1].contacts[0][1]), 0];
        let proved = self.all(|sight| sight.graze() == 0.0) && self.model.blocked(turn);
        proved.then(|| Row { touch: Some(turn), ..Row::new(self.interval, Verdict::None) })
    }

    fn empty(&self) -> Option<Row> {
        // Half-way to the limit, or nearer to it where that is not beyond the wall.
        let values = self.at_sights(|sight| {
            let limit = if sight.limit.is_finite() { sight.limit } else { 4.0 * sight.graze() };
            (0.5 * limit).max((limit * sight.graze()).sqrt())
        });
        if !self.all(|sight| sight.graze() < sight.limit) {
            return None;
        }
        let (upper, middle) = (self.velocity(values), self.sights[1].contacts[0][1]);
        let touch = self.nearest(values, [middle - 0.125, middle + 0.125]);
        let velocity = |at: &At| at.witness(upper);
        let proved = self.model.unstable(&velocity) && self.model.beyond(&velocity, touch);
        let row = Row::new(self.interval, Verdict::None);
        proved.then_some(Row { upper: Some(upper), touch: Some(touch), ..row })
    }

    fn edge(&self) -> Option<Row> {
        let amplitude = self.goal.amplitude.to_f64();
        let value = |sight: &Sight| {
            let Family { nu, c, w, .. } = sight.family;
            let grazing = self.oscillator.grazing_square(nu).sqrt();
            (1.0 + 1.01 * amplitude / grazing) / (c * c + w * w).sqrt()
        };
        if !self.all(|sight| sight.graze() > value(sight)) {
            return None;
        }
        let values = self.at_sights(value);
        let lower = self.velocity(values);
        let velocity = |at: &At| at.witness(lower);
        let beyond = (self.model.amplitude(&velocity) - self.goal.amplitude).is_positive();
        let proved = beyond && self.model.stable(&velocity);
        let clearance = proved.then(|| self.clearance([lower; 2], values))??;
        let row = Row::new(self.interval, Verdict::Stable);
        Some(Row { lower: Some(lower), clearance: Some(clearance), ..row })
    }

    fn tube(&self) -> Option<Row> {
        let in_middle = self.sights[1].contacts[0][1];
        let (fine, stable) = (self.interval.level >= FINE, self.all(|sight| sight.graze() > sight.limit));
        // At a point one contact is followed, even where another is made earlier, by as much as this.
        let contact = |i: usize| {
            let sight = &self.sights[i];
            if fine { sight.contact_near(in_middle) } else { sight.contacts[0] }
        };
        let [values, times] = [0, 1].map(|of| core::array::from_fn(|i| contact(i)[of]));
        let excess = (0..3).fold(0.0, |most, i| f64::max(most, values[i] - self.sights[i].graze()));
        let is_point = excess > 0.0 || !stable;
        // At a resonance the tube is twice as wide at the end as in the middle.
        let share = match (is_point, self.interval.base) {
            (true, _) if !fine => return None,
            (true, _) => 0.05,
            (false, Base::Middle) => 0.49,
            (false, _) => 0.22,
        };
        let slope = self.model.amplitude_step_square([1 << WITNESS_BITS, 0, 0]).to_f64().sqrt();
        let width = share * self.goal.width.to_f64() / slope;
        let room = self.least(|sight| {
            let second = sight.contacts.get(1).map_or(f64::INFINITY, |contact| contact[0]);
            let next = (second - sight.graze()).min(sight.graze() - sight.limit);
            0.1 * if is_point { sight.graze() } else { sight.graze().min(next) }
        });
        let half_width = width.min(room);
        let low = values.map(|value| value - excess - half_width);
        let [lower, upper] = [low, values.map(|value| value + half_width)].map(|v| self.velocity(v));
        let touch = self.time(times);
        let step_square = self.model.amplitude_step_square(core::array::from_fn(|i| upper[i] - lower[i]));
        let stable = stable && self.model.stable(&|at| at.witness(lower));
        let proved = (self.goal.width * self.goal.width - step_square).is_positive()
            && (stable || fine)
            && self.model.beyond(&|at| at.witness(upper), touch);
        let clearance = proved.then(|| self.clearance([lower, upper], low))??;
        let verdict = match (stable, clearance.open) {
            (true, 1) => Verdict::Stable,
            (true, 2) | (false, 1) if fine => Verdict::Point(self.model.point(&clearance)?),
            _ => return None,
        };
        Some(Row {
            lower: Some(lower),
            upper: Some(upper),
            touch: Some(touch),
            clearance: Some(clearance),
            ..Row::new(self.interval, verdict)
        })
    }

    /// Why nothing could be proved of the finest interval.
    fn reason(&self) -> &'static str {
        if self.all(|sight| sight.limit < 1e-6) {
            "a resonance of one loop: stability begins at velocity zero, and so does contact"
        } else if self.all(|sight| (sight.graze() - sight.limit).abs() < 1e-6) {
            "motion touches the wall where it becomes stable"
        } else {
            "the bounds are too wide"
        }
    }
}

/// The rows that tile an interval, `left` being how much work may be done.
pub fn rows(oscillator: &Oscillator, interval: Interval, goal: Goal, left: &mut usize) -> Vec<Row> {
    let undecided = |reason| vec![Row::new(interval, Verdict::Undecided(reason))];
    if *left == 0 {
        return undecided("too many intervals were tried beside it");
    }
    let attempt = Attempt::new(oscillator, interval, goal);
    let mut row = attempt.row();
    *left = left.saturating_sub(attempt.work.get());
    let resonance = interval.resonance().filter(|_| interval.p > 1 && interval.level >= FINE);
    if let (None, Some(base)) = (&row, resonance) {
        row = Attempt::new(oscillator, Interval { base, ..interval }, goal).row();
    }
    match row {
        Some(row) => vec![row],
        None if interval.level >= goal.finest => undecided(attempt.reason()),
        None => interval.halves().into_iter().flat_map(|half| rows(oscillator, half, goal, left)).collect(),
    }
}
