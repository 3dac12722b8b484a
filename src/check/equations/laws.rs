//! Laws: statements that the claims file assumes, and the checks that they are needed and consistent.
//!
//! A law is not checked. But it must not hold without being assumed, nor be given beside a system. Laws must also leave
//! states to test at: laws that contradict each other, or allow only one value of a quantity that varies, would make
//! every claim pass.

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, Statement, text};

use crate::check::document::checker::Checker;
use crate::check::document::reread::says_the_same;
use crate::check::judge::identity;
use crate::check::model::claim::{Law, Link};
use crate::check::sample::context::Context;
use crate::check::sample::setting::FEWEST;
use crate::check::sample::unmet_hypotheses;
use crate::check::vacuity::forced_value;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

impl Checker<'_> {
    /// The finding on a statement that the claims file calls a law; `None`, if the statement is not one.
    pub(crate) fn law(&self, display: usize, statement: &Statement, context: &Context<'_>) -> Result<Option<Finding>> {
        // A statement of another print is the law only if it is the same statement.
        let is_law = |place: &(usize, usize)| {
            let law = self.readings[place.0].statements.get(place.1);
            place.0 == display && law.is_some_and(|law| law.as_ref().is_ok_and(|law| says_the_same(law, statement)))
        };
        // A law that the claims file writes out is a law wherever the notes print it.
        let mut links = Vec::new();
        for (at, (relation, _)) in statement.relations.iter().enumerate() {
            links.push(self.link(&statement.members[at], *relation, &statement.members[at + 1])?);
        }
        let written = |law: &Law| {
            let same = |link: &Link| law.hypotheses.iter().any(|c| c.lhs == link.lhs && c.rhs == link.rhs);
            law.printed.is_empty() && !law.derived && !links.is_empty() && links.iter().all(same)
        };
        let is_here = |law: &&Law| law.printed.iter().any(is_law) || written(law);
        let Some(law) = self.model.laws.iter().find(is_here) else { return Ok(None) };
        for link in &links {
            let always = Context { on_shell: Some(false), hypotheses: &[], local: &[], ..*context };
            let finding = identity::check(link, &always)?;
            // A definition in a display of several laws is checked like any definition.
            if finding.verdict == Verdict::Definition && law.printed.len() > 1 {
                return Ok(None);
            }
            if finding.verdict.passes() {
                let message = format!(
                    "this is not a law, because it can be checked ({}); remove it from `laws`",
                    finding.message
                );
                return Ok(Some(context.finding(Code::NotALaw, Verdict::Undecided, message)));
            }
            if self.model.system.is_some() {
                let message = "the Lagrangian or the system determines the motion, so this cannot be a law; remove it \
                               from `laws`, so that it is checked";
                return Ok(Some(context.finding(Code::NotALaw, Verdict::Undecided, message)));
            }
        }
        if let Some(finding) = self.too_strong(&links, context)? {
            return Ok(Some(finding));
        }
        Ok(Some(context.finding(Code::Law, Verdict::Law, law.granted())))
    }

    /// The finding that no sampled state satisfies all laws, or that they allow only one value of a varying quantity.
    fn too_strong(&self, links: &[Link], context: &Context<'_>) -> Result<Option<Finding>> {
        let lawful = Context { on_shell: Some(true), hypotheses: &[], local: &[], ..*context };
        let sides: Vec<&Expr> = links.iter().flat_map(|link| [&link.lhs, &link.rhs]).collect();
        let ensemble = lawful.ensemble(lawful.mode(true, &sides), false, FEWEST)?;
        let names: Vec<&str> = self.model.laws.iter().map(|law| law.name.as_str()).collect();
        if ensemble.states.is_empty() {
            let message = format!(
                "no sampled state satisfies the laws ({}), that is, {}",
                names.join(", "),
                unmet_hypotheses::explanation(&ensemble.projection)
            );
            return Ok(Some(context.finding(Code::LawsTooStrong, Verdict::Undecided, message)));
        }
        let forced = forced_value::of_formulas(&sides, &lawful, &ensemble);
        Ok(forced.map(|symbol| {
            let name = text::plain(&self.model.name(symbol));
            let message = format!(
                "the laws ({}) allow only one value of {name}; correct them, or declare {name} a constant",
                names.join(", ")
            );
            context.finding(Code::LawsTooStrong, Verdict::Undecided, message)
        }))
    }
}
