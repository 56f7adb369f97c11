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
