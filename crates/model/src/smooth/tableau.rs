//! Coefficients of Gauss's collocation for ẍ = F(x, ẋ, t): six points, order 12.
//!
//! Source: E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*, 2nd edition, section II.7; the
//! nodes are the zeros of the Legendre polynomial of degree six, shifted to the unit interval, and the other coefficients
//! integrals of Lagrange's polynomials on them, computed to 50 digits and rounded. Tests hold them to the conditions that define them.

use super::stages::{Matrix, STAGES};

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
pub(super) static MATRIX: Matrix = Matrix::from_rows([
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
pub(super) static SQUARE: Matrix = Matrix::from_rows([
    [
        0.0009062542019565115,
        -0.000728597116125314,
        0.0007910269586116769,
        -0.0007067539021853538,
        0.0004564771422405692,
        -0.00014836147050330408,
    ],
    [
        0.011272367531794366,
        0.00390834824478407,
        -0.0014724868010943912,
        0.001099266905658843,
        -0.0006768904072940142,
        0.0002167795034717414,
    ],
    [
        0.030008019623627546,
        0.036978289259468146,
        0.0065490339168957825,
        -0.0016615098173008262,
        0.0008475346186204161,
        -0.0002587746262343742,
    ],
    [
        0.0499002696506509,
        0.08200342744527161,
        0.05416511129506007,
        0.0065490339168957825,
        -0.0011352871017627473,
        0.0002896308105595239,
    ],
    [
        0.06847583667161725,
        0.11859257878058808,
        0.10635984886129551,
        0.04796147404218138,
        0.00390834824478407,
        -0.0003460083900134244,
    ],
    [
        0.07972907161944999,
        0.1441910039270223,
        0.13628542646896577,
        0.0819565862174019,
        0.023736460480774324,
        0.0009062542019565115,
    ],
]);

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
pub(super) const POSITION_WEIGHTS: [f64; STAGES] = [
    0.08276983963976924,
    0.1498251278559757,
    0.14489179419935322,
    0.08906517308699231,
    0.030555658668093604,
    0.0028924065498159377,
];

/// The coefficients of a function in Legendre polynomials on the step, of degrees five to two: (2n + 1) b P_n(2c − 1).
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

/// The factors of Lagrange's polynomials on the stages: 1/((c_j − c_1) ⋯ (c_j − c_6)), without the factor that is zero.
pub(super) const LAGRANGE: [f64; STAGES] = [
    -48.847570374052054,
    147.20243244417318,
    -217.01004297283262,
    217.01004297283262,
    -147.20243244417318,
    48.847570374052054,
];

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
        // P_n in u = 2c − 1 by Bonnet's recursion, n = 0 to 5: each has the coefficient one of its own degree, and none of another.
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
    fn lagranges_polynomials_are_one_at_their_own_stage() {
        for (j, factor) in LAGRANGE.into_iter().enumerate() {
            let others = (0..STAGES).filter(|&k| k != j);
            let product = others.fold(factor, |product, k| product * (NODES[j] - NODES[k]));
            // Five differences of rounded nodes, the smallest of 0.1.
            assert!((product - 1.0).abs() < 10.0 * ROUNDING);
        }
    }
}
