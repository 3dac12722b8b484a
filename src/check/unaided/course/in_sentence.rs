//! A name to which the sentence before a display gives a formula, as the display does: "the heat capacity `C = dU/dT` comes out as"
//! before `C = …`, "thus `\tau = 2\pi m a b/\ell` and" before `\tau^2 = …`.
//!
//! The formula of the sentence may use names that only other formulas of sentences after the last display define.

use crate::check::document::inferred::prose::{body_of, follows_condition};
use crate::check::unaided::course::Course;
use crate::check::unaided::course::restated::Restated;
use crate::check::unaided::course::special_values::Special;
use crate::check::unaided::inline;
use crate::formula::{Expr, Node, Statement, SymbolId, text};
use crate::latex::read_display;

impl Course<'_, '_> {
    /// What the last formula in a sentence between a display and the one before it says of the name to which the display gives a
    /// formula.
    pub(super) fn formula_in_sentence(&self, at: usize, statement: &Statement) -> Option<Restated> {
        let (notes, model) = (self.checker.notes, self.checker.model);
        let display = &notes.equations[at];
        let own = name_of(display.text.get(statement.members.first()?.span.range())?);
        let end = display.span.start;
        let printed = notes.equations[..at].iter().filter(|display| !inline::is_inline(notes, display));
        let start = printed.map(|display| display.span.end).filter(|before| *before <= end).max().unwrap_or(0);
        let known = model.symbols.len();
        let (mut symbols, mut defined) = (model.symbols.clone(), Vec::<(SymbolId, Expr)>::new());
        let mut said = None;
        for span in notes.inline.iter().filter(|span| span.start >= start && span.end <= end) {
            let Some(body) = body_of(notes, *span) else { continue };
            let latex = inline::as_displayed(notes.source.slice(body));
            if !latex.contains('=') || follows_condition(notes, *span) {
                continue;
            }
            let reading = read_display(&latex, &mut symbols, &model.macros);
            let [Ok(found)] = reading.statements.as_slice() else { continue };
            let [name, formula, ..] = found.members.as_slice() else { continue };
            let Some(printed) = latex.get(name.span.range()).map(name_of) else { continue };
            let formula = written_out(formula, &defined);
            if let Some(id) = name.as_plain_symbol().filter(|id| id.0 >= known) {
                defined.push((id, formula));
                continue;
            }
            let squared = format!("{printed}^2");
            let is_known = formula.symbols().iter().all(|(id, _)| id.0 < known);
            let value = match own == printed {
                true => formula.clone(),
                false if own == squared => square(&formula),
                false => continue,
            };
            if is_known && !formula.symbols().is_empty() && !formula.is_null() {
                let says = format!("{}, as the sentence before it says", text::formula(&value, &model.symbols));
                let is_direct = inline::leads_to(notes, *span, end);
                said = Some(Restated { said: Special { value, says }, is_direct });
            }
        }
        said
    }
}

/// The name on the left side of a formula, without its argument: C for `C(T)`.
fn name_of(text: &str) -> String {
    let bare: String = text.chars().filter(|c| !c.is_whitespace() && *c != '&').collect();
    match bare.find('(') {
        Some(at) if at > 0 && bare.ends_with(')') => bare[..at].to_owned(),
        _ => bare,
    }
}

fn written_out(formula: &Expr, defined: &[(SymbolId, Expr)]) -> Expr {
    let mut formula = formula.clone();
    formula.substitute(&|node| match node {
        Node::Symbol { id, dots: 0, .. } => {
            defined.iter().find(|(known, _)| known == id).map(|(_, value)| value.clone())
        }
        _ => None,
    });
    formula
}

fn square(formula: &Expr) -> Expr {
    let two = Expr::integer(2, formula.span);
    Expr::new(Node::Power(Box::new(formula.clone()), Box::new(two)), formula.span)
}
