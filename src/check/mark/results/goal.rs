//! A wanted result as something that a line may say: in another form, as a root, with numbers put in, or with a slip.

use crate::formula::{Expr, Node, Relation, Statement, SymbolId};
use crate::latex::Reading;
use crate::notes::claims::{Claim, Lost, Range, Spanned};
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::judge::difference;
use crate::check::mark::carried::numbers::{self, FEWEST, STATES};
use crate::check::mark::marked::{Line, Mark};
use crate::check::mark::problem::Wanted;
use crate::check::mark::world::World;
use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::meaning::{Meaning, Variable};
use crate::check::model::sampling::Spread;
use crate::check::sample::context::Context;
use crate::check::vacuity::restatement;

/// A wanted result, and the model in which lines are compared with it.
pub(super) struct Goal {
    model: Model,
    pub links: Vec<Link>,
    hypotheses: Vec<Hypothesis>,
    symbols: Vec<(SymbolId, u8)>,
    /// Whether the problem gives it as a law.
    is_law: bool,
    /// The names that other results give a formula for: a line that uses one of them is a step on the way.
    others: Vec<SymbolId>,
    /// What the claim says that the result is too.
    also: Option<Expr>,
    /// Whether it is a secular equation: then an equation for amplitudes is a step on the way.
    is_secular: bool,
}

impl Goal {
    pub fn of(checker: &Checker<'_>, world: &World<'_>, wanted: &Wanted) -> Option<Goal> {
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
        // What a length of the student's own would be if it were negative decides on no result.
        for id in world.declared.iter().filter_map(|name| Some(checker.model.symbols.find(name)?.0)) {
            if matches!(model.meaning(id), Some(Meaning::Constant(_))) {
                free(&mut model, id, Range::Positive);
            }
        }
        let none = Claim::default();
        let claim = checker.assigned[wanted.display].unwrap_or(&none);
        // What holds at the start alone says nothing of a result that starts there.
        let lasts = |text: &&Spanned<String>| checker.without_start(&text.value).is_none();
        let assume = claim.assume.iter().filter(lasts).cloned().collect();
        let hypotheses = checker.hypotheses(&Claim { assume, ..claim.clone() }).ok()?;
        let also = claim.also_equals.as_ref().and_then(|text| {
            let reading = checker.as_printed(&text.value, &none, &checker.model.macros);
            Some(reading.statements.first()?.as_ref().ok()?.members.first()?.clone())
        });
        symbols.sort_unstable();
        symbols.dedup();
        let is_own = |id: &SymbolId| symbols.iter().any(|(own, _)| own == id);
        let others = super::names(checker, world.problem).into_iter().filter(|id| !is_own(id)).collect();
        let is_secular = claim.secular_for.is_some();
        (!links.is_empty()).then_some(Goal { model, links, hypotheses, symbols, is_law, others, also, is_secular })
    }

    /// Whether it says how something moves: it has a rate, or is a law of the problem.
    pub fn is_motion(&self) -> bool {
        self.is_law || self.symbols.iter().any(|(_, dots)| *dots > 0)
    }

