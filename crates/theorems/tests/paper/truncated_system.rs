//! A hybrid system near grazing whose maps are polynomials: as little as the unfolding depends on, and some
//! terms that it must not depend on. Its bifurcations are found by solving the equations that define them,
//! without any expansion.

use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};
use num_dual::{Dual64, DualNum, DualNumCopy, first_derivative, second_derivative};

use grazing_theorems::{GrazingPoint, LinearisedMap, ResonantPoint, Unfolding};

/// `P_virt` and `P_virt o R` are their leading terms; `P_global` is quadratic in `(x, z)`, linear in `mu`,
/// and its linear part varies with `eta` as `A + eta A'`. Grazing occurs at `(x, z; mu) = 0` for all `eta`.
pub(crate) struct TruncatedSystem {
    pub(crate) point: GrazingPoint,
    /// `A'`.
    pub(crate) drift: Matrix2<f64>,
    /// The coefficients of `x^2, x z, z^2, z mu` in both components of `P_global`.
    pub(crate) quadratic: [[f64; 4]; 2],
}

/// Which multiplier the solution has on the curve.
#[derive(Clone, Copy)]
pub(crate) enum Multiplier {
    One,
    MinusOne,
}

impl TruncatedSystem {
    fn global<D: DualNumCopy + DualNum<Primitive = f64>>(&self, [x, z]: [D; 2], mu: D, eta: f64) -> [D; 2] {
        let a = self.point.map.a + self.drift * eta;
        let b = self.point.map.b;
        let row = |linear: (f64, f64, f64), quadratic: [f64; 4]| {
            x * linear.0
                + z * linear.1
                + mu * linear.2
                + x * x * quadratic[0]
                + x * z * quadratic[1]
                + z * z * quadratic[2]
                + z * mu * quadratic[3]
        };
        [row((a.m11, a.m12, b.x), self.quadratic[0]), row((a.m21, a.m22, b.y), self.quadratic[1])]
    }

    fn iterated<D: DualNumCopy + DualNum<Primitive = f64>>(
        &self,
        p: u32,
        start: [D; 2],
        mu: D,
        eta: f64,
    ) -> [D; 2] {
        (0..p).fold(start, |visit, _| self.global(visit, mu, eta))
    }

    /// The points where the loop ends after `p` returns, and where it should end.
    fn ends<D: DualNumCopy + DualNum<Primitive = f64>>(
        &self,
        p: u32,
        [y, z]: [D; 2],
        mu: D,
        eta: f64,
    ) -> ([D; 2], [D; 2]) {
        let (after_reset, hat) = (self.point.virtual_map_after_reset(), self.point.virtual_map());
        let start = [y * y * after_reset.x_coefficient, z + y * after_reset.z_coefficient];
        (self.iterated(p, start, mu, eta), [y * y * hat.x_coefficient, z + y * hat.z_coefficient])
    }

    /// The VIVID function.
    fn vivid(&self, p: u32, y: f64, z: f64, mu: f64, eta: f64) -> Vector2<f64> {
        let (end, hat) = self.ends(p, [y, z], mu, eta);
        Vector2::new(end[0] - hat[0], end[1] - hat[1])
    }

    /// `det(D G -+ D P_virt)` with `G = P_global^p o P_virt o R`: `y / gamma` times `1 -+ T + D`.
    fn multiplier_condition(&self, p: u32, y: f64, z: f64, mu: f64, eta: f64, multiplier: Multiplier) -> f64 {
        let sign = match multiplier {
            Multiplier::One => -1.0,
            Multiplier::MinusOne => 1.0,
        };
        let column = |direction: [f64; 2]| {
            let arguments = [Dual64::new(y, direction[0]), Dual64::new(z, direction[1])];
            let (end, hat) = self.ends(p, arguments, Dual64::from(mu), eta);
            Vector2::new(end[0].eps + hat[0].eps * sign, end[1].eps + hat[1].eps * sign)
        };
        Matrix2::from_columns(&[column([1.0, 0.0]), column([0.0, 1.0])]).determinant()
    }

