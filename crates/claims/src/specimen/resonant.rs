//! Specimens at resonances, and points near them.

use crate::*;
use grazing_theorems::resonant_theorem::BifurcationCurve;
use std::sync::LazyLock;

/// A resonant grazing point of one oscillator.
pub(crate) struct ResonantSpecimen {
    pub(crate) resonance: ResonantGrazingPoint<Specimen>,
}

/// Coordinates of a point near a resonance: y, z − z_graz,η, μ, η.
pub(crate) type Offset = [f64; 4];

/// A point near a resonance, with the grazing orbit at its η.
#[derive(Clone)]
pub(crate) struct Near {
    pub(crate) unknowns: Unknowns,
    pub(crate) orbit: Grazing,
}

/// The numbers of section 5 at a resonance, in the paper's symbols.
pub(crate) struct Symbols {
    pub(crate) alpha: f64,
    pub(crate) omega: f64,
    pub(crate) gamma: f64,
    pub(crate) phi: f64,
    /// A^p at the resonance, as in section 5: A for p = 1, −δ^{p/2} I for p ≥ 2, with a₁₂ = 0.
    pub(crate) power: Matrix2<f64>,
    /// The number ξ_p.
    pub(crate) xi: f64,
    /// The number d_p.
    pub(crate) d: f64,
    /// The number e_p.
    pub(crate) e: f64,
    /// The number f_p along the grazing curve: a₁₂' and eq:fp.
    pub(crate) f: f64,
}

impl ResonantSpecimen {
    /// The resonance into which the resonance (p, n) of the linear oscillator is continued with this law.
    pub(crate) fn find(law: Law, loops: u32, index: u32) -> Result<Self, CheckError> {
        Ok(Self { resonance: law.resonance(loops, index)?.checked()? })
    }

    pub(crate) fn loops(&self) -> u32 {
        self.resonance.loops()
    }

    pub(crate) fn point(&self) -> &ResonantPoint {
        self.resonance.resonant_point()
    }

    pub(crate) fn symbols(&self) -> Result<Symbols, CheckError> {
        let point = self.point();
        let GrazingPoint { map, forcing_frequency: omega, gamma, phi, .. } = point.grazing;
        let orbit = self.resonance.orbit();
        let jet = global_iterate::<_, 2>(orbit.oscillator(), self.loops(), AtRest::new(0.0, orbit.phase()))?;
        let power = if self.loops() == 1 {
            Matrix2::new(map.a.m11, 0.0, map.a.m21, map.a.m22)
        } else {
            -Matrix2::identity() * modulus_power(self.loops(), map.determinant())
        };
        Ok(Symbols {
            alpha: point.grazing.alpha(),
            omega,
            gamma,
            phi,
            power,
            xi: point.second_phase_derivative,
            d: jet.hessians[0][(0, 1)],
            e: jet.hessians[0][(1, 2)],
            f: point.off_diagonal_slope(),
        })
    }

    /// The grazing orbit at a distance η from the resonance.
    pub(crate) fn grazing(&self, eta: f64) -> Option<Grazing> {
        let orbit = self.resonance.orbit();
        let [primary, secondary] = orbit.oscillator().parameters();
        let parameters = [primary + orbit.primary_slope() * eta, secondary + eta];
        let oscillator = orbit.oscillator().with_parameters(parameters);
        Grazing::find(&oscillator, orbit.phase() + orbit.phase_slope() * eta).ok()
    }

    /// The derivative in η of a function of P_global at grazing, along the grazing curve.
    pub(crate) fn along_grazing(
        &self,
        step: f64,
        number: fn(u32, &LinearisedMap) -> f64,
    ) -> Result<f64, CheckError> {
        let rate = slope(step, |eta| Some(number(self.loops(), &self.grazing(eta)?.grazing_point().map)));
        Ok(rate.ok_or("no grazing orbit beside a resonance")?)
    }

