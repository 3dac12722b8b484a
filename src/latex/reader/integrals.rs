//! Integrals over a declared continuum, `\int_V \rho(\vec r)\,\vec r\,d^3r`, and limits of a shrinking part of it,
//! `\lim_{V(\vec r) \to 0}`.
//!
//! The differential ends an integral, or is first and is followed by the integrand. It has the letter of the position,
//! without its arrow, and the dimension of the continuum as its power: `d^3r`, `d^2r`, `dr`. A volume also has `dV`, an
//! area `dA` and `dS`. `dm` is the declared density times the differential.

use crate::code::Code;
use crate::formula::SymbolId;
use crate::formula::symbols::Name;
use crate::formula::tree::{Expr, Node};
use crate::source::{Fault, Span};

use super::super::layout::{Item, Layout, contents};
use super::super::names::{self, unaccented};
use super::items::{beside, differential, extent, is_integral, is_lone, whole_number};
use super::state::{Read, Reader};

impl Reader<'_> {
    /// The continuum with this name, with or without its argument: `V(\vec r)`, `V`.
    pub(super) fn region(&mut self, items: &[Item], place: Span) -> Read<SymbolId> {
        let place = extent(items).unwrap_or(place);
        let refused = || {
            Fault::new(place, "the region of this integral is not declared")
                .code(Code::UndeclaredName)
                .help("declare the body with its density under \"continua\" in the claims file")
        };
        let mut items = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
        let printed = items.next().and_then(|item| names::printed(item, self.branch)).ok_or_else(refused)?;
        if printed.dots > 0 || printed.sup.is_some() {
            return Err(refused());
        }
        let (id, _) = self.symbols.find(&printed.name).ok_or_else(refused)?;
        let entry = self.symbols.entry(id);
        if entry.measure.is_none() && entry.argument.is_none() {
            return Err(refused());
        }
        match (items.next(), items.next(), &entry.argument) {
            (None, ..) => Ok(id),
            (Some(fence), None, Some(argument)) if is_lone(fence, argument) => Ok(id),
            _ => Err(refused()),
        }
    }

    /// An integral up to its differential; the cursor is after the integral sign.
    pub(super) fn integral(&mut self, sign: &Item, items: &[Item], cursor: &mut usize) -> Read<Expr> {
        let Layout::Scripts { sub: Some(below), sup: None, .. } = &sign.layout else {
            let in_one_variable = matches!(&sign.layout, Layout::Scripts { sup: Some(_), .. });
            let (message, help) = match in_one_variable {
                true => {
                    ("a definite integral needs both of its limits", "write the lower limit under the integral sign")
                }
                false => (
                    "an integral without limits has no value",
                    "give both limits, as in \\int_0^x, or state the derivative of the result",
                ),
            };
            return Err(Fault::unsupported(sign.span, message).help(help));
        };
        let region = self.region(contents(below), below.span)?;
        let entry = self.symbols.entry(region);
        let (Some(measure), Some(argument)) = (entry.measure, entry.argument.clone()) else {
            return Err(Fault::new(below.span, format!("{} is not declared as a part of a continuum", entry.name))
                .code(Code::UndeclaredName)
                .help("declare the body with its density under \"continua\" in the claims file"));
        };
        let (name, density) = (entry.name.clone(), entry.density);
        let wanted = match measure {
            1 => format!("d{}", unaccented(&argument)),
            n => format!("d^{n}{}", unaccented(&argument)),
        };
        let rest = &items[*cursor..];
        // An integral under this one has a differential of its own, before this one's.
        let mut inner = 0_usize;
        let ends = |item: &Item| {
            inner += usize::from(is_integral(item));
            let is_differential = differential(item).is_some();
            let is_own = is_differential && inner == 0;
            inner = inner.saturating_sub(usize::from(is_differential));
            is_own
        };
        let Some(at) = rest.iter().position(ends) else {
            return Err(Fault::new(sign.span, "this integral has no differential").help(format!(
                "end the integral with {wanted}, and put an integrand with several terms in parentheses"
            )));
        };
        let variable = rest.get(at + 1);
        let place = variable.map_or(rest[at].span, |variable| rest[at].span.to(variable.span));
        if self.symbols.find(&Name::plain("d")).is_some() && !matches!(rest[at].layout, Layout::Style(..)) {
            return Err(Fault::ambiguous(place, "d may be a differential or the declared symbol d")
                .help("write \\mathrm{d} for the differential"));
        }
        let printed = variable.and_then(|item| names::printed(item, None));
        let printed = printed.filter(|printed| printed.dots == 0 && printed.sup.is_none()).map(|printed| printed.name);
        let is_one_of =
            |elements: &[&str]| printed.iter().any(|name| elements.iter().any(|e| *name == Name::plain(*e)));
        let is_place = printed.iter().any(|name| *name == argument || *name == unaccented(&argument));
        let is_element = match measure {
            3 => is_one_of(&["V"]),
            2 => is_one_of(&["A", "S"]),
            _ => false,
        };
        let order = differential(&rest[at]);
        let of_mass = density.filter(|_| is_one_of(&["m"]) && order == Some(1));
        let fits = is_place && order == Some(measure.into()) || is_element && order == Some(1) || of_mass.is_some();
        if !fits {
            return Err(Fault::new(place, format!("an integral over {name} needs the differential {wanted}"))
                .help(format!("write {wanted} at this place")));
        }
        let blank = |items: &[Item]| items.iter().all(|item| matches!(item.layout, Layout::Space(_)));
        let (before, after) = (&rest[..at], &rest[(at + 2).min(rest.len())..]);
        let first = blank(before) && !blank(after);
        let body = if first { after } else { before };
        let density = of_mass.map(|id| Expr::new(Node::Symbol { id, indices: Vec::new(), dots: 0 }, place));
        let body = match (blank(body), density) {
            (true, None) => {
                return Err(Fault::new(sign.span.to(place), "this integral has no integrand")
                    .help(format!("write the integrand before {wanted}")));
            }
            (true, Some(density)) => density,
            (false, None) => self.term(body)?,
            (false, Some(density)) => beside(vec![density, self.term(body)?]),
        };
        *cursor = if first { items.len() } else { *cursor + at + 2 };
        let span = sign.span.to(place).to(body.span);
        Ok(Expr::new(Node::Integral(region, Box::new(body)), span))
    }

    /// The limit of the rest of the term as a part of a continuum shrinks to a point.
    pub(super) fn shrinking(&mut self, limit: &Item, rest: &[Item]) -> Read<Expr> {
        let is_open = self.symbols.open;
        let refused = || {
            Fault::unsupported(limit.span, "the limit of a function is not supported").help(match is_open {
                true => "compare the formulas without the limit",
                false => "write ≈ in place of the limit, and say in the claims file where it holds: \"limit\": \"x \\\\to 0\"",
            })
        };
        let Layout::Scripts { sub: Some(below), sup: None, .. } = &limit.layout else { return Err(refused()) };
        let below = contents(below);
        let is_arrow = |item: &Item| matches!(&item.layout, Layout::Command(name) if name == "\\rightarrow");
        let arrow = below.iter().position(is_arrow).ok_or_else(refused)?;
        let zero = matches!(&below[arrow + 1..], [zero] if whole_number(zero) == Some(0));
        if !zero {
            return Err(refused());
        }
        let region =
            self.region(&below[..arrow], limit.span).map_err(|fault| Fault { span: fault.span, ..refused() })?;
        if rest.iter().all(|item| matches!(item.layout, Layout::Space(_))) {
            return Err(Fault::new(limit.span, "no formula follows this limit")
                .help("write the formula of which the limit is taken"));
        }
        let span = extent(rest).map_or(limit.span, |rest| limit.span.to(rest));
        let body = self.term(rest)?;
        Ok(Expr::new(Node::Shrinking(region, Box::new(body)), span))
    }
}
