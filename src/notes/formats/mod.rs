//! The formats in which people write: which file is in which format, and how each becomes Markdown or TeX.
//!
//! A [`Format`] is one value. Its `view` gives the document as Markdown or TeX text in which every byte has its place in a
//! file, so that the search for displays, the checks and the repairs are the same for all formats. Another format is one
//! file in this folder and one entry in [`ALL`].
//!
//! Offers [`Format`] and [`ALL`]. Knows texts and places in them, and nothing of displays.

mod asciidoc;
mod blocks;
mod comments;
mod notebook;
mod org;
mod restructured;
mod tex_project;
mod typst;

use std::path::Path;
use std::sync::Arc;

use super::kind::Kind;
use crate::source::Source;
use crate::{Error, Result};

/// A format of documents.
#[derive(Clone, Copy)]
pub struct Format {
    /// The extensions of its files, in lower case.
    pub extensions: &'static [&'static str],
    /// What a view is.
    pub kind: Kind,
    /// Whether its files are programs, whose comments alone are read. A folder is searched for those with displays.
    pub is_code: bool,
    /// The document in a file.
    pub(super) view: fn(&Arc<Source>, &Path) -> Result<View>,
}

/// A document as Markdown or TeX.
pub(super) struct View {
    /// The text, with the places in files.
    pub source: Arc<Source>,
    /// Files that the document names and that are not there.
    pub absent: Vec<Error>,
}

/// Every format.
pub const ALL: &[Format] = &[
    MARKDOWN,
    tex_project::FORMAT,
    notebook::FORMAT,
    restructured::FORMAT,
    asciidoc::FORMAT,
    org::FORMAT,
    typst::FORMAT,
    comments::RUST,
    comments::C,
    comments::PYTHON,
    comments::JULIA,
];

const MARKDOWN: Format = Format {
    extensions: &["md", "markdown", "qmd", "rmd", "txt"],
    kind: Kind::Markdown,
    is_code: false,
    view: as_it_is,
};

impl Format {
    /// The format of a file, by its extension.
    pub fn of(path: &Path) -> Option<&'static Format> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        ALL.iter().find(|format| format.extensions.contains(&extension.as_str()))
    }
}

fn as_it_is(file: &Arc<Source>, _: &Path) -> Result<View> {
    Ok(View { source: file.clone(), absent: Vec::new() })
}

/// A view of one file alone.
fn alone(source: Source) -> Result<View> {
    Ok(View { source: Arc::new(source), absent: Vec::new() })
}

impl Kind {
    /// How a document is read, by the extension of its file.
    pub fn of(path: &Path) -> Option<Kind> {
        Format::of(path).map(|format| format.kind)
    }
}
