//! The permitted contents of the parameter file, and the messages for other contents.

mod file;
mod schema;
mod together;
mod values;

use grazing_beyond::{all_figures, parameters};
use grazing_input::{Setting, SourceError, Text};
use grazing_reproduction::StudyFigure;
use grazing_reproduction::parameters::{ParameterError, Parameters};

const DEFAULT: &str = include_str!("../../../../../figures/parameters.toml");

/// The parameters, or the first error in any section.
fn parse(text: &str) -> Result<Parameters, SourceError> {
    let told = |error: ParameterError| source(&error).clone();
    let parameters = parameters::parse(&Text::new(text, &[]), "p.toml").map_err(told)?;
    match errors(&parameters).into_iter().next() {
        Some(error) => Err(told(error)),
        None => Ok(parameters),
    }
}

/// The underlying error, of either kind.
fn source(error: &ParameterError) -> &SourceError {
    let (ParameterError::Malformed(error) | ParameterError::Unfit(error)) = error;
    error
}

/// The errors in the sections, in their order.
fn errors(parameters: &Parameters) -> Vec<ParameterError> {
    fn check<F: StudyFigure>() -> fn(&Parameters) -> Result<(), ParameterError> {
        |parameters| parameters.section::<F>().map(drop)
    }
    let sections = all_figures!(check, first |parameters: &Parameters| parameters.oscillator().map(drop));
    sections.into_iter().filter_map(|check| check(parameters).err()).collect()
}

/// The default parameters with settings.
fn set(settings: &[&str]) -> Result<Parameters, ParameterError> {
    let settings: Vec<Setting> = settings.iter().map(|text| text.parse().expect("it is a setting")).collect();
    parameters::parse(&Text::new(DEFAULT, &settings), "p.toml")
}

/// The default file in which the first line for the key after `section` is replaced. The current values
/// do not matter, so the file can change without its tests.
fn edited(section: &str, key: &str, line: &str) -> String {
    let section_start = DEFAULT.find(section).expect("the section stands in the file");
    let start =
        1 + section_start + DEFAULT[section_start..].find(&format!("\n{key} = ")).expect("the key follows");
    let end = start + DEFAULT[start..].find('\n').expect("the file ends with a line end");
    format!("{}{line}{}", &DEFAULT[..start], &DEFAULT[end..])
}

/// The line number of the first `needle` after `section` in the text.
fn line_of(text: &str, section: &str, needle: &str) -> usize {
    let start = text.find(section).expect("the section stands in the text");
    let at = start + text[start..].find(needle).expect("the needle follows");
    1 + text[..at].matches('\n').count()
}

/// Asserts that the value, written for the key after `section`, is rejected under the full key, on its
/// line, and that the message quotes `culprit`; returns the stated requirement.
fn refusal_quoting(culprit: &str, section: &str, key: &str, value: &str, full_key: &str) -> String {
    let line = format!("{key} = {value}");
    let text = edited(section, key, &line);
    match parse(&text) {
        Err(SourceError::Forbidden { file, line: number, key, value, allowed }) => {
            assert_eq!((file.as_str(), key.as_str(), value.as_str()), ("p.toml", full_key, culprit));
            assert_eq!(number, line_of(&text, section, &line), "the line of {line}");
            allowed
        }
        other => panic!("{section} {line}: {other:?}"),
    }
}

/// Like [`refusal_quoting`], with the whole value quoted.
fn refusal(section: &str, key: &str, value: &str, full_key: &str) -> String {
    refusal_quoting(value, section, key, value, full_key)
}

/// The keys that are rejected with settings.
fn refused(settings: &[&str]) -> Vec<String> {
    let key = |error: &ParameterError| match source(error) {
        SourceError::Forbidden { key, .. } => key.clone(),
        other => other.to_string(),
    };
    match set(settings) {
        Ok(parameters) => errors(&parameters).iter().map(key).collect(),
        Err(error) => vec![key(&error)],
    }
}
