//! Section 4.1: the points of an impact on Σ and Π, and the discontinuity map.

use crate::*;
use grazing_model::maps::virtual_preimage;
use nalgebra::Vector3;

/// The rounding of positions of order one and of phases up to 2π.
pub(super) const ROUNDING: f64 = 2e-15;

/// The oscillator, impact velocity and impact phase at (y, z − z_graz, μ).
pub(super) fn near_grazing(grazing: &Grazing, [y, dz, dmu]: [f64; 3]) -> (Specimen, f64, f64) {
    let [primary, secondary] = grazing.oscillator().parameters();
    let oscillator = grazing.oscillator().with_parameters([primary + dmu, secondary]);
    (oscillator, y, grazing.phase() + dz)
}

/// An impact and its recoil.
pub(crate) fn impact_and_recoil(oscillator: &Specimen, y: f64, z: f64) -> [OnWall; 2] {
    let impact = OnWall::new(y, z);
    [impact, oscillator.reset::<1>(impact).image()]
}

/// The image of a point of Σ under P_virt.
pub(crate) fn virtual_point(oscillator: &Specimen, from: OnWall) -> Result<Vector2<f64>, MapError> {
    Ok(virtual_map::<_, 1>(oscillator, from, None)?.jet.value)
}

/// The classical Runge–Kutta method on eq:f over a time of either sign: (x, y, z) at its end.
pub(super) fn integrated(oscillator: &Specimen, from: State, duration: f64, steps: u32) -> Vector3<f64> {
    let h = duration / f64::from(steps);
    let omega = oscillator.forcing_frequency().value;
    let field = |s: &Vector3<f64>| {
        let state = State { position: s[0], velocity: s[1], phase: s[2] };
        Vector3::new(s[1], oscillator.acceleration(state), omega)
    };
    let mut state = Vector3::new(from.position, from.velocity, from.phase);
    for _ in 0..steps {
        let k1 = field(&state);
        let k2 = field(&(state + k1 * (0.5 * h)));
        let k3 = field(&(state + k2 * (0.5 * h)));
        let k4 = field(&(state + k3 * h));
        state += (k1 + (k2 + k3) * 2.0 + k4) * (h / 6.0);
    }
    state
}

/// The preimage of a point of Π under P_virt on the outgoing set, by Newton's method.
fn outgoing_preimage(oscillator: &Specimen, target: Vector2<f64>, gamma: f64) -> Option<Vector2<f64>> {
    let omega = oscillator.forcing_frequency().value;
    let velocity = -(2.0 * gamma * target[0]).sqrt();
    let mut preimage = Vector2::new(velocity, target[1] - omega * velocity / gamma);
    for _ in 0..20 {
        let jet = virtual_map::<_, 1>(oscillator, OnWall::new(preimage[0], preimage[1]), None).ok()?.jet;
        preimage -= jet.derivative().lu().solve(&(jet.value - target))?;
    }
    Some(preimage)
}

/// P_disc minus its leading terms, at x̂ = s² with (z, μ) as near to grazing as s.
fn leading_order(seed: u64, component: usize, stated: f64) -> CheckResult {
    smallest_order(seed, stated, |grazing, [ds, dz, dmu]| {
        let s = ds.abs() + 0.1 * (dz.abs() + dmu.abs());
        let (oscillator, s, z) = near_grazing(grazing, [s, dz, dmu]);
        let image = discontinuity_map::<_, 1>(&oscillator, AtRest::new(s * s, z)).ok()?.value;
        let leading = grazing.grazing_point().discontinuity_map(s * s, z);
        // Positions are of the size of x̂; velocities and phases are known to the rounding of x̂ over s.
        Some((image[component] - leading[component], [ROUNDING, ROUNDING / s][component]))
    })
}

