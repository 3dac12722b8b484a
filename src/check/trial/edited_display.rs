//! A document with another text for one display, without reading the rest again.
//!
//! The display is read with the names of the whole document. Names that it defines get their new meanings, and a
//! law that it prints is replaced. How other displays would then be read is not considered: this only excludes
//! edits, and what is offered has been read in full.
//!
//! To read a document again takes longer than to see that an edit corrects nothing. So only the one display is
//! read, with the names of the others, and two states judge; the edits that remain are checked in full.

use crate::formula::{Expr, Node, SymbolId};
use crate::latex::{DefinedSymbol, Reading, read_display};
use crate::notes::claims::Claim;

use crate::check::document::checker::Checker;
use crate::check::document::reading::for_each;
use crate::check::document::reread::defined;
use crate::check::model::Model;
use crate::check::sample::context::Options;

impl Checker<'_> {
    /// What is found on the checker with another text for a display; nothing, if that cannot be read or names other things.
    pub(crate) fn with_text<T>(
        &self,
        options: Options,
        at: usize,
        text: &str,
        judge: impl FnOnce(&Checker<'_>) -> T,
    ) -> Option<T> {
        let none = Claim::default();
        let claim = self.assigned[at].unwrap_or(&none);
        let formulas = self.redefines(at, claim, text)?;
        let (mut model, reading) = self.redefined(at, claim, text, &formulas)?;
        if reading.statements.iter().any(std::result::Result::is_err) {
            return None;
        }
        let mut readings = self.readings.to_vec();
        readings[at] = reading;
        // Units are inferred from what is wrong as well.
        let units = || None;
        if self.is_law(at) {
            let unlawful = Checker { model: &model, readings: &readings, options, units: units(), ..*self };
            let (laws, lost_laws) = unlawful.laws().ok()?;
            (model.laws, model.unread_laws) = (laws, lost_laws);
        }
        Some(judge(&Checker { model: &model, readings: &readings, options, units: units(), ..*self }))
    }

    /// What a text in the place of a display makes of the names that the display introduces, one formula for each; none, if
    /// it does not introduce them all.
    pub(crate) fn redefines(&self, at: usize, claim: &Claim, text: &str) -> Option<Vec<Expr>> {
        self.introduces(at, claim, text).or_else(|| self.defined_anew(at, claim, text))
    }

    /// The same; none either, if the text cannot be read where these names are not known.
    pub(crate) fn introduces(&self, at: usize, claim: &Claim, text: &str) -> Option<Vec<Expr>> {
        let model = self.model;
        let own = &self.readings[at].introduced;
        if own.is_empty() {
            return Some(Vec::new());
        }
        let mut symbols = model.symbols.clone();
        own.iter().for_each(|introduced| symbols.forget(introduced.symbol));
        symbols.for_each = for_each(Some(claim), model);
        let reading = read_display(text, &mut symbols, &model.macros);
        if reading.statements.iter().any(std::result::Result::is_err) {
            return None;
        }
        let known = |id: SymbolId| {
            let name = &symbols.entry(id).name;
            own.iter().map(|introduced| introduced.symbol).find(|old| model.symbols.entry(*old).name == *name)
        };
        let formula = |wanted: &DefinedSymbol| {
            let new = reading.introduced.iter().find(|new| known(new.symbol) == Some(wanted.symbol))?;
            let mut formula = new.formula.clone();
            formula.rename(&|id| known(id).unwrap_or(id));
            Some(formula)
        };
        own.iter().map(formula).collect()
    }

    /// What a text makes of these names where they are known: some displays use a name before they say what it is.
    fn defined_anew(&self, at: usize, claim: &Claim, text: &str) -> Option<Vec<Expr>> {
        let reading = self.as_printed(text, claim, &self.model.macros);
        let formula = |new: &DefinedSymbol| {
            let (name, formula) = defined(reading.statements.get(new.statement)?.as_ref().ok()?, new)?;
            matches!(name.node, Node::Symbol { id, dots: 0, .. } if id == new.symbol).then(|| formula.clone())
        };
        let is_read = reading.statements.iter().all(std::result::Result::is_ok);
        is_read.then(|| self.readings[at].introduced.iter().map(formula).collect())?
    }

    /// The model in which the names that a display introduces have these meanings, and how a text in its place is read
    /// there; nothing, if the names do not stand in it where they stood, or would be defined in a circle.
    pub(crate) fn redefined(
        &self,
        at: usize,
        claim: &Claim,
        text: &str,
        formulas: &[Expr],
    ) -> Option<(Model, Reading)> {
        let before = &self.readings[at];
        let mut model: Model = self.model.clone();
        let introduced = || before.introduced.iter().zip(formulas);
        for (new, formula) in introduced() {
            // Nothing can be what it is by way of itself.
            if model.depends_on(formula, &[new.symbol]) {
                return None;
            }
            model.define(new.symbol, formula.clone());
        }
        let mut reading: Reading = self.as_printed(text, claim, &self.model.macros);
        for (new, formula) in introduced() {
            let name = |reading: &Reading| {
                let statement = reading.statements.get(new.statement)?.as_ref().ok()?;
                defined(statement, new).map(|(name, _)| name.clone())
            };
            if name(&reading).is_none_or(|here| Some(here) != name(before)) {
                return None;
            }
            reading.introduced.push(DefinedSymbol { formula: formula.clone(), ..new.clone() });
        }
        Some((model, reading))
    }
}
