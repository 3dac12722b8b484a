//! The displays of notes in their order, each judged by what was said before it.
//!
//! A display follows by itself, or from relations that were taken for granted before it ([`premises`]). If it does not, a
//! slip is sought, first without premises and then with those that it could follow from. What is no slip is taken for
//! granted, and is a premise of what comes later. What is wrong is no premise.
//!
//! Offers `judged`, and `judged_again` where some findings are known already. Knows `gate` and the premises of `unaided`, and `repair` and
//! below.

mod arguments;
mod cases;
mod chains;
mod constants;
mod doubts;
pub(super) mod examples;
mod extrema;
mod factor;
mod in_sentence;
mod restated;
mod roots;
mod slips;
mod sought;
mod special_values;
mod systems;
pub(super) mod taken;

use std::collections::{HashMap, VecDeque};
use std::sync::OnceLock;

use rayon::prelude::*;

use crate::Result;
use crate::check::document::checker::Checker;
use crate::check::document::setup::Run;
use crate::check::model::meaning::Meaning;
use crate::check::sample::context::Options;
use crate::check::unaided::contradictions;
use crate::check::unaided::gate;
use crate::check::unaided::inline;
use crate::check::unaided::ordered::{self, Ordered};
use crate::check::unaided::premises::{self, Premise, Sought, named};
use crate::check::unaided::prose;
use crate::check::unaided::prose::contrasts::Cases;
use crate::check::unaided::scope::Scope;
use crate::check::unaided::screen;
use crate::check::unaided::signs::{self, Positive};
use crate::check::unaided::solutions;
use crate::check::verdict::Verdict;
use crate::check::verdict::report::Equation;
use crate::code::Code;
use crate::formula::{Expr, Statement, SymbolId, text};
use crate::notes::claims::Claim;

/// The fewest symbols of a relation that is taken for an earlier one in another form.
const FEWEST_RESTATED: usize = 4;

/// The number of displays that are first judged by themselves at once.
const AT_ONCE: usize = 16;

/// What is known of the displays of a scope.
pub(super) struct Judged {
    /// The findings, in the order of the displays, up to the section in which a letter has another meaning.
    pub found: Vec<Equation>,
    /// What was taken for granted, and what follows.
    pub premises: Vec<Premise>,
}

/// The findings on the displays of a scope.
///
/// # Errors
/// When a claim does not fit the notes.
pub(super) fn judged(run: &Run<'_>, checker: &Checker<'_>, scope: &Scope) -> Result<Judged> {
    judged_again(run, checker, scope, (&|_| None, &[]))
}

/// The same, where some displays were judged before: their findings are `known`, by their places, and so are the premises.
///
/// # Errors
/// When a claim does not fit the notes.
pub(super) fn judged_again(
    run: &Run<'_>,
    checker: &Checker<'_>,
    scope: &Scope,
    (known, premises): (&(dyn Fn(usize) -> Option<Equation> + Sync), &[Premise]),
) -> Result<Judged> {
    let explained = &with_options(checker, true);
    let mut course = Course {
        run,
        scope,
        checker: explained,
        quick: with_options(checker, false),
        known: premises.to_vec(),
        seen: HashMap::new(),
        at_first: VecDeque::new(),
        doubtful: Vec::new(),
        other_case: false,
        blamed: Vec::new(),
        unsupported: Vec::new(),
        confirmed: Vec::new(),
        contradicted: Vec::new(),
        in_sentences: OnceLock::new(),
        ordered: ordered::letters(checker.notes, &checker.model.macros),
        cases: Cases::of(checker.notes),
        before: known,
    };
    for at in 0..scope.carried {
        course.note_symbols(at);
        course.note_lost_derivative(at);
    }
    let mut found = Vec::new();
    for at in scope.carried..checker.notes.equations.len() {
        let equation = match known(at) {
            Some(equation) => course.judged_before(at, equation),
            None => course.judged_with_start(at)?,
        };
        // Another formula for a function begins another case, in which its name has this one.
        if at > scope.carried && equation.finding.verdict == Verdict::Assumed && course.begins_another_case(at) {
            break;
        }
        let section = scope.section_of(at);
        if equation.finding.verdict == Verdict::Assumed && course.is_given_again(at, section) && section > scope.carried
        {
            found.truncate(section - scope.carried);
            break;
        }
        course.note_symbols(at);
        found.push(equation);
    }
    contradictions::premises::weighed(&course, &mut found)?;
    contradictions::unsupported::against_premises(&course, &mut found)?;
    for examples::Contradicted { definition, repair, by } in &course.contradicted {
        let (place, by) = (definition - scope.carried, by - scope.carried);
        // What was judged in another section is gone.
        let Some(message) = found.get(by).map(|found| format!("the numbers in ({}) contradict this", found.id)) else {
            continue;
        };
        if matches!(found[place].finding.verdict, Verdict::Definition | Verdict::Assumed) {
            found[place] = contradictions::refuted(&found[place], repair, message);
        }
    }
    Ok(Judged { found, premises: course.known })
}

