//! Resonances on a grazing curve: found, located, numbered, and checked against the hypotheses of
//! Theorems 2.4 and 2.5.

use core::f64::consts::TAU;

use grazing_continuation::curve::Window;
use grazing_continuation::resonance::{LocatedResonance, ResonanceError, ResonantGrazingPoint};
use grazing_model::ImpactOscillator;
use grazing_theorems::HypothesesViolated;
use grazing_theorems::from_map::GrazingOrbit;

use crate::Scope;
use crate::grazing::{GrazingCurve, GrazingCurvePoint, multipliers};
use crate::progress::Progress;
use crate::tolerances::BETWEEN_RESONANCES;
use crate::winding;

/// A resonant grazing bifurcation of the non-impacting solution.
#[derive(Clone, Debug)]
pub struct FoundResonance {
    /// Number of loops p.
    pub loops: u32,
    /// The integer n: half-turns (p = 1) or whole turns (p ≥ 2) of neighbouring motion in a forcing
    /// period; 0 where the grazing orbit has impacts elsewhere.
    pub n: u32,
    /// The resonance as located.
    pub located: LocatedResonance,
    /// The theorem that holds there, or its hypotheses if some fail.
    pub theorem: Result<ResonantGrazingPoint, HypothesesViolated>,
}

/// A resonance that was detected between two points of the grazing curve but could not be located.
#[derive(Clone, Debug)]
pub struct Unlocated {
    /// Number of loops p.
    pub loops: u32,
    /// The parameters (μ, η) near which it was detected.
    pub near: [f64; 2],
    /// The reason.
    pub reason: ResonanceError,
}

/// The stage in which resonances are looked for.
pub const STAGE: &str = "resonances on the grazing curve";

/// The resonances of all p of the scope on the admissible part of a grazing curve: by p, and in the
/// order of the curve for each.
///
/// Once the computation is cancelled, missing resonances are reported neither as found nor as lost.
pub fn on_curve(
    curve: &GrazingCurve,
    scope: &Scope,
    progress: &dyn Progress,
) -> (Vec<FoundResonance>, Vec<Unlocated>) {
    let (mut found, mut lost) = (Vec::new(), Vec::new());
    progress.begin(STAGE, scope.loops.len() as u64);
    for &loops in &scope.loops {
        for pair in curve.states.windows(2) {
            if !(pair[0].admissible && pair[1].admissible) {
                continue;
            }
            // What is rounding has no sign, and so no zeros.
            if pair.iter().any(GrazingCurvePoint::is_forgotten) {
                continue;
            }
            let step = Step::new([&pair[0], &pair[1]], loops, scope);
            for way in step.zeros() {
                let resonance = step.locate(way, loops).map(numbered);
                match resonance {
                    _ if progress.stopped() => break,
                    Ok(resonance) => found.push(resonance),
                    Err(reason) => lost.push(Unlocated { loops, near: step.parameters(way), reason }),
                }
            }
        }
        progress.step(STAGE);
    }
    progress.end(STAGE);
    (found, lost)
}

/// The resonances without duplicates, as found on two grazing curves that touch, or on both sides
/// of a point of one.
pub(crate) fn distinct(found: Vec<FoundResonance>, window: Window) -> Vec<FoundResonance> {
    let mut all: Vec<FoundResonance> = Vec::new();
    for new in found {
        if !all.iter().any(|old| old.is_same(&new, window)) {
            all.push(new);
        }
    }
    all
}

impl FoundResonance {
    /// Whether the curves of solutions with so many loops that leave the resonance lie on the grazing curve, but
    /// for rounding: for two loops and more all that is stable lies at a distance of the order of the square
    /// of the multipliers.
    pub(crate) fn is_forgotten(&self, loops: u32) -> bool {
        let orbit = self.located.orbit();
        multipliers(orbit.oscillator(), orbit.phase()).forget(loops.min(2))
    }

    fn is_same(&self, other: &Self, window: Window) -> bool {
        let orbits = [self, other].map(|resonance| resonance.located.orbit());
        let [here, there] = orbits.map(|orbit| orbit.oscillator().parameters());
        let widths = window.widths();
        // In a narrow window rounding is a large part of its width.
        let near = |k: usize| {
            (here[k] - there[k]).abs() <= BETWEEN_RESONANCES * widths[k].max(LEAST * here[k].abs())
        };
        let turned = libm::remainder(orbits[0].phase() - orbits[1].phase(), TAU).abs();
        (self.loops, self.n) == (other.loops, other.n) && near(0) && near(1) && turned <= BETWEEN_RESONANCES
    }
}

/// Least width of a window in this comparison, as a fraction of its parameters.
const LEAST: f64 = 1e-2;

