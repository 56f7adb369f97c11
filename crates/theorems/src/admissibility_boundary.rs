//! The boundary `h_p` of the values of the trace for which the `p`-loop maximal periodic solution
//! is known to be admissible (section 2.4 and appendix A of the paper).

use core::f64::consts::PI;

use crate::error::TheoryError;

/// The largest value of the trace at which `H_p` vanishes.
///
/// `h_2(delta) = -2 sqrt(delta)`; for `p >= 3`, `h_p(delta)` is the largest `tau` with `H_p(tau,
/// delta) = 0`.
///
/// Paper: section 2.4, after eq. (16), `eq:Hp`. By lemma 2.1, `le:admissibilityBoundary`,
/// `g_{p/2}(delta) < h_p(delta) < g_{p-1}(delta)` for `p >= 3`.
///
/// `p`: number of loops, at least 2. `delta`: dimensionless, in (0, 1). The result is off by a few
/// units in the last place of `2 sqrt(delta)`.
///
/// # Method
/// With `r = sqrt(delta)` and `tau = 2 r c`, `r^{p-2} H_p = W(c) = sum_{j=1}^{p-1} r^{p-1-j}
/// U_{j-1}(c)`, `U` the Chebyshev polynomials of the second kind: nothing overflows, however small
/// `delta` is. The lemma brackets the root, `cos(2 pi / p) < c < cos(pi / (p-1))`. It is the only
/// root there: with `c = cos(theta)` and `1 - r e^{i theta} = rho e^{-i psi}`, eq. (9) of section
/// A, `eq:Hp5`, vanishes where `sin((p-1) theta - psi) = -r^{p-1} sin(psi)`; `psi' <= (1 /
/// sin(theta) - 1) / 2 < (p-1) / 4`, so the phase on the left increases from `pi - psi` to `2 pi -
/// theta - psi` and crosses the right-hand side once, downwards. Hence Newton's method, guarded by
/// bisection, finds it.
///
/// # Errors
/// [`TheoryError::TooFewLoops`] when `p < 2`; [`TheoryError::DeterminantOutsideUnitInterval`] when
/// `delta` is not in (0, 1).
pub fn admissibility_boundary(p: u32, delta: f64) -> Result<f64, TheoryError> {
    if p < 2 {
        return Err(TheoryError::TooFewLoops { loops: p, minimum: 2 });
    }
    if !(0.0 < delta && delta < 1.0) {
        return Err(TheoryError::DeterminantOutsideUnitInterval { delta });
    }
    let modulus = delta.sqrt();
    if p == 2 {
        return Ok(-2.0 * modulus);
    }
    let loops = f64::from(p);
    let bracket = (libm::cos(2.0 * PI / loops), libm::cos(PI / (loops - 1.0)));
    Ok(2.0 * modulus * increasing_root(bracket, |cosine| scaled_admissibility_sum(p, modulus, cosine)))
}

/// `W(c) = r^{p-2} H_p(2 r c, r^2)` and `W'(c)`, for `p >= 3`.
fn scaled_admissibility_sum(p: u32, modulus: f64, cosine: f64) -> (f64, f64) {
    // (U_{j-2}, U_{j-1}) and their derivatives, from j = 1.
    let (mut u, mut du) = ((0.0, 1.0), (0.0, 0.0));
    let (mut w, mut dw) = (1.0, 0.0);
    for _ in 2..p {
        du = (du.1, 2.0 * (u.1 + cosine * du.1) - du.0);
        u = (u.1, 2.0 * cosine * u.1 - u.0);
        w = modulus * w + u.1;
        dw = modulus * dw + du.1;
    }
    (w, dw)
}

/// The root of a function that is negative at the lower end of the bracket and positive at the
/// upper one, by Newton's method; a step that leaves the bracket or does not halve the last one is
/// replaced by a bisection.
fn increasing_root((mut low, mut high): (f64, f64), value_and_slope: impl Fn(f64) -> (f64, f64)) -> f64 {
    let mut point = 0.5 * (low + high);
    let mut last_step = high - low;
    loop {
        let (value, slope) = value_and_slope(point);
        if value < 0.0 {
            low = point;
        } else {
            high = point;
        }
        let step = -value / slope;
        // The bracket lies in [-1, 1]: the error that remains after a Newton step of this size is
        // below the last digit.
        if step.abs() <= 2.0 * f64::EPSILON {
            return (point + step).clamp(low, high);
        }
        let newton = point + step;
        let midpoint = 0.5 * (low + high);
        let next =
            if low < newton && newton < high && step.abs() < 0.5 * last_step { newton } else { midpoint };
        if midpoint == low || midpoint == high {
            return midpoint;
        }
        last_step = (next - point).abs();
        point = next;
    }
}
