//! One item as a formula: a number, a group, a fraction, a root, a matrix, and its superscript.

use crate::code::Code;
use crate::formula::shape::Shape;
use crate::formula::symbols::Components;
use crate::formula::tree::{Expr, Index, MatrixFunction, Node};
use crate::source::{Fault, Span};

use super::super::layout::{Delimiter, Item, Layout, contents};
use super::super::lexer::Space;
use super::super::names;
use super::super::overdots;
use super::super::rows::relation;
use super::algebra::is_matrix;
use super::items::{differential, is_number, joint, starts_differential, whole_number};
use super::state::{Read, Reader, unread};
use super::structure::is_material;
use super::values::Place;

impl Reader<'_> {
    /// A single item as a formula.
    pub(super) fn item(&mut self, item: &Item) -> Read<Expr> {
        // `1.2^{+0.8}_{-0.4}`
        if let Layout::Scripts { nucleus, sub: Some(_), sup: Some(_), .. } = &item.layout
            && is_number(nucleus)
        {
            return Err(Fault::unsupported(
                item.span,
                "a number with an uncertainty, as in 1.2^{+0.8}_{-0.4}, is not supported",
            )
            .help("write the number without its uncertainty"));
        }
        // `3.0\text{–}5.2`
        if let Layout::Text(word) = &item.layout
            && word.contains(['–', '-', '—'])
            && !word.contains(char::is_alphanumeric)
        {
            return Err(Fault::unsupported(item.span, "a range of values is not supported").help("write one value"));
        }
        // `{\mu\pi}_K`
        if let Layout::Scripts { nucleus, sub: Some(_), .. } = &item.layout
            && let Layout::Group(inside) = &nucleus.layout
            && inside.len() > 1
            && inside.iter().all(|inner| names::printed(inner, self.branch).is_some())
        {
            return Err(Fault::ambiguous(item.span, "braces do not print, so {a b}_k may be (a b)_k or a b_k")
                .help("use parentheses, or put the subscript on its letter"));
        }
        match self.is_abstract() && names::printed(item, self.branch).is_none() {
            true => match self.abstract_item(item)? {
                Some(found) => Ok(found),
                None => self.plain_item(item),
            },
            false => self.plain_item(item),
        }
    }

    fn plain_item(&mut self, item: &Item) -> Read<Expr> {
        let span = item.span;
        if let Some(printed) = names::printed(item, self.branch) {
            return self.symbol(span, printed, &[], &mut 0);
        }
        if let Layout::Accent(command, inner) = &item.layout
            && let Some(order) = overdots::order(command)
        {
            if is_number(inner) {
                return Err(Fault::new(span, "a number cannot have a dot, because it does not vary with time")
                    .help("remove the dot, or put it over a letter"));
            }
            return Ok(Expr::new(Node::TimeDerivative(order, Box::new(self.item(inner)?)), span));
        }
        match &item.layout {
            Layout::Scripts { nucleus, .. } if nucleus.layout == Layout::Group(Vec::new()) => {
                Err(Fault::new(span, "no symbol stands before this subscript or superscript")
                    .help("write it after its symbol, as in x_1 or x^2"))
            }
            Layout::Fault(fault) => Err(fault.clone()),
            Layout::Unit(units) => self.units(units, span),
            Layout::Rest(order) => self.rest(item, order.as_deref()),
            Layout::Value(_) => Err(Fault::new(span, "this formula is used as one symbol, and is not declared")
                .help("declare it under \"formulas as names\" in the claims file")),
            Layout::Number(digits) => {
                if digits.parse::<f64>().is_ok_and(f64::is_finite) {
                    Ok(Expr::new(Node::Number(digits.clone()), span))
                } else {
                    Err(Fault::new(span, "this number is too large to compute with")
                        .code(Code::TooLarge)
                        .help("choose units in which the number is smaller"))
                }
            }
            Layout::Group(items) => self.sum(items, span),
            Layout::Fence(delimiter, items) => self.fence(*delimiter, items, span),
            Layout::Fraction(numerator, denominator) => self.fraction(numerator, denominator, span),
            Layout::Root(index, radicand) => self.root(index.as_deref(), radicand, span),
            Layout::Environment(name, rows) if is_cases(name) => self.cases(rows, span),
            Layout::Environment(name, rows) => self.matrix(name, rows, span),
            // A unit matrix, `\mathbb{1}`.
            Layout::Style(style, inner)
                if matches!(style.as_str(), "\\mathbb" | "\\mathbf") && whole_number(inner) == Some(1) =>
            {
                Ok(Expr::new(Node::Identity, span))
            }
            Layout::Scripts { nucleus, sub, sup, primes: 0 }
                if matches!(nucleus.layout, Layout::Fence(Delimiter::Evaluation, _)) =>
            {
                let Layout::Fence(_, inside) = &nucleus.layout else {
                    return Err(Fault::new(span, "this bar is not supported"));
                };
                let inner = self.sum(inside, span)?;
                self.value_at(inner, (sub.as_deref(), sup.as_deref()), span)
            }
            // `[F]_a^b` is a difference.
            Layout::Scripts { nucleus, sub: Some(sub), sup: Some(sup), primes: 0 }
                if matches!(nucleus.layout, Layout::Fence(Delimiter::Square, _)) =>
            {
                let inner = self.item(nucleus)?;
                self.value_at(inner, (Some(sub), Some(sup)), span)
            }
            Layout::Command(name) if name == "\\dots" && self.symbols.infers() => Ok(self.ellipsis(span)),
            Layout::Scripts { nucleus, sub: Some(sub), sup, primes: 0 }
                if matches!(nucleus.layout, Layout::Fence(Delimiter::Round | Delimiter::Square, _)) =>
            {
                self.with_subscript(nucleus, sub, sup.as_deref(), span)
            }
            Layout::Style(command, inner) | Layout::Accent(command, inner)
                if matches!(command.as_str(), "\\vec" | "\\mathbf") && whole_number(inner) == Some(0) =>
            {
                let zero = || vec![Expr::new(Node::Number("0".to_owned()), span)];
                Ok(Expr::new(Node::Matrix(vec![zero(), zero(), zero()]), span))
            }
            Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 } => {
                self.with_superscript(nucleus, sup, span)
            }
            Layout::Scripts { .. }
            | Layout::Command(_)
            | Layout::Style(..)
            | Layout::Accent(..)
            | Layout::Text(_)
            | Layout::Other(_)
            | Layout::Letter(_)
            | Layout::Space(_)
            | Layout::Row
            | Layout::Align => Err(unread(item, !(self.symbols.open || self.symbols.guessed))),
        }
    }

    /// A fraction: an operator that stands alone, or a quotient.
    fn fraction(&mut self, numerator: &Item, denominator: &Item, span: Span) -> Read<Expr> {
        if let Some(operator) = self.operator(numerator, denominator, span)? {
            return self.apply(&operator, &[], &mut 0);
        }
        if self.symbols.infers() && is_material(numerator, denominator) {
            return Err(Fault::unsupported(span, "the derivative D/Dt along a flow is not supported")
                .help("write \\frac{\\partial}{\\partial t} + \\vec u \\cdot \\nabla"));
        }
        let is_element = self.is_abstract()
            || self.symbols.infers()
                && self.symbols.inferred.differentials
                && !starts_differential(denominator)
                && !matches!(&contents(numerator)[0].layout, Layout::Command(name) if name == "\\partial");
        if !is_element && (starts_differential(numerator) || starts_differential(denominator)) {
            return Err(Fault::unsupported(
                span,
                "a differential in a fraction is supported only in a derivative, such as \\frac{dx}{dt}",
            )
            .help("write each quotient of differentials as one derivative"));
        }
        is_filled(numerator, "the numerator", span)?;
        is_filled(denominator, "the denominator", span)?;
        let (a, b) = (self.item(numerator)?, self.item(denominator)?);
        Ok(Expr::new(Node::Quotient(Box::new(a), Box::new(b)), span))
    }

    fn root(&mut self, index: Option<&Item>, radicand: &Item, span: Span) -> Read<Expr> {
        let degree = match index.map(|index| whole_number(index).ok_or(index.span)) {
            None => 2,
            Some(Ok(degree)) if degree >= 2 => degree,
            Some(Ok(_)) => return Err(no_degree(span)),
            Some(Err(span)) => return Err(no_degree(span)),
        };
        is_filled(radicand, "the root", span)?;
        Ok(Expr::new(Node::Root(degree, Box::new(self.item(radicand)?)), span))
    }

    /// `(\partial S/\partial V)_T`, `(\vec\omega \times \vec r)_a`: parentheses with a subscript.
    fn with_subscript(&mut self, nucleus: &Item, sub: &Item, sup: Option<&Item>, span: Span) -> Read<Expr> {
        let is_derivative = self.symbols.infers() && is_derivative_in_parentheses(nucleus);
        // `\left(\frac{d\vec e}{dt}\right)_S` is the rate in a frame, and nothing is held fixed.
        let is_rate = is_derivative && is_rate_in_a_frame(nucleus, sub);
        if is_rate && !self.is_abstract() {
            return Err(Fault::unsupported(span, "a time derivative in a named frame, (d/dt)_S, is not supported")
                .help("write the derivative without the name of the frame"));
        }
        let is_held = is_derivative && !is_rate;
        if is_rate {
            let inner = self.item(nucleus)?;
            let below = super::structure::printed(contents(sub));
            let rate = self.template(&format!("(#)_{{{below}}}"), vec![inner], span);
            return match sup {
                Some(sup) => self.raised(rate, sup, span),
                None => Ok(rate),
            };
        }
        let part = match is_held {
            true => {
                let inner = self.item(nucleus)?;
                self.evaluated(inner, (Some(sub), None), span)?
            }
            false => self.held_or_part(nucleus, sub, span)?,
        };
        match sup {
            Some(sup) => self.raised(part, sup, span),
            None => Ok(part),
        }
    }

    /// `(a + b)^2`: a formula that is no name, with a superscript.
    fn with_superscript(&mut self, nucleus: &Item, sup: &Item, span: Span) -> Read<Expr> {
        let base = match &nucleus.layout {
            // `[a\,b]^2`: no row has a power.
            Layout::Fence(Delimiter::Square, inside) if are_entries(inside) && whole_number(sup).is_some() => {
                self.sum(inside, nucleus.span)?
            }
            _ => self.item(nucleus)?,
        };
        if matches!(nucleus.layout, Layout::Group(_)) && matches!(base.node, Node::Sum(_) | Node::Product(_)) {
            return Err(Fault::ambiguous(span, "braces do not print, so {a b}^2 may be (a b)^2 or a b^2")
                .help("use parentheses"));
        }
        // Nobody puts parentheses around a name below an index: `(x_2)^{n_1}`.
        let is_enclosed = matches!(nucleus.layout, Layout::Fence(Delimiter::Round, _));
        let is_name = |sup: &Item| {
            names::printed(sup, None).is_some_and(|found| found.sup.is_none() && !found.name.subscript.is_empty())
        };
        let is_plain = base.as_plain_symbol().is_some() && self.shape_of(&base)? == Shape::Scalar;
        if is_enclosed && is_plain && is_name(sup) {
            let exponent = self.item(sup)?;
            return Ok(Expr::new(Node::Power(Box::new(base), Box::new(exponent)), span));
        }
        self.raised(base, sup, span)
    }

    /// A formula at a place: its value, or where letters are inferred an operator.
    fn value_at(&mut self, inner: Expr, place: Place<'_>, span: Span) -> Read<Expr> {
        match self.symbols.infers() {
            true => self.evaluated(inner, place, span),
            false => self.at_place(&inner, place, span),
        }
    }

    fn fence(&mut self, delimiter: Delimiter, items: &[Item], span: Span) -> Read<Expr> {
        if let [Item { layout: Layout::Environment(name, rows), .. }] = items
            && matches!(delimiter, Delimiter::Round | Delimiter::Square)
        {
            return self.matrix(name, rows, span);
        }
        // Nobody puts one letter in such brackets for a product: it is a concentration, a unit or a matrix, or a set.
        if matches!(delimiter, Delimiter::Square | Delimiter::Curly)
            && self.symbols.may_be_abstract
            && matches!(items, [only] if super::structure::is_alone_in_brackets(only))
        {
            return match self.is_abstract() {
                true => self.shown_in_brackets(delimiter, &items[0], span),
                false => Err(Fault::unsupported(span, "a letter alone in square or curly brackets is not supported")
                    .help("for a product, write parentheses")),
            };
        }
        if delimiter == Delimiter::Square && self.symbols.may_be_abstract && are_entries(items) {
            return Err(Fault::ambiguous(span, "these square brackets may hold the entries of a row, or a product")
                .help("write \\begin{pmatrix} a & b \\end{pmatrix} for a row, and parentheses for a product"));
        }
        match delimiter {
            Delimiter::Round | Delimiter::Square | Delimiter::Curly => {
                let mut inner = self.sum(items, span)?;
                inner.span = span;
                Ok(inner)
            }
            Delimiter::Bar | Delimiter::PlainBar | Delimiter::DoubleBar => {
                let mut inner = self.sum(items, span)?;
                // `|r_i|` beside a declared `\vec r_i`: the name alone is the norm already.
                if let ([name], Node::Norm(_)) = (items, &inner.node)
                    && names::printed(name, self.branch).is_some_and(|p| p.sup.is_none())
                {
                    inner.span = span;
                    return Ok(inner);
                }
                // Bars around a matrix print its determinant.
                if delimiter != Delimiter::DoubleBar && matches!(self.shape_of(&inner)?, Shape::Matrix(..)) {
                    return Ok(Expr::new(Node::OfMatrix(MatrixFunction::Determinant, Box::new(inner)), span));
                }
                Ok(Expr::new(Node::Norm(Box::new(inner)), span))
            }
            Delimiter::Angle | Delimiter::Ket | Delimiter::Bra => {
                Err(Fault::unsupported(span, "states and mean values in angle brackets are not supported here")
                    .help("declare a mean value as one name, under \"formulas as names\" in a claims file"))
            }
            Delimiter::RightOpen | Delimiter::LeftOpen => {
                let is_interval = items.iter().any(|item| matches!(item.layout, Layout::Other(',' | ';')));
                let (open, close) = if delimiter == Delimiter::RightOpen { ("[", ")") } else { ("(", "]") };
                let right = if open == "[" { "]" } else { ")" };
                Err(match is_interval {
                    true => Fault::unsupported(span, "an interval is not supported here")
                        .help("write its ends as relations, as in 0 \\le x < 1"),
                    false => Fault::unsupported(span, format!("the bracket {open} is closed by {close}"))
                        .help(format!("write {right} in place of {close}")),
                })
            }
            Delimiter::Evaluation => {
                Err(Fault::unsupported(span, "this bar does not say at which place the formula is taken")
                    .help("write the place at the bar, as in \\right|_{x=a}"))
            }
        }
    }

    /// `(\vec\omega \times \vec r)_a`, `(R^T)_{ab}`: a component along the fixed axes, an entry.
    pub(super) fn part(&mut self, fence: &Item, sub: &Item, span: Span) -> Read<Expr> {
        let is_partial = |item: &Item| match &item.layout {
            Layout::Fraction(above, _) => {
                matches!(contents(above), [Item { layout: Layout::Command(name), .. }, ..] if name == "\\partial")
            }
            _ => false,
        };
        let refused = || match &fence.layout {
            Layout::Fence(_, inside) if inside.iter().any(is_partial) => Fault::unsupported(
                span,
                "a partial derivative with a subscript, as in (∂S/∂V)_T, is not supported here",
            )
            .help("leave the equation out with \"skip\" in the claims file"),
            _ => Fault::unsupported(sub.span, "only a symbol, a vector or a 3×3 matrix can have a subscript")
                .help("remove the subscript, or give the formula a name of its own"),
        };
        let index = |item: &Item| match &item.layout {
            Layout::Number(digits) => digits.parse().ok().filter(|n| (1..=3).contains(n)).map(Index::Fixed),
            _ => {
                let letter = self.symbols.index(&names::printed(item, None)?.name.to_string())?;
                (!self.symbols.indices[letter.0].labels).then_some(Index::Letter(letter))
            }
        };
        // `_{12}` is one number in the layout, and two indices here.
        let digits = |item: &Item| match &item.layout {
            Layout::Number(digits) => {
                let one = |c: char| Item { layout: Layout::Number(c.to_string()), span: item.span };
                digits.chars().map(one).collect()
            }
            _ => vec![item.clone()],
        };
        let inside = contents(sub).iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
        let indices: Option<Vec<Index>> = inside.flat_map(digits).map(|item| index(&item)).collect();
        let indices = indices.ok_or_else(refused)?;
        let inner = self.item(fence)?;
        match (self.shape_of(&inner)?, indices.as_slice()) {
            (Shape::Vector, [a]) => {
                if inner
                    .symbols()
                    .iter()
                    .any(|(id, _)| matches!(self.symbols.components_of(*id), Some(Components::Along(_))))
                {
                    return Err(Fault::ambiguous(
                        span,
                        "this component may be along the turning axes or along the fixed axes",
                    )
                    .help("write the dot product with a unit vector, \\cdot \\hat e_a"));
                }
                Ok(Expr::new(Node::Component(Box::new(inner), *a), span))
            }
            (Shape::Matrix(rows, columns), [a, b]) if within(*a, rows) && within(*b, columns) => {
                Ok(Expr::new(Node::Entry(Box::new(inner), *a, *b), span))
            }
            _ => Err(refused()),
        }
    }

    /// A cell of a matrix; an empty one is shown as such.
    fn cell(&mut self, cell: &[Item], span: Span) -> Read<Expr> {
        match cell.iter().all(|item| matches!(item.layout, Layout::Space(_))) {
            true if self.is_abstract() => Ok(self.label(&[], span)),
            _ => self.sum(cell, span),
        }
    }

    fn matrix(&mut self, name: &str, rows: &[Vec<Vec<Item>>], span: Span) -> Read<Expr> {
        match name {
            "vmatrix" | "Vmatrix" => {
                let inner = self.matrix("pmatrix", rows, span)?;
                Ok(Expr::new(Node::OfMatrix(MatrixFunction::Determinant, Box::new(inner)), span))
            }
            _ if is_matrix(name) => {
                for (at, row) in rows.iter().enumerate() {
                    let empty = |cell: &Vec<Item>| cell.iter().all(|item| matches!(item.layout, Layout::Space(_)));
                    if let (Some(column), false) = (row.iter().position(empty), self.is_abstract()) {
                        let place = row.iter().flatten().map(|item| item.span).reduce(Span::to).unwrap_or(span);
                        let message = format!("row {} of this matrix is empty in column {}", at + 1, column + 1);
                        return Err(Fault::new(place, message).help("write 0 there, or remove an &"));
                    }
                }
                let rows: Read<Vec<Vec<Expr>>> = rows
                    .iter()
                    .map(|row| row.iter().map(|cell| self.cell(without_stop(cell), span)).collect())
                    .collect();
                let rows = rows?;
                match rows.iter().position(|row| row.len() != rows[0].len()) {
                    Some(at) if !self.is_abstract() => Err(ragged((rows[0].len(), at + 1, rows[at].len()), span)),
                    _ => Ok(Expr::new(Node::Matrix(rows), span)),
                }
            }
            _ => Err(Fault::unsupported(span, format!("the environment {name} is not supported here"))
                .help("write a display for each formula in it")),
        }
    }
}

