//! Displays that are declared the steps of a derivation: a wrong one that follows from a wrong one before it is no slip of
//! its own.
//!
//! Each step is judged against what is true, like any display. A step that is false then, and has a false one before it, is
//! judged once more in a world in which that one is right ([`super::premise`]). If it holds there, or says what the false one
//! says in other words, it follows: its verdict stays, and is explained by the other. Truth is never taken from there, and
//! what cannot be decided changes nothing.

use std::collections::BTreeMap;

use rayon::prelude::*;

use crate::formula::{Expr, Relation, Statement};
use crate::latex::{Introduced, Reading};
use crate::notes::claims::Claim;
use crate::{Error, Result};

use super::desk::Desk;
use super::document::{Run, shown};
use super::draw::Reach;
use super::ensemble::Condition;
use super::identity::{self, Context, FEWEST, Options, is_equality};
use super::judge::Link;
use super::motion;
use super::premise::Premise;
use super::trial::is_plain;
use super::verdict::{Equation, Finding, Inherited, Verdict};

/// A step is held against so many false ones before it, the nearest first.
const LOOKED_BACK: usize = 6;

/// How a step stands to a false one before it.
#[derive(Clone, Copy, PartialEq)]
enum Standing {
    /// It follows.
    Follows,
    /// It says something else.
    Differs,
    /// It cannot be told.
    Open,
}

/// What is found of a step.
struct Told {
    /// Of each place up to which it is wrong, the false step that it follows from, if it does.
    wrong: Vec<(usize, Option<usize>)>,
    /// A false step that it certainly does not follow from, where it follows from none.
    other: Option<usize>,
}

