//! The slip in a wrong line: what was lost, and the edit that corrects it.

use std::cell::OnceCell;

use crate::Result;
use crate::formula::SymbolId;
use crate::latex::slips::{Edit, Pool, Slip};
use crate::latex::{Reading, names, read_formula, slips};
use crate::notes::claims::{Claim, Lost};
use crate::source::Span;

use crate::check::document::checker::Checker;
use crate::check::document::setup::Run;
use crate::check::model::claim::Hypothesis;
use crate::check::model::sampling::Spread;
use crate::check::sample::context::Context;
use crate::check::sample::outcome;
use crate::check::verdict::Verdict;
use crate::check::verdict::finding::{Finding, Formula};
use crate::check::verdict::report::Equation;

use super::marked::{Derived, Slipped};
use super::status::{Status, status};
use super::world::World;

/// The number of states that screen an edit.
const STATES: usize = 6;

/// The most bytes of a line in which a slip is sought: the edits of a longer one are too many.
const LONGEST: usize = 2000;

/// The kind of slip that a rubric names, for a kind of edit.
pub(super) fn lost(slip: Slip) -> Lost {
    match slip {
        Slip::Sign => Lost::Sign,
        Slip::Doubled | Slip::Number | Slip::Fraction | Slip::Factor | Slip::Order => Lost::Factor,
        Slip::Exponent => Lost::Power,
        Slip::Function => Lost::Function,
        Slip::Symbol | Slip::Index | Slip::Accent | Slip::Name | Slip::Relation => Lost::Symbol,
        Slip::Dot => Lost::Dot,
        Slip::Parenthesis | Slip::Term => Lost::Term,
    }
}

/// A slip with the edit of the document that corrects it.
#[derive(Clone, Debug)]
pub(super) struct Corrected {
    /// The slip, at its place in the hand-in.
    pub slip: Slipped,
    /// The corrected text of the line, with the letters of the problem.
    pub text: String,
}

/// The most likely slip in a wrong line, with its correction or without one, and what the derivation says instead.
type Found = (Option<Corrected>, Option<Slipped>, Option<Derived>);

/// The slips in lines, each sought once.
pub(super) struct Slips(Vec<OnceCell<Found>>);

impl Slips {
    /// Those of so many lines.
    pub fn of(lines: usize) -> Slips {
        Slips(vec![OnceCell::new(); lines])
    }

    /// The slip in a line.
    ///
    /// # Errors
    /// As for a check of the line.
    pub fn found(&self, run: &Run<'_>, checker: &Checker<'_>, world: &World<'_>, at: usize) -> Result<Found> {
        let known = self.0.get(at).and_then(OnceCell::get).cloned();
        if let Some(known) = known {
            return Ok(known);
        }
        let found = found(run, checker, world, at)?;
        Ok(self.0.get(at).map_or_else(|| found.clone(), |cell| cell.get_or_init(|| found.clone()).clone()))
    }
}

fn found(run: &Run<'_>, checker: &Checker<'_>, world: &World<'_>, at: usize) -> Result<Found> {
    let display = world.first + at;
    if world.display(at).text.len() > LONGEST {
        return Ok((None, None, None));
    }
    let equation = checker.equation(display, None)?;
    let equation: Equation = checker.with_repairs(run, display, equation, false)?;
    let body = world.display(at).body;
    let text = &world.display(at).text;
    let own = equation.repairs.iter().filter(|repair| {
        let inside = || Span::new(repair.span.start - body.start, repair.span.end - body.start);
        let is_here = repair.verdict.holds() && !repair.idle && repair.shared.is_none() && body.contains(repair.span);
        is_here && is_likely(checker, text, (inside(), &repair.replacement, repair.slip))
    });
    let corrected = own.filter_map(|repair| {
        let inside = Span::new(repair.span.start - body.start, repair.span.end - body.start);
        let mut new = text.clone();
        new.get(inside.range())?;
        new.replace_range(inside.range(), &repair.replacement);
        let span = world.original(at, repair.span)?;
        let slip =
            Slipped { lost: lost(repair.slip), span, replacement: Some(world.in_own_letters(&repair.replacement)) };
        Some(Corrected { slip, text: new })
    });
    let corrected = corrected.into_iter().next().or_else(|| edited(checker, world, at));
    let fitted = fitted(&equation.finding, world, at);
    let shown = |formula: &Formula| world.in_own_letters(&formula.latex);
    let instead = equation.finding.derived.as_ref().map(|formula| Derived::Instead(shown(formula)));
    let difference = || equation.finding.difference.as_ref().map(|formula| Derived::Difference(shown(formula)));
    Ok((corrected, fitted, instead.or_else(difference)))
}

/// The slip that the coefficients of the terms show, where no single edit corrects the line.
fn fitted(finding: &Finding, world: &World<'_>, at: usize) -> Option<Slipped> {
    let fit = finding.fit.as_ref()?;
    match (fit.terms.as_slice(), fit.missing.is_empty()) {
        ([only], true) => {
            let value = only.coefficient.value();
            let lost = if value == -1.0 {
                Lost::Sign
            } else if value == 0.0 {
                Lost::Term
            } else {
                Lost::Factor
            };
            Some(Slipped { lost, span: world.original(at, only.span)?, replacement: None })
        }
        ([], false) => Some(Slipped { lost: Lost::Term, span: world.original(at, finding.span)?, replacement: None }),
        _ => None,
    }
}

