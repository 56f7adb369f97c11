//! What is proved, in stretches of frequency, and as sentences.

use core::iter;

use crate::ball::Ball;
use crate::orbit::Oscillator;
use crate::proof::{Model, Velocity};
use crate::resonance::Resonance;
use crate::row::{Block, Row, Verdict};

/// What holds in several intervals side by side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Stable admissible motion exists in an interval of amplitudes.
    Stable,
    /// None does.
    None,
    /// A point where such motion begins to exist: SN-GZ or PD-GZ.
    Crossing,
    /// One where contact changes from one time to another: GZ-GZ.
    Double,
    /// Nothing is stated, for this reason.
    Undecided(&'static str),
}

impl Kind {
    /// That of an interval.
    pub fn of(row: &Row) -> Self {
        match row.verdict {
            Verdict::Tube { double: true, .. } => Self::Double,
            Verdict::Tube { .. } | Verdict::Edge { .. } => Self::Stable,
            Verdict::Empty { .. } | Verdict::Blocked { .. } => Self::None,
            Verdict::Crossing { .. } => Self::Crossing,
            Verdict::Undecided(reason) => Self::Undecided(reason),
        }
    }
}

/// A stretch of frequencies in which the same holds.
#[derive(Debug, Clone)]
pub struct Stretch<'a> {
    /// What holds.
    pub kind: Kind,
    /// Its intervals.
    pub rows: &'a [Row],
    /// Whether exactly one point is in it: otherwise one at most in each of its intervals.
    pub exactly_one: bool,
    /// Where it begins and ends.
    pub omega: [Ball; 2],
    /// Amplitudes among which a point is.
    pub amplitude: Ball,
}

impl Stretch<'_> {
    /// What a point is called; nothing for others.
    pub fn point(&self, oscillator: &Oscillator) -> Option<&'static str> {
        let interval = self.rows[0].interval;
        let limit = Model::new(oscillator, interval).limit(interval.middle(), Ball::ONE);
        match (self.kind, limit) {
            (Kind::Double, _) => Some("GZ-GZ"),
            (Kind::Crossing, Velocity::SaddleNode(_)) => Some("SN-GZ"),
            (Kind::Crossing, _) => Some("PD-GZ"),
            _ => None,
        }
    }
}

/// The row of a number of loops that holds a ν.
pub fn row_at(rows: &[Row], p: i64, nu: Ball) -> Option<&Row> {
    rows.iter().find(|row| {
        let [left, right] = row.interval.ends();
        row.interval.p == p && !(left - nu).is_positive() && !(nu - right).is_positive()
    })
}

/// Where stable motion begins at one ν, and the two sides of the tube in which it ends, in amplitude;
/// the second beyond the window at its edge, nothing where there is none.
pub fn ends(oscillator: &Oscillator, row: &Row, nu: Ball) -> Option<[Ball; 3]> {
    let model = Model::new(oscillator, row.interval);
    let limit = model.limit(nu, Ball::ONE);
    let [lower, upper] = match row.verdict {
        Verdict::Tube { lower, upper, .. } => [lower, upper].map(Velocity::Witness),
        Verdict::Edge { lower, .. } => [Velocity::Witness(lower); 2],
        Verdict::Crossing { .. } => [limit, model.limit(nu, Ball::A_LITTLE_ABOVE_ONE)],
        Verdict::Empty { .. } | Verdict::Blocked { .. } | Verdict::Undecided(_) => return None,
    };
    Some([limit, lower, upper].map(|velocity| model.amplitude_at(nu, &velocity)))
}

/// The stretches, by decreasing frequency for each number of loops.
pub fn stretches<'a>(oscillator: &Oscillator, rows: &'a [Row]) -> Vec<Stretch<'a>> {
    let same = |a: &Row, b: &Row| a.interval.p == b.interval.p && Kind::of(a) == Kind::of(b);
    let groups: Vec<&[Row]> = rows.chunk_by(same).collect();
    let beside = |index: Option<usize>, p: i64| {
        index.and_then(|index| groups.get(index)).filter(|group| group[0].interval.p == p)
    };
    let stretch = |(index, group): (usize, &&'a [Row])| {
        let (rows, p) = (*group, group[0].interval.p);
        let before = beside(index.checked_sub(1), p).and_then(|group| group.last());
        let after = beside(Some(index + 1), p).and_then(|group| group.first());
        let exactly_one = before.zip(after).is_some_and(|(before, after)| match Kind::of(&rows[0]) {
            // Of one or two side by side, each with at most one change of sign.
            Kind::Crossing => {
                let some = [before, after].map(|row| match Kind::of(row) {
                    Kind::Stable | Kind::Double => Some(true),
                    Kind::None => Some(false),
                    Kind::Crossing | Kind::Undecided(_) => None,
                });
                rows.len() <= 2 && matches!(some, [Some(a), Some(b)] if a != b)
            }
            Kind::Double => contact_changes(before, rows, after),
            _ => false,
        });
        let ends = [&rows[rows.len() - 1], &rows[0]];
        let omega = [0, 1].map(|end| oscillator.omega_1 * ends[end].interval.ends()[1 - end].inverse());
        let amplitudes = |row: &Row| {
            let model = Model::new(oscillator, row.interval);
            let velocities = match row.verdict {
                Verdict::Tube { lower, upper, .. } => [lower, upper].map(Velocity::Witness),
                _ => [model.limit(row.interval.middle(), Ball::ONE); 2],
            };
            let [a, b] = velocities.map(|velocity| model.amplitude(&velocity));
            Ball::between(a, b)
        };
        let amplitude = match Kind::of(&rows[0]) {
            Kind::Crossing | Kind::Double => rows.iter().map(amplitudes).reduce(Ball::between),
            _ => None,
        };
        let amplitude = amplitude.unwrap_or(Ball::ANY);
        Stretch { kind: Kind::of(&rows[0]), rows, exactly_one, omega, amplitude }
    };
    groups.iter().enumerate().map(stretch).collect()
}

