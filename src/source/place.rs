//! Where a range of a text stands in a file, and how the file is edited there.

use std::sync::Arc;

use super::encoding::Encoding;
use super::origin::Origin;
use super::{Source, Span};

/// How a text was made from files.
#[derive(Debug, Default)]
pub(super) struct Provenance {
    /// How the bytes of the file are the text.
    encoding: Encoding,
    /// The files of a view.
    origin: Option<Origin>,
}

/// A place in a file.
#[derive(Clone, Copy, Debug)]
pub struct Place<'a> {
    /// The file, read as it is.
    pub file: &'a Source,
    /// The range in the text of the file.
    pub span: Span,
}

impl Place<'_> {
    /// The range as bytes of the file, which may have another encoding than its text.
    pub fn bytes(&self) -> Span {
        let before = |at: usize| self.file.made.encoding.bytes(self.file.text.get(..at).unwrap_or(&self.file.text));
        Span::new(before(self.span.start), before(self.span.end))
    }

    /// The line and the column of the first byte, from 1; a column is a character.
    pub fn line_column(&self) -> (usize, usize) {
        self.file.own_line_column(self.span.start)
    }

    /// The line and the column after the last byte.
    pub fn end_line_column(&self) -> (usize, usize) {
        self.file.own_line_column(self.span.end)
    }
}

/// An edit of a file.
#[derive(Clone, Debug)]
pub struct FileEdit<'a> {
    /// What is replaced.
    pub place: Place<'a>,
    /// What is put there, as the file writes it.
    pub replacement: String,
}

impl Source {
    /// The same text, of a file in another encoding.
    pub(crate) fn encoded(self, encoding: Encoding) -> Self {
        Source { made: Provenance { encoding, origin: None }, ..self }
    }

    /// A view of files.
    pub(super) fn view(path: impl Into<String>, text: String, origin: Origin) -> Self {
        Source { path: path.into(), text, made: Provenance { encoding: Encoding::Utf8, origin: Some(origin) } }
    }

    /// The bytes of the file.
    pub(crate) fn encode(&self, text: &str) -> Option<Vec<u8>> {
        self.made.encoding.encode(text)
    }

    /// The files that the text was put together from; none, if it is the text of one file as it is.
    pub(crate) fn files(&self) -> &[Arc<Source>] {
        self.made.origin.as_ref().map_or(&[], |origin| &origin.files)
    }

    /// Where a range stands in a file. A range over several files stands where it begins.
    pub fn place(&self, span: Span) -> Place<'_> {
        match self.made.origin.as_ref().and_then(|origin| origin.place(span)) {
            Some((file, span)) => Place { file, span },
            None => Place { file: self, span },
        }
    }

    /// The edit of a file that replaces a range of the text.
    ///
    /// # Errors
    /// The reason, a clause, why the file cannot be edited so.
    pub fn edit(&self, span: Span, replacement: &str) -> Result<FileEdit<'_>, &'static str> {
        match &self.made.origin {
            None => Ok(FileEdit { place: Place { file: self, span }, replacement: replacement.to_owned() }),
            Some(origin) => {
                let (file, place, replacement) = origin.edit(span, replacement)?;
                Ok(FileEdit { place: Place { file, span: place }, replacement })
            }
        }
    }
}