fn with_options<'a>(checker: &Checker<'a>, explain: bool) -> Checker<'a> {
    let options = Options { explain, deduction: true, ..checker.options };
    Checker { options, units: checker.units.clone(), ..*checker }
}

/// The way through the displays.
pub(super) struct Course<'c, 'a> {
    run: &'c Run<'c>,
    pub(super) scope: &'c Scope,
    pub(super) checker: &'c Checker<'a>,
    /// The same checker without explanations.
    pub(super) quick: Checker<'a>,
    /// What was taken for granted so far.
    known: Vec<Premise>,
    /// The symbols of the displays so far, with the first display of each.
    seen: HashMap<SymbolId, usize>,
    /// The findings on the next displays by themselves, with the places of these.
    at_first: VecDeque<(usize, Result<Equation>)>,
    /// The names that are defined beside a relation which contradicts an earlier one: the slip may be in the definition.
    doubtful: Vec<SymbolId>,
    /// Whether a display began another case: it gives a name another formula, and the words before it say so.
    other_case: bool,
    /// The displays that were called wrong given premises, with these.
    pub(super) blamed: Vec<(usize, Vec<Premise>)>,
    /// The displays that are said to follow and do not, with what they may rest on.
    pub(super) unsupported: Vec<(usize, Vec<Premise>)>,
    /// The places of the premises from which another display followed.
    pub(super) confirmed: Vec<usize>,
    /// The definitions that numbers of examples contradict.
    contradicted: Vec<examples::Contradicted>,
    /// The values that the formulas in sentences give to letters, once they were needed.
    in_sentences: OnceLock<Vec<examples::Given>>,
    /// The letters that may stand for vectors and matrices.
    ordered: Vec<Ordered>,
    /// The cases that the words name.
    cases: Cases,
    /// The findings that are known already.
    before: &'c (dyn Fn(usize) -> Option<Equation> + Sync),
}

impl Course<'_, '_> {
    fn note_symbols(&mut self, at: usize) {
        let members = self.checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
        for (id, _) in members.flat_map(Expr::symbols) {
            self.seen.entry(id).or_insert(at);
        }
    }

    /// Notes the names of a display that says nothing of them: K = ∫ u (dp/du) du where no formula for p is known.
    fn note_lost_derivative(&mut self, at: usize) {
        if self.lost_derivative(at) {
            self.doubtful.extend(self.checker.readings[at].introduced.iter().map(|new| new.symbol));
        }
    }

    /// Whether a display gives a formula to a name that a display before this section has.
    fn is_given_again(&self, at: usize, section: usize) -> bool {
        let is_old = |id: SymbolId| self.seen.get(&id).is_some_and(|first| *first < section);
        self.checker.readings[at].statements.iter().flatten().any(|statement| {
            statement.members.first().and_then(Expr::as_plain_symbol).is_some_and(is_old) && statement.members.len() > 1
        })
    }

    /// The finding on a display by itself. Several displays are judged at once.
    fn by_itself(&mut self, at: usize) -> Result<Equation> {
        if self.at_first.is_empty() {
            let all = at..self.checker.notes.equations.len();
            let next: Vec<usize> = all.filter(|at| (self.before)(*at).is_none()).take(AT_ONCE).collect();
            let none = Claim::default();
            let judged =
                |at: &usize| (*at, self.equation(&self.quick, *at, self.checker.assigned[*at].unwrap_or(&none)));
            let found: Vec<(usize, Result<Equation>)> = next.par_iter().with_max_len(1).map(judged).collect();
            self.at_first.extend(found);
        }
        match self.at_first.pop_front() {
            Some((place, found)) if place == at => found,
            _ => self.equation(&self.quick, at, &Claim::default()),
        }
    }

