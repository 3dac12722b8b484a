//! Which name is the Lagrangian of notes without a claims file.

use crate::check::document::inferred::open_energies;
use crate::check::usage::Usage;
use crate::formula::symbols::Name;
use crate::latex::Macros;
use crate::notes::Notes;

/// The name of the Lagrangian, if a display defines one, and the notes speak of it, differentiate it, or square a rate in it: an
/// angular momentum has no such square.
pub(super) fn of<'u>(notes: &Notes, usages: &'u [Usage], macros: &Macros) -> Option<&'u Name> {
    let texts = || notes.equations.iter().map(|display| display.text.as_str());
    let open = open_energies::only_named(texts(), macros);
    // `L = T - V` alone is no formula for it.
    let has_formula = |usage: &Usage| {
        open.is_empty() || {
            let mut others = texts().enumerate().filter(|(at, _)| !open.contains(at));
            let name = usage.name.to_string();
            others.any(|(_, text)| text.trim_start().strip_prefix(&name).is_some_and(|rest| rest.contains('=')))
        }
    };
    let text = &notes.source.text;
    let is_spoken_of = text.contains("agrangian") || text.contains("Euler--Lagrange") || text.contains("\\partial L");
    let is_it = |usage: &&Usage| {
        ["L", "\\mathcal{L}"].contains(&usage.name.base.as_str())
            && usage.name.subscript.is_empty()
            && usage.introduced == Some(usage.first)
    };
    let moves = usages.iter().any(|usage| usage.moves);
    let is_kinetic = |usage: &&Usage| {
        usage.introduced.and_then(|at| notes.equations.get(at)).is_some_and(|display| squares_a_rate(&display.text))
    };
    usages
        .iter()
        .find(is_it)
        .filter(|usage| moves && (is_spoken_of || is_kinetic(usage)) && has_formula(usage))
        .map(|usage| &usage.name)
}

/// Whether a text has a dotted name with the power 2: `\dot x^2`, `\dot{\theta}_1^{2}`.
fn squares_a_rate(text: &str) -> bool {
    text.split("\\dot").skip(1).any(|after| {
        let after = after.trim_start_matches(['{', ' ']);
        let name = after.trim_start_matches('\\').trim_start_matches(|c: char| c.is_ascii_alphabetic());
        let script = name.trim_start_matches('}').trim_start();
        let script = script.strip_prefix('_').map_or(script, |index| {
            index.trim_start_matches(|c: char| c.is_ascii_alphanumeric() || "{}\\".contains(c))
        });
        script.starts_with("^2") || script.starts_with("^{2}")
    })
}
