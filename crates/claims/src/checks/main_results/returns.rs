//! P_global without Newton's method or jets: the maxima of x in a free motion, found by the search of `motion`.

use core::f64::consts::TAU;

use crate::Failure;
use grazing_model::motion::local_maxima;
use grazing_model::{ImpactOscillator, State};
use nalgebra::Vector2;

/// The image of (x, z) under P_global: the local maximum of x nearest to one forcing period later.
pub(crate) fn returned<O: ImpactOscillator>(
    oscillator: &O,
    [position, phase]: [f64; 2],
) -> Result<Vector2<f64>, Failure> {
    let period = oscillator.forcing_period();
    let motion = oscillator.motion(State::at_rest(position, phase));
    let nearest = local_maxima(&motion, 1.5 * period)
        .into_iter()
        .min_by(|a, b| (a.time - period).abs().total_cmp(&(b.time - period).abs()))
        .ok_or("the motion has no maximum")?;
    let turn = oscillator.forcing_frequency().value * nearest.time - TAU;
    Ok(Vector2::new(nearest.position, phase + turn))
}

/// The p-th iterate.
pub(crate) fn iterated<O: ImpactOscillator>(
    oscillator: &O,
    loops: u32,
    start: [f64; 2],
) -> Result<Vector2<f64>, Failure> {
    let mut here = Vector2::from(start);
    for _ in 0..loops {
        here = returned(oscillator, here.into())?;
    }
    Ok(here)
}

/// A first derivative by central differences with steps h and h/2, extrapolated: the error is of fourth order.
pub(crate) fn derivative<const N: usize>(
    step: f64,
    mut value: impl FnMut(f64) -> Result<[f64; N], Failure>,
) -> Result<[f64; N], Failure> {
    let mut central = |h: f64| -> Result<[f64; N], Failure> {
        let (ahead, back) = (value(h)?, value(-h)?);
        Ok(core::array::from_fn(|i| (ahead[i] - back[i]) / (2.0 * h)))
    };
    let (coarse, fine) = (central(step)?, central(0.5 * step)?);
    Ok(core::array::from_fn(|i| (4.0 * fine[i] - coarse[i]) / 3.0))
}

/// A second derivative by central differences with steps h and h/2, extrapolated: the error is of fourth order.
pub(crate) fn second_derivative(
    step: f64,
    mut value: impl FnMut(f64) -> Result<f64, Failure>,
) -> Result<f64, Failure> {
    let middle = value(0.0)?;
    let mut central =
        |h: f64| -> Result<f64, Failure> { Ok((value(h)? - 2.0 * middle + value(-h)?) / (h * h)) };
    let (coarse, fine) = (central(step)?, central(0.5 * step)?);
    Ok((4.0 * fine - coarse) / 3.0)
}
