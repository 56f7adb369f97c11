//! The sections of Figures 1, 3 and 9 as they are written: types and keys are checked here, values are not.
//!
//! Ranges are lists here, not pairs: for a pair the reader would take the first two numbers and drop the rest.

use serde::Deserialize;
use toml::Spanned;

/// `[fig01]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct Figure1 {
    pub(super) zeta: Spanned<f64>,
    pub(super) epsilon: Spanned<f64>,
    pub(super) amplitude: Spanned<f64>,
    pub(super) frequency: Spanned<f64>,
    pub(super) velocity: Spanned<Vec<f64>>,
    pub(super) view: View,
    pub(super) orbits: Spanned<Vec<Arrival>>,
}

/// One of `[[fig01.orbits]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct Arrival {
    pub(super) velocity: Spanned<f64>,
    pub(super) phase: Spanned<f64>,
    pub(super) before: Spanned<f64>,
    pub(super) after: Spanned<f64>,
}

/// `[fig01.view]` and its like.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct View {
    pub(super) turn: Spanned<f64>,
    pub(super) tilt: Spanned<f64>,
    pub(super) stretch: Spanned<Vec<f64>>,
}

/// `[fig03]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct Figure3 {
    pub(super) zeta: Spanned<f64>,
    pub(super) frequency: Spanned<f64>,
    pub(super) start: Spanned<Vec<f64>>,
    pub(super) position: Spanned<Vec<f64>>,
    pub(super) phase: Spanned<Vec<f64>>,
    pub(super) radius: Spanned<f64>,
    pub(super) axes: Spanned<f64>,
    pub(super) view: View,
}

/// `[fig09]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct Figure9 {
    pub(super) zeta: Spanned<f64>,
    pub(super) epsilon: Spanned<f64>,
    pub(super) amplitude: Spanned<f64>,
    pub(super) frequency: Spanned<f64>,
    pub(super) impact: Spanned<Vec<f64>>,
    pub(super) loops: Spanned<u32>,
    pub(super) position: Spanned<Vec<f64>>,
    pub(super) velocity: Spanned<Vec<f64>>,
    pub(super) phase: Spanned<Vec<f64>>,
    pub(super) view: View,
}
