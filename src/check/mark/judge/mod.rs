//! The mark of each line: whether it holds in the problem, and if not, whether it follows from a false line before it.
//!
//! Offers `judge`, the marks of all lines, and `judge_quickly`, which gives up where another way to take the letters is better. Knows
//! `carried`, `written` and `world` of `mark`, and `document` and below.

use crate::Result;
use crate::code::Code;
use crate::formula::{Expr, SymbolId};
use crate::latex::Reading;
use crate::notes::claims::Claim;
use crate::phrases::listed;
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::document::setup::Run;
use crate::check::sample::context::Options;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::Finding;

use super::carried::energies;
use super::given::Implied;
use super::judged::{Judged, Rival};
use super::marked::{Because, Line, Mark};
use super::motion::{Along, Motion};
use super::near_rest;
use super::results;
use super::rounded::Known;
use super::slip;
use super::special;
use super::status::{Status, approximate, composed, stated, status};
use super::world::World;

mod another_meaning;
mod cases;
mod digits;
mod extrema;
mod false_line;
mod hidden;
mod instants;
mod later_values;
mod readings;
mod rest;
mod secular;
mod several;
mod supposed;
mod trial;
mod units;

pub(super) use readings::with_dots;
use readings::{Break, free_of};

/// Judges the lines of a hand-in, with the slips in wrong lines.
///
/// # Errors
/// When the problem cannot be applied to the hand-in.
pub(super) fn judge(run: &Run<'_>, world: &World<'_>) -> Result<Judged> {
    judged(run, world, (true, None))
}

/// Judges the lines of a hand-in by numbers alone, until it cannot have a better score than `rival`.
///
/// # Errors
/// As [`judge`].
pub(super) fn judge_quickly(run: &Run<'_>, world: &World<'_>, rival: &Rival) -> Result<Judged> {
    judged(run, world, (false, Some(rival)))
}

fn judged(run: &Run<'_>, world: &World<'_>, (details, rival): (bool, Option<&Rival>)) -> Result<Judged> {
    world.checked(run, |checker| {
        let first = world.first;
        let readings: Vec<Reading> = checker.readings.iter().cloned().map(with_dots).collect();
        let checker = Checker { readings: &readings, units: checker.units.clone(), ..checker };
        let mut instants = instants::known(&checker, world, &Motion::of(&checker, world));
        let mut model = checker.model.clone();
        instants::defined_elsewhere(&mut model, &readings[first..], &mut instants);
        let checker = Checker { model: &model, units: checker.units.clone(), ..checker };
        let quiet =
            Checker { options: Options { explain: false, ..checker.options }, units: checker.units.clone(), ..checker };
        let motion = Motion::of(&checker, world);
        let mut judge = Judge {
            world,
            instants,
            run,
            checker: &checker,
            open: free_of(&checker, &motion),
            implied: Vec::new(),
            wanted: results::names(&checker, world.problem),
            quiet: &quiet,
            details,
            motion,
            trusted: checker.readings.to_vec(),
            premises: checker.readings.to_vec(),
            cases: supposed::cases(&quiet, world, details),
            conditions: Vec::new(),
            unsaid: Vec::new(),
            breaks: Vec::new(),
            known: Known::default(),
            data: digits::data(&quiet, world),
            printed: digits::printed(&quiet, world),
            trials: Vec::new(),
            constants: Vec::new(),
            false_constants: Vec::new(),
            slips: slip::Slips::of(world.written.len()),
            lines: Vec::new(),
        };
        for at in 0..world.written.len() {
            judge.line(at)?;
            if rival.is_some_and(|rival| !rival.may_be_beaten(&judge.lines)) {
                return Ok(Judged { lines: judge.lines, found: Vec::new() });
            }
        }
        let (mut lines, premises, slips) = (judge.lines, judge.premises, judge.slips);
        let mut corrected = vec![None; lines.len()];
        if details {
            for at in 0..lines.len() {
                if lines[at].mark == Mark::Wrong {
                    let (edit, fitted, derived) = slips.found(run, &checker, world, at)?;
                    lines[at].slip = edit.as_ref().map(|edit| edit.slip.clone()).or(fitted);
                    lines[at].derived = derived;
                    corrected[at] = edit.map(|edit| edit.text);
                }
            }
        }
        let found = results::found(&quiet, world, &mut lines, (&premises, details.then_some(&corrected)))?;
        if details {
            hidden::leave_open(&quiet, world, &mut lines, &found);
        }
        Ok(Judged { lines, found })
    })
}

