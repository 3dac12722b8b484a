//! What is read in formulas without declarations, and has no value there: operators on what follows them.
//!
//! Such an operator is a name before its argument ([`Node::Apply`]): the text of a Σ with its limits, an integral sign, ∇,
//! a bar with the place of an evaluation, a function at other arguments than its own. So the reading shows what was
//! understood, and nothing is computed from it.
//!
//! | file | what is read there |
//! | --- | --- |
//! | `functions` | `V(r)`, `V'(r)`, `x(0)`, `f(x + h)`, where the use of the name shows a function |
//! | `coefficient_d` | whether d is a factor in a display, and no differential |
//! | `current` | whether i is a current or an angle in a display, and not √−1 |
//! | `sums` | `\sum`, `\prod`, `\lim`, `\dots` |
//! | `integrals` | `\int`, `\oint`, differentials in the integrand |
//! | `fields` | `\nabla` |
//! | `marks` | δ and Δ before a letter: variations, differences and factors |
//! | `bound` | the letter of an integral that stands again behind it, which is refused |
//! | `no_factors` | what stands beside a factor and is none, which is refused |
//! | `neighbours` | factors that a person reads otherwise, which are refused |
//! | `unclear` | derivatives and integrals that may be meant in two ways, which are refused |
//! | `uses` | names that are factors in one place and seem to be functions in another |
//! | `spelled_names` | names of several letters that look like a product, which are refused |
//! | `vectors` | dots between bold letters of which one is a matrix |
//! | `bars` | `\left. … \right|_{x=a}`, `(\partial S/\partial V)_T` |
//!
//! Offers methods of the reader, and `bar`. Knows the layout, the names and the state of the reader.

pub(super) use bars::bar;
pub(super) use functions::is_probability;
pub(in super::super) use marks::has_coefficient;
pub(in super::super) use marks::note_marks;
pub(super) use neighbours::unclear_reach;
pub(in super::super) use spelled_names::unclear_name;
pub(super) use sums::follows_a_sum;
pub(in super::super) use unclear::unclear;

mod bars;
pub(super) mod bound;
pub(in super::super) mod coefficient_d;
pub(in super::super) mod current;
mod fields;
mod functions;
mod integrals;
mod marks;
mod neighbours;
mod no_factors;
mod spelled_names;
mod sums;
mod unclear;
pub(in super::super) mod uses;
pub(in super::super) mod vectors;

use crate::formula::symbols::{Kind, Name, Operator};
use crate::formula::tree::{Expr, Node};
use crate::source::Span;

use super::super::layout::{Item, Layout, contents};
use super::super::names;
use super::items::{is_any_integral, is_big_sum};
use super::state::{Read, Reader};

