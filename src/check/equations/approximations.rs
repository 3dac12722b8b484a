//! Statements with ≈: their finding, and what they say about the definitions of names that they use.

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
use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Link};
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

/// A statement with ≈ that uses a name.
struct Approximation<'c> {
    id: String,
    link: Link,
    claim: Option<&'c Claim>,
    hypotheses: Vec<Hypothesis>,
    local: Vec<Rule>,
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
        let mut uses = Vec::new();
        for (at, reading) in checker.readings.iter().enumerate().filter(|(at, _)| !checker.is_law(*at)) {
            let claim = checker.assigned[at];
            if claim.is_some_and(|claim| claim.expect.is_some() || !claim.errata.is_empty() || claim.skip.is_some()) {
                continue;
            }
            for statement in reading.statements.iter().flatten() {
                for (k, (relation, _)) in statement.relations.iter().enumerate() {
                    let sides = &statement.members[k..k + 2];
                    let is_use = |side: &Expr| checker.model.depends_on(side, &[symbol]);
                    if *relation != Relation::Approximately || !sides.iter().any(is_use) {
                        continue;
                    }
                    let none = Claim::default();
                    let of = claim.unwrap_or(&none);
                    let (hypotheses, local) = (checker.hypotheses(of)?, checker.local(of)?);
                    let link = checker.link(&sides[0], *relation, &sides[1])?;
                    let id = format!("({})", shown(&checker.notes.equations[at]));
                    uses.push(Approximation { id, link, claim, hypotheses, local });
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
        let Approximation { id, link, claim, hypotheses, local } = of;
        let context = Context {
            model,
            options: checker.options,
            hypotheses,
            on_shell: None,
            topic: id,
            span: Span::default(),
            spread: Spread::Declared,
            local,
        };
        let none = Claim::default();
        let claim = claim.unwrap_or(&none);
        let found = checker.approximation(link, claim, Span::default(), (Span::default(), &context))?;
        Ok(found.verdict.passes())
    }
}

impl Approximations for ApproximateUses<'_, '_> {
    fn holding(&self) -> Result<Vec<String>> {
        let mut names = Vec::new();
        for of in &self.uses {
            if self.holds(of, self.checker.model)? && !names.contains(&of.id) {
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
        let holds = |of: &Approximation<'_>, model: &Model| self.holds(of, model).is_ok_and(|holds| holds);
        self.uses.iter().any(|of| holds(of, self.checker.model) && !holds(of, &model))
    }
}
