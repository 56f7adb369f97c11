//! Curves that pass in front of each other: the farther one is interrupted where they cross on the sheet.

use crate::geometry::sheet::{Spot, distance};

/// A curve on the sheet with its distance from the viewer: coordinates to the right, downwards and away
/// from the viewer, in points.
pub(crate) type SpaceCurve = Vec<[f64; 3]>;

/// Half the gap in a curve where another one crosses it at a right angle, in points.
const PASSING_GAP: f64 = 2.2;
/// Curves whose distances differ by less than this (points) meet rather than pass.
const MEETING_DEPTH: f64 = 2.0;
/// The sine of the angle below which crossing curves run side by side for so long that a gap would be
/// meaningless.
const LEAST_CROSSING_SINE: f64 = 0.12;

/// The parts of a curve that remain when it is interrupted wherever a nearer one passes.
pub(crate) fn interrupted(course: &SpaceCurve, others: &[&SpaceCurve]) -> Vec<Vec<Spot>> {
    let mut gaps: Vec<[f64; 2]> = Vec::new();
    let mut start = 0.0;
    for pair in course.windows(2) {
        let (a, b) = (spot(&pair[0]), spot(&pair[1]));
        let step = distance(a, b);
        for other in others {
            for passing in other.windows(2) {
                if let Some((share, half)) = passed(pair, passing) {
                    let at = start + share * step;
                    gaps.push([at - half, at + half]);
                }
            }
        }
        start += step;
    }
    without(course, &gaps)
}

/// The position along the first segment at which the second one crosses it nearer to the viewer, and half
/// the length of the gap.
fn passed(far: &[[f64; 3]], near: &[[f64; 3]]) -> Option<(f64, f64)> {
    let (a, c) = (&far[0], &near[0]);
    let u = [far[1][0] - a[0], far[1][1] - a[1]];
    let v = [near[1][0] - c[0], near[1][1] - c[1]];
    let w = [c[0] - a[0], c[1] - a[1]];
    let cross = u[0] * v[1] - u[1] * v[0];
    if cross == 0.0 {
        return None;
    }
    let (s, t) = ((w[0] * v[1] - w[1] * v[0]) / cross, (w[0] * u[1] - w[1] * u[0]) / cross);
    if !((0.0..1.0).contains(&s) && (0.0..1.0).contains(&t)) {
        return None;
    }
    let depth = |from: &[f64; 3], to: &[f64; 3], share: f64| from[2] + share * (to[2] - from[2]);
    let before = depth(a, &far[1], s) - depth(c, &near[1], t);
    let sine = cross.abs() / ((u[0] * u[0] + u[1] * u[1]) * (v[0] * v[0] + v[1] * v[1])).sqrt();
    (before > MEETING_DEPTH && sine > LEAST_CROSSING_SINE).then(|| (s, PASSING_GAP / sine.max(0.4)))
}

/// The parts of a curve outside intervals of its length.
fn without(course: &SpaceCurve, gaps: &[[f64; 2]]) -> Vec<Vec<Spot>> {
    let mut parts: Vec<Vec<Spot>> = Vec::new();
    let mut goes_on = false;
    let mut start = 0.0;
    for pair in course.windows(2) {
        let (a, b) = (spot(&pair[0]), spot(&pair[1]));
        let step = distance(a, b);
        let inside = |at: f64| gaps.iter().any(|gap| gap[0] < at && at < gap[1]);
        // The part of the segment between the ends of gaps that lie on it.
        let mut cuts = vec![0.0, step];
        cuts.extend(gaps.iter().flatten().map(|end| end - start).filter(|cut| 0.0 < *cut && *cut < step));
        cuts.sort_by(f64::total_cmp);
        let at = |length: f64| {
            let share = if step > 0.0 { length / step } else { 0.0 };
            (a.0 + share * (b.0 - a.0), a.1 + share * (b.1 - a.1))
        };
        for ends in cuts.windows(2) {
            let seen = !inside(start + 0.5 * (ends[0] + ends[1]));
            match parts.last_mut().filter(|_| goes_on) {
                Some(part) if seen => part.push(at(ends[1])),
                None if seen => parts.push(vec![at(ends[0]), at(ends[1])]),
                _ => {}
            }
            goes_on = seen;
        }
        start += step;
    }
    parts
}

fn spot(point: &[f64; 3]) -> Spot {
    (point[0], point[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::sheet::length;

    fn straight(from: [f64; 3], to: [f64; 3]) -> SpaceCurve {
        let at = |k: u32, i: usize| from[i] + (to[i] - from[i]) * f64::from(k) / 40.0;
        (0..=40).map(|k| [at(k, 0), at(k, 1), at(k, 2)]).collect()
    }

    #[test]
    fn the_farther_of_two_crossing_curves_is_interrupted_and_the_nearer_is_whole() {
        let far = straight([0.0, 0.0, 50.0], [100.0, 0.0, 50.0]);
        let near = straight([50.3, -50.0, 10.0], [50.3, 50.0, 10.0]);
        let parts = interrupted(&far, &[&far, &near]);
        assert_eq!(parts.len(), 2);
        let drawn: f64 = parts.iter().map(|part| length(part)).sum();
        // Tolerance for the rounding of the lengths of forty segments.
        assert!((100.0 - 2.0 * PASSING_GAP - drawn).abs() < 1e-9, "{drawn}");
        assert!((parts[0].last().unwrap().0 - (50.3 - PASSING_GAP)).abs() < 1e-9);
        assert_eq!(interrupted(&near, &[&far, &near]).len(), 1);
    }

    #[test]
    fn curves_that_meet_in_space_are_not_interrupted() {
        let one = straight([0.0, 0.0, 10.0], [100.0, 0.0, 10.0]);
        let other = straight([50.3, -50.0, 10.5], [50.3, 50.0, 9.5]);
        assert_eq!(interrupted(&one, &[&other]).len(), 1);
        assert_eq!(interrupted(&other, &[&one]).len(), 1);
    }

    #[test]
    fn a_curve_can_pass_before_itself() {
        let mut loop_ = straight([0.0, 0.0, 90.0], [100.0, 0.0, 60.0]);
        loop_.extend(straight([100.0, 40.0, 50.0], [30.3, -30.0, 20.0]));
        assert_eq!(interrupted(&loop_, &[&loop_]).len(), 2);
    }
}
