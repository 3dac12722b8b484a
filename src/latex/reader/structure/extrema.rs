//! `\min_x` and its kin, which act on the whole sum after them.

use crate::formula::tree::Expr;
use crate::source::Span;

use super::super::super::layout::{Item, Layout, contents};
use super::super::state::{Read, Reader};
use super::printed;

impl Reader<'_> {
    /// `\min_x` before a sum; `None` for anything else.
    pub(in super::super) fn extremum(&mut self, items: &[Item], place: Span) -> Read<Option<Expr>> {
        let Some(at) = items.iter().position(|item| !matches!(item.layout, Layout::Space(_))) else { return Ok(None) };
        let rest = &items[at + 1..];
        if !is_extremum(&items[at]) || rest.iter().all(|item| matches!(item.layout, Layout::Space(_))) {
            return Ok(None);
        }
        let inner = self.sum(rest, place)?;
        let template = format!("{}(#)", printed(std::slice::from_ref(&items[at])));
        Ok(Some(self.template(&template, vec![inner], place)))
    }
}

/// `\min_x`, which acts on the whole sum after it.
pub(in super::super::super) fn is_extremum(item: &Item) -> bool {
    let Layout::Scripts { nucleus, sub: Some(_), sup: None, primes: 0 } = &item.layout else { return false };
    const WORDS: [&str; 12] = [
        "min", "max", "sup", "inf", "argmin", "argmax", "arginf", "argsup", "minimize", "maximize", "minimum",
        "maximum",
    ];
    let nucleus = match contents(nucleus) {
        [only] => only,
        _ => nucleus,
    };
    match &nucleus.layout {
        Layout::Command(name) => ["\\min", "\\max", "\\sup", "\\inf"].contains(&name.as_str()),
        Layout::Style(_, inner) => WORDS.contains(&printed(contents(inner)).as_str()),
        Layout::Text(word) => WORDS.contains(&word.trim()),
        _ => false,
    }
}
