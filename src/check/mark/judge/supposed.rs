//! The hypotheses of single claims of the problem, and which lines may use them.
//!
//! A claim may hold in a case alone: at t = 0, on a circle, for equal masses. A line that holds there is right if the hand-in says that
//! it speaks of the case. Where it does not, the line may be true of the case and false in general, and is left to the teacher.
//! Hypotheses that are no case are granted to each line: inequalities, the values at the start, what is conserved, and equations
//! of the problem.

use crate::formula::symbols::Name;
use crate::formula::{Expr, Node, Statement, SymbolId, Term};
use crate::latex::Reading;
use crate::notes::claims::{Claim, Spanned};
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::mark::carried::numbers;
use crate::check::mark::given;
use crate::check::mark::marked::Mark;
use crate::check::mark::motion::Along;
use crate::check::mark::special;
use crate::check::mark::status::{Status, status};
use crate::check::mark::world::World;
use crate::check::model::claim::{Hypothesis, Link, is_equality};
use crate::check::model::meaning::Meaning;

use super::Judge;

/// What the hypotheses of a claim, or the conditions of a hand-in, say of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Under {
    /// It holds under them, and they leave something of each of its terms.
    Holds,
    /// It holds under them, whatever a factor before one of its terms is.
    Anyway,
    /// It does not hold.
    No,
}

/// For each set of hypotheses of the problem, those that make a case.
pub(super) fn cases(checker: &Checker<'_>, world: &World<'_>, details: bool) -> Vec<Vec<Reading>> {
    let displays = &world.problem.notes.equations;
    let is_case = |text: &&Spanned<String>| {
        let is_equation_of_problem = displays.iter().any(|display| display.id() == Some(text.value.as_str()));
        !is_equation_of_problem && checker.without_start(&text.value).is_none()
    };
    let none = Claim::default();
    let is_equation = |reading: &Reading| {
        let equates = |statement: &Statement| statement.relations.iter().any(|(relation, _)| is_equality(*relation));
        reading.statements.iter().flatten().any(equates)
    };
    let is_conserved = |reading: &Reading| {
        let equalities = given::up_to_initial_values(checker, displays.len(), reading);
        let stays = |rate: &Reading| !details || matches!(status(checker, 0, rate, &none), Status::Holds(_));
        !equalities.is_empty() && equalities.iter().all(|(_, rate)| rate.as_ref().is_some_and(stays))
    };
    let of = |context: &Claim| {
        let texts = context.assume.iter().chain(&context.throughout).filter(is_case);
        let read = texts.map(|text| checker.as_printed(&text.value, &none, &checker.model.macros));
        read.filter(|reading| is_equation(reading) && !is_conserved(reading)).collect()
    };
    world.problem.contexts.iter().map(of).collect()
}

impl Judge<'_, '_> {
    /// Whether the `at`-th set of hypotheses of the problem is granted to a line: it makes no case, the hand-in says that it speaks of
    /// the case, or the line is the equation that the problem prints.
    pub(super) fn is_granted(&self, at: usize, display: usize, reading: &Reading) -> bool {
        let cases = &self.cases[at];
        // The name of one of the values that coordinates keep is enough, if none of the coordinates is there.
        let places: Vec<Option<bool>> = cases.iter().map(|case| self.names_the_place(reading, case)).collect();
        let is_about_them = places.iter().all(Option::is_some) && places.contains(&Some(true));
        is_about_them
            || cases.iter().zip(&places).all(|(case, place)| *place == Some(true) || self.says_the_case(display, case))
            || self.is_printed_under(&self.world.problem.contexts[at], reading)
    }

    /// A hypothesis of the problem that no line says, and without which a line does not hold, in the letters of the student.
    pub(super) fn unsaid_case(&self, checker: &Checker<'_>, display: usize, reading: &Reading) -> Option<String> {
        let contexts = self.world.problem.contexts.iter().enumerate();
        let (context, _) = contexts.map(|(at, context)| (context, at)).find(|(context, at)| {
            !self.is_granted(*at, display, reading)
                && !special::is_degenerate(checker, context, reading)
                && self.under(checker, display, reading, context) == Under::Holds
        })?;
        let text = context.throughout.first().or(context.assume.first())?;
        Some(self.world.in_own_letters(&text.value))
    }

