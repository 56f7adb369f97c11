//! Checks at samples of the ranges: the assumptions of the theorems about F, ω, Φ and Ψ, and that
//! the wall moves with the forcing.
//!
//! A sample proves nothing, but a wrong sign, a pole in the range or a forgotten factor shows at
//! almost every point.

use std::f64::consts::TAU;

use grazing_model::smooth::{SmoothOscillator, Stop, Units};

use crate::description::{Description, Expressions};
use crate::error::{DescriptionError, KeyPlace, Note, rounded};

/// Number of points along the range of either parameter, both ends included.
const ALONG: u32 = 7;
/// Positions and velocities at which the force is sampled, in the oscillator's [`Units`];
/// empirical. At the wall and close to it, from `-NEAR` on, it must be finite; far from it a force
/// may have its poles.
const POSITIONS: [f64; 4] = [-1.0, -0.37, -0.01, 0.0];
const NEAR: f64 = 0.01;
const VELOCITIES: [f64; 3] = [-0.83, 0.0, 0.61];
/// Positions between which a spring would show.
const AWAY: [f64; 5] = [-30.0, -4.0, -1.0, -0.37, 0.0];
/// Impact velocities, also in [`Units`], at which the reset law is sampled: the theorems are about
/// slow impacts.
const IMPACT_VELOCITIES: [f64; 5] = [0.0, 0.01, 0.1, 0.5, 1.0];
/// Ratio of the natural frequency to the forcing frequencies, or its inverse, beyond which the
/// description is probably a mistake: resonances of low order lie nearer; empirical.
const FAR: f64 = 15.0;
/// Phases, as fractions of the period, that are not related by any symmetry.
const SHARES: [f64; 5] = [0.0, 0.137, 0.361, 0.592, 0.823];
/// Number of phases at which two walls must not meet.
const PHASES: u32 = 64;
/// The relative change over one period that rounding may cause: the phase's error, a few units in
/// the last place, is magnified by the derivative with respect to it, which is far below 1e6 for
/// any forcing whose period could be resolved.
const ROUNDING: f64 = 1e-9;

type Checked = Result<(), DescriptionError>;

/// Checks frequency, force and reset law at samples, in the order of the file, until the
/// computation is cancelled; returns notes on values that are allowed but perhaps not intended.
pub(crate) fn samples(description: &Description, stop: &Stop) -> Result<Vec<Note>, DescriptionError> {
    let parameters = description.sampled();
    let seen: Vec<Description> = description.from_each_wall().collect();
    for check in PlaceChecks::CHECKS {
        for sampler in seen.iter().map(PlaceChecks::new) {
            for &parameters in &parameters {
                if stop.is_asked() {
                    return Err(DescriptionError::Ended);
                }
                check(&sampler, parameters)?;
            }
        }
    }
    let sampler = PlaceChecks::new(description);
    let going = || parameters.iter().take_while(|_| !stop.is_asked());
    let other =
        seen.iter().skip(1).map(PlaceChecks::new).find_map(|other| going().find_map(|&at| other.unusual(at)));
    let notes = [
        going().find_map(|&at| sampler.unusual(at)),
        other,
        sampler.unsprung(going()),
        going().find_map(|&at| sampler.undamped(at)),
        going().find_map(|&at| sampler.in_hertz(at)),
        sampler.far(going()),
    ];
    if stop.is_asked() {
        return Err(DescriptionError::Ended);
    }
    Ok(notes.into_iter().flatten().collect())
}

/// Checks of a description at places of its plane, which need not lie in its ranges.
pub(crate) struct PlaceChecks<'a> {
    description: &'a Description,
    places: &'a Expressions<KeyPlace>,
    units: Units,
}

impl<'a> PlaceChecks<'a> {
    /// All checks, in the order of the file.
    const CHECKS: [fn(&Self, [f64; 2]) -> Checked; 5] =
        [Self::frequency, Self::wall, Self::force, Self::restitution, Self::duration];

    pub(crate) fn new(description: &'a Description) -> Self {
        Self { description, places: &description.seen().places, units: description.units() }
    }

    /// Whether all checks pass at a place.
    pub(crate) fn passes(&self, parameters: [f64; 2]) -> bool {
        Self::CHECKS.iter().all(|check| check(self, parameters).is_ok())
    }

