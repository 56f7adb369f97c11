//! The top of the page: what it is about, and how everything came out.

use crate::html::{counted, escape, put};
use crate::oscillator::Tally;
use crate::{OscillatorEntry, Report, State, figure, prose};

/// The title of the page.
pub(crate) fn title(report: &Report) -> &str {
    match report.oscillators.as_slice() {
        _ if report.is_of_the_paper() => "Resonant grazing bifurcations, reproduced",
        [oscillator] => &oscillator.name,
        _ => "Resonant grazing bifurcations",
    }
}

pub(crate) fn section(report: &Report) -> String {
    if report.is_of_the_paper() { of_the_paper(report) } else { of_oscillators(report) }
}

/// The top of a page about oscillators alone.
fn of_oscillators(report: &Report) -> String {
    let mut html = format!(
        "<section id=\"summary\" aria-labelledby=\"title\">\n<p class=\"eyebrow\">Report</p>\n<h1 id=\"title\">{}</h1>\n\
         <p class=\"lead\">Resonant grazing bifurcations, as in D. J. W. Simpson and I. Ghosh, \
         <cite>Resonant grazing bifurcations revisited</cite> \
         (<a href=\"https://arxiv.org/abs/2602.22797\" rel=\"noreferrer\">arXiv 2602.22797</a>).</p>\n<ul class=\"cards\">\n",
        escape(title(report)),
    );
    let tallies: Vec<_> = report.oscillators.iter().map(OscillatorEntry::tally).collect();
    let sum = |count: fn(&Tally) -> usize| tallies.iter().map(count).sum::<usize>();
    let (all, agreeing) = (sum(|tally| tally.all), sum(|tally| tally.agreeing));
    let (predicted, contradicted) = (sum(|tally| tally.predicted), sum(|tally| tally.contradicted));
    let found: usize = report.oscillators.iter().map(|oscillator| oscillator.resonances.len()).sum();
    let what = if found == 1 { "resonant grazing bifurcation" } else { "resonant grazing bifurcations" };
    card(&mut html, "#oscillators", "neutral", &found.to_string(), what);
    if all > 0 {
        let tone = |good: usize, bad: usize| match bad {
            0 if good == all => "passed",
            0 => "neutral",
            _ => "failed",
        };
        for (good, bad, words) in [
            (agreeing, sum(|tally| tally.differing), "coefficients measured as by the theorem"),
            (predicted, contradicted, "simulations as predicted"),
        ] {
            card(&mut html, "#oscillators", tone(good, bad), &format!("{good} of {all}"), words);
        }
    }
    html.push_str("</ul>\n<nav class=\"contents\" aria-label=\"Figures\"><ul>\n");
    html.push_str(&contents_of_oscillators(report));
    html.push_str("</ul></nav>\n</section>\n");
    html
}

/// Lines of the table of contents.
fn contents_of_oscillators(report: &Report) -> String {
    let mut html = String::new();
    for oscillator in &report.oscillators {
        let anchor = oscillator.anchor();
        put!(html, "<li><a href=\"#{}\">{}</a></li>\n", escape(&anchor), escape(&oscillator.name));
        // The figures of many oscillators would be too long a list.
        if report.oscillators.len() == 1 {
            for figure in &oscillator.figures {
                let target = format!("{anchor}-{}", figure.name);
                let title = prose(&figure::capitalised(&figure.title));
                put!(html, "<li><a href=\"#{}\">{title}</a></li>\n", escape(&target));
            }
        }
    }
    html
}

fn of_the_paper(report: &Report) -> String {
    let met = report.published.iter().filter(|entry| entry.met).count();
    let all = report.published.len();
    let count = |state| report.claims.iter().filter(|claim| claim.verdict.state() == state).count();
    let (passed, failed, unchecked) = (count(State::Passed), count(State::Failed), count(State::Unchecked));
    let misprints = report.claims.iter().filter(|claim| claim.misprint.is_some()).count();
    let good = met == all && failed == 0 && report.missing.is_empty();
    let verdict = if good {
        "Everything that was tested came out."
    } else if !report.missing.is_empty() {
        "Not everything could be made:"
    } else {
        "Not everything came out: see what is marked as off or failed."
    };
    let mut html = format!(
        "<section id=\"summary\" aria-labelledby=\"title\">\n<p class=\"eyebrow\">Report</p>\n\
         <h1 id=\"title\">Resonant grazing bifurcations, reproduced</h1>\n\
         <p class=\"lead\">What D. J. W. Simpson and I. Ghosh state and show in <cite>Resonant grazing bifurcations revisited</cite> \
         (<a href=\"https://arxiv.org/abs/2602.22797\" rel=\"noreferrer\">arXiv 2602.22797</a>), computed again from the equations: \
         figures with the values behind them, every claim with the computation that tests it, and the files that came out.</p>\n\
         <p class=\"judgement {}\"><strong>{verdict}</strong></p>\n",
        if good { "passed" } else { "failed" },
    );
    if !report.missing.is_empty() {
        let items = report.missing.iter().map(|reason| format!("<li>{}</li>\n", escape(reason)));
        put!(html, "<ul class=\"reasons\">\n{}</ul>\n", items.collect::<String>());
    }
    html.push_str("<ul class=\"cards\">\n");
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
        if misprints == 1 { "misprint" } else { "misprints" },
    );
    let files = report.manifest.outputs.len();
    card(&mut html, "#manifest", "neutral", &files.to_string(), "output files with their SHA-256");
    let others = report.oscillators.len();
    if others > 0 {
        let what = if others == 1 { "other oscillator" } else { "other oscillators" };
        card(&mut html, "#oscillators", "neutral", &others.to_string(), &format!("{what}, from text files"));
    }
    html.push_str("</ul>\n<nav class=\"contents\" aria-label=\"Figures and tables\"><ul>\n");
    for (name, title) in report
        .figures
        .iter()
        .map(|figure| (&figure.name, &figure.title))
        .chain(report.tables.iter().map(|table| (&table.name, &table.title)))
    {
        put!(html, "<li><a href=\"#{}\">{}</a></li>\n", escape(name), prose(title));
    }
    html.push_str(&contents_of_oscillators(report));
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
