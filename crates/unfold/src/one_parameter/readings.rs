//! Quantities of solutions and simulated motion other than x on Π.

use grazing_continuation::mps::PeriodicSolution;
use grazing_model::motion::Motion;
use grazing_model::phase::{centred, turned};
use grazing_model::{AnyOscillator, ImpactOscillator, State};
use grazing_results::Stability;
use grazing_results::branches::Orbits;
use grazing_results::readings::{MotionReading, Reading, Sweep};
use nalgebra::Vector2;

use super::branches::{Branch, within};
use super::{Cut, Sampling};
use crate::long_time::{LongOrbit, MotionKind, Strike};
use crate::parallel;
use crate::progress::Progress;
use crate::segments::{BranchVertex, vertices};

/// Number of instants of a forcing period between which turning points are bracketed: at turning
/// points closer together x has no visible difference.
const INSTANTS: f64 = 64.0;
/// Number of halvings, down to rounding of the position of a turning point.
const HALVINGS: u32 = 30;

/// The name of the stage.
const SWEEPS: &str = "sweeps of a one-parameter diagram";

/// Lowest and highest position of a motion until a time.
fn extent(motion: &impl Motion, until: f64, period: f64) -> [f64; 2] {
    let steps = libm::ceil(INSTANTS * until / period).max(1.0);
    let mut extent = [f64::INFINITY, f64::NEG_INFINITY];
    let mut see = |position: f64| extent = [extent[0].min(position), extent[1].max(position)];
    let mut before = motion.at(0.0);
    see(before.position);
    for step in 1..=steps as u32 {
        let [mut from, mut to] = [step - 1, step].map(|k| until * f64::from(k) / steps);
        let here = motion.at(to);
        see(here.position);
        if before.velocity * here.velocity < 0.0 {
            for _ in 0..HALVINGS {
                let middle = 0.5 * (from + to);
                let turns = motion.at(middle).velocity * before.velocity > 0.0;
                if turns { from = middle } else { to = middle }
            }
            see(motion.at(from).position);
        }
        before = here;
    }
    extent
}

/// The extent that contains all of these.
fn widest(extents: impl Iterator<Item = [f64; 2]>, least: [f64; 2]) -> [f64; 2] {
    extents.fold(least, |all, one| [all[0].min(one[0]), all[1].max(one[1])])
}

impl Branch {
    /// The difference between the highest and the lowest position of a solution, from impact to
    /// impact or over a period.
    fn peak_to_peak(&self, solution: &PeriodicSolution) -> f64 {
        let period = self.equations.oscillator_at(&solution.unknowns).forcing_period();
        let flights = self.equations.flown(&solution.unknowns);
        let extents = flights.iter().map(|flight| extent(&flight.motion, flight.duration, period));
        let [low, high] = widest(extents, [f64::INFINITY, f64::NEG_INFINITY]);
        high - low
    }

    /// The readings of every solution, impact by impact; one without impacts.
    fn readings(&self) -> Vec<Vec<Reading>> {
        let places = vertices(&self.curve);
        let stability = self.stability(&places);
        let readings = |(at, stable): (&BranchVertex<'_>, Stability)| {
            let [primary, secondary] = at.solution.parameters();
            let point = &at.solution.unknowns;
            let peak_to_peak = self.peak_to_peak(at.solution);
            let impacts: Vec<[f64; 2]> = match self.impacts() {
                0 => vec![[0.0, f64::NAN]],
                count => {
                    let impacts = (0..count as usize).map(|index| point.impact(index));
                    impacts.map(|impact| [impact.velocity, impact.phase]).collect()
                }
            };
            let reading = |(index, [velocity, phase]): (usize, [f64; 2])| Reading {
                diagram: 0,
                loops: self.equations.loops(),
                impacts: self.impacts(),
                wall: self.wall(index),
                secondary,
                primary,
                impact_velocity: velocity,
                impact_phase: centred(phase),
                peak_to_peak,
                impulse: f64::NAN,
                force: f64::NAN,
                power: f64::NAN,
                stable,
                admissible: at.solution.ceiling() <= PeriodicSolution::TOUCH,
                branch: 0,
            };
            impacts.into_iter().enumerate().map(reading).collect()
        };
        places.iter().zip(stability).map(readings).collect()
    }
}

impl Cut {
    /// The readings of the solutions on the branches. Those of the impacts of one solution are in strands
    /// that follow each other and are equally long.
    pub fn readings(&self) -> Vec<Reading> {
        let found: Vec<Vec<Vec<Reading>>> = parallel::map(&self.branches, Branch::readings);
        let pieces =
            found.iter().flat_map(|branch| within(branch, |impacts| impacts[0].primary, self.line.range));
        let strands = pieces.flat_map(|piece| {
            let strand = |impact: usize| piece.iter().map(|impacts| impacts[impact].clone()).collect();
            (0..piece.first().map_or(0, Vec::len)).map(strand).collect::<Vec<Vec<Reading>>>()
        });
        let mut rows = Vec::new();
        for (number, mut strand) in (1..).zip(strands) {
            strand.iter_mut().for_each(|row| row.branch = number);
            rows.extend(strand);
        }
        self.in_place(rows)
    }

