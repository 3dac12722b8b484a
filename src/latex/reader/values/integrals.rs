//! Definite integrals in one variable: `\int_0^a x\,dx`, `\int_0^\infty \frac{dx}{x^2 + a^2}`, `\int_a^b dx\, f`.
//!
//! An integral reaches to its differential. If that is first, or in a fraction, it reaches to the end of the term.

use crate::formula::SymbolId;
use crate::formula::calculus::NoFormula;
use crate::formula::calculus::definite::integral;
use crate::formula::calculus::places::{End, at, depends_on};
use crate::formula::symbols::Name;
use crate::formula::tree::{Definite, Expr, Node};
use crate::source::{Fault, Span};

use super::super::super::layout::{Item, Layout, contents};
use super::super::super::names;
use super::super::items::{differential, is_integral};
use super::super::state::{Read, Reader};
use super::sums::as_step;

/// What is integrated, and the items that the integral takes.
struct Parts {
    integrand: Vec<Item>,
    variable: Item,
    taken: usize,
}

impl Reader<'_> {
    /// A definite integral; the cursor is after its sign. `None` for one over a declared continuum.
    pub(in super::super) fn definite_integral(
        &mut self,
        sign: &Item,
        items: &[Item],
        cursor: &mut usize,
    ) -> Read<Option<Expr>> {
        let Layout::Scripts { sub: Some(below), sup: Some(above), primes: 0, .. } = &sign.layout else {
            return Ok(None);
        };
        let rest = &items[*cursor..];
        let missing = || {
            Fault::new(sign.span, "this integral has no differential")
                .help("end the integral with dx, and put an integrand with several terms in parentheses")
        };
        // Where d is a symbol, an upright d is the differential, and else the only d that there is.
        let is_name = self.symbols.find(&Name::plain("d")).is_some() && !self.symbols.open;
        let is_upright = is_name && rest.iter().any(|item| is_upright(item) || above_line(item).any(is_upright));
        let Parts { integrand, variable, taken } = parts(rest, is_upright).ok_or_else(missing)?;
        if is_name && !is_upright && count_of_d(&rest[..taken]) > 1 {
            return Err(Fault::ambiguous(variable.span, "d may be a differential or the declared symbol d")
                .help("write \\mathrm{d} for the differential"));
        }
        *cursor += taken;
        let span = rest[..taken].iter().fold(sign.span, |span, item| span.to(item.span));
        let ends = (self.end(below)?, self.end(above)?);
        let bound = self.bind(&variable)?;
        let body = self.sum(&integrand, span);
        self.release(&bound);
        let body = self.written_out(&body?, bound.id)?;
        if let (Some(whole), End::At(lower), End::At(upper)) = (self.antiderivative(&body, bound.id), &ends.0, &ends.1)
        {
            let mut value = at(&whole, bound.id, upper).minus(at(&whole, bound.id, lower));
            value.move_to(span);
            return Ok(Some(as_step(value)));
        }
        self.without_any_function(&body)?;
        let found = integral(&body, bound.id, (&ends.0, &ends.1), span);
        match found {
            Ok(formula) => Ok(Some(as_step(formula))),
            Err(reason) => by_quadrature(&body, (bound.id, &self.symbols.entry(bound.id).name.to_string()), ends, span)
                .filter(|_| reason == NoFormula::Unknown)
                .map(Some)
                .ok_or_else(|| refused(reason, sign.span.to(span))),
        }
    }

    /// The number of items of a term that begins with an integral whose integrand is a sum without parentheses.
    pub(in super::super) fn definite_length(&self, items: &[Item]) -> Option<usize> {
        let is_sign = |item: &Item| matches!(item.layout, Layout::Other('+' | '-'));
        let begins = |item: &Item| matches!(item.layout, Layout::Scripts { .. }) && is_integral(item);
        // No further than the term: a long sum has many of them.
        let at = items.iter().position(|item| is_sign(item) || begins(item))?;
        if is_sign(&items[at]) {
            return None;
        }
        let found = own_differential(&items[at + 1..], false)?;
        let before = &items[at + 1..at + 1 + found];
        before.iter().any(is_sign).then_some(at + 1 + found + 2)
    }
}

