//! The manifest of what this repository reproduces, as CODECHECK wants it
//! (<https://codecheck.org.uk/spec/config/2.0/>).
//!
//! Only what is known before anybody has checked: who checks adds their name, a summary, the time
//! and the certificate.

use askama::Template;
use grazing_reproduction::Study;

use crate::outputs::edition::Edition;
use crate::outputs::{self, Output};
use crate::template::rendered;

/// The manifest's file, at the root of the repository.
pub const FILE: &str = "codecheck.yml";
/// The paper that is reproduced.
pub const TITLE: &str = "Resonant grazing bifurcations revisited";
/// Its authors.
pub const AUTHORS: [&str; 2] = ["David J. W. Simpson", "Indranil Ghosh"];
/// Where it is found.
pub const REFERENCE: &str = "https://arxiv.org/abs/2602.22797";

#[derive(Template)]
#[template(path = "codecheck.yml", escape = "none")]
struct Manifest {
    /// Each with what it is.
    files: Vec<(String, String)>,
}

/// The manifest: all figures, and the tables that are none's data.
pub fn manifest() -> String {
    let listed = |output| files(output).into_iter().map(|file| (file, comment(output.title)));
    rendered(&Manifest { files: outputs::ALL.iter().flat_map(listed).collect() })
}

/// The figure, or the tables if there is none, by path from the root.
fn files(output: &Output<Study>) -> Vec<String> {
    if output.is_figure {
        return vec![format!("figures/{}", output.figure_file())];
    }
    let paths = output.paths(&Edition::default());
    paths.iter().map(|path| format!("figures/{}", path.display())).collect()
}

/// A title as a comment: `Figure 2: …` is Figure 2 of the manuscript.
fn comment(title: &str) -> String {
    match title.split_once(": ") {
        Some((figure, about)) if figure.starts_with("Figure ") => {
            format!("{figure} of manuscript: {about}")
        }
        _ => title.to_owned(),
    }
}

/// The text as a scalar of YAML in double quotes.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}
