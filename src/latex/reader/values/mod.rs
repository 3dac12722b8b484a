//! Sums, integrals and bars that have a value: each is read as a formula without Σ, ∫ and bars. Units after numbers, and
//! terms that are left out.
//!
//! | file | what is read there |
//! | --- | --- |
//! | `sums` | `\sum_{k=1}^{n} k^2`, `\prod_{k=1}^{3} k`, `\sum_{k=0}^{\infty} x^k` over letters that are no declared indices |
//! | `integrals` | `\int_0^a x\,dx`, `\int_0^\infty e^{-ax}\,dx` |
//! | `rests` | `+ \dots`, `+ O(x^3)` |
//! | `units` | units after numbers |
//! | `bars` | `\left. f \right|_{x=a}`, `[F]_a^b` |
//!
//! The letter of a sum or an integral is a number of its own while its body is read, unless it is a declared number:
//! then names that a formula defines by it are written out.
//!
//! Offers methods of the reader. Knows the layout, the state of the reader, and the calculus of `formula`.

mod bars;
mod integrals;
mod rests;
mod sums;
mod units;

pub(super) use bars::Place;

use crate::formula::SymbolId;
use crate::formula::calculus::places::{at, depends_on};
use crate::formula::derivative::{self, Scope};
use crate::formula::symbols::{Kind, Name};
use crate::formula::tree::{Expr, Node};
use crate::source::{Fault, Span};

use super::super::layout::{Item, Layout, contents};
use super::super::names;
use super::state::{Read, Reader};

/// The deepest chain of definitions that is written out.
const DEEPEST: usize = 20;

/// The advice where a value cannot be computed.
const IN_A_DISPLAY: &str = "write the value of the integral or the sum in a display of its own";

/// A letter that a sum or an integral binds.
pub(super) struct Bound {
    pub id: SymbolId,
    /// Its name, and the symbol that had it before; `None` for a declared number.
    released: Option<(Name, Option<SymbolId>)>,
}

