//! Cases that a condition leaves, conclusions under a condition, and values at instants.

use crate::formula::{Expr, Node, Statement, SymbolId};
use crate::latex::Reading;
use crate::notes::claims::{Claim, Spanned};
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::kinds::solution::is_an_orbit;
use crate::check::mark::carried::numbers;
use crate::check::mark::given::{self, Implied};
use crate::check::mark::marked::{Because, Line, Mark};
use crate::check::mark::motion::{Along, printed};
use crate::check::mark::names::moving;
use crate::check::mark::slip;
use crate::check::mark::status::{Status, approximate, stated, status};
use crate::check::model::claim::is_equality;
use crate::check::model::meaning::Meaning;
use crate::check::verdict::Verdict;

use super::{Condition, Judge, supposed};

/// The lines behind a line that may say what a quantity in it is.
const LATER: usize = 3;

/// The lines before an alternative of which it may be a case.
const CASES: usize = 3;

impl Judge<'_, '_> {
    /// What a line is under conditions, all of them or the last one, if it holds there.
    pub(super) fn under_conditions(
        &self,
        checker: &Checker<'_>,
        (display, reading): (usize, &Reading),
        conditions: &[Condition],
    ) -> Option<(Status, Option<Because>)> {
        let (text, name) = conditions.last()?;
        let spanned = |text: &String| Spanned::new(text.clone(), Span::default());
        let all: Vec<Spanned<String>> = conditions.iter().map(|(text, _)| spanned(text)).collect();
        // Conditions for different instants contradict each other.
        let last = (all.len() > 1).then(|| vec![spanned(text)]);
        [Some(all), last].into_iter().flatten().find_map(|assume| {
            let claim = Claim { assume, ..Claim::default() };
            let holds = |reading: &Reading| {
                self.holds_under(checker, display, reading, &claim)
                    || self.along(checker, display, reading, &claim) == Along::True
            };
            // In equilibrium all terms of an equation of motion may be 0, and it says nothing.
            if !holds(reading) || self.details && supposed::says_nothing(reading, holds) {
                return None;
            }
            let unsaid = self.unsaid.last().filter(|unsaid| claim.assume.len() > 1 || *unsaid == name);
            Some(match unsaid {
                Some(unsaid) => {
                    let why = format!("holds under the condition of {unsaid}, and no word says that it is a condition");
                    (Status::Open(Verdict::Undecided, why), None)
                }
                None => {
                    let why = format!("follows under the condition of {name}");
                    (Status::Holds(Verdict::Verified), Some(why.into()))
                }
            })
        })
    }

    /// The limit that the sentence of a line names, if the line holds there: "for $M \to \infty$ it is $\ddot s = g\sin\alpha$".
    pub(super) fn limit_in_which_it_holds(&self, display: usize, reading: &Reading) -> Option<String> {
        let at = display - self.world.first;
        let limit = self.world.limits[at].as_ref().filter(|_| self.details)?;
        let limit = Some(Spanned::new(limit.clone(), Span::default()));
        let claim = Claim { limit, ..Claim::default() };
        let holds = matches!(status(self.quiet, display, &approximate(reading), &claim), Status::Holds(_));
        holds.then(|| self.world.written[at].limit.clone()).flatten()
    }

    /// The conditions that say nothing of a state, and so hold at all times: `m_1 = m_2`.
    fn lasting(&self) -> Vec<Condition> {
        let moving = moving(self.quiet.model);
        let lasts = |(text, _): &&Condition| {
            let reading = self.quiet.as_printed(text, &Claim::default(), &self.quiet.model.macros);
            let mut members = reading.statements.iter().flatten().flat_map(|statement| &statement.members);
            !members.any(|member| self.quiet.model.depends_on(member, &moving))
        };
        self.conditions.iter().filter(lasts).cloned().collect()
    }

    /// Whether the last condition holds where a line holds, so that the line is one of the cases that it leaves.
    pub(super) fn is_a_case(&self, display: usize, reading: &Reading) -> bool {
        let Some((condition, _)) = self.conditions.last() else { return false };
        let is_equation = reading.statements.iter().flatten().all(|statement| {
            statement.members.len() == 2 && statement.relations.iter().all(|(relation, _)| is_equality(*relation))
        });
        let none = Claim::default();
        let text = &self.world.display(display - self.world.first).text;
        let condition = self.quiet.as_printed(condition, &none, &self.quiet.model.macros);
        let assume = vec![Spanned::new(text.clone(), Span::default())];
        let with = Claim { assume, ..Claim::default() };
        is_equation && matches!(status(self.quiet, display, &condition, &with), Status::Holds(_))
    }

