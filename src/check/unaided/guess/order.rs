//! Displays that use what a later one defines: `L = T - V` before T and V have formulas, and the Euler–Lagrange equation
//! before L has one.
//!
//! A name that such a display uses is one that the later display defines. So what names are is told from the displays in
//! another order: each after those that it needs.

use crate::check::document::inferred::open_energies::is_energy;
use crate::check::unaided::guess::lagrangian::is_lagrangian;
use crate::check::usage::{Usage, names_of};
use crate::formula::symbols::Name;
use crate::latex::Macros;
use crate::notes::{Display, Notes};

/// The names in the displays of notes, and how they stand there; each place is that in the notes.
pub(super) fn names_in_order(notes: &Notes, macros: &Macros) -> Vec<Usage> {
    let order = order(notes, macros);
    let Some(order) = order else { return names_of(&notes.equations, macros) };
    let displays: Vec<Display> = order.iter().map(|at| notes.equations[*at].clone()).collect();
    let mut found = names_of(&displays, macros);
    for usage in &mut found {
        usage.first = order[usage.first];
        usage.introduced = usage.introduced.map(|at| order[at]);
    }
    found
}

/// The order of the displays; `None` if it is that of the notes.
fn order(notes: &Notes, macros: &Macros) -> Option<Vec<usize>> {
    let displays = &notes.equations;
    let is_candidate = |display: &Display| display.text.contains('L');
    if !displays.iter().any(is_candidate) {
        return None;
    }
    let names: Vec<Vec<Usage>> =
        displays.iter().map(|display| names_of(std::slice::from_ref(display), macros)).collect();
    let gives =
        |at: usize, name: &Name| names[at].iter().any(|usage| usage.name == *name && usage.introduced.is_some());
    let moves = |at: usize| names[at].iter().any(|usage| usage.moves);
    // After which display each one comes.
    let later: Vec<Option<usize>> = (0..displays.len())
        .map(|at| {
            let own = &names[at];
            let lagrangian = own.iter().map(|usage| &usage.name).find(|name| is_lagrangian(name))?;
            let is_sum = gives(at, lagrangian) && own.len() > 1 && own.iter().all(|usage| is_energy(&usage.name));
            if is_sum {
                let terms = own.iter().map(|usage| &usage.name).filter(|name| *name != lagrangian);
                let is_new = |name: &&Name| !(0..at).any(|before| gives(before, name));
                let given = terms.filter(is_new).map(|name| (at + 1..displays.len()).find(|after| gives(*after, name)));
                return given.collect::<Option<Vec<usize>>>()?.into_iter().max();
            }
            let is_general = is_general_law(&displays[at].text) && !gives(at, lagrangian);
            let is_first = is_general && !(0..at).any(|before| gives(before, lagrangian));
            is_first.then(|| (at + 1..displays.len()).find(|after| gives(*after, lagrangian) && moves(*after)))?
        })
        .collect();
    later.iter().any(Option::is_some).then_some(())?;
    let mut order: Vec<usize> = (0..displays.len()).collect();
    // A stable order: what comes after a display comes directly after it.
    order.sort_by_key(|at| later[*at].map_or((*at, 0), |after| (after, at + 1)));
    Some(order)
}

/// Whether a display has a derivative with ∂ in it.
fn is_general_law(text: &str) -> bool {
    text.contains("\\partial") || text.contains("\\pdv")
}