/// The blocks in which motion may touch the wall, as first and last time.
fn contacts(row: &Row) -> Vec<Ball> {
    match &row.verdict {
        Verdict::Tube { clearance, .. } => {
            let open = clearance.blocks.iter().filter(|block| block.open);
            open.filter_map(|block: &Block| block.times(clearance.cells).reduce(Ball::between)).collect()
        }
        _ => Vec::new(),
    }
}

/// Whether the time of contact is another after one or two rows than before. In each there are two,
/// and the velocities at which motion touches the wall at these differ by a monotone function, which
/// so has exactly one zero.
fn contact_changes(before: &Row, rows: &[Row], after: &Row) -> bool {
    let apart = |a: Ball, b: Ball| (a - b).is_not_zero();
    let both: Vec<Vec<Ball>> = rows.iter().map(contacts).collect();
    let same = both.windows(2).all(|two| apart(two[0][0], two[1][1]) && apart(two[0][1], two[1][0]));
    let (Some(first), Some(last)) = (both.first(), both.last()) else { return false };
    let ([before], [after]) = (&contacts(before)[..], &contacts(after)[..]) else { return false };
    let leads = |one: usize, two: usize| apart(*before, first[two]) && apart(*after, last[one]);
    rows.len() <= 2 && same && (leads(0, 1) || leads(1, 0))
}

/// Frequencies to nine places: rounded outwards, or inwards.
fn to_nine_places([low, high]: [Ball; 2], outwards: bool) -> [f64; 2] {
    let (down, up) = (
        |x: Ball| libm::floor(x.to_f64() * 1e9 - 1e-3) / 1e9,
        |x: Ball| libm::ceil(x.to_f64() * 1e9 + 1e-3) / 1e9,
    );
    if outwards { [down(low), up(high)] } else { [up(low), down(high)] }
}

/// What is proved in a stretch.
pub fn sentence(oscillator: &Oscillator, stretch: &Stretch<'_>) -> String {
    let p = stretch.rows[0].interval.p;
    let inwards = matches!(stretch.kind, Kind::Stable | Kind::None);
    let [low, high] = to_nine_places(stretch.omega, !inwards);
    let [least, most] = to_nine_places([stretch.amplitude.bottom(), stretch.amplitude.top()], true);
    let holds = match stretch.kind {
        Kind::Stable => format!(
            "one stable admissible {p}-loop MPS at each A between its SN or PD curve and its GZ curve or the window's edge, none at other A of the window"
        ),
        Kind::None => format!("no stable admissible {p}-loop MPS at any A"),
        Kind::Undecided(reason) => format!("UNDECIDED, {p}-loop MPSs: {reason}"),
        Kind::Crossing | Kind::Double => format!(
            "{} one codimension-two point, {}, p = {p}, with {least:.9} <= A <= {most:.9}",
            if stretch.exactly_one { "exactly" } else { "in each interval at most" },
            stretch.point(oscillator).unwrap_or_default(),
        ),
    };
    format!("{low:.9} <= omega <= {high:.9}: {holds}")
}

/// What share of the window, in `nu`, is left undecided.
pub fn undecided_share(rows: &[Row]) -> f64 {
    let width = |row: &Row| libm::scalbn(1.0, -(row.interval.level as i32));
    let all: f64 = rows.iter().map(width).sum();
    let left = rows.iter().filter(|row| matches!(row.verdict, Verdict::Undecided(_)));
    left.map(width).fold(0.0, |sum, width| sum + width) / all
}

/// What is proved of a resonance.
pub fn resonance(resonance: &Resonance) -> Vec<String> {
    let Resonance { p, n, criticality, missing, .. } = resonance;
    let theorem = if *p == 1 { "2.4" } else { "2.5" };
    let holds = if missing.is_empty() {
        format!("all hypotheses of Theorem {theorem} hold")
    } else {
        format!("NOT SHOWN of Theorem {theorem}: {}", missing.join(", "))
    };
    let doubling = if criticality.is_negative() {
        "negative: period doubling is supercritical next to the resonance (docs/beyond.md, 2)"
    } else if criticality.is_positive() {
        "positive: period doubling is subcritical next to the resonance (docs/beyond.md, 2)"
    } else {
        "its sign is NOT SHOWN: nothing is stated of criticality"
    };
    let numbers = resonance.numbers().map(|(name, number)| format!("  {name} = {number}"));
    let [numbers @ .., criticality] = numbers;
    iter::once(format!("p = {p}, n = {n}: {holds}"))
        .chain(numbers)
        .chain([format!("{criticality}, {doubling}")])
        .collect()
}
