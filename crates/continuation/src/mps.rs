//! Maximal periodic solutions (MPSs), and periodic solutions without impacts, as zeros of smooth
//! functions.
//!
//! A p-loop MPS has one impact, at velocity y and phase z, and returns to it after p forcing
//! periods. Two maps lead from (y, z) to one surface: one through the recoil and p loops, the other
//! straight from the impact, with the wall ignored. The MPS is where they agree; its stability
//! multipliers are the eigenvalues of the first one's derivative times the inverse of the second
//! one's. The choice of the surface gives the [`Formulation`].
//!
//! A periodic solution without impacts is the case p = 0: from (x, y) at phase zero the flow leads
//! round one forcing period, and the other map is the identity. Everything else is the same: two
//! equations, multipliers from the two maps, a highest maximum.

mod pair;
mod symmetry;

use core::f64::consts::{PI, TAU};

use grazing_model::maps::{self, MapError, Passage};
use grazing_model::motion::{Maximum, Motion};
use grazing_model::phase::turned;
use grazing_model::smooth::Purpose;
use grazing_model::{AnyOscillator, AtPhase, ImpactOscillator, MapJet, OnWall, State, Surface};
use grazing_theorems::from_map::GrazingOrbit;
use nalgebra::{SMatrix, Vector2, Vector4};
use smallvec::SmallVec;

pub use pair::LoopPair;
pub use symmetry::Symmetry;

use crate::newton::Linearisation;
pub(crate) use crate::solution::Stability;
pub use crate::solution::{Multipliers, PeriodicSolution, Unknowns, parameters, unknown};
use crate::tolerances::{FAR, RECURS, REST, UNSURE_HEIGHT};

/// The impact at a point.
fn impact(point: &Unknowns) -> OnWall {
    OnWall::new(point[unknown::VELOCITY], point[unknown::PHASE])
}

/// The state at phase zero for a point without impacts.
fn at_phase_zero(point: &Unknowns) -> AtPhase {
    AtPhase::new(point[0], point[1])
}

/// Fraction of a flight: a maximum nearer to one of its ends than this is that end, which is
/// located like all maxima to some 10⁻⁸.
const END: f64 = 1e-4;

/// The surface on which the map through recoil and loops is compared with the direct map from the
/// impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Formulation {
    /// The Poincaré section Π, y = 0: the VIVID function V = P_global^p ∘ P_virt ∘ R − P_virt
    /// (eq:V), the paper's method. It ends where one of the maxima that it passes through
    /// disappears: that of a loop on Π, or the virtual one beyond the wall, as where the wall is
    /// met with ẍ ≥ 0.
    Vivid,
    /// The plane of constant phase through the impact: flow for p forcing periods from the impact
    /// phase, less the duration of the recoil. It has no virtual points and is defined everywhere,
    /// and one landing serves all loops: curves are followed with it.
    FixedPhase,
}

/// State carried along a curve: event times, so that "the next maximum" is never ambiguous, and the
/// phase of the comparison plane.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EventTimes {
    /// Evolution times of P_virt from the impact and from the recoil.
    virtual_times: [Option<f64>; 2],
    /// Return times of P_global, loop by loop.
    return_times: SmallVec<[f64; 4]>,
    /// Phase of the plane of [`Formulation::FixedPhase`].
    reference_phase: Option<f64>,
    /// Time from the recoil to the interior maximum that a grazing curve holds at the wall.
    pub(crate) grazing_time: f64,
    /// Time from the recoil to a second interior maximum, where two touch the wall.
    pub(crate) second_grazing_time: f64,
    /// The stability found by the last evaluation along a curve.
    pub(crate) stability: Option<Stability>,
    /// Whether the next evaluation may find another stability.
    pub(crate) unsettled: bool,
}

impl EventTimes {
    /// The event times with the time from the recoil to the interior maximum that is held at the
    /// wall.
    #[must_use]
    pub fn touching(self, time: f64) -> Self {
        Self { grazing_time: time, ..self }
    }
}

/// The equations of the periodic solutions of one oscillator with one impact in p forcing periods
/// (MPSs), or without impacts (p = 0).
#[derive(Clone, Debug)]
pub struct LoopEquations<O = AnyOscillator> {
    oscillator: O,
    loops: u32,
    formulation: Formulation,
    /// The units of μ and η in lengths.
    units: [f64; 2],
    /// The symmetry of motion without impacts.
    symmetry: Option<Symmetry>,
    /// Whether the equations are those of symmetric motion over half a period.
    halved: bool,
}

