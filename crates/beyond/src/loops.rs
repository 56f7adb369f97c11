//! Beyond the paper: the k-loop MPSs that leave one-loop resonances of the linear oscillator.
//!
//! In the limit map's units they depend only on σ and ε ([`iterated`](grazing_theorems::iterated)). The
//! closed forms are drawn for the paper's ε and compared with measurements on the curves of oscillators
//! with several damping ratios.

mod ink;

use grazing_continuation::resonance::LeavingCurve;
use grazing_continuation::resonance::LocatedResonance;
use grazing_input::kind::{counts, numbers};
use grazing_model::AnyOscillator;
use grazing_reproduction::forced;
use grazing_reproduction::parameters::MOST_LOOPS;
use grazing_reproduction::prelude::*;
use grazing_results::{rows, tables};
use grazing_theorems::iterated::{IteratedResonance, last_visit_margin};
use grazing_theorems::{LinearOscillator, Resonance};
use rayon::prelude::*;

/// The number of values of σ from 0 to the end of a curve.
const SAMPLES: i32 = 100;
/// The integers n of the measured resonances.
const INDICES: core::ops::RangeInclusive<u32> = 1..=6;
/// A σ above those of all regions of three loops or more, which end at 2/3 at most.
const ABOVE: f64 = 0.7;

/// The relative error above which a measurement is discarded.
const RESOLVED: f64 = 1e-4;

keys! {
    /// Solutions of more loops at one-loop resonances.
    pub struct BeyondLoops {
        /// The numbers of loops k.
        loops: Vec<u32> = counts(2..=MOST_LOOPS),
            "the numbers of loops must be a list of different whole numbers from {} to {}, as [2, 3, 4]";
        /// Damping ratios of oscillators whose curves are measured.
        damping: [f64; 3] = numbers().such(|all: &[f64; 3]| all.iter().all(|zeta| (1e-3..0.5).contains(zeta))),
            "the damping ratios must be three numbers from 0.001 to 0.5";
    }
}

rows! {
    /// The beginning and end of the interval of stable, admissible k-loop MPSs at one σ.
    LoopInterval {
        loops: u32 = LOOPS,
        sigma: f64 = SIGMA,
        slowest: f64 = Y_SLOWEST,
        fastest: f64 = Y_FASTEST,
        from: f64 = M_SLOWEST,
        to: f64 = M_FASTEST,
        log_from: f64 = LOG_M_SLOWEST,
        log_width: f64 = LOG_M_WIDTH,
    }

    /// The curves that bound these MPSs at a resonance of an oscillator, measured.
    LoopMeasurement {
        loops: u32 = LOOPS,
        n: u32 = RESONANCE_INDEX,
        zeta: f64 = ZETA,
        sigma: f64 = SIGMA,
        from: f64 = C_SLOWEST,
        from_fit: f64 = C_SLOWEST_FIT,
        to: f64 = C_FASTEST,
        to_fit: f64 = C_FASTEST_FIT,
        m_from: f64 = M_SLOWEST,
        m_to: f64 = M_FASTEST,
    }
}

tables! {
    /// Solutions of more loops at one-loop resonances.
    MoreLoops {
        /// The intervals are computed by closed forms.
        intervals: LoopInterval = "beyond_loops", "a value of σ",
        /// The measurements are taken on continued curves.
        measured: LoopMeasurement = "beyond_loops_measured", "a resonance of an oscillator",
    }
}

impl FileSection for BeyondLoops {
    const NAME: &'static str = "beyond_loops";
    const REQUIREMENT: &'static str =
        "the table [beyond_loops] says which solutions at one-loop resonances are shown";
}

impl StudyFigure for BeyondLoops {
    const LABEL: &'static str = "fig:loops";
    const TITLE: Title<&'static str> = Title::beyond("solutions with more loops at one-loop resonances");
    const TABLES: &'static [TablePlan] = MoreLoops::TABLES;
    const REMEDY: &'static str = "beyond_loops.damping";
    type Shown = MoreLoops;

