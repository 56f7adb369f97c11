//! Coefficients of Gauss's collocation for ẍ = F(x, ẋ, t): six points, order 12.
//!
//! Source: E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*, 2nd
//! edition, section II.7; the nodes are the zeros of the Legendre polynomial of degree six, shifted
//! to the unit interval, and the other coefficients integrals of Lagrange's polynomials on them,
//! computed to 50 digits and rounded, or products of such. Tests check the conditions that define
//! them.

use super::stages::{Lanes, Matrix, STAGES, Stages};

/// Fractions c of the step at which the stages stand.
pub(super) const NODES: [f64; STAGES] = [
    0.03376524289842399,
    0.16939530676686773,
    0.38069040695840156,
    0.6193095930415985,
    0.8306046932331322,
    0.966234757101576,
];

/// The matrix A: velocities at the stages from accelerations.
pub(super) const MATRIX: Matrix = Matrix::from_rows([
    [
        0.04283112309479259,
        -0.014763725997197413,
        0.009325050706477751,
        -0.005668858049483512,
        0.002854433315099335,
        -0.0008127801712647621,
    ],
    [
        0.09267349143037887,
        0.09019039326203465,
        -0.020300102293239586,
        0.010363156240246424,
        -0.004887192928037671,
        0.0013555610554850618,
    ],
    [
        0.08224792261284387,
        0.196032162333245,
        0.11697848364317276,
        -0.020482527745656096,
        0.007989991899662336,
        -0.002075625784866334,
    ],
    [
        0.0877378719744515,
        0.17239079462440696,
        0.25443949503200164,
        0.11697848364317276,
        -0.0156513758091757,
        0.0034143235767412987,
    ],
    [
        0.08430668513410011,
        0.18526797945210696,
        0.2235938110460991,
        0.2542570695795851,
        0.09019039326203465,
        -0.007011245240793691,
    ],
    [
        0.08647502636084993,
        0.17752635320896998,
        0.23962582533582905,
        0.22463191657986778,
        0.19514451252126672,
        0.04283112309479259,
    ],
]);

/// A²: positions at the stages from accelerations.
pub(super) static SQUARE: Matrix = {
    let mut square = [Lanes([0.0; STAGES]); STAGES];
    let mut j = 0;
    while j < STAGES {
        square[j] = through(&MATRIX.0[j].0, &MATRIX.0);
        j += 1;
    }
    Matrix(square)
};

/// A linear combination of columns.
const fn through(weights: &[f64; STAGES], columns: &[Stages; STAGES]) -> Stages {
    let mut sums = [0.0; STAGES];
    let mut place = 0;
    while place < STAGES * STAGES {
        let (i, j) = (place % STAGES, place / STAGES);
        sums[i] += weights[j] * columns[j].0[i];
        place += 1;
    }
    Lanes(sums)
}

/// The weights b: velocity at the end from accelerations.
pub(super) const WEIGHTS: [f64; STAGES] = [
    0.08566224618958518,
    0.1803807865240693,
    0.23395696728634552,
    0.23395696728634552,
    0.1803807865240693,
    0.08566224618958518,
];

/// bA: position at the end from accelerations.
pub(super) const POSITION_WEIGHTS: [f64; STAGES] = {
    let mut weights = [0.0; STAGES];
    let mut place = 0;
    while place < STAGES * STAGES {
        let (i, j) = (place % STAGES, place / STAGES);
        weights[j] += WEIGHTS[i] * MATRIX.0[j].0[i];
        place += 1;
    }
    weights
};

/// The coefficients of a function in Legendre polynomials on the step, of degrees five to two:
/// (2n + 1) b P_n(2c − 1).
pub(super) const LEGENDRE: [[f64; STAGES]; 4] = {
    let mut rows = [[0.0; STAGES]; 4];
    let mut stage = 0;
    while stage < STAGES {
        let (u, b) = (2.0 * NODES[stage] - 1.0, WEIGHTS[stage]);
        rows[0][stage] = 11.0 * b * u * (15.0 + u * u * (63.0 * u * u - 70.0)) / 8.0;
        rows[1][stage] = 9.0 * b * (3.0 + u * u * (35.0 * u * u - 30.0)) / 8.0;
        rows[2][stage] = 7.0 * b * u * (5.0 * u * u - 3.0) / 2.0;
        rows[3][stage] = 5.0 * b * (3.0 * u * u - 1.0) / 2.0;
        stage += 1;
    }
    rows
};