/// A condition that was stated, as LaTeX, with the name of its line.
type Condition = (String, String);

struct Judge<'j, 'c> {
    world: &'j World<'j>,
    run: &'j Run<'j>,
    checker: &'j Checker<'c>,
    /// What relations said of the student's own quantities.
    implied: Vec<Implied>,
    /// What moves in the problem, and nothing there determines.
    open: Vec<SymbolId>,
    wanted: Vec<SymbolId>,
    quiet: &'j Checker<'c>,
    /// Whether a false line is compared with those before it; without that, numbers alone decide what holds.
    details: bool,
    motion: Motion,
    /// The names of values at instants, and the values that are known.
    instants: Vec<(SymbolId, Option<Expr>)>,
    /// The readings without those of lines that are false: what another line is judged by.
    trusted: Vec<Reading>,
    /// The readings, in which a row of a chain says what it says of the first member.
    premises: Vec<Reading>,
    /// For each set of hypotheses of the problem, those that make a case.
    cases: Vec<Vec<Reading>>,
    conditions: Vec<Condition>,
    /// The lines of those that no word makes conditions, and that say that constants are the same.
    unsaid: Vec<String>,
    /// The conditions that the problem does not meet.
    breaks: Vec<Break>,
    /// What the lines say that symbols are.
    known: Known,
    /// The numbers that the problem and the whole hand-in give.
    data: Known,
    /// What the problem prints, and what its claims file says that a name stands for.
    printed: Known,
    /// The trial solutions.
    trials: Vec<trial::Trial>,
    /// The lines that hold whatever some names are to which later lines give values, with these names.
    constants: Vec<(usize, Vec<SymbolId>)>,
    /// Those of them that are false with the value that a later line gives, with that line.
    false_constants: Vec<(usize, usize)>,
    slips: slip::Slips,
    lines: Vec<Line>,
}

