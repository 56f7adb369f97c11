//! Figure 4 (fig:D): the boundaries g_p and h_p in the trapesium of stable, orientation-preserving grazing orbits.

use grazing_theorems::admissibility_boundary::admissibility_boundary;
use grazing_theorems::auxiliary::resonance_boundary;

use crate::StudyError;
use crate::parameters::Parameters;
use crate::table::{Columns, Table, columns, row};

/// The frames of Figure 4.
#[derive(Clone, Debug)]
pub struct Figure4 {
    /// `fig04_curves`: the trapesium's outline, the curves τ = g_p(δ) and τ = h_p(δ), and their limit τ = 2√δ.
    pub curves: Table,
    /// `fig04_points`: the grazing bifurcation of Figure 2.
    pub points: Table,
}

/// Samples of each curve.
const SAMPLES: u32 = 200;

/// The corners (τ, δ) of the trapesium. Paper: eq:cT.
const CORNERS: [[f64; 2]; 4] = [[-1.0, 0.0], [1.0, 0.0], [2.0, 1.0], [-2.0, 1.0]];

impl Figure4 {
    /// All tables.
    pub fn tables(&self) -> Vec<Table> {
        vec![self.curves.clone(), self.points.clone()]
    }

    pub(crate) fn compute(parameters: &Parameters) -> Result<Self, StudyError> {
        let mut curves = columns! { "kind": "", "p": 0, "tau": 0.0, "delta": 0.0 };
        for [tau, delta] in CORNERS.into_iter().chain([CORNERS[0]]) {
            curves.push(row!["trapesium", 0, tau, delta]);
        }
        // The limit of both families as p grows: the cosine in eq:gp tends to 1, and h_p lies between two of the g.
        sample(&mut curves, "limit", 0, |delta| Ok(2.0 * delta.sqrt()))?;
        for &p in parameters.fig04()?.loops() {
            sample(&mut curves, "g", p, |delta| Ok(resonance_boundary(f64::from(p), delta)))?;
            sample(&mut curves, "h", p, |delta| extended_admissibility_boundary(p, delta))?;
        }

        let oscillator = parameters.oscillator()?;
        let grazing = oscillator.grazing(parameters.fig02_frequency()?)?;
        let mut points = columns! { "kind": "", "tau": 0.0, "delta": 0.0 };
        points.push(row!["fig02", grazing.trace(), grazing.determinant()]);
        Ok(Self { curves: curves.finish("fig04_curves")?, points: points.finish("fig04_points")? })
    }
}

/// One curve from δ = 0 to δ = 1, evenly in √δ: near δ = 0 the curves are parabolas about the τ-axis.
fn sample(
    columns: &mut Columns,
    kind: &'static str,
    p: u32,
    tau: impl Fn(f64) -> Result<f64, StudyError>,
) -> Result<(), StudyError> {
    for k in 0..=SAMPLES {
        let root = f64::from(k) / f64::from(SAMPLES);
        let delta = root * root;
        columns.push(row![kind, p, tau(delta)?, delta]);
    }
    Ok(())
}

/// h_p(δ), with its limits at the ends of 0 < δ < 1, outside which h_p is not defined.
///
/// As δ → 0 it is squeezed to 0 by [`le:admissibilityBoundary`](admissibility_boundary). At δ = 1 the eigenvalues are
/// e^{±iθ}, the sum H_p is T_p, which is sin((p−1)θ/2) sin(pθ/2) / (sin(θ/2) sin θ), and its largest zero τ = 2 cos θ
/// is at θ = 2π/p: the limit is g_{p/2}(1).
fn extended_admissibility_boundary(p: u32, delta: f64) -> Result<f64, StudyError> {
    if delta == 0.0 {
        return Ok(0.0);
    }
    if delta == 1.0 {
        return Ok(resonance_boundary(0.5 * f64::from(p), 1.0));
    }
    Ok(admissibility_boundary(p, delta)?)
}
