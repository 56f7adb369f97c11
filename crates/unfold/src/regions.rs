//! Regions of stability in the plane of the two parameters (μ, η), decided face by face.
//!
//! The curves of one p cut the window into faces. In every face the solutions are looked at along
//! slices of constant η: a face in which every slice sees a stable, admissible solution all along
//! is shaded, one in which none does is not, and where slices do not agree, or a branch could not
//! be followed, that is said.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::Window;
use grazing_model::AnyOscillator;
use rayon::prelude::*;

use crate::Scope;
use crate::curves::{DiagramCurve, Net};
use crate::faces::{self, Face, Point, chords, extent};
use crate::grazing::GrazingCurve;
use crate::progress::Progress;
use crate::search;
use crate::sight::Sight;
use crate::survey::{CLEAR, Survey};

pub use crate::region::{Doubt, Region};

/// A face and what was found in it.
struct FaceVerdict {
    face: Face,
    verdict: Result<bool, Doubt>,
    /// Values of η at which slices do not agree with the rest.
    trouble: Vec<f64>,
}

/// Along chords shorter than this share of the window a face may seem mixed: curves are drawn by
/// chords of their own.
const SHORT: f64 = 2e-3;
/// A face all of whose chords are shorter than this is thinner than curves are drawn: the majority
/// of its slices decides.
const THIN: f64 = 5e-4;
/// Along a chord of a face there are good solutions on none or all of it, give or take what the
/// curves' chords leave.
const PURE: f64 = 0.1;
/// However long a chord, no more than this share of the window may differ from the rest of it.
const STRETCH: f64 = 5e-3;
/// What has less than this share of the window's area is what rounding leaves between curves that
/// meet: they are located to some 10⁻¹⁰.
const NOTHING: f64 = 1e-12;
/// Undecided faces with less than this share of the window's area are left out: the chords of two
/// curves that cross at a small angle leave such between them.
const SPECK: f64 = 1e-7;
/// Values of η in a face at which the longest chord is looked for.
const TRIALS: u32 = 15;
/// A face's slice is good enough if its chord has this share of the longest one.
const LONG_ENOUGH: f64 = 0.25;
/// Slices of the whole window to begin with.
const SLICES: u32 = 16;
/// How often slices are added where they are needed.
const ROUNDS: usize = 8;
/// Slices are no closer than this share of the range of η,
const NEAREST: f64 = 1e-3;
/// but for faces that none crosses, which may be as low as so many times this share,
const LEAST_APART: f64 = 1e-7;
/// and no more than this. Where motion is violent, as near the top of a pendulum, each shows
/// changes that the others do not, and what they leave is undecided.
const MOST_SLICES: usize = 200;
/// A curve on which η changes by less than this share of its range runs along a slice, on which
/// nothing would be seen but it.
const ALONG: f64 = 1e-9;
/// So many slices cross a curve at which branches begin: what begins there and comes to an end on
/// both sides is as high as a share of the curve.
const ABOUT_BEGINNINGS: u32 = 5;
/// Shares of the range of η at which slices are laid beside a loose end.
const BESIDE: [f64; 4] = [-0.02, -0.003, 0.003, 0.02];

/// The values of η at which slices are laid to begin with.
pub(crate) fn levels(window: Window) -> Vec<f64> {
    (0..=SLICES).map(|k| window.parameters([0.0, f64::from(k) / f64::from(SLICES)])[1]).collect()
}

/// The stage in which regions of MPSs are decided.
pub(crate) const STAGE: &str = "regions";

/// The regions of the MPSs of each p, none where an end was asked for meanwhile; curves that are
/// found to be missing on the way are added.
pub(crate) fn of_mps(
    oscillator: &AnyOscillator,
    scope: &Scope,
    grazing: &[GrazingCurve],
    nets: &mut [Net],
    progress: &dyn Progress,
) -> Vec<Option<Vec<Region>>> {
    let window = scope.window;
    let levels = levels(window);
    let fastest = search::fastest(nets.iter().flat_map(|net| &net.curves).map(|curve| &curve.curve));
    progress.begin(STAGE, nets.len() as u64);
    let found = search::on_slices(oscillator, &scope.loops, window, &levels, fastest, progress);
    let regions = nets.par_iter_mut().map(|net| {
        let loops = net.loops();
        let found = found.iter().filter(|(p, _)| *p == loops).map(|(_, solution)| *solution).collect();
        let mut survey = Survey::new(net, scope, grazing, found);
        let regions = decided(window, &mut survey, &levels, progress);
        progress.step(STAGE);
        (!progress.stopped()).then_some(regions)
    });
    let regions = regions.collect();
    progress.end(STAGE);
    regions
}

