//! Statements with ≈: their finding, and what they say about the definitions of names that they use; so do equations that are
//! printed with = and hold to first order in a small motion.

use std::cell::OnceCell;

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, Node, Relation, Sign, SymbolId, text};
use crate::latex::{name_search, read_formula};
use crate::notes::claims::{Claim, Spanned};
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::document::inferred::prose;
use crate::check::document::names::shown;
use crate::check::hypotheses::rule::Rule;
use crate::check::judge::term_fit;
use crate::check::kinds::definitions::Approximations;
use crate::check::kinds::limit;
use crate::check::kinds::mechanics::equilibrium;
use crate::check::kinds::series::{self, Read};
use crate::check::kinds::small;
use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::meaning::{Meaning, Variable};
use crate::check::model::order::derivatives;
use crate::check::model::sampling::Spread;
use crate::check::sample::context::Context;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

/// What came of an equation in small motion.
pub(crate) enum FirstOrder {
    /// Nothing says that the motion is small.
    NotMeant,
    /// It holds, or it could not be decided.
    Judged(Box<Finding>),
    /// It is false to first order about these places.
    Fails(String),
}

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
        let expanded = self.expanded_solution(link, context)?;
        let link = expanded.as_ref().unwrap_or(link);
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

    /// Whether a hypothesis says that the motion is a small oscillation, so that equations hold to first order.
    pub(crate) fn is_small(&self, latex: &str) -> bool {
        latex.trim_start().starts_with("small oscillations")
    }

    /// The finding on an equation that was refuted and holds to first order in all coordinates about a place, where the claim or the
    /// words before the display say so: a linearised equation is often printed with =. Where small motion cannot be tried, it is not
    /// decided. What fails to first order too says so, and terms that would make it exact are not sought.
    ///
    /// # Errors
    /// When the system's mass matrix is singular.
    pub(crate) fn in_first_order(
        &self,
        link: &Link,
        found: Finding,
        claim: &Claim,
        context: &Context<'_>,
    ) -> Result<Finding> {
        if found.verdict != Verdict::Refuted {
            return Ok(found);
        }
        Ok(match self.to_first_order(link, claim, context)? {
            FirstOrder::NotMeant => term_fit::fitted(link, context, found),
            FirstOrder::Judged(judged) => *judged,
            FirstOrder::Fails(places) => {
                let message = format!("{}, also to first order about {places}", found.message);
                Finding { message, difference: None, ..found }
            }
        })
    }

    /// Whether an equation holds to first order in all coordinates about a place.
    ///
    /// # Errors
    /// When the system's mass matrix is singular.
    pub(crate) fn to_first_order(&self, link: &Link, claim: &Claim, context: &Context<'_>) -> Result<FirstOrder> {
        // A claim that says what is small is about ≈, and = says more.
        if !claim.small.is_empty() {
            return Ok(FirstOrder::NotMeant);
        }
        if self.model.system.is_none() {
            let is_said = claim.assume.iter().any(|latex| self.is_small(&latex.value)) && !self.options.deduction;
            let message = "small oscillations need a Lagrangian, and there is none; write ≈ instead, and name the \
                           small quantities under \"small\"";
            return Ok(match is_said {
                true => {
                    FirstOrder::Judged(Box::new(context.finding(Code::ClaimDoesNotFit, Verdict::Undecided, message)))
                }
                false => FirstOrder::NotMeant,
            });
        }
        let Some(said) = self.says_small(claim, context.span) else { return Ok(FirstOrder::NotMeant) };
        let open = |message: &str| match self.options.deduction {
            // Without a claims file, what is not decided is taken for granted.
            true => Ok(FirstOrder::NotMeant),
            false => {
                let finding = context.finding(Code::NotDecided, Verdict::Undecided, message.to_owned());
                Ok(FirstOrder::Judged(Box::new(finding)))
            }
        };
        let Some(mut places) = self.places_of(&said) else {
            return open(
                "this does not hold exactly, and it was not tested to first order, because the place of the small \
                 oscillations cannot be read; write it as “small oscillations about x = 0”",
            );
        };
        if said.is_empty() {
            places = self.places_of_distances([&link.lhs, &link.rhs].into_iter());
        }
        let has_letters = places.iter().any(|(_, value)| !value.symbols().is_empty());
        // Of one coordinate, a place with letters is one of rest, which says what they are. Others may go on moving.
        let is_alone = has_letters && self.model.coordinates.len() == 1;
        let rest = if is_alone { equilibrium::rest_at(&places, context) } else { None };
        let is_of_rest = rest.is_some();
        let hypotheses: Vec<Hypothesis> =
            context.hypotheses.iter().cloned().chain(rest.into_iter().flatten()).collect();
        let context = &Context { hypotheses: &hypotheses, ..*context };
        let (small, rates) = self.small_motion(&said, &places);
        let close = Link { relation: Relation::Approximately, ..link.clone() };
        match small::of_motion(&close, &small, &rates, context) {
            Ok(linear) if linear.verdict.holds() => {
                let message = format!("about {}, this {}", self.shown(&places), linear.message);
                Ok(FirstOrder::Judged(Box::new(Finding { message, ..linear })))
            }
            // A place with a letter may also be one of a steady motion, under a condition that the claim need not contain.
            Ok(linear) if linear.code != Code::TooFewStates && (is_of_rest || !has_letters) => {
                Ok(FirstOrder::Fails(self.shown(&places)))
            }
            _ => open(&format!(
                "this does not hold exactly, and it could not be tested for small motion about {}",
                self.shown(&places)
            )),
        }
    }

    /// What a claim says of small oscillations; nothing, where only the words before the display say that the motion is small, and `None`
    /// where neither does.
    pub(crate) fn says_small(&self, claim: &Claim, span: Span) -> Option<String> {
        let said = |latex: &Spanned<String>| {
            let named = self.claims.conditions.iter().find(|(name, _)| name.value == latex.value);
            let text = named.map_or(Some(&latex.value), |(_, all)| all.first().map(|latex| &latex.value));
            text.filter(|text| self.is_small(text)).cloned()
        };
        let claimed = claim.assume.iter().chain(&claim.throughout).chain(&claim.implied).find_map(said);
        let is_coordinate = |text: &str| {
            let mut names = self.model.coordinates.iter().map(|q| self.model.name(q.symbol));
            names.any(|name| name_search::same(text, &name))
        };
        claimed.or_else(|| prose::speaks_of_small(self.notes, span, is_coordinate).then(String::new))
    }

    /// The ways in which a claim, or the words before its display, say that a motion about a place is small: the coordinates are, or
    /// their rates too.
    pub(crate) fn small_motion_of(&self, claim: &Claim, span: Span) -> Option<Vec<Vec<Expr>>> {
        let is_possible = claim.small.is_empty() && self.model.system.is_some();
        let said = self.says_small(claim, span).filter(|_| is_possible)?;
        let mut places = self.places_of(&said)?;
        if said.is_empty() {
            let display = self.notes.equations.iter().position(|display| display.body.contains(span));
            let statements = display.map(|at| &self.readings[at].statements).into_iter().flatten().flatten();
            places = self.places_of_distances(statements.flat_map(|statement| &statement.members));
            // What a place with letters is, the families of states do not know.
            if places.iter().any(|(_, value)| !value.symbols().is_empty()) {
                return Some(Vec::new());
            }
        }
        let (small, rates) = self.small_motion(&said, &places);
        let both = small.iter().chain(&rates).cloned().collect();
        Some(vec![small, both])
    }

    /// The coordinates that these words put in a place other than 0, each with its value; `None`, where they cannot be read. "About
    /// \theta = \pi, \phi = 0" names one.
    fn places_of(&self, said: &str) -> Option<Vec<(SymbolId, Expr)>> {
        let mut places = Vec::new();
        for equation in said.split(',').filter(|part| part.contains('=')) {
            let (names, value) = equation.rsplit_once('=')?;
            let value = read_formula(value.trim(), &mut self.model.symbols.clone(), &self.model.macros).ok()?;
            let is_fixed = |(id, _): &(SymbolId, u8)| matches!(self.model.meaning(*id), Some(Meaning::Constant(_)));
            if !value.symbols().iter().all(is_fixed) {
                return None;
            }
            if value.is_zero() {
                continue;
            }
            let named = names.split('=').map(|name| {
                let is_it = |q: &&Variable| name_search::mentions(name, &self.model.name(q.symbol), &self.model.macros);
                let mut found = self.model.coordinates.iter().filter(is_it);
                found.next().map(|q| q.symbol).filter(|_| found.next().is_none())
            });
            places.extend(named.collect::<Option<Vec<SymbolId>>>()?.into_iter().map(|q| (q, value.clone())));
        }
        Some(places)
    }

    /// The places from which distances in formulas are measured: x_0, where ξ = x − x_0 is defined.
    fn places_of_distances<'e>(&self, formulas: impl Iterator<Item = &'e Expr>) -> Vec<(SymbolId, Expr)> {
        let mut found: Vec<(SymbolId, Expr)> = Vec::new();
        for (id, _) in formulas.flat_map(Expr::symbols) {
            let Some(Meaning::Defined(formula)) = self.model.meaning(id) else { continue };
            let Some((q, place)) = self.distance(formula) else { continue };
            if found.iter().all(|(known, _)| *known != q) {
                found.push((q, place));
            }
        }
        found
    }

    /// The coordinate and the place, where a formula is a coordinate less a place, which has constants only.
    fn distance(&self, formula: &Expr) -> Option<(SymbolId, Expr)> {
        let Node::Sum(terms) = &formula.node else { return None };
        let [first, second] = terms.as_slice() else { return None };
        let coordinate = first.expr.as_plain_symbol().filter(|id| self.model.is_coordinate(*id))?;
        let is_fixed = second.expr.symbols().iter().all(|(id, _)| {
            let is_constant = matches!(self.model.meaning(*id), Some(Meaning::Constant(_)));
            is_constant || matches!(self.model.meaning(*id), Some(Meaning::Defined(_))) && !self.moves(*id)
        });
        let place = match second.sign {
            Sign::Minus => second.expr.clone(),
            Sign::Plus => second.expr.clone().negated(),
        };
        (first.sign == Sign::Plus && is_fixed).then_some((coordinate, place))
    }

    /// Whether a name depends on a coordinate or on the time.
    fn moves(&self, id: SymbolId) -> bool {
        let coordinates: Vec<SymbolId> =
            self.model.coordinates.iter().chain(&self.model.varying).map(|q| q.symbol).collect();
        let name = Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, Span::default());
        self.model.symbol_depends_on(id, &coordinates) || self.model.contains_time(&name)
    }

    /// These places in words; 0, if there is none.
    fn shown(&self, places: &[(SymbolId, Expr)]) -> String {
        let one = |(q, value): &(SymbolId, Expr)| {
            format!("{} = {}", text::plain(&self.model.name(*q)), text::formula(value, &self.model.symbols))
        };
        if places.is_empty() { "0".to_owned() } else { places.iter().map(one).collect::<Vec<_>>().join(", ") }
    }

    /// The coordinates that are small in a small motion, as distances from their places, and their rates, without what constraints
    /// give: of each the last coordinate in it that `named` does not name.
    fn small_motion(&self, named: &str, places: &[(SymbolId, Expr)]) -> (Vec<Expr>, Vec<Expr>) {
        let model = self.model;
        let multipliers = model.system.as_ref().map_or(&[][..], |system| system.multipliers());
        let is_multiplier = |at: usize| multipliers.contains(&at);
        let all: Vec<SymbolId> = model.coordinates.iter().map(|q| q.symbol).collect();
        let is_named = |q: SymbolId| name_search::mentions(named, &model.name(q), &model.macros);
        let free = all.iter().enumerate().filter(|(at, _)| !is_multiplier(*at)).map(|(_, q)| *q);
        let order: Vec<SymbolId> = free.collect();
        let (mut given, mut given_rates): (Vec<SymbolId>, Vec<SymbolId>) = (Vec::new(), Vec::new());
        for constraint in model.constraints.iter().map(|known| &known.lhs) {
            if matches!(constraint.node, Node::TimeDerivative(..)) {
                // The rate of a constraint that was there before it.
                continue;
            }
            let is_rolling = derivatives(constraint, model) > 0;
            let dots = u8::from(is_rolling);
            let symbols = constraint.symbols();
            let list = if is_rolling { &mut given_rates } else { &mut given };
            let stands = |q: &&SymbolId| symbols.contains(&(**q, dots)) && !list.contains(*q);
            let unnamed = order.iter().filter(|q| !is_named(**q)).rfind(stands);
            let next = unnamed.or_else(|| order.iter().rfind(stands)).copied();
            list.extend(next);
        }
        let quantity =
            |q: &SymbolId, dots: u8| Expr::new(Node::Symbol { id: *q, indices: Vec::new(), dots }, Span::default());
        let small: Vec<SymbolId> = all.into_iter().filter(|q| order.contains(q) && !given.contains(q)).collect();
        let rates = small.iter().filter(|q| !given_rates.contains(q)).map(|q| quantity(q, 1)).collect();
        let distance = |q: &SymbolId| match places.iter().find(|(other, _)| other == q) {
            Some((_, place)) => quantity(q, 0).minus(place.clone()),
            None => quantity(q, 0),
        };
        (small.iter().map(distance).collect(), rates)
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
        let found = checker.to_first_order(link, claim, &context)?;
        Ok(matches!(found, FirstOrder::Judged(found) if found.verdict.passes()))
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
