//! Every error in a description is reported with its place and its remedy.

use std::fmt::Write as _;
use std::path::Path;

use grazing_input::Description;

/// A correct description.
pub(crate) const RIGHT: &str = r#"name = "Invented"
[parameters]
zeta = 0.1
kappa = 0.2
[primary]
name = "A"
range = [0.0, 1.5]
[secondary]
name = "omega"
range = [0.4, 1.1]
[motion]
force = "-2*zeta*v - x - kappa*x^3 - 1 + A*cos(omega*t)"
frequency = "omega"
[impact]
restitution = "0.8"
duration = "0"
[analysis]
loops = [1, 2, 3]
"#;

/// Edits of the description: the table, the key whose line is replaced, and the new line.
pub(crate) const EDITS: &[(&str, &str, &str)] = &[
    // The file.
    ("", "name", "name = Invented"),
    ("", "name", "name = \" \""),
    ("", "name", ""),
    ("", "name", "title = \"Invented\""),
    ("", "[motion]", "[movement]"),
    ("", "[parameters]", ""),
    ("[analysis]", "loops", "loop = [1]"),
    ("[impact]", "duration", ""),
    ("[impact]", "restitution", "restitution = 0.8"),
    ("[parameters]", "zeta", "zeta = \"small\""),
    ("[parameters]", "zeta", "zeta = inf"),
    ("[primary]", "range", "range = [1.5, 0.0]"),
    ("[primary]", "range", "range = [1.5, 1.5]"),
    ("[primary]", "range", "range = [0.0]"),
    ("[secondary]", "range", "range = [0.4, nan]"),
    ("[analysis]", "loops", "loops = [1, 0]"),
    ("[analysis]", "loops", "loops = [1, -2]"),
    ("[analysis]", "loops", "loops = [13]"),
    ("[analysis]", "loops", "loops = [2, 2]"),
    ("[analysis]", "loops", "loops = []"),
    // The wall, and names of units.
    ("", "[impact]", "[wall]\nside = \"above\"\n[impact]"),
    ("", "[impact]", "[wall]\nposition = \"0\"\nside = \"left\"\n[impact]"),
    ("", "[impact]", "[wall]\nposition = \"cos(0.5*omega*t)\"\n[impact]"),
    ("", "[impact]", "[wall]\nposition = \"x\"\n[impact]"),
    ("", "[impact]", "[wall]\nposition = \"ln(A - 0.1)\"\n[impact]"),
    ("", "[impact]", "[wall]\nposition = 0.1\n[impact]"),
    ("", "[impact]", "[wall]\nposition = \"0\"\nside = \"both\"\n[impact]"),
    ("", "[impact]", "[wall]\nposition = \"0\"\nboth = true\n[impact]"),
    ("[primary]", "range", "range = [0.0, 1.5]\nunit = 1"),
    ("[primary]", "range", "range = [0.0, 1.5]\nunit = \"\""),
    ("", "[impact]", "[units]\nlength = \"<b>mm</b>\"\n[impact]"),
    ("", "[impact]", "[units]\ncharge = \"C\"\n[impact]"),
    // Common mistakes.
    ("[parameters]", "zeta", "zeta = {a = 1}"),
    ("[parameters]", "zeta", "zeta = [0.1]"),
    ("[parameters]", "zeta", "zeta = 0.1 N s/m"),
    ("[parameters]", "zeta", "zeta = 0,1"),
    ("[parameters]", "zeta", "zeta ="),
    ("[parameters]", "zeta", "zeta = 0.1\nzeta = 0.2"),
    ("[primary]", "range", "range = [{from = 0.0}, 1.5]"),
    ("[primary]", "range", "range = [-1e308, 1e308]"),
    ("[analysis]", "loops", "loops = [1]\ntime_limit = 0"),
    ("[analysis]", "loops", "loops = [1]\nmemory_limit = \"2 GB\""),
    ("[analysis]", "loops", "loops = [1]\nstep_limit = -1"),
    ("[analysis]", "loops", "loops = [1]\nstart = [-1.0, inf]"),
    // One-parameter diagrams.
    ("[analysis]", "loops", "loops = [1]\n[diagrams]\nfixed = \"A\""),
    ("[analysis]", "loops", "loops = [1]\n[[diagrams]]\nat = 0.5"),
    ("[analysis]", "loops", "loops = [1]\n[[diagrams]]\nfixed = \"zeta\"\nat = 0.5"),
    ("[analysis]", "loops", "loops = [1]\n[[diagrams]]\nfixed = \"omega\""),
    ("[analysis]", "loops", "loops = [1]\n[[diagrams]]\nfixed = \"omega\"\nat = 1.2"),
    ("[analysis]", "loops", "loops = [1]\n[[diagrams]]\nfixed = \"omega\"\nat = 0.5\nrange = [0.5, 1.6]"),
    ("[analysis]", "loops", "loops = [1]\n[[diagrams]]\nfixed = \"A\"\nat = 0.5\nrange = [0.8, 0.6]"),
    ("[analysis]", "loops", "loops = [1]\n[[diagrams]]\nfixed = \"A\"\nat = 0.5\nportraits = [0.3]"),
    ("[analysis]", "loops", "loops = [1]\n[[diagrams]]\nfixed = \"A\"\nat = 0.5\nportraits = [0.5, 0.5]"),
    ("[analysis]", "loops", "loops = [1]\n[[diagrams]]\nfixed = \"A\"\nat = 0.5\nseed = -1"),
    ("[analysis]", "loops", "loops = [1]\n[[diagrams]]\nfixed = \"A\"\nat = 0.5\nportrait = [0.5]"),
    ("[analysis]", "loops", "loops = [1]\n[[diagrams]]\nfixed = \"A\"\nat = 0.5\nordinate = \"speed\""),
    ("[analysis]", "loops", "loops = [1]\n[[diagrams]]\nfixed = \"A\"\nat = 0.5\nordinate = \"power\""),
    ("[impact]", "duration", "duration = \"0\"\nmass = \"A - 1\""),
    ("[impact]", "duration", "duration = \"0\"\nmass = \"x\""),
    // Own curves.
    ("[analysis]", "loops", "loops = [1]\n[[curves]]\nmodulus = 0.9"),
    ("[analysis]", "loops", "loops = [1]\n[[curves]]\nname = \"fast\""),
    ("[analysis]", "loops", "loops = [1]\n[[curves]]\nname = \"fast\"\nmodulus = 0.9\nimpact_velocity = 0.1"),
    ("[analysis]", "loops", "loops = [1]\n[[curves]]\nname = \"fast\"\nimpact_velocity = -0.1"),
    ("[analysis]", "loops", "loops = [1]\n[[curves]]\nname = \"far\"\ndistance = 0.1"),
    ("[analysis]", "loops", "loops = [1]\n[[curves]]\nname = \"far\"\nmodulus = 0.1\nphase = 0.5"),
    ("[analysis]", "loops", "loops = [1]\n[[curves]]\nname = \"far\"\ndistance = 0.1\nphase = 90"),
    ("[analysis]", "loops", "loops = [1]\n[[curves]]\nname = \"$far$\"\nmodulus = 0.9"),
    ("[analysis]", "loops", "loops = [1]\n[[curves]]\nname = \"far\"\nmodulus = 0.9\nloops = [2]"),
    (
        "[analysis]",
        "loops",
        "loops = [1]\n[[curves]]\nname = \"a\"\nmodulus = 0.9\n[[curves]]\nname = \"a\"\nmodulus = 0.8",
    ),
    // Names.
    ("[parameters]", "zeta", "zeta = 0.1\nx = 1"),
    ("[parameters]", "zeta", "zeta = 0.1\nt = 1"),
    ("[parameters]", "zeta", "zeta = 0.1\nv = 1"),
    ("[parameters]", "zeta", "zeta = 0.1\ny = 1"),
    ("[parameters]", "zeta", "zeta = 0.1\nz = 1"),
    ("[parameters]", "zeta", "zeta = 0.1\npi = 3"),
    ("[parameters]", "zeta", "zeta = 0.1\ne = 3"),
    ("[parameters]", "zeta", "zeta = 0.1\nsin = 3"),
    ("[parameters]", "zeta", "zeta = 0.1\nomega = 3"),
    ("[parameters]", "zeta", "zeta = 0.1\n\"ζ\" = 3"),
    ("[secondary]", "name", "name = \"A\""),
    ("[secondary]", "name", "name = \"forcing frequency\""),
    ("[motion]", "force", "force = \"-2*zeta*v - x - 1 + cos(omega*t)\""),
    ("[secondary]", "name", "name = \"epsilon\""),
    // Expressions.
    ("[motion]", "force", "force = \"\""),
    ("[motion]", "force", "force = \"-x - 1 + A*cos(omga*t)\""),
    ("[motion]", "force", "force = \"-x - 1 + A*cosine(omega*t)\""),
    ("[motion]", "force", "force = \"-x - log(2 - x) + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-x - 1 + A*cos(omega, t)\""),
    ("[motion]", "force", "force = \"-x - 1 + A*cos()\""),
    ("[motion]", "force", "force = \"-x - 1 + A*cos omega\""),
    ("[motion]", "force", "force = \"-x - 1 + A*cos\""),
    ("[motion]", "force", "force = \"-x - 1 + A(cos(omega*t))\""),
    ("[motion]", "force", "force = \"-2x - 1 + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-0.1*x' - x - 1 + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-0,1*v - x - 1 + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-(x + 1)(x + 2) + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-x - 1 + A*cos(omega*t\""),
    ("[motion]", "force", "force = \"-x - 1) + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-x - * 1 + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-x - 1 +\""),
    ("[motion]", "force", "force = \"-x - 1 + A·cos(ωt)\""),
    ("[motion]", "force", "force = \"-x - 1e999 + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-x - 1/(zeta - zeta) + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-x - sqrt(kappa - 1) + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-x - ln(0) + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-x - exp(1000) + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-x - m*v + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-x - 10^400 + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"\"\"\n-x - 1\n    - 2*zeta*w\n    + A*cos(omega*t)\"\"\""),
    ("[motion]", "frequency", "frequency = \"omega + x\""),
    ("[impact]", "restitution", "restitution = \"0.8 - 0.1*v\""),
    ("[motion]", "force", "force = \"-x, -1\""),
    ("[motion]", "force", "force = \"-x - kappa*pow(x, 3) + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-x - kappa*pow(x + 1, 2*zeta) + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-x - kappa*x.^3 + A*cos(omega*t)\""),
    // Nothing depends on the time.
    ("[motion]", "force", "force = \"A*(1 - x^2)*v - omega*x\""),
    // Not smooth.
    ("[motion]", "force", "force = \"-x - 1 - zeta*abs(v)*v + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-x - 1 - zeta*sign(v) + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-max(x, 0) - 1 + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-min(x, 0) - 1 + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-x - 1 + A*floor(cos(omega*t))\""),
    ("[motion]", "force", "force = \"-x - 1 + A*heaviside(cos(omega*t))\""),
    ("[motion]", "force", "force = \"-x - 1 - hypot(x, v) + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-x - 1 + A*(t % 2)\""),
    ("[motion]", "force", "force = \"-x - 1 + (x > -1 ? A : 0)*cos(omega*t)\""),
    // Values.
    ("[motion]", "frequency", "frequency = \"omega - 0.5\""),
    ("[motion]", "frequency", "frequency = \"sqrt(omega - 0.5)\""),
    ("[motion]", "force", "force = \"-x - 1/v + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-sqrt(x) - 1 + A*cos(omega*t)\""),
    ("[motion]", "force", "force = \"-x - 1 + A*cos(2.1*omega*t)\""),
    ("[motion]", "force", "force = \"-x - 1 + A*cos(omega*t/2)\""),
    ("[motion]", "force", "force = \"-x - 1 + A*t + 0*omega\""),
    ("[impact]", "restitution", "restitution = \"0.8 - y\""),
    ("[impact]", "restitution", "restitution = \"0.8 - A*(1 + cos(z))/2\""),
    ("[impact]", "restitution", "restitution = \"0.8 + 0.1*cos(z/2)\""),
    ("[impact]", "restitution", "restitution = \"y^-0.2\""),
    ("[impact]", "duration", "duration = \"0.1*z\""),
    ("[impact]", "duration", "duration = \"0.1/y\""),
    // Figures.
    ("[analysis]", "loops", "loops = [1]\n[figure]\nswap = \"yes\""),
    ("[analysis]", "loops", "loops = [1]\n[figure]\nnames = [\"curve\"]"),
    ("[analysis]", "loops", "loops = [1]\n[figure]\nheight = 10"),
    ("[analysis]", "loops", "loops = [1]\n[figure.colours]\nSN = \"blue\""),
    ("[analysis]", "loops", "loops = [1]\n[figure.colours]\nsn = \"#1946be\""),
];

