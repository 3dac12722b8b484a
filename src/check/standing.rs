//! How the pieces of a display stand to a false one: whether they follow from it as printed, or say something else.
//!
//! A piece follows if it says the same in other words, or if it passes its check in a world in which the false one is right
//! ([`super::premise`]). It says something else if it is refuted there, and that world is about it. All else stays open.

use crate::Result;
use crate::formula::{Expr, Relation, Statement};
use crate::latex::{Introduced, Reading};
use crate::notes::claims::Claim;

use super::desk::Desk;
use super::document::shown;
use super::draw::Reach;
use super::ensemble::Condition;
use super::identity::{self, Context, FEWEST, Options, is_equality};
use super::judge::Link;
use super::motion;
use super::premise::Premise;
use super::rules::Action;
use super::trial::is_plain;
use super::verdict::Verdict;

/// How a step stands to a false one before it.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Standing {
    /// It follows.
    Follows,
    /// It says something else.
    Differs,
    /// It cannot be told.
    Open,
}

/// What a step is held against.
pub(super) struct Against<'s> {
    /// A false step before it.
    pub from: usize,
    /// All steps before it.
    pub before: &'s [usize],
    /// Those of them that pass.
    pub sound: &'s [usize],
}

impl Desk<'_> {
    /// The pieces of a display that are false; all of them, of one that is true.
    ///
    /// # Errors
    /// As for a check of the display.
    pub(super) fn wrong_pieces(&self, at: usize, wrong: bool) -> Result<Vec<Reading>> {
        let none = Claim::default();
        let claim = self.assigned[at].unwrap_or(&none);
        let quiet = self.quiet();
        let mut open = Vec::new();
        for piece in pieces(&self.readings[at]) {
            if !wrong || !quiet.holds(at, &piece, claim)?.0 {
                open.push(piece);
            }
        }
        Ok(open)
    }

    /// The same desk, without explanations.
    fn quiet(&self) -> Desk<'_> {
        Desk { options: Options { explain: false, ..self.options }, units: self.units.clone(), ..*self }
    }

    /// Whether a step claims what it prints, under hypotheses, and nothing else: then others may be held against it.
    pub(super) fn is_bare(&self, at: usize) -> bool {
        let Some(claim) = self.assigned[at] else { return true };
        is_plain(claim) && claim.errata.is_empty() && claim.expect.is_none() && claim.meanings.is_empty()
    }

    /// How pieces of a step stand to a false one, as printed; `wrong` is whether they are false themselves.
    ///
    /// # Errors
    /// As for a check of the step.
    pub(super) fn standings(
        &self,
        Against { from, before, sound }: &Against<'_>,
        (at, pieces): (usize, &[&Reading]),
        wrong: bool,
    ) -> Result<Vec<Standing>> {
        let from = *from;
        let mut standings = vec![Standing::Open; pieces.len()];
        let none = Claim::default();
        let claim = |at: usize| self.assigned[at].unwrap_or(&none);
        let own = self.conditions(claim(at))?;
        let same = |a: &Condition, b: &Condition| {
            a.lhs == b.lhs && a.rhs == b.rhs && a.relation == b.relation && (a.throughout || !b.throughout)
        };
        // What holds under hypotheses of its own says nothing where these do not hold.
        let is_usable = |at: &usize| {
            let conditions = self.conditions(claim(*at)).ok();
            let granted = |all: Vec<Condition>| all.iter().all(|other| own.iter().any(|own| same(own, other)));
            self.is_bare(*at) && conditions.is_some_and(granted)
        };
        if !is_usable(&from) {
            return Ok(standings);
        }
        let before: Vec<usize> = before.iter().copied().filter(is_usable).collect();
        let quiet = self.quiet();
        let aside = self.aside();
        let aside = Desk { model: &aside.model, units: self.units.clone(), ..quiet };
        for (standing, piece) in standings.iter_mut().zip(pieces) {
            if wrong && aside.says_the_same(piece, from, &own)? {
                *standing = Standing::Follows;
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
        let (alone, more) = ([from], usize::from(wrong));
        let laws = [alone.as_slice(), &together].into_iter().take(more + usize::from(!is_world || wrong));
        for (n, premise) in printed.into_iter().chain(laws.filter_map(|steps| quiet.as_laws(steps))).enumerate() {
            let there = Desk { model: &premise.model, units: quiet.units.clone(), ..quiet };
            for (standing, piece) in standings.iter_mut().zip(pieces).filter(|(known, _)| **known != Standing::Follows)
            {
                match there.stands(at, piece, claim(at), &premise)? {
                    Standing::Differs if n > 0 || !is_world && !self.is_about_one_motion(from, piece) => {}
                    Standing::Open => {}
                    told => *standing = told,
                }
            }
        }
        Ok(standings)
    }

    /// Whether a piece of a display holds in the world of a premise, which this desk is about.
    fn stands(&self, at: usize, piece: &Reading, claim: &Claim, premise: &Premise) -> Result<Standing> {
        // A world without states, as where the printed mass matrix is singular, decides nothing.
        let Ok(true) = self.has_room(at, piece, claim, premise) else { return Ok(Standing::Open) };
        Ok(match self.holds(at, piece, claim) {
            Ok((true, _)) => Standing::Follows,
            Ok((false, true)) => Standing::Differs,
            _ => Standing::Open,
        })
    }

    /// Whether a piece of a display passes; and whether it is refuted.
    fn holds(&self, at: usize, piece: &Reading, claim: &Claim) -> Result<(bool, bool)> {
        let display = &self.notes.equations[at];
        // What is small concerns ≈ alone, and not every link of a chain has one.
        let relations = || piece.statements.iter().flatten().flat_map(|statement| &statement.relations);
        let exact = Claim { small: Vec::new(), order: None, ..claim.clone() };
        let claim = if relations().any(|(relation, _)| !is_equality(*relation)) { claim } else { &exact };
        let parts = self.parts((at, display.body.start), piece, claim, &format!("{} step", shown(display)))?;
        let all = |is: &dyn Fn(Verdict) -> bool| parts.iter().all(|part| is(part.finding.verdict));
        Ok((all(&Verdict::passes), all(&|verdict| verdict == Verdict::Refuted)))
    }

    /// Whether a premise leaves the states of a piece free.
    fn has_room(&self, at: usize, piece: &Reading, claim: &Claim, premise: &Premise) -> Result<bool> {
        let (conditions, local) = (self.conditions(claim)?, self.local(claim)?);
        let members: Vec<&Expr> = piece.statements.iter().flatten().flat_map(|statement| &statement.members).collect();
        let topic = format!("{} room", shown(&self.notes.equations[at]));
        let context = Context {
            model: self.model,
            options: self.options,
            conditions: &conditions,
            on_shell: Some(true),
            topic: &topic,
            span: self.notes.equations[at].body,
            reach: Reach::Declared,
            local: &local,
        };
        let ensemble = context.ensemble(context.mode(true, &members), false, FEWEST)?;
        premise.leaves_the_state_free(&ensemble)
    }

    /// Whether a piece is an equality of two things that are, member for member, those which a step sets equal.
    fn says_the_same(&self, piece: &Reading, from: usize, conditions: &[Condition]) -> Result<bool> {
        let Some(Ok(Statement { members, relations, constant: None, .. })) = piece.statements.first() else {
            return Ok(false);
        };
        let ([a, b], [(relation, _)]) = (members.as_slice(), relations.as_slice()) else { return Ok(false) };
        let one = |a: &Expr, b: &Expr| -> Result<bool> {
            let Ok(link) = self.link(a, Relation::Equal, b) else { return Ok(false) };
            Ok(a == b || self.always(&link, conditions)?)
        };
        for statement in self.readings[from].statements.iter().flatten().filter(|_| is_equality(*relation)) {
            for (members, (relation, _)) in statement.members.windows(2).zip(&statement.relations) {
                let (left, right) = (&members[0], &members[1]);
                if is_equality(*relation) && (one(a, left)? && one(b, right)? || one(a, right)? && one(b, left)?) {
                    return Ok(true);
                }
            }
        }
        Ok(false)
    }

    /// Whether two formulas are one whatever moves.
    fn always(&self, link: &Link, conditions: &[Condition]) -> Result<bool> {
        let context = Context {
            model: self.model,
            options: self.options,
            conditions,
            on_shell: Some(false),
            topic: "the same",
            span: link.lhs.span,
            reach: Reach::Declared,
            local: &[],
        };
        Ok(identity::check(link, &context)?.verdict.holds())
    }

    /// Whether a step gives the highest derivative of something that a piece of another speaks of too.
    fn is_about_one_motion(&self, from: usize, piece: &Reading) -> bool {
        let Some(premise) = self.as_laws(&[from]) else { return false };
        let conditions = premise.model.laws.iter().flat_map(|law| &law.conditions);
        let rules: Vec<_> = conditions.filter_map(|condition| motion::motion(&premise.model, condition)).collect();
        let members = || piece.statements.iter().flatten().flat_map(|statement| &statement.members);
        rules.iter().any(|rule| {
            let order = |formula: &Expr| motion::order(&premise.model, formula, rule.symbol);
            let Action::Follows { order: leading, .. } = &rule.action else { return false };
            members().filter_map(order).max().is_some_and(|highest| highest >= *leading)
        })
    }
}

/// A display link by link; a statement that introduces a name stays whole.
fn pieces(reading: &Reading) -> Vec<Reading> {
    let mut pieces = Vec::new();
    for (at, statement) in reading.statements.iter().enumerate() {
        let Ok(statement) = statement else { continue };
        let introduced = reading.introduced.iter().filter(|introduced| introduced.statement == at);
        let introduced: Vec<Introduced> = introduced.map(|new| Introduced { statement: 0, ..new.clone() }).collect();
        let mut add = |statement: Statement, introduced: Vec<Introduced>| {
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
