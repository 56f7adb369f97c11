//! Places where slices are wanted: at faces that none crosses, between verdicts that differ, beside
//! loose ends of curves and across curves.

use super::face_stability::Judge;
use crate::faces::{Face, Point, extent};

/// Number of values of η in a face at which the longest chord is looked for.
const TRIALS: u32 = 15;
/// A face's slice is good enough if its chord has at least this fraction of the longest one.
const LONG_ENOUGH: f64 = 0.25;
/// Smallest distance of slices, as a fraction of the range of η.
const NEAREST: f64 = 1e-3;
/// Smallest distance, in multiples of [`NEAREST`], for faces that no slice crosses, which may be
/// very low.
const LEAST_APART: f64 = 1e-7;
/// Largest number of slices. Where motion is violent, as near the top of a pendulum, each shows
/// changes that the others do not, and the rest is undecided.
const MOST_SLICES: usize = 200;
/// A curve on which η changes by less than this fraction of its range runs along a slice, on which
/// only the curve would be seen.
const ALONG: f64 = 1e-9;
/// Displacements of slices beside a loose end, as fractions of the range of η.
const FROM_LOOSE_END: [f64; 4] = [-0.02, -0.003, 0.003, 0.02];

impl Judge {
    /// The η at which a slice is needed to judge a face, if no existing slice is sufficient, and
    /// the distance within which another one would also suffice.
    pub(super) fn unseen(&self, face: &Face) -> Option<[f64; 2]> {
        let [low, high] = extent(face);
        let trial = |k: u32| low + (high - low) * (f64::from(k) + 0.5) / f64::from(TRIALS);
        let trials = (0..TRIALS).map(|k| (trial(k), self.longest(face, trial(k))));
        let (best, length) = trials.max_by(|a, b| a.1.total_cmp(&b.1))?;
        let seen = self.slices.iter().any(|slice| {
            low < slice.secondary
                && slice.secondary < high
                && self.longest(face, slice.secondary) >= LONG_ENOUGH * length
        });
        let height = self.window.widths()[1];
        let apart = (0.5 / f64::from(TRIALS) * (high - low)).min(NEAREST * height);
        (!seen && length > 0.0 && apart > LEAST_APART * height).then_some([best, apart])
    }

    /// The wanted values of η without those so close to one another or to a slice that they would
    /// add nothing, thinned out evenly where slices would become too many. Those at which a face is
    /// `unseen` may be closer, each by its own distance.
    pub(super) fn affordable(&self, unseen: Vec<[f64; 2]>, wanted: &[f64]) -> Vec<f64> {
        let nearest = NEAREST * self.window.widths()[1];
        let mut all = unseen;
        all.extend(wanted.iter().map(|level| [*level, nearest]));
        all.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut apart: Vec<f64> = Vec::new();
        for [level, nearest] in all {
            let known = self.slices.iter().map(|slice| slice.secondary).chain(apart.last().copied());
            if known.into_iter().all(|known| (known - level).abs() >= nearest) {
                apart.push(level);
            }
        }
        let left = MOST_SLICES.saturating_sub(self.slices.len());
        (0..apart.len().min(left)).map(|k| apart[k * apart.len() / apart.len().min(left)]).collect()
    }

    /// Values of η half-way between neighbouring slices one of which has trouble in a face and the
    /// other has not: a missing curve ends between them.
    pub(super) fn between_verdicts(&self, face: Face) -> Vec<f64> {
        let trouble = self.judge(face).trouble;
        if trouble.is_empty() {
            return Vec::new();
        }
        let [first, last] = self.window.secondary;
        let mut levels: Vec<f64> = self.slices.iter().map(|slice| slice.secondary).collect();
        levels.extend([first, last]);
        levels.sort_by(f64::total_cmp);
        let pairs = levels.windows(2).filter(|pair| trouble.contains(&pair[0]) != trouble.contains(&pair[1]));
        pairs.map(|pair| 0.5 * (pair[0] + pair[1])).collect()
    }

