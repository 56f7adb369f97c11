//! The motion of ẍ = −k x − c ẋ after an impulse.

use super::super::jet::Jet;
use crate::scalar::{Function, Scalar};

/// Discriminants times the square of the time below which power series are used: closed forms of the derivatives
/// divide by them.
const SMALL: f64 = 2.0;
/// Number of terms of these series, of which the last is then below 10⁻¹⁷ of the first.
const TERMS: u32 = 16;

/// With d = k − c²/4, e^{−cs/2} cos(√d s) and e^{−cs/2} sin(√d s)/√d: entire functions of k, c and the time s.
pub(super) struct Propagator<const LENGTH: usize> {
    pub(super) cosine: Jet<LENGTH>,
    pub(super) sine: Jet<LENGTH>,
}

impl<const LENGTH: usize> Propagator<LENGTH> {
    pub(super) fn new(stiffness: Jet<LENGTH>, damping: Jet<LENGTH>, time: f64) -> Self {
        let rate = damping.scale(0.5);
        let discriminant = stiffness - rate.square();
        let [cosine, sine] = decaying(rate.value(), discriminant.value(), time)
            .map(|derivatives| discriminant.compose(derivatives));
        // The value of the exponential is in the functions of the discriminant.
        let decay = (Jet::constant(rate.value()) - rate).scale(time).apply(Function::Exp);
        Self { cosine: decay * cosine, sine: decay * sine }
    }
}

/// The cosine and the sine over √d at rate a, with their first and second derivatives in d.
fn decaying(rate: f64, discriminant: f64, time: f64) -> [[f64; 3]; 2] {
    let square = time * time;
    let turned = discriminant * square;
    let (cosine, sine, by_first, by_second);
    if turned.abs() < SMALL {
        let decay = libm::exp(-rate * time);
        // (−x)^j / (2j + 1)! and its derivatives in x.
        let (mut c, mut s, mut s1, mut s2) = (0.0, 0.0, 0.0, 0.0);
        for j in (0..TERMS).rev().map(f64::from) {
            let [even, odd] = [(2.0 * j + 1.0) * (2.0 * j + 2.0), (2.0 * j + 2.0) * (2.0 * j + 3.0)];
            // Horner's scheme, with the derivatives.
            s2 = -(turned * s2 + 2.0 * s1) / odd;
            s1 = -(turned * s1 + s) / odd;
            s = 1.0 - turned * s / odd;
            c = 1.0 - turned * c / even;
        }
        (cosine, sine) = (decay * c, decay * s * time);
        (by_first, by_second) = (decay * s1 * time * square, decay * s2 * time * square * square);
    } else {
        (cosine, sine) = if discriminant > 0.0 {
            let decay = libm::exp(-rate * time);
            let frequency = discriminant.sqrt();
            let (sin, cos) = libm::sincos(frequency * time);
            (decay * cos, decay * sin / frequency)
        } else {
            let rise = (-discriminant).sqrt();
            let [slow, fast] = [rise - rate, -rise - rate].map(|rate| libm::exp(rate * time));
            (0.5 * (slow + fast), 0.5 * (slow - fast) / rise)
        };
        by_first = (time * cosine - sine) / (2.0 * discriminant);
        by_second = (-0.5 * square * sine - 3.0 * by_first) / (2.0 * discriminant);
    }
    [[cosine, -0.5 * time * sine, -0.5 * time * by_first], [sine, by_first, by_second]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn series_and_closed_forms_are_one_function() {
        for rate in [0.0, 0.3, -0.2] {
            for discriminant in [-1.0, 1.0] {
                let time = SMALL.sqrt();
                let [inside, outside] =
                    [1.0 - 1e-15, 1.0 + 1e-15].map(|by| decaying(rate, discriminant * by, time));
                for (a, b) in inside.iter().flatten().zip(outside.iter().flatten()) {
                    assert!((a - b).abs() < 1e-13 * a.abs(), "{rate} {discriminant}: {inside:?} {outside:?}");
                }
            }
        }
    }
}
