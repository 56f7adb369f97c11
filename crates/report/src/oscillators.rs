//! Oscillators from text files, as the page shows them.

use crate::formula::{shown, words};
use crate::html::{counted, escape, number, put};
use crate::oscillator::{CoefficientEntry, Finding, Judgement, OscillatorEntry, ResonanceEntry};
use crate::{Report, columns, figure, table};

/// Significant digits of coefficients and of parameters.
const COEFFICIENT: usize = 9;
const PARAMETER: usize = 7;
const VALUE: usize = 4;

/// The heading of the section.
pub(crate) fn title(report: &Report) -> &'static str {
    match (report.is_of_the_paper(), report.oscillators.len()) {
        (true, _) => "Other oscillators",
        (false, 1) => "The oscillator",
        (false, _) => "Oscillators",
    }
}

pub(crate) fn section(report: &Report) -> String {
    let mut html = format!(
        "<section id=\"oscillators\" aria-labelledby=\"oscillators-title\">\n<h2 id=\"oscillators-title\">{}</h2>\n\
         <p class=\"lead\">{} that a text file describes: its grazing curve, the resonant grazing \
         bifurcations on it with the coefficients that Theorems 2.4 (<i>p</i> = 1) and 2.5 (<i>p</i> ≥ 2) give, the curves of \
         bifurcations that are continued from there, and simulation beside them.</p>\n",
        title(report),
        if report.is_of_the_paper() { "The same analysis of any oscillator" } else { "An oscillator" },
    );
    html.push_str(figure::USE);
    if report.oscillators.len() > 1 {
        html.push_str(&overview(report));
    }
    for entry in &report.oscillators {
        html.push_str(&one(entry));
    }
    html.push_str("</section>\n");
    html
}

/// All oscillators in a table, with links.
fn overview(report: &Report) -> String {
    let mut html = String::from(
        "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"All oscillators\">\n<table class=\"sortable overview\"><thead><tr>\
         <th scope=\"col\">Oscillator</th><th scope=\"col\" class=\"number\">Resonances</th><th scope=\"col\">Verdict</th></tr></thead>\n<tbody>\n",
    );
    for entry in &report.oscillators {
        put!(
            html,
            "<tr><th scope=\"row\"><a href=\"#{}\">{}</a></th><td class=\"number\">{}</td><td>{}</td></tr>\n",
            escape(&entry.anchor()),
            escape(&entry.name),
            entry.resonances.len(),
            verdicts(entry),
        );
    }
    html.push_str("</tbody></table>\n</div>\n");
    html
}

/// The verdicts on agreement and simulation, where a theorem applies, and how much is lost.
fn verdicts(entry: &OscillatorEntry) -> String {
    let tally = entry.tally();
    let mut told = match tally.all {
        0 => vec![("unchecked", "no theorem applies".to_owned())],
        _ => vec![tally.agreement(), tally.simulation()],
    };
    if !entry.lost.is_empty() {
        told.push(("misprint", format!("{} not unfolded", entry.lost.len())));
    }
    if !entry.undecided.is_empty() {
        told.push(("misprint", counted(entry.undecided.len(), "region undecided", "regions undecided")));
    }
    let told = told.iter().map(|(tone, words)| format!("<span class=\"verdict {tone}\">{words}</span>"));
    told.collect::<Vec<_>>().join(" ")
}

fn one(entry: &OscillatorEntry) -> String {
    let anchor = escape(&entry.anchor());
    let file = format!("<code>{}</code>", escape(&entry.file));
    let file = match &entry.link {
        Some(link) => format!("<a href=\"{}\">{file}</a>", escape(link)),
        None => file,
    };
    let mut html = format!(
        "<section class=\"oscillator\" id=\"{anchor}\" aria-labelledby=\"{anchor}-title\">\n<h3 id=\"{anchor}-title\">{}</h3>\n\
         <p class=\"links\"><span>From</span> {file}</p>\n<p class=\"judgements\">{}</p>\n",
        escape(&entry.name),
        verdicts(entry),
    );
    for paragraph in &entry.about {
        put!(html, "<p class=\"about\">{}</p>\n", words(paragraph));
    }
    html.push_str(&definition(entry));
    html.push_str(&coefficients(entry));
    html.push_str(&without_curves(entry));
    for drawn in &entry.figures {
        html.push_str(&figure::of_oscillator(entry, drawn));
    }
    if !entry.tables.is_empty() {
        put!(html, "<h4>Tables</h4>\n");
    }
    for listed in &entry.tables {
        html.push_str(&table::of_oscillator(entry, listed));
    }
    html.push_str("</section>\n");
    html
}

