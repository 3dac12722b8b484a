//! Quantities that follow from the Lagrangian and that the prose or custom names: effective potentials, constants of the motion.

use crate::latex::layout::prints_derivative;
use crate::latex::name_search;
use crate::notes::claims::{Claim, Conserved};

use super::notes_names::NotesNames;
use super::words::Sentence;
use super::{ProseClaim, Refutes, spanned};

/// Phrases that say that a quantity keeps its value, each word as it begins.
const CONSERVED: [&str; 14] = [
    "conserv",
    "constant of the motion",
    "constant of motion",
    "constants of the motion",
    "constants of motion",
    "integral of the motion",
    "integral of motion",
    "first integral",
    "keeps its value",
    "erhalt",
    "konstante der bewegung",
    "constante du mouvement",
    "constante de movimiento",
    "intégrale première",
];

/// The letters of the whole energy.
const ENERGIES: [&str; 5] = ["E", "H", "h", "\\mathcal{E}", "\\varepsilon"];

/// The letters of potentials.
const POTENTIALS: [&str; 3] = ["V", "U", "W"];

/// What the prose or custom says of the quantities of the notes.
pub(super) fn infer(notes_names: &NotesNames<'_>) -> Vec<ProseClaim> {
    let mut found = effective_potentials(notes_names);
    found.extend(
        (0..notes_names.notes.equations.len())
            .filter(|at| notes_names.is_free(*at))
            .filter_map(|at| conserved(notes_names, at)),
    );
    found
}

/// Names such as `U_{\text{eff}}`.
fn effective_potentials(notes_names: &NotesNames<'_>) -> Vec<ProseClaim> {
    let is_it = |name: &crate::formula::symbols::Name| {
        let below = name.subscript.concat().to_lowercase();
        POTENTIALS.contains(&name.base.as_str()) && name.primes == 0 && below.contains("eff")
    };
    let named = notes_names.usages.iter().filter(|usage| is_it(&usage.name));
    let names = named.map(|usage| usage.name.to_string()).filter(|name| !notes_names.is_declared(name));
    let claim = |name: String| ProseClaim {
        displays: (0..notes_names.notes.equations.len())
            .filter(|at| notes_names.is_free(*at) && notes_names.mentions(*at, &name))
            .collect(),
        why: format!("{name} is the effective potential, as its subscript says"),
        means: vec![(name, "effective potential".to_owned())],
        refutes: Refutes::Never,
        ..ProseClaim::default()
    };
    names.map(claim).collect()
}

/// What a display says that gives a quantity a formula, where the words around it say that it is conserved.
fn conserved(notes_names: &NotesNames<'_>, at: usize) -> Option<ProseClaim> {
    let says = |words: &Sentence| words.says_phrase(&CONSERVED) && !words.denies();
    let before = notes_names.before(at);
    let is_energy =
        before.says(&["energ", "énerg"]) && !before.says(&["kinet", "potential", "kinét", "potenti", "cinét"]);
    let is_said = says(&before) || says(&Sentence::after(notes_names.notes, at));
    let condition = notes_names.equality_but_for_constant(at)?;
    // A formula of velocities with the letter of the energy needs no word; where a claims file is, the name may mean something else.
    let is_guessed = notes_names.claims.guesses.is_some();
    let is_a_formula_of_velocities = is_guessed && prints_derivative(&condition, &notes_names.macros);
    if !is_said && !is_energy && !is_a_formula_of_velocities {
        return None;
    }
    let given = notes_names.usages.iter().find(|usage| usage.introduced == Some(at) && usage.arguments.is_none())?;
    let name = given.name.to_string();
    let is_meant = name_search::is_a_side(&condition, &name, &notes_names.macros)
        && !notes_names.is_declared(&name)
        && (is_said || ENERGIES.contains(&given.name.base.as_str()) && given.name.subscript.is_empty());
    let id = notes_names.notes.equations[at].id()?;
    // Any formula of constants keeps its value. As the energy of a motion that the notes print it can be tested.
    if is_meant && !is_said && !notes_names.has_coordinates(at) {
        return Some(ProseClaim {
            displays: vec![at],
            refutes: Refutes::WhereNatural,
            why: format!("{name} is the energy, as the words before ({id}) say"),
            means: vec![(name, "energy".to_owned())],
            ..ProseClaim::default()
        });
    }
    is_meant.then(|| ProseClaim {
        claims: vec![(at, Claim { conserved: Some(spanned(Conserved::This)), ..Claim::default() })],
        displays: vec![at],
        refutes: if is_said { Refutes::WithAnEdit } else { Refutes::WhereNatural },
        why: match is_said {
            true => format!("{name} is conserved, as the words around ({id}) say"),
            false if is_energy => format!("{name} is the energy, as the words before ({id}) say"),
            false => format!("{name} is the energy, as it is a formula of velocities"),
        },
        ..ProseClaim::default()
    })
}