/// The correct description with one line changed.
pub(crate) fn edited(table: &str, key: &str, line: &str) -> String {
    let mut inside = table.is_empty();
    let mut done = false;
    let mut text = String::new();
    for old in RIGHT.lines() {
        inside |= old == table;
        if inside && !done && (old == key || old.starts_with(&format!("{key} ="))) {
            done = true;
            if !line.is_empty() {
                writeln!(text, "{line}").expect("a string takes it");
            }
        } else {
            writeln!(text, "{old}").expect("a string takes it");
        }
    }
    assert!(done, "{table} {key}");
    text
}

#[test]
fn the_description_without_edits_is_right() {
    let description = Description::parse(RIGHT, "invented.toml").expect("it is right");
    assert_eq!(description.name(), "Invented");
    assert_eq!(description.constants().collect::<Vec<_>>(), [("kappa", 0.2), ("zeta", 0.1)]);
    assert_eq!((description.primary().name(), description.primary().range()), ("A", [0.0, 1.5]));
    assert_eq!((description.secondary().name(), description.secondary().range()), ("omega", [0.4, 1.1]));
    assert_eq!(description.loops(), [1, 2, 3]);
}

#[test]
fn diagrams_have_the_range_of_the_file_and_a_seed_unless_they_say_otherwise() {
    let diagrams = "[[diagrams]]\nfixed = \"A\"\nat = 0.5\n[[diagrams]]\nfixed = \"omega\"\nat = 0.5\n\
                    range = [0.1, 0.9]\nportraits = [0.8, 0.3]\nseed = 7\n";
    let description =
        Description::parse(&format!("{RIGHT}{diagrams}"), "invented.toml").expect("it is right");
    let [first, second] = description.diagrams() else { panic!("there are two") };
    assert!(first.primary_is_fixed && first.portraits.is_empty());
    assert_eq!((first.range, first.seed), ([0.4, 1.1], 1));
    assert!(!second.primary_is_fixed);
    assert_eq!((second.range, second.seed), ([0.1, 0.9], 7));
    assert_eq!(second.portraits, [0.3, 0.8]);
}

