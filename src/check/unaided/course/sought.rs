//! From what a display may follow, and with what a slip in it is sought.

use crate::Result;
use crate::check::unaided::course::{Course, taken};
use crate::check::unaided::gate;
use crate::check::unaided::premises::{self, Premise, Sought};
use crate::check::unaided::prose::{self, Announced, Words};
use crate::check::unaided::signs::Positive;
use crate::check::unaided::solutions::Solution;
use crate::check::verdict::Verdict;
use crate::check::verdict::report::Equation;
use crate::notes::claims::Claim;

/// The sets of premises that are tried for a certificate, from the first with which a display passes.
const MORE: usize = 3;

/// The most relations that a display with a slip is taken to solve.
pub(super) const SOLVED_WITH_A_SLIP: usize = 2;

/// Words that suppose something of all names, or of those that a formula does not name.
const OF_ALL_NAMES: [&str; 22] = [
    "equal",
    "same",
    "identical",
    "symmetr",
    "small",
    "large",
    "near",
    "approx",
    "neglect",
    "limit",
    "order",
    "slow",
    "fast",
    "weak",
    "strong",
    "\\ll",
    "\\gg",
    // other languages
    "gleich",
    "klein",
    "groß",
    "égal",
    "petit",
];

impl Course<'_, '_> {
    /// The finding on a display that needs nothing before it: on numbers, on an example, on a value in a special case, or on ≈.
    pub(super) fn settled_by_itself(&mut self, at: usize, found: &Equation) -> Result<Option<Equation>> {
        // Numbers are wrong by themselves, whatever the letters mean, unless they are only supposed.
        if let Some(found) = gate::wrong_numbers(found) {
            let is_supposed = prose::before(self.checker.notes, at).announced.is_supposed();
            return Ok(Some(if is_supposed { gate::as_it_counts(found) } else { found }));
        }
        if let Some(found) = self.example(at, found)? {
            return Ok(Some(found));
        }
        if let Some(found) = self.special_value(at, found)? {
            return Ok(Some(found));
        }
        if let Some(found) = self.restated(at, found)? {
            return Ok(Some(found));
        }
        if let Some(found) = self.extremum(at, found)? {
            return Ok(Some(found));
        }
        if found.finding.verdict == Verdict::Refuted && self.lost_derivative(at) {
            return Ok(Some(gate::left_open(found.clone())));
        }
        if self.rests_on_doubt(at) {
            return Ok(None);
        }
        self.nearly(at, found)
    }

    /// Whether an equality contains the same names on both sides, of which the words before its chain suppose nothing. Then it is one of
    /// formulas, and what they suppose of other names does not matter.
    fn is_identity_in_any_case(&self, at: usize, origin: usize) -> bool {
        let notes = self.checker.notes;
        let sentence = prose::sentence(notes, origin);
        let lower = sentence.to_lowercase();
        let Some(own) = self.symbols(at).filter(|_| self.is_by_itself(at)) else { return false };
        let is_about_it = |formula: &str| {
            let symbols = gate::symbols_of(formula, self.checker.model);
            !symbols.is_empty() && symbols.iter().all(|id| own.contains(id))
        };
        !OF_ALL_NAMES.iter().any(|word| lower.contains(word))
            && !sentence.split('$').skip(1).step_by(2).any(is_about_it)
    }

    /// The words before a display, or before the chain of which it is a step.
    pub(super) fn words_before(&self, at: usize, origin: usize) -> Words {
        let mut words = prose::before(self.checker.notes, origin);
        // What comes later in a chain is said to follow.
        if self.scope.link(at, self.checker.notes.equations.len()).is_some_and(|link| link.is_later) {
            words.connected = !words.announced.is_supposed() || self.is_identity_in_any_case(at, origin);
            if words.connected {
                words.announced = Announced::Consequence;
            }
        }
        words.named.extend(self.formulas_before(origin));
        words
    }

    /// The relations before a display from which it may follow. Beside a motion, only what is about constants has any.
    pub(super) fn premises_before(&self, at: usize, origin: usize, named: &[usize]) -> Vec<Premise> {
        let mut before: Vec<Premise> = self.known.iter().filter(|premise| premise.at < origin).cloned().collect();
        self.leave_out_replaced(origin, named, &mut before);
        self.leave_out_ended_cases(at, named, &mut before);
        self.leave_out_other_cases(at, named, &mut before);
        self.leave_out_other_values(at, &mut before);
        before.extend(self.in_states(at, &before));
        if self.checker.model.system.is_some() && !taken::is_static(self.checker, at) {
            before.clear();
        }
        before
    }

