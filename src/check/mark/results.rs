//! The wanted results in a hand-in: recognised by what a line says, not by its number or its form.
//!
//! A true line reaches a result if the result follows from the line alone, without the motion and the laws, and not
//! without the line. So any form of an equation of motion is the equation of motion. A line that names further quantities
//! of the problem, as L = T − U, is a step on the way.

use crate::Result;
use crate::formula::{Expr, Node, Relation, Statement, SymbolId};
use crate::latex::Reading;
use crate::notes::claims::{Claim, Lost};
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::judge::difference;
use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::meaning::{Meaning, Variable};
use crate::check::model::sampling::Spread;
use crate::check::sample::context::Context;
use crate::check::vacuity::restatement;
use crate::notes::claims::Range;

use super::carried::numbers::{self, FEWEST, STATES};
use super::judged::Found;
use super::marked::{Because, Line, Mark, Slipped};
use super::problem::{Problem, Wanted};
use super::status::composed;
use super::world::World;

/// The names that the wanted results give a formula for.
pub(super) fn names(checker: &Checker<'_>, problem: &Problem) -> Vec<SymbolId> {
    let statements =
        problem.wanted.iter().flat_map(|wanted| checker.readings[wanted.display].statements.iter().flatten());
    statements.filter_map(|statement| statement.members.first()?.as_plain_symbol()).collect()
}

/// For each wanted result, the line that reaches it: the first right one, or else the last one with a slip.
///
/// # Errors
/// As for states of the problem.
pub(super) fn found(
    checker: &Checker<'_>,
    world: &World<'_>,
    lines: &mut [Line],
    (premises, corrected): (&[Reading], Option<&[Option<String>]>),
) -> Result<Vec<Option<Found>>> {
    let mut all = Vec::new();
    let is_at_speed: Vec<bool> = lines.iter().map(|line| matches!(line.because, Because::AtSpeed(_))).collect();
    for wanted in &world.problem.wanted {
        let Some(goal) = Goal::of(checker, world, wanted) else {
            all.push(None);
            continue;
        };
        let readings = |at: usize| {
            let display = world.first + at;
            let own = &checker.readings[display];
            let mut both = vec![own.clone()];
            let is_at_speed = is_at_speed[at];
            if world.written[at].continues.is_some() || is_at_speed {
                both.push(premises[display].clone());
            }
            both.extend(with_named_rates(checker, own));
            both
        };
        let is_true = |line: &Line| matches!(line.mark, Mark::Right | Mark::Given);
        let computed = |at: usize| {
            let own = links(checker, &checker.readings[world.first + at]);
            lines[at].mark == Mark::Right && own.iter().any(|link| goal.is_computed(checker, link))
        };
        let reached = |at: usize| {
            let more = readings(at).into_iter().filter_map(|reading| goal.reached(checker, world, &reading));
            Some((more.min().filter(|_| is_true(&lines[at]))?, at))
        };
        // A line without names of the student's own says it best.
        let right = (0..lines.len()).filter_map(reached).min().map(|(_, line)| line);
        // The statements of a result may stand on lines of their own; the last of them reaches it.
        let right = right.or_else(|| {
            let says = |part: usize, at: &usize| {
                let mut own = readings(*at).into_iter();
                is_true(&lines[*at]) && own.any(|reading| goal.part(checker, world, &reading, part).is_some())
            };
            let parts = (0..goal.links.len()).map(|part| (0..lines.len()).find(|at| says(part, at)));
            parts.collect::<Option<Vec<usize>>>()?.into_iter().max().filter(|_| goal.links.len() > 1)
        });
        // A right number for what is wanted, where no line has the formula.
        if let Some(line) = right.or_else(|| (0..lines.len()).find(|at| computed(*at))) {
            all.push(Some(Found { line, is_right: true, lost: None }));
            continue;
        }
        let Some(corrected) = corrected else {
            all.push(None);
            continue;
        };
        let mut with_slip = None;
        for at in (0..lines.len()).rev().filter(|at| matches!(lines[*at].mark, Mark::Wrong | Mark::Carried)) {
            let is_corrected = corrected[at].as_ref().is_some_and(|text| {
                let reading = checker.as_printed(text, &Claim::default(), &checker.model.macros);
                let whole = world.written[at]
                    .continues
                    .and_then(|start| composed(&checker.readings[world.first + start], &reading));
                let whole = whole.as_ref().and_then(|whole| goal.reached(checker, world, whole));
                whole.or_else(|| goal.reached(checker, world, &reading)).is_some()
            });
            let attempt = readings(at).iter().rev().find_map(|reading| goal.attempt(checker, world, reading));
            if is_corrected || attempt.is_some() {
                with_slip = Some((at, attempt.flatten()));
                break;
            }
        }
        let found = with_slip.map(|(at, off)| {
            let mut root = at;
            while let Some(before) = lines[root].follows_from {
                root = before;
            }
            if let (None, Some(lost), Mark::Wrong) = (&lines[root].slip, off, lines[root].mark) {
                let span = lines[root].span;
                lines[root].slip = Some(Slipped { lost, span, replacement: None });
            }
            Found { line: at, is_right: false, lost: lines[root].slip.as_ref().map(|slip| slip.lost).or(off) }
        });
        all.push(found);
    }
    Ok(all)
}

