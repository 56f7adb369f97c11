//! Periodic solutions with several impacts: their curves, and the regions in which they are stable.
//!
//! Solutions with K impacts in P forcing periods are found where curves leave a resonance of motion with
//! impacts ([`generations`](crate::generations)), and where simulated motion settles on them. From there
//! branches and curves are followed, and regions decided, as those of MPSs are; but no lattice is searched,
//! so that a region to which neither leads is not known. A region of K impacts that begins at the period
//! doublings of K/2 is bounded by these.
//!
//! Between two walls, solutions that hit each of them once in p forcing periods are among these, in every
//! generation: what MPSs are to one wall they are to two. Those that are their own mirror images and those that
//! are not are one surface, which branches at pitchforks.

mod rows;

use std::collections::BTreeMap;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::Window;
use grazing_continuation::mps::{LoopEquations, Unknowns};
use grazing_model::smooth::Purpose;
use grazing_model::{ImpactOscillator, State};
use rand_pcg::Pcg64;

use crate::Scope;
use crate::curves::{CodimensionTwoPoint, DiagramCurve, Net, drawn};
use crate::diagram::Diagram;
use crate::generations::{BaseCurve, Later, LaterResonance, bases, later};
use crate::long_time::{Horizon, LongOrbit, Patience, random_start};
use crate::parallel;
use crate::progress::Progress;
use crate::regions::{self, Region};
use crate::resonances::Unlocated;
use crate::settled::{self, ImpactPattern};
use crate::survey::Survey;

/// The solutions with K impacts in P forcing periods, at the same stops in the same order.
#[derive(Clone, Debug)]
pub struct Sequence {
    /// The number of impacts K.
    pub impacts: usize,
    /// The number of forcing periods P.
    pub periods: u32,
    /// The stops that impacts hit, in their order, over and over; none if all are at x = 0.
    pub stops: Vec<usize>,
    /// Their SN, PD, NS, PF and GZ curves.
    pub curves: Vec<DiagramCurve>,
    /// The codimension-two points at which these meet.
    pub codimension_two: Vec<CodimensionTwoPoint>,
    /// The regions in which they are stable, and in which that is undecided.
    pub regions: Vec<Region>,
}

/// The solutions with several impacts of a diagram, and the resonances that lead to them.
#[derive(Clone, Debug, Default)]
pub struct Sequences {
    /// The solutions, by K and P.
    pub solutions: Vec<Sequence>,
    /// The resonances of motion with impacts that were located, generation by generation.
    pub resonances: Vec<LaterResonance>,
    /// Those that were detected but could not be located.
    pub unlocated: Vec<Unlocated>,
}

/// The stage in which motion is simulated.
const SIMULATED: &str = "motion with several impacts";
/// The stage in which curves and regions are found.
pub const REGIONS: &str = "regions of solutions with several impacts";
/// The seed of the random states, and the lowest of them.
const SEED: u128 = 1;
const LOWEST: f64 = -2.0;

/// Where motion is simulated, and for how long.
struct Places {
    /// Numbers of parts into which the ranges of η and μ are divided.
    rows: u32,
    columns: u32,
    /// Number of random initial states at a place; motion from the place beside it is followed as well.
    starts: u32,
    horizon: Horizon,
}

impl Places {
    /// Solutions with several impacts may be stable in slivers.
    const SEVERAL: Self = Self { rows: 32, columns: 64, starts: 2, horizon: Horizon::drifting(64, 24) };
    /// Those with one impact at each of two walls are a few surfaces, along which they are followed from any of their points
    /// that motion comes near.
    const ONCE_AT_EACH: Self = Self {
        rows: 16,
        columns: 16,
        starts: 1,
        horizon: Horizon { transient: 4, counted: 4, patience: Patience::Unsettled, longest: 16 },
    };

    /// The value of η of a row.
    fn level(&self, window: Window, row: u32) -> f64 {
        window.parameters([0.0, f64::from(row) / f64::from(self.rows)])[1]
    }
}

/// What is known of the solutions with so many impacts of a kind before their branches are followed.
#[derive(Clone, Default)]
struct Leads {
    /// Curves that leave resonances.
    curves: Vec<DiagramCurve>,
    /// Solutions on which motion settles.
    seen: Vec<Unknowns>,
}

/// The number of impacts and the kind, in the order in which solutions branch off each other.
type Numbers = (usize, ImpactPattern);

