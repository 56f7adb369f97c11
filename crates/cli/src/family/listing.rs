//! Lines about a family on the terminal.

use std::path::Path;

use grazing_analysis::family::{Plan, Varied};
use grazing_description::Description;
use grazing_results::Names;
use grazing_results::brief;
use grazing_results::family::{Family, Member, Resonance};

use crate::layout::{aligned, headed};
use crate::variation::Part;

/// Significant digits of numbers.
const DIGITS: usize = 6;
/// The most entries of a kind that are listed; more are counted.
const LISTED: usize = 24;

/// The line about the family that is about to be computed.
pub(super) fn plan(
    description: &Description,
    file: &Path,
    plan: &Plan,
    part: Option<Part>,
    members: usize,
) -> String {
    let varied = plan.varied.iter().map(|Varied { name, values }| {
        let [first, last] = [values[0], values[values.len() - 1]].map(|value| brief(value, DIGITS));
        format!("{name} from {first} to {last} in {} values", values.len())
    });
    let varied: Vec<String> = varied.collect();
    let part = part.map_or(String::new(), |Part { part, parts }| {
        format!(", of which {members} are in part {part} of {parts}")
    });
    format!(
        "{} ({}): {}; {} members{part}\n",
        description.name(),
        file.display(),
        varied.join(", "),
        plan.count()
    )
}

/// The results: curves of resonances, degenerate resonances, and members with something missing.
pub(super) fn results(family: &Family, names: &Names, plan: &Plan) -> String {
    let mut text = curves(family, names, plan);
    let count = plan.varied.len();
    let values = |varied: [f64; 3]| {
        let own = &varied[varied.len() - count..];
        let named = plan.varied.iter().zip(own);
        let set = named.map(|(constant, value)| format!("{} = {}", constant.name, brief(*value, DIGITS)));
        set.collect::<Vec<_>>().join(", ")
    };
    let degenerate = family.degenerate.iter().map(|row| {
        let at = values(row.varied);
        let mark = format!("  p = {}, n = {}: ", row.loops, row.n);
        let [primary, secondary] = [row.primary, row.secondary].map(|value| brief(value, DIGITS));
        let (quantity, meaning) = (&row.quantity, row.meaning.name());
        let place = format!("{} = {primary}, {} = {secondary}", names.primary, names.secondary);
        (mark, format!("{quantity} = 0 ({meaning}) at {at}, {place}"))
    });
    text.push_str(&some("Degenerate resonances between members", degenerate.collect()));
    let missing = family.members.iter().filter(|row| !row.missing.is_empty()).map(|row: &Member| {
        let at = values(row.varied);
        (format!("  {at}: "), row.missing.clone())
    });
    text.push_str(&some("Members of which something is missing", missing.collect()));
    text
}

/// Entries under a heading; of too many, the first ones and the number of the others.
fn some(heading: &str, mut entries: Vec<(String, String)>) -> String {
    if let Some(rest) = entries.len().checked_sub(LISTED).filter(|rest| *rest > 0) {
        entries.truncate(LISTED);
        entries.push(("  ".to_owned(), format!("and {rest} more, in the tables")));
    }
    headed(heading, entries)
}

/// A line for each curve of resonances, by p, with the constant that varies first at its ends.
fn curves(family: &Family, names: &Names, plan: &Plan) -> String {
    let mut curves: Vec<(u32, Vec<&Resonance>)> = Vec::new();
    for row in &family.resonances {
        match curves.iter_mut().find(|(curve, _)| *curve == row.curve) {
            Some((_, rows)) => rows.push(row),
            None => curves.push((row.curve, vec![row])),
        }
    }
    if curves.is_empty() {
        return "\nno resonant grazing bifurcation in the ranges of the parameters at any member\n"
            .to_owned();
    }
    let count = curves.len();
    curves.truncate(LISTED);
    let slot = 3 - plan.varied.len();
    let range = |rows: &[&Resonance], value: &dyn Fn(&Resonance) -> f64| {
        let known = || rows.iter().map(|row| value(row)).filter(|value| value.is_finite());
        match (known().next(), known().next_back()) {
            (Some(first), Some(last)) => format!("{} .. {}", brief(first, DIGITS), brief(last, DIGITS)),
            _ => "-".to_owned(),
        }
    };
    let lines = curves.iter().map(|(curve, rows)| {
        let mut line = vec![curve.to_string(), rows[0].loops.to_string(), rows[0].n.to_string()];
        line.extend(rows[0].varied[slot + 1..].iter().map(|value| brief(*value, DIGITS)));
        line.extend([rows.len().to_string(), range(rows, &|row| row.varied[slot])]);
        line.extend([
            range(rows, &|row| row.secondary),
            range(rows, &|row| row.c_sn),
            range(rows, &|row| row.c_pd),
        ]);
        line
    });
    let others = plan.varied[1..].iter().map(|other| other.name.as_str());
    let mut header = vec!["curve", "p", "n"];
    header.extend(others);
    let secondary = format!("{}*", names.secondary);
    header.extend(["members", plan.varied[0].name.as_str(), &secondary, "c_SN", "c_PD"]);
    let table = aligned(&header, lines);
    let more = match count.saturating_sub(LISTED) {
        0 => String::new(),
        more => format!("  and {more} more, in the tables\n"),
    };
    format!("\nCurves of resonances, with the values at their ends\n{table}{more}")
}