/// The regions of the solutions of a survey, from slices at some values of η and wherever else they
/// are needed.
pub(crate) fn decided(
    window: Window,
    survey: &mut Survey<'_>,
    levels: &[f64],
    progress: &dyn Progress,
) -> Vec<Region> {
    survey.look_at(levels, progress);
    let mut judge = Judge { window, sights: survey.sights(), witnesses: survey.witnesses() };
    for _ in 0..ROUNDS {
        let lines = joined(window, survey.lines());
        let faces = faces::cut(window, &lines);
        let unseen: Vec<[f64; 2]> = faces.iter().filter_map(|face| judge.unseen(face)).collect();
        let mut wanted: Vec<f64> = faces.iter().flat_map(|face| judge.contradicted(face)).collect();
        wanted.extend(faces.into_iter().flat_map(|face| judge.between_verdicts(face)));
        wanted.extend(judge.beside_loose_ends(&lines, survey.loops() > 0));
        wanted.extend(judge.uncrossed(&lines, 1));
        wanted.extend(judge.uncrossed(&survey.beginnings(), ABOUT_BEGINNINGS));
        let wanted = judge.affordable(unseen, &wanted);
        if wanted.is_empty() || progress.stopped() {
            break;
        }
        survey.look_at(&wanted, progress);
        judge.sights = survey.sights();
        judge.witnesses = survey.witnesses();
    }
    let lines = joined(window, survey.lines());
    judge.regions(&lines, survey.curves(), survey.loops())
}

/// What decides faces.
struct Judge {
    window: Window,
    sights: Vec<Sight>,
    /// Where a solution is known to be stable and admissible, beside curves.
    witnesses: Vec<Point>,
}

impl Judge {
    fn length(&self, [from, to]: [f64; 2]) -> f64 {
        (to - from) / self.window.widths()[0]
    }

    fn longest(&self, face: &Face, secondary: f64) -> f64 {
        chords(face, secondary).into_iter().map(|chord| self.length(chord)).fold(0.0, f64::max)
    }

    /// The η at which a slice is needed to judge a face, if none of those that there are will do,
    /// and how near to it another one would do as well.
    fn unseen(&self, face: &Face) -> Option<[f64; 2]> {
        let [low, high] = extent(face);
        let trial = |k: u32| low + (high - low) * (f64::from(k) + 0.5) / f64::from(TRIALS);
        let trials = (0..TRIALS).map(|k| (trial(k), self.longest(face, trial(k))));
        let (best, length) = trials.max_by(|a, b| a.1.total_cmp(&b.1))?;
        let seen = self.sights.iter().any(|sight| {
            low < sight.secondary
                && sight.secondary < high
                && self.longest(face, sight.secondary) >= LONG_ENOUGH * length
        });
        let height = self.window.widths()[1];
        let apart = (0.5 / f64::from(TRIALS) * (high - low)).min(NEAREST * height);
        (!seen && length > 0.0 && apart > LEAST_APART * height).then_some([best, apart])
    }

    /// Values of η that are not so close to one another or to a slice that another one would add
    /// nothing: evenly fewer than there are where slices would become too many. Those at which a
    /// face is `unseen` may be closer, each as it says.
    fn affordable(&self, unseen: Vec<[f64; 2]>, wanted: &[f64]) -> Vec<f64> {
        let nearest = NEAREST * self.window.widths()[1];
        let mut all = unseen;
        all.extend(wanted.iter().map(|level| [*level, nearest]));
        all.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut apart: Vec<f64> = Vec::new();
        for [level, nearest] in all {
            let known = self.sights.iter().map(|sight| sight.secondary).chain(apart.last().copied());
            if known.into_iter().all(|known| (known - level).abs() >= nearest) {
                apart.push(level);
            }
        }
        let left = MOST_SLICES.saturating_sub(self.sights.len());
        (0..apart.len().min(left)).map(|k| apart[k * apart.len() / apart.len().min(left)]).collect()
    }

