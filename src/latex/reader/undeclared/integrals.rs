//! Integrals in formulas without declarations: `\int_a^b f\,dx`, `\int \frac{dx}{x}`, `\oint \vec F \cdot d\vec l`.
//!
//! An integral reaches to its differential, and if that is first, or in a fraction, to the end of the term. The
//! differential is a factor of the integrand.

use crate::formula::symbols::Operator;
use crate::formula::tree::Expr;
use crate::source::{Fault, Span};

use super::super::super::layout::{Item, Layout, contents};
use super::super::super::names;
use super::super::super::typeset;
use super::super::items::{
    beside, differential, differential_of_many, extent, is_any_integral, is_big_product, is_big_sum, is_integral, joint,
};
use super::super::state::{Read, Reader};
use super::super::structure::printed;
use super::simple_text;

impl Reader<'_> {
    /// An integral; the cursor is after its sign.
    pub(in super::super) fn unevaluated_integral(
        &mut self,
        sign: &Item,
        items: &[Item],
        cursor: &mut usize,
    ) -> Read<Expr> {
        let (nucleus, below, above) = match &sign.layout {
            Layout::Scripts { nucleus, sub, sup, .. } => (&**nucleus, sub.as_deref(), sup.as_deref()),
            _ => (sign, None, None),
        };
        let Layout::Command(command) = &nucleus.layout else {
            return Err(
                Fault::unsupported(sign.span, "this integral is not supported").help("write the equation without it")
            );
        };
        let mut name = command.clone();
        for (mark, limit) in [("_", below), ("^", above)] {
            let Some(limit) = limit else { continue };
            let text = match simple_text(contents(limit)) {
                Some(text) => text,
                None if self.is_abstract() => printed(contents(limit)),
                None => {
                    let read = self.item(limit)?;
                    typeset(&read, self.symbols)
                }
            };
            name.push_str(&format!("{mark}{{{text}}}"));
        }
        let rest = &items[*cursor..];
        let whole = extent(rest).map_or(sign.span, |rest| sign.span.to(rest));
        let outer = std::mem::replace(&mut self.symbols.inferred.differentials, true);
        let body = self.integrand(rest, cursor, whole);
        self.symbols.inferred.differentials = outer;
        let body = body?;
        let span = sign.span.to(body.span);
        Ok(self.operate(&name, Operator::Same, vec![body], span))
    }

    fn integrand(&mut self, rest: &[Item], cursor: &mut usize, whole: Span) -> Read<Expr> {
        let blank = |items: &[Item]| items.iter().all(|item| matches!(item.layout, Layout::Space(_)));
        match own_differential(rest) {
            Some(at) if !blank(&rest[..at]) => {
                let end = at
                    + 1
                    + rest[at + 1..].iter().take_while(|item| matches!(item.layout, Layout::Space(_))).count()
                    + 1;
                // `\iint f\,du\,dv`: all that follow one another, where no outer integral has one of them.
                let end = end_of_differentials(rest, end.min(rest.len()));
                *cursor += end;
                let last = rest[..at].iter().rev().find(|item| !matches!(item.layout, Layout::Space(_)));
                let is_open = |last: &Item| joint(last).is_some() || is_big_product(last) || is_big_sum(last);
                if last.is_some_and(is_open) {
                    // `\int \prod_i dx_i\, e^{-S}`: the product of the differentials ends before the integrand.
                    if last.is_some_and(is_big_product) && !blank(&rest[end..]) {
                        return Err(Fault::ambiguous(
                            whole,
                            "the product of the differentials may end at more than one place",
                        )
                        .help(
                            "write the product of the differentials in parentheses, or put the integrand before it",
                        ));
                    }
                    return self.term(&rest[..end]);
                }
                let integrand = self.sum(&rest[..at], whole)?;
                let element = self.term(&rest[at..end])?;
                Ok(beside(vec![integrand, element]))
            }
            Some(_) => {
                *cursor += rest.len();
                self.term(rest)
            }
            None if rest.iter().any(has_differential) => {
                *cursor += rest.len();
                self.term(rest)
            }
            None => {
                // The measure is no differential, `\\int \\mathcal D[q] \\, e^{iS}`.
                if self.is_abstract() && !blank(rest) {
                    *cursor += rest.len();
                    return self.term(rest);
                }
                Err(Fault::new(whole, "this integral has no differential")
                    .help("end the integral with dx, and put an integrand with several terms in parentheses"))
            }
        }
    }

    /// The number of items of a term that begins with integrals and whose integrand is a sum without parentheses:
    /// `\int a + b\,dx`.
    pub(in super::super) fn integral_length(&self, items: &[Item]) -> Option<usize> {
        if !self.symbols.infers() {
            return None;
        }
        let is_sign = |item: &Item| match &item.layout {
            Layout::Other(c) => matches!(c, '+' | '-'),
            Layout::Command(name) => name == "\\pm" || name == "\\mp",
            _ => false,
        };
        let first = items.iter().position(is_sign)?;
        let at = items[..first].iter().position(is_any_integral)?;
        let end = own_differential(&items[at + 1..])? + at + 1;
        (first < end).then_some(end + 1)
    }
}

