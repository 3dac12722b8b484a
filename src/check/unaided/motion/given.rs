//! A name that a display gives a formula, and an edit with which the formula is what it has to be.

use crate::Result;
use crate::check::document::checker::Checker;
use crate::check::repair::culprit::is_common;
use crate::check::repair::ranking::{adds_parentheses, rank};
use crate::check::unaided::course::examples::LOST_FACTORS;
use crate::check::verdict::Verdict;
use crate::check::verdict::repair::Repair;
use crate::formula::{Expr, SymbolId};
use crate::latex::read_display;
use crate::latex::slips::{self, Edit, Pool, Slip};
use crate::source::Span;

/// A name with the display that gives it a formula.
pub(super) struct Given {
    /// The place of the display.
    pub at: usize,
    /// The name.
    pub id: SymbolId,
    /// The formula.
    pub formula: Expr,
}

/// The likeliest edit of the display of a name that gives it the formula that is sought: a common slip, or a lost number, of a kind that
/// may be one here.
///
/// # Errors
/// As for a check of an equation.
pub(super) fn corrected(
    checker: &Checker<'_>,
    given: &Given,
    may_be: &dyn Fn(&Edit) -> bool,
    is_sought: &dyn Fn(Expr) -> Result<bool>,
) -> Result<Option<Repair>> {
    let (model, display) = (checker.model, &checker.notes.equations[given.at]);
    let points = slips::insertion_points(&display.text, &model.symbols, &model.macros);
    let starts = points.into_iter().filter(|point| point.slip == Slip::Factor).map(|point| Span::at(point.whole.start));
    let lost = starts.flat_map(|span| {
        LOST_FACTORS.map(|factor| Edit { span, replacement: format!("{factor} "), slip: Slip::Factor })
    });
    let is_likely = |edit: &Edit| is_common(edit.slip) && !adds_parentheses(&display.text, edit);
    let mut edits = slips::corrections(&display.text, &model.symbols, &model.macros, &Pool::empty());
    edits.retain(is_likely);
    edits.sort_by_key(|edit| rank(&display.text, edit, false));
    for edit in edits.into_iter().chain(lost).filter(may_be) {
        let reading = read_display(&edit.applied(&display.text), &mut model.symbols.clone(), &model.macros);
        let statements = reading.statements.iter().flatten();
        let mut formulas = statements.filter_map(|statement| {
            let [first, .., last] = statement.members.as_slice() else { return None };
            (first.as_plain_symbol() == Some(given.id)).then(|| last.clone())
        });
        if let Some(formula) = formulas.next()
            && is_sought(formula)?
        {
            return Ok(Some(Repair::of(edit, display.body.start, Verdict::Verified)));
        }
    }
    Ok(None)
}