impl Reader<'_> {
    /// An operator with this name on these arguments.
    pub(super) fn operate(&mut self, name: &str, operator: Operator, arguments: Vec<Expr>, span: Span) -> Expr {
        self.operate_by(Name::plain(name), Kind::Scalar, operator, arguments, span)
    }

    pub(super) fn operate_by(
        &mut self,
        name: Name,
        kind: Kind,
        operator: Operator,
        arguments: Vec<Expr>,
        span: Span,
    ) -> Expr {
        // A name that is a quantity too is another symbol than the operator.
        let key = Name { base: format!("{}{}", name.base, crate::formula::text::APPLICATION), ..name };
        let id = match self.symbols.find(&key) {
            Some((id, _)) => id,
            None => self.symbols.add_operator(key, kind, operator),
        };
        Expr::new(Node::Apply(id, arguments), span)
    }

    /// One factor that an operator acts on: all of the term, or the first factor of it if that is a parenthesis.
    pub(super) fn acted_on(&mut self, operator: Span, items: &[Item], cursor: &mut usize) -> Read<Expr> {
        while matches!(items.get(*cursor).map(|item| &item.layout), Some(Layout::Space(_))) {
            *cursor += 1;
        }
        let missing = || {
            crate::source::Fault::new(operator, "no formula follows this operator")
                .help("write the formula on which the operator acts")
        };
        let first = items.get(*cursor).ok_or_else(missing)?;
        if is_constant_before_an_integral(&items[*cursor..]) {
            let rest = &items[*cursor..];
            *cursor = items.len();
            return self.term(rest);
        }
        if matches!(first.layout, Layout::Fence(..)) {
            *cursor += 1;
            return self.item(first);
        }
        let (inner, _) = self.factor(items, cursor)?;
        let goes_on = items[*cursor..].iter().find(|item| !matches!(item.layout, Layout::Space(_)));
        let is_factor = |item: &&Item| {
            names::printed(item, None).is_some()
                || matches!(item.layout, Layout::Fraction(..) | Layout::Fence(..))
                || is_any_integral(item)
                || is_big_sum(item)
        };
        let inner_span = inner.span;
        match goes_on.filter(is_factor) {
            Some(_) => Err(crate::source::Fault::ambiguous(
                operator.to(inner_span),
                "an operator before f g may act on f or on the product f g",
            )
            .help("put the factors on which it acts in parentheses")),
            None => Ok(inner),
        }
    }
}

/// Whether a fraction of constants stands before an integral: an operator before them acts on both, for it makes nothing of the first.
pub(super) fn is_constant_before_an_integral(items: &[Item]) -> bool {
    const CONSTANTS: [&str; 6] = ["\\pi", "\\epsilon", "\\varepsilon", "\\mu", "\\hbar", "c"];
    let is_constant = |item: &Item| {
        matches!(item.layout, Layout::Number(_) | Layout::Space(_))
            || names::printed(item, None).is_some_and(|found| CONSTANTS.contains(&found.name.base.as_str()))
    };
    let mut solid = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
    let (Some(first), Some(second)) = (solid.next(), solid.next()) else { return false };
    let Layout::Fraction(above, below) = &first.layout else { return false };
    is_any_integral(second) && [above, below].iter().all(|part| contents(part).iter().all(is_constant))
}

/// The text of items that are names, numbers, relations and signs, as under a Σ; `None` for anything else.
pub(super) fn simple_text(items: &[Item]) -> Option<String> {
    let mut text = String::new();
    for item in items {
        // `\Delta t` is no command `\Deltat`.
        let command = text.rfind('\\').map(|at| &text[at + 1..]);
        if command.is_some_and(|name| !name.is_empty() && name.chars().all(|c| c.is_ascii_alphabetic())) {
            text.push(' ');
        }
        match &item.layout {
            Layout::Space(_) => continue,
            Layout::Number(digits) => text.push_str(digits),
            Layout::Other(c @ ('=' | '+' | '-' | '<' | '>' | ',' | '≠' | '/')) => text.push(*c),
            Layout::Group(inner) => text.push_str(&simple_text(inner)?),
            Layout::Fence(super::super::layout::Delimiter::Round, inner) => {
                text.push('(');
                text.push_str(&simple_text(inner)?);
                text.push(')');
            }
            Layout::Command(name)
                if ["\\neq", "\\in", "\\leq", "\\geq", "\\infty", "\\rightarrow", "\\dots"]
                    .contains(&name.as_str()) =>
            {
                let between = if text.ends_with(' ') { "" } else { " " };
                text.push_str(&format!("{between}{name} "));
            }
            Layout::Command(name) if name == "\\partial" => text.push_str("\\partial "),
            Layout::Text(word) => text.push_str(word),
            _ => {
                let found = names::printed(item, None)?;
                text.push_str(&names::with_dots(&found.name, found.dots)?.to_string());
                if let Some(sup) = found.sup {
                    text.push_str(&format!("^{{{}}}", simple_text(std::slice::from_ref(sup))?));
                }
            }
        }
    }
    Some(text)
}
