//! Newton's method for small square systems with exact Jacobians.

use core::ops::{Add, Div, Index, IndexMut, Mul, Neg, Sub};

use nalgebra::{Const, DimMin, LU, SMatrix, SVector};

use crate::tolerances;

/// Vectors of unknowns, with the square matrices that belong to them.
pub trait Space:
    Clone
    + Index<usize, Output = f64>
    + IndexMut<usize>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
    + Neg<Output = Self>
{
    /// Square matrices with as many rows as a vector has components.
    type Matrix: Clone;
    /// The factors of a matrix.
    type Factors: Clone;

    /// The number of components.
    fn size(&self) -> usize;

    /// A vector of the same size with equal components.
    fn filled(&self, value: f64) -> Self;

    /// The scalar product.
    fn dot(&self, other: &Self) -> f64;

    /// The Euclidean norm.
    fn norm(&self) -> f64 {
        self.dot(self).sqrt()
    }

    /// The products of the components.
    fn component_mul(&self, other: &Self) -> Self;

    /// The quotients of the components.
    fn component_div(&self, other: &Self) -> Self;

    /// Replaces the last row of a matrix.
    fn set_last_row(matrix: &mut Self::Matrix, row: &Self);

    /// Multiplies each column of a matrix by a component of this vector.
    fn scale_columns(&self, matrix: &mut Self::Matrix);

    /// The factors of a matrix.
    fn factors(matrix: Self::Matrix) -> Self::Factors;

    /// The solution of a linear system; `None` if its matrix is singular.
    fn solved(&self, factors: &Self::Factors) -> Option<Self>;

    /// The unit null vector of all rows of a matrix but the last, at an acute angle with the last,
    /// computed from the matrix's factors.
    fn null_direction(&self, factors: &Self::Factors) -> Option<Self> {
        let mut last = self.filled(0.0);
        last[self.size() - 1] = 1.0;
        let direction = last.solved(factors)?;
        let norm = direction.norm();
        (norm.is_finite() && norm > 0.0).then(|| direction / norm)
    }
}

impl<const N: usize> Space for SVector<f64, N>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    type Matrix = SMatrix<f64, N, N>;
    type Factors = LU<f64, Const<N>, Const<N>>;

    fn size(&self) -> usize {
        N
    }

    fn filled(&self, value: f64) -> Self {
        Self::repeat(value)
    }

    fn dot(&self, other: &Self) -> f64 {
        SVector::dot(self, other)
    }

    fn component_mul(&self, other: &Self) -> Self {
        SVector::component_mul(self, other)
    }

    fn component_div(&self, other: &Self) -> Self {
        SVector::component_div(self, other)
    }

    fn set_last_row(matrix: &mut Self::Matrix, row: &Self) {
        matrix.set_row(N - 1, &row.transpose());
    }

    fn scale_columns(&self, matrix: &mut Self::Matrix) {
        for (mut column, factor) in matrix.column_iter_mut().zip(self.iter()) {
            column.scale_mut(*factor);
        }
    }

    fn factors(matrix: Self::Matrix) -> Self::Factors {
        matrix.lu()
    }

    fn solved(&self, factors: &Self::Factors) -> Option<Self> {
        factors.solve(self)
    }
}

/// Residual and Jacobian of a square system at one point.
#[derive(Clone, Debug)]
pub struct Linearisation<V: Space> {
    /// The residual F(u).
    pub residual: V,
    /// The Jacobian DF(u).
    pub jacobian: V::Matrix,
}

impl<V: Space> Linearisation<V> {
    /// The linearisation with the residual and the gradient of one more equation in the last row.
    #[must_use]
    pub fn bordered(mut self, residual: f64, gradient: &V) -> Self {
        let last = self.residual.size() - 1;
        self.residual[last] = residual;
        V::set_last_row(&mut self.jacobian, gradient);
        self
    }

    /// The unit null vector of all rows of the Jacobian but the last, at an acute angle with the
    /// last; `None` if it is not unique.
    pub fn null_direction(self) -> Option<V> {
        self.residual.null_direction(&V::factors(self.jacobian))
    }
}

/// The reason why Newton's method did not reach a solution.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum NewtonFailure<E> {
    /// The equations are not defined at an iterate.
    #[error("in step {iteration} of Newton's method, {cause}")]
    Undefined {
        /// Number of the iteration, from 1.
        iteration: usize,
        /// The reason why the equations are not defined.
        cause: E,
    },
    /// The Jacobian is singular to rounding.
    #[error(
        "Newton's method has no next step: solutions are not isolated here, and the equations are met to {residual:.1e}"
    )]
    Singular {
        /// Number of the iteration, from 1.
        iteration: usize,
        /// Euclidean norm of the residual.
        residual: f64,
    },
    /// The iteration limit was reached.
    #[error(
        "Newton's method has not converged in {iterations} steps: the equations are met to {residual:.1e}"
    )]
    NoConvergence {
        /// The limit.
        iterations: usize,
        /// Euclidean norm of the last residual.
        residual: f64,
    },
}

/// A converged solution.
#[derive(Clone, Debug)]
pub struct Root<V: Space> {
    /// The solution.
    pub point: V,
    /// Euclidean norm of the residual at the last iterate but one, less than the tolerance away.
    pub residual: f64,
    /// The factors of the Jacobian at the last iterate but one.
    pub factors: V::Factors,
    /// Number of evaluations.
    pub iterations: usize,
}

/// Solves F(u) = 0 from a starting point.
///
/// # Errors
/// The equations are undefined at an iterate, the Jacobian is singular, or `limit` evaluations were
/// not enough.
pub fn solve<V: Space, E>(
    start: V,
    limit: usize,
    equations: impl FnMut(&V) -> Result<Linearisation<V>, E>,
) -> Result<Root<V>, NewtonFailure<E>> {
    solve_within(f64::INFINITY, tolerances::STEP, start, limit, equations)
}

/// Like [`solve`], with another length of the last step, and given up as soon as an iterate is
/// farther from the start than `reach`.
///
/// # Errors
/// As [`solve`].
pub fn solve_within<V: Space, E>(
    reach: f64,
    tolerance: f64,
    start: V,
    limit: usize,
    mut equations: impl FnMut(&V) -> Result<Linearisation<V>, E>,
) -> Result<Root<V>, NewtonFailure<E>> {
    let mut point = start.clone();
    let mut residual = f64::NAN;
    for iteration in 1..=limit {
        let last = equations(&point).map_err(|cause| NewtonFailure::Undefined { iteration, cause })?;
        residual = last.residual.norm();
        let factors = V::factors(last.jacobian);
        let step = last
            .residual
            .solved(&factors)
            .filter(|step| (0..step.size()).all(|entry| step[entry].is_finite()))
            .ok_or(NewtonFailure::Singular { iteration, residual })?;
        let length = step.norm();
        point = point - step;
        if length <= tolerance {
            return Ok(Root { point, residual, factors, iterations: iteration });
        }
        if (point.clone() - start.clone()).norm() > reach {
            return Err(NewtonFailure::NoConvergence { iterations: iteration, residual });
        }
    }
    Err(NewtonFailure::NoConvergence { iterations: limit, residual })
}
