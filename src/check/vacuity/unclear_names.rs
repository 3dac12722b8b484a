//! Formulas with an unclear name: a family joined from several families, the motion of an integration point, and the
//! time derivative of a constant.

use crate::code::Code;
use crate::formula::tree::Node;
use crate::formula::{Expr, SymbolId, text};

use crate::check::hypotheses::rule::Action;
use crate::check::model::Model;
use crate::check::model::meaning::Meaning;
use crate::check::sample::context::Context;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

impl Context<'_> {
    /// The finding that formulas, or the hypotheses, contain an unclear name.
    pub fn unclear(&self, formulas: &[&Expr]) -> Option<Finding> {
        let hypotheses = self.hypotheses.iter().flat_map(|c| [&c.lhs, &c.rhs]);
        let all: Vec<&Expr> = formulas.iter().copied().chain(hypotheses).collect();
        let message = self.joined(&all).or_else(|| self.moving_place(&all)).or_else(|| self.moving_constant(&all))?;
        Some(self.finding(Code::UnclearName, Verdict::Unreadable, message))
    }

    /// The message about a family that is joined from several families in this claim. It may only occur in definitions,
    /// through sums over all members.
    fn joined(&self, formulas: &[&Expr]) -> Option<String> {
        let is_named = |id: SymbolId| formulas.iter().any(|side| side.symbols().iter().any(|(known, _)| *known == id));
        let unions = self.local.iter().filter(|rule| matches!(rule.action, Action::Union(_)));
        let rule = unions.into_iter().find(|rule| is_named(rule.symbol))?;
        let name = text::plain(&self.model.name(rule.symbol));
        Some(format!("{name} stands for several families here; use a different letter for each of them"))
    }

    /// The message about a dot on a quantity that depends on the point of an integral: the motion of the matter is not
    /// known.
    fn moving_place(&self, formulas: &[&Expr]) -> Option<String> {
        let mut seen = Vec::new();
        let name = formulas.iter().find_map(|formula| moving_place(formula, &[], self.model, &mut seen))?;
        let name = text::plain(&self.model.name(name));
        Some(format!(
            "there is a dot on {name}, the point that the integral runs over, and nothing says how the matter there \
             moves; write its velocity instead"
        ))
    }
}

impl Context<'_> {
    /// The message about a dot on a constant: as 0 it would make any factor beside it pass.
    fn moving_constant(&self, formulas: &[&Expr]) -> Option<String> {
        let mut seen = Vec::new();
        let name = formulas.iter().find_map(|formula| moving_constant(formula, self.model, &mut seen))?;
        let what = match self.model.meaning(name) {
            Some(Meaning::Time) => "which is the time; remove the dot",
            _ => "which is declared as a constant; if it changes, declare it under \"varies with time\"",
        };
        Some(format!("there is a dot on {}, {what}", text::plain(&self.model.name(name))))
    }
}

/// The constant, or the time, that has a dot in a formula or in its definitions.
fn moving_constant(formula: &Expr, model: &Model, seen: &mut Vec<SymbolId>) -> Option<SymbolId> {
    let constant = |id: SymbolId| matches!(model.meaning(id), Some(Meaning::Constant(_) | Meaning::Time)).then_some(id);
    let is_constant = |id: SymbolId| matches!(model.meaning(id), Some(Meaning::Constant(_)));
    match &formula.node {
        Node::TimeDerivative(_, inner) if matches!(inner.node, Node::Symbol { .. }) => {
            let Node::Symbol { id, .. } = inner.node else { return None };
            constant(id)
        }
        // `\dot{(x + 1)}`, where nothing in the parenthesis varies.
        Node::TimeDerivative(_, inner) if inner.symbols().iter().all(|(id, _)| is_constant(*id)) => {
            inner.symbols().first().map(|(id, _)| *id)
        }
        Node::Symbol { id, dots: 1.., .. } => constant(*id),
        Node::Symbol { id, .. } if !seen.contains(id) => {
            seen.push(*id);
            let Some(Meaning::Defined(definition)) = model.meaning(*id) else { return None };
            moving_constant(definition, model, seen)
        }
        _ => formula.children().into_iter().find_map(|inner| moving_constant(inner, model, seen)),
    }
}

/// The integration point on which a dotted part of a formula, or of its definitions, depends. `under` are the point and
/// the density of the enclosing integral, if there is one.
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
