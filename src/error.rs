//! The one error type: what is wrong, where, and what to do next.
//!
//! An [`Error`] means that something could not be checked at all (exit code 2); a wrong equation is not an error but
//! a verdict.

use std::fmt;
use std::sync::Arc;

use crate::source::{Fault, Missing, Source, Span};

/// `Result` with onshell's [`Error`].
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Something that could not be done, with its place in a file where it has one.
#[derive(Clone, Debug)]
pub struct Error(Box<Inner>);

#[derive(Clone, Debug)]
struct Inner {
    message: String,
    place: Option<(Arc<Source>, Span)>,
    help: Option<String>,
    missing: Option<Missing>,
}

impl Error {
    /// An error that is not about a place in a text.
    pub fn new(message: impl Into<String>) -> Self {
        Error(Box::new(Inner { message: message.into(), place: None, help: None, missing: None }))
    }

    /// An error at a place in `source`.
    pub fn at(source: &Arc<Source>, span: Span, message: impl Into<String>) -> Self {
        let place = Some((source.clone(), span));
        Error(Box::new(Inner { message: message.into(), place, help: None, missing: None }))
    }

    /// A fault, now that its text is known.
    pub fn fault(source: &Arc<Source>, fault: Fault) -> Self {
        let Fault { span, message, help, missing } = fault;
        Error(Box::new(Inner { message, place: Some((source.clone(), span)), help, missing }))
    }

    /// The same error with advice.
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.0.help = Some(help.into());
        self
    }

    /// The same error, for want of this.
    pub fn lacking(mut self, missing: Option<Missing>) -> Self {
        self.0.missing = missing;
        self
    }

    /// What is wrong.
    pub fn message(&self) -> &str {
        &self.0.message
    }

    /// The text and the range in it that the error is about.
    pub fn place(&self) -> Option<(&Arc<Source>, Span)> {
        self.0.place.as_ref().map(|(source, span)| (source, *span))
    }

    /// What to do next.
    pub fn advice(&self) -> Option<&str> {
        self.0.help.as_deref()
    }

    /// What is wanted and not known, if it is that which is wrong.
    pub fn missing(&self) -> Option<&Missing> {
        self.0.missing.as_ref()
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((source, span)) = &self.0.place {
            let (line, column) = source.line_column(span.start);
            write!(f, "{}:{line}:{column}: ", source.path)?;
        }
        f.write_str(&self.0.message)?;
        if let Some(help) = &self.0.help {
            write!(f, " ({help})")?;
        }
        Ok(())
    }
}

impl std::error::Error for Error {}