impl<O: ImpactOscillator> LoopEquations<O> {
    /// The equations of MPSs with `loops` = p ≥ 1 loops, or, for any formulation, of periodic
    /// solutions without impacts (p = 0); the oscillator's own parameters do not matter.
    pub fn new(oscillator: O, loops: u32, formulation: Formulation) -> Self {
        Self { oscillator, loops, formulation, units: [1.0; 2], symmetry: None, halved: false }
    }

    /// The equations of periodic solutions without impacts; in lengths of steps μ and η are
    /// measured in these units.
    pub fn without_impacts(oscillator: O, units: [f64; 2]) -> Self {
        Self { units, ..Self::new(oscillator, 0, Formulation::FixedPhase) }
    }

    /// The equations with the symmetry of motion without impacts, if any.
    #[must_use]
    pub fn with_symmetry(self, symmetry: Option<Symmetry>) -> Self {
        Self { symmetry, ..self }
    }

    /// The equations of symmetric motion: half a forcing period and the mirror lead back; `None`
    /// where there is no symmetry.
    pub fn halved(&self) -> Option<Self> {
        self.symmetry.map(|_| Self { halved: true, ..self.clone() })
    }

    /// The number of loops p; 0 without impacts.
    pub fn loops(&self) -> u32 {
        self.loops
    }

    /// Whether there is an impact in p forcing periods.
    pub fn has_impacts(&self) -> bool {
        self.loops > 0
    }

    /// The index of the unknown that is an angle: the impact phase.
    pub fn angle(&self) -> Option<usize> {
        self.has_impacts().then_some(unknown::PHASE)
    }

    /// The units of the unknowns in lengths.
    pub fn units(&self) -> Unknowns {
        Unknowns::new(1.0, 1.0, self.units[0], self.units[1])
    }

    /// The displacement from one point to another, with phases modulo 2π.
    pub fn gap(&self, from: &Unknowns, to: &Unknowns) -> Unknowns {
        let mut gap = to - from;
        if let Some(angle) = self.angle() {
            gap[angle] = libm::remainder(gap[angle], TAU);
        }
        gap.component_div(&self.units())
    }

    /// The formulation in use.
    pub fn formulation(&self) -> Formulation {
        self.formulation
    }

    /// The equations in another formulation.
    pub fn with_formulation(&self, formulation: Formulation) -> Self {
        Self { formulation, ..self.clone() }
    }

    /// The equations with motion computed to fewer digits, where that takes less time.
    #[must_use]
    pub fn roughly(&self) -> Self {
        Self { oscillator: self.oscillator.roughly(), ..self.clone() }
    }

    /// The equations with motion integrated in shorter steps; `None` where it is not integrated.
    pub fn finely(&self) -> Option<Self> {
        Some(Self { oscillator: self.oscillator.finely()?, ..self.clone() })
    }

    /// The oscillator at the parameters of a point.
    pub fn oscillator_at(&self, point: &Unknowns) -> O {
        self.oscillator.with_parameters(parameters(point))
    }

    /// The state in which the flight begins: just after the impact, (0, y_rec, z_rec); without
    /// impacts at phase zero, (x, y, 0).
    pub fn departure(&self, point: &Unknowns) -> State {
        match self.has_impacts() {
            true => self.oscillator_at(point).reset::<1>(impact(point)).image().into(),
            false => at_phase_zero(point).at_phase_zero(),
        }
    }

    /// The motion of the flight.
    pub(crate) fn motion(&self, point: &Unknowns) -> O::Motion {
        self.oscillator_at(point).motion(self.departure(point))
    }

