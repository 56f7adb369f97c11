//! Units in which an oscillator's motion is of the order of one.
//!
//! Tolerances, first guesses and step lengths are chosen for such motion. Any [`SmoothOscillator`]
//! is brought into this form by a change of variables, [`Dimensionless`]. Its [`Units`] follow from
//! the force alone: length and time are those of the balance between what pushes the oscillator
//! away from the wall and what holds it, be that a spring or inertia. They are powers of four, so
//! that nothing is rounded on the way there and back, and motion that is of the order of one
//! already keeps its numbers.

use core::f64::consts::TAU;

use super::oscillator::SmoothOscillator;
use super::partials::Partials;
use crate::scalar::Scalar;
use crate::taylor::Taylor;

/// The oscillator's own units in which one of each dimensionless quantity is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units {
    /// The unit of positions.
    pub length: f64,
    /// The unit of time.
    pub time: f64,
    /// The unit of the primary parameter μ.
    pub primary: f64,
    /// The unit of the secondary parameter η.
    pub secondary: f64,
}

/// Number of instants of a forcing period at which the force is evaluated.
const INSTANTS: u32 = 16;
/// Fractions of both parameter ranges at which the force is evaluated.
const SHARES: [f64; 3] = [0.0, 0.5, 1.0];
/// Relative size below which the mean force at the wall, or the forcing, counts as zero beside the
/// other: it is then a residue of rounding.
const NO_LOAD: f64 = 1e-12;
/// Units lie between 4⁻⁶⁰ and 4⁶⁰: products of a few of them do not overflow.
const MOST: f64 = 60.0;
/// Where the force changes with a parameter at less than this fraction of the greatest rate on the way of
/// motion, as it does at rest with a parameter that multiplies x, that rate counts.
const AT_REST: f64 = 0.1;
/// Number of halvings in the search for the length, from that at which inertia balances the load
/// down to 2⁻¹²⁰ of it.
const DOUBLINGS: i32 = 120;
/// Number of bisections after which the length is known to a thousandth, far better than units are
/// rounded.
const BISECTIONS: u32 = 10;

impl Units {
    /// The units of motion that is of the order of one already.
    pub const ONE: Self = Self { length: 1.0, time: 1.0, primary: 1.0, secondary: 1.0 };

    /// Units for an oscillator in ranges of μ and η.
    ///
    /// Each unit is the median over nine places. The load is the mean force at the wall, or, where
    /// that does not point away from the wall, the amplitude of the forcing if there is one. The
    /// length is the shortest over which the mean force changes by the load, or inertia at the
    /// forcing frequency balances it; the square of the time is length over load. A unit of a
    /// parameter changes the force by the load at that length, or at the wall or as far
    /// beyond if it hardly changes it there, or the frequency by one.
    pub fn of<M: SmoothOscillator>(model: &M, ranges: [[f64; 2]; 2]) -> Self {
        let at = |[low, high]: [f64; 2], share: f64| low * (1.0 - share) + high * share;
        let places = SHARES.into_iter().flat_map(|m| SHARES.map(|e| [at(ranges[0], m), at(ranges[1], e)]));
        let sizes: Vec<[f64; 4]> = places.filter_map(|place| sizes(model, place)).collect();
        let unit = |index: usize, otherwise: f64| {
            let mut values: Vec<f64> = sizes.iter().map(|sizes| sizes[index]).collect();
            values.sort_by(f64::total_cmp);
            let median = values.get(values.len() / 2).copied().unwrap_or(otherwise);
            power_of_four(if median.is_finite() { median } else { otherwise })
        };
        let greatest = |[low, high]: [f64; 2]| low.abs().max(high.abs());
        Self {
            length: unit(0, 1.0),
            time: unit(1, 1.0),
            primary: unit(2, greatest(ranges[0])),
            secondary: unit(3, greatest(ranges[1])),
        }
    }

    /// The unit of velocities.
    pub fn velocity(&self) -> f64 {
        self.length / self.time
    }

    /// The unit of accelerations, and of the force per mass.
    pub fn acceleration(&self) -> f64 {
        self.velocity() / self.time
    }

    /// Parameters (μ, η) in the oscillator's own units.
    pub fn parameters(&self, [primary, secondary]: [f64; 2]) -> [f64; 2] {
        [primary * self.primary, secondary * self.secondary]
    }

