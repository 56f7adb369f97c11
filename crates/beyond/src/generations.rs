//! Beyond the paper: resonances on the curves along which the MPSs of Figure 7 graze, and the solutions with more
//! impacts that leave them.

mod ink;

use grazing_continuation::bifurcation::{Bifurcation, Pair};
use grazing_continuation::curve::{Curve, Window};
use grazing_continuation::fit::{Estimate, measure};
use grazing_continuation::mps::PeriodicSolution;
use grazing_input::kind::{count, counts};
use grazing_model::ImpactOscillator;
use grazing_reproduction::figures::fig07::Figure7;
use grazing_reproduction::parameters::MOST_LOOPS;
use grazing_reproduction::prelude::*;
use grazing_results::plane::{CurveSource, PlanePoint, SequenceVertex};
use grazing_results::{Frame, Stability, brief, rows, tables};
use grazing_unfold::generations::{BaseName, LaterResonance};
use grazing_unfold::plane;
use grazing_unfold::resonances::Unlocated;
use grazing_unfold::sequences::{Sequences, sequences};
use rayon::prelude::*;

/// The greatest number of panels that fit beside each other.
const MOST_PANELS: u32 = 3;
/// The half-height of a magnification, as a fraction of the distance in η to the nearer end of the SN and the PD
/// curve.
const REACH: f64 = 0.08;
/// The number of points of a quadratic approximation.
const SAMPLES: i32 = 40;

keys! {
    /// Resonances of motion with impacts.
    pub struct BeyondGenerations {
        /// The numbers of rounds q.
        rounds: Vec<u32> = counts(1..=MOST_LOOPS),
            "the numbers of rounds must be a list of different whole numbers from {} to {}, as [1, 2, 3]";
        /// The number of resonances that are magnified.
        panels: u32 = count(1..=MOST_PANELS), "the number of magnified resonances must be a whole number from {} to {}";
    }
}

rows! {
    /// A resonance on a curve along which MPSs graze.
    LaterRow {
        number: u32 = LATER_NUMBER,
        base_loops: u32 = LATER_BASE_LOOPS,
        base_n: u32 = LATER_BASE_INDEX,
        rounds: u32 = LATER_ROUNDS,
        impacts: u32 = LATER_IMPACTS,
        periods: u32 = LATER_PERIODS,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        tau: f64 = TAU,
        delta: f64 = DELTA,
        off_diagonal: f64 = A12,
        saddle_node: f64 = C_SN,
        saddle_node_fit: f64 = C_SN_FIT,
        saddle_node_error: f64 = C_SN_FIT_ERROR,
        period_doubling: f64 = C_PD,
        period_doubling_fit: f64 = C_PD_FIT,
        period_doubling_error: f64 = C_PD_FIT_ERROR,
        limit_r: f64 = LIMIT_R,
        limit_k: f64 = LIMIT_K,
        limit_d: f64 = LIMIT_D,
        criticality: f64 = PD_CRITICALITY,
        doubled_grazing: f64 = C_2GZ,
        fails: String = LATER_FAILS,
    }

    /// A point of a curve that leaves such a resonance.
    LaterPoint {
        number: u32 = LATER_NUMBER,
        impacts: u32 = LATER_IMPACTS,
        periods: u32 = LATER_PERIODS,
        kind: Bifurcation = BIFURCATION,
        arc: u32 = ARC,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        impact_velocity: f64 = LATER_VELOCITY,
        trace: f64 = TRACE,
        determinant: f64 = DETERMINANT,
        max_interior_x: f64 = MAX_INTERIOR_X,
        stable: Stability = STABLE,
        admissible: bool = ADMISSIBLE,
    }

    /// A point of a curve in a magnification.
    LaterMagnified {
        panel: u32 = PANEL,
        number: u32 = LATER_NUMBER,
        kind: Bifurcation = BIFURCATION,
        source: CurveSource = SOURCE,
        arc: u32 = ARC,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
    }
}

