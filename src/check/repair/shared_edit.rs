//! Shared repairs: one edit of a law or definition that repairs several equations.
//!
//! A slip in a law or a definition makes all equations fail that use it, and each of these could be changed to agree with the
//! slip. One slip in the shared display is likelier than one in each equation. So where at least two equations are refuted,
//! or an equation and a sentence, each display that they use is tried with every single edit. An edit that repairs several
//! of them, and with which everything else still passes, is offered for each.
//!
//! # Why one slip is preferred to several
//!
//! A law is taken for granted, and so is a definition that nothing tests. What depends on a wrong one fails, and
//! each of these equations could be made to agree with the slip. One slip that explains several failures is more
//! likely than one in each; a sentence that fails is a failure like any other. So edits of what the failures have
//! in common are ranked by how many items they correct, and come before edits of each item. A display that cannot
//! be read takes with it everything that depends on it, and is corrected in the same way. An edit with which
//! something fails that held is no correction.

use rayon::prelude::*;
use std::cmp::{Ordering, Reverse};

use crate::formula::{Expr, Node, Statement};
use crate::latex::slips::{Edit, Pool, Slip};
use crate::latex::{DefinedSymbol, Reading, name_search, read_display, slips};
use crate::notes::Notes;
use crate::notes::claims::{Claim, Solved};
use crate::source::Fault;

use crate::check::certificate::formulas;
use crate::check::document::checker::Checker;
use crate::check::document::names::{is_wrong, shown};
use crate::check::document::printed_lagrangian;
use crate::check::document::reading::for_each;
use crate::check::document::setup::{Run, with_checker};
use crate::check::equations::sentences;
use crate::check::repair::items::{Item, Passing, SharedEdit};
use crate::check::repair::ranking::{changes_a_half, rank};
use crate::check::repair::suggest::{agree_memberwise, has_branches, is_in_source};
use crate::check::sample::context::Options;
use crate::check::trial::edited_document::with_text;
use crate::check::trial::failed_display::{MISSING, OFFERED};
use crate::check::trial::text_trial::Trial;
use crate::check::verdict::Verdict;
use crate::check::verdict::repair::{Repair, Shared};
use crate::check::verdict::report::Equation;

/// The largest number of edits of one display with which the whole document is checked.
const DOCUMENTS: usize = 4;

/// The largest number of edits that are tried, the likeliest first, since each makes another document.
const TRIED: usize = 240;

/// The same number where each trial takes longer.
const TRIED_SLOWLY: usize = 60;

/// The largest number of displays that cannot be read and are still tried with edits.
const MOST_UNREADABLE: usize = 12;

/// The same number where each trial derives the equations of motion anew.
const TRIED_OF_A_LAGRANGIAN: usize = 120;

/// The number of states that reject most edits.
const STATES: usize = 2;

/// Makes an edit the first suggestion for an equation.
fn offer(equation: &mut Equation, repair: &Repair) {
    equation.parts.iter_mut().for_each(|part| part.finding.fit = None);
    equation.finding.fit = None;
    let known = &mut equation.repairs;
    known.retain(|other| (other.span, &other.replacement) != (repair.span, &repair.replacement));
    known.insert(0, repair.clone());
    known.truncate(OFFERED);
}