impl Reader<'_> {
    /// Rejects an integral without limits over a space whose measure is first, `\int d^4x\, a + b`: the sum may be the
    /// integrand.
    pub(in super::super) fn is_no_open_integrand(&self, items: &[Item]) -> Read<()> {
        let mut solid = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
        let (Some(sign), Some(measure)) = (solid.next(), solid.next()) else { return Ok(()) };
        let is_open = is_integral(sign) && !matches!(sign.layout, Layout::Scripts { .. });
        let is_of_space =
            differential_of_many(measure).is_some() || differential(measure).is_some_and(|order| order > 1);
        let plus = items.iter().position(|item| matches!(item.layout, Layout::Other('+' | '-')));
        match plus {
            Some(at) if is_open && is_of_space && !items[at..].iter().any(is_any_integral) => {
                Err(Fault::ambiguous(sign.span.to(items[at].span), "the sum after this integral may be a part of it")
                    .help("put what is integrated in parentheses"))
            }
            _ => Ok(()),
        }
    }
}

/// The position of the differential of the integral before these items: inner integrals have their own before it.
fn own_differential(rest: &[Item]) -> Option<usize> {
    let mut inner = 0_usize;
    for (at, item) in rest.iter().enumerate() {
        inner += usize::from(is_integral(item));
        let next = rest[at + 1..].iter().find(|item| !matches!(item.layout, Layout::Space(_)));
        let is_own = (differential(item).is_some() || differential_of_many(item).is_some())
            && next.is_some_and(|next| names::printed(next, None).is_some());
        match (is_own, has_differential(item), inner) {
            (true, _, 0) => return Some(at),
            // The integral ends in a fraction.
            (false, true, 0) => return None,
            (true, ..) | (_, true, _) => inner -= 1,
            (false, false, _) => {}
        }
    }
    None
}

/// Where the differentials end of which the first ends here.
fn end_of_differentials(rest: &[Item], first: usize) -> usize {
    let mut end = first;
    loop {
        let spaces =
            |from: usize| rest[from..].iter().take_while(|item| matches!(item.layout, Layout::Space(_))).count();
        let at = end + spaces(end);
        let is_differential =
            rest.get(at).is_some_and(|item| differential(item).is_some() || differential_of_many(item).is_some());
        let name = if is_differential { at + 1 + spaces(at + 1) } else { rest.len() };
        match rest.get(name) {
            Some(next) if names::printed(next, None).is_some() => end = name + 1,
            _ => return end,
        }
    }
}

/// Whether a differential stands in the numerator of a fraction, alone or as a factor.
fn has_differential(item: &Item) -> bool {
    let Layout::Fraction(above, below) = &item.layout else { return false };
    let d = |items: &[Item]| {
        items.iter().enumerate().any(|(at, item)| {
            differential(item).is_some() && items.get(at + 1).is_some_and(|next| names::printed(next, None).is_some())
        })
    };
    d(contents(above)) && !d(contents(below))
}
