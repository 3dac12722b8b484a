//! Mistakes in a chain `a = b = c`: which member is wrong, and how many mistakes there are.
//!
//! A wrong member breaks two links. So the members around failing links are compared: where `a = b` and `b = c` fail and
//! `a = c` holds, only b is wrong. Where the links after a failing link hold, the later members follow from the wrong one,
//! and are not mistakes of their own.

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, Relation, Statement, text};

use crate::check::document::checker::Checker;
use crate::check::judge::identity;
use crate::check::model::claim::is_equality;
use crate::check::sample::context::{Context, Options};
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// A link of a chain with its finding.
pub(crate) struct JudgedLink {
    /// The index of the member that it starts from.
    pub at: usize,
    /// The relation.
    pub relation: Relation,
    /// What was found.
    pub finding: Finding,
}

impl JudgedLink {
    fn fails(&self) -> bool {
        is_equality(self.relation) && self.finding.verdict == Verdict::Refuted
    }

    /// Whether it is an equality that holds.
    pub fn holds(&self) -> bool {
        is_equality(self.relation) && self.finding.verdict.holds()
    }
}

impl Checker<'_> {
    /// The findings on the mistakes in a chain, in their order. None, if no equality is refuted, or if a link is neither
    /// refuted nor passes.
    pub(crate) fn mistakes(
        &self,
        statement: &Statement,
        links: &mut [JudgedLink],
        context: &Context<'_>,
    ) -> Result<Vec<Finding>> {
        let members = statement.members.len();
        if members < 3
            || !self.options.explain
            || links.iter().any(|step| !step.fails() && !step.finding.verdict.passes())
        {
            return Ok(Vec::new());
        }
        let failing: Vec<usize> = (0..links.len()).filter(|n| links[*n].fails()).collect();
        let link =
            |links: &[JudgedLink], at: usize| links.iter().find(|step| step.at == at).is_some_and(JudgedLink::holds);
        let mut mistakes = Vec::new();
        let mut next = 0;
        while let Some(n) = failing.get(next).copied() {
            let (before, wrong) = (links[n].at, links[n].at + 1);
            let carried = (wrong..members - 1).take_while(|at| link(links, *at)).count();
            // Where a later member equals the one before, the members between are wrong.
            let back = failing.get(next + 1).map(|m| links[*m].at).filter(|at| *at == wrong + carried);
            let returns = match back {
                Some(at) => self.agree(&statement.members[before], &statement.members[at + 1], context)?,
                None => false,
            };
            next += if returns { 2 } else { 1 };
            let mut finding = links[n].finding.clone();
            let named = |at: usize| text::formula(&statement.members[at], &self.model.symbols);
            if returns {
                let what = match carried {
                    0 => "is wrong here",
                    _ => "and what follows from it are wrong here",
                };
                let only = format!("; only “{}” {what}, because the members before and after agree", named(wrong));
                finding.message.push_str(&only);
            } else if carried > 0 {
                finding.message.push_str("; the rest of the chain follows from this mistake");
            }
            // The members before this one are correct, so they are not part of the finding.
            if returns || before > 0 && link(links, before - 1) {
                finding.span = statement.members[wrong].span.shifted(context.span.start - statement.span.start);
            }
            finding.carried = carried;
            mistakes.push(finding);
        }
        Ok(mistakes)
    }

    /// In a chain with a 0, a member that is 0 on shell is claimed to be 0, and not to equal the next member.
    pub(crate) fn zeros(&self, statement: &Statement, links: &mut [JudgedLink], context: &Context<'_>) -> Result<()> {
        let Some(zero) = statement.members.iter().find(|member| member.is_null()) else { return Ok(()) };
        // Hypotheses may make both members 0 though they differ otherwise.
        let is_plain = context.hypotheses.iter().all(|hypothesis| hypothesis.implied);
        if !is_plain || !statement.relations.iter().all(|(relation, _)| is_equality(*relation)) {
            return Ok(());
        }
        for step in links.iter_mut().filter(|step| step.finding.code == Code::SideAlwaysZero) {
            let link = self.link(&statement.members[step.at], Relation::Equal, zero)?;
            step.finding = identity::check(&link, &Context { span: step.finding.span, ..*context })?;
        }
        Ok(())
    }

    /// Whether two members of a chain are equal.
    fn agree(&self, a: &Expr, b: &Expr, context: &Context<'_>) -> Result<bool> {
        let Ok(link) = self.link(a, Relation::Equal, b) else { return Ok(false) };
        let options = Options { explain: false, ..context.options };
        let found = identity::check(&link, &Context { options, ..*context })?;
        // A member that is repeated says nothing new, and agrees.
        Ok(found.verdict.holds() || link.lhs == link.rhs)
    }
}
