//! A chain `a = b = c` with a failing link: which member is wrong, and how many slips there are.
//!
//! The links are tested one by one, and a wrong member breaks two of them. So the members on either side of a
//! failing link are compared: if `a = b` and `b = c` fail and `a = c` holds, only b is wrong. If the links after a
//! failing one hold, the rest follows from the wrong member, and is no slip of its own.

use crate::Result;
use crate::formula::{Expr, Relation, Statement, text};

use crate::check::document::checker::Checker;
use crate::check::judge::identity;
use crate::check::model::claim::is_equality;
use crate::check::sample::context::{Context, Options};
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// A link of a chain that was judged.
pub(crate) struct Step {
    /// Which of its members it starts from.
    pub at: usize,
    /// The relation.
    pub relation: Relation,
    /// What was found.
    pub finding: Finding,
}

impl Step {
    fn fails(&self) -> bool {
        is_equality(self.relation) && self.finding.verdict == Verdict::Refuted
    }

    /// Whether it is an equality that holds.
    pub fn holds(&self) -> bool {
        is_equality(self.relation) && self.finding.verdict.holds()
    }
}

impl Checker<'_> {
    /// The slips in a chain, a finding each, in their order; none, if no equality of it is refuted, or if something else is
    /// worse than what can be told from the others. The findings on the links are taken from them.
    pub(crate) fn slips(
        &self,
        statement: &Statement,
        steps: &mut [Step],
        context: &Context<'_>,
    ) -> Result<Vec<Finding>> {
        let members = statement.members.len();
        if members < 3
            || !self.options.explain
            || steps.iter().any(|step| !step.fails() && !step.finding.verdict.passes())
        {
            return Ok(Vec::new());
        }
        let failing: Vec<usize> = (0..steps.len()).filter(|n| steps[*n].fails()).collect();
        let link = |steps: &[Step], at: usize| steps.iter().find(|step| step.at == at).is_some_and(Step::holds);
        let mut slips = Vec::new();
        let mut next = 0;
        while let Some(n) = failing.get(next).copied() {
            let (before, wrong) = (steps[n].at, steps[n].at + 1);
            let carried = (wrong..members - 1).take_while(|at| link(steps, *at)).count();
            // Where the chain comes back to what it was before, what lies between is wrong.
            let back = failing.get(next + 1).map(|m| steps[*m].at).filter(|at| *at == wrong + carried);
            let returns = match back {
                Some(at) => self.agree(&statement.members[before], &statement.members[at + 1], context)?,
                None => false,
            };
            next += if returns { 2 } else { 1 };
            let mut finding = steps[n].finding.clone();
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
            // What was right so far is not to be mended.
            if returns || before > 0 && link(steps, before - 1) {
                finding.span = statement.members[wrong].span.shifted(context.span.start - statement.span.start);
            }
            finding.carried = carried;
            slips.push(finding);
        }
        Ok(slips)
    }

    /// Whether two members of a chain are one.
    fn agree(&self, a: &Expr, b: &Expr, context: &Context<'_>) -> Result<bool> {
        let Ok(link) = self.link(a, Relation::Equal, b) else { return Ok(false) };
        let options = Options { explain: false, ..context.options };
        let found = identity::check(&link, &Context { options, ..*context })?;
        // A member that is repeated says nothing new, and agrees.
        Ok(found.verdict.holds() || link.lhs == link.rhs)
    }
}
