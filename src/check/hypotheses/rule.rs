//! A rule: the value that a hypothesis, or a definition within one claim, gives a symbol.

use std::sync::Arc;

use crate::formula::{Expr, Index, IndexId, Sign, SymbolId};

use crate::check::model::Model;

/// Laws that are solved together: as many as unknowns.
#[derive(Debug)]
pub struct CoupledLaws {
    /// The unknowns: a scalar function of time, and the order of its derivative.
    pub unknowns: Vec<(SymbolId, u8)>,
    /// The two sides of each law.
    pub sides: Vec<[Expr; 2]>,
}

/// The value that a hypothesis, or a definition within one claim, gives a symbol.
#[derive(Clone, Debug)]
pub struct Rule {
    /// The symbol.
    pub symbol: SymbolId,
    /// The letters that stand for its indices.
    pub letters: Vec<IndexId>,
    /// How the value is given.
    pub action: Action,
    /// Whether the value holds at all times, with its derivatives, and not only at the instant.
    pub throughout: bool,
}

/// How a rule gives the value of a symbol.
#[derive(Clone, Debug)]
pub enum Action {
    /// The value of a formula.
    Equals(Expr),
    /// The part of the earlier value that is symmetric, or antisymmetric, under a permutation of its indices.
    Symmetric {
        /// For each index, the index that replaces it.
        permutation: Vec<usize>,
        /// The sign: plus for symmetric.
        sign: Sign,
    },
    /// The part of the earlier value that is parallel to a vector.
    Parallel(Expr),
    /// The solution of an equation of motion, for all members at once: the derivative of this order is the formula's
    /// value.
    EquationOfMotion {
        /// The order of the derivative.
        order: u8,
        /// Its value.
        formula: Expr,
    },
    /// The solution of coupled laws, together with other symbols.
    Coupled(Arc<CoupledLaws>),
    /// The members of several families, one family after the other.
    Union(Vec<Expr>),
}

impl Action {
    /// The formulas on which the value depends.
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

/// The letters of indices, if all are letters and no two are the same.
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
    // A symbol whose rule uses the symbol depends on it as well.
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
