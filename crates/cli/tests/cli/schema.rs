//! `schema` prints what editors need to complete and check the files that people write.

#[path = "../../../input/tests/input/schema/validator.rs"]
mod validator;

use grazing_input::Description;
use toml::Table;

use crate::bad_input::EDITS;
use crate::program::{INVENTED, edited, empty_folder, grazing};
use validator::refusal;

/// Edits that are refused for their meaning: the order of two numbers, and one key beside another.
const OF_MEANING: &[&str] = &[
    "amplitude = [0.4, 0.2]",
    "amplitude = [0.2, 0.2]",
    "amplitude = [0, 9]",
    // With so many orbits at so many amplitudes.
    "transient = 1000000",
    "loops = 7",
    "frequency = [0.4, 4]",
];

fn printed(arguments: &[&str]) -> Table {
    let outcome = grazing(empty_folder().path(), arguments);
    assert_eq!((outcome.code, &*outcome.messages), (Some(0), ""), "{arguments:?}");
    serde_json::from_str(&outcome.output).expect("it is JSON")
}

#[test]
fn schemas_are_those_of_the_keys_that_are_read() {
    let schema = printed(&["schema"]);
    let title = schema["title"].as_str().expect("it is text");
    assert_eq!(schema, Description::requirements().schema(title));
    assert_eq!(schema, printed(&["schema", "--of", "oscillator"]));
    let force = &schema["properties"]["motion"]["properties"]["force"];
    assert!(
        force["description"]
            .as_str()
            .is_some_and(|text| text
                .starts_with("The force F per mass.\n\nThe force must be an expression in x, v, t")),
        "{force}"
    );
    let generations = &schema["properties"]["analysis"]["properties"]["generations"];
    assert_eq!(
        ["minimum", "maximum", "default"].map(|key| generations[key].as_integer()),
        [1, 3, 1].map(Some)
    );
}

#[test]
fn bad_parameter_files_are_refused_by_the_schema_as_well() {
    let schema = printed(&["schema", "--of", "parameters"]);
    let fits = |text: &str| text.parse::<Table>().is_ok_and(|file| refusal(&schema, &file.into()).is_none());
    assert!(fits(INVENTED));
    let of_meaning = EDITS.iter().filter(|(section, key, line)| fits(&edited(INVENTED, section, key, line)));
    assert_eq!(of_meaning.map(|(_, _, line)| *line).collect::<Vec<_>>(), OF_MEANING);
}
