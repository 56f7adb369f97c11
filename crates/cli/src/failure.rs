//! Why the program ends without having done what it was asked to, and with which exit code.

use std::path::PathBuf;

use grazing_description::DescriptionError;
use grazing_reproduction::parameters::ParameterError;
use grazing_reproduction::published::PublishedError;
use thiserror::Error;

/// A failure, with what is printed for it: one line, and where an expression is wrong the expression with a mark.
#[derive(Debug, Error)]
pub enum Failure {
    /// Files are not what the code makes.
    #[error("{folder} is not what the code makes: {}", remedies(*.wrong, *.unexpected, mend))]
    CheckFailed {
        /// The folder of the figures.
        folder: String,
        /// How many files are missing or have another content.
        wrong: usize,
        /// How many files should not be there.
        unexpected: usize,
        /// The command that makes the missing and other ones right.
        mend: String,
    },
    /// Published values are not met.
    #[error("{off} of {all} published values not met")]
    PublishedOff {
        /// How many are not met.
        off: usize,
        /// How many there are.
        all: usize,
    },
    /// Claims of the paper do not hold.
    #[error("{failing} of {all} claims do not hold")]
    ClaimsFail {
        /// How many do not hold.
        failing: usize,
        /// How many were tested.
        all: usize,
    },
    /// The page of misprints is not what the ledger makes.
    #[error("ERRATA.md is not what the ledger makes: mend it with `cargo xtask claims --write-errata`")]
    ErrataStale,
    /// No claim fits what was asked for.
    #[error(
        "no claim fits {wanted}: labels are those of the paper, as eq:gp or th:*; `cargo xtask claims` lists all"
    )]
    NoClaim {
        /// What was asked for.
        wanted: String,
    },
    /// The parameter file is not right.
    #[error(transparent)]
    Parameters(#[from] ParameterError),
    /// The description of an oscillator is not right.
    #[error(transparent)]
    Description(#[from] DescriptionError),
    /// The value of an option is not right.
    #[error("{option} {reason}")]
    Option {
        /// The option.
        option: &'static str,
        /// Its value, and what would be right.
        reason: String,
    },
    /// Two descriptions would be unfolded into one folder.
    #[error("{} and {} would both go to {}: unfold them one by one, with --output DIR", first.display(), second.display(), folder.display())]
    SameFolder {
        /// The first of the files.
        first: PathBuf,
        /// The other.
        second: PathBuf,
        /// The folder.
        folder: PathBuf,
    },
    /// An oscillator has nothing to unfold.
    #[error("{}: {reason}", file.display())]
    NothingToUnfold {
        /// The description.
        file: PathBuf,
        /// What was seen instead, and what can be done.
        reason: String,
    },
    /// Not all of an oscillator's diagram could be found.
    #[error("{}: {missing}, as told above; everything else is written", file.display())]
    PartlyUnfolded {
        /// The description.
        file: PathBuf,
        /// What could not be located or followed.
        missing: String,
    },
    /// The analysis of an oscillator was ended by a limit or by Ctrl-C.
    #[error("{}: {met}; {outcome}", file.display())]
    Ended {
        /// The description.
        file: PathBuf,
        /// What ended it.
        met: String,
        /// What is missing.
        outcome: String,
    },
    /// What is measured or simulated contradicts a theorem.
    #[error("{}: the theorem is contradicted: {what}; everything is written", file.display())]
    Contradiction {
        /// The description.
        file: PathBuf,
        /// What is contradicted, with both values and their errors.
        what: String,
    },
    /// Not all outputs could be made.
    #[error(
        "{missing} of {all} outputs could not be made, or not wholly, as told above; everything else is written"
    )]
    PartlyMade {
        /// How many could not.
        missing: usize,
        /// How many were asked for.
        all: usize,
    },
    /// Not all of several oscillators could be unfolded.
    #[error("{failing} of {all} files failed, as told above")]
    SomeFiles {
        /// How many failed.
        failing: usize,
        /// How many there are.
        all: usize,
        /// The exit code of the first that did.
        code: u8,
    },
    /// There is no default parameter file.
    #[error(
        "no figures/parameters.toml in this folder or in one above: run this inside a clone of the repository, or name \
         the files with --parameters FILE and, where files are written or checked, --output DIR"
    )]
    NoProject,
    /// The output folder cannot be written.
    #[error("{}: cannot be written: {reason}; name a folder for the outputs with --output DIR", path.display())]
    Unwritable {
        /// The folder or file.
        path: PathBuf,
        /// What stands in the way.
        reason: String,
    },
    /// Something other than a regular file is where a file is to be written.
    #[error("{}: is {what}, not a regular file, and is not replaced: move it away, or name another place with --output", path.display())]
    NotRegular {
        /// The place of the file.
        path: PathBuf,
        /// What is there.
        what: &'static str,
    },
    /// Results could not be told.
    #[error("standard output cannot be written: {reason}")]
    Untold {
        /// What the system says.
        reason: std::io::Error,
    },
    /// Other formats or widths than the default ones were to go to the default folder.
    #[error(
        "{folder} holds SVG at the paper's widths only: leave --output out, or name another folder, for other formats \
         and widths"
    )]
    DefaultFolder {
        /// The default folder.
        folder: String,
    },
    /// The page of the report cannot be written.
    #[error("{}: cannot be written: {reason}; name another file for the page with --output FILE", path.display())]
    UnwritablePage {
        /// The file, or the folder it should stand in.
        path: PathBuf,
        /// What stands in the way.
        reason: String,
    },
    /// The threads could not be started.
    #[error("{jobs} threads could not be started: {reason}")]
    Threads {
        /// How many were asked for.
        jobs: u16,
        /// What the system says.
        reason: String,
    },
    /// The computation failed.
    #[error("{what}: {reason}")]
    Computation {
        /// The output that was being computed.
        what: &'static str,
        /// What went wrong.
        reason: String,
    },
    /// The computation made other tables than the registry of outputs says.
    #[error("{output}: the tables {made:?} were made, the registry of outputs says {registered:?}")]
    Registry {
        /// The output.
        output: &'static str,
        /// The tables that were made.
        made: Vec<&'static str>,
        /// The tables that should have been.
        registered: Vec<&'static str>,
    },
    /// The list of published values is not right, or does not fit the computed ones.
    #[error(transparent)]
    Published(#[from] PublishedError),
    /// A file could not be read or written although the folder seemed fine.
    #[error("{}: {reason}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the system says.
        reason: std::io::Error,
    },
}

