//! Trial solutions, `x_1 = A_1 \cos\omega t` with names of the student's own, and what the laws say of those names.

use crate::formula::calculus::places::at;
use crate::formula::derivative::{Scope, partial};
use crate::formula::tree::Variable;
use crate::formula::{Expr, Node, Relation, SymbolId};
use crate::latex::Reading;
use crate::notes::claims::{Claim, Range};

use crate::check::mark::carried::numbers;
use crate::check::mark::motion::{printed, with_rates_taken};
use crate::check::mark::status::{Status, status};
use crate::check::model::Model;
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::meaning::{self, Meaning};
use crate::check::verdict::Verdict;

use super::Judge;
use crate::check::mark::marked::Mark;

/// A function of the time that a line tries for a coordinate.
pub(super) struct Trial {
    coordinate: SymbolId,
    formula: Expr,
    /// The line.
    line: String,
}

/// The equations of motion into which a trial is put, the nearest.
const EQUATIONS: usize = 6;

impl Judge<'_, '_> {
    /// The function of the time that a line tries for a coordinate, with names of which no line says what they are.
    pub(super) fn trial(&self, at: usize, reading: &Reading) -> Option<Trial> {
        let written = &self.world.written[at];
        if !(written.inline || written.is_tried) || written.continues.is_some() {
            return None;
        }
        let [Ok(statement)] = reading.statements.as_slice() else { return None };
        let own = printed(self.quiet, statement).filter(|own| own.dots == 0 && statement.members.len() == 2)?;
        let is_unknown = |(id, _): &(SymbolId, u8)| {
            matches!(self.quiet.model.meaning(*id), Some(Meaning::Constant(_)))
                && (self.is_own(*id)
                    || written.is_tried && self.is_of_no_law(*id) && !self.motion.prints(own.coordinate))
        };
        let symbols = own.formula.symbols();
        (symbols.iter().any(is_unknown) && self.quiet.model.contains_time(&own.formula)).then(|| Trial {
            coordinate: own.coordinate,
            formula: own.formula.clone(),
            line: written.name.clone(),
        })
    }

    /// Whether no display of the problem that has a rate has a constant: nothing there says what it is.
    fn is_of_no_law(&self, id: SymbolId) -> bool {
        let displays = &self.quiet.readings[..self.world.problem.notes.equations.len()];
        let mut statements = displays.iter().flat_map(|reading| reading.statements.iter().flatten());
        !statements.any(|statement| {
            let symbols: Vec<(SymbolId, u8)> = statement.members.iter().flat_map(Expr::symbols).collect();
            symbols.iter().any(|(_, dots)| *dots > 0) && symbols.iter().any(|(other, _)| *other == id)
        })
    }

    /// Whether a line says of the coordinates what holds in a mode alone: one is a multiple of another with a factor of the student's
    /// own, `x_2 = \rho x_1`, or each oscillates with the frequency that the problem seeks, `\ddot x_1 = -\omega^2 x_1`.
    pub(super) fn is_of_a_mode(&self, at: usize, reading: &Reading) -> bool {
        let written = &self.world.written[at];
        if !(written.inline || written.is_tried) || written.continues.is_some() {
            return false;
        }
        let [Ok(statement)] = reading.statements.as_slice() else { return false };
        let [first, second] = statement.members.as_slice() else { return false };
        let model = self.quiet.model;
        let Node::Symbol { id, dots, .. } = &first.node else { return false };
        let others = second.symbols();
        let moving: Vec<&(SymbolId, u8)> = others.iter().filter(|(other, _)| model.is_coordinate(*other)).collect();
        let [(other, 0)] = moving.as_slice() else { return false };
        let factors = || others.iter().filter(|(factor, _)| factor != other);
        let is_sought = |factor: SymbolId| {
            let name = &model.symbols.entry(factor).name;
            let secular = &self.world.problem.secular;
            secular.iter().any(|(_, omega)| omega == name) || model.normal_frequencies.contains(name)
        };
        let is_product = matches!(&second.node, Node::Product(factors) if factors.iter().all(|factor| factor.as_plain_symbol().is_some()));
        let is_multiple = *dots == 0
            && is_product
            && other != id
            && factors().count() == 1
            && factors().all(|(factor, _)| {
                self.is_own(*factor) && matches!(model.meaning(*factor), Some(Meaning::Constant(_)))
            });
        let is_oscillation = *dots == 2
            && other == id
            && factors().count() == 1
            && factors().all(|(factor, _)| is_sought(*factor))
            && self.is_minus_its_square_times(second, (factors().next().map(|(factor, _)| *factor), *other));
        !self.world.problem.secular.is_empty() && model.is_coordinate(*id) && (is_multiple || is_oscillation)
    }