    fn impact_velocities(&self) -> [f64; 5] {
        IMPACT_VELOCITIES.map(|y| y * self.units.velocity())
    }

    /// The parameters and further variables as text, by name.
    fn point(&self, [mu, eta]: [f64; 2], variables: &[(&str, f64)]) -> String {
        let axes = [(self.description.primary().name(), mu), (self.description.secondary().name(), eta)];
        let values =
            axes.iter().chain(variables).map(|(name, value)| format!("{name} = {}", rounded(*value)));
        values.collect::<Vec<_>>().join(", ")
    }

    fn frequency(&self, [mu, eta]: [f64; 2]) -> Checked {
        let place = &self.places.frequency;
        let value = self.description.forcing_frequency(mu, eta);
        let at = self.point([mu, eta], &[]);
        if !value.is_finite() {
            return Err(not_finite(place, value, &at));
        }
        if value <= 0.0 {
            let value = rounded(value);
            let problem = format!(
                "the frequency is {value} at {at}: it must be positive over the ranges of both parameters"
            );
            return Err(wrong(place, problem));
        }
        Ok(())
    }

    fn wall(&self, [mu, eta]: [f64; 2]) -> Checked {
        let place = &self.places.wall;
        let period = TAU / self.description.forcing_frequency(mu, eta);
        for t in SHARES.map(|share| share * period) {
            let position = |t| self.description.wall().outside([0.0, 0.0], t, [mu, eta])[0];
            let at = || self.point([mu, eta], &[("t", t)]);
            let values = [position(t), position(t + period)];
            finite_and_periodic(place, values, self.units.length, ("t", period), at)?;
        }
        for t in (0..PHASES).map(|k| period * f64::from(k) / f64::from(PHASES)) {
            let [gap, _] = self.description.gap(t, mu, eta);
            if gap.is_nan() || gap <= 0.0 {
                let at = self.point([mu, eta], &[("t", t)]);
                let problem = format!(
                    "the walls meet: at {at} the one that has the motion below it is {} above the other; it must be above it over the \
                     ranges of both parameters, at all times",
                    rounded(gap)
                );
                return Err(wrong(place, problem));
            }
        }
        Ok(())
    }

    fn force(&self, [mu, eta]: [f64; 2]) -> Checked {
        let place = &self.places.force;
        let period = TAU / self.description.forcing_frequency(mu, eta);
        let near = NEAR * self.units.length;
        // The part that depends on time alone is computed once for all positions and velocities.
        let force_at = |t: f64| self.description.force_at::<f64, f64>(t, mu, eta);
        let mut instants =
            SHARES.map(|share| share * period).map(|t| (t, [force_at(t), force_at(t + period)]));
        for x in POSITIONS.map(|x| x * self.units.length) {
            for v in VELOCITIES.map(|v| v * self.units.velocity()) {
                for (t, forces) in &mut instants {
                    let at = || {
                        let [x, v] = self.description.wall().outside([x, v], *t, [mu, eta]);
                        self.point([mu, eta], &[("x", x), ("v", v), ("t", *t)])
                    };
                    let values = forces.each_mut().map(|force| force(x, v));
                    if values[0].is_finite() || x >= -near {
                        let unit = self.units.acceleration();
                        finite_and_periodic(place, values, unit, ("t", period), at)?;
                    }
                }
            }
        }
        Ok(())
    }

    fn restitution(&self, [mu, eta]: [f64; 2]) -> Checked {
        let restitution = |y, z| self.description.restitution(y, z, mu, eta);
        self.reset(&self.places.restitution, 1.0, [mu, eta], restitution, |value| {
            (value < 0.0).then_some("it must not be negative, or the rebound goes through the wall")
        })
    }

    /// A note if the restitution exceeds one, or is zero.
    fn unusual(&self, [mu, eta]: [f64; 2]) -> Option<Note> {
        let samples = self.impact_velocities().into_iter().flat_map(|y| SHARES.map(|share| (y, share * TAU)));
        let (y, z, value) = samples
            .map(|(y, z)| (y, z, self.description.restitution(y, z, mu, eta)))
            .find(|(_, _, value)| *value > 1.0 || *value == 0.0)?;
        let at = self.point([mu, eta], &[("y", y), ("z", z)]);
        let so = if value > 1.0 {
            "it is above 1, so impacts drive the oscillator; the analysis uses it as it is"
        } else {
            "impacts are plastic, and motion sticks where the force presses, which simulation alone shows (--at, \
             [[diagrams]]): MPSs are those that leave the wall at once, and the paper's theorems ask for a positive restitution"
        };
        let remark = format!("the restitution is {} at {at}: {so}", rounded(value));
        Some(Note { place: self.places.restitution.clone(), remark })
    }

