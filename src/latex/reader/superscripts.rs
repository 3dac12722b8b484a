//! What stands above a base: a power, a transpose, an inverse; and marks that look like a power and are none.
//!
//! In an exponent of e, and in the argument of `\exp`, everything after a slash stands below it: `e^{-E/kT}` is exp(−E/(kT)).
//!
//! `X^T`, `A^\dagger`, `x^*`, `x^{(n)}`, `v^+`, `F^{\mathrm{ext}}` and indices above a symbol are rejected, since to read
//! them as powers would be silently wrong. Without declarations, letters that are usual as indices are rejected too.

use crate::formula::shape::Shape;
use crate::formula::symbols::Name;
use crate::formula::tree::{Expr, Node};
use crate::source::{Fault, Span};

use super::super::layout::{Delimiter, Item, Layout, contents, typed};
use super::super::lexer::Space;
use super::super::names;
use super::items::{is_inverse_transpose, is_minus_one, is_number, is_numeric_item, is_transpose, whole_number};
use super::state::{Read, Reader};

/// The same items with a space between β and a parenthesis that begins with a fraction, `e^{-\beta\left(\frac{p^2}{2m} + V\right)}`: there
/// β is one by the temperature, and no function.
fn with_factor_beta(items: &[Item]) -> Vec<Item> {
    let is_beta = |item: &Item| item.layout == Layout::Command("\\beta".to_owned());
    let is_energy = |item: &Item| {
        matches!(&item.layout, Layout::Fence(Delimiter::Round | Delimiter::Square, inside)
            if inside.iter().find(|item| !matches!(item.layout, Layout::Space(_))).is_some_and(|first| matches!(first.layout, Layout::Fraction(..))))
    };
    let mut found: Vec<Item> = Vec::with_capacity(items.len());
    for item in items {
        if found.last().is_some_and(is_beta) && is_energy(item) {
            found.push(Item { layout: Layout::Space(Space::Thin), span: Span::at(item.span.start) });
        }
        found.push(item.clone());
    }
    found
}

/// A term `a/bc` as a fraction.
fn as_fraction(term: &[Item]) -> Option<Item> {
    let is_slash = |item: &Item| item.layout == Layout::Other('/');
    let is_space = |item: &&Item| matches!(item.layout, Layout::Space(_));
    let is_figure = |item: &Item| is_number(item) || is_numeric_item(item);
    let is_pi = |item: &Item| matches!(&item.layout, Layout::Command(name) if name == "\\pi");
    let is_factor = |item: &Item| is_figure(item) || is_pi(item) || names::printed(item, None).is_some();
    let at = term.iter().position(is_slash)?;
    let (above, below) = (&term[..at], &term[at + 1..]);
    let factors: Vec<&Item> = below.iter().filter(|item| !is_space(item)).collect();
    let is_product = factors.len() > 1 && factors.iter().all(|item| is_factor(item));
    // `e^{-k/m t}` may be a rate times the time; in `x^2/4Dt` the place above says that it is not.
    let is_variable = |item: &Item| {
        names::printed(item, None)
            .is_some_and(|printed| ["t", "x", "y", "z", "r"].iter().any(|name| printed.name == Name::plain(*name)))
    };
    let is_open = factors.last().is_some_and(|last| is_variable(last)) && !above.iter().any(is_variable);
    let is_mixed = above.iter().filter(|item| !is_space(item)).all(is_figure) && is_figure(factors.first()?);
    let group = |items: &[Item]| {
        let span = items.first()?.span.to(items.last()?.span);
        Some(Box::new(Item { layout: Layout::Group(items.to_vec()), span }))
    };
    if !is_product || is_mixed || is_open {
        return None;
    }
    let (above, below) = (group(above)?, group(below)?);
    let span = above.span.to(below.span);
    Some(Item { layout: Layout::Fraction(above, below), span })
}