    /// What the unfolding needs to know, from derivatives of the polynomials.
    pub(crate) fn resonant_point(&self, p: u32) -> ResonantPoint {
        let (_, _, second_phase_derivative) = second_derivative(
            |z: num_dual::Dual2_64| {
                self.iterated(p, [num_dual::Dual2_64::from(0.0), z], num_dual::Dual2_64::from(0.0), 0.0)[0]
            },
            0.0,
        );
        let unfolding = if p == 1 {
            Unfolding::OneLoop { off_diagonal_derivative: self.drift.m12 }
        } else {
            // kappa_p = tau - 2 sqrt(delta) cos(pi / p), with the cosine from the point itself, where kappa_p
            // = 0.
            let (a, drift) = (self.point.map.a, self.drift);
            let cosine = a.trace() / (2.0 * a.determinant().sqrt());
            let (_, detuning_derivative) = first_derivative(
                |eta: Dual64| {
                    let entry = |row, column| eta * drift[(row, column)] + a[(row, column)];
                    let determinant = entry(0, 0) * entry(1, 1) - entry(0, 1) * entry(1, 0);
                    entry(0, 0) + entry(1, 1) - determinant.sqrt() * (2.0 * cosine)
                },
                0.0,
            );
            Unfolding::MultiLoop { loops: p, detuning_derivative }
        };
        ResonantPoint { grazing: self.point, second_phase_derivative, unfolding }
    }

    /// The solution with the given multiplier at `eta`, in the scaling `y = eta Y`, `z = eta Z`,
    /// `mu = eta^2 M`: `(Y, Z, M)`.
    pub(crate) fn bifurcation(
        &self,
        p: u32,
        eta: f64,
        multiplier: Multiplier,
        guess: Vector3<f64>,
    ) -> Vector3<f64> {
        newton(guess, |unknown| {
            let (y, z, mu) = (eta * unknown.x, eta * unknown.y, eta * eta * unknown.z);
            let vivid = self.vivid(p, y, z, mu, eta);
            let condition = self.multiplier_condition(p, y, z, mu, eta, multiplier);
            Vector3::new(vivid.x / (eta * eta), vivid.y / eta, condition / eta)
        })
    }

    /// The solution with impact velocity `size velocity` at `eta = size share`, scaled likewise: `(Z, M)`.
    pub(crate) fn on_branch(
        &self,
        p: u32,
        size: f64,
        velocity: f64,
        share: f64,
        guess: Vector2<f64>,
    ) -> Vector2<f64> {
        let solution = newton(Vector3::new(guess.x, guess.y, 0.0), |unknown| {
            let vivid =
                self.vivid(p, size * velocity, size * unknown.x, size * size * unknown.y, size * share);
            Vector3::new(vivid.x / (size * size), vivid.y / size, unknown.z)
        });
        solution.xy()
    }
}

/// Newton's method with a Jacobian of central differences: it has nine digits, so each step gains nine.
fn newton(mut unknown: Vector3<f64>, residual: impl Fn(&Vector3<f64>) -> Vector3<f64>) -> Vector3<f64> {
    const STEP: f64 = 1e-5;
    for _ in 0..30 {
        let jacobian = Matrix3::from_columns(&[0, 1, 2].map(|index| {
            let mut step = Vector3::zeros();
            step[index] = STEP;
            (residual(&(unknown + step)) - residual(&(unknown - step))) / (2.0 * STEP)
        }));
        let correction = jacobian.lu().solve(&residual(&unknown)).expect("a regular solution");
        unknown -= correction;
        if correction.amax() <= 1e-12 * (1.0 + unknown.amax()) {
            return unknown;
        }
    }
    panic!("Newton's method did not converge: {unknown}");
}

/// A resonant system with one loop: `a12 = 0`, multipliers `a11`, `a22`.
pub(crate) fn one_loop(a11: f64, a22: f64) -> TruncatedSystem {
    system(Matrix2::new(a11, 0.0, -0.8, a22))
}

/// A resonant system with `p >= 2` loops: determinant `delta`, trace `2 sqrt(delta) cos(pi / p)`.
pub(crate) fn multi_loop(p: u32, delta: f64, a11: f64, a12: f64) -> TruncatedSystem {
    let tau = 2.0 * delta.sqrt() * libm::cos(core::f64::consts::PI / f64::from(p));
    let a22 = tau - a11;
    system(Matrix2::new(a11, a12, (a11 * a22 - delta) / a12, a22))
}

/// All other numbers are of order one and without pattern.
fn system(a: Matrix2<f64>) -> TruncatedSystem {
    TruncatedSystem {
        point: GrazingPoint {
            map: LinearisedMap { a, b: Vector2::new(0.7, -0.3) },
            forcing_frequency: 1.3,
            gamma: 0.9,
            phi: 0.65,
            psi: 0.2,
        },
        drift: Matrix2::new(0.25, 0.6, -0.35, -0.15),
        quadratic: [[0.3, -0.2, -0.55, 0.4], [0.15, 0.25, -0.3, -0.35]],
    }
}
