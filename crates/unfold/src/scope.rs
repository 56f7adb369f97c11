//! The scope of an analysis.

use grazing_continuation::curve::Window;
use grazing_model::{AnyOscillator, ImpactOscillator};
use grazing_results::{Dimension, Dimensioned};
use grazing_theorems::from_map::GrazingOrbit;
use nalgebra::Vector3;

/// The part of the parameter plane that is analysed, and the solutions that are looked for.
#[derive(Clone, Debug, PartialEq)]
pub struct Scope {
    /// The ranges of the primary parameter μ and the secondary parameter η.
    pub window: Window,
    /// The numbers of loops p, each at least 1.
    pub loops: Vec<u32>,
    /// A state (x, y) at phase zero from which the non-impacting motion is looked for, in addition
    /// to the usual ones.
    pub start: Option<[f64; 2]>,
}

impl Dimensioned for Scope {
    fn each_number(&mut self, visit: &mut dyn FnMut(Dimension, &mut f64)) {
        self.window.each_number(visit);
        if let Some([x, y]) = &mut self.start {
            visit(Dimension::of("length"), x);
            visit(Dimension::of("length/time"), y);
        }
    }
}

impl Scope {
    /// The oscillator at fractions of the ranges of μ and η.
    pub(crate) fn oscillator_at(&self, oscillator: &AnyOscillator, shares: [f64; 2]) -> AnyOscillator {
        oscillator.with_parameters(self.window.parameters(shares))
    }

    /// Phase and fractions of the ranges of a grazing orbit, the variables in which grazing curves
    /// are followed.
    pub(crate) fn place(&self, orbit: &GrazingOrbit) -> Vector3<f64> {
        let [primary, secondary] = self.window.shares(orbit.oscillator().parameters());
        Vector3::new(orbit.phase(), primary, secondary)
    }
}
