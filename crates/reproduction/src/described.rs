//! Oscillators from text files, prepared for an analysis.

use grazing_continuation::curve::Window;
use grazing_description::{Axis, Description};
use grazing_model::AnyOscillator;
use grazing_model::smooth::{Stop, Units};
use grazing_unfold::Scope;

/// An oscillator that ends when an end is asked for, in these units, and what its file asks for.
pub fn prepared(description: &Description, units: &Units, stop: &Stop) -> (AnyOscillator, Scope) {
    let [primary, secondary] = [description.primary(), description.secondary()].map(Axis::range);
    let scope = Scope {
        window: Window { primary, secondary },
        loops: description.loops().to_vec(),
        start: description.start(),
    };
    let scope = scope.without_dimensions(units);
    let at = [scope.window.primary[0], scope.window.secondary[0]];
    (description.counted(at, units, stop), scope)
}