/// Equation of motion and reset law, constants and ranges.
fn definition(entry: &OscillatorEntry) -> String {
    let code = |text: &str| format!("<code>{}</code>", escape(text));
    let formula = |latex: &str| shown(latex, false);
    let constants: Vec<String> = entry
        .constants
        .iter()
        .map(|(name, value)| format!("{} = {}", columns::symbol(name), plain(*value)))
        .collect();
    let range = |(name, [low, high]): &(String, [f64; 2])| {
        format!("{} from {} to {}", columns::symbol(name), plain(*low), plain(*high))
    };
    let loops: Vec<String> = entry.loops.iter().map(u32::to_string).collect();
    let rows = [
        (
            "Motion",
            format!(
                "{} for {}, where {}<br>{} = {}",
                formula(r"\ddot{x} = F(x, v, t)"),
                formula("x < 0"),
                formula(r"v = \dot{x}"),
                formula("F"),
                code(&entry.force)
            ),
        ),
        ("Forcing frequency", format!("{} = {}", formula(r"\omega"), code(&entry.frequency))),
        (
            "Impact at the wall",
            format!(
                "{} at {}, with velocity {} and phase {}<br>{} = {}, {} = {}",
                formula(r"y \mapsto -y \Phi(y, z), \; z \mapsto z + y \Psi(y, z)"),
                formula("x = 0"),
                formula("y"),
                formula("z"),
                formula(r"\Phi"),
                code(&entry.restitution),
                formula(r"\Psi"),
                code(&entry.duration),
            ),
        ),
        ("Constants", if constants.is_empty() { "none".to_owned() } else { constants.join(", ") }),
        ("Primary parameter", range(&entry.primary)),
        ("Secondary parameter", range(&entry.secondary)),
        ("Loops", format!("<i>p</i> = {}", loops.join(", "))),
    ];
    let mut html = String::from("<dl class=\"definition\">\n");
    for (term, content) in rows {
        put!(html, "<dt>{term}</dt><dd>{content}</dd>\n");
    }
    html.push_str("</dl>\n");
    html
}

/// A number from the file, with the digits it has there.
fn plain(value: f64) -> String {
    value.to_string().replace('-', "−")
}

/// Resonances at which a theorem applies, two rows each.
fn coefficients(entry: &OscillatorEntry) -> String {
    let found: Vec<&ResonanceEntry> =
        entry.resonances.iter().filter(|resonance| !resonance.coefficients().is_empty()).collect();
    let mut html = String::from("<h4>Theorem, curves and simulation</h4>\n");
    if found.is_empty() {
        html.push_str(
            "<p>There is no resonant grazing bifurcation in the ranges at which a theorem applies.</p>\n",
        );
        return html;
    }
    let (primary, secondary) = (columns::symbol(&entry.primary.0), columns::symbol(&entry.secondary.0));
    put!(
        html,
        "<p class=\"lead\">{} {} Near each the curves are {primary} = {primary}<sub>graz</sub>({secondary}) + <i>c</i> <i>η</i><sup>2</sup> + …, \
         where <i>η</i> is {secondary} less its value there: <i>c</i> by the theorem, and measured on the continued curve.</p>\n",
        counted(found.len(), "resonant grazing bifurcation", "resonant grazing bifurcations"),
        if found.len() == 1 { "is unfolded." } else { "are unfolded." },
    );
    put!(
        html,
        "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Coefficients of {0}\">\n<table class=\"sortable data\"><thead><tr>\
         <th scope=\"col\" class=\"number\"><i>p</i></th><th scope=\"col\" class=\"number\"><i>n</i></th>\
         <th scope=\"col\" class=\"number\">{secondary}</th><th scope=\"col\" class=\"number\">{primary}</th><th scope=\"col\">Curve</th>\
         <th scope=\"col\" class=\"number\"><i>c</i> by theorem</th><th scope=\"col\" class=\"number\"><i>c</i> measured</th>\
         <th scope=\"col\" class=\"number\">Digits agreeing</th><th scope=\"col\">Simulation</th></tr></thead>\n<tbody>\n",
        escape(&entry.name),
    );
    for resonance in found {
        for (curve, coefficient) in ["SN", "PD"].into_iter().zip(resonance.coefficients()) {
            html.push_str(&row(resonance, curve, coefficient));
        }
    }
    html.push_str("</tbody></table>\n</div>\n");
    html
}

