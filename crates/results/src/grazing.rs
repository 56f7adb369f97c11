//! Quantities along grazing curves.

use grazing_theorems::{GrazingPoint, ResonantPoint, auxiliary};

use crate::resonance::slopes;
use crate::{Stability, row, rows, tables};

rows! {
    /// A point of the grazing curve, with the grazing orbit and the Poincaré map around it.
    GrazingRow {
        arc: u32 = ARC,
        wall: u32 = WALL,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        phase: f64 = GRAZING_PHASE,
        point: GrazingPoint,
        stable: Stability = STABLE,
        admissible: bool = ADMISSIBLE,
    }

    /// The quantities at a point of a grazing curve that depend on p.
    GrazingLoopRow {
        loops: u32 = LOOPS,
        arc: u32 = ARC,
        wall: u32 = WALL,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        point: ResonantPoint,
    }
}

row! { GrazingPoint, |point| {
    let map = &point.map;
} [
    FREQUENCY = point.forcing_frequency,
    A11 = map.a.m11,
    A12 = map.a.m12,
    A21 = map.a.m21,
    A22 = map.a.m22,
    B1 = map.b.x,
    B2 = map.b.y,
    TAU = map.trace(),
    DELTA = map.determinant(),
    ALPHA = point.alpha(),
    BETA = map.transversality(),
    GAMMA = point.gamma,
    PHI = point.phi,
    PSI = point.psi,
] }

row! { ResonantPoint, |point| {
    let map = &point.grazing.map;
    let stability = point.stability_coefficients();
    let [a12_prime, kappa_prime] = slopes(point);
    let kappa = match point.loops() {
        1 => f64::NAN,
        loops => auxiliary::detuning(loops, map.trace(), map.determinant()),
    };
} [
    A12 = map.a.m12,
    KAPPA = kappa,
    A12_PRIME = a12_prime,
    KAPPA_PRIME = kappa_prime,
    XI = point.second_phase_derivative,
    S_PLUS = stability.plus,
    S_MINUS = stability.minus,
] }

tables! {
    /// Quantities along the grazing curve.
    AlongGrazing: Dimensioned {
        grazing: GrazingRow = "grazing",
            "a point of the grazing curve, with the grazing orbit and the Poincaré map around it",
        grazing_loops: GrazingLoopRow = "grazing_loops", "a point of the grazing curve and a p, with the quantities that depend on p",
    }
}
