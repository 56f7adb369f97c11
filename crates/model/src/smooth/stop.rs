//! Ending a computation early: a flag that any thread can set, and oscillators that cease to move
//! once it is set.
//!
//! An analysis is loops in loops, and the innermost of all is a step of the integration, or a
//! motion in closed form. So the flag is read by the force, or by the motion: once the computation
//! is cancelled it is NaN, no step can be made, and no motion is found. Every loop then ends within
//! moments in the same way as for motion that does not exist, and Newton's method, the continuation
//! and the search for events need no code for it. The result that was being computed at that moment
//! is meaningless; the caller checks [`Stop::is_asked`] afterwards and leaves it out.

use core::cell::Cell;
use core::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::Arc;

use super::oscillator::SmoothOscillator;
use super::partials::Partials;
use super::purpose::Purpose;
use crate::jet::{FlowJet, MapJet, ParameterJet};
use crate::motion::{BoundedMotion, Enclosure, Kinematics};
use crate::oscillator::ImpactOscillator;
use crate::scalar::Scalar;
use crate::state::{OnWall, State};

/// A flag that cancels a computation; clones share it. It also counts the steps of integration, and
/// motions in closed form, by their [`Purpose`].
#[derive(Clone, Debug)]
pub struct Stop(Arc<Shared>);

#[derive(Debug)]
struct Shared {
    asked: AtomicBool,
    by_purpose: [AtomicU64; Purpose::ALL.len()],
    most: u64,
    /// Whether the limit of steps has been lifted.
    lifted: AtomicBool,
}

impl Default for Stop {
    /// A flag that is set only by hand.
    fn default() -> Self {
        Self::after(u64::MAX)
    }
}

/// Number of steps that a thread makes before it adds them to the common count: updating a shared
/// count at every step would cost more than the step.
const LOT: u64 = 256;

thread_local! {
    static OWN: [Cell<u64>; Purpose::ALL.len()] = const { [const { Cell::new(0) }; Purpose::ALL.len()] };
}

impl Stop {
    /// A flag that is set after about this many steps of integration.
    pub fn after(steps: u64) -> Self {
        let (asked, lifted) = (AtomicBool::new(false), AtomicBool::new(false));
        let by_purpose = core::array::from_fn(|_| AtomicU64::new(0));
        Self(Arc::new(Shared { asked, by_purpose, most: steps, lifted }))
    }

    /// Cancels the computation.
    pub fn ask(&self) {
        self.0.asked.store(true, Ordering::Relaxed);
    }

    /// Clears the request, and the limit of steps with it: everything moves again, so that finished
    /// results can be written.
    pub fn withdraw(&self) {
        self.0.lifted.store(true, Ordering::Relaxed);
        self.0.asked.store(false, Ordering::Relaxed);
    }

    /// Whether the computation is cancelled.
    #[inline]
    pub fn is_asked(&self) -> bool {
        self.0.asked.load(Ordering::Relaxed)
    }

    /// The number of steps of integration so far, without the last few of each thread.
    pub fn steps(&self) -> u64 {
        self.by_purpose().map(|(_, count)| count).sum()
    }

    /// Whether all steps that were allowed have been made.
    pub fn is_used_up(&self) -> bool {
        self.steps() >= self.0.most
    }

    /// The number of these steps for each purpose.
    pub fn by_purpose(&self) -> impl Iterator<Item = (Purpose, u64)> {
        Purpose::ALL.into_iter().zip(self.0.by_purpose.iter().map(|count| count.load(Ordering::Relaxed)))
    }

    #[inline]
    fn count(&self) {
        let purpose = Purpose::current() as usize;
        OWN.with(|own| {
            let steps = own[purpose].get() + 1;
            own[purpose].set(steps % LOT);
            if steps == LOT {
                self.0.by_purpose[purpose].fetch_add(LOT, Ordering::Relaxed);
                if self.is_used_up() && !self.0.lifted.load(Ordering::Relaxed) {
                    self.ask();
                }
            }
        });
    }
}

