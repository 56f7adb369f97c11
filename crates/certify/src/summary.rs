//! What is proved, as sentences.

use core::iter;

use crate::ball::Ball;
use crate::orbit::Oscillator;
use crate::resonance::Resonance;
use crate::row::{Row, Verdict};

/// What holds in several intervals side by side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Stable,
    None,
    Point,
    Undecided(&'static str),
}

fn kind(verdict: &Verdict) -> Kind {
    match verdict {
        Verdict::Tube { .. } | Verdict::Edge { .. } => Kind::Stable,
        Verdict::Empty { .. } | Verdict::Blocked { .. } => Kind::None,
        Verdict::Crossing { .. } => Kind::Point,
        Verdict::Undecided(reason) => Kind::Undecided(reason),
    }
}

/// The frequencies of intervals of ν to nine places: rounded outwards, or inwards.
fn frequencies(oscillator: &Oscillator, first: &Row, last: &Row, outwards: bool) -> [f64; 2] {
    let at = |nu: Ball| (oscillator.omega_1 * nu.inverse()).to_f64() * 1e9;
    let (low, high) = (at(last.interval.ends()[1]), at(first.interval.ends()[0]));
    let (down, up) = (|x: f64| libm::floor(x - 1e-3) / 1e9, |x: f64| libm::ceil(x + 1e-3) / 1e9);
    if outwards { [down(low), up(high)] } else { [up(low), down(high)] }
}

/// What is proved for one number of loops, by decreasing frequency.
pub fn regions(oscillator: &Oscillator, rows: &[Row]) -> Vec<String> {
    let mut sentences = Vec::new();
    let mut groups: Vec<(Kind, &Row, &Row)> = Vec::new();
    for row in rows {
        match groups.last_mut() {
            Some((last, _, end)) if *last == kind(&row.verdict) => *end = row,
            _ => groups.push((kind(&row.verdict), row, row)),
        }
    }
    // Of one or two crossings side by side, each with at most one change of sign, exactly one is a
    // point if what is proved on either side is different.
    let is_point = |index: usize| {
        let (_, first, last) = groups[index];
        let few = first == last || first.interval.ends()[1] == last.interval.ends()[0];
        let beside = [index.checked_sub(1), Some(index + 1)].map(|i| groups.get(i?).map(|group| group.0));
        few && matches!(
            beside,
            [Some(Kind::Stable), Some(Kind::None)] | [Some(Kind::None), Some(Kind::Stable)]
        )
    };
    for (index, &(kind, first, last)) in groups.iter().enumerate() {
        let p = first.interval.p;
        let outwards = matches!(kind, Kind::Point | Kind::Undecided(_));
        let [low, high] = frequencies(oscillator, first, last, outwards);
        sentences.push(match kind {
            Kind::Stable => format!(
                "{low:.9} <= omega <= {high:.9}: one stable admissible {p}-loop MPS at each A between its SN or PD curve and its GZ curve or the window's edge, none at other A of the window"
            ),
            Kind::None => format!("{low:.9} <= omega <= {high:.9}: no stable admissible {p}-loop MPS at any A"),
            Kind::Point => {
                let middle = oscillator.family(p, 0.5 * first.interval.ends().map(Ball::to_f64).iter().sum::<f64>());
                let name = if middle.b > 0.0 { "SN-GZ" } else { "PD-GZ" };
                format!("{low:.9} <= omega <= {high:.9}: {} one codimension-two point, {name}, p = {p}",
                    if is_point(index) { "exactly" } else { "at most" },
                )
            }
            Kind::Undecided(reason) => format!("{low:.9} <= omega <= {high:.9}: UNDECIDED, {p}-loop MPSs: {reason}"),
        });
    }
    sentences
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