#[test]
fn every_bad_description_is_refused_with_its_place_and_what_would_be_right() {
    let mut transcript = String::new();
    for (table, key, line) in EDITS {
        let edit = if line.is_empty() { "removed" } else { line };
        let error = match Description::parse(&edited(table, key, line), "invented.toml") {
            Ok(_) => panic!("{table} {key}: {edit}: not refused"),
            Err(error) => error.to_string(),
        };
        assert!(error.starts_with("invented.toml:"), "{error}");
        writeln!(transcript, "{table} {key}: {edit}\n{error}\n").expect("a string takes it");
    }
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../expected"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!("messages_for_bad_descriptions", transcript));
}

#[test]
fn a_long_expression_is_read_in_time_and_not_repeated_whole() {
    let terms = |count: usize| vec!["kappa*x^3"; count].join(" + sin(x)*v - ");
    let force = |terms: &str| format!("force = \"-x - 1 + A*cos(omega*t) - {terms}\"");
    let parse = |line: &str| Description::parse(&edited("[motion]", "force", line), "long.toml");
    assert!(parse(&force(&terms(4000))).is_ok());
    // Terms that are all different, where quadratic work would take minutes.
    let different: String = (0..9000).map(|k| format!("+{k}*x*v")).collect();
    assert!(parse(&force(&different[1..])).is_ok());

    let nested = format!("{}x{}", "(".repeat(20_000), ")".repeat(20_000));
    let minuses = format!("{}x", "-".repeat(40_000));
    let powers = "x^".repeat(20_000) + "2";
    let names = "abc".repeat(20_000);
    let missing = format!("{} 2 3 {}", terms(1000), terms(1000));
    let too_long = terms(20_000);
    for wrong in [&nested, &minuses, &powers, &names, &missing, &too_long] {
        let message = parse(&force(wrong)).expect_err("it is wrong").to_string();
        assert!(message.starts_with("long.toml:12: motion.force: "), "{message}");
        // Message, line, and mark.
        assert!(message.len() < 700, "{} bytes: {message}", message.len());
    }
}

