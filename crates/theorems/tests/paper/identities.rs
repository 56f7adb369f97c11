//! The algebra of the paper's proofs, for all p at once.
//!
//! p enters through symbols: λ₁^p and λ₂^p, or the factors of modulus and argument, E_p, or p
//! itself. A statement for every p follows by induction from an identity between rational functions
//! of these symbols, and such an identity is proved by exact fractions: once cleared of its
//! denominators it states that a polynomial is zero, and a polynomial that is zero at all points of
//! a grid with more values of each variable than its degree in that variable is the zero
//! polynomial. Grids avoid the zeros of denominators. Trigonometric functions are written with
//! `z = e^{iθ}`; as identities between Laurent polynomials in z they are tested at rational z.

use num_rational::Ratio;

type Exact = Ratio<i128>;

fn whole(n: i128) -> Exact {
    Exact::from_integer(n)
}

/// Checks that both sides agree on a grid, which has for each variable one value more than its
/// degree, from its first value on.
fn identity<const N: usize, const M: usize>(
    variables: [(i128, i128); N],
    sides: impl Fn([Exact; N]) -> [[Exact; M]; 2],
) {
    let points = variables.iter().map(|(_, degree)| degree + 1).product::<i128>();
    for point in 0..points {
        let mut rest = point;
        let at = variables.map(|(first, degree)| {
            let value = whole(first + rest % (degree + 1));
            rest /= degree + 1;
            value
        });
        let [left, right] = sides(at);
        assert_eq!(left, right, "at {at:?}");
    }
}

/// The sum S_p, from λ₁, λ₂ and their p-th powers.
fn s([a, b]: [Exact; 2], [p, q]: [Exact; 2]) -> Exact {
    (p - q) / (a - b)
}

/// The sum T_p by eq:Tp3.
fn t([a, b]: [Exact; 2], [p, q]: [Exact; 2]) -> Exact {
    let one = whole(1);
    (a - b - (p - q) + b * p - a * q) / ((one - a) * (one - b) * (a - b))
}

/// The sum H_p by eq:Hp3.
fn h([a, b]: [Exact; 2], [p, q]: [Exact; 2]) -> Exact {
    let one = whole(1);
    let (before, last) = ([p / a, q / b], p * q / (a * b));
    (last * (a - b) - (p - q) + (before[0] - before[1])) / ((one - a) * (one - b) * (a - b) * last / (a * b))
}

/// The powers for p + 1 from those for p.
fn next([a, b]: [Exact; 2], [p, q]: [Exact; 2]) -> [Exact; 2] {
    [a * p, b * q]
}

/// The variables λ₁, λ₂, λ₁^p, λ₂^p, each with its first value and the degree of the sums in it.
const POWERS: [(i128, i128); 4] = [(2, 10), (-13, 10), (14, 5), (-22, 5)];

#[test]
fn sums_of_powers_are_their_closed_forms() {
    let (one, zero) = (whole(1), whole(0));
    // For p = 1, and from p to p + 1 by the definitions eq:SpTp and eq:Hp: each inner sum of H_p is S_j/δ^(j−1).
    identity([(2, 10), (-13, 10)], |[a, b]| {
        [[s([a, b], [a, b]), t([a, b], [a, b]), h([a, b], [a, b])], [one, zero, zero]]
    });
    identity(POWERS, |[a, b, p, q]| {
        let (at, now) = ([a, b], [p, q]);
        let then = next(at, now);
        let inner = |powers: [Exact; 2]| s(at, powers) * a * b / (powers[0] * powers[1]);
        [
            [s(at, then), t(at, then), inner(then), h(at, then)],
            [a * s(at, now) + q, t(at, now) + s(at, now), inner(now) / a + one / q, h(at, now) + inner(now)],
        ]
    });
}

