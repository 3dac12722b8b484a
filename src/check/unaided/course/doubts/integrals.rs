//! Integrals in which a letter may depend on the letter of the integral: `\int \frac{m}{r}\,dm`, where the notes speak of m(r), and
//! `\int p\,dV` beside pV = nRT.
//!
//! Such a letter is read as a constant. What is concluded from that may not be what the author means.

use crate::check::model::meaning::Meaning;
use crate::check::unaided::calculus::integrals::{self, Integral};
use crate::check::unaided::course::Course;
use crate::check::unaided::gate;
use crate::check::unaided::prose;
use crate::check::usage::names_of;
use crate::formula::symbols::Name;
use crate::formula::text;
use crate::latex::layout::typeset_items;

/// Letters of quantities that an equation of state connects.
const OF_STATE: [&str; 6] = ["p", "P", "V", "T", "S", "U"];

/// Words that say that a quantity is no constant, behind its letter.
const CHANGES: [&str; 20] = [
    " falls",
    " rises",
    " drops",
    " varies",
    " vary",
    " changes",
    " depends",
    " grows",
    " increases",
    " decreases",
    " is a function",
    " ändert",
    " hängt",
    " wächst",
    " varie",
    " dépend",
    " croît",
    " cambia",
    " depende",
    " dipende",
];

/// Words of a process at a constant pressure, volume or temperature.
const AT_CONSTANT: [&str; 10] =
    ["constant", "isobar", "isotherm", "isochor", "isentrop", "konstant", "constante", "costante", "fixed", "uniform"];

/// The most bytes behind a letter in which it is said to change.
const NEAR: usize = 60;

impl Course<'_, '_> {
    /// A letter that may depend on the letter of an integral, in a display or in a formula that it uses.
    pub(super) fn rests_on_hidden_letters(&self, at: usize) -> Option<String> {
        gate::with_definitions(self.checker, at).into_iter().find_map(|place| self.hidden_letter(place))
    }

    /// A letter that may depend on the letter of an integral of a display.
    pub(in crate::check::unaided::course) fn hidden_letter(&self, at: usize) -> Option<String> {
        let (checker, model) = (self.checker, self.checker.model);
        let display = &checker.notes.equations[at];
        if !display.text.contains("\\int") {
            return None;
        }
        let items = typeset_items(&display.text, &model.macros).ok()?;
        let mut printed = Vec::new();
        integrals::collect(&items, &mut printed);
        let is_constant = |name: &&Name| {
            let id = model.symbols.find(name).map(|(id, _)| id);
            id.is_some_and(|id| {
                let is_one = matches!(model.meaning(id), Some(Meaning::Constant(_) | Meaning::Varying(_)));
                is_one && model.symbols.entry(id).coefficient.is_none()
            })
        };
        printed.iter().find_map(|integral| {
            let mut others = integral.names.iter().filter(|name| **name != integral.letter).filter(is_constant);
            others.find(|name| self.may_depend(at, name, integral)).map(|name| text::plain(&name.to_string()))
        })
    }

    /// Whether the notes say, or an equation of state does, that a name depends on the letter of an integral.
    fn may_depend(&self, at: usize, name: &Name, integral: &Integral) -> bool {
        let notes = self.checker.notes;
        let (of, letter) = (name.to_string(), integral.letter.to_string());
        let all = notes.source.text.as_str();
        if is_applied(all, &of, &letter) || is_applied(all, &letter, &of) {
            return true;
        }
        if integral.names.contains(&integral.letter) {
            return false;
        }
        changes(all, &of) || self.are_of_state(at, name, &integral.letter)
    }

    /// Whether two names are quantities of state that another display relates, and the words before the display keep neither constant.
    fn are_of_state(&self, at: usize, name: &Name, letter: &Name) -> bool {
        let notes = self.checker.notes;
        let is_one = |name: &Name| name.subscript.is_empty() && OF_STATE.contains(&name.base.as_str());
        if !is_one(name) || !is_one(letter) {
            return false;
        }
        let origin = self.scope.origin_of(at, notes.equations.len());
        let words = prose::words_since_last(notes, origin);
        let relates = |text: &str, place: usize| {
            let usages = names_of(std::slice::from_ref(&notes.equations[place]), &self.checker.model.macros);
            !text.contains("\\int") && [name, letter].iter().all(|name| usages.iter().any(|usage| usage.name == **name))
        };
        let mut displays = notes.equations.iter().enumerate();
        !AT_CONSTANT.iter().any(|word| words.contains(word))
            && displays.any(|(place, display)| relates(&display.text, place))
    }
}

/// Whether a text has a name with another one in parentheses: `m(r)`.
fn is_applied(all: &str, name: &str, argument: &str) -> bool {
    [format!("{name}({argument})"), format!("{name} ({argument})"), format!("{name}\\left({argument}\\right)")]
        .iter()
        .any(|call| {
            all.match_indices(call.as_str())
                .any(|(at, _)| !all[..at].ends_with(|c: char| c.is_alphanumeric() || c == '\\'))
        })
}

/// Whether a sentence says that a quantity changes: "the temperature $T$ falls along the rod".
fn changes(all: &str, name: &str) -> bool {
    all.match_indices(&format!("${name}$")).any(|(at, found)| {
        let after = &all[at + found.len()..];
        let near: String = after.chars().take(NEAR).take_while(|c| !matches!(c, '.' | '$' | ';')).collect();
        CHANGES.iter().any(|word| near.to_lowercase().starts_with(word))
    })
}
