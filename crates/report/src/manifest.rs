//! What was made, from what, and by what.

use sha2::{Digest, Sha256};

use crate::Report;
use crate::html::{counted, escape, put};

/// What was made, from what, and by what.
#[derive(Debug, Clone, PartialEq)]
pub struct Manifest {
    /// The program and its version.
    pub program: String,
    /// The version of the compiler.
    pub rust: String,
    /// The libraries and their versions.
    pub libraries: Vec<(String, String)>,
    /// The name of the parameter file.
    pub parameter_file: String,
    /// What stands in it.
    pub parameters: String,
    /// The files that were computed.
    pub outputs: Vec<OutputFile>,
    /// The path from the page's folder to the one where these files are, with a slash at its end; without it they are
    /// named but not linked.
    pub folder: Option<String>,
}

/// A computed file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OutputFile {
    /// Its path in the folder of figures, as `data/coefficients.csv`.
    pub path: String,
    /// Its size.
    pub bytes: usize,
    /// Its SHA-256, in hexadecimal digits.
    pub sha256: String,
}

impl OutputFile {
    /// The file with this content.
    pub fn of(path: impl Into<String>, content: &[u8]) -> Self {
        let mut sha256 = String::with_capacity(64);
        for byte in Sha256::digest(content) {
            put!(sha256, "{byte:02x}");
        }
        Self { path: path.into(), bytes: content.len(), sha256 }
    }
}

impl Manifest {
    /// A link to a computed file, or its name.
    pub(crate) fn link(&self, path: &str) -> String {
        match &self.folder {
            Some(folder) => format!("<a href=\"{}{}\"><code>{1}</code></a>", escape(folder), escape(path)),
            None => format!("<code>{}</code>", escape(path)),
        }
    }
}

pub(crate) fn section(report: &Report) -> String {
    let manifest = &report.manifest;
    let mut html = format!(
        "<section id=\"manifest\" aria-labelledby=\"manifest-title\">\n<h2 id=\"manifest-title\">Manifest</h2>\n\
         <p class=\"lead\">Made by {} with Rust {}. Equal parameters give equal bytes, on any number of threads.</p>\n\
         <h3>Outputs</h3>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Outputs\">\n\
         <table class=\"sortable\" id=\"outputs\"><thead><tr><th scope=\"col\">File</th><th scope=\"col\" class=\"number\">Bytes</th>\
         <th scope=\"col\">SHA-256</th></tr></thead>\n<tbody>\n",
        escape(&manifest.program),
        escape(&manifest.rust),
    );
    for file in &manifest.outputs {
        put!(
            html,
            "<tr><td>{}</td><td class=\"number\">{}</td><td><code class=\"hash\">{}</code></td></tr>\n",
            manifest.link(&file.path),
            file.bytes,
            file.sha256
        );
    }
    put!(
        html,
        "</tbody></table>\n</div>\n<details><summary>Parameters <code>{}</code></summary>\n<pre tabindex=\"0\">{}</pre></details>\n\
         <details><summary>{}</summary>\n<ul class=\"libraries\">\n",
        escape(&manifest.parameter_file),
        escape(&manifest.parameters),
        counted(manifest.libraries.len(), "library", "libraries"),
    );
    for (name, version) in &manifest.libraries {
        put!(html, "<li><code>{}</code> {}</li>\n", escape(name), escape(version));
    }
    html.push_str("</ul></details>\n</section>\n");
    html
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_digest_is_that_of_the_standard() {
        // FIPS 180-2, appendix B.1.
        assert_eq!(
            OutputFile::of("a", b"abc").sha256,
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
        );
    }
}