    /// The point at an offset from the resonance.
    pub(crate) fn near(&self, [y, z, mu, eta]: Offset) -> Option<Near> {
        let orbit = self.grazing(eta)?;
        let [primary, secondary] = orbit.oscillator().parameters();
        Some(Near { unknowns: Unknowns::new(y, orbit.phase() + z, primary + mu, secondary), orbit })
    }

    /// The phase z_graz at the resonance itself.
    pub(crate) fn fixed_phase(&self) -> f64 {
        self.resonance.orbit().phase()
    }

    /// The zero of the VIVID function with impact velocity y at η: (z, μ) = (Z, M)(y, η) of eq:ZM.
    pub(crate) fn on_branch(&self, y: f64, eta: f64) -> Option<Near> {
        let branch = self.resonance.theorem().branch();
        let near = self.near([y, branch.k_1 * y, branch.parameter(y, eta), eta])?;
        self.solved([Condition::ImpactVelocity(y), Condition::Secondary(near.unknowns[3])], near)
    }

    /// The point of a bifurcation curve at η, from its leading terms.
    pub(crate) fn on_curve(&self, curve: &TheoremCurve, eta: f64) -> Option<Near> {
        let leading = &curve.leading;
        let near = self.near([
            leading.impact_velocity_slope * eta,
            leading.impact_phase_slope * eta,
            leading.coefficient * eta * eta,
            eta,
        ])?;
        self.solved([curve.condition, Condition::Secondary(near.unknowns[3])], near)
    }

    /// The two paths from the impact of a point to one surface, to first order.
    pub(crate) fn maps(&self, near: &Near) -> Result<Round, MapError> {
        self.resonance.equations().maps::<1>(&near.unknowns, &mut EventTimes::default())
    }

    /// The MPS at a point.
    pub(crate) fn solution(&self, near: &Near) -> PeriodicSolution {
        self.resonance.equations().solution(&near.unknowns)
    }

    fn solved(&self, conditions: [Condition; 2], near: Near) -> Option<Near> {
        let unknowns = located(self.resonance.equations(), conditions, near.unknowns)?;
        Some(Near { unknowns, ..near })
    }

    /// The saddle-node and the period-doubling curve.
    pub(crate) fn curves(&self) -> [TheoremCurve; 2] {
        let theorem = self.resonance.theorem();
        let stability = self.point().stability_coefficients();
        [
            TheoremCurve {
                condition: Condition::SADDLE_NODE,
                leading: theorem.saddle_node(),
                stability: stability.plus,
            },
            TheoremCurve {
                condition: Condition::PERIOD_DOUBLING,
                leading: theorem.period_doubling(),
                stability: stability.minus,
            },
        ]
    }
}

/// A bifurcation curve of the theorem.
pub(crate) struct TheoremCurve {
    pub(crate) condition: Condition,
    pub(crate) leading: BifurcationCurve,
    /// The coefficient s_p^+ or s_p^-.
    pub(crate) stability: f64,
}

impl Near {
    /// The pair (z − z_graz,η, μ).
    pub(crate) fn relative(&self) -> [f64; 2] {
        [
            self.unknowns[unknown::PHASE] - self.orbit.phase(),
            self.unknowns[unknown::PRIMARY] - self.orbit.primary(),
        ]
    }

    /// The oscillator at the point's parameters.
    pub(crate) fn oscillator(&self) -> Specimen {
        self.orbit
            .oscillator()
            .with_parameters([self.unknowns[unknown::PRIMARY], self.unknowns[unknown::SECONDARY]])
    }

    /// The impact (y, z).
    pub(crate) fn impact(&self) -> Vector2<f64> {
        Vector2::new(self.unknowns[0], self.unknowns[1])
    }
}

/// A range of numbers of loops.
pub(crate) type Loops = RangeInclusive<u32>;
/// One loop.
pub(crate) const ONE: Loops = 1..=1;
/// Two or more loops.
pub(crate) const MANY: Loops = 2..=5;
/// All numbers of loops with resonances in [`everywhere`].
pub(crate) const ANY: Loops = 1..=5;