impl Reader<'_> {
    /// An exponent of e whose slashes are fraction lines: authors set no `\frac` there, and divide nothing but the whole term.
    ///
    /// `1/2x` keeps its slash, and so does a term whose denominator is no product of numbers and names.
    pub(super) fn exponent_of_e(&mut self, exponent: &Item) -> Read<Expr> {
        let is_sign = |item: &Item| matches!(item.layout, Layout::Other('+' | '-'));
        let items = match &exponent.layout {
            Layout::Group(items) | Layout::Fence(_, items) => items,
            _ => return self.item(exponent),
        };
        let items = &with_factor_beta(items);
        // `e^{-s(0)}`: the place at which an integral ends is put in, or s is a function.
        let is_figure = |item: &Item| matches!(&item.layout, Layout::Fence(Delimiter::Round, inside) if matches!(inside.as_slice(), [only] if is_number(only)));
        let applied = items.windows(2).find(|pair| names::printed(&pair[0], None).is_some() && is_figure(&pair[1]));
        if let Some([name, place]) = applied.filter(|_| self.symbols.open) {
            return Err(Fault::ambiguous(
                name.span.to(place.span),
                "a number in parentheses after a name may be a factor or the place where a function is taken",
            )
            .help("write \\cdot for the product"));
        }
        let mut found: Vec<Item> = Vec::with_capacity(items.len());
        for term in items.split_inclusive(is_sign) {
            let length = term.len() - usize::from(term.last().is_some_and(is_sign));
            let (term, sign) = term.split_at(length);
            match as_fraction(term) {
                Some(fraction) => found.push(fraction),
                None => found.extend_from_slice(term),
            }
            found.extend_from_slice(sign);
        }
        let layout = match &exponent.layout {
            Layout::Fence(delimiter, _) => Layout::Fence(*delimiter, found),
            _ => Layout::Group(found),
        };
        self.item(&Item { layout, span: exponent.span })
    }

    /// A base with a superscript: a power, a transpose, an inverse.
    pub(super) fn raised(&mut self, base: Expr, sup: &Item, span: Span) -> Read<Expr> {
        let shape = self.shape_of(&base)?;
        let found = self.above_a_matrix(&base, shape, sup, span).or_else(|| self.conjugate(&base, shape, sup, span));
        if let Some(found) = found {
            return Ok(found);
        }
        let is_power = self.is_a_power(&base, sup, span);
        let no_power = shape == Shape::Vector && whole_number(sup) != Some(2);
        let is_index = self.is_abstract()
            && (self.symbols.inferred.has_tensors && self.is_index(sup)
                || self.is_index_of_several(sup)
                || self.is_component(&base, sup)
                || matches!(whole_number(sup), Some(0 | 1)));
        if self.is_abstract() && (is_power.is_err() || no_power || is_index) {
            return match self.marked(&base, sup, span)? {
                Some(found) => Ok(found),
                None => is_power.and_then(|()| Err(self.mark(&base, sup))),
            };
        }
        is_power?;
        let boxed = Box::new(base);
        let has_hat = matches!(&boxed.node, Node::Symbol { id, .. }
            if self.symbols.entry(*id).name.base.starts_with("\\hat{"));
        if has_hat && shape == Shape::Vector && self.symbols.may_be_abstract && !self.is_abstract() {
            return Err(Fault::ambiguous(
                span,
                "a letter with a hat may be an operator or a unit vector, so its power is unclear",
            )
            .help("for the square of a vector, declare the vector in a claims file"));
        }
        if shape == Shape::Vector && whole_number(sup) == Some(2) {
            return Ok(Expr::new(Node::Dot(boxed.clone(), boxed), span));
        }
        let exponent = self.item(sup)?;
        Ok(Expr::new(Node::Power(boxed, Box::new(exponent)), span))
    }

    /// Rejects a superscript that is no power.
    fn is_a_power(&self, base: &Expr, sup: &Item, span: Span) -> Read<()> {
        let marks: Vec<&Item> = contents(sup).iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
        if is_transpose(sup) {
            let is_letter = matches!(marks.as_slice(), [Item { layout: Layout::Letter(_), .. }]);
            let is_declared = !self.symbols.open && self.symbols.find(&Name::plain("T")).is_some();
            return match is_letter && is_declared {
                true => Ok(()),
                false => Err(Fault::ambiguous(span, "this superscript may be a transpose or a power")
                    .help("for a transpose, declare the matrix or write it out; for a power, declare T")),
            };
        }
        // `B^{-T}`
        if is_inverse_transpose(sup) && (self.symbols.open || self.symbols.guessed) {
            return Err(Fault::ambiguous(span, "this superscript may be the inverse of a transpose, or a power")
                .help("for a transpose, declare the matrix or write it out"));
        }
        // `\theta^{M[u, x]}`: a list is no exponent.
        let has_list = |item: &&&Item| matches!(&item.layout, Layout::Fence(Delimiter::Square, inside) if inside.iter().any(|item| item.layout == Layout::Other(',')));
        if let Some(list) = marks.iter().find(has_list).filter(|_| self.symbols.open) {
            return Err(Fault::ambiguous(
                list.span,
                "brackets with a comma in an exponent may hold arguments or a commutator",
            )
            .help("for arguments, write parentheses, as in M(u, x)"));
        }
        if self.is_level(self.name_of(base).0, sup) {
            return Err(unclear(span, sup, "the number of a step or a power")
                .help("write the number of the step as a subscript, u_n; write a power as (u)^n"));
        }
        if (self.symbols.open || self.symbols.guessed) && is_next_to(self.name_of(base).1, &marks) {
            return Err(unclear(span, sup, "the frame or the step beside the one below, or a power")
                .help("write both as a subscript, as in T_{i-1,i}; write a power as \\exp((i-1)\\ln T_i)"));
        }
        match marks.as_slice() {
            [Item { layout: Layout::Command(name), .. }]
                if [
                    "\\prime",
                    "\\dagger",
                    "\\ddagger",
                    "\\circ",
                    "\\ast",
                    "\\star",
                    "\\perp",
                    "\\parallel",
                    "\\sharp",
                    "\\wedge",
                    "\\vee",
                    "\\pm",
                    "\\mp",
                ]
                .contains(&name.as_str()) =>
            {
                return Err(self.mark(base, sup));
            }
            [Item { layout: Layout::Other('*' | '+' | '-' | '°' | '†'), .. }] => return Err(self.mark(base, sup)),
            // `2^{(n-1)}`, `(a + b)^{(n-1)}`: neither has a mark.
            [Item { layout: Layout::Fence(Delimiter::Round, _), .. }] if is_value(base) => return Ok(()),
            [Item { layout: Layout::Fence(delimiter, _), .. }] if !is_bar(*delimiter) => {
                return Err(self.mark(base, sup));
            }
            [Item { layout: Layout::Text(_), .. }] => return Err(label(sup.span)),
            // `v^{\hat r}` is the component along a direction.
            [Item { layout: Layout::Accent(accent, _), .. }] if self.symbols.open && accent == "\\hat" => {
                return Err(label(sup.span));
            }
            [Item { layout: Layout::Style(style, inner), .. }]
                if style == "\\mathrm" && contents(inner).len() > 1 && !self.is_declared(marks[0]) =>
            {
                return Err(label(sup.span));
            }
            // `W^{\rm M}`: one upright capital names something too.
            [Item { layout: Layout::Style(style, inner), .. }]
                if style == "\\mathrm"
                    && self.symbols.open
                    && matches!(contents(inner), [Item { layout: Layout::Letter('A'..='Z'), .. }])
                    && !matches!(base.node, Node::Number(_)) =>
            {
                return Err(label(sup.span));
            }
            // `c^{s\dagger}`, `H^{\dagger(i)}`
            [_, _, ..] if marks.iter().any(|item| is_dagger(item)) => return Err(self.mark(base, sup)),
            // `U^{\mathrm{dis}(k)}`
            [Item { layout: Layout::Style(style, inner), .. }, _, ..]
                if style == "\\mathrm" && contents(inner).len() > 1 && !self.is_declared(marks[0]) =>
            {
                return Err(label(sup.span));
            }
            [_, .., Item { layout: Layout::Other('†' | '*'), .. }] => return Err(self.mark(base, sup)),
            _ => {}
        }
        // `\Gamma^{r_t}_{\theta_t\theta_t}`; but `p_i^{n_i}` is a power for each i.
        if let [only] = marks.as_slice()
            && let Some(found) = names::printed(only, None).filter(|found| found.sup.is_none())
            && (self.symbols.open || self.symbols.guessed)
        {
            let (_, below) = self.name_of(base);
            let above = &found.name.subscript;
            if !above.is_empty() && !below.is_empty() && below != above.as_slice() {
                return Err(unclear(span, sup, "an index, a label or a power")
                    .help("write indices as a subscript; write a power as (x_1)^{n_2}"));
            }
        }
        // `T^{a_1 \ldots a_r}`, `p^{B_1}`: names with an index of their own, or many of them.
        let found: Vec<_> = marks.iter().filter_map(|item| names::printed(item, None)).collect();
        let are_indexed = found.iter().all(|found| found.sup.is_none() && !found.name.subscript.is_empty());
        let is_row = found.len() > 1
            && marks.iter().all(|item| {
                names::printed(item, None).is_some()
                    || matches!(&item.layout, Layout::Command(name) if name == "\\dots")
            });
        let is_frame =
            found.len() == marks.len() && found.len() == 1 && found[0].name.base.starts_with(char::is_uppercase);
        let is_symbol = matches!(base.node, Node::Symbol { .. } | Node::Apply(..));
        if self.symbols.open && is_symbol && names_two_places(sup) {
            return Err(unclear(span, sup, "a label or a power")
                .help("write a label as a subscript; write a power as \\exp(b \\ln a)"));
        }
        if self.symbols.open && is_symbol && are_indexed && (is_row || is_frame) {
            return Err(unclear(span, sup, "an index, a label or a power")
                .help("write an index as a subscript; write a power as \\exp(b \\ln a), or declare the letters in a claims file"));
        }
        // `\varepsilon^p_{3,3}`
        let is_lone = matches!(marks.as_slice(), [Item { layout: Layout::Letter(_), .. }]);
        if self.symbols.open && is_lone && has_two_components(self.name_of(base).1) {
            return Err(unclear(span, sup, "a label or a power")
                .help("write a label as a subscript, and a power as (x_{3,3})^p"));
        }
        if self.symbols.open && whole_number(sup) == Some(5) && self.name_of(base).0 == "\\gamma" {
            return Err(Fault::ambiguous(span, "γ⁵ may be a matrix or a power")
                .help("write \\gamma_5 for the matrix, and (\\gamma)^5 for the power"));
        }
        if self.is_element_of_an_inverse(base, sup) {
            return Err(Fault::ambiguous(span, "F_{ij}^{-1} may be an element of the inverse matrix, or 1/F_{ij}")
                .help("write (F^{-1})_{ij} or \\frac{1}{F_{ij}}"));
        }
        let letters: Option<Vec<String>> = marks.iter().map(|item| letter(item)).collect();
        let letters = letters.unwrap_or_default();
        let is_index = |letter: &String| self.symbols.index(letter).is_some();
        if !letters.is_empty() && letters.iter().all(is_index) && !marks.iter().all(|item| self.is_declared(item)) {
            return Err(Fault::unsupported(sup.span, "indices as a superscript are not supported")
                .help("write the index as a subscript"));
        }
        let is_unclear = |letter: &String| self.symbols.inferred.unclear_letters.contains(letter);
        if self.symbols.guessed && letters.iter().any(is_unclear) && !matches!(base.node, Node::Number(_)) {
            return Err(unclear(span, sup, "an index or a power")
                .help("upper indices are not supported; write them as a subscript; for a power, use a letter that is no index elsewhere"));
        }
        match self.symbols.open {
            // The letter of a Σ above a name without an index, `\sum_N N^3 x^N`, is a power.
            true if matches!(letters.as_slice(), [only] if self.bound.contains(only))
                && self.name_of(base).1.is_empty()
                && matches!(letters[0].as_str(), "N" | "M" | "l") =>
            {
                Ok(())
            }
            // `p^x (1 - p)^{1 - x}`
            true if matches!(letters.as_slice(), [only] if self.symbols.inferred.exponents.contains(only)) => Ok(()),
            true => is_unlikely_index(self.name_of(base), base, &letters, sup, span),
            false => Ok(()),
        }
    }

    /// `F_{ji}^{-1}` beside a matrix `\mathbf{F}`.
    pub(in super::super) fn is_element_of_an_inverse(&self, base: &Expr, sup: &Item) -> bool {
        let (letter, subscript) = self.name_of(base);
        let is_index = |token: &String| token.len() == 1 && token.starts_with(|c: char| c.is_lowercase());
        let has_indices = matches!(subscript, [first, second] if is_index(first) && is_index(second));
        let matrix = Name::plain(format!("\\mathbf{{{letter}}}"));
        has_indices && is_minus_one(sup) && self.symbols.infers() && self.symbols.find(&matrix).is_some()
    }

    /// A superscript that is no power: what it may be, and what can be written in its place.
    fn mark(&self, base: &Expr, sup: &Item) -> Fault {
        let above = typed(contents(sup));
        let has_sign = contents(sup).iter().any(|item| matches!(item.layout, Layout::Other('+' | '-')));
        let (name, _) = self.name_of(base);
        let known = !name.is_empty();
        let name = if known { name } else { "x" };
        let (message, help) = if matches!(base.node, Node::Number(_)) && has_sign {
            (
                "a limit from one side is not supported".to_owned(),
                format!("leave ^{above} out where both limits are equal"),
            )
        } else if contents(sup).iter().any(is_dagger) {
            let message = format!("the superscript {above} needs a matrix or a complex number");
            let named = if known { name } else { "the name before it" };
            (message, format!("declare {named} as one, such as \"2x2 matrix\" or \"complex\", under \"constants\""))
        } else {
            let message = format!(
                "the superscript {above} is not a power, and a superscript that is only a mark is not supported"
            );
            (
                message,
                format!(
                    "write the mark as a subscript, such as {name}_{{{above}}}; write a power as {name}^2 or {name}^n"
                ),
            )
        };
        Fault::unsupported(sup.span, message).help(help)
    }

    /// Whether an item is a declared name.
    fn is_declared(&self, item: &Item) -> bool {
        names::printed(item, None).is_some_and(|printed| self.symbols.find(&printed.name).is_some())
    }

    /// The letter and the subscript of a symbol.
    pub(super) fn name_of(&self, base: &Expr) -> (&str, &[String]) {
        match &base.node {
            Node::Symbol { id, .. } => {
                let name = &self.symbols.entry(*id).name;
                (&name.base, &name.subscript)
            }
            _ => ("", &[]),
        }
    }
}