    /// Values of η half the way between neighbouring slices one of which is in trouble in a face
    /// and the other is not: what is missing ends between them.
    fn between_verdicts(&self, face: Face) -> Vec<f64> {
        let trouble = self.judge(face).trouble;
        if trouble.is_empty() {
            return Vec::new();
        }
        let [first, last] = self.window.secondary;
        let mut levels: Vec<f64> = self.sights.iter().map(|sight| sight.secondary).collect();
        levels.extend([first, last]);
        levels.sort_by(f64::total_cmp);
        let pairs = levels.windows(2).filter(|pair| trouble.contains(&pair[0]) != trouble.contains(&pair[1]));
        pairs.map(|pair| 0.5 * (pair[0] + pair[1])).collect()
    }

    /// Values of η beside ends of curves inside the window at which no other curve ends and, if so
    /// asked, half the way from one to the next: a curve is missing there, which may lead to that.
    fn beside_loose_ends(&self, lines: &[Vec<Point>], to_next: bool) -> Vec<f64> {
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
        let beside = loose.iter().flat_map(|end| BESIDE.map(|share| end + share * height));
        let between = loose.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).filter(|_| to_next);
        beside
            .chain(between)
            .filter(|level| self.window.secondary[0] < *level && *level < self.window.secondary[1])
            .collect()
    }

    /// Values of η along curves that fewer slices cross than so many, half the way where that is
    /// one: what else begins beside them has not been seen.
    fn uncrossed(&self, lines: &[Vec<Point>], slices: u32) -> Vec<f64> {
        let extents = lines.iter().map(|line| extent(core::slice::from_ref(line)));
        let crossed = |[low, high]: &[f64; 2]| {
            let inside = self.sights.iter().filter(|it| *low < it.secondary && it.secondary < *high);
            inside.count() >= slices as usize
        };
        let along = |[low, high]: &[f64; 2]| high - low < ALONG * self.window.widths()[1];
        let share = |k: u32| f64::from(k) / f64::from(slices + 1);
        extents
            .filter(|extent| !crossed(extent) && !along(extent))
            .flat_map(|[low, high]| (1..=slices).map(move |k| low + share(k) * (high - low)))
            .collect()
    }

    fn judge(&self, face: Face) -> FaceVerdict {
        let [low, high] = extent(&face);
        let mut votes: Vec<(f64, f64, f64)> = Vec::new();
        let (mut doubt, mut trouble) = (None, Vec::new());
        for sight in self.sights.iter().filter(|sight| low <= sight.secondary && sight.secondary <= high) {
            for chord in chords(&face, sight.secondary) {
                let (length, share) = (self.length(chord), sight.share(chord));
                votes.push((sight.secondary, length, share));
                let within = |primary: f64| chord[0] < primary && primary < chord[1];
                let known = sight.doubts.iter().find(|(primary, _)| within(*primary)).map(|(_, doubt)| doubt);
                let known = known.or(sight.everywhere.as_ref());
                let lesser = share.min(1.0 - share);
                let mixed = lesser > PURE && length > SHORT || lesser * length > STRETCH;
                // Where there are good solutions all along, nothing that is unknown of others
                // matters.
                let known = known.filter(|_| share < 1.0 - PURE);
                if let Some(reason) = known {
                    doubt.get_or_insert(reason.clone());
                    trouble.push(sight.secondary);
                } else if mixed {
                    doubt.get_or_insert(Doubt::Disagreement);
                    trouble.push(sight.secondary);
                }
            }
        }
        let total: f64 = votes.iter().map(|(_, length, _)| length).sum();
        let yes: f64 = votes.iter().filter(|(_, _, share)| *share >= 0.5).map(|(_, length, _)| length).sum();
        let majority = yes > 0.5 * total;
        let minority = if majority { total - yes } else { yes };
        let thin = votes.iter().all(|(_, length, _)| *length < THIN);
        let outvoted = minority <= PURE * total;
        if !thin {
            let against = votes.iter().filter(|(_, _, share)| (*share >= 0.5) != majority);
            let against = against.filter(|(_, length, _)| !outvoted || *length > STRETCH);
            trouble.extend(against.map(|(secondary, ..)| *secondary));
            if !trouble.is_empty() {
                doubt.get_or_insert(Doubt::Disagreement);
            }
        }
        if !majority {
            // What is known beside a curve is not outvoted either.
            let known = trouble.len();
            trouble.extend(self.witnesses_in(&face));
            if trouble.len() > known {
                doubt.get_or_insert(Doubt::Disagreement);
            }
        }
        let verdict = match doubt {
            _ if votes.is_empty() => Err(Doubt::Unseen),
            Some(doubt) => Err(doubt),
            None => Ok(majority),
        };
        FaceVerdict { face, verdict, trouble }
    }

    /// The values of η of the witnesses that lie clearly inside a face.
    fn witnesses_in(&self, face: &Face) -> impl Iterator<Item = f64> {
        let room = CLEAR * self.window.widths()[0];
        let inside = move |[primary, secondary]: Point| {
            chords(face, secondary).iter().any(|[from, to]| from + room < primary && primary < to - room)
        };
        self.witnesses.iter().filter(move |at| inside(**at)).map(|at| at[1])
    }

    /// Values of η at which good solutions are known beside a curve in a face in which no slice
    /// sees any.
    fn contradicted(&self, face: &Face) -> Vec<f64> {
        if self.judge(face.clone()).verdict == Ok(true) {
            return Vec::new();
        }
        self.witnesses_in(face).collect()
    }

    /// Horizontal lines that part the slices at which there is trouble from the others.
    fn bands(&self, judged: &FaceVerdict) -> Vec<Vec<Point>> {
        let levels: Vec<f64> = self.sights.iter().map(|sight| sight.secondary).collect();
        let mut cuts: Vec<f64> = Vec::new();
        for level in &judged.trouble {
            let below =
                levels.iter().copied().filter(|other| other < level).fold(f64::NEG_INFINITY, f64::max);
            let above = levels.iter().copied().filter(|other| other > level).fold(f64::INFINITY, f64::min);
            cuts.extend(
                [below, above]
                    .into_iter()
                    .filter(|other| other.is_finite())
                    .map(|other| 0.5 * (other + level)),
            );
        }
        cuts.sort_by(f64::total_cmp);
        cuts.dedup();
        let [left, right] = self.window.primary;
        cuts.into_iter().map(|level| vec![[left, level], [right, level]]).collect()
    }

    /// Judges a face that has trouble again in bands, each about one of the slices at which there
    /// is some; a band that no slice meets is as doubtful as the whole.
    fn parted(&self, judged: FaceVerdict) -> Vec<FaceVerdict> {
        let Err(doubt) = &judged.verdict else { return vec![judged] };
        let bands = self.bands(&judged);
        let parts = faces::part(&judged.face, &bands).into_iter().map(|face| {
            let part = self.judge(face);
            let verdict = if part.verdict == Err(Doubt::Unseen) { Err(doubt.clone()) } else { part.verdict };
            FaceVerdict { verdict, ..part }
        });
        parts.collect()
    }

    /// The regions into which lines cut the window.
    fn regions(&self, lines: &[Vec<Point>], curves: &[DiagramCurve], loops: u32) -> Vec<Region> {
        let faces = faces::cut(self.window, lines).into_iter();
        let judged: Vec<FaceVerdict> = faces.flat_map(|face| self.parted(self.judge(face))).collect();
        let faces: Vec<&Face> = judged.iter().filter(|j| j.verdict == Ok(true)).map(|j| &j.face).collect();
        let mut regions: Vec<(usize, Region)> = Vec::new();
        let [width, height] = self.window.widths();
        let is_one = |rings: &Face| faces::area(rings) > NOTHING * width * height;
        for rings in faces::unite(&faces).into_iter().filter(is_one) {
            let place = self.bordering(&rings, curves);
            let n = place.map_or(0, |index| curves[index].n);
            regions.push((place.unwrap_or(usize::MAX), Region { loops, n, rings, doubt: None }));
        }
        regions.sort_by_key(|(place, _)| *place);
        let mut regions: Vec<Region> = regions.into_iter().map(|(_, region)| region).collect();
        for judged in judged.into_iter().filter(|judged| !self.speck(&judged.face)) {
            if let Err(doubt) = judged.verdict {
                regions.push(Region { loops, n: 0, rings: judged.face, doubt: Some(doubt) });
            }
        }
        regions
    }

    /// Less than can be seen or drawn: where the chords of two curves that touch cross each other.
    fn speck(&self, face: &Face) -> bool {
        let [width, height] = self.window.widths();
        faces::area(face) < SPECK * width * height
    }

    /// The first saddle-node curve on the border of a region, or else the first curve.
    fn bordering(&self, face: &Face, curves: &[DiagramCurve]) -> Option<usize> {
        let on_border = |curve: &DiagramCurve| {
            let points = curve.curve.parameters();
            let inner = &points[1..points.len().max(2) - 1];
            inner
                .iter()
                .any(|point| face.iter().flatten().any(|vertex| gap(self.window, *vertex, *point) < MEET))
        };
        let first = |saddle_node: bool| {
            curves
                .iter()
                .position(|curve| (curve.kind == Bifurcation::SaddleNode) == saddle_node && on_border(curve))
        };
        first(true).or_else(|| first(false))
    }
}

