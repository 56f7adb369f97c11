//! Searches, in floating point, for the rows and witnesses that [`IntervalMotions`] then proves.

use std::collections::VecDeque;

use crate::ball::{Ball, Number};
use crate::orbit::{MotionFamily, Oscillator};
use crate::proof::{FINE, IntervalMotions};
use crate::row::{Base, CertificateRow, Interval, IntervalVerdict, Reason, WITNESS_BITS, Witness};
use crate::statement::Statement;

/// Intervals are halved down to width `2^-FINEST`.
const FINEST: u32 = 40;

/// The greatest slope of a time as a function of ν.
const MOST_SLOPE: i128 = 256 << WITNESS_BITS;

/// Where stability and contact begin at velocities below this, these are too small for balls in units of
/// 2⁻⁸⁸, in which their squares matter: narrower intervals would not help.
const SLOW: f64 = 1.0 / (1_u64 << 36) as f64;

/// The greatest number of intervals tried within one of the coarsest. Figure 7 needs less than a quarter
/// of it.
const MOST_TRIED: u32 = 6_000;

/// The motions at one ν, in floating point.
struct Sight {
    nu: f64,
    family: MotionFamily<f64>,
    /// The velocity above which motion is stable.
    limit: f64,
    /// The velocity above which motion is no longer stable; infinite if there is none.
    end: f64,
    /// The velocities at which motion touches the wall as the velocity increases, in increasing order,
    /// and the times of contact in turns.
    contacts: Vec<[f64; 2]>,
}

impl Sight {
    fn new(oscillator: &Oscillator, p: i64, nu: f64) -> Self {
        let family = oscillator.family(p, nu);
        let [saddle_node, doubling] = [1, -1].map(|multiplier| family.velocity_at(multiplier));
        let (limit, end) = match (family.b > 0.0, family.big_q > 0.0) {
            (true, true) => (saddle_node, f64::INFINITY),
            (true, false) => (saddle_node, doubling),
            (false, true) => (doubling, f64::INFINITY),
            (false, false) => (f64::INFINITY, f64::INFINITY),
        };
        Self { nu, family, limit, end, contacts: contacts(oscillator, p, &family) }
    }

    /// The velocity up to which motion is admissible: 0 if there is none, infinite if all are.
    fn graze(&self) -> f64 {
        self.contacts[0][0]
    }

    /// A velocity at which motion is stable and has either left the window, which it does at `edge`, or
    /// lost stability before it touches the wall.
    fn last(&self, edge: f64) -> f64 {
        edge.max(1.01 * self.limit).min(1.01 * self.end).min(0.5 * (self.end + self.graze()))
    }

    /// A velocity between the greatest at which motion is admissible and the least at which it is stable:
    /// half the latter, or nearer to it.
    fn between(&self) -> f64 {
        let limit = if self.limit.is_finite() { self.limit } else { 4.0 * self.graze() };
        (0.5 * limit).max((limit * self.graze()).sqrt())
    }
}

/// The maxima of `psi/(1 - cos)` between impacts: the inverse of each, and its time.
fn contacts(oscillator: &Oscillator, p: i64, family: &MotionFamily<f64>) -> Vec<[f64; 2]> {
    // ψ, less what rounding may add to it, so that rounding is never taken for contact.
    let psi = |turns: f64| {
        let (decay, free_sine, free_cosine) = oscillator.free(family.nu, turns);
        let (sine, cosine) = turns.turn();
        let MotionFamily { c, e, w, .. } = family;
        let terms = [decay * c * free_cosine, decay * e * free_sine, -(c * cosine), -(w * sine)];
        let sum = |part: fn(f64) -> f64| terms.into_iter().map(part).fold(0.0, |sum, term| sum + term);
        sum(|term| term) - 4.0 * f64::EPSILON * sum(f64::abs)
    };
    let ratio = |turns: f64| {
        let half = (0.5 * turns).turn().0;
        psi(turns) / (2.0 * half * half)
    };
    if let Some(turn) = (1..p).map(|turn| turn as f64).find(|&turn| psi(turn) > 0.0) {
        return vec![[0.0, turn]];
    }
    // Peaks next to whole turns may be this narrow.
    let near = |n: i32| libm::exp2(-0.5 * f64::from(n));
    let in_period: Vec<f64> = (15..80)
        .rev()
        .map(near)
        .chain((1..128).map(|n| f64::from(n) / 128.0))
        .chain((15..80).map(|n| 1.0 - near(n)))
        .collect();
    let times: Vec<f64> =
        (0..p).flat_map(|turn| in_period.iter().map(move |time| turn as f64 + time)).collect();
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
    model: IntervalMotions<'a>,
    sights: [Sight; 3],
}