/// A reading with the name that a law gives to a rate in the place of the rate: `a` for `\ddot x`.
fn with_named_rates(checker: &Checker<'_>, reading: &Reading) -> Option<Reading> {
    let laws = checker.model.laws.iter().flat_map(|law| &law.hypotheses);
    let named = laws.filter_map(|law| match (&law.lhs.node, law.rhs.as_plain_symbol()) {
        (Node::Symbol { id, dots, .. }, Some(name)) if *dots > 0 && law.relation == Relation::Equal => {
            Some(((*id, *dots), name))
        }
        _ => None,
    });
    let named: Vec<((SymbolId, u8), SymbolId)> = named.collect();
    let mut new = reading.clone();
    for member in new.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
        let span = member.span;
        member.substitute(&|node| match node {
            Node::Symbol { id, dots, .. } => {
                let (_, name) = named.iter().find(|(rate, _)| rate == &(*id, *dots))?;
                Some(Expr::new(Node::Symbol { id: *name, indices: Vec::new(), dots: 0 }, span))
            }
            _ => None,
        });
    }
    (!named.is_empty()).then_some(new)
}

/// A wanted result, and the model in which lines are compared with it.
struct Goal {
    model: Model,
    links: Vec<Link>,
    hypotheses: Vec<Hypothesis>,
    symbols: Vec<(SymbolId, u8)>,
    /// Whether the problem gives it as a law.
    is_law: bool,
}

impl Goal {
    fn of(checker: &Checker<'_>, world: &World<'_>, wanted: &Wanted) -> Option<Goal> {
        let is_law = world.problem.laws.contains(&wanted.display);
        let reading = &checker.readings[wanted.display];
        let statements: Vec<&Statement> = reading.statements.iter().flatten().collect();
        let mut model = checker.without_system(false).model;
        let mut links = Vec::new();
        let mut symbols = Vec::new();
        for statement in statements {
            let (Some(first), Some(last)) = (statement.members.first(), statement.members.last()) else { continue };
            if statement.members.len() < 2 {
                continue;
            }
            if let Some(id) = first.as_plain_symbol()
                && matches!(model.meaning(id), Some(Meaning::Defined(_)))
            {
                free(&mut model, id, if is_positive(checker, last) { Range::Positive } else { Range::Any });
            }
            links.push(checker.link(first, Relation::Equal, last).ok()?);
            // What stands between them is a way to the result.
            symbols.extend([first, last].into_iter().flat_map(Expr::symbols));
        }
        let none = Claim::default();
        let hypotheses = checker.hypotheses(checker.assigned[wanted.display].unwrap_or(&none)).ok()?;
        symbols.sort_unstable();
        symbols.dedup();
        (!links.is_empty()).then_some(Goal { model, links, hypotheses, symbols, is_law })
    }