impl Judge<'_, '_> {
    fn line(&mut self, at: usize) -> Result<()> {
        let written = &self.world.written[at];
        let display = self.world.first + at;
        let mut line = Line {
            line: written.line,
            name: written.name.clone(),
            id: written.id.clone(),
            span: written.span,
            statement: written.text.split_whitespace().collect::<Vec<_>>().join(" "),
            inline: written.inline,
            mark: Mark::Right,
            verdict: None,
            follows_from: None,
            because: Because::Follows,
            slip: None,
            derived: None,
            result: None,
            credit: None,
        };
        let reading = self.with_known(self.quiet.readings[display].clone());
        self.premises[display] = reading.clone();
        let before = written.continues.map(|_| at - 1);
        let broken = before.filter(|before| matches!(self.lines[*before].mark, Mark::Wrong | Mark::Carried));
        if let (Some(start), Some(_)) = (written.continues, before)
            && let Some(whole) = composed(&self.premises[self.world.first + start], &reading)
        {
            self.premises[display] = whole;
        }
        let (mut status, mut under) = self.status(display, &reading);
        let mut apart = None;
        if let (Status::False(_), Some(_)) = (&status, broken) {
            // The row before is wrong, and this one may have returned to what is true of the first member.
            let whole = self.premises[display].clone();
            let again = self.status(display, &whole);
            if let Status::Holds(_) = again.0 {
                (status, under) = again;
                apart = Some("is true, but does not follow from the row before, which is wrong".into());
            }
        } else if let (Status::Holds(_), Some(from)) = (&status, broken) {
            (line.mark, line.follows_from) = (Mark::Carried, Some(from));
            line.because = carried(&self.lines, from, &[]);
            line.verdict = Some(Verdict::Refuted);
            self.push(line);
            return Ok(());
        }
        if matches!(status, Status::Open(..) | Status::False(_)) && self.is_near(display, &reading) {
            (status, under) = (Status::Holds(Verdict::Verified), Some("agrees to the printed digits".into()));
        }
        // ≈ is = beside a number.
        if matches!(status, Status::Open(..)) && self.is_rounded(display, &reading) {
            (status, under) = (Status::Holds(Verdict::Verified), Some("agrees to the printed digits".into()));
        }
        if matches!(status, Status::False(_))
            && let Some(other) = self.in_the_other_order(display)
        {
            self.premises[display] = other;
            (status, under) = (Status::Holds(Verdict::Verified), Some(Because::OtherOrder));
        }
        if matches!(status, Status::Open(..) | Status::False(_)) && self.is_right_with_units(display) {
            (status, under) = (
                Status::Holds(Verdict::Verified),
                Some("agrees to the printed digits, if its letters are read as units".into()),
            );
        }
        if self.details && energies::is_sum_of_energies(self.quiet, &reading) {
            (line.mark, line.verdict) = (Mark::Wrong, Some(Verdict::Refuted));
            line.because = "is not the Lagrangian, which is the kinetic minus the potential energy".into();
            self.push(line);
            return Ok(());
        }
        // A value with the unit of another quantity is wrong, though its number is right.
        if matches!(status, Status::Holds(_))
            && let Some(why) = self.wrong_unit(at, &reading)
        {
            (line.mark, line.verdict, line.because) = (Mark::Wrong, Some(Verdict::Refuted), why);
            self.push(line);
            return Ok(());
        }
        match status {
            Status::Holds(verdict) => {
                self.known.add(&reading, false);
                if let Some(Because::AtSpeed(speed)) = &under {
                    let special = &self.world.problem.special;
                    self.premises[display] = special.at_speed(self.quiet, reading.clone(), speed);
                }
                line.verdict = Some(verdict);
                line.because = apart.or(under).unwrap_or(Because::Follows);
            }
            Status::Given(Verdict::Definition, _) if self.is_false_constant(at, &reading, &mut line) => {}
            Status::Given(Verdict::Definition, _) | Status::False(_) if self.is_one_of_several(at, &mut line) => {}
            Status::Given(verdict, what) => {
                if what == SOME_MOTIONS {
                    self.add_condition(at);
                    if !(self.world.written[at].inline || self.world.written[at].is_supposed) {
                        self.unsaid.push(self.world.written[at].name.clone());
                    }
                }
                if verdict == Verdict::Definition {
                    self.known.add(&reading, false);
                }
                (line.mark, line.verdict, line.because) = (Mark::Given, Some(verdict), what.into());
            }
            // In a state it cannot be put to the test, as e^{i\omega t} has none.
            Status::Open(..) if self.is_tried(at, &reading) => {
                (line.mark, line.verdict) = (Mark::Given, Some(Verdict::Assumed));
                line.because = false_line::TRIAL.into();
            }
            Status::Open(verdict, message) => {
                let message = self.world.with_own_names(&message);
                (line.mark, line.verdict, line.because) = (Mark::Open, Some(verdict), message.into());
            }
            Status::Unread(message) => {
                let message = self.world.with_own_names(&message);
                (line.mark, line.verdict, line.because) = (Mark::Unread, Some(Verdict::Unreadable), message.into());
            }
            Status::False(_) if self.is_at_an_extremum(at, &reading, &mut line) => {}
            Status::False(_) if self.is_at_rest(at, &reading, &mut line) => {}
            Status::False(finding) => {
                if let Some(said) = near_rest::of_the_frequency(self.quiet, self.world, &self.quiet.readings[display]) {
                    self.premises[display] = said;
                }
                self.false_line(at, &reading, &mut line, &finding)?;
            }
        }
        self.push(line);
        Ok(())
    }