impl<'a> Attempt<'a> {
    fn new(statement: &'a Statement, interval: Interval) -> Self {
        let [left, right] = interval.ends().map(Ball::to_f64);
        // Three Chebyshev nodes.
        let sights = [-0.75f64.sqrt(), 0.0, 0.75f64.sqrt()].map(|node| {
            let nu = 0.5 * (left + right) + node * 0.5 * (right - left);
            Sight::new(&statement.oscillator, interval.p, nu)
        });
        Self { model: IntervalMotions::over(statement, interval), sights }
    }

    /// The polynomial through values at the three nodes. If the base is at a resonance, where velocities
    /// vanish and contact is at a whole turn, it is the line from `whole` to the value in the middle.
    fn polynomial(&self, values: [f64; 3], whole: f64) -> Witness<3> {
        let Interval { base, level, .. } = self.model.interval;
        if base != Base::Middle {
            let offset = self.sights[1].nu - self.model.interval.origin().to_f64();
            return [whole, (values[1] - whole) / offset, 0.0].map(witness);
        }
        let step = self.sights[2].nu - self.sights[1].nu;
        let slope = (values[2] - values[0]) / (2.0 * step);
        let bend = (values[2] - 2.0 * values[1] + values[0]) / (2.0 * step * step);
        [values[1], slope, if level >= FINE { 0.0 } else { bend }].map(witness)
    }

    fn time(&self, values: [f64; 3]) -> Witness<2> {
        let [constant, slope, _] = self.polynomial(values, libm::rint(values[1]));
        // Greater slopes have third powers that balls cannot represent.
        [constant, if slope.abs() < MOST_SLOPE { slope } else { 0 }]
    }

