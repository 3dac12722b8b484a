//! A term: factors, the operators between them, and the products that they make.

use crate::formula::shape::Shape;
use crate::formula::symbols::{Entry, Kind};
use crate::formula::tree::{Expr, Node};
use crate::source::{Fault, Span};

use super::super::layout::{Item, Layout, typed};
use super::super::names::unaccented;
use super::items::{Joint, beside, extent, joint};
use super::slashes;
use super::state::{Read, Reader};
use super::undeclared::{bar, bound, unclear_reach};

/// A term as far as it was read.
struct Factors {
    /// The factors between one `\cdot` or `\times` and the next stand side by side.
    runs: Vec<(Joint, Vec<Expr>)>,
    /// What stands before the next factor.
    next: Joint,
    /// The place of the operator before it, if it is printed.
    operator: Option<Span>,
    /// The factor after a slash, if it is the last one.
    after_slash: Option<Span>,
    /// The span of the last factor if it is a function whose argument nothing encloses.
    open_function: Option<Span>,
}

impl Factors {
    fn new() -> Self {
        let runs = vec![(Joint::Beside, Vec::new())];
        Factors { runs, next: Joint::Beside, operator: None, after_slash: None, open_function: None }
    }

    /// Whether no factor stands after the last `\cdot` or `\times`.
    fn is_empty(&self) -> bool {
        self.runs.last().is_none_or(|(_, run)| run.is_empty())
    }

    /// Takes the operator before the next factor.
    fn join(&mut self, found: Joint, items: &[Item], at: usize) -> Read<()> {
        let span = items[at].span;
        if self.operator.is_some() || self.is_empty() {
            let operator = typed(&items[at..=at]);
            return Err(Fault::new(span, format!("a factor is missing before this {operator}"))
                .help(format!("write the factor, or remove the {operator}")));
        }
        if found == Joint::Slash {
            if let Some(function) = self.open_function {
                return Err(slashes::after_a_function(items, function, at));
            }
            if self.after_slash.is_some() {
                return Err(slashes::two(items, at));
            }
        }
        self.next = found;
        self.operator = Some(span);
        Ok(())
    }

    /// Takes a factor of the denominator after a slash.
    fn divide(&mut self, factor: Expr) {
        let quotient = self.runs.last_mut().and_then(|(_, run)| run.last_mut());
        if let Some(Expr { node: Node::Quotient(_, below), span }) = quotient {
            *span = span.to(factor.span);
            let first = std::mem::replace(below.as_mut(), Expr::integer(1, factor.span));
            **below = beside(vec![first, factor]);
        }
        self.after_slash = None;
    }

    /// Takes a factor, which begins with the item at `first`.
    fn push(&mut self, factor: Expr, first: Span) {
        if matches!(self.next, Joint::CDot | Joint::Times) {
            self.runs.push((self.next, Vec::new()));
        }
        let Some((_, run)) = self.runs.last_mut() else { return };
        if self.next == Joint::Slash {
            let numerator = beside(std::mem::take(run));
            let span = numerator.span.to(factor.span);
            run.push(Expr::new(Node::Quotient(Box::new(numerator), Box::new(factor)), span));
            self.after_slash = Some(first);
        } else {
            run.push(factor);
            self.after_slash = None;
        }
        self.next = Joint::Beside;
        self.operator = None;
    }
}

