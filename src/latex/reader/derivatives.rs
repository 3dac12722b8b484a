//! Time derivatives `\frac{d}{dt}` and `dx/dt`. Overdots are in [`crate::latex`], file `overdots.rs`.

use crate::formula::symbols::Name;
use crate::formula::tree::Expr;
use crate::source::{Fault, Span};

use super::super::layout::{Item, Layout, contents};
use super::super::lexer::Space;
use super::super::names;
use super::items::{
    Joint, differential, has_sign_second, is_big_sum, is_integral, joint, starts_differential, whole_number,
};
use super::state::{Read, Reader};

impl Reader<'_> {
    /// The operand of `\frac{d}{dt}`.
    pub(super) fn operand(&mut self, items: &[Item], cursor: &mut usize, operator: Span) -> Read<Expr> {
        while matches!(items.get(*cursor).map(|item| &item.layout), Some(Layout::Space(Space::Thin))) {
            *cursor += 1;
        }
        let missing = || {
            Fault::new(operator, "no formula follows this derivative").help("write the function that is differentiated")
        };
        let first = items.get(*cursor).ok_or_else(missing)?;
        if matches!(first.layout, Layout::Fence(..)) {
            *cursor += 1;
            return self.item(first);
        }
        let rest = &items[*cursor..];
        let significant = || rest.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
        if significant().filter(|item| is_operator(item)).count() > 5 {
            return Err(of_too_high_order("derivatives above the fifth order", operator));
        }
        let one = significant().count() == 1 || self.is_a_function_with_its_arguments(significant());
        if !one && !is_big_sum(first) && !is_integral(first) && !self.reaches_to_the_end(significant()) {
            // It is read once: derivatives in functions in derivatives would take time without end.
            if let Some(factor) = self.only_factor(rest) {
                *cursor = items.len();
                return Ok(factor);
            }
            return Err(Fault::ambiguous(
                operator.to(first.span),
                "\\frac{d}{dt} x y may be \\frac{d}{dt}(x) y or \\frac{d}{dt}(x y)",
            )
            .help("put what is differentiated in parentheses, \\frac{d}{dt}(…)"));
        }
        *cursor = items.len();
        self.sum(rest, operator)
    }

    /// Whether these are a declared function and its arguments, and nothing else: `V(r)`.
    fn is_a_function_with_its_arguments<'i>(&self, mut items: impl Iterator<Item = &'i Item>) -> bool {
        let (Some(name), Some(arguments), None) = (items.next(), items.next(), items.next()) else { return false };
        let is_function = names::printed(name, self.branch).is_some_and(|printed| {
            self.declared_function(&printed).is_some() || self.is_inferred_function(&printed.name)
        });
        is_function && matches!(arguments.layout, Layout::Fence(..))
    }

    /// Whether a derivative before these factors must act on their product: a constant first factor is not
    /// differentiated alone, and constants after the factor that varies change nothing.
    fn reaches_to_the_end<'i>(&self, factors: impl Iterator<Item = &'i Item>) -> bool {
        let factors: Vec<&Item> =
            factors.filter(|item| !matches!(joint(item), Some(Joint::CDot | Joint::Times))).collect();
        let constant = |item: &&Item| self.is_constant(item);
        let divides = |item: &&Item| joint(item) == Some(Joint::Slash);
        match factors.as_slice() {
            all if all.iter().any(divides) => false,
            [first, ..] if constant(first) || is_operator(first) => true,
            [_, rest @ ..] => rest.iter().all(|item| constant(item) || self.is_time_in_parentheses(item)),
            [] => false,
        }
    }

    /// Whether an item consists of numbers and declared constants.
    fn is_constant(&self, item: &Item) -> bool {
        if let Some(printed) = names::printed(item, self.branch) {
            let known = self.symbols.find(&printed.name).map(|(id, _)| self.symbols.entry(id));
            let is_pi = known.is_none() && printed.name == Name::plain("\\pi");
            let fixed = !self.symbols.open && known.is_some_and(|entry| !entry.varies);
            return printed.dots == 0 && (is_pi || fixed) && printed.sup.is_none_or(|sup| self.is_constant(sup));
        }
        match &item.layout {
            Layout::Number(_) => true,
            Layout::Group(items) => items.iter().all(|item| self.is_constant(item)),
            Layout::Fraction(a, b) => !starts_differential(a) && self.is_constant(a) && self.is_constant(b),
            Layout::Root(_, a) => self.is_constant(a),
            _ => false,
        }
    }

    /// The order n of `\frac{d^n …}{dt^n}`, and the items after the upper d.
    pub(super) fn derivative<'i>(&self, numerator: &'i Item, denominator: &Item) -> Read<Option<(u8, &'i [Item])>> {
        let upper = contents(numerator);
        let lower = contents(denominator);
        let (Some(order), [d, time]) = (upper.first().and_then(differential), lower) else {
            return Ok(None);
        };
        if has_sign_second(upper) {
            return Ok(None);
        }
        let Some(time) = names::printed(time, None).filter(|_| differential(d) == Some(1)) else {
            return Ok(None);
        };
        let below = match time.sup {
            None => Some(1),
            Some(sup) => whole_number(sup),
        };
        if Some(&time.name) != self.symbols.time.as_ref() {
            return Ok(None);
        }
        let span = numerator.span.to(denominator.span);
        // An upright d is no name.
        let is_upright = upper.first().is_some_and(|d| match &d.layout {
            Layout::Scripts { nucleus, .. } => matches!(nucleus.layout, Layout::Style(..)),
            layout => matches!(layout, Layout::Style(..)),
        });
        if self.symbols.find(&Name::plain("d")).is_some() && !is_upright {
            return Err(Fault::ambiguous(span, "d may be a differential or the declared symbol d")
                .help("write \\mathrm{d} for the derivative"));
        }
        if below != Some(order) {
            return Err(different_orders(span, "\\frac{d^2x}{dt^2}"));
        }
        match u8::try_from(order) {
            Ok(order @ 1..=5) => Ok(Some((order, &upper[1..]))),
            _ => Err(of_too_high_order("derivatives above the fifth order", span)),
        }
    }

    /// The order of `d\theta/dt` typed on one line: d, θ, slash, d, t.
    pub(super) fn derivative_slash(&self, items: &[Item], at: usize) -> Option<u8> {
        let [d, inner, slash, below, time, ..] = items.get(at..)? else { return None };
        let is_time = names::printed(time, None).is_some_and(|p| Some(&p.name) == self.symbols.time.as_ref());
        let fits = differential(d) == Some(1)
            && names::printed(inner, self.branch).is_some()
            && joint(slash) == Some(Joint::Slash)
            && differential(below) == Some(1)
            && is_time
            && self.symbols.find(&Name::plain("d")).is_none();
        fits.then_some(1)
    }
}

