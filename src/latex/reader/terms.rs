//! Sums, the terms of a sum, and the factors of a term with the operators between them.

use crate::formula::shape::Shape;
use crate::formula::symbols::{Entry, Kind};
use crate::formula::tree::{Expr, Node, Sign, Term};
use crate::source::{Fault, Span};

use super::super::layout::{Item, Layout};
use super::super::names::{self, unaccented};
use super::functions::written_out;
use super::items::{
    Joint, beside, extent, function_head, is_any_integral, is_big_product, is_big_sum, is_integral, is_limit, joint,
};
use super::state::{Read, Reader};
use super::undeclared::bar;
use super::words::are_no_words;

impl Reader<'_> {
    /// A sum of terms with signs; all of `items`. `end` is the place of a fault if there are no items.
    pub fn sum(&mut self, items: &[Item], end: Span) -> Read<Expr> {
        let whole = extent(items).unwrap_or(end);
        are_no_words(items, self.symbols)?;
        if self.is_abstract()
            && let Some(found) = self.infix(items, whole)?
        {
            return Ok(found);
        }
        if self.is_abstract()
            && let Some(found) = self.unit_of(items)?
        {
            return Ok(found);
        }
        if self.is_abstract()
            && let Some(found) = self.extremum(items, whole)?
        {
            return Ok(found);
        }
        let mut terms: Vec<Term> = Vec::new();
        let mut at = 0;
        let mut pending: Option<(Sign, Span)> = None;
        while at < items.len() {
            if let Some(sign) = self.sign(&items[at])? {
                if let Some((before, first)) = pending {
                    // `a + -b` with a space; `+-` is ± as often.
                    if (before, sign) == (Sign::Plus, Sign::Minus)
                        && first.end < items[at].span.start
                        && !terms.is_empty()
                    {
                        pending = Some((sign, items[at].span));
                        at += 1;
                        continue;
                    }
                    return Err(Fault::new(first.to(items[at].span), "two signs stand side by side"));
                }
                pending = Some((sign, items[at].span));
                at += 1;
                continue;
            }
            let length = self.term_length(&items[at..])?;
            let slice = &items[at..at + length];
            at += length;
            if slice.iter().all(|item| matches!(item.layout, Layout::Space(_))) {
                continue;
            }
            if pending.is_none() && !terms.is_empty() {
                return Err(Fault::new(slice[0].span, "a + or − is missing before this term"));
            }
            let (sign, sign_span) = pending.take().map_or((Sign::Plus, None), |(sign, span)| (sign, Some(span)));
            terms.push(Term { sign, sign_span, expr: self.term(slice)? });
        }
        if let Some((_, span)) = pending {
            return Err(Fault::new(span, "no term follows this sign"));
        }
        if terms.len() > 1
            && let Some(dots) = dots_after_a_factor(items)
        {
            let what = "these dots may stand for further factors or for further terms";
            return Err(Fault::ambiguous(dots, what).help("write + \\dots for terms that are left out"));
        }
        match terms.len() {
            0 => Err(Fault::new(whole, "a formula is missing here")),
            1 if terms[0].sign == Sign::Plus => Ok(terms.remove(0).expr),
            _ => Ok(Expr::new(Node::Sum(terms), whole)),
        }
    }

    fn sign(&self, item: &Item) -> Read<Option<Sign>> {
        Ok(match &item.layout {
            Layout::Other('+') => Some(Sign::Plus),
            Layout::Other('-') => Some(Sign::Minus),
            Layout::Command(name) if name == "\\pm" || name == "\\mp" => {
                let upper = self.branch.ok_or_else(|| {
                    Fault::unsupported(item.span, "± stands for two formulas, and only one is allowed here")
                        .help("write + or −")
                })?;
                Some(if name == "\\pm" { upper } else { upper.flipped() })
            }
            _ => None,
        })
    }

    /// The number of items of the term that starts here: up to a sign that follows no operator.
    fn term_length(&self, items: &[Item]) -> Read<usize> {
        if let Some(integral) = self.integral_length(items).or_else(|| self.definite_length(items)) {
            return Ok(integral.max(integral + self.term_length(items.get(integral..).unwrap_or_default())?));
        }
        let mut after_operator = false;
        for (at, item) in items.iter().enumerate() {
            if self.sign(item)?.is_some() {
                if after_operator {
                    return Err(Fault::new(item.span, "a sign directly follows an operator")
                        .help("put the signed factor in parentheses"));
                }
                return Ok(at);
            }
            if !matches!(item.layout, Layout::Space(_)) {
                after_operator = joint(item).is_some();
            }
        }
        Ok(items.len())
    }

    /// A term: factors and the operators between them; all of `items`.
    pub(super) fn term(&mut self, items: &[Item]) -> Read<Expr> {
        let whole = extent(items).unwrap_or_default();
        if self.is_abstract()
            && let Some(found) = self.infix_product(items, whole)?
        {
            return Ok(found);
        }
        // `f(\cdot)`: any argument.
        if let ([Item { layout: Layout::Command(name), .. }], true) = (items, self.is_abstract())
            && name == "\\cdot"
        {
            return Ok(self.label(items, whole));
        }
        // Factors between one `\cdot` or `\times` and the next stand side by side.
        let mut runs: Vec<(Joint, Vec<Expr>)> = vec![(Joint::Beside, Vec::new())];
        let mut next = Joint::Beside;
        let mut operator: Option<Span> = None;
        let mut after_slash: Option<Span> = None;
        // The span of the last factor if it is a function whose argument nothing encloses.
        let mut open_function: Option<Span> = None;
        let mut cursor = 0;
        while cursor < items.len() {
            let item = &items[cursor];
            if matches!(item.layout, Layout::Space(_)) {
                cursor += 1;
                continue;
            }
            if let Some(found) = joint(item) {
                let empty = runs.last().is_none_or(|(_, run)| run.is_empty());
                if operator.is_some() || empty {
                    return Err(Fault::new(item.span, "a factor is missing before this operator"));
                }
                if found == Joint::Slash {
                    if let Some(function) = open_function {
                        return Err(Fault::ambiguous(
                            function.to(item.span),
                            "\\sin x/y may be (\\sin x)/y or \\sin(x/y)",
                        )
                        .help("put the argument in parentheses, or use \\frac"));
                    }
                    if after_slash.is_some() {
                        return Err(Fault::ambiguous(item.span, "a/b/c may be (a/b)/c or a/(b/c)")
                            .help("use \\frac or parentheses"));
                    }
                }
                next = found;
                operator = Some(item.span);
                cursor += 1;
                continue;
            }
            if let (Joint::Beside, Some(slash)) = (next, after_slash) {
                return Err(Fault::ambiguous(slash.to(item.span), "a/bc may be a/(bc) or (a/b)c")
                    .help("write \\frac{a}{bc} or \\frac{a}{b}c"));
            }
            if let Some(limits) = bar(item) {
                match runs.as_mut_slice() {
                    // A bar with two limits belongs to all before it.
                    [(_, run)] if self.is_abstract() && limits.0.is_some() && limits.1.is_some() && !run.is_empty() => {
                        let inner = beside(std::mem::take(run));
                        let span = inner.span.to(item.span);
                        run.push(self.evaluated(inner, limits, span)?);
                        cursor += 1;
                        continue;
                    }
                    // The bar of a derivative.
                    [.., (_, run)] if self.is_abstract() && cursor > 0 && is_fraction(&items[cursor - 1]) => {
                        let Some(inner) = run.pop() else { continue };
                        let span = inner.span.to(item.span);
                        run.push(self.evaluated(inner, limits, span)?);
                        cursor += 1;
                        continue;
                    }
                    [(_, run)] if run.len() == 1 => {
                        let inner = run.remove(0);
                        let span = inner.span.to(item.span);
                        let found = match self.symbols.infers() {
                            true => self.evaluated(inner, limits, span)?,
                            false => self.at_place(&inner, limits, span)?,
                        };
                        runs = vec![(Joint::Beside, vec![found])];
                        cursor += 1;
                        continue;
                    }
                    _ => {
                        return Err(Fault::ambiguous(
                            item.span,
                            "this bar may belong to one factor or to all before it",
                        )
                        .help("write \\left. before what it belongs to, and \\right| for the bar"));
                    }
                }
            }
            let start = cursor;
            let (factor, enclosed) = self.factor(items, &mut cursor)?;
            let factor = self.with_what_follows(factor, items, &mut cursor)?;
            if matches!(item.layout, Layout::Group(_)) && matches!(factor.node, Node::Sum(_)) && items.len() > 1 {
                return Err(Fault::ambiguous(
                    factor.span,
                    "braces do not print, so {a + b} c may be (a + b) c or a + b c",
                )
                .help("use parentheses"));
            }
            if next == Joint::Beside && !runs.last().is_none_or(|(_, run)| run.is_empty()) {
                self.run_together(items, start)?;
            }
            open_function = (!enclosed).then_some(factor.span);
            if matches!(next, Joint::CDot | Joint::Times) {
                runs.push((next, Vec::new()));
            }
            let Some((_, run)) = runs.last_mut() else { break };
            if next == Joint::Slash {
                let numerator = beside(std::mem::take(run));
                let span = numerator.span.to(factor.span);
                run.push(Expr::new(Node::Quotient(Box::new(numerator), Box::new(factor)), span));
                after_slash = Some(items[start].span);
            } else {
                run.push(factor);
                after_slash = None;
            }
            next = Joint::Beside;
            operator = None;
        }
        if let Some(span) = operator {
            return Err(Fault::new(span, "no factor follows this operator"));
        }
        let product = self.join(runs, whole)?;
        self.has_no_implied_sum(&product)?;
        Ok(product)
    }

    /// Joins runs of factors by `\times` (first) and `\cdot`. Between numbers, both are plain products.
    fn join(&mut self, runs: Vec<(Joint, Vec<Expr>)>, whole: Span) -> Read<Expr> {
        if runs.len() == 1 {
            let mut expr = beside(runs.into_iter().flat_map(|(_, run)| run).collect());
            expr.span = whole;
            return Ok(expr);
        }
        let factors: Vec<Expr> = runs.iter().flat_map(|(_, run)| run.iter().cloned()).collect();
        let mut parts: Vec<(Joint, Expr, bool)> = Vec::new();
        for (joint, run) in runs {
            let expr = beside(run);
            let is_vector = self.shape_of(&expr)? == Shape::Vector;
            parts.push((joint, expr, is_vector));
        }
        if self.is_abstract() && !parts.iter().all(|(_, _, is_vector)| *is_vector) {
            return self.joined(parts, whole);
        }
        let lost = parts.windows(2).find_map(|pair| match pair {
            [(_, number, false), (Joint::Times, _, true)] | [(_, _, true), (Joint::Times, number, false)] => {
                length(number).or_else(|| self.names_a_vector(number))
            }
            _ => None,
        });
        if let Some(span) = lost {
            return Err(Fault::shape(span, "× stands between a number and a vector, and needs two vectors")
                .help("put an arrow on the vector, or write a plain product without ×"));
        }
        self.are_plain_products(&parts)?;
        if parts.iter().filter(|(_, _, is_vector)| *is_vector).count() < 2 {
            return Ok(Expr::new(Node::Product(factors), whole));
        }
        for (joint, make) in [(Joint::Times, Node::Cross as fn(_, _) -> _), (Joint::CDot, Node::Dot as fn(_, _) -> _)] {
            let mut folded: Vec<(Joint, Expr, bool)> = Vec::new();
            let mut previous_was_cross = false;
            for (found, expr, is_vector) in parts {
                match folded.last_mut() {
                    Some(last) if found == joint && last.2 && is_vector => {
                        if previous_was_cross {
                            return Err(Fault::ambiguous(
                                last.1.span.to(expr.span),
                                "a × b × c may be (a × b) × c or a × (b × c)",
                            )
                            .help("use parentheses"));
                        }
                        let span = last.1.span.to(expr.span);
                        let left = std::mem::replace(&mut last.1, Expr::integer(0, span));
                        last.1 = Expr::new(make(Box::new(left), Box::new(expr)), span);
                        last.2 = joint == Joint::Times;
                        previous_was_cross = joint == Joint::Times;
                    }
                    _ => {
                        folded.push((found, expr, is_vector));
                        previous_was_cross = false;
                    }
                }
            }
            parts = folded;
        }
        let mut expr = beside(parts.into_iter().map(|(_, expr, _)| expr).collect());
        expr.span = whole;
        Ok(expr)
    }

    /// Without declarations, × between letters may be the product of two vectors.
    fn are_plain_products(&self, parts: &[(Joint, Expr, bool)]) -> Read<()> {
        let has_letter = |expr: &Expr| !expr.symbols().is_empty();
        let ends = |expr: &Expr| match &expr.node {
            Node::Product(factors) => factors.last().is_some_and(has_letter),
            _ => has_letter(expr),
        };
        let starts = |expr: &Expr| match &expr.node {
            Node::Product(factors) => factors.first().is_some_and(has_letter),
            _ => has_letter(expr),
        };
        let crossed = parts.windows(2).find(|pair| {
            let are_vectors = pair[0].2 && pair[1].2;
            self.symbols.open && pair[1].0 == Joint::Times && !are_vectors && ends(&pair[0].1) && starts(&pair[1].1)
        });
        match crossed {
            Some(pair) => {
                let span = pair[0].1.span.to(pair[1].1.span);
                Err(Fault::ambiguous(span, "× may be a product of numbers or of vectors")
                    .help("for numbers, remove × or write \\cdot; declare vectors in a claims file"))
            }
            None => Ok(()),
        }
    }

    /// The place of a factor with the letter of a vector but without its arrow: the B of `\vec B`.
    fn names_a_vector(&self, number: &Expr) -> Option<Span> {
        match &number.node {
            Node::Product(factors) => factors.iter().find_map(|factor| self.names_a_vector(factor)),
            Node::Symbol { id, .. } => {
                let name = &self.symbols.entry(*id).name;
                let is_its_arrow = |other: &Entry| {
                    let letter = unaccented(&other.name);
                    other.kind == Kind::Vector && letter.base == name.base && letter.subscript == name.subscript
                };
                self.symbols.iter().any(|(_, other)| is_its_arrow(other)).then_some(number.span)
            }
            _ => None,
        }
    }

    /// One factor. The flag is false for a function whose argument has no parentheses.
    pub(super) fn factor(&mut self, items: &[Item], cursor: &mut usize) -> Read<(Expr, bool)> {
        let item = &items[*cursor];
        if let Some(found) = self.raised_operator(items, cursor)? {
            return Ok((found, true));
        }
        if self.is_abstract()
            && let Some(found) = self.abstract_factor(items, cursor)?
        {
            return Ok((found, true));
        }
        if self.symbols.infers() && (is_big_sum(item) || is_big_product(item) || is_limit(item)) {
            let rest = &items[*cursor + 1..];
            *cursor = items.len();
            return Ok((self.unevaluated(item, rest)?, true));
        }
        if self.symbols.infers() && is_any_integral(item) {
            *cursor += 1;
            return Ok((self.unevaluated_integral(item, items, cursor)?, true));
        }
        if self.symbols.infers()
            && let Some(field) = self.nabla(items, cursor)?
        {
            return Ok((field, true));
        }
        if let Some((function, power)) = function_head(item)? {
            *cursor += 1;
            let (call, enclosed) = self.call(function, power, item.span, items, cursor)?;
            return Ok((written_out(item, call), enclosed));
        }
        if let Some(found) = self.algebra(items, cursor)? {
            return Ok((found, true));
        }
        if is_big_sum(item) || is_big_product(item) {
            let rest = &items[*cursor + 1..];
            if let Some(counted) = self.counted(item, rest)? {
                *cursor = items.len();
                return Ok((counted, true));
            }
        }
        if is_big_sum(item) {
            let rest = &items[*cursor + 1..];
            *cursor = items.len();
            return Ok((self.big_sum(item, rest)?, true));
        }
        if is_integral(item) {
            *cursor += 1;
            if let Some(value) = self.definite_integral(item, items, cursor)? {
                return Ok((value, true));
            }
            return Ok((self.integral(item, items, cursor)?, true));
        }
        if is_limit(item) {
            let rest = &items[*cursor + 1..];
            *cursor = items.len();
            return Ok((self.shrinking(item, rest)?, true));
        }
        if let Some(order) = self.derivative_slash(items, *cursor) {
            let span = item.span.to(items[*cursor + 4].span);
            let inner = self.item(&items[*cursor + 1])?;
            *cursor += 5;
            self.is_no_value("this derivative", span, items.get(*cursor).unwrap_or(item))?;
            return Ok((Expr::new(Node::TimeDerivative(order, Box::new(inner)), span), true));
        }
        if let Layout::Fraction(numerator, denominator) = &item.layout
            && let Some((order, rest)) = self.derivative(numerator, denominator)?
        {
            *cursor += 1;
            if !rest.is_empty() {
                self.is_no_value("this derivative", item.span, items.get(*cursor).unwrap_or(item))?;
                let inner = self.sum(rest, item.span)?;
                return Ok((Expr::new(Node::TimeDerivative(order, Box::new(inner)), item.span), true));
            }
            let inner = self.operand(items, cursor, item.span)?;
            let span = item.span.to(inner.span);
            return Ok((Expr::new(Node::TimeDerivative(order, Box::new(inner)), span), true));
        }
        if let Layout::Fraction(numerator, denominator) = &item.layout
            && let Some(operator) = self.operator(numerator, denominator, item.span)?
        {
            *cursor += 1;
            return Ok((self.apply(&operator, items, cursor)?, true));
        }
        if let Some(operator) = self.operator_on_one_line(items, cursor)? {
            return Ok((self.apply(&operator, items, cursor)?, true));
        }
        if let Some(derivative) = self.subscripted(items, cursor)? {
            return Ok((derivative, true));
        }
        if let Some(compound) = self.compound(items, cursor)? {
            return Ok((compound, true));
        }
        *cursor += 1;
        if let Some(printed) = names::printed(item, self.branch) {
            return Ok((self.symbol(item.span, printed, items, cursor)?, true));
        }
        Ok((self.item(item)?, true))
    }
}

fn is_fraction(item: &Item) -> bool {
    matches!(item.layout, Layout::Fraction(..))
}

/// The place of a factor that is the norm of a vector, or a derivative of one.
fn length(number: &Expr) -> Option<Span> {
    match &number.node {
        Node::Product(factors) => factors.iter().find_map(length),
        Node::TimeDerivative(_, inner) => length(inner).map(|_| number.span),
        Node::Norm(_) => Some(number.span),
        _ => None,
    }
}

/// Where dots stand directly after a factor at the end: `a_1 x + a_2 x^2 \dots`.
fn dots_after_a_factor(items: &[Item]) -> Option<Span> {
    let mut last = items.iter().rev().filter(|item| !matches!(item.layout, Layout::Space(_)));
    let dots = last.next().filter(|item| matches!(&item.layout, Layout::Command(name) if name == "\\dots"))?;
    let is_sign = |item: &Item| matches!(item.layout, Layout::Other(_)) || joint(item).is_some();
    last.next().filter(|before| !is_sign(before)).map(|_| dots.span)
}
