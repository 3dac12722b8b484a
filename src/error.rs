//! The error type of the library: what is wrong, where, and what to do next.
//!
//! An [`Error`] means that something could not be checked at all (exit code 2). A wrong equation is no error; it has a
//! verdict.

use std::fmt;
use std::sync::Arc;

use crate::code::Code;
use crate::source::{Fault, Missing, Source, Span};

/// `Result` with onshell's [`Error`].
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Something that could not be done, with its place in a file where it has one.
#[derive(Clone, Debug)]
pub struct Error(Box<Inner>);

#[derive(Clone, Debug)]
struct Inner {
    code: Code,
    message: String,
    place: Option<(Arc<Source>, Span)>,
    help: Option<String>,
    missing: Option<Missing>,
}

/// The reason of a failure to read or write, as a clause: without the number that the operating system gives it.
#[cfg(feature = "notes")]
pub(crate) fn reason(error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
        std::io::ErrorKind::PermissionDenied => "permission is denied".to_owned(),
        _ => {
            let text = error.to_string();
            text.split(" (os error").next().unwrap_or(&text).to_lowercase()
        }
    }
}

impl Error {
    /// An error without a place, of the class [`Code::Input`].
    pub fn new(message: impl Into<String>) -> Self {
        let message = message.into();
        Error(Box::new(Inner { code: Code::Input, message, place: None, help: None, missing: None }))
    }

    /// An error at a place in `source`, of the class [`Code::ClaimsFile`], since most of them are in claims files.
    pub fn at(source: &Arc<Source>, span: Span, message: impl Into<String>) -> Self {
        let (message, place) = (message.into(), Some((source.clone(), span)));
        Error(Box::new(Inner { code: Code::ClaimsFile, message, place, help: None, missing: None }))
    }

    /// A fault in `source`, of the fault's own class.
    pub fn fault(source: &Arc<Source>, fault: Fault) -> Self {
        let Fault { code, span, message, help, missing } = fault;
        Error(Box::new(Inner { code, message, place: Some((source.clone(), span)), help, missing }))
    }

    /// The same error in another class.
    pub fn with_code(mut self, code: Code) -> Self {
        self.0.code = code;
        self
    }

    /// The same error with advice.
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.0.help = Some(help.into());
        self
    }

    /// The same error, with the unknown name or equation that is its reason.
    pub fn lacking(mut self, missing: Option<Missing>) -> Self {
        self.0.missing = missing;
        self
    }

    /// The class of the message.
    pub fn code(&self) -> Code {
        self.0.code
    }

    /// What is wrong.
    pub fn message(&self) -> &str {
        &self.0.message
    }

    /// The text that the error is in, and the range of bytes.
    pub fn place(&self) -> Option<(&Arc<Source>, Span)> {
        self.0.place.as_ref().map(|(source, span)| (source, *span))
    }

    /// What to do next.
    pub fn advice(&self) -> Option<&str> {
        self.0.help.as_deref()
    }

    /// The name or equation that is needed and unknown, where that is the reason.
    pub fn missing(&self) -> Option<&Missing> {
        self.0.missing.as_ref()
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((source, span)) = &self.0.place {
            let (line, column) = source.line_column(span.start);
            write!(f, "{}:{line}:{column}: ", source.path_at(span.start))?;
        }
        f.write_str(&self.0.message)?;
        if let Some(help) = &self.0.help {
            write!(f, " ({help})")?;
        }
        Ok(())
    }
}

impl std::error::Error for Error {}