    /// Readings of motion as the parameter across goes up and down, each time from the long-term
    /// state at the previous value.
    ///
    /// A sweep begins at rest, a unit of length from the wall. Where motion comes to rest at the
    /// wall for good, it continues from the last state before that. The numbers of orbits are returned
    /// as well.
    pub fn sweeps(&self, sampling: &Sampling, progress: &dyn Progress) -> (Vec<MotionReading>, Orbits) {
        let sampling = &self.long_enough(sampling);
        let [low, high] = self.line.range;
        let at = |k: u32| {
            let primary = low + (high - low) * f64::from(k) / f64::from(sampling.values - 1);
            self.oscillator.with_parameters([primary, self.line.at])
        };
        let sweep = |sweep: Sweep| {
            let (mut state, mut rows) = (State::at_rest(-1.0, 0.0), Vec::new());
            let mut orbits = Orbits::default();
            for k in 0..sampling.values {
                if progress.stopped() {
                    break;
                }
                let oscillator = at(if sweep == Sweep::Up { k } else { sampling.values - 1 - k });
                let orbit = LongOrbit::follow(&oscillator, state, sampling.horizon());
                state = orbit.state(&oscillator).unwrap_or(state);
                rows.extend(readings_of(&oscillator, &orbit, (sweep, 0)));
                orbits = orbits.plus(counted(&orbit));
                progress.step(SWEEPS);
            }
            (rows, orbits)
        };
        let ways = [Sweep::Up, Sweep::Down];
        let steps = u64::from(sampling.values) * ways.len() as u64;
        let swept: Vec<_> = progress.during(SWEEPS, steps, || parallel::map(ways, sweep));
        let (rows, orbits): (Vec<_>, Vec<_>) = swept.into_iter().unzip();
        (self.in_place(rows.concat()), orbits.into_iter().fold(Orbits::default(), Orbits::plus))
    }
}

/// One orbit, counted by what it comes to.
pub(super) fn counted(orbit: &LongOrbit) -> Orbits {
    let is = |kind| u32::from(orbit.fate.kind == kind);
    Orbits { all: 1, resting: is(MotionKind::Resting), escaping: is(MotionKind::Escaping) }
}

/// Readings of the impacts of an orbit on its cycle, or of all recorded impacts, or one row for
/// motion without impacts; none for motion that has come to rest for good or cannot be followed.
pub(super) fn readings_of(
    oscillator: &AnyOscillator,
    orbit: &LongOrbit,
    (sweep, number): (Sweep, u32),
) -> Vec<MotionReading> {
    let [primary, secondary] = oscillator.parameters();
    let period = oscillator.forcing_period();
    let row = |x, (wall, [velocity, phase]): (u32, [f64; 2]), peak_to_peak| MotionReading {
        diagram: 0,
        sweep,
        orbit: number,
        secondary,
        primary,
        motion: orbit.fate.kind.name(),
        periods: orbit.fate.periods.map_or(f64::NAN, f64::from),
        impacts: orbit.fate.impacts,
        rests: orbit.fate.rests,
        wall,
        x,
        impact_velocity: velocity,
        impact_phase: centred(phase),
        peak_to_peak,
        impulse: f64::NAN,
        force: f64::NAN,
        power: f64::NAN,
    };
    if let Some((from, periods)) = orbit.free_cycle(oscillator) {
        let [low, high] = extent(&oscillator.motion(from), periods * period, period);
        return vec![row(high, (0, [0.0, f64::NAN]), high - low)];
    }
    if orbit.state(oscillator).is_none() {
        return Vec::new();
    }
    let extents = orbit.flights.iter().map(|flight| extent(&flight.motion, flight.duration, period));
    // Impacts are at x = 0 unless another stop is hit.
    let begin = if oscillator.other_stop().is_some() { f64::NEG_INFINITY } else { 0.0 };
    let [low, high] = widest(extents, [f64::INFINITY, begin]);
    // The impacts of one cycle, if there is one.
    let count = orbit.cycle.map_or(usize::MAX, |cycle| cycle.impacts);
    let rows = orbit.impacts.iter().take(count).map(|&Strike { impact, stop }| {
        let impact = Vector2::new(impact[0], turned(impact[1]));
        let x = Strike { impact, stop }.virtual_top(oscillator).map_or(f64::NAN, |[x, _]| x);
        row(x, (stop as u32 + 1, impact.into()), high - low)
    });
    rows.collect()
}
