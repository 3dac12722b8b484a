//! Claims about an equation as a whole: `solves`, `also equals`, `conserved`, `generates`.

use crate::check::document::checker::Checker;
use crate::check::hypotheses::rule::Rule;
use crate::check::judge::identity;
use crate::check::kinds::{conserved, generates, same_motion, solves};
use crate::check::model::claim::Hypothesis;
use crate::check::model::sampling::Spread;
use crate::check::sample::context::Context;
use crate::check::verdict::Verdict;
use crate::check::verdict::report::Part;
use crate::code::Code;
use crate::formula::tree::Sign;
use crate::formula::{Expr, Node, Relation, Statement, SymbolId, text};
use crate::latex::{DefinedSymbol, Reading};
use crate::notes::claims::{Claim, Conserved, Holds, Solved, Spanned};
use crate::{Error, Result};

impl Checker<'_> {
    /// Adds the findings on `solves`, `also equals`, `conserved` and `generates` to the parts of an equation.
    ///
    /// # Errors
    /// For a claim that does not fit the equation, at its place in the claims file.
    pub(crate) fn whole(
        &self,
        reading: &Reading,
        claim: &Claim,
        (hypotheses, local): (&[Hypothesis], &[Rule]),
        offset: usize,
        topic: &str,
        parts: &mut Vec<Part>,
    ) -> Result<()> {
        let statements: Vec<&Statement> = reading.statements.iter().flatten().collect();
        let Some(last) = statements.last() else { return Ok(()) };
        let Some(printed) = last.members.last() else { return Ok(()) };
        let span = statements[0].span.to(last.span).shifted(offset);
        let topic = format!("{topic} whole");
        let on_shell = claim.holds.as_ref().map(|holds| holds.value == Holds::OnShell);
        let context = Context {
            model: self.model,
            options: self.options,
            hypotheses,
            on_shell,
            topic: &topic,
            span,
            spread: Spread::Declared,
            local,
        };
        if let Some(solves) = &claim.solves {
            let address = match &solves.of {
                Solved::Equation(address) => Spanned::new(address.text.clone(), address.span),
                Solved::EquationsOfMotion(span) => {
                    let message = "solutions of the equations of motion are not supported";
                    return Err(Error::at(&self.claims.source, *span, message));
                }
            };
            let [unknown] = solves.unknowns.as_slice() else {
                return Err(Error::at(&self.claims.source, address.span, "only one unknown is supported"));
            };
            let target = self.target(&address)?;
            let symbol = self.symbol(unknown)?;
            let name = text::plain(&self.model.name(symbol));
            let branches: Vec<Expr> = statements.iter().filter_map(|s| s.members.last().cloned()).collect();
            if solves.complete {
                let finding = solves::check(&target, symbol, &branches, &context)?;
                parts.push(self.part(finding, format!("all solutions of ({}) for {name}", address.value)));
            }
            if branches.len() > 1 || !solves.complete {
                for (statement, branch) in statements.iter().zip(&branches) {
                    let span = statement.span.shifted(offset);
                    let of_branch = Context { span, ..context };
                    let finding = solves::check_branch(&target, symbol, branch, &of_branch)?;
                    let reading = text::statement(statement, &self.model.symbols);
                    parts.push(self.part(finding, format!("{reading} solves ({}) for {name}", address.value)));
                }
            }
        }
        if let Some(also) = &claim.also_equals {
            let other = self.formula(also)?;
            let printed = match &claim.dropping {
                Some(dropped) => with_dropped(printed, &self.formula(dropped)?),
                None => printed.clone(),
            };
            let link = self.link(&other, Relation::Equal, &printed)?;
            let finding = match self.only_repeats(&link, &reading.introduced) {
                true => {
                    let message = "\"also equals\" only repeats the definition, so nothing is checked";
                    context.finding(Code::Circular, Verdict::Undecided, message)
                }
                false => identity::check(&link, &context)?,
            };
            let reading =
                text::formula(&link.lhs, &self.model.symbols) + " = " + &text::formula(&link.rhs, &self.model.symbols);
            parts.push(self.part(finding, reading));
        }
        if let Some(conserved) = &claim.conserved {
            // Of several statements each has something that is constant.
            let all = match &conserved.value {
                Conserved::Expression(latex) => {
                    vec![(self.formula(&Spanned::new(latex.clone(), conserved.span))?, None)]
                }
                Conserved::This => {
                    let last = statements.iter().enumerate().map(|(at, s)| Some((s.members.last()?.clone(), Some(at))));
                    last.flatten().collect()
                }
            };
            for (what, at) in all {
                let mut finding = conserved::check(&what, &context)?;
                if let Some(at) = at {
                    let introduced: Vec<&DefinedSymbol> =
                        reading.introduced.iter().filter(|i| i.statement == at).collect();
                    self.only_constant(&introduced, statements[at], &mut finding)?;
                }
                parts.push(self.part(finding, format!("{} is constant", text::formula(&what, &self.model.symbols))));
            }
        }
        if let Some(other) = &claim.same_motion_as {
            let finding = same_motion::check(printed, &self.formula(other)?, &context)?;
            parts.push(self.part(finding, format!("the same motion as {}", other.value)));
        }
        if claim.generates.is_some() {
            let finding = generates::check(printed, &context)?;
            parts.push(self.part(finding, "it generates the motion by Hamilton's equations".to_owned()));
        }
        Ok(())
    }

    /// Whether a member is the unknown that a claim solves for; the member beside it is then the solution.
    pub(crate) fn is_unknown_of(&self, member: &Expr, claim: &Claim) -> Result<bool> {
        let Some(solves) = &claim.solves else { return Ok(false) };
        let unknowns: Result<Vec<SymbolId>> = solves.unknowns.iter().map(|unknown| self.symbol(unknown)).collect();
        Ok(member.as_plain_symbol().is_some_and(|id| unknowns.is_ok_and(|unknowns| unknowns.contains(&id))))
    }
}

/// The sum `expr + dropped`: a side of a claim with the terms that its author dropped.
pub fn with_dropped(expr: &Expr, dropped: &Expr) -> Expr {
    let plus = |expr: &Expr| crate::formula::Term { sign: Sign::Plus, sign_span: None, expr: expr.clone() };
    Expr::new(Node::Sum(vec![plus(expr), plus(dropped)]), expr.span)
}

/// Whether a relation restricts states to a range instead of fixing a value.
pub(crate) fn is_inequality(relation: Relation) -> bool {
    use Relation::{Greater, GreaterEqual, Less, LessEqual, NotEqual};
    matches!(relation, Less | Greater | LessEqual | GreaterEqual | NotEqual)
}

/// Whether a formula contains another.
pub(crate) fn contains(whole: &Expr, part: &Expr) -> bool {
    let mut found = false;
    whole.walk(&mut |inner| found |= inner == part);
    found
}
