//! The JSON schema of the parameter file accepts the default file, and refuses nothing that is read.

#[path = "../../../../input/tests/input/schema/validator.rs"]
mod validator;
#[path = "../../../../input/tests/input/schema/variants.rs"]
mod variants;

use grazing_beyond::{all_figures, parameters};
use grazing_input::{SourceError, Text};
use grazing_reproduction::StudyFigure;
use grazing_reproduction::parameters::{ParameterError, Parameters};
use toml::Table;

use super::{DEFAULT, source};
use validator::refusal;
use variants::variants;

type Read = fn(&Parameters) -> Result<(), ParameterError>;

fn section<F: StudyFigure>() -> (&'static str, Read) {
    (F::NAME, |parameters| parameters.section::<F>().map(drop))
}

#[test]
fn what_the_schema_refuses_is_not_read() {
    let schema = parameters::requirements().schema("Parameters");
    let default: Table = DEFAULT.parse().expect("it is TOML");
    assert_eq!(refusal(&schema, &default.clone().into()), None);
    let oscillator: Read = |parameters| parameters.oscillator().map(drop);
    let mut refused = 0;
    for (name, read) in all_figures!(section, first("oscillator", oscillator)) {
        let [schema, table] =
            [&schema["properties"][name], &default[name]].map(|of| of.as_table().expect("it is a table"));
        for (path, variant) in variants(table) {
            let Some(reason) = refusal(schema, &variant.clone().into()) else { continue };
            // The section alone, whose own keys are read first.
            let text = toml::to_string(&Table::from_iter([(name.to_owned(), variant.into())]))
                .expect("it is a table");
            let parameters =
                parameters::parse(&Text::new(&text, &[]), "p.toml").expect("there is no other section");
            let error = read(&parameters).expect_err(&format!("{name}.{path}: {reason}"));
            match source(&error) {
                SourceError::UnknownKey { key, .. }
                | SourceError::MissingKey { key, .. }
                | SourceError::Forbidden { key, .. } => {
                    assert!(key.starts_with(name), "{name}.{path}: {reason}: {key}")
                }
                other => panic!("{name}.{path}: {reason}: {other}"),
            }
            refused += 1;
        }
    }
    assert!(refused > 1000, "{refused}");
}
