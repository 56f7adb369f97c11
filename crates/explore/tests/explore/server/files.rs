//! The files of the page, with a server and without one.

use grazing_continuation::bifurcation::Bifurcation;
use std::fs;
use std::path::Path;

use grazing_explore::alone;

use super::running::{LIMITS, Running};

/// The files in a folder of the crate, with their texts.
fn texts(folder: &str) -> Vec<(String, String)> {
    let folder = fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)).unwrap();
    let text = |entry: fs::DirEntry| {
        (entry.file_name().into_string().unwrap(), fs::read_to_string(entry.path()).unwrap())
    };
    folder.map(|entry| text(entry.unwrap())).collect()
}

#[test]
fn all_files_of_the_page_are_served_and_all_that_these_load_is_there() {
    let server = Running::new(LIMITS);
    let is_served = |name: &str| server.get(&format!("{}{name}", server.path)) == 200;
    let (page, own) = (texts("page"), texts("alone"));
    let alone: Vec<(&str, Vec<u8>)> = alone("grazing", &[]);
    let is_alone = |wanted: &str| alone.iter().any(|(name, _)| *name == wanted);
    assert!(page.len() > 20 && own.len() > 1);
    for (name, _) in &page {
        assert!(is_served(name) && is_alone(name), "{name}");
    }
    for (name, text) in &own {
        // They replace those of the page with a server.
        let content = alone.iter().find(|(alone, _)| alone == name).map(|(_, content)| content.as_slice());
        assert_eq!(content, Some(text.as_bytes()), "{name}");
    }
    for (name, text) in page.iter().chain(&own) {
        let quoted = text.split(['"', '\'']).skip(1).step_by(2);
        let loaded = |text: &str| {
            let file = text.strip_prefix("./").unwrap_or(text);
            [".js", ".css", ".ttf"].iter().any(|ending| file.ends_with(ending)) && !file.contains([' ', '*'])
        };
        for loaded in quoted.filter(|text| loaded(text)) {
            let loaded = loaded.strip_prefix("./").unwrap_or(loaded);
            let served = own.iter().any(|(own, _)| own == name) || is_served(loaded);
            assert!(served && is_alone(loaded), "{name}: {loaded}");
        }
        // The content policy forbids these anyway.
        for foreign in ["https://", "//cdn", "eval(", "innerHTML"] {
            assert!(!text.contains(foreign), "{name}: {foreign}");
        }
    }
}

#[test]
fn kinds_of_curves_are_listed_by_the_program_alone() {
    let files: Vec<(&str, String)> = alone("grazing", &[])
        .into_iter()
        .filter_map(|(name, content)| Some((name, String::from_utf8(content).ok()?)))
        .collect();
    let (_, kinds) = files.iter().find(|(name, _)| *name == "kinds.js").expect("it is there");
    let quoted = |kind: Bifurcation| format!("\"{}\"", kind.name());
    let all = Bifurcation::ALL.map(quoted).join(",");
    assert!(kinds.starts_with(&format!("export const KINDS = [{all}];")), "{kinds}");
    for kind in Bifurcation::ALL {
        assert!(
            kinds.contains(&format!("\"legend\":\"{}", kind.name().replace("graz", "grazing"))),
            "{kinds}"
        );
    }
    // A part that asks for one kind may name it, but nothing names those that only a list would.
    for (name, text) in files.iter().filter(|(name, _)| *name != "kinds.js") {
        let listed = [Bifurcation::Torus, Bifurcation::Pitchfork].map(|kind| {
            text.split(|letter: char| !letter.is_ascii_alphanumeric()).any(|word| word == kind.name())
        });
        assert_eq!(listed, [false; 2], "{name}");
    }
}
