//! Figure 7 (fig:G): the two-parameter bifurcation diagram.

use crate::StudyError;
use crate::diagram::Diagram;
use crate::grazing_curve::{GrazingCurve, centred};
use crate::parameters::Parameters;
use crate::regions::{self, Polygon};
use crate::table::{Table, columns, row};

/// The frames of Figure 7.
#[derive(Clone, Debug)]
pub struct Figure7 {
    /// `fig07_curves`: the grazing curve of the non-impacting solution and the bifurcation curves of MPSs.
    pub curves: Table,
    /// `fig07_points`: resonances and other codimension-two points.
    pub points: Table,
    /// `fig07_regions`: polygons of stability.
    pub regions: Table,
}

impl Figure7 {
    /// All tables.
    pub fn tables(&self) -> Vec<Table> {
        vec![self.curves.clone(), self.points.clone(), self.regions.clone()]
    }

    pub(crate) fn of(parameters: &Parameters, diagram: &Diagram) -> Result<Self, StudyError> {
        let window = parameters.fig07().window();
        let grazing =
            GrazingCurve::sample(parameters, window.frequency().lower(), window.frequency().upper())?;
        let mut polygons = vec![regions::non_impacting(&grazing, window)];
        polygons.extend(regions::stable_mps(diagram, window));
        Ok(Self {
            curves: curves(parameters, diagram, &grazing)?,
            points: points(diagram)?,
            regions: polygon_table(&polygons)?,
        })
    }
}

fn curves(parameters: &Parameters, diagram: &Diagram, grazing: &GrazingCurve) -> Result<Table, StudyError> {
    let mut columns = columns! {
        "kind": "", "p": 0, "n": 0, "omega": 0.0, "amplitude": 0.0, "impact_velocity": 0.0, "impact_phase": 0.0,
        "trace": 0.0, "determinant": 0.0, "max_interior_x": 0.0, "stable": false, "admissible": false, "arc": 0,
    };
    for state in &grazing.states {
        let (trace, determinant) = (state.trace(), state.determinant());
        let stable = trace.abs() - 1.0 < determinant && determinant < 1.0;
        columns.push(row![
            "graz",
            0,
            0,
            state.forcing_frequency(),
            state.amplitude(),
            0.0,
            0.0,
            trace,
            determinant,
            f64::NAN,
            stable,
            true,
            0,
        ]);
    }
    let theory = grazing_theorems::LinearOscillator::new(parameters.zeta(), parameters.epsilon())?;
    for (arc, curve) in (1..).zip(&diagram.curves) {
        for point in &curve.curve.points {
            let solution = &point.solution;
            let [velocity, phase, amplitude, frequency] = solution.unknowns.into();
            let relative_phase = centred(phase - theory.grazing(frequency)?.phase());
            columns.push(row![
                curve.kind.name(),
                curve.loops,
                curve.n,
                frequency,
                amplitude,
                velocity,
                relative_phase,
                solution.multipliers.trace,
                solution.multipliers.determinant,
                solution.ceiling(),
                solution.stable(),
                solution.ceiling() <= grazing_continuation::mps::MaximalPeriodicSolution::TOUCH,
                arc,
            ]);
        }
    }
    Ok(columns.finish("fig07_curves")?)
}

fn points(diagram: &Diagram) -> Result<Table, StudyError> {
    let mut columns = columns! { "kind": "", "p": 0, "n": 0, "omega": 0.0, "amplitude": 0.0 };
    for resonance in &diagram.resonances {
        let [_, _, amplitude, frequency] = resonance.located.unknowns().into();
        let closed_form = &resonance.closed_form;
        columns.push(row!["resonance", closed_form.loops(), closed_form.index(), frequency, amplitude]);
    }
    for corner in &diagram.corners {
        let [_, _, amplitude, frequency] = corner.unknowns.into();
        columns.push(row![corner.kind, corner.loops, corner.n, frequency, amplitude]);
    }
    Ok(columns.finish("fig07_points")?)
}

fn polygon_table(polygons: &[Polygon]) -> Result<Table, StudyError> {
    let mut columns = columns! { "region": 0, "kind": "", "p": 0, "n": 0, "omega": 0.0, "amplitude": 0.0 };
    for (region, polygon) in (1..).zip(polygons) {
        for [amplitude, frequency] in &polygon.vertices {
            columns.push(row![region, polygon.kind, polygon.loops, polygon.n, *frequency, *amplitude]);
        }
    }
    Ok(columns.finish("fig07_regions")?)
}
