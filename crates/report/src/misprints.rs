//! Where print and mathematics differ.

use crate::formula::prose;
use crate::html::{escape, identifier, put};
use crate::{Report, Verdict};

pub(crate) fn section(report: &Report) -> String {
    let mut html = String::from(
        "<section id=\"misprints\" aria-labelledby=\"misprints-title\">\n<h2 id=\"misprints-title\">Misprints</h2>\n",
    );
    let mut found = false;
    for claim in &report.claims {
        let Some(misprint) = &claim.misprint else {
            continue;
        };
        if !found {
            html.push_str(
                "<p class=\"lead\">Each is decided by a computation that the corrected form passes and the printed form fails.</p>\n",
            );
            found = true;
        }
        put!(
            html,
            "<article class=\"misprint\" id=\"{}\">\n<h3><a href=\"#{}\"><code>{}</code></a> <span class=\"place\">{}</span></h3>\n\
             <dl>\n<dt>Printed</dt><dd class=\"printed\">{}</dd>\n<dt>Corrected</dt><dd class=\"corrected\">{}</dd>\n\
             <dt>Why</dt><dd>{}</dd>\n<dt>Decided by</dt><dd>{}",
            escape(&identifier("misprint", &claim.label)),
            escape(&identifier("claim", &claim.label)),
            escape(&claim.label),
            escape(&claim.place),
            prose(&misprint.printed),
            prose(&misprint.corrected),
            prose(&misprint.reason),
            prose(&misprint.decided),
        );
        if let Verdict::Checked { measured, print: Some(print), samples, over, .. } = &claim.verdict {
            put!(
                html,
                "<br><span class=\"samples\">Corrected: {}. Printed: {}. {samples} {}.</span>",
                measured.html(),
                print.html(),
                prose(over)
            );
        }
        html.push_str("</dd>\n</dl>\n</article>\n");
    }
    if !found {
        html.push_str("<p>None are listed in the ledger.</p>\n");
    }
    html.push_str("</section>\n");
    html
}
