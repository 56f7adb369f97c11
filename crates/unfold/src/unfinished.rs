//! Parts of an analysis that were not finished because the computation was cancelled
//! ([`Stop`](grazing_model::smooth::Stop)).

use std::borrow::Cow;

use grazing_model::ImpactOscillator;

use crate::resonances::FoundResonance;

/// A part of the analysis that was not finished because the computation was cancelled.
#[derive(Clone, Debug, PartialEq)]
pub struct Unfinished {
    /// The stage that was running, or that would have followed.
    pub stage: Cow<'static, str>,
    /// The numbers p and n of the resonance it belongs to, if it belongs to one.
    pub resonance: Option<[u32; 2]>,
    /// The parameters (μ, η) of the place it belongs to, if it belongs to one.
    pub at: Option<[f64; 2]>,
}

impl Unfinished {
    /// A stage as a whole.
    pub fn stage(stage: impl Into<Cow<'static, str>>) -> Self {
        Self { stage: stage.into(), resonance: None, at: None }
    }

    /// A stage at one resonance.
    pub fn at(stage: &'static str, resonance: &FoundResonance) -> Self {
        let at = resonance.located.orbit().oscillator().parameters();
        Self { stage: stage.into(), resonance: Some([resonance.loops, resonance.n]), at: Some(at) }
    }
}