    /// The finding of before; what was a premise then is one now.
    fn judged_before(&mut self, at: usize, equation: Equation) -> Equation {
        let (notes, display) = (self.checker.notes, &self.checker.notes.equations[at]);
        let is_case = inline::is_inline(notes, display) && inline::is_conditional(notes, display);
        if equation.finding.verdict == Verdict::Assumed && !is_case {
            self.note_doubt(at);
        }
        equation
    }

    /// The formulas in the sentences before a display, and before the one before it, which are premises.
    fn formulas_before(&self, at: usize) -> Vec<usize> {
        let notes = self.checker.notes;
        let mut displays = 0;
        let is_near = |place: &usize| {
            displays += usize::from(!inline::is_inline(notes, &notes.equations[*place]));
            displays < 2
        };
        let near = (0..at).rev().take_while(is_near).collect::<Vec<_>>();
        // What holds under a condition does so for the next display.
        let is_said = |place: &usize| {
            let display = &notes.equations[*place];
            let is_next = || (*place..at).all(|place| inline::is_inline(notes, &notes.equations[place]));
            inline::is_inline(notes, display) && (!inline::is_conditional(notes, display) || is_next())
        };
        near.into_iter().filter(is_said).collect()
    }

    fn judge(&mut self, at: usize) -> Result<Equation> {
        self.note_lost_derivative(at);
        let none = Claim::default();
        let claim = self.checker.assigned[at].unwrap_or(&none);
        let found = self.by_itself(at)?;
        if let Some(unclear) = self.unclear(at, &found) {
            return Ok(unclear);
        }
        if let Some(settled) = self.settled_by_itself(at, &found)? {
            // A value in a special case, in a sentence, is what the next display is about.
            if settled.finding.verdict.passes()
                && inline::is_inline(self.checker.notes, &self.checker.notes.equations[at])
            {
                self.take_for_granted(at);
            }
            return Ok(settled);
        }
        // Rows that were read as one name say nothing that could be compared.
        if found.finding.verdict == Verdict::Refuted && self.has_unread_rows(at) {
            return Ok(gate::as_it_counts(found));
        }
        let may_follow = found.finding.verdict == Verdict::Refuted || found.finding.code == Code::NoMotion;
        let Some(symbols) = self.symbols(at).filter(|_| may_follow) else {
            return Ok(self.root(at)?.unwrap_or_else(|| gate::as_it_counts(found)));
        };
        // A formula in a sentence is a premise of the next display; it is not judged.
        let display = &self.checker.notes.equations[at];
        if inline::is_inline(self.checker.notes, display) {
            if !inline::is_conditional(self.checker.notes, display) {
                self.note_doubt(at);
            }
            self.take_for_granted(at);
            return Ok(gate::as_it_counts(found));
        }
        let origin = self.scope.origin_of(at, self.checker.notes.equations.len());
        let words = self.words_before(at, origin);
        let before = self.premises_before(at, origin, &words.named);
        let sets = premises::sets(&before, &symbols, self.has_rates(at), &words.named);
        let positive = signs::positive(&self.checker.readings[at], &symbols, self.checker.model);
        if let Some(positive) = &positive
            && let Some(follows) = self.follows_where(at, positive, claim)?
        {
            return Ok(gate::as_it_counts(follows));
        }
        let relations = self.relations_of_constants(at, claim);
        if let Some(follows) = self.solution_with(at, &relations, positive.as_ref())? {
            return Ok(follows);
        }
        let nearest = words.connected.then(|| premises::nearest(&before, &symbols)).flatten();
        let nearest = nearest.filter(|set| !sets.contains(set));
        let sought = Sought { words: &words, symbols: &symbols, sets, nearest, positive };
        if let Some(follows) = self.following(at, &sought, false)? {
            return Ok(gate::as_it_counts(follows));
        }
        let solved = solutions::solved((at, &symbols), &before, self.checker.readings, self.checker.model);
        if let Some(found) = self.solving(at, &solved)? {
            return Ok(gate::as_it_counts(found));
        }
        if sought.positive.is_some()
            && let Some(follows) = self.following(at, &sought, true)?
        {
            return Ok(gate::as_it_counts(follows));
        }
        if let Some(found) = self.in_stated_case(at, sought.positive.as_ref())? {
            return Ok(found);
        }
        if self.rests_on_doubt(at) && !self.is_by_itself(at)
            || self.hides_a_letter(at)
            || self.hidden_letter(at).is_some()
            || self.is_about_guessed_matrices(at)
        {
            self.take_for_granted(at);
            return Ok(gate::as_it_counts(found));
        }
        let with_relations = constants::added(claim, &relations);
        if let Some(wrong) = self.slip_from(at, &with_relations, &sought, &solved)? {
            return Ok(constants::given(wrong, &relations));
        }
        if let Some(unclear) = self.with_unclear_derivative(at, &found) {
            return Ok(unclear);
        }
        self.note_unsupported(at, &sought);
        self.note_doubt(at);
        self.take_for_granted(at);
        Ok(match self.introduced(at) {
            Some(name) => gate::introduces(found, &name),
            None => gate::as_it_counts(found),
        })
    }

