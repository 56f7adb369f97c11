//! The file itself: its keys, its syntax, and settings that replace values.

use grazing_beyond::parameters;
use grazing_input::{Setting, SourceError};
use grazing_reproduction::figures::fig02::Figure2;
use grazing_reproduction::figures::fig07::Figure7;
use grazing_reproduction::figures::fig08::Figure8;
use grazing_reproduction::parameters::ParameterError;

use super::{DEFAULT, edited, errors, line_of, parse, set};

#[test]
fn the_default_file_is_accepted_and_read_whole() {
    let parameters = parse(DEFAULT).expect("the default file is valid");
    assert!(
        DEFAULT
            .contains(&format!("zeta = {}", parameters.oscillator().expect("it is right").damping_ratio()))
    );
    assert!(DEFAULT.contains(&format!(
        "epsilon = {}",
        parameters.oscillator().expect("it is right").coefficient_of_restitution()
    )));
    assert!(DEFAULT.contains(&format!(
        "frequency = {}",
        parameters.section::<Figure2>().expect("it is right").frequency
    )));
    assert_eq!(parameters.section::<Figure2>().expect("it is right").loops, [1, 2, 3]);
    assert_eq!(parameters.section::<Figure7>().expect("it is right").loops, [1, 2, 3]);
    let panels = parameters.section::<Figure8>().expect("it is right").panels.into_iter();
    assert_eq!(panels.map(|panel| (panel.loops, panel.n)).collect::<Vec<_>>(), [(1, 3), (2, 1), (3, 2)]);
    assert_eq!(
        parameters.section::<Figure2>().expect("it is right").portraits.len(),
        DEFAULT.matches("[[fig02.portraits]]").count()
    );
}

#[test]
fn every_key_of_the_default_file_is_explained_where_it_first_stands() {
    let mut previous = "";
    let mut explained = std::collections::BTreeSet::new();
    for line in DEFAULT.lines() {
        if let Some((key, _)) = line.split_once(" = ").filter(|_| !line.starts_with('#')) {
            let repeated = !explained.insert(key);
            assert!(previous.starts_with('#') || repeated, "no comment above `{line}`");
        }
        previous = line;
    }
    assert!(explained.len() > 10, "the keys were found");
}

#[test]
fn every_key_of_the_default_file_is_needed() {
    let keys = DEFAULT.lines().filter(|line| !line.starts_with('#') && line.contains(" = "));
    let mut removed = 0;
    for line in keys.filter(|line| !line.starts_with("near = ")) {
        let text = DEFAULT.replacen(&format!("{line}\n"), "", 1);
        let name = line.split_once(" = ").map_or(line, |(name, _)| name);
        match parse(&text) {
            Err(SourceError::MissingKey { key, allowed, .. }) => {
                assert!(key.ends_with(name), "{key} for {name}");
                assert!(!allowed.starts_with("see "), "no requirement is written down for {key}");
            }
            other => panic!("without `{line}`: {other:?}"),
        }
        removed += 1;
    }
    assert!(removed > 20, "the keys were found");
}

