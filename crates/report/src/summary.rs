//! The top of the page: what it is about, and how everything came out.

use crate::html::{counted, escape, put};
use crate::{Report, State, prose};

pub(crate) fn section(report: &Report) -> String {
    let met = report.published.iter().filter(|entry| entry.met).count();
    let all = report.published.len();
    let count = |state| report.claims.iter().filter(|claim| claim.verdict.state() == state).count();
    let (passed, failed, unchecked) = (count(State::Passed), count(State::Failed), count(State::Unchecked));
    let misprints = report.claims.iter().filter(|claim| claim.misprint.is_some()).count();
    let good = met == all && failed == 0;
    let verdict = if good {
        "Everything that was tested came out."
    } else {
        "Not everything came out: see what is marked as off or failed."
    };
    let mut html = format!(
        "<section id=\"summary\" aria-labelledby=\"title\">\n<p class=\"eyebrow\">Report</p>\n\
         <h1 id=\"title\">Resonant grazing bifurcations, reproduced</h1>\n\
         <p class=\"lead\">What D. J. W. Simpson and I. Ghosh state and show in <cite>Resonant grazing bifurcations revisited</cite> \
         (<a href=\"https://arxiv.org/abs/2602.22797\" rel=\"noreferrer\">arXiv 2602.22797</a>), computed again from the equations: \
         figures with the values behind them, every claim with the computation that tests it, and the files that came out.</p>\n\
         <p class=\"judgement {}\"><strong>{verdict}</strong></p>\n<ul class=\"cards\">\n",
        if good { "passed" } else { "failed" },
    );
    let tone = |good: bool| if good { "passed" } else { "failed" };
    card(&mut html, "#published", tone(met == all), &format!("{met} of {all}"), "published values met");
    let tested = passed + failed;
    card(
        &mut html,
        "#claims",
        tone(failed == 0),
        &format!("{passed} of {tested}"),
        &match unchecked {
            0 => "tested claims hold".to_owned(),
            _ => format!("tested claims hold; {unchecked} not tested, with the reason"),
        },
    );
    card(
        &mut html,
        "#misprints",
        "neutral",
        &misprints.to_string(),
        if misprints == 1 { "misprint, decided by computation" } else { "misprints, decided by computation" },
    );
    let files = report.manifest.outputs.len();
    card(&mut html, "#manifest", "neutral", &files.to_string(), "output files with their SHA-256");
    html.push_str("</ul>\n<nav class=\"contents\" aria-label=\"Figures and tables\"><ul>\n");
    for (name, title) in report
        .figures
        .iter()
        .map(|figure| (&figure.name, &figure.title))
        .chain(report.tables.iter().map(|table| (&table.name, &table.title)))
    {
        put!(html, "<li><a href=\"#{}\">{}</a></li>\n", escape(name), prose(title));
    }
    put!(
        html,
        "</ul></nav>\n<p class=\"made\">{}, {}, {}.</p>\n</section>\n",
        counted(report.figures.len(), "figure", "figures"),
        counted(report.tables.len(), "table", "tables"),
        counted(report.claims.len(), "claim", "claims"),
    );
    html
}

fn card(html: &mut String, target: &str, tone: &str, figure: &str, words: &str) {
    put!(
        html,
        "<li><a class=\"card {tone}\" href=\"{target}\"><b>{figure}</b> <span>{words}</span></a></li>\n"
    );
}
