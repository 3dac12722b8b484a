//! What an equation rests on: the displays that define a symbol in it, and those that its claim names.

use crate::formula::SymbolId;
use crate::notes::claims::{Claim, Solved};

use crate::check::document::checker::Checker;
use crate::check::document::names::shown;

impl Checker<'_> {
    /// The names of the displays on which a display rests, in the order of the notes.
    pub(crate) fn rests_on(&self, at: usize, claim: &Claim) -> Vec<String> {
        let own = &self.readings[at];
        let members = own.statements.iter().flatten().flat_map(|statement| &statement.members);
        let symbols: Vec<SymbolId> = members.flat_map(|member| member.symbols()).map(|(id, _)| id).collect();
        let defines = |display: usize| {
            let introduced = &self.readings[display].introduced;
            introduced.iter().any(|new| symbols.contains(&new.symbol))
        };
        let solved = claim.solves.as_ref().and_then(|solves| match &solves.of {
            Solved::Equation(address) => Some(address),
            Solved::EquationsOfMotion(_) => None,
        });
        let addresses = solved.into_iter().chain(&claim.continuum_limit_of);
        let assumed = claim.assume.iter().chain(&claim.throughout).map(|text| text.value.as_str());
        let conditions =
            self.claims.conditions.iter().filter(|(name, _)| assumed.clone().any(|text| text == name.value));
        let inside = conditions.flat_map(|(_, texts)| texts).map(|text| text.value.as_str());
        let texts = addresses.map(|address| address.text.as_str()).chain(assumed.clone()).chain(inside);
        let named: Vec<usize> = texts.filter_map(|text| self.place(text)).collect();
        let displays = (0..self.readings.len()).filter(|display| *display != at);
        let found = displays.filter(|display| named.contains(display) || defines(*display));
        found.map(|display| shown(&self.notes.equations[display])).collect()
    }
}
