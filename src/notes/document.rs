//! The notes: a file with its display equations, in order, each with its place and its number.

use std::collections::HashSet;
use std::path::Path;
use std::sync::Arc;

use super::references::{self, Reference};
use super::{displays, macros, markdown, tex};
use crate::source::{Source, Span};
use crate::{Error, Result};

/// No lecture notes are larger.
const LARGEST: u64 = 64 << 20;

/// A document, and the displays in it.
#[derive(Clone, Debug)]
pub struct Notes {
    /// The file.
    pub source: Arc<Source>,
    /// All display equations, in order; also those without a number.
    pub equations: Vec<Display>,
    /// The commands that the notes define.
    pub macros: Vec<MacroDefinition>,
    /// Where the prose cites equations by their numbers, in order.
    pub references: Vec<Reference>,
    /// Mathematics in the sentences, with its dollar signs.
    pub inline: Vec<Span>,
    /// Block-quote markers, which are no part of a sentence.
    markers: Vec<Span>,
}

/// One display equation: all that one number holds, or one display without a number.
///
/// Several `$$…$$` that follow each other and share a number are one `Display`. Its `body` then reaches from the
/// first to the last, and in `text` the `$$` between them are a row break, `\\`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Display {
    /// The display with its delimiters; for a row group of an `align`, its rows.
    pub span: Span,
    /// The LaTeX between the delimiters.
    pub body: Span,
    /// The bodies that `body` was joined from; one, mostly.
    pub parts: Vec<Span>,
    /// The body to be read as a formula: as many bytes as `body`, so that a place in it is a place in the file.
    ///
    /// What is no formula (comments, `\tag`, `\label`, numbers, block-quote markers, definitions of macros) is
    /// overwritten by spaces, and a blank line between two rows by a row break, `\\`.
    pub text: String,
    /// The printed number, without its parentheses.
    pub number: Option<Numbered>,
    /// Labels, as in `\label{…}`, and names, as `#veff`.
    pub labels: Vec<Numbered>,
    /// The line in which the display starts, from 1.
    pub line: usize,
}

/// A number, a label or a name, and where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Numbered {
    /// What it says.
    pub id: String,
    /// Where.
    pub span: Span,
}

/// A command that the notes define.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MacroDefinition {
    /// Its name, with the backslash.
    pub name: String,
    /// How many arguments it takes.
    pub arguments: usize,
    /// What the first argument is when it is left out.
    pub default: Option<String>,
    /// What it stands for.
    pub body: String,
    /// The whole definition.
    pub span: Span,
}

/// How a document is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Markdown, or plain text with `$$…$$`.
    Markdown,
    /// TeX.
    Tex,
}

impl Kind {
    /// By the extension of a file.
    pub fn of(path: &Path) -> Option<Kind> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "md" | "markdown" | "txt" => Some(Kind::Markdown),
            "tex" => Some(Kind::Tex),
            _ => None,
        }
    }
}

impl Notes {
    /// Reads the file at `path`, known in messages as `shown_as`.
    pub fn read(path: &Path, shown_as: &str) -> Result<Notes> {
        let Some(kind) = Kind::of(path) else {
            return Err(Error::new(format!("{shown_as} is not a kind of notes that onshell reads"))
                .help("notes are .md, .markdown, .txt or .tex"));
        };
        let source = read_text(path, shown_as)?;
        if source.text.trim_start_matches('\u{feff}').trim().is_empty() {
            return Err(Error::new(format!("{shown_as} is empty")).help("there is nothing in it to check"));
        }
        Notes::parse(source, kind)
    }

