//! The errors of measured coefficients are correct: at random resonances theorem and curve differ
//! by less.
//!
//! The number of resonances can be chosen (a thousand take some minutes):
//!
//! ```sh
//! GRAZING_RESONANCES=1000 cargo test -p grazing-unfold --test unfold calibration -- --nocapture
//! ```

use std::io::Write;

use grazing_continuation::curve::Window;
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_input::Description;
use grazing_unfold::progress::Silent;
use grazing_unfold::verdict::{Coefficient, Verdict, coefficients};
use grazing_unfold::{Diagram, Scope};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::Rng;
use rayon::prelude::*;

/// Default number of resonances.
const FEW: usize = 60;

/// Number of resonances of linear oscillators for each one of an integrated oscillator, which takes
/// a hundred times as long.
const INTEGRATED: usize = 5;

/// A seeded source of random numbers.
struct Source(Pcg64Mcg);

impl Source {
    fn between(&mut self, [low, high]: [f64; 2]) -> f64 {
        low + (high - low) * (self.0.next_u64() >> 11) as f64 * libm::ldexp(1.0, -53)
    }

    /// A random number that is equally likely in any decade.
    fn scaled(&mut self, [low, high]: [f64; 2]) -> f64 {
        libm::exp(self.between([libm::log(low), libm::log(high)]))
    }
}

fn asked() -> usize {
    std::env::var("GRAZING_RESONANCES").map_or(FEW, |count| count.parse().expect("it is a number"))
}

/// Fails unless deviations are within errors in at least 95 of 100 cases and never contradict, and
/// errors are small where the coefficient can be measured.
fn assert_calibrated(what: &str, measured: &[Coefficient]) {
    let mut relative: Vec<f64> = Vec::new();
    let (mut within, mut unmeasured, mut contradictions) = (0, 0, Vec::new());
    for coefficient in measured {
        match (coefficient.verdict(), &coefficient.fit) {
            (Verdict::NotMeasurable(_), _) | (_, Err(_)) => unmeasured += 1,
            (verdict, Ok(fit)) => {
                within += usize::from(verdict == Verdict::Agree);
                relative.push(fit.coefficient.error / coefficient.theorem.value.abs());
                if verdict == Verdict::Contradict {
                    contradictions.push(coefficient);
                }
            }
        }
    }
    relative.sort_by(f64::total_cmp);
    let (count, median) = (relative.len(), relative[relative.len() / 2]);
    writeln!(
        std::io::stderr(),
        "{what}: of {} coefficients {unmeasured} not measurable, {within} of the other {count} within the error, whose median is \
         {median:.1e}",
        measured.len()
    )
    .expect("there is an error stream");
    assert!(20 * within >= 19 * count, "{what}: {contradictions:?}");
    // Strong damping over several periods leaves coefficients that are lost in rounding, some of
    // seven here.
    assert!(4 * unmeasured <= measured.len(), "{what}: {unmeasured}");
    assert!(median < 1e-7, "{what}: {median}");
}

fn measured(points: &[ResonantGrazingPoint]) -> Vec<Coefficient> {
    points.par_iter().flat_map_iter(|point| coefficients(point).into_array()).collect()
}

#[test]
fn errors_of_coefficients_of_random_linear_oscillators_hold() {
    let mut source = Source(Pcg64Mcg::new(1));
    let mut points = Vec::new();
    let mut exact = Vec::new();
    while points.len() < asked() {
        let (zeta, epsilon) = (source.scaled([0.003, 0.3]), source.between([0.3, 1.0]));
        let (loops, n) = (source.between([1.0, 5.0]) as u32, source.between([1.0, 7.0]) as u32);
        let theory = grazing_theorems::LinearOscillator::new(zeta, epsilon).unwrap();
        let known = theory.resonance(loops, n).unwrap();
        let (amplitude, omega) = (known.grazing().amplitude(), known.forcing_frequency());
        let oscillator = crate::specimens::linear(zeta, epsilon, [amplitude, omega]);
        // Where ε E_p > 1 or an entry of A is lost in rounding, no theorem applies.
        if let Ok(point) = ResonantGrazingPoint::find(&oscillator, loops, known.grazing().phase()) {
            points.push(point);
            exact.extend([known.saddle_node_coefficient(), known.period_doubling_coefficient()]);
        }
    }
    let measured = measured(&points);
    assert_calibrated("linear", &measured);
    for (coefficient, exact) in measured.iter().zip(exact) {
        // The theorem's own error, against the closed form's rounding.
        let deviation = (coefficient.theorem.value - exact).abs();
        assert!(deviation <= coefficient.theorem.error + 1e-13 * exact.abs(), "{coefficient:?}, {exact:e}");
    }
}

/// An oscillator with a nonlinear spring, nonlinear drag, or neither, and an impact that varies and
/// takes time.
fn description(source: &mut Source, kind: usize) -> Description {
    let zeta = source.scaled([0.003, 0.3]);
    let bent = match kind % 3 {
        0 => format!("- {}*x^3", source.between([-0.1, 0.6])),
        1 => format!("- {}*v*sqrt(v^2 + {})", source.between([0.0, 0.3]), source.scaled([0.01, 0.3])),
        _ => format!("- {}*x^2", source.between([0.0, 0.2])),
    };
    let text = format!(
        "name = \"Random\"\n[parameters]\n[primary]\nname = \"A\"\nrange = [0.0, 2.0]\n[secondary]\nname = \"omega\"\nrange = [0.4, 1.2]\n\
         [motion]\nforce = \"-2*{zeta}*v - x - 1 + A*cos(omega*t) {bent}\"\nfrequency = \"omega\"\n[impact]\n\
         restitution = \"{}*exp(-{}*y) + {}*sin(z)\"\nduration = \"{}/(1 + y^2)\"\n[analysis]\nloops = [1, 2, 3]\n",
        source.between([0.3, 0.9]),
        source.between([0.0, 1.0]),
        source.between([0.0, 0.1]),
        source.between([-0.1, 0.3]),
    );
    Description::parse(&text, "random.toml").unwrap_or_else(|error| panic!("{error}\n{text}"))
}

#[test]
fn errors_of_coefficients_of_random_integrated_oscillators_hold() {
    let mut source = Source(Pcg64Mcg::new(2));
    let mut points = Vec::new();
    let mut kind = 0;
    while points.len() * INTEGRATED < asked() {
        let description = description(&mut source, kind);
        kind += 1;
        let window =
            Window { primary: description.primary().range(), secondary: description.secondary().range() };
        let scope = Scope { window, loops: description.loops().to_vec(), start: None };
        let oscillator = description.oscillator([1.0, 0.8]);
        // Some have no grazing in the window.
        if let Ok(diagram) = Diagram::located(&oscillator, &scope, &Silent) {
            points.extend(diagram.unfolding().map(|(_, point)| point.clone()));
        }
    }
    assert_calibrated("integrated", &measured(&points));
}
