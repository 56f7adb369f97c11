//! One-parameter diagrams as lines on the terminal.

use grazing_input::Description;
use grazing_results::branches::{OneParameter, Orbits};
use grazing_results::place::briefly;
use grazing_results::{Names, with_unit};

use super::gaps::few;
use super::{PARAMETER, significant};
use crate::layout::Layout;
use crate::outputs::oscillator::of_one_parameter;

/// A one-parameter diagram: the bifurcations on it, and what simulation leaves out.
pub(crate) fn one_parameter(
    layout: Layout,
    description: &Description,
    units: &Names,
    diagram: &OneParameter,
) -> String {
    let names = [description.primary().name(), description.secondary().name()];
    let [across, _] = diagram.exchanged(names);
    let [unit, _] = diagram.exchanged([description.primary().unit(), description.secondary().unit()]);
    let of = of_one_parameter(names, diagram);
    let mut text =
        format!("\n{}", layout.wrapped("", &format!("One-parameter diagram {}: {of}", diagram.diagram)));
    let rows = diagram.bifurcations.iter().map(|found| {
        let p = if found.impacts > 1 {
            format!("{}/{}", found.impacts, found.loops)
        } else {
            found.loops.to_string()
        };
        let mut row = vec![found.kind.name().to_owned(), p];
        let values = [diagram.across(found), found.impact_velocity, found.x];
        row.extend(values.map(|value| significant(value, PARAMETER)));
        row
    });
    let of_motion = |head, declared| with_unit(head, units.named_unit(declared).as_deref());
    let (velocity, x) = (of_motion("impact velocity", "length/time"), of_motion("x", "length"));
    match diagram.bifurcations.is_empty() {
        true => text.push_str("  no bifurcations\n"),
        false => {
            text.push_str(&layout.aligned(&["kind", "p", &with_unit(across, unit), &velocity, &x], rows))
        }
    }
    let broken = diagram.broken.iter().map(|(numbers, value, reason)| {
        let at = significant(*value, PARAMETER);
        let content = format!("could not be followed beyond {across} = {at}: {reason}");
        (format!("  a branch of {}  ", briefly(*numbers)), content)
    });
    for (mark, content) in few(broken.collect(), "ends of branches", "data/diagram_branches.csv") {
        text.push_str(&layout.wrapped(&mark, &content));
    }
    for left_out in diagram.simulated.iter().flat_map(Orbits::left_out) {
        text.push_str(&layout.wrapped("  left out: ", &left_out));
    }
    text
}
