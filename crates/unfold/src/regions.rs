//! Regions of stability in the plane of the two parameters (μ, η), decided face by face.
//!
//! The curves of one p cut the window into faces. In every face the solutions are examined along
//! slices of constant η: a face in which every slice has a stable, admissible solution along its
//! whole length is shaded, one in which none does is not, and where slices disagree, or a branch
//! could not be followed, the face is reported as undecided.

mod face_stability;
mod slice_placement;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::Window;
use grazing_input::OwnCurve;
use grazing_model::AnyOscillator;
use grazing_model::smooth::Purpose;

use crate::Scope;
use crate::curves::{DiagramCurve, Net};
use crate::entering_curves;
use crate::faces::{self, Face, Point};
use crate::grazing::GrazingCurve;
use crate::own_curves::FoundCurves;
use crate::parallel;
use crate::progress::Progress;
use crate::search;
use crate::survey::Survey;

use self::face_stability::{FaceVerdict, Judge};
pub use crate::region::{Doubt, Region};

/// Faces with less than this fraction of the window's area are residues of rounding between curves
/// that meet: they are located to some 10⁻¹⁰.
const NOTHING: f64 = 1e-12;
/// Undecided faces with less than this fraction of the window's area are left out: the chords of
/// two curves that cross at a small angle leave such faces between them.
const SPECK: f64 = 1e-7;
/// Room, as a fraction of the range of μ, to both sides of what slices do not agree on, beyond which they
/// decide.
const ABOUT_DOUBTS: f64 = 0.02;
/// Number of intervals between the first slices of the whole window.
const SLICES: u32 = 16;
/// Largest number of rounds in which slices are added where they are needed.
const ROUNDS: usize = 8;
/// Number of slices that cross a curve at which branches begin: a region that begins there and ends
/// on both sides may be as high as a fraction of the curve.
const ABOUT_BEGINNINGS: u32 = 5;

/// The values of η of the first slices.
pub(crate) fn levels(window: Window) -> Vec<f64> {
    (0..=SLICES).map(|k| window.parameters([0.0, f64::from(k) / f64::from(SLICES)])[1]).collect()
}

/// The stage in which regions of MPSs are decided.
pub(crate) const STAGE: &str = "regions";

/// Receives p, curves and regions of its MPSs.
pub type Decided<'a> = &'a (dyn Fn(u32, &[DiagramCurve], &[Region]) + Sync);

/// The regions of the MPSs of each p with the requested curves, where nothing is decided if the computation
/// was cancelled early; bifurcation curves found to be missing on the way are added. `finished` receives
/// each p as soon as its regions are decided.
pub(crate) fn of_mps(
    oscillator: &AnyOscillator,
    (scope, requested): (&Scope, &[OwnCurve]),
    grazing: &[GrazingCurve],
    nets: &mut [Net],
    progress: &dyn Progress,
    finished: Decided<'_>,
) -> Vec<(Option<Vec<Region>>, FoundCurves)> {
    let window = scope.window;
    let levels = levels(window);
    progress.begin(STAGE, nets.len() as u64);
    let found = search::on_slices(oscillator, &scope.loops, window, &levels, progress);
    let about = entering_curves::about(scope);
    let beyond = Purpose::Curves.during(|| entering_curves::followed(grazing, &about));
    let regions = parallel::map(nets, |net| {
        let loops = net.loops();
        let found = found.iter().filter(|(p, _)| *p == loops).map(|(_, solution)| solution.clone()).collect();
        let mut survey = Survey::new(net, scope, grazing, found);
        survey.look_outside(&about, &beyond);
        let regions = decided(window, &mut survey, &levels, progress);
        if let Some(regions) = &regions
            && !progress.stopped()
        {
            finished(loops, survey.curves(), regions);
        }
        let own = survey.own_curves(requested, progress);
        progress.step(STAGE);
        (regions, if progress.stopped() { FoundCurves::default() } else { own })
    });
    progress.end(STAGE);
    regions
}

