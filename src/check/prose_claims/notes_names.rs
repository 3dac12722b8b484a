//! The names in the displays of notes beside what the claims file declares.

use crate::formula::symbols::Name;
use crate::latex::{Macros, name_search, names};
use crate::notes::claims::{Claims, Declaration, Role};
use crate::notes::{Display, Notes};

use crate::check::document::setup::{assign, define_macros};
use crate::check::prose_claims::words::Sentence;
use crate::check::usage::{Usage, names_of};

/// The most displays in one sentence.
const LONGEST_SENTENCE: usize = 4;

/// The names of notes, and the displays without a claim of their own.
pub(super) struct NotesNames<'a> {
    pub claims: &'a Claims,
    pub notes: &'a Notes,
    pub macros: Macros,
    /// How each name stands in the displays.
    pub usages: Vec<Usage>,
    /// Whether each display is checked and has no claim of its own.
    free: Vec<bool>,
}

impl<'a> NotesNames<'a> {
    /// Those of some notes.
    pub fn of(claims: &'a Claims, notes: &'a Notes) -> Self {
        let mut macros = Macros::default();
        define_macros(&notes.macros, &mut macros);
        let usages = names_of(&notes.equations, &macros);
        let assigned = assign(claims, notes).unwrap_or_default();
        let is_free = |at: usize| notes.equations[at].id().is_some() && assigned.get(at).is_none_or(Option::is_none);
        let free = (0..notes.equations.len()).map(is_free).collect();
        NotesNames { claims, notes, macros, usages, free }
    }

    /// Whether a display is checked and has no claim of its own.
    pub fn is_free(&self, at: usize) -> bool {
        self.free[at]
    }

    /// Whether a claim says of a display that the system rests there, or moves steadily.
    pub fn is_said_to_stay(&self, at: usize) -> bool {
        let id = self.notes.equations[at].id();
        let mut claimed = self.claims.equations.iter().filter(|(address, _)| Some(address.text.as_str()) == id);
        claimed.any(|(_, claim)| claim.equilibrium.is_some())
    }

    /// The sentence before a display.
    pub fn before(&self, at: usize) -> Sentence {
        Sentence::before(self.notes, at)
    }

    /// The sentence before a display, and those before the displays that stand in the same sentence.
    pub fn sentence_of(&self, at: usize) -> Vec<Sentence> {
        let goes_on = |at: &usize| {
            let ends = |before: usize| self.notes.equations[before].text.trim_end().ends_with('.');
            at.checked_sub(1).filter(|before| !ends(*before) && self.before(*at).goes_on)
        };
        let all = std::iter::successors(Some(at), goes_on).take(LONGEST_SENTENCE);
        all.map(|at| self.before(at)).collect()
    }

    /// Whether the claims file says what a name is. A guess that it is a constant says nothing.
    pub fn is_declared(&self, name: &str) -> bool {
        let claims = self.claims;
        let is_said = |one: &&Declaration| claims.guesses.is_none() || one.role != Role::Constant;
        let declared = claims.declarations.iter().filter(is_said).map(|declaration| &declaration.name);
        let tied = claims.means.iter().chain(&claims.define).map(|(name, _)| name);
        declared.chain(tied).any(|known| name_search::same(&known.value, name))
    }

    /// Whether the claims file says of a name that it is a constant, and no more.
    pub fn is_constant(&self, name: &str) -> bool {
        let mut constants = self.claims.declarations.iter().filter(|one| one.role == Role::Constant);
        constants.any(|one| name_search::same(&one.name.value, name))
    }

    /// Whether a display gives a name a formula that nothing declares.
    pub fn introduces(&self, at: usize) -> bool {
        let own = self.usages.iter().filter(|usage| usage.introduced == Some(at)).map(|usage| usage.name.to_string());
        own.into_iter().any(|name| !self.is_declared(&name) && !self.is_constant(&name))
    }

    /// The coordinates, each with its name.
    pub fn coordinates(&self) -> impl Iterator<Item = (&'a Declaration, Name)> {
        let coordinates = self.claims.declarations.iter().filter(|one| one.role == Role::Coordinate);
        coordinates.filter_map(|one| Some((one, names::parse(&one.name.value)?.0)))
    }

    /// The displays that mention a name, by their places.
    pub fn displays_with(&self, name: &str) -> Vec<usize> {
        let mentions = |at: &usize| {
            let names = names_of(std::slice::from_ref(&self.notes.equations[*at]), &self.macros);
            names.iter().any(|usage| name_search::same(&usage.name.to_string(), name))
        };
        (0..self.notes.equations.len()).filter(mentions).collect()
    }

    /// Whether a display mentions a name, with primes too.
    pub fn mentions(&self, at: usize, name: &str) -> bool {
        self.has_name(&self.notes.equations[at].text, name)
    }

    /// The names in a formula.
    pub fn names_in(&self, formula: &str) -> Vec<Name> {
        let Some(display) = self.notes.equations.first() else { return Vec::new() };
        let display = Display { text: formula.to_owned(), ..display.clone() };
        names_of(std::slice::from_ref(&display), &self.macros).into_iter().map(|usage| usage.name).collect()
    }