impl Reader<'_> {
    /// Binds the letter that an item prints.
    pub(super) fn bind(&mut self, item: &Item) -> Read<Bound> {
        let wanted = || {
            Fault::new(item.span, "a sum or an integral needs a letter as its variable")
                .help("write a letter without a dot or a power, as in \\sum_{k=1}^{n} or dx")
        };
        let printed = names::printed(item, None).ok_or_else(wanted)?;
        if printed.dots > 0 || printed.sup.is_some() {
            return Err(wanted());
        }
        if let Some((id, indices)) = self.symbols.find(&printed.name) {
            let entry = self.symbols.entry(id);
            let is_number = entry.kind == Kind::Scalar && indices.is_empty() && entry.slots.is_empty();
            let is_free = entry.definition.is_none() && !entry.derived && !entry.squared && entry.operator.is_none();
            if is_number && is_free {
                return Ok(Bound { id, released: None });
            }
        }
        let (id, before) = self.symbols.bind(&printed.name);
        Ok(Bound { id, released: Some((printed.name, before)) })
    }

    /// Ends the life of a bound letter.
    pub(super) fn release(&mut self, bound: &Bound) {
        if let Some((name, before)) = &bound.released {
            self.symbols.release(name, *before);
        }
    }

    /// A formula in which no definition, no rate and no vector hides the letter.
    pub(super) fn written_out(&self, body: &Expr, letter: SymbolId) -> Read<Expr> {
        let mut body = self.with_rates_formed(body, letter);
        let hidden = |id: SymbolId, depth: usize| self.hides(id, letter, depth);
        let mut depth = 0;
        while body.symbols().iter().any(|(id, _)| hidden(*id, 0)) {
            depth += 1;
            if depth > DEEPEST {
                return Err(unclear(body.span, "the definition of a name in it contains this name"));
            }
            let span = body.span;
            body.substitute(&|node| match node {
                Node::Symbol { id, dots: 0, indices } if indices.is_empty() && hidden(*id, 0) => {
                    let mut formula = self.symbols.entry(*id).definition.as_ref()?.as_ref().clone();
                    formula.move_to(span);
                    Some(formula)
                }
                _ => None,
            });
            body = self.with_rates_formed(&body, letter);
        }
        let entry = self.symbols.entry(letter);
        let is_time = self.symbols.time.as_ref() == Some(&entry.name);
        let mut fault = None;
        let by = entry.name.to_string();
        let unknown = |span: Span, what: &str| {
            Fault::unsupported(span, format!("it is not known how {what} depends on {by}"))
                .help(format!("write {what} as a formula of {by} in a display before this one"))
        };
        body.walk(&mut |part| match &part.node {
            Node::Symbol { id, dots, .. } => {
                let other = self.symbols.entry(*id);
                if *dots > 0 {
                    fault.get_or_insert_with(|| unknown(part.span, &format!("the time derivative of {}", other.name)));
                } else if is_time && *id != letter && other.varies && !other.steady {
                    fault.get_or_insert_with(|| unknown(part.span, &other.name.to_string()));
                } else if *id != letter && other.definition.is_none() && other.derived
                    || other.unread && other.name.mentions(&entry.name.base)
                {
                    fault.get_or_insert_with(|| unknown(part.span, &other.name.to_string()));
                }
            }
            Node::TimeDerivative(..) => {
                fault.get_or_insert_with(|| unknown(part.span, "this time derivative"));
            }
            Node::Integral(..) | Node::Shrinking(..) | Node::Apply(..) if depends_on(part, letter) => {
                let what = "an integral or a function inside an integral, a sum or a value at a place is not supported";
                fault.get_or_insert_with(|| Fault::unsupported(part.span, what).help(IN_A_DISPLAY));
            }
            _ => {}
        });
        fault.map_or(Ok(body), Err)
    }

    /// A formula in which the rates of what the time gives a value are formulas of the time, where the letter is the time.
    fn with_rates_formed(&self, body: &Expr, letter: SymbolId) -> Expr {
        let mut body = body.clone();
        if self.symbols.time.as_ref() != Some(&self.symbols.entry(letter).name) {
            return body;
        }
        let (span, scope) = (body.span, Scope { symbols: self.symbols, fixed: &[] });
        body.substitute(&|node| {
            let (order, mut formed) = match node {
                Node::Symbol { id, indices, dots } if *dots > 0 && self.hides(*id, letter, 0) => {
                    (*dots, Expr::new(Node::Symbol { id: *id, indices: indices.clone(), dots: 0 }, span))
                }
                Node::TimeDerivative(order, inner) => (*order, inner.as_ref().clone()),
                _ => return None,
            };
            for _ in 0..order {
                formed = derivative::rate(&formed, scope, span).ok()?;
            }
            // What still has a rate is no formula of the time alone.
            formed.symbols().iter().all(|(_, dots)| *dots == 0).then_some(formed)
        });
        body
    }

    /// Refuses what contains a function without a formula. A polynomial stands for it, and what holds for the sum or
    /// the integral of every such polynomial need not hold for every function.
    pub(super) fn without_any_function(&self, body: &Expr) -> Read<()> {
        let is_coefficient = |(id, _): &(SymbolId, u8)| self.symbols.entry(*id).coefficient.is_some();
        match body.symbols().iter().any(is_coefficient) {
            true => Err(unclear(body.span, "a function in it is declared without a formula")),
            false => Ok(()),
        }
    }

    /// The function without a formula of which this is the derivative by the letter.
    pub(super) fn antiderivative(&self, body: &Expr, letter: SymbolId) -> Option<Expr> {
        let by = Expr::new(Node::Symbol { id: letter, indices: Vec::new(), dots: 0 }, body.span);
        self.symbols.iter().find_map(|(_, entry)| {
            let ([argument], [derivative]) = (entry.arguments.as_slice(), entry.derivatives.as_slice()) else {
                return None;
            };
            let rate = self.symbols.entry(*derivative).definition.as_ref()?;
            let is_plain = argument.indices.is_empty() && argument.dots == 0;
            let is_rate = is_plain && at(rate, argument.id, &by) == *body;
            entry.definition.as_ref().filter(|_| is_rate).map(|whole| at(whole, argument.id, &by))
        })
    }

    /// Whether a definition contains a letter.
    pub(super) fn hides(&self, id: SymbolId, letter: SymbolId, depth: usize) -> bool {
        let Some(formula) = &self.symbols.entry(id).definition else { return false };
        id != letter
            && depth < DEEPEST
            && formula.symbols().iter().any(|(inner, _)| *inner == letter || self.hides(*inner, letter, depth + 1))
    }

    /// A limit: ±∞, or a formula.
    pub(super) fn end(&mut self, item: &Item) -> Read<crate::formula::calculus::places::End> {
        use crate::formula::calculus::places::End;
        let is_infinity = |item: &Item| matches!(&item.layout, Layout::Command(name) if name == "\\infty");
        let items: Vec<&Item> = contents(item).iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
        Ok(match items.as_slice() {
            [only] if is_infinity(only) => End::Infinity,
            [Item { layout: Layout::Other('+'), .. }, only] if is_infinity(only) => End::Infinity,
            [Item { layout: Layout::Other('-'), .. }, only] if is_infinity(only) => End::MinusInfinity,
            _ => End::At(self.sum(contents(item), item.span)?),
        })
    }
}

fn unclear(span: Span, why: &str) -> Fault {
    Fault::unsupported(span, format!("this sum or integral cannot be evaluated, because {why}")).help(IN_A_DISPLAY)
}
