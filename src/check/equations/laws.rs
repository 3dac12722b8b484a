//! Laws: equations that hold and are not checked, and the cases in which such an equation is not a law.
//!
//! A law is declared in the claims file. It must not be true anyway, and not stand beside a system. Laws must leave
//! states to test at: laws that contradict each other, or that leave one value for something that is said to vary,
//! would let anything pass.

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, Statement, text};

use crate::check::document::checker::Checker;
use crate::check::document::reread::says_the_same;
use crate::check::judge::identity;
use crate::check::model::claim::{Law, Link};
use crate::check::sample::context::Context;
use crate::check::sample::setting::FEWEST;
use crate::check::vacuity::forced_value;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

impl Checker<'_> {
    /// The verdict on a statement that the claims file calls a law: it is not checked, unless it can be.
    pub(crate) fn law(&self, display: usize, statement: &Statement, context: &Context<'_>) -> Result<Option<Finding>> {
        // What another print has in the place of a law is no law, unless it says the same.
        let is_law = |place: &(usize, usize)| {
            let law = self.readings[place.0].statements.get(place.1);
            place.0 == display && law.is_some_and(|law| law.as_ref().is_ok_and(|law| says_the_same(law, statement)))
        };
        // A law that the claims file writes out is one wherever the notes print it.
        let mut links = Vec::new();
        for (at, (relation, _)) in statement.relations.iter().enumerate() {
            links.push(self.link(&statement.members[at], *relation, &statement.members[at + 1])?);
        }
        let written = |law: &Law| {
            let same = |link: &Link| law.hypotheses.iter().any(|c| c.lhs == link.lhs && c.rhs == link.rhs);
            law.printed.is_empty() && !links.is_empty() && links.iter().all(same)
        };
        let is_here = |law: &&Law| law.printed.iter().any(is_law) || written(law);
        let Some(law) = self.model.laws.iter().find(is_here) else { return Ok(None) };
        for link in &links {
            let always = Context { on_shell: Some(false), hypotheses: &[], local: &[], ..*context };
            let finding = identity::check(link, &always)?;
            // What a display of laws says of a name in passing is checked as any definition is.
            if finding.verdict == Verdict::Definition && law.printed.len() > 1 {
                return Ok(None);
            }
            if finding.verdict.passes() {
                let message =
                    format!("this is not a law, because it can be checked: {}; remove it from `laws`", finding.message);
                return Ok(Some(context.finding(Code::NotALaw, Verdict::Undecided, message)));
            }
            if self.model.system.is_some() {
                let message = "the system determines the motion, so this cannot be a law; remove it from `laws`";
                return Ok(Some(context.finding(Code::NotALaw, Verdict::Undecided, message)));
            }
        }
        if let Some(finding) = self.leaves_no_choice(&links, context)? {
            return Ok(Some(finding));
        }
        Ok(Some(context.finding(Code::Law, Verdict::Law, format!("assumed, not checked: {}", law.title()))))
    }

    /// What is wrong with the laws together, on the statement of one: no state obeys them, or hardly any does.
    fn leaves_no_choice(&self, links: &[Link], context: &Context<'_>) -> Result<Option<Finding>> {
        let lawful = Context { on_shell: Some(true), hypotheses: &[], local: &[], ..*context };
        let sides: Vec<&Expr> = links.iter().flat_map(|link| [&link.lhs, &link.rhs]).collect();
        let ensemble = lawful.ensemble(lawful.mode(true, &sides), false, FEWEST)?;
        let names: Vec<&str> = self.model.laws.iter().map(|law| law.name.as_str()).collect();
        if ensemble.states.is_empty() {
            let message =
                format!("no sampled state satisfies the laws ({}); check them against each other", names.join(", "));
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