/// Rejects a group without a formula in it.
fn is_filled(item: &Item, what: &str, span: Span) -> Read<()> {
    let is_space = |item: &Item| matches!(item.layout, Layout::Space(_));
    match contents(item).iter().all(is_space) {
        true => Err(Fault::new(span, format!("{what} is empty")).help("write a formula in it")),
        false => Ok(()),
    }
}

/// A cell without the full stop or the comma at its end.
fn without_stop(cell: &[Item]) -> &[Item] {
    let is_mark = |item: &Item| matches!(item.layout, Layout::Other('.' | ',' | ';') | Layout::Space(_));
    &cell[..cell.iter().rposition(|item| !is_mark(item)).map_or(cell.len(), |at| at + 1)]
}

/// Whether an environment lists cases.
fn is_cases(name: &str) -> bool {
    matches!(name.trim_end_matches('*'), "cases" | "dcases" | "rcases" | "drcases")
}

/// Whether an index fits rows or columns, of which 0 stands for an unknown number.
fn within(index: Index, count: usize) -> bool {
    match index {
        Index::Fixed(value) => count == 0 || usize::from(value) <= count,
        Index::Letter(_) => count == 3,
    }
}

/// Whether a parenthesis holds one derivative: `(\partial S/\partial V)`.
fn is_derivative_in_parentheses(fence: &Item) -> bool {
    let Layout::Fence(_, inside) = &fence.layout else { return false };
    match inside.as_slice() {
        [Item { layout: Layout::Fraction(above, below), .. }] => {
            [above, below].iter().all(|part| starts_differential(part))
        }
        _ => false,
    }
}

