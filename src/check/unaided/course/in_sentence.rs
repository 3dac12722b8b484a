//! A name to which the sentence before a display gives a formula, as the display does: "the heat capacity `C = dU/dT` comes out as"
//! before `C = …`, "thus `\tau = 2\pi m a b/\ell` and" before `\tau^2 = …`.
//!
//! The formula of the sentence may use names that only other formulas of the same paragraph define.

use crate::check::document::inferred::prose::{body_of, follows_condition};
use crate::check::unaided::course::Course;
use crate::check::unaided::course::restated::Restated;
use crate::check::unaided::inline;
use crate::formula::{Expr, Node, Statement, SymbolId, text};
use crate::latex::read_display;
use crate::source::Span;

/// The words that may stand between a formula in a sentence and a display that follows from it.
const BETWEEN: [&str; 66] = [
    "and",
    "so",
    "is",
    "we",
    "get",
    "find",
    "have",
    "has",
    "hence",
    "thus",
    "therefore",
    "which",
    "that",
    "this",
    "it",
    "then",
    "gives",
    "yields",
    "comes",
    "out",
    "as",
    "be",
    "to",
    "becomes",
    "reads",
    "obtain",
    "see",
    "from",
    "follows",
    "now",
    "i.e",
    "simply",
    "or",
    "one",
    "finds",
    "gets",
    "obtains",
    "by",
    "differentiation",
    "explicitly",
    "the",
    "result",
    // other languages
    "also",
    "und",
    "damit",
    "folgt",
    "ergibt",
    "sich",
    "zu",
    "wird",
    "ist",
    "daraus",
    "donc",
    "d'où",
    "on",
    "obtient",
    "trouve",
    "vaut",
    "quindi",
    "si",
    "ottiene",
    "vale",
    "è",
    "e",
    "et",
    "soit",
];

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
            let latex = inline::with_whole_denominators(&with_derivatives(notes.source.slice(body)));
            if !latex.contains('=') || follows_condition(notes, *span) {
                continue;
            }
            let reading = read_display(&latex, &mut symbols, &model.macros);
            let [Ok(found)] = reading.statements.as_slice() else { continue };
            let [name, formula, ..] = found.members.as_slice() else { continue };
            let printed = name_of(latex.get(name.span.range())?);
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
                said = Some(Restated { formula: value, says, is_direct: self.is_directly_before(*span, at) });
            }
        }
        said
    }

    /// Whether nothing but words that one gives the other stands between a formula in a sentence and a display.
    fn is_directly_before(&self, span: Span, at: usize) -> bool {
        let notes = self.checker.notes;
        let between = notes.source.text.get(span.end..notes.equations[at].span.start).unwrap_or_default();
        let words = between.split(|c: char| c.is_whitespace() || ",;:".contains(c)).filter(|word| !word.is_empty());
        let is_allowed = |word: &str| {
            let word = word.trim_end_matches('.').to_lowercase();
            word.is_empty() || BETWEEN.contains(&word.as_str())
        };
        words.into_iter().all(is_allowed)
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

/// A formula in a line of text with its derivatives as fractions: `dU/dT`, `\partial \ln Z/\partial\beta`.
fn with_derivatives(text: &str) -> String {
    const SIGNS: [&str; 2] = ["\\partial", "d"];
    let ends_a_name = |text: &str| text.ends_with(|c: char| c.is_ascii_alphabetic() || matches!(c, '\\' | '^' | '_'));
    let derivative = |sign: &str| {
        let slash =
            text.match_indices('/').map(|(at, _)| at).find(|at| text[at + 1..].trim_start().starts_with(sign))?;
        let (before, below) = (&text[..slash], &text[slash + 1..]);
        let is_sign = |at: &usize| sign != "d" || !ends_a_name(&before[..*at]);
        let start = before.match_indices(sign).map(|(at, _)| at).filter(is_sign).last()?;
        let length = below.trim_end().find(|c: char| "=+-,;)".contains(c)).unwrap_or(below.trim_end().len());
        let (below, after) = below.split_at(length);
        let above = &before[start..];
        let is_plain = !above.contains(['=', '+', '/', '(']) && above.trim() != sign;
        is_plain.then(|| format!("{}\\frac{{{above}}}{{{below}}}{after}", &before[..start]))
    };
    SIGNS.iter().find_map(|sign| derivative(sign)).unwrap_or_else(|| text.to_owned())
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
