//! H as the Hamiltonian, where the claims file says nothing of it: beside a Lagrangian, `H = …` with momenta is Σ p q̇ − L.
//!
//! Without this, a printed H would be a definition, which cannot be wrong.

use crate::formula::{Kind, text};
use crate::latex::names;
use crate::notes::Notes;
use crate::notes::claims::Claims;

use crate::check::model::Model;
use crate::check::model::meaning::{Meaning, Quantity};

/// The names that are taken for a Hamiltonian.
const NAMES: [&str; 3] = ["H", "\\mathcal{H}", "\\mathcal H"];

/// Gives the name H its meaning, if a display defines it by momenta.
pub(crate) fn infer(claims: &Claims, notes: &Notes, model: &mut Model) {
    let is_taken = |latex: &str| claims.define.iter().any(|(name, _)| name.value == latex);
    if model.system.is_none() && model.printed_lagrangian.is_none() {
        return;
    }
    for latex in NAMES.into_iter().filter(|latex| !is_taken(latex)) {
        let defines = |body: &str| {
            body.trim_start().strip_prefix(latex).is_some_and(|rest| {
                let rest = rest.trim_start();
                let rest = match rest.strip_prefix('(') {
                    Some(arguments) => arguments.split_once(')').map_or("", |(_, rest)| rest).trim_start(),
                    None => rest,
                };
                rest.trim_start_matches(['&', ' ', ':']).strip_prefix('=').is_some_and(contains_momentum)
            })
        };
        if !notes.equations.iter().any(|display| defines(&display.text)) {
            continue;
        }
        let Some((name, 0)) = names::parse(latex) else { continue };
        let shown = name.to_string();
        let Some(id) = model.symbols.add(name, Kind::Scalar) else { continue };
        let entry = model.symbols.entry_mut(id);
        (entry.varies, entry.derived) = (true, true);
        model.mean(id, Meaning::System(Quantity::Energy));
        model.inferred.push(format!("{} is the Hamiltonian, the sum of p q̇ minus L", text::plain(&shown)));
    }
}

/// Whether a formula contains the letter p outside of the names of commands.
fn contains_momentum(latex: &str) -> bool {
    let mut in_command = false;
    latex.chars().any(|c| {
        in_command = c == '\\' || in_command && c.is_ascii_alphabetic();
        c == 'p' && !in_command
    })
}