#[test]
fn powers_of_the_map_are_as_stated() {
    let one = whole(1);
    // A has the eigenvalues a and b: a₁₁ and a₁₂ are free. eq:Hp9, eq:Ap, eq:b1pb2p.
    identity(POWERS, |[a, b, p, q]| {
        let (at, now) = ([a, b], [p, q]);
        let before = [p / a, q / b];
        let product = s(at, before) * t(at, now) - s(at, now) * t(at, before);
        [[product], [h(at, now) * p * q / (a * b * a * b)]]
    });
    let variables = [(2, 6), (-8, 6), (11, 1), (-13, 1), (3, 4), (5, 3), (1, 1), (1, 1)];
    identity(variables, |[a, b, p, q, a11, a12, b1, b2]| {
        let (at, now) = ([a, b], [p, q]);
        let then = next(at, now);
        let a22 = a + b - a11;
        let a21 = (a11 * a22 - a * b) / a12;
        let power = |now: [Exact; 2]| {
            let (sum, after) = (s(at, now), s(at, next(at, now)));
            [after - a22 * sum, a12 * sum, a21 * sum, after - a11 * sum]
        };
        let drift = |now: [Exact; 2]| {
            let beta = (one - a22) * b1 + a12 * b2;
            let (sum, total) = (s(at, now), t(at, now));
            [sum * b1 + total * beta, sum * b2 + total * (a21 * b1 + (one - a11) * b2)]
        };
        let ([c, d, e, f], [g, k]) = (power(now), drift(now));
        let ([x1, x2, x3, x4], [y1, y2]) = (power(then), drift(then));
        [
            [
                a11 * c + a12 * e,
                a11 * d + a12 * f,
                a21 * c + a22 * e,
                a21 * d + a22 * f,
                a11 * g + a12 * k + b1,
                a21 * g + a22 * k + b2,
            ],
            [x1, x2, x3, x4, y1, y2],
        ]
    });
}

#[test]
fn visits_are_as_stated() {
    // eq:ujcodim1proof, from eq:affineMapj with u⁽⁰⁾ = 0 and w⁽⁰⁾ = −b₁ₚ/(a₁₂β): S_p, T_p, S_j, T_j are free.
    identity([(1, 2), (1, 2), (1, 2), (1, 2), (1, 1), (1, 1), (1, 1)], |[sp, tp, sj, tj, b1, beta, a12]| {
        let start = -(sp * b1 + tp * beta) / (a12 * beta);
        [[a12 * sj * start + sp / beta * (sj * b1 + tj * beta)], [sp * tj - sj * tp]]
    });
    // eq:upm1codim1proof: u⁽ᵖ⁻¹⁾ = −δ^(p−2) H_p.
    identity(POWERS, |[a, b, p, q]| {
        let (at, now, before) = ([a, b], [p, q], [p / a, q / b]);
        let visit = s(at, now) * t(at, before) - s(at, before) * t(at, now);
        [[visit], [-h(at, now) * p * q / (a * b * a * b)]]
    });
    // eq:ujeig1, λ₁ = 1: δ, δ^p, δ^j, p and j. First T_p, by induction, from T_1 = 0.
    let one = whole(1);
    let sum = |delta: Exact, power: Exact| (one - power) / (one - delta);
    let total = |delta: Exact, power: Exact, p: Exact| {
        (p * (one - delta) - (one - power)) / ((one - delta) * (one - delta))
    };
    identity([(2, 4)], |[delta]| [[total(delta, delta, one)], [whole(0)]]);
    identity([(2, 4), (2, 2), (3, 2)], |[delta, power, p]| {
        [[total(delta, delta * power, p + one)], [total(delta, power, p) + sum(delta, power)]]
    });
    identity([(2, 5), (2, 2), (3, 2), (5, 2), (4, 2)], |[delta, dp, dj, p, j]| {
        let visit = sum(delta, dp) * total(delta, dj, j) - sum(delta, dj) * total(delta, dp, p);
        [[visit], [(j * (one - dp) - p * (one - dj)) / ((one - delta) * (one - delta))]]
    });
}

/// 2 i sin of an angle, by `z = e^{iθ}`.
fn sine(z: Exact) -> Exact {
    z - whole(1) / z
}

