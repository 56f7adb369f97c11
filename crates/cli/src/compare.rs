//! `grazing compare`: computed values beside the published ones, and curves of another program beside
//! those of an oscillator.

use std::path::Path;

use grazing_claims::published::{Comparison, Published, Rounding, Tally};
use grazing_description::Limits;
use grazing_measured::read::{self, Foreign};
use grazing_measured::{Apart, apart};
use grazing_reproduction::Study;

use crate::arguments::{Compare, ParameterFile};
use crate::failure::{Failure, computation};
use crate::layout::Layout;
use crate::limits::{Watch, ended};
use crate::oscillator::{OscillatorFile, parameter_names, settings};
use crate::unfold::analysis::analyse;
use crate::{limits, project, terminal};

/// How many digits more than the print has are shown of a computed value.
const DIGITS_BEYOND_PRINT: usize = 4;

/// Prints the comparison.
///
/// # Errors
/// A value is not met, a curve lies elsewhere, or there is nothing to compare.
pub(crate) fn run(arguments: &Compare) -> Result<(), Failure> {
    match (&arguments.curves, &arguments.oscillator) {
        (Some(curves), Some(oscillator)) => foreign(curves, oscillator, arguments),
        _ => {
            arguments.named.of(None)?;
            print(&arguments.parameters)
        }
    }
}

/// Prints how far the points of another program's curves are from those of an oscillator.
fn foreign(curves: &Path, oscillator: &Path, arguments: &Compare) -> Result<(), Failure> {
    let of = OscillatorFile::read(oscillator, &settings(&arguments.parameters.set), Limits::USUAL)?;
    let Compare { named, curve, within, .. } = arguments;
    let foreign = Foreign { columns: named.of(Some(curves))?.to_vec(), curve: *curve };
    let points = read::curves(curves, parameter_names(&of.description), &foreign);
    let points = points.map_err(|error| Failure::input(error.to_string()))?;
    arguments.threads.start()?;
    limits::listen();
    let (unfolded, met) = analyse(&of, Watch::begin(of.description.limits(), of.taken), &|_| ())?;
    if met.is_some() {
        return Err(ended(oscillator, met, "nothing was compared"));
    }
    let kinds = apart(&points, &unfolded.axes, &unfolded.diagram, *within);
    let row = |Apart { curve, points, outside, far, farthest: (distance, line) }: &Apart| {
        let farthest = match distance {
            0.0 => String::new(),
            distance if distance.is_infinite() => "no such curve".to_owned(),
            distance => format!("{distance:.1e}"),
        };
        [curve.words(), points.to_string(), outside.to_string(), far.to_string(), farthest, line.to_string()]
            .into()
    };
    let heads = ["curve", "points", "outside", "too far", "farthest", "line"];
    terminal::say(&terminal::layout().aligned(&heads, kinds.iter().map(row)));
    let total = |count: fn(&Apart) -> u32| kinds.iter().map(count).sum::<u32>();
    let (all, far) = (total(|kind| kind.points), total(|kind| kind.far));
    match (all, far) {
        (0, _) => Err(Failure::input(format!(
            "{}: no point of a bifurcation curve lies within the ranges of {}",
            curves.display(),
            oscillator.display()
        ))),
        (_, 0) => {
            terminal::say(&format!(
                "\nAll {all} points lie within {within:e} of the ranges of a curve of their kind.\n"
            ));
            Ok(())
        }
        _ => Err(Failure::check(format!(
            "{}: {far} of {all} points lie farther than {within:e} of the ranges from every admissible part of a curve of their kind",
            curves.display()
        ))),
    }
}

/// Prints the values that the paper prints beside the computed ones.
fn print(file: &ParameterFile) -> Result<(), Failure> {
    crate::limits::leave_nothing_behind();
    let parameters = project::parameters(file)?;
    let comparisons = published(&Study::new(&parameters))?;
    terminal::say_coloured(&table(terminal::layout(), &comparisons, terminal::is_coloured()));
    let tally = Tally::of(&comparisons);
    if !tally.is_complete() {
        return Err(Failure::check(tally.to_string()));
    }
    terminal::say(&format!("\n{tally}.\n"));
    Ok(())
}

/// The values that the paper prints, each with the one that the study computes.
pub(crate) fn published(study: &Study) -> Result<Vec<Comparison<'static>>, Failure> {
    let computed = study.published_values().map_err(|error| computation("published values", &error))?;
    Ok(Published::printed().compare(&computed))
}

/// The comparisons as a table with aligned columns.
pub fn table(layout: Layout, comparisons: &[Comparison<'_>], coloured: bool) -> String {
    let header = ["<quantity", "printed", "computed", "difference", "<verdict", "<where"];
    layout.aligned(&header, comparisons.iter().map(|comparison| cells(comparison, coloured).into()))
}

/// A computed value in a few digits more than the print has.
pub(crate) fn computed(comparison: &Comparison<'_>) -> Option<String> {
    let decimals = comparison.published.decimals() + DIGITS_BEYOND_PRINT;
    comparison.computed.map(|computed| match comparison.published.rounding {
        Rounding::Exact => format!("{computed}"),
        Rounding::Significant => format!("{computed:.decimals$}"),
    })
}

/// The cells of a row: quantity, printed and computed value, difference, verdict and place.
fn cells(comparison: &Comparison<'_>, coloured: bool) -> [String; 6] {
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
