//! The manifest of what this repository reproduces, as CODECHECK wants it
//! (<https://codecheck.org.uk>, version 1.0).
//!
//! Only what is known before anybody has checked: who checks adds their name, a summary, the time
//! and the certificate.

use std::fmt::Write;

use crate::outputs::edition::Edition;
use grazing_reproduction::Study;

use crate::outputs::{self, Output};

/// The manifest's file, at the root of the repository.
pub const FILE: &str = "codecheck.yml";
/// The paper that is reproduced.
pub const TITLE: &str = "Resonant grazing bifurcations revisited";
/// Its authors.
pub const AUTHORS: [&str; 2] = ["David J. W. Simpson", "Indranil Ghosh"];
/// Where it is found.
pub const REFERENCE: &str = "https://arxiv.org/abs/2602.22797";

/// The manifest: all figures, and the tables that are none's data.
pub fn manifest() -> String {
    let mut text = format!(
        "---\n# Made by `cargo xtask reproduce` from its registry of outputs. Whoever checks adds codechecker, summary, repository,\n\
         # check_time, certificate and report.\nversion: https://codecheck.org.uk/spec/config/1.0\n\npaper:\n  title: {}\n  \
         authors:\n",
        quoted(TITLE)
    );
    // Writing to a string cannot fail.
    for author in AUTHORS {
        let _ = writeln!(text, "    - name: {}", quoted(author));
    }
    let _ = write!(text, "  reference: {REFERENCE}\n\nmanifest:\n");
    for output in outputs::ALL {
        for file in files(output) {
            let _ = writeln!(text, "  - file: {file}\n    comment: {}", quoted(&comment(output.title)));
        }
    }
    text
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
