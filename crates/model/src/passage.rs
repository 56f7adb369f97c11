//! P_global of periodic motion that has impacts elsewhere.
//!
//! Impacts at other parts of the trajectory than the grazing point do not affect the smoothness of
//! P_global (section 6 of the paper): as long as they have a velocity, it is the composition of
//! flights from Π to the wall, from the wall to the wall and from the wall to Π, with the reset law
//! between each and the next.

use core::f64::consts::TAU;

use smallvec::SmallVec;

use crate::jet::MapJet;
use crate::maps::{Landing, MapError, land_on_section, land_on_wall};
use crate::oscillator::ImpactOscillator;
use crate::state::{AtRest, OnWall};

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