/// The regions of the solutions of a survey, from slices at some values of η and wherever else they
/// are needed. If the computation is cancelled after the first slices what they show is decided, and
/// the rest not finished; `None` if it is cancelled before.
pub(crate) fn decided(
    window: Window,
    survey: &mut Survey<'_>,
    levels: &[f64],
    progress: &dyn Progress,
) -> Option<Vec<Region>> {
    let seen = refined(window, survey, levels, progress, |judge, survey, lines| {
        let faces = faces::cut(window, lines);
        let unseen: Vec<[f64; 2]> = faces.iter().filter_map(|face| judge.unseen(face)).collect();
        let mut wanted: Vec<f64> = faces.iter().flat_map(|face| judge.contradicted(face)).collect();
        wanted.extend(faces.into_iter().flat_map(|face| judge.between_verdicts(face)));
        wanted.extend(judge.beside_loose_ends(lines, survey.loops() > 0));
        wanted.extend(across_curves(judge, survey, lines));
        judge.affordable(unseen, &wanted)
    });
    let Evidence { judge, lines, curves, is_whole } = seen?;
    if is_whole {
        return Some(judge.regions(&lines, survey.curves(), survey.loops(), false));
    }
    let regions = judge.regions(&lines, &curves, survey.loops(), true);
    survey.return_to(curves);
    Some(regions)
}

/// What slices show, and the lines that cut the window.
struct Evidence {
    judge: Judge,
    lines: Vec<Vec<Point>>,
    curves: Vec<DiagramCurve>,
    /// Whether nothing is missing.
    is_whole: bool,
}

/// Completes a survey without regions: lays slices across all its curves, and across those at which
/// its branches begin.
pub(crate) fn crossed(window: Window, survey: &mut Survey<'_>, levels: &[f64], progress: &dyn Progress) {
    refined(window, survey, levels, progress, |judge, survey, lines| {
        judge.affordable(Vec::new(), &across_curves(judge, survey, lines))
    });
}

fn across_curves(judge: &Judge, survey: &Survey<'_>, lines: &[Vec<Point>]) -> Vec<f64> {
    [judge.uncrossed(lines, 1), judge.uncrossed(&survey.beginnings(), ABOUT_BEGINNINGS)].concat()
}

