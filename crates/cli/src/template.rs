//! Text files whose wording is in `templates/`.

/// The text of a template, with the end of the last line that the template leaves out.
///
/// # Panics
/// Never: writing to a string cannot fail.
pub(crate) fn rendered(template: &impl askama::Template) -> String {
    template.render().expect("writing to a string cannot fail") + "\n"
}
