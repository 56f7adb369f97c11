//! Oscillators from text files, prepared for an analysis.

use core::f64::consts::TAU;

use grazing_continuation::curve::Window;
use grazing_description::{Axis, Description, OwnCurve, Property as Written};
use grazing_model::AnyOscillator;
use grazing_model::smooth::{Stop, Units};
use grazing_unfold::Scope;
use grazing_unfold::levels::{Level, Property};

/// The curves that a file asks for, without dimensions.
pub fn levels(description: &Description, units: &Units) -> Vec<Level> {
    let level = |OwnCurve { name, loops, property }: &OwnCurve| {
        let property = match *property {
            Written::ImpactVelocity(velocity) => Property::ImpactVelocity(velocity / units.velocity()),
            Written::Modulus(modulus) => Property::Modulus(modulus),
            Written::Distance { distance, phase } => {
                Property::Distance { phase: TAU * phase, distance: distance / units.length }
            }
        };
        Level { name: name.clone(), loops: loops.clone(), property }
    };
    description.curves().iter().map(level).collect()
}

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
