//! The proved results, by ranges of frequency and as sentences.

use core::iter;

use crate::ball::Ball;
use crate::proof::IntervalMotions;
use crate::resonance::{EnclosedResonance, NAMES};
use crate::row::{CertificateRow, Interval, IntervalVerdict};
use crate::statement::{Statement, WIDTH_PLACES};

/// The row for a number of loops whose interval contains a ν.
pub fn row_at(rows: &[CertificateRow], p: i64, nu: Ball) -> Option<&CertificateRow> {
    rows.iter().find(|row| {
        let [left, right] = row.interval.ends();
        row.interval.p == p && !(left - nu).is_positive() && !(nu - right).is_positive()
    })
}

/// The amplitude at which stable motion begins at one ν, and two amplitudes between which it ends; the
/// second is missing where motion continues to the window's edge. Nothing where there is no stable
/// motion.
pub fn ends(statement: &Statement, row: &CertificateRow, nu: Ball) -> Option<(Ball, Ball, Option<Ball>)> {
    let (model, lower) = (IntervalMotions::at(statement, row.interval, nu), row.lower?);
    let side = |side| model.amplitude(model.witness(side));
    let begins = model.amplitude(model.limit());
    Some(match (row.upper, model.end_below(model.witness(lower))) {
        (Some(upper), _) => (begins, side(lower), Some(side(upper))),
        (None, Some(end)) => (begins, end, Some(end)),
        (None, None) => (begins, side(lower), None),
    })
}

/// The points in the window, away from resonances, at which GZ curves that bound stable motion end or
/// meet, each with its kind.
pub fn points<'a>(
    statement: &'a Statement,
    rows: &'a [CertificateRow],
) -> impl Iterator<Item = (&'static str, &'a CertificateRow)> {
    rows.iter().filter(|row| is_in_window(statement, row)).filter_map(|row| Some((point(row)?, row)))
}

/// The kind of a row's point; at a PD-GZ point stability begins or ends.
fn point(row: &CertificateRow) -> Option<&'static str> {
    match row.verdict {
        IntervalVerdict::Point("GZ-PD") => Some("PD-GZ"),
        IntervalVerdict::Point(name) => Some(name),
        _ => None,
    }
}

/// Whether the point of a row is proved to be in the window.
fn is_in_window(statement: &Statement, row: &CertificateRow) -> bool {
    let CertificateRow { interval, lower, .. } = *row;
    point(row).is_some()
        && lower.and_then(|lower| IntervalMotions::over(statement, interval).is_in_window(lower))
            == Some(true)
}

/// A range of amplitudes that contains a point: the tube, where amplitudes increase with the velocity; or
/// the range, if narrower, of amplitudes at which stability begins. At an SN-GZ point it is the latter,
/// from which amplitudes no longer decrease.
pub fn amplitudes(statement: &Statement, row: &CertificateRow) -> Ball {
    let model = IntervalMotions::over(statement, row.interval);
    let side = |side: Option<_>| side.map_or(Ball::ANY, |side| model.amplitude(model.witness(side)));
    let (tube, limit) = (Ball::between(side(row.lower), side(row.upper)), model.amplitude(model.limit()));
    match row.verdict {
        IntervalVerdict::Point("SN-GZ") => limit,
        IntervalVerdict::Point("PD-GZ") if limit.radius() < tube.radius() => limit,
        _ => tube,
    }
}

/// The range of frequencies that consecutive rows cover.
pub fn frequencies(statement: &Statement, rows: &[CertificateRow]) -> [Ball; 2] {
    let ends = [rows[rows.len() - 1].interval.ends()[1], rows[0].interval.ends()[0]];
    ends.map(|nu| statement.oscillator.omega_1_over(nu))
}

/// Groups of adjacent rows with the same verdict, by decreasing frequency for each number of loops; each
/// point is a group of its own.
pub fn stretches(rows: &[CertificateRow]) -> impl Iterator<Item = &[CertificateRow]> {
    rows.chunk_by(|a, b| {
        let point = matches!(a.verdict, IntervalVerdict::Point(_));
        a.interval.p == b.interval.p && a.verdict == b.verdict && !point
    })
}

/// Two bounds, rounded to nine places outwards or inwards.
fn to_nine_places([low, high]: [Ball; 2], outwards: bool) -> [f64; 2] {
    let scale = if outwards { 1e9 } else { -1e9 };
    [libm::floor(scale * low.to_f64() - 1e-3), libm::ceil(scale * high.to_f64() + 1e-3)]
        .map(|end| end / scale)
}

