//! The entry of an oscillator on a page, and the page about it.

use std::path::PathBuf;

use grazing_input::Description;
use grazing_report::{FileDigest, Manifest, OscillatorEntry, Report};
use grazing_unfold::Diagram;
use grazing_unfold::plane::counts;
use grazing_unfold::regions::Region;
use grazing_unfold::unfolded::Unfolded;

use super::reason;
use crate::folder::{self, OutputFile};
use crate::oscillator::{OscillatorFile, file_name, noted};
use crate::outputs::ComputedOutput;
use crate::outputs::oscillator::AnalysedOscillator;
use crate::versions;

/// The tables that are shown as tables.
const SHOWN: [&str; 5] = ["agreement", "measured", "coefficients", "hypotheses", "points"];
/// The name of the page about an oscillator, in the folder of its results.
pub(crate) const PAGE: &str = "report.html";

/// The entry of the oscillator on a page.
pub(crate) fn entry(analysed: &AnalysedOscillator, computed: &ComputedOutput) -> OscillatorEntry {
    let AnalysedOscillator { oscillator: OscillatorFile { file, text, description, .. }, unfolded, .. } =
        analysed;
    OscillatorEntry {
        id: file.file_stem().unwrap_or_default().to_string_lossy().into_owned(),
        file: file_name(file),
        link: None,
        about: leading_comment(text),
        description: description.clone(),
        figures: computed.entries().collect(),
        tables: SHOWN.iter().filter_map(|name| computed.table(name).cloned()).collect(),
        resonances: unfolded.from_each_wall().flat_map(|seen| seen.resonances.clone()).collect(),
        lost: lost(description, unfolded),
        undecided: undecided(description, unfolded),
    }
}

/// The page about this oscillator alone, for the folder of its other files.
pub(super) fn page(
    analysed: &AnalysedOscillator,
    computed: &ComputedOutput,
    files: &[OutputFile],
) -> OutputFile {
    let digest = |file: &OutputFile| FileDigest::of(folder::with_slashes(&file.path), &file.content);
    let entry = entry(analysed, computed);
    let report = Report {
        manifest: Manifest {
            parameter_file: entry.file.clone(),
            parameters: noted(&analysed.oscillator.text, &analysed.oscillator.settings),
            outputs: files.iter().map(digest).collect(),
            ..versions::manifest()
        },
        oscillators: vec![entry],
        ..Report::default()
    };
    OutputFile { path: PathBuf::from(PAGE), content: grazing_report::page(&report).into_bytes() }
}

/// The paragraphs of the comment with which a file begins.
fn leading_comment(text: &str) -> Vec<String> {
    let comment = text.lines().map_while(|line| line.trim_start().strip_prefix('#')).map(str::trim);
    let mut paragraphs = vec![String::new()];
    for line in comment {
        match paragraphs.last_mut() {
            Some(last) if !line.is_empty() => {
                if !last.is_empty() {
                    last.push(' ');
                }
                last.push_str(line);
            }
            _ => paragraphs.push(String::new()),
        }
    }
    paragraphs.retain(|paragraph| !paragraph.is_empty());
    paragraphs
}

/// Resonances that could not be located or unfolded, and work that was not finished, in words.
pub(crate) fn lost(description: &Description, unfolded: &Unfolded) -> Vec<String> {
    let units = &unfolded.axes.units;
    let of = |seen: &Unfolded| {
        let diagram = &seen.diagram;
        let wall = at_wall(diagram.wall);
        let lost =
            reason::lost(description, units, diagram).map(|(what, why)| format!("{wall}{what}: {why}"));
        let cut = diagram.unfinished.iter();
        let cut =
            cut.map(|cut| format!("{wall}not finished: {}", reason::unfinished(description, units, cut)));
        lost.chain(cut).collect::<Vec<_>>()
    };
    unfolded.from_each_wall().flat_map(of).collect()
}

/// The second of two walls, before words about what it sees.
fn at_wall(wall: u32) -> String {
    if wall < 2 { String::new() } else { format!("wall {wall}: ") }
}

/// Regions in which the stability of solutions is undecided, with their loops.
fn undecided(description: &Description, unfolded: &Unfolded) -> Vec<(u32, String)> {
    let units = &unfolded.axes.units;
    let words = |region: &Region| reason::undecided(description, units, region);
    let seen = unfolded.from_each_wall().flat_map(|seen| {
        let Diagram { wall, regions, .. } = &seen.diagram;
        let own = regions.iter().filter(|region| counts(region.loops, *wall));
        own.filter_map(|region| Some((region.loops, format!("{}{}", at_wall(*wall), words(region)?))))
    });
    let both = unfolded.sequences.solutions.iter().filter(|found| found.stops.len() > 1);
    let both = both.flat_map(|found| &found.regions);
    let both = both.filter_map(|region| Some((region.loops, format!("both walls: {}", words(region)?))));
    seen.chain(both).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_leading_comment_is_put_together_by_paragraphs() {
        let text = "# A block on a spring\n#   beside a wall.\n#\n# Values are ours.\n\nname = \"o\" # not this\n# nor this\n";
        assert_eq!(leading_comment(text), ["A block on a spring beside a wall.", "Values are ours."]);
        assert_eq!(leading_comment("name = \"o\"\n# later\n"), [""; 0]);
    }
}
