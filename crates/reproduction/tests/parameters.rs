//! What the parameter file may hold, and what is said when it holds something else.

use grazing_reproduction::parameters::{ParameterError, Parameters, Place, Range};
use grazing_source::{Setting, SourceError, Text};

const DEFAULT: &str = include_str!("../../../figures/parameters.toml");

/// The parameters, or the first thing that is wrong in any section.
fn parse(text: &str) -> Result<Parameters, SourceError> {
    let told = |error: ParameterError| error.source_error().clone();
    let parameters = Parameters::parse(text, "p.toml").map_err(told)?;
    match errors(&parameters).into_iter().next() {
        Some(error) => Err(told(error)),
        None => Ok(parameters),
    }
}

/// What is wrong in the sections, in their order.
fn errors(parameters: &Parameters) -> Vec<ParameterError> {
    [
        parameters.oscillator().map(drop),
        parameters.fig01().map(drop),
        parameters.fig02().map(drop),
        parameters.fig03().map(drop),
        parameters.fig04().map(drop),
        parameters.fig05().map(drop),
        parameters.fig06().map(drop),
        parameters.fig07().map(drop),
        parameters.fig08().map(drop),
        parameters.fig09().map(drop),
        parameters.fig10().map(drop),
    ]
    .into_iter()
    .filter_map(Result::err)
    .collect()
}

/// The default parameters with settings.
fn set(settings: &[&str]) -> Result<Parameters, ParameterError> {
    let settings: Vec<Setting> = settings.iter().map(|text| text.parse().expect("it is a setting")).collect();
    Parameters::parse_with(&Text::new(DEFAULT, &settings), "p.toml")
}

/// The default file with another line in the place of the first one for the key after `section`. The values that stand
/// there do not matter, so the file can change without its tests.
fn edited(section: &str, key: &str, line: &str) -> String {
    let section_start = DEFAULT.find(section).expect("the section stands in the file");
    let start =
        1 + section_start + DEFAULT[section_start..].find(&format!("\n{key} = ")).expect("the key follows");
    let end = start + DEFAULT[start..].find('\n').expect("the file ends with a line end");
    format!("{}{line}{}", &DEFAULT[..start], &DEFAULT[end..])
}

/// The line on which `needle` first stands after `section` in the text.
fn line_of(text: &str, section: &str, needle: &str) -> usize {
    let start = text.find(section).expect("the section stands in the text");
    let at = start + text[start..].find(needle).expect("the needle follows");
    1 + text[..at].matches('\n').count()
}

/// Asserts that the value, written for the key after `section`, is refused under the full key, on its line, and that
/// the refusal quotes `culprit`; gives what is said to be allowed.
fn refusal_quoting(culprit: &str, section: &str, key: &str, value: &str, full_key: &str) -> String {
    let line = format!("{key} = {value}");
    let text = edited(section, key, &line);
    match parse(&text) {
        Err(SourceError::Forbidden { file, line: number, key, value, allowed }) => {
            assert_eq!((file.as_str(), key.as_str(), value.as_str()), ("p.toml", full_key, culprit));
            assert_eq!(number, line_of(&text, section, &line), "the line of {line}");
            allowed
        }
        other => panic!("{section} {line}: {other:?}"),
    }
}