#[test]
fn a_file_that_is_no_text_of_a_reasonable_size_is_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let file = folder.path().join("o.toml");
    for (content, wanted) in
        [(vec![b'#'; 2_000_000], "longer than 1000000 bytes"), (vec![0xff, 0xfe], "UTF-8")]
    {
        std::fs::write(&file, content).expect("the folder is ours");
        let error = Description::from_file(&file).expect_err("it is refused").to_string();
        assert!(error.contains(wanted), "{error}");
    }
    let error = Description::from_file(folder.path()).expect_err("a folder is no file").to_string();
    assert!(error.contains("it is a folder, not a regular file"), "{error}");
}

#[test]
fn deep_tables_neither_take_for_ever_nor_overflow_the_stack() {
    let nested = format!("zeta = {}1{}", "[".repeat(100_000), "]".repeat(100_000));
    let dotted = format!("{}a = 1", "a.".repeat(100_000));
    let inline = format!("zeta = {}1{}", "{a=".repeat(100_000), "}".repeat(100_000));
    for line in [&nested, &dotted, &inline] {
        let text = edited("[parameters]", "zeta", line);
        let message = Description::parse(&text, "deep.toml").expect_err("it is wrong").to_string();
        assert!(message.contains("nested too deeply") && message.len() < 700, "{message}");
    }
}

