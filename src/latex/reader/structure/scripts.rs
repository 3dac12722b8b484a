//! What stands above a base that has no power: an index, a mark, a label; and T, −1 and † above what has no value.
//!
//! A letter above a symbol is an index if it is a usual index of space and time, or an index elsewhere in the display. In
//! any other case it may be a power, and is refused.

use crate::formula::shape::Shape;
use crate::formula::tree::{Expr, Node};
use crate::source::{Fault, Span};

use super::super::super::layout::{Delimiter, Item, Layout, contents};
use super::super::super::names;
use super::super::items::{is_inverse_transpose, is_minus_one, is_transpose, whole_number};
use super::super::state::{Read, Reader};
use super::super::superscripts::{has_two_components, is_value, names_two_places};
use super::printed;

impl Reader<'_> {
    /// A base with what stands above it; `None` if it may be a power.
    pub(in super::super) fn marked(&mut self, base: &Expr, sup: &Item, span: Span) -> Read<Option<Expr>> {
        let shape = self.shape_of(base)?;
        let has_no_powers = matches!(shape, Shape::Abstract | Shape::Vector | Shape::Matrix(..));
        let text = self.by_sign(contents(sup));
        let is_number = matches!(base.node, Node::Number(_));
        if is_in_parentheses(sup) && !is_value(base) && may_be_an_exponent(contents(sup)) {
            return Err(Fault::ambiguous(
                span,
                "a superscript in parentheses, as in x^{(n)}, may be a label or a power",
            )
            .help("write a label as a subscript, x_n, and a power without the parentheses"));
        }
        let is_mark = match is_transpose(sup) || is_inverse_transpose(sup) {
            true => has_no_powers || self.symbols.inferred.has_transposes,
            false => {
                // Nobody writes the powers x⁰ and x¹.
                is_sign(sup) && !(is_in_parentheses(sup) && is_value(base))
                    || !is_number && matches!(whole_number(sup), Some(0 | 1))
                    || !is_number && (is_word(sup) || names_two_places(sup))
                    || !is_number && self.is_index(sup)
                    || self.is_component(base, sup)
                    || self.is_certain_level(self.name_of(base).0, sup)
                    || self.is_element_of_an_inverse(base, sup)
                    || self.has_subscript(base) && self.may_be_a_label(base, sup)
                    || self.has_indices(base) && names::printed(sup, None).is_some_and(|found| found.sup.is_none())
                    || has_no_powers && (is_minus_one(sup) || whole_number(sup).is_none())
            }
        };
        Ok(is_mark.then(|| self.template(&format!("#^{{{text}}}"), vec![base.clone()], span)))
    }

    /// Whether a base has a subscript, so that a letter above it is a second label as often as a power: `j^\phi_n`.
    fn has_subscript(&self, base: &Expr) -> bool {
        match &base.node {
            Node::Symbol { id, .. } => !self.symbols.entry(*id).name.subscript.is_empty(),
            Node::Apply(id, _) => self.symbols.entry(*id).name.base.contains("#_{"),
            _ => false,
        }
    }

    /// Whether a lone letter above may be a label: no letter that is usual for a power, as in `D h_i^r`, `r_c^\gamma`. Above a Greek
    /// index stands another one, `\Lambda_\beta^\alpha`.
    fn may_be_a_label(&self, base: &Expr, sup: &Item) -> bool {
        const POWERS: [&str; 5] = ["a", "b", "p", "q", "r"];
        const GREEK: [&str; 4] = ["\\alpha", "\\beta", "\\gamma", "\\kappa"];
        let has_greek = self.name_of(base).1.iter().any(|token| token.starts_with('\\'));
        let is_power = |found: names::Printed<'_>| {
            let letter = found.name.base.as_str();
            POWERS.contains(&letter) || !has_greek && GREEK.contains(&letter)
        };
        let has_components = has_two_components(self.name_of(base).1);
        is_lone_letter(sup)
            && (has_components || !names::printed(sup, None).is_some_and(is_power) || self.is_index(sup))
    }

    /// Whether two letters stand below a base, Greek or with a subscript of their own: `\Gamma_{\theta_t\theta_t}`.
    fn has_indices(&self, base: &Expr) -> bool {
        let Node::Symbol { id, .. } = &base.node else { return false };
        let subscript = &self.symbols.entry(*id).name.subscript;
        let is_letter = |token: &String| token.starts_with(|c: char| c.is_alphabetic() || c == '\\');
        let has_own = |at: usize| subscript.get(at + 1).is_some_and(|next| next == "_");
        let is_index = |at: &usize| is_letter(&subscript[*at]) && (subscript[*at].starts_with('\\') || has_own(*at));
        let is_nested = |at: &usize| at.checked_sub(1).is_some_and(|before| subscript[before] == "{");
        (0..subscript.len()).filter(|at| is_index(at) && !is_nested(at)).count() > 1
    }

    /// `F^{i 0}`: letters and digits above a base, of which none can be a power beside the others.
    pub(in super::super) fn is_index_of_several(&self, sup: &Item) -> bool {
        contents(sup).iter().filter(|item| !matches!(item.layout, Layout::Space(_))).count() > 1 && self.is_index(sup)
    }

    /// `P^2` beside `P^0`: a digit above a letter that has components in the display.
    pub(in super::super) fn is_component(&self, base: &Expr, sup: &Item) -> bool {
        match &base.node {
            Node::Symbol { id, .. } => {
                let name = &self.symbols.entry(*id).name;
                // `A^{11}` beside `A^{ij}`
                let are_two = matches!(contents(sup), [Item { layout: Layout::Number(digits), .. }]
                    if digits.len() == 2 && digits.chars().all(|digit| ('0'..='4').contains(&digit)));
                are_two && self.symbols.inferred.tensor_letters.contains(&name.base)
                    || matches!(whole_number(sup), Some(0..=4))
                        && self.symbols.inferred.component_letters.contains(&name.base)
            }
            _ => false,
        }
    }

    /// Whether letters above a base are indices.
    pub(in super::super) fn is_index(&self, sup: &Item) -> bool {
        let known = &self.symbols.inferred.index_letters;
        let is_known = |item: &Item| match names::printed(item, None) {
            Some(found) => {
                SPACETIME.contains(&found.name.base.as_str()) || known.contains(&found.name.base) && found.sup.is_none()
            }
            // `T^{i}{}_{1}`, `x^{\mu'}`
            None => {
                matches!(&item.layout, Layout::Number(digits) if digits.len() == 1) || item.layout == Layout::Other(',')
            }
        };
        let marks: Vec<&Item> = contents(sup).iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
        let has_letter = marks.iter().any(|item| names::printed(item, None).is_some());
        match marks.as_slice() {
            [] => false,
            _ => has_letter && marks.into_iter().all(is_known),
        }
    }
}

