//! `grazing claims`: every statement of the paper with what its check measures.

mod listing;

use std::collections::BTreeSet;
use std::io;
use std::path::Path;
use std::sync::LazyLock;

use grazing_claims::audit::{Finding, audit};
use grazing_claims::errata;
use grazing_claims::ledger::{Claim, Ledger};
use grazing_reproduction::Study;
use grazing_reproduction::parameters::Parameters;
use grazing_unfold::progress::Progress;

use crate::arguments::ClaimsArguments;
use crate::commands::CommandLine;
use crate::compare::published;
use crate::failure::Failure;
use crate::folder::{self, Batch, OutputFile};
use crate::runner::{CommandOutcome, Plan, Running};
use crate::{project, terminal};

/// The page of errata, from the root of the repository.
const ERRATA: &str = "docs/ERRATA.md";

/// What the paper states.
pub(crate) static LEDGER: LazyLock<Ledger> = LazyLock::new(Ledger::of_the_paper);

/// Reads which claims are to be tested.
///
/// # Errors
/// Bad input.
pub(crate) fn read(arguments: &ClaimsArguments) -> Result<Plan<'_>, Failure> {
    let chosen: Vec<&Claim> = LEDGER.claims.iter().filter(|claim| is_chosen(claim, arguments)).collect();
    if chosen.is_empty() {
        let wanted = arguments.labels.join(" ");
        return Err(Failure::input(format!(
            "no claim matches {wanted}: labels are those of the paper, such as eq:gp or th:*; `{}` lists all",
            CommandLine::own("claims")
        )));
    }
    let parameters = project::parameters(&arguments.parameters)?;
    let compute = move |running: &Running<'_>| findings(&parameters, &chosen, &**running.progress());
    let say = |findings: Vec<Finding<'_>>, _: &Path| {
        let failing = findings.iter().filter(|finding| finding.verdict.fails()).count();
        let (batches, failure) = match failing {
            0 if findings.len() == LEDGER.claims.len() => errata_page(&findings, arguments.write_errata),
            0 => Default::default(),
            _ => {
                let all = findings.len();
                (Vec::new(), Some(Failure::check(format!("{failing} of {all} claims do not hold"))))
            }
        };
        let (explain, coloured) = (arguments.explain, terminal::is_coloured());
        let coloured = listing::table(terminal::layout(), &findings, explain, coloured);
        Ok(CommandOutcome {
            coloured,
            text: listing::summary(&findings),
            batches,
            failure,
            ..CommandOutcome::default()
        })
    };
    Ok(Plan::new(compute, say))
}

/// The findings of testing the claims.
///
/// # Errors
/// The numbers that the paper prints could not be computed.
pub(crate) fn findings<'a>(
    parameters: &Parameters,
    claims: &[&'a Claim],
    progress: &dyn Progress,
) -> Result<Vec<Finding<'a>>, Failure> {
    let numbers = progress.during("published values", 1, || published(&Study::new(parameters)))?;
    let task = "claims";
    let checks: BTreeSet<&str> = claims.iter().filter_map(|claim| claim.check_name()).collect();
    progress.begin(task, checks.len() as u64);
    let found = audit(claims, &numbers, || progress.step(task));
    progress.end(task);
    Ok(found)
}

/// Whether a claim is selected: by its label, in which `*` stands for any characters, by its kind,
/// and by whether it is a misprint.
fn is_chosen(claim: &Claim, arguments: &ClaimsArguments) -> bool {
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

/// `ERRATA.md`, or the failure if the existing one differs from the ledger.
fn errata_page(findings: &[Finding<'_>], write: bool) -> (Vec<Batch>, Option<Failure>) {
    let Some(root) = project::root() else {
        let absent = "--write-errata: the page belongs in a clone of the repository, and this is not one";
        return (Vec::new(), write.then(|| Failure::input(absent)));
    };
    let page = OutputFile { path: ERRATA.into(), content: errata::page(findings).into_bytes() };
    if write {
        return (vec![Batch::unlisted(&root, vec![page])], None);
    }
    let path = root.join(ERRATA);
    let failure = match folder::read(&path) {
        Ok(present) if present == page.content => None,
        Err(error) if error.kind() != io::ErrorKind::NotFound => Some(Failure::file(&path, &error)),
        _ => {
            let update = CommandLine::own("claims").with("--write-errata");
            Some(Failure::check(format!(
                "{ERRATA} differs from the page that the ledger gives: update it with `{update}`"
            )))
        }
    };
    (Vec::new(), failure)
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
