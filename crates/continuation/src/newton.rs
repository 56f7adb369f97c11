//! Newton's method for small square systems with exact Jacobians.

use nalgebra::{Const, DimMin, LU, SMatrix, SVector};

use crate::tolerances;

/// Residual and Jacobian of a square system at one point.
#[derive(Clone, Copy, Debug)]
pub struct Linearisation<const N: usize> {
    /// The residual F(u).
    pub residual: SVector<f64, N>,
    /// The Jacobian DF(u).
    pub jacobian: SMatrix<f64, N, N>,
}

impl<const N: usize> Linearisation<N> {
    /// The linearisation with the residual and the gradient of one more equation in the last row.
    #[must_use]
    pub fn bordered(mut self, residual: f64, gradient: &SVector<f64, N>) -> Self {
        self.residual[N - 1] = residual;
        self.jacobian.set_row(N - 1, &gradient.transpose());
        self
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
pub struct Solution<const N: usize>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    /// The solution.
    pub point: SVector<f64, N>,
    /// Euclidean norm of the residual at the last iterate but one, less than the tolerance away.
    pub residual: f64,
    /// The factors of the Jacobian at the last iterate but one.
    pub factors: LU<f64, Const<N>, Const<N>>,
    /// Number of evaluations.
    pub iterations: usize,
}

/// Solves F(u) = 0 from a starting point.
///
/// # Errors
/// The equations are undefined at an iterate, the Jacobian is singular, or `limit` evaluations were
/// not enough.
pub fn solve<const N: usize, E>(
    start: SVector<f64, N>,
    limit: usize,
    equations: impl FnMut(&SVector<f64, N>) -> Result<Linearisation<N>, E>,
) -> Result<Solution<N>, NewtonFailure<E>>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    solve_within(f64::INFINITY, tolerances::STEP, start, limit, equations)
}

/// Like [`solve`], with another length of the last step, and given up as soon as an iterate is
/// farther from the start than `reach`.
///
/// # Errors
/// As [`solve`].
pub fn solve_within<const N: usize, E>(
    reach: f64,
    tolerance: f64,
    start: SVector<f64, N>,
    limit: usize,
    mut equations: impl FnMut(&SVector<f64, N>) -> Result<Linearisation<N>, E>,
) -> Result<Solution<N>, NewtonFailure<E>>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let mut point = start;
    let mut residual = f64::NAN;
    for iteration in 1..=limit {
        let last = equations(&point).map_err(|cause| NewtonFailure::Undefined { iteration, cause })?;
        residual = last.residual.norm();
        let factors = last.jacobian.lu();
        let step = factors
            .solve(&last.residual)
            .filter(|step| step.iter().all(|entry| entry.is_finite()))
            .ok_or(NewtonFailure::Singular { iteration, residual })?;
        point -= step;
        if step.norm() <= tolerance {
            return Ok(Solution { point, residual, factors, iterations: iteration });
        }
        if (point - start).norm() > reach {
            return Err(NewtonFailure::NoConvergence { iterations: iteration, residual });
        }
    }
    Err(NewtonFailure::NoConvergence { iterations: limit, residual })
}