impl Reader<'_> {
    /// A term: factors and the operators between them; all of `items`.
    pub(super) fn term(&mut self, items: &[Item]) -> Read<Expr> {
        let whole = extent(items).unwrap_or_default();
        if self.is_abstract()
            && let Some(fault) = unclear_reach(items)
        {
            return Err(fault);
        }
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
        let mut factors = Factors::new();
        let mut cursor = 0;
        while cursor < items.len() {
            let item = &items[cursor];
            if matches!(item.layout, Layout::Space(_)) {
                cursor += 1;
                continue;
            }
            if self.symbols.open || self.symbols.guessed {
                self.is_a_clear_factor(items, cursor)?;
            }
            if let Some(found) = joint(item) {
                if factors.after_slash.is_some() && slashes::is_before_a_power_of_ten(items, cursor) {
                    return Err(slashes::by_a_power_of_ten(item.span));
                }
                factors.join(found, items, cursor)?;
                cursor += 1;
                continue;
            }
            let infers = self.symbols.open || self.symbols.guessed;
            if infers && factors.next == Joint::Beside && slashes::is_over_turns(items, cursor) {
                let (factor, _) = self.factor(items, &mut cursor)?;
                factors.divide(factor);
                continue;
            }
            if let (Joint::Beside, Some(slash)) = (factors.next, factors.after_slash) {
                return Err(slashes::before_a_product(items, slash.to(item.span), cursor));
            }
            if let Some(limits) = bar(item) {
                let before = cursor.checked_sub(1).map(|before| &items[before]);
                self.apply_bar(&mut factors.runs, (item, limits), before)?;
                cursor += 1;
                continue;
            }
            let start = cursor;
            let (factor, enclosed) = self.factor(items, &mut cursor)?;
            let factor = self.with_what_follows(factor, items, &mut cursor)?;
            if infers {
                bound::ends_with_its_factor(&items[start..cursor], &items[cursor..])?;
            }
            if matches!(item.layout, Layout::Group(_)) && matches!(factor.node, Node::Sum(_)) && items.len() > 1 {
                return Err(Fault::ambiguous(
                    factor.span,
                    "braces do not print, so {a + b} c may be (a + b) c or a + b c",
                )
                .help("use parentheses"));
            }
            if factors.next == Joint::Beside && !factors.is_empty() {
                self.run_together(items, start)?;
            }
            factors.open_function = (!enclosed).then_some(factor.span);
            factors.push(factor, items[start].span);
        }
        if let Some(span) = factors.operator {
            let operator = items.iter().filter(|item| item.span == span).cloned().collect::<Vec<_>>();
            let operator = typed(&operator);
            return Err(Fault::new(span, format!("a factor is missing after this {operator}"))
                .help(format!("write the factor, or remove the {operator}")));
        }
        let product = self.join(factors.runs, whole)?;
        self.has_no_implied_sum(&product)?;
        Ok(product)
    }

    /// Takes the value of what stands before the bar of an evaluation: of all of it, or of a derivative directly before the bar.
    fn apply_bar(
        &mut self,
        runs: &mut [(Joint, Vec<Expr>)],
        (item, limits): (&Item, (Option<&Item>, Option<&Item>)),
        before: Option<&Item>,
    ) -> Read<()> {
        match runs {
            // A bar with two limits belongs to all before it.
            [(_, run)] if self.is_abstract() && limits.0.is_some() && limits.1.is_some() && !run.is_empty() => {
                let inner = beside(std::mem::take(run));
                let span = inner.span.to(item.span);
                run.push(self.evaluated(inner, limits, span)?);
            }
            // The bar of a derivative.
            [.., (_, run)] if self.is_abstract() && !run.is_empty() && before.is_some_and(is_fraction) => {
                let Some(inner) = run.pop() else { return Ok(()) };
                let span = inner.span.to(item.span);
                run.push(self.evaluated(inner, limits, span)?);
            }
            [(_, run)] if run.len() == 1 => {
                let inner = run.remove(0);
                let span = inner.span.to(item.span);
                run.push(match self.symbols.infers() {
                    true => self.evaluated(inner, limits, span)?,
                    false => self.at_place(&inner, limits, span)?,
                });
            }
            _ => {
                return Err(Fault::ambiguous(
                    item.span,
                    "the bar may belong to one factor, or to all factors before it",
                )
                .help("write \\left. before the factors to which the bar belongs, and \\right| for the bar"));
            }
        }
        Ok(())
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