impl Desk<'_> {
    /// The derivations that the claims file declares: of each the displays, in their order.
    ///
    /// # Errors
    /// For one that has no steps to compare.
    pub(super) fn derivations(&self) -> Result<Vec<Vec<usize>>> {
        let at = |span, message: String| Error::at(&self.claims.source, span, message);
        let mut all = Vec::new();
        for address in &self.claims.steps {
            let places = address.lookup(self.notes, &self.claims.source)?;
            if places.iter().any(|place| place.row.or(place.part).or(place.step).is_some()) {
                return Err(at(address.span, "a step of a derivation is a whole display".to_owned())
                    .help("leave out `row`, `part` and `step`; a chain in one display is judged link by link anyway"));
            }
            let displays: Vec<usize> = places.into_iter().map(|place| place.display).collect();
            if displays.len() < 2 {
                let error = at(address.span, "one display is no derivation".to_owned());
                return Err(error.help("name its steps in their order, as in \"6.71..6.73, 6.77\""));
            }
            let again = displays.iter().enumerate().find(|(n, display)| displays[..*n].contains(display));
            if let Some((_, display)) = again {
                let message =
                    format!("({}) is a step of this derivation twice", shown(&self.notes.equations[*display]));
                return Err(at(address.span, message));
            }
            all.push(displays);
        }
        Ok(all)
    }

    /// The findings on some displays, those of steps with what they follow from; and the repairs of those that do not. A
    /// display that was not asked for is judged where another one may follow from it.
    ///
    /// # Errors
    /// As for a check of the displays.
    pub(super) fn with_steps(
        &self,
        run: &Run<'_>,
        derivations: &[Vec<usize>],
        (work, equations): (&[usize], Vec<Equation>),
        judge: impl Fn(usize) -> Result<Equation> + Sync,
    ) -> Result<Vec<Equation>> {
        if derivations.is_empty() {
            return Ok(equations);
        }
        let mut found: BTreeMap<usize, Equation> = work.iter().copied().zip(equations).collect();
        let asked = |derivation: &&Vec<usize>| derivation.iter().any(|at| work.contains(at));
        let missing = derivations.iter().filter(asked).flatten().copied().filter(|at| !found.contains_key(at));
        let missing: Vec<usize> = missing.collect();
        found.extend(missing.into_iter().map(|at| Ok((at, judge(at)?))).collect::<Result<Vec<_>>>()?);
        let pairs = derivations.iter().filter(asked).flat_map(|d| (1..d.len()).map(move |n| (&d[..n], d[n])));
        let pairs: Vec<(&[usize], usize)> = pairs.collect();
        let told: Vec<Told> = pairs
            .par_iter()
            .with_max_len(1)
            .map(|(before, at)| self.told(&found, before, *at))
            .collect::<Result<_>>()?;
        let mut roots: BTreeMap<usize, usize> = BTreeMap::new();
        for ((_, at), told) in pairs.iter().zip(&told) {
            if let Some(from) = told.from() {
                let root = roots.get(&from).copied().unwrap_or(from);
                roots.entry(*at).or_insert(root);
            }
        }
        let name = |at: usize| shown(&self.notes.equations[at]);
        for ((_, at), told) in pairs.iter().zip(told) {
            let start = self.notes.equations[*at].body.start;
            let Some(equation) = found.get_mut(at).filter(|known| known.finding.follows_from.is_none()) else {
                continue;
            };
            let inherited = |from: usize| {
                let root = roots.get(&from).copied().unwrap_or(from);
                Inherited { from: name(from), root: name(root) }
            };
            if let Some(from) = told.from() {
                inherit(&mut equation.finding, inherited(from));
                let wrong = equation.parts.iter_mut().filter(|part| !part.ok);
                wrong.for_each(|part| inherit(&mut part.finding, inherited(from)));
                continue;
            }
            for part in equation.parts.iter_mut().filter(|part| !part.ok) {
                let mut here = told.wrong.iter().filter(|(end, _)| end + start == part.finding.span.end);
                if let (Some((_, Some(from))), None) = (here.next(), here.next()) {
                    inherit(&mut part.finding, inherited(*from));
                }
            }
            let own = equation.parts.iter_mut().find(|part| !part.ok && part.finding.follows_from.is_none());
            if let Some(other) = told.other {
                let not = match equation.finding.verdict.passes() {
                    true => format!("; from ({}), as printed, it does not follow", name(other)),
                    false => format!("; from ({}) it does not follow either", name(other)),
                };
                match own {
                    Some(part) => part.finding.message.push_str(&not),
                    None => equation.finding.message.push_str(&not),
                }
            }
            if let Some(part) = equation.parts.iter().find(|part| !part.ok && part.finding.follows_from.is_none()) {
                equation.finding = part.finding.clone();
            }
        }
        let is_step = |at: &usize| derivations.iter().any(|derivation| derivation.contains(at));
        let mended = work.par_iter().with_max_len(1).map(|at| match found.get(at).cloned() {
            Some(equation) if is_step(at) && equation.finding.follows_from.is_none() => {
                self.with_repairs(run, *at, equation)
            }
            Some(equation) => Ok(equation),
            None => judge(*at),
        });
        mended.collect()
    }

    /// What is to be told of a step, from those before it.
    fn told(&self, found: &BTreeMap<usize, Equation>, before: &[usize], at: usize) -> Result<Told> {
        let mut told = Told { wrong: Vec::new(), other: None };
        let Some(equation) = found.get(&at) else { return Ok(told) };
        let verdict = |at: &usize| found.get(at).map(|equation| (equation.finding.verdict, equation.ok));
        let is_false = |at: &usize| verdict(at) == Some((Verdict::Refuted, false)) && self.is_bare(*at);
        let wrong = equation.finding.verdict == Verdict::Refuted
            && !equation.ok
            && equation.parts.iter().all(|part| part.ok || part.finding.verdict == Verdict::Refuted);
        let right = equation.ok && equation.finding.verdict.holds();
        if !(wrong || right) || !self.may_follow(at) {
            return Ok(told);
        }
        // Of what is true it is worth saying that the step before does not give it, and nothing else.
        let looked_back = if wrong { LOOKED_BACK } else { 1 };
        let is_true = |at: &usize| verdict(at).is_some_and(|(verdict, ok)| ok && verdict.passes());
        let mut open: Option<Vec<(Reading, Option<usize>)>> = None;
        for from in before.iter().rev().filter(|at| is_false(at)).take(looked_back) {
            let known = match &mut open {
                Some(known) => known,
                none => none.insert(self.wrong_pieces(at, wrong)?.into_iter().map(|piece| (piece, None)).collect()),
            };
            let pieces: Vec<&Reading> = known.iter().map(|(piece, _)| piece).collect();
            let standings = self.standings((before, &is_true), *from, (at, &pieces), wrong)?;
            if standings.iter().all(|standing| *standing == Standing::Follows) {
                // One line before it is enough.
                known.iter_mut().for_each(|(_, known)| *known = Some(*from));
                break;
            }
            for ((_, known), standing) in known.iter_mut().zip(standings) {
                match standing {
                    Standing::Follows => *known = known.or(Some(*from)),
                    Standing::Differs if known.is_none() => told.other = told.other.or(Some(*from)),
                    _ => {}
                }
            }
        }
        if wrong {
            let end = |piece: &Reading| piece.statements.iter().flatten().next().map(|s| s.span.end);
            told.wrong = open.into_iter().flatten().filter_map(|(piece, from)| Some((end(&piece)?, from))).collect();
        }
        Ok(told)
    }

    /// The pieces of a display that are false; all of them, of one that is true.
    fn wrong_pieces(&self, at: usize, wrong: bool) -> Result<Vec<Reading>> {
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
    fn is_bare(&self, at: usize) -> bool {
        let Some(claim) = self.assigned[at] else { return true };
        is_plain(claim) && claim.errata.is_empty() && claim.expect.is_none() && claim.meanings.is_empty()
    }

    /// The same of one that is held against others; it may be an approximation.
    fn may_follow(&self, at: usize) -> bool {
        let Some(claim) = self.assigned[at] else { return true };
        let exact = Claim { small: Vec::new(), ..claim.clone() };
        is_plain(&exact) && claim.errata.is_empty() && claim.expect.is_none() && claim.meanings.is_empty()
    }

    /// How pieces of a step stand to a false one, as printed; `wrong` is whether they are false themselves.
    fn standings(
        &self,
        (before, is_true): (&[usize], &dyn Fn(&usize) -> bool),
        from: usize,
        (at, pieces): (usize, &[&Reading]),
        wrong: bool,
    ) -> Result<Vec<Standing>> {
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
        let true_ones = before.iter().copied().filter(|at| is_true(at) && equal(at));
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
            let super::rules::Action::Follows { order: leading, .. } = &rule.action else { return false };
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
            pieces.push(Reading { statements: vec![Ok(statement)], introduced, ..reading.clone() });
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

impl Told {
    /// The one false step that all of it follows from.
    fn from(&self) -> Option<usize> {
        let (_, first) = self.wrong.first()?;
        first.filter(|_| self.wrong.iter().all(|(_, from)| from == first))
    }
}

/// Explains what is false by a step that it follows from.
fn inherit(finding: &mut Finding, inherited: Inherited) {
    let Inherited { from, root } = &inherited;
    let message = match from == root {
        true => format!("it follows from ({from}), which is refuted: mend that"),
        false => format!("it follows from ({from}), and so from ({root}), which is refuted: mend that"),
    };
    let Finding { verdict, span, points, tried, .. } = *finding;
    let follows_from = Some(inherited);
    *finding = Finding { points, tried, follows_from, ..Finding::new(verdict, span, message) };
}
