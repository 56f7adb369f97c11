//! P_global of periodic motion that has impacts elsewhere.
//!
//! Impacts at other parts of the trajectory than the grazing point do not affect the smoothness of
//! P_global (section 6 of the paper): as long as they have a velocity, it is the composition of
//! flights from Π to the wall, from the wall to the wall and from the wall to Π, with the reset law
//! between each and the next.

use core::f64::consts::TAU;

use nalgebra::Vector4;
use smallvec::SmallVec;

use super::{Landing, MapError, flow, land_on_section, map_columns, second_along};
use crate::jet::{FlowJet, MapJet};
use crate::motion::Motion;
use crate::oscillator::ImpactOscillator;
use crate::state::{AtRest, OnWall, State, Surface};
use crate::tolerances::{LAST_STEP_TO_SECTION, MOST_ITERATIONS};

/// A way from Π back to Π: the times of its flights, with an impact between each and the next, and
/// the number of forcing periods that it takes.
///
/// The times tell which crossing of the wall is an impact, as a guess at a return time tells which
/// maximum is the next point of Π.
#[derive(Clone, Debug, PartialEq)]
pub struct Passage {
    periods: u32,
    /// The times of the flights that end at the wall.
    to_wall: SmallVec<[f64; 2]>,
    /// The time of the last flight, to Π; `None` for the forcing period.
    back: Option<f64>,
}

/// P_global along a passage, and the impacts on the way in the order of time.
#[derive(Clone, Debug)]
pub struct Passed {
    /// The map and its derivatives.
    pub jet: MapJet<AtRest, AtRest>,
    /// The impacts.
    pub impacts: SmallVec<[OnWall; 2]>,
}

impl Passage {
    /// The way without impacts, over one forcing period.
    pub fn direct() -> Self {
        Self { periods: 1, to_wall: SmallVec::new(), back: None }
    }

    /// The way with impacts after flights of these times, the last of which leads back to Π.
    pub fn through(periods: u32, to_wall: impl IntoIterator<Item = f64>, back: f64) -> Self {
        Self { periods, to_wall: to_wall.into_iter().collect(), back: Some(back) }
    }

    /// The number of forcing periods.
    pub fn periods(&self) -> u32 {
        self.periods
    }

    /// The times of all flights, the last of which leads to Π.
    pub fn times<O: ImpactOscillator>(&self, oscillator: &O) -> impl Iterator<Item = f64> {
        let back = self.back.unwrap_or_else(|| oscillator.forcing_period());
        self.to_wall.iter().copied().chain([back])
    }

    /// The number of impacts on the way.
    pub fn impacts(&self) -> usize {
        self.to_wall.len()
    }

    /// P_global along this way; the times become those from the point `from`.
    ///
    /// # Errors
    /// A flight does not reach the wall, or has no maximum of x, near its time.
    pub fn global_map<O: ImpactOscillator, const ORDER: usize>(
        &mut self,
        oscillator: &O,
        from: AtRest,
    ) -> Result<Passed, MapError> {
        let mut impacts = SmallVec::new();
        let mut jet: Option<MapJet<AtRest, OnWall>> = None;
        for time in &mut self.to_wall {
            let (next, taken) = match &jet {
                None => land_on_wall::<O, ORDER, AtRest>(oscillator, from.into(), *time)?,
                Some(recoil) => {
                    let flight = land_on_wall::<O, ORDER, OnWall>(oscillator, recoil.image().into(), *time)?;
                    (flight.0.after::<ORDER, _>(recoil), flight.1)
                }
            };
            *time = taken;
            impacts.push(next.image());
            jet = Some(oscillator.reset::<ORDER>(next.image()).after::<ORDER, _>(&next));
        }
        let turn = f64::from(self.periods) * TAU;
        let back = self.back.unwrap_or_else(|| oscillator.forcing_period());
        let last = match jet {
            None => land_on_section::<O, ORDER, AtRest>(oscillator, from.into(), back, turn)?,
            Some(recoil) => {
                let Landing { jet, time } =
                    land_on_section::<O, ORDER, OnWall>(oscillator, recoil.image().into(), back, turn)?;
                Landing { jet: jet.after::<ORDER, _>(&recoil), time }
            }
        };
        self.back = Some(last.time);
        Ok(Passed { jet: last.jet, impacts })
    }
}

/// Solves for the crossing of the wall upwards near a time, and differentiates the landing point
/// (y, z) implicitly; returns the time as well.
fn land_on_wall<O: ImpactOscillator, const ORDER: usize, A: Surface>(
    oscillator: &O,
    from: State,
    guess: f64,
) -> Result<(MapJet<A, OnWall>, f64), MapError> {
    let motion = oscillator.motion(from);
    let mut time = guess;
    for _ in 0..MOST_ITERATIONS {
        let here = motion.at(time);
        let step = here.position / here.velocity;
        time -= step;
        // NaN counts as far away as well.
        let near = (time - guess).abs() <= oscillator.forcing_period();
        if !near {
            break;
        }
        if step.abs() <= LAST_STEP_TO_SECTION {
            // One more step, of second order, leaves rounding only.
            let here = motion.at(time);
            time -= here.position / here.velocity;
            let jet = oscillator.flow_along::<ORDER>(&motion, from, time);
            let velocity = jet.value[1];
            if velocity.is_nan() || velocity <= 0.0 {
                return Err(MapError::NoCrossing { near: guess, velocity });
            }
            return Ok((implicit_impact::<ORDER, A>(oscillator, &jet, from.phase, time), time));
        }
    }
    Err(MapError::NoCrossing { near: guess, velocity: motion.at(guess).velocity })
}

/// The jet of (y', z') from the flow's jet at the wall, where x(u, z, s; μ, η) = 0 defines the
/// duration s.
fn implicit_impact<const ORDER: usize, A: Surface>(
    oscillator: &impl ImpactOscillator,
    jet: &FlowJet,
    phase: f64,
    time: f64,
) -> MapJet<A, OnWall> {
    let columns = map_columns::<A>();
    let frequency = oscillator.forcing_frequency();
    let omega = [0.0, 0.0, frequency.gradient[0], frequency.gradient[1]];
    let velocity = jet.jacobian[(0, flow::DURATION)];
    let acceleration = jet.jacobian[(1, flow::DURATION)];
    let ds = Vector4::from_fn(|a, _| -jet.jacobian[(0, columns[a])] / velocity);

    let mut map = MapJet::constant([jet.value[1], phase + frequency.value * time].into());
    for a in 0..4 {
        map.jacobian[(0, a)] = jet.jacobian[(1, columns[a])] + acceleration * ds[a];
        map.jacobian[(1, a)] = frequency.value * ds[a] + omega[a] * time;
    }
    if A::VARIABLES[1] == flow::PHASE {
        map.jacobian[(1, 1)] += 1.0;
    }
    if ORDER >= 2 {
        for a in 0..4 {
            for b in 0..=a {
                let along = |component: usize| second_along(&jet.hessians[component], &columns, &ds, a, b);
                let dds = -along(0) / velocity;
                let curvature = if b >= 2 { frequency.hessian[(a - 2, b - 2)] } else { 0.0 };
                let phase_entry =
                    frequency.value * dds + omega[a] * ds[b] + omega[b] * ds[a] + curvature * time;
                map.set_second(0, [a, b], along(1) + acceleration * dds);
                map.set_second(1, [a, b], phase_entry);
            }
        }
    }
    map
}
