//! Text files whose wording stands in `templates/`.

/// The text of a template, which leaves out the end of its last line.
///
/// # Panics
/// Never: writing to a string cannot fail.
pub(crate) fn rendered(template: &impl askama::Template) -> String {
    template.render().expect("writing to a string cannot fail") + "\n"
}