/// The most likely edit with which a line holds, also where it then only repeats what the problem says.
fn edited(checker: &Checker<'_>, world: &World<'_>, at: usize) -> Option<Corrected> {
    let line = world.display(at);
    let edit = correction(checker, world.first + at, &line.text, &|_| true)?;
    let span = world.original(at, edit.span.shifted(line.body.start))?;
    let slip = Slipped { lost: lost(edit.slip), span, replacement: Some(world.in_own_letters(&edit.replacement)) };
    Some(Corrected { slip, text: edit.applied(&line.text) })
}

/// Whether one likely edit of a text makes it true as a line, and leaves a symbol where it is.
pub(super) fn is_one_edit_away(checker: &Checker<'_>, display: usize, (text, of): (&str, SymbolId)) -> bool {
    let is_about_it = |reading: &Reading| {
        let mut firsts = reading.statements.iter().flatten().filter_map(|statement| statement.members.first());
        firsts.any(|first| first.as_plain_symbol() == Some(of))
    };
    text.len() <= LONGEST && correction(checker, display, text, &is_about_it).is_some()
}

/// The most likely edit with which the text of a line holds, and reads as `is_wanted` asks.
fn correction(checker: &Checker<'_>, display: usize, text: &str, is_wanted: &dyn Fn(&Reading) -> bool) -> Option<Edit> {
    let model = checker.model;
    let mut edits = slips::corrections(text, &model.symbols, &model.macros, &Pool::default());
    edits.sort_by_key(|edit| edit.slip);
    let none = Claim::default();
    let holds = |edit: &Edit| {
        let reading = checker.as_printed(&edit.applied(text), &none, &model.macros);
        let is_read = reading.statements.iter().all(Result::is_ok);
        is_read && is_wanted(&reading) && !is_trivial(&reading) && fits(checker, &reading) && {
            matches!(status(checker, display, &reading, &none), Status::Holds(_) | Status::Given(Verdict::Law, _))
        }
    };
    let is_likely = |edit: &Edit| is_likely(checker, text, (edit.span, &edit.replacement, edit.slip));
    edits.into_iter().filter(is_likely).find(holds)
}

/// Whether a student may have lost what an edit puts in. A factor is a number or a letter, and stands beside the formula for a name, not
/// beside the name. A term has no rate that the line does not have.
fn is_likely(checker: &Checker<'_>, text: &str, (span, new, slip): (Span, &str, Slip)) -> bool {
    let kind = lost(slip);
    if !matches!(kind, Lost::Factor | Lost::Term) {
        return true;
    }
    let mut symbols = checker.model.symbols.clone();
    let plain = new.trim().trim_start_matches(['+', '-']);
    let put_in = read_formula(plain, &mut symbols, &checker.model.macros).map(|formula| formula.symbols());
    let Ok(put_in) = put_in else { return true };
    let rates = put_in.iter().filter(|(_, dots)| *dots > 0).count();
    if kind == Lost::Term {
        return rates == 0 || text.contains("dot") || text.contains('\'');
    }
    let left = text.find('=').map(|end| &text[..end]);
    let is_before_a_name = left.is_some_and(|left| span.end <= left.len() && names::parse(left.trim()).is_some());
    rates == 0 && put_in.len() <= 1 && !is_before_a_name
}

/// Whether a side of an equality is the other one.
fn is_trivial(reading: &Reading) -> bool {
    let mut pairs = reading.statements.iter().flatten().flat_map(|statement| statement.members.windows(2));
    pairs.any(|pair| pair[0] == pair[1])
}

/// Whether the equalities of a reading hold at a few states.
pub(super) fn fits(checker: &Checker<'_>, reading: &Reading) -> bool {
    fits_under(checker, reading, &[])
}

/// The same at states that obey hypotheses.
pub(super) fn fits_under(checker: &Checker<'_>, reading: &Reading, hypotheses: &[Hypothesis]) -> bool {
    let context = Context {
        model: checker.model,
        options: checker.options,
        hypotheses,
        on_shell: None,
        topic: "a corrected line",
        span: Span::default(),
        spread: Spread::Declared,
        local: &[],
    };
    reading.statements.iter().flatten().all(|statement| {
        let mut links = statement.members.windows(2).zip(&statement.relations);
        links.all(|(pair, (relation, _))| {
            let Ok(link) = checker.link(&pair[0], *relation, &pair[1]) else { return false };
            let mode = context.mode(checker.model.has_motion(), &[&link.lhs, &link.rhs]);
            let Ok(ensemble) = context.ensemble(mode, false, STATES) else { return false };
            outcome::run(&link, &ensemble.states).is_ok_and(|outcome| outcome.failure.is_none() && outcome.points > 0)
        })
    })
}