/// The solutions with several impacts up to a generation, the MPSs being the first: solutions of the next
/// leave the resonances on curves at which those of the one before graze, with one impact more than so many
/// `rounds` of the grazing motion. Solutions on which simulated motion settles are added if they have no more
/// impacts and forcing periods than these can have, but not solutions with two impacts that branch off MPSs
/// whose number of loops the diagram does not have. With one wall, empty for the first generation; between two,
/// solutions with one impact at each in the diagram's numbers of loops.
pub fn sequences(diagram: &Diagram, rounds: &[u32], generations: u32, progress: &dyn Progress) -> Sequences {
    let mut found = Sequences::default();
    let (most_rounds, most_loops) = (largest(rounds), largest(&diagram.scope.loops));
    let between_walls = diagram.oscillator.other_stop().is_some();
    if generations < 2 && !between_walls || most_rounds == 0 {
        return found;
    }
    let places = if generations < 2 { Places::ONCE_AT_EACH } else { Places::SEVERAL };
    let levels: Vec<f64> = (0..=places.rows).map(|row| places.level(diagram.scope.window, row)).collect();
    let most = (1..generations).fold((1, most_loops), |(impacts, periods), _| {
        (most_rounds as usize * impacts + 1, most_rounds * periods)
    });
    let mut leads: BTreeMap<Numbers, Leads> = BTreeMap::new();
    for (numbers, solution) in simulated(diagram, (&places, &levels), progress) {
        if is_sought(diagram, most, &numbers) {
            leads.entry(numbers).or_default().seen.push(solution);
        }
    }
    let scope = Scope { loops: rounds.to_vec(), ..diagram.scope.clone() };
    if generations < 2 {
        found.solutions = decided(diagram, &leads, &levels, progress);
        return found;
    }
    let mut grazing = bases(diagram);
    for _ in 1..generations {
        let Later { resonances, unlocated } = later(diagram, &grazing, &scope, progress);
        for resonance in &resonances {
            let numbers = (resonance.impacts(), (resonance.periods(), Vec::new()));
            leads.entry(numbers).or_default().curves.extend(leaving(resonance));
        }
        found.resonances.extend(resonances);
        found.unlocated.extend(unlocated);
        found.solutions = decided(diagram, &leads, &levels, progress);
        grazing = found.solutions.iter().flat_map(Sequence::bases).collect();
    }
    found
}

/// The [`sequences`] of a diagram in which grazing motion goes round up to as often as MPSs have loops.
pub fn of_diagram(diagram: &Diagram, generations: u32, progress: &dyn Progress) -> Sequences {
    let rounds: Vec<u32> = (1..=largest(&diagram.scope.loops)).collect();
    sequences(diagram, &rounds, generations, progress)
}

/// Whether solutions have no more impacts at a wall, and no more forcing periods, than is asked for, and the curves
/// are known at which some branch off those of half the time: MPSs, and solutions that hit each of two walls once,
/// have them if the diagram has their p.
fn is_sought(diagram: &Diagram, most: (usize, u32), (impacts, (periods, stops)): &Numbers) -> bool {
    let loops = &diagram.scope.loops;
    let at = |stop: usize| (0..*impacts).filter(|impact| stops[impact % stops.len()] == stop).count();
    let at_one = if stops.is_empty() { *impacts } else { at(0).max(at(1)) };
    let doubled = at_one == 2 && periods.is_multiple_of(2);
    at_one <= most.0
        && *periods <= most.1
        && (at_one > 1 || loops.contains(periods))
        && (!doubled || loops.contains(&(periods / 2)))
}

/// The largest of some numbers, or 0.
fn largest(numbers: &[u32]) -> u32 {
    numbers.iter().copied().max().unwrap_or(0)
}

/// The curves that leave a resonance.
fn leaving(resonance: &LaterResonance) -> impl Iterator<Item = DiagramCurve> {
    let loops = resonance.periods();
    resonance.curves.iter().map(move |curve| {
        let kind = Bifurcation::of(curve.condition, loops).unwrap_or(Bifurcation::Grazing);
        DiagramCurve { kind, loops, n: 0, curve: curve.clone() }
    })
}

impl Sequence {
    /// The curves at which these solutions graze.
    fn bases(&self) -> impl Iterator<Item = BaseCurve> {
        let curves = self.curves.iter().enumerate().filter(|(_, curve)| curve.kind == Bifurcation::Grazing);
        curves.map(|(index, curve)| BaseCurve { impacts: self.impacts, index, curve: curve.clone() })
    }
}

