//! Texts and places in them: the ground floor that every room may use.
//!
//! A [`Source`] is a file as read, a [`Span`] is a half-open byte range in one, and a [`Fault`] is something wrong
//! at a span. A fault does not know which file it is in; [`crate::Error`] adds that.

use std::fmt;
use std::ops::Range;

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

    /// The smallest range that holds both.
    pub fn to(self, other: Span) -> Span {
        Span { start: self.start.min(other.start), end: self.end.max(other.end) }
    }

    /// The same range, `offset` bytes later: from a place in a part to the place in the whole.
    pub fn shifted(self, offset: usize) -> Span {
        Span { start: self.start + offset, end: self.end + offset }
    }

    /// Whether `other` lies within this range.
    pub fn contains(self, other: Span) -> bool {
        self.start <= other.start && other.end <= self.end
    }

    /// As a standard range, to index with.
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
    /// Where.
    pub span: Span,
    /// What is wrong, in a sentence without a final stop.
    pub message: String,
    /// What to do next.
    pub help: Option<String>,
    /// What is wanted and not known, if it is that which is wrong.
    pub missing: Option<Missing>,
}

/// Something that a formula or a claim needs and that is not known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Missing {
    /// A name, as LaTeX.
    Name(String),
    /// The reading of the equation with this number or label, or on this line.
    Equation(String),
}

impl Fault {
    /// A fault at `span`.
    pub fn new(span: Span, message: impl Into<String>) -> Self {
        Fault { span, message: message.into(), help: None, missing: None }
    }

    /// A name that is not declared, at `span`.
    pub fn undeclared(span: Span, name: impl fmt::Display) -> Self {
        let missing = Some(Missing::Name(name.to_string()));
        Fault { missing, ..Fault::new(span, format!("{name} is not declared")) }
    }

    /// The same fault with advice.
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// The same fault, seen from the text that holds this one at `offset`.
    pub fn shifted(mut self, offset: usize) -> Self {
        self.span = self.span.shifted(offset);
        self
    }
}

/// A text with the name it is known by.
#[derive(Debug, PartialEq, Eq)]
pub struct Source {
    /// The path as the user gave it, for messages.
    pub path: String,
    /// The whole text.
    pub text: String,
}

impl Source {
    /// A text known as `path`.
    pub fn new(path: impl Into<String>, text: impl Into<String>) -> Self {
        Source { path: path.into(), text: text.into() }
    }

    /// Line and column of a byte, both from 1; columns count characters.
    pub fn line_column(&self, offset: usize) -> (usize, usize) {
        let mut offset = offset.min(self.text.len());
        while !self.text.is_char_boundary(offset) {
            offset -= 1;
        }
        let before = &self.text[..offset];
        let line = before.bytes().filter(|&b| b == b'\n').count() + 1;
        let start = before.rfind('\n').map_or(0, |i| i + 1);
        (line, before[start..].chars().count() + 1)
    }

    /// The text at `span`; empty where the span is not within the text.
    pub fn slice(&self, span: Span) -> &str {
        self.text.get(span.range()).unwrap_or("")
    }
}

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.path)
    }
}
