//! Motion without impacts of a symmetric oscillator.

use grazing_model::MapJet;

use super::Unknowns;
use crate::unknowns::parameters;

/// A symmetry of an oscillator without its wall: with x(t), 2c − x(t + T/2) is a motion as well.
///
/// Motion that is its own image recurs, mirrored, after half a forcing period: it is a fixed point
/// of the map H over half a period followed by the mirror. The flow over the whole period is H²,
/// and its multipliers are squares. Where a multiplier of H is −1 that of the flow is 1: a
/// pitchfork, at which two motions begin that are each other's images.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Symmetry {
    /// The centre c where both parameters vanish.
    pub centre: f64,
    /// The slopes of the centre in μ and η.
    pub slopes: [f64; 2],
}

impl Symmetry {
    /// The mirror image (2c − x, −ẋ) of a map to (x, ẋ), at the parameters of a point.
    pub(super) fn mirrored<A, B>(&self, map: MapJet<A, B>, at: &Unknowns) -> MapJet<A, B> {
        let mut mirrored = map;
        mirrored.value.neg_mut();
        mirrored.jacobian.neg_mut();
        mirrored.hessians.iter_mut().for_each(|hessian| hessian.neg_mut());
        let [primary, secondary] = parameters(at);
        let [by_primary, by_secondary] = self.slopes;
        mirrored.value[0] += 2.0 * (self.centre + by_primary * primary + by_secondary * secondary);
        mirrored.jacobian[(0, 2)] += 2.0 * by_primary;
        mirrored.jacobian[(0, 3)] += 2.0 * by_secondary;
        mirrored
    }
}
