//! What is asked for.

use grazing_continuation::curve::Window;
use grazing_model::ImpactOscillator;
use grazing_theorems::from_map::GrazingOrbit;
use nalgebra::Vector3;

/// The part of the parameter plane that is looked at, and the solutions that are looked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Scope {
    /// The ranges of the primary parameter μ and the secondary parameter η.
    pub window: Window,
    /// The numbers of loops p, each at least 1.
    pub loops: Vec<u32>,
    /// A state (x, y) at phase zero from which the non-impacting motion is looked for, besides the usual ones.
    pub start: Option<[f64; 2]>,
}

impl Scope {
    /// The oscillator at shares of the ranges of μ and η: 0 at the lower end, 1 at the upper one.
    pub(crate) fn oscillator_at<O: ImpactOscillator>(&self, oscillator: &O, shares: [f64; 2]) -> O {
        oscillator.with_parameters(self.parameters(shares))
    }

    /// The parameters (μ, η) at shares of their ranges.
    pub(crate) fn parameters(&self, shares: [f64; 2]) -> [f64; 2] {
        let at = |[lower, upper]: [f64; 2], share: f64| lower + (upper - lower) * share;
        [at(self.window.primary, shares[0]), at(self.window.secondary, shares[1])]
    }

    /// The shares of their ranges at which parameters (μ, η) lie.
    pub(crate) fn shares(&self, [primary, secondary]: [f64; 2]) -> [f64; 2] {
        let share = |[lower, upper]: [f64; 2], value: f64| (value - lower) / (upper - lower);
        [share(self.window.primary, primary), share(self.window.secondary, secondary)]
    }

    /// Phase and shares of the ranges of a grazing orbit, the variables in which grazing curves are followed.
    pub(crate) fn place<O: ImpactOscillator>(&self, orbit: &GrazingOrbit<O>) -> Vector3<f64> {
        let [primary, secondary] = self.shares(orbit.oscillator().parameters());
        Vector3::new(orbit.phase(), primary, secondary)
    }

    /// The widths of the ranges of μ and η.
    pub(crate) fn widths(&self) -> [f64; 2] {
        let width = |[lower, upper]: [f64; 2]| upper - lower;
        [width(self.window.primary), width(self.window.secondary)]
    }
}
