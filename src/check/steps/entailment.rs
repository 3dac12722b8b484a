//! Entailment between steps: whether the pieces of a display follow from a false step as printed.
//!
//! A piece follows if it is equivalent to the false step, or if it passes its check in a model in which the false step holds
//! ([`super::premise`]). It differs if it is refuted in a model that determines it. Otherwise it is undecided.

use crate::Result;
use crate::formula::{Expr, Node, Relation, Statement};
use crate::latex::{DefinedSymbol, Reading};
use crate::notes::claims::Claim;
use crate::scalar::RunningError;

use crate::check::document::checker::Checker;
use crate::check::document::names::shown;
use crate::check::hypotheses::motion;
use crate::check::hypotheses::rule::Action;
use crate::check::judge::difference::entries;
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::meaning::Meaning;
use crate::check::model::sampling::Spread;
use crate::check::model::{free_symbols, order};
use crate::check::sample::context::{Context, Options};
use crate::check::sample::setting::FEWEST;
use crate::check::state::residual;
use crate::check::steps::premise::Premise;
use crate::check::verdict::Verdict;

/// Whether a step follows from a false step before it.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Entailment {
    /// It follows.
    Follows,
    /// It does not follow.
    Differs,
    /// It is undecided.
    Open,
}

/// The steps that a step is compared with.
pub(crate) struct EarlierSteps<'s> {
    /// A false step before it.
    pub from: usize,
    /// All steps before it.
    pub before: &'s [usize],
    /// Those of them that pass.
    pub sound: &'s [usize],
}

