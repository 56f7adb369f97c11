//! Simplification of curves on the sheet (Douglas–Peucker), finer than the resolution of print.

use crate::geometry::sheet::Hundredths;

/// The greatest distance between a curve and its simplification, in hundredths of a point, which are 3.5
/// micrometres each.
const BELOW_PRINT_RESOLUTION: f64 = 1.0;

/// Omits points that lie within [`BELOW_PRINT_RESOLUTION`] of the line through those kept; both ends are
/// kept.
pub(crate) fn simplify(path: &[Hundredths]) -> Vec<Hundredths> {
    if path.len() < 3 {
        return path.to_vec();
    }
    let mut keep = vec![false; path.len()];
    keep[0] = true;
    keep[path.len() - 1] = true;
    // Chunks bound the work on long winding curves, for which the plain algorithm takes quadratic time.
    const CHUNK: usize = 256;
    let mut spans: Vec<(usize, usize)> = Vec::new();
    for start in (0..path.len() - 1).step_by(CHUNK) {
        let end = (start + CHUNK).min(path.len() - 1);
        keep[end] = true;
        spans.push((start, end));
    }
    while let Some((start, end)) = spans.pop() {
        let farthest = (start + 1..end)
            .map(|i| (off_segment(path[i], path[start], path[end]), i))
            .fold((0.0, start), |best, next| if next.0 > best.0 { next } else { best });
        if farthest.0 > BELOW_PRINT_RESOLUTION {
            keep[farthest.1] = true;
            spans.push((start, farthest.1));
            spans.push((farthest.1, end));
        }
    }
    path.iter().zip(keep).filter(|(_, kept)| *kept).map(|(&point, _)| point).collect()
}

/// Distance of a point from a segment.
fn off_segment(point: Hundredths, from: Hundredths, to: Hundredths) -> f64 {
    let (dx, dy) = (f64::from(to.0 - from.0), f64::from(to.1 - from.1));
    let (px, py) = (f64::from(point.0 - from.0), f64::from(point.1 - from.1));
    let squared = dx * dx + dy * dy;
    let t = if squared > 0.0 { ((px * dx + py * dy) / squared).clamp(0.0, 1.0) } else { 0.0 };
    let (ex, ey) = (px - t * dx, py - t * dy);
    (ex * ex + ey * ey).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_line_of_many_points_becomes_its_two_ends() {
        let line: Vec<Hundredths> = (0..=200).map(|i| (3 * i, 2 * i)).collect();
        assert_eq!(simplify(&line), [(0, 0), (600, 400)]);
    }

    #[test]
    fn no_point_moves_by_more_than_the_tolerance() {
        let parabola: Vec<Hundredths> = (0..=1000).map(|i| (i * 10, (i - 500) * (i - 500) / 50)).collect();
        let kept = simplify(&parabola);
        assert!(kept.len() < 150, "{}", kept.len());
        for &point in &parabola {
            let off = kept.windows(2).map(|s| off_segment(point, s[0], s[1])).fold(f64::INFINITY, f64::min);
            assert!(off <= BELOW_PRINT_RESOLUTION);
        }
    }

    #[test]
    fn a_spike_is_kept() {
        assert_eq!(simplify(&[(0, 0), (100, 0), (101, 900), (102, 0), (200, 0)]).len(), 5);
    }
}