impl Checker<'_> {
    /// The equations of a document; those that one edit repairs together get it as their first repair.
    pub(crate) fn with_shared_repairs(
        &self,
        run: &Run<'_>,
        mut equations: Vec<Equation>,
        sentences: &[Equation],
    ) -> Vec<Equation> {
        let wrong: Vec<(usize, usize)> = equations
            .iter()
            .enumerate()
            .filter(|(_, equation)| equation.finding.follows_from.is_none() && !equation.ok && is_wrong(equation))
            .filter_map(|(nth, equation)| Some((nth, self.display_of(equation)?)))
            .filter(|(_, at)| self.may_be_edited(*at) && self.is_tried(*at))
            .collect();
        let failing: Vec<Item> =
            (0..sentences.len()).filter(|at| is_refuted(&sentences[*at])).map(Item::Sentence).collect();
        if wrong.is_empty() || wrong.len() + failing.len() < 2 || !self.options.explain {
            return equations;
        }
        let passing = self.items_as_expected(&equations, sentences);
        let refuted: Vec<usize> =
            wrong.iter().filter(|(nth, _)| is_refuted(&equations[*nth])).map(|(_, other)| *other).collect();
        let is_in_doubt = refuted.len() > 2 * self.confirmations_of_the_motion(&equations);
        let mut best: Vec<SharedEdit> = Vec::new();
        let most = |found: &[SharedEdit]| found.first().map_or(0, |found| found.repaired.len());
        for at in (0..self.notes.equations.len()).filter(|at| self.may_be_edited(*at) && self.is_tried(*at)) {
            let mut dependents = self.dependents(at, &wrong, &refuted);
            // The display itself takes the longest to check, so it comes last.
            let own_last = |dependents: &mut Vec<usize>| {
                dependents.sort_by_key(|other| *other == at && !self.is_unreadable(at));
            };
            own_last(&mut dependents);
            let said = failing.iter().filter(|_| !self.readings[at].introduced.is_empty() || self.is_law(at)).copied();
            let with_said = |dependents: Vec<usize>| -> Vec<Item> {
                dependents.into_iter().map(Item::Display).chain(said).collect()
            };
            let mut found = Vec::new();
            // Every motion follows from the Lagrangian, so all that fails may rest on a part of it. One edit of it is
            // likelier than many others where all of that holds with it.
            let moves =
                self.readings[at].introduced.iter().any(|new| printed_lagrangian::is_part(self.model, new.symbol));
            if moves && refuted.len() > 1 && is_in_doubt {
                let mut all = refuted.clone();
                own_last(&mut all);
                let all = with_said.clone()(all);
                let least = nearly_all(all.len());
                found = self.repairing_edits(run, at, (&all, least), &passing);
            }
            let dependents = with_said(dependents);
            if found.is_empty() && dependents.len() > 1 && matches!(dependents[0], Item::Display(_)) {
                found = self.repairing_edits(run, at, (&dependents, 2), &passing);
            }
            match most(&found).cmp(&most(&best)) {
                Ordering::Greater => best = found,
                Ordering::Equal => best.extend(found),
                Ordering::Less => {}
            }
        }
        self.sort_by_likelihood(&mut best);
        best.truncate(OFFERED);
        let blamed = self.blamed(run, &best, &equations);
        for SharedEdit { at, edit, repaired } in best.into_iter().rev() {
            let repairs = self.shared_repairs(at, &edit, &repaired);
            if let (Some(nth), Some(repair)) = (blamed, repairs.first()) {
                let is_own = repaired.iter().any(|(item, _)| *item == Item::Display(at));
                let definition = Repair { verdict: Verdict::Definition, ..repair.clone() };
                (!is_own).then(|| offer(&mut equations[nth], &definition));
            }
            let corrected: Vec<usize> = repaired.iter().filter_map(|(item, _)| item.display()).collect();
            for ((item, _), repair) in repaired.into_iter().zip(repairs) {
                for (nth, _) in wrong.iter().filter(|(_, other)| item == Item::Display(*other)) {
                    offer(&mut equations[*nth], &repair);
                }
            }
            if let Some(nth) = blamed {
                self.blame(&mut equations, nth, &corrected);
            }
        }
        equations
    }

    /// The wrong displays that an edit of a display may correct: itself, and those that use it.
    fn dependents(&self, at: usize, wrong: &[(usize, usize)], refuted: &[usize]) -> Vec<usize> {
        let others = wrong.iter().map(|(_, other)| *other).filter(|other| *other != at);
        // Which equations use a display that cannot be read is unknown, so all are tried.
        match self.is_unreadable(at) && wrong.iter().any(|(_, other)| *other == at) {
            true => std::iter::once(at).chain(others).collect(),
            false => {
                let stands = |other: &usize| self.depends_on_display(*other, at) || self.solves(*other, at);
                refuted.iter().copied().filter(|other| *other == at || stands(other)).collect()
            }
        }
    }

    /// Puts the likeliest edits first; a superfluous minus is rarer than a wrong sign.
    fn sort_by_likelihood(&self, edits: &mut [SharedEdit]) {
        edits.sort_by_key(|SharedEdit { at, edit, .. }| {
            let text = &self.notes.equations[*at].text;
            let kind = match edit.slip == Slip::Sign && edit.replacement.is_empty() {
                true => Slip::Fraction,
                false => rank(text, edit, false).0,
            };
            (changes_a_half(text, edit), kind)
        });
    }

    /// An edit of a display as a repair of each equation that passes with it.
    pub(crate) fn shared_repairs(&self, at: usize, edit: &Edit, repaired: &[(Item, Verdict)]) -> Vec<Repair> {
        let display = &self.notes.equations[at];
        let name = |item: &Item| match item {
            Item::Display(at) => shown(&self.notes.equations[*at]),
            Item::Sentence(at) => sentences::name(*at, &self.claims.sentences[*at]),
        };
        let mends: Vec<String> = repaired.iter().map(|(item, _)| name(item)).collect();
        let repair = |(_, verdict): &(Item, Verdict)| Repair {
            shared: Some(Shared { of: shown(display), mends: mends.clone() }),
            ..Repair::of(edit.clone(), display.body.start, *verdict)
        };
        repaired.iter().map(repair).collect()
    }

    /// The displays and sentences that are as expected.
    pub(crate) fn items_as_expected(&self, equations: &[Equation], sentences: &[Equation]) -> Passing {
        Passing {
            displays: equations.iter().filter(|equation| equation.ok).filter_map(|e| self.display_of(e)).collect(),
            sentences: (0..sentences.len()).filter(|at| sentences[*at].ok).collect(),
        }
    }

    /// The display of an equation of the report.
    pub(crate) fn display_of(&self, equation: &Equation) -> Option<usize> {
        self.notes.equations.iter().position(|display| shown(display) == equation.id)
    }

    /// Whether a display may be edited: it is not expected to fail, and has no erratum.
    pub(crate) fn may_be_edited(&self, at: usize) -> bool {
        self.assigned[at].is_none_or(|claim| claim.expect.is_none() && claim.errata.is_empty())
    }

    /// Whether an equation depends on a law or a definition in another display.
    pub(crate) fn depends_on_display(&self, equation: usize, at: usize) -> bool {
        let is_law = self.is_law(at);
        let members = || self.readings[equation].statements.iter().flatten().flat_map(|statement| &statement.members);
        let uses = |new: &DefinedSymbol| members().any(|member| self.model.depends_on(member, &[new.symbol]));
        let named = |new: &DefinedSymbol| {
            self.model.laws.iter().flat_map(|law| &law.hypotheses).any(|hypothesis| {
                [&hypothesis.lhs, &hypothesis.rhs].iter().any(|side| self.model.depends_on(side, &[new.symbol]))
            })
        };
        let said = || self.assigned[equation].is_some_and(|claim| self.speaks_of(claim, at));
        equation != at && (is_law || self.readings[at].introduced.iter().any(|new| uses(new) || named(new)) || said())
    }

    /// Whether a display is claimed to solve another.
    fn solves(&self, display: usize, other: usize) -> bool {
        let solves = self.assigned[display].and_then(|claim| claim.solves.as_ref());
        matches!(solves.map(|solves| &solves.of), Some(Solved::Equation(address)) if self.place(&address.text) == Some(other))
    }

    /// Whether a claim has a hypothesis about a name that a display introduces, or gives it another meaning.
    fn speaks_of(&self, claim: &Claim, at: usize) -> bool {
        let says_nothing = claim.assume.is_empty() && claim.throughout.is_empty() && claim.meanings.is_empty();
        let introduced: Vec<_> = self.readings[at].introduced.iter().map(|new| new.symbol).collect();
        if says_nothing || introduced.is_empty() {
            return false;
        }
        let hypotheses = self.hypotheses(claim).unwrap_or_default();
        let rules = self.local(claim).unwrap_or_default();
        let sides = hypotheses.iter().flat_map(|hypothesis| [&hypothesis.lhs, &hypothesis.rhs]);
        let mut formulas = sides.chain(rules.iter().flat_map(|rule| rule.action.formulas()));
        formulas.any(|formula| self.model.depends_on(formula, &introduced))
    }

    /// Whether a display gives names formulas that contain those of another display, as U(a) does if that display defines U(x).
    fn is_read_again(&self, item: Item, at: usize) -> bool {
        let Item::Display(display) = item else { return false };
        let (text, macros) = (&self.notes.equations[display].text, &self.model.macros);
        let mentions = |new: &DefinedSymbol| name_search::mentions(text, &self.model.name(new.symbol), macros);
        let is_other = display != at && !self.readings[display].introduced.is_empty();
        is_other && self.readings[at].introduced.iter().any(mentions)
    }

    /// The edits of a display with which most of these equations pass, and at least so many, and with which everything that
    /// passed still passes.
    pub(crate) fn repairing_edits(
        &self,
        run: &Run<'_>,
        at: usize,
        (wrong, least): (&[Item], usize),
        passing: &Passing,
    ) -> Vec<SharedEdit> {
        let display = &self.notes.equations[at];
        let (symbols, macros) = (&self.model.symbols, &self.model.macros);
        let quick = Options { points: STATES.min(self.options.points), explain: false, ..self.options };
        let own = || Pool::of(std::iter::once(display.text.as_str()), symbols, macros, MISSING).factors_only();
        // A claim that needs many states, and a display that would have to be read again, wait for the full check, if the others
        // suffice to reject edits.
        let is_soon = |item: &&Item| !self.takes_many_states(**item) && !self.is_read_again(**item, at);
        let soon: Vec<Item> = wrong.iter().filter(is_soon).copied().collect();
        let (soon, enough) = match soon.len() < least.min(2) {
            true => (wrong, least),
            false => (soon.as_slice(), least.saturating_sub(wrong.len() - soon.len()).max(least.min(2))),
        };
        let texts = || self.notes.equations.iter().map(|display| display.text.as_str());
        let terms = || Pool::of(texts(), symbols, macros, MISSING);
        let all = || terms().factors_only();
        let mut tried: Vec<Edit> = Vec::new();
        let mut all_found: Vec<SharedEdit> = Vec::new();
        let pools: [(&dyn Fn() -> Pool, bool); 4] =
            [(&Pool::empty, false), (&own, false), (&all, false), (&terms, true)];
        // With each edit the states that obey hypotheses are sought again.
        let moves = self.readings[at].introduced.iter().any(|new| printed_lagrangian::is_part(self.model, new.symbol));
        let most = match wrong.iter().all(|item| self.has_hypotheses(*item)) {
            true => TRIED_SLOWLY,
            false if moves => TRIED_OF_A_LAGRANGIAN,
            false => TRIED,
        };
        // Where all must pass, the edits are those of a Lagrangian, and each takes longer.
        let few = if least > 2 { pools.len() - 1 } else { pools.len() };
        for (pool, of_terms) in pools.into_iter().take(few) {
            let mut edits = slips::corrections(&display.text, symbols, macros, &pool());
            edits.retain(|edit| !tried.contains(edit) && (!of_terms || edit.slip == Slip::Term));
            edits.retain(|edit| is_in_source(self, &display.text, edit, display.body.start));
            // In a law that a rate is 0, another name or dot makes a stronger law, with which more equations hold.
            let names = |edit: &Edit| matches!(edit.slip, Slip::Dot | Slip::Symbol | Slip::Name);
            edits.retain(|edit| !names(edit) || !self.states_a_zero_rate(at));
            // With a side that is 0 a law or a definition says something else, and much follows from it that nobody meant.
            edits.retain(|edit| edit.replacement.trim() != "0");
            edits.retain(|edit| !has_branches(&edit.replacement) || has_branches(&display.text));
            edits.retain(|edit| !self.is_unreadable(at) || self.is_readable(at, &edit.applied(&display.text)));
            edits.sort_by_key(|edit| rank(&display.text, edit, false));
            edits.truncate(most);
            tried.extend(edits.iter().cloned());
            let repaired = |edit: &Edit| match self.is_unreadable(at) {
                true => self.edited(&Run { options: quick, ..*run }, at, edit, |checker| {
                    checker.items_that_pass(soon, enough, true)
                }),
                false => self.with_edited_text(quick, at, &edit.applied(&display.text), |checker| {
                    checker.items_that_pass(soon, enough, true)
                }),
            };
            let likely = edits.into_par_iter().filter_map(|edit| {
                let repaired = repaired(&edit)?;
                Some(SharedEdit { at, edit, repaired }).filter(|found| found.repaired.len() >= enough)
            });
            let found = self.confirmed(run, at, likely.collect(), (wrong, least, passing));
            all_found.extend(found);
            // What changes a customary ½ is offered, but a lost factor is likelier.
            if all_found.iter().any(|found| !changes_a_half(&display.text, &found.edit)) {
                break;
            }
        }
        all_found
    }

    /// The edits of a display that repair most equations by the full check.
    fn confirmed(
        &self,
        run: &Run<'_>,
        at: usize,
        mut likely: Vec<SharedEdit>,
        (wrong, least, passing): (&[Item], usize, &Passing),
    ) -> Vec<SharedEdit> {
        let text = &self.notes.equations[at].text;
        likely.sort_by_key(|found| (Reverse(found.repaired.len()), rank(text, &found.edit, false)));
        // Of two edits that give equal equations one is enough; in an unreadable display this cannot be decided.
        let none = Claim::default();
        let claim = self.assigned[at].unwrap_or(&none);
        let equal = |a: &Expr, b: &Expr| formulas::is_identity(a, b, self.model);
        let mut distinct: Vec<(SharedEdit, Reading)> = Vec::new();
        for found in likely {
            let reading = self.as_printed(&found.edit.applied(text), claim, &self.model.macros);
            let is_known = || distinct.iter().any(|(_, known)| agree_memberwise(known, &reading, equal));
            if distinct.len() < DOCUMENTS && (self.is_unreadable(at) || !is_known()) {
                distinct.push((found, reading));
            }
        }
        let full = Options { explain: false, ..self.options };
        let mut found: Vec<SharedEdit> = Vec::new();
        for (SharedEdit { edit, .. }, _) in distinct {
            let judge = |checker: &Checker<'_>| {
                checker.still_passes(passing).then(|| checker.items_that_pass(wrong, least, false))
            };
            match self.edited(&Run { options: full, ..*run }, at, &edit, judge).flatten() {
                Some(mut repaired) if repaired.len() >= least => {
                    repaired.sort_by_key(|(item, _)| *item);
                    found.push(SharedEdit { at, edit, repaired });
                }
                _ => {}
            }
        }
        let most = found.iter().map(|found| found.repaired.len()).max().unwrap_or(0);
        found.retain(|found| found.repaired.len() == most);
        found
    }

    /// Whether a display cannot be read, and no other display is the cause.
    pub(crate) fn is_unreadable(&self, at: usize) -> bool {
        let own = |statement: &Result<Statement, Fault>| {
            statement.as_ref().is_err_and(|fault| self.cause(fault.missing.as_ref()).is_none())
        };
        self.readings[at].statements.iter().any(own)
    }

    /// Whether edits of a display are tried: of one that cannot be read only where there are few of these.
    pub(crate) fn is_tried(&self, at: usize) -> bool {
        !self.is_unreadable(at) || !self.has_many_unreadable()
    }

    /// Whether so many displays cannot be read that no edits of them are tried: each edit means that the document is read
    /// again, and where hardly anything can be read, none of them helps.
    pub(crate) fn has_many_unreadable(&self) -> bool {
        let unread = self.readings.iter().filter(|reading| reading.statements.iter().any(Result::is_err));
        unread.take(MOST_UNREADABLE + 1).count() > MOST_UNREADABLE
    }

    /// Whether a text in place of a display can be read, with any names.
    fn is_readable(&self, at: usize, text: &str) -> bool {
        let mut symbols = self.model.symbols.clone();
        symbols.for_each = for_each(self.assigned[at], self.model);
        read_display(text, &mut symbols, &self.model.macros).statements.iter().all(Result::is_ok)
    }

    /// Whether a display is a law that a rate is 0.
    fn states_a_zero_rate(&self, at: usize) -> bool {
        let moves = |member: &Expr| matches!(member.node, Node::Symbol { dots: 1.., .. } | Node::TimeDerivative(..));
        let is_law = self.is_law(at);
        let says_so = |s: &Statement| s.members.iter().any(Expr::is_null) && s.members.iter().any(moves);
        is_law && self.readings[at].statements.iter().flatten().any(says_so)
    }

    /// The result of `judge` on the document with an edit of a display; `None`, if the edited document cannot be set up or
    /// introduces other names there.
    fn edited<T>(&self, run: &Run<'_>, at: usize, edit: &Edit, judge: impl FnOnce(&Checker<'_>) -> T) -> Option<T> {
        let mut file = self.notes.source.text.clone();
        file.replace_range(edit.span.shifted(self.notes.equations[at].body.start).range(), &edit.replacement);
        let notes: Notes = with_text(self.notes, file).ok()?;
        let is_alike = notes.equations.len() == self.notes.equations.len();
        let introduced = |checker: &Checker<'_>| -> Vec<String> {
            checker.readings[at].introduced.iter().map(|new| checker.model.name(new.symbol)).collect()
        };
        // An edit that introduces other names changes the meaning of the display.
        let is_same = |checker: &Checker<'_>| introduced(checker) == introduced(self) || self.is_unreadable(at);
        let judged = |checker: Checker<'_>| Ok(is_same(&checker).then(|| judge(&checker)));
        is_alike.then(|| with_checker(run, self.claims, &notes, judged).ok())??
    }

    /// The items that pass, with their verdicts; stops where fewer than `least` can pass, or most do not. With `quickly`, a display that defines a name
    /// passes if it holds at a few states.
    fn items_that_pass(&self, wrong: &[Item], least: usize, quickly: bool) -> Vec<(Item, Verdict)> {
        let none = Claim::default();
        let display = |at: usize| -> Option<Verdict> {
            let (reading, claim) = (&self.readings[at], self.assigned[at].unwrap_or(&none));
            if quickly && !reading.introduced.is_empty() && claim.is_plain() {
                let is_readable = reading.statements.iter().all(Result::is_ok);
                let stands = is_readable && Trial::new(self, at, reading, claim).ok()?.passes_screen();
                return stands.then_some(Verdict::Definition);
            }
            // Most edits fail at the first state.
            let is_refuted = || Trial::new(self, at, reading, claim).is_ok_and(|trial| !trial.passes_screen());
            if quickly && reading.statements.iter().all(Result::is_ok) && is_refuted() {
                return None;
            }
            let found = self.equation(at, self.assigned[at]).ok()?;
            found.ok.then_some(found.finding.verdict)
        };
        let judged = |item: Item| match item {
            Item::Display(at) => display(at),
            Item::Sentence(at) => {
                let found = sentences::check(self, at, &self.claims.sentences[at]).ok()?;
                found.ok.then_some(found.finding.verdict)
            }
        };
        let mut repaired = Vec::new();
        for (looked_at, item) in wrong.iter().enumerate() {
            match judged(*item) {
                Some(verdict) => repaired.push((*item, verdict)),
                _ if looked_at > repaired.len() || repaired.len() + wrong.len() <= looked_at + least => {
                    return repaired;
                }
                _ => {}
            }
        }
        repaired
    }

    /// Whether all items that passed still pass.
    fn still_passes(&self, passing: &Passing) -> bool {
        let sentence =
            |at: &usize| sentences::check(self, *at, &self.claims.sentences[*at]).is_ok_and(|found| found.ok);
        passing.displays.iter().all(|at| self.equation(*at, self.assigned[*at]).is_ok_and(|found| found.ok))
            && passing.sentences.iter().all(sentence)
    }
}

/// The number of items that an edit of the Lagrangian must repair: all of a few, and of more than three all but a quarter, since one of them
/// may be wrong for another reason.
fn nearly_all(of: usize) -> usize {
    of - of / 4
}

/// Whether an equation is false, against expectation.
pub(crate) fn is_refuted(equation: &Equation) -> bool {
    !equation.ok && matches!(equation.finding.verdict, Verdict::Refuted | Verdict::Domain)
}