fn row(resonance: &ResonanceEntry, curve: &str, coefficient: &CoefficientEntry) -> String {
    let cell = |value: f64, digits| {
        format!("<td class=\"number\" data-value=\"{value:e}\">{}</td>", number(value, digits))
    };
    let (tone, _) = judged(&coefficient.agreement);
    let (measured, digits) = match coefficient.measured {
        Some((value, digits)) => {
            let told = format!(
                "<td class=\"number\" data-value=\"{digits}\"><span class=\"verdict {tone}\">{digits}</span></td>"
            );
            (cell(value, COEFFICIENT), told)
        }
        None => (
            format!("<td class=\"number\"><span class=\"verdict {tone}\">not measurable</span></td>"),
            "<td class=\"number\"></td>".to_owned(),
        ),
    };
    let (tone, simulated) = judged(&coefficient.simulation);
    format!(
        "<tr><td class=\"number\">{}</td><td class=\"number\">{}</td>{}{}<td>{curve}</td>{}{measured}{digits}\
         <td><span class=\"verdict {tone}\">{simulated}</span></td></tr>\n",
        resonance.loops,
        resonance.n,
        cell(resonance.secondary, PARAMETER),
        cell(resonance.primary, PARAMETER),
        cell(coefficient.theorem, COEFFICIENT),
    )
}

/// The class of a verdict's colour, and the verdict on a simulation.
fn judged(judgement: &Judgement) -> (&'static str, &'static str) {
    match judgement {
        Judgement::For => ("passed", "as predicted"),
        Judgement::Against(_) => ("failed", "otherwise"),
        Judgement::Open(_) => ("unchecked", "undecided"),
    }
}

/// Why coefficients were not measured or simulation is not as predicted, as items of a list.
fn reasons(entry: &OscillatorEntry) -> String {
    let mut items = String::new();
    for resonance in &entry.resonances {
        for (curve, coefficient) in ["SN", "PD"].into_iter().zip(resonance.coefficients()) {
            let told = [
                ("coefficient", "contradicts", "not measurable", &coefficient.agreement),
                ("simulation", "otherwise", "undecided", &coefficient.simulation),
            ];
            for (what, against, open, judgement) in told {
                let (word, reason) = match judgement {
                    Judgement::For => continue,
                    Judgement::Against(reason) => (against, reason),
                    Judgement::Open(reason) => (open, reason),
                };
                put!(
                    items,
                    "<li><i>p</i> = {}, <i>n</i> = {} at {} = {}, {curve}, {what} {word}: {}</li>\n",
                    resonance.loops,
                    resonance.n,
                    columns::symbol(&entry.secondary.0),
                    number(resonance.secondary, PARAMETER),
                    escape(reason),
                );
            }
        }
    }
    items
}

/// Resonances at which no theorem applies, and what could not be unfolded, with the reasons.
fn without_curves(entry: &OscillatorEntry) -> String {
    let mut items = String::new();
    for resonance in &entry.resonances {
        let Finding::Silent(hypotheses) = &resonance.finding else { continue };
        let failing = hypotheses.iter().map(|(statement, value)| {
            format!("<code>{}</code> fails: {}", escape(statement), number(*value, VALUE))
        });
        put!(
            items,
            "<li><i>p</i> = {}, <i>n</i> = {} at {} = {}, {} = {}: {}</li>\n",
            resonance.loops,
            resonance.n,
            columns::symbol(&entry.primary.0),
            number(resonance.primary, PARAMETER),
            columns::symbol(&entry.secondary.0),
            number(resonance.secondary, PARAMETER),
            failing.collect::<Vec<_>>().join(", "),
        );
    }
    let lost: String = entry.lost.iter().map(|reason| format!("<li>{}</li>\n", escape(reason))).collect();
    let list = |title: &str, items: &str| match items {
        "" => String::new(),
        _ => format!("<h4>{title}</h4>\n<ul class=\"reasons\">\n{items}</ul>\n"),
    };
    let undecided = entry.undecided.iter();
    let undecided: String = undecided
        .map(|(loops, reason)| format!("<li><i>p</i> = {loops}, {}</li>\n", escape(reason)))
        .collect();
    list("What was not borne out, and why", &reasons(entry))
        + &list("Resonances at which the theorem does not apply", &items)
        + &list("What could not be unfolded", &lost)
        + &list("Where stability is not decided (hatched in the diagram)", &undecided)
}
