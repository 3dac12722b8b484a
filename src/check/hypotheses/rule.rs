//! A rule: what a hypothesis, or a meaning given in one claim only, makes of a symbol.

use std::sync::Arc;

use crate::formula::{Expr, Index, IndexId, Sign, SymbolId};

use crate::check::model::Model;

/// As many laws as unknowns.
#[derive(Debug)]
pub struct CoupledLaws {
    /// What they are solved for: a number that varies, and which of its derivatives.
    pub unknowns: Vec<(SymbolId, u8)>,
    /// The sides of each.
    pub sides: Vec<[Expr; 2]>,
}

/// What a hypothesis, or the meaning of a symbol in one equation, makes of a symbol.
#[derive(Clone, Debug)]
pub struct Rule {
    /// The symbol.
    pub symbol: SymbolId,
    /// The letters that stand for its indices.
    pub letters: Vec<IndexId>,
    /// What it is.
    pub action: Action,
    /// Whether at all times, and not only at the instant.
    pub throughout: bool,
}

/// What a rule makes of a symbol.
#[derive(Clone, Debug)]
pub enum Action {
    /// The value of a formula.
    Equals(Expr),
    /// The part of what it was before that goes over into itself, or into its negative, when its indices are permuted.
    Symmetric {
        /// For each of its indices, which one takes its place.
        permutation: Vec<usize>,
        /// The sign.
        sign: Sign,
    },
    /// The part of what it was before that is parallel to a vector.
    Parallel(Expr),
    /// What follows from its derivatives below this order, all members at once: that derivative is the formula's value.
    EquationOfMotion {
        /// Which derivative.
        order: u8,
        /// Its value.
        formula: Expr,
    },
    /// What laws give it together with other symbols.
    Coupled(Arc<CoupledLaws>),
    /// The members of several families, one after the other.
    Union(Vec<Expr>),
}

impl Action {
    /// The formulas that a symbol's value depends on by it.
    pub fn formulas(&self) -> Vec<&Expr> {
        match self {
            Action::Equals(formula) | Action::Parallel(formula) | Action::EquationOfMotion { formula, .. } => {
                vec![formula]
            }
            Action::Coupled(laws) => laws.sides.iter().flatten().collect(),
            Action::Symmetric { .. } | Action::Union(_) => Vec::new(),
        }
    }
}

/// The letters of indices, if each is one of its own.
pub(crate) fn letters(indices: &[Index]) -> Option<Vec<IndexId>> {
    let mut letters = Vec::new();
    for index in indices {
        match index {
            Index::Letter(letter) if !letters.contains(letter) => letters.push(*letter),
            _ => return None,
        }
    }
    Some(letters)
}

/// Whether the value of a formula depends on a symbol, through definitions and earlier rules.
pub(crate) fn depends_through_rules(model: &Model, rules: &[Rule], expr: &Expr, symbol: SymbolId) -> bool {
    let mut dependent = vec![symbol];
    // Whatever a rule builds on the symbol depends on it as well.
    loop {
        let more = rules.iter().find(|rule| {
            !dependent.contains(&rule.symbol)
                && rule.action.formulas().into_iter().any(|formula| model.depends_on(formula, &dependent))
        });
        match more {
            Some(rule) => dependent.push(rule.symbol),
            None => return model.depends_on(expr, &dependent),
        }
    }
}
