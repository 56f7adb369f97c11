//! `grazing claims`: every statement of the paper with what its check measures.

mod listing;

use std::collections::{BTreeMap, BTreeSet};
use std::{fs, io};

use grazing_claims::audit::{Finding, PrintedNumber, audit};
use grazing_claims::errata;
use grazing_claims::ledger::{Claim, Ledger};
use grazing_reproduction::Study;
use grazing_reproduction::parameters::Parameters;
use grazing_reproduction::published::{Published, Verdict as Met};
use grazing_unfold::progress::Progress;

use crate::arguments::Claims;
use crate::failure::Failure;
use crate::folder::{self, MadeFile};
use crate::outputs::computation;
use crate::progress::Display;
use crate::{project, terminal};

/// The page of misprints, from the root of the repository.
const ERRATA: &str = "ERRATA.md";

/// Tests the claims that were asked for and prints what came of it.
///
/// # Errors
/// [`Failure::ClaimsFail`]; [`Failure::ErrataStale`] if `ERRATA.md` is not what the ledger makes; any other [`Failure`].
pub(crate) fn run(arguments: &Claims) -> Result<(), Failure> {
    let ledger = Ledger::of_the_paper();
    let chosen: Vec<&Claim> = ledger.claims.iter().filter(|claim| is_chosen(claim, arguments)).collect();
    if chosen.is_empty() {
        return Err(Failure::NoClaim { wanted: arguments.labels.join(" ") });
    }
    let parameters = project::parameters(&arguments.parameters)?;
    let findings = findings(&parameters, &chosen, &Display::new())?;
    let failing = findings.iter().filter(|finding| finding.verdict.fails()).count();
    terminal::say_coloured(&listing::table(&findings, arguments.explain, terminal::is_coloured()));
    terminal::say(&listing::summary(&findings));
    if failing > 0 {
        return Err(Failure::ClaimsFail { failing, all: findings.len() });
    }
    if chosen.len() == ledger.claims.len() {
        misprints(&findings, arguments.write_errata)?;
    }
    Ok(())
}

/// What comes of testing the claims.
///
/// # Errors
/// [`Failure::Computation`] if the numbers that the paper prints could not be computed.
pub(crate) fn findings<'a>(
    parameters: &Parameters,
    claims: &[&'a Claim],
    display: &Display,
) -> Result<Vec<Finding<'a>>, Failure> {
    let numbers = printed_numbers(parameters)?;
    let task = "claims";
    let checks: BTreeSet<&str> = claims.iter().filter_map(|claim| claim.check_name()).collect();
    display.begin(task, checks.len() as u64);
    let found = audit(claims, |id| numbers.get(id).cloned(), || display.step(task));
    display.end(task);
    Ok(found)
}

fn printed_numbers(parameters: &Parameters) -> Result<BTreeMap<String, PrintedNumber>, Failure> {
    let published = Published::printed()?;
    let computed =
        Study::new(parameters).published_values().map_err(|error| computation("published values", &error))?;
    let number = |comparison: grazing_reproduction::published::Comparison<'_>| {
        let (computed, met) = match comparison.verdict {
            Met::Met { computed, .. } => (Some(computed), true),
            Met::Off { computed, .. } => (Some(computed), false),
            Met::NotComputed => (None, false),
        };
        let value = comparison.published;
        let (id, quantity, printed) = (value.id(), value.quantity(), value.printed());
        let [id, quantity, printed] = [id, quantity, printed].map(str::to_owned);
        (id.clone(), PrintedNumber { id, quantity, printed, computed, met })
    };
    Ok(published.compare(&computed).into_iter().map(number).collect())
}

/// Whether a claim was asked for: by a label, where `*` stands for anything, or a part of one; and by kind.
fn is_chosen(claim: &Claim, arguments: &Claims) -> bool {
    let labels = &arguments.labels;
    (labels.is_empty() || labels.iter().any(|wanted| matches(wanted, &claim.label)))
        && arguments.kind.as_ref().is_none_or(|kind| kind == claim.kind.name())
        && (!arguments.misprints || claim.misprint.is_some())
}

/// Whether a label is what was wanted: the same, or fitting a pattern with `*`.
fn matches(wanted: &str, label: &str) -> bool {
    let mut parts = wanted.split('*');
    let first = parts.next().unwrap_or_default();
    let Some(mut rest) = label.strip_prefix(first) else {
        return false;
    };
    let mut last = None;
    for part in parts {
        let Some(at) = rest.find(part) else {
            return false;
        };
        rest = &rest[at + part.len()..];
        last = Some(part);
    }
    match last {
        None => rest.is_empty(),
        Some(end) => rest.is_empty() || label.ends_with(end),
    }
}

/// Writes `ERRATA.md`, or holds the one that is there against the ledger.
fn misprints(findings: &[Finding<'_>], write: bool) -> Result<(), Failure> {
    let Some(root) = project::root() else {
        return if write { Err(Failure::NoProject) } else { Ok(()) };
    };
    let content = errata::page(findings).into_bytes();
    if write {
        let file = MadeFile { path: ERRATA.into(), content };
        folder::write(&root, &[file])?;
        terminal::say(&format!("{} is written.\n", root.join(ERRATA).display()));
        return Ok(());
    }
    let path = root.join(ERRATA);
    match fs::read(&path) {
        Ok(present) if present == content => Ok(()),
        Ok(_) => Err(Failure::ErrataStale),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Err(Failure::ErrataStale),
        Err(reason) => Err(Failure::File { path, reason }),
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