/// A sentence that states the proved result for a group of rows.
pub fn sentence(statement: &Statement, stretch: &[CertificateRow]) -> String {
    let CertificateRow { interval: Interval { p, .. }, verdict, .. } = &stretch[0];
    let inwards = matches!(verdict, IntervalVerdict::Stable | IntervalVerdict::None | IntervalVerdict::Thin);
    let [low, high] = to_nine_places(frequencies(statement, stretch), !inwards);
    let holds = match verdict {
        IntervalVerdict::Stable => format!(
            "one stable admissible {p}-loop MPS at each A between the SN or PD curve where it becomes stable and its GZ curve, a PD curve or the window's edge, none at other A of the window"
        ),
        IntervalVerdict::None => format!("no stable admissible {p}-loop MPS at any A of the window"),
        IntervalVerdict::Thin => {
            let resonance = stretch.iter().find_map(|row| row.interval.resonance_within());
            let why =
                resonance.map_or_else(String::new, |[p, n]| format!(", at the resonance p = {p}, n = {n}"));
            format!(
                "no stable admissible {p}-loop MPS at any A of the window farther than 1e-{WIDTH_PLACES} from grazing{why}; closer, nothing is stated"
            )
        }
        IntervalVerdict::Undecided(reason) => format!("UNDECIDED, {p}-loop MPSs: {reason}"),
        IntervalVerdict::Point(_) => {
            let name = point(&stretch[0]).unwrap_or_default();
            let place = if is_in_window(statement, &stretch[0]) { "" } else { ", beyond the window" };
            let amplitudes = amplitudes(statement, &stretch[0]);
            let [least, most] = to_nine_places([amplitudes.bottom(), amplitudes.top()], true);
            format!(
                "in a part of it exactly one point, {name}, p = {p}, with {least:.9} <= A <= {most:.9}{place}"
            )
        }
    };
    format!("{low:.9} <= omega <= {high:.9}: {holds}")
}

/// The fraction of the window, in `nu`, that is undecided.
pub fn undecided_share(rows: &[CertificateRow]) -> f64 {
    let width = |row: &CertificateRow| libm::scalbn(1.0, -(row.interval.level as i32));
    let all: f64 = rows.iter().map(width).sum();
    let left = rows.iter().filter(|row| matches!(row.verdict, IntervalVerdict::Undecided(_)));
    left.map(width).fold(0.0, |sum, width| sum + width) / all
}

/// What a statement about all other places of the window excepts.
pub fn exceptions(rows: &[CertificateRow]) -> &'static str {
    let some = |is: fn(&IntervalVerdict) -> bool| rows.iter().any(|row| is(&row.verdict));
    let undecided = some(|verdict| matches!(verdict, IntervalVerdict::Undecided(_)));
    match (undecided, some(|verdict| *verdict == IntervalVerdict::Thin)) {
        (false, false) => "",
        (true, false) => " outside of what is undecided",
        (false, true) => " outside of tubes at grazing in which nothing is stated",
        (true, true) => " outside of what is undecided and of tubes at grazing in which nothing is stated",
    }
}

/// Sentences that state the proved results for a resonance.
pub fn resonance(EnclosedResonance { p, n, numbers, missing }: &EnclosedResonance) -> Vec<String> {
    let theorem = if *p == 1 { "2.4" } else { "2.5" };
    let holds = if missing.is_empty() {
        format!("all hypotheses of Theorem {theorem} hold")
    } else {
        format!("NOT SHOWN of Theorem {theorem}: {}", missing.join(", "))
    };
    let [.., criticality] = numbers;
    let doubling = match (criticality.is_negative(), criticality.is_positive()) {
        (true, _) => "negative: period doubling is supercritical next to the resonance (docs/beyond.md, 2)",
        (_, true) => "positive: period doubling is subcritical next to the resonance (docs/beyond.md, 2)",
        _ => "not shown to have a sign: nothing is stated of criticality",
    };
    iter::once(format!("p = {p}, n = {n}: {holds}"))
        .chain(NAMES.iter().zip(numbers).map(|(name, number)| format!("  {name} = {number}")))
        .chain([format!("  which is {doubling}")])
        .collect()
}
