//! `[fig04]`: which boundaries Figure 4 shows.

use serde::Deserialize;
use toml::Spanned;

use super::validate::{Checked, loops, refusal};
use grazing_source::Source;

/// `[fig04]` as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct Raw {
    loops: Spanned<Vec<Spanned<u32>>>,
}

/// Figure 4: the boundaries g_p and h_p in the trapesium.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure4 {
    loops: Vec<u32>,
}

impl Figure4 {
    /// The numbers of loops p whose boundaries are drawn: at least one, each 2 or more, none twice.
    pub fn loops(&self) -> &[u32] {
        &self.loops
    }
}

pub(super) fn check(raw: &Raw, source: &Source<'_>) -> Checked<Figure4> {
    let numbers = loops(source, "fig04.loops", &raw.loops)?;
    if let Some(written) = raw.loops.get_ref().iter().find(|p| *p.get_ref() < 2) {
        return Err(refusal(source, "fig04.loops", written));
    }
    Ok(Figure4 { loops: numbers })
}
