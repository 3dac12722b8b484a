//! A line beside the false line from which it may follow: what the false line says in other words, and what may be supposed with it.

use crate::formula::calculus::places::at;
use crate::formula::{Expr, Node, Relation, Sign, SymbolId};
use crate::latex::Reading;

use crate::check::document::checker::Checker;
use crate::check::mark::motion::printed;
use crate::check::mark::names::moving;
use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Link};
use crate::check::model::meaning::Meaning;

use super::numbers::{beside_one, holds, links, premises, rate, twice, without_motion};
use super::{Before, derived};

/// The number of true lines that may stand beside a false one, the nearest.
const BESIDE: usize = 5;

/// A line and the false line from which it may follow, as links.
pub(super) struct Step<'s, 'c> {
    pub checker: &'s Checker<'c>,
    /// The display of the false line.
    pub from: usize,
    pub reading: &'s Reading,
    pub before: &'s Before<'s>,
    /// Without the equations of motion.
    pub model: Model,
    pub wrong: Vec<Link>,
    /// What of the line is false.
    pub own: Vec<Link>,
    /// The nearest true lines.
    pub sound: Vec<Vec<Link>>,
    /// The nearest laws.
    pub laws: Vec<Vec<Link>>,
    /// The nearest other false lines.
    pub others: Vec<Vec<Link>>,
    /// What the false line says in other words.
    pub derived: Vec<Vec<Link>>,
    /// The rates of the false line.
    pub rates: Vec<Link>,
}

impl<'s, 'c> Step<'s, 'c> {
    /// The step from a false line to a line; `None`, if they state no equalities.
    pub fn of(
        checker: &'s Checker<'c>,
        from: usize,
        before: &'s Before<'s>,
        reading: &'s Reading,
    ) -> Option<Step<'s, 'c>> {
        let (wrong, own) = (links(checker, &checker.readings[from])?, links(checker, reading)?);
        // Of a chain only the links count that are false: the others hold whatever is carried.
        let is_true =
            |link: &Link| holds(checker, checker.model, link, &[]) == Some(true) || before.motion.has(checker, link);
        let is_false = |link: &Link| own.len() == 1 || !is_true(link);
        let own: Vec<Link> = match own.iter().filter(|link| is_false(link)).cloned().collect::<Vec<_>>() {
            none if none.is_empty() => own,
            some => some,
        };
        let model = without_motion(checker, from, &[wrong.clone(), own.clone()].concat());
        let nearest = |all: &[usize]| -> Vec<Vec<Link>> {
            all.iter().rev().take(BESIDE).filter_map(|at| links(checker, &checker.readings[*at])).collect()
        };
        let others: Vec<usize> = before.wrong.iter().copied().filter(|other| *other != from).collect();
        let (sound, laws, others) = (nearest(before.sound), nearest(before.laws), nearest(&others));
        let derived = consequences(checker, from, reading, before);
        let derived = derived.iter().filter_map(|reading| links(checker, reading)).collect();
        let rates = wrong.iter().filter_map(|link| rate(checker, link)).collect();
        Some(Step { checker, from, reading, before, model, wrong, own, sound, laws, others, derived, rates })
    }

    /// Whether the line says what a false slope of the Lagrangian makes of the equation of motion.
    pub fn is_motion_by_a_slope(&self) -> bool {
        let motion = derived::motion_by_a_slope(self.checker, self.from);
        let Some(motion) = motion.and_then(|motion| links(self.checker, &motion)) else { return false };
        let same =
            |link: &Link| motion.iter().any(|known| self.checker.proportional(link, known, &[]).unwrap_or(false));
        self.own.iter().all(same)
    }

    /// The display of the first line.
    pub fn first(&self) -> usize {
        self.before.all.first().copied().unwrap_or(self.from)
    }

    /// What may be supposed beside the false line, the line alone first.
    pub fn sets(&self) -> Vec<Vec<Hypothesis>> {
        let (wrong, sound) = (&self.wrong, &self.sound);
        let mut sets = vec![premises(wrong), premises(&self.rates)];
        sets.extend(sound.iter().chain(&self.laws).map(|one| premises(wrong.iter().chain(one))));
        // A false line may take the place of a law: with `J = \frac12 m R^2` all others hold.
        let name = |links: &[Link]| links.first().and_then(|link| link.lhs.as_plain_symbol());
        let is_other = |law: &&Vec<Link>| name(law).is_none() || name(law) != name(wrong);
        let others: Vec<&Vec<Link>> = self.laws.iter().filter(is_other).collect();
        if others.len() > 1 {
            sets.push(premises(wrong.iter().chain(others.into_iter().flatten())));
        }
        sets.extend(self.derived.iter().map(premises));
        if sound.len() > 1 {
            sets.push(premises(wrong.iter().chain(sound.iter().flatten())));
        }
        sets
    }

    /// Whether the line is the same equation for what is conserved as the false line in other words, up to a factor without it: no state
    /// may obey it, as none obeys `p^2 = -m M g r^3`.
    pub fn is_equation_for_what_stays(&self) -> bool {
        let (checker, model) = (self.checker, &self.model);
        let [own] = self.own.as_slice() else { return false };
        let off = |link: &Link| link.lhs.clone().minus(link.rhs.clone());
        let own = off(own);
        let stays = |id: &SymbolId| matches!(checker.model.meaning(*id), Some(Meaning::System(_)));
        let names = own.symbols().into_iter().filter(|(id, dots)| *dots == 0 && stays(id));
        names.into_iter().any(|(id, _)| {
            let at_one = |formula: &Expr| at(formula, id, &Expr::integer(1, formula.span));
            let product = |a: &Expr, b: Expr| Expr::new(Node::Product(vec![a.clone(), b]), a.span);
            let same = |known: &Expr| {
                let sides = [product(&own, at_one(known)), product(known, at_one(&own))];
                checker.link(&sides[0], Relation::Equal, &sides[1]).ok()
            };
            let all = self.derived.iter().filter(|links| links.len() == 1).flatten().map(off);
            let mut all = all.filter(|known| model.depends_on(known, &[id]));
            all.any(|known| same(&known).is_some_and(|same| holds(checker, model, &same, &[]) == Some(true)))
        })
    }