    /// Whether a link gives a number, or a formula of fewer names, for a wanted quantity that does not vary: the student has put
    /// in numbers.
    pub fn is_computed(&self, checker: &Checker<'_>, link: &Link) -> bool {
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
    pub fn reached(&self, checker: &Checker<'_>, world: &World<'_>, reading: &Reading) -> Option<usize> {
        let parts = (0..self.links.len()).map(|part| self.part(checker, world, reading, part));
        parts.collect::<Option<Vec<usize>>>()?.into_iter().max()
    }

    /// The same for one of the statements of the result.
    pub fn part(&self, checker: &Checker<'_>, world: &World<'_>, reading: &Reading, part: usize) -> Option<usize> {
        let all = links(checker, reading);
        let all: Vec<(usize, &Link)> =
            all.iter().filter_map(|link| Some((self.own_names(checker, world, link)?, link))).collect();
        let wanted = self.links.get(part)?;
        all.iter().filter(|(_, link)| self.says(checker, world, link, wanted)).map(|(names, _)| *names).min()
    }

    fn says(&self, checker: &Checker<'_>, world: &World<'_>, link: &Link, wanted: &Link) -> bool {
        if self.also.as_ref() == Some(&link.lhs) {
            let same = checker.link(&link.rhs, Relation::Equal, &wanted.rhs);
            return same.is_ok_and(|same| self.holds(checker, &same, &[]) == Some(true));
        }
        // What the problem gives is no result, though with its definitions it may say the same.
        let is_same = || checker.proportional(link, wanted, &[]).unwrap_or(false);
        if !(is_about_its_rates(checker, link, wanted) || is_same())
            || !self.is_law && self.is_but_a_law(checker, world, link, wanted)
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

    /// Whether a link says what a law of the problem says, and no more. Where the result is a law solved for a quantity, so must the link be.
    fn is_but_a_law(&self, checker: &Checker<'_>, world: &World<'_>, link: &Link, wanted: &Link) -> bool {
        let is_solved = |id: SymbolId| is_power_of(&link.lhs, id) || is_power_of(&link.rhs, id);
        says_a_law(checker, world, link)
            && !(wanted.lhs.as_plain_symbol().is_some_and(is_solved) && says_a_law(checker, world, wanted))
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
        // So does the rate in its formula: `\dot\varphi = \ell/(m r^2)` says what ℓ is.
        let is_its_rate = |side: &Expr| match &side.node {
            Node::Symbol { id, dots, .. } if *dots > 0 => wanted.rhs.symbols().contains(&(*id, *dots)),
            _ => false,
        };
        [&link.lhs, &link.rhs].into_iter().any(|side| is_alone(side) || is_its_rate(side))
    }

    /// Whether a reading says what is wanted with other quantities of the problem, each of which is conserved or is given by a right
    /// line: `\omega = \sqrt{2 \Omega^2/(1 + b^2 x_0^6)}` after `x_0 = \Omega/\sqrt{g b}`.
    pub fn is_with_known_quantities(
        &self,
        checker: &Checker<'_>,
        world: &World<'_>,
        (own_line, reading): (usize, &Reading),
        lines: &[Line],
    ) -> bool {
        let is_own = |id: SymbolId| world.problem.names.symbols.find(&checker.model.symbols.entry(id).name).is_none();
        // A line does not say by itself what its other quantities are.
        let gives = |id: SymbolId, at: usize| {
            if at == own_line {
                return false;
            }
            let own = links(checker, &checker.readings[world.first + at]);
            (lines[at].mark == Mark::Right || lines[at].mark == Mark::Given && is_own(id))
                && own.iter().any(|link| [&link.lhs, &link.rhs].into_iter().any(|side| is_power_of(side, id)))
        };
        let is_place = |id: SymbolId| {
            let name = &checker.model.symbols.entry(id).name;
            world.problem.special.kept().any(|(_, place)| place == name)
        };
        let is_known = |id: SymbolId| match checker.model.meaning(id) {
            // A line that defines a quantity of the student's own reaches a result if another line gives the quantity.
            _ if is_own(id) && lines[own_line].mark == Mark::Given => (0..lines.len()).any(|at| gives(id, at)),
            Some(Meaning::Defined(_)) => (0..lines.len()).any(|at| gives(id, at)),
            _ if is_place(id) => (0..lines.len()).any(|at| gives(id, at)),
            _ => true,
        };
        let says = |link: &Link, wanted: &Link| {
            let symbols = link.lhs.symbols().into_iter().chain(link.rhs.symbols());
            let mut others = symbols.filter(|symbol| !self.symbols.contains(symbol));
            others.all(|(id, _)| is_known(id)) && self.says(checker, world, link, wanted)
        };
        let own = links(checker, reading);
        // What lines say of other quantities makes two forms the same: of a place of rest, or of the speed in `E = -\frac12 m v^2`.
        let others: Vec<SymbolId> = own
            .iter()
            .flat_map(|link| [link.lhs.symbols(), link.rhs.symbols()].concat())
            .filter(|symbol| !self.symbols.contains(symbol))
            .map(|(id, _)| id)
            .collect();
        let is_true = |at: &usize| *at != own_line && matches!(lines[*at].mark, Mark::Right | Mark::Given);
        let given = (0..lines.len()).filter(is_true).flat_map(|at| {
            let all = links(checker, &checker.readings[world.first + at]).into_iter();
            let is_right = lines[at].mark == Mark::Right;
            let gives = |link: &Link| {
                let names = link.lhs.symbols();
                let is_it = |id: SymbolId| (is_place(id) || others.contains(&id)) && (is_right || is_own(id));
                names.iter().any(|(id, _)| is_it(*id) && is_power_of(&link.lhs, *id))
            };
            all.filter(gives).collect::<Vec<_>>()
        });
        let mut known: Vec<Link> = Vec::new();
        given.for_each(|link| {
            if known.iter().all(|other| other.lhs != link.lhs) && known.len() < MOST_KNOWN {
                known.push(link);
            }
        });
        let premises: Vec<Hypothesis> = known.into_iter().map(|link| Hypothesis::of(link, false)).collect();
        let is_same_there = |link: &Link, wanted: &Link| {
            let value = match &wanted.lhs.node {
                _ if link.lhs == wanted.lhs => link.rhs.clone(),
                Node::Power(base, power) if link.lhs == **base => {
                    Expr::new(Node::Power(Box::new(link.rhs.clone()), power.clone()), link.rhs.span)
                }
                _ if matches!(&link.lhs.node, Node::Root(2, base) if **base == wanted.lhs) => {
                    Expr::new(Node::Product(vec![link.rhs.clone(), link.rhs.clone()]), link.rhs.span)
                }
                _ => return false,
            };
            let same = checker.link(&value, Relation::Equal, &wanted.rhs);
            !premises.is_empty()
                && same.is_ok_and(|same| numbers::holds(checker, &self.model, &same, &premises) == Some(true))
        };
        self.links.iter().all(|wanted| own.iter().any(|link| says(link, wanted) || is_same_there(link, wanted)))
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
                _ if self.is_secular && world.problem.names.symbols.len() > id.0 => return None,
                Some(Meaning::System(_)) => return None,
                Some(Meaning::Defined(_)) if of_problem(id) || self.others.contains(&id) => return None,
                // A letter or primes for a rate say nothing of their own.
                Some(Meaning::Defined(formula)) if matches!(formula.node, Node::Symbol { .. }) => {}
                Some(Meaning::Defined(_)) => own.push(id),
                _ => {}
            }
        }
        (own.len() <= 1).then_some(own.len())
    }

