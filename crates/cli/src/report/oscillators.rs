//! The oscillators that the page shows.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use grazing_drawing::SheetWidth;
use grazing_input::AnalysisLimits;
use grazing_report::OscillatorEntry;
use grazing_unfold::progress::Progress;

use crate::examples;
use crate::failure::Failure;
use crate::limits::ended;
use crate::oscillator::OscillatorFile;
use crate::outputs::oscillator::AnalysedOscillator;
use crate::runner::Running;
use crate::unfold::FIGURES;
use crate::unfold::analysis::analyse;
use crate::unfold::page;

/// The examples that the page always shows; others can be named.
const EXAMPLES: [&str; 4] =
    ["clearance.toml", "duffing.toml", "quadratic-damping.toml", "varying-impact.toml"];

impl OscillatorFile {
    /// Some examples of the repository, then the given files.
    ///
    /// # Errors
    /// A file cannot be read, or something in it is wrong.
    pub(crate) fn all(root: Option<&Path>, given: &[PathBuf]) -> Result<Vec<Self>, Failure> {
        let folder = root.map(|root| root.join(examples::EXAMPLES));
        let examples = folder.iter().flat_map(|folder| EXAMPLES.map(|name| folder.join(name)));
        let mut files: Vec<PathBuf> = examples.filter(|file| file.is_file()).collect();
        files.extend_from_slice(given);
        files.iter().map(|file| Self::read(file, &[], AnalysisLimits::USUAL)).collect()
    }

    /// Unfolds the oscillator up to its limits, and returns its entry with the failure if a limit
    /// was reached. An example of the repository is named as such, and linked by way of the link to
    /// the root.
    ///
    /// # Errors
    /// There is nothing to unfold, or a figure cannot be drawn.
    pub(crate) fn entry(
        &self,
        root: Option<&Path>,
        link: Option<&str>,
        running: &Running<'_>,
    ) -> Result<(OscillatorEntry, Option<Failure>), Failure> {
        // Finished curves are not kept: the page takes little time.
        let own = running.another(Some((self.description.limits(), self.taken)));
        let (unfolded, met) = analyse(self, self.prepared(&own.stop()), &own, &|_| ())?;
        drop(own);
        let outcome = "the unfinished parts are named on the page";
        let met = met.map(|met| ended(&self.file, Some(met), outcome));
        let analysed = AnalysedOscillator::new(self.clone(), unfolded);
        let progress: &dyn Progress = &**running.progress();
        let computed = progress.during(FIGURES, 1, || analysed.computed(SheetWidth::Paper))?;
        let mut entry = page::entry(&analysed, &computed);
        if root.is_some_and(|root| self.file.parent() == Some(&root.join(examples::EXAMPLES))) {
            entry.file = format!("{}/{}", examples::EXAMPLES, entry.file);
            entry.link = link.map(|link| format!("{link}{}", entry.file));
        }
        Ok((entry, met))
    }
}

/// Makes identifiers differ from each other: files in different folders can have the same name.
pub(crate) fn distinguish<'a>(identifiers: impl IntoIterator<Item = &'a mut String>) {
    let mut taken = BTreeSet::new();
    for identifier in identifiers {
        let stem = identifier.clone();
        let mut number = 1;
        while !taken.insert(identifier.clone()) {
            number += 1;
            *identifier = format!("{stem}-{number}");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_the_same_name_have_addresses_of_their_own() {
        let mut identifiers = ["a", "b", "a", "a"].map(str::to_owned);
        distinguish(&mut identifiers);
        assert_eq!(identifiers, ["a", "b", "a-2", "a-3"]);
    }
}
