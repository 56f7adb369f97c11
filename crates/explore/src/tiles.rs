//! Simulation over the plane, from coarse to fine.

use std::time::Duration;

use grazing_continuation::curve::Window;
use grazing_model::ImpactOscillator;
use grazing_model::smooth::Stop;
use grazing_unfold::long_time::{Horizon, LongOrbit, MotionKind, random_start};
use grazing_unfold::progress::Progress;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::answer::{Problem, answers};
use crate::events::Events;
use crate::model::{Model, View};

/// The request for simulation.
#[derive(Deserialize)]
pub(crate) struct TilesRequest {
    model: Model,
    view: View,
    columns: u32,
    rows: u32,
    periods: u32,
    /// The number of places that are known, in the order in which they are simulated.
    #[serde(default)]
    known: usize,
}

/// The most columns and rows of places, and the most forcing periods.
const MOST: u32 = 1000;
const MOST_PERIODS: u32 = 5000;
/// The width of the first cells; it is halved each time.
const COARSEST: u32 = 16;
/// The number of places in the first message; later ones are as large as can be simulated in about this time.
const LOT: usize = 32;
const OFTEN: Duration = Duration::from_millis(100);
/// The share of all forcing periods that counts: one in this many.
const COUNTED: u32 = 6;

answers! {
    /// Results for cells that are so many places wide.
    Tiles { step: u32, cells: Vec<Cell>, }
}

/// The place in a cell: its column and row; and what motion comes to, if there is any: loops of an MPS, period in
/// forcing periods, impacts in one, and whether it rests at the wall.
#[derive(Serialize)]
#[serde(untagged)]
pub(crate) enum Cell {
    Empty(u32, u32),
    Simulated(u32, u32, Option<u32>, Option<u32>, f64, bool),
}

pub(crate) fn compute(request: &TilesRequest, events: &Events, stop: &Stop) -> Result<(), Problem> {
    let &TilesRequest { columns, rows, periods, .. } = request;
    if !((1..=MOST).contains(&columns)
        && (1..=MOST).contains(&rows)
        && (COUNTED..=MOST_PERIODS).contains(&periods))
    {
        return Err(Problem::wrong(format!(
            "columns and rows must lie between 1 and {MOST}, periods between {COUNTED} and {MOST_PERIODS}"
        )));
    }
    let of = request.model.prepared(Some(&request.view), stop)?;
    let View { primary, secondary } = request.view;
    let view = Window { primary, secondary };
    let mut known = request.known;
    let counted = periods / COUNTED;
    let horizon = Horizon::drifting(periods - counted, counted);
    let (mut step, mut lot) = (COARSEST, LOT);
    loop {
        let places = (0..rows)
            .step_by(step as usize)
            .flat_map(|row| (0..columns).step_by(step as usize).map(move |column| [column, row]));
        let coarser =
            |[column, row]: &[u32; 2]| step < COARSEST && column % (2 * step) == 0 && row % (2 * step) == 0;
        let mut places: Vec<[u32; 2]> = places.filter(|place| !coarser(place)).collect();
        known -= places.drain(..known.min(places.len())).len();
        let mut rest = &places[..];
        while !rest.is_empty() {
            let (now, later) = rest.split_at(lot.min(rest.len()));
            let began = (events.clock)();
            let cells = now.par_iter().map(|&[column, row]| {
                let shares = [(column, columns), (row, rows)]
                    .map(|(place, count)| (f64::from(place) + 0.5) / f64::from(count));
                let at = of.without_dimensions(view.parameters(shares));
                // Beyond the part that is valid there is no motion.
                if events.stopped() || !of.scope.window.contains(at) {
                    return Cell::Empty(column, row);
                }
                let here = of.oscillator.with_parameters(at);
                // A place always has the same initial state, whatever was computed before.
                let mut random = random(column, row);
                let fate = LongOrbit::follow(&here, random_start(&here, -1.0, &mut random), horizon).fate;
                let rests = fate.rests > 0.0 || fate.kind == MotionKind::Resting;
                Cell::Simulated(column, row, fate.loops(), fate.periods, fate.impacts, rests)
            });
            let cells = cells.collect();
            if events.stopped() {
                return Ok(());
            }
            events.send("tiles", &Tiles { step, cells });
            lot = if (events.clock)() - began < OFTEN { 2 * lot } else { (lot / 2).max(1) };
            rest = later;
        }
        if step == 1 {
            return Ok(());
        }
        step /= 2;
    }
}

/// The generator of random numbers of a place.
fn random(column: u32, row: u32) -> rand_pcg::Pcg64 {
    rand_pcg::Pcg64::new(1, u128::from(column) << 32 | u128::from(row))
}
