//! Detection of the symmetry of an oscillator without its wall.

use core::f64::consts::{PI, TAU};

use grazing_continuation::curve::Window;
use grazing_continuation::mps::{LoopEquations, Symmetry};
use grazing_continuation::regula_falsi::zero_between;
use grazing_model::{AnyOscillator, ImpactOscillator, State};

use super::rest;

/// Displacements to either side of a centre in the search for it, as fractions of its distance from
/// the wall.
const ASIDE: [f64; 2] = [0.0, 0.31];
/// Forces at mirrored places cancel to this fraction of themselves: expressions are exact to
/// rounding.
const CANCELS: f64 = 1e-9;
/// Places of the window at which the symmetry must hold, as fractions of its sides; the first three
/// determine its centre.
const PLACES: [[f64; 2]; 5] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [0.37, 0.61]];
/// A centre that moves by less than this through the window counts as fixed.
const STAYS: f64 = 1e-12;

/// The equations of motion without impacts in a window.
pub fn equations(oscillator: &AnyOscillator, window: Window) -> LoopEquations {
    let equations = LoopEquations::without_impacts(oscillator.clone(), window.widths());
    equations.with_symmetry(symmetry(oscillator, window))
}

/// The symmetry of an oscillator in a window: with x(t), 2c − x(t + T/2) is a motion as well, where c
/// is an affine function of the parameters.
fn symmetry(oscillator: &AnyOscillator, window: Window) -> Option<Symmetry> {
    let places = PLACES.map(|shares| window.parameters(shares));
    let here = oscillator.with_parameters(places[0]);
    rest::all_positions(&here).into_iter().find_map(|near| {
        let nearest = |k: usize| {
            let there = oscillator.with_parameters(places[k]);
            let rests = rest::all_positions(&there).into_iter();
            let rest = rests.min_by(|a, b| (a - near).abs().total_cmp(&(b - near).abs()))?;
            centre(&there, rest)
        };
        let [origin, right, above] = [0, 1, 2].map(nearest);
        let origin = origin?;
        let slopes = [(right?, 0), (above?, 1)].map(|(there, k)| {
            let moves = there - origin;
            if moves.abs() <= STAYS * origin.abs() { 0.0 } else { moves / window.widths()[k] }
        });
        let centre = origin - slopes[0] * places[0][0] - slopes[1] * places[0][1];
        let holds = |[primary, secondary]: [f64; 2]| {
            let there = oscillator.with_parameters([primary, secondary]);
            is_centre(&there, centre + slopes[0] * primary + slopes[1] * secondary)
        };
        places.into_iter().all(holds).then_some(Symmetry { centre, slopes })
    })
}

/// The centre beside a rest position, if there is one: forces at rest half a period apart cancel
/// there or, where the spring is very soft at the centre, on either side of it.
fn centre(oscillator: &AnyOscillator, near: f64) -> Option<f64> {
    let beside = |aside: f64| {
        let both = |position: f64| -> f64 {
            let sides = [(-aside * near, 0.0), (aside * near, PI)];
            let forces =
                sides.map(|(by, phase)| oscillator.acceleration(State::at_rest(position + by, phase)));
            forces.iter().sum()
        };
        let [low, high] = [0.8, 1.2].map(|share| share * near);
        let values = [low, high].map(both);
        let at = |share: f64| {
            let position = low + share * (high - low);
            Ok::<_, core::convert::Infallible>((position, both(position)))
        };
        let Ok(found) = zero_between(values, at, |_, value| value == 0.0);
        (values[0] * values[1] < 0.0 && is_centre(oscillator, found)).then_some(found)
    };
    ASIDE.into_iter().find_map(beside)
}

/// Whether forces at places that mirror each other are opposite.
fn is_centre(oscillator: &AnyOscillator, centre: f64) -> bool {
    const SHARES: [[f64; 3]; 6] = [
        [0.0, 0.0, 0.13],
        [0.31, 0.0, 0.0],
        [0.57, 0.42, 0.29],
        [0.83, -0.71, 0.61],
        [0.12, 0.93, 0.83],
        [0.97, 0.18, 0.47],
    ];
    let frequency = oscillator.forcing_frequency().value;
    SHARES.iter().all(|[distance, speed, phase]| {
        let force = |side: f64, turn: f64| {
            let position = centre * (1.0 + side * distance);
            let velocity = -side * speed * centre * frequency;
            oscillator.acceleration(State { position, velocity, phase: TAU * phase + turn })
        };
        let [one, other] = [force(-1.0, 0.0), force(1.0, PI)];
        (one + other).abs() <= CANCELS * (one.abs() + other.abs() + 1.0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_centre_of_a_symmetric_force_is_found_and_no_other() {
        let cases = [
            ("-0.1*v - x - 1", Some(-1.0)),
            ("-0.1*v - (x + 1) - 2*(x + 1)^3", Some(-1.0)),
            // Two wells: the hill between them.
            ("(x + 2) - (x + 2)^3", Some(-2.0)),
            ("-0.1*v^3 - sin(x + 0.4)", Some(-0.4)),
            ("-0.1*v - (x + 1) - 0.3*(x + 1)^2", None),
            ("-0.1*v^2 - (x + 1)", None),
        ];
        let window = Window { primary: [0.1, 1.0], secondary: [0.5, 1.5] };
        for (force, expected) in cases {
            let found = symmetry(&crate::specimens::unforced(force).oscillator([0.1, 0.5]), window);
            let centre = found.map(|found| found.centre);
            let same = match (centre, expected) {
                (Some(centre), Some(expected)) => (centre - expected).abs() < 1e-12,
                (found, expected) => found == expected,
            };
            assert!(same, "{force}: {found:?}");
            assert!(found.is_none_or(|found| found.slopes == [0.0, 0.0]), "{force}: {found:?}");
        }
    }

    #[test]
    fn a_centre_that_moves_with_the_parameters_is_followed_if_it_does_so_evenly() {
        let window = Window { primary: [0.1, 1.0], secondary: [0.5, 1.5] };
        let of = |force: &str| symmetry(&crate::specimens::unforced(force).oscillator([0.1, 0.5]), window);
        let found = of("-0.1*v - (x + 1 + 0.4*mu - 0.2*eta)^3").expect("it is symmetric");
        let errors = [found.centre + 1.0, found.slopes[0] + 0.4, found.slopes[1] - 0.2];
        assert!(errors.iter().all(|error| error.abs() < 1e-9), "{found:?}");
        assert_eq!(of("-0.1*v - (x + 1 + mu*eta)"), None);
    }
}