    /// Notes the names that a display defines, if it relates what an earlier relation does and does not follow from it.
    fn note_doubt(&mut self, at: usize) {
        let Some(symbols) = self.symbols(at) else { return };
        let is_same = |premise: &Premise| {
            premise.symbols.len() == symbols.len() && symbols.iter().all(|id| premise.symbols.contains(id))
        };
        // Another formula for a name that has one: another case. It holds for what comes after it.
        if let Some(id) = self.named_again(at) {
            self.doubtful.push(id);
            let words = prose::before(self.checker.notes, at);
            self.other_case = self.other_case || words.other_case || words.announced.is_supposed();
        }
        if self.known.iter().any(is_same) {
            self.doubtful.extend(self.checker.readings[at].introduced.iter().map(|new| new.symbol));
        }
    }

    /// Whether a display contains a name whose definition may be wrong.
    pub(super) fn rests_on_doubt(&self, at: usize) -> bool {
        let members = self.checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
        let mut used = members.flat_map(|member| gate::names(member, self.checker.model));
        let uses_it = used.any(|id| self.doubtful.contains(&id));
        uses_it || self.other_case && self.named_again(at).is_some()
    }

    /// The name to which a display gives a formula, if another one defines it.
    fn named_again(&self, at: usize) -> Option<SymbolId> {
        let [Ok(statement)] = self.checker.readings[at].statements.as_slice() else { return None };
        let id = statement.members.first().and_then(Expr::as_plain_symbol)?;
        let is_own = self.checker.readings[at].introduced.iter().any(|new| new.symbol == id);
        let is_defined = matches!(self.checker.model.meaning(id), Some(Meaning::Defined(_)));
        (is_defined && !is_own && self.seen.contains_key(&id)).then_some(id)
    }

    /// The name that a display gives a formula, if no display before has it.
    fn introduced(&self, at: usize) -> Option<String> {
        let [Ok(statement)] = self.checker.readings[at].statements.as_slice() else { return None };
        let [first, _] = statement.members.as_slice() else { return None };
        let is_new = |id: &SymbolId| !self.seen.contains_key(id) && !gate::is_derivative(*id, self.checker.model);
        let id = first.as_plain_symbol().filter(is_new)?;
        Some(text::plain(&self.checker.model.name(id)))
    }

    fn equation(&self, checker: &Checker<'_>, at: usize, claim: &Claim) -> Result<Equation> {
        let found = checker.equation(at, Some(claim)).or_else(|error| checker.equation_left_open(at, error))?;
        Ok(checker.without_unreadable_laws(found, None))
    }

