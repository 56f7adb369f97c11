//! Any impact oscillator as a value.

use core::any::Any;
use core::fmt;
use std::sync::Arc;

use crate::jet::{FlowJet, MapJet, ParameterJet};
use crate::motion::{Crossing, Kinematics, Maximum, Motion};
use crate::oscillator::ImpactOscillator;
use crate::state::{OnWall, State};

/// Any [`ImpactOscillator`] as a value of one type: code built on it is compiled once and accepts
/// every oscillator.
#[derive(Clone)]
pub struct AnyOscillator(Arc<dyn Erased>);

impl AnyOscillator {
    /// Wraps an oscillator.
    pub fn new<O: ImpactOscillator<Motion: 'static> + 'static>(oscillator: O) -> Self {
        Self(Arc::new(oscillator))
    }
}

impl fmt::Debug for AnyOscillator {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_tuple("AnyOscillator").field(&self.0.parameters()).finish()
    }
}

/// Any [`Motion`] as a value of one type: the motion of an [`AnyOscillator`].
pub struct AnyMotion(Box<dyn ErasedMotion>);

impl AnyMotion {
    /// Wraps a motion.
    pub fn new(motion: impl Motion + 'static) -> Self {
        Self(Box::new(motion))
    }

    /// The wrapped motion, if it is of this type.
    pub fn downcast_ref<M: 'static>(&self) -> Option<&M> {
        self.0.as_any().downcast_ref()
    }
}

impl fmt::Debug for AnyMotion {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_tuple("AnyMotion").field(&self.0.at(0.0)).finish()
    }
}

trait ErasedMotion: Motion {
    fn as_any(&self) -> &dyn Any;
}

impl<M: Motion + 'static> ErasedMotion for M {
    fn as_any(&self) -> &dyn Any {
        self
    }
}

/// [`ImpactOscillator`] without types and numbers in its methods' signatures.
trait Erased: Send + Sync {
    fn parameters(&self) -> [f64; 2];
    fn with_parameters(&self, parameters: [f64; 2]) -> AnyOscillator;
    fn roughly(&self) -> AnyOscillator;
    fn finely(&self) -> Option<AnyOscillator>;
    fn forcing_frequency(&self) -> ParameterJet;
    fn acceleration(&self, state: State) -> f64;
    fn flow_along(&self, order: usize, motion: &AnyMotion, from: State, duration: f64) -> FlowJet;
    fn reset(&self, order: usize, impact: OnWall) -> MapJet<OnWall, OnWall>;
    fn motion(&self, from: State) -> AnyMotion;
    fn other_stop(&self) -> Option<AnyOscillator>;
    fn gap(&self, phase: f64) -> [ParameterJet; 2];
}

impl<O: ImpactOscillator<Motion: 'static> + 'static> Erased for O {
    fn parameters(&self) -> [f64; 2] {
        O::parameters(self)
    }

    fn with_parameters(&self, parameters: [f64; 2]) -> AnyOscillator {
        AnyOscillator::new(O::with_parameters(self, parameters))
    }

    fn roughly(&self) -> AnyOscillator {
        AnyOscillator::new(O::roughly(self))
    }

    fn finely(&self) -> Option<AnyOscillator> {
        O::finely(self).map(AnyOscillator::new)
    }

    fn forcing_frequency(&self) -> ParameterJet {
        O::forcing_frequency(self)
    }

    fn acceleration(&self, state: State) -> f64 {
        O::acceleration(self, state)
    }

    fn flow_along(&self, order: usize, motion: &AnyMotion, from: State, duration: f64) -> FlowJet {
        match (motion.downcast_ref(), order) {
            (Some(motion), 2..) => O::flow_along::<2>(self, motion, from, duration),
            (Some(motion), _) => O::flow_along::<1>(self, motion, from, duration),
            // The motion belongs to another oscillator and cannot be used here.
            (None, 2..) => O::flow::<2>(self, from, duration),
            (None, _) => O::flow::<1>(self, from, duration),
        }
    }

    fn reset(&self, order: usize, impact: OnWall) -> MapJet<OnWall, OnWall> {
        if order >= 2 { O::reset::<2>(self, impact) } else { O::reset::<1>(self, impact) }
    }

    fn motion(&self, from: State) -> AnyMotion {
        AnyMotion::new(O::motion(self, from))
    }

    fn other_stop(&self) -> Option<AnyOscillator> {
        O::other_stop(self).map(AnyOscillator::new)
    }

    fn gap(&self, phase: f64) -> [ParameterJet; 2] {
        O::gap(self, phase)
    }
}

impl ImpactOscillator for AnyOscillator {
    type Motion = AnyMotion;

    fn parameters(&self) -> [f64; 2] {
        self.0.parameters()
    }

    fn with_parameters(&self, parameters: [f64; 2]) -> Self {
        self.0.with_parameters(parameters)
    }

    fn roughly(&self) -> Self {
        self.0.roughly()
    }

    fn finely(&self) -> Option<Self> {
        self.0.finely()
    }

    fn forcing_frequency(&self) -> ParameterJet {
        self.0.forcing_frequency()
    }

    fn acceleration(&self, state: State) -> f64 {
        self.0.acceleration(state)
    }

    fn flow_along<const ORDER: usize>(&self, motion: &AnyMotion, from: State, duration: f64) -> FlowJet {
        self.0.flow_along(ORDER, motion, from, duration)
    }

    fn reset<const ORDER: usize>(&self, impact: OnWall) -> MapJet<OnWall, OnWall> {
        self.0.reset(ORDER, impact)
    }

    fn motion(&self, from: State) -> AnyMotion {
        self.0.motion(from)
    }

    fn other_stop(&self) -> Option<Self> {
        self.0.other_stop()
    }

    fn gap(&self, phase: f64) -> [ParameterJet; 2] {
        self.0.gap(phase)
    }
}

impl Motion for AnyMotion {
    fn at(&self, time: f64) -> Kinematics {
        self.0.at(time)
    }

    fn first_crossing(&self, horizon: f64) -> Option<Crossing> {
        self.0.first_crossing(horizon)
    }

    fn local_maxima(&self, horizon: f64) -> Vec<Maximum> {
        self.0.local_maxima(horizon)
    }

    fn highest_maximum(&self, horizon: f64) -> Option<Maximum> {
        self.0.highest_maximum(horizon)
    }

    fn first_rest(&self, forwards: bool, horizon: f64) -> Option<f64> {
        self.0.first_rest(forwards, horizon)
    }
}