    /// Whether a line that holds under a condition, among those nearest before an alternative, holds where the alternative does.
    pub(super) fn is_an_alternative(&self, at: usize) -> bool {
        let text = self.world.display(at).text.replace("\\equiv", "=");
        let members: Vec<&str> = text.split('=').collect();
        let [first, second, ..] = members.as_slice() else { return false };
        let display = self.world.first + at;
        let none = Claim::default();
        let macros = &self.quiet.model.macros;
        let rest = (members.len() > 2).then(|| self.quiet.as_printed(&members[1..].join("="), &none, macros));
        let claim =
            Claim { assume: vec![Spanned::new(format!("{first} = {second}"), Span::default())], ..Claim::default() };
        let holds = |reading: &Reading| matches!(status(self.quiet, display, reading, &claim), Status::Holds(_));
        let is_open = |line: &Line| matches!(line.mark, Mark::Right | Mark::Given) && !line.inline;
        let before = (at.saturating_sub(CASES)..at).rev().filter(|before| is_open(&self.lines[*before]));
        rest.is_none_or(|rest| matches!(self.status(display, &rest).0, Status::Holds(_)))
            && before.into_iter().any(|before| {
                if numbers::solves_at_rest(self.quiet, self.world.first + at, self.world.first + before) {
                    return true;
                }
                let own = &self.premises[self.world.first + before];
                let holds_anyway = || matches!(status(self.quiet, display, own, &none), Status::Holds(_));
                stated(own).is_none() && !holds_anyway() && holds(own)
            })
    }