    /// Whether a formula is -ω² times a coordinate.
    fn is_minus_its_square_times(&self, formula: &Expr, (omega, of): (Option<SymbolId>, SymbolId)) -> bool {
        let Some(omega) = omega else { return false };
        let symbol = |id| Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, formula.span);
        let product = Expr::new(Node::Product(vec![symbol(omega), symbol(omega), symbol(of)]), formula.span).negated();
        let model = self.quiet.without_system(false).model;
        let link = self.quiet.link(formula, Relation::Equal, &product);
        link.is_ok_and(|link| numbers::holds(self.quiet, &model, &link, &[]) == Some(true))
    }

    /// Whether a line has a name of a trial solution: the laws say what it is, and the line does not define it.
    pub(super) fn is_about_a_trial(&self, reading: &Reading) -> bool {
        let of_trials: Vec<SymbolId> =
            self.trials.iter().flat_map(|trial| trial.formula.symbols()).map(|(id, _)| id).collect();
        let members = || reading.statements.iter().flatten().flat_map(|statement| &statement.members);
        members().flat_map(Expr::symbols).any(|(id, _)| of_trials.contains(&id) && self.is_own(id))
    }

    /// What a function of the time in letters of the problem is, that solves an equation of motion which the problem prints: the steady
    /// motion `\theta = B\cos\Omega t`, also where the exact law has no such solution. Or it is what a quantity of the problem is to
    /// first order along that motion: `x = C\cos\Omega t`.
    pub(super) fn solves_a_printed_equation(&self, at: usize, reading: &Reading) -> Option<&'static str> {
        let [Ok(statement)] = reading.statements.as_slice() else { return None };
        let (first, others) = statement.members.split_first().filter(|(_, others)| !others.is_empty())?;
        let is_equal = statement.relations.iter().all(|(relation, _)| is_equality(*relation));
        // What solves the exact laws is judged by them, and by the values at the start.
        let display = self.world.first + at;
        let is_exact = || matches!(status(self.quiet, display, reading, &Claim::default()), Status::Holds(_));
        if !self.details || !is_equal || is_exact() {
            return None;
        }
        if let Some(own) = printed(self.quiet, statement).filter(|own| own.dots == 0 && others.len() == 1) {
            let own = Trial { coordinate: own.coordinate, formula: own.formula, line: String::new() };
            return self.is_a_solution(own).then_some("solves an equation of motion that the problem prints");
        }
        let model = self.quiet.model;
        let id = first.as_plain_symbol()?;
        let Some(Meaning::Defined(formula)) = model.meaning(id) else { return None };
        if !self.world.written[at].is_near || !model.contains_time(formula) && !self.moves(formula) {
            return None;
        }
        let free = self.quiet.without_system(false).model;
        let is_it = |steady: &Trial| {
            let Some(value) = self.to_first_order(formula, steady) else { return false };
            others.iter().all(|member| {
                let Some(member) = self.to_first_order(member, steady) else { return false };
                let link = self.quiet.link(&value, Relation::Equal, &member);
                link.is_ok_and(|link| numbers::holds(self.quiet, &free, &link, &[]) == Some(true))
            })
        };
        self.steady_motions()
            .iter()
            .any(is_it)
            .then_some("holds for small motion, along the steady motion of the problem")
    }

    /// Whether a function of the time solves an equation of motion of the problem, of which nothing is left that moves.
    fn is_a_solution(&self, own: Trial) -> bool {
        let verdicts = &self.world.problem.verdicts;
        let is_true = |at: &usize| verdicts[*at].holds() || verdicts[*at] == Verdict::Law;
        let displays = (0..self.world.problem.notes.equations.len()).filter(is_true);
        let has_rate = |link: &Link| {
            let symbols = [link.lhs.symbols(), link.rhs.symbols()].concat();
            symbols.iter().any(|(id, dots)| *dots == 2 && *id == own.coordinate)
        };
        let links = displays.flat_map(|at| numbers::links(self.quiet, &self.quiet.readings[at]).unwrap_or_default());
        let model = self.quiet.without_system(false).model;
        let trials = std::slice::from_ref(&own);
        links.filter(has_rate).filter_map(|link| self.with(trials, &link)).any(|link| {
            !self.moves(&link.lhs)
                && !self.moves(&link.rhs)
                && numbers::holds(self.quiet, &model, &numbers::beside_one(self.quiet, &link), &[]) == Some(true)
        })
    }

    /// Whether a coordinate is in a formula.
    fn moves(&self, formula: &Expr) -> bool {
        let moves = |(id, _): &(SymbolId, u8)| {
            matches!(self.quiet.model.meaning(*id), Some(Meaning::Coordinate(_) | Meaning::Varying(_)))
        };
        formula.symbols().iter().any(moves)
    }

    /// The functions of the time, in the text of the problem and the lines before, that solve an equation of motion of the problem.
    fn steady_motions(&self) -> Vec<Trial> {
        let notes = &self.world.problem.notes;
        let texts = notes.inline.iter().filter_map(|span| notes.source.text.get(span.range()));
        let read =
            |text: &str| self.quiet.as_printed(text.trim_matches('$'), &Claim::default(), &self.quiet.model.macros);
        let lines = (0..self.lines.len()).map(|at| self.quiet.readings[self.world.first + at].clone());
        let found = texts.map(read).chain(lines).filter_map(|reading| {
            let [Ok(statement)] = reading.statements.as_slice() else { return None };
            let own = printed(self.quiet, statement).filter(|own| own.dots == 0 && statement.members.len() == 2)?;
            let trial =
                |line: &str| Trial { coordinate: own.coordinate, formula: own.formula.clone(), line: line.to_owned() };
            self.is_a_solution(trial("")).then(|| trial(""))
        });
        found.collect()
    }

    /// What a formula is to first order in a coordinate, with a function of the time in its place; `None`, if rates are in it.
    fn to_first_order(&self, formula: &Expr, steady: &Trial) -> Option<Expr> {
        let symbols = &self.quiet.model.symbols;
        let id = steady.coordinate;
        if formula.symbols().iter().any(|(other, dots)| *other == id && *dots > 0) {
            return None;
        }
        let by = Variable { id, indices: Vec::new(), dots: 0 };
        let slope = partial(formula, &by, Scope { symbols, fixed: &[] }, formula.span).ok()?;
        let zero = Expr::integer(0, formula.span);
        let (start, slope) = (self::at(formula, id, &zero), self::at(&slope, id, &zero));
        let change = Expr::new(Node::Product(vec![slope, steady.formula.clone()]), formula.span);
        let whole = start.minus(change.negated());
        (!self.moves(&whole)).then_some(whole)
    }

    /// The line of a trial solution from which a line follows with the laws: it says of the student's own names what the
    /// equations of motion say of them with the trial in the place of the coordinates.
    pub(super) fn follows_from_a_trial(&self, reading: &Reading) -> Option<&str> {
        let last = self.trials.last()?.line.as_str();
        self.follows_with_trials(reading, &self.equations_of_motion()).then_some(last)
    }

    /// The false equation of motion, by its place among the lines, from which a line follows with a trial solution.
    pub(super) fn carried_from_a_trial(&self, reading: &Reading) -> Option<usize> {
        let is_false = |at: &usize| matches!(self.lines[*at].mark, Mark::Wrong | Mark::Carried);
        let mut all: Vec<usize> = (0..self.lines.len()).filter(is_false).collect();
        all.reverse();
        all.into_iter().find(|at| {
            let display = self.world.first + at;
            self.follows_with_trials(reading, &self.about_tried_coordinates(std::iter::once(display)))
        })
    }

    /// Whether a line follows from equations of motion with the trials in the place of the coordinates.
    fn follows_with_trials(&self, reading: &Reading, equations: &[Link]) -> bool {
        if !self.details || self.trials.is_empty() {
            return false;
        }
        let Some(own) = numbers::links(self.quiet, reading) else { return false };
        let mut model = self.quiet.without_system(false).model;
        // An exponent in `e^{\lambda t}` may be negative.
        let tried = self.trials.iter().flat_map(|trial| trial.formula.symbols()).map(|(id, _)| id);
        for id in tried.filter(|id| self.is_own(*id)) {
            model.mean(id, Meaning::Constant(model.constants.len()));
            model.constants.push(meaning::Variable::number(id, Range::Any));
        }
        let moves = |id: SymbolId| matches!(model.meaning(id), Some(Meaning::Coordinate(_) | Meaning::Varying(_)));
        let symbols = |link: &Link| [link.lhs.symbols(), link.rhs.symbols()].concat();
        if own.iter().flat_map(symbols).any(|(id, _)| moves(id)) {
            return false;
        }
        let is_left = |link: &Link| !symbols(link).into_iter().any(|(id, _)| moves(id));
        let equations = equations.iter().map(|link| self.with_trials(link));
        let premises: Vec<Hypothesis> =
            equations.flatten().filter(is_left).take(EQUATIONS).map(|link| Hypothesis::of(link, false)).collect();
        let follows = |link: &Link, premises: &[Hypothesis]| {
            numbers::holds(self.quiet, &model, &numbers::beside_one(self.quiet, link), premises) == Some(true)
                && numbers::holds(self.quiet, &model, link, &[]) == Some(false)
                && numbers::twice(self.quiet, link)
                    .is_none_or(|twice| numbers::holds(self.quiet, &model, &twice, premises) == Some(false))
        };
        // States are found more easily for one equation alone.
        let from_one = |link: &Link| premises.chunks(1).any(|one| follows(link, one));
        let is_factor =
            |link: &Link| premises.iter().any(|known| self.is_a_factor(&model, link, (&known.lhs, &known.rhs)));
        own.iter().all(|link| from_one(link) || follows(link, &premises) || is_factor(link))
    }

    /// Whether the difference of the sides of a link is that of an equation with a trial, but for a factor in which no constant of the problem
    /// is: no number may obey `m \lambda^2 + b \lambda + k = 0`.
    fn is_a_factor(&self, model: &Model, link: &Link, (left, right): (&Expr, &Expr)) -> bool {
        let span = link.lhs.span;
        let (own, whole) = (link.lhs.clone().minus(link.rhs.clone()), left.clone().minus(right.clone()));
        let is_constant = |id: &SymbolId| matches!(model.meaning(*id), Some(Meaning::Constant(_))) && !self.is_own(*id);
        let mut constants: Vec<SymbolId> =
            [own.symbols(), whole.symbols()].concat().into_iter().map(|(id, _)| id).filter(is_constant).collect();
        constants.sort_unstable();
        constants.dedup();
        let product = |a: &Expr, b: &Expr| Expr::new(Node::Product(vec![a.clone(), b.clone()]), span);
        let scope = Scope { symbols: &model.symbols, fixed: &[] };
        let is_left_out = |id: &SymbolId| {
            let by = Variable { id: *id, indices: Vec::new(), dots: 0 };
            let slope = |formula: &Expr| partial(formula, &by, scope, span).ok();
            let (Some(of_own), Some(of_whole)) = (slope(&own), slope(&whole)) else { return false };
            let link = self.quiet.link(&product(&of_own, &whole), Relation::Equal, &product(&own, &of_whole));
            link.is_ok_and(|link| {
                numbers::holds(self.quiet, model, &numbers::beside_one(self.quiet, &link), &[]) == Some(true)
            })
        };
        constants.len() > 1 && constants.iter().all(is_left_out)
    }

    /// The equations of motion that the problem and the true lines print.
    fn equations_of_motion(&self) -> Vec<Link> {
        let of_problem = 0..self.world.problem.notes.equations.len();
        let verdicts = &self.world.problem.verdicts;
        let is_true = |at: &usize| verdicts[*at].holds() || verdicts[*at] == Verdict::Law;
        let sound = |at: &usize| self.lines[*at].mark == Mark::Right;
        let lines = (0..self.lines.len()).filter(sound).map(|at| self.world.first + at);
        self.about_tried_coordinates(of_problem.filter(is_true).chain(lines))
    }

    /// The equalities of displays that have rates of coordinates for which a solution is tried.
    fn about_tried_coordinates(&self, displays: impl Iterator<Item = usize>) -> Vec<Link> {
        let links = displays.flat_map(|at| numbers::links(self.quiet, &self.quiet.readings[at]).unwrap_or_default());
        let is_tried =
            |(id, dots): &(SymbolId, u8)| *dots > 0 && self.trials.iter().any(|trial| trial.coordinate == *id);
        links.filter(|link| link.lhs.symbols().iter().chain(&link.rhs.symbols()).any(is_tried)).collect()
    }

    /// An equation with the trials in the place of the coordinates.
    fn with_trials(&self, link: &Link) -> Option<Link> {
        self.with(&self.trials, link)
    }

    /// The same with other functions of the time.
    fn with(&self, trials: &[Trial], link: &Link) -> Option<Link> {
        let inserted = |side: &Expr| {
            let mut side = side.clone();
            side.substitute(&|node| {
                let Node::Symbol { id, dots, .. } = node else { return None };
                // The last trial for a coordinate counts.
                let trial = trials.iter().rev().find(|trial| trial.coordinate == *id)?;
                let span = trial.formula.span;
                Some(match *dots {
                    0 => trial.formula.clone(),
                    dots => Expr::new(Node::TimeDerivative(dots, Box::new(trial.formula.clone())), span),
                })
            });
            with_rates_taken(self.quiet, &mut side)?;
            Some(side)
        };
        self.quiet.link(&inserted(&link.lhs)?, link.relation, &inserted(&link.rhs)?).ok()
    }
}
