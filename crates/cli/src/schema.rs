//! `grazing schema`: JSON schemas of the files that people write, for editors.

use grazing_beyond::parameters;
use grazing_input::Description;

use crate::arguments::{SchemaArguments, Written};
use crate::terminal;

/// Prints the schema of a kind of file.
pub(crate) fn run(arguments: &SchemaArguments) {
    let schema = match arguments.of {
        Written::Oscillator => Description::requirements().schema("An impact oscillator"),
        Written::Parameters => parameters::requirements().schema("Parameters of the figures of the paper"),
    };
    terminal::say_coloured(&format!("{:#}\n", serde_json::json!(schema)));
}