fn numbered(located: LocatedResonance) -> FoundResonance {
    let loops = located.loops();
    let n = if located.orbit().impacts().is_empty() { winding::index(located.orbit(), loops) } else { 0 };
    FoundResonance { loops, n, theorem: located.checked(), located }
}

/// Number of parts of a step in which bisection begins.
const PARTS: u32 = 8;

/// The grazing curve between two neighbouring points, and a₁₂ or κ_p along it as a cubic with the
/// right values and slopes at both ends, so that two zeros between the points are seen as well.
struct Step<'a> {
    ends: [&'a GrazingCurvePoint; 2],
    values: [f64; 2],
    /// Derivatives with respect to the fraction of the way.
    slopes: [f64; 2],
}

impl<'a> Step<'a> {
    fn new(ends: [&'a GrazingCurvePoint; 2], loops: u32, scope: &Scope) -> Self {
        // The step's length in the variables in which the curve was followed.
        let length = (scope.place(&ends[1].orbit) - scope.place(&ends[0].orbit)).norm();
        let at = ends.map(|state| {
            let rate = state.orbit.derivative_along(&state.tangent) * length;
            state.orbit.detuning(loops, &rate)
        });
        Self { ends, values: [at[0][0], at[1][0]], slopes: [at[0][1], at[1][1]] }
    }

    /// The value of Hermite's cubic.
    fn at(&self, way: f64) -> f64 {
        let rest = 1.0 - way;
        let [a, b] = self.values;
        let [da, db] = self.slopes;
        rest * rest * ((1.0 + 2.0 * way) * a + way * da) + way * way * ((1.0 + 2.0 * rest) * b - rest * db)
    }

    /// The fractions of the way between which the cubic has at most one zero: its extrema and the
    /// ends of the parts, in order.
    fn brackets(&self) -> Vec<f64> {
        let [a, b] = self.values;
        let [da, db] = self.slopes;
        // The derivative is q₂ w² + q₁ w + q₀ at the fraction w of the way.
        let [q2, q1, q0] = [6.0 * (a - b) + 3.0 * (da + db), 6.0 * (b - a) - 4.0 * da - 2.0 * db, da];
        let root = (q1 * q1 - 4.0 * q2 * q0).sqrt();
        // Without cancellation; NaN where there are no extrema.
        let half = -0.5 * (q1 + root.copysign(q1));
        let mut points: Vec<f64> = (0..=PARTS).map(|k| f64::from(k) / f64::from(PARTS)).collect();
        points.extend([half / q2, q0 / half].into_iter().filter(|way| *way > 0.0 && *way < 1.0));
        points.sort_by(f64::total_cmp);
        points
    }

    /// The fractions of the way at which the cubic changes its sign.
    fn zeros(&self) -> Vec<f64> {
        let mut found = Vec::new();
        for bracket in self.brackets().windows(2) {
            let (mut low, mut high) = (bracket[0], bracket[1]);
            let sign = self.at(low) > 0.0;
            // Where κ_p is NaN (δ ≤ 0) there is no resonance.
            if self.at(low).is_nan() || self.at(high).is_nan() || sign == (self.at(high) > 0.0) {
                continue;
            }
            for _ in 0..20 {
                let middle = 0.5 * (low + high);
                if (self.at(middle) > 0.0) == sign { low = middle } else { high = middle }
            }
            found.push(0.5 * (low + high));
        }
        found
    }

    fn interpolated(&self, way: f64, value: impl Fn(&GrazingCurvePoint) -> f64) -> f64 {
        value(self.ends[0]) * (1.0 - way) + value(self.ends[1]) * way
    }

    fn parameters(&self, way: f64) -> [f64; 2] {
        [0, 1].map(|i| self.interpolated(way, |state| state.orbit.oscillator().parameters()[i]))
    }

    fn locate(&self, way: f64, loops: u32) -> Result<LocatedResonance, ResonanceError> {
        let beside = &self.ends[0].orbit;
        let oscillator = beside.oscillator().with_parameters(self.parameters(way));
        let phase = self.interpolated(way, |state| state.orbit.phase());
        if beside.impacts().is_empty() {
            return LocatedResonance::find(&oscillator, loops, phase);
        }
        let orbit = GrazingOrbit::along(&oscillator, phase, beside.passage().clone())?;
        LocatedResonance::of_impacting(orbit, loops)
    }
}

#[cfg(test)]
mod tests {
    use grazing_continuation::mps::Multipliers;
    use grazing_theorems::from_map::GrazingOrbit;
    use nalgebra::Vector3;

    use super::*;