/// The items of an integral.
fn parts(rest: &[Item], upright: bool) -> Option<Parts> {
    let blank = |items: &[Item]| items.iter().all(|item| matches!(item.layout, Layout::Space(_)));
    if let Some(at) = own_differential(rest, upright) {
        let spaces = rest[at + 1..].iter().take_while(|item| matches!(item.layout, Layout::Space(_))).count();
        let variable = rest.get(at + 1 + spaces)?.clone();
        let end = at + 2 + spaces;
        let one = || vec![Item { layout: Layout::Number("1".to_owned()), span: rest[at].span }];
        return Some(match (blank(&rest[..at]), blank(&rest[end..])) {
            (true, true) => Parts { integrand: one(), variable, taken: end },
            (true, false) => Parts { integrand: rest[end..].to_vec(), variable, taken: rest.len() },
            (false, _) => Parts { integrand: rest[..at].to_vec(), variable, taken: end },
        });
    }
    let (at, above, below) = rest.iter().enumerate().find_map(|(at, item)| match &item.layout {
        Layout::Fraction(above, below) => Some((at, above, below)),
        _ => None,
    })?;
    let above_items = contents(above);
    let d = own_differential(above_items, upright)?;
    let spaces = above_items[d + 1..].iter().take_while(|item| matches!(item.layout, Layout::Space(_))).count();
    let variable = above_items.get(d + 1 + spaces)?.clone();
    let mut left: Vec<Item> = above_items[..d].iter().chain(&above_items[d + 2 + spaces..]).cloned().collect();
    if blank(&left) {
        left = vec![Item { layout: Layout::Number("1".to_owned()), span: above.span }];
    }
    let above = Item { layout: Layout::Group(left), span: above.span };
    let mut integrand = rest.to_vec();
    integrand[at].layout = Layout::Fraction(Box::new(above), below.clone());
    Some(Parts { integrand, variable, taken: rest.len() })
}

/// The position of the differential of the integral before these items; inner integrals have their own before it. It may
/// have to be upright.
fn own_differential(rest: &[Item], upright: bool) -> Option<usize> {
    let mut inner = 0_usize;
    for (at, item) in rest.iter().enumerate() {
        inner += usize::from(is_integral(item));
        let next = rest[at + 1..].iter().find(|item| !matches!(item.layout, Layout::Space(_)));
        let is_own = differential(item) == Some(1)
            && (!upright || is_upright(item))
            && next
                .and_then(|next| names::printed(next, None))
                .is_some_and(|name| name.sup.is_none() && name.dots == 0);
        match (is_own, inner) {
            (true, 0) => return Some(at),
            (true, _) => inner -= 1,
            (false, _) => {}
        }
    }
    None
}

/// Whether an item is an upright d.
fn is_upright(item: &Item) -> bool {
    differential(item) == Some(1) && matches!(item.layout, Layout::Style(..))
}

/// The items above the line of a fraction.
fn above_line(item: &Item) -> impl Iterator<Item = &Item> {
    match &item.layout {
        Layout::Fraction(above, _) => contents(above),
        _ => &[],
    }
    .iter()
}

/// How often the letter d stands in items as a name of its own.
fn count_of_d(items: &[Item]) -> usize {
    let inside = |item: &Item| match &item.layout {
        Layout::Letter('d') => 1,
        Layout::Group(items) | Layout::Fence(_, items) => count_of_d(items),
        Layout::Fraction(above, below) => count_of_d(contents(above)) + count_of_d(contents(below)),
        Layout::Scripts { nucleus, sup, .. } => {
            count_of_d(contents(nucleus)) + sup.as_ref().map_or(0, |sup| count_of_d(contents(sup)))
        }
        Layout::Root(_, inner) => count_of_d(contents(inner)),
        _ => 0,
    };
    items.iter().map(inside).sum()
}

/// An integral whose value is found by quadrature. One inside it that contains its letter would take too long.
fn by_quadrature(
    body: &Expr,
    (letter, name): (SymbolId, &str),
    (lower, upper): (End, End),
    span: Span,
) -> Option<Expr> {
    let mut is_double = false;
    body.walk(&mut |part| is_double |= matches!(part.node, Node::Definite(_)) && depends_on(part, letter));
    let place = |end: End| match end {
        End::At(place) => Some(place),
        End::Infinity | End::MinusInfinity => None,
    };
    let is_backwards = lower == End::Infinity || upper == End::MinusInfinity;
    if is_double || is_backwards || place(lower.clone()).is_none() && lower == upper {
        return None;
    }
    let own = Expr::new(Node::Letter(name.to_owned()), span);
    let of = Definite {
        letter: name.to_owned(),
        lower: place(lower),
        upper: place(upper),
        integrand: at(body, letter, &own),
    };
    Some(Expr::new(Node::Definite(Box::new(of)), span))
}

fn refused(reason: NoFormula, span: Span) -> Fault {
    let what = match reason {
        NoFormula::Unknown => "no antiderivative of this integrand is known, so the integral cannot be evaluated",
        NoFormula::Diverges => "this integral diverges, or cannot be shown to have a finite value",
    };
    Fault::unsupported(span, what).help(
        "state the value as its antiderivative at the two limits, or leave the equation out with \"skip\" in the claims file",
    )
}
