//! Motion without impacts of a symmetric oscillator, and motion with one impact at each of two stops.

use core::f64::consts::{PI, TAU};

use grazing_model::maps::{self, MapError};
use grazing_model::{ImpactOscillator, MapJet, OnWall, State};

use super::{EventTimes, LoopEquations, LoopPair, Round, Unknowns, planes};
use crate::newton::{Linearisation, Space};
use crate::tolerances::RECURS;
use crate::unknowns::{Square, parameters, unknown};

/// A symmetry of an oscillator without its wall: with x(t), 2c − x(t + T/2) is a motion as well.
///
/// Motion that is its own image recurs, mirrored, after half a forcing period: it is a fixed point
/// of the map H over half a period followed by the mirror. The flow over the whole period is H²,
/// and its multipliers are squares. Where a multiplier of H is −1 that of the flow is 1: a
/// pitchfork, at which two motions begin that are each other's images.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Symmetry {
    /// The centre c where both parameters vanish.
    pub centre: f64,
    /// The slopes of the centre in μ and η.
    pub slopes: [f64; 2],
}

impl Symmetry {
    /// The mirror image (2c − x, −ẋ) of a map to (x, ẋ), at the parameters of a point.
    pub(super) fn mirrored<A, B>(&self, map: MapJet<A, B>, at: &Unknowns) -> MapJet<A, B> {
        let mut mirrored = map;
        mirrored.value.neg_mut();
        mirrored.jacobian.neg_mut();
        mirrored.hessians.iter_mut().for_each(|hessian| hessian.neg_mut());
        let [primary, secondary] = parameters(at);
        let [by_primary, by_secondary] = self.slopes;
        mirrored.value[0] += 2.0 * (self.centre + by_primary * primary + by_secondary * secondary);
        mirrored.jacobian[(0, 2)] += 2.0 * by_primary;
        mirrored.jacobian[(0, 3)] += 2.0 * by_secondary;
        mirrored
    }
}

/// Number of states and impacts at which an oscillator is compared with its mirror image; their velocities are up
/// to this, in units in which motion is of the order of one.
const STATES: u32 = 48;
const FASTEST: f64 = 3.0;
/// Relative difference of forces that is rounding: of phases half a period apart, times the derivative in the phase.
const ROUNDING: f64 = 1e-12;
/// Difference of multipliers over both halves of a solution that is its own image: it is off by [`RECURS`] at most, and
/// multipliers change this many times as much (empirical).
const SENSITIVE: f64 = 1e3;

/// Whether an oscillator with two stops looks the same from each, half a forcing period later, at states that fill the
/// room between the stops evenly.
///
/// A difference that vanishes at all of them could be confined to a fiftieth of the room; therefore what is
/// concluded of a solution is compared with both halves of it as well.
fn is_symmetric(oscillator: &impl ImpactOscillator) -> bool {
    let Some(other) = oscillator.other_stop() else { return false };
    let same = |a: f64, b: f64| (a - b).abs() <= ROUNDING * (1.0 + a.abs());
    let share = |number: u32, square: f64| {
        let turns = f64::from(number) * square.sqrt();
        turns - libm::floor(turns)
    };
    (1..=STATES).all(|number| {
        let phase = TAU * share(number, 2.0);
        let position = -oscillator.gap(phase)[0].value * share(number, 3.0);
        let velocity = FASTEST * (2.0 * share(number, 5.0) - 1.0);
        let [here, there] = [phase, phase + PI];
        let forces = same(
            oscillator.acceleration(State { position, velocity, phase: here }),
            other.acceleration(State { position, velocity, phase: there }),
        );
        let reset = |seen: &dyn Fn(OnWall) -> OnWall, phase| {
            let after = seen(OnWall::new(velocity.abs(), phase));
            [after.velocity, after.phase - phase]
        };
        let [a, b] = reset(&|impact| oscillator.reset::<1>(impact).image(), here);
        let [c, d] = reset(&|impact| other.reset::<1>(impact).image(), there);
        let gaps = [here, there].map(|phase| oscillator.gap(phase)[0].value);
        forces && same(a, c) && same(b, d) && same(gaps[0], gaps[1])
    })
}

impl<O: ImpactOscillator> LoopEquations<O> {
    /// Whether solutions hit each of two stops once, and may be their own mirror images.
    fn may_be_mirrored(&self, point: &Unknowns) -> bool {
        point.impacts() == 2 && self.stops() == [0, 1] && !self.loops().is_multiple_of(2)
    }

    /// Whether solutions like one have mirror images, and may be their own: there are pitchforks then.
    pub fn have_images(&self, like: &Unknowns) -> bool {
        self.may_be_mirrored(like) && is_symmetric(&self.oscillator_at(like))
    }