    fn states() -> [GrazingCurvePoint; 2] {
        [0.8, 0.81].map(|frequency| {
            let near = crate::specimens::linear(0.02, [0.3, frequency]);
            let phase = libm::atan2(0.04 * frequency, 1.0 - frequency * frequency);
            let orbit = GrazingOrbit::find(&near, phase).expect("it grazes");
            GrazingCurvePoint {
                orbit,
                tangent: Vector3::y(),
                multipliers: Multipliers { trace: 0.5, determinant: 0.9 },
                admissible: true,
            }
        })
    }

    #[test]
    fn a_resonance_that_is_found_twice_is_one_in_any_window() {
        let oscillator = crate::specimens::linear(0.02, [0.3, 0.8]);
        let window = Window { primary: [0.0, 1.2], secondary: [0.55, 1.1] };
        let scope = Scope { window, loops: vec![1, 2], start: None };
        let near = oscillator.with_parameters([0.36, 0.8]);
        let orbit = GrazingOrbit::find(&near, states()[0].orbit.phase()).expect("it grazes");
        let curve = GrazingCurve::through(&orbit, &scope, 1).expect("it is one");
        let found = on_curve(&curve, &scope, &crate::progress::Silent).0;
        assert!(found.len() >= 2, "{}", found.len());
        let one = &found[0];
        let orbit = one.located.orbit();
        // Newton's method begins elsewhere, and ends elsewhere by rounding.
        let [primary, secondary] = orbit.oscillator().parameters();
        let beside = orbit.oscillator().with_parameters([primary + 1e-6, secondary - 1e-6]);
        let again = LocatedResonance::find(&beside, one.loops, orbit.phase() + 1e-6).map(numbered);
        let twice: Vec<FoundResonance> = found.iter().cloned().chain([again.expect("it is there")]).collect();
        let about = |value: f64| [value - 1e-9, value + 1e-9];
        let narrow = Window { primary: about(primary), secondary: about(secondary) };
        for window in [window, narrow] {
            assert_eq!(distinct(twice.clone(), window).len(), found.len());
        }
    }

    /// The zeros found of (w − a)(w − b) c, or of (w − a) c without b.
    fn found(a: f64, b: Option<f64>, c: f64) -> Vec<f64> {
        let [first, second] = states();
        let value = |w: f64| c * (w - a) * b.map_or(1.0, |b| w - b);
        let slope = |w: f64| c * b.map_or(1.0, |b| 2.0 * w - a - b);
        let step = Step {
            ends: [&first, &second],
            values: [value(0.0), value(1.0)],
            slopes: [slope(0.0), slope(1.0)],
        };
        step.zeros()
    }

    #[test]
    fn two_zeros_within_a_step_are_seen_however_close_they_are() {
        for (a, b) in [(0.2, 0.7), (0.3, 0.34), (0.51, 0.52), (1e-4, 1.0 - 1e-4), (0.1, 0.1 + 1e-5)] {
            for c in [1.0, -30.0] {
                let zeros = found(a, Some(b), c);
                assert_eq!(zeros.len(), 2, "{a} {b}");
                // Twenty halvings of an eighth, and a parabola's rounding over the distance of its
                // zeros.
                for (zero, wanted) in zeros.iter().zip([a, b]) {
                    assert!((zero - wanted).abs() < 2e-7, "{zero} instead of {wanted}");
                }
            }
        }
    }

    #[test]
    fn a_zero_is_seen_once_and_none_where_there_is_none() {
        for a in [1e-9, 0.125, 0.3, 0.5, 0.875, 1.0 - 1e-9] {
            assert_eq!(found(a, None, -2.0).len(), 1, "{a}");
        }
        for (a, b) in [(-0.1, Some(1.1)), (-0.1, Some(-0.2)), (1.01, None), (-0.01, None)] {
            assert!(found(a, b, 3.0).is_empty(), "{a} {b:?}");
        }
    }

    #[test]
    fn neighbouring_stretches_share_a_zero_at_their_common_end_between_them() {
        // One step ends where the next begins: the zero belongs to one of them, for either sign of
        // its rounding error.
        let scope = Scope {
            window: Window { primary: [0.0, 1.0], secondary: [0.0, 1.0] },
            loops: vec![1],
            start: None,
        };
        let [first, second] = states();
        for end in [0.0, 1e-18, -1e-18] {
            let ends = [&first, &second];
            let before = Step { values: [-1.0, end], slopes: [1.0; 2], ..Step::new(ends, 1, &scope) };
            let after = Step { values: [end, 1.0], slopes: [1.0; 2], ..Step::new(ends, 1, &scope) };
            assert_eq!(before.zeros().len() + after.zeros().len(), 1, "{end}");
        }
    }
}
