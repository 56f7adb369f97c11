//! Points at which a single hypothesis fails, and what the theorems answer.

use grazing_theorems::hypothesis::Quantity;
use grazing_theorems::{
    GenericGrazing, GrazingPoint, HypothesesViolated, LinearisedMap, ResonantGrazing, ResonantPoint,
    Unfolding,
};
use nalgebra::{Matrix2, Vector2};

use crate::tally::Votes;

fn point([a11, a12, a21, a22]: [f64; 4]) -> GrazingPoint {
    GrazingPoint {
        map: LinearisedMap { a: Matrix2::new(a11, a12, a21, a22), b: Vector2::new(1.0, 0.5) },
        forcing_frequency: 1.0,
        gamma: 1.0,
        phi: 0.5,
        psi: 0.0,
    }
}

/// Points that differ from a good one in what the four theorems have in common.
fn common(good: [f64; 4], expanding: [f64; 4]) -> Vec<(GrazingPoint, Quantity)> {
    let base = point(good);
    // δ < 0; trace 2 with δ = 0.5.
    let mut reversing = good;
    reversing[2] = -good[2];
    vec![
        (GrazingPoint { forcing_frequency: -1.0, ..base }, Quantity::ForcingFrequency),
        (GrazingPoint { gamma: -1.0, ..base }, Quantity::Deceleration),
        (GrazingPoint { phi: -0.5, ..base }, Quantity::Restitution),
        (point(expanding), Quantity::Contraction),
        (point(reversing), Quantity::Determinant),
    ]
}

fn without_motion(good: [f64; 4]) -> GrazingPoint {
    let base = point(good);
    GrazingPoint { map: LinearisedMap { b: Vector2::zeros(), ..base.map }, ..base }
}

/// δ = 0.49, τ = 0.6, a₁₂ > 0: all hypotheses of theorems 2.2 and 2.3 hold for p = 1, 2, 3.
const GENERIC: [f64; 4] = [0.3, 0.8, -0.5, 0.3];
/// δ = 1.69.
const EXPANDING: [f64; 4] = [0.3, 1.6, -1.0, 0.3];
/// τ = 2, δ = 0.5.
const UNSTABLE: [f64; 4] = [1.0, 0.5, 1.0, 1.0];
/// a₁₂ = 0.
const ONE_LOOP: [f64; 4] = [0.3, 0.0, -0.5, 0.3];
/// τ = 0 = g₂, δ = 0.5.
const TWO_LOOP: [f64; 4] = [0.25, 0.75, -0.75, -0.25];
/// a₁₂ = 0 and δ = 0.25, in powers of two.
const DYADIC: [f64; 4] = [-0.5, 0.0, 0.0, -0.5];
/// ψ for which α < 0.
const LONG: f64 = 3.0;

/// Theorem 2.2 (p = 1) or 2.3 names what fails.
pub(super) fn generic(count: &mut Votes, p: u32) {
    let base = point(GENERIC);
    count.see(GenericGrazing::check(&base, p).is_ok());
    let mut list = common(GENERIC, EXPANDING);
    list.push((point(UNSTABLE), Quantity::StabilityMargin));
    let slow = GrazingPoint { psi: LONG, ..base };
    if p == 1 {
        list.extend([
            (slow, Quantity::SquareRootFactor),
            (point(ONE_LOOP), Quantity::OffDiagonalTimesTransversality),
            (without_motion(GENERIC), Quantity::OffDiagonalTimesTransversality),
        ]);
    } else {
        list.extend([
            (slow, Quantity::OffDiagonalTimesSquareRootFactor),
            (without_motion(GENERIC), Quantity::TransversalityTimesDetuning),
        ]);
    }
    if p == 2 {
        list.push((point(TWO_LOOP), Quantity::TransversalityTimesDetuning));
        count.see(names(GenericGrazing::check(&base, 0), Quantity::Loops));
    }
    if p == 3 {
        // τ = −0.6 < h₃ = −δ.
        list.push((point([-0.3, 0.8, -0.5, -0.3]), Quantity::AdmissibilityMargin));
    }
    for (point, quantity) in list {
        count.see(names(GenericGrazing::check(&point, p), quantity));
    }
}