/// A [`SmoothOscillator`] whose force is NaN once the computation is cancelled, or an
/// [`ImpactOscillator`] in which no motion begins after that.
#[derive(Clone, Debug)]
pub struct Stoppable<M> {
    model: M,
    stop: Stop,
}

impl<M> Stoppable<M> {
    /// The oscillator, cancelled by this flag.
    pub fn new(model: M, stop: Stop) -> Self {
        Self { model, stop }
    }
}

impl<M: SmoothOscillator> SmoothOscillator for Stoppable<M> {
    #[inline]
    fn force<S: Scalar>(&self, x: S, y: S, t: S, mu: S, eta: S) -> S {
        if self.stop.is_asked() { S::constant(f64::NAN) } else { self.model.force(x, y, t, mu, eta) }
    }

    #[inline]
    fn force_at<T: Scalar, S: Scalar + From<T>>(&self, t: T, mu: T, eta: T) -> impl FnMut(S, S) -> S {
        self.stop.count();
        // The part that is computed once for many places may be most of the work.
        let mut force = (!self.stop.is_asked()).then(|| self.model.force_at(t, mu, eta));
        move |x, y| match &mut force {
            Some(force) if !self.stop.is_asked() => force(x, y),
            _ => S::constant(f64::NAN),
        }
    }

    #[inline]
    fn slopes_at<S: Scalar>(&self, t: S, mu: S, eta: S) -> Option<impl FnMut(S, S, bool) -> [S; 3]> {
        if self.stop.is_asked() {
            return None;
        }
        let mut force = self.model.slopes_at(t, mu, eta)?;
        self.stop.count();
        Some(move |x, y, slopes| match self.stop.is_asked() {
            true => [S::constant(f64::NAN); 3],
            false => force(x, y, slopes),
        })
    }

    #[inline]
    fn partials<S: Scalar>(&self, arguments: &[S; 5], second: bool, partials: &mut Partials<S>) -> bool {
        // Once an end is asked for, the force is evaluated with jets, and is not a number.
        !self.stop.is_asked() && self.model.partials(arguments, second, partials)
    }

    fn forcing_frequency<S: Scalar>(&self, mu: S, eta: S) -> S {
        self.model.forcing_frequency(mu, eta)
    }

    fn restitution<S: Scalar>(&self, y: S, z: S, mu: S, eta: S) -> S {
        self.model.restitution(y, z, mu, eta)
    }

    fn impact_duration<S: Scalar>(&self, y: S, z: S, mu: S, eta: S) -> S {
        self.model.impact_duration(y, z, mu, eta)
    }

    fn harmonics(&self) -> Option<u32> {
        self.model.harmonics()
    }

    fn other_stop(&self) -> Option<Self> {
        self.model.other_stop().map(|model| self.with(model))
    }

    fn gap<S: Scalar>(&self, t: S, mu: S, eta: S) -> [S; 2] {
        self.model.gap(t, mu, eta)
    }
}

impl<M> Stoppable<M> {
    fn with(&self, model: M) -> Self {
        Self { model, stop: self.stop.clone() }
    }
}

impl<M: ImpactOscillator<Motion: BoundedMotion>> Stoppable<M> {
    /// The state in which a motion begins, NaN once the computation is cancelled.
    fn beginning(&self, from: State) -> State {
        if self.stop.is_asked() { State { position: f64::NAN, velocity: f64::NAN, ..from } } else { from }
    }
}

/// A motion that is NaN once the computation is cancelled, even in the middle of a search for
/// events.
#[derive(Clone, Debug)]
pub struct StoppableMotion<M> {
    motion: M,
    stop: Stop,
}

impl<M: BoundedMotion> BoundedMotion for StoppableMotion<M> {
    #[inline]
    fn kinematics_at(&self, time: f64) -> Kinematics {
        self.motion.kinematics_at(if self.stop.is_asked() { f64::NAN } else { time })
    }

    #[inline]
    fn enclose(&self, horizon: f64) -> impl Enclosure {
        self.motion.enclose(horizon)
    }