    /// The two maps at a point with derivatives up to `ORDER`.
    ///
    /// # Errors
    /// VIVID is not defined there.
    pub fn pair<const ORDER: usize>(
        &self,
        point: &Unknowns,
        times: &mut EventTimes,
    ) -> Result<LoopPair, MapError> {
        match self.formulation {
            Formulation::Vivid if self.has_impacts() => {
                let oscillator = self.oscillator_at(point);
                let reset = oscillator.reset::<ORDER>(impact(point));
                let [from_impact, from_recoil] = times.virtual_times;
                let ahead = maps::virtual_map::<O, ORDER>(&oscillator, impact(point), from_impact)?;
                let back = maps::virtual_map::<O, ORDER>(&oscillator, reset.image(), from_recoil)?;
                times.virtual_times = [Some(ahead.time), Some(back.time)];
                let mut jet = back.jet.after::<ORDER, _>(&reset);
                times.return_times.resize(self.loops as usize, oscillator.forcing_period());
                for time in &mut times.return_times {
                    let next = maps::global_map::<O, ORDER>(&oscillator, jet.image(), Some(*time))?;
                    *time = next.time;
                    jet = next.jet.after::<ORDER, _>(&jet);
                }
                Ok(LoopPair::of(&jet, &ahead.jet))
            }
            _ => {
                let plane = *times.reference_phase.get_or_insert(point[unknown::PHASE]);
                let mirror = self.symmetry.filter(|_| self.halved);
                self.pair_along::<ORDER>(point, plane, &self.motion(point), mirror)
            }
        }
    }

    /// The two maps to the plane of constant phase `plane`, given the motion of the flight. Without
    /// impacts they are the flow over a forcing period, or over half of it with a mirror, and the
    /// identity; they are undefined where motion goes far away.
    fn pair_along<const ORDER: usize>(
        &self,
        point: &Unknowns,
        plane: f64,
        motion: &O::Motion,
        mirror: Option<Symmetry>,
    ) -> Result<LoopPair, MapError> {
        if self.has_impacts() {
            return Ok(self.fixed_phase_pair::<ORDER>(point, plane, motion));
        }
        let (oscillator, from) = (self.oscillator_at(point), at_phase_zero(point));
        let to = |phase| maps::to_phase::<O, ORDER, _>(&oscillator, motion, from.at_phase_zero(), phase);
        let around = match mirror {
            Some(symmetry) => symmetry.mirrored(to(PI), point),
            None => to(TAU),
        };
        let size = around.value.norm();
        // NaN counts as far away as well.
        if size.is_nan() || size > FAR {
            return Err(MapError::NoRest { near: oscillator.forcing_period(), velocity: size });
        }
        Ok(LoopPair::of(&around, &MapJet::identity(from)))
    }

    /// The two maps of an MPS to the plane of constant phase `plane`, which exist at every point.
    pub(crate) fn fixed_phase_pair<const ORDER: usize>(
        &self,
        point: &Unknowns,
        plane: f64,
        motion: &O::Motion,
    ) -> LoopPair {
        let oscillator = self.oscillator_at(point);
        let reset = oscillator.reset::<ORDER>(impact(point));
        let [from_recoil, from_impact]: [State; 2] = [reset.image().into(), impact(point).into()];
        let around_to = plane + f64::from(self.loops) * TAU;
        let around = maps::to_phase::<O, ORDER, _>(&oscillator, motion, from_recoil, around_to);
        let straight = oscillator.motion(from_impact);
        let ahead = maps::to_phase::<O, ORDER, OnWall>(&oscillator, &straight, from_impact, plane);
        LoopPair::of(&around.after::<ORDER, _>(&reset), &ahead)
    }

    /// Updates the carried state at an accepted point: the comparison plane moves to its phase.
    pub(crate) fn settle(&self, point: &Unknowns, times: &mut EventTimes) {
        times.reference_phase = Some(point[unknown::PHASE]);
    }

    /// The points (x⁽ʲ⁾, z⁽ʲ⁾), j = 1, …, p, at which the loops of an MPS meet Π; the last is
    /// virtual.
    ///
    /// Paper: eq:xjzj. Starts from the event times in `times`.
    ///
    /// # Errors
    /// A loop has no maximum of x near Π, half a forcing period or more after the one before, as
    /// where VIVID is not defined.
    pub fn visits(&self, point: &Unknowns, times: &EventTimes) -> Result<Vec<Vector2<f64>>, MapError> {
        let oscillator = self.oscillator_at(point);
        let recoil = oscillator.reset::<1>(impact(point)).image();
        let mut here = maps::virtual_map::<O, 1>(&oscillator, recoil, times.virtual_times[1])?.jet.image();
        (0..self.loops as usize)
            .map(|j| {
                let time = times.return_times.get(j).copied();
                here = maps::next_visit(&oscillator, here, time)?.jet.image();
                Ok(here.coordinates())
            })
            .collect()
    }