/// Theorem 2.4 (p = 1) or 2.5 (p = 2) names what fails.
pub(super) fn resonant(count: &mut Votes, p: u32) {
    let good = if p == 1 { ONE_LOOP } else { TWO_LOOP };
    let unfolding = |derivative: f64| match p {
        1 => Unfolding::OneLoop { off_diagonal_derivative: derivative },
        _ => Unfolding::MultiLoop { loops: p, detuning_derivative: derivative },
    };
    let with = |grazing: GrazingPoint, second_phase_derivative: f64, derivative: f64| ResonantPoint {
        grazing,
        second_phase_derivative,
        unfolding: unfolding(derivative),
    };
    let base = point(good);
    count.see(ResonantGrazing::check(&with(base, 0.1, 1.0), 0.0).is_ok());
    let expanding = if p == 1 { [1.5, 0.0, 0.0, 1.2] } else { [0.5, 1.5, -1.0, -0.5] };
    let mut list: Vec<_> = common(good, expanding)
        .into_iter()
        // With a₁₂ = 0 the lower left entry does not matter for δ.
        .filter(|(_, quantity)| p == 2 || *quantity != Quantity::Determinant)
        .map(|(point, quantity)| (with(point, 0.1, 1.0), quantity))
        .collect();
    let slow = with(GrazingPoint { psi: LONG, ..base }, 0.1, 1.0);
    let dyadic = GrazingPoint { phi: 1.0, ..point(if p == 1 { DYADIC } else { TWO_LOOP }) };
    list.extend([
        (with(without_motion(good), 0.1, 1.0), Quantity::Transversality),
        // α = 2, and s⁺ = −9/4 + 8ξ/3, s⁻ = 1/4 + 8ξ/3 for either p.
        (with(dyadic, 27.0 / 32.0, 1.0), Quantity::SaddleNodeStability),
        (with(dyadic, -3.0 / 32.0, 1.0), Quantity::PeriodDoublingStability),
    ]);
    if p == 1 {
        list.extend([
            (with(point([0.3, 0.0, 0.0, -0.3]), 0.1, 1.0), Quantity::Determinant),
            (with(point([-1.5, 0.0, 0.0, -0.4]), 0.1, 1.0), Quantity::StabilityMargin),
            (slow, Quantity::SquareRootFactor),
            (with(point(GENERIC), 0.1, 1.0), Quantity::OffDiagonal),
            (with(base, 0.1, 0.0), Quantity::OffDiagonalDerivative),
        ]);
    } else {
        list.extend([
            (slow, Quantity::OffDiagonalTimesSquareRootFactor),
            (with(point(GENERIC), 0.1, 1.0), Quantity::Detuning),
            (with(base, 0.1, 0.0), Quantity::DetuningDerivative),
        ]);
    }
    for (point, quantity) in list {
        count.see(names(ResonantGrazing::check(&point, 0.0), quantity));
    }
}

/// The answer names the quantity, and no other that does not depend on it.
fn names<T>(answer: Result<T, HypothesesViolated>, quantity: Quantity) -> bool {
    let Err(answer) = answer else { return false };
    // δ < 0 leaves κ_p and E_p without a value, and p = 0 leaves g_p without one.
    let follows = |other: Quantity| match quantity {
        Quantity::Determinant | Quantity::Loops => matches!(
            other,
            Quantity::TransversalityTimesDetuning
                | Quantity::Detuning
                | Quantity::SaddleNodeStability
                | Quantity::PeriodDoublingStability
        ),
        _ => false,
    };
    let violated: Vec<Quantity> = answer.violated().map(|hypothesis| hypothesis.quantity).collect();
    violated.contains(&quantity) && violated.iter().all(|other| *other == quantity || follows(*other))
}