    /// Whether a reading has the left side of the result.
    pub fn has_its_side(&self, checker: &Checker<'_>, reading: &Reading) -> bool {
        let own = links(checker, reading);
        own.iter().any(|link| self.links.iter().any(|wanted| link.lhs == wanted.lhs))
    }

    /// Whether a false reading was meant as the result: it has the same left side, or the same rates in it; and what it is
    /// off by, if that is a number.
    pub fn attempt(&self, checker: &Checker<'_>, world: &World<'_>, reading: &Reading) -> Option<Option<Lost>> {
        self.links.iter().find_map(|wanted| self.attempt_at(checker, world, reading, wanted))
    }

    /// The same for one of the statements of the result.
    fn attempt_at(
        &self,
        checker: &Checker<'_>,
        world: &World<'_>,
        reading: &Reading,
        wanted: &Link,
    ) -> Option<Option<Lost>> {
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
            // A false line about the square of a wanted quantity was meant as it too.
            let name = wanted.lhs.as_plain_symbol();
            if name.is_some_and(|id| matches!(link.lhs.node, Node::Power(..)) && is_power_of(&link.lhs, id)) {
                return Some(None);
            }
            // So was one about the quantity in the names of the result, which is not solved for it: `r_0 (k + m \Omega^2) = k \ell`.
            if let Some(id) = name
                && self.is_in_its_names(&link, wanted, id)
            {
                return Some(None);
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

    /// Whether a link has a quantity of the result, all its other names but at most one, and no name more.
    fn is_in_its_names(&self, link: &Link, wanted: &Link, id: SymbolId) -> bool {
        let names = |link: &Link| {
            let mut names = [link.lhs.symbols(), link.rhs.symbols()].concat();
            names.sort_unstable();
            names.dedup();
            names
        };
        let (own, all) = (names(link), names(wanted));
        own.contains(&(id, 0))
            && own.len() > 2
            && own.len() + 1 >= all.len()
            && own.iter().all(|name| all.contains(name))
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

/// The most quantities of which right lines say what they are, so that two forms are the same.
const MOST_KNOWN: usize = 3;

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

/// Whether a formula is a symbol or a power of it.
fn is_power_of(formula: &Expr, id: SymbolId) -> bool {
    match &formula.node {
        // A name that is defined by its square is a root.
        Node::Power(base, _) | Node::Root(_, base) => base.as_plain_symbol() == Some(id),
        // So does its reciprocal: `\frac1R = \frac1{R_1} + \frac1{R_2}`.
        Node::Quotient(_, below) => below.as_plain_symbol() == Some(id) && formula.symbols().len() == 1,
        _ => formula.as_plain_symbol() == Some(id),
    }
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
pub(super) fn links(checker: &Checker<'_>, reading: &Reading) -> Vec<Link> {
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