impl Checker<'_> {
    /// The false pieces of a false display; all pieces of a true one.
    ///
    /// # Errors
    /// As for a check of the display.
    pub(crate) fn wrong_pieces(&self, at: usize, wrong: bool) -> Result<Vec<Reading>> {
        let none = Claim::default();
        let claim = self.assigned[at].unwrap_or(&none);
        let quiet = self.without_explanations();
        let mut open = Vec::new();
        for piece in pieces(&self.readings[at]) {
            if !wrong || !quiet.holds(at, &piece, claim)?.0 {
                open.push(piece);
            }
        }
        Ok(open)
    }

    /// The same checker, without explanations.
    fn without_explanations(&self) -> Checker<'_> {
        Checker { options: Options { explain: false, ..self.options }, units: self.units.clone(), ..*self }
    }

    /// Whether a step claims what it prints, under hypotheses, and nothing else; only then can others follow from it.
    pub(crate) fn claims_only_what_it_prints(&self, at: usize) -> bool {
        let Some(claim) = self.assigned[at] else { return true };
        claim.is_plain() && claim.errata.is_empty() && claim.expect.is_none() && claim.meanings.is_empty()
    }

    /// The entailment of each piece of a step by a false step as printed; `wrong` says whether the pieces are false.
    ///
    /// # Errors
    /// As for a check of the step.
    pub(crate) fn entailments(
        &self,
        EarlierSteps { from, before, sound }: &EarlierSteps<'_>,
        (at, pieces): (usize, &[&Reading]),
        wrong: bool,
    ) -> Result<Vec<Entailment>> {
        let from = *from;
        let mut entailments = vec![Entailment::Open; pieces.len()];
        let none = Claim::default();
        let claim = |at: usize| self.assigned[at].unwrap_or(&none);
        let own = self.hypotheses(claim(at))?;
        let same = |a: &Hypothesis, b: &Hypothesis| {
            a.lhs == b.lhs && a.rhs == b.rhs && a.relation == b.relation && (a.throughout || !b.throughout)
        };
        // A step with hypotheses is usable only where these hold, and at all times.
        let is_constant = |symbol| matches!(self.model.meaning(symbol), Some(Meaning::Constant(_)));
        let at_all_times = |hypothesis: &Hypothesis| {
            let drawn = free_symbols::drawn(&[&hypothesis.lhs, &hypothesis.rhs], self.model);
            hypothesis.throughout || drawn.into_iter().all(is_constant)
        };
        let is_usable = |at: &usize| {
            let hypotheses = self.hypotheses(claim(*at)).ok();
            let granted = |other: &Hypothesis| at_all_times(other) && own.iter().any(|own| same(own, other));
            let granted = |all: Vec<Hypothesis>| all.iter().all(granted);
            self.claims_only_what_it_prints(*at) && hypotheses.is_some_and(granted)
        };
        if !is_usable(&from) {
            return Ok(entailments);
        }
        let before: Vec<usize> = before.iter().copied().filter(is_usable).collect();
        let quiet = self.without_explanations();
        let aside = self.without_system(false);
        let aside = Checker { model: &aside.model, units: self.units.clone(), ..quiet };
        for (entailment, piece) in entailments.iter_mut().zip(pieces) {
            if wrong && aside.says_the_same(piece, from, &own)? {
                *entailment = Entailment::Follows;
            }
        }
        let printed = quiet.printed_world(&before, from);
        let is_world = printed.is_some();
        let equal = |at: &usize| {
            let relations = self.readings[*at].statements.iter().flatten().flat_map(|statement| &statement.relations);
            relations.into_iter().all(|(relation, _)| is_equality(*relation))
        };
        let true_ones = before.iter().copied().filter(|at| sound.contains(at) && equal(at));
        let together: Vec<usize> = true_ones.chain([from]).collect();
        let mut laws = Vec::new();
        if wrong {
            laws = vec![(vec![from], false), (together.clone(), false), (vec![from], true), (together, true)];
        } else if !is_world {
            laws = vec![(vec![from], false)];
        }
        let laws = laws.into_iter().filter_map(|(steps, names)| quiet.as_laws(&steps, names));
        for (n, premise) in printed.into_iter().chain(laws).enumerate() {
            let there = Checker { model: &premise.model, units: quiet.units.clone(), ..quiet };
            for (entailment, piece) in
                entailments.iter_mut().zip(pieces).filter(|(known, _)| **known != Entailment::Follows)
            {
                match there.holds_under(at, piece, claim(at), &premise)? {
                    Entailment::Differs if n > 0 || !is_world && !self.concerns_same_motion(from, piece) => {}
                    Entailment::Open => {}
                    decided => *entailment = decided,
                }
            }
        }
        Ok(entailments)
    }

    /// The entailment of a piece by a premise, whose model this checker has.
    fn holds_under(&self, at: usize, piece: &Reading, claim: &Claim, premise: &Premise) -> Result<Entailment> {
        // A premise without states, such as a printed mass matrix that is singular, decides nothing.
        let Ok(true) = self.leaves_states(at, piece, claim, premise) else { return Ok(Entailment::Open) };
        Ok(match self.holds(at, piece, claim) {
            Ok((true, _)) => Entailment::Follows,
            Ok((false, true)) => Entailment::Differs,
            _ => Entailment::Open,
        })
    }

    /// Whether a piece of a display passes; and whether it is refuted.
    fn holds(&self, at: usize, piece: &Reading, claim: &Claim) -> Result<(bool, bool)> {
        let display = &self.notes.equations[at];
        // `small` concerns ≈ only, and not every link of a chain has one.
        let relations = || piece.statements.iter().flatten().flat_map(|statement| &statement.relations);
        let exact = Claim { small: Vec::new(), order: None, ..claim.clone() };
        let claim = if relations().any(|(relation, _)| !is_equality(*relation)) { claim } else { &exact };
        let parts = self.parts((at, display.body.start), piece, claim, &format!("{} step", shown(display)))?;
        let all = |is: &dyn Fn(Verdict) -> bool| parts.iter().all(|part| is(part.finding.verdict));
        Ok((all(&Verdict::passes), all(&|verdict| verdict == Verdict::Refuted)))
    }

    /// Whether a premise leaves the states of a piece free.
    fn leaves_states(&self, at: usize, piece: &Reading, claim: &Claim, premise: &Premise) -> Result<bool> {
        let (hypotheses, local) = (self.hypotheses(claim)?, self.local(claim)?);
        let members: Vec<&Expr> = piece.statements.iter().flatten().flat_map(|statement| &statement.members).collect();
        let topic = format!("{} room", shown(&self.notes.equations[at]));
        let context = Context {
            model: self.model,
            options: self.options,
            hypotheses: &hypotheses,
            on_shell: Some(true),
            topic: &topic,
            span: self.notes.equations[at].body,
            spread: Spread::Declared,
            local: &local,
        };
        let ensemble = context.ensemble(context.mode(true, &members), false, FEWEST)?;
        premise.leaves_the_state_free(&ensemble)
    }

    /// Whether a piece is equivalent to a step: the difference of its sides is a constant times that of the step, or of the
    /// time derivative of the step.
    fn says_the_same(&self, piece: &Reading, from: usize, hypotheses: &[Hypothesis]) -> Result<bool> {
        let Some(Ok(Statement { members, relations, constant: None, .. })) = piece.statements.first() else {
            return Ok(false);
        };
        let ([a, b], [(relation, _)]) = (members.as_slice(), relations.as_slice()) else { return Ok(false) };
        let Some(link) = is_equality(*relation).then(|| self.link(a, Relation::Equal, b).ok()).flatten() else {
            return Ok(false);
        };
        for statement in self.readings[from].statements.iter().flatten() {
            for (members, (relation, _)) in statement.members.windows(2).zip(&statement.relations) {
                let (a, b) = (&members[0], &members[1]);
                let rate = |of: &Expr| Expr::new(Node::TimeDerivative(1, Box::new(of.clone())), of.span);
                for (a, b) in [(a.clone(), b.clone()), (rate(a), rate(b))] {
                    let Ok(known) = self.link(&a, Relation::Equal, &b) else { continue };
                    if is_equality(*relation) && self.proportional(&link, &known, hypotheses)? {
                        return Ok(true);
                    }
                }
            }
        }
        Ok(false)
    }

    /// Whether the difference of the sides of a link is the same multiple of that of another link at all states.
    pub(crate) fn proportional(&self, link: &Link, known: &Link, hypotheses: &[Hypothesis]) -> Result<bool> {
        let context = Context {
            model: self.model,
            options: self.options,
            hypotheses,
            on_shell: Some(false),
            topic: "the same",
            span: link.lhs.span,
            spread: Spread::Declared,
            local: &[],
        };
        let mode = context.mode(false, &[&link.lhs, &link.rhs, &known.lhs, &known.rhs]);
        let ensemble = context.ensemble(mode, false, self.options.points.max(FEWEST))?;
        let mut factor = None;
        for state in &ensemble.states {
            let (Ok(own), Ok(others)) = (entries(link, state), entries(known, state)) else { return Ok(false) };
            let apart = |(a, b): (RunningError, RunningError)| a - b;
            let (own, others) = (own.into_iter().map(apart), others.into_iter().map(apart));
            for (own, other) in own.clone().zip(others.clone()) {
                if residual::vanishes(other) && residual::vanishes(own) {
                    continue;
                }
                let factor = *factor.get_or_insert(own.value / other.value);
                if !f64::is_normal(factor) || !residual::vanishes(own - other * factor) {
                    return Ok(false);
                }
            }
            if own.len() != others.len() {
                return Ok(false);
            }
        }
        Ok(factor.is_some() && ensemble.states.len() >= FEWEST)
    }

    /// Whether a step determines the highest derivative of a symbol whose derivative of that order or above is in a piece.
    fn concerns_same_motion(&self, from: usize, piece: &Reading) -> bool {
        let Some(premise) = self.as_laws(&[from], false) else { return false };
        let hypotheses = premise.model.laws.iter().flat_map(|law| &law.hypotheses);
        let rules: Vec<_> = hypotheses.filter_map(|hypothesis| motion::motion(&premise.model, hypothesis)).collect();
        let members = || piece.statements.iter().flatten().flat_map(|statement| &statement.members);
        rules.iter().any(|rule| {
            let order = |formula: &Expr| order::order(&premise.model, formula, rule.symbol);
            let Action::EquationOfMotion { order: leading, .. } = &rule.action else { return false };
            members().filter_map(order).max().is_some_and(|highest| highest >= *leading)
        })
    }
}

