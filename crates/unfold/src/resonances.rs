//! Resonances on a grazing curve: found, located, numbered, and held against the hypotheses of Theorems 2.4 and 2.5.

use grazing_continuation::resonance::{LocatedResonance, ResonanceError, ResonantGrazingPoint};
use grazing_model::ImpactOscillator;
use grazing_theorems::HypothesesViolated;

use crate::Scope;
use crate::grazing::{GrazingCurve, GrazingState};
use crate::winding;

/// A resonant grazing bifurcation of the non-impacting solution.
#[derive(Clone, Debug)]
pub struct Resonance<O> {
    /// Number of loops p.
    pub loops: u32,
    /// The integer n: half-turns (p = 1) or whole turns (p ≥ 2) of neighbouring motion in a forcing period.
    pub n: u32,
    /// The resonance as located.
    pub located: LocatedResonance<O>,
    /// The theorem that holds there, or the hypotheses of which some fail.
    pub theorem: Result<ResonantGrazingPoint<O>, HypothesesViolated>,
}

/// A resonance that was seen between two points of the grazing curve and could not be located.
#[derive(Clone, Debug)]
pub struct Unlocated {
    /// Number of loops p.
    pub loops: u32,
    /// The parameters (μ, η) near which it was seen.
    pub near: [f64; 2],
    /// What happened.
    pub reason: ResonanceError,
}

/// The resonances of all p of the scope on the admissible part of a grazing curve: by p, and in the order of the curve for each.
pub fn on_curve<O: ImpactOscillator>(
    curve: &GrazingCurve<O>,
    scope: &Scope,
) -> (Vec<Resonance<O>>, Vec<Unlocated>) {
    let (mut found, mut lost) = (Vec::new(), Vec::new());
    for &loops in &scope.loops {
        for pair in curve.states.windows(2) {
            if !(pair[0].admissible && pair[1].admissible) {
                continue;
            }
            let stretch = Stretch::new([&pair[0], &pair[1]], loops, scope);
            for way in stretch.zeros() {
                match stretch.locate(way, loops) {
                    Ok(located) => found.push(numbered(located)),
                    Err(reason) => lost.push(Unlocated { loops, near: stretch.parameters(way), reason }),
                }
            }
        }
    }
    (found, lost)
}

fn numbered<O: ImpactOscillator>(located: LocatedResonance<O>) -> Resonance<O> {
    let loops = located.loops();
    Resonance { loops, n: winding::index(located.orbit(), loops), theorem: located.checked(), located }
}

/// The grazing curve between two neighbouring points, and a₁₂ or κ_p along it as a cubic with the right values and slopes at both
/// ends, so that two zeros between the points are seen as well.
struct Stretch<'a, O> {
    ends: [&'a GrazingState<O>; 2],
    values: [f64; 2],
    /// Derivatives with respect to the share of the way.
    slopes: [f64; 2],
}

/// Parts of a stretch between which a sign change is looked for.
const PARTS: u32 = 8;

impl<'a, O: ImpactOscillator> Stretch<'a, O> {
    fn new(ends: [&'a GrazingState<O>; 2], loops: u32, scope: &Scope) -> Self {
        // The stretch's length in the variables in which the curve was followed.
        let place = |state: &GrazingState<O>| {
            let [primary, secondary] = scope.shares(state.orbit.oscillator().parameters());
            [state.orbit.phase(), primary, secondary]
        };
        let [a, b] = ends.map(place);
        let length =
            ((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]) + (b[2] - a[2]) * (b[2] - a[2]))
                .sqrt();
        let at = ends.map(|state| {
            let rate = state.orbit.derivative_along(&state.tangent) * length;
            state.orbit.detuning(loops, &rate)
        });
        Self { ends, values: [at[0][0], at[1][0]], slopes: [at[0][1], at[1][1]] }
    }

    /// Hermite's cubic.
    fn at(&self, way: f64) -> f64 {
        let rest = 1.0 - way;
        let [a, b] = self.values;
        let [da, db] = self.slopes;
        rest * rest * ((1.0 + 2.0 * way) * a + way * da) + way * way * ((1.0 + 2.0 * rest) * b - rest * db)
    }

    /// The shares of the way at which the cubic changes its sign.
    fn zeros(&self) -> Vec<f64> {
        let part = |k: u32| f64::from(k) / f64::from(PARTS);
        let mut found = Vec::new();
        for k in 0..PARTS {
            let (mut low, mut high) = (part(k), part(k + 1));
            let sign = self.at(low) > 0.0;
            // Where κ_p is not a number (δ ≤ 0) there is no resonance.
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

    fn between(&self, way: f64, value: impl Fn(&GrazingState<O>) -> f64) -> f64 {
        value(self.ends[0]) * (1.0 - way) + value(self.ends[1]) * way
    }

    fn parameters(&self, way: f64) -> [f64; 2] {
        [0, 1].map(|i| self.between(way, |state| state.orbit.oscillator().parameters()[i]))
    }

    fn locate(&self, way: f64, loops: u32) -> Result<LocatedResonance<O>, ResonanceError> {
        let oscillator = self.ends[0].orbit.oscillator().with_parameters(self.parameters(way));
        LocatedResonance::find(&oscillator, loops, self.between(way, |state| state.orbit.phase()))
    }
}
