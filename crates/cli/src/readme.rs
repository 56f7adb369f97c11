//! The results in README.md, which `reproduce` writes between two marks.

use std::path::{Path, PathBuf};

use grazing_beyond::proofs::BeyondProofs;
use grazing_claims::errata;
use grazing_claims::ledger::{Claim, Test};
use grazing_reproduction::Study;

use crate::claims::LEDGER;
use crate::compare::{computed, published};
use crate::failure::{Failure, computation};
use crate::folder::{self, OutputFile};

/// The file, at the root of the repository.
const FILE: &str = "README.md";
/// The marks around the results.
const MARKS: [&str; 2] = ["<!-- results -->\n", "<!-- /results -->"];

/// README.md with the results of a study; none if there is no such file, or no mark in it.
///
/// # Errors
/// The results cannot be computed.
pub(crate) fn file(root: &Path, study: &Study) -> Result<Option<OutputFile>, Failure> {
    let Ok(text) = folder::read(&root.join(FILE)) else {
        return Ok(None);
    };
    let text = String::from_utf8_lossy(&text);
    let parts =
        text.split_once(MARKS[0]).and_then(|(before, rest)| Some((before, rest.split_once(MARKS[1])?.1)));
    let Some((before, after)) = parts else {
        return Ok(None);
    };
    let [begin, end] = MARKS;
    let content = format!("{before}{begin}{}{end}{after}", results(study)?).into_bytes();
    Ok(Some(OutputFile { path: PathBuf::from(FILE), content }))
}

/// The results in Markdown: published values, claims, and what is proved.
fn results(study: &Study) -> Result<String, Failure> {
    let mut text = "| quantity | printed | computed |\n|---|---|---|\n".to_owned();
    let comparisons = published(study)?;
    for comparison in comparisons.iter().filter(|comparison| !comparison.is_input()) {
        let published = comparison.published;
        let computed = computed(comparison).unwrap_or_default();
        text.push_str(&format!("| {} | {} | {computed} |\n", published.quantity, published.printed));
    }
    let count = |is: fn(&Claim) -> bool| LEDGER.claims.iter().filter(|claim| is(claim)).count();
    text.push_str(&format!(
        "\n**Claims.** The paper makes {} claims: {} are tested by a check, {} by comparison with printed numbers, {} give \
         parameters, and {} cannot be\ntested by a computation. Print and mathematics differ in [{} errata](docs/ERRATA.md), none of which changes what the \
         theorems state.\n",
        LEDGER.claims.len(),
        count(|claim| matches!(claim.test(), Test::Check(_))),
        count(|claim| matches!(claim.test(), Test::Published(_))),
        count(|claim| matches!(claim.test(), Test::Given(_))),
        count(|claim| matches!(claim.test(), Test::Unchecked(_))),
        errata::count(&LEDGER.claims),
    ));
    let shown = study.shown::<BeyondProofs>().map_err(|error| computation("beyond_proofs", &error))?;
    let [curves, points, regions] = ["curve", "point", "region"]
        .map(|object| shown.items.iter().filter(|item| item.object == object).count());
    text.push_str(&format!(
        "\n**Proved**, in integer arithmetic that a second program checks: the {curves} curves, {points} points and {regions} regions of \
         Figure 7,\nexcept in [tubes and boxes](docs/proof.md) too narrow to be seen.\n"
    ));
    Ok(text)
}