    /// A place of the problem, if a line is an equation of a deviation from there, `\eta = r - r_0`: the hypothesis makes both sides 0, and
    /// nothing decides on the line.
    pub(super) fn deviation_from(&self, checker: &Checker<'_>, display: usize, reading: &Reading) -> Option<String> {
        let of_problem = self.world.problem.notes.equations.len();
        let own = &self.quiet.readings[display];
        let members = || own.statements.iter().flatten().flat_map(|statement| &statement.members);
        let (deviation, _) = members().flat_map(Expr::symbols).find(|(id, dots)| *dots == 2 && self.is_own(*id))?;
        let value = self.with_known(self.quiet.readings[display].clone());
        let model = self.quiet.model;
        let own_places = self.places_of_a_deviation(display, deviation);
        let kept = self.world.problem.special.kept().cloned().chain(own_places);
        let (of, place) = kept.into_iter().find(|(of, place)| {
            let id = |name| model.symbols.find(name).map(|(id, _)| id);
            let written_out = value.statements.iter().flatten().flat_map(|statement| &statement.members);
            let symbols: Vec<_> = written_out
                .map(|member| given::expanded(self.quiet, of_problem, member.clone()))
                .flat_map(|member| member.symbols())
                .map(|(id, _)| Some(id))
                .collect();
            !symbols.contains(&Some(deviation)) && symbols.contains(&id(of)) && symbols.contains(&id(place))
        })?;
        let said = Spanned::new(format!("{of} = {place}"), Span::default());
        let claim = Claim { throughout: vec![said], ..Claim::default() };
        (self.under(checker, display, reading, &claim) == Under::Anyway)
            .then(|| self.world.in_own_letters(&place.to_string()))
    }

    /// The place from which a line before says that a deviation counts, `r = r_0 + \xi`, with the coordinate, after words for what is small.
    fn places_of_a_deviation(&self, display: usize, deviation: SymbolId) -> Vec<(Name, Name)> {
        let model = self.quiet.model;
        let name = |id: SymbolId| model.symbols.entry(id).name.clone();
        let is_near = self.world.written[display - self.world.first].is_near;
        let said = self.implied.iter().filter(|implied| is_near && implied.symbol() == deviation);
        let pairs = said.flat_map(|implied| {
            let symbols: Vec<SymbolId> = implied.symbols().into_iter().map(|(id, _)| id).collect();
            let moves = |id: &SymbolId| {
                matches!(model.meaning(*id), Some(Meaning::Coordinate(_) | Meaning::Varying(_))) && !self.is_own(*id)
            };
            let (moving, fixed): (Vec<SymbolId>, Vec<SymbolId>) = symbols.into_iter().partition(moves);
            match (moving.as_slice(), fixed.as_slice()) {
                ([of], [place]) => Some((name(*of), name(*place))),
                _ => None,
            }
        });
        pairs.collect()
    }

    /// What a line is under hypotheses.
    pub(super) fn under(&self, checker: &Checker<'_>, display: usize, reading: &Reading, claim: &Claim) -> Under {
        let holds = |reading: &Reading| {
            self.holds_under(checker, display, reading, claim)
                || self.along(checker, display, reading, claim) == Along::True
        };
        match holds(reading) {
            false => Under::No,
            true if with_another_factor(reading).iter().any(holds) => Under::Anyway,
            true => Under::Holds,
        }
    }

    /// Whether the words before a line, the line, one before it or the one behind it say a hypothesis.
    fn says_the_case(&self, display: usize, case: &Reading) -> bool {
        let at = display - self.world.first;
        let statements = || case.statements.iter().flatten();
        if self.world.written[at].is_at_start && statements().all(|statement| self.is_the_start(statement)) {
            return true;
        }
        let may_say = |other: &usize| {
            let is_false = |mark: Mark| matches!(mark, Mark::Wrong | Mark::Carried | Mark::Unread);
            self.lines.get(*other).is_none_or(|line| !is_false(line.mark))
        };
        let lines = (0..self.world.written.len().min(at + 2)).filter(may_say);
        let readings: Vec<&Reading> = lines.map(|other| &self.quiet.readings[self.world.first + other]).collect();
        let is_said = |statement: &Statement| {
            readings.iter().flat_map(|reading| reading.statements.iter().flatten()).any(|said| is_same(said, statement))
        };
        statements().all(is_said)
    }

    /// Whether a statement is `t = 0`.
    fn is_the_start(&self, statement: &Statement) -> bool {
        let is_time = |member: &Expr| {
            let id = member.as_plain_symbol();
            id.is_some_and(|id| matches!(self.quiet.model.meaning(id), Some(Meaning::Time)))
        };
        statement.members.len() == 2 && is_time(&statement.members[0]) && statement.members[1].is_null()
    }

