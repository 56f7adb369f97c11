//! `grazing compare`: computed values beside the published ones, and curves of another program beside
//! those of an oscillator.

use std::path::Path;

use grazing_claims::published::{Published, PublishedComparison, Rounding, Tally};
use grazing_input::AnalysisLimits;
use grazing_measured::read::{self, Foreign};
use grazing_measured::{Apart, apart};
use grazing_reproduction::Study;

use crate::arguments::CompareArguments;
use crate::failure::{Failure, computation};
use crate::layout::Layout;
use crate::limits::ended;
use crate::oscillator::{OscillatorFile, parameter_names};
use crate::runner::{CommandOutcome, Plan, Running};
use crate::unfold::analysis::analyse;
use crate::{project, terminal};

/// How many digits more than the print has are shown of a computed value.
const DIGITS_BEYOND_PRINT: usize = 4;

/// Reads what is to be compared: another program's curves with those of an oscillator, or the values that the paper prints
/// with the computed ones.
///
/// # Errors
/// Bad input.
pub(crate) fn read(arguments: &CompareArguments) -> Result<Plan<'_>, Failure> {
    let (Some(curves), Some(oscillator)) = (&arguments.curves, &arguments.oscillator) else {
        arguments.named.of(None)?;
        let parameters = project::parameters(&arguments.parameters)?;
        return Ok(Plan::new(move |_| published(&Study::new(&parameters)), said));
    };
    let CompareArguments { named, curve, within, parameters, .. } = arguments;
    let of = OscillatorFile::read(oscillator, &parameters.set, AnalysisLimits::USUAL)?;
    let foreign = Foreign { columns: named.of(Some(curves))?.to_vec(), curve: *curve };
    let points = read::curves(curves, parameter_names(&of.description), &foreign)?;
    let limits = (of.description.limits(), of.taken);
    let compute = move |running: &Running<'_>| {
        let (unfolded, met) = analyse(&of, of.prepared(&running.stop()), running, &|_| ())?;
        match met {
            Some(_) => Err(ended(oscillator, met, "nothing was compared")),
            None => Ok(apart(&points, &unfolded.axes, unfolded.known(), *within)),
        }
    };
    let say = move |kinds: Vec<Apart>, _: &Path| {
        let total = |count: fn(&Apart) -> u32| kinds.iter().map(count).sum::<u32>();
        let (curves, all, far) = (curves.display(), total(|kind| kind.points), total(|kind| kind.far));
        let mut text = distances(terminal::layout(), &kinds);
        let failure = match (all, far) {
            (0, _) => Some(Failure::input(format!(
                "{curves}: no point of a bifurcation curve lies within the ranges of {}",
                oscillator.display()
            ))),
            (_, 0) => {
                let near =
                    format!("All {all} points lie within {within:e} of the ranges of a curve of their kind.");
                text.push_str(&format!("\n{near}\n"));
                None
            }
            _ => Some(Failure::check(format!(
                "{curves}: {far} of {all} points lie farther than {within:e} of the ranges from every admissible part of a curve of their kind"
            ))),
        };
        Ok(CommandOutcome { text, failure, ..CommandOutcome::default() })
    };
    Ok(Plan::new(compute, say).within(oscillator, limits))
}

/// The comparison with the published values, and whether they are met.
fn said(comparisons: Vec<PublishedComparison<'_>>, _: &Path) -> Result<CommandOutcome, Failure> {
    let coloured = table(terminal::layout(), &comparisons, terminal::is_coloured());
    let tally = Tally::of(&comparisons);
    let (text, failure) = match tally.is_complete() {
        true => (format!("\n{tally}.\n"), None),
        false => (String::new(), Some(Failure::check(tally.to_string()))),
    };
    Ok(CommandOutcome { coloured, text, failure, ..CommandOutcome::default() })
}

/// How far points are from the curves of their kinds, as a table.
fn distances(layout: Layout, kinds: &[Apart]) -> String {
    let row = |Apart { curve, points, outside, far, farthest: (distance, line) }: &Apart| {
        let farthest = match distance {
            0.0 => String::new(),
            distance if distance.is_infinite() => "no such curve".to_owned(),
            distance => format!("{distance:.1e}"),
        };
        [curve.words(), points.to_string(), outside.to_string(), far.to_string(), farthest, line.to_string()]
            .into()
    };
    layout.aligned(&["curve", "points", "outside", "too far", "farthest", "line"], kinds.iter().map(row))
}

/// The values that the paper prints, each with the one that the study computes.
pub(crate) fn published(study: &Study) -> Result<Vec<PublishedComparison<'static>>, Failure> {
    let computed = study.published_values().map_err(|error| computation("published values", &error))?;
    Ok(Published::printed().compare(&computed))
}

/// The comparisons as a table with aligned columns.
pub fn table(layout: Layout, comparisons: &[PublishedComparison<'_>], coloured: bool) -> String {
    let header = ["<quantity", "printed", "computed", "difference", "<verdict", "<where"];
    layout.aligned(&header, comparisons.iter().map(|comparison| cells(comparison, coloured).into()))
}

/// A computed value in a few digits more than the print has.
pub(crate) fn computed(comparison: &PublishedComparison<'_>) -> Option<String> {
    let decimals = comparison.published.decimals() + DIGITS_BEYOND_PRINT;
    comparison.computed.map(|computed| match comparison.published.rounding {
        Rounding::Exact => format!("{computed}"),
        Rounding::Significant => format!("{computed:.decimals$}"),
    })
}

/// The cells of a row: quantity, printed and computed value, difference, verdict and place.
fn cells(comparison: &PublishedComparison<'_>, coloured: bool) -> [String; 6] {
    let published = comparison.published;
    let difference = comparison
        .difference()
        .map(|difference| if difference == 0.0 { "0".to_owned() } else { format!("{difference:.1e}") });
    let verdict = match comparison.computed {
        Some(_) if comparison.is_met() => "met",
        Some(_) => "OFF",
        None => "NOT COMPUTED",
    };
    let colour = if comparison.is_met() { "32" } else { "1;31" };
    let verdict = if coloured { format!("\x1b[{colour}m{verdict}\x1b[0m") } else { verdict.to_owned() };
    [
        published.quantity.clone(),
        published.printed.clone(),
        computed(comparison).unwrap_or_default(),
        difference.unwrap_or_default(),
        verdict,
        format!("{} ({})", published.place, published.label),
    ]
}