    /// A note if the force grows with the distance from rest wherever it is tried.
    fn unsprung<'p>(&self, mut parameters: impl Iterator<Item = &'p [f64; 2]> + Clone) -> Option<Note> {
        let slope = |at: [f64; 2], x: f64| self.description.slopes(x * self.units.length, at)[0];
        let least = ROUNDING / (self.units.time * self.units.time);
        let first = *parameters.clone().next()?;
        parameters.all(|&at| AWAY.iter().all(|x| slope(at, *x) > least)).then(|| {
            self.on_force(format!(
                "the force grows with x, by {} x at {}, and wherever else it was tried, so that motion is pushed away \
                 from rest, not back: is the sign of the spring intended?",
                rounded(slope(first, 0.0)),
                self.point(first, &[])
            ))
        })
    }

    /// A note if the force grows with the velocity.
    fn undamped(&self, parameters: [f64; 2]) -> Option<Note> {
        let slope = self.description.slopes(0.0, parameters)[1];
        (slope * self.units.time > ROUNDING).then(|| {
            self.on_force(format!(
                "at the wall the force grows with the velocity, by {} v at {}, so that motion is driven, not damped: is \
                 the sign of the damping intended?",
                rounded(slope),
                self.point(parameters, &[])
            ))
        })
    }

    /// A note if the frequency is a parameter in hertz.
    fn in_hertz(&self, [mu, eta]: [f64; 2]) -> Option<Note> {
        let frequency = self.description.forcing_frequency(mu, eta);
        let axes = [(self.description.primary(), mu), (self.description.secondary(), eta)];
        let (axis, _) =
            axes.into_iter().find(|(axis, value)| axis.unit() == Some("Hz") && *value == frequency)?;
        let name = axis.name();
        let remark = format!(
            "{name} is in Hz, but frequencies are in radians per unit of time here: write 2*pi*{name}, here and in the force"
        );
        Some(Note { place: self.places.frequency.clone(), remark })
    }

    /// A note if the natural frequency, of small motion beside the wall, is far from those of the
    /// forcing.
    fn far<'p>(&self, parameters: impl Iterator<Item = &'p [f64; 2]>) -> Option<Note> {
        let [low, high] = self.description.forcing_frequencies();
        let natural = |&at: &[f64; 2]| self.description.natural_frequency(0.0, at);
        let [slowest, fastest] = extent(parameters.map(natural));
        (slowest > FAR * high || fastest * FAR < low && fastest > 0.0).then(|| {
            self.on_force(format!(
                "free motion at the wall has a natural frequency of about {}, and the forcing has {} to {}, in \
                 radians per unit of time: if this is not intended, check that the units are coherent (kg with N and m) and that no factor 2*pi is missing",
                rounded(slowest.max(fastest)),
                rounded(low),
                rounded(high)
            ))
        })
    }

    fn on_force(&self, remark: String) -> Note {
        Note { place: self.places.force.clone(), remark }
    }

    fn duration(&self, [mu, eta]: [f64; 2]) -> Checked {
        let duration = |y, z| self.description.impact_duration(y, z, mu, eta);
        let unit = 1.0 / self.units.velocity();
        self.reset(&self.places.duration, unit, [mu, eta], duration, |_| None)
    }

    /// Checks a function of the reset law, which is of the order of `unit`: finite, 2π-periodic in
    /// z, and not `refused` for a reason.
    fn reset(
        &self,
        place: &KeyPlace,
        unit: f64,
        parameters: [f64; 2],
        function: impl Fn(f64, f64) -> f64,
        refused: impl Fn(f64) -> Option<&'static str>,
    ) -> Checked {
        for y in self.impact_velocities() {
            for z in SHARES.map(|share| share * TAU) {
                let at = || self.point(parameters, &[("y", y), ("z", z)]);
                let value = function(y, z);
                if let Some(reason) = refused(value).filter(|_| value.is_finite()) {
                    let problem = format!("the restitution is {} at {}: {reason}", rounded(value), at());
                    return Err(wrong(place, problem));
                }
                finite_and_periodic(place, [value, function(y, z + TAU)], unit, ("z", TAU), at)?;
            }
        }
        Ok(())
    }
}

