//! Derivatives by central differences of sixth order.

use core::ops::{Add, Mul, Sub};

/// The first derivative at zero, by central differences of sixth order.
pub(crate) fn slope<V: Add<Output = V> + Sub<Output = V> + Mul<f64, Output = V>>(
    step: f64,
    f: impl Fn(f64) -> Option<V>,
) -> Option<V> {
    let pair = |k: f64| Some(f(k * step)? - f(-k * step)?);
    Some((pair(1.0)? * 45.0 - pair(2.0)? * 9.0 + pair(3.0)?) * (1.0 / (60.0 * step)))
}

/// The second derivative at zero, by central differences of sixth order.
pub(crate) fn curvature(step: f64, f: impl Fn(f64) -> Option<f64>) -> Option<f64> {
    let pair = |k: f64| Some(f(k * step)? + f(-k * step)?);
    let sum = 270.0 * pair(1.0)? - 27.0 * pair(2.0)? + 2.0 * pair(3.0)? - 490.0 * f(0.0)?;
    Some(sum / (180.0 * step * step))
}
