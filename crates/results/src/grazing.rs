//! Quantities along grazing curves.

use grazing_theorems::{GrazingPoint, ResonantPoint, auxiliary};

use crate::resonance::slopes;
use crate::{Stability, rows, tables};

rows! {
    /// A point of the grazing curve, with the grazing orbit and the Poincaré map around it.
    GrazingRow {
        arc: u32 = ARC,
        wall: u32 = WALL,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        phase: f64 = GRAZING_PHASE,
        frequency: f64 = FREQUENCY,
        a11: f64 = A11,
        a12: f64 = A12,
        a21: f64 = A21,
        a22: f64 = A22,
        b1: f64 = B1,
        b2: f64 = B2,
        tau: f64 = TAU,
        delta: f64 = DELTA,
        alpha: f64 = ALPHA,
        beta: f64 = BETA,
        gamma: f64 = GAMMA,
        phi: f64 = PHI,
        psi: f64 = PSI,
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
        a12: f64 = A12,
        kappa: f64 = KAPPA,
        a12_prime: f64 = A12_PRIME,
        kappa_prime: f64 = KAPPA_PRIME,
        xi: f64 = XI,
        s_plus: f64 = S_PLUS,
        s_minus: f64 = S_MINUS,
    }
}

tables! {
    /// Quantities along the grazing curve.
    AlongGrazing: Dimensioned {
        grazing: GrazingRow = "grazing",
            "a point of the grazing curve, with the grazing orbit and the Poincaré map around it",
        grazing_loops: GrazingLoopRow = "grazing_loops", "a point of the grazing curve and a p, with the quantities that depend on p",
    }
}

impl GrazingRow {
    /// The row of a grazing orbit with this phase of its grazing point, on the curve with a number, as a wall sees it.
    pub fn new(
        (arc, wall): (u32, u32),
        [primary, secondary]: [f64; 2],
        phase: f64,
        point: &GrazingPoint,
        (stable, admissible): (Stability, bool),
    ) -> Self {
        let map = &point.map;
        Self {
            arc,
            wall,
            secondary,
            primary,
            phase,
            frequency: point.forcing_frequency,
            a11: map.a.m11,
            a12: map.a.m12,
            a21: map.a.m21,
            a22: map.a.m22,
            b1: map.b.x,
            b2: map.b.y,
            tau: map.trace(),
            delta: map.determinant(),
            alpha: point.alpha(),
            beta: map.transversality(),
            gamma: point.gamma,
            phi: point.phi,
            psi: point.psi,
            stable,
            admissible,
        }
    }
}

impl GrazingLoopRow {
    /// The row of a point of the curve with a number, as a wall sees it.
    pub fn new((arc, wall): (u32, u32), [primary, secondary]: [f64; 2], point: &ResonantPoint) -> Self {
        let map = &point.grazing.map;
        let stability = point.stability_coefficients();
        let [a12_prime, kappa_prime] = slopes(point);
        let kappa = match point.loops() {
            1 => f64::NAN,
            loops => auxiliary::detuning(loops, map.trace(), map.determinant()),
        };
        Self {
            loops: point.loops(),
            arc,
            wall,
            secondary,
            primary,
            a12: map.a.m12,
            kappa,
            a12_prime,
            kappa_prime,
            xi: point.second_phase_derivative,
            s_plus: stability.plus,
            s_minus: stability.minus,
        }
    }
}
