//! Names that notes define, and the formulas for which they stand.

use crate::formula::{Expr, Node, Relation, SymbolId, Symbols};
use crate::latex::{Macros, read_display};

/// Names with their formulas, in terms of the same symbols.
#[derive(Clone, Debug, Default)]
pub(super) struct Defined(Vec<(SymbolId, Expr)>);

/// The most definitions that stand inside each other.
const DEEPEST: usize = 8;

impl Defined {
    /// Reads definitions, each an equation with the name alone on its left side. What already is a symbol keeps its meaning.
    pub fn read(definitions: &[String], symbols: &mut Symbols, macros: &Macros) -> Defined {
        let is_known = |symbols: &Symbols, left: &Expr, known: usize| match &left.node {
            Node::Symbol { id, .. } => symbols.iter().take(known).any(|(other, _)| other == *id),
            _ => true,
        };
        let known = symbols.iter().count();
        let mut found: Vec<(SymbolId, Expr)> = Vec::new();
        // A formula may use names that later definitions introduce, so all are read twice.
        for latex in definitions.iter().chain(definitions) {
            let reading = read_display(latex, symbols, macros);
            for statement in reading.statements.into_iter().flatten() {
                let is_definition = matches!(statement.relations.first(), Some((Relation::Equal, _)));
                let [left, right, ..] = statement.members.as_slice() else { continue };
                let Node::Symbol { id, indices, dots: 0 } = &left.node else { continue };
                let is_new = found.iter().all(|(other, _)| other != id);
                if is_definition && is_new && indices.is_empty() && !is_known(symbols, left, known) {
                    found.push((*id, right.clone()));
                }
            }
        }
        Defined(found)
    }

    /// The formula with each name replaced by what it stands for.
    pub fn unfolded(&self, formula: &Expr) -> Expr {
        let mut formula = formula.clone();
        let stands_for = |node: &Node| {
            let Node::Symbol { id, dots, indices } = node else { return None };
            let (_, other) = self.0.iter().find(|(own, _)| own == id && indices.is_empty())?;
            let mut value = other.clone();
            if *dots > 0 {
                value = Expr::new(Node::TimeDerivative(*dots, Box::new(value)), other.span);
            }
            Some(value)
        };
        for _ in 0..DEEPEST {
            let uses = formula.symbols().iter().any(|(id, _)| self.0.iter().any(|(own, _)| own == id));
            if !uses {
                break;
            }
            formula.substitute(&stands_for);
        }
        formula
    }
}
