//! Compares shaded regions of the linear oscillator along lines of constant η with the closed form: whole
//! intervals of μ, however narrow, in windows and in parts of them.

use grazing_claims::sweep::closed_form::LoopSolutions;
use grazing_continuation::curve::Window;
use grazing_model::{AnyOscillator, LinearOscillator};
use grazing_unfold::progress::Silent;
use grazing_unfold::regions::Region;
use grazing_unfold::{Diagram, Scope};

use crate::closed_form::orbit;
use crate::random::Random;

/// The least length of an interval that is compared; shorter ones are affected by rounding, and two-loop
/// slivers end in cusps, where they have any width.
pub const LEAST: f64 = 1e-8;
/// The greatest deviation of the chords that draw borders from the curves, as a fraction of the range of
/// μ.
pub const CHORD: f64 = 3e-4;

/// Disjoint intervals of μ on a line, in order.
pub type Intervals = Vec<[f64; 2]>;

/// The interval of amplitudes within a range in which a p-loop MPS is stable and admissible; at one
/// frequency there is at most one such interval.
///
/// The trace is linear in 1/y, so stable MPSs are those with y in an interval, on which the amplitude
/// increases. They are admissible up to some y, because x divided by its forced part is linear in y.
pub fn exact(zeta: f64, epsilon: f64, [least, most]: [f64; 2], omega: f64, loops: u32) -> Option<[f64; 2]> {
    let solutions = LoopSolutions::new(zeta, epsilon, omega, loops);
    let [one, two] = [1.0, 2.0].map(|velocity| solutions.with_velocity(velocity));
    let slope = 2.0 * (one.trace - two.trace);
    let constant = one.trace - slope;
    let limit = 1.0 + one.determinant;
    let inverse = [-limit, limit].map(|trace| (trace - constant) / slope);
    let [low, high] = [inverse[0].min(inverse[1]).max(0.0), inverse[0].max(inverse[1])];
    if high <= 0.0 {
        return None;
    }
    let amplitude = |velocity: f64| solutions.with_velocity(velocity).amplitude;
    let slowest = 1.0 / high;
    // Faster motion lies beyond the range of amplitudes.
    let mut fastest = if low > 0.0 { 1.0 / low } else { f64::INFINITY };
    let mut reach = slowest.max(1.0);
    while reach < fastest && amplitude(reach) < most {
        reach *= 2.0;
    }
    fastest = fastest.min(reach);
    let admissible =
        |velocity: f64| orbit(zeta, epsilon, &solutions.with_velocity(velocity), omega, loops).admissible();
    if !admissible(fastest) {
        let (mut below, mut above) = (slowest, fastest);
        if !admissible(slowest) {
            return None;
        }
        for _ in 0..60 {
            let middle = 0.5 * (below + above);
            if admissible(middle) { below = middle } else { above = middle }
        }
        fastest = below;
    }
    let [from, to] = [amplitude(slowest).max(least), amplitude(fastest).min(most)];
    (to - from > 0.0).then_some([from, to])
}

/// The intervals of a line on which regions of p-loop solutions are shaded, and those on which they are
/// hatched.
pub fn shown(regions: &[Region], loops: u32, secondary: f64) -> [Intervals; 2] {
    [false, true].map(|hatched| {
        let regions =
            regions.iter().filter(|region| region.loops == loops && region.doubt.is_some() == hatched);
        let mut all: Intervals = regions.flat_map(|region| region.chords(secondary)).collect();
        all.sort_by(|a, b| a[0].total_cmp(&b[0]));
        all
    })
}

/// Lines beside a line, in units of [`CHORD`]; what is drawn on them may belong to the line itself.
const BESIDE: [f64; 5] = [0.0, -0.5, 0.5, -1.0, 1.0];
/// The number of places tested in an interval.
const PLACES: u32 = 9;

/// The pieces of `wanted` that are farther from all intervals in `there` than chords explain: they are
/// not covered on the line itself, and some of their places are not near the intervals on lines beside
/// it.
pub fn lacking(wanted: &[[f64; 2]], there: &[Intervals; BESIDE.len()], width: f64) -> Intervals {
    let near = |place: f64| {
        let reach = CHORD * width;
        there.iter().flatten().any(|[low, high]| low - reach <= place && place <= high + reach)
    };
    let pieces = wanted.iter().flat_map(|interval| uncovered(*interval, &there[0]));
    let places = |[from, to]: [f64; 2]| {
        (1..=PLACES).map(move |k| from + (to - from) * f64::from(k) / f64::from(PLACES + 1))
    };
    pieces.filter(|piece| piece[1] - piece[0] > LEAST && places(*piece).any(|place| !near(place))).collect()
}

