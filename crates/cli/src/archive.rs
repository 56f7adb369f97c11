//! `grazing archive`: results and what they were made from in one file, for an archive.

use std::fs;
use std::path::{Path, PathBuf};

use grazing_report::FileDigest;
use serde_json::{Value, json};
use tar::{Builder, Header};

use crate::arguments::ArchiveArguments;
use crate::failure::Failure;
use crate::folder::{self, MOST_BYTES, OutputFile, with_slashes};
use crate::{codecheck, outputs, project, terminal, versions};

/// The files and folders of a clone that an archive of the paper's results contains, from its root.
const OF_THE_PAPER: [&str; 9] = [
    "CITATION.cff",
    "LICENSE-APACHE",
    "LICENSE-MIT",
    "README.md",
    "codecheck.yml",
    "docs",
    "examples",
    "expected",
    "figures",
];
/// The licence of the files of a clone.
const LICENCE: &str = "MIT OR Apache-2.0";
/// The file that describes all the others.
const DESCRIPTION: &str = "ro-crate-metadata.json";
/// The modification time of all files, 1 January 1980 in seconds: the archive does not depend on
/// when they were written.
const TIME: u64 = 315_532_800;

/// Collects files, describes them and packs them into one archive.
///
/// # Errors
/// A file cannot be read, results are incomplete, or the archive cannot be written.
pub(crate) fn run(arguments: &ArchiveArguments) -> Result<(), Failure> {
    let of_the_paper = arguments.paths.is_empty();
    let mut files = Vec::new();
    if of_the_paper {
        let root = project::root().ok_or_else(|| {
            Failure::input("this is not a clone of the repository: name the files and folders to archive")
        })?;
        OF_THE_PAPER.iter().try_for_each(|path| collect(&root.join(path), Path::new(path), &mut files))?;
    }
    for path in &arguments.paths {
        let name = path
            .file_name()
            .ok_or_else(|| Failure::input(format!("{}: this path has no file name", path.display())))?;
        collect(path, Path::new(name), &mut files)?;
    }
    files.sort_by(|a, b| a.path.cmp(&b.path));
    if let Some(pair) = files.windows(2).find(|pair| pair[0].path == pair[1].path) {
        return Err(Failure::input(format!("{}: two files have this name", pair[0].path.display())));
    }
    let output = arguments
        .output
        .clone()
        .unwrap_or_else(|| PathBuf::from(concat!("grazing-", env!("CARGO_PKG_VERSION"), ".tar")));
    let name = output.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let licence = arguments.licence.as_deref().or(of_the_paper.then_some(LICENCE));
    files.push(description(&files, &name, &arguments.date, licence, of_the_paper));
    files.push(folder::list(&files, false));
    let content = packed(&name, &files).map_err(|reason| Failure::file(&output, &reason))?;
    let (folder, path) = (output.parent().unwrap_or(Path::new("")), output.file_name().unwrap_or_default());
    let size = content.len() as f64 / 1e6;
    folder::write(folder, &[OutputFile { path: path.into(), content }])?;
    terminal::say(&format!("{}: {} files, {size:.1} MB\n", output.display(), files.len()));
    Ok(())
}

/// Adds a file, or all regular files of a folder except hidden and unfinished ones.
fn collect(path: &Path, name: &Path, files: &mut Vec<OutputFile>) -> Result<(), Failure> {
    let unreadable = |reason| Failure::file(path, &reason);
    if !path.is_dir() {
        let content = folder::read(path).map_err(unreadable)?;
        files.push(OutputFile { path: name.to_owned(), content });
        let bytes: usize = files.iter().map(|file| file.content.len()).sum();
        return match bytes as u64 > MOST_BYTES {
            true => Err(Failure::input(format!(
                "{}: with this file the archive is larger than a gigabyte",
                path.display()
            ))),
            false => Ok(()),
        };
    }
    folder::refuse_mixture(path)?;
    for entry in fs::read_dir(path).map_err(unreadable)? {
        let entry = entry.map_err(unreadable)?;
        let (of, kind) = (entry.file_name(), entry.file_type().map_err(unreadable)?);
        let is_left_out = of.to_string_lossy().starts_with('.') || of == "unfinished";
        if !is_left_out && (kind.is_dir() || kind.is_file()) {
            collect(&entry.path(), &name.join(of), files)?;
        }
    }
    Ok(())
}

