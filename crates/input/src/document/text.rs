//! The text of a file, with settings.

use super::setting::Setting;

/// The text of a file with the settings that replace some of its values.
#[derive(Debug, Clone)]
pub struct Text {
    /// The file's text, followed by a line for each setting.
    pub(crate) whole: String,
    /// The position at which the file's text ends.
    pub(crate) end: usize,
    /// The settings, with their positions in the whole text.
    pub(crate) settings: Vec<(usize, Setting)>,
}

impl Text {
    /// The text of a file, with settings; later ones override earlier ones.
    pub fn new(text: &str, settings: &[Setting]) -> Text {
        let mut whole = text.to_owned();
        let mut placed = Vec::new();
        for setting in settings {
            whole.push('\n');
            placed.push((whole.len(), setting.clone()));
            whole.push_str(&setting.to_string());
        }
        Text { whole, end: text.len(), settings: placed }
    }
}