    /// Whether a line has the name of the value that a hypothesis gives a coordinate, or a rate of one: `E = -\frac{k}{2 r_0}` is about
    /// the circle r = r_0. `None`, if the hypothesis gives no such value, or the coordinate is in the line.
    fn names_the_place(&self, reading: &Reading, case: &Reading) -> Option<bool> {
        let [Ok(statement)] = case.statements.as_slice() else { return None };
        let [Expr { node: Node::Symbol { id: of, .. }, .. }, value] = statement.members.as_slice() else {
            return None;
        };
        let place = value.as_plain_symbol()?;
        let is_fixed = matches!(self.quiet.model.meaning(place), Some(Meaning::Constant(_) | Meaning::Defined(_)));
        let of_problem = self.world.problem.notes.equations.len();
        let members = reading.statements.iter().flatten().flat_map(|statement| &statement.members);
        let written_out = members.map(|member| given::expanded(self.quiet, of_problem, member.clone()));
        let symbols: Vec<_> = written_out.flat_map(|member| member.symbols()).map(|(id, _)| id).collect();
        (is_fixed && !symbols.contains(of)).then(|| symbols.contains(&place))
    }

    /// Whether a line says what an equation says that the problem prints under these hypotheses, and no more.
    fn is_printed_under(&self, context: &Claim, reading: &Reading) -> bool {
        let problem = self.world.problem;
        let has = |claim: &Claim| {
            claim.throughout == context.throughout && claim.assume.iter().all(|text| context.assume.contains(text))
        };
        let numbers = problem.claims.equations.iter().filter(|(_, claim)| has(claim)).map(|(address, _)| &address.text);
        let display = |number: &String| problem.notes.equations.iter().position(|other| other.id() == Some(number));
        let Some(own) = numbers::links(self.quiet, reading) else { return false };
        let model = self.quiet.without_system(false).model;
        let says = |one: &Link, other: &Link| {
            let premise = [Hypothesis::of(one.clone(), false)];
            let other = numbers::beside_one(self.quiet, other);
            numbers::holds(self.quiet, &model, &other, &premise) == Some(true)
                && numbers::holds(self.quiet, &model, &other, &[]) == Some(false)
        };
        numbers.filter_map(display).any(|at| {
            let printed = numbers::links(self.quiet, &self.quiet.readings[at]).unwrap_or_default();
            own.iter().all(|link| printed.iter().any(|known| says(link, known) && says(known, link)))
        })
    }
}

/// Whether a line that holds also holds with three times any of its terms: all of them are 0.
pub(super) fn says_nothing(reading: &Reading, holds: impl Fn(&Reading) -> bool) -> bool {
    let others = with_another_factor(reading);
    !others.is_empty() && others.iter().all(holds)
}

/// Whether two statements are the same equality.
fn is_same(said: &Statement, known: &Statement) -> bool {
    let has = |a: &Expr, b: &Expr| {
        let pairs = said.members.windows(2).zip(&said.relations);
        let mut equal = pairs.filter(|(_, (relation, _))| is_equality(*relation));
        equal.any(|(pair, _)| pair[0] == *a && pair[1] == *b || pair[0] == *b && pair[1] == *a)
    };
    matches!(known.members.as_slice(), [a, b] if has(a, b))
}

/// A line with three times one of its terms, for each term: where one of them holds too, the line says nothing of the term. That a
/// single term is 0 has no such twin.
fn with_another_factor(reading: &Reading) -> Vec<Reading> {
    let mut found = Vec::new();
    for (at, statement) in reading.statements.iter().enumerate() {
        let Ok(statement) = statement else { continue };
        let is_zero = |pair: &[Expr]| pair.iter().any(Expr::is_null) && pair.iter().all(|side| terms(side) == 1);
        if !statement.relations.iter().all(|(relation, _)| is_equality(*relation))
            || statement.members.windows(2).any(is_zero)
        {
            continue;
        }
        for (place, member) in statement.members.iter().enumerate() {
            for term in 0..terms(member) {
                let Some(member) = with_three_times(member, term) else { continue };
                let mut new = reading.clone();
                if let Ok(statement) = &mut new.statements[at] {
                    statement.members[place] = member;
                }
                found.push(new);
            }
        }
    }
    found
}

fn terms(formula: &Expr) -> usize {
    match &formula.node {
        Node::Sum(terms) => terms.len(),
        _ => 1,
    }
}

/// A formula with three times one of its terms; `None`, if that is a number.
fn with_three_times(formula: &Expr, at: usize) -> Option<Expr> {
    let three = |term: &Expr| {
        let product = Node::Product(vec![Expr::integer(3, Span::default()), term.clone()]);
        (!term.symbols().is_empty()).then(|| Expr::new(product, term.span))
    };
    let Node::Sum(terms) = &formula.node else { return three(formula) };
    let mut terms = terms.clone();
    terms[at] = Term { expr: three(&terms[at].expr)?, ..terms[at].clone() };
    Some(Expr::new(Node::Sum(terms), formula.span))
}
