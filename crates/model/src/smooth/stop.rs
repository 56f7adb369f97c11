//! Ending a computation early: a mark that anybody can set, and oscillators that cease to move once
//! it is.
//!
//! An analysis is loops in loops, and the innermost of all is a step of the integration. So it is
//! the force that asks: once an end is asked for it is NaN, no step can be made, and whatever waits
//! for a motion finds that there is none. Every loop then ends within moments by the way it has
//! anyway for motion that does not exist, and nothing that Newton's method, the continuation or the
//! search for events do has to know of it. What was being computed at that moment is worth nothing
//! and is left out by whoever asks [`Stop::is_asked`] afterwards.

use core::cell::Cell;
use core::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::Arc;

use super::oscillator::SmoothOscillator;
use crate::scalar::Scalar;

/// A mark that asks a computation to end; clones share it. It counts the steps of integration as
/// well.
#[derive(Clone, Debug)]
pub struct Stop(Arc<Shared>);

#[derive(Debug)]
struct Shared {
    asked: AtomicBool,
    steps: AtomicU64,
    most: u64,
    /// The steps are not limited any more.
    lifted: AtomicBool,
}

impl Default for Stop {
    /// A mark that nobody sets but by hand.
    fn default() -> Self {
        Self::after(u64::MAX)
    }
}

/// Every thread adds its steps to the common count in lots of this size: a count that threads
/// shared step by step would cost them more than the step.
const LOT: u64 = 256;

thread_local! {
    static OWN: Cell<u64> = const { Cell::new(0) };
}

impl Stop {
    /// A mark that is set after about so many steps of integration.
    pub fn after(steps: u64) -> Self {
        let (asked, lifted) = (AtomicBool::new(false), AtomicBool::new(false));
        Self(Arc::new(Shared { asked, steps: AtomicU64::new(0), most: steps, lifted }))
    }

    /// Asks for the end.
    pub fn ask(&self) {
        self.0.asked.store(true, Ordering::Relaxed);
    }

    /// Clears the request, and the limit of steps with it: everything moves again, for whoever
    /// writes down what was finished.
    pub fn withdraw(&self) {
        self.0.lifted.store(true, Ordering::Relaxed);
        self.0.asked.store(false, Ordering::Relaxed);
    }

    /// Whether the end is asked for.
    #[inline]
    pub fn is_asked(&self) -> bool {
        self.0.asked.load(Ordering::Relaxed)
    }

    /// The number of steps of integration so far, those of the last moment left out.
    pub fn steps(&self) -> u64 {
        self.0.steps.load(Ordering::Relaxed)
    }

    /// Whether all steps that were allowed have been made.
    pub fn is_used_up(&self) -> bool {
        self.steps() >= self.0.most
    }

    #[inline]
    fn count(&self) {
        OWN.with(|own| {
            let steps = own.get() + 1;
            own.set(steps % LOT);
            if steps == LOT {
                let before = self.0.steps.fetch_add(LOT, Ordering::Relaxed);
                let reached = before < self.0.most && before.saturating_add(LOT) >= self.0.most;
                if reached && !self.0.lifted.load(Ordering::Relaxed) {
                    self.ask();
                }
            }
        });
    }
}

/// A [`SmoothOscillator`] whose force is NaN once an end is asked for.
#[derive(Clone, Debug)]
pub struct Stoppable<M> {
    model: M,
    stop: Stop,
}

impl<M> Stoppable<M> {
    /// The oscillator, to be ended by this mark.
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
        let mut force = self.model.force_at(t, mu, eta);
        move |x, y| if self.stop.is_asked() { S::constant(f64::NAN) } else { force(x, y) }
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
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::Motion;
    use crate::smooth::Integrated;
    use crate::{ImpactOscillator, State};

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

    /// The spring, to be ended by a mark.
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