    /// Values of η beside ends of curves inside the window at which no other curve ends and, if
    /// requested, half-way from one to the next: a curve is missing there, which may lead to the
    /// next end.
    pub(super) fn beside_loose_ends(&self, lines: &[Vec<Point>], to_next: bool) -> Vec<f64> {
        let ends: Vec<Point> =
            lines.iter().filter_map(|line| Some([*line.first()?, *line.last()?])).flatten().collect();
        let inside = |[primary, secondary]: Point| {
            let within = |[low, high]: [f64; 2], value: f64| low < value && value < high;
            within(self.window.primary, primary) && within(self.window.secondary, secondary)
        };
        let loose =
            ends.iter().filter(|end| inside(**end) && ends.iter().filter(|other| other == end).count() == 1);
        let mut loose: Vec<f64> = loose.map(|end| end[1]).collect();
        loose.sort_by(f64::total_cmp);
        let height = self.window.widths()[1];
        let beside = loose.iter().flat_map(|end| FROM_LOOSE_END.map(|share| end + share * height));
        let between = loose.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).filter(|_| to_next);
        beside
            .chain(between)
            .filter(|level| self.window.secondary[0] < *level && *level < self.window.secondary[1])
            .collect()
    }

    /// Values of η along curves that fewer than `slices` slices cross, half-way if that is one:
    /// other branches that begin beside them have not been seen.
    pub(super) fn uncrossed(&self, lines: &[Vec<Point>], slices: u32) -> Vec<f64> {
        let extents = lines.iter().map(|line| extent(core::slice::from_ref(line)));
        let crossed = |[low, high]: &[f64; 2]| {
            let inside = self.slices.iter().filter(|it| *low < it.secondary && it.secondary < *high);
            inside.count() >= slices as usize
        };
        let along = |[low, high]: &[f64; 2]| high - low < ALONG * self.window.widths()[1];
        let share = |k: u32| f64::from(k) / f64::from(slices + 1);
        extents
            .filter(|extent| !crossed(extent) && !along(extent))
            .flat_map(|[low, high]| (1..=slices).map(move |k| low + share(k) * (high - low)))
            .collect()
    }

    /// Values of η at which good solutions are known beside a curve in a face in which no slice
    /// sees any.
    pub(super) fn contradicted(&self, face: &Face) -> Vec<f64> {
        if self.judge(face.clone()).verdict == Ok(true) {
            return Vec::new();
        }
        self.witnesses_in(face).collect()
    }
}

#[cfg(test)]
mod tests {
    use grazing_continuation::curve::Window;

    use super::*;
    use crate::slice_stability::SliceStability;

    const UNIT: Window = Window { primary: [0.0, 1.0], secondary: [0.0, 1.0] };

    #[test]
    fn slices_keep_their_distance_and_are_no_more_than_can_be_afforded() {
        let window = Window { primary: [0.0, 1.0], secondary: [0.0, 2.0] };
        let (good, doubts) = (Vec::new(), Vec::new());
        let judge = Judge {
            window,
            slices: vec![SliceStability { secondary: 1.0, good, doubts, everywhere: None }],
            witnesses: Vec::new(),
        };
        let wanted: Vec<f64> = (0..=10_000).map(|k| 2.0 * f64::from(k) / 10_000.0).collect();
        let levels = judge.affordable(Vec::new(), &wanted);
        assert_eq!(levels.len(), MOST_SLICES - 1);
        assert!(levels.windows(2).all(|pair| pair[1] - pair[0] >= 2.0 * NEAREST));
        assert!(levels.iter().all(|level| (level - 1.0).abs() >= 2.0 * NEAREST));
        // From end to end.
        assert!(levels[0] < 0.02 && levels[levels.len() - 1] > 1.98);
        assert_eq!(judge.affordable(Vec::new(), &[0.5, 1.001, 1.5]), [0.5, 1.5]);
        // A face that no slice crosses gets one however low it is.
        assert_eq!(judge.affordable(vec![[1.001, 1e-5]], &[0.5]), [0.5, 1.001]);
    }

    #[test]
    fn slices_are_laid_beside_loose_ends_and_through_curves_that_none_crosses() {
        let nothing =
            SliceStability { secondary: 0.5, good: Vec::new(), doubts: Vec::new(), everywhere: None };
        let judge = Judge { window: UNIT, slices: vec![nothing], witnesses: Vec::new() };
        // From the edge to a loose end, and two curves that meet.
        let line = |points: &[Point]| points.to_vec();
        let loose = line(&[[0.0, 0.3], [0.4, 0.6]]);
        let pair = [line(&[[0.0, 0.1], [0.7, 0.2]]), line(&[[0.7, 0.2], [1.0, 0.1]])];
        assert_eq!(judge.beside_loose_ends(&pair, true), []);
        let levels = judge.beside_loose_ends(&[loose.clone(), pair[0].clone(), pair[1].clone()], true);
        assert_eq!(levels, FROM_LOOSE_END.map(|share| 0.6 + share));
        // A curve from there to another loose end lies between.
        let levels = judge.beside_loose_ends(&[loose.clone(), line(&[[0.0, 0.8], [0.4, 0.7]])], true);
        assert!(levels.contains(&(0.5 * (0.6 + 0.7))), "{levels:?}");
        let [first, second] = pair;
        assert_eq!(judge.uncrossed(&[loose, first, second], 1), [0.5 * (0.1 + 0.2); 2]);
    }
}