tables! {
    /// Resonances of motion with impacts.
    Generations {
        /// Where they are.
        resonances: LaterRow = "beyond_generations", "a resonance on a curve along which MPSs of Figure 7 graze",
        /// What leaves them.
        curves: LaterPoint = "beyond_generations_curves", "a point of a curve of solutions with several impacts",
        /// Where solutions with several impacts are stable.
        regions: SequenceVertex = "beyond_generations_regions",
            "a vertex of a region of stability of solutions with several impacts" as Areas,
        /// Magnified.
        magnified: LaterMagnified = "beyond_generations_magnified", "a point of a curve in a magnification",
        ;
        /// The curves of Figure 7.
        known: Vec<PlanePoint>,
        /// The window of Figure 7.
        frame: Frame,
        /// The magnifications.
        panels: Vec<Frame>,
        /// Sentences about curves that are missing.
        missing: Vec<String>,
        /// Resonances that were detected but could not be located.
        unlocated: Vec<Unlocated>,
    }
}

impl FileSection for BeyondGenerations {
    const NAME: &'static str = "beyond_generations";
    const REQUIREMENT: &'static str =
        "the table [beyond_generations] says which resonances of motion with impacts are shown";
}

impl StudyFigure for BeyondGenerations {
    const LABEL: &'static str = "fig:generations";
    const TITLE: Title<&'static str> = Title::beyond("resonances of motion that already hits the wall");
    const TABLES: &'static [TablePlan] = Generations::TABLES;
    const REMEDY: &'static str = "fig07.frequency, fig07.amplitude or fig07.loops";
    type Shown = Generations;

    fn compute(&self, study: &Study) -> Result<Generations, StudyError> {
        let diagram = study.diagram()?;
        let window = study.parameters.section::<Figure7>()?.window();
        let sequences = sequences(diagram, &self.rounds, 2, &*study.progress);
        let regions = sequences.rows(0).regions;
        let Sequences { resonances: found, unlocated, .. } = sequences;
        let resonances: Vec<LaterRow> =
            found.par_iter().enumerate().map(|(index, found)| row(index as u32 + 1, found)).collect();
        let curves = (1..).zip(&found).flat_map(|(number, found)| points(number, found)).collect();
        let missing = (1..).zip(&found).flat_map(|(number, found): (u32, _)| {
            let sentence = move |reason| {
                format!("resonance {number} of motion with impacts: a curve is missing: {reason}")
            };
            found.missing.iter().map(sentence)
        });
        let chosen = self.chosen(&found);
        let frames: Vec<Frame> = chosen.iter().filter_map(|index| frame(&found[*index])).collect();
        let magnified = (1..)
            .zip(chosen.iter().zip(&frames))
            .flat_map(|(panel, (index, frame))| magnified(panel, *index as u32 + 1, &found[*index], frame))
            .collect();
        Ok(Generations {
            resonances,
            curves,
            regions,
            magnified,
            known: plane::curves(diagram),
            frame: window.into(),
            panels: frames,
            missing: missing.collect(),
            unlocated,
        })
    }

    fn draw(shown: &Generations, width: SheetWidth) -> Result<Sheet, DrawingError> {
        ink::draw(shown, width)
    }

    fn remarks(&self, _: &Study, shown: &Generations) -> Result<Remarks, StudyError> {
        let unlocated = shown.unlocated.first().map(|lost| {
            let [amplitude, omega] = lost.near.map(|value| brief(value, 6));
            format!(
                "resonances of motion with impacts that were detected and not located: {}, the first with q = {} near amplitude {amplitude}, frequency {omega}: {}",
                shown.unlocated.len(),
                lost.loops,
                lost.reason
            )
        });
        Ok(Remarks { notes: shown.missing.iter().cloned().chain(unlocated).collect(), gaps: Vec::new() })
    }

