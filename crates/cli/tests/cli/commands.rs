//! Commands in messages are those of the program as it was started; what users write stays as it is.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::program::{Outcome, empty_folder, grazing};

/// Runs the program as it is started where it is installed.
fn installed(folder: &Path, arguments: &[&str]) -> Outcome {
    let mut run = Command::new(env!("CARGO_BIN_EXE_grazing"));
    let run = run.args(arguments).current_dir(folder).env_remove("GRAZING_BY_XTASK").output();
    let run = run.expect("the program starts");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("the program writes UTF-8");
    Outcome { code: run.status.code(), output: text(run.stdout), messages: text(run.stderr) }
}

#[test]
fn words_of_users_are_no_commands() {
    let folder = empty_folder();
    let name = "my cargo xtask rig {grazing}";
    let made = installed(folder.path(), &["new", "cargo xtask.toml"]);
    assert!(made.output.starts_with("cargo xtask.toml is written."), "{}", made.output);
    assert!(
        made.output.ends_with("\nNext: edit it, then grazing unfold 'cargo xtask.toml'\n"),
        "{}",
        made.output
    );
    let file = folder.path().join("cargo xtask.toml");
    let text = fs::read_to_string(&file).expect("it was written");
    assert!(text.contains("\n#   grazing unfold THIS-FILE\n") && !text.contains("{grazing}"), "{text}");
    let named = text.replace("name = \"My oscillator\"", &format!("name = \"{name}\""));
    fs::write(&file, &named).expect("the folder is ours");
    let run = ["unfold", "cargo xtask.toml", "--loops", "1", "--set", "primary.range=[0.4,0.5]"];
    let run = installed(folder.path(), &[&run[..], &["--set", "secondary.range=[0.5,0.52]"]].concat());
    assert!(run.output.contains(name), "{}{}", run.output, run.messages);
    // What is quoted in messages.
    for (line, wrong) in
        [("name = \"A\"", "name = \"my cargo xtask rig\""), ("force = ", "force = \"cargo xtask\" #")]
    {
        fs::write(&file, named.replace(line, wrong)).expect("the folder is ours");
        let run = installed(folder.path(), &["unfold", "cargo xtask.toml"]);
        assert!(
            run.code == Some(2) && run.messages.starts_with("error: cargo xtask.toml:"),
            "{}",
            run.messages
        );
        assert!(run.messages[24..].contains("cargo xtask"), "{}", run.messages);
    }
}

#[test]
fn commands_are_those_of_the_program_as_it_was_started() {
    let folder = empty_folder();
    for (run, program) in [(installed as fn(&Path, &[&str]) -> Outcome, "grazing"), (grazing, "cargo xtask")]
    {
        let none = run(folder.path(), &["claims", "eq:none"]);
        assert!(none.messages.contains(&format!("; `{program} claims` lists all\n")), "{}", none.messages);
        let help = run(folder.path(), &["new", "--help"]);
        assert!(help.output.contains(&format!("\n`{program} unfold my.toml`.")), "{}", help.output);
        // Where the program is built is the same for everybody.
        assert!(run(folder.path(), &["--help"]).output.contains("`cargo xtask` builds the program"));
    }
}