/// The coefficients of the polynomial through values at the stages, in powers of 2c − 1, in
/// ascending order.
pub(super) const POWERS: Matrix = {
    let mut columns = [Lanes([0.0; STAGES]); STAGES];
    let mut j = 0;
    while j < STAGES {
        // Lagrange's polynomial: 1 at its own stage and 0 at the others, a factor for each of
        // these.
        let mut product = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let mut k = 0;
        while k < STAGES {
            if k != j {
                let (zero, gap) = (2.0 * NODES[k] - 1.0, 2.0 * (NODES[j] - NODES[k]));
                let mut power = STAGES - 1;
                while power > 0 {
                    product[power] = (product[power - 1] - zero * product[power]) / gap;
                    power -= 1;
                }
                product[0] *= -zero / gap;
            }
            k += 1;
        }
        columns[j] = Lanes(product);
        j += 1;
    }
    Matrix(columns)
};

#[cfg(test)]
mod tests {
    use super::*;

    /// Sums of six terms of order one.
    const ROUNDING: f64 = 1e-15;

    fn moment(weights: &[f64; STAGES], power: u32) -> f64 {
        let powers = NODES.map(|c| (0..power).fold(1.0, |product, _| product * c));
        weights.iter().zip(powers).map(|(weight, power)| weight * power).sum()
    }

    #[test]
    fn weights_integrate_polynomials_up_to_degree_eleven() {
        for power in 0..12_u32 {
            let n = f64::from(power);
            assert!((moment(&WEIGHTS, power) - 1.0 / (n + 1.0)).abs() < ROUNDING);
            // ∫ (1 − t) tⁿ dt; the factor takes one degree.
            if power < 11 {
                let exact = 1.0 / (n + 1.0) - 1.0 / (n + 2.0);
                assert!((moment(&POSITION_WEIGHTS, power) - exact).abs() < ROUNDING);
            }
        }
    }

    #[test]
    fn stages_integrate_polynomials_up_to_degree_five() {
        for (i, c) in NODES.into_iter().enumerate() {
            let [row, twice_row] = [&MATRIX, &SQUARE].map(|matrix| matrix.0.map(|column| column.0[i]));
            let mut power_of_c = c;
            for power in 0..6_u32 {
                let n = f64::from(power);
                assert!((moment(&row, power) - power_of_c / (n + 1.0)).abs() < ROUNDING);
                power_of_c *= c;
                // Twice integrated for positions; A² is exact to one degree less.
                if power < 5 {
                    let twice = power_of_c / ((n + 1.0) * (n + 2.0));
                    assert!((moment(&twice_row, power) - twice).abs() < ROUNDING);
                }
            }
        }
    }

    #[test]
    fn highest_coefficients_are_those_of_legendre_polynomials() {
        // P_n in u = 2c − 1 by Bonnet's recursion, n = 0 to 5: each has the coefficient one of its
        // own degree, and none of another.
        let polynomials = NODES.map(|c| {
            let u = 2.0 * c - 1.0;
            let mut values = [1.0, u, 0.0, 0.0, 0.0, 0.0];
            for n in 1..5 {
                let k = n as f64;
                values[n + 1] = ((2.0 * k + 1.0) * u * values[n] - k * values[n - 1]) / (k + 1.0);
            }
            values
        });
        for (weights, own) in LEGENDRE.iter().zip([5, 4, 3, 2]) {
            for degree in 0..STAGES {
                let coefficient: f64 = weights.iter().zip(&polynomials).map(|(w, p)| w * p[degree]).sum();
                let expected = if degree == own { 1.0 } else { 0.0 };
                // Weights up to five.
                assert!((coefficient - expected).abs() < 10.0 * ROUNDING, "{own} {degree}");
            }
        }
    }

    #[test]
    fn powers_pass_the_values_at_the_stages() {
        for (j, Lanes(column)) in POWERS.0.iter().enumerate() {
            for (i, node) in NODES.into_iter().enumerate() {
                let u = 2.0 * node - 1.0;
                let value = column.iter().rev().fold(0.0, |value, coefficient| value * u + coefficient);
                let expected = if i == j { 1.0 } else { 0.0 };
                // Coefficients up to twenty.
                assert!((value - expected).abs() < 50.0 * ROUNDING, "{i} {j}");
            }
        }
    }
}
