//! Shaded regions of the linear oscillator along lines of constant η against the closed form: whole
//! intervals of μ, however narrow, in windows and in parts of them.

use grazing_claims::sweep::closed_form::LoopSolutions;
use grazing_continuation::curve::Window;
use grazing_model::{AnyOscillator, LinearOscillator};
use grazing_unfold::progress::Silent;
use grazing_unfold::regions::Region;
use grazing_unfold::{Diagram, Scope};

use crate::closed_form::orbit;
use crate::random::Random;

/// Shorter intervals are those of rounding: two-loop slivers end in cusps, in which they have any
/// width.
pub const LEAST: f64 = 1e-8;
/// Borders are drawn by chords that leave curves by this share of the range of μ at most.
pub const CHORD: f64 = 3e-4;

/// Intervals of μ on a line, apart and in order.
pub type Intervals = Vec<[f64; 2]>;

/// The interval of amplitudes in a range at which a p-loop MPS is stable and admissible; at one
/// frequency there is one at most.
///
/// The trace is linear in 1/y, so that stable MPSs are those with y in an interval, on which the
/// amplitude grows; and they are admissible up to some y, as x is linear in y once it is divided by
/// what of it the forcing makes.
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
    // Faster ones lie beyond the range.
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

/// What regions show of p-loop solutions on a line: where it is shaded, and where it is hatched.
pub fn shown(regions: &[Region], loops: u32, secondary: f64) -> [Intervals; 2] {
    [false, true].map(|hatched| {
        let regions =
            regions.iter().filter(|region| region.loops == loops && region.doubt.is_some() == hatched);
        let mut all: Intervals = regions.flat_map(|region| region.chords(secondary)).collect();
        all.sort_by(|a, b| a[0].total_cmp(&b[0]));
        all
    })
}

/// Lines beside a line, in shares of [`CHORD`]: what is shown there may belong to the line itself.
const BESIDE: [f64; 5] = [0.0, -0.5, 0.5, -1.0, 1.0];
/// Places in an interval that are looked at.
const PLACES: u32 = 9;

/// What of `wanted` lies farther from everything `there` than chords may leave it: pieces of the
/// intervals that none of the others covers, with places that are near to none of those on lines
/// beside.
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

/// The parts of an interval in none of the others, which are in order.
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

/// A line on which a diagram is not what it should be.
#[derive(Clone, Debug)]
pub struct Wrong {
    /// p.
    pub loops: u32,
    /// η.
    pub secondary: f64,
    /// What is there and is not shown.
    pub missed: Intervals,
    /// What is shown and is not there.
    pub false_shading: Intervals,
}

/// A random part of a window, its sides in logarithmic proportion to those of the whole.
pub fn part(window: Window, random: &mut Random) -> Window {
    let mut within = |[low, high]: [f64; 2]| {
        let width = (high - low) * random.logarithmic(SMALLEST, 1.0);
        let from = random.uniform(low, high - width);
        [from, from + width]
    };
    Window { primary: within(window.primary), secondary: within(window.secondary) }
}

/// Where a curve is said to be missing, slivers narrower than this share of the range may be, too.
const TOLD: f64 = 1e-6;
/// Sides of parts of a window are at least this share of its own.
const SMALLEST: f64 = 0.02;

/// What became of the lines of one window.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// Where the diagram is wrong.
    pub wrong: Vec<Wrong>,
    /// The share of the lines that is hatched, for all p together.
    pub hatched: f64,
}

/// Compares the regions of a linear oscillator (ζ, ε) in a window with the closed form on so many
/// random lines. Where there is nothing in the window, nothing is shown.
pub fn compare(
    [zeta, epsilon]: [f64; 2],
    window: Window,
    loops: &[u32],
    lines: usize,
    random: &mut Random,
) -> Outcome {
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
    let mut outcome = Outcome::default();
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
