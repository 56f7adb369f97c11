//! Beyond the paper: the limit map at all resonances of Figure 7, as a table.

use grazing_reproduction::{Study, StudyError};
use grazing_unfold::limit_map::{AtLimit, LimitTable};

/// The limit map at each resonance of Figure 7.
///
/// # Errors
/// There is no grazing in the window.
pub fn at_resonances(study: &Study) -> Result<LimitTable, StudyError> {
    let found = study.diagram()?.unfolding();
    Ok(LimitTable { rows: found.map(|(resonance, _)| AtLimit::of(resonance)).collect() })
}
