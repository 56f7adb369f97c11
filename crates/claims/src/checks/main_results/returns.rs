//! P_global without Newton's method or jets: maxima of x in free motion, found by the search of `motion`.

use crate::*;

/// The image of (x, z) under P_global: the local maximum of x nearest to one forcing period later.
pub(crate) fn returned<O: ImpactOscillator>(
    oscillator: &O,
    [position, phase]: [f64; 2],
) -> Result<Vector2<f64>, CheckError> {
    let period = oscillator.forcing_period();
    let motion = oscillator.motion(State::at_rest(position, phase));
    let nearest = motion
        .local_maxima(1.5 * period)
        .into_iter()
        .min_by(|a, b| (a.time - period).abs().total_cmp(&(b.time - period).abs()))
        .ok_or("the motion has no maximum")?;
    let turn = oscillator.forcing_frequency().value * nearest.time - TAU;
    Ok(Vector2::new(nearest.position, phase + turn))
}

/// The p-th iterate of `returned`.
pub(crate) fn iterated(
    oscillator: &Specimen,
    loops: u32,
    start: [f64; 2],
) -> Result<Vector2<f64>, CheckError> {
    (0..loops).try_fold(start.into(), |here: Vector2<f64>, _| returned(oscillator, here.into()))
}

/// ∂P_global/∂(x, z, μ) at grazing by differences, with μ in multiples of a unit.
pub(crate) fn derivatives<O: ImpactOscillator>(
    grazing: &GrazingOrbit<O>,
    unit: f64,
) -> Result<[Vector2<f64>; 3], CheckError> {
    let [primary, secondary] = grazing.oscillator().parameters();
    let by = |axis: usize| {
        // Rounding is 10⁻¹⁵ over the step; the error is its sixth power times seventh derivatives.
        slope(1e-3, |h| {
            let [x, z, mu] = core::array::from_fn(|i| if i == axis { h } else { 0.0 });
            let near = grazing.oscillator().with_parameters([primary + mu * unit, secondary]);
            returned(&near, [x, grazing.phase() + z]).ok()
        })
    };
    let columns = by(0).zip(by(1)).zip(by(2));
    let ((x, z), mu) = columns.ok_or("P_global is not defined near grazing")?;
    Ok([x, z, mu])
}
