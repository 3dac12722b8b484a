//! The members of families that formulas name: `m_1`, and the ends that a Σ leaves out.

use crate::formula::tree::Excluded;
use crate::formula::{Expr, Index, IndexId, Node, SymbolId};

use crate::check::hypotheses::rule::{Action, Rule};
use crate::check::model::Model;
use crate::check::model::meaning::Meaning;

/// The members that formulas name, through definitions and rules.
pub(crate) struct NamedMembers<'a> {
    model: &'a Model,
    rules: &'a [Rule],
    seen: Vec<SymbolId>,
    /// The highest number that is named.
    pub(crate) first: u8,
    /// The number of members at the end that a Σ leaves out.
    pub(crate) last: u8,
}

impl<'a> NamedMembers<'a> {
    /// The members that some formulas name.
    pub(crate) fn of(formulas: &[&Expr], model: &'a Model, rules: &'a [Rule]) -> Self {
        let mut named = NamedMembers { model, rules, seen: Vec::new(), first: 0, last: 0 };
        formulas.iter().for_each(|formula| named.follow(formula));
        named
    }

    fn follow(&mut self, formula: &Expr) {
        let indices = &self.model.symbols.indices;
        let is_counted = |letter: &IndexId| indices[letter.0].count.is_some();
        let mut symbols = Vec::new();
        formula.walk(&mut |expr| match &expr.node {
            Node::Symbol { id, indices, .. } => {
                symbols.push(*id);
                for (index, (_, letter)) in indices.iter().zip(&self.model.symbols.entry(*id).slots) {
                    if let (Index::Fixed(value), true) = (index, is_counted(letter)) {
                        self.first = self.first.max(*value);
                    }
                }
            }
            Node::SumOver { index, except, .. } if is_counted(index) => {
                for left_out in except {
                    match (left_out, left_out.index()) {
                        (Excluded::Last(last), _) => self.last = self.last.max(*last),
                        (_, Some(Index::Fixed(value))) => self.first = self.first.max(value),
                        _ => {}
                    }
                }
            }
            _ => {}
        });
        symbols.into_iter().for_each(|id| self.visit(id));
    }

    fn visit(&mut self, id: SymbolId) {
        if self.seen.contains(&id) {
            return;
        }
        self.seen.push(id);
        let (model, rules) = (self.model, self.rules);
        model.symbols.entry(id).members.iter().for_each(|member| self.visit(*member));
        for rule in rules.iter().filter(|rule| rule.symbol == id) {
            if let Action::Union(parts) = &rule.action {
                parts.iter().for_each(|part| self.follow(part));
            }
            rule.action.formulas().into_iter().for_each(|formula| self.follow(formula));
        }
        match model.meaning(id) {
            Some(Meaning::Defined(formula)) => self.follow(formula),
            Some(Meaning::Particles(_, _, masses, positions)) => {
                self.follow(masses);
                self.follow(positions);
            }
            _ => {}
        }
    }
}
