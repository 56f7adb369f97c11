//! Lines about a family on the terminal.

use std::path::Path;

use grazing_input::Description;
use grazing_results::family::{Family, FamilyResonance, Member};
use grazing_results::{Names, brief, with_unit};
use grazing_unfold::family::{FamilyPlan, Varied};

use crate::layout::Layout;
use crate::variation::PartNumber;

/// Significant digits of numbers.
const DIGITS: usize = 6;
/// The most lines of a kind that are listed; of more the rest is counted.
const LISTED: usize = 5;
/// The most curves that are listed.
const CURVES: usize = 24;

/// The line about the family that is about to be computed.
pub(super) fn plan(
    layout: Layout,
    description: &Description,
    file: &Path,
    plan: &FamilyPlan,
    part: Option<PartNumber>,
    members: usize,
) -> String {
    let varied = plan.varied.iter().map(|Varied { name, values }| {
        let [first, last] = [values[0], values[values.len() - 1]].map(|value| brief(value, DIGITS));
        format!("{name} takes {} values from {first} to {last}", values.len())
    });
    let varied: Vec<String> = varied.collect();
    let part = part.map_or(String::new(), |PartNumber { part, parts }| {
        format!(", {members} of them in part {part} of {parts}")
    });
    let varied = varied.join(", ");
    let text =
        format!("{} ({}): {varied}; {} members{part}", description.name(), file.display(), plan.count());
    layout.wrapped("", &text)
}

/// What was found.
pub(super) fn results(layout: Layout, family: &Family, names: &Names, plan: &FamilyPlan) -> String {
    let mut text = curves(layout, family, names, plan);
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
    let file = "data/family_degenerate.csv";
    text.push_str(&some(layout, "Degenerate resonances between members", degenerate.collect(), file));
    let missing = family.members.iter().filter(|row| !row.missing.is_empty()).map(|row: &Member| {
        let at = values(row.varied);
        (format!("  {at}: "), row.missing.clone())
    });
    let file = "data/family_members.csv";
    text.push_str(&some(layout, "Members with missing results", missing.collect(), file));
    text
}

/// Entries under a heading; of many, a line that counts them and names the file that has them all.
fn some(layout: Layout, heading: &str, mut entries: Vec<(String, String)>, file: &str) -> String {
    if entries.len() > LISTED {
        entries = vec![("  ".to_owned(), format!("{} of them, in {file}", entries.len()))];
    }
    layout.headed(heading, entries)
}

/// A line for each curve of resonances, by p, with the constant that varies first at its ends.
fn curves(layout: Layout, family: &Family, names: &Names, plan: &FamilyPlan) -> String {
    let mut curves: Vec<(u32, Vec<&FamilyResonance>)> = Vec::new();
    for row in &family.resonances {
        match curves.iter_mut().find(|(curve, _)| *curve == row.curve) {
            Some((_, rows)) => rows.push(row),
            None => curves.push((row.curve, vec![row])),
        }
    }
    if curves.is_empty() {
        return "\nNo member has a resonant grazing bifurcation in the ranges of the parameters.\n"
            .to_owned();
    }
    let count = curves.len();
    curves.truncate(CURVES);
    let slot = 3 - plan.varied.len();
    let range = |rows: &[&FamilyResonance], value: &dyn Fn(&FamilyResonance) -> f64| {
        let known = || rows.iter().map(|row| value(row)).filter(|value| value.is_finite());
        match (known().next(), known().next_back()) {
            (Some(first), Some(last)) => format!("{} .. {}", brief(first, DIGITS), brief(last, DIGITS)),
            _ => "-".to_owned(),
        }
    };
    let lines = curves.iter().map(|(curve, rows)| {
        let mut line = vec![curve.to_string(), rows[0].loops.to_string(), rows[0].n.to_string()];
        line.extend((rows[0].wall > 0).then(|| rows[0].wall.to_string()));
        line.extend(rows[0].varied[slot + 1..].iter().map(|value| brief(*value, DIGITS)));
        line.extend([rows.len().to_string(), range(rows, &|row| row.varied[slot])]);
        line.extend([
            range(rows, &|row| row.secondary),
            range(rows, &|row| row.coefficients.c_sn),
            range(rows, &|row| row.coefficients.c_pd),
        ]);
        line
    });
    let others = plan.varied[1..].iter().map(|other| other.name.as_str());
    let mut header = vec!["curve", "p", "n"];
    header.extend((curves[0].1[0].wall > 0).then_some("wall"));
    header.extend(others);
    let secondary = with_unit(&format!("{}*", names.secondary), names.named_unit("{secondary}").as_deref());
    let coefficient = names.named_unit("{primary}/{secondary}^2");
    let [c_sn, c_pd] = ["c_SN", "c_PD"].map(|head| with_unit(head, coefficient.as_deref()));
    header.extend(["members", plan.varied[0].name.as_str(), &secondary, &c_sn, &c_pd]);
    let table = layout.aligned(&header, lines);
    let more = match count.saturating_sub(CURVES) {
        0 => String::new(),
        more => format!("  and {more} more, in data/family_resonances.csv\n"),
    };
    format!("\nCurves of resonances, with the values at their ends\n{table}{more}")
}
