//! Shaded regions of any oscillator against what simulation from random states settles on.

use core::f64::consts::TAU;

use grazing_continuation::curve::Window;
use grazing_description::Description;
use grazing_model::orbit::{FlightEnd, Orbit};
use grazing_model::smooth::Integrated;
use grazing_model::{ImpactOscillator, State};
use grazing_unfold::progress::Silent;
use grazing_unfold::{Diagram, Scope, UnfoldError};
use rayon::prelude::*;

use crate::random::Random;
use crate::regions::distance;

/// What was seen on a lattice of points.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// How often motion settled on a p-loop solution where it is shaded or hatched.
    pub explained: usize,
    /// (p, point) where it did and nothing is shaded.
    pub unexplained: Vec<(u32, [f64; 2])>,
}

/// Forcing periods until motion has settled, and for which it is then looked at.
const TRANSIENT: f64 = 300.0;
const LOOKED_AT: f64 = 60.0;
/// Impacts that differ less than this are the same.
const SAME: f64 = 1e-6;
/// Impacts slower than this belong to motion close to grazing, which is as slow to settle.
const SLOWEST: f64 = 1e-3;
/// The distance from a border, in shares of the ranges, within which a point tells nothing.
const BORDER: f64 = 0.004;

/// Simulates on a lattice of so many points each way, from so many random states at each.
///
/// # Errors
/// There is nothing to unfold.
pub fn compare(description: &Description, lattice: u32, states: u32) -> Result<Outcome, UnfoldError> {
    let window =
        Window { primary: description.primary().range(), secondary: description.secondary().range() };
    let scope = Scope { window, loops: description.loops().to_vec(), start: description.start() };
    let oscillator = Integrated::new(description.clone(), [window.primary[0], window.secondary[0]]);
    let diagram = Diagram::compute(&oscillator, &scope, &Silent)?;
    let at = |[low, high]: [f64; 2], k: u32| low + (high - low) * (f64::from(k) + 0.5) / f64::from(lattice);
    let points: Vec<[f64; 2]> = (0..lattice)
        .flat_map(|i| (0..lattice).map(move |j| [at(window.primary, i), at(window.secondary, j)]))
        .collect();
    let seen: Vec<Vec<u32>> = points
        .par_iter()
        .enumerate()
        .map(|(number, point)| {
            let mut random = Random::new(number as u64);
            let here = oscillator.with_parameters(*point);
            let mut loops: Vec<u32> = (0..states).filter_map(|_| settled(&here, &mut random)).collect();
            loops.sort_unstable();
            loops.dedup();
            loops
        })
        .collect();
    let mut outcome = Outcome::default();
    for (point, loops) in points.iter().zip(seen) {
        for p in loops.into_iter().filter(|p| scope.loops.contains(p)) {
            let mut of_p = diagram.regions.iter().filter(|region| region.loops == p);
            if of_p.clone().any(|region| region.contains(*point)) {
                outcome.explained += 1;
            } else if !of_p.any(|region| distance(region, *point, window) < BORDER) {
                outcome.unexplained.push((p, *point));
            }
        }
    }
    Ok(outcome)
}

/// The p of the p-loop solution on which motion from a random state settles, if it does.
fn settled(oscillator: &impl ImpactOscillator, random: &mut Random) -> Option<u32> {
    let period = oscillator.forcing_period();
    let from = State {
        position: -random.uniform(0.0, 2.0),
        velocity: random.uniform(-1.5, 1.5),
        phase: random.uniform(0.0, TAU),
    };
    let until = (TRANSIENT + LOOKED_AT) * period;
    let mut impacts: Vec<[f64; 3]> = Vec::new();
    for flight in Orbit::new(oscillator, from, until, 100_000) {
        if let FlightEnd::Impact(state) = flight.end {
            impacts.push([flight.start + flight.duration, state.velocity, state.phase]);
        }
    }
    impacts.retain(|[time, ..]| *time > TRANSIENT * period);
    let gaps: Vec<f64> = impacts.windows(2).map(|pair| (pair[1][0] - pair[0][0]) / period).collect();
    // The time that passes during impacts is not among those of flights.
    let loops = libm::round(*gaps.first()?);
    let first = *impacts.first()?;
    let same = impacts.iter().all(|[_, velocity, phase]| {
        (velocity - first[1]).abs() < SAME
            && libm::remainder(phase - first[2], TAU).abs() < SAME
            && *velocity > SLOWEST
    });
    // At least three times round.
    (same && gaps.len() >= 3 && loops >= 1.0).then_some(loops as u32)
}