impl Failure {
    /// The exit code: 1 a check failed, 2 bad input, 3 the computation failed, 4 a file could not be read or written.
    pub fn exit_code(&self) -> u8 {
        match self {
            Failure::CheckFailed { .. }
            | Failure::PublishedOff { .. }
            | Failure::ClaimsFail { .. }
            | Failure::Contradiction { .. }
            | Failure::ErrataStale => 1,
            Failure::Parameters(ParameterError::Malformed(_))
            | Failure::Description(_)
            | Failure::SameFolder { .. }
            | Failure::Option { .. }
            | Failure::NoProject
            | Failure::NoClaim { .. }
            | Failure::Unwritable { .. }
            | Failure::DefaultFolder { .. }
            | Failure::UnwritablePage { .. }
            | Failure::Threads { .. } => 2,
            Failure::Computation { .. }
            | Failure::NothingToUnfold { .. }
            | Failure::PartlyUnfolded { .. }
            | Failure::Ended { .. }
            | Failure::Parameters(ParameterError::Unfit(_))
            | Failure::PartlyMade { .. }
            | Failure::Registry { .. }
            | Failure::Published(_) => 3,
            Failure::File { .. } | Failure::NotRegular { .. } | Failure::Untold { .. } => 4,
            Failure::SomeFiles { code, .. } => *code,
        }
    }
}

/// What has to be done about files that are wrong and files that should not be there.
fn remedies(wrong: usize, unexpected: usize, mend: &str) -> String {
    let files = |count: usize| {
        if count == 1 { "1 file".to_owned() } else { format!("{count} files") }
    };
    let mut remedies = Vec::new();
    if wrong > 0 {
        remedies.push(format!("mend {} with `{mend}`", files(wrong)));
    }
    if unexpected > 0 {
        remedies.push(format!("remove {} that it does not make", files(unexpected)));
    }
    remedies.join(", ")
}
