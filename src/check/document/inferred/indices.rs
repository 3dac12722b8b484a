//! Indices of coordinates, where no declaration says what they run over: the i of q_i, where q_1 and q_2 are coordinates.
//!
//! Lagrange's equations are mostly written once for all coordinates. The letter then runs over all coordinates of its name.

use crate::formula::symbols::Name;
use crate::formula::{SymbolId, text};
use crate::latex::{Reading, names};
use crate::source::{Fault, Missing};

use crate::check::document::unreadable::faults;
use crate::check::model::Model;
use crate::check::model::meaning::Meaning;

/// The largest value of an index.
const MOST: u8 = 9;

/// Declares the index of a coordinate that one of the readings lacks; returns whether there was one.
pub(crate) fn declare<'r>(unread: impl Iterator<Item = &'r Reading>, model: &mut Model) -> bool {
    let name = |fault: &Fault| match &fault.missing {
        Some(Missing::Name(name)) => names::parse(name).map(|(name, _)| name),
        _ => None,
    };
    let missing: Vec<Name> = unread.flat_map(faults).filter_map(name).collect();
    let Some((letter, upper, name)) = missing.iter().find_map(|name| index_of(name, model)) else { return false };
    model.symbols.add_index(&letter, upper);
    model.inferred.push(format!("{letter} runs from 1 to {upper}, as {} are the coordinates", text::plain(&name)));
    true
}

/// The letter of a name that is no symbol but would be a family of coordinates, how many there are, and their names.
fn index_of(name: &Name, model: &Model) -> Option<(String, u8, String)> {
    let [letter] = name.subscript.as_slice() else { return None };
    let is_letter = letter.len() == 1 && letter.bytes().all(|byte| byte.is_ascii_lowercase());
    if !is_letter || model.symbols.index(letter).is_some() || model.symbols.find(&Name::plain(letter.clone())).is_some()
    {
        return None;
    }
    let member = |value: u8| -> Option<SymbolId> {
        let mut member = name.clone();
        member.subscript[0] = value.to_string();
        let (id, _) = model.symbols.find(&member)?;
        matches!(model.meaning(id), Some(Meaning::Coordinate(_))).then_some(id)
    };
    let members: Vec<SymbolId> = (1..=MOST).map_while(member).collect();
    let upper = u8::try_from(members.len()).ok().filter(|upper| *upper > 1)?;
    let all: Vec<String> = members.iter().map(|id| model.name(*id)).collect();
    Some((letter.clone(), upper, all.join(", ")))
}
