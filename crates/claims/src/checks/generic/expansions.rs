//! Section 4.1, lemma 4.1 and its proof: orders of remainders near grazing.

use super::maps::{ROUNDING, impact_and_recoil, near_grazing, virtual_point};
use crate::*;

/// The order of a remainder at (oscillator, y, z).
fn impact_order(
    seed: u64,
    stated: f64,
    remainder: impl Fn(&GrazingPoint, &Specimen, f64, f64) -> Option<(f64, f64)>,
) -> CheckResult {
    smallest_order(seed, stated, |grazing, near: [f64; 3]| {
        let (oscillator, y, z) = near_grazing(grazing, near);
        remainder(&grazing.grazing_point(), &oscillator, y, z)
    })
}

/// The order of the expansion of x, y or z of the orbit through an impact point.
fn orbit_expansion(seed: u64, stated: f64, coordinate: usize) -> CheckResult {
    smallest_order(seed, stated, |grazing, [dy, dz, dmu, t]| {
        let GrazingPoint { gamma, forcing_frequency, .. } = grazing.grazing_point();
        let (oscillator, y, z) = near_grazing(grazing, [dy, dz, dmu]);
        let there = oscillator.motion(State::on_wall(y, z)).at(t);
        let remainders = [
            there.position - (y * t - 0.5 * gamma * t * t),
            there.velocity - (y - gamma * t),
            oscillator.forcing_frequency().value * t - forcing_frequency * t,
        ];
        Some((remainders[coordinate], ROUNDING))
    })
}

/// (x̂, ẑ) or (x⁽⁰⁾, z⁽⁰⁾) minus its leading terms.
fn virtual_remainder(
    point: &GrazingPoint,
    oscillator: &Specimen,
    y: f64,
    z: f64,
    reset: bool,
) -> Option<Vector2<f64>> {
    let [impact, recoil] = impact_and_recoil(oscillator, y, z);
    let (from, leading) =
        if reset { (recoil, point.virtual_map_after_reset()) } else { (impact, point.virtual_map()) };
    Some(virtual_point(oscillator, from).ok()? - leading.apply(y, z))
}

fn virtual_order(seed: u64, stated: f64, component: usize, reset: bool) -> CheckResult {
    impact_order(seed, stated, |point, oscillator, y, z| {
        Some((virtual_remainder(point, oscillator, y, z, reset)?[component], ROUNDING))
    })
}

/// le:discMapComponents: the four expansions together.
pub(crate) fn components() -> CheckResult {
    let orders = [
        virtual_order(9, 3.0, 0, false)?,
        virtual_order(10, 2.0, 1, false)?,
        virtual_order(11, 3.0, 0, true)?,
        virtual_order(12, 2.0, 1, true)?,
    ];
    let over = "the four components, each on fifteen oscillators in nine directions";
    Ok(Votes::of(orders.iter().map(Outcome::passes)).outcome(over))
}

/// The remainder of the reset law near grazing.
fn reset_remainder(point: &GrazingPoint, oscillator: &Specimen, y: f64, z: f64) -> Vector2<f64> {
    oscillator.reset::<1>(OnWall::new(y, z)).value - Vector2::new(-point.phi * y, z + point.psi * y)
}

fn reset_order(seed: u64, component: usize) -> CheckResult {
    impact_order(seed, 2.0, |point, oscillator, y, z| {
        Some((reset_remainder(point, oscillator, y, z)[component], ROUNDING))
    })
}

checks! {
    /// The vector field near grazing: the first display of the proof of le:discMapComponents.
    vector_field: smallest_order(4, 1.0, |grazing, [dx, dy, dz, dmu]| {
        let (oscillator, velocity, phase) = near_grazing(grazing, [dy, dz, dmu]);
        let GrazingPoint { gamma, forcing_frequency, .. } = grazing.grazing_point();
        let frequency = oscillator.forcing_frequency().value - forcing_frequency;
        let acceleration = oscillator.acceleration(State { position: dx, velocity, phase });
        Some(((acceleration + gamma).abs() + frequency.abs(), ROUNDING))
    });
    /// The evolution time T.
    evolution_time: impact_order(8, 2.0, |point, oscillator, y, z| {
        let time = virtual_map::<_, 1>(oscillator, OnWall::new(y, z), None).ok()?.time;
        Some((time - y / point.gamma, ROUNDING))
    });
    /// The reset law's expansion: both remainders, divided by y, are of first order.
    reset_law: impact_order(16, 1.0, |point, oscillator, y, z| {
        let remainder = reset_remainder(point, oscillator, y, z);
        // At y = 0 the map is the identity.
        Some(if y == 0.0 { (remainder.norm(), ROUNDING) } else { (remainder.norm() / y, ROUNDING / y.abs()) })
    });
    /// x(t) in the proof of le:discMapComponents.
    position_of_orbit: orbit_expansion(5, 3.0, 0);
    /// y(t) in the proof of le:discMapComponents.
    velocity_of_orbit: orbit_expansion(6, 2.0, 1);
    /// z(t) in the proof of le:discMapComponents.
    phase_of_orbit: orbit_expansion(7, 2.0, 2);
    /// eq:xHatzHat, first line.
    position_beyond_the_wall: virtual_order(9, 3.0, 0, false);
    /// eq:xHatzHat, second line.
    phase_beyond_the_wall: virtual_order(10, 2.0, 1, false);
    /// eq:x0z0, first line.
    position_before_the_recoil: virtual_order(11, 3.0, 0, true);
    /// eq:x0z0, second line.
    phase_before_the_recoil: virtual_order(12, 2.0, 1, true);
    /// y_rec and the first line of the reset law's expansion.
    recoil_velocity: reset_order(14, 0);
    /// z_rec and the second line of the reset law's expansion.
    recoil_phase: reset_order(15, 1);
}