    /// Nondimensional parameters from those in the oscillator's own units.
    pub fn without_dimensions(&self, [primary, secondary]: [f64; 2]) -> [f64; 2] {
        [primary / self.primary, secondary / self.secondary]
    }
}

/// The power of four next to a positive number.
fn power_of_four(value: f64) -> f64 {
    let exponent = libm::round(0.5 * libm::log2(value));
    // NaN, as from zero, counts as one.
    if exponent.is_nan() { 1.0 } else { libm::ldexp(1.0, 2 * exponent.clamp(-MOST, MOST) as i32) }
}

/// Length, time, and the changes in μ and in η that change the force by the load or the frequency
/// by its unit (infinite if there are none); `None` at a place without load or frequency.
fn sizes<M: SmoothOscillator>(model: &M, [mu, eta]: [f64; 2]) -> Option<[f64; 4]> {
    let frequency = model.forcing_frequency(mu, eta).abs();
    let instants = move || (0..INSTANTS).map(|k| TAU * f64::from(k) / f64::from(INSTANTS));
    // The part that depends on time alone is computed once for all positions.
    let mut forces: Vec<_> =
        instants().map(|phase| model.force_at::<f64, f64>(phase / frequency, mu, eta)).collect();
    let mut at = |x: f64| -> Vec<f64> { forces.iter_mut().map(|force| force(x, 0.0)).collect() };
    let mean = |forces: &[f64]| forces.iter().sum::<f64>() / f64::from(INSTANTS);
    let there = at(0.0);
    let at_wall = mean(&there);
    let swing = there.iter().map(|force| (force - at_wall).abs()).fold(0.0, f64::max);
    let load = if at_wall < -NO_LOAD * swing || swing < NO_LOAD * at_wall { at_wall.abs() } else { swing };
    if !(load > 0.0 && load.is_finite() && frequency > 0.0 && frequency.is_finite()) {
        return None;
    }
    // A force that is NaN counts as holding.
    let mut held = |length: f64| {
        let change = (mean(&at(-length)) - at_wall).abs();
        change.is_nan() || change >= load
    };
    let inertial = load / (frequency * frequency);
    let mut lengths = (-DOUBLINGS..0).map(|k| libm::ldexp(inertial, k));
    // If the force is NaN right beside the wall, no length can be determined.
    if lengths.next().is_some_and(&mut held) {
        return None;
    }
    let mut length = lengths.find(|length| held(*length)).unwrap_or(inertial);
    let mut shorter = 0.5_f64;
    for _ in 0..BISECTIONS {
        shorter = shorter.sqrt();
        if held(length * shorter) {
            length *= shorter;
        }
    }
    let time = (length / load).sqrt();
    let velocity = length / time;
    let unit = |[mu, eta]: [Taylor; 2]| {
        let frequency = model.forcing_frequency(mu, eta);
        let rate = |x: f64| {
            let [x, y] = [x, velocity].map(Taylor::constant);
            let force = |phase| model.force(x, y, Taylor::constant(phase) / frequency, mu, eta);
            let rates = instants().map(|phase| (force(phase).coefficients()[1] / load).abs());
            rates.fold((frequency.coefficients()[1] * time).abs(), f64::max)
        };
        let at_rest = rate(-length);
        let moving = rate(0.0).max(rate(-2.0 * length));
        1.0 / if at_rest < AT_REST * moving { moving } else { at_rest }
    };
    let [still, moving] =
        [[mu, eta].map(Taylor::constant), [mu, eta].map(|value| Taylor::new([value, 1.0, 0.0, 0.0]))];
    Some([length, time, unit([moving[0], still[1]]), unit([still[0], moving[1]])])
}

/// A [`SmoothOscillator`] whose positions, times and parameters are measured in [`Units`].
#[derive(Clone, Debug)]
pub struct Dimensionless<M> {
    model: M,
    units: Units,
    /// Whether the units are all one, so that no conversion is needed.
    plain: bool,
}

impl<M> Dimensionless<M> {
    /// The oscillator, measured in these units.
    pub fn new(model: M, units: Units) -> Self {
        Self { model, units, plain: units == Units::ONE }
    }