/// The parts of an interval that none of the others covers; these are in order.
fn uncovered([start, to]: [f64; 2], others: &[[f64; 2]]) -> Intervals {
    let (mut parts, mut from) = (Vec::new(), start);
    for [low, high] in others.iter().filter(|[low, high]| *high > start && *low < to) {
        if *low > from {
            parts.push([from, *low]);
        }
        from = from.max(*high);
    }
    if from < to {
        parts.push([from, to]);
    }
    parts
}

/// A line on which a diagram is wrong.
#[derive(Clone, Debug)]
pub struct Wrong {
    /// p.
    pub loops: u32,
    /// η.
    pub secondary: f64,
    /// Intervals of stable motion that are not drawn.
    pub missed: Intervals,
    /// Intervals drawn without stable motion.
    pub false_shading: Intervals,
}

/// A random part of a window; the ratios of its sides to those of the window are logarithmically
/// distributed.
pub fn part(window: Window, random: &mut Random) -> Window {
    let mut within = |[low, high]: [f64; 2]| {
        let width = (high - low) * random.logarithmic(SMALLEST, 1.0);
        let from = random.uniform(low, high - width);
        [from, from + width]
    };
    Window { primary: within(window.primary), secondary: within(window.secondary) }
}

/// If a curve is reported as missing, slivers narrower than this fraction of the range may be missing as
/// well.
const TOLD: f64 = 1e-6;
/// The least ratio of the sides of a part to those of the window.
const SMALLEST: f64 = 0.02;

/// The result of comparing the lines of one window.
#[derive(Clone, Debug, Default)]
pub struct LineComparison {
    /// The lines on which the diagram is wrong.
    pub wrong: Vec<Wrong>,
    /// The hatched fraction of the lines, summed over all p.
    pub hatched: f64,
}

/// Compares the regions of a linear oscillator (ζ, ε) in a window with the closed form on `lines` random
/// lines. If the window has nothing to unfold, the diagram counts as empty.
pub fn compare(
    [zeta, epsilon]: [f64; 2],
    window: Window,
    loops: &[u32],
    lines: usize,
    random: &mut Random,
) -> LineComparison {
    let scope = Scope { window, loops: loops.to_vec(), start: None };
    let oscillator = LinearOscillator::new(zeta, epsilon, window.primary[0], window.secondary[0])
        .unwrap_or_else(|error| panic!("zeta {zeta}, epsilon {epsilon}: {error}"));
    let (regions, told) = match Diagram::compute(&AnyOscillator::new(oscillator), &scope, &Silent) {
        Ok(diagram) => {
            let lost = diagram.not_unfolded.iter().map(|lost| lost.solutions);
            (diagram.regions, lost.chain(diagram.unlocated.iter().map(|lost| lost.loops)).collect())
        }
        Err(_) => (Vec::new(), Vec::new()),
    };
    let mut outcome = LineComparison::default();
    let [width, height] = window.widths();
    for _ in 0..lines {
        let secondary = random.uniform(window.secondary[0], window.secondary[1]);
        let beside = BESIDE.map(|share| secondary + share * CHORD * height);
        for &loops in loops {
            let right = beside.map(|secondary| -> Intervals {
                exact(zeta, epsilon, window.primary, secondary, loops).into_iter().collect()
            });
            let shown = beside.map(|secondary| shown(&regions, loops, secondary));
            let known = shown.each_ref().map(|lists| {
                let mut known = lists.concat();
                known.sort_by(|a, b| a[0].total_cmp(&b[0]));
                known
            });
            let mut missed = lacking(&right[0], &known, width);
            if told.contains(&loops) {
                missed.retain(|[from, to]| to - from > TOLD * width);
            }
            let false_shading = lacking(&shown[0][0], &right, width);
            let length: f64 = shown[0][1].iter().map(|[from, to]| to - from).sum();
            outcome.hatched += length / width / lines as f64;
            if !missed.is_empty() || !false_shading.is_empty() {
                outcome.wrong.push(Wrong { loops, secondary, missed, false_shading });
            }
        }
    }
    outcome
}
