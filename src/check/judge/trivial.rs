//! Claims that are decided without a state: both sides the same formula, a hypothesis, a law.

use crate::code::Code;
use crate::formula::Expr;

use crate::check::certificate::formulas;
use crate::check::hypotheses::rule::Action;
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::meaning::Meaning;
use crate::check::sample::context::Context;
use crate::check::vacuity::tautology;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// The finding on a claim that is decided without a state, if it is.
pub(crate) fn trivial(link: &Link, context: &Context<'_>) -> Option<Finding> {
    if link.lhs == link.rhs {
        return Some(context.finding(
            Code::SameFormula,
            Verdict::Undecided,
            "both sides are the same formula, so nothing is checked; write the step that is claimed",
        ));
    }
    let opened = |expr: &Expr| match expr.as_plain_symbol().and_then(|id| context.model.meaning(id)) {
        Some(Meaning::Defined(formula)) => formula.as_ref().clone(),
        _ => expr.clone(),
    };
    if is_equality(link.relation) && opened(&link.lhs) == opened(&link.rhs) {
        return Some(context.finding(
            Code::TrueByDefinition,
            Verdict::Definition,
            "true by definition: this formula defines the symbol",
        ));
    }
    if let Some(finding) = context.unclear(&[&link.lhs, &link.rhs]) {
        return Some(finding);
    }
    for rule in context.local {
        let bare =
            [&link.lhs, &link.rhs].into_iter().any(|side| side.symbols().iter().any(|(id, _)| *id == rule.symbol));
        match &rule.action {
            Action::Equals(formula)
                if bare
                    && ([&link.lhs, &link.rhs].into_iter().any(|side| opened(side) == *formula)
                        || tautology::is_linear_in(link, rule.symbol)
                            && formulas::is_identity_where(&link.lhs, &link.rhs, context.local, context.model)) =>
            {
                return Some(context.finding(
                    Code::RestatesHypothesis,
                    Verdict::Undecided,
                    "this only restates what \"where\" says, so nothing is checked; leave it out there",
                ));
            }
            _ => {}
        }
    }
    let is_hypothesis = |c: &Hypothesis| {
        c.relation == link.relation
            && (c.lhs == link.lhs && c.rhs == link.rhs || c.lhs == link.rhs && c.rhs == link.lhs)
    };
    if let Some(law) = context.model.laws.iter().find(|law| !law.derived && law.hypotheses.iter().any(is_hypothesis)) {
        return (context.on_shell != Some(false)).then(|| context.finding(Code::Law, Verdict::Law, law.granted()));
    }
    context.hypotheses.iter().any(is_hypothesis).then(|| {
        context.finding(
            Code::RestatesHypothesis,
            Verdict::Undecided,
            "this is one of its own hypotheses, so nothing is checked; remove that hypothesis",
        )
    })
}
