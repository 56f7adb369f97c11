//! Helpers for the tests of figures.

mod scenes;

use std::path::Path;

use crate::Study;
use crate::parameters::Parameters;

/// The study of the default parameters.
pub(crate) fn study() -> Study {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../figures/parameters.toml");
    Study::new(&Parameters::from_file(&file, &[]).expect("the default parameters are valid"))
}
