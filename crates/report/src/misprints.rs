//! Where print and mathematics differ.

use crate::formula::prose;
use crate::html::{escape, identifier, put};
use crate::{Report, Verdict};

pub(crate) fn section(report: &Report) -> String {
    let mut html = String::from(
        "<section id=\"misprints\" aria-labelledby=\"misprints-title\">\n<h2 id=\"misprints-title\">Misprints</h2>\n",
    );
    let of_kind = |typographic: bool| {
        let listed = report.claims.iter().filter_map(|claim| Some((claim, claim.misprint.as_ref()?)));
        listed.filter(move |(_, misprint)| misprint.typographic == typographic)
    };
    let found = of_kind(false).chain(of_kind(true)).count() > 0;
    if found {
        html.push_str(
            "<p class=\"lead\">First those that a computation decides: the corrected form passes it and the printed form fails. \
             Then those of notation and wording.</p>\n",
        );
    }
    for (claim, misprint) in of_kind(false).chain(of_kind(true)) {
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
