//! Figure 4 (fig:D): the boundaries g_p and h_p in the trapesium of stable, orientation-preserving
//! grazing orbits.

use grazing_results::sketches::{Boundary, BoundaryPoint, Figure4, Star};
use grazing_theorems::admissibility_boundary::admissibility_boundary;
use grazing_theorems::auxiliary::resonance_boundary;

use crate::{Study, StudyError};

/// Samples of each curve.
const SAMPLES: u32 = 200;

/// The corners (τ, δ) of the trapesium. Paper: eq:cT.
const CORNERS: [[f64; 2]; 4] = [[-1.0, 0.0], [1.0, 0.0], [2.0, 1.0], [-2.0, 1.0]];

impl Study {
    /// Figure 4.
    pub fn fig04(&self) -> Result<Figure4, StudyError> {
        let mut curves = Vec::new();
        for [tau, delta] in CORNERS.into_iter().chain([CORNERS[0]]) {
            curves.push(BoundaryPoint { kind: Boundary::Trapesium, loops: 0, tau, delta });
        }
        // The limit of both families as p grows: the cosine in eq:gp tends to 1, and h_p lies
        // between two of the g.
        sample(&mut curves, Boundary::Limit, 0, |delta| Ok(2.0 * delta.sqrt()))?;
        for &p in &self.parameters.fig04.get()?.loops {
            sample(&mut curves, Boundary::Resonance, p, |delta| Ok(resonance_boundary(f64::from(p), delta)))?;
            sample(&mut curves, Boundary::Admissibility, p, |delta| {
                extended_admissibility_boundary(p, delta)
            })?;
        }

        let oscillator = self.parameters.oscillator.get()?;
        let grazing = oscillator.grazing(*self.parameters.fig02_frequency.get()?)?;
        let star = Star { kind: "fig02", tau: grazing.trace(), delta: grazing.determinant() };
        Ok(Figure4 { curves, points: vec![star] })
    }
}

/// One curve from δ = 0 to δ = 1, evenly in √δ: near δ = 0 the curves are parabolas about the
/// τ-axis.
fn sample(
    curves: &mut Vec<BoundaryPoint>,
    kind: Boundary,
    loops: u32,
    tau: impl Fn(f64) -> Result<f64, StudyError>,
) -> Result<(), StudyError> {
    for k in 0..=SAMPLES {
        let root = f64::from(k) / f64::from(SAMPLES);
        let delta = root * root;
        curves.push(BoundaryPoint { kind, loops, tau: tau(delta)?, delta });
    }
    Ok(())
}

/// h_p(δ), with its limits at the ends of 0 < δ < 1, outside which h_p is not defined.
///
/// As δ → 0 it is squeezed to 0 by [`le:admissibilityBoundary`](admissibility_boundary). At δ = 1
/// the eigenvalues are e^{±iθ}, the sum H_p is T_p, which is sin((p−1)θ/2) sin(pθ/2) / (sin(θ/2)
/// sin θ), and its largest zero τ = 2 cos θ is at θ = 2π/p: the limit is g_{p/2}(1).
fn extended_admissibility_boundary(p: u32, delta: f64) -> Result<f64, StudyError> {
    if delta == 0.0 {
        return Ok(0.0);
    }
    if delta == 1.0 {
        return Ok(resonance_boundary(0.5 * f64::from(p), 1.0));
    }
    Ok(admissibility_boundary(p, delta)?)
}
