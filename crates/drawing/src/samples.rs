//! What `figures/parameters.toml` gives, for the tests of figures whose labels have to find room in one particular picture.

use std::path::Path;

use grazing_reproduction::Study;
use grazing_reproduction::parameters::Parameters;

use crate::style::SheetWidth;

/// All widths.
pub(crate) const WIDTHS: [SheetWidth; 3] = [SheetWidth::OneColumn, SheetWidth::Paper, SheetWidth::TwoColumns];

pub(crate) fn study() -> Study<'static> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../figures/parameters.toml");
    Study::new(&Parameters::from_file(&file, &[]).unwrap())
}