fn cosine(z: Exact) -> Exact {
    z + whole(1) / z
}

#[test]
fn complex_eigenvalues_give_the_forms_with_sines() {
    let one = whole(1);
    // r, e^{iθ}, r^p, e^{ipθ}: eq:Sp3, eq:Tp6, eq:Hp5, from p to p + 1.
    let sum = |[r, z]: [Exact; 2], [power, turned]: [Exact; 2]| power / r * sine(turned) / sine(z);
    let gap = |r: Exact, z: Exact| r * r - r * cosine(z) + one;
    let total = |[r, z]: [Exact; 2], [power, turned]: [Exact; 2]| {
        (sine(z) - power / r * sine(turned) + power * sine(turned / z)) / (gap(r, z) * sine(z))
    };
    let weighted = |[r, z]: [Exact; 2], [power, turned]: [Exact; 2]| {
        (power * sine(z) - r * sine(turned) + sine(turned / z)) / (gap(r, z) * power / (r * r) * sine(z))
    };
    identity([(2, 8), (12, 14)], |[r, z]| {
        let at = [r, z];
        [[sum(at, at), total(at, at), weighted(at, at)], [one, whole(0), whole(0)]]
    });
    identity([(2, 8), (12, 14), (3, 4), (2, 8)], |[r, z, power, turned]| {
        let (at, now) = ([r, z], [power, turned]);
        let (then, before) = ([r * power, z * turned], [power / r, turned / z]);
        let recurrence = sum(at, then) - r * cosine(z) * sum(at, now) + r * r * sum(at, before);
        [
            [recurrence, total(at, then), weighted(at, then)],
            [
                whole(0),
                total(at, now) + sum(at, now),
                weighted(at, now) + sum(at, now) * r * r / (power * power),
            ],
        ]
    });
    // At pθ = 2π and pθ = π: lemmas le:admissibilityBoundary and le:SpTp (b).
    identity([(2, 8), (12, 14), (3, 4)], |[r, z, power]| {
        let (at, turn, half) = ([r, z], [power, one], [power, -one]);
        let after = sum(at, [r * power, -z]);
        [
            [weighted(at, turn), after, total(at, half)],
            [(power - one) / (gap(r, z) * power / (r * r)), -power, (one + power) / gap(r, z)],
        ]
    });
    // Ξ: three sines of half-angles have (2i)³ = −4 · 2i.
    identity([(2, 12), (3, 12)], |[half, turned]| {
        let (z, w) = (half * half, turned * turned);
        [[sine(z) - sine(w) + sine(w / z)], [-sine(half) * sine(turned / half) * sine(turned)]]
    });
    // eq:fp, by ∂S_p/∂η at pθ = π and κ_p' = −2 r sin θ θ': r, r^p, sin θ, θ', p.
    identity([(2, 3), (3, 2), (2, 3), (1, 2), (2, 2)], |[r, power, sin, slope, p]| {
        let kappa = -whole(2) * r * sin * slope;
        [[-(power / r) * p * slope / sin], [p * power / (r * r) * kappa / (whole(2) * sin * sin)]]
    });
}

/// The coefficient s^±, eq:c1; for p ≥ 2 (eq:cp) both diagonal entries are −δ^(p/2).
fn stability([a11, a22, phi, alpha, omega, gamma, xi]: [Exact; 7], sign: Exact) -> Exact {
    let one = whole(1);
    (one - sign * a22) * (a11 * phi * phi - sign) + alpha * alpha * omega * omega * xi / ((one - a22) * gamma)
}

