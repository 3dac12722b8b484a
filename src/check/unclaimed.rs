//! The report of notes without a claims file.

use std::path::Path;

use crate::code::Code;
use crate::notes::{Display, Notes, claims_beside};

use crate::check::document::names::unjudged;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::report::Document;

/// The report of notes without a claims file: every numbered equation is unclaimed.
pub fn unclaimed(notes: &Notes) -> Document {
    let equation = |display: &Display| {
        let beside = claims_beside(Path::new(&notes.source.path));
        let message =
            format!("these notes have no claims file, so this equation was not checked; write {}", beside.display());
        let finding = Finding::new(Code::NoClaimsFile, Verdict::Unclaimed, display.body, message);
        Some(unjudged(notes, display.id()?, display.line, finding))
    };
    Document {
        path: notes.source.path.clone(),
        claims: None,
        source: notes.source.clone(),
        equations: notes.equations.iter().filter_map(equation).collect(),
        sentences: Vec::new(),
        unnumbered: notes.equations.iter().filter(|display| display.id().is_none()).count(),
        inferred: Vec::new(),
    }
}
