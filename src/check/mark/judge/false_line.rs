//! A line that does not hold in the problem: it gives something, is true in another sense, follows from a false line before
//! it, is left open, or is wrong.

use crate::Result;
use crate::formula::units::Unit;
use crate::formula::{Expr, Node, Statement, SymbolId};
use crate::latex::Reading;
use crate::notes::claims::{Claim, Spanned};

use crate::check::document::checker::Checker;
use crate::check::mark::carried::{Before, energies, origin};
use crate::check::mark::given::{self, Implied};
use crate::check::mark::marked::{Because, Line, Mark};
use crate::check::mark::results;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

use super::readings::vanishes;
use super::{Judge, carried};

/// A mark with its verdict and the reason for it.
type Reason = (Mark, Verdict, Because);

fn given(because: impl Into<Because>) -> Reason {
    (Mark::Given, Verdict::Assumed, because.into())
}

fn right(because: impl Into<Because>) -> Reason {
    (Mark::Right, Verdict::Verified, because.into())
}

fn open(because: impl Into<Because>) -> Reason {
    (Mark::Open, Verdict::Undecided, because.into())
}

impl Judge<'_, '_> {
    pub(super) fn false_line(
        &mut self,
        at: usize,
        reading: &Reading,
        line: &mut Line,
        finding: &Finding,
    ) -> Result<()> {
        line.verdict = Some(finding.verdict);
        let found = match self.as_condition(at, reading) {
            Some(found) => Some(found),
            None => self.as_true_otherwise(at, reading)?,
        };
        if let Some((mark, verdict, because)) = found {
            (line.mark, line.verdict, line.because) = (mark, Some(verdict), because);
            return Ok(());
        }
        if let Some(from) = self.carried_from(at, reading)? {
            (line.mark, line.follows_from) = (Mark::Carried, Some(from));
            line.because = carried(&self.lines, from, &self.wrong_values_in(reading));
            return Ok(());
        }
        let (mark, verdict, because) = self.open_or_wrong(at, reading)?;
        (line.mark, line.because) = (mark, because.into());
        line.verdict = verdict.or(line.verdict);
        Ok(())
    }

