//! The auxiliary functions of the trace `tau` and the determinant `delta` that decide which maximal
//! periodic solutions exist (sections 2.4 and 4.2 and appendix A of the paper).
//!
//! All arithmetic is real: the sums over eigenvalues are evaluated by recurrences in `tau` and
//! `delta`, so double and complex eigenvalues need no special case.

use core::f64::consts::PI;

/// The value of the trace at which the resonance of the `p`-loop maximal periodic solution occurs.
///
/// `g_p(delta) = 2 sqrt(delta) cos(pi / p)`. Paper: section 2, eq. (15), `eq:gp`.
///
/// `p`: dimensionless, at least 1, not necessarily an integer. `delta`: dimensionless, not
/// negative. The cosine is written as `sin(pi (p - 2) / (2 p))`, which is exactly zero at `p = 2`.
/// NaN when `delta < 0`.
pub fn resonance_boundary(p: f64, delta: f64) -> f64 {
    2.0 * delta.sqrt() * libm::sin(0.5 * PI * (p - 2.0) / p)
}

/// The signed distance of the trace from the resonance of the `p`-loop maximal periodic solution.
///
/// `kappa_p = tau - g_p(delta)`. Paper: section 2.5, before theorem 2.3, `th:codim1p`.
///
/// `p`: number of loops, at least 1 (the paper uses it for `p >= 2`). `tau`, `delta`:
/// dimensionless, `delta >= 0`.
pub fn detuning(p: u32, tau: f64, delta: f64) -> f64 {
    tau - resonance_boundary(f64::from(p), delta)
}

/// The complete homogeneous symmetric polynomial of the eigenvalues, of degree `j - 1`: the Lucas
/// sequence `U_j(tau, delta)`.
///
/// `S_j = sum_{k=1}^{j} lambda_1^{j-k} lambda_2^{k-1}`. Paper: section 4, eq. (7), `eq:SpTp`;
/// closed forms in section A, eq. (10) and (11), `eq:Sp2`, `eq:Sp3`.
///
/// Evaluated by `S_{j+1} = tau S_j - delta S_{j-1}` with `S_0 = 0`, `S_1 = 1`. `tau`, `delta`:
/// dimensionless, any.
pub fn lucas_sequence(j: u32, tau: f64, delta: f64) -> f64 {
    let (mut current, mut next) = (0.0, 1.0);
    for _ in 0..j {
        (current, next) = (next, tau * next - delta * current);
    }
    current
}

/// The partial sum of the `S_j`.
///
/// `T_p = sum_{j=1}^{p-1} S_j`. Paper: section 4, eq. (7), `eq:SpTp`; closed forms in section A,
/// eq. (4), (5) and (12) to (14), `eq:Tp2`, `eq:Tp3`, `eq:Tp6`, `eq:Tp4`, `eq:Tp5`.
///
/// `tau`, `delta`: dimensionless, any. `T_0 = T_1 = 0`.
pub fn lucas_partial_sum(p: u32, tau: f64, delta: f64) -> f64 {
    let (mut current, mut next, mut sum) = (0.0, 1.0, 0.0);
    for _ in 1..p {
        (current, next) = (next, tau * next - delta * current);
        sum += current;
    }
    sum
}

/// The sum whose sign decides whether the last but one visit of the `p`-loop maximal periodic
/// solution is admissible.
///
/// `H_p(tau, delta) = sum_{j=1}^{p-1} sum_{k=1}^{j} lambda_1^{k-j} lambda_2^{1-k}`, which is
/// `sum_{j=1}^{p-1} S_j / delta^{j-1}`.
///
/// Paper: section 2, eq. (16), `eq:Hp`; closed forms in section A, eq. (2), (3), (8) and (9),
/// `eq:Hp2`, `eq:Hp3`, `eq:Hp4`, `eq:Hp5`, and section 4, eq. (8), `eq:Hp9`.
///
/// Evaluated by `h_{j+1} = (tau h_j - h_{j-1}) / delta` for `h_j = S_j / delta^{j-1}`.
/// `tau`, `delta`: dimensionless.
/// `H_0 = H_1 = 0` and `H_2 = 1`. Infinite or NaN when `delta = 0` and `p >= 3`; it grows like
/// `delta^{-(p-2)/2}` at least, so it overflows when `delta` is tiny and `p` is large.
pub fn admissibility_sum(p: u32, tau: f64, delta: f64) -> f64 {
    if p < 2 {
        return 0.0;
    }
    let (mut previous, mut current, mut sum) = (0.0, 1.0, 1.0);
    for _ in 2..p {
        (previous, current) = (current, (tau * current - previous) / delta);
        sum += current;
    }
    sum
}

/// The determinant of the geometric sum `I + A + ... + A^{p-1}`.
///
/// `(1 - lambda_1^p) (1 - lambda_2^p) / ((1 - lambda_1) (1 - lambda_2))`, the factor of `beta` in
/// `det(K)`. Paper: section 4, eq. (16), `eq:detJac2`.
///
/// Evaluated without the quotient: the sum of the powers is `T_p A + (1 - delta T_{p-1}) I`, so
/// that the value is `u^2 + tau u T_p + delta T_p^2` with `u = 1 - delta T_{p-1}`; this holds for
/// eigenvalue 1 too. `tau`, `delta`: dimensionless, any. Zero for `p = 0`, positive in the
/// trapesium for `p >= 1`.
pub fn geometric_sum_determinant(p: u32, tau: f64, delta: f64) -> f64 {
    if p == 0 {
        return 0.0;
    }
    let t_p = lucas_partial_sum(p, tau, delta);
    let u = 1.0 - delta * lucas_partial_sum(p - 1, tau, delta);
    u * u + tau * u * t_p + delta * t_p * t_p
}

/// The scaled position of the `j`-th visit to `Pi` of the emerging `p`-loop maximal periodic
/// solution.
///
/// `u^(j) = S_p T_j - S_j T_p`, where `d x^(j) / d mu (0) = (beta / S_p) u^(j)`.
///
/// Paper: section 4, eq. (30), `eq:ujcodim1proof`; scaling in eq. (27), `eq:ujwj`; special cases in
/// eq. (31) to (33), `eq:u1codim1proof`, `eq:upm1codim1proof`, `eq:ujeig1`.
///
/// `j` from 0 to `p`; zero at both ends. `tau`, `delta`: dimensionless, any. Negative for all `0 <
/// j < p` when `(tau, delta)` lies in the trapesium and `tau > h_p(delta)` (step 3 of the proof of
/// theorem 2.3).
pub fn scaled_visit_position(j: u32, p: u32, tau: f64, delta: f64) -> f64 {
    lucas_sequence(p, tau, delta) * lucas_partial_sum(j, tau, delta)
        - lucas_sequence(j, tau, delta) * lucas_partial_sum(p, tau, delta)
}

/// The modulus of the eigenvalues of `A^p` when they are complex.
///
/// `delta^{p/2}`; for the linear oscillator this is `E_p`, section 3, eq. (14), `eq:Ep`.
///
/// `delta`: dimensionless, not negative; NaN otherwise (for odd `p`).
pub fn modulus_power(p: u32, delta: f64) -> f64 {
    libm::pow(delta, 0.5 * f64::from(p))
}
