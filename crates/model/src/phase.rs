//! Phases modulo 2π.

use core::f64::consts::{PI, TAU};

/// An angle brought into [0, 2π).
pub fn turned(angle: f64) -> f64 {
    angle - TAU * libm::floor(angle / TAU)
}

/// An angle brought into (−π, π].
pub fn centred(angle: f64) -> f64 {
    let turned = turned(angle);
    if turned > PI { turned - TAU } else { turned }
}
