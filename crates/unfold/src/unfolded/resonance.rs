//! A resonance with the results for the curves that leave it.

use crate::Diagram;
use crate::magnification::{magnify, window_about};
use crate::resonances::FoundResonance;
use crate::straightened::{self, straighten};
use crate::verdict::{Coefficient, coefficients_on, near};
use crate::verification::{Simulated, simulate};
use grazing_continuation::bifurcation::{Bifurcation, Pair};
use grazing_continuation::curve::Window;
use grazing_continuation::fit::{CoefficientError, Straightened};
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::ImpactOscillator;
use grazing_model::smooth::Units;
use grazing_results::plane::{MagnifiedPanel, MagnifiedPoint, StraightenedCurves, StraightenedPoint};
use grazing_results::{Dimensioned, brief, dimensioned};
use grazing_theorems::ResonantPoint;
use grazing_theorems::hypothesis::{Hypothesis, Theorem};

use crate::described::Axes;
use crate::limit_map::measured_doubled_grazing;

/// A resonant grazing bifurcation with its results.
#[derive(Clone, Debug)]
pub struct AtResonance {
    /// Number of loops p.
    pub loops: u32,
    /// The number of the wall that grazing motion touches, 1 or 2, if there are two; 0 otherwise.
    pub wall: u32,
    /// The integer n.
    pub n: u32,
    /// Primary and secondary parameter.
    pub parameters: [f64; 2],
    /// The resonance with the quantities that the theorem uses.
    pub point: ResonantPoint,
    /// The theorem that applies to this p: Theorem 2.4 or 2.5.
    pub theorem: Theorem,
    /// The hypotheses of the theorem, which applies if all hold.
    pub hypotheses: Vec<Hypothesis>,
    /// The results for the curves that leave the resonance, if the theorem applies.
    pub curves: Option<Curves>,
}

/// Relative difference of resonances at like walls, which are located to some 10⁻¹⁰.
const ALIKE: f64 = 1e-6;

impl AtResonance {
    /// A resonance as a wall sees it, dimensionless, without results for its curves.
    pub fn new(resonance: &FoundResonance, wall: u32) -> Self {
        let FoundResonance { loops, n, located, theorem } = resonance;
        let (theorem, hypotheses) = match theorem {
            Ok(point) => (point.theorem().theorem(), point.theorem().hypotheses()),
            Err(violated) => (violated.theorem, violated.hypotheses.as_slice()),
        };
        Self {
            loops: *loops,
            wall,
            n: *n,
            parameters: located.orbit().oscillator().parameters(),
            point: *located.resonant_point(),
            theorem,
            hypotheses: hypotheses.to_vec(),
            curves: None,
        }
    }

    /// Whether it is the same at another wall, which is alike.
    pub fn is_like(&self, other: &Self) -> bool {
        let near = |(one, another): (f64, f64)| (one - another).abs() <= ALIKE * one.abs();
        (self.loops, self.n) == (other.loops, other.n)
            && self.parameters.into_iter().zip(other.parameters).all(near)
            && near((self.point.saddle_node_coefficient(), other.point.saddle_node_coefficient()))
    }

    /// Its wall, after other words: ` at wall 2`; nothing if there is one wall.
    pub fn at_wall(&self) -> String {
        if self.wall == 0 { String::new() } else { format!(" at wall {}", self.wall) }
    }

    /// The hypotheses that fail, with their values; none if the theorem applies.
    pub fn failing(&self) -> impl Iterator<Item = String> {
        let failing = self.hypotheses.iter().filter(|hypothesis| !hypothesis.holds());
        failing.map(|failing| format!("{} fails: {}", failing.statement(), brief(failing.value, 4)))
    }
}

/// The results for the curves that leave a resonance.
#[derive(Clone, Debug)]
pub struct Curves {
    /// The results for the SN and the PD curve.
    pub findings: Pair<CurveFinding>,
    /// c_2GZ, measured on grazing orbits of twice the period; NaN where none are found.
    pub doubled_grazing: f64,
    /// The window of the magnification.
    pub window: Window,
    /// The curves in the magnification; empty if they could not be followed.
    pub magnified: Vec<MagnifiedPoint>,
    /// The curves in straightened coordinates.
    pub straightened: Vec<StraightenedPoint>,
}