    /// The value of x at the maximum near a time after the recoil, with its first derivatives in
    /// the unknowns; the time becomes that of the maximum.
    ///
    /// # Errors
    /// The maximum has disappeared.
    pub fn maximum_near(&self, point: &Unknowns, time: &mut f64) -> Result<(f64, Vector4<f64>), MapError> {
        let oscillator = self.oscillator_at(point);
        let jet = if self.has_impacts() {
            let reset = oscillator.reset::<1>(impact(point));
            let landing = maps::virtual_map::<O, 1>(&oscillator, reset.image(), Some(*time))?;
            *time = landing.time;
            landing.jet.after::<1, _>(&reset).plain()
        } else {
            let landing = maps::maximum_from_phase_zero::<O, 1>(&oscillator, at_phase_zero(point), *time)?;
            *time = landing.time;
            landing.jet.plain()
        };
        Ok((jet.value[0], jet.jacobian.row(0).transpose()))
    }

    /// The solution on a curve of interior grazing as a grazing orbit with an impact elsewhere; `None` where
    /// P_global is not defined.
    pub fn touching_orbit(&self, point: &Unknowns, times: &EventTimes) -> Option<GrazingOrbit<O>> {
        let (oscillator, from) = (self.oscillator_at(point), self.departure(point));
        let (time, flight) = (times.grazing_time, self.flight(point));
        let phase = from.phase + oscillator.forcing_frequency().value * time;
        let passage = Passage::through(self.loops, [flight - time], time);
        GrazingOrbit::through(oscillator, phase, passage).ok()
    }

    /// The position x of the flight when the forcing is at a phase, counted from that of the
    /// recoil, with its first derivatives in the unknowns.
    pub fn position_at(&self, point: &Unknowns, phase: f64) -> (f64, Vector4<f64>) {
        let oscillator = self.oscillator_at(point);
        let reset = oscillator.reset::<1>(impact(point));
        let recoil: State = reset.image().into();
        let motion = oscillator.motion(recoil);
        let there = maps::to_phase::<O, 1, OnWall>(&oscillator, &motion, recoil, phase);
        let jet = there.after::<1, _>(&reset).plain();
        (jet.value[0], jet.jacobian.row(0).transpose())
    }

    /// The periodic solution at a zero of the equations: multipliers, maxima, stability,
    /// admissibility.
    ///
    /// No virtual points are needed, for any formulation.
    pub fn solution(&self, point: &Unknowns) -> PeriodicSolution {
        self.solution_and_stability(point).0
    }

    /// The periodic solution at a zero of the equations, with the stability from which its
    /// multipliers follow.
    pub(crate) fn solution_and_stability(&self, point: &Unknowns) -> (PeriodicSolution, Stability) {
        let motion = self.motion(point);
        let stability = self.symmetric_stability(point, &motion).unwrap_or_else(|| {
            let pair = self.pair_along::<1>(point, point[unknown::PHASE], &motion, None);
            pair.map_or(Stability::UNKNOWN, |pair| pair.stability())
        });
        (self.orbit(point, &motion, stability.multipliers), stability)
    }

    /// The stability of symmetric motion over the whole period, from the map over half of it.
    fn symmetric_stability(&self, point: &Unknowns, motion: &O::Motion) -> Option<Stability> {
        let mirror = Some(self.symmetry?);
        let pair = self.pair_along::<1>(point, point[unknown::PHASE], motion, mirror).ok()?;
        (pair.difference().0.norm() < RECURS).then(|| pair.stability().of_the_square())
    }

    /// The periodic solution at a point with y = 0 that is approached along a curve with the given
    /// tangent; its multipliers are limits.
    pub fn limiting_solution(&self, point: &Unknowns, tangent: &Unknowns) -> PeriodicSolution {
        let motion = self.motion(point);
        let pair = self.fixed_phase_pair::<2>(point, point[unknown::PHASE], &motion);
        let flight = self.flight(point);
        // The orbit begins and ends at a maximum; neither is an interior one.
        let ends = END * flight;
        let interior = motion
            .local_maxima(flight)
            .into_iter()
            .filter(|maximum| (ends..flight - ends).contains(&maximum.time));
        PeriodicSolution {
            loops: self.loops,
            unknowns: *point,
            multipliers: pair.limiting_multipliers(tangent),
            highest_interior_maximum: interior.max_by(|a, b| a.position.total_cmp(&b.position)),
        }
    }