/// The description of the files in RO-Crate 1.1 (<https://w3id.org/ro/crate/1.1>).
fn description(
    files: &[OutputFile],
    name: &str,
    date: &str,
    licence: Option<&str>,
    of_the_paper: bool,
) -> OutputFile {
    let reference = |id: &str| json!({ "@id": id });
    let (mut all, mut inputs, mut results) = (Vec::new(), Vec::new(), Vec::new());
    let described: Vec<Value> = files
        .iter()
        .map(|file| {
            let FileDigest { path, bytes, sha256 } = FileDigest::of(with_slashes(&file.path), &file.content);
            all.push(reference(&path));
            match file.path.extension().and_then(|ending| ending.to_str()) {
                // Beside the parameters and descriptions there is the book's configuration.
                Some("toml") if !(of_the_paper && file.path.starts_with("docs")) => {
                    inputs.push(reference(&path));
                }
                Some("svg" | "csv" | "pdf" | "png" | "html" | "tex") => results.push(reference(&path)),
                _ => {}
            }
            json!({
                "@id": path,
                "@type": "File",
                "name": title(&file.path, of_the_paper).unwrap_or_else(|| path.clone()),
                "encodingFormat": media_type(&file.path),
                "contentSize": bytes.to_string(),
                "sha256": sha256,
            })
        })
        .collect();
    let about = match of_the_paper {
        true => {
            format!("Every figure, table and number of \"{}\", recomputed, with the checks", codecheck::TITLE)
        }
        false => "Resonant grazing bifurcations of oscillators, and the files that describe these".to_owned(),
    };
    let mut dataset = json!({
        "@id": "./",
        "@type": "Dataset",
        "name": name,
        "description": about,
        "datePublished": date,
        "hasPart": all,
        "mentions": reference("#run"),
    });
    if let Some(licence) = licence {
        dataset["license"] = licence.into();
    }
    if of_the_paper {
        dataset["isBasedOn"] = reference(codecheck::REFERENCE);
    }
    let mut graph = vec![
        json!({
            "@id": DESCRIPTION,
            "@type": "CreativeWork",
            "about": reference("./"),
            "conformsTo": reference("https://w3id.org/ro/crate/1.1"),
        }),
        dataset,
        json!({
            "@id": "#grazing",
            "@type": "SoftwareApplication",
            "name": "grazing",
            "softwareVersion": versions::program(),
        }),
        json!({
            "@id": "#run",
            "@type": "CreateAction",
            "name": "Computed by grazing",
            "instrument": reference("#grazing"),
            "object": inputs,
            "result": results,
        }),
    ];
    if of_the_paper {
        let authors = codecheck::AUTHORS.map(|name| json!({ "@type": "Person", "name": name }));
        graph.push(json!({
            "@id": codecheck::REFERENCE,
            "@type": "ScholarlyArticle",
            "name": codecheck::TITLE,
            "author": authors,
        }));
    }
    graph.extend(described);
    let text = json!({ "@context": "https://w3id.org/ro/crate/1.1/context", "@graph": graph });
    OutputFile { path: DESCRIPTION.into(), content: format!("{text:#}\n").into_bytes() }
}

/// The title of the paper's output that a file belongs to, if it is one of its files.
fn title(path: &Path, of_the_paper: bool) -> Option<String> {
    let within = path.strip_prefix(project::FIGURES).ok().filter(|_| of_the_paper)?;
    let edition = outputs::edition::Edition::default();
    let output =
        outputs::ALL.iter().find(|output| output.paths(&edition).iter().any(|found| found == within))?;
    Some(output.title.to_string())
}

/// The media type of a file by its ending.
fn media_type(path: &Path) -> &'static str {
    match path.extension().and_then(|ending| ending.to_str()) {
        Some("svg") => "image/svg+xml",
        Some("png") => "image/png",
        Some("webp") => "image/webp",
        Some("pdf") => "application/pdf",
        Some("csv") => "text/csv",
        Some("html") => "text/html",
        Some("md") => "text/markdown",
        Some("toml") => "application/toml",
        Some("yml" | "cff") => "application/yaml",
        _ => "text/plain",
    }
}

/// The tar archive, with all files in one folder.
fn packed(folder: &str, files: &[OutputFile]) -> std::io::Result<Vec<u8>> {
    let mut tar = Builder::new(Vec::new());
    for file in files {
        let mut header = Header::new_gnu();
        header.set_size(file.content.len() as u64);
        header.set_mode(0o644);
        header.set_mtime(TIME);
        tar.append_data(&mut header, PathBuf::from(folder).join(&file.path), file.content.as_slice())?;
    }
    tar.into_inner()
}
