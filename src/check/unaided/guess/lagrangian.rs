//! Which name is the Lagrangian of notes without a claims file.

use crate::check::document::inferred::open_energies;
use crate::check::usage::{Usage, names_of};
use crate::formula::symbols::Name;
use crate::latex::Macros;
use crate::notes::{Display, Notes};

/// The name of the Lagrangian, if a display defines one, and the notes speak of it, differentiate it, or square a rate in it: an
/// angular momentum has no such square.
pub(super) fn of<'u>(notes: &Notes, usages: &'u [Usage], macros: &Macros) -> Option<&'u Name> {
    let texts = || notes.equations.iter().map(|display| display.text.as_str());
    let open = open_energies::only_named(texts(), macros);
    // `L = T - V` alone is no formula for it.
    let has_formula = |usage: &Usage| {
        open.is_empty() || {
            let mut others = notes.equations.iter().enumerate().filter(|(at, _)| !open.contains(at));
            let gives = |display: &Display| {
                let names = names_of(std::slice::from_ref(display), macros);
                names.iter().any(|given| given.name == usage.name && given.introduced.is_some())
            };
            others.any(|(_, display)| gives(display))
        }
    };
    let text = &notes.source.text;
    let is_spoken_of = text.contains("agrangian") || text.contains("Euler--Lagrange") || text.contains("\\partial L");
    let is_it = |usage: &&Usage| is_lagrangian(&usage.name) && usage.introduced == Some(usage.first);
    let moves = usages.iter().any(|usage| usage.moves);
    let is_kinetic = |usage: &&Usage| {
        let display = usage.introduced.and_then(|at| notes.equations.get(at));
        display
            .is_some_and(|display| squares_a_rate(&display.text) || is_sum_with_rates(display, notes, usages, macros))
    };
    usages
        .iter()
        .find(is_it)
        .filter(|usage| moves && (is_spoken_of || is_kinetic(usage)) && has_formula(usage))
        .map(|usage| &usage.name)
}

/// Whether a name is that of a Lagrangian, where it has the formula of one.
pub(super) fn is_lagrangian(name: &Name) -> bool {
    ["L", "\\mathcal{L}"].contains(&name.base.as_str()) && name.subscript.is_empty() && name.primes == 0
}

/// Whether a display gives the sum of energies, `L = T - V`, and another one squares a rate in the formula of one of them.
fn is_sum_with_rates(display: &Display, notes: &Notes, usages: &[Usage], macros: &Macros) -> bool {
    let names = names_of(std::slice::from_ref(display), macros);
    let squares = |name: &Name| {
        let given = usages.iter().find(|usage| usage.name == *name).and_then(|usage| usage.introduced);
        given.and_then(|at| notes.equations.get(at)).is_some_and(|display| squares_a_rate(&display.text))
    };
    names.iter().all(|usage| open_energies::is_energy(&usage.name))
        && names.iter().any(|usage| !is_lagrangian(&usage.name) && squares(&usage.name))
}

/// Whether a text has a dotted name with the power 2: `\dot x^2`, `\dot{\theta}_1^{2}`.
pub(super) fn squares_a_rate(text: &str) -> bool {
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
