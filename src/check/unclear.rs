//! Formulas that name something of which it is not clear what is meant: a family that is joined of several, and the motion
//! of a place that is integrated over.

use crate::formula::tree::Node;
use crate::formula::{Expr, SymbolId, text};

use super::identity::Context;
use super::model::{Meaning, Model};
use super::rules::Action;
use super::verdict::{Finding, Verdict};

impl Context<'_> {
    /// The finding that formulas, or the hypotheses, name something without saying clearly what.
    pub fn unclear(&self, formulas: &[&Expr]) -> Option<Finding> {
        let hypotheses = self.conditions.iter().flat_map(|c| [&c.lhs, &c.rhs]);
        let all: Vec<&Expr> = formulas.iter().copied().chain(hypotheses).collect();
        let message = self.joined(&all).or_else(|| self.moving_place(&all))?;
        Some(self.finding(Verdict::Unreadable, message))
    }

    /// A family that is joined of several in this claim: which of them is meant is not clear. What is defined by sums
    /// over it is.
    fn joined(&self, formulas: &[&Expr]) -> Option<String> {
        let is_named = |id: SymbolId| formulas.iter().any(|side| side.symbols().iter().any(|(known, _)| *known == id));
        let unions = self.local.iter().filter(|rule| matches!(rule.action, Action::Union(_)));
        let rule = unions.into_iter().find(|rule| is_named(rule.symbol))?;
        let name = text::plain(&self.model.name(rule.symbol));
        Some(format!("{name} is joined of several families here, so which of them is printed is not clear"))
    }

    /// A dot on what depends on the place under an integral: nothing says how the matter there moves.
    fn moving_place(&self, formulas: &[&Expr]) -> Option<String> {
        let mut seen = Vec::new();
        let name = formulas.iter().find_map(|formula| moving_place(formula, &[], self.model, &mut seen))?;
        let name = text::plain(&self.model.name(name));
        Some(format!(
            "there is a dot on the place {name} that is integrated over, and nothing says how the matter there moves; \
             write its velocity out"
        ))
    }
}

/// What has a dot on it, in a formula or in the definitions that it stands on, and depends on the place of an integral;
/// `under` are that place and what fills the continuum there, if the formula stands in one.
fn moving_place(
    formula: &Expr,
    under: &[SymbolId],
    model: &Model,
    seen: &mut Vec<(SymbolId, Vec<SymbolId>)>,
) -> Option<SymbolId> {
    let moves = |expr: &Expr| under.first().copied().filter(|_| model.depends_on(expr, under));
    match &formula.node {
        Node::Integral(region, body) => {
            let entry = model.symbols.entry(*region);
            let place = entry.argument.as_ref().and_then(|name| model.symbols.find(name)).map(|(id, _)| id);
            let under: Vec<SymbolId> = place.into_iter().chain(entry.density).collect();
            return moving_place(body, &under, model, seen);
        }
        Node::TimeDerivative(_, inner) if moves(inner).is_some() => return moves(inner),
        Node::Symbol { dots: 1.., .. } if moves(formula).is_some() => return moves(formula),
        Node::Symbol { id, .. } if !seen.iter().any(|(known, at)| (*known, &at[..]) == (*id, under)) => {
            seen.push((*id, under.to_vec()));
            if let Some(Meaning::Defined(definition)) = model.meaning(*id) {
                return moving_place(definition, under, model, seen);
            }
        }
        _ => {}
    }
    formula.children().into_iter().find_map(|inner| moving_place(inner, under, model, seen))
}
