//! The display equation of a document: its text, its place, its number and its labels.

use crate::source::Span;

/// One display equation: everything under one number, or one display without a number.
///
/// Several `$$…$$` that follow each other and share a number are one `Display`. Its `body` then reaches from the
/// first to the last, and in `text` the `$$` between them are a row break, `\\`.
///
/// A numbered row that begins with a relation goes on from the row before. Its `body` then begins with the last member of that
/// row, before its `span`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Display {
    /// The display with its delimiters; for a row group of an `align`, its rows.
    pub span: Span,
    /// The LaTeX between the delimiters.
    pub body: Span,
    /// The bodies that `body` was joined from; one, mostly.
    pub parts: Vec<Span>,
    /// The body as it is read as a formula, with as many bytes as `body`, so that a place in it is a place in the
    /// file.
    ///
    /// Spaces replace comments, `\tag`, `\label`, numbers, block-quote markers and macro definitions. A row break,
    /// `\\`, replaces a blank line between two rows.
    pub text: String,
    /// The printed number, without its parentheses.
    pub number: Option<Numbered>,
    /// Labels, as in `\label{…}`, and names, as `#veff`.
    pub labels: Vec<Numbered>,
    /// The numbers that LaTeX prints beside its rows by itself, where nothing else numbers them.
    pub automatic: Vec<String>,
    /// Whether each of its rows may have a number of its own, as in `align`: a number or a label in it is that of its row.
    pub numbers_rows: bool,
    /// The line in which the display starts, from 1.
    pub line: usize,
}

impl Display {
    /// The number, or else the first label.
    pub fn id(&self) -> Option<&str> {
        let number = self.number.as_ref().or(self.labels.first());
        number.map(|numbered| numbered.id.as_str())
    }
}

/// A number, a label or a name, and where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Numbered {
    /// What it says.
    pub id: String,
    /// Where.
    pub span: Span,
}
