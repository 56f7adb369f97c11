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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn centred_angles_lie_above_minus_half_a_turn_and_at_most_half_a_turn() {
        // Sums of a few angles of order one are exact to some 10⁻¹⁵.
        for (angle, expected) in
            [(PI, PI), (-PI, PI), (3.0 * PI, PI), (4.0, 4.0 - TAU), (-1.0, -1.0), (13.0, 13.0 - 2.0 * TAU)]
        {
            assert!((centred(angle) - expected).abs() < 1e-14, "{angle}: {}", centred(angle));
        }
    }
}
