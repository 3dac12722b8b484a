//! The marks of one hand-in.

use std::path::Path;
use std::sync::Arc;

use crate::notes::Notes;
use crate::notes::document::Kind;
use crate::source::Source;

use crate::check::document::setup::Run;

use super::marked::Marked;
use super::problem::Problem;
use super::{credit, letters};

impl Problem {
    /// Marks a hand-in, known as `path`.
    pub fn mark(&self, run: &Run<'_>, path: &Path, text: &str) -> Marked {
        let shown_as = path.display().to_string();
        let student = path.file_stem().map_or_else(|| shown_as.clone(), |stem| stem.to_string_lossy().into_owned());
        let source = Arc::new(Source::new(shown_as, text.trim_start_matches('\u{feff}')));
        let kind = Kind::of(path).unwrap_or(Kind::Markdown);
        let mut marked = Marked {
            student,
            source: source.clone(),
            letters: Vec::new(),
            lines: Vec::new(),
            results: Vec::new(),
            fault: None,
        };
        let found = Notes::parse(source, kind).and_then(|notes| letters::best(run, self, &notes));
        match found {
            Ok((judged, letters)) => {
                marked.letters = letters;
                (marked.lines, marked.results) = credit::given(self, judged);
            }
            Err(error) => {
                marked.fault = Some(error.message().to_owned());
                marked.results = credit::nothing(self);
            }
        }
        marked
    }
}