    /// The oscillator in its own units.
    pub fn model(&self) -> &M {
        &self.model
    }

    fn own<S: Scalar>(&self, [mu, eta]: [S; 2]) -> [S; 2] {
        if self.plain { [mu, eta] } else { [mu.scale(self.units.primary), eta.scale(self.units.secondary)] }
    }

    fn velocity<S: Scalar>(&self, y: S) -> S {
        if self.plain { y } else { y.scale(self.units.velocity()) }
    }
}

impl<M: SmoothOscillator> SmoothOscillator for Dimensionless<M> {
    #[inline]
    fn force<S: Scalar>(&self, x: S, y: S, t: S, mu: S, eta: S) -> S {
        if self.plain {
            return self.model.force(x, y, t, mu, eta);
        }
        let [mu, eta] = self.own([mu, eta]);
        let Units { length, time, .. } = self.units;
        let force = self.model.force(x.scale(length), self.velocity(y), t.scale(time), mu, eta);
        force.scale(1.0 / self.units.acceleration())
    }

    #[inline]
    fn force_at<T: Scalar, S: Scalar + From<T>>(&self, t: T, mu: T, eta: T) -> impl FnMut(S, S) -> S {
        let [mu, eta] = self.own([mu, eta]);
        let t = if self.plain { t } else { t.scale(self.units.time) };
        let mut force = self.model.force_at(t, mu, eta);
        let (plain, units) = (self.plain, self.units);
        let [velocity, acceleration] = [units.velocity(), units.acceleration()];
        move |x, y| {
            if plain {
                force(x, y)
            } else {
                force(x.scale(units.length), y.scale(velocity)).scale(1.0 / acceleration)
            }
        }
    }

    #[inline]
    fn slopes_at<S: Scalar>(&self, t: S, mu: S, eta: S) -> Option<impl FnMut(S, S, bool) -> [S; 3]> {
        let [mu, eta] = self.own([mu, eta]);
        let t = if self.plain { t } else { t.scale(self.units.time) };
        let mut force = self.model.slopes_at(t, mu, eta)?;
        let (plain, Units { length, time, .. }) = (self.plain, self.units);
        let [velocity, acceleration] = [self.units.velocity(), self.units.acceleration()];
        Some(move |x: S, y: S, slopes| {
            if plain {
                return force(x, y, slopes);
            }
            let [value, by_position, by_velocity] = force(x.scale(length), y.scale(velocity), slopes);
            [value.scale(1.0 / acceleration), by_position.scale(time * time), by_velocity.scale(time)]
        })
    }

    #[inline]
    fn partials<S: Scalar>(&self, arguments: &[S; 5], second: bool, partials: &mut Partials<S>) -> bool {
        if self.plain {
            return self.model.partials(arguments, second, partials);
        }
        let Units { length, time, primary, secondary } = self.units;
        let units = [length, self.units.velocity(), time, primary, secondary];
        let own = core::array::from_fn(|a| arguments[a].scale(units[a]));
        let known = self.model.partials(&own, second, partials);
        if known {
            partials.convert(units, self.units.acceleration());
        }
        known
    }

    fn forcing_frequency<S: Scalar>(&self, mu: S, eta: S) -> S {
        let [mu, eta] = self.own([mu, eta]);
        let frequency = self.model.forcing_frequency(mu, eta);
        if self.plain { frequency } else { frequency.scale(self.units.time) }
    }

    fn restitution<S: Scalar>(&self, y: S, z: S, mu: S, eta: S) -> S {
        let [mu, eta] = self.own([mu, eta]);
        self.model.restitution(self.velocity(y), z, mu, eta)
    }

    fn impact_duration<S: Scalar>(&self, y: S, z: S, mu: S, eta: S) -> S {
        let [mu, eta] = self.own([mu, eta]);
        self.velocity(self.model.impact_duration(self.velocity(y), z, mu, eta))
    }

    fn harmonics(&self) -> Option<u32> {
        self.model.harmonics()
    }

    fn other_stop(&self) -> Option<Self> {
        Some(Self { model: self.model.other_stop()?, ..self.clone() })
    }

