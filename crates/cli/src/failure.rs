//! Why the program ends without having done what it was asked to, and with which exit code.

use std::error::Error;
use std::fmt::{self, Display};
use std::path::Path;

use grazing_description::DescriptionError;
use grazing_reproduction::StudyError;
use grazing_reproduction::parameters::ParameterError;
use grazing_source::SettingError;

/// A failure, with what is printed for it: one line, and where an expression is wrong the
/// expression with a mark.
#[derive(Debug)]
pub struct Failure {
    code: u8,
    /// What was being computed.
    output: Option<&'static str>,
    /// What is printed after that.
    pub(crate) reason: String,
}

impl Failure {
    /// With this exit code.
    pub(crate) fn new(code: u8, reason: impl Into<String>) -> Self {
        Self { code, output: None, reason: reason.into() }
    }

    /// A check failed.
    pub(crate) fn check(reason: impl Into<String>) -> Self {
        Self::new(1, reason)
    }

    /// Something that was given is wrong, and nothing was done.
    pub(crate) fn input(reason: impl Into<String>) -> Self {
        Self::new(2, reason)
    }

    /// Not everything could be computed.
    pub(crate) fn incomplete(reason: impl Into<String>) -> Self {
        Self::new(3, reason)
    }

    /// An output could not be computed.
    pub(crate) fn output(output: &'static str, reason: String) -> Self {
        Self { output: Some(output), ..Self::incomplete(reason) }
    }

    /// A file or a stream could not be read or written.
    pub(crate) fn unwritten(reason: impl Into<String>) -> Self {
        Self::new(4, reason)
    }

    /// A file could not be read or written although the folder seemed fine.
    pub(crate) fn file(path: &Path, reason: &std::io::Error) -> Self {
        Self::unwritten(format!("{}: {reason}", path.display()))
    }

    /// Some outputs failed or are incomplete.
    pub(crate) fn partial(missing: usize, all: usize) -> Self {
        Self::incomplete(format!(
            "{missing} of {all} outputs failed or are incomplete, see above; everything else is written"
        ))
    }

    /// The exit code: 1 a check failed, 2 bad input, 3 the computation failed, 4 a file could not
    /// be read or written.
    pub fn exit_code(&self) -> u8 {
        self.code
    }
}

impl Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.output {
            Some(output) => write!(formatter, "{output}: {}", self.reason),
            None => formatter.write_str(&self.reason),
        }
    }
}

impl From<ParameterError> for Failure {
    fn from(error: ParameterError) -> Self {
        match error {
            ParameterError::Malformed(_) => Self::input(error.to_string()),
            ParameterError::Unfit(_) => Self::incomplete(error.to_string()),
        }
    }
}

impl From<DescriptionError> for Failure {
    fn from(error: DescriptionError) -> Self {
        Self::input(error.to_string())
    }
}

impl From<SettingError> for Failure {
    fn from(error: SettingError) -> Self {
        Self::input(error.to_string())
    }
}

/// The failure of a computation, with the error and those of its causes that its message does not
/// contain; that of a section of the parameter file if it is one.
pub(crate) fn computation(what: &'static str, error: &(dyn Error + 'static)) -> Failure {
    if let Some(StudyError::Parameters(error)) = error.downcast_ref() {
        return error.clone().into();
    }
    let mut reason = error.to_string();
    let mut cause = error.source();
    while let Some(deeper) = cause {
        let shown = deeper.to_string();
        if !reason.contains(&shown) {
            reason.push_str(&format!(": {shown}"));
        }
        cause = deeper.source();
    }
    Failure::output(what, reason)
}
