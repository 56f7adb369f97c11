//! The manifest: the files that were computed, their parameters, and the program.

use sha2::{Digest, Sha256};

use askama::filters::Safe;

use crate::html::{Html, escape};

/// The manifest of a run: the files that were computed, their parameters, and the program.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Manifest {
    /// The program and its version.
    pub program: String,
    /// The version of the compiler.
    pub rust: String,
    /// The libraries and their versions.
    pub libraries: Vec<(String, String)>,
    /// The name of the parameter file.
    pub parameter_file: String,
    /// The content of the parameter file.
    pub parameters: String,
    /// The files that were computed.
    pub outputs: Vec<FileDigest>,
    /// The address of the folder of these files, with a slash at its end; without it they are named
    /// but not linked.
    pub folder: Option<String>,
}

/// A computed file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FileDigest {
    /// The path in the folder of figures, as `data/coefficients.csv`.
    pub path: String,
    /// The size of the file.
    pub bytes: usize,
    /// The SHA-256 of the content, in hexadecimal digits.
    pub sha256: String,
}

impl FileDigest {
    /// The digest of a file with this content.
    pub fn of(path: impl Into<String>, content: &[u8]) -> Self {
        let sha256 = Sha256::digest(content).iter().map(|byte| format!("{byte:02x}")).collect();
        Self { path: path.into(), bytes: content.len(), sha256 }
    }
}

impl Manifest {
    /// A link to a computed file, or its name.
    pub(crate) fn link(&self, path: &str) -> Html {
        Safe(match &self.folder {
            Some(folder) => format!("<a href=\"{}{}\"><code>{1}</code></a>", escape(folder), escape(path)),
            None => format!("<code>{}</code>", escape(path)),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_digest_is_that_of_the_standard() {
        // FIPS 180-2, appendix B.1.
        assert_eq!(
            FileDigest::of("a", b"abc").sha256,
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
        );
    }
}
