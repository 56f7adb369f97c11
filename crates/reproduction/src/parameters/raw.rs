//! The parameter file as it is written: types and keys are checked here, values are not.
//!
//! Ranges are lists here, not pairs: for a pair the reader would take the first two numbers and drop the rest.

use serde::Deserialize;
use toml::Spanned;

/// The whole file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct File {
    pub(super) oscillator: Oscillator,
    pub(super) fig01: Figure1,
    pub(super) fig02: Figure2,
    pub(super) fig03: Figure3,
    pub(super) fig04: super::fig04::Raw,
    pub(super) fig05: super::fig05::Raw,
    pub(super) fig06: super::fig06::Raw,
    pub(super) fig07: Figure7,
    pub(super) fig08: Figure8,
    pub(super) fig09: Figure9,
    pub(super) fig10: super::fig10::Raw,
}

/// `[oscillator]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct Oscillator {
    pub(super) zeta: Spanned<f64>,
    pub(super) epsilon: Spanned<f64>,
}

/// `[fig02]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct Figure2 {
    pub(super) frequency: Spanned<f64>,
    pub(super) amplitude: Spanned<Vec<f64>>,
    pub(super) x: Spanned<Vec<f64>>,
    pub(super) loops: Spanned<Vec<Spanned<u32>>>,
    pub(super) magnification: Magnification,
    pub(super) attractor: Attractor,
    pub(super) portraits: Spanned<Vec<Portrait>>,
}

/// `[fig02.magnification]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct Magnification {
    pub(super) amplitude: Spanned<Vec<f64>>,
    pub(super) x: Spanned<Vec<f64>>,
}

/// `[fig02.attractor]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct Attractor {
    pub(super) amplitudes: Spanned<u32>,
    pub(super) orbits: Spanned<u32>,
    pub(super) transient: Spanned<u32>,
    pub(super) recorded: Spanned<u32>,
    pub(super) seed: Spanned<u64>,
}

/// One of `[[fig02.portraits]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct Portrait {
    pub(super) loops: Spanned<u32>,
    pub(super) amplitude: Spanned<f64>,
}

/// `[fig07]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct Figure7 {
    pub(super) amplitude: Spanned<Vec<f64>>,
    pub(super) frequency: Spanned<Vec<f64>>,
    pub(super) loops: Spanned<Vec<Spanned<u32>>>,
}

/// `[fig08]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct Figure8 {
    pub(super) panels: Spanned<Vec<Panel>>,
}

/// One of `[[fig08.panels]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct Panel {
    pub(super) loops: Spanned<u32>,
    pub(super) n: Spanned<u32>,
    pub(super) amplitude: Spanned<Vec<f64>>,
    pub(super) frequency: Spanned<Vec<f64>>,
}

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
