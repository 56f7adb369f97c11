//! Shapes of the schematic as polylines of points (x, height).

use core::f64::consts::TAU;

use super::Polyline;

/// The number of chords of a full turn: on 90 mm of paper they deviate from the arc by less than a
/// hundredth of a millimetre.
const CHORDS: u32 = 48;

/// The lean of the coils of a spring, as a fraction of their radius, like a helix seen slightly from the
/// side.
const LEAN: f64 = 0.45;

/// A helix between two straight leads, symmetric about its middle.
///
/// (x, h) = (x₀ + ℓs + b (1 − cos θ), h₀ + r sin θ), θ = (2N − 1) π s, 0 ≤ s ≤ 1: N turns minus the half
/// turn below the axis h₀, on which it begins and ends. Under reflection about the middle, s becomes 1 −
/// s and cos θ becomes −cos θ.
pub(super) fn spring([from, to]: [f64; 2], height: f64, radius: f64, lead: f64, coils: u32) -> Polyline {
    let lean = LEAN * radius;
    let (start, length) = (from + lead, to - from - 2.0 * (lead + lean));
    let chords = CHORDS * coils - CHORDS / 2;
    let mut points = vec![[from, height]];
    for k in 0..=chords {
        let share = f64::from(k) / f64::from(chords);
        let (sine, cosine) = libm::sincos(TAU * f64::from(k % CHORDS) / f64::from(CHORDS));
        points.push([start + length * share + lean * (1.0 - cosine), height + radius * sine]);
    }
    points.push([to, height]);
    points
}

/// A circle as a closed polyline.
pub(super) fn circle([x, height]: [f64; 2], radius: f64) -> Polyline {
    let point = |k: u32| {
        let (sine, cosine) = libm::sincos(TAU * f64::from(k % CHORDS) / f64::from(CHORDS));
        [x + radius * cosine, height + radius * sine]
    };
    (0..=CHORDS).map(point).collect()
}

/// A rectangle as a closed polyline.
pub(super) fn rectangle([left, right]: [f64; 2], [bottom, top]: [f64; 2]) -> Polyline {
    vec![[left, bottom], [right, bottom], [right, top], [left, top], [left, bottom]]
}

/// Strokes at 45 degrees across a strip, cut off at its edges.
pub(super) fn hatching([left, right]: [f64; 2], [bottom, top]: [f64; 2]) -> Vec<Polyline> {
    const PITCH: f64 = 0.085;
    let width = right - left;
    let strokes = libm::floor((top - bottom + width) / PITCH) as u32;
    let stroke = |k: u32| {
        // The height at which the rising stroke would meet the left edge.
        let start = bottom - width + (f64::from(k) + 0.5) * PITCH;
        let low = start.max(bottom);
        let high = (start + width).min(top);
        (low < high).then(|| vec![[left + low - start, low], [left + high - start, high]])
    };
    (0..=strokes).filter_map(stroke).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spring_has_its_coils_between_its_ends_and_is_its_own_mirror_image() {
        for coils in [1, 9, 30] {
            let points = spring([-3.0, -1.0], 0.5, 0.15, 0.3, coils);
            assert_eq!((points[0], points[points.len() - 1]), ([-3.0, 0.5], [-1.0, 0.5]));
            for ([x, h], [x_mirrored, h_mirrored]) in points.iter().zip(points.iter().rev()) {
                // Rounding of numbers of order 1.
                assert!((x + x_mirrored + 4.0).abs() < 1e-14 && (h - h_mirrored).abs() < 1e-14);
            }
            let tops = points.windows(3).filter(|w| w[0][1] < w[1][1] && w[1][1] > w[2][1]).count();
            assert_eq!(tops, coils as usize);
            // The height is rounded once.
            assert!(points.iter().all(|[_, h]| (h - 0.5).abs() <= 0.15 + 1e-15));
        }
    }

    #[test]
    fn hatching_stays_in_its_strip_at_45_degrees() {
        let strokes = hatching([0.0, 0.2], [0.0, 1.45]);
        assert!(strokes.len() > 15, "{}", strokes.len());
        for stroke in strokes {
            let [[x0, h0], [x1, h1]] = stroke[..] else { panic!("a stroke has two ends") };
            // Differences of numbers of order 1 are accurate to about 1e-16.
            assert!(((x1 - x0) - (h1 - h0)).abs() < 1e-15);
            for (x, h) in [(x0, h0), (x1, h1)] {
                assert!((-1e-15..=0.2 + 1e-15).contains(&x) && (0.0..=1.45).contains(&h), "{x} {h}");
            }
        }
    }
}