    #[inline]
    fn foresight(&self) -> f64 {
        self.motion.foresight()
    }
}

impl<M: ImpactOscillator<Motion: BoundedMotion>> ImpactOscillator for Stoppable<M> {
    type Motion = StoppableMotion<M::Motion>;

    fn parameters(&self) -> [f64; 2] {
        self.model.parameters()
    }

    fn with_parameters(&self, parameters: [f64; 2]) -> Self {
        self.with(self.model.with_parameters(parameters))
    }

    fn roughly(&self) -> Self {
        self.with(self.model.roughly())
    }

    fn finely(&self) -> Option<Self> {
        self.model.finely().map(|model| self.with(model))
    }

    fn forcing_frequency(&self) -> ParameterJet {
        self.model.forcing_frequency()
    }

    fn acceleration(&self, state: State) -> f64 {
        self.model.acceleration(state)
    }

    fn flow_along<const ORDER: usize>(&self, motion: &Self::Motion, from: State, duration: f64) -> FlowJet {
        self.model.flow_along::<ORDER>(&motion.motion, self.beginning(from), duration)
    }

    fn reset<const ORDER: usize>(&self, impact: OnWall) -> MapJet<OnWall, OnWall> {
        self.model.reset::<ORDER>(impact)
    }

    fn other_stop(&self) -> Option<Self> {
        self.model.other_stop().map(|model| self.with(model))
    }

    fn gap(&self, phase: f64) -> [ParameterJet; 2] {
        self.model.gap(phase)
    }

    fn motion(&self, from: State) -> Self::Motion {
        self.stop.count();
        StoppableMotion { motion: self.model.motion(self.beginning(from)), stop: self.stop.clone() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::LinearOscillator;
    use crate::motion::Motion;
    use crate::smooth::Integrated;

    /// ẍ = −x − 1.
    #[derive(Clone)]
    struct Spring;

    impl SmoothOscillator for Spring {
        fn force<S: Scalar>(&self, x: S, _: S, _: S, _: S, _: S) -> S {
            -x - S::constant(1.0)
        }

        fn forcing_frequency<S: Scalar>(&self, _: S, eta: S) -> S {
            eta
        }

        fn restitution<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
            S::constant(1.0)
        }

        fn impact_duration<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
            S::constant(0.0)
        }
    }

    /// The spring, cancelled by a flag.
    fn spring(stop: &Stop) -> Integrated<Stoppable<Spring>> {
        Integrated::new(Stoppable::new(Spring, stop.clone()), [0.0, 1.0])
    }

    fn position_after(oscillator: &Integrated<Stoppable<Spring>>, time: f64) -> f64 {
        oscillator.motion(State::on_wall(0.0, 0.0)).at(time).position
    }

    #[test]
    fn nothing_moves_once_an_end_is_asked_for_until_the_request_is_withdrawn() {
        let stop = Stop::default();
        let oscillator = spring(&stop);
        let before = position_after(&oscillator, 2.0);
        // x = cos t − 1, to the integration's tolerance.
        assert!((before - (libm::cos(2.0) - 1.0)).abs() < 1e-12, "{before}");
        stop.ask();
        assert!(position_after(&oscillator, 2.0).is_nan());
        stop.withdraw();
        assert_eq!(position_after(&oscillator, 2.0).to_bits(), before.to_bits());
    }

    #[test]
    fn motion_in_closed_form_ends_like_that_which_is_integrated() {
        let stop = Stop::default();
        let linear = LinearOscillator::new(0.03, 0.9, 0.5, 0.8).unwrap();
        let oscillator = Stoppable::new(linear, stop.clone()).with_parameters([0.9, 0.8]);
        let from = State::at_rest(-1.5, 0.3);
        let before = oscillator.motion(from).first_crossing(50.0);
        assert!(
            before.is_some()
                && before == linear.with_parameters([0.9, 0.8]).motion(from).first_crossing(50.0)
        );
        let begun = oscillator.motion(from);
        stop.ask();
        let motion = oscillator.motion(from);
        assert!(motion.at(0.0).position.is_nan() && oscillator.flow::<1>(from, 1.0).value[0].is_nan());
        // However far the horizon, no cell is walked through.
        assert_eq!((motion.first_crossing(1e300), motion.highest_maximum(1e300)), (None, None));
        assert_eq!((motion.local_maxima(1e300).len(), motion.first_rest(true, 1e300)), (0, None));
        // A motion that began before the request ends as well.
        assert!(begun.at(1.0).position.is_nan());
        stop.withdraw();
        assert_eq!(oscillator.motion(from).first_crossing(50.0), before);
    }

