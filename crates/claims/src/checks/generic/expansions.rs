//! Section 4.1, lemma 4.1 and its proof: orders of remainders near grazing.

use grazing_model::maps::virtual_map;
use grazing_model::motion::Motion;
use grazing_model::{ImpactOscillator, OnWall, State};
use grazing_theorems::GrazingPoint;
use nalgebra::Vector2;

use super::maps::{ROUNDING, SLACK, impact_and_recoil, near_grazing, virtual_point};
use super::specimens::{delayed, directions, specimens, uniform_order};
use crate::specimen::Specimen;
use crate::{CheckResult, Outcome, Sampler, Smallest, Votes};

const SPECIMENS: &str = "fifteen oscillators, α of either sign, μ the amplitude or the frequency; nine directions in (y, z, μ) at once";

/// The smallest order over specimens and directions of a remainder at (oscillator, y, z), and its rounding.
fn smallest_order(
    seed: u64,
    stated: f64,
    remainder: impl Fn(&GrazingPoint, &Specimen, f64, f64) -> Option<(f64, f64)>,
) -> CheckResult {
    let mut sampler = Sampler::new(seed);
    let mut orders = Smallest::default();
    for grazing in specimens()?.into_iter().chain(delayed()?) {
        let point = grazing.grazing_point();
        orders.see(uniform_order(&directions::<3>(&mut sampler, 6), |direction, h| {
            let (oscillator, y, z) = near_grazing(&grazing, direction, h);
            remainder(&point, &oscillator, y, z)
        }));
    }
    Ok(orders.order(stated, SLACK, SPECIMENS))
}

/// The vector field near grazing: the first display of the proof of le:discMapComponents.
pub(crate) fn vector_field() -> CheckResult {
    let mut sampler = Sampler::new(4);
    let mut orders = Smallest::default();
    for grazing in specimens()? {
        let gamma = grazing.grazing_point().gamma;
        let [primary, secondary] = grazing.oscillator().parameters();
        orders.see(uniform_order(&directions::<4>(&mut sampler, 6), |[dx, dy, dz, dmu], h| {
            let oscillator = grazing.oscillator().with_parameters([primary + h * dmu, secondary]);
            let state = State { position: h * dx, velocity: h * dy, phase: grazing.phase() + h * dz };
            let frequency =
                oscillator.forcing_frequency().value - grazing.oscillator().forcing_frequency().value;
            let remainder = (oscillator.acceleration(state) + gamma).abs() + frequency.abs();
            Some((remainder, ROUNDING))
        }));
    }
    Ok(orders.order(1.0, SLACK, "twelve oscillators, ten directions in (x, y, z, μ)"))
}

/// x, y or z of the orbit through an impact point.
fn orbit_expansion(seed: u64, stated: f64, coordinate: usize) -> CheckResult {
    let mut sampler = Sampler::new(seed);
    let mut orders = Smallest::default();
    for grazing in specimens()? {
        let GrazingPoint { gamma, forcing_frequency, .. } = grazing.grazing_point();
        orders.see(uniform_order(&directions::<4>(&mut sampler, 8), |[dy, dz, dmu, dt], h| {
            let (oscillator, y, z) = near_grazing(&grazing, [dy, dz, dmu], h);
            let t = h * dt;
            let there = oscillator.motion(State::on_wall(y, z)).at(t);
            let remainders = [
                there.position - (y * t - 0.5 * gamma * t * t),
                there.velocity - (y - gamma * t),
                oscillator.forcing_frequency().value * t - forcing_frequency * t,
            ];
            Some((remainders[coordinate], ROUNDING))
        }));
    }
    Ok(orders.order(stated, SLACK, "twelve oscillators, twelve directions in (y, z, μ, t)"))
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
    smallest_order(seed, stated, |point, oscillator, y, z| {
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

/// The reset law near grazing.
fn reset_remainder(point: &GrazingPoint, oscillator: &Specimen, y: f64, z: f64) -> Vector2<f64> {
    oscillator.reset::<1>(OnWall::new(y, z)).value - Vector2::new(-point.phi * y, z + point.psi * y)
}

fn reset_order(seed: u64, component: usize) -> CheckResult {
    smallest_order(seed, 2.0, |point, oscillator, y, z| {
        Some((reset_remainder(point, oscillator, y, z)[component], ROUNDING))
    })
}

checks! {
    /// The evolution time T.
    evolution_time: smallest_order(8, 2.0, |point, oscillator, y, z| {
        let time = virtual_map::<_, 1>(oscillator, OnWall::new(y, z), None).ok()?.time;
        Some((time - y / point.gamma, ROUNDING))
    });
    /// The reset law's expansion: both remainders, divided by y, are of first order.
    reset_law: smallest_order(16, 1.0, |point, oscillator, y, z| {
        let remainder = reset_remainder(point, oscillator, y, z);
        // Where y = 0 the map is the identity.
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
