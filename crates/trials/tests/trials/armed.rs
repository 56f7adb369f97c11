//! Errors behind switches.

use std::path::PathBuf;

use grazing_trials::errors::{DeliberateError, armed};

fn error(find: &str, replace: &str) -> DeliberateError {
    let [find, replace] = [find, replace].map(str::to_owned);
    DeliberateError { meaning: String::new(), file: PathBuf::new(), find, replace }
}

#[test]
fn a_function_has_its_body_once_for_each_error_and_once_as_it_is() {
    let text = "fn a() {}\nfn b(x: f64) -> f64 {\n    // }\n    let brace = \"}\" ; x + 1.0\n}\nconst C: f64 = 2.0;\n";
    let errors = [error("x + 1.0", "x - 1.0"), error("+ 1.0", "+ 2.0"), error("2.0;", "3.0;")];
    let numbered: Vec<(usize, &DeliberateError)> = (1..).zip(&errors).collect();
    let (all, left) = armed(text, &numbered[..2]);
    let body = "\n    // }\n    let brace = \"}\" ; x + 1.0\n";
    let wanted = format!(
        "fn a() {{}}\nfn b(x: f64) -> f64 {{(if crate::deliberate_error(1) {{ {} }} else if \
         crate::deliberate_error(2) {{ {} }} else {{ {body} }})}}\nconst C: f64 = 2.0;\n",
        body.replace("x + 1.0", "x - 1.0"),
        body.replace("+ 1.0", "+ 2.0"),
    );
    assert_eq!((all, left), (wanted, Vec::new()));
    // Outside functions, the expression itself is replaced.
    let both = [(7, &error("2.0", "3.0")), (8, &error("= 2.0", "= 4.0"))];
    let (outside, left) = armed("const C: f64 = 2.0;", &both);
    assert_eq!(outside, "const C: f64 = (if crate::deliberate_error(7) { 3.0 } else { 2.0 });");
    assert_eq!(left, [8]);
}