#[test]
fn expansions_give_the_coefficients_of_both_curves() {
    let (one, two) = (whole(1), whole(2));
    // eq:k1231 and, with a₁₁ = a₂₂ = −δ^(p/2), T_p β instead of b₁ and f_p instead of a₁₂',
    // eq:k123p: X₁ = X₂ = X₃ = 0, and the coefficients of y Ψ^± are those of eq:Upsilon1 and
    // eq:Upsilonp.
    let variables = [(3, 2), (2, 4), (1, 2), (2, 4), (1, 3), (1, 4), (1, 1), (1, 1), (1, 1)];
    identity(variables, |[a11, a22, phi, alpha, omega, gamma, xi, b1, slope]| {
        let numbers = [a11, a22, phi, alpha, omega, gamma, xi];
        let plus = stability(numbers, one);
        let room = (one - a22) * gamma;
        let k1 = omega * (a22 * (one - alpha) - one) / room;
        let (k2, k3) = (-plus / (two * room * b1), alpha * omega * slope / (room * b1));
        let phase = k1 + (one - alpha) * omega / gamma;
        let x1 = -(one - a22) * k1 + omega / gamma * (a22 * (one - alpha) - one);
        let x2 = b1 * k2 + (a11 * phi * phi - one) / (two * gamma) + xi / two * phase * phase;
        let x3 = b1 * k3 + slope * phase;
        let trace = a11 * phi * phi + a22
            - alpha * xi * omega * omega * (one - alpha) / gamma
            - alpha * omega * xi * k1;
        let determinant = phi * phi * a11 * a22;
        let psi = |sign: Exact| trace - sign * determinant - sign;
        let zero = whole(0);
        [[x1, x2, x3, psi(one), psi(-one)], [zero, zero, zero, plus, stability(numbers, -one)]]
    });
    // eq:coeffs1 from M at Υ^±, with β = b₁(1 − a₂₂) where a₁₂ = 0; and eq:coeffsp, where T_p = (1 + δ^(p/2))/(δ − τ + 1).
    identity([(1, 3), (3, 4), (1, 2), (1, 3), (1, 2)], |[plus, minus, beta, gamma, f]| {
        let (k2, k3) = (-plus / (two * beta * gamma), f / (beta * gamma));
        let curve = |velocity: Exact| k2 * velocity * velocity + k3 * velocity;
        let (saddle_node, ratio) = (f * f / (two * beta * gamma * plus), plus / minus);
        [[curve(f / plus), curve(f / minus)], [saddle_node, ratio * (two - ratio) * saddle_node]]
    });
    let variables = [(1, 2), (2, 4), (1, 2), (1, 2), (1, 2), (1, 2), (2, 2)];
    identity(variables, |[f, power, beta, gamma, plus, gap, sin]| {
        // f: p a₁₂ α ω δ^(p/2−1) κ_p'.
        let slope = f / (two * sin * sin);
        let total = (one + power) / gap;
        let squared = f / (two * sin * sin * (one + power));
        [
            [slope * slope / (two * (one + power) * total * beta * gamma * plus)],
            [squared * squared * gap / (two * beta * gamma * plus)],
        ]
    });
}

