//! Names that the notes set to 1, as in "we set $c = \hbar = 1$". A display in which such a name stands again is in other units than those
//! before it, so it is not called wrong by them.

use crate::check::document::inferred::prose::body_of;
use crate::check::unaided::course::Course;
use crate::formula::Expr;
use crate::latex::names;

/// The constants of nature that authors set to 1.
const CONSTANTS: [&str; 12] = [
    "c",
    "\\hbar",
    "h",
    "G",
    "k",
    "k_B",
    "k_{B}",
    "k_{\\mathrm B}",
    "k_{\\mathrm{B}}",
    "\\epsilon_0",
    "\\varepsilon_0",
    "\\mu_0",
];

impl Course<'_, '_> {
    /// Whether a display contains a name that the notes before it set to 1.
    pub(super) fn restores_a_unit(&self, at: usize) -> bool {
        let (checker, model) = (self.checker, self.checker.model);
        let members = checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
        let printed: Vec<_> = members.flat_map(Expr::symbols).map(|(id, _)| id).collect();
        let is_printed = |name: &str| {
            let found = names::parse(name).and_then(|(name, _)| model.symbols.find(&name));
            found.is_some_and(|(id, _)| printed.contains(&id))
        };
        if !CONSTANTS.into_iter().any(is_printed) {
            return false;
        }
        let end = checker.notes.equations[at].span.start;
        let inline = checker.notes.inline.iter().filter(|span| span.end <= end);
        let said = inline.filter_map(|span| Some(checker.notes.source.slice(body_of(checker.notes, *span)?)));
        let said = said.chain(checker.notes.equations[..at].iter().map(|display| display.text.as_str()));
        said.filter_map(|text| text.trim().trim_end_matches(['.', ',']).trim_end().strip_suffix('1')).any(|text| {
            let Some(names) = text.trim_end().strip_suffix('=') else { return false };
            let names = names.split('=').map(str::trim);
            names.clone().all(|name| CONSTANTS.contains(&name)) && names.into_iter().any(is_printed)
        })
    }
}