    fn push(&mut self, line: Line) {
        if matches!(line.mark, Mark::Wrong | Mark::Carried) {
            self.trusted[self.world.first + self.lines.len()] = Reading::default();
        }
        self.lines.push(line);
    }

    /// What a reading is in the problem, by itself, along its motion, under the hypotheses of its equations, or under
    /// conditions that were stated; and what it needs.
    fn status(&self, display: usize, reading: &Reading) -> (Status, Option<Because>) {
        self.status_with(display, reading, &self.conditions)
    }

    /// The same with only some of the conditions.
    fn status_with(&self, display: usize, reading: &Reading, conditions: &[Condition]) -> (Status, Option<Because>) {
        let checker = Checker { readings: &self.trusted, units: self.quiet.units.clone(), ..*self.quiet };
        let none = Claim::default();
        let refuted = || Box::new(Finding::new(Code::SidesDiffer, Verdict::Refuted, Span::default(), ""));
        let own = match !self.details && stated(reading).is_none() {
            true if slip::fits(&checker, reading) => Status::Holds(Verdict::Verified),
            true => Status::False(refuted()),
            false => status(&checker, display, reading, &none),
        };
        if matches!(own, Status::Holds(_)) && self.motion.is_printed_in(&checker, self.world, reading) {
            return match self.along(&checker, display, reading, &none) {
                Along::True => (own, None),
                Along::False => (Status::False(refuted()), None),
                Along::Open => (Status::Given(Verdict::Assumed, OTHER_START), None),
            };
        }
        if matches!(own, Status::Holds(_)) && self.is_kept_by_some_motions(&checker, reading) {
            return match self.along(&checker, display, reading, &none) {
                Along::True => (own, None),
                _ => (Status::Given(Verdict::Assumed, SOME_MOTIONS), None),
            };
        }
        if matches!(own, Status::Holds(_)) && self.names_a_rate(reading) {
            return (Status::Given(Verdict::Definition, "defines a name"), None);
        }
        if !matches!(own, Status::False(_) | Status::Open(..)) {
            return (own, None);
        }
        if self.along(&checker, display, reading, &none) == Along::True {
            return (Status::Holds(Verdict::Verified), None);
        }
        // The problem states the frequency of small motion, and not what the deviation is.
        let of_frequency = near_rest::of_the_frequency(self.quiet, self.world, &self.quiet.readings[display]);
        let mut all = std::iter::once(&none).chain(&self.world.problem.contexts);
        if of_frequency.as_ref().is_some_and(|said| all.any(|claim| self.holds_under(&checker, display, said, claim))) {
            return (Status::Holds(Verdict::Verified), Some("follows for a small deviation".into()));
        }
        if self.are_the_roots(&checker, display, reading) {
            return (Status::Holds(Verdict::Verified), Some("gives the roots of an equation of the problem".into()));
        }
        for (at, context) in self.world.problem.contexts.iter().enumerate() {
            // While the motion stays at a place there is no deviation, and anything holds of it.
            let is_still = of_frequency.is_some() && !context.throughout.is_empty();
            if is_still || special::is_degenerate(&checker, context, reading) {
                continue;
            }
            let loose = (!context.small.is_empty() || context.limit.is_some()).then(|| approximate(reading));
            let own = context.secular_for.is_some().then(|| self.of_the_frequency(reading));
            let holds =
                self.holds_under(&checker, display, own.as_ref().or(loose.as_ref()).unwrap_or(reading), context)
                    || self.along(&checker, display, reading, context) == Along::True;
            let is_tested = || self.under(&checker, display, reading, context) != supposed::Under::Anyway;
            if holds && (self.cases[at].is_empty() || self.is_granted(at, display, reading) && is_tested()) {
                return (
                    Status::Holds(Verdict::Verified),
                    Some("follows from the problem, with its hypotheses".into()),
                );
            }
        }
        if self.holds_where_it_grows(&checker, display, reading) {
            return (
                Status::Holds(Verdict::Verified),
                Some("follows from the problem where the velocity is positive".into()),
            );
        }
        if self.is_a_root(&checker, display, reading) {
            return (Status::Holds(Verdict::Verified), Some("gives a root of the secular equation".into()));
        }
        let special = &self.world.problem.special;
        if let Some(speed) = special.speed(&checker, display, reading) {
            return (Status::Holds(Verdict::Verified), Some(Because::AtSpeed(speed.clone())));
        }
        let is_near = self.world.written[display - self.world.first].is_near;
        if special.is_linearized(&checker, display, reading, is_near) {
            return (Status::Holds(Verdict::Verified), Some("follows for small motion".into()));
        }
        if (is_near || special.has_modes_at_places()) && near_rest::holds(&checker, self.world, display, reading) {
            return (Status::Holds(Verdict::Verified), Some("follows for small motion about the place of rest".into()));
        }
        if self.holds_at_a_place(&checker, display, reading) {
            return (
                Status::Holds(Verdict::Verified),
                Some("follows while the coordinate keeps the value that the problem gives".into()),
            );
        }
        if let Some(found) = self.under_conditions(&checker, (display, reading), conditions) {
            return found;
        }
        (own, None)
    }