    /// What displays of the problem say of other quantities with the value that the false line gives.
    pub fn with_the_value(&self) -> Vec<Vec<Hypothesis>> {
        let wrong = &self.checker.readings[self.from];
        let first_of =
            |reading: &Reading| reading.statements.iter().flatten().next()?.members.first()?.as_plain_symbol();
        let name = first_of(wrong);
        let others: Vec<usize> = (0..self.first()).filter(|at| first_of(&self.checker.readings[*at]) != name).collect();
        let said = derived::insertions(self.checker, wrong, &others);
        said.iter().filter_map(|said| links(self.checker, said)).map(|one| premises(&one)).collect()
    }

    /// The false line with each other false one: a force follows from a false acceleration and a false velocity.
    pub fn beside_another(&self) -> Vec<Vec<Hypothesis>> {
        self.others.iter().map(|one| premises(self.wrong.iter().chain(one))).collect()
    }

    /// Whether the line holds wherever a set does, and not everything does there.
    pub fn holds(&self, model: &Model, set: &[Hypothesis]) -> bool {
        let checker = self.checker;
        let follows = |link: &Link| {
            // Where both sides vanish, anything would follow.
            holds(checker, model, &beside_one(checker, link), set) == Some(true)
                && twice(checker, link).is_none_or(|twice| holds(checker, model, &twice, set) == Some(false))
        };
        !set.is_empty() && self.own.iter().all(follows)
    }

    /// Whether the line is what the false line becomes when it is integrated from the start: its rate holds wherever the false line
    /// does, and it holds at the start of the motion.
    pub fn is_first_integral(&self, wrong: &[Hypothesis]) -> bool {
        let (checker, model) = (self.checker, &self.model);
        let moving = moving(checker.model);
        let moves = |link: &Link| [&link.lhs, &link.rhs].iter().any(|side| model.depends_on(side, &moving));
        if wrong.is_empty() || !self.own.iter().all(moves) {
            return false;
        }
        let start = self.before.motion.at_start(checker, self.reading);
        let Some(start) = start.and_then(|start| links(checker, &start)) else { return false };
        let starts = || {
            start.iter().all(|link| {
                let zero = Expr::integer(0, link.lhs.span);
                let off = checker.link(&link.lhs.clone().minus(link.rhs.clone()), Relation::Equal, &zero);
                off.is_ok_and(|off| holds(checker, checker.model, &beside_one(checker, &off), &[]) == Some(true))
            })
        };
        let follows = |link: &Link| {
            let Some(rate) = rate(checker, &split(checker, model, link)) else { return false };
            holds(checker, model, &beside_one(checker, &rate), wrong) == Some(true)
                && twice(checker, &rate).is_none_or(|twice| holds(checker, model, &twice, wrong) == Some(false))
        };
        self.own.iter().all(follows) && starts()
    }
}

/// What a false line says in other words.
fn consequences(checker: &Checker<'_>, from: usize, own: &Reading, before: &Before<'_>) -> Vec<Reading> {
    let wrong = &checker.readings[from];
    let of_problem = before.all.first().copied().unwrap_or(from);
    let nearest: Vec<usize> = before.sound.iter().rev().take(BESIDE).copied().collect();
    let mut found = derived::insertions(checker, wrong, &nearest);
    found.extend(derived::insertions(checker, wrong, before.laws));
    found.extend(derived::motion_written_out(checker, from));
    found.extend(derived::motion_by_a_momentum(checker, from));
    let given = |at: &usize| {
        checker.readings[*at].statements.iter().flatten().find_map(|s| s.members.first()?.as_plain_symbol())
    };
    let named: Vec<SymbolId> = before.wrong.iter().filter_map(given).collect();
    found.extend(derived::at_instants(checker, wrong, own, &named));
    found.extend(derived::at_values_of_the_motion(checker, before.motion, wrong, own));
    found.extend(derived::at_turns(checker, wrong, own));
    found.extend(derived::on_a_circle(checker, wrong, before.special));
    // A false function of the time has a false value at the start, from which anything would follow.
    let is_function = wrong.statements.iter().flatten().any(|statement| printed(checker, statement).is_some());
    found.extend(before.motion.at_start(checker, wrong).filter(|_| !is_function));
    found.extend(derived::at_instants_of_the_problem(checker, wrong, of_problem));
    found
}

/// A link with its last term on the other side, where that does not move: the rate of `T - U = -U_0` is 0 on the right, where no factor
/// could be seen to be wrong.
fn split(checker: &Checker<'_>, model: &Model, link: &Link) -> Link {
    let moves = |side: &Expr| model.depends_on(side, &moving(checker.model));
    let (whole, rest) = if moves(&link.rhs) { (&link.rhs, &link.lhs) } else { (&link.lhs, &link.rhs) };
    let Node::Sum(terms) = &whole.node else { return link.clone() };
    let Some((last, others)) = terms.split_last().filter(|(_, others)| !others.is_empty() && !moves(rest)) else {
        return link.clone();
    };
    let term = if last.sign == Sign::Plus { last.expr.clone() } else { last.expr.clone().negated() };
    let others = Expr::new(Node::Sum(others.to_vec()), whole.span);
    checker.link(&others, Relation::Equal, &rest.clone().minus(term)).unwrap_or_else(|_| link.clone())
}