    fn constants(study: &Study) -> Result<Vec<(&'static str, f64)>, ParameterError> {
        study.oscillator_constants()
    }
}

impl BeyondGenerations {
    /// The resonances that are magnified: of those that can be, the ones whose curves reach farthest, no two on
    /// one curve of grazing bifurcations, in the order of the list.
    fn chosen(&self, found: &[LaterResonance]) -> Vec<usize> {
        let reach = |index: usize| frame(&found[index]).map_or(0.0, |frame| frame.y[1] - frame.y[0]);
        let mut all: Vec<usize> = (0..found.len()).filter(|index| reach(*index) > 0.0).collect();
        all.sort_by(|a, b| reach(*b).total_cmp(&reach(*a)));
        let mut chosen: Vec<usize> = Vec::new();
        for index in all {
            let is_other = chosen.iter().all(|known| found[*known].base != found[index].base);
            if is_other && chosen.len() < self.panels as usize {
                chosen.push(index);
            }
        }
        chosen.sort_unstable();
        chosen
    }
}

/// The row of a resonance.
fn row(number: u32, found: &LaterResonance) -> LaterRow {
    let BaseName { periods: base_loops, n: base_n, .. } = found.base;
    let located = &found.resonance.located;
    let [primary, secondary] = located.orbit().oscillator().parameters();
    let map = located.orbit().grazing_point().map;
    let none = Estimate { value: f64::NAN, error: f64::NAN };
    let (leading, fits, [limit_r, limit_k, limit_d, criticality, doubled_grazing], fails) =
        match &found.resonance.theorem {
            Ok(point) => {
                let fit = |condition| measure(point, condition).map_or(none, |measured| measured.coefficient);
                let leading = point.leading().map(|curve| curve.coefficient);
                let (here, limit) = (point.resonant_point(), point.resonant_point().limit_map());
                let [r, k, d] = limit.numbers();
                let limits = [r, k, d, limit.criticality(), here.doubled_grazing_coefficient()];
                (leading, Pair::CONDITIONS.map(fit), limits, String::new())
            }
            Err(violated) => {
                let missing = Pair { saddle_node: f64::NAN, period_doubling: f64::NAN };
                let none = Pair { saddle_node: none, period_doubling: none };
                (missing, none, [f64::NAN; 5], violated.to_string())
            }
        };
    LaterRow {
        number,
        base_loops,
        base_n,
        rounds: located.loops(),
        impacts: found.impacts() as u32,
        periods: found.periods(),
        secondary,
        primary,
        tau: map.trace(),
        delta: map.determinant(),
        off_diagonal: map.a.m12,
        saddle_node: leading.saddle_node,
        saddle_node_fit: fits.saddle_node.value,
        saddle_node_error: fits.saddle_node.error,
        period_doubling: leading.period_doubling,
        period_doubling_fit: fits.period_doubling.value,
        period_doubling_error: fits.period_doubling.error,
        limit_r,
        limit_k,
        limit_d,
        criticality,
        doubled_grazing,
        fails,
    }
}

/// The bifurcation on a curve that leaves a resonance of motion with impacts.
fn kind(curve: &Curve) -> Bifurcation {
    Bifurcation::of(curve.condition, 1).unwrap_or(Bifurcation::Grazing)
}

fn points(number: u32, found: &LaterResonance) -> Vec<LaterPoint> {
    let (impacts, periods) = (found.impacts() as u32, found.periods());
    let of_curve = |(arc, curve): (u32, &Curve)| {
        let kind = kind(curve);
        let point = |solution: &PeriodicSolution| LaterPoint {
            number,
            impacts,
            periods,
            kind,
            arc,
            secondary: solution.parameters()[1],
            primary: solution.parameters()[0],
            impact_velocity: solution.impact_velocity(),
            trace: solution.multipliers.trace,
            determinant: solution.multipliers.determinant,
            max_interior_x: solution.highest_interior_maximum.map_or(f64::NAN, |top| top.position),
            stable: Stability::of(solution.multipliers),
            admissible: solution.admissible(),
        };
        curve.points.iter().map(|at| point(&at.solution)).collect::<Vec<_>>()
    };
    (1..).zip(&found.curves).flat_map(of_curve).collect()
}

