//! Generates the table of checks from the ledger: a check is a function that a claim names.

use std::collections::BTreeSet;
use std::path::Path;
use std::{env, fs};

const LEDGER: &str = "../../expected/claims.toml";

fn main() {
    println!("cargo::rerun-if-changed={LEDGER}");
    let ledger = fs::read_to_string(LEDGER).expect("the ledger of the project");
    let named = |line: &'_ str| Some(line.strip_prefix("check = \"")?.strip_suffix('"')?.to_owned());
    let names: BTreeSet<String> = ledger.lines().filter_map(named).collect();
    let rows: Vec<String> =
        names.iter().map(|name| format!("Check {{ name: {name:?}, run: {name} }},\n")).collect();
    let folder = env::var_os("OUT_DIR").expect("cargo says where to write");
    fs::write(Path::new(&folder).join("checks.rs"), format!("&[\n{}]\n", rows.concat()))
        .expect("the folder can be written to");
}