checks! {
    /// eq:Pvirt2: both virtual points against integration, forwards for y > 0, backwards for y < 0.
    // Sixty-four steps over a time below 0.5: about (10⁻²)⁴ times derivatives over 5!.
    virtual_points: at_specimens(2, 60) |sampler, grazing; deviations: Deviations| {
        let oscillator = grazing.oscillator();
        // Some points lie on the tangency set; impacts of negative velocity belong to the extension.
        let y = sampler.one_of(&[0.0, 1.0, 1.0, 1.0]) * sampler.between(-0.05, 0.2);
        let z = grazing.phase() + sampler.between(-0.1, 0.1);
        for from in impact_and_recoil(oscillator, y, z) {
            let landing = virtual_map::<_, 1>(oscillator, from, None)?;
            let [y, z] = from.coordinates().into();
            // For y = 0 the time is zero to within the rounding of the velocity.
            if y * landing.time < 0.0 || (y == 0.0 && landing.time.abs() > 1e-15) {
                return Err(format!("y = {y} takes the time {}", landing.time).into());
            }
            let image = landing.jet.value;
            let expected = integrated(oscillator, State::on_wall(y, z), landing.time, 64);
            deviations.see((expected - Vector3::new(image[0], 0.0, image[1])).amax());
        }
    } => deviations.outcome(1e-11, "impacts near grazing on twelve oscillators, and their recoils");
    /// P_virt and P_virt ∘ R are twice differentiable: the jump of their second derivatives at ±y
    /// vanishes with y.
    smooth_across_tangency: over(specimens()?) |grazing; orders: Smallest| {
        let oscillator = grazing.oscillator();
        let phase = grazing.phase();
        let second = |y: f64, reset: bool| {
            if !reset {
                return Some(virtual_map::<_, 2>(oscillator, OnWall::new(y, phase), None).ok()?.jet);
            }
            let jet = oscillator.reset::<2>(OnWall::new(y, phase));
            let after = virtual_map::<_, 2>(oscillator, jet.image(), None).ok()?.jet;
            Some(after.after::<2, _>(&jet))
        };
        for (reset, component) in [(false, 0), (false, 1), (true, 0), (true, 1)] {
            orders.see(order(|h| {
                let jump = second(h, reset)?.hessians[component] - second(-h, reset)?.hessians[component];
                // Second derivatives of order ten.
                Some((jump.norm(), 1e-13))
            }));
        }
    } => orders.order(1.0, SLACK_AT_GRAZING, "twelve oscillators, both maps, both components");
    /// P_virt has two inverses for x > 0, one on either side of y = 0.
    // Newton's method stops when the phase is known to within its rounding.
    two_inverses: at_specimens(17, 50) |sampler, grazing; deviations: Deviations| {
        let oscillator = grazing.oscillator();
        let x = libm::pow(10.0, sampler.between(-6.0, -2.5));
        let target = Vector2::new(x, grazing.phase() + sampler.between(-0.05, 0.05));
        let incoming = virtual_preimage(oscillator, AtRest::new(target[0], target[1]))?.coordinates();
        let outgoing = outgoing_preimage(oscillator, target, grazing.grazing_point().gamma)
            .ok_or("no preimage on the outgoing set")?;
        if incoming[0] <= 0.0 || outgoing[0] >= 0.0 {
            return Err(format!("not on either side: {incoming} and {outgoing}").into());
        }
        for preimage in [incoming, outgoing] {
            let image = virtual_point(oscillator, OnWall::new(preimage[0], preimage[1]))?;
            deviations.see((image - target).amax());
        }
    } => deviations.outcome(1e-14, "positions from 10⁻⁶ to 0.003 beyond the wall, both preimages, twelve oscillators");
    /// The sign of the square-root term is opposite to that of α.
    sign_of_square_root: over(specimens()?.into_iter().chain(delayed()?)) |grazing; votes: Votes| {
        for exponent in [-6.0, -5.0, -4.0] {
            let x = libm::pow(10.0, exponent);
            let image =
                discontinuity_map::<_, 1>(grazing.oscillator(), AtRest::new(x, grazing.phase()))?.value;
            votes.see((image[1] - grazing.phase()) * grazing.grazing_point().alpha() < 0.0);
        }
    } => votes.outcome("fifteen oscillators, twelve with α > 0 and three with α < 0, x̂ = 10⁻⁶ to 10⁻⁴");
    /// The label `eq:`: the recoil is on the outgoing set.
    recoil: at_specimens(1, 200) |sampler, grazing; margins: Smallest| {
        // From velocities of grazing to those of the largest orbits in the figures.
        let y = libm::pow(10.0, sampler.between(-8.0, 0.5));
        let z = sampler.between(0.0, core::f64::consts::TAU);
        margins.see(-grazing.oscillator().reset::<1>(OnWall::new(y, z)).value[0] / y);
    } => margins.margin("impacts with velocities from 10⁻⁸ to 3 on twelve oscillators: the smallest −y_rec / y_imp");
    /// Orbits hit Π transversally near grazing, where P_virt ends: the acceleration is negative.
    transversality: at_specimens(21, 100) |sampler, grazing; margins: Smallest| {
        let oscillator = grazing.oscillator();
        let y = sampler.between(-0.05, 0.05);
        let z = grazing.phase() + sampler.between(-0.05, 0.05);
        let image = virtual_point(oscillator, OnWall::new(y, z))?;
        margins.see(-oscillator.acceleration(State::at_rest(image[0], image[1])));
    } => margins.margin("images under P_virt of points near grazing on twelve oscillators: the smallest −ẍ");
    /// Both points are virtual: x̂ and x⁽⁰⁾ are positive for y ≠ 0.
    points_are_virtual: at_specimens(3, 100) |sampler, grazing; margins: Smallest| {
        let oscillator = grazing.oscillator();
        let y = libm::pow(10.0, sampler.between(-5.0, -0.7));
        let z = grazing.phase() + sampler.between(-0.1, 0.1);
        for from in impact_and_recoil(oscillator, y, z) {
            let y = from.coordinates()[0];
            margins.see(virtual_point(oscillator, from)?[0] / (y * y));
        }
    } => margins.margin("impacts with velocities from 10⁻⁵ to 0.2 near grazing: the smallest x̂ / y² and x⁽⁰⁾ / y²");
    /// eq:Pdisc: P_disc maps (x̂, ẑ) to (x⁽⁰⁾, z⁽⁰⁾).
    discontinuity: at_specimens(18, 100) |sampler, grazing; deviations: Deviations| {
        let oscillator = grazing.oscillator();
        let y = libm::pow(10.0, sampler.between(-4.0, -1.0));
        let z = grazing.phase() + sampler.between(-0.1, 0.1);
        let [impact, recoil] = impact_and_recoil(oscillator, y, z);
        let (hat, start) = (virtual_point(oscillator, impact)?, virtual_point(oscillator, recoil)?);
        let image = discontinuity_map::<_, 1>(oscillator, AtRest::new(hat[0], hat[1]))?.value;
        // A rounding error of 10⁻¹⁶ in x̂ changes the phase by that over y.
        deviations.see((image - start).amax() * y);
    } => deviations.outcome(1e-14, "impacts with velocities from 10⁻⁴ to 0.1, twelve oscillators: the deviation times y");
    /// The display after eq:Pdisc, first line: the coefficient of x̂ is φ².
    leading_position: leading_order(19, 0, 3.0);
    /// The display after eq:Pdisc, second line: the square root.
    leading_phase: leading_order(20, 1, 2.0);
}
