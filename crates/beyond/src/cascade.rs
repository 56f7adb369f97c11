//! Beyond the paper: motion after the period doublings, in the limit map and in the system at decreasing
//! distances from the resonance.

mod ink;

use grazing_continuation::cascade::Cascade;
use grazing_continuation::mps::unknown;
use grazing_input::kind::{count, numbers};
use grazing_model::orbit::{FlightEnd, Orbit};
use grazing_model::{ImpactOscillator, State};
use grazing_reproduction::figures::fig07::Figure7;
use grazing_reproduction::prelude::*;
use grazing_results::{row, rows, tables};
use grazing_theorems::limit_map::LimitImpact;
use grazing_theorems::{LimitMap, ResonantPoint, Side};
use grazing_unfold::resonances::FoundResonance;
use rayon::prelude::*;

keys! {
    /// The motion after the period doublings.
    pub struct BeyondCascade {
        /// Impact velocities at the period doubling, in the columns of the figure but the last, which is the limit.
        sizes: [f64; 2] = numbers().such(|all: &[f64; 2]| all.iter().all(|size| (1e-6..0.5).contains(size))),
            "the sizes must be two impact velocities from 0.000001 to 0.5";
        /// Values of the parameter in a panel.
        values: u32 = count(2..=10_000), "the number of values must be a whole number from {} to {}";
    }
}

/// The numbers of impacts that are discarded and shown at each value of the parameter.
const TRANSIENT: usize = 250;
const SHOWN: usize = 24;
/// Motion that recurs to this accuracy is shown for one period.
const SAME: f64 = 1e-6;
/// The greatest parameter at which motion is shown, in units of that of the period doubling.
const HIGHEST: f64 = 1.03;
/// The steps in which motion is followed until it leaves, and the number of impacts at each.
const LEAVING_STEP: f64 = 1e-3;
const LEAVING_IMPACTS: usize = 4000;
/// An impact of the system that is early or late by more than this fraction of p periods does not
/// correspond to one of the limit map.
const PUNCTUAL: f64 = 0.1;
/// The number of periods without an impact after which none is expected, for p = 1.
const PATIENCE: f64 = 100.0;

rows! {
    /// An impact of motion that is followed down from where the MPS is stable.
    CascadePoint {
        panel: u32 = CASCADE_PANEL,
        scaled: f64 = SCALED_PARAMETER,
        velocity: f64 = SCALED_VELOCITY,
    }

    /// A panel of the figure.
    CascadePanel {
        panel: u32 = CASCADE_PANEL,
        loops: u32 = LOOPS,
        n: u32 = RESONANCE_INDEX,
        size: f64 = CASCADE_SIZE,
    }
}

/// The period-doubling cascade at a resonance.
#[derive(Clone, Debug)]
pub struct Onsets {
    n: u32,
    point: ResonantPoint,
    cascade: Cascade,
    leaves: f64,
}

row! { Onsets, |this| {
    let map = this.point.limit_map();
} [
    LOOPS = this.point.loops(),
    RESONANCE_INDEX = this.n,
    SIGMA = map.numbers()[2],
    PERIOD_4 = this.cascade.fraction(1),
    PERIOD_8 = this.cascade.fraction(2),
    PERIOD_16 = this.cascade.fraction(3),
    LEAVES = this.leaves,
    CASCADE_STOP = this.cascade.stop.name(),
] }

tables! {
    /// The period-doubling cascades at the resonances of Figure 7.
    Cascades {
        onsets: Onsets = "beyond_cascade", "a resonance of Figure 7",
        panels: CascadePanel = "beyond_cascade_panels", "a panel",
        /// The points are those of the resonance of each p with the least |σ| whose period doubling
        /// creates stable orbits. For p = 1 motion is followed beyond where it misses the wall, for p ≥ 2
        /// it is not.
        points: CascadePoint = "beyond_cascade_attractor", "an impact of simulated motion" as Cloud,
    }
}

impl FileSection for BeyondCascade {
    const NAME: &'static str = "beyond_cascade";
    const REQUIREMENT: &'static str =
        "the table [beyond_cascade] says how near to resonances motion is followed";
}

impl StudyFigure for BeyondCascade {
    const LABEL: &'static str = "fig:cascade";
    const TITLE: Title<&'static str> = Title::beyond("what follows the period doublings");
    const TABLES: &'static [TablePlan] = Cascades::TABLES;
    const REMEDY: &'static str = Figure7::REMEDY;
    type Shown = Cascades;

    fn compute(&self, study: &Study) -> Result<Cascades, StudyError> {
        let found: Vec<&FoundResonance> =
            study.diagram()?.unfolding().map(|(resonance, _)| resonance).collect();
        let onsets: Vec<Onsets> = found.par_iter().map(|resonance| Onsets::of(resonance)).collect();
        let mut chosen: Vec<(&FoundResonance, &Onsets)> = Vec::new();
        for (resonance, onsets) in found.into_iter().zip(&onsets).filter(|(_, at)| !at.leaves.is_nan()) {
            let weight = |onsets: &Onsets| onsets.point.limit_map().numbers()[2].abs();
            match chosen.iter_mut().find(|(other, _)| other.loops == resonance.loops) {
                Some(other) if weight(onsets) < weight(other.1) => *other = (resonance, onsets),
                Some(_) => {}
                None => chosen.push((resonance, onsets)),
            }
        }
        let [far, near] = self.sizes;
        let all = chosen.iter().flat_map(|found| [far, near, 0.0].map(|size| (*found, size)));
        let numbered: Vec<_> = (1..).zip(all).collect();
        let panel = |&(panel, ((resonance, _), size)): &(u32, ((&FoundResonance, _), f64))| CascadePanel {
            panel,
            loops: resonance.loops,
            n: resonance.n,
            size,
        };
        let panels = numbered.iter().map(panel).collect();
        let points = numbered.par_iter().flat_map_iter(|&(panel, ((resonance, onsets), size))| {
            let shown = followed(resonance, size, [HIGHEST, onsets.lowest()], self.values);
            shown.into_iter().map(move |[scaled, velocity]| CascadePoint { panel, scaled, velocity })
        });
        let points = points.collect();
        Ok(Cascades { onsets, panels, points })
    }