impl Description {
    /// Places of the ranges at which the description is checked.
    fn sampled(&self) -> Vec<[f64; 2]> {
        let along = |[lower, upper]: [f64; 2]| {
            (0..ALONG).map(move |i| {
                let share = f64::from(i) / f64::from(ALONG - 1);
                lower * (1.0 - share) + upper * share
            })
        };
        let primary = self.primary().range();
        along(self.secondary().range()).flat_map(|eta| along(primary).map(move |mu| [mu, eta])).collect()
    }

    /// The lowest and the highest forcing frequency in the ranges, in radians per unit of time.
    pub fn forcing_frequencies(&self) -> [f64; 2] {
        extent(self.sampled().into_iter().map(|[mu, eta]| self.forcing_frequency(mu, eta)))
    }

    /// The mean derivatives of the force in x and in v over a period, at rest at a position seen from the wall.
    pub(crate) fn slopes(&self, position: f64, [mu, eta]: [f64; 2]) -> [f64; 2] {
        let units = self.units();
        let period = TAU / self.forcing_frequency(mu, eta);
        let [by_x, by_v] = [units.length, units.velocity()].map(|unit| NEAR * unit);
        let mut sum = [0.0; 2];
        for t in SHARES.map(|share| share * period) {
            let mut force = self.force_at::<f64, f64>(t, mu, eta);
            sum[0] += (force(position, 0.0) - force(position - by_x, 0.0)) / by_x;
            sum[1] += (force(position, by_v) - force(position, -by_v)) / (2.0 * by_v);
        }
        sum.map(|sum| sum / SHARES.len() as f64)
    }

    /// The natural frequency of small motion about a position seen from the wall, in radians per unit of time;
    /// 0 if the force does not drive back to there.
    pub fn natural_frequency(&self, position: f64, parameters: [f64; 2]) -> f64 {
        (-self.slopes(position, parameters)[0]).max(0.0).sqrt()
    }
}

/// The least and the greatest of some numbers.
fn extent(numbers: impl Iterator<Item = f64>) -> [f64; 2] {
    numbers
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], number| [low.min(number), high.max(number)])
}

fn wrong(place: &KeyPlace, problem: String) -> DescriptionError {
    DescriptionError::Value { place: place.clone(), problem }
}

fn not_finite(place: &KeyPlace, value: f64, at: &str) -> DescriptionError {
    let domain = match place.key.as_str() {
        "motion.force" => {
            "at the wall and close to it where motion takes place, over the ranges of both parameters"
        }
        _ => "over the ranges of both parameters",
    };
    wrong(place, format!("the value is {value} at {at}: it must be a finite number {domain}"))
}

/// Checks a value, which is of the order of `unit`, against the one a period of t or z later.
fn finite_and_periodic(
    place: &KeyPlace,
    [value, after]: [f64; 2],
    unit: f64,
    period: (&str, f64),
    at: impl Fn() -> String,
) -> Checked {
    if !value.is_finite() {
        return Err(not_finite(place, value, &at()));
    }
    if (after - value).abs() > ROUNDING * (unit + value.abs()) {
        return Err(not_periodic(place, after - value, &at(), period));
    }
    Ok(())
}

/// The error of a value that changes over one period of t or z.
fn not_periodic(
    place: &KeyPlace,
    change: f64,
    at: &str,
    (variable, period): (&str, f64),
) -> DescriptionError {
    let entry = match variable {
        "t" => {
            "cos(omega*t) or sin(omega*t), where omega is the frequency of motion.frequency, or with multiples of omega"
        }
        _ => "cos(z) or sin(z), or with multiples of z",
    };
    let (change, period) = (rounded(change), rounded(period));
    let problem = format!(
        "not periodic with the forcing: the value changes by {change} from {at} over one period, to {variable} + {period}; {variable} \
         must enter as {entry}"
    );
    wrong(place, problem)
}
