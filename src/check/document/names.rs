//! The names of displays in messages, and the finding on a display that is not checked.

use std::collections::HashMap;

use crate::code::Code;
use crate::formula::SymbolId;
use crate::formula::symbols::Name;
use crate::latex::names;
use crate::notes::claims::{Claims, Spanned};
use crate::notes::document::Numbered;
use crate::notes::{Display, Notes};
use crate::source::Missing;
use crate::suggest::declaration;
use crate::{Error, Result};

use crate::check::model::Model;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;
use crate::check::verdict::report::Equation;

/// The numbers that an earlier display has too, each with the line of the first display.
pub(crate) fn repeated(notes: &Notes) -> Vec<(&Numbered, usize)> {
    let mut seen: HashMap<&str, usize> = HashMap::new();
    let mut repeated = Vec::new();
    for display in &notes.equations {
        let Some(number) = &display.number else { continue };
        match seen.get(number.id.as_str()) {
            Some(line) => repeated.push((number, *line)),
            None => drop(seen.insert(&number.id, display.line)),
        }
    }
    repeated
}

/// The report of an equation that was not checked, with the finding that says why.
pub(crate) fn unjudged(notes: &Notes, id: &str, line: usize, finding: Finding) -> Equation {
    Equation {
        id: id.to_owned(),
        line,
        latex: notes.source.slice(finding.span).to_owned(),
        reading: String::new(),
        finding,
        ok: false,
        because: None,
        parts: Vec::new(),
        repairs: Vec::new(),
        elsewhere: Vec::new(),
        errata: Vec::new(),
        rests_on: Vec::new(),
    }
}

/// The name of a display in messages: its number or label, or else its line.
pub(crate) fn shown(display: &Display) -> String {
    display.id().map_or_else(|| format!("line {}", display.line), str::to_owned)
}

/// Whether an equation, or a part of it, is false or cannot be read.
pub(crate) fn is_wrong(equation: &Equation) -> bool {
    let wrong = |verdict| matches!(verdict, Verdict::Refuted | Verdict::Domain | Verdict::Unreadable);
    wrong(equation.finding.verdict) || equation.parts.iter().any(|part| wrong(part.finding.verdict))
}

/// The most symbols that an error lists.
const MOST_LISTED: usize = 12;

/// A symbol named in the claims file.
pub(crate) fn symbol(claims: &Claims, model: &Model, latex: &Spanned<String>) -> Result<SymbolId> {
    let name = names::parse(&latex.value).filter(|(_, dots)| *dots == 0).map(|(name, _)| name);
    // A formula that stands for one name is written out.
    let name = name.or_else(|| Some(Name::plain(latex.value.clone())));
    let found = name.as_ref().and_then(|name| model.symbols.find(name));
    found.map(|(id, _)| id).ok_or_else(|| {
        let error = Error::at(&claims.source, latex.span, format!("there is no symbol {}", latex.value))
            .with_code(Code::UndeclaredName)
            .lacking(Some(Missing::Name(latex.value.clone())));
        let add = declaration(latex.value.trim(), 0);
        let known: Vec<String> =
            model.symbols.iter().filter(|(_, entry)| !entry.hidden).map(|(id, _)| model.name(id)).collect();
        match name.and_then(|name| model.symbols.nearest(&name)) {
            Some(near) => error.help(format!("did you mean {near}? If not, {add}")),
            None if (1..=MOST_LISTED).contains(&known.len()) => {
                error.help(format!("the declared symbols are {}; for another one, {add}", known.join(", ")))
            }
            None => error.help(add),
        }
    })
}