/// Whether a parenthesis holds a derivative by the time, with the letters of a frame below it and no place.
fn is_rate_in_a_frame(fence: &Item, below: &Item) -> bool {
    let Layout::Fence(_, inside) = &fence.layout else { return false };
    let [Item { layout: Layout::Fraction(above, by), .. }] = inside.as_slice() else { return false };
    let is_d = |part: &Item| contents(part).first().is_some_and(|first| differential(first).is_some());
    let is_time =
        contents(by).get(1).and_then(|item| names::printed(item, None)).is_some_and(|found| found.name.base == "t");
    let is_place = |item: &Item| matches!(item.layout, Layout::Number(_) | Layout::Other('=' | '<' | '>' | '→'));
    is_d(above) && is_d(by) && is_time && !contents(below).iter().any(is_place)
}

/// Whether names stand apart from each other, as the entries of `[a\ b\ c]` do, and there is nothing else; or anything
/// stands apart by a wide space, `[2u~~v]`.
fn are_entries(items: &[Item]) -> bool {
    let is_space = |item: &Item| matches!(item.layout, Layout::Space(_));
    let is_wide = |at: usize| {
        items[at].layout == Layout::Space(Space::Wide)
            || is_space(&items[at]) && items.get(at + 1).is_some_and(is_space)
    };
    let inner = items.iter().position(|item| !is_space(item)).zip(items.iter().rposition(|item| !is_space(item)));
    let Some((first, last)) = inner else { return false };
    let is_joint = |item: &Item| {
        joint(item).is_some() || matches!(item.layout, Layout::Other('+' | '-' | ',' | ';')) || relation(item).is_some()
    };
    let is_apart = |at: usize| {
        let before = items[first..at].iter().rev().find(|item| !is_space(item));
        let after = items[at..=last].iter().find(|item| !is_space(item));
        is_wide(at) && before.is_some_and(|item| !is_joint(item)) && after.is_some_and(|item| !is_joint(item))
    };
    let is_entry = |entry: &[Item]| match entry {
        [name] | [name, Item { layout: Layout::Fence(Delimiter::Round, _), .. }] => {
            names::printed(name, None).is_some()
        }
        _ => false,
    };
    let entries: Vec<&[Item]> = items.split(is_space).filter(|entry| !entry.is_empty()).collect();
    entries.len() > 1 && entries.iter().all(|entry| is_entry(entry)) || (first..last).any(is_apart)
}

fn no_degree(span: Span) -> Fault {
    Fault::new(span, "the index of a root must be a whole number of at least 2")
        .help("write the root as a power, x^{1/n}")
}

/// A matrix whose `row`-th row has another number of entries than the first one.
fn ragged((first, row, other): (usize, usize, usize), span: Span) -> Fault {
    let entries = |count: usize| if count == 1 { "1 entry".to_owned() } else { format!("{count} entries") };
    let message = format!("row 1 of this matrix has {}, and row {row} has {}", entries(first), entries(other));
    Fault::shape(span, message).help("separate the entries of a row by &, and the rows by \\\\")
}