    /// Whether a reading holds under a claim. Where other letters are sought, a few states that obey its hypotheses tell enough.
    fn holds_under(&self, checker: &Checker<'_>, display: usize, reading: &Reading, claim: &Claim) -> bool {
        let (assume, throughout) = (claim.assume.clone(), claim.throughout.clone());
        let only_supposes = *claim == Claim { assume, throughout, ..Claim::default() } && !checker.starts(claim);
        if self.details || !only_supposes || stated(reading).is_some() {
            // States that obey hypotheses are found by chance: where none was found, another seed may find some.
            let seeds = if claim.assume.is_empty() && claim.throughout.is_empty() { 1 } else { SEEDS };
            let tried = (0..seeds).map(|more| {
                let options = Options { seed: checker.options.seed + more, ..checker.options };
                status(&Checker { options, units: checker.units.clone(), ..*checker }, display, reading, claim)
            });
            let mut decided = tried.skip_while(|found| matches!(found, Status::Open(..)));
            return matches!(decided.next(), Some(Status::Holds(_)));
        }
        checker.hypotheses(claim).is_ok_and(|hypotheses| slip::fits_under(checker, reading, &hypotheses))
    }

    fn along(&self, checker: &Checker<'_>, display: usize, reading: &Reading, claim: &Claim) -> Along {
        self.motion.along((checker, self.world), (display, reading), (claim, !self.details))
    }
}

/// How many seeds are tried for states that obey the hypotheses of a claim.
const SEEDS: u64 = 3;

/// What is said of a function of the time that solves the laws and is not that of the model solution.
const OTHER_START: &str = "solves the equations of motion, but for other initial values than the model solution";

/// What is said of a relation between coordinates that some motions keep.
const SOME_MOTIONS: &str = "holds for some motions, and the problem does not say that this is one of them";

/// That a line builds on a false line, and on the other false lines that give a value to a name in it.
fn carried(lines: &[Line], from: usize, others: &[usize]) -> Because {
    let mut root = from;
    while let Some(next) = lines[root].follows_from {
        root = next;
    }
    if root != from {
        return format!(
            "is a correct step, but builds on {}, which builds on the mistake in {}",
            lines[from].name, lines[root].name
        )
        .into();
    }
    let mut all: Vec<usize> = others.iter().copied().chain([from]).collect();
    all.sort_unstable();
    all.dedup();
    let names: Vec<&str> = all.iter().map(|at| lines[*at].name.as_str()).collect();
    let mistakes = if names.len() == 1 { "mistake" } else { "mistakes" };
    format!("is a correct step, but builds on the {mistakes} in {}", listed(&names, "and")).into()
}
