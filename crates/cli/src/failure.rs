//! Failures of the program, with their messages and exit codes.

use std::error::Error;
use std::fmt::{self, Display};
use std::path::Path;

use grazing_input::{DescriptionError, SettingError};
use grazing_measured::MeasurementError;
use grazing_reproduction::StudyError;
use grazing_reproduction::parameters::ParameterError;

/// The exit code where a computation is incomplete.
pub(crate) const INCOMPLETE: u8 = 3;

/// A failure with its message: one line, and for a wrong expression the expression with a mark.
#[derive(Debug)]
pub struct Failure {
    code: u8,
    /// The output that was being computed, which is printed first.
    output: Option<&'static str>,
    /// The reason, which is printed after the output.
    pub(crate) reason: String,
}

impl Failure {
    /// A failure with this exit code.
    pub(crate) fn new(code: u8, reason: impl Into<String>) -> Self {
        Self { code, output: None, reason: reason.into() }
    }

    /// The failure of a check.
    pub(crate) fn check(reason: impl Into<String>) -> Self {
        Self::new(1, reason)
    }

    /// The failure of bad input, after which nothing was done.
    pub(crate) fn input(reason: impl Into<String>) -> Self {
        Self::new(2, reason)
    }

    /// The failure of a computation that is incomplete.
    pub(crate) fn incomplete(reason: impl Into<String>) -> Self {
        Self::new(INCOMPLETE, reason)
    }

    /// The failure to compute an output.
    pub(crate) fn output(output: &'static str, reason: String) -> Self {
        Self { output: Some(output), ..Self::incomplete(reason) }
    }

    /// The failure to read or write a file or a stream.
    pub(crate) fn unwritten(reason: impl Into<String>) -> Self {
        Self::new(4, reason)
    }

    /// The failure to read or write a file although its folder passed the checks.
    pub(crate) fn file(path: &Path, reason: &std::io::Error) -> Self {
        let path = path.display();
        if reason.kind() == std::io::ErrorKind::FileTooLarge {
            let limit = "the file would be larger than the system allows (ulimit -f)";
            return Self::incomplete(format!("{path}: {limit}"));
        }
        Self::unwritten(format!("{path}: {reason}"))
    }

    /// The same failure, with what was done in spite of it.
    pub(crate) fn but(self, done: &str) -> Self {
        Self { reason: format!("{}; {done}", self.reason), ..self }
    }

    /// The failure of some outputs, or their incompleteness.
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

/// Errors that are bad input, whatever it is.
macro_rules! input {
    ($($error:ty),+) => {$(
        impl From<$error> for Failure {
            fn from(error: $error) -> Self {
                Self::input(error.to_string())
            }
        }
    )+};
}

input!(DescriptionError, MeasurementError, SettingError);

/// The failure of a computation, with the error and any causes that its message does not contain; a
/// wrong section of the parameter file has a failure of its own.
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