/// Ends of curves closer than this share of the ranges meet there; they were located to about
/// 10⁻¹⁰.
const MEET: f64 = 1e-7;

/// The distance of two points in shares of the ranges.
fn gap(window: Window, a: Point, b: Point) -> f64 {
    let [width, height] = window.widths();
    ((a[0] - b[0]) / width).abs().max(((a[1] - b[1]) / height).abs())
}

/// The lines with ends that meet made equal.
fn joined(window: Window, mut lines: Vec<Vec<Point>>) -> Vec<Vec<Point>> {
    let mut ends: Vec<Point> = Vec::new();
    for line in &mut lines {
        let last = line.len().saturating_sub(1);
        for index in [0, last] {
            let Some(point) = line.get_mut(index) else { continue };
            for (value, [low, high]) in point.iter_mut().zip([window.primary, window.secondary]) {
                // An end on the edge of the window, give or take rounding, cuts it.
                let edge = [low, high].into_iter().find(|edge| ((*value - edge) / (high - low)).abs() < MEET);
                *value = edge.unwrap_or(*value);
            }
            match ends.iter().find(|end| gap(window, **end, *point) < MEET) {
                Some(end) => *point = *end,
                None => ends.push(*point),
            }
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use grazing_results::plane::RegionKind;

    use super::*;

    #[test]
    fn slices_keep_their_distance_and_are_no_more_than_can_be_afforded() {
        let window = Window { primary: [0.0, 1.0], secondary: [0.0, 2.0] };
        let (good, doubts) = (Vec::new(), Vec::new());
        let judge = Judge {
            window,
            sights: vec![Sight { secondary: 1.0, good, doubts, everywhere: None }],
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
    fn a_slice_that_differs_is_not_outvoted() {
        let window = Window { primary: [0.0, 1.0], secondary: [0.0, 1.0] };
        // A sliver that chords of curves have left open where it ends.
        let [left, right] = [0.4, 0.42];
        let block = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.4], [right, 0.4]];
        let sliver = [[right, 0.6], [left, 0.6], [left, 0.4], [0.0, 0.4]];
        let face: Face = vec![[block, sliver].concat()];
        let sight = |secondary: f64, good: Vec<[f64; 2]>| Sight {
            secondary,
            good,
            doubts: Vec::new(),
            everywhere: None,
        };
        let nothing = [0.1, 0.2, 0.3].map(|secondary| sight(secondary, Vec::new()));
        let sights = nothing.into_iter().chain([sight(0.5, vec![[left, right]])]).collect();
        let judge = Judge { window, sights, witnesses: Vec::new() };
        let judged = judge.judge(face);
        assert!(judged.verdict.is_err());
        let parts = judge.parted(judged);
        let verdict = |at: Point| {
            parts.iter().find(|part| faces::holds(&part.face, at)).map(|part| part.verdict.clone())
        };
        assert_eq!(verdict([0.41, 0.5]), Some(Ok(true)));
        assert_eq!(verdict([0.5, 0.1]), Some(Ok(false)));
    }

    #[test]
    fn what_a_curve_knows_of_a_place_beside_it_is_not_outvoted() {
        let window = Window { primary: [0.0, 1.0], secondary: [0.0, 1.0] };
        let nothing =
            |secondary: f64| Sight { secondary, good: Vec::new(), doubts: Vec::new(), everywhere: None };
        let square: Face = vec![vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]];
        let judge =
            |witnesses: Vec<Point>| Judge { window, sights: [0.2, 0.5, 0.8].map(nothing).into(), witnesses };
        assert_eq!(judge(Vec::new()).judge(square.clone()).verdict, Ok(false));
        // As near to the border as a curve is drawn, it may belong to the other side.
        assert_eq!(judge(vec![[1e-4, 0.3]]).judge(square.clone()).verdict, Ok(false));
        let judge = judge(vec![[0.4, 0.3]]);
        assert_eq!(judge.contradicted(&square), [0.3]);
        let judged = judge.judge(square);
        assert_eq!(judged.verdict, Err(Doubt::Disagreement));
        let parts = judge.parted(judged);
        let verdict =
            |at: Point| parts.iter().find(|part| faces::holds(&part.face, at)).map(|part| &part.verdict);
        assert!(verdict([0.4, 0.3]).is_some_and(|verdict| verdict.is_err()));
        assert_eq!(verdict([0.4, 0.9]), Some(&Ok(false)));
    }

    const UNIT: Window = Window { primary: [0.0, 1.0], secondary: [0.0, 1.0] };

    fn sight(secondary: f64, good: &[[f64; 2]], doubts: &[f64]) -> Sight {
        let doubts = doubts.iter().map(|primary| (*primary, Doubt::ManyBranches)).collect();
        Sight { secondary, good: good.to_vec(), doubts, everywhere: None }
    }

    /// What becomes of the whole window, cut by no curve.
    fn whole(sights: Vec<Sight>) -> Vec<(RegionKind, Option<Doubt>)> {
        let regions = Judge { window: UNIT, sights, witnesses: Vec::new() }.regions(&[], &[], 1);
        regions.into_iter().map(|region| (region.kind(), region.doubt)).collect()
    }

    #[test]
    fn a_doubt_leaves_a_face_undecided_unless_good_solutions_are_there_all_along() {
        let (none, all): (&[[f64; 2]], &[[f64; 2]]) = (&[], &[[0.0, 1.0]]);
        let undecided = (RegionKind::Undecided, Some(Doubt::ManyBranches));
        assert_eq!(whole(vec![sight(0.3, none, &[]), sight(0.6, none, &[])]), []);
        assert_eq!(whole(vec![sight(0.3, all, &[]), sight(0.6, all, &[])]), [(RegionKind::Mps, None)]);
        assert_eq!(whole(vec![sight(0.3, all, &[0.5])]), [(RegionKind::Mps, None)]);
        assert_eq!(whole(vec![sight(0.3, none, &[0.5])]).as_slice(), std::slice::from_ref(&undecided));
        // Half of a slice, where no curve runs, and a doubt about all of a slice.
        let disagreement = (RegionKind::Undecided, Some(Doubt::Disagreement));
        assert_eq!(whole(vec![sight(0.3, &[[0.0, 0.5]], &[])]), [disagreement]);
        let everywhere = Sight { everywhere: Some(Doubt::ManyBranches), ..sight(0.3, none, &[]) };
        assert_eq!(whole(vec![everywhere]), [undecided]);
        // And without a slice.
        assert_eq!(whole(Vec::new()), [(RegionKind::Undecided, Some(Doubt::Unseen))]);
    }

    #[test]
    fn every_slice_of_a_face_counts() {
        let all: &[[f64; 2]] = &[[0.0, 1.0]];
        let face: Face = vec![vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]];
        let levels = [0.2, 0.4, 0.6, 0.8];
        for other in levels {
            let good = |level: f64| if level == other { &[][..] } else { all };
            let sights = levels.map(|level| sight(level, good(level), &[])).to_vec();
            let judged = Judge { window: UNIT, sights, witnesses: Vec::new() }.judge(face.clone());
            assert_eq!(judged.verdict, Err(Doubt::Disagreement), "{other}");
            assert_eq!(judged.trouble, [other]);
        }
    }

    #[test]
    fn slices_are_laid_beside_loose_ends_and_through_curves_that_none_crosses() {
        let judge = Judge { window: UNIT, sights: vec![sight(0.5, &[], &[])], witnesses: Vec::new() };
        // From the edge to a loose end, and two curves that meet.
        let line = |points: &[Point]| points.to_vec();
        let loose = line(&[[0.0, 0.3], [0.4, 0.6]]);
        let pair = [line(&[[0.0, 0.1], [0.7, 0.2]]), line(&[[0.7, 0.2], [1.0, 0.1]])];
        assert_eq!(judge.beside_loose_ends(&pair, true), []);
        let levels = judge.beside_loose_ends(&[loose.clone(), pair[0].clone(), pair[1].clone()], true);
        assert_eq!(levels, BESIDE.map(|share| 0.6 + share));
        // What leads from there to another loose end lies between.
        let levels = judge.beside_loose_ends(&[loose.clone(), line(&[[0.0, 0.8], [0.4, 0.7]])], true);
        assert!(levels.contains(&(0.5 * (0.6 + 0.7))), "{levels:?}");
        let [first, second] = pair;
        assert_eq!(judge.uncrossed(&[loose, first, second], 1), [0.5 * (0.1 + 0.2); 2]);
    }
}