    /// The false lines that are the last before this one to give a value to a name in it.
    fn wrong_values_in(&self, reading: &Reading) -> Vec<usize> {
        let members = |reading: &'_ Reading| {
            let statements = reading.statements.iter().flatten();
            statements.flat_map(|statement| statement.members.clone()).collect::<Vec<_>>()
        };
        let gives =
            |at: usize| members(self.premises.get(self.world.first + at)?).first().and_then(Expr::as_plain_symbol);
        let mut names: Vec<SymbolId> = members(reading).iter().flat_map(Expr::symbols).map(|(id, _)| id).collect();
        names.sort_unstable_by_key(|id| id.0);
        names.dedup();
        let last = |id: &SymbolId| (0..self.lines.len()).rev().find(|at| gives(*at) == Some(*id));
        names.iter().filter_map(last).filter(|at| self.lines[*at].mark == Mark::Wrong).collect()
    }

    /// What a line gives: a law, a condition, a value. Lines after it are also judged under it.
    fn as_condition(&mut self, at: usize, reading: &Reading) -> Option<Reason> {
        let written = &self.world.written[at];
        // A law may be a condition that the others do not imply, as the form of a steady motion.
        if results::prints_a_law(self.quiet, self.world, reading) {
            return Some((Mark::Given, Verdict::Law, "is a law that the problem gives".into()));
        }
        let statements: Vec<&Statement> = reading.statements.iter().flatten().collect();
        if written.continues.is_none() && statements.iter().all(|statement| self.is_supposed_in_the_problem(statement))
        {
            return Some(given("is a condition of the problem"));
        }
        let is_said = written.is_supposed || written.inline;
        let is_condition = |statement: &&Statement| given::may_be(self.quiet, statement, &self.wanted, is_said);
        let is_last = at + 1 == self.world.written.len();
        let has_value = !statements.is_empty() && statements.iter().all(is_condition);
        if written.continues.is_none() && has_value && (is_said || !is_last) {
            self.add_condition(at);
            self.known.add(reading, true);
            let own = |id: SymbolId| self.is_own(id);
            let compares = statements.iter().all(|statement| given::compares_constants(self.quiet, statement, own));
            return Some(match !is_said && compares {
                true => {
                    self.unsaid.push(written.name.clone());
                    open(UNSAID)
                }
                false => given("is a condition or a value, and is taken for granted"),
            });
        }
        let is_state = |statement: &&Statement| given::is_special_state(self.quiet, statement, &self.wanted);
        if written.inline && written.continues.is_none() && !statements.is_empty() && statements.iter().all(is_state) {
            // One solution among others says nothing of the lines after it.
            let vanishes = |statement: &&Statement| statement.members.iter().any(Expr::is_null);
            if written.is_supposed || written.is_if || statements.iter().all(vanishes) {
                self.add_condition(at);
            }
            return Some(given("is a special state of the motion, and is taken for granted"));
        }
        let is_phase = |statement: &&Statement| self.is_instant_of_a_phase(statement);
        if written.inline && written.continues.is_none() && !statements.is_empty() && statements.iter().all(is_phase) {
            return Some(given("defines an instant by its phase, as in ωt = π/2"));
        }
        if let Some(name) = vanishes(self.quiet, &statements).filter(|_| is_said) {
            self.breaks.push((name, written.name.clone()));
            return Some(open("is a condition that the problem does not have"));
        }
        let is_ratio = written.continues.is_none()
            && !statements.is_empty()
            && statements.iter().all(|statement| self.is_ratio_of_data(statement) && !self.is_determined(statement));
        let is_case = written.is_if || written.is_example;
        let is_condition = is_case && statements.iter().all(|statement| self.relates_constants(statement))
            || is_ratio && self.stands_beside_a_value(at);
        if is_condition || is_ratio {
            self.add_condition(at);
            self.known.add_relation(self.quiet, reading);
            return Some(if is_condition { given("is a condition, and is taken for granted") } else { open(UNSAID) });
        }
        if self.has_unknown_instant(reading) {
            self.add_condition(at);
            return Some(given("is a value at an instant that the problem leaves open"));
        }
        None
    }

    /// Whether a result of the problem holds under what a statement says, as the angle at which a rod leaves a wall does where the
    /// force vanishes.
    fn is_supposed_in_the_problem(&self, statement: &Statement) -> bool {
        let texts = self.world.problem.contexts.iter().flat_map(|claim| claim.assume.iter().chain(&claim.throughout));
        let macros = &self.quiet.model.macros;
        let read = |text: &Spanned<String>| self.quiet.as_printed(&text.value, &Claim::default(), macros);
        let is_it = |known: &Statement| {
            let same = |a: &[Expr], b: &[Expr]| a == b || a.iter().eq(b.iter().rev());
            let relations = |of: &Statement| of.relations.iter().map(|(relation, _)| *relation).collect::<Vec<_>>();
            same(&known.members, &statement.members) && relations(known) == relations(statement)
        };
        statement.members.len() == 2 && texts.map(read).any(|reading| reading.statements.iter().flatten().any(is_it))
    }

    pub(super) fn add_condition(&mut self, at: usize) {
        self.conditions.push((self.world.display(at).text.clone(), self.world.written[at].name.clone()));
    }

    /// What a line says that holds in another sense than as an equation of the problem: it says what a quantity of the student's
    /// own is, counts from another zero, is rounded, follows under a condition, or is a case.
    fn as_true_otherwise(&mut self, at: usize, reading: &Reading) -> Result<Option<Reason>> {
        let written = &self.world.written[at];
        let display = self.world.first + at;
        if self.is_tried(at, reading) {
            return Ok(Some(given(TRIAL)));
        }
        if let Some(reason) = self.solves_a_printed_equation(at, reading) {
            return Ok(Some(given(reason)));
        }
        if let Some(name) = self.follows_from_a_trial(reading) {
            return Ok(Some(right(format!("follows from the trial solution in {name}"))));
        }
        if let Some(said) = self.said_before_its_value(at, reading) {
            let because = format!("defines {}, to which a later line gives another value", said.name(self.quiet));
            self.implied.push(said);
            return Ok(Some(given(because)));
        }
        if !self.is_about_a_trial(reading)
            && !self.has_a_numbered_value(reading)
            && !self.ends_are_false(display, reading)
            && let Some(implied) = Implied::by(self.quiet, (&self.world.declared, &self.open), reading)
            && !self.is_a_constant_that_moves(&implied)
            && let Some(all) = self.given_by(display, reading, implied.clone())
            && (self.names_the_last(display, reading, &implied)
                || self.is_another_variable(reading, &implied)
                || !(self.details && self.is_slip(at)?))
        {
            let name = implied.name(self.quiet);
            let because = match self.open.contains(&implied.symbol()) {
                true => format!("defines {name}, which the problem leaves open"),
                false if Unit::named(&name).is_some() && is_number_times_a_letter(reading) => format!(
                    "defines {name}, which the problem does not use; if {name} is a unit, it is written \\text{{{name}}}"
                ),
                false => format!("defines {name}, which the problem does not use"),
            };
            self.implied.extend(all);
            return Ok(Some(given(because)));
        }
        if self.ends_in_a_condition(at, reading) {
            self.add_condition(at);
            return Ok(Some(right("follows from the problem, and its last member is a condition")));
        }
        if self.is_condition_of_an_extremum(at, reading) {
            return Ok(Some(given("is the condition for an extremum")));
        }
        if energies::has_another_zero(self.quiet, display, reading) {
            return Ok(Some(right("is correct up to a constant, so only the zero of the potential energy differs")));
        }
        if self.is_rounded(display, reading) {
            if let Some(why) = self.wrong_unit(at, reading) {
                return Ok(Some((Mark::Wrong, Verdict::Refuted, why)));
            }
            self.known.add(reading, false);
            return Ok(Some(right("agrees to the printed digits, with the numbers that are given")));
        }
        if let Some(limit) = self.limit_in_which_it_holds(display, reading) {
            return Ok(Some(right(format!("follows in the limit {limit}"))));
        }
        if let Some(name) = self.follows_with_a_later_line(at, reading) {
            return Ok(Some(right(format!("follows together with {name}"))));
        }
        if let Some(name) = self.follows_under_a_condition(reading) {
            return Ok(Some(right(format!("follows under the condition of {name}"))));
        }
        if self.has_constants_of_integration(display, reading) {
            return Ok(Some(right("solves the equations of motion, with constants that a later line gives")));
        }
        let text = &self.world.display(at).text;
        if self.world.problem.special.is_rest(self.quiet, display, (text, reading)) {
            return Ok(Some(right("says where the system can be at rest")));
        }
        if text.contains("\\pm") && self.has_a_true_sign(display, reading) {
            return Ok(Some(right("is true with one of the two signs")));
        }
        let is_alternative =
            written.is_alternative || self.world.written.get(at + 1).is_some_and(|next| next.is_alternative);
        if is_alternative && self.is_an_alternative(at) {
            return Ok(Some(given("is one of the cases that an earlier line leaves open")));
        }
        if self.is_a_case(display, reading) {
            self.add_condition(at);
            return Ok(Some(given("is one of the cases that an earlier condition leaves open")));
        }
        let in_general = self.world.problem.special.at_all_times(self.quiet, &self.with_running_time(reading));
        if self.is_up_to_initial_values(display, reading)
            || in_general.is_some_and(|reading| self.is_up_to_initial_values(display, &reading))
        {
            return Ok(Some(given("is true up to a constant, which an initial value makes 0")));
        }
        Ok(None)
    }

    /// Whether a line tries a solution, which is then kept for the lines after it.
    pub(super) fn is_tried(&mut self, at: usize, reading: &Reading) -> bool {
        let trial = self.trial(at, reading);
        let is_tried = trial.is_some() || self.is_of_a_mode(at, reading);
        self.trials.extend(trial);
        if is_tried {
            // What follows from it is not judged as a step from a solution of the problem.
            self.trusted[self.world.first + at] = Reading::default();
        }
        is_tried
    }

    /// The displays of the lines before for which something holds.
    fn displays(&self, wanted: impl Fn(&Line) -> bool) -> Vec<usize> {
        (0..self.lines.len()).filter(|n| wanted(&self.lines[*n])).map(|n| self.world.first + n).collect()
    }

    /// The false line, by its place, from which a line follows.
    fn carried_from(&mut self, at: usize, reading: &Reading) -> Result<Option<usize>> {
        let display = self.world.first + at;
        let all = self.displays(|_| true);
        let mut wrong = self.displays(|line| matches!(line.mark, Mark::Wrong | Mark::Carried));
        let mut sound = self.displays(|line| line.mark == Mark::Right || line.verdict == Some(Verdict::Law));
        // With a false constant the solution that has it is false.
        let first = self.world.first;
        for (solution, _) in &self.false_constants {
            sound.retain(|other| *other != first + solution);
            wrong.push(first + solution);
        }
        let before = Before {
            all: &all,
            wrong: &wrong,
            sound: &sound,
            laws: &self.world.problem.laws,
            motion: &self.motion,
            special: &self.world.problem.special,
            contexts: &self.world.problem.contexts,
        };
        let checker = Checker { readings: &self.premises, units: self.quiet.units.clone(), ..*self.quiet };
        if !wrong.is_empty()
            && self.details
            && let Some(from) = origin(&checker, (display, reading), &before).unwrap_or(None)
        {
            let from = from - first;
            let constant = self.false_constants.iter().find(|(solution, _)| *solution == from);
            return Ok(Some(constant.map_or(from, |(_, line)| *line)));
        }
        if let Some(start) = self.carried_number(display, reading).or_else(|| self.carried_from_a_trial(reading)) {
            return Ok(Some(start));
        }
        if let Some(rest) = self.before_a_true_number(display, reading)
            && let Some(start) = self.carried_from(at, &rest)?
        {
            return Ok(Some(start));
        }
        if let Some(start) = self.carried_root(reading).or_else(|| self.starts_as_a_false_line(display, reading)) {
            return Ok(Some(start));
        }
        let own = self.displays(|line| line.verdict == Some(Verdict::Definition));
        let energy = if self.details { energies::false_energy(self.quiet, (display, reading), &own) } else { None };
        Ok(energy.map(|energy| {
            let energy = energy - self.world.first;
            let false_one = &mut self.lines[energy];
            (false_one.mark, false_one.verdict) = (Mark::Wrong, Some(Verdict::Refuted));
            false_one.because = "gives a Lagrangian that is not that of the problem".into();
            energy
        }))
    }

    /// The mark of a false line that follows from nothing before it, with a verdict where that is another one.
    fn open_or_wrong(&self, at: usize, reading: &Reading) -> Result<(Mark, Option<Verdict>, String)> {
        let display = self.world.first + at;
        if self.details && !self.ends_are_false(display, reading) && self.leaves_open(at, reading)? {
            let because = format!("uses {}, which no line defines", self.unknown(reading).join(", "));
            return Ok((Mark::Open, Some(Verdict::Undecided), because));
        }
        if let Some(why) = self.energy_for_a_constant(reading).filter(|_| self.details) {
            return Ok((Mark::Open, Some(Verdict::Undecided), why));
        }
        if let Some(why) = self.another_meaning(display, reading).filter(|_| self.details) {
            return Ok((Mark::Open, Some(Verdict::Undecided), why));
        }
        let trusting = Checker { readings: &self.trusted, units: self.quiet.units.clone(), ..*self.quiet };
        if self.details
            && let Some(case) = self.unsaid_case(&trusting, display, reading)
        {
            let because = format!("holds only where {case}, and no line says that it is about this case");
            return Ok((Mark::Open, Some(Verdict::Undecided), because));
        }
        if self.details
            && !self.world.problem.special.has_modes_at_places()
            && let Some(place) = self.deviation_from(&trusting, display, reading)
        {
            let because = format!("is about a small deviation from {place}, on which the problem says nothing");
            return Ok((Mark::Open, Some(Verdict::Undecided), because));
        }
        let missing = if self.details { self.missing_values(display, reading) } else { Vec::new() };
        if !missing.is_empty() {
            let because = format!("is a number, and no line gives the value of {}", missing.join(", "));
            return Ok((Mark::Open, Some(Verdict::Undecided), because));
        }
        let is_wrong = |line: &Line| matches!(line.mark, Mark::Wrong | Mark::Carried);
        let because = match self.lines.iter().any(is_wrong) {
            false => "does not follow from the problem",
            true => "follows neither from the problem nor from the lines before it",
        };
        Ok((Mark::Wrong, None, because.to_owned()))
    }
}

/// Whether a reading gives a quantity a number times a letter, which may be a unit: `H = 5 m`.
fn is_number_times_a_letter(reading: &Reading) -> bool {
    let last = reading.statements.iter().flatten().next().and_then(|statement| statement.members.last());
    last.is_some_and(|last| match &last.node {
        Node::Product(factors) => {
            matches!(factors.as_slice(), [number, letter] if number.as_digits().is_some() && letter.as_plain_symbol().is_some())
        }
        _ => false,
    })
}

/// What is said of a trial solution.
pub(super) const TRIAL: &str = "is a trial solution, with names that the problem does not have";

/// Why a condition is left open.
const UNSAID: &str = "is a condition that the problem does not have, and no word before it says that it is a condition";
