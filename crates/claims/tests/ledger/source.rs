//! The lines of source that define items.

use grazing_claims::source::Sources;

/// Whether the line of a file defines the item.
fn defines(line: &str, name: &str) -> bool {
    let files = [("crates/model/src/lib.rs".to_owned(), line.to_owned())];
    let found = Sources::new(files).item(&format!("grazing_model::{name}"));
    assert!(found.as_ref().is_none_or(|found| found.line == 1), "{found:?}");
    found.is_some()
}

#[test]
fn calls_comments_and_longer_names_define_nothing() {
    assert!(defines("    pub const fn order(self) -> f64 {", "order"));
    assert!(defines("    pub label: String,", "label"));
    assert!(defines("    Order {", "Order"));
    for line in
        ["order(x);", "// fn order", "fn order_of(x: f64)", "label::new()", "let label = 1;", "Orders,"]
    {
        assert!(!["order", "label", "Order"].iter().any(|name| defines(line, name)), "{line}");
    }
}
