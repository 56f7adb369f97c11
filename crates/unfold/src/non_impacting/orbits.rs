//! The equations of periodic motion without the wall: fixed points of the flow over a forcing period.

use core::f64::consts::TAU;

use grazing_continuation::arclength::{CurveEquations, StepControl};
use grazing_continuation::locate::Condition;
use grazing_continuation::mps::{LoopPair, Multipliers};
use grazing_continuation::newton::{self, Linearisation};
use grazing_continuation::tolerances;
use grazing_model::maps::{MapError, stroboscopic_map};
use grazing_model::motion::{Maximum, Motion, highest_maximum};
use grazing_model::{AtPhase, ImpactOscillator, MapJet, State};
use nalgebra::{SMatrix, Vector2, Vector4};

use super::Height;
use crate::Scope;
use crate::edges::located;
use crate::grazing::HighestPoint;

/// An orbit: x and y at phase zero, and the shares of the ranges of μ and η.
pub(crate) type OrbitPoint = Vector4<f64>;

/// Positions in an [`OrbitPoint`].
pub(crate) const PRIMARY: usize = 2;
pub(crate) const SECONDARY: usize = 3;

/// Motion this far away, the wall's distance from rest being of order one, has run away.
pub(super) const FAR: f64 = 1e6;
/// Motion through less than this is rest: maxima of what rounding leaves are none.
const REST: f64 = 1e-9;
/// Instants of a period at which rest is seen: no motion is slow at all of them.
const INSTANTS: u32 = 32;

/// The equations of periodic orbits without impacts.
pub(crate) struct PeriodicOrbits<'a, O> {
    pub(crate) oscillator: &'a O,
    pub(crate) scope: &'a Scope,
    /// Steps along branches.
    pub(crate) control: StepControl,
}

/// An orbit and what is to be known of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PeriodicOrbit {
    pub(crate) orbit: OrbitPoint,
    pub(crate) height: Height,
    /// Time and position of the highest point, time counted from phase zero.
    pub(crate) highest: Maximum,
    pub(crate) phase_of_highest: f64,
    pub(crate) multipliers: Multipliers,
}

/// A curve of orbits: the equations with one more condition, a share of μ or η or a multiplier.
pub(super) struct PeriodicOrbitCurve<'a, O> {
    pub(super) orbits: &'a PeriodicOrbits<'a, O>,
    /// [`Condition::Primary`] or [`Condition::Secondary`] of a share, or [`Condition::Multiplier`].
    pub(super) condition: Condition,
}

impl<O: ImpactOscillator> CurveEquations<4> for PeriodicOrbitCurve<'_, O> {
    type Carried = ();
    type Failure = MapError;

    fn evaluate(&self, orbit: &OrbitPoint, (): &mut ()) -> Result<Linearisation<4>, MapError> {
        let mut system = Linearisation { residual: Vector4::zeros(), jacobian: SMatrix::zeros() };
        let pair = match self.condition {
            Condition::Multiplier(multiplier) => {
                let pair = self.orbits.pair::<2>(orbit)?;
                let (value, gradient) = pair.characteristic(multiplier);
                system.residual[2] = value;
                system.jacobian.set_row(2, &gradient.transpose());
                pair
            }
            Condition::Primary(share) | Condition::Secondary(share) => {
                let held = if matches!(self.condition, Condition::Primary(_)) { PRIMARY } else { SECONDARY };
                system.residual[2] = orbit[held] - share;
                system.jacobian[(2, held)] = 1.0;
                self.orbits.pair::<1>(orbit)?
            }
            _ => unreachable!("curves of periodic orbits have a fixed parameter or a fixed multiplier"),
        };
        let (difference, derivative) = pair.difference();
        system.residual.fixed_rows_mut::<2>(0).copy_from(&difference);
        system.jacobian.fixed_rows_mut::<2>(0).copy_from(&derivative);
        Ok(system)
    }
}

