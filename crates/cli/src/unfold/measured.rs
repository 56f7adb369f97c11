//! Measurements beside computed results, as lines on the terminal.

use grazing_results::brief;
use grazing_results::measured::{Agreement, Comparison, MeasuredCount, MeasuredPoint};

use crate::layout::Layout;

/// Digits of places.
const DIGITS: usize = 6;
/// The most disagreeing measurements that are listed; all are in data/measured.csv.
const LISTED: usize = 5;

/// How many agree, region by region, and which do not.
pub(super) fn listing(layout: Layout, compared: &Comparison) -> String {
    let row = |count: &MeasuredCount| {
        let region = if count.region == 0 { "-".to_owned() } else { count.region.to_string() };
        let loops = if count.kind == "none" { "-".to_owned() } else { count.loops.to_string() };
        let numbers =
            [count.points, count.agree, count.within_error, count.disagree, count.undecided, count.silent];
        let mut cells = vec![region, count.kind.clone(), loops];
        cells.extend(numbers.map(|number| number.to_string()));
        cells
    };
    let heads =
        ["region", "kind", "p", "measured", "agree", "within error", "disagree", "undecided", "not computed"];
    let counts = layout.aligned(&heads, compared.counts.iter().map(row));
    let against: Vec<&MeasuredPoint> =
        compared.points.iter().filter(|point| point.agreement == Agreement::Disagrees).collect();
    let entry = |point: &&MeasuredPoint| {
        let at = [point.primary, point.secondary].map(|value| brief(value, DIGITS));
        let reason = match point.distance.is_nan() {
            true => point.reason.clone(),
            false => format!("{} standard errors away: {}", brief(point.distance, 3), point.reason),
        };
        ("  ".to_owned(), format!("line {} ({}, {}), {}: {reason}", point.line, at[0], at[1], point.seen))
    };
    let more = against.len().saturating_sub(LISTED);
    let rest = (more > 0).then(|| ("  ".to_owned(), format!("and {more} more, in data/measured.csv")));
    let entries = against.iter().take(LISTED).map(entry).chain(rest);
    format!(
        "\nMeasurements compared with the computation\n{counts}{}",
        layout.headed("Measurements that disagree", entries)
    )
}
