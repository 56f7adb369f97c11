//! The searches for events, cell by cell.

use super::cell::{Course, Crossing, Maximum, TimeCell};
use super::enclosure::{BoundedMotion, Enclosure, Kinematics, Walk};
use crate::tolerances::MOST_CELLS;

/// The cells of a motion from time 0 to `horizon`, up to which an enclosure reaches, in which x may
/// exceed `level`.
#[inline]
fn cells_above(
    motion: &impl BoundedMotion,
    enclosure: &impl Enclosure,
    horizon: f64,
    level: f64,
) -> impl Iterator<Item = TimeCell> {
    let stride = enclosure.stride();
    // Positions at both ends below this rule the cell out: |x − chord| ≤ h²/8 · max|ẍ|.
    let relevant = level - stride * stride / 8.0 * enclosure.acceleration();
    let whole_cells = enclosure.strides();
    let mut walk = enclosure.walk();
    let (mut index, mut position) = (0, walk.position());
    // The derivatives at the point where the walk stands, if the cell before needed them.
    let mut known: Option<Kinematics> = None;
    core::iter::from_fn(move || {
        // Local copies, so that the loop over ruled-out cells runs in registers.
        let (mut here, mut cell, mut above) = (walk, index, position >= relevant);
        while cell < whole_cells {
            let before = here;
            here.advance();
            cell += 1;
            let next = here.position();
            let next_above = next >= relevant;
            if above || next_above {
                let first = known.filter(|_| cell == index + 1).unwrap_or_else(|| before.kinematics());
                let last = here.kinematics();
                (walk, index, position, known) = (here, cell, next, Some(last));
                let [start, end] = [cell - 1, cell].map(|strides| enclosure.time_after(strides));
                return Some(TimeCell::within(enclosure, [start, end], [first, last]));
            }
            above = next_above;
        }
        if cell > index {
            (walk, index, known) = (here, cell, None);
        }
        let start = enclosure.time_after(index.min(whole_cells));
        // The rest of the time, shorter than a stride, comes last, unless the motion ends before
        // the horizon.
        if index > whole_cells || start >= horizon {
            return None;
        }
        index += 1;
        let last = motion.kinematics_at(horizon);
        let first = known.unwrap_or_else(|| walk.kinematics());
        last.position.is_finite().then(|| TimeCell::within(enclosure, [start, horizon], [first, last]))
    })
}

/// [`Motion::first_crossing`](super::Motion::first_crossing).
#[inline]
pub(super) fn first_crossing(motion: &impl BoundedMotion, horizon: f64) -> Option<Crossing> {
    let mut reach = motion.foresight().min(horizon);
    loop {
        let enclosure = motion.enclose(reach);
        let crossing = cells_above(motion, &enclosure, reach, 0.0).find_map(|cell| cell.crossing(motion));
        // NaN as the horizon ends the search as well.
        let more = reach < horizon;
        if crossing.is_some() || !more {
            return crossing;
        }
        reach = (2.0 * reach).min(horizon);
    }
}

/// [`Motion::local_maxima`](super::Motion::local_maxima).
pub(super) fn local_maxima(motion: &impl BoundedMotion, horizon: f64) -> Vec<Maximum> {
    let mut found = Vec::new();
    for cell in cells_above(motion, &motion.enclose(horizon), horizon, f64::NEG_INFINITY) {
        cell.maxima(motion, f64::NEG_INFINITY, &mut |maximum| {
            found.push(maximum);
            f64::NEG_INFINITY
        });
    }
    found
}

/// [`Motion::highest_maximum`](super::Motion::highest_maximum).
pub(super) fn highest_maximum(motion: &impl BoundedMotion, horizon: f64) -> Option<Maximum> {
    let enclosure = motion.enclose(horizon);
    let mut candidates: Vec<TimeCell> = Vec::with_capacity(8);
    // Where the velocity changes from + to − there is a maximum, at least as high as the cell's
    // ends.
    let mut threshold = highest_seen(&enclosure);
    for cell in cells_above(motion, &enclosure, horizon, threshold) {
        match cell.course() {
            Course::Monotone | Course::Curved { falling: false } => continue,
            Course::Curved { falling: true } | Course::Open => {}
        }
        if cell.first.velocity > 0.0 && cell.last.velocity <= 0.0 {
            threshold = threshold.max(cell.first.position.max(cell.last.position));
        }
        candidates.push(cell);
    }
    let mut highest: Option<Maximum> = None;
    for cell in candidates {
        threshold = cell.maxima(motion, threshold, &mut |maximum| {
            if highest.is_none_or(|other| other.position < maximum.position) {
                highest = Some(maximum);
            }
            maximum.position
        });
    }
    highest
}

/// The highest position after a stride that none before and after it exceeds: there is a local
/// maximum between these two, at least as high.
fn highest_seen(enclosure: &impl Enclosure) -> f64 {
    let mut walk = enclosure.walk();
    let (mut highest, mut before, mut here) = (f64::NEG_INFINITY, f64::INFINITY, walk.position());
    for _ in 0..enclosure.strides() {
        walk.advance();
        let after = walk.position();
        if before <= here && here >= after && here > highest {
            highest = here;
        }
        (before, here) = (here, after);
    }
    highest
}

/// [`Motion::first_rest`](super::Motion::first_rest).
pub(super) fn first_rest(motion: &impl BoundedMotion, forwards: bool, horizon: f64) -> Option<f64> {
    let sign = if forwards { 1.0 } else { -1.0 };
    let enclosure = motion.enclose(sign * horizon);
    let stride = enclosure.stride();
    let (mut start, mut first) = (0.0, motion.kinematics_at(0.0));
    let mut patience = MOST_CELLS;
    while start < horizon && patience > 0 {
        let end = (start + stride).min(horizon);
        let last = motion.kinematics_at(sign * end);
        if !last.position.is_finite() {
            return None;
        }
        let cell = TimeCell::within(&enclosure, [sign * start, sign * end], [first, last]);
        if let Some(time) = cell.rest(motion, &mut patience) {
            return Some(time);
        }
        (start, first) = (end, last);
        patience = patience.saturating_sub(1);
    }
    None
}