/// Lays slices at some values of η, then at those that are wanted once these are known, and so on. What was
/// seen last when the computation is cancelled is left out; `None` if that is everything.
fn refined(
    window: Window,
    survey: &mut Survey<'_>,
    levels: &[f64],
    progress: &dyn Progress,
    wanted: impl Fn(&Judge, &Survey<'_>, &[Vec<Point>]) -> Vec<f64>,
) -> Option<Evidence> {
    let mut last = None;
    let mut levels = levels.to_vec();
    for round in 0..=ROUNDS {
        survey.look_at(&levels);
        let mut goes_on = true;
        while goes_on {
            goes_on = survey.goes_on(progress);
            let witnesses = if goes_on { Vec::new() } else { survey.witnesses() };
            let judge = Judge { window, slices: survey.stabilities(), witnesses };
            let lines = joined(window, survey.lines());
            survey.number();
            let is_last = goes_on || round == ROUNDS;
            levels = if is_last { Vec::new() } else { wanted(&judge, survey, &lines) };
            // Only now is it known that nothing of this was cancelled.
            if progress.stopped() {
                return last;
            }
            let is_whole = !goes_on && levels.is_empty();
            let curves = if is_whole { Vec::new() } else { survey.curves().to_vec() };
            last = Some(Evidence { judge, lines, curves, is_whole });
        }
        if levels.is_empty() && !survey.enters(progress) {
            break;
        }
    }
    last
}

impl Judge {
    /// Horizontal lines that separate the slices with trouble from the others.
    fn bands(&self, judged: &FaceVerdict) -> Vec<Vec<Point>> {
        let levels: Vec<f64> = self.slices.iter().map(|slice| slice.secondary).collect();
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

    /// Judges a face with trouble again in bands, each about one of the slices with trouble, and these in
    /// parts, beside what is doubtful and about it; a part that no slice meets is as doubtful as the whole.
    fn parted(&self, judged: FaceVerdict) -> Vec<FaceVerdict> {
        let Err(doubt) = &judged.verdict else { return vec![judged] };
        let judge = |face: Face| {
            let part = self.judge(face);
            let verdict = if part.verdict == Err(Doubt::Unseen) { Err(doubt.clone()) } else { part.verdict };
            FaceVerdict { verdict, ..part }
        };
        let in_bands = faces::part(&judged.face, &self.bands(&judged)).into_iter().map(judge);
        let about = |band: FaceVerdict| match band.verdict {
            Ok(_) => vec![band],
            Err(_) => {
                let lines = self.about_doubts(&band.face);
                faces::part(&band.face, &lines).into_iter().map(judge).collect::<Vec<_>>()
            }
        };
        in_bands.flat_map(about).collect()
    }

    /// Vertical lines to both sides of what slices show in a face or doubt there; none where they doubt all of it.
    fn about_doubts(&self, face: &Face) -> Vec<Vec<Point>> {
        let [low, high] = faces::extent(face);
        let [left, right] = self.window.primary;
        let [mut first, mut last] = [f64::INFINITY, f64::NEG_INFINITY];
        for slice in self.slices.iter().filter(|slice| low <= slice.secondary && slice.secondary <= high) {
            if slice.everywhere.is_some() {
                return Vec::new();
            }
            let chords = faces::chords(face, slice.secondary);
            let doubts = slice.doubts.iter().map(|(primary, _)| [*primary; 2]);
            for [from, to] in slice.good.iter().copied().chain(doubts) {
                for [begin, end] in chords.iter().filter(|[begin, end]| *begin < to && from < *end) {
                    (first, last) = (first.min(from.max(*begin)), last.max(to.min(*end)));
                }
            }
        }
        let room = ABOUT_DOUBTS * (right - left);
        let lines = [first - room, last + room].into_iter().filter(|at| left < *at && *at < right);
        let beyond = high - low;
        lines.map(|at| vec![[at, low - beyond], [at, high + beyond]]).collect()
    }

    /// The regions into which lines cut the window.
    ///
    /// If solutions may be missing only faces in which they are stable and admissible are decided.
    fn regions(
        &self,
        lines: &[Vec<Point>],
        curves: &[DiagramCurve],
        loops: u32,
        incomplete: bool,
    ) -> Vec<Region> {
        let faces = faces::cut(self.window, lines).into_iter();
        let judged =
            faces.flat_map(|face| self.parted(self.judge(face))).map(|judged| match judged.verdict {
                Ok(true) => judged,
                _ if incomplete => FaceVerdict { verdict: Err(Doubt::NotFinished), ..judged },
                _ => judged,
            });
        let judged: Vec<FaceVerdict> = judged.collect();
        let faces: Vec<&Face> = judged.iter().filter(|j| j.verdict == Ok(true)).map(|j| &j.face).collect();
        let mut regions: Vec<(usize, Region)> = Vec::new();
        let [width, height] = self.window.widths();
        let is_one = |rings: &Face| faces::area(rings) > NOTHING * width * height;
        for rings in faces::unite(&faces).into_iter().filter(is_one) {
            let bordering = self.bordering(&rings, curves);
            let n = bordering.iter().map(|index| curves[*index].n).max().unwrap_or(0);
            let place = bordering.first().copied().unwrap_or(usize::MAX);
            regions.push((place, Region { loops, n, rings, doubt: None }));
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

    /// Whether a face is too small to be seen or drawn: the chords of two curves that touch cross
    /// there.
    fn speck(&self, face: &Face) -> bool {
        let [width, height] = self.window.widths();
        faces::area(face) < SPECK * width * height
    }

    /// The indices of the curves on the border of a region, saddle-node curves first.
    fn bordering(&self, face: &Face, curves: &[DiagramCurve]) -> Vec<usize> {
        let on_border = |curve: &DiagramCurve| {
            let points = curve.curve.parameters();
            let inner = &points[1..points.len().max(2) - 1];
            inner
                .iter()
                .any(|point| face.iter().flatten().any(|vertex| gap(self.window, *vertex, *point) < MEET))
        };
        let mut found: Vec<usize> = (0..curves.len()).filter(|k| on_border(&curves[*k])).collect();
        found.sort_by_key(|k| curves[*k].kind != Bifurcation::SaddleNode);
        found
    }
}

/// Ends of curves closer than this fraction of the ranges meet there; they were located to about
/// 10⁻¹⁰.
const MEET: f64 = 1e-7;

/// The distance of two points in fractions of the ranges.
fn gap(window: Window, a: Point, b: Point) -> f64 {
    let [width, height] = window.widths();
    ((a[0] - b[0]) / width).abs().max(((a[1] - b[1]) / height).abs())
}

/// The lines, with ends that meet made equal.
fn joined(window: Window, mut lines: Vec<Vec<Point>>) -> Vec<Vec<Point>> {
    let mut ends: Vec<Point> = Vec::new();
    for line in &mut lines {
        let last = line.len().saturating_sub(1);
        for index in [0, last] {
            let Some(point) = line.get_mut(index) else { continue };
            for (value, [low, high]) in point.iter_mut().zip([window.primary, window.secondary]) {
                // An end on the edge of the window, up to rounding, cuts it.
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
    use crate::slice_stability::SliceStability;

    #[test]
    fn a_slice_that_differs_is_not_outvoted() {
        let window = Window { primary: [0.0, 1.0], secondary: [0.0, 1.0] };
        // A sliver that the chords of curves have left open at its end.
        let [left, right] = [0.4, 0.42];
        let block = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.4], [right, 0.4]];
        let sliver = [[right, 0.6], [left, 0.6], [left, 0.4], [0.0, 0.4]];
        let face: Face = vec![[block, sliver].concat()];
        let slice = |secondary: f64, good: Vec<[f64; 2]>| SliceStability {
            secondary,
            good,
            doubts: Vec::new(),
            everywhere: None,
        };
        let nothing = [0.1, 0.2, 0.3].map(|secondary| slice(secondary, Vec::new()));
        let slices = nothing.into_iter().chain([slice(0.5, vec![[left, right]])]).collect();
        let judge = Judge { window, slices, witnesses: Vec::new() };
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
        let nothing = |secondary: f64| SliceStability {
            secondary,
            good: Vec::new(),
            doubts: Vec::new(),
            everywhere: None,
        };
        let square: Face = vec![vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]];
        let judge =
            |witnesses: Vec<Point>| Judge { window, slices: [0.2, 0.5, 0.8].map(nothing).into(), witnesses };
        assert_eq!(judge(Vec::new()).judge(square.clone()).verdict, Ok(false));
        // As near to the border as the accuracy of drawing, it may belong to the other side.
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

    fn slice(secondary: f64, good: &[[f64; 2]], doubts: &[f64]) -> SliceStability {
        let doubts = doubts.iter().map(|primary| (*primary, Doubt::ManyBranches)).collect();
        SliceStability { secondary, good: good.to_vec(), doubts, everywhere: None }
    }

    /// The regions of the whole window, cut by no curve.
    fn whole(slices: Vec<SliceStability>) -> Vec<(RegionKind, Option<Doubt>)> {
        let regions = Judge { window: UNIT, slices, witnesses: Vec::new() }.regions(&[], &[], 1, false);
        regions.into_iter().map(|region| (region.kind(), region.doubt)).collect()
    }

    #[test]
    fn a_doubt_leaves_a_face_undecided_unless_good_solutions_are_there_all_along() {
        let (none, all): (&[[f64; 2]], &[[f64; 2]]) = (&[], &[[0.0, 1.0]]);
        let undecided = (RegionKind::Undecided, Some(Doubt::ManyBranches));
        assert_eq!(whole(vec![slice(0.3, none, &[]), slice(0.6, none, &[])]), []);
        assert_eq!(whole(vec![slice(0.3, all, &[]), slice(0.6, all, &[])]), [(RegionKind::Mps, None)]);
        assert_eq!(whole(vec![slice(0.3, all, &[0.5])]), [(RegionKind::Mps, None)]);
        assert_eq!(whole(vec![slice(0.3, none, &[0.5])]).as_slice(), std::slice::from_ref(&undecided));
        // Half of a slice, where no curve runs, and a doubt about all of a slice.
        let disagreement = (RegionKind::Undecided, Some(Doubt::Disagreement));
        assert_eq!(whole(vec![slice(0.3, &[[0.0, 0.5]], &[])]), [disagreement]);
        let everywhere = SliceStability { everywhere: Some(Doubt::ManyBranches), ..slice(0.3, none, &[]) };
        assert_eq!(whole(vec![everywhere]), [undecided]);
        // And without a slice.
        assert_eq!(whole(Vec::new()), [(RegionKind::Undecided, Some(Doubt::Unseen))]);
    }

    #[test]
    fn a_slice_beside_the_highest_point_of_a_curve_agrees_with_chords_that_it_hardly_meets() {
        // Chords with a vertex where the slice crosses the curve first; it crosses it again beyond.
        let [first, again] = [0.5, 0.502];
        let top = [[0.51, 0.4], [first, 0.6], [0.49, 0.4]];
        let face: Face = vec![[vec![[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]], top.to_vec()].concat()];
        let judged = |left: f64, right: f64| {
            let slices = vec![slice(0.6, &[[0.0, left], [right, 1.0]], &[]), slice(0.8, &[[0.0, 1.0]], &[])];
            Judge { window: UNIT, slices, witnesses: Vec::new() }.judge(face.clone()).verdict
        };
        // The chords, drawn to 1e-5, allow for a thousandth and more only beside their vertex.
        assert_eq!(judged(first, again), Err(Doubt::Disagreement));
        let flat: Face = vec![
            [
                vec![[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]],
                vec![[0.6, 0.599], [first, 0.6], [0.4, 0.4]],
            ]
            .concat(),
        ];
        let judge = |good: &[[f64; 2]]| {
            let slices = vec![slice(0.6, good, &[]), slice(0.8, &[[0.0, 1.0]], &[])];
            Judge { window: UNIT, slices, witnesses: Vec::new() }.judge(flat.clone()).verdict
        };
        // Its chord falls by 1e-5 over 1e-3: what the slice sees there may be below the curve.
        assert_eq!(judge(&[[0.0, first], [first + 1.05e-3, 1.0]]), Ok(true));
        assert_eq!(judge(&[[0.0, first], [first + 0.02, 1.0]]), Err(Doubt::Disagreement));
        assert_eq!(judge(&[[0.0, 0.7], [0.702, 1.0]]), Err(Doubt::Disagreement));
    }

    #[test]
    fn every_slice_of_a_face_counts() {
        let all: &[[f64; 2]] = &[[0.0, 1.0]];
        let face: Face = vec![vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]];
        let levels = [0.2, 0.4, 0.6, 0.8];
        for other in levels {
            let good = |level: f64| if level == other { &[][..] } else { all };
            let slices = levels.map(|level| slice(level, good(level), &[])).to_vec();
            let judged = Judge { window: UNIT, slices, witnesses: Vec::new() }.judge(face.clone());
            assert_eq!(judged.verdict, Err(Doubt::Disagreement), "{other}");
            assert_eq!(judged.trouble, [other]);
        }
    }
}
