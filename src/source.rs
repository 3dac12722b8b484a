//! Texts and places in them. Every folder may import this file; it imports only [`crate::code`] and [`crate::suggest`].
//!
//! A [`Source`] is a file as it was read. A [`Span`] is a half-open range of bytes in it. A [`Fault`] is something
//! wrong at a span. A fault does not know its file; [`crate::Error`] adds that.

#[cfg(feature = "notes")]
mod builder;
#[cfg(feature = "notes")]
mod encoding;
#[cfg(feature = "notes")]
mod origin;
mod text;

use std::fmt;
use std::ops::Range;

use crate::code::Code;
use crate::suggest;

#[cfg(feature = "notes")]
pub(crate) use builder::Builder;
#[cfg(feature = "notes")]
pub(crate) use encoding::Encoding;
pub use text::Source;
#[cfg(feature = "notes")]
pub use text::{FileEdit, Place};

/// A half-open range of bytes in a text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    /// The first byte.
    pub start: usize,
    /// One past the last byte.
    pub end: usize,
}

impl Span {
    /// The range `start..end`.
    pub const fn new(start: usize, end: usize) -> Self {
        Span { start, end }
    }

    /// The empty range at `offset`.
    pub const fn at(offset: usize) -> Self {
        Span { start: offset, end: offset }
    }

    /// The smallest range that contains both.
    pub fn to(self, other: Span) -> Span {
        Span { start: self.start.min(other.start), end: self.end.max(other.end) }
    }

    /// The same range, moved by `offset` bytes: from a place in a part to the place in the whole.
    pub fn shifted(self, offset: usize) -> Span {
        Span { start: self.start + offset, end: self.end + offset }
    }

    /// Whether `other` lies within this range.
    pub fn contains(self, other: Span) -> bool {
        self.start <= other.start && other.end <= self.end
    }

    /// The range as a standard range, for indexing.
    pub fn range(self) -> Range<usize> {
        self.start..self.end
    }
}

impl From<Range<usize>> for Span {
    fn from(range: Range<usize>) -> Self {
        Span { start: range.start, end: range.end }
    }
}

/// Something wrong at a place in a text, and what to do about it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The class of the message.
    pub code: Code,
    /// The place.
    pub span: Span,
    /// What is wrong: a sentence without its full stop.
    pub message: String,
    /// What to do next.
    pub help: Option<String>,
    /// The name or equation that is needed and unknown, where that is the reason.
    pub missing: Option<Missing>,
}

/// Something unknown that a formula or a claim needs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Missing {
    /// A name, as LaTeX.
    Name(String),
    /// The reading of the equation with this number or label, or on this line.
    Equation(String),
}

impl Fault {
    /// A fault of the class [`Code::Syntax`], which is what a reader of text reports most.
    pub fn new(span: Span, message: impl Into<String>) -> Self {
        Fault { code: Code::Syntax, span, message: message.into(), help: None, missing: None }
    }

    /// A formula that has more than one meaning; `what` names the readings, as in `a/bc may be a/(bc) or (a/b)c`.
    pub fn ambiguous(span: Span, what: impl fmt::Display) -> Self {
        Fault::new(span, what.to_string()).code(Code::Ambiguous)
    }

    /// A notation that is well-formed and that onshell does not support.
    pub fn unsupported(span: Span, message: impl Into<String>) -> Self {
        Fault::new(span, message).code(Code::NotSupported)
    }

    /// Two shapes that cannot be equal, be added or be multiplied.
    pub fn shape(span: Span, message: impl Into<String>) -> Self {
        Fault::new(span, message).code(Code::ShapeMismatch)
    }

    /// An index that occurs too often, or free indices that differ.
    pub fn index(span: Span, message: impl Into<String>) -> Self {
        Fault::new(span, message).code(Code::IndexMismatch)
    }

    /// Something in a claims file that cannot be used.
    pub fn claims(span: Span, message: impl Into<String>) -> Self {
        Fault::new(span, message).code(Code::ClaimsFile)
    }

    /// A document that cannot be divided into prose and displays.
    pub fn notes(span: Span, message: impl Into<String>) -> Self {
        Fault::new(span, message).code(Code::NotesFile)
    }

    /// A name that is not declared, at `span`, with the advice to declare it.
    pub fn undeclared(span: Span, name: impl fmt::Display) -> Self {
        let missing = Some(Missing::Name(name.to_string()));
        let fault = Fault::new(span, format!("{name} is not declared")).code(Code::UndeclaredName);
        Fault { missing, ..fault.help(suggest::declaration(&name.to_string(), 0)) }
    }

    /// The same fault in another class.
    pub fn code(mut self, code: Code) -> Self {
        self.code = code;
        self
    }

    /// The same fault with advice.
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// The same fault, placed in the text that contains this one at `offset`.
    pub fn shifted(mut self, offset: usize) -> Self {
        self.span = self.span.shifted(offset);
        self
    }
}