impl<O: ImpactOscillator> PeriodicOrbits<'_, O> {
    pub(super) fn oscillator_at(&self, orbit: &OrbitPoint) -> O {
        self.scope.oscillator_at(self.oscillator, [orbit[PRIMARY], orbit[SECONDARY]])
    }

    pub(super) fn parameters(&self, orbit: &OrbitPoint) -> [f64; 2] {
        self.scope.window.parameters([orbit[PRIMARY], orbit[SECONDARY]])
    }

    /// The stroboscopic map beside the identity, parameters counted in shares: their difference vanishes on orbits.
    fn pair<const ORDER: usize>(&self, orbit: &OrbitPoint) -> Result<LoopPair, MapError> {
        let mut jet =
            stroboscopic_map::<O, ORDER>(&self.oscillator_at(orbit), AtPhase::new(orbit[0], orbit[1]));
        let size = jet.value.norm();
        if !size.is_finite() || size > FAR {
            return Err(MapError::NoRest { near: TAU, velocity: size });
        }
        let widths = self.scope.window.widths();
        for (variable, width) in [PRIMARY, SECONDARY].into_iter().zip(widths) {
            jet.jacobian.column_mut(variable).scale_mut(width);
            for hessian in &mut jet.hessians {
                hessian.row_mut(variable).scale_mut(width);
                hessian.column_mut(variable).scale_mut(width);
            }
        }
        Ok(LoopPair::of(&jet, &MapJet::identity(AtPhase::new(orbit[0], orbit[1]))))
    }

    /// The orbit with a highest point.
    pub(crate) fn through(&self, highest: &HighestPoint) -> Option<OrbitPoint> {
        let oscillator = self.oscillator.with_parameters(highest.parameters);
        let phase = highest.phase - TAU * libm::floor(highest.phase / TAU);
        let rest = (TAU - phase) / oscillator.forcing_frequency().value;
        let there = oscillator.motion(State::at_rest(highest.height, phase)).at(rest);
        let [primary, secondary] = self.scope.window.shares(highest.parameters);
        self.at(&OrbitPoint::new(there.position, there.velocity, primary, secondary))
    }

    /// The orbit near a state at shares of the ranges, which are held.
    pub(crate) fn at(&self, near: &OrbitPoint) -> Option<OrbitPoint> {
        self.within(f64::INFINITY, near)
    }

    /// The same, given up as soon as an iterate is farther from the state than `reach`.
    pub(super) fn within(&self, reach: f64, near: &OrbitPoint) -> Option<OrbitPoint> {
        let start = Vector2::new(near[0], near[1]);
        let solution = newton::solve_within(reach, tolerances::STEP, start, 20, |state| {
            let (residual, derivative) = self
                .pair::<1>(&OrbitPoint::new(state[0], state[1], near[PRIMARY], near[SECONDARY]))?
                .difference();
            Ok::<_, MapError>(Linearisation {
                residual,
                jacobian: derivative.fixed_columns::<2>(0).into_owned(),
            })
        });
        let point = solution.ok()?.point;
        Some(OrbitPoint::new(point[0], point[1], near[PRIMARY], near[SECONDARY]))
    }

    /// The orbit with a multiplier at the share of μ or η of an orbit nearby, which is held.
    pub(super) fn with_multiplier(
        &self,
        near: &OrbitPoint,
        multiplier: Condition,
        held: usize,
    ) -> Option<OrbitPoint> {
        let curve = PeriodicOrbitCurve { orbits: self, condition: multiplier };
        located(&curve, *near, &OrbitPoint::ith(held, 1.0), near)
    }

    /// What is to be known of an orbit.
    pub(crate) fn seen(&self, orbit: &OrbitPoint) -> PeriodicOrbit {
        let oscillator = self.oscillator_at(orbit);
        let motion = oscillator.motion(State { position: orbit[0], velocity: orbit[1], phase: 0.0 });
        let frequency = oscillator.forcing_frequency().value;
        let period = TAU / frequency;
        let at_rest = (0..=INSTANTS).all(|instant| {
            let here = motion.at(period * f64::from(instant) / f64::from(INSTANTS));
            here.velocity.abs() * period <= REST && here.acceleration.abs() * period * period <= REST
        });
        // A little more than a period, so that a maximum at phase zero lies inside.
        let highest = if at_rest { None } else { highest_maximum(&motion, 1.25 * period) };
        let highest = highest.unwrap_or(Maximum { time: 0.0, position: orbit[0] });
        let multipliers = self
            .pair::<1>(orbit)
            .map_or(Multipliers { trace: f64::NAN, determinant: f64::NAN }, |pair| pair.multipliers());
        let height = Height {
            position: highest.position,
            parameters: self.parameters(orbit),
            acceleration: motion.at(highest.time).acceleration,
        };
        PeriodicOrbit {
            orbit: *orbit,
            height,
            highest,
            phase_of_highest: highest.time * frequency,
            multipliers,
        }
    }
}