    fn gap<S: Scalar>(&self, t: S, mu: S, eta: S) -> [S; 2] {
        let [mu, eta] = self.own([mu, eta]);
        let [gap, rate] = self.model.gap(t.scale(self.units.time), mu, eta);
        [gap.scale(1.0 / self.units.length), rate.scale(1.0 / self.units.velocity())]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Function;

    /// ẍ = −g − k x − c x³ + μ cos ηt.
    #[derive(Clone)]
    struct Spring {
        preload: f64,
        stiffness: f64,
        cubic: f64,
    }

    impl SmoothOscillator for Spring {
        fn force<S: Scalar>(&self, x: S, _: S, t: S, mu: S, eta: S) -> S {
            let held = x.scale(self.stiffness) + x.power(3).scale(self.cubic) + S::constant(self.preload);
            mu * (eta * t).apply(Function::Cos) - held
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

    fn units([preload, stiffness, cubic]: [f64; 3], ranges: [[f64; 2]; 2]) -> [f64; 4] {
        let Units { length, time, primary, secondary } =
            Units::of(&Spring { preload, stiffness, cubic }, ranges);
        [length, time, primary, secondary]
    }

    /// Rounding to powers of four moves a unit by a factor of two at most.
    fn assert_near(found: [f64; 4], expected: [f64; 4]) {
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((0.5..=2.0).contains(&(found / expected)), "{found} and not about {expected}");
        }
    }

    #[test]
    fn motion_of_the_order_of_one_keeps_its_numbers() {
        assert_eq!(units([1.0, 1.0, 0.1], [[0.0, 1.5], [0.4, 1.1]]), [1.0; 4]);
    }

    #[test]
    fn a_spring_sets_length_and_time() {
        // A gap of a millimetre, 300 radians a second.
        let found = units([90.0, 9e4, 0.0], [[0.0, 100.0], [100.0, 250.0]]);
        assert_near(found, [1e-3, 1.0 / 300.0, 90.0, 300.0]);
        // The range of the forcing does not matter.
        let found = units([90.0, 9e4, 0.0], [[0.0, 1e9], [100.0, 250.0]]);
        assert_near(found, [1e-3, 1.0 / 300.0, 90.0, 300.0]);
        // c x³ = g at x = 0.1.
        let found = units([1e3, 0.0, 1e6], [[0.0, 1e3], [5.0, 50.0]]);
        assert_near(found, [0.1, 0.01, 1e3, 100.0]);
    }

    #[test]
    fn without_a_spring_inertia_sets_the_length() {
        let found = units([1e4, 0.0, 0.0], [[0.0, 1e4], [90.0, 110.0]]);
        assert_near(found, [1.0, 0.01, 1e4, 100.0]);
    }

    #[test]
    fn at_rest_at_the_wall_the_forcing_is_the_load() {
        let found = units([0.0, 1e4, 0.0], [[0.0, 200.0], [10.0, 50.0]]);
        assert_near(found, [0.015, 0.01, 150.0, 100.0]);
    }

    /// ẍ = −(1 + μ cos 2t)(x + 1) + 1/4 cos t.
    #[derive(Clone)]
    struct Parametric;

    impl SmoothOscillator for Parametric {
        fn force<S: Scalar>(&self, x: S, _: S, t: S, mu: S, _: S) -> S {
            let stiffness = S::constant(1.0) + mu * t.scale(2.0).apply(Function::Cos);
            t.apply(Function::Cos).scale(0.25) - stiffness * (x + S::constant(1.0))
        }

        fn forcing_frequency<S: Scalar>(&self, _: S, _: S) -> S {
            S::constant(1.0)
        }

        fn restitution<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
            S::constant(1.0)
        }

        fn impact_duration<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
            S::constant(0.0)
        }
    }

    #[test]
    fn a_parameter_that_multiplies_x_has_its_unit_from_where_motion_goes() {
        // At rest the force does not depend on it.
        let units = Units::of(&Parametric, [[0.0, 1.2], [0.0, 1.0]]);
        assert_eq!((units.length, units.primary), (1.0, 1.0));
    }

    #[test]
    fn where_nothing_is_known_the_ranges_are_the_units() {
        assert_eq!(units([f64::NAN; 3], [[-16.0, 4.0], [0.0, 64.0]]), [1.0, 1.0, 16.0, 64.0]);
    }
}