    /// Whether a link gives a number, or a formula of fewer names, for a wanted quantity that does not vary: the student has put
    /// in numbers.
    fn is_computed(&self, checker: &Checker<'_>, link: &Link) -> bool {
        let is_fixed = self.symbols.iter().all(|(id, dots)| {
            let varies = matches!(
                checker.model.meaning(*id),
                Some(Meaning::Coordinate(_) | Meaning::Varying(_) | Meaning::Time | Meaning::System(_))
            );
            *dots == 0 && !varies
        });
        let symbols = link.rhs.symbols();
        is_fixed
            && self.links.iter().any(|wanted| {
                let known = wanted.rhs.symbols();
                let fewer = symbols.len() < known.len() && symbols.iter().all(|symbol| known.contains(symbol));
                matches!(link.lhs.node, Node::Symbol { .. }) && link.lhs == wanted.lhs && fewer
            })
    }

    /// The number of names of the student's own in a reading that says what is wanted; `None`, if it does not say it.
    fn reached(&self, checker: &Checker<'_>, world: &World<'_>, reading: &Reading) -> Option<usize> {
        let parts = (0..self.links.len()).map(|part| self.part(checker, world, reading, part));
        parts.collect::<Option<Vec<usize>>>()?.into_iter().max()
    }

    /// The same for one of the statements of the result.
    fn part(&self, checker: &Checker<'_>, world: &World<'_>, reading: &Reading, part: usize) -> Option<usize> {
        let all = links(checker, reading);
        let all: Vec<(usize, &Link)> =
            all.iter().filter_map(|link| Some((self.own_names(checker, world, link)?, link))).collect();
        let wanted = self.links.get(part)?;
        all.iter().filter(|(_, link)| self.says(checker, world, link, wanted)).map(|(names, _)| *names).min()
    }

    fn says(&self, checker: &Checker<'_>, world: &World<'_>, link: &Link, wanted: &Link) -> bool {
        // What the problem gives is no result, though with its definitions it may say the same.
        let is_same = || checker.proportional(link, wanted, &[]).unwrap_or(false);
        if !(is_about_its_rates(checker, link, wanted) || is_same()) || !self.is_law && says_a_law(checker, world, link)
        {
            return false;
        }
        if restatement::same_but_for_letters(link, wanted) {
            return true;
        }
        if self.is_its_root(checker, link, wanted) {
            return true;
        }
        if !self.is_solved_for(link, wanted) {
            return false;
        }
        let own = Hypothesis::of(link.clone(), false);
        match self.holds(checker, wanted, &[]) {
            // What holds anyway is recognised by its sides.
            Some(true) => {
                let same = |a: &Expr, b: &Expr| {
                    let link = checker.link(a, Relation::Equal, b);
                    link.is_ok_and(|link| self.holds(checker, &link, &[]) == Some(true))
                };
                same(&link.lhs, &wanted.lhs) && same(&link.rhs, &wanted.rhs)
            }
            _ => self.holds(checker, link, &[]) == Some(false) && self.holds(checker, wanted, &[own]) == Some(true),
        }
    }

    /// Whether a link gives the quantity whose square is wanted: `v = \sqrt{2gh}` for `v^2 = 2gh`.
    fn is_its_root(&self, checker: &Checker<'_>, link: &Link, wanted: &Link) -> bool {
        let Node::Power(base, power) = &wanted.lhs.node else { return false };
        let is_square = matches!(&power.node, Node::Number(two) if two == "2");
        if !is_square || base.as_plain_symbol().is_none() || link.lhs != **base {
            return false;
        }
        let square = Expr::new(Node::Power(Box::new(link.rhs.clone()), power.clone()), link.rhs.span);
        let same = checker.link(&square, Relation::Equal, &wanted.rhs);
        same.is_ok_and(|same| self.holds(checker, &same, &[]) == Some(true))
    }

    /// Whether a link has a side with no other name than the quantity whose formula is wanted: ½mu² = mgh is a step on the way to
    /// the height, and v² = 2gh gives the speed.
    fn is_solved_for(&self, link: &Link, wanted: &Link) -> bool {
        let Some(id) = wanted.lhs.as_plain_symbol() else { return true };
        let is_alone = |side: &Expr| {
            let names = side.symbols();
            !names.is_empty() && names.iter().all(|(name, _)| *name == id)
        };
        is_alone(&link.lhs) || is_alone(&link.rhs)
    }