/// The resonances at which everything is measured: linear, with a variable reset law, and nonlinear.
static PLACES: LazyLock<Result<Vec<ResonantSpecimen>, String>> =
    LazyLock::new(|| places().map_err(|failure| failure.to_string()));

fn places() -> Result<Vec<ResonantSpecimen>, CheckError> {
    let mut sampler = Sampler::new(5);
    let mut found = Vec::new();
    let indices = ANY.flat_map(|loops| (1..=if loops == 1 { 4 } else { 2 }).map(move |n| (loops, n)));
    for (loops, n) in indices {
        // For smaller E_p the leading terms would be smaller than rounding.
        let damping = damping_for_decay(loops, n, sampler.between(0.15, 0.8));
        found.push(ResonantSpecimen::find(Law::linear(damping, sampler.between(0.3, 1.0)), loops, n)?);
        let damping = damping_for_decay(loops, n, sampler.between(0.3, 0.8));
        found.push(ResonantSpecimen::find(Law::varying(damping), loops, n)?);
    }
    for (loops, n) in [(1, 1), (1, 3), (2, 1), (3, 1)] {
        found.push(ResonantSpecimen::find(Law::nonlinear(damping_for_decay(loops, n, 0.5)), loops, n)?);
    }
    Ok(found)
}

/// The tally of measurements at all resonances with these numbers of loops.
pub(crate) fn everywhere<T: Default>(
    which: Loops,
    measure: impl FnMut(&ResonantSpecimen, &mut T) -> Result<(), CheckError>,
) -> Result<T, CheckError> {
    let places = PLACES.as_ref().map_err(String::as_str)?;
    over(places.iter().filter(|place| which.contains(&place.loops())), measure)
}

/// The observed orders of remainders.
pub(crate) type Orders = Result<Vec<Observed>, CheckError>;

/// The orders that a function finds at all resonances with these numbers of loops.
pub(crate) fn all_orders(which: Loops, measure: impl Fn(&ResonantSpecimen) -> Orders) -> Orders {
    everywhere(which, |place, all: &mut Vec<_>| measure(place).map(|orders| all.extend(orders)))
}

/// The orders that a function finds at all resonances, as an outcome.
pub(crate) fn orders(which: Loops, over: &str, measure: impl Fn(&ResonantSpecimen) -> Orders) -> CheckResult {
    Ok(of_orders(&all_orders(which, measure)?, over))
}

/// The outcome of the corrected form, with the orders of the printed one.
pub(crate) fn orders_against_print(
    which: Loops,
    corrected: impl Fn(&ResonantSpecimen) -> Orders,
    printed: impl Fn(&ResonantSpecimen) -> Orders,
) -> CheckResult {
    let printed = lowest(&all_orders(which.clone(), printed)?);
    Ok(orders(which, EVERYWHERE, corrected)?.against_print(printed))
}

/// The description of the samples of [`everywhere`] if they are remainders.
pub(crate) const EVERYWHERE: &str =
    "remainders at resonances with p up to 5 of oscillators with linear and other forces and reset laws";

/// Random directions (y, z, μ, η) in which points approach a resonance, with y of either sign and never
/// small.
pub(crate) fn offsets(count: usize) -> Vec<Offset> {
    let mut sampler = Sampler::new(7);
    let mut one = || {
        let y = sampler.between(0.4, 1.0) * sampler.one_of(&[1.0, -1.0]);
        [y, sampler.between(-1.0, 1.0), sampler.between(-1.0, 1.0), sampler.between(-1.0, 1.0)]
    };
    (0..count).map(|_| one()).collect()
}

/// The direction multiplied by a size.
pub(crate) fn scaled(direction: &Offset, size: f64) -> Offset {
    direction.map(|share| share * size)
}
