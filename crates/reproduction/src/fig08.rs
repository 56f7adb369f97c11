//! Figure 8 (fig:Y): magnifications around resonances with the quadratic approximations.

use grazing_continuation::arclength::StepControl;
use grazing_theorems::Resonance;
use grazing_theorems::resonant_theorem::BifurcationCurve;
use rayon::prelude::*;

use crate::StudyError;
use crate::coefficients::Coefficients;
use crate::diagram::{Diagram, Kind, locate, route};
use crate::grazing_curve::GrazingCurve;
use crate::parameters::{Panel, Parameters, Rectangle};
use crate::table::{Columns, Table, columns, row};

/// The frames of Figure 8.
#[derive(Clone, Debug)]
pub struct Figure8 {
    /// `fig08_curves`: continued curves and quadratic approximations, panel by panel.
    pub curves: Table,
    /// The coefficients printed in each panel; they also stand in `coefficients.csv`.
    pub coefficients: Table,
}

/// Short steps, for curves seen at thirty times the scale of Figure 7.
const MAGNIFIED: StepControl = StepControl { first: 1e-4, longest: 4e-3, shortest: 1e-9, turn: 0.02 };

/// Samples of a quadratic approximation from the resonance to the edge of the panel.
const QUADRATIC_SAMPLES: u32 = 100;

impl Figure8 {
    /// The tables that are written.
    pub fn tables(&self) -> Vec<Table> {
        vec![self.curves.clone()]
    }

    pub(crate) fn compute(
        parameters: &Parameters,
        diagram: &Diagram,
        coefficients: &[Coefficients],
    ) -> Result<Self, StudyError> {
        let mut columns = columns! {
            "panel": 0, "kind": "", "source": "", "arc": 0, "omega": 0.0, "amplitude": 0.0,
        };
        let mut printed = columns! { "panel": 0, "p": 0, "n": 0, "c_sn": 0.0, "c_pd": 0.0 };
        let panels = parameters.fig08().panels();
        let theory = grazing_theorems::LinearOscillator::new(parameters.zeta(), parameters.epsilon())?;
        let curves: Vec<PanelCurves> = panels
            .par_iter()
            .map(|panel| {
                let resonance = theory.resonance(panel.loops(), panel.n())?;
                PanelCurves::follow(parameters, diagram, panel, resonance)
            })
            .collect::<Result<_, StudyError>>()?;
        for (number, (panel, curves)) in (1..).zip(panels.iter().zip(&curves)) {
            curves.write(number, &mut columns);
            for c in coefficients.iter().filter(|c| c.loops == panel.loops() && c.n == panel.n()) {
                printed.push(row![number, c.loops, c.n, c.closed_form[0], c.closed_form[1]]);
            }
        }
        Ok(Self {
            curves: columns.finish("fig08_curves")?,
            coefficients: printed.finish("fig08_coefficients")?,
        })
    }
}

/// A polyline of one kind and source, as points (amplitude, frequency).
struct Polyline {
    kind: &'static str,
    source: &'static str,
    points: Vec<[f64; 2]>,
}

struct PanelCurves(Vec<Polyline>);

impl PanelCurves {
    fn follow(
        parameters: &Parameters,
        diagram: &Diagram,
        panel: &Panel,
        resonance: Resonance,
    ) -> Result<Self, StudyError> {
        let window = panel.window();
        let frequencies = window.frequency();
        let grazing = GrazingCurve::sample(parameters, frequencies.lower(), frequencies.upper())?;
        let point = |state: &grazing_theorems::GrazingState| [state.amplitude(), state.forcing_frequency()];
        let mut list = vec![Polyline {
            kind: "graz",
            source: "continuation",
            points: grazing.states.iter().map(point).collect(),
        }];

        let located = locate(parameters, &resonance)?;
        let error = |source| StudyError::resonance(&resonance, source);
        let unfolded = located.unfold(&route(window, MAGNIFIED)).map_err(error)?;
        let own =
            [(Kind::SaddleNode, &unfolded.saddle_node), (Kind::PeriodDoubling, &unfolded.period_doubling)];
        let own = own.into_iter().chain(unfolded.grazing.iter().map(|curve| (Kind::Grazing, curve)));
        for (kind, curve) in own {
            list.push(Polyline { kind: kind.name(), source: "continuation", points: curve.parameters() });
        }
        list.extend(neighbours(diagram, &resonance, window));

        let theorem = located.theorem();
        for (kind, curve) in
            [(Kind::SaddleNode, theorem.saddle_node()), (Kind::PeriodDoubling, theorem.period_doubling())]
        {
            let points = quadratic(&resonance, curve, window)?;
            list.push(Polyline { kind: kind.name(), source: "quadratic", points });
        }
        Ok(Self(list))
    }

    fn write(&self, panel: u32, columns: &mut Columns) {
        for (arc, polyline) in (1..).zip(&self.0) {
            for [amplitude, frequency] in &polyline.points {
                columns.push(row![panel, polyline.kind, polyline.source, arc, *frequency, *amplitude]);
            }
        }
    }
}

/// The curves of Figure 7 that belong to other resonances and enter the panel.
fn neighbours(diagram: &Diagram, resonance: &Resonance, window: Rectangle) -> Vec<Polyline> {
    let own = |loops, n| loops == resonance.loops() && n == resonance.index();
    let mut list = Vec::new();
    for curve in diagram.curves.iter().filter(|curve| !own(curve.loops, curve.n)) {
        let points = curve.curve.parameters();
        if points.iter().any(|[amplitude, frequency]| window.contains(*amplitude, *frequency)) {
            list.push(Polyline { kind: curve.kind.name(), source: "continuation", points });
        }
    }
    list
}

/// 𝒜 = 𝒜_graz(ω) + c η² from the resonance to the edge of the panel, on the side of η that theory gives.
fn quadratic(
    resonance: &Resonance,
    curve: BifurcationCurve,
    window: Rectangle,
) -> Result<Vec<[f64; 2]>, StudyError> {
    let origin = resonance.forcing_frequency();
    let edge =
        if curve.eta_side.signum() < 0.0 { window.frequency().lower() } else { window.frequency().upper() };
    let mut points = Vec::new();
    for k in 0..=QUADRATIC_SAMPLES {
        let frequency = origin + (edge - origin) * f64::from(k) / f64::from(QUADRATIC_SAMPLES);
        let grazing = resonance.grazing().oscillator().grazing(frequency)?;
        let Some(mu) = curve.parameter(frequency - origin) else {
            continue;
        };
        points.push([grazing.amplitude() + mu, frequency]);
        if !window.amplitude().contains(grazing.amplitude() + mu) {
            break;
        }
    }
    Ok(points)
}