    /// Whether the sides of a display contain the same names, and none of a motion. Then it holds, or does not, in every case.
    fn is_by_itself(&self, at: usize) -> bool {
        let model = self.checker.model;
        let names = |member: &Expr| {
            let mut names: Vec<(SymbolId, u8)> = member.symbols();
            names.sort_unstable_by_key(|(id, _)| id.0);
            names
        };
        let is_free = |(id, dots): &(SymbolId, u8)| {
            *dots == 0
                && matches!(
                    model.meaning(*id),
                    Some(Meaning::Constant(_) | Meaning::Varying(_) | Meaning::Time | Meaning::Defined(_))
                )
        };
        self.checker.readings[at].statements.iter().flatten().all(|statement| {
            let all: Vec<_> = statement.members.iter().map(names).collect();
            all.windows(2).all(|pair| pair[0] == pair[1]) && all.iter().flatten().all(is_free)
        })
    }

    /// Whether a display relates the symbols that an earlier one does, in another order of its terms perhaps.
    fn restates(&self, at: usize) -> bool {
        let printed = |at: usize| {
            let [Ok(statement)] = self.checker.readings[at].statements.as_slice() else { return Vec::new() };
            let [first, second] = statement.members.as_slice() else { return Vec::new() };
            let mut found: Vec<usize> =
                first.symbols().into_iter().chain(second.symbols()).map(|(id, _)| id.0).collect();
            found.sort_unstable();
            found.dedup();
            found
        };
        let own = printed(at);
        own.len() >= FEWEST_RESTATED && {
            let origin = self.scope.origin_of(at, self.checker.notes.equations.len());
            (0..origin).any(|earlier| printed(earlier) == own)
        }
    }

    /// Whether a rate stands in a display.
    fn has_rates(&self, at: usize) -> bool {
        let members = self.checker.readings[at].statements.iter().flatten().flat_map(|statement| &statement.members);
        let is_rate = |member: &Expr| member.symbols().iter().any(|(_, dots)| *dots > 0);
        // What is constant has a rate of 0.
        let mut statements = self.checker.readings[at].statements.iter().flatten();
        statements.any(|statement| statement.constant.is_some()) || members.into_iter().any(is_rate)
    }

    /// The symbols that a display relates, if it was read.
    fn symbols(&self, at: usize) -> Option<Vec<SymbolId>> {
        let statements = self.checker.readings[at].statements.iter().map(|statement| statement.as_ref().ok());
        Some(self.symbols_of(&statements.collect::<Option<Vec<&Statement>>>()?))
    }

    /// The symbols that statements relate.
    fn symbols_of(&self, statements: &[&Statement]) -> Vec<SymbolId> {
        let members = statements.iter().flat_map(|statement| &statement.members);
        let mut found = Vec::new();
        for id in members.flat_map(|member| gate::leaves(member, self.checker.model)) {
            if !found.contains(&id) {
                found.push(id);
            }
        }
        found
    }

    /// The finding that a display follows from premises, if it does, perhaps only where some constants are positive.
    fn follows_from(&self, at: usize, set: &[&Premise], positive: Option<&Positive>) -> Result<Option<Equation>> {
        let claim = premises::claim(set);
        let mut found = self.passes(at, &claim)?;
        if found.is_none()
            && let Some(positive) = positive
        {
            found = self.follows_where(at, positive, &claim)?;
        }
        Ok(found.map(|mut found| {
            let (message, set) = (found.finding.message, named(set));
            // The hypotheses are these displays.
            let rest = message.strip_prefix("holds under its hypotheses").or(message.is_empty().then_some(""));
            let all = || format!("{message}; it follows from {set}");
            found.finding.message = rest.map_or_else(all, |rest| format!("follows from {set}{rest}"));
            found
        }))
    }

    /// The finding that a display holds where some constants are positive, if it does.
    fn follows_where(&self, at: usize, positive: &Positive, claim: &Claim) -> Result<Option<Equation>> {
        let found = self.passes(at, &positive.added_to(claim))?;
        Ok(found.map(|found| positive.found(found)))
    }

    /// The finding that a display passes with a claim, if it does.
    pub(super) fn passes(&self, at: usize, claim: &Claim) -> Result<Option<Equation>> {
        if !screen::may_follow(&self.quick, at, claim)? {
            return Ok(None);
        }
        Ok(gate::as_following(self.equation(&self.quick, at, claim)?))
    }
}