/// The results for an SN or PD curve.
#[derive(Clone, Copy, Debug)]
pub struct CurveFinding {
    /// The coefficient of the curve, by the theorem and measured.
    pub coefficient: Coefficient,
    /// The behaviour of the simulated hybrid system beside the curve.
    pub simulated: Simulated,
}

impl CurveFinding {
    /// The results that differ from the prediction or are unknown, each with the reason.
    pub fn doubts(&self) -> impl Iterator<Item = (String, String)> + use<> {
        let (verdict, simulated) = (self.coefficient.verdict(), self.simulated);
        let both = [
            (verdict.name().to_owned(), verdict.reason()),
            (format!("simulation {}", simulated.name()), simulated.reason()),
        ];
        both.into_iter().filter(|(_, reason)| !reason.is_empty())
    }
}

/// The SN and PD curves of all these resonances, each with the resonance that it leaves.
pub fn curves(
    resonances: &[AtResonance],
) -> impl Iterator<Item = (&AtResonance, Bifurcation, &CurveFinding)> {
    let unfolded = resonances.iter().filter_map(|at| Some((at, at.curves.as_ref()?)));
    unfolded.flat_map(|(at, curves)| curves.findings.as_ref().named().map(|(kind, known)| (at, kind, known)))
}

/// Computes the results for the curves that leave a resonance, dimensionless; straightened curves at round numbers in
/// these units.
pub(super) fn curves_from(
    diagram: &Diagram,
    resonance: &FoundResonance,
    point: &ResonantGrazingPoint,
    units: &Units,
) -> Curves {
    let near = near(point);
    let coefficients = coefficients_on(point, &near);
    let finding = |(kind, coefficient): (Bifurcation, &Coefficient)| CurveFinding {
        coefficient: *coefficient,
        simulated: simulate(point, kind, &coefficients),
    };
    let window = window_about(diagram, resonance, point);
    Curves {
        findings: Pair::BIFURCATIONS.zip(coefficients.as_ref()).map(finding),
        doubled_grazing: measured_doubled_grazing(&resonance.located).unwrap_or(f64::NAN),
        window,
        magnified: magnify(diagram, resonance, point, window).unwrap_or_default(),
        straightened: straightened(diagram, (resonance, point), &near, units),
    }
}

/// The curves that leave a resonance in straightened coordinates, at round numbers in these units.
fn straightened(
    diagram: &Diagram,
    at: (&FoundResonance, &ResonantGrazingPoint),
    near: &Pair<Result<Straightened, CoefficientError>>,
    units: &Units,
) -> Vec<StraightenedPoint> {
    let etas = straightened::etas(diagram.scope.window.with_dimensions(units).secondary);
    let etas: Vec<f64> = etas.iter().map(|eta| eta / units.secondary).collect();
    straighten(diagram, at, near, &etas)
}

/// The curves that leave one resonance of a diagram, in straightened coordinates and the units of `axes`. The diagram
/// needs no regions.
pub fn straightened_at(
    axes: &Axes,
    diagram: &Diagram,
    (resonance, point): (&FoundResonance, &ResonantGrazingPoint),
) -> StraightenedCurves {
    let near = near(point);
    let coefficients = coefficients_on(point, &near).map(|known| known.theorem.value);
    let curves = straightened(diagram, (resonance, point), &near, &axes.units).with_dimensions(&axes.units);
    let (loops, wall, n) = (resonance.loops, diagram.wall, Some(resonance.n));
    let frame = diagram.scope.window.into();
    let panel = MagnifiedPanel { panel: 1, frame, loops, wall, n, coefficients };
    straightened::panels([(panel.with_dimensions(&axes.units), curves.as_slice())])
}

// The coefficient of the curve on which period-doubled solutions graze is one as the others are.
dimensioned! {
    AtResonance, |own| {
        own.parameters[0] => "{primary}",
        own.parameters[1] => "{secondary}",
        own.point,
        own.hypotheses,
        own.curves,
    }

    Curves, |own| {
        own.findings.saddle_node,
        own.findings.period_doubling,
        own.doubled_grazing => "{primary}/{secondary}^2",
        own.window,
        own.magnified,
        own.straightened,
    }

    CurveFinding, |own| {
        own.coefficient,
        own.simulated,
    }
}