/// Without declarations: rejects letters above a base that are as likely indices, a label or an ordinal as a power.
fn is_unlikely_index(
    (name, subscript): (&str, &[String]),
    base: &Expr,
    letters: &[String],
    sup: &Item,
    span: Span,
) -> Read<()> {
    let is_symbol = matches!(base.node, Node::Symbol { .. } | Node::Apply(..));
    let is_number = matches!(base.node, Node::Number(_));
    let has_index = matches!(subscript, [.., last] if last.starts_with(|c: char| c.is_lowercase() || c == '\\'));
    let is_usual = |letter: &String| ["i", "j", "\\mu", "\\nu"].contains(&letter.as_str());
    // Of a capital, r and s are labels as often: those of quarks.
    let is_capital = name.len() == 1 && name.starts_with(char::is_uppercase);
    let is_power = |letter: &String| {
        // `r^\ell`: the radial part of a multipole.
        let is_multipole = name == "r" && subscript.is_empty() && ["l", "\\ell"].contains(&letter.as_str());
        is_multipole || ["n", "m", "k", "p", "q", "\\gamma"].contains(&letter.as_str())
            || !is_capital && ["r", "s"].contains(&letter.as_str())
            // `\omega_0^N`: a label below, and a number of particles or stages above.
            || !is_capital && letter == "N" && matches!(subscript, [label] if label.bytes().all(|b| b.is_ascii_digit()))
    };
    // The partition function of N particles.
    let is_of_particles = || match &base.node {
        Node::Symbol { .. } => letters.concat() == "N" && ["Z", "V", "z"].contains(&name),
        _ => false,
    };
    let is_ordinal = is_number && ["o", "st", "nd", "rd", "th"].contains(&letters.concat().as_str());
    let may_be_index = match letters {
        [] => is_symbol && matches!(whole_number(sup), Some(0 | 1)),
        [only] => {
            !is_of_particles()
                && (is_ordinal || !is_number && (is_usual(only) || is_symbol && (has_index || !is_power(only))))
        }
        [_, _] => is_symbol || is_ordinal,
        _ => true,
    };
    match may_be_index {
        true => Err(unclear(span, sup, "an index, a label or a power").help(
            "write an index or a label as a subscript; write a power as \\exp(b \\ln a), or with the exponent n",
        )),
        false => Ok(()),
    }
}

