//! Attractors at the places that were asked for, as lines on the terminal.

use grazing_results::place::{AtPlace, PlaceAttractor};
use grazing_results::{Names, brief, with_unit};

use crate::layout::Layout;
use crate::unfold::numbers::heads;

/// Digits of parameters, and of exponents.
const DIGITS: usize = 6;
const EXPONENT: usize = 3;

/// The attractors of all places, and the places at which they were not found in time; nothing without
/// places.
pub(crate) fn listing(layout: Layout, places: &[AtPlace], unfinished: &[[f64; 2]], names: &Names) -> String {
    let at = |at: [f64; 2]| {
        let [mu, eta] = at.map(|value| brief(value, DIGITS));
        format!("  at {} = {mu}, {} = {eta}: ", names.primary, names.secondary)
    };
    let missing: String = unfinished
        .iter()
        .map(|place| layout.wrapped(&at(*place), "motion at this place was not finished"))
        .collect();
    if places.is_empty() {
        return if missing.is_empty() { missing } else { format!("\nAttractors\n{missing}") };
    }
    let row = |one: &PlaceAttractor| {
        let exponent = if one.exponent.is_finite() { brief(one.exponent, EXPONENT) } else { "-".to_owned() };
        vec![
            brief(one.primary, DIGITS),
            brief(one.secondary, DIGITS),
            one.words().replace('$', ""),
            format!("{:.0} %", 100.0 * one.share),
            exponent,
        ]
    };
    let [primary, secondary] = heads(names);
    let exponent = with_unit("Lyapunov exponent", names.named_unit("1/time").as_deref());
    let heads = [&*primary, &secondary, "attractor", "share of random states", &exponent];
    let rows: Vec<_> = places.iter().flat_map(|place| &place.attractors).map(row).collect();
    let mut text = "\nAttractors\n".to_owned();
    text.push_str(&if rows.is_empty() {
        "  none\n".to_owned()
    } else {
        layout.aligned(&heads, rows.into_iter())
    });
    for place in places {
        if place.attractors.iter().any(|one| one.rests > 0.0 && one.periods > 0.0) {
            let words = "motion that rests at the wall forgets its state: its multipliers are 0";
            text.push_str(&layout.wrapped(&at(place.at), words));
        }
        for one in place.neutral() {
            let words = format!("{} is neutral: nearby motion neither approaches nor leaves it", one.words());
            text.push_str(&layout.wrapped(&at(place.at), &words));
        }
        if place.undecided() > 0 {
            let counts = format!("{} of {}", place.undecided(), place.basins.len());
            let words = format!("{counts} states of the basins have not settled in time");
            text.push_str(&layout.wrapped(&at(place.at), &words));
        }
    }
    text + &missing
}

#[cfg(test)]
mod tests {
    use grazing_results::Stability;
    use grazing_results::place::PlaceSolution;

    use super::*;

    #[test]
    fn a_neutral_solution_is_named_though_no_attractor_shows_it() {
        let solution = |loops: u32, stable, admissible| PlaceSolution {
            place: 1,
            loops,
            impacts: loops.min(1),
            wall: 0,
            impact_velocity: 0.25,
            impact_phase: 0.0,
            trace: 0.5,
            determinant: 1.0,
            stable,
            admissible,
        };
        let neutral = Stability::Neutral;
        let place = AtPlace {
            attractors: Vec::new(),
            solutions: vec![
                solution(0, neutral, true),
                solution(1, neutral, true),
                solution(2, neutral, false),
                solution(3, true.into(), true),
            ],
            motion: Vec::new(),
            impacts: Vec::new(),
            basins: Vec::new(),
            place: 1,
            at: [0.5, 1.25],
            states: 24,
            period: 1.0,
            from_the_wall: false,
            lattice: [0, 0],
        };
        let text = listing(Layout::new(200), &[place], &[], &Names::new("A", "w"));
        let lines: Vec<&str> = text.lines().filter(|line| line.contains("neutral")).collect();
        assert_eq!(lines.len(), 2, "{text}");
        assert!(lines[0].contains("motion without impacts is neutral"), "{text}");
        assert!(lines[1].contains("the MPS with p = 1 and impact velocity 0.25 is neutral"), "{text}");
    }
}