/// Curves and regions of the solutions to which something leads, those of fewer impacts first.
fn decided(
    diagram: &Diagram,
    leads: &BTreeMap<Numbers, Leads>,
    levels: &[f64],
    progress: &dyn Progress,
) -> Vec<Sequence> {
    let all: Vec<(&Numbers, &Leads)> = leads.iter().collect();
    progress.begin(REGIONS, all.len() as u64);
    let mut found: Vec<Sequence> = Vec::new();
    for same in all.chunk_by(|a, b| a.0.0 == b.0.0) {
        let more = parallel::map(same, |&(numbers, leads)| {
            let halved = halved(diagram, &found, numbers);
            let solutions = of_numbers(diagram, numbers, leads, levels, halved, progress);
            progress.step(REGIONS);
            solutions
        });
        found.extend(more);
    }
    progress.end(REGIONS);
    found
}

/// The solutions of half the time from which some may branch off, with their curves.
fn halved<'a>(
    diagram: &'a Diagram,
    known: &'a [Sequence],
    (impacts, (periods, stops)): &Numbers,
) -> Option<(LoopEquations, Vec<DiagramCurve>)> {
    (impacts.is_multiple_of(2) && periods.is_multiple_of(2)).then_some(())?;
    let (impacts, periods) = (impacts / 2, periods / 2);
    impacts.is_multiple_of(stops.len().max(1)).then_some(())?;
    let of_half = |curve: &&DiagramCurve| curve.loops == periods;
    let curves = match impacts {
        1 if stops.is_empty() => diagram.curves.iter().filter(of_half).cloned().collect(),
        _ => {
            let half = known
                .iter()
                .find(|known| (known.impacts, known.periods, &known.stops) == (impacts, periods, stops));
            half.map_or_else(Vec::new, |half| half.curves.clone())
        }
    };
    Some((settled::equations(&diagram.oscillator, &(periods, stops.clone())), curves))
}

/// Curves and regions of the solutions with so many impacts of a kind.
fn of_numbers(
    diagram: &Diagram,
    (impacts, kind): &Numbers,
    leads: &Leads,
    levels: &[f64],
    halved: Option<(LoopEquations, Vec<DiagramCurve>)>,
    progress: &dyn Progress,
) -> Sequence {
    let scope = &diagram.scope;
    let mut net = Net::new(settled::equations(&diagram.oscillator, kind));
    leads.curves.iter().for_each(|curve| net.add(curve.clone()));
    Purpose::Curves.during(|| net.grow(&drawn(scope.window)));
    let halved = halved.as_ref().map(|(equations, curves)| (equations.clone(), curves.as_slice()));
    let mut survey = Survey::of_several(&mut net, scope, leads.seen.clone(), halved);
    let regions = regions::decided(scope.window, &mut survey, levels, progress);
    let (periods, stops) = kind.clone();
    let regions = regions.unwrap_or_else(|| vec![Region::not_finished(scope.window, periods)]);
    let Net { curves, meetings, .. } = net;
    Sequence { impacts: *impacts, periods, stops, curves, codimension_two: meetings, regions }
}

/// The solutions with several impacts on which simulated motion settles, row by row.
fn simulated(
    diagram: &Diagram,
    (places, levels): (&Places, &[f64]),
    progress: &dyn Progress,
) -> Vec<(Numbers, Unknowns)> {
    progress.begin(SIMULATED, levels.len() as u64);
    let row = |level: &f64| {
        let found = along_row(diagram, (places, *level), progress);
        progress.step(SIMULATED);
        found
    };
    let found = parallel::map(levels, row).concat();
    progress.end(SIMULATED);
    found
}

/// The solutions with several impacts on which motion settles at the places of one row.
fn along_row(
    diagram: &Diagram,
    (places, level): (&Places, f64),
    progress: &dyn Progress,
) -> Vec<(Numbers, Unknowns)> {
    let mut found = Vec::new();
    let mut beside: Vec<State> = Vec::new();
    for column in (0..=places.columns).take_while(|_| !progress.stopped()) {
        let share = f64::from(column) / f64::from(places.columns);
        let [primary, _] = diagram.scope.window.parameters([share, 0.0]);
        let here = diagram.oscillator.with_parameters([primary, level]);
        let mut random = Pcg64::new(SEED, u128::from(column));
        let fresh = (0..places.starts).map(|_| random_start(&here, LOWEST, &mut random));
        let starts: Vec<State> = beside.drain(..).chain(fresh).collect();
        for from in starts {
            let orbit = LongOrbit::follow(&here, from, places.horizon);
            let Some(cycle) = orbit.cycle.filter(|cycle| cycle.impacts > 0) else { continue };
            if beside.is_empty() {
                beside.push(cycle.from);
            }
            if cycle.impacts > 1
                && let Some((kind, near)) = settled::near(&here, &orbit)
                && let Some(solution) =
                    settled::solution(&settled::equations(&here, &kind), &near, here.parameters())
            {
                found.push(((cycle.impacts, kind), solution));
            }
        }
    }
    found
}