/// The area about a resonance in which its curves are seen to leave it; `None` where no theorem holds or a curve
/// hardly leaves.
fn frame(found: &LaterResonance) -> Option<Frame> {
    let point = found.resonance.theorem.as_ref().ok()?;
    let [saddle_node, period_doubling, ..] = found.curves.as_slice() else { return None };
    let [_, secondary] = point.orbit().oscillator().parameters();
    let reach = |curve: &Curve| {
        let away = curve.parameters().into_iter().map(|[_, at]| (at - secondary).abs());
        away.fold(0.0, f64::max)
    };
    let half = REACH * reach(saddle_node).min(reach(period_doubling));
    let up = [secondary - half, secondary + half];
    let grazing =
        up.map(|eta| Some(point.orbit().place().moved(point.orbit().oscillator(), eta).ok()?.parameters[0]));
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    // As far as the curves lead from the resonance without a break.
    let leaving = |curve: &Curve| {
        let places = curve.parameters().into_iter();
        places.take_while(|[_, eta]| (up[0]..=up[1]).contains(eta)).map(|[primary, _]| primary)
    };
    let inside = [saddle_node, period_doubling].into_iter().flat_map(leaving);
    for primary in inside.chain(grazing.into_iter().flatten()) {
        (low, high) = (low.min(primary), high.max(primary));
    }
    let room = 0.05 * (high - low);
    (half > 0.0 && room > 0.0).then_some(Frame { x: [low - room, high + room], y: up })
}

fn magnified(panel: u32, number: u32, found: &LaterResonance, frame: &Frame) -> Vec<LaterMagnified> {
    let Ok(point) = &found.resonance.theorem else { return Vec::new() };
    let mut rows = Vec::new();
    let mut add = |kind, source, arc, places: &mut dyn Iterator<Item = [f64; 2]>| {
        rows.extend(places.map(|[primary, secondary]| LaterMagnified {
            panel,
            number,
            kind,
            source,
            arc,
            secondary,
            primary,
        }));
    };
    let window = Window { primary: frame.x, secondary: frame.y };
    for (arc, curve) in (1..).zip(&found.curves) {
        // With the first points outside.
        let places = curve.parameters();
        let near = |k: usize| {
            (k.saturating_sub(1)..=k + 1).any(|k| places.get(k).is_some_and(|at| window.contains(*at)))
        };
        add(
            kind(curve),
            CurveSource::Continuation,
            arc,
            &mut (0..places.len()).filter(|k| near(*k)).map(|k| places[k]),
        );
    }
    let (orbit, oscillator) = (point.orbit(), point.orbit().oscillator());
    let [_, resonance] = oscillator.parameters();
    let half = 0.5 * (frame.y[1] - frame.y[0]);
    let places: Vec<(f64, f64)> = (-SAMPLES..=SAMPLES)
        .filter_map(|k| {
            let eta = half * f64::from(k) / f64::from(SAMPLES);
            Some((eta, orbit.place().moved(oscillator, resonance + eta).ok()?.parameters[0]))
        })
        .collect();
    let along = |shift: &dyn Fn(f64) -> Option<f64>| -> Vec<[f64; 2]> {
        places.iter().filter_map(|(eta, grazing)| Some([grazing + shift(*eta)?, resonance + eta])).collect()
    };
    add(Bifurcation::Grazing, CurveSource::Continuation, 0, &mut along(&|_| Some(0.0)).into_iter());
    for (bifurcation, leading) in point.leading().named() {
        add(bifurcation, CurveSource::Quadratic, 0, &mut along(&|eta| leading.parameter(eta)).into_iter());
    }
    rows
}