    /// The time within a range at which motion with these velocities is nearest to the wall: a zero of
    /// the slope of the distance, not an end of the range.
    fn nearest(&self, velocities: [f64; 3], [first, last]: [f64; 2]) -> Witness<2> {
        self.time(core::array::from_fn(|i| {
            let motion = self.sights[i].family.motion(velocities[i]);
            let margin = 1e-3 * (last - first);
            let (mut low, mut high) = (first + margin, last - margin);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                let [_, slope] = self.model.statement.oscillator.distance(&motion, middle);
                if slope < 0.0 { low = middle } else { high = middle }
            }
            0.5 * (low + high)
        }))
    }

    fn at_sights(&self, value: impl Fn(&Sight) -> f64) -> [f64; 3] {
        self.sights.each_ref().map(value)
    }

    fn all(&self, condition: impl Fn(&Sight) -> bool) -> bool {
        self.sights.iter().all(condition)
    }

    /// The row, if one can be proved at this width.
    fn row(&self) -> Option<CertificateRow> {
        self.best_row()
            .or_else(|| self.all(|sight| sight.graze().max(sight.limit) < SLOW).then(|| self.thin_row())?)
    }

    /// The row that states least: that stable admissible motion is next to the grazing curve, if there is
    /// any.
    fn thin_row(&self) -> Option<CertificateRow> {
        let row = CertificateRow::new(self.model.interval, IntervalVerdict::Thin);
        let slopes = self.at_sights(|sight| self.model.statement.oscillator.steepness_square(&sight.family));
        let values = slopes.map(|square| 0.45 * Statement::width().to_f64() / square.sqrt());
        let in_middle = self.sights[1].contacts[0][1];
        let touch = self.nearest(values, [in_middle - 0.125, in_middle + 0.125]);
        let row = CertificateRow { upper: Some(self.polynomial(values, 0.0)), touch: Some(touch), ..row };
        (0..3).all(|i| self.sights[i].graze() < 0.5 * values[i]).then(|| self.model.prove(row, &|_| touch))?
    }

    /// The row that states where motion exists, if one can be proved; guesses at the nearest approach to
    /// the wall use velocities `low`.
    fn best_row(&self) -> Option<CertificateRow> {
        let row = CertificateRow::new(self.model.interval, IntervalVerdict::None);
        let prove = |row, low| self.model.prove(row, &|stretch| self.nearest(low, stretch));
        let (in_middle, none) = (self.sights[1].contacts[0][1], [0.0; 3]);
        if self.all(|sight| sight.graze() == 0.0) {
            return prove(CertificateRow { touch: Some([witness(in_middle), 0]), ..row }, none);
        }
        if self.all(|sight| sight.graze() < sight.limit) {
            let values = self.at_sights(Sight::between);
            let touch = self.nearest(values, [in_middle - 0.125, in_middle + 0.125]);
            return prove(
                CertificateRow { upper: Some(self.polynomial(values, 0.0)), touch: Some(touch), ..row },
                none,
            );
        }
        let edges = self.at_sights(|sight| self.edge(sight));
        if (0..3).all(|i| self.sights[i].limit > 2.0 * edges[i]) {
            return prove(CertificateRow { upper: Some(self.polynomial(edges, 0.0)), ..row }, none);
        }
        let last = core::array::from_fn(|i| self.sights[i].last(edges[i]));
        if (0..3).all(|i| self.sights[i].graze() > last[i]) {
            return prove(CertificateRow { lower: Some(self.polynomial(last, 0.0)), ..row }, last);
        }
        let ([lower, upper], touch, low) = self.tube()?;
        prove(CertificateRow { lower: Some(lower), upper: Some(upper), touch: Some(touch), ..row }, low)
    }

    /// A velocity from which on amplitudes are beyond the window.
    fn edge(&self, sight: &Sight) -> f64 {
        let Statement { oscillator, amplitude, .. } = self.model.statement;
        let grazing = oscillator.grazing_square(sight.nu).sqrt();
        (grazing + 1.01 * amplitude[1].ball().to_f64()) / oscillator.steepness_square(&sight.family).sqrt()
    }

    /// Two velocities, one on either side of that at which motion touches the wall, with the time of
    /// contact and the values of the lower velocity.
    fn tube(&self) -> Option<([Witness<3>; 2], Witness<2>, [f64; 3])> {
        let in_middle = self.sights[1].contacts[0][1];
        let IntervalMotions { statement, interval, .. } = self.model;
        let (fine, stable) = (interval.level >= FINE, self.all(|sight| sight.graze() > sight.limit));
        // At a codimension-two point one contact is followed, even if another occurs earlier, by at most
        // `excess`.
        let away = |contact: &[f64; 2]| (contact[1] - in_middle).abs();
        let nearest =
            |sight: &Sight| sight.contacts.iter().copied().min_by(|a, b| away(a).total_cmp(&away(b)));
        let followed = |sight: &Sight| nearest(sight).filter(|_| fine).unwrap_or(sight.contacts[0]);
        let [values, times] = [0, 1].map(|of| self.at_sights(|sight| followed(sight)[of]));
        let excess = (0..3).fold(0.0, |most, i| f64::max(most, values[i] - self.sights[i].graze()));
        let is_point = excess > 0.0 || !stable || !self.all(|sight| sight.graze() < sight.end);
        // At a resonance the tube is twice as wide at the end as in the middle.
        let share = match (is_point, interval.base) {
            (true, _) if !fine => return None,
            (true, _) => 0.05,
            (false, Base::Middle) => 0.49,
            (false, _) => 0.22,
        };
        let half_widths = self.at_sights(|sight| {
            let slope = statement.oscillator.steepness_square(&sight.family).sqrt();
            let second = sight.contacts.get(1).map_or(f64::INFINITY, |contact| contact[0]);
            let next = second.min(sight.end) - sight.graze();
            let next = next.min(sight.graze() - sight.limit);
            // Beside a point the time of contact must be known well, also at low velocities.
            let room = if is_point { 0.02 * sight.graze() } else { sight.graze().min(next) };
            (0.1 * room).min(share * Statement::width().to_f64() / slope)
        });
        let half_width = half_widths.into_iter().fold(f64::INFINITY, f64::min);
        let low = values.map(|value| value - excess - half_width);
        let high = values.map(|value| value + half_width);
        Some(([low, high].map(|values| self.polynomial(values, 0.0)), self.time(times), low))
    }

    /// The reason why nothing could be proved for the finest interval.
    fn reason(&self) -> Reason {
        let resonance = self.model.interval.resonance_within();
        match resonance.filter(|_| self.all(|sight| sight.limit < 1e-6 && sight.graze() < 1e-6)) {
            Some([p, n]) => Reason::Resonance { p, n },
            None if self.all(|sight| (sight.graze() - sight.limit).abs() < 1e-6) => Reason::Coincidence,
            None => Reason::Width,
        }
    }
}