/// The notes on a file that is allowed.
fn notes(text: &str) -> String {
    let description = Description::parse(text, "o.toml").expect("it is allowed");
    description.notes().iter().map(|note| format!("{note}\n")).collect()
}

#[test]
fn a_restitution_above_one_or_of_zero_is_allowed_and_said() {
    let noted = |line: &str| notes(&edited("[impact]", "restitution", line));
    assert_eq!(noted("restitution = \"1\""), "");
    let notes = noted("restitution = \"1.2\"");
    assert!(notes.starts_with("o.toml:15: impact.restitution: the restitution is 1.2 at A = 0, "), "{notes}");
    let notes = noted("restitution = \"0\"");
    assert!(
        notes.contains("the restitution is 0 at A = 0, ") && notes.contains("impacts are plastic"),
        "{notes}"
    );
}

#[test]
fn what_may_not_be_meant_is_said() {
    let noted = |changes: &[(&str, &str, &str)]| {
        let text =
            changes.iter().fold(edited("[parameters]", "zeta", "zeta = 0.1"), |text, (from, to, _)| {
                assert!(text.contains(from), "{from}: {text}");
                text.replacen(from, to, 1)
            });
        let notes = notes(&text);
        for (_, _, told) in changes {
            assert!(if told.is_empty() { notes.is_empty() } else { notes.contains(told) }, "{told}: {notes}");
        }
    };
    noted(&[("zeta = 0.1", "zeta = 0.2", "")]);
    noted(&[("zeta = 0.1", "zeta = -0.1", "the sign of the damping")]);
    noted(&[("- x -", "- 1000*x -", "a natural frequency of about 31.6")]);
    noted(&[("- x - kappa*x^3", "+ x + kappa*x^3", "the sign of the spring")]);
    noted(&[("- x - kappa*x^3", "+ 0.3*x*kappa", "0.06 x at A = 0, omega = 0.4")]);
    // A beam that has buckled, and a spring that softens until it pushes away.
    noted(&[("- x -", "+ x -", "")]);
    noted(&[("- x - kappa*x^3", "- x + kappa*x^3", "")]);
    noted(&[("name = \"omega\"", "name = \"omega\"\nunit = \"Hz\"", "2*pi*omega")]);
}

#[test]
fn a_file_that_is_not_there_is_said_to_be() {
    let error = Description::from_file(Path::new("nowhere/oscillator.toml")).expect_err("there is none");
    assert!(error.to_string().starts_with("nowhere/oscillator.toml: cannot be read: "), "{error}");
}
