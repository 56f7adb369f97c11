//! Time per point of the saddle-node curves of `examples/duffing.toml`, compared with the same
//! oscillator in compiled Rust.
//!
//! A point includes its correction, its multipliers and its admissibility over the whole orbit; the
//! end of the curve is located along the way.

use core::hint::black_box;
use std::path::Path;

use divan::Bencher;
use divan::counter::ItemsCount;
use grazing_continuation::arclength::StepControl;
use grazing_continuation::curve::{Curve, Route, Window};
use grazing_continuation::locate::Condition;
use grazing_continuation::mps::EventTimes;
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_input::Description;
use grazing_model::smooth::{Function, Integrated, Scalar, SmoothOscillator};

fn main() {
    divan::main();
}

/// The oscillator of the file, in Rust.
#[derive(Clone)]
struct Duffing {
    zeta: f64,
    kappa: f64,
    epsilon: f64,
}

impl SmoothOscillator for Duffing {
    #[inline]
    fn force<S: Scalar>(&self, x: S, y: S, t: S, amplitude: S, omega: S) -> S {
        self.force_at(t, amplitude, omega)(x, y)
    }

    #[inline]
    fn force_at<T: Scalar, S: Scalar + From<T>>(
        &self,
        t: T,
        amplitude: T,
        omega: T,
    ) -> impl FnMut(S, S) -> S {
        let drive = S::from(amplitude * (omega * t).apply(Function::Cos) - T::constant(1.0));
        move |x, y| drive - y.scale(2.0 * self.zeta) - x - x.square() * x.scale(self.kappa)
    }

    fn forcing_frequency<S: Scalar>(&self, _: S, omega: S) -> S {
        omega
    }

    fn restitution<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
        S::constant(self.epsilon)
    }

    fn impact_duration<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
        S::constant(0.0)
    }
}

/// The oscillator as read from the file.
fn written() -> Description {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/duffing.toml");
    Description::from_file(&path).unwrap()
}

/// The oscillator of the file with a compiled force.
fn compiled() -> Duffing {
    let written = written();
    let constant = |wanted: &str| written.constants().find(|(name, _)| *name == wanted).unwrap().1;
    let epsilon = written.restitution(0.0, 0.0, 0.0, 0.0);
    Duffing { zeta: constant("zeta"), kappa: constant("kappa"), epsilon }
}

/// The start of Newton's method for a p-loop resonance: phase, amplitude and frequency.
struct Place {
    loops: u32,
    near: [f64; 3],
}

impl core::fmt::Display for Place {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "p = {}", self.loops)
    }
}

/// Starts found by homotopy from the linear oscillator's resonances with the largest regions (n =
/// 3, 1, 1; empirical).
const PLACES: [Place; 3] = [
    Place { loops: 1, near: [0.0668, 0.6734, 0.7597] },
    Place { loops: 2, near: [0.0868, 0.3983, 0.9134] },
    Place { loops: 3, near: [0.1242, 0.2857, 0.9781] },
];

/// A route through the window of the file.
fn route() -> Route<'static> {
    let file = written();
    Route {
        window: Window { primary: file.primary().range(), secondary: file.secondary().range() },
        control: StepControl::DRAWING,
        step_limit: 20_000,
        stop_at_events: true,
        pace: None,
    }
}

/// Benchmark in which one item is one point of the curve.
fn follow<M: SmoothOscillator>(bencher: Bencher<'_, '_>, model: M, place: &Place) {
    let [phase, amplitude, omega] = place.near;
    let oscillator = Integrated::new(model, [amplitude, omega]);
    let resonance = ResonantGrazingPoint::find(&oscillator, place.loops, phase).unwrap();
    let condition = Condition::SADDLE_NODE;
    let curve = resonance.curve(condition);
    let (start, direction, route) = (resonance.unknowns(), resonance.direction(condition), route());
    let follow = || -> Curve {
        black_box(&curve)
            .clone()
            .follow(start.clone(), direction.clone(), EventTimes::default(), &route)
            .unwrap()
    };
    bencher.counter(ItemsCount::new(follow().points.len())).bench(follow);
}

#[divan::bench(args = PLACES)]
fn point_in_compiled_rust(bencher: Bencher<'_, '_>, place: &Place) {
    follow(bencher, compiled(), place);
}

#[divan::bench(args = PLACES)]
fn point_from_the_text_file(bencher: Bencher<'_, '_>, place: &Place) {
    follow(bencher, written(), place);
}