/// The rows that tile an interval. The widest intervals are tried first, so that what remains undecided
/// is narrow; no more are tried once `stopped`.
pub fn rows(statement: &Statement, whole: Interval, stopped: &dyn Fn() -> bool) -> Vec<CertificateRow> {
    let (mut waiting, mut rows, mut tried) = (VecDeque::from([whole]), Vec::new(), 0);
    while let Some(interval) = waiting.pop_front() {
        let undecided = |reason| CertificateRow::new(interval, IntervalVerdict::Undecided(reason));
        let resonance = interval.resonance().filter(|_| interval.p > 1 && interval.level >= FINE);
        let at_resonance = |base| Attempt::new(statement, Interval { base, ..interval }).row();
        rows.push(match tried {
            _ if stopped() => undecided(Reason::Interruption),
            MOST_TRIED => undecided(Reason::Number),
            _ => {
                tried += 1;
                let attempt = Attempt::new(statement, interval);
                let found = attempt.row();
                let on_edge = found.as_ref().is_some_and(|row| attempt.model.is_on_edge(row));
                match found.filter(|_| !on_edge).or_else(|| resonance.and_then(at_resonance)) {
                    Some(row) => row,
                    None if on_edge && interval.level >= FINEST => undecided(Reason::Edge),
                    None if interval.level >= FINEST => {
                        attempt.thin_row().unwrap_or_else(|| undecided(attempt.reason()))
                    }
                    None => {
                        waiting.extend(interval.halves());
                        continue;
                    }
                }
            }
        });
    }
    rows.sort_by_key(|row| row.interval.left << (FINEST - row.interval.level));
    joined(rows)
}

/// The rows with one in place of two halves that are undecided for the same reason.
fn joined(rows: Vec<CertificateRow>) -> Vec<CertificateRow> {
    let mut joined: Vec<CertificateRow> = Vec::new();
    for mut row in rows {
        while let Some(before) = joined.last() {
            let Interval { left, level, .. } = before.interval;
            let whole = Interval { left: left >> 1, level: level.saturating_sub(1), ..before.interval };
            let halves = level > 0 && whole.halves() == [before.interval, row.interval];
            if !(halves
                && matches!(row.verdict, IntervalVerdict::Undecided(_))
                && row.verdict == before.verdict)
            {
                break;
            }
            row.interval = whole;
            joined.pop();
        }
        joined.push(row);
    }
    joined
}