    /// The direction in which solutions that are not symmetric leave one that is, at a pitchfork: over half a
    /// period, in the mirror, it is turned round.
    pub fn leaving_symmetry(&self, at: &Unknowns) -> Option<Unknowns> {
        if !self.has_impacts() {
            let [x, y] =
                self.halved()?.maps::<1>(at, &mut EventTimes::default()).ok()?.direction(-1.0)?.into();
            return Some(Unknowns::new(x, y, 0.0, 0.0));
        }
        self.may_be_mirrored(at).then_some(())?;
        let [velocity, phase] = self.mirrored_maps::<1>(at, at[unknown::PHASE]).direction(-1.0)?.into();
        let there = OnWall::new(-velocity, -phase);
        Some(Unknowns::of_impacts(&[OnWall::new(velocity, phase), there], [0.0; 2]))
    }

    /// The maps over half the time of a solution with one impact at each of two symmetric stops, the second
    /// p/2 forcing periods after the first: as the other stop sees them, they lead to an impact like the first.
    fn mirrored_maps<const ORDER: usize>(&self, point: &Unknowns, plane: f64) -> Round {
        let (oscillator, impact) = (self.oscillator_at(point), point.impact(0));
        let reset = oscillator.reset::<ORDER>(impact);
        let [recoil, before]: [State; 2] = [reset.image().into(), impact.into()];
        let to = plane + f64::from(self.loops()) * PI;
        let around = maps::to_phase::<O, ORDER, OnWall>(&oscillator, &oscillator.motion(recoil), recoil, to);
        let around = maps::across(&oscillator, &around, to).after::<ORDER, _>(&reset);
        let motion = oscillator.motion(before);
        let ahead = maps::to_phase::<O, ORDER, OnWall>(&oscillator, &motion, before, plane);
        LoopPair::of(&around, &ahead).into()
    }

    /// The maps over half the time of a solution that is its own mirror image, given its flights; `None` for all
    /// others.
    pub(super) fn mirrored(&self, point: &Unknowns, flights: &[O::Motion]) -> Option<Round> {
        self.may_be_mirrored(point).then_some(())?;
        let apart = [
            point[unknown::velocity(1)] - point[unknown::VELOCITY],
            point[unknown::phase(1)] - point[unknown::PHASE] - f64::from(self.loops()) * PI,
        ];
        let is_image = apart.iter().all(|apart| apart.abs() < RECURS);
        (is_image && is_symmetric(&self.oscillator_at(point))).then_some(())?;
        let half = self.mirrored_maps::<1>(point, point[unknown::PHASE]);
        // The maps through both impacts know nothing of a symmetry.
        let whole = self.fixed_phase_maps::<1>(point, &planes(point), flights).multipliers();
        let square = half.stability().of_the_square().multipliers;
        let size = SENSITIVE * RECURS * (1.0 + square.trace.abs() + square.determinant.abs());
        let apart = [whole.trace - square.trace, whole.determinant - square.determinant];
        apart.iter().all(|apart| apart.abs() <= size).then_some(half)
    }

    /// The equations of solutions that are their own mirror images, with a multiplier of −1 over half the
    /// time, and the maps over it.
    ///
    /// # Errors
    /// There are no such solutions.
    pub(crate) fn symmetry_breaking(
        &self,
        point: &Unknowns,
        times: &EventTimes,
    ) -> Result<(Linearisation<Unknowns>, Round), MapError> {
        if !self.have_images(point) {
            return Err(MapError::NotSymmetric);
        }
        let plane = times.planes.first().copied().unwrap_or(point[unknown::PHASE]);
        let half = self.mirrored_maps::<2>(point, plane);
        let (gap, slopes) = half.first().difference();
        let (value, gradient) = half.characteristic(-1.0);
        let mut jacobian = Square::zeros(point.size());
        let mut residual = point.filled(0.0);
        for row in 0..2 {
            residual[row] = gap[row];
            (0..4).for_each(|column| jacobian[[row, column]] = slopes[(row, column)]);
        }
        let pairs = [(unknown::VELOCITY, 0.0), (unknown::PHASE, f64::from(self.loops()) * PI)];
        for (row, (own, later)) in (2..).zip(pairs) {
            let image = if own == unknown::VELOCITY { unknown::velocity(1) } else { unknown::phase(1) };
            residual[row] = point[image] - point[own] - later;
            (jacobian[[row, image]], jacobian[[row, own]]) = (1.0, -1.0);
        }
        residual[4] = value;
        (0..4).for_each(|column| jacobian[[4, column]] = gradient[column]);
        Ok((Linearisation { residual, jacobian }, half))
    }
}
