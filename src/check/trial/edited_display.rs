//! A document with another text for one display, without reading the other displays again.
//!
//! Reading a document takes far longer than rejecting an edit. So only the edited display is read, with the names of the
//! document; the names that it introduces get their new definitions, and a law that it prints is replaced. The effect of the
//! edit on the reading of other displays is ignored here. This only rejects edits: an edit that is offered was checked in
//! the whole document.

use crate::formula::{Expr, Node, SymbolId};
use crate::latex::{DefinedSymbol, Reading, read_display};
use crate::notes::claims::Claim;

use crate::check::document::checker::Checker;
use crate::check::document::printed_lagrangian;
use crate::check::document::reading::for_each;
use crate::check::document::reread::{defined, forms_derivatives};
use crate::check::model::Model;
use crate::check::model::meaning::Meaning;
use crate::check::sample::context::Options;

impl Checker<'_> {
    /// The result of `judge` on the checker with another text for a display; `None`, if the text cannot be read or introduces
    /// other names.
    pub(crate) fn with_edited_text<T>(
        &self,
        options: Options,
        at: usize,
        text: &str,
        judge: impl FnOnce(&Checker<'_>) -> T,
    ) -> Option<T> {
        let none = Claim::default();
        let claim = self.assigned[at].unwrap_or(&none);
        let formulas = self.new_definitions(at, claim, text)?;
        let (mut model, reading) = self.redefined_model(at, claim, text, &formulas)?;
        if reading.statements.iter().any(std::result::Result::is_err) {
            return None;
        }
        // The other text may use a name that stands for the one that it defines. Then neither has a value.
        let is_edited = |id: &SymbolId| match (model.meaning(*id), self.model.meaning(*id)) {
            (Some(Meaning::Defined(new)), Some(Meaning::Defined(old))) => new != old,
            (new, _) => matches!(new, Some(Meaning::Defined(_))),
        };
        let mut edited = model.symbols.iter().map(|(id, _)| id).filter(is_edited);
        if edited.any(|id| model.is_defined_by_itself(id)) {
            return None;
        }
        let mut readings = self.readings.to_vec();
        readings[at] = reading;
        if !formulas.is_empty() {
            self.derive_again(&model, at, &mut readings);
        }
        // The units were inferred from the text before the edit, so they are not checked.
        let units = || None;
        if self.is_law(at) {
            let unlawful = Checker { model: &model, readings: &readings, options, units: units(), ..*self };
            let (laws, lost_laws) = unlawful.laws().ok()?;
            model.laws.retain(|law| law.derived);
            model.laws.extend(laws);
            model.unread_laws = lost_laws;
        }
        Some(judge(&Checker { model: &model, readings: &readings, options, units: units(), ..*self }))
    }

    /// Reads displays with a derivative by a symbol again: their readings contain derivatives of the definitions as they
    /// were before.
    fn derive_again(&self, model: &Model, edited: usize, readings: &mut [Reading]) {
        let none = Claim::default();
        for (at, display) in self.notes.equations.iter().enumerate() {
            let has_any = forms_derivatives(&display.text);
            if at == edited || !has_any || !readings[at].introduced.is_empty() {
                continue;
            }
            let claim = self.assigned[at].unwrap_or(&none);
            let derived = Checker { model, units: None, ..*self };
            readings[at] = derived.as_printed(&display.text, claim, &model.macros);
        }
    }

    /// The definitions that a text gives to the names that a display introduces, one formula for each; `None`, if it does not
    /// define them all.
    pub(crate) fn new_definitions(&self, at: usize, claim: &Claim, text: &str) -> Option<Vec<Expr>> {
        self.introduced_formulas(at, claim, text).or_else(|| self.formulas_of_known_names(at, claim, text))
    }

    /// The same, read as if these names were unknown; `None`, if the text cannot be read so.
    pub(crate) fn introduced_formulas(&self, at: usize, claim: &Claim, text: &str) -> Option<Vec<Expr>> {
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

    /// The same, read with these names known: some displays use a name before they define it.
    fn formulas_of_known_names(&self, at: usize, claim: &Claim, text: &str) -> Option<Vec<Expr>> {
        let reading = self.as_printed(text, claim, &self.model.macros);
        let formula = |new: &DefinedSymbol| {
            let (name, formula) = defined(reading.statements.get(new.statement)?.as_ref().ok()?, new)?;
            matches!(name.node, Node::Symbol { id, dots: 0, .. } if id == new.symbol).then(|| formula.clone())
        };
        let is_read = reading.statements.iter().all(std::result::Result::is_ok);
        is_read.then(|| self.readings[at].introduced.iter().map(formula).collect())?
    }

    /// The model in which the names of a display have these definitions, and the reading of a text in its place; `None`, if the
    /// names are not where they were, or if a name would be defined by itself.
    pub(crate) fn redefined_model(
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
            if model.depends_on(formula, &[new.symbol]) {
                return None;
            }
            model.redefine(new.symbol, formula.clone());
        }
        if introduced().any(|(new, _)| printed_lagrangian::is_part(&model, new.symbol)) {
            printed_lagrangian::retrace(&mut model).ok()?;
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