    /// Notes a display that is said to follow and does not, with the likeliest premises: one of these may be wrong.
    pub(super) fn note_unsupported(&mut self, at: usize, sought: &Sought<'_>) {
        if sought.words.connected && !sought.words.other_case {
            let sets = premises::for_slips(&sought.sets, sought.symbols, false).into_iter().chain(&sought.nearest);
            let sets = sets.map(|set| (at, set.iter().map(|premise| (*premise).clone()).collect()));
            self.unsupported.extend(sets);
        }
    }

    /// The finding that a display follows from premises, perhaps only where the constants of the premises are positive too.
    pub(super) fn following(&mut self, at: usize, sought: &Sought<'_>, all_positive: bool) -> Result<Option<Equation>> {
        let mut best: Option<(Equation, Vec<usize>)> = None;
        let mut more = MORE;
        for set in sought.sets.iter().chain(&sought.nearest) {
            let with_all = |positive: &Positive| positive.with(premises::symbols(set), self.checker.model);
            let all = sought.positive.as_ref().filter(|_| all_positive).map(with_all);
            let follows = self.follows_from(at, set, all.as_ref().or(sought.positive.as_ref()))?;
            let is_certified = follows.as_ref().is_some_and(|found| found.finding.verdict == Verdict::Certified);
            if let Some(follows) = follows.filter(|_| is_certified || best.is_none()) {
                best = Some((follows, set.iter().map(|premise| premise.at).collect()));
            }
            more -= usize::from(best.is_some());
            if is_certified || more == 0 {
                break;
            }
        }
        let Some((follows, from)) = best else { return Ok(None) };
        // What follows says in short what several premises do, so it is one too.
        self.confirmed.extend(&from);
        self.take_as_premise(at, &from);
        Ok(Some(follows))
    }

    /// The finding that a display solves a relation before it.
    pub(super) fn solving(&mut self, at: usize, solved: &[Solution<'_>]) -> Result<Option<Equation>> {
        for solution in solved {
            let found = self.equation(&self.quick, at, &solution.claim)?;
            if let Some(found) = gate::as_following(found) {
                // What is solved says more than the relation did: it is a premise too.
                let found = solution.found(found);
                self.take_for_granted(at);
                return Ok(Some(found));
            }
        }
        Ok(None)
    }

    /// The finding that a slip separates a display from what follows: from definitions alone, from premises, or from a relation
    /// that it solves.
    pub(super) fn slip_from(
        &mut self,
        at: usize,
        claim: &Claim,
        sought: &Sought<'_>,
        solved: &[Solution<'_>],
    ) -> Result<Option<Equation>> {
        if let Some(wrong) = self.slip(at, claim, &[], sought.words)? {
            return Ok(Some(wrong));
        }
        if let Some(positive) = &sought.positive
            && let Some(wrong) = self.slip(at, &positive.added_to(claim), &[], sought.words)?
        {
            return Ok(Some(wrong));
        }
        let mut statements = self.checker.readings[at].statements.iter().flatten();
        let is_constant = statements.any(|statement| statement.constant.is_some());
        for set in premises::for_slips(&sought.sets, sought.symbols, is_constant).into_iter().chain(&sought.nearest) {
            let claim = premises::claim(set);
            let positive =
                sought.positive.as_ref().map(|positive| positive.with(premises::symbols(set), self.checker.model));
            let where_positive = positive.map(|positive| positive.added_to(&claim));
            for claim in std::iter::once(claim).chain(where_positive) {
                if let Some(wrong) = self.slip(at, &claim, set, sought.words)? {
                    self.blamed.push((at, set.iter().map(|premise| (*premise).clone()).collect()));
                    return Ok(Some(wrong));
                }
            }
        }
        let is_about_it = |solution: &&Solution<'_>| solution.same_symbols || solution.more_symbols;
        for solution in solved.iter().filter(is_about_it).filter(|_| sought.words.connected).take(SOLVED_WITH_A_SLIP) {
            let Some(mut wrong) = self.slip(at, &solution.claim, &[solution.of], sought.words)? else { continue };
            // What an edit adds did not drop out: the display may be a special case.
            if solution.more_symbols {
                wrong.repairs.retain(|repair| !self.adds_a_name(at, repair));
            }
            if !wrong.repairs.is_empty() {
                return Ok(Some(wrong));
            }
        }
        Ok(None)
    }
}