/// The links of a display, each as a reading; a statement that introduces a name is not divided.
fn pieces(reading: &Reading) -> Vec<Reading> {
    let mut pieces = Vec::new();
    for (at, statement) in reading.statements.iter().enumerate() {
        let Ok(statement) = statement else { continue };
        let introduced = reading.introduced.iter().filter(|introduced| introduced.statement == at);
        let introduced: Vec<DefinedSymbol> =
            introduced.map(|new| DefinedSymbol { statement: 0, ..new.clone() }).collect();
        let mut add = |statement: Statement, introduced: Vec<DefinedSymbol>| {
            pieces.push(Reading { statements: vec![Ok(statement)], introduced });
        };
        if !introduced.is_empty() {
            add(statement.clone(), introduced);
            continue;
        }
        for (at, relation) in statement.relations.iter().enumerate() {
            let members = statement.members[at..=at + 1].to_vec();
            let span = members[0].span.to(members[1].span);
            let link = Statement { members, relations: vec![*relation], constant: None, span, ..statement.clone() };
            add(link, Vec::new());
        }
        if statement.constant.is_some() {
            let members = statement.members.last().cloned().into_iter().collect();
            add(Statement { members, relations: Vec::new(), ..statement.clone() }, Vec::new());
        }
    }
    pieces
}
