//! The names in one display, and what it prints.

use crate::check::usage::{Usage, names_of};
use crate::formula::symbols::Name;
use crate::latex::Macros;
use crate::notes::Display;

/// The names in one display.
pub(super) struct Named {
    /// Those that it gives a formula.
    pub introduced: Vec<Name>,
    /// All of them.
    pub used: Vec<Name>,
    /// Those with a dot, or under d/dt.
    pub moving: Vec<Name>,
    /// What the display prints.
    pub printed: String,
}

impl Named {
    /// The names in a display.
    pub fn of(display: &Display, macros: &Macros) -> Named {
        let usages = names_of(std::slice::from_ref(display), macros);
        let is_introduced = |usage: &&Usage| usage.introduced.is_some();
        Named {
            introduced: usages.iter().filter(is_introduced).map(|usage| usage.name.clone()).collect(),
            used: usages.iter().map(|usage| usage.name.clone()).collect(),
            moving: usages.iter().filter(|usage| usage.moves).map(|usage| usage.name.clone()).collect(),
            printed: printed(&display.text),
        }
    }
}

/// What a display prints, without spaces, marks of alignment and punctuation at the end.
fn printed(text: &str) -> String {
    let text = text.replace("\\left", "").replace("\\right", "");
    let kept: String = text.chars().filter(|c| !c.is_whitespace() && *c != '&').collect();
    kept.trim_end_matches(['.', ',', ';']).to_owned()
}