    /// Whether a link holds at states that obey a hypothesis; `None`, if there are too few.
    fn holds(&self, checker: &Checker<'_>, link: &Link, hypotheses: &[Hypothesis]) -> Option<bool> {
        let with: Vec<Hypothesis> = self.hypotheses.iter().chain(hypotheses).cloned().collect();
        let tried = |hypotheses: &[Hypothesis]| numbers::holds(checker, &self.model, link, hypotheses);
        tried(&with).or_else(|| if self.hypotheses.is_empty() { None } else { tried(hypotheses) })
    }

    /// The number of names in a link that the student defined and the result does not have; `None`, if there are several, or
    /// if one is a quantity of the problem: then the link is a step on the way.
    fn own_names(&self, checker: &Checker<'_>, world: &World<'_>, link: &Link) -> Option<usize> {
        let of_problem = |id: SymbolId| {
            let readings = checker.readings[..world.problem.notes.equations.len()].iter();
            readings.flat_map(|reading| &reading.introduced).any(|new| new.symbol == id)
        };
        let mut own = Vec::new();
        for (id, _) in link.lhs.symbols().into_iter().chain(link.rhs.symbols()) {
            if self.symbols.iter().any(|(known, _)| *known == id) || own.contains(&id) {
                continue;
            }
            match checker.model.meaning(id) {
                Some(Meaning::System(_)) => return None,
                Some(Meaning::Defined(_)) if of_problem(id) => return None,
                // A letter or primes for a rate say nothing of their own.
                Some(Meaning::Defined(formula)) if matches!(formula.node, Node::Symbol { .. }) => {}
                Some(Meaning::Defined(_)) => own.push(id),
                _ => {}
            }
        }
        (own.len() <= 1).then_some(own.len())
    }

    /// Whether a false reading was meant as the result: it has the same left side, or the same rates in it; and what it is
    /// off by, if that is a number.
    fn attempt(&self, checker: &Checker<'_>, world: &World<'_>, reading: &Reading) -> Option<Option<Lost>> {
        let [wanted] = self.links.as_slice() else { return None };
        let varies = |symbols: &[(SymbolId, u8)]| {
            let is_moving = |(id, dots): &&(SymbolId, u8)| {
                *dots > 0 || !matches!(checker.model.meaning(*id), Some(Meaning::Constant(_)))
            };
            let mut all: Vec<(SymbolId, u8)> = symbols.iter().filter(is_moving).copied().collect();
            all.sort_unstable();
            all.dedup();
            all
        };
        for link in links(checker, reading) {
            if self.own_names(checker, world, &link).is_none() || self.holds(checker, &link, &[]) == Some(true) {
                continue;
            }
            let is_name = matches!(wanted.lhs.node, Node::Symbol { .. });
            if is_name && link.lhs == wanted.lhs {
                return Some(self.off_by(checker, &link.rhs, &wanted.rhs));
            }
            let left = checker.link(&link.lhs, Relation::Equal, &wanted.lhs);
            if !link.lhs.is_null() && left.is_ok_and(|left| self.holds(checker, &left, &[]) == Some(true)) {
                return Some(self.off_by(checker, &link.rhs, &wanted.rhs));
            }
            let symbols: Vec<(SymbolId, u8)> = link.lhs.symbols().into_iter().chain(link.rhs.symbols()).collect();
            let own: Vec<(SymbolId, u8)> = wanted.lhs.symbols().into_iter().chain(wanted.rhs.symbols()).collect();
            let moving = varies(&own);
            let highest = |all: &[(SymbolId, u8)]| all.iter().map(|(_, dots)| *dots).max();
            let has_acceleration = moving.iter().any(|(id, dots)| *dots > 1 && symbols.contains(&(*id, *dots)));
            let is_alike =
                has_acceleration || varies(&symbols) == moving && highest(&moving).is_some_and(|dots| dots > 0);
            if is_alike && !(is_name && matches!(link.lhs.node, Node::Symbol { .. })) {
                return Some(None);
            }
        }
        None
    }

