//! `grazing archive`: one file with all results, and with a description of each part.

use std::collections::BTreeMap;
use std::fs;
use std::io::Read;
use std::path::Path;

use crate::program::{digest, empty_folder, grazing, narrow_linear, repository};
use serde_json::Value;

/// The files of a tar by path.
fn unpacked(file: &Path) -> BTreeMap<String, Vec<u8>> {
    let content = fs::read(file).expect("it was written");
    let mut tar = tar::Archive::new(content.as_slice());
    let read = |entry: std::io::Result<tar::Entry<'_, &[u8]>>| {
        let mut entry = entry.expect("it is a tar");
        let path = entry.path().expect("it has one").display().to_string();
        let mut content = Vec::new();
        entry.read_to_end(&mut content).expect("it is whole");
        (path, content)
    };
    tar.entries().expect("it is a tar").map(read).collect()
}

/// Asserts that every file but the two generated ones has its digest and its description; returns
/// the descriptions.
fn assert_described(files: &BTreeMap<String, Vec<u8>>, name: &str) -> Vec<Value> {
    let text = |path: &str| String::from_utf8(files[&format!("{name}/{path}")].clone()).expect("it is text");
    let digests = text("manifest.sha256");
    let told: Value = serde_json::from_str(&text("ro-crate-metadata.json")).expect("it is JSON");
    let graph = told["@graph"].as_array().expect("it is a list").clone();
    for (path, content) in files {
        let path = path.strip_prefix(&format!("{name}/")).expect("all lie in a folder");
        if path == "manifest.sha256" {
            continue;
        }
        assert!(digests.contains(&format!("{}  {path}\n", digest(content))), "{path}");
        let entity = graph.iter().find(|entity| entity["@id"] == path).expect("it is described");
        if path != "ro-crate-metadata.json" {
            assert_eq!(entity["sha256"], digest(content), "{path}");
            assert_eq!(entity["contentSize"], content.len().to_string(), "{path}");
        }
    }
    graph
}

#[test]
fn the_papers_archive_has_everything_and_the_same_bytes_each_time() {
    let folder = empty_folder();
    let [first, second] = ["a", "b"].map(|name| {
        let output = folder.path().join(name).join("paper.tar").display().to_string();
        let made = grazing(&repository(), &["archive", "--date", "2027-01-31", "--output", &output]);
        assert_eq!(made.code, Some(0), "{}", made.messages);
        output
    });
    assert!(fs::read(&first).expect("it is there") == fs::read(&second).expect("it is there"));
    let files = unpacked(Path::new(&first));
    let graph = assert_described(&files, "paper");
    for path in [
        "figures/fig07.svg",
        "figures/data/fig07_curves.csv",
        "figures/parameters.toml",
        "expected/certificate/rows.csv",
    ] {
        assert_eq!(
            files[&format!("paper/{path}")],
            fs::read(repository().join(path)).expect("it is there"),
            "{path}"
        );
    }
    let entity = |id: &str| graph.iter().find(|entity| entity["@id"] == id).expect("it is described");
    assert_eq!(entity("figures/fig07.svg")["name"], "Figure 7: two-parameter bifurcation diagram");
    assert_eq!(entity("./")["datePublished"], "2027-01-31");
    let run = entity("#run").to_string();
    assert!(
        run.contains("figures/parameters.toml") && run.contains("figures/data/coefficients.csv"),
        "{run}"
    );
}

#[test]
fn results_of_ones_own_are_packed_if_they_are_whole() {
    let folder = empty_folder();
    fs::write(folder.path().join("my.toml"), narrow_linear()).expect("the folder is ours");
    assert_eq!(grazing(folder.path(), &["unfold", "my.toml"]).code, Some(0));
    let command = ["archive", "--date", "2027-01-31", "--output", "my.tar", "unfolded/my", "my.toml"];
    let made = grazing(folder.path(), &command);
    assert_eq!(made.code, Some(0), "{}", made.messages);
    let files = unpacked(&folder.path().join("my.tar"));
    let graph = assert_described(&files, "my");
    assert!(files.contains_key("my/my.toml") && files.contains_key("my/my/data/coefficients.csv"));
    assert!(graph.iter().all(|entity| entity.get("license").is_none()), "nobody gave one");
    // A table that was changed by hand differs from the list.
    let table = folder.path().join("unfolded/my/data/coefficients.csv");
    fs::write(table, "p,n\n").expect("the folder is ours");
    let refused = grazing(folder.path(), &command);
    assert_eq!(refused.code, Some(2), "{}", refused.messages);
    assert!(refused.errors().contains("1 of 14 files differ from those"), "{}", refused.messages);
    for bad in [
        &["archive"][..],
        &["archive", "--date", "31.1.2027", "my.toml"],
        &["archive", "--date", "2027-01-31"],
    ] {
        let refused = grazing(folder.path(), bad);
        assert_eq!(refused.code, Some(2), "{}", refused.messages);
    }
}