/// Whether an item is `\frac{d}{dt}`, with no operand in its numerator.
fn is_operator(item: &Item) -> bool {
    match &item.layout {
        Layout::Fraction(above, below) => {
            starts_differential(below) && matches!(contents(above), [only] if differential(only).is_some())
        }
        _ => false,
    }
}

/// The fault of a derivative with another order above than below.
pub(super) fn different_orders(span: Span, example: &str) -> Fault {
    Fault::new(span, "the numerator and the denominator of this derivative have different orders")
        .help(format!("write the same order above and below, as in {example}"))
}

/// The fault of derivatives of a high order.
pub(super) fn of_too_high_order(derivatives: &str, span: Span) -> Fault {
    Fault::unsupported(span, format!("{derivatives} are not supported"))
        .help("give a derivative of lower order a name, and differentiate the name")
}

/// The fault of a variable below without ∂ or d before it.
pub(super) fn without_mark(span: Span) -> Fault {
    Fault::new(span, "∂ or d must stand before each variable in the denominator of a derivative")
        .help("write, for example, \\frac{\\partial^2 f}{\\partial x\\,\\partial y}")
}

/// The fault of an order that is no number.
pub(super) fn without_order(span: Span) -> Fault {
    Fault::new(span, "the order of a derivative must be a whole number")
        .help("write the order as a number, as in \\partial x^2")
}

/// The fault of a letter that may be a function of the variable of a derivative.
pub(super) fn may_depend(letter: &str, span: Span) -> Fault {
    Fault::ambiguous(span, format!("{letter} may or may not depend on the variable of this derivative"))
        .help(format!("declare {letter} in a claims file"))
}