#[test]
fn the_linear_oscillator_has_the_formulas_of_the_propositions() {
    let (one, two) = (whole(1), whole(2));
    // Flow over p periods: E, cos, sin, k = ζ/ω₁, ω₁, ω. With X' = 0, Y' = X'' = ω², Y'' = 0 for the start's distance from
    // forced motion at grazing, ∂²φ/∂t₀² = −2 Φ₁₂' Y' + Φ₁₁ X'', Φ₁₂' = Φ₂₂; eq:d2phidt02, eq:xi1proof2, eq:xipproof2, and eq:oscA.
    identity([(1, 2), (2, 2), (3, 2), (1, 2), (2, 2), (3, 2)], |[e, cos, sin, k, omega_1, omega]| {
        let square = omega * omega;
        let [phi_11, phi_12, phi_21, phi_22] =
            [e * (cos + k * sin), e * sin / omega_1, -e * sin / omega_1, e * (cos - k * sin)];
        let bend = square * (phi_11 - two * phi_22);
        // φ̇ = 0, φ̈ = −ω²; eq:Abproof3.
        let [a11, a12, a21, a22] =
            [phi_11, phi_12 * square / omega, phi_21 / omega, phi_22 * square / square];
        let xi = (a22 * a22 * -square + two * a22 * phi_22 * square + bend) / square;
        [
            [bend, xi, a11, a12, a21, a22],
            [
                -square * e * (cos - whole(3) * k * sin),
                e * e * (cos - k * sin) * (cos - k * sin) - e * (cos - whole(3) * k * sin),
                e * (cos + k * sin),
                omega / omega_1 * e * sin,
                -e * sin / (omega_1 * omega),
                e * (cos - k * sin),
            ],
        ]
    });
    // At resonance σ = E cos: s^± = ∓(1 ± εσ)² (eq:xi1proof4, eq:xipproof4).
    identity([(2, 6), (1, 4), (1, 6)], |[sigma, epsilon, omega]| {
        let xi = sigma * sigma - sigma;
        let numbers = [sigma, sigma, epsilon, one + epsilon, omega, omega * omega, xi];
        let closed = |sign: Exact| -sign * (one + sign * epsilon * sigma) * (one + sign * epsilon * sigma);
        [[stability(numbers, one), stability(numbers, -one)], [closed(one), closed(-one)]]
    });
    // c_PD of either proposition, by q = εσ.
    identity([(2, 12)], |[q]| {
        let (plus, minus) = (-(one + q) * (one + q), (one - q) * (one - q));
        let ratio = plus / minus;
        let bracket = (one - q) * (one - q) + two * (one + q * q);
        [[ratio * (two - ratio)], [-(one + q) * (one + q) * bracket / (minus * minus)]]
    });
    // c_SN for p = 1: σ, ε, ω, 𝒜_graz, π, with a₁₂' = −2πσ/ω and β = (1 − σ)²/𝒜_graz.
    identity([(2, 6), (1, 6), (1, 6), (1, 2), (1, 2)], |[sigma, epsilon, omega, amplitude, pi]| {
        let (alpha, slope) = (one + epsilon, -two * pi * sigma / omega);
        let beta = (one - sigma) * (one - sigma) / amplitude;
        let plus = -(one + epsilon * sigma) * (one + epsilon * sigma);
        let shared = alpha * sigma / ((one + epsilon * sigma) * (one - sigma));
        [
            [(alpha * omega * slope) * (alpha * omega * slope) / (two * beta * omega * omega * plus)],
            [-two * pi * pi * amplitude / (omega * omega) * shared * shared],
        ]
    });
    // c_SN for p ≥ 2: first p a₁₂ α ω δ^(p/2−1) κ_p'/(2 sin² (1 + E_p)), with E_p, ε, ω, ω₁, E₁, sin(π/p) and p.
    let pi = whole(5);
    let variables = [(2, 3), (1, 1), (1, 4), (1, 2), (2, 4), (2, 4), (2, 1)];
    identity(variables, |[e, epsilon, omega, omega_1, e_1, sin, p]| {
        let kappa = whole(4) * pi * omega_1 / (omega * omega) * e_1 * sin;
        let a12 = omega / omega_1 * e_1 * sin;
        let left = p * a12 * (one + epsilon) * omega * e / (e_1 * e_1) * kappa;
        [[left / (two * sin * sin * (one + e))], [two * pi * p * (one + epsilon) * e / (one + e)]]
    });
    // Then the coefficient, with β = (δ − τ + 1)/𝒜_graz.
    let variables = [(2, 8), (1, 6), (1, 4), (2, 2), (1, 2), (1, 2)];
    identity(variables, |[e, epsilon, omega, p, amplitude, gap]| {
        let slope = two * pi * p * (one + epsilon) * e / (one + e);
        let plus = -(one - epsilon * e) * (one - epsilon * e);
        let shared = (one + epsilon) * e / ((one - epsilon * e) * (one + e));
        [
            [slope * slope * gap / (two * (gap / amplitude) * omega * omega * plus)],
            [-two * pi * pi * p * p * amplitude / (omega * omega) * shared * shared],
        ]
    });
}