    /// A reading with what is known of the student's own quantities in their place: values at instants, and what relations say.
    /// Names that are defined by such quantities are written out, so that nothing hides in them: `c_2 = e^{-c_1}`.
    pub(super) fn with_known(&self, mut reading: Reading) -> Reading {
        let of_problem = self.world.problem.notes.equations.len();
        let known: Vec<SymbolId> = self
            .instants
            .iter()
            .filter_map(|(id, value)| value.as_ref().map(|_| *id))
            .chain(self.implied.iter().map(Implied::symbol))
            .collect();
        let value = |node: &Node| match node {
            Node::Symbol { id, dots: 0, .. } => self.instants.iter().find(|(known, _)| known == id)?.1.clone(),
            _ => None,
        };
        // What a line says of a quantity counts for more than a value that a later line gives it.
        let is_defined = |id: SymbolId| matches!(self.quiet.model.meaning(id), Some(Meaning::Defined(_)));
        for implied in self.implied.iter().filter(|implied| is_defined(implied.symbol())) {
            reading = implied.applied(reading);
        }
        for member in reading.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
            if self.quiet.model.depends_on(member, &known) {
                *member = given::expanded(self.quiet, of_problem, member.clone());
            }
            member.substitute(&value);
        }
        self.implied.iter().fold(reading, |reading, implied| implied.applied(reading))
    }

    /// Whether a reading has a value at an instant that is not known.
    pub(super) fn has_unknown_instant(&self, reading: &Reading) -> bool {
        let members = || reading.statements.iter().flatten().flat_map(|statement| &statement.members);
        let is_unknown = |id: SymbolId| self.instants.iter().any(|(known, value)| *known == id && value.is_none());
        members().any(|member| member.symbols().iter().any(|(id, _)| is_unknown(*id)))
    }

    /// Whether a line prints a relation between coordinates that no law makes true, `x_1 = x_2`, where the problem prints no orbit: a
    /// motion that starts on it stays there, and others do not.
    pub(super) fn is_kept_by_some_motions(&self, checker: &Checker<'_>, reading: &Reading) -> bool {
        let is_orbit = |reading: &Reading| {
            let links = numbers::links(checker, reading).unwrap_or_default();
            links.iter().any(|link| is_an_orbit(link, checker.model))
        };
        let of_problem = self.world.problem.notes.equations.len();
        is_orbit(reading) && !self.quiet.readings[..of_problem].iter().any(is_orbit) && !slip::fits(checker, reading)
    }

    /// Whether a line is true up to a constant that an initial value makes 0.
    pub(super) fn is_up_to_initial_values(&self, display: usize, reading: &Reading) -> bool {
        let of_problem = self.world.problem.notes.equations.len();
        // What is 0 in one state need not stay as it is.
        let lasting = self.lasting();
        let holds = |reading: &Reading| matches!(self.status_with(display, reading, &lasting).0, Status::Holds(_));
        let equalities = given::up_to_initial_values(self.quiet, of_problem, reading);
        let stays = |rate: &Option<Reading>| rate.as_ref().is_some_and(holds);
        // Where the initial values are known, they do not make it true.
        let fails = || self.along(self.quiet, display, reading, &Claim::default()) == Along::False;
        !equalities.is_empty() && !fails() && equalities.iter().all(|(equality, rate)| stays(rate) || holds(equality))
    }

    /// Whether a line gives a velocity as a root, of which the problem knows the square, and holds where the velocity is positive.
    pub(super) fn holds_where_it_grows(&self, checker: &Checker<'_>, display: usize, reading: &Reading) -> bool {
        let [Ok(statement)] = reading.statements.as_slice() else { return false };
        let [Expr { node: Node::Symbol { id, dots: 1, .. }, .. }, others @ ..] = statement.members.as_slice() else {
            return false;
        };
        let is_root = |member: &Expr| matches!(member.node, Node::Root(..));
        if !checker.model.is_coordinate(*id) || !others.iter().any(is_root) {
            return false;
        }
        let positive = Spanned::new(format!("\\dot{{{}}} > 0", checker.model.name(*id)), Span::default());
        let supposed = self.world.problem.contexts.iter().enumerate().filter(|(_, claim)| !claim.assume.is_empty());
        let granted = supposed.filter(|(at, _)| self.is_granted(*at, display, reading)).map(|(_, claim)| claim);
        granted.filter(|claim| !checker.starts(claim)).any(|claim| {
            let assume = claim.assume.iter().cloned().chain([positive.clone()]).collect();
            self.holds_under(checker, display, reading, &Claim { assume, ..claim.clone() })
        })
    }

    /// Whether a line that names the place where a coordinate stays holds while it stays there, and the others turn in one sense: the
    /// speed on a circle, `v = r_0 \dot\varphi = u`.
    pub(super) fn holds_at_a_place(&self, checker: &Checker<'_>, display: usize, reading: &Reading) -> bool {
        let model = checker.model;
        let find = |name| Some(model.symbols.find(name)?.0);
        let members = || reading.statements.iter().flatten().flat_map(|statement| &statement.members);
        let has = |id: SymbolId, least: u8| {
            members().any(|member| member.symbols().iter().any(|(found, dots)| *found == id && *dots >= least))
        };
        let said = |text: String| Spanned::new(text, Span::default());
        self.world.problem.special.kept().any(|(of, place)| {
            let (Some(of_id), Some(place_id)) = (find(of), find(place)) else { return false };
            let turning: Vec<SymbolId> =
                model.coordinates.iter().map(|known| known.symbol).filter(|id| *id != of_id && has(*id, 1)).collect();
            let claim = Claim {
                throughout: vec![said(format!("{of} = {place}"))],
                assume: turning.iter().map(|id| said(format!("\\dot{{{}}} > 0", model.name(*id)))).collect(),
                ..Claim::default()
            };
            // Of the coordinate itself the line says nothing there.
            !turning.is_empty()
                && has(place_id, 0)
                && !has(of_id, 0)
                && self.holds_under(checker, display, reading, &claim)
        })
    }

    /// Whether a line with two signs holds with one of them.
    pub(super) fn has_a_true_sign(&self, display: usize, reading: &Reading) -> bool {
        let holds = |statement: &Statement| {
            let alone = Reading { statements: vec![Ok(statement.clone())], introduced: Vec::new() };
            matches!(self.status(display, &alone).0, Status::Holds(_))
        };
        reading.statements.len() == 2 && reading.statements.iter().flatten().any(holds)
    }

    /// Whether a chain that holds ends with a name for its last member, as `I = \dot Q =: I_0 e^{-t/(RC)}` does.
    pub(super) fn names_the_last(&self, display: usize, reading: &Reading, implied: &Implied) -> bool {
        let [Ok(statement)] = reading.statements.as_slice() else { return false };
        let Some((last, others)) = statement.members.split_last().filter(|(_, others)| others.len() > 1) else {
            return false;
        };
        let is_it = |member: &Expr| member.symbols().iter().any(|(id, _)| *id == implied.symbol());
        let (members, relations) = (others.to_vec(), statement.relations[..others.len() - 1].to_vec());
        let rest = Statement { members, relations, ..statement.clone() };
        let rest = Reading { statements: vec![Ok(rest)], introduced: Vec::new() };
        is_it(last) && !others.iter().any(is_it) && matches!(self.status(display, &rest).0, Status::Holds(_))
    }

    /// Whether a line puts another variable in the place of a coordinate, `x = x_0 + \varepsilon`: a quantity of the student's own that
    /// moves and that a line with accelerations uses, beside the coordinate and constants.
    pub(super) fn is_another_variable(&self, reading: &Reading, implied: &Implied) -> bool {
        let model = self.quiet.model;
        let own = implied.symbol();
        let [Ok(statement)] = reading.statements.as_slice() else { return false };
        let symbols: Vec<(SymbolId, u8)> = statement.members.iter().flat_map(Expr::symbols).collect();
        let is_coordinate = |id: SymbolId| model.is_coordinate(id);
        let moving = moving(model);
        let is_fixed = |id: SymbolId| {
            let symbol = Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, Span::default());
            !model.depends_on(&symbol, &moving)
        };
        statement.members.len() == 2
            && matches!(model.meaning(own), Some(Meaning::Varying(_)))
            && symbols.iter().filter(|(id, _)| is_coordinate(*id)).count() == 1
            && symbols.iter().all(|(id, dots)| *dots == 0 && (*id == own || is_coordinate(*id) || is_fixed(*id)))
    }

    /// Whether a line would give what moves to a name that is a constant in a function of the time before it, `x = A\cos\omega t`.
    pub(super) fn is_a_constant_that_moves(&self, implied: &Implied) -> bool {
        let model = self.quiet.model;
        let first = self.world.first;
        let before = self.quiet.readings[first..first + self.lines.len()].iter();
        let mut functions = before
            .flat_map(|reading| reading.statements.iter().flatten())
            .filter_map(|statement| printed(self.quiet, statement));
        functions.any(|own| own.formula.symbols().contains(&(implied.symbol(), 0)))
            && (implied.depends_on(model, &moving(model)))
    }

    /// The name of the line behind a line that says what a quantity of the student's own is, where the line holds with it.
    pub(super) fn follows_with_a_later_line(&self, at: usize, reading: &Reading) -> Option<&str> {
        let unknown = self.unknown_symbols(reading);
        if !self.details || unknown.is_empty() {
            return None;
        }
        let first = self.world.first;
        let later = (at + 1..self.world.written.len()).take(LATER).filter_map(|later| {
            let own = (self.world.declared.as_slice(), [].as_slice());
            let implied = Implied::by(self.quiet, own, &self.quiet.readings[first + later])?;
            (unknown == [implied.symbol()]).then_some((later, implied))
        });
        let holds = |(_, implied): &(usize, Implied)| {
            let new = implied.applied(reading.clone());
            let is_new = self.unknown_symbols(&new).is_empty();
            is_new && matches!(self.status(first + at, &new).0, Status::Holds(_))
        };
        let (line, _) = later.into_iter().find(holds)?;
        Some(self.world.written[line].name.as_str())
    }

    /// The name of the last condition, if a line follows from it and from a true line before it.
    pub(super) fn follows_under_a_condition(&self, reading: &Reading) -> Option<&str> {
        let (text, name) = self.conditions.last().filter(|_| self.details)?;
        let condition = self.quiet.as_printed(text, &Claim::default(), &self.quiet.model.macros);
        let is_sound = |line: &Line| line.mark == Mark::Right || line.verdict == Some(Verdict::Law);
        let sound: Vec<usize> =
            (0..self.lines.len()).filter(|at| is_sound(&self.lines[*at])).map(|at| self.world.first + at).collect();
        numbers::follows_under(self.quiet, &condition, &sound, reading).then_some(name)
    }

    /// The false line with an initial value that a solution of the laws has: the solution is that for this value.
    pub(super) fn starts_as_a_false_line(&self, display: usize, reading: &Reading) -> Option<usize> {
        let motion = self.motion.with(self.quiet, reading).filter(|_| self.details)?;
        if !matches!(status(self.quiet, display, reading, &Claim::default()), Status::Holds(_)) {
            return None;
        }
        let values: Vec<(SymbolId, Expr)> = self
            .world
            .instants
            .iter()
            .zip(&self.instants)
            .filter_map(|(instant, (id, _))| Some((*id, motion.value(self.quiet, instant)?)))
            .collect();
        let starts_so = |at: &usize| {
            let mut start = self.quiet.readings[self.world.first + at].clone();
            let mut is_there = false;
            for member in start.statements.iter_mut().flatten().flat_map(|statement| &mut statement.members) {
                is_there |= member.symbols().iter().any(|(id, _)| values.iter().any(|(known, _)| known == id));
                member.substitute(&|node| match node {
                    Node::Symbol { id, .. } => {
                        values.iter().find(|(known, _)| known == id).map(|(_, value)| value.clone())
                    }
                    _ => None,
                });
            }
            is_there && matches!(status(self.quiet, display, &start, &Claim::default()), Status::Holds(_))
        };
        (0..self.lines.len()).rev().filter(|at| self.lines[*at].mark == Mark::Wrong).find(starts_so)
    }
}
