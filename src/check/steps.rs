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
enum Told {
    /// It follows from the false one at this place.
    Follows(usize),
    /// It does not, and is judged by itself; the false one is named if it certainly does not follow from it.
    Own(Option<usize>),
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
            if let Told::Follows(from) = told {
                let root = roots.get(from).copied().unwrap_or(*from);
                roots.entry(*at).or_insert(root);
            }
        }
        for ((_, at), told) in pairs.iter().zip(told) {
            let name = |at: usize| shown(&self.notes.equations[at]);
            let Some(equation) = found.get_mut(at) else { continue };
            match told {
                Told::Follows(from) if equation.follows_from.is_none() => {
                    let root = roots.get(at).copied().unwrap_or(from);
                    inherit(equation, Inherited { from: name(from), root: name(root) });
                }
                Told::Own(Some(other)) if equation.follows_from.is_none() => {
                    let not = match equation.finding.verdict.passes() {
                        true => format!("; from ({}), as printed, it does not follow", name(other)),
                        false => format!("; from ({}) it does not follow either", name(other)),
                    };
                    equation.finding.message.push_str(&not);
                    let wrong = equation.parts.iter_mut().find(|part| !part.ok);
                    wrong.into_iter().for_each(|part| part.finding.message.push_str(&not));
                }
                _ => {}
            }
        }
        let is_step = |at: &usize| derivations.iter().any(|derivation| derivation.contains(at));
        let mended = work.par_iter().with_max_len(1).map(|at| match found.get(at).cloned() {
            Some(equation) if is_step(at) && equation.follows_from.is_none() => self.with_repairs(run, *at, equation),
            Some(equation) => Ok(equation),
            None => judge(*at),
        });
        mended.collect()
    }

    /// What is to be told of a step, from those before it.
    fn told(&self, found: &BTreeMap<usize, Equation>, before: &[usize], at: usize) -> Result<Told> {
        let Some(equation) = found.get(&at) else { return Ok(Told::Own(None)) };
        let verdict = |at: &usize| found.get(at).map(|equation| (equation.finding.verdict, equation.ok));
        let is_false = |at: &usize| verdict(at) == Some((Verdict::Refuted, false)) && self.is_bare(*at);
        let wrong = equation.finding.verdict == Verdict::Refuted
            && !equation.ok
            && equation.parts.iter().all(|part| part.ok || part.finding.verdict == Verdict::Refuted);
        let right = equation.ok && equation.finding.verdict.holds();
        if !(wrong || right) || !self.may_follow(at) {
            return Ok(Told::Own(None));
        }
        let mut other = None;
        // Of what is true it is worth saying that the step before does not give it, and nothing else.
        let looked_back = if wrong { LOOKED_BACK } else { 1 };
        for from in before.iter().rev().filter(|at| is_false(at)).take(looked_back) {
            let true_ones = before
                .iter()
                .copied()
                .filter(|at| verdict(at).is_some_and(|(verdict, ok)| ok && verdict.passes()) && self.is_bare(*at));
            match self.standing(before, (*from, &true_ones.collect::<Vec<_>>()), at, wrong)? {
                Standing::Follows if wrong => return Ok(Told::Follows(*from)),
                Standing::Follows => {}
                Standing::Differs => other = other.or(Some(*from)),
                Standing::Open => {}
            }
        }
        Ok(Told::Own(other))
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

    /// How a step stands to a false one, as printed; `wrong` is whether it is false itself.
    fn standing(
        &self,
        before: &[usize],
        (from, true_ones): (usize, &[usize]),
        at: usize,
        wrong: bool,
    ) -> Result<Standing> {
        let none = Claim::default();
        let claim = |at: usize| self.assigned[at].unwrap_or(&none);
        let (own, others) = (self.conditions(claim(at))?, self.conditions(claim(from))?);
        let same = |a: &Condition, b: &Condition| {
            a.lhs == b.lhs && a.rhs == b.rhs && a.relation == b.relation && (a.throughout || !b.throughout)
        };
        if !others.iter().all(|other| own.iter().any(|own| same(own, other))) {
            return Ok(Standing::Open);
        }
        let options = Options { explain: false, ..self.options };
        let quiet = Desk { options, units: self.units.clone(), ..*self };
        let mut open: Vec<Reading> = Vec::new();
        for piece in pieces(&self.readings[at]) {
            if !wrong || !quiet.holds(at, &piece, claim(at))?.0 {
                open.push(piece);
            }
        }
        if open.is_empty() {
            return Ok(Standing::Open);
        }
        let aside = self.aside();
        let aside = Desk { model: &aside.model, units: self.units.clone(), ..quiet };
        if wrong && aside.say_the_same(&open, from, &own)? {
            return Ok(Standing::Follows);
        }
        let mut differs = false;
        let printed = quiet.printed_world(before, from);
        let is_world = printed.is_some();
        let together: Vec<usize> = true_ones.iter().copied().chain([from]).collect();
        let laws = [&[from] as &[usize], &together];
        let laws = laws.into_iter().take(if wrong { 2 } else { 1 }).filter(|_| !is_world);
        for (n, premise) in printed.into_iter().chain(laws.filter_map(|steps| quiet.as_laws(steps))).enumerate() {
            let there = Desk { model: &premise.model, units: quiet.units.clone(), ..quiet };
            match there.stands(at, &open, claim(at), &premise)? {
                Standing::Follows => return Ok(Standing::Follows),
                Standing::Differs => differs |= is_world || n == 0 && self.is_about_one_motion(from, &open),
                Standing::Open => {}
            }
        }
        Ok(if differs { Standing::Differs } else { Standing::Open })
    }

    /// Whether pieces of a display hold in the world of a premise, which this desk is about.
    fn stands(&self, at: usize, pieces: &[Reading], claim: &Claim, premise: &Premise) -> Result<Standing> {
        let mut standing = Standing::Follows;
        for piece in pieces {
            // A world without states, as where the printed mass matrix is singular, decides nothing.
            let Ok(true) = self.has_room(at, piece, claim, premise) else { return Ok(Standing::Open) };
            match self.holds(at, piece, claim) {
                Ok((true, _)) => {}
                Ok((false, true)) => standing = Standing::Differs,
                _ => return Ok(Standing::Open),
            }
        }
        Ok(standing)
    }

    /// Whether a piece of a display passes; and whether it is refuted.
    fn holds(&self, at: usize, piece: &Reading, claim: &Claim) -> Result<(bool, bool)> {
        let display = &self.notes.equations[at];
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

    /// Whether each piece is an equality of two things that are, member for member, those which a step sets equal.
    fn say_the_same(&self, pieces: &[Reading], from: usize, conditions: &[Condition]) -> Result<bool> {
        let one = |a: &Expr, b: &Expr| -> Result<bool> {
            let Ok(link) = self.link(a, Relation::Equal, b) else { return Ok(false) };
            Ok(a == b || self.always(&link, conditions)?)
        };
        let mut printed = Vec::new();
        for statement in self.readings[from].statements.iter().flatten() {
            let links = statement.members.windows(2).zip(&statement.relations);
            printed.extend(links.filter(|(_, (relation, _))| is_equality(*relation)).map(|(members, _)| members));
        }
        let says = |statement: &Statement| -> Result<bool> {
            let ([a, b], [(relation, _)]) = (statement.members.as_slice(), statement.relations.as_slice()) else {
                return Ok(false);
            };
            if !is_equality(*relation) || statement.constant.is_some() {
                return Ok(false);
            }
            for members in &printed {
                if one(a, &members[0])? && one(b, &members[1])? || one(a, &members[1])? && one(b, &members[0])? {
                    return Ok(true);
                }
            }
            Ok(false)
        };
        for statement in pieces.iter().flat_map(|piece| piece.statements.iter().flatten()) {
            if !says(statement)? {
                return Ok(false);
            }
        }
        Ok(true)
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

    /// Whether a step gives the highest derivative of something that pieces of another speak of too.
    fn is_about_one_motion(&self, from: usize, pieces: &[Reading]) -> bool {
        let Some(premise) = self.as_laws(&[from]) else { return false };
        let conditions = premise.model.laws.iter().flat_map(|law| &law.conditions);
        let rules: Vec<_> = conditions.filter_map(|condition| motion::motion(&premise.model, condition)).collect();
        let members = || pieces.iter().flat_map(|piece| piece.statements.iter().flatten()).flat_map(|s| &s.members);
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

/// Explains a false step by the one that it follows from.
fn inherit(equation: &mut Equation, inherited: Inherited) {
    let Inherited { from, root } = &inherited;
    let message = match from == root {
        true => format!("it follows from ({from}), which is refuted: mend that"),
        false => format!("it follows from ({from}), and so from ({root}), which is refuted: mend that"),
    };
    let explain = |finding: &mut Finding| {
        if !finding.verdict.passes() {
            let (verdict, span) = (finding.verdict, finding.span);
            *finding =
                Finding { points: finding.points, tried: finding.tried, ..Finding::new(verdict, span, &*message) };
        }
    };
    explain(&mut equation.finding);
    equation.parts.iter_mut().for_each(|part| explain(&mut part.finding));
    equation.follows_from = Some(inherited);
}