/// As [`refusal_quoting`] the whole value.
fn refusal(section: &str, key: &str, value: &str, full_key: &str) -> String {
    refusal_quoting(value, section, key, value, full_key)
}

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
    assert!(
        DEFAULT.contains(&format!("frequency = {}", parameters.fig02().expect("it is right").frequency()))
    );
    assert_eq!(parameters.fig02().expect("it is right").loops(), [1, 2, 3]);
    assert_eq!(parameters.fig07().expect("it is right").loops(), [1, 2, 3]);
    let panels = parameters.fig08().expect("it is right").panels().iter();
    assert_eq!(panels.map(|panel| (panel.loops(), panel.n())).collect::<Vec<_>>(), [(1, 3), (2, 1), (3, 2)]);
    assert_eq!(
        parameters.fig02().expect("it is right").portraits().len(),
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
fn damping_ratio_lies_strictly_between_0_and_1() {
    for wrong in ["0", "0.0", "1", "-0.5", "1.5", "nan", "inf", "-inf", "\"small\"", "[0.1]", "true"] {
        let allowed = refusal("[oscillator]", "zeta", wrong, "oscillator.zeta");
        assert!(allowed.contains("between 0 and 1"), "{allowed}");
    }
    // Its resonances differ little from those of the default damping, so the windows keep them.
    let slight = parse(&edited("[oscillator]", "zeta", "zeta = 0.01"));
    assert_eq!(slight.map(|parameters| parameters.oscillator().map(|of| of.damping_ratio())), Ok(Ok(0.01)));
}

#[test]
fn restitution_lies_above_0_and_may_be_1() {
    for wrong in ["0", "-0.1", "1.0000001", "nan"] {
        refusal("[oscillator]", "epsilon", wrong, "oscillator.epsilon");
    }
    let elastic = parse(&edited("[oscillator]", "epsilon", "epsilon = 1"));
    let epsilon = |parameters: Parameters| parameters.oscillator().map(|of| of.coefficient_of_restitution());
    assert_eq!(elastic.map(epsilon), Ok(Ok(1.0)));
}

#[test]
fn ranges_are_two_finite_numbers_and_run_upwards() {
    for wrong in ["[0.3, 0.3]", "[0.4, 0.2]", "[nan, 0.4]", "[0.2, inf]", "[0.2]", "[0.2, 0.3, 0.4]", "0.3"] {
        refusal("[fig02]", "near", wrong, "fig02.near");
        refusal("[fig02]", "x", wrong, "fig02.x");
        refusal("[fig07]", "frequency", wrong, "fig07.frequency");
        refusal("[[fig08.panels]]", "frequency", wrong, "fig08.panels[1].near.frequency");
    }
    refusal("[fig07]", "amplitude", "[-0.1, 1.3]", "fig07.amplitude");
    refusal("[fig07]", "frequency", "[0, 1.1]", "fig07.frequency");
    assert!(Range::new(1.0, 1.0).is_none());
}

#[test]
fn loops_are_different_whole_numbers_from_1_on() {
    for section in ["fig02", "fig07"] {
        let (table, key) = (format!("[{section}]"), format!("{section}.loops"));
        for (wrong, culprit) in [
            ("[0, 1]", "0"),
            ("[1, -2]", "-2"),
            ("[1, 2.0]", "2.0"),
            ("[13]", "13"),
            ("[]", "[]"),
            ("1", "1"),
        ] {
            refusal_quoting(culprit, &table, "loops", wrong, &key);
        }
        let allowed = refusal(&table, "loops", "[1, 2, 1]", &key);
        assert!(allowed.contains("twice"), "{allowed}");
    }
}

#[test]
fn figure_7_holds_a_resonance() {
    let allowed = refusal("[fig07]", "frequency", "[0.9, 0.95]", "fig07.frequency");
    assert!(allowed.contains("no resonance"), "{allowed}");
    assert!(allowed.contains("the nearest, p = 3, n = 1"), "{allowed}");
    // One resonance is enough; that of three loops lies outside.
    assert_eq!(refused(&["fig07.frequency=[0.65, 0.82]"]), [""; 0]);
    // Resonances accumulate at zero, where there would be no end of them.
    let allowed = refusal("[fig07]", "frequency", "[1e-9, 1.1]", "fig07.frequency");
    assert!(allowed.contains("0.05 <= lower"), "{allowed}");
}

#[test]
fn parts_lie_inside_the_whole() {
    refusal("[fig02.magnification]", "amplitude", "[0, 9]", "fig02.magnification.amplitude");
    refusal("[fig02.magnification]", "x", "[-9, 0]", "fig02.magnification.x");
    for (setting, key) in [
        ("fig02.portraits[1].amplitude=9.0", "fig02.portraits[1].amplitude"),
        ("fig08.panels[1].amplitude=[0.1, 9]", "fig08.panels[1].amplitude"),
    ] {
        assert_eq!(refused(&[setting]), [key]);
    }
}

/// The keys that are refused with settings.
fn refused(settings: &[&str]) -> Vec<String> {
    let key = |error: &ParameterError| match error.source_error() {
        SourceError::Forbidden { key, .. } => key.clone(),
        other => other.to_string(),
    };
    match set(settings) {
        Ok(parameters) => errors(&parameters).iter().map(key).collect(),
        Err(error) => vec![key(&error)],
    }
}

#[test]
fn a_panel_of_figure_8_holds_its_resonance() {
    let window =
        |n| format!("fig08.panels=[{{loops=1, n={n}, amplitude=[0.5, 0.61], frequency=[0.6475, 0.6815]}}]");
    assert_eq!(refused(&[&window(3)]), [""; 0]);
    assert_eq!(refused(&[&window(5)]), ["fig08.panels[1].amplitude"]);
    assert_eq!(refused(&["fig08.panels[1].frequency=[0.7, 0.8]"]), ["fig08.panels[1].frequency"]);
    // Nothing but the resonance is asked for then, and the program chooses the window.
    let parameters = set(&["fig08.panels[1].n=2"]).expect("it is TOML");
    let panel = &parameters.fig08().expect("it is right").panels()[0];
    assert_eq!((panel.loops(), panel.n(), panel.amplitude(), panel.frequency()), (1, 2, None, None));
}

#[test]
fn panels_are_about_resonances_that_the_window_holds() {
    // The last of the three resonances lies below this window.
    let parameters = set(&["fig07.frequency=[0.6, 1.02]"]).expect("it is TOML");
    let shown = parameters.fig08().expect("it is right");
    let panels: Vec<_> = shown.panels().iter().map(|panel| (panel.loops(), panel.n())).collect();
    assert_eq!(panels.len(), 3, "{panels:?}");
    let theory = parameters.oscillator().expect("it is right");
    for (index, (loops, n)) in panels.iter().enumerate() {
        let resonance = theory.resonance(*loops, *n).expect("it is one");
        let window = parameters.fig07().expect("it is right").window();
        assert!(
            window.contains(resonance.grazing().amplitude(), resonance.forcing_frequency()),
            "{loops} {n}"
        );
        assert!(!panels[..index].contains(&(*loops, *n)), "{panels:?}");
    }
    assert!(shown.notes()[0].contains("p = 3, n = 2 does not lie in the window"), "{:?}", shown.notes());
    let parameters = set(&["fig08.panels=[]"]).expect("it is TOML");
    assert_eq!(parameters.fig08().expect("it is right").panels().len(), 3);
}

#[test]
fn a_portrait_is_strictly_where_its_amplitude_is_and_otherwise_where_it_can_be() {
    let place = |settings: &[&str]| {
        let parameters = set(settings).expect("it is TOML");
        parameters.fig02().expect("it is right").portraits()[1].place()
    };
    let Place::Near(near) = place(&[]) else { panic!("the default file has wishes") };
    assert_eq!(place(&["fig02.portraits[2].amplitude=0.3"]), Place::At(0.3));
    assert_eq!(place(&["fig02.portraits[2].near=9.5"]), Place::Near(9.5));
    assert!(near > 0.0);
    let parameters = set(&["fig02.portraits=[]"]).expect("it is TOML");
    assert!(parameters.fig02().expect("it is right").portraits().is_empty());
}

#[test]
fn what_is_wrong_in_a_section_concerns_no_other_one() {
    let parameters = set(&["fig10.frequency=-1", "fig04.loops=[]"]).expect("it is TOML");
    assert_eq!(errors(&parameters).len(), 2);
    assert!(errors(&parameters).iter().all(|error| matches!(error, ParameterError::Malformed(_))));
    // Another oscillator can be at odds with what the file says, which is no slip.
    let parameters = set(&["oscillator.zeta=0.2"]).expect("it is TOML");
    for error in errors(&parameters) {
        assert!(matches!(error, ParameterError::Unfit(_)), "{error}");
    }
    let parameters = set(&["oscillator.zeta=2"]).expect("it is TOML");
    assert!(parameters.fig01().is_ok() && parameters.fig07().is_err());
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
        ("oscillator.zeta.x=1", "--set: oscillator.zeta.x = 1: oscillator.zeta: it is no table"),
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
fn the_frequency_for_figure_10_that_a_refusal_names_is_accepted() {
    let parameters = set(&["fig10.frequency=0.6"]).expect("it is TOML");
    let told = parameters.fig10().expect_err("Theorem 2.3 does not apply").to_string();
    let range = told.rsplit("they hold from ").next().expect("a remedy is told");
    for end in range.split(" to ") {
        let middle: f64 =
            range.split(" to ").map(|end| end.parse::<f64>().expect("a number")).sum::<f64>() / 2.0;
        let close: f64 = 0.999 * end.parse::<f64>().expect("a number") + 0.001 * middle;
        let parameters = set(&[&format!("fig10.frequency={close}")]).expect("it is TOML");
        assert!(parameters.fig10().is_ok(), "{close} of {told}");
    }
}

#[test]
fn figure_2_holds_its_grazing_amplitude() {
    let grazing = |parameters: &Parameters| {
        let frequency = parameters.fig02_frequency().expect("it is right");
        parameters.oscillator().expect("it is right").grazing(frequency).expect("it grazes").amplitude()
    };
    for zeta in [0.001, 0.2, 0.9] {
        let parameters = set(&[&format!("oscillator.zeta={zeta}")]).expect("it is TOML");
        let (figure, grazing) = (parameters.fig02().expect("it has a place"), grazing(&parameters));
        assert!(figure.amplitude().strictly_contains(grazing), "{zeta}");
        assert!(figure.amplitude().encloses(&figure.magnified_amplitude()), "{zeta}");
        // Told, if it is not where the file says.
        let there =
            DEFAULT.contains(&format!("[{}, {}]", figure.amplitude().lower(), figure.amplitude().upper()));
        assert_eq!(figure.notes().is_empty(), there, "{zeta}");
        assert!(there || figure.magnified_amplitude().strictly_contains(grazing), "{zeta}");
    }
    // What is not a wish is refused.
    let text = edited("[fig02]", "near", "amplitude = [0.001, 0.002]");
    let parameters = Parameters::parse(
        &text.replace("amplitude = [0.2704, 0.2748]", "amplitude = [0.0015, 0.002]"),
        "p.toml",
    );
    let told = parameters.expect("it is TOML").fig02().expect_err("grazing is elsewhere").to_string();
    assert!(
        told.contains("fig02.amplitude = [0.001, 0.002]: the range must contain the grazing amplitude"),
        "{told}"
    );
    let neither = Parameters::parse(&edited("[fig02]", "near", ""), "p.toml").expect("it is TOML");
    assert!(neither.fig02().expect_err("it has no place").to_string().contains("fig02.near is missing"));
}

#[test]
fn portraits_and_panels_show_loops_that_are_computed() {
    refusal("[[fig02.portraits]]", "loops", "4", "fig02.portraits[1].loops");
    refusal("[[fig08.panels]]", "loops", "4", "fig08.panels[1].loops");
    refusal("[[fig08.panels]]", "n", "0", "fig08.panels[1].n");
    refusal("[[fig08.panels]]", "n", "101", "fig08.panels[1].n");
}

#[test]
fn boundaries_in_the_trapesium_begin_with_two_loops() {
    refusal_quoting("1", "[fig04]", "loops", "[2, 1]", "fig04.loops");
    refusal("[fig04]", "loops", "[]", "fig04.loops");
    refusal_quoting("13", "[fig04]", "loops", "[13]", "fig04.loops");
}

#[test]
fn figure_5_is_about_a_resonance_with_both_parameters_around_zero() {
    refusal("[fig05]", "n", "101", "fig05.n");
    for key in ["mu", "eta"] {
        for wrong in ["[0.0, 0.1]", "[-0.1, 0.0]", "[0.1, -0.1]", "[-0.1]"] {
            refusal("[fig05]", key, wrong, &format!("fig05.{key}"));
        }
    }
}

#[test]
fn the_oscillator_of_figure_6_keeps_off_the_wall() {
    for wrong in ["0.0", "-0.1", "9", "nan"] {
        let allowed = refusal("[fig06]", "amplitude", wrong, "fig06.amplitude");
        assert!(allowed.contains("grazing amplitude"), "{allowed}");
    }
    refusal("[fig06]", "phase", "6.3", "fig06.phase");
    refusal("[fig06]", "coils", "0", "fig06.coils");
}

#[test]
fn the_path_of_figure_10_belongs_to_a_grazing_bifurcation_of_theorem_2_3() {
    // At 0.6 of the natural frequency a12 is negative; at 0.85 tau lies below h_6.
    for (wrong, reason) in [("0.6", "a12 alpha"), ("0.85", "h_p")] {
        let allowed = refusal("[fig10]", "frequency", wrong, "fig10.frequency");
        assert!(allowed.contains("Theorem 2.3") && allowed.contains(reason), "{allowed}");
    }
    refusal("[fig10]", "loops", "2", "fig10.loops");
}

#[test]
fn the_work_of_the_attractor_is_bounded() {
    let section = "[fig02.attractor]";
    refusal(section, "amplitudes", "1", "fig02.attractor.amplitudes");
    refusal(section, "orbits", "0", "fig02.attractor.orbits");
    refusal(section, "recorded", "0", "fig02.attractor.recorded");
    refusal(section, "seed", "-1", "fig02.attractor.seed");
    let allowed = refusal(section, "transient", "999999", "fig02.attractor.transient");
    assert!(allowed.contains("forcing periods"), "{allowed}");
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
    match Parameters::from_file(path) {
        Err(ParameterError::Malformed(SourceError::Unreadable { file, .. })) => {
            assert_eq!(file, "no/such/parameters.toml")
        }
        other => panic!("{other:?}"),
    }
}

#[cfg(unix)]
#[test]
fn what_has_no_end_is_not_read() {
    for (path, wanted) in [("/dev/zero", "not a file"), ("/", "not a file")] {
        let error = Parameters::from_file(std::path::Path::new(path)).expect_err("it is no file").to_string();
        assert!(error.starts_with(path) && error.contains(wanted), "{error}");
    }
}

#[test]
fn views_stand_above_the_plane_and_stretches_are_three_positive_numbers() {
    for figure in ["fig01", "fig03", "fig09"] {
        let section = format!("[{figure}.view]");
        for (key, wrongs) in [
            ("turn", vec!["181", "-200.0", "nan"]),
            ("tilt", vec!["0", "90", "-10", "inf"]),
            ("stretch", vec!["[1.0, 1.0]", "[1.0, 0.0, 1.0]", "[1, 1, 1, 1]", "[1.0, nan, 1.0]", "1.0"]),
        ] {
            for wrong in wrongs {
                refusal(&section, key, wrong, &format!("{figure}.view.{key}"));
            }
        }
    }
}

#[test]
fn surfaces_of_the_scenes_hold_the_wall_and_the_points_given() {
    refusal("[fig01]", "velocity", "[0.1, 1.0]", "fig01.velocity");
    refusal("[fig03]", "position", "[-1.0, -0.5]", "fig03.position");
    refusal("[fig03]", "phase", "[-2.0, 0.5]", "fig03.phase");
    refusal("[fig03]", "start", "[-5.0, 0.0]", "fig03.start");
    refusal("[fig03]", "radius", "2.0", "fig03.radius");
    refusal("[fig03]", "axes", "7.0", "fig03.axes");
    refusal("[fig09]", "position", "[0, 1]", "fig09.position");
    refusal("[fig09]", "phase", "[-4.0, 4.0]", "fig09.phase");
    refusal("[fig09]", "impact", "[0.0, 0.0]", "fig09.impact");
    refusal("[fig09]", "impact", "[9.0, 0.0]", "fig09.impact");
    refusal("[fig09]", "loops", "4", "fig09.loops");
    for figure in ["fig01", "fig09"] {
        let section = format!("[{figure}]");
        refusal(&section, "zeta", "1", &format!("{figure}.zeta"));
        refusal(&section, "epsilon", "1.5", &format!("{figure}.epsilon"));
        refusal(&section, "amplitude", "0", &format!("{figure}.amplitude"));
        refusal(&section, "frequency", "-1", &format!("{figure}.frequency"));
    }
}

#[test]
fn orbits_of_figure_1_stay_within_one_period_of_the_phase() {
    let section = "[[fig01.orbits]]";
    refusal(section, "velocity", "-0.5", "fig01.orbits[1].velocity");
    refusal(section, "velocity", "9.0", "fig01.orbits[1].velocity");
    refusal(section, "phase", "6.3", "fig01.orbits[1].phase");
    refusal(section, "before", "4.0", "fig01.orbits[1].before");
    refusal(section, "after", "5.0", "fig01.orbits[1].after");
}
