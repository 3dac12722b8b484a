//! A text with its path, and where its ranges stand in files.

use std::fmt;
#[cfg(feature = "notes")]
use std::sync::Arc;

use super::Span;
#[cfg(feature = "notes")]
use super::encoding::Encoding;
#[cfg(feature = "notes")]
use super::origin::Origin;

/// A text and its path.
///
/// The text may be a view: what a document says as Markdown or TeX, put together from one file or several. Then an
/// origin says where each byte of it stands. All places in a source are bytes of its text.
#[derive(Debug)]
pub struct Source {
    /// The path as the user gave it, for messages.
    pub path: String,
    /// The whole text.
    pub text: String,
    #[cfg(feature = "notes")]
    made: Provenance,
}

impl PartialEq for Source {
    fn eq(&self, other: &Source) -> bool {
        self.path == other.path && self.text == other.text
    }
}

impl Eq for Source {}

impl Source {
    /// A text known as `path`.
    pub fn new(path: impl Into<String>, text: impl Into<String>) -> Self {
        Source {
            path: path.into(),
            text: text.into(),
            #[cfg(feature = "notes")]
            made: Provenance::default(),
        }
    }

    /// The line and the column of a byte in its file, both counted from 1. A column is a character, not a byte.
    pub fn line_column(&self, offset: usize) -> (usize, usize) {
        #[cfg(feature = "notes")]
        let place = self.place(Span::at(offset)).line_column();
        #[cfg(not(feature = "notes"))]
        let place = self.own_line_column(offset);
        place
    }

    /// The path of the file in which a byte stands.
    pub fn path_at(&self, offset: usize) -> &str {
        #[cfg(feature = "notes")]
        let path = &self.place(Span::at(offset)).file.path;
        #[cfg(not(feature = "notes"))]
        let path = (offset, &self.path).1;
        path
    }

    fn own_line_column(&self, offset: usize) -> (usize, usize) {
        let mut offset = offset.min(self.text.len());
        while !self.text.is_char_boundary(offset) {
            offset -= 1;
        }
        let before = &self.text[..offset];
        let line = before.bytes().filter(|&b| b == b'\n').count() + 1;
        let start = before.rfind('\n').map_or(0, |i| i + 1);
        (line, before[start..].chars().count() + 1)
    }

    /// The text at `span`; empty if the span does not lie within the text.
    pub fn slice(&self, span: Span) -> &str {
        self.text.get(span.range()).unwrap_or("")
    }
}

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.path)
    }
}

#[cfg(feature = "notes")]
/// How a text was made from files.
#[derive(Debug, Default)]
pub(super) struct Provenance {
    /// How the bytes of the file are the text.
    encoding: Encoding,
    /// The pieces of a view.
    origin: Option<Origin>,
    /// The files of a view.
    files: Vec<Arc<Source>>,
}

#[cfg(feature = "notes")]
/// A place in a file.
#[derive(Clone, Copy, Debug)]
pub struct Place<'a> {
    /// The file, read as it is.
    pub file: &'a Source,
    /// The range in the text of the file.
    pub span: Span,
}

#[cfg(feature = "notes")]
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

#[cfg(feature = "notes")]
/// An edit of a file.
#[derive(Clone, Debug)]
pub struct FileEdit<'a> {
    /// What is replaced.
    pub place: Place<'a>,
    /// What is put there, as the file writes it.
    pub replacement: String,
}

#[cfg(feature = "notes")]
impl Source {
    /// The same text, of a file in another encoding.
    pub(crate) fn encoded(self, encoding: Encoding) -> Self {
        Source { made: Provenance { encoding, ..Provenance::default() }, ..self }
    }

    /// A view of files.
    pub(super) fn view(path: impl Into<String>, text: String, files: Vec<Arc<Source>>, origin: Origin) -> Self {
        Source { path: path.into(), text, made: Provenance { encoding: Encoding::Utf8, origin: Some(origin), files } }
    }

    /// The bytes of the file with another text; none, if its encoding lacks a character.
    pub fn encode(&self, text: &str) -> Option<Vec<u8>> {
        self.made.encoding.encode(text)
    }

    /// The files that the text was put together from; none, if it is the text of one file as it is.
    pub fn files(&self) -> &[Arc<Source>] {
        &self.made.files
    }

    /// Where a range stands in a file. A range over several files stands where it begins.
    pub fn place(&self, span: Span) -> Place<'_> {
        match self.made.origin.as_ref().and_then(|origin| origin.place(span)) {
            Some((file, span)) => Place { file: &self.made.files[file], span },
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
                Ok(FileEdit { place: Place { file: &self.made.files[file], span: place }, replacement })
            }
        }
    }
}
