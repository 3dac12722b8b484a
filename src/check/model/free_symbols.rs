//! The symbols that are drawn at random and on which formulas depend.

use crate::formula::{Expr, SymbolId};

use crate::check::model::Model;
use crate::check::model::meaning::Meaning;

/// The drawn symbols on which formulas depend, through definitions.
pub(crate) fn drawn(formulas: &[&Expr], model: &Model) -> Vec<SymbolId> {
    fn collect(symbol: SymbolId, model: &Model, into: &mut Vec<SymbolId>) {
        match model.meaning(symbol) {
            Some(Meaning::Constant(_) | Meaning::Varying(_) | Meaning::Coordinate(_)) if !into.contains(&symbol) => {
                into.push(symbol);
            }
            Some(Meaning::Defined(formula)) => {
                formula.symbols().into_iter().for_each(|(symbol, _)| collect(symbol, model, into));
            }
            _ => model.symbols.entry(symbol).members.iter().for_each(|member| collect(*member, model, into)),
        }
    }
    let mut found = Vec::new();
    for (symbol, _) in formulas.iter().flat_map(|formula| formula.symbols()) {
        collect(symbol, model, &mut found);
    }
    found
}