    fn compute(&self, study: &Study) -> Result<MoreLoops, StudyError> {
        let epsilon = study.parameters.oscillator()?.coefficient_of_restitution();
        let at = |loops: u32, sigma: f64| {
            let resonance = IteratedResonance::of_linear_oscillator(loops, sigma, epsilon);
            let found = *resonance.emerging().first()?;
            let (slowest, fastest) = (found.slowest, found.fastest?);
            let [from, to] = [slowest, fastest].map(|bound| resonance.coefficient(&bound));
            Some(LoopInterval {
                loops,
                sigma,
                slowest: slowest.velocity_slope,
                fastest: fastest.velocity_slope,
                from,
                to,
                log_from: libm::log10(from),
                log_width: libm::log10(to - from),
            })
        };
        let mut intervals = Vec::new();
        for &loops in &self.loops {
            let last = if loops == 2 { 1.0 } else { last_sigma(loops, epsilon) };
            let shares = (1 - SAMPLES..=SAMPLES).filter(|k| *k != 0 && (*k > 0 || loops == 2));
            // At the end itself the two curves coincide.
            let share = |k: i32| f64::from(k) / f64::from(SAMPLES) * (1.0 - 1e-9);
            intervals.extend(shares.filter_map(|k| at(loops, last * share(k))));
        }
        let oscillators: Vec<(f64, u32)> =
            self.damping.into_iter().flat_map(|zeta| INDICES.map(move |n| (zeta, n))).collect();
        let measured: Vec<_> = oscillators
            .par_iter()
            .map(|&(zeta, n)| {
                let theory = LinearOscillator::new(zeta, epsilon)?;
                measured(&theory, &theory.resonance(1, n)?, &self.loops)
            })
            .collect::<Result<_, StudyError>>()?;
        Ok(MoreLoops { intervals, measured: measured.concat() })
    }

    fn draw(shown: &MoreLoops, width: SheetWidth) -> Result<Sheet, DrawingError> {
        ink::draw(shown, width)
    }

    fn constants(study: &Study) -> Result<Vec<(&'static str, f64)>, ParameterError> {
        Ok(vec![(r"\epsilon", study.parameters.oscillator()?.coefficient_of_restitution())])
    }
}

/// The σ up to which MPSs of three loops or more leave the resonance.
fn last_sigma(loops: u32, epsilon: f64) -> f64 {
    let (mut below, mut above) = (0.0, ABOVE);
    for _ in 0..52 {
        let half = 0.5 * (below + above);
        if last_visit_margin(loops, half, epsilon) > 0.0 { below = half } else { above = half }
    }
    below
}

/// The curves for all these numbers of loops at a resonance.
fn measured(
    theory: &LinearOscillator,
    resonance: &Resonance,
    loops: &[u32],
) -> Result<Vec<LoopMeasurement>, StudyError> {
    let (n, grazing) = (resonance.index(), resonance.grazing());
    let oscillator = AnyOscillator::new(forced(theory, grazing.amplitude(), resonance.forcing_frequency())?);
    let failed = |reason: String| StudyError::Failed(format!("p = 1, n = {n} cannot be measured: {reason}"));
    let located =
        LocatedResonance::find(&oscillator, 1, grazing.phase()).map_err(|e| failed(e.to_string()))?;
    let [_, _, sigma] = located.resonant_point().limit_map().numbers();
    let unit = located.resonant_point().limit_scale().parameter;
    let mut rows = Vec::new();
    for &loops in loops {
        let curves = located.leaving_iterated(loops);
        let [from, to] = curves.as_slice() else { continue };
        // Velocities and heights for many loops may be too small to be resolved.
        let fit = |curve: &LeavingCurve<'_>| {
            let found = curve.straightened().map(|found| found.measurement.coefficient);
            let resolved = found.ok().filter(|found| found.error < RESOLVED * found.value.abs());
            resolved.map_or(f64::NAN, |found| found.value)
        };
        let [from_fit, to_fit] = [fit(from), fit(to)];
        rows.push(LoopMeasurement {
            loops,
            n,
            zeta: theory.damping_ratio(),
            sigma,
            from: from.leading.coefficient,
            from_fit,
            to: to.leading.coefficient,
            to_fit,
            m_from: from_fit / unit,
            m_to: to_fit / unit,
        });
    }
    Ok(rows)
}
