//! Whether a text says the same as the display in whose place it stands: mutation testing leaves such a text out.

use crate::Result;
use crate::formula::{Expr, Index, Node, Relation, Statement};
use crate::latex::Reading;

use crate::check::certificate::claim::Certificate;
use crate::check::certificate::signs::is_never_zero;
use crate::check::certificate::{decide, formulas};
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::meaning::Meaning;
use crate::check::sample::context::Context;
use crate::check::sample::outcome;
use crate::check::vacuity::restatement;

use super::text_trial::{Answer, STATES, Trial};

impl Trial<'_, '_> {
    /// The outcome of a text in place of the display.
    ///
    /// # Errors
    /// As for a check of the display itself.
    pub fn judge(&self, text: &str) -> Result<Answer> {
        self.judge_where(text, |_| true)
    }

    /// Whether a reading is proved over a prime field to be equal to the original member by member, or to follow from it.
    ///
    /// # Errors
    /// When the system's mass matrix is singular.
    pub fn is_equivalent(&self, reading: &Reading) -> Result<bool> {
        let original = &self.now.statements;
        if original.len() != reading.statements.len() {
            return Ok(false);
        }
        for statements in original.iter().zip(&reading.statements) {
            let (Ok(was), Ok(is)) = statements else { return Ok(false) };
            if was.members.len() != is.members.len()
                || !was.relations.iter().map(|r| r.0).eq(is.relations.iter().map(|r| r.0))
            {
                return Ok(false);
            }
            let link =
                |s: &Statement, at: usize| self.checker.link(&s.members[at], s.relations[at].0, &s.members[at + 1]);
            let alike = |at| matches!((link(was, at), link(is, at)), (Ok(a), Ok(b)) if restatement::same_but_for_letters(&a, &b));
            if (0..was.relations.len()).all(alike) {
                continue;
            }
            let mut same = true;
            for (a, b) in was.members.iter().zip(&is.members).filter(|(a, b)| a != b) {
                same = same && self.is_same(a, b)?;
            }
            let model = self.checker.model;
            let never_zero = |factor: &Expr| is_never_zero(model, factor);
            let follows = |at: usize| {
                // Only an equality may be multiplied by a factor.
                let relation = was.relations[at].0;
                let equal = is_equality(relation) || relation == Relation::Approximately;
                let null = equal && was.members[at + 1].is_null() && is.members[at + 1].is_null();
                null && formulas::vanishes_with(&is.members[at], &was.members[at], model, &never_zero)
            };
            let kept = |at: usize| is.members[at..=at + 1] == was.members[at..=at + 1];
            if !same && !(0..was.relations.len()).all(|at| kept(at) || follows(at)) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Whether two formulas are proved to be equal: for all values of their symbols, with definitions written out, or where
    /// the hypotheses of the claim hold.
    fn is_same(&self, a: &Expr, b: &Expr) -> Result<bool> {
        let model = self.checker.model;
        if formulas::same(a, b, model) || formulas::same(&self.expanded(a), &self.expanded(b), model) {
            return Ok(true);
        }
        // Formulas of different shapes are not equal.
        match self.checker.link(a, Relation::Equal, b) {
            Ok(link) => Ok(self.implied(&[], &link)? || self.implied(&self.hypotheses, &link)?),
            Err(_) => Ok(false),
        }
    }

    /// A formula with definitions written out, and with the left sides of hypotheses that hold throughout replaced by their
    /// right sides.
    fn expanded(&self, expr: &Expr) -> Expr {
        let by_hypothesis = |expr: &Expr| {
            let known = |c: &&Hypothesis| c.throughout && is_equality(c.relation) && c.lhs == *expr;
            self.hypotheses.iter().find(known).map(|hypothesis| hypothesis.rhs.clone())
        };
        if let Some(other) = by_hypothesis(expr) {
            return other;
        }
        let model = self.checker.model;
        if let Node::Symbol { id, indices, dots } = &expr.node
            && let Some(Meaning::Defined(formula)) = model.meaning(*id)
            && model
                .symbols
                .entry(*id)
                .slots
                .iter()
                .map(|(_, letter)| Index::Letter(*letter))
                .eq(indices.iter().copied())
        {
            let formula = self.expanded(formula);
            return match dots {
                0 => formula,
                dots => Expr::new(Node::TimeDerivative(*dots, Box::new(formula)), expr.span),
            };
        }
        let mut opened = expr.clone();
        opened.children_mut().into_iter().for_each(|child| *child = self.expanded(child));
        opened
    }

    /// Whether a link is an identity where some hypotheses hold.
    fn implied(&self, hypotheses: &[Hypothesis], link: &Link) -> Result<bool> {
        let context = Context { hypotheses, ..self.context(&self.topic) };
        let mode = context.mode(false, &[&link.lhs, &link.rhs]);
        let ensemble = context.ensemble(mode, false, STATES)?;
        if ensemble.states.is_empty() {
            return Ok(false);
        }
        let holds = outcome::run(link, &ensemble.states).is_ok_and(|outcome| outcome.failure.is_none());
        Ok(holds && matches!(decide::certify(link, &context, &ensemble), Certificate::Identity(_)))
    }
}
