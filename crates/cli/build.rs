//! Computes the digest of everything that the numbers of a family depend on, so that parts computed
//! by other builds of the program are not merged.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs, io};

use sha2::{Digest, Sha256};

/// The crates whose sources enter the digest, with the versions of their libraries and of the compiler.
const CRATES: [&str; 8] =
    ["beyond", "continuation", "input", "model", "reproduction", "results", "theorems", "unfold"];
const LOCK: &str = "Cargo.lock";
/// The number of leading hexadecimal digits of the digest that tell builds apart.
const DIGITS: usize = 16;

fn main() -> io::Result<()> {
    let root = Path::new("../..");
    let mut paths = vec![PathBuf::from(LOCK)];
    for name in CRATES {
        let folder = Path::new("crates").join(name).join("src");
        // Cargo watches everything in a folder.
        println!("cargo::rerun-if-changed={}", root.join(&folder).display());
        collect(root, &folder, &mut paths)?;
    }
    paths.sort();
    let compiler = compiler()?;
    let mut digest = Sha256::new();
    digest.update(&compiler);
    for path in &paths {
        let content = fs::read(root.join(path))?;
        let name: Vec<_> = path.components().map(|part| part.as_os_str().to_string_lossy()).collect();
        digest.update(format!("{} {}\n", name.join("/"), content.len()));
        digest.update(content);
    }
    println!("cargo::rerun-if-changed={}", root.join(LOCK).display());
    println!("cargo::rustc-env=GRAZING_COMPILER={compiler}");
    let digits: String = digest.finalize().iter().map(|byte| format!("{byte:02x}")).collect();
    println!("cargo::rustc-env=GRAZING_SOURCE={}", &digits[..DIGITS]);
    Ok(())
}

/// The version of the compiler: the second word of `rustc 1.95.0 (…)`.
fn compiler() -> io::Result<String> {
    let compiler = env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let said = Command::new(compiler).arg("--version").output()?.stdout;
    let version = String::from_utf8_lossy(&said).split(' ').nth(1).map(str::to_owned);
    version.ok_or_else(|| io::Error::other("the compiler does not say its version"))
}

/// Adds all files in a folder, by path from the root.
fn collect(root: &Path, folder: &Path, paths: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(root.join(folder))? {
        let entry = entry?;
        let path = folder.join(entry.file_name());
        if entry.file_type()?.is_dir() { collect(root, &path, paths)? } else { paths.push(path) }
    }
    Ok(())
}