    #[test]
    fn nothing_is_computed_of_a_force_once_an_end_is_asked_for() {
        /// A force that counts how often it is prepared for a time.
        #[derive(Clone)]
        struct Counting(Arc<AtomicU64>);

        impl SmoothOscillator for Counting {
            fn force<S: Scalar>(&self, x: S, _: S, _: S, _: S, _: S) -> S {
                -x
            }

            fn force_at<T: Scalar, S: Scalar + From<T>>(&self, _: T, _: T, _: T) -> impl FnMut(S, S) -> S {
                self.0.fetch_add(1, Ordering::Relaxed);
                |x: S, _| -x
            }

            fn forcing_frequency<S: Scalar>(&self, _: S, eta: S) -> S {
                eta
            }

            fn restitution<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
                S::constant(1.0)
            }

            fn impact_duration<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
                S::constant(0.0)
            }
        }

        let (count, stop) = (Arc::new(AtomicU64::new(0)), Stop::default());
        let oscillator = Integrated::new(Stoppable::new(Counting(count.clone()), stop.clone()), [0.0, 1.0]);
        let from = State::at_rest(-1.0, 0.0);
        assert!(oscillator.motion(from).at(2.0).position.is_finite());
        let before = count.load(Ordering::Relaxed);
        assert!(before > 0);
        stop.ask();
        assert!(oscillator.motion(from).at(2.0).position.is_nan());
        assert_eq!(count.load(Ordering::Relaxed), before);
    }

    #[test]
    fn steps_are_counted_and_their_limit_asks_for_the_end_once() {
        let stop = Stop::after(10 * LOT);
        let oscillator = spring(&stop);
        let mut motions = 0;
        while !stop.is_asked() {
            assert!(!stop.is_used_up());
            position_after(&oscillator, 6.0);
            motions += 1;
        }
        // Some ten steps each, and no more than a hundred.
        assert!(motions > 20 && stop.is_used_up(), "{motions}");
        stop.withdraw();
        for _ in 0..motions {
            position_after(&oscillator, 6.0);
        }
        assert!(!stop.is_asked(), "what is written down afterwards has no limit");
    }

    #[test]
    fn steps_are_counted_by_the_innermost_purpose() {
        let stop = Stop::default();
        let oscillator = spring(&stop);
        let move_on = || (0..100).for_each(|_| assert!(position_after(&oscillator, 6.0).is_finite()));
        Purpose::Lattices.during(|| {
            move_on();
            Purpose::Events.during(|| (move_on(), move_on()));
            move_on();
        });
        let counts: Vec<u64> = stop.by_purpose().map(|(_, count)| count).collect();
        assert_eq!(counts.iter().sum::<u64>(), stop.steps());
        let of = |purpose: Purpose| counts[purpose as usize];
        // Apart from the last few.
        assert!(of(Purpose::Lattices).abs_diff(of(Purpose::Events)) <= LOT && of(Purpose::Events) > LOT);
        assert_eq!(of(Purpose::Other), 0);
        assert!(Purpose::ALL.iter().enumerate().all(|(place, purpose)| *purpose as usize == place));
    }

    #[test]
    fn an_end_that_is_withdrawn_before_the_steps_are_used_up_lifts_their_limit() {
        let stop = Stop::after(2 * LOT);
        let oscillator = spring(&stop);
        stop.withdraw();
        for _ in 0..100 {
            position_after(&oscillator, 6.0);
        }
        assert!(stop.is_used_up() && !stop.is_asked());
    }
}
