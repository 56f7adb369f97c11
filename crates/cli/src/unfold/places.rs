//! Attractors at the places that were asked for, as lines on the terminal.

use grazing_results::place::{AtPlace, PlaceAttractor};
use grazing_results::{Names, brief};

use crate::layout::Layout;
use crate::unfold::numbers::{heads, with_unit};

/// Digits of parameters, and of exponents.
const DIGITS: usize = 6;
const EXPONENT: usize = 3;

/// The attractors of all places; nothing without places.
pub(crate) fn listing(layout: Layout, places: &[AtPlace], names: &Names) -> String {
    if places.is_empty() {
        return String::new();
    }
    let row = |one: &PlaceAttractor| {
        let exponent = if one.exponent.is_nan() { "-".to_owned() } else { brief(one.exponent, EXPONENT) };
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
    let rows = places.iter().flat_map(|place| &place.attractors).map(row);
    format!("\nAttractors\n{}", layout.aligned(&heads, rows))
}