    /// What a formula is off by: a sign or a number.
    fn off_by(&self, checker: &Checker<'_>, is: &Expr, wanted: &Expr) -> Option<Lost> {
        let context = Context {
            model: &self.model,
            options: checker.options,
            hypotheses: &[],
            on_shell: Some(false),
            topic: "a wanted result",
            span: Span::default(),
            spread: Spread::Declared,
            local: &[],
        };
        let ensemble = context.ensemble(context.mode(false, &[is, wanted]), false, STATES).ok()?;
        let mut ratios = Vec::new();
        for state in &ensemble.states {
            let (Some(is), Some(wanted)) = (difference::value(is, state), difference::value(wanted, state)) else {
                continue;
            };
            ratios.push(is.value / wanted.value);
        }
        let first = *ratios.first().filter(|first| first.is_finite() && ratios.len() >= FEWEST)?;
        let is_constant = ratios.iter().all(|ratio| (ratio - first).abs() < 1e-9 * first.abs());
        is_constant.then_some(if (first + 1.0).abs() < 1e-9 { Lost::Sign } else { Lost::Factor })
    }
}

/// Whether a link says what a law of the problem says, whatever the definitions of the problem say.
fn says_a_law(checker: &Checker<'_>, world: &World<'_>, own: &Link) -> bool {
    let model = checker.without_system(true).model;
    let premise = [Hypothesis::of(own.clone(), false)];
    let follows = |law: &Link| numbers::holds(checker, &model, law, &premise) == Some(true);
    world.problem.laws.iter().any(|law| {
        let all = links(checker, &checker.readings[*law]);
        !all.is_empty() && all.iter().all(follows)
    })
}

/// Whether a line prints a law of the problem as the problem does, in either order of its sides.
pub(super) fn prints_a_law(checker: &Checker<'_>, world: &World<'_>, reading: &Reading) -> bool {
    let own = links(checker, reading);
    let laws: Vec<Link> = world.problem.laws.iter().flat_map(|law| links(checker, &checker.readings[*law])).collect();
    let is_it = |own: &Link, law: &Link| {
        own.relation == law.relation
            && (own.lhs == law.lhs && own.rhs == law.rhs || own.lhs == law.rhs && own.rhs == law.lhs)
    };
    !own.is_empty() && own.iter().all(|own| laws.iter().any(|law| is_it(own, law)))
}

/// Whether a link speaks of the rate of a quantity that the problem defines, or of the rate of a formula, where a result
/// does. The equation of motion is no statement on the rate of the energy, though that follows from it.
fn is_about_its_rates(checker: &Checker<'_>, link: &Link, wanted: &Link) -> bool {
    let determined = |id| matches!(checker.model.meaning(id), Some(Meaning::Defined(_) | Meaning::System(_)));
    let rate_of_formula = |link: &Link| {
        let mut found = false;
        let mut look = |expr: &Expr| {
            found |= match &expr.node {
                Node::Symbol { id, dots: 1, .. } => determined(*id),
                Node::TimeDerivative(_, inner) => inner.as_plain_symbol().is_none_or(determined),
                _ => false,
            }
        };
        link.lhs.walk(&mut look);
        link.rhs.walk(&mut look);
        found
    };
    !rate_of_formula(wanted) || rate_of_formula(link)
}

fn free(model: &mut Model, id: SymbolId, range: Range) {
    model.mean(id, Meaning::Varying(model.varying.len()));
    model.varying.push(Variable::number(id, range));
}

/// Whether a formula is positive at all states of the problem: then its square says as much.
fn is_positive(checker: &Checker<'_>, formula: &Expr) -> bool {
    let link = checker.link(formula, Relation::Greater, &Expr::integer(0, formula.span));
    link.is_ok_and(|link| numbers::holds(checker, checker.model, &link, &[]) == Some(true))
}

/// The equalities that a reading states: each link, and the first member with the last.
fn links(checker: &Checker<'_>, reading: &Reading) -> Vec<Link> {
    let mut found = Vec::new();
    for statement in reading.statements.iter().flatten() {
        let equal = |relation: Relation| is_equality(relation) || relation == Relation::Approximately;
        if !statement.relations.iter().all(|(relation, _)| equal(*relation)) || statement.members.len() < 2 {
            continue;
        }
        let members = &statement.members;
        let last = members.len() - 1;
        let mut add = |a: usize, b: usize| found.extend(checker.link(&members[a], Relation::Equal, &members[b]).ok());
        add(0, last);
        if last > 1 {
            (0..last).for_each(|at| add(at, at + 1));
            (2..last).for_each(|at| add(0, at));
        }
    }
    found
}