#[test]
fn settings_are_told_of_as_such_and_later_ones_go_before() {
    let parameters = set(&["oscillator.zeta=0.3", "oscillator.zeta=0.04"]).expect("it is TOML");
    assert_eq!(parameters.oscillator().map(|of| of.damping_ratio()), Ok(0.04));
    let told = |settings: &[&str]| match set(settings) {
        Ok(parameters) => errors(&parameters)[0].to_string(),
        Err(error) => error.to_string(),
    };
    for (setting, beginning) in [
        ("oscillator.zetta=0.3", "--set: unknown key oscillator.zetta: did you mean `zeta`?"),
        ("oscilator.zeta=0.3", "--set: unknown key oscilator: did you mean `oscillator`?"),
        ("oscillator.zeta=3", "--set: oscillator.zeta = 3: the damping ratio"),
        ("oscillator.zeta=\"a\"", "--set: oscillator.zeta = \"a\": the damping ratio"),
        ("oscillator.zeta.x=1", "--set: oscillator.zeta.x = 1: oscillator.zeta: it is not a table"),
        (
            "fig08.panels[9].n=1",
            "--set: fig08.panels[9].n = 1: fig08.panels: there is no entry 9: the list has 3",
        ),
        ("fig08.panels[2].lops=1", "--set: unknown key fig08.panels[2].lops: did you mean `loops`?"),
        ("fig02.x[1]=7.0", "p.toml:"),
    ] {
        assert!(told(&[setting]).starts_with(beginning), "{setting}: {}", told(&[setting]));
    }
    for wrong in ["zeta", "=1", "a..b=1", "a.b=", "a.b=x", "a.b=1\nc=2", "a[x]=1", "a[1=1"] {
        assert!(wrong.parse::<Setting>().is_err(), "{wrong}");
    }
}

#[test]
fn an_unknown_key_is_named_with_the_nearest_known_one() {
    let text = edited("[fig02.attractor]", "orbits", "recoded = 20\norbits = 4");
    match parse(&text) {
        Err(SourceError::UnknownKey { line, key, nearest, known, .. }) => {
            assert_eq!(line, line_of(&text, "[fig02.attractor]", "recoded"));
            assert_eq!((key.as_str(), nearest.as_deref()), ("fig02.attractor.recoded", Some("recorded")));
            assert_eq!(known, ["amplitudes", "orbits", "transient", "recorded", "seed"]);
        }
        other => panic!("{other:?}"),
    }
    match parse(&DEFAULT.replacen("\n[fig02.attractor]", "\n[fig2.attractor]", 1)) {
        Err(SourceError::UnknownKey { key, nearest, .. }) => {
            assert_eq!((key.as_str(), nearest.as_deref()), ("fig2", Some("fig02")));
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_missing_table_and_a_missing_member_key_are_named() {
    let text = DEFAULT.split("# Figure 8 (fig:Y)").next().expect("a first part");
    match parse(text) {
        Err(SourceError::MissingKey { line, key, .. }) => {
            assert_eq!((line, key.as_str()), (text.lines().count(), "fig08"));
        }
        other => panic!("{other:?}"),
    }
    let last = DEFAULT.rfind("n = 2\n").expect("the last panel has an n");
    let text = format!("{}{}", &DEFAULT[..last], &DEFAULT[last + 6..]);
    match parse(&text) {
        Err(SourceError::MissingKey { key, .. }) => assert_eq!(key, "fig08.panels[3].n"),
        other => panic!("{other:?}"),
    }
}

#[test]
fn what_is_not_toml_is_shown_with_line_and_column() {
    match parse("[oscillator]\nzeta = 0.02.1\n") {
        Err(SourceError::Syntax { line, column, .. }) => assert_eq!((line, column), (2, 12)),
        other => panic!("{other:?}"),
    }
    assert!(matches!(
        parse(&edited("[oscillator]", "epsilon", "zeta = 0.9")),
        Err(SourceError::Syntax { .. })
    ));
}

#[test]
fn a_file_that_is_not_there_is_named() {
    let path = std::path::Path::new("no/such/parameters.toml");
    match parameters::from_file(path, &[]) {
        Err(ParameterError::Malformed(SourceError::Unreadable { file, .. })) => {
            assert_eq!(file, "no/such/parameters.toml")
        }
        other => panic!("{other:?}"),
    }
}

#[cfg(unix)]
#[test]
fn what_has_no_end_is_not_read() {
    for (path, wanted) in
        [("/dev/zero", "a device, not a regular file"), ("/", "a folder, not a regular file")]
    {
        let error =
            parameters::from_file(std::path::Path::new(path), &[]).expect_err("it is no file").to_string();
        assert!(error.starts_with(path) && error.contains(wanted), "{error}");
    }
}
