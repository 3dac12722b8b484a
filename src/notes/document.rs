//! A document: a file with its display equations in order, each with its place and its number.

use std::collections::{BTreeMap, HashSet};
use std::path::Path;
use std::sync::Arc;

pub use super::display::{Display, Numbered};
use super::file::read_text;
use super::formats::{self, Format};
pub use super::kind::Kind;
pub use super::macros::MacroDefinition;
use super::references::{self, Reference};
use super::{displays, macros, markdown, tex};
use crate::code::Code;
use crate::source::{Source, Span};
use crate::{Error, Result};

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
    /// Inline mathematics, with its dollar signs.
    pub inline: Vec<Span>,
    /// Block-quote markers, which are not part of a sentence.
    markers: Vec<Span>,
    /// Files that the document names and that are not there.
    pub absent: Vec<Error>,
    /// The place of the first display that another author added. All before it are read first, so that no added display
    /// defines a name that is theirs.
    pub added_from: Option<usize>,
}

impl Notes {
    /// The numbers that LaTeX prints beside the rows of each display, by the display's own name.
    pub fn automatic_numbers(&self) -> BTreeMap<String, Vec<String>> {
        let named = self.equations.iter().filter(|display| !display.automatic.is_empty());
        named.filter_map(|display| Some((display.id()?.to_owned(), display.automatic.clone()))).collect()
    }

    /// Reads the file at `path`, known in messages as `shown_as`.
    pub fn read(path: &Path, shown_as: &str) -> Result<Notes> {
        let Some(format) = Format::of(path) else {
            let known: Vec<String> = formats::ALL.iter().map(|format| format!(".{}", format.extensions[0])).collect();
            return Err(Error::new(format!("the format of {shown_as} is not supported"))
                .help(format!("save the notes in a supported format: {}", known.join(", "))));
        };
        let source = read_text(path, shown_as)?;
        if source.text.trim_start_matches('\u{feff}').trim().is_empty() {
            return Err(Error::new(format!("{shown_as} is empty")).with_code(Code::NotesFile).help(
                match format.kind {
                    Kind::Markdown => "write an equation between $$ and $$",
                    Kind::Tex => "write an equation between \\[ and \\], or in an environment such as equation",
                },
            ));
        }
        let view = (format.view)(&source, path)?;
        let mut notes = Notes::parse(view.source, format.kind)?;
        notes.absent = view.absent;
        Ok(notes)
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
        let macros = macros::definitions(&String::from_utf8_lossy(&clean));
        displays::blank(&mut clean, macros.iter().map(|definition| &definition.span));
        let mut prose = clean.clone();
        displays::blank(&mut prose, scan.raws.iter().map(|raw| &raw.span).chain(&scan.inline));
        let automatic = match kind {
            Kind::Tex => tex::automatic(&clean, &scan.raws, &macros),
            Kind::Markdown => Vec::new(),
        };
        let mut equations =
            displays::assemble(&source, clean, scan.raws, scan.names).map_err(|fault| Error::fault(&source, fault))?;
        let mut automatic = automatic.into_iter().peekable();
        for display in &mut equations {
            while let Some(number) = automatic.next_if(|number| number.row.start < display.span.end) {
                if display.number.is_none() && display.span.start <= number.row.end {
                    display.automatic.push(number.id);
                }
            }
        }
        let numbers = || equations.iter().filter_map(|display| display.number.as_ref());
        displays::blank(&mut prose, numbers().map(|number| &number.span));
        // In a part of a document, the numbers of the whole are not known.
        let is_whole = kind == Kind::Tex && source.text.contains("\\documentclass");
        let automatic = equations.iter().filter(|_| is_whole).flat_map(|display| display.automatic.iter());
        let printed = numbers().map(|number| &number.id).chain(automatic).map(String::as_str);
        let references = references::all(&prose, &source, printed);
        Ok(Notes {
            source,
            equations,
            macros,
            references,
            inline: scan.inline,
            markers: scan.markers,
            absent: Vec::new(),
            added_from: None,
        })
    }

    /// The references to numbers that no display carries. The prose may mean another document.
    pub fn dangling_references(&self) -> impl Iterator<Item = &Reference> {
        let numbers = |display: &'_ Display| {
            let number = display.number.iter().map(|number| number.id.clone());
            number.chain(display.automatic.iter().cloned()).collect::<Vec<_>>()
        };
        let carried: HashSet<String> = self.equations.iter().flat_map(numbers).collect();
        self.references.iter().filter(move |reference| !carried.contains(&reference.number))
    }

    /// The displays that carry `id` as their number, label or (as `#veff`) name; else those beside which LaTeX prints it.
    pub fn find(&self, id: &str) -> Vec<usize> {
        let carries = |display: &Display| {
            display.number.as_ref().is_some_and(|number| number.id == id) || display.labels.iter().any(|l| l.id == id)
        };
        let found: Vec<usize> = (0..self.equations.len()).filter(|&i| carries(&self.equations[i])).collect();
        let prints = |display: &Display| display.automatic.iter().any(|number| number == id);
        match found.is_empty() {
            true => (0..self.equations.len()).filter(|&i| prints(&self.equations[i])).collect(),
            false => found,
        }
    }

    /// The places of `quote` in the prose, without regard to white space, dollar signs and block-quote markers.
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
