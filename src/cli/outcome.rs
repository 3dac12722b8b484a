//! What a command prints and returns, and how it is written: nothing else here writes a report.

use std::io::Write;
use std::process::ExitCode;

use clap::ValueEnum;

use crate::Error;
use crate::code::Code;
use crate::report::{self, Style};

/// The form of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// For people
    Text,
    /// For programs
    Json,
}

/// How the two streams of the program are drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Screen {
    /// Standard output.
    pub out: Style,
    /// Standard error.
    pub err: Style,
}

/// What a command prints and returns.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Outcome {
    /// For standard output.
    pub output: String,
    /// For standard error.
    pub messages: String,
    /// The exit code.
    pub code: u8,
}

impl Outcome {
    /// A command that did what it should.
    pub fn done(output: String) -> Outcome {
        Outcome { output, ..Outcome::default() }
    }

    /// A command that ended with an error: told to people on standard error, and to machines on standard output.
    pub fn failed(error: &Error, format: Format, screen: Screen) -> Outcome {
        let output = match format {
            Format::Text => String::new(),
            Format::Json => format!("{:#}\n", report::json::failure(error)),
        };
        Outcome { output, messages: shown(std::slice::from_ref(error), screen), code: 2 }
    }

    /// Writes all of it, and gives the exit code: 2 if any of it is lost.
    ///
    /// A pipe that is closed early and a disk that is full lose output. The first needs no message: its reader left.
    pub fn write(self, mut out: impl Write, mut err: impl Write) -> ExitCode {
        let written = out.write_all(self.output.as_bytes()).and_then(|()| out.flush());
        let told = err.write_all(self.messages.as_bytes()).and_then(|()| err.flush());
        let code = match (&written, told) {
            (Ok(()), Ok(())) => self.code,
            _ => 2,
        };
        if let Err(error) = written
            && error.kind() != std::io::ErrorKind::BrokenPipe
        {
            // If this is lost as well, the exit code says it.
            let _ = writeln!(err, "error: cannot write the output: {error}");
        }
        ExitCode::from(code)
    }
}

/// Errors as diagnostics, and how to look up the code of the first.
pub(super) fn shown(errors: &[Error], screen: Screen) -> String {
    let mut text: String = errors.iter().map(|error| report::diagnostic::error(error, screen.err) + "\n\n").collect();
    // Of a file or an argument that cannot be used, the message says all.
    let says_more = |error: &&Error| !matches!(error.code(), Code::Input | Code::Json | Code::ClaimsFile);
    if let Some(first) = errors.iter().find(says_more) {
        text.push_str(&report::text::code_hint(report::code::of_error(first), screen.err));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A stream that takes nothing.
    struct Full(std::io::ErrorKind);

    impl Write for Full {
        fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
            Err(self.0.into())
        }

        fn flush(&mut self) -> std::io::Result<()> {
            Err(self.0.into())
        }
    }

    fn exit(code: ExitCode) -> String {
        format!("{code:?}")
    }

    #[test]
    fn lost_output_is_exit_code_two() {
        let outcome = || Outcome::done("a report".to_owned());
        let mut said = Vec::new();
        assert_eq!(exit(outcome().write(Vec::new(), &mut said)), exit(ExitCode::from(0)));
        assert_eq!(exit(outcome().write(Full(std::io::ErrorKind::BrokenPipe), &mut said)), exit(ExitCode::from(2)));
        assert!(said.is_empty());
        assert_eq!(exit(outcome().write(Full(std::io::ErrorKind::StorageFull), &mut said)), exit(ExitCode::from(2)));
        assert!(String::from_utf8_lossy(&said).starts_with("error: cannot write the output: "));
        let lost = outcome().write(Vec::new(), Full(std::io::ErrorKind::StorageFull));
        assert_eq!(exit(lost), exit(ExitCode::from(2)));
    }
}
