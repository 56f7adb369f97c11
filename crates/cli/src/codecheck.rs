//! The manifest of what this repository reproduces, as CODECHECK wants it
//! (<https://codecheck.org.uk/spec/config/2.0/>).
//!
//! It contains only what is known before a check: the codechecker adds a name, a summary, the time
//! and the certificate.

use askama::Template;
use grazing_reproduction::Study;
use grazing_results::Title;
use grazing_results::title::{TitleSubject, without_ties};

use crate::outputs::edition::Edition;
use crate::outputs::{self, Output};
use crate::template::rendered;

/// The file of the manifest, at the root of the repository.
pub const FILE: &str = "codecheck.yml";
/// The paper that is reproduced.
pub const TITLE: &str = "Resonant grazing bifurcations revisited";
/// The authors of the paper.
pub const AUTHORS: [&str; 2] = ["David J. W. Simpson", "Indranil Ghosh"];
/// The address of the paper.
pub const REFERENCE: &str = "https://arxiv.org/abs/2602.22797";

#[derive(Template)]
#[template(path = "codecheck.yml", escape = "none")]
struct Manifest {
    /// The files, each with a comment.
    files: Vec<(String, String)>,
}

/// The manifest: all figures, and the tables that are not the data of a figure.
pub fn manifest() -> String {
    let listed = |output| files(output).into_iter().map(|file| (file, comment(output.title)));
    rendered(&Manifest { files: outputs::ALL.iter().flat_map(listed).collect() })
}

/// The file of an output's figure, or those of its tables if it has none, by path from the root.
fn files(output: &Output<Study>) -> Vec<String> {
    if output.is_figure {
        return vec![format!("figures/{}", output.figure_file())];
    }
    let paths = output.paths(&Edition::default());
    paths.iter().map(|path| format!("figures/{}", path.display())).collect()
}

/// A title as a comment, which says for a figure of the paper that it is one.
fn comment(title: Title<&str>) -> String {
    match title.place {
        TitleSubject::Figure(number) => {
            format!("Figure {number} of manuscript: {}", without_ties(title.words))
        }
        _ => title.to_string(),
    }
}

/// The text as a scalar of YAML in double quotes.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}
