//! The figures of the paper, and those beyond it. A new figure needs a module and a line in the list; the
//! sections of the parameter file and the outputs of the program follow from that.

pub mod beyond_atlas;
pub mod beyond_attractors;
pub mod beyond_branches;
pub mod beyond_cascade;
pub mod beyond_generations;
pub mod beyond_loops;
pub mod beyond_proofs;
pub mod beyond_regions;
pub mod fig01;
pub mod fig02;
pub mod fig03;
pub mod fig04;
pub mod fig05;
pub mod fig06;
pub mod fig07;
pub mod fig08;
pub mod fig09;
pub mod fig10;

use std::path::Path;
use std::sync::LazyLock;

use grazing_input::{Requirements, Setting, Text, read_file};

use crate::parameters::{ParameterError, Parameters, declaration, requirements};

/// The list of all figures: an array of the results of a generic function for each figure, in order;
/// other elements may precede and follow them.
#[macro_export]
macro_rules! paper_figures {
    ($make:ident $(, first $first:expr)? $(, last $($last:expr),+)?) => {
        [
            $($first,)?
            $make::<$crate::figures::fig01::Figure1>(),
            $make::<$crate::figures::fig02::Figure2>(),
            $make::<$crate::figures::fig03::Figure3>(),
            $make::<$crate::figures::fig04::Figure4>(),
            $make::<$crate::figures::fig05::Figure5>(),
            $make::<$crate::figures::fig06::Figure6>(),
            $make::<$crate::figures::fig07::Figure7>(),
            $make::<$crate::figures::fig08::Figure8>(),
            $make::<$crate::figures::fig09::Figure9>(),
            $make::<$crate::figures::fig10::Figure10>(),
            $make::<$crate::figures::beyond_cascade::BeyondCascade>(),
            $make::<$crate::figures::beyond_atlas::BeyondAtlas>(),
            $make::<$crate::figures::beyond_loops::BeyondLoops>(),
            $make::<$crate::figures::beyond_regions::BeyondRegions>(),
            $make::<$crate::figures::beyond_attractors::BeyondAttractors>(),
            $make::<$crate::figures::beyond_proofs::BeyondProofs>(),
            $make::<$crate::figures::beyond_generations::BeyondGenerations>(),
            $make::<$crate::figures::beyond_branches::BeyondBranches>(),
            $($($last,)+)?
        ]
    };
}

/// The requirements on the keys of a parameter file.
static REQUIREMENTS: LazyLock<Requirements> = LazyLock::new(|| requirements(paper_figures!(declaration)));

impl Parameters {
    /// The keys that a parameter file can have, with their meanings and requirements.
    pub fn requirements() -> &'static Requirements {
        &REQUIREMENTS
    }

    /// Reads a parameter file, with settings that replace values in it; its path appears in messages as
    /// given here.
    ///
    /// # Errors
    /// As [`parse`](Self::parse), or the file cannot be read.
    pub fn from_file(path: &Path, settings: &[Setting]) -> Result<Self, ParameterError> {
        let text = read_file(path)?;
        Self::parse(&Text::new(&text, settings), &path.display().to_string())
    }

    /// The parameters in the text of a file; `file` is its name in messages.
    ///
    /// # Errors
    /// [`ParameterError`] if the text is not valid TOML or has unknown sections, and for settings of
    /// missing keys. Other errors in a section are reported when the section is requested.
    pub fn parse(text: &Text, file: &str) -> Result<Self, ParameterError> {
        Self::new(text, file, &REQUIREMENTS)
    }
}
