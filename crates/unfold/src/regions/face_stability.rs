//! The judgement of a face by the slices that cross it.

use grazing_continuation::curve::Window;

use crate::faces::{Face, Point, chords, extent};
use crate::region::Doubt;
use crate::slice_stability::SliceStability;
use crate::tolerances::CLEAR;

/// Along chords shorter than this fraction of the window a face may seem mixed: curves are drawn by
/// chords of their own.
const SHORT: f64 = 2e-3;
/// A face all of whose chords are shorter than this is thinner than the accuracy of drawn curves:
/// the majority of its slices decides.
const THIN: f64 = 5e-4;
/// Tolerance for the fraction of a chord of a face with good solutions, which is 0 or 1 up to the
/// error of the curves' chords.
const PURE: f64 = 0.1;
/// Largest fraction of the window that may differ from the rest of a chord, however long.
const STRETCH: f64 = 1e-3;
/// The accuracy of drawn curves in η, as a fraction of its range: a slice that meets a curve beside its highest point
/// crosses it twice, and its chords once or not at all.
const ACCURACY_OF_CURVES: f64 = 1e-5;

/// A face and its verdict.
pub(super) struct FaceVerdict {
    pub(super) face: Face,
    pub(super) verdict: Result<bool, Doubt>,
    /// Values of η at which slices do not agree with the rest.
    pub(super) trouble: Vec<f64>,
}

/// The information by which faces are judged.
pub(super) struct Judge {
    pub(super) window: Window,
    pub(super) slices: Vec<SliceStability>,
    /// Points beside curves at which a solution is known to be stable and admissible.
    pub(super) witnesses: Vec<Point>,
}

impl Judge {
    pub(super) fn length(&self, [from, to]: [f64; 2]) -> f64 {
        (to - from) / self.window.widths()[0]
    }

    pub(super) fn longest(&self, face: &Face, secondary: f64) -> f64 {
        chords(face, secondary).into_iter().map(|chord| self.length(chord)).fold(0.0, f64::max)
    }

    pub(super) fn judge(&self, face: Face) -> FaceVerdict {
        let [low, high] = extent(&face);
        let mut votes: Vec<(f64, f64, f64)> = Vec::new();
        let (mut doubt, mut trouble) = (None, Vec::new());
        for slice in self.slices.iter().filter(|slice| low <= slice.secondary && slice.secondary <= high) {
            for chord in chords(&face, slice.secondary) {
                let (length, share) = (self.length(chord), slice.share(chord));
                votes.push((slice.secondary, length, share));
                let within = |primary: f64| chord[0] < primary && primary < chord[1];
                let known = slice.doubts.iter().find(|(primary, _)| within(*primary)).map(|(_, doubt)| doubt);
                let known = known.or(slice.everywhere.as_ref());
                let mixed = self.is_mixed(slice, chord) && self.stays_mixed(slice, &face, chord);
                // Where there are good solutions along the whole chord, doubts about others do not
                // matter.
                let known = known.filter(|_| share < 1.0 - PURE);
                if let Some(reason) = known {
                    doubt.get_or_insert(reason.clone());
                    trouble.push(slice.secondary);
                } else if mixed {
                    doubt.get_or_insert(Doubt::Disagreement);
                    trouble.push(slice.secondary);
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
            // Known solutions beside a curve are not outvoted either.
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

    /// Whether there are good solutions along a part of a chord, and none along another.
    fn is_mixed(&self, slice: &SliceStability, chord: [f64; 2]) -> bool {
        let (length, share) = (self.length(chord), slice.share(chord));
        let lesser = share.min(1.0 - share);
        lesser > PURE && length > SHORT || lesser * length > STRETCH
    }

    /// Whether that is so for the chords of a face beside a slice as well, to both sides.
    fn stays_mixed(&self, slice: &SliceStability, face: &Face, [from, to]: [f64; 2]) -> bool {
        let height = self.window.widths()[1];
        [-ACCURACY_OF_CURVES, ACCURACY_OF_CURVES].into_iter().all(|aside| {
            let beside = chords(face, slice.secondary + aside * height).into_iter();
            let mut beside = beside.filter(|[begin, end]| *begin < to && from < *end).peekable();
            beside.peek().is_none() || beside.any(|chord| self.is_mixed(slice, chord))
        })
    }

    /// The values of η of the witnesses that lie clearly inside a face.
    pub(super) fn witnesses_in(&self, face: &Face) -> impl Iterator<Item = f64> {
        let room = CLEAR * self.window.widths()[0];
        let inside = move |[primary, secondary]: Point| {
            chords(face, secondary).iter().any(|[from, to]| from + room < primary && primary < to - room)
        };
        self.witnesses.iter().filter(move |at| inside(**at)).map(|at| at[1])
    }
}
