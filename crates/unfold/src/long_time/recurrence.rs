//! Whether the impacts of an orbit come again.

use crate::tolerances::BETWEEN_ORBITS;
use core::f64::consts::TAU;

use nalgebra::Vector2;

/// Motion whose impacts come again to within this may be about to settle.
const NEARLY: f64 = 0.1;
/// An orbit whose impacts do not come again after so many counts as not periodic.
const LONGEST_CYCLE: usize = 24;

/// Whether the impacts (y, z) of an orbit come again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Recurrence {
    /// The same ones come again and again, after so many.
    Cycle(usize),
    /// Nearly the same ones do, as where motion comes slowly to a cycle, or leaves one.
    Drift,
    /// They do not, as far as the orbit was followed, or there are too few to say.
    None,
}

impl Recurrence {
    /// Of impacts (y, z) in the order of time.
    pub fn of(impacts: &[Vector2<f64>]) -> Self {
        let cycles = 1..=LONGEST_CYCLE.min(impacts.len() / 2);
        let again = |cycle: usize| {
            impacts.iter().enumerate().all(|(k, a)| same_impact(BETWEEN_ORBITS, a, &impacts[k % cycle]))
        };
        if let Some(cycle) = cycles.clone().find(|cycle| again(*cycle)) {
            return Self::Cycle(cycle);
        }
        let nearly =
            |cycle: usize| impacts.iter().zip(&impacts[cycle..]).all(|(a, b)| same_impact(NEARLY, a, b));
        if cycles.clone().any(nearly) { Self::Drift } else { Self::None }
    }
}

/// Whether two impacts (y, z) are no farther apart than this, in y counted in y where that is above
/// one.
pub fn same_impact(distance: f64, a: &Vector2<f64>, b: &Vector2<f64>) -> bool {
    (a[0] - b[0]).abs() <= distance * a[0].max(1.0) && libm::remainder(a[1] - b[1], TAU).abs() <= distance
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Impacts whose velocities alternate and come nearer to their limits by a factor.
    fn settling(factor: f64, from: f64) -> Vec<Vector2<f64>> {
        let impact =
            |k: i32| Vector2::new(1.0 + 0.2 * f64::from(k % 2) + from * libm::pow(factor, k.into()), 2.0);
        (0..40).map(impact).collect()
    }

    #[test]
    fn impacts_that_come_slowly_to_a_cycle_drift_until_they_have_come_to_it() {
        // Each is within the distance of the one two before, but not of the first.
        let slow = settling(0.99, 0.02);
        assert!(slow.windows(3).all(|three| same_impact(BETWEEN_ORBITS, &three[0], &three[2])));
        assert_eq!(Recurrence::of(&slow), Recurrence::Drift);
        assert_eq!(Recurrence::of(&settling(0.99, 1e-4)), Recurrence::Cycle(2));
        // What wanders about neither drifts nor comes again.
        let wandering: Vec<_> =
            (0..40).map(|k| Vector2::new(1.0 + 0.5 * libm::sin(f64::from(k * k)), 2.0)).collect();
        assert_eq!(Recurrence::of(&wandering), Recurrence::None);
    }
}