/// The usual indices of space and time, which are no exponents.
const SPACETIME: [&str; 5] = ["\\mu", "\\nu", "\\rho", "\\sigma", "\\lambda"];

/// Whether one letter stands above.
fn is_lone_letter(sup: &Item) -> bool {
    names::printed(sup, None).is_some_and(|found| found.sup.is_none() && found.name.subscript.is_empty())
}

/// Whether letters above a symbol spell one of the usual labels.
fn is_word(sup: &Item) -> bool {
    const WORDS: [&str; 23] = [
        "CM", "abs", "mol", "ex", "ext", "in", "out", "eff", "tot", "kin", "pot", "int", "rot", "max", "min", "eq",
        "cl", "rel", "cm", "el", "mag", "vib", "obs",
    ];
    // `Q^{EXC}`, `F^{LJ}`: capitals side by side.
    let is_capital = |item: &Item| matches!(item.layout, Layout::Letter('A'..='Z'));
    let are_capitals = contents(sup).len() > 2 && contents(sup).iter().all(is_capital);
    are_capitals || WORDS.contains(&printed(contents(sup)).as_str())
}

/// Whether a fraction of numbers or a negative number stands in the parentheses of a superscript: `x^{(1/2)}`, `x^{(-1)}`.
fn may_be_an_exponent(above: &[Item]) -> bool {
    let [Item { layout: Layout::Fence(Delimiter::Round, inside), .. }] = above else { return false };
    let is_number =
        |item: &Item| matches!(item.layout, Layout::Number(_) | Layout::Other('-' | '/') | Layout::Fraction(..));
    inside.len() > 1 && inside.iter().all(is_number)
}

/// Whether all that stands above is in parentheses.
fn is_in_parentheses(sup: &Item) -> bool {
    matches!(contents(sup), [Item { layout: Layout::Fence(Delimiter::Round, _), .. }])
}

/// Whether what stands above is a sign, a word or a number in parentheses, and so no power.
fn is_sign(sup: &Item) -> bool {
    let marks: Vec<&Item> = contents(sup).iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    match marks.as_slice() {
        [Item { layout: Layout::Command(name), .. }] => [
            "\\dagger",
            "\\ddagger",
            "\\circ",
            "\\ast",
            "\\star",
            "\\perp",
            "\\parallel",
            "\\pm",
            "\\mp",
            "\\prime",
            "\\sharp",
            "\\flat",
            "\\wedge",
            "\\times",
            "\\vee",
        ]
        .contains(&name.as_str()),
        [Item { layout: Layout::Other('*' | '+' | '-' | '°' | '†' | '!'), .. }] => true,
        [Item { layout: Layout::Fence(Delimiter::Round, _), .. }] => true,
        [Item { layout: Layout::Text(_), .. }] => true,
        [Item { layout: Layout::Accent(accent, _), .. }] if accent == "\\hat" => true,
        [Item { layout: Layout::Style(style, inner), .. }] if style == "\\mathrm" => contents(inner).len() > 1,
        [Item { layout: Layout::Style(style, _), .. }] => style == "\\mathbf",
        _ => false,
    }
}