    /// Finds the displays of a text.
    pub fn parse(source: Arc<Source>, kind: Kind) -> Result<Notes> {
        let scan = match kind {
            Kind::Markdown => markdown::scan(&source.text),
            Kind::Tex => tex::scan(&source.text),
        };
        let scan = scan.map_err(|fault| Error::fault(&source, fault))?;
        let mut clean = source.text.clone().into_bytes();
        displays::blank(&mut clean, scan.blank.iter().chain(&scan.markers));
        let macros = macros::all(&String::from_utf8_lossy(&clean));
        displays::blank(&mut clean, macros.iter().map(|definition| &definition.span));
        let mut prose = clean.clone();
        displays::blank(&mut prose, scan.raws.iter().map(|raw| &raw.span).chain(&scan.inline));
        let equations = displays::assemble(&source.text, clean, scan.raws, scan.names)
            .map_err(|fault| Error::fault(&source, fault))?;
        let numbers = || equations.iter().filter_map(|display| display.number.as_ref());
        displays::blank(&mut prose, numbers().map(|number| &number.span));
        let references = references::all(&prose, &source, numbers().map(|number| number.id.as_str()));
        Ok(Notes { source, equations, macros, references, inline: scan.inline, markers: scan.markers })
    }

    /// The references to numbers that no display carries. The prose may mean another document.
    pub fn dangling_references(&self) -> impl Iterator<Item = &Reference> {
        let carried: HashSet<&str> =
            self.equations.iter().filter_map(|d| Some(d.number.as_ref()?.id.as_str())).collect();
        self.references.iter().filter(move |reference| !carried.contains(reference.number.as_str()))
    }

    /// The displays that carry `id` as their number, label or (as `#veff`) name.
    pub fn find(&self, id: &str) -> Vec<usize> {
        let carries = |display: &Display| {
            display.number.as_ref().is_some_and(|number| number.id == id) || display.labels.iter().any(|l| l.id == id)
        };
        (0..self.equations.len()).filter(|&i| carries(&self.equations[i])).collect()
    }

    /// Where the prose says `quote`: word for word, but for white space, dollar signs and block-quote markers.
    pub fn find_quote(&self, quote: &str) -> Vec<Span> {
        let counts = |c: char| !c.is_whitespace() && c != '$';
        let needle: String = quote.chars().filter(|&c| counts(c)).collect();
        if needle.is_empty() {
            return Vec::new();
        }
        let mut prose = String::with_capacity(self.source.text.len());
        // For every byte of `prose`, its place in the file.
        let mut places = Vec::with_capacity(self.source.text.len());
        let mut markers = self.markers.iter().peekable();
        for (at, c) in self.source.text.char_indices() {
            if markers.next_if(|marker| marker.start == at).is_some() || !counts(c) {
                continue;
            }
            prose.push(c);
            places.extend((0..c.len_utf8()).map(|i| at + i));
        }
        let found = prose.match_indices(&needle);
        found.map(|(at, _)| Span::new(places[at], places[at + needle.len() - 1] + 1)).collect()
    }
}

/// Reads a text file: too large, unreadable and not UTF-8 are errors.
pub(super) fn read_text(path: &Path, shown_as: &str) -> Result<Arc<Source>> {
    let failed = |error: std::io::Error| Error::new(format!("cannot read {shown_as}: {error}"));
    let about = std::fs::metadata(path).map_err(failed)?;
    if about.is_dir() {
        return Err(Error::new(format!("cannot read {shown_as}: it is a folder")));
    }
    if !about.is_file() {
        return Err(Error::new(format!("cannot read {shown_as}: it is not a regular file")));
    }
    if about.len() > LARGEST {
        let size = about.len() >> 20;
        return Err(Error::new(format!("{shown_as} has {size} MB; the most that is read is {} MB", LARGEST >> 20)));
    }
    let bytes = std::fs::read(path).map_err(failed)?;
    match String::from_utf8(bytes) {
        Ok(text) => Ok(Arc::new(Source::new(shown_as, text))),
        Err(error) => {
            let at = error.utf8_error().valid_up_to();
            let bytes = error.as_bytes();
            let line = bytes[..at].iter().filter(|&&b| b == b'\n').count() + 1;
            Err(Error::new(format!("{shown_as} is not UTF-8: byte {at} (0x{:02x}, line {line})", bytes[at]))
                .help("save the file as UTF-8"))
        }
    }
}