    fn draw(shown: &Cascades, width: SheetWidth) -> Result<Sheet, DrawingError> {
        shown.draw(width)
    }
}

impl Onsets {
    fn of(resonance: &FoundResonance) -> Self {
        let point = *resonance.located.resonant_point();
        let map = point.limit_map();
        let cascade = Cascade::of(&map, 4);
        let leaves = if cascade.onsets.is_empty() { f64::NAN } else { leaves(&map) };
        Self { n: resonance.n, point, cascade, leaves }
    }

    /// The least parameter at which motion is shown.
    fn lowest(&self) -> f64 {
        self.leaves - 0.25 * (1.0 - self.leaves)
    }
}

/// The fixed point beside the period doubling, at which motion starts.
fn start(map: &LimitMap) -> LimitImpact {
    let (mut here, _) = map.fixed_point(map.period_doubling()[0]);
    here.velocity *= 1.001;
    here
}

/// The parameter at which the limit map's motion leaves, in units of M_PD.
fn leaves(map: &LimitMap) -> f64 {
    let [velocity, parameter] = map.period_doubling();
    let side = Side::of(velocity);
    let mut here = start(map);
    for step in 0..(1.0 / LEAVING_STEP) as u32 {
        let scaled = 1.0 - LEAVING_STEP * f64::from(step);
        for _ in 0..LEAVING_IMPACTS {
            match map.step(side, scaled * parameter, here) {
                Ok(next) => here = next,
                Err(_) => return scaled,
            }
        }
    }
    0.0
}

/// (μ, y) of impacts in units of their values at the period doubling, as μ decreases: of the system at
/// the distance from the resonance that corresponds to `size`, or of the limit map if `size` is 0.
fn followed(
    resonance: &FoundResonance,
    size: f64,
    [highest, lowest]: [f64; 2],
    values: u32,
) -> Vec<[f64; 2]> {
    let point = resonance.located.resonant_point();
    let (map, scale) = (point.limit_map(), point.limit_scale());
    let [velocity, parameter] = map.period_doubling();
    let side = Side::of(velocity);
    let (one_loop, entry) = (point.loops() == 1, point.grazing.map.a.m11);
    let mut impact = start(&map);
    // The visit before the recoil, for p = 1.
    let mut visit = [impact.velocity * impact.velocity, impact.phase + impact.velocity];
    let eta = size / (scale.velocity * velocity);
    let mut state = match resonance.located.near(eta, parameter, impact) {
        Ok(near) => State::on_wall(near[unknown::VELOCITY], near[unknown::PHASE]),
        Err(_) => return Vec::new(),
    };
    let mut shown = Vec::new();
    for value in 0..=values {
        let scaled = highest + (lowest - highest) * f64::from(value) / f64::from(values);
        let mut seen = Vec::new();
        if size > 0.0 {
            let Ok(place) = resonance.located.near(eta, scaled * parameter, impact) else { break };
            let oscillator = resonance.located.equations().oscillator_at(&place);
            let turn = f64::from(point.loops()) * oscillator.forcing_period();
            let horizon = PATIENCE * (TRANSIENT + SHOWN) as f64 * turn;
            for flight in Orbit::new(&oscillator, state, horizon, usize::MAX).take(TRANSIENT + SHOWN) {
                let FlightEnd::Impact(next) = flight.end else { break };
                if !one_loop && (flight.duration / turn - 1.0).abs() > PUNCTUAL {
                    break;
                }
                state = next;
                seen.push(next.velocity / size);
            }
        } else if one_loop {
            for _ in 0..PATIENCE as usize * (TRANSIENT + SHOWN) {
                visit = map.next_visit(side, scaled * parameter, entry, visit);
                if visit[0] > 0.0 {
                    seen.push(visit[0].sqrt() / velocity.abs());
                }
                if seen.len() == TRANSIENT + SHOWN {
                    break;
                }
            }
        } else {
            for _ in 0..TRANSIENT + SHOWN {
                let Ok(next) = map.step(side, scaled * parameter, impact) else { break };
                impact = next;
                seen.push(next.velocity / velocity);
            }
        }
        if seen.len() < TRANSIENT + SHOWN {
            break;
        }
        let seen = &seen[TRANSIENT..];
        let again = |&count: &usize| {
            seen[count..].iter().zip(seen).all(|(later, first)| (later - first).abs() < SAME)
        };
        let count = (1..=SHOWN / 2).find(again).unwrap_or(SHOWN);
        shown.extend(seen[..count].iter().map(|&velocity| [scaled, velocity]));
    }
    shown
}
