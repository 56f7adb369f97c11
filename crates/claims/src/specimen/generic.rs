//! Specimens for section 4: oscillators at grazing, and random first-order data.

use crate::*;

/// The specimens at grazing: three with Φ = ε and Ψ = 0, three with a variable reset law, three of these
/// with the frequency as μ, three with a nonlinear force, two with real eigenvalues.
///
/// α > 0 for all, a₁₂ and β have either sign, and no p ≤ 4 is near its resonance: |S_p| > 0.1 r^(p−1).
pub(crate) fn specimens() -> Result<Vec<Grazing>, CheckError> {
    let all = [
        (Law::linear(0.1, 0.8), 0.83),
        (Law::linear(0.03, 0.9), 0.87),
        (Law::linear(0.2, 0.5), 1.7),
        (Law::varying(0.05), 0.84),
        (Law::varying(0.12), 1.4),
        (Law::varying(0.02), 0.9),
        (Law::varying(0.08).frequency_first(), 0.78),
        (Law::varying(0.06).frequency_first(), 0.9),
        (Law::varying(0.1).frequency_first(), 1.3),
        (Law::nonlinear(0.05), 0.95),
        (Law::nonlinear(0.1).frequency_first(), 1.35),
        (Law::nonlinear(0.15).frequency_first(), 1.25),
    ];
    all.into_iter().map(|(law, frequency)| law.grazing(frequency)).collect()
}

/// The specimens, each with all of these numbers of loops.
pub(crate) fn specimens_with(loops: RangeInclusive<u32>) -> Result<Vec<(Grazing, u32)>, CheckError> {
    let with = |grazing: Grazing| loops.clone().map(move |p| (grazing.clone(), p));
    Ok(specimens()?.into_iter().flat_map(with).collect())
}

/// The tally of `samples` random samples at each of the specimens.
pub(crate) fn at_specimens<T: Default>(
    seed: u64,
    samples: usize,
    mut sample: impl FnMut(&mut Sampler, &Grazing, &mut T) -> Result<(), CheckError>,
) -> Result<T, CheckError> {
    drawn_over(seed, specimens()?, |sampler, grazing, tally| {
        (0..samples).try_for_each(|_| sample(sampler, &grazing, tally))
    })
}

/// Specimens with Ψ so large that α < 0.
pub(crate) fn delayed() -> Result<Vec<Grazing>, CheckError> {
    let delay = Exponential { size: 6.0, ..DELAY };
    let all = [(Law::varying(0.05), 0.8), (Law::varying(0.12), 1.4), (Law::nonlinear(0.05), 0.95)];
    all.into_iter().map(|(law, frequency)| Law { delay, ..law }.grazing(frequency)).collect()
}

/// Random first-order data of a global map: (τ, δ) in the trapesium, entries of order one, a₁₂ ≠ 0.
pub(crate) fn sampled_map(sampler: &mut Sampler) -> LinearisedMap {
    let (tau, delta) = sampler.trapesium();
    map_with(sampler, tau, delta)
}

/// Random first-order data of a global map with this trace and determinant.
pub(crate) fn map_with(sampler: &mut Sampler, tau: f64, delta: f64) -> LinearisedMap {
    let a11 = sampler.between(-1.5, 1.5);
    let a12 = sampler.between(0.2, 2.0) * sampler.one_of(&[-1.0, 1.0]);
    let a22 = tau - a11;
    LinearisedMap {
        a: Matrix2::new(a11, a12, (a11 * a22 - delta) / a12, a22),
        b: Vector2::new(sampler.between(-1.0, 1.0), sampler.between(-1.0, 1.0)),
    }
}

/// Random first-order data of a grazing point with this map; Ψ has either sign, and is so small that α >
/// 0.
pub(crate) fn sampled_point(sampler: &mut Sampler, map: LinearisedMap) -> GrazingPoint {
    let forcing_frequency = sampler.between(0.2, 3.0);
    let gamma = sampler.between(0.2, 3.0);
    GrazingPoint {
        map,
        forcing_frequency,
        gamma,
        phi: sampler.between(0.1, 1.0),
        psi: sampler.between(-1.0, 1.0) * forcing_frequency / gamma,
    }
}

/// Directions in (y, z − z_graz, μ), or in more variables: random ones, and along the axes.
pub(crate) fn directions<const N: usize>(sampler: &mut Sampler, number: usize) -> Vec<[f64; N]> {
    let axes = (0..N).map(|axis| core::array::from_fn(|i| f64::from(u8::from(i == axis))));
    let others: Vec<[f64; N]> =
        (0..number).map(|_| core::array::from_fn(|_| sampler.between(-1.0, 1.0))).collect();
    axes.chain(others).collect()
}

/// The smallest order of a remainder in all directions at once, over specimens with α of either sign.
pub(crate) fn smallest_order<const N: usize>(
    seed: u64,
    stated: f64,
    remainder: impl Fn(&Grazing, [f64; N]) -> Option<(f64, f64)>,
) -> CheckResult {
    let mut sampler = Sampler::new(seed);
    let mut orders = Smallest::default();
    for grazing in specimens()?.into_iter().chain(delayed()?) {
        orders.see(uniform_order(&directions::<N>(&mut sampler, 6), |direction, h| {
            remainder(&grazing, direction.map(|share| share * h))
        }));
    }
    let over = "fifteen oscillators, α of either sign, μ the amplitude or the frequency";
    Ok(orders.order(stated, SLACK_AT_GRAZING, &format!("{over}; {} directions at once", N + 6)))
}