/// Whether a subscript is that of a component, as in `\sigma_{3,3}`.
pub(super) fn has_two_components(subscript: &[String]) -> bool {
    let is_number = |token: &String| matches!(token.as_str(), "0" | "1" | "2" | "3" | "4");
    matches!(subscript, [first, comma, second] if is_number(first) && comma == "," && is_number(second))
}

/// Whether two places stand side by side, between which something is taken: `V^{Px_1}`, `V^{\infty x_1}`.
pub(super) fn names_two_places(sup: &Item) -> bool {
    let marks: Vec<&Item> = contents(sup).iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
    let [first, last] = marks.as_slice() else { return false };
    let is_place =
        first.layout == Layout::Command("\\infty".to_owned()) || matches!(first.layout, Layout::Letter('A'..='Z'));
    is_place && names::printed(last, None).is_some_and(|found| found.sup.is_none() && !found.name.subscript.is_empty())
}

fn is_dagger(item: &Item) -> bool {
    matches!(&item.layout, Layout::Command(name) if ["\\dagger", "\\ddagger"].contains(&name.as_str()))
}

/// Whether a formula is a number or a sum or product, and no name.
pub(super) fn is_value(base: &Expr) -> bool {
    matches!(base.node, Node::Number(_) | Node::Sum(_) | Node::Product(_) | Node::Quotient(..))
}