    /// The periodic solution to fewer digits, with known multipliers; its maxima are computed only
    /// on request.
    pub(crate) fn sketch(
        &self,
        point: &Unknowns,
        multipliers: Multipliers,
        with_maxima: bool,
    ) -> PeriodicSolution {
        if with_maxima {
            let orbit = |equations: &Self| {
                let motion = equations.oscillator_at(point).motion(self.departure(point));
                self.orbit(point, &motion, multipliers)
            };
            return Purpose::Admissibility.during(|| {
                let rough = orbit(&self.roughly());
                if rough.ceiling().abs() > UNSURE_HEIGHT { rough } else { orbit(self) }
            });
        }
        let loops = self.loops;
        PeriodicSolution { loops, unknowns: *point, multipliers, highest_interior_maximum: None }
    }

    fn orbit(&self, point: &Unknowns, motion: &O::Motion, multipliers: Multipliers) -> PeriodicSolution {
        PeriodicSolution {
            loops: self.loops,
            unknowns: *point,
            multipliers,
            highest_interior_maximum: Purpose::Admissibility.during(|| match self.has_impacts() {
                true => motion.highest_maximum(self.flight(point)),
                false => Some(highest_point(motion, self.flight(point))),
            }),
        }
    }

    /// The time from the recoil to the next impact; without impacts the forcing period.
    pub fn flight(&self, point: &Unknowns) -> f64 {
        let oscillator = self.oscillator_at(point);
        match self.has_impacts() {
            true => flight_time(&oscillator, self.loops, point[unknown::PHASE], self.departure(point).phase),
            false => oscillator.forcing_period(),
        }
    }

    /// Velocity and phase of the impact of a solution; without impacts 0 and the phase of the
    /// highest point, in [0, 2π).
    pub fn impact(&self, solution: &PeriodicSolution) -> [f64; 2] {
        let point = &solution.unknowns;
        if self.has_impacts() {
            return [point[unknown::VELOCITY], point[unknown::PHASE]];
        }
        let time = solution.highest_interior_maximum.map_or(f64::NAN, |maximum| maximum.time);
        [0.0, turned(time * self.oscillator_at(point).forcing_frequency().value)]
    }
}

/// The time from the recoil to the impact of a solution with p loops, p T − (z_rec − z)/ω, computed
/// from the phases of impact and recoil.
pub fn flight_time<O: ImpactOscillator>(oscillator: &O, loops: u32, impact: f64, recoil: f64) -> f64 {
    let lag = (recoil - impact) / oscillator.forcing_frequency().value;
    f64::from(loops) * oscillator.forcing_period() - lag
}

/// Number of instants of a period at which rest is recognised: no motion is slow at all of them.
const INSTANTS: u32 = 32;

/// The highest point of periodic motion; the first point if it is at rest.
fn highest_point(motion: &impl Motion, period: f64) -> Maximum {
    let at_rest = (0..=INSTANTS).all(|instant| {
        let here = motion.at(period * f64::from(instant) / f64::from(INSTANTS));
        here.velocity.abs() * period <= REST && here.acceleration.abs() * period * period <= REST
    });
    // Slightly more than a period, so that a maximum at phase zero lies inside.
    let highest = if at_rest { None } else { motion.highest_maximum(1.25 * period) };
    highest.unwrap_or_else(|| Maximum { time: 0.0, position: motion.at(0.0).position })
}

/// Stacks V and one further scalar equation into the first three rows of a 4 × 4 system.
pub(crate) fn stack(
    (difference, derivative): (Vector2<f64>, SMatrix<f64, 2, 4>),
    (value, gradient): (f64, Vector4<f64>),
) -> Linearisation<4> {
    let mut system = Linearisation { residual: Vector4::zeros(), jacobian: SMatrix::zeros() };
    system.residual.fixed_rows_mut::<2>(0).copy_from(&difference);
    system.jacobian.fixed_rows_mut::<2>(0).copy_from(&derivative);
    system.residual[2] = value;
    system.jacobian.set_row(2, &gradient.transpose());
    system
}
