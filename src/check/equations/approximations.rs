//! Statements with ≈: their finding, and what they say about the definitions of names that they use; so do equations that are
//! printed with = and hold to first order in a small motion.

use std::cell::OnceCell;

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, Relation, SymbolId};
use crate::notes::claims::Claim;
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::document::names::shown;
use crate::check::hypotheses::rule::Rule;
use crate::check::kinds::definitions::Approximations;
use crate::check::kinds::limit;
use crate::check::kinds::series::{self, Read};
use crate::check::kinds::small;
use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::sampling::Spread;
use crate::check::sample::context::Context;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

impl Checker<'_> {
    /// The finding on two members with ≈ between them. `place` is that of the sign, and `from` that of the left member, in
    /// the text that was read.
    ///
    /// # Errors
    /// For a `limit` or `small` that does not fit the notes, and when the system's mass matrix is singular.
    pub(crate) fn approximation(
        &self,
        link: &Link,
        claim: &Claim,
        place: Span,
        (from, context): (Span, &Context<'_>),
    ) -> Result<Finding> {
        let link = &match series::of(link, claim.small.is_empty() && claim.limit.is_none(), self.model) {
            Read::Plain => link.clone(),
            Read::Unclear(why) => return Ok(context.finding(Code::NeedsLimitOrSmall, Verdict::Undecided, why)),
            Read::Cut(cut) => cut,
            Read::Series(series) => return series.check(context),
        };
        if !claim.small.is_empty() {
            return self.small(link, claim, context);
        }
        if let Some(limit) = &claim.limit {
            let (variable, towards) = self.limit(limit)?;
            return limit::check(link, variable, towards, context);
        }
        if let Some(found) = self.inferred_small(link, context)? {
            return Ok(found);
        }
        let span = place.shifted(context.span.start - from.start);
        let message = self.needs_limit_or_small(link, span);
        Ok(Finding { span, ..context.finding(Code::NeedsLimitOrSmall, Verdict::Unreadable, message) })
    }
}

/// A statement with ≈, or an equation that may hold to first order, that uses a name.
struct Approximation<'c> {
    id: String,
    link: Link,
    /// The place of its display.
    span: Span,
    claim: Option<&'c Claim>,
    hypotheses: Vec<Hypothesis>,
    local: Vec<Rule>,
    /// Whether it holds with the definitions as printed, once that was asked.
    held: OnceCell<bool>,
}

/// The statements with ≈ in which a name stands that a display defines.
pub(crate) struct ApproximateUses<'d, 'a> {
    checker: &'d Checker<'a>,
    symbol: SymbolId,
    uses: Vec<Approximation<'a>>,
}

impl<'d, 'a> ApproximateUses<'d, 'a> {
    /// The uses of `symbol` with ≈, in equations that are expected to pass.
    ///
    /// # Errors
    /// For a claim that does not fit the notes.
    pub fn of(checker: &'d Checker<'a>, symbol: SymbolId) -> Result<Self> {
        Self::with(checker, symbol, false)
    }

    /// The uses of `symbol` with =, in equations of a small motion.
    ///
    /// # Errors
    /// For a claim that does not fit the notes.
    pub fn linear(checker: &'d Checker<'a>, symbol: SymbolId) -> Result<Self> {
        Self::with(checker, symbol, true)
    }

    fn with(checker: &'d Checker<'a>, symbol: SymbolId, linear: bool) -> Result<Self> {
        let mut uses = Vec::new();
        for (at, reading) in checker.readings.iter().enumerate().filter(|(at, _)| !checker.is_law(*at)) {
            let claim = checker.assigned[at];
            if claim.is_some_and(|claim| claim.expect.is_some() || !claim.errata.is_empty() || claim.skip.is_some()) {
                continue;
            }
            let span = checker.notes.equations[at].body;
            let none = Claim::default();
            let says_small = || checker.says_small(claim.unwrap_or(&none), span).is_some();
            for statement in reading.statements.iter().flatten() {
                for (k, (relation, _)) in statement.relations.iter().enumerate() {
                    let sides = &statement.members[k..k + 2];
                    let is_use = |side: &Expr| checker.model.depends_on(side, &[symbol]);
                    // What defines the name holds for any formula.
                    let defines = || sides.iter().any(|side| side.as_plain_symbol() == Some(symbol));
                    let is_meant = match linear {
                        true => is_equality(*relation) && !defines() && says_small(),
                        false => *relation == Relation::Approximately,
                    };
                    if !is_meant || !sides.iter().any(is_use) {
                        continue;
                    }
                    let of = claim.unwrap_or(&none);
                    let (hypotheses, local) = (checker.hypotheses(of)?, checker.local(of)?);
                    let link = checker.link(&sides[0], *relation, &sides[1])?;
                    let id = format!("({})", shown(&checker.notes.equations[at]));
                    let held = OnceCell::new();
                    uses.push(Approximation { id, link, span, claim, hypotheses, local, held });
                }
            }
        }
        Ok(ApproximateUses { checker, symbol, uses })
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.uses.is_empty()
    }

    fn holds(&self, of: &Approximation<'_>, model: &Model) -> Result<bool> {
        let checker = Checker { model, units: None, ..*self.checker };
        let Approximation { id, link, span, claim, hypotheses, local, .. } = of;
        let context = Context {
            model,
            options: checker.options,
            hypotheses,
            on_shell: None,
            topic: id,
            span: *span,
            spread: Spread::Declared,
            local,
        };
        let none = Claim::default();
        let claim = claim.unwrap_or(&none);
        if link.relation == Relation::Approximately {
            let found = checker.approximation(link, claim, Span::default(), (Span::default(), &context))?;
            return Ok(found.verdict.passes());
        }
        // With another definition a few families of states suffice to refute it.
        if !std::ptr::eq(model, self.checker.model) {
            let Some(ways) = checker.small_motion_of(claim, *span) else { return Ok(true) };
            let families = small::screen(model, context.mode(true, &[&link.lhs, &link.rhs]), &ways, &context)?;
            return Ok(!small::misses_order(link, 1, &families));
        }
        Ok(checker.to_first_order(link, claim, &context)?.is_some_and(|found| found.verdict.passes()))
    }

    /// Whether a use holds with the definitions as printed.
    fn held(&self, of: &Approximation<'_>) -> Result<bool> {
        if let Some(held) = of.held.get() {
            return Ok(*held);
        }
        let held = self.holds(of, self.checker.model)?;
        Ok(*of.held.get_or_init(|| held))
    }
}

impl Approximations for ApproximateUses<'_, '_> {
    fn holding(&self) -> Result<Vec<String>> {
        let mut names = Vec::new();
        for of in &self.uses {
            if self.held(of)? && !names.contains(&of.id) {
                names.push(of.id.clone());
            }
        }
        Ok(names)
    }

    fn detect(&self, mutant: &Expr) -> bool {
        // A name cannot be defined by itself.
        if self.checker.model.depends_on(mutant, &[self.symbol]) {
            return true;
        }
        let mut model = self.checker.model.clone();
        model.define(self.symbol, mutant.clone());
        let held = |of: &Approximation<'_>| self.held(of).is_ok_and(|held| held);
        self.uses.iter().any(|of| held(of) && !self.holds(of, &model).is_ok_and(|holds| holds))
    }
}
