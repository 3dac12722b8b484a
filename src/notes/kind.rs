//! How the text of a document is written: Markdown or TeX.

/// How the text of a document is written. Each format of files is read as one of these.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Markdown, or plain text with `$$…$$`.
    Markdown,
    /// TeX.
    Tex,
}
