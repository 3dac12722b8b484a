//! Names that a display defines before all of it can be read.
//!
//! `\partial_t^2 u = c^2 \partial_x^2 u, \quad c = \sqrt{S/\rho}` lacks u, and `u = A \sin(kx - \omega t), \quad \omega = ck` lacks c.
//! Each display waits for the other one. So the first defines c, and is read again once u is known.

use crate::check::document::unreadable::faults;
use crate::check::model::Model;
use crate::formula::Symbols;
use crate::latex::{DefinedSymbol, Reading, name_search};
use crate::source::{Fault, Missing};

/// The names that were defined early, with the places of their displays.
#[derive(Default)]
pub(crate) struct EarlyDefinitions {
    defined: Vec<(usize, DefinedSymbol)>,
}

impl EarlyDefinitions {
    /// Defines the names of the first display that lacks a name which another one gives; returns whether there is one.
    pub fn define(&mut self, unread: &[(usize, Symbols, Reading)], texts: &[String], model: &mut Model) -> bool {
        if !model.symbols.guessed {
            return false;
        }
        let waits = |(at, _, reading): &&(usize, Symbols, Reading)| {
            let is_given = |fault: &Fault| {
                let Some(Missing::Name(name)) = &fault.missing else { return false };
                let mut others = unread.iter().filter(|(other, ..)| other != at);
                others.any(|(other, ..)| gives(&texts[*other], name, model))
            };
            !reading.introduced.is_empty() && faults(reading).next().is_some() && faults(reading).all(is_given)
        };
        let Some((at, symbols, reading)) = unread.iter().find(waits) else { return false };
        model.symbols = symbols.clone();
        for new in &reading.introduced {
            model.define(new.symbol, new.formula.clone());
            self.defined.push((*at, new.clone()));
        }
        true
    }

    /// Notes in the readings which of their statements define these names.
    pub fn restore(self, readings: &mut [Reading]) {
        for (at, new) in self.defined.into_iter().rev() {
            readings[at].introduced.insert(0, new);
        }
    }
}

/// Whether a display gives a name a formula, `u = …` or `u(x,t) = …`.
fn gives(text: &str, name: &str, model: &Model) -> bool {
    let call = format!("{name}(");
    let is_applied = text.match_indices(&call).any(|(at, _)| {
        let arguments = text[at + call.len()..].split_once(')');
        arguments.is_some_and(|(_, rest)| rest.trim_start().starts_with('='))
    });
    is_applied || name_search::is_a_side(text, name, &model.macros)
}
