//! `grazing claims`: every statement of the paper with what its check measures.

mod listing;

use std::collections::BTreeSet;
use std::io;

use grazing_claims::audit::{Finding, audit};
use grazing_claims::errata;
use grazing_claims::ledger::{Claim, Ledger};
use grazing_reproduction::Study;
use grazing_reproduction::parameters::Parameters;
use grazing_unfold::progress::Progress;

use crate::arguments::Claims;
use crate::commands::CommandLine;
use crate::compare::published;
use crate::failure::Failure;
use crate::folder::{self, OutputFile};
use crate::progress::Display;
use crate::{project, terminal};

/// The page of errata, from the root of the repository.
const ERRATA: &str = "docs/ERRATA.md";

/// Tests the selected claims and prints the results.
///
/// # Errors
/// Claims do not hold, `ERRATA.md` differs from what the ledger produces, or nothing could be tested.
pub(crate) fn run(arguments: &Claims) -> Result<(), Failure> {
    crate::limits::leave_nothing_behind();
    let ledger = Ledger::of_the_paper();
    let chosen: Vec<&Claim> = ledger.claims.iter().filter(|claim| is_chosen(claim, arguments)).collect();
    if chosen.is_empty() {
        let wanted = arguments.labels.join(" ");
        return Err(Failure::input(format!(
            "no claim matches {wanted}: labels are those of the paper, such as eq:gp or th:*; `{}` lists all",
            CommandLine::own("claims")
        )));
    }
    let parameters = project::parameters(&arguments.parameters)?;
    let findings = findings(&parameters, &chosen, &Display::new())?;
    let failing = findings.iter().filter(|finding| finding.verdict.fails()).count();
    terminal::say_coloured(&listing::table(
        terminal::layout(),
        &findings,
        arguments.explain,
        terminal::is_coloured(),
    ));
    terminal::say(&listing::summary(&findings));
    if failing > 0 {
        return Err(Failure::check(format!("{failing} of {} claims do not hold", findings.len())));
    }
    if chosen.len() == ledger.claims.len() {
        errata_page(&findings, arguments.write_errata)?;
    }
    Ok(())
}

/// The findings of testing the claims.
///
/// # Errors
/// The numbers that the paper prints could not be computed.
pub(crate) fn findings<'a>(
    parameters: &Parameters,
    claims: &[&'a Claim],
    display: &Display,
) -> Result<Vec<Finding<'a>>, Failure> {
    let progress: &dyn Progress = display;
    let numbers = progress.during("published values", 1, || published(&Study::new(parameters)))?;
    let task = "claims";
    let checks: BTreeSet<&str> = claims.iter().filter_map(|claim| claim.check_name()).collect();
    display.begin(task, checks.len() as u64);
    let found = audit(claims, &numbers, || display.step(task));
    display.end(task);
    Ok(found)
}

/// Whether a claim is selected: by its label, in which `*` stands for any characters, by its kind,
/// and by whether it is a misprint.
fn is_chosen(claim: &Claim, arguments: &Claims) -> bool {
    let labels = &arguments.labels;
    (labels.is_empty() || labels.iter().any(|wanted| matches(wanted, &claim.label)))
        && arguments.kind.as_ref().is_none_or(|kind| kind == claim.kind.name())
        && (!arguments.misprints || claim.misprint.is_some())
}

/// Whether a label equals the wanted one, or fits it as a pattern with `*`.
fn matches(wanted: &str, label: &str) -> bool {
    let Some((start, rest)) = wanted.split_once('*') else {
        return wanted == label;
    };
    let ends = |after: &str| after.char_indices().any(|(at, _)| matches(rest, &after[at..]));
    label.strip_prefix(start).is_some_and(|after| ends(after) || matches(rest, ""))
}

/// Writes `ERRATA.md`, or compares the existing one with the ledger.
fn errata_page(findings: &[Finding<'_>], write: bool) -> Result<(), Failure> {
    let root = match project::root() {
        None if !write => return Ok(()),
        None => {
            return Err(Failure::input(
                "--write-errata: the page belongs in a clone of the repository, and this is not one",
            ));
        }
        Some(root) => root,
    };
    let content = errata::page(findings).into_bytes();
    if write {
        let file = OutputFile { path: ERRATA.into(), content };
        folder::write(&root, &[file])?;
        terminal::say(&format!("{} is written.\n", root.join(ERRATA).display()));
        return Ok(());
    }
    let path = root.join(ERRATA);
    match folder::read(&path) {
        Ok(present) if present == content => Ok(()),
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(Failure::file(&path, &error)),
        _ => Err(Failure::check(
            "docs/ERRATA.md differs from the page that the ledger gives: update it with `cargo xtask claims --write-errata`",
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_star_stands_for_anything() {
        for (wanted, label, fits) in [
            ("eq:gp", "eq:gp", true),
            ("eq:g", "eq:gp", false),
            ("eq:*", "eq:gp", true),
            ("*gp", "eq:gp", true),
            ("*", "eq:gp", true),
            ("eq:*p", "eq:gpq", false),
            ("le:*/*", "le:SpTp/a", true),
            ("th:*", "eq:gp", false),
        ] {
            assert_eq!(matches(wanted, label), fits, "{wanted} {label}");
        }
    }
}
