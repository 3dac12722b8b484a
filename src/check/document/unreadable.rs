//! Unreadable displays, and which of them makes a name unknown.
//!
//! A misprint in a display that defines a name, or prints a law, makes the name or the law unknown wherever it is used, in
//! the claims file too. So an unknown name is attributed to an unreadable display that contains it. If that display only
//! lacks other names, it must have the name as one of its sides. What needs the name is unreadable; the rest is checked.

use crate::code::Code;
use crate::latex::{Reading, name_search};
use crate::notes::Notes;
use crate::source::{Fault, Missing};

use crate::check::document::names::shown;

use crate::check::model::Model;

/// The displays of a document that cannot be read, each with the faults of its statements.
pub(crate) struct UnreadableDisplays<'a> {
    notes: &'a Notes,
    faults: Vec<(usize, Vec<&'a Fault>)>,
}

impl<'a> UnreadableDisplays<'a> {
    /// The unreadable displays among these readings, which come with the index of their display.
    pub fn of(notes: &'a Notes, readings: impl Iterator<Item = (usize, &'a Reading)>) -> UnreadableDisplays<'a> {
        let faults = readings.map(|(at, reading)| (at, faults(reading).collect::<Vec<_>>()));
        UnreadableDisplays { notes, faults: faults.filter(|(_, faults)| !faults.is_empty()).collect() }
    }

    /// The clause of a message that names the unreadable display which makes this unknown; `None`, if there is none.
    pub fn cause(&self, missing: Option<&Missing>, model: &Model) -> Option<String> {
        let name = match missing? {
            Missing::Equation(id) => return Some(format!("({id}) cannot be read")),
            Missing::Name(name) => name,
        };
        if let Some((_, cause)) = model.unread_names.iter().find(|(lost, _)| name_search::same(lost, name)) {
            return Some(cause.clone());
        }
        let lacks = |fault: &&Fault| matches!(&fault.missing, Some(Missing::Name(own)) if name_search::same(own, name));
        // What lacks only other names is misprinted in them: it has this one whole, if it introduces it.
        // So does what is typeset well, and only not supported: the d of an integral is no symbol.
        let is_own =
            |fault: &&Fault| !matches!(&fault.missing, Some(Missing::Name(_))) && fault.code != Code::NotSupported;
        let (display, _) = self.faults.iter().find(|(at, faults)| {
            let text = &self.notes.equations[*at].text;
            let has_it = if faults.iter().any(is_own) { name_search::mentions } else { name_search::is_a_side };
            !faults.iter().any(lacks) && has_it(text, name, &model.macros)
        })?;
        Some(format!("its definition may be in ({}), which cannot be read", shown(&self.notes.equations[*display])))
    }
}

/// The faults of the statements of a display that cannot be read.
pub(crate) fn faults(reading: &Reading) -> impl Iterator<Item = &Fault> {
    reading.statements.iter().filter_map(|read| read.as_ref().err())
}