/// Whether a delimiter is that of an absolute value.
fn is_bar(delimiter: Delimiter) -> bool {
    matches!(delimiter, Delimiter::Bar | Delimiter::PlainBar | Delimiter::DoubleBar)
}

/// A superscript with several meanings, which are named.
fn unclear(span: Span, sup: &Item, meanings: &str) -> Fault {
    Fault::ambiguous(span, format!("the superscript {} may be {meanings}", typed(contents(sup))))
}

fn label(span: Span) -> Fault {
    Fault::unsupported(span, "a word as a superscript is not supported")
        .help("write the word as a subscript, such as x_{\\text{ext}}")
}

/// The letter that an item is.
fn letter(item: &Item) -> Option<String> {
    match &item.layout {
        Layout::Letter(c) => Some(c.to_string()),
        Layout::Command(name) if names::is_letter(name) => Some(name.clone()),
        _ => None,
    }
}

/// Whether what stands above is the letter below and a 1, `T_i^{i-1}`.
fn is_next_to(below: &[String], above: &[&Item]) -> bool {
    let [letter] = below else { return false };
    match above {
        [first, sign, one] => {
            matches!(sign.layout, Layout::Other('+' | '-'))
                && whole_number(one) == Some(1)
                && names::printed(first, None).is_some_and(|found| found.sup.is_none() && found.name.base == *letter)
        }
        _ => false,
    }
}
