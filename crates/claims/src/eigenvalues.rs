//! The eigenvalues of A as a pair of complex numbers, and the printed sums over them.

use grazing_theorems::spectrum::Eigenvalues;
use nalgebra::Complex;

/// λ₁ and λ₂ of eq:eigs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct EigenvaluePair {
    /// λ₁.
    pub(crate) first: Complex<f64>,
    /// λ₂.
    pub(crate) second: Complex<f64>,
}

/// The power λᵏ by repeated multiplication, k of either sign.
pub(crate) fn power(lambda: Complex<f64>, k: i32) -> Complex<f64> {
    let product = (0..k.unsigned_abs()).fold(Complex::new(1.0, 0.0), |product, _| product * lambda);
    if k < 0 { product.finv() } else { product }
}

impl EigenvaluePair {
    /// The eigenvalues of a matrix with trace τ and determinant δ.
    pub(crate) fn new(tau: f64, delta: f64) -> Self {
        match Eigenvalues::from_trace_and_determinant(tau, delta) {
            Eigenvalues::Real { lambda_1, lambda_2 } => {
                Self { first: Complex::new(lambda_1, 0.0), second: Complex::new(lambda_2, 0.0) }
            }
            Eigenvalues::ComplexPair { .. } => {
                let first = Complex::new(0.5 * tau, 0.5 * (4.0 * delta - tau * tau).sqrt());
                Self { first, second: first.conj() }
            }
        }
    }

    /// The pair |λ₁|, |λ₂|, whose sums bound those over the eigenvalues and their rounding errors.
    pub(crate) fn moduli(&self) -> Self {
        let real = |lambda: Complex<f64>| Complex::new(lambda.norm(), 0.0);
        Self { first: real(self.first), second: real(self.second) }
    }

    /// The monomial λ₁ᵃ λ₂ᵇ.
    pub(crate) fn monomial(&self, a: i32, b: i32) -> Complex<f64> {
        power(self.first, a) * power(self.second, b)
    }

    /// The difference λ₁ᵏ − λ₂ᵏ.
    pub(crate) fn difference_of_powers(&self, k: i32) -> Complex<f64> {
        power(self.first, k) - power(self.second, k)
    }

    /// |λ₁|ᵏ + |λ₂|ᵏ, the size of the terms of λ₁ᵏ ± λ₂ᵏ.
    pub(crate) fn size_of_powers(&self, k: i32) -> f64 {
        let Self { first, second } = self.moduli();
        (power(first, k) + power(second, k)).re
    }

    /// S_j = Σₖ λ₁^(j−k) λ₂^(k−1), k = 1, …, j. Paper: eq:SpTp.
    pub(crate) fn s(&self, j: u32) -> Complex<f64> {
        let j = j as i32;
        (1..=j).map(|k| self.monomial(j - k, k - 1)).sum()
    }

    /// T_p = Σ S_j, j = 1, …, p − 1. Paper: eq:SpTp.
    pub(crate) fn t(&self, p: u32) -> Complex<f64> {
        (1..p).map(|j| self.s(j)).sum()
    }

    /// H_p = Σⱼ Σₖ λ₁^(k−j) λ₂^(1−k), j = 1, …, p − 1, k = 1, …, j. Paper: eq:Hp.
    pub(crate) fn h(&self, p: u32) -> Complex<f64> {
        (1..p as i32).flat_map(|j| (1..=j).map(move |k| self.monomial(k - j, 1 - k))).sum()
    }

    /// The product (1 − λ₁)(1 − λ₂).
    pub(crate) fn gap(&self) -> Complex<f64> {
        (-self.first + 1.0) * (-self.second + 1.0)
    }
}