    /// The names in a formula that have a dot, or stand under a derivative by the time.
    pub fn moving_names_in(&self, formula: &str) -> Vec<Name> {
        let Some(display) = self.notes.equations.first() else { return Vec::new() };
        let display = Display { text: formula.to_owned(), ..display.clone() };
        let usages = names_of(std::slice::from_ref(&display), &self.macros).into_iter();
        usages.filter(|usage| usage.moves).map(|usage| usage.name).collect()
    }

    /// Whether a formula does.
    pub fn has_name(&self, formula: &str, name: &str) -> bool {
        let (Some((name, _)), Some(display)) = (names::parse(name), self.notes.equations.first()) else { return false };
        let display = Display { text: formula.to_owned(), ..display.clone() };
        let names = names_of(std::slice::from_ref(&display), &self.macros);
        names.iter().any(|usage| usage.name.base == name.base && usage.name.subscript == name.subscript)
    }

    /// Whether a coordinate, or its rate, stands in a display.
    pub fn has_coordinates(&self, at: usize) -> bool {
        let names = names_of(std::slice::from_ref(&self.notes.equations[at]), &self.macros);
        let is_coordinate = |name: &Name| self.coordinates().any(|(_, known)| known == *name);
        names.iter().any(|usage| usage.moves || is_coordinate(&usage.name))
    }

    /// Whether a display gives a name, or a power of it, a formula.
    pub fn is_given_in(&self, at: usize, name: &str) -> bool {
        name_search::is_a_side(&self.notes.equations[at].text, name, &self.macros)
    }

    /// Whether one of the displays does.
    pub fn is_defined(&self, name: &str) -> bool {
        (0..self.notes.equations.len()).any(|at| self.is_given_in(at, name))
    }

    /// The text of a display as a formula of a claims file; `None` where it is not one equality.
    pub fn equality(&self, at: usize) -> Option<String> {
        let text = self.notes.equations[at].text.trim().trim_end_matches([',', '.', ';']).trim();
        is_one_equality(text).then(|| text.to_owned())
    }

    /// The text of a display that is one equality, perhaps with "= const" behind it.
    pub fn equality_but_for_constant(&self, at: usize) -> Option<String> {
        let text = self.notes.equations[at].text.trim().trim_end_matches([',', '.', ';']).trim();
        let (formula, last) = text.rsplit_once('=')?;
        let word: String = last.chars().filter(|c| c.is_alphabetic()).collect();
        let word = ["mathrm", "text", "mbox", "rm"].iter().find_map(|mark| word.strip_prefix(mark)).unwrap_or(&word);
        match ["const", "constant", "konst", "cte", "cste", "constante", "costante"].contains(&word) {
            true => Some(formula.trim().to_owned()).filter(|formula| is_one_equality(formula)),
            false => self.equality(at),
        }
    }

    /// Whether a display is one equality, in which determinants may stand.
    pub fn is_equality_of_determinants(&self, at: usize) -> bool {
        is_one_equality(without_matrices(&self.notes.equations[at].text).trim().trim_end_matches([',', '.', ';']))
    }
}

fn is_one_equality(text: &str) -> bool {
    text.matches('=').count() == 1 && !["\\quad", "\\\\", ",", "&"].iter().any(|mark| text.contains(mark))
}

/// A formula without what it is differentiated by: `\\frac{d^2 V}{d\\theta^2}` has no θ of its own.
pub(super) fn without_differentials(printed: &str) -> String {
    let mut found = printed.to_owned();
    for (at, _) in printed.match_indices("}{").chain(printed.match_indices("} {")) {
        let Some(open) = printed[at + 1..].find('{').map(|open| at + 1 + open) else { continue };
        let inner = printed[open + 1..].trim_start();
        let is_differential = ["\\partial", "d\\", "d ", "\\mathrm{d}"].iter().any(|mark| inner.starts_with(mark))
            || inner.starts_with('d') && inner[1..].starts_with(char::is_alphabetic);
        let is_time = inner.starts_with("dt") || inner.starts_with("d t");
        if !is_differential || is_time {
            continue;
        }
        let mut depth = 0;
        let end = printed[open..].char_indices().find_map(|(place, mark)| {
            depth += match mark {
                '{' => 1,
                '}' => -1,
                _ => 0,
            };
            (depth == 0).then_some(open + place)
        });
        if let Some(end) = end {
            found.replace_range(open + 1..end, &" ".repeat(end - open - 1));
        }
    }
    found
}

/// A text without its matrices and determinants.
fn without_matrices(text: &str) -> String {
    let mut rest = text.to_owned();
    let environments = ["vmatrix", "pmatrix", "bmatrix", "matrix", "array"];
    for name in environments {
        let (open, close) = (format!("\\begin{{{name}}}"), format!("\\end{{{name}}}"));
        while let Some(from) = rest.find(&open) {
            let Some(length) = rest[from..].find(&close) else { break };
            rest.replace_range(from..from + length + close.len(), " ");
        }
    }
    rest
}
