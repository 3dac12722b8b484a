//! Operators without a value: derivatives by anything, `\frac{\partial L}{\partial \vec q}`, `\frac{D\vec u}{Dt}`; ∂ and ∇ with
//! an index, or with nothing to act on.

use crate::formula::tree::Expr;
use crate::source::{Fault, Span};

use super::super::super::layout::{Delimiter, Item, Layout, contents};
use super::super::super::names;
use super::super::super::rows::relation;
use super::super::items::{differential, has_sign_second, is_any_integral, is_big_sum, joint, whole_number};
use super::super::state::{Read, Reader};
use super::super::undeclared::is_constant_before_an_integral;
use super::super::vector_names::is_vectorial;
use super::named_functions::is_named;
use super::printed;

impl Reader<'_> {
    /// A factor that only the second attempt reads; `None` for any other.
    pub(in super::super) fn abstract_factor(&mut self, items: &[Item], cursor: &mut usize) -> Read<Option<Expr>> {
        if let Some(found) = self.braced(items, cursor)? {
            return Ok(Some(found));
        }
        if let Some(found) = self.indicator(items, cursor) {
            return Ok(Some(found));
        }
        if let Some(found) = self.operator_at_a_place(items, cursor)? {
            return Ok(Some(found));
        }
        if let Some(found) = self.abstract_derivative(items, cursor)? {
            return Ok(Some(found));
        }
        if let Some(found) = self.abstract_operator(items, cursor)? {
            return Ok(Some(found));
        }
        if let Some(found) = self.named_function(items, cursor)? {
            return Ok(Some(found));
        }
        if let (Layout::Command(name), Some(next)) = (&items[*cursor].layout, items.get(*cursor + 1))
            && ["\\delta", "\\Delta"].contains(&name.as_str())
            && (is_parenthesis(next) || is_derivative(next) || matches!(next.layout, Layout::Root(..)))
        {
            let span = items[*cursor].span;
            let template = format!("{name}(#)");
            *cursor += 1;
            let (inner, _) = self.factor(items, cursor)?;
            let span = span.to(inner.span);
            return Ok(Some(self.template(&template, vec![inner], span)));
        }
        // `d(pV)`, `d\\ln r`
        if self.symbols.inferred.differentials && differential(&items[*cursor]) == Some(1) {
            let spaces = items[*cursor + 1..].iter().take_while(|item| matches!(item.layout, Layout::Space(_))).count();
            let at = *cursor + 1 + spaces;
            let acts = items.get(at).is_some_and(|next| {
                names::printed(next, None).is_none()
                    && (is_parenthesis(next)
                        || matches!(next.layout, Layout::Group(_))
                        || matches!(&next.layout, Layout::Command(name) if ["\\ln", "\\log", "\\cos", "\\sin"].contains(&name.as_str())))
            });
            if acts {
                let span = items[*cursor].span;
                *cursor = at;
                let (inner, _) = self.factor(items, cursor)?;
                let span = span.to(inner.span);
                return Ok(Some(self.template("d(#)", vec![inner], span)));
            }
        }
        // `{}^A R`
        let item = &items[*cursor];
        if is_bare_script(item) {
            *cursor += 1;
            let script = printed(std::slice::from_ref(item));
            if items.get(*cursor).is_none_or(|next| matches!(next.layout, Layout::Space(_)) || joint(next).is_some()) {
                return Err(Fault::new(item.span, "no symbol stands beside this subscript or superscript")
                    .help("write it after its symbol, as in x_1 or x^2"));
            }
            let (base, _) = self.factor(items, cursor)?;
            let span = item.span.to(base.span);
            return Ok(Some(self.template(&format!("{script}#"), vec![base], span)));
        }
        Ok(None)
    }

    /// `\underbrace{x}_{y}`, `\overset{a}{b}`, `\binom{n}{k}`: a formula with a label, or two formulas one above the other.
    fn braced(&mut self, items: &[Item], cursor: &mut usize) -> Read<Option<Expr>> {
        let item = &items[*cursor];
        let Layout::Command(name) = &item.layout else { return Ok(None) };
        let Some(next) = items.get(*cursor + 1) else { return Ok(None) };
        match name.as_str() {
            "\\underbrace" | "\\overbrace" => {
                let (nucleus, label) = match &next.layout {
                    Layout::Scripts { nucleus, sub, sup, primes: 0 } => {
                        let label = |mark, script: &Option<Box<Item>>| {
                            script.as_ref().map_or_else(String::new, |s| format!("{mark}{{{}}}", printed(contents(s))))
                        };
                        (&**nucleus, format!("{}{}", label('_', sub), label('^', sup)))
                    }
                    _ => (next, String::new()),
                };
                *cursor += 2;
                let inner = self.equated(nucleus)?;
                Ok(Some(self.template(&format!("{name}{{#}}{label}"), vec![inner], item.span.to(next.span))))
            }
            "\\overset" | "\\underset" | "\\stackrel" => {
                let Some(base) = items.get(*cursor + 2) else { return Ok(None) };
                if contents(base).iter().any(|item| relation(item).is_some()) {
                    return Err(Fault::unsupported(
                        item.span.to(base.span),
                        "a relation with this mark above or below it, such as ?, is not supported",
                    )
                    .help("write the relation alone, if it is meant to hold"));
                }
                let place = item.span.to(base.span);
                if matches!(contents(base), [Item { layout: Layout::Command(name), .. }] if name.ends_with("arrow")) {
                    let what = "an arrow with a formula above or below it is not supported";
                    return Err(Fault::unsupported(place, what)
                        .help("write an equation, and what stands at the arrow as text beside it"));
                }
                *cursor += 3;
                let inner = self.item(base)?;
                let template = format!("{name}{{{}}}{{#}}", printed(contents(next)));
                Ok(Some(self.template(&template, vec![inner], place)))
            }
            "\\binom" | "\\dbinom" | "\\tbinom" => {
                let Some(below) = items.get(*cursor + 2) else { return Ok(None) };
                *cursor += 3;
                let (above, lower) = (self.item(next)?, self.item(below)?);
                Ok(Some(self.template("\\binom{#}{#}", vec![above, lower], item.span.to(below.span))))
            }
            _ => Ok(None),
        }
    }

    /// A fraction that is a derivative by anything, with what it acts on; `None` for another fraction.
    pub(in super::super) fn abstract_derivative(&mut self, items: &[Item], cursor: &mut usize) -> Read<Option<Expr>> {
        let item = &items[*cursor];
        let Layout::Fraction(above, below) = &item.layout else { return Ok(None) };
        let (above, below) = (contents(above), contents(below));
        // `\frac{{}^N d\vec v}{dt}`: a derivative in the frame N.
        let (frame, above) = match above.split_first() {
            Some((script, rest)) if is_bare_script(script) => (printed(std::slice::from_ref(script)), rest),
            _ => (String::new(), above),
        };
        let (Some(first), Some(lower)) = (above.first(), below.first()) else { return Ok(None) };
        if [above, below].into_iter().any(has_sign_second) {
            return Ok(None);
        }
        let (Some(mark), Some(_)) = (mark(first), mark_alone(lower)) else { return Ok(None) };
        if below.len() < 2 {
            return Ok(None);
        }
        *cursor += 1;
        let template = |hole: &str| format!("\\frac{{{frame}{mark} {hole}}}{{{}}}", printed(&without_braces(below)));
        if above[1..].iter().any(|item| !matches!(item.layout, Layout::Space(_))) {
            let inner = self.sum(&above[1..], item.span)?;
            let derivative = self.template(&template("#"), vec![inner], item.span);
            return self.derivative_at(derivative, items, cursor).map(Some);
        }
        let applied = self.on_the_rest(items, cursor)?;
        Ok(Some(self.acting(&template(""), applied, item.span)))
    }

    /// `\left.\frac{d}{dt}\right|_{t=0} g(t)`: the derivative of what follows, at a place. `None` for anything else.
    fn operator_at_a_place(&mut self, items: &[Item], cursor: &mut usize) -> Read<Option<Expr>> {
        let item = &items[*cursor];
        let Layout::Scripts { nucleus, sub, sup, primes: 0 } = &item.layout else { return Ok(None) };
        let Layout::Fence(Delimiter::Evaluation, inside) = &nucleus.layout else { return Ok(None) };
        let mut solid = inside.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
        let (Some(operator), None) = (solid.next(), solid.next()) else { return Ok(None) };
        let Layout::Fraction(above, below) = &operator.layout else { return Ok(None) };
        let is_operator = |above: &[Item]| matches!(above, [only] if mark(only).is_some());
        let lower = contents(below).first().and_then(mark_alone);
        if !is_operator(contents(above)) || lower.is_none() {
            return Ok(None);
        }
        let mut rest = *cursor + 1;
        let Some(applied) = self.on_the_rest(items, &mut rest)? else { return Ok(None) };
        *cursor = rest;
        let derivative = self.acting(&printed(std::slice::from_ref(operator)), Some(applied), item.span);
        let span = derivative.span;
        self.evaluated(derivative, (sub.as_deref(), sup.as_deref()), span).map(Some)
    }

    /// `\frac{\partial f}{\partial x}(x_0, y)`: a derivative at a place, if names, numbers or a list stand in parentheses.
    fn derivative_at(&mut self, derivative: Expr, items: &[Item], cursor: &mut usize) -> Read<Expr> {
        let Some(Item { layout: Layout::Fence(Delimiter::Round, inside), span }) = items.get(*cursor) else {
            return Ok(derivative);
        };
        let is_comma = |item: &Item| matches!(item.layout, Layout::Other(',' | ';'));
        let is_place = |item: &&Item| {
            is_comma(item)
                || matches!(item.layout, Layout::Number(_) | Layout::Space(_))
                || names::printed(item, None).is_some_and(|found| found.sup.is_none())
        };
        let solid = inside.iter().filter(|item| !matches!(item.layout, Layout::Space(_))).count();
        if !(inside.iter().any(is_comma) || solid == 1 && inside.iter().all(|item| is_place(&item))) {
            return Ok(derivative);
        }
        let mut parts = vec![derivative];
        for argument in inside.split(is_comma) {
            parts.push(self.sum(argument, *span)?);
        }
        *cursor += 1;
        let holes = vec!["#"; parts.len() - 1].join(", ");
        let whole = parts[0].span.to(*span);
        Ok(self.template(&format!("(#)({holes})"), parts, whole))
    }

    /// ∂ or ∇ with an index or alone, a box, `\frac{d}{dt}` without an operand.
    pub(in super::super) fn abstract_operator(&mut self, items: &[Item], cursor: &mut usize) -> Read<Option<Expr>> {
        let item = &items[*cursor];
        // `\partial'_\mu`, the derivative by other coordinates.
        let nucleus = match &item.layout {
            Layout::Scripts { nucleus, .. } => nucleus,
            _ => item,
        };
        let nucleus = match &nucleus.layout {
            Layout::Style(_, inner) | Layout::Accent(_, inner) => contents(inner).first().unwrap_or(nucleus),
            _ => nucleus,
        };
        let Layout::Command(name) = &nucleus.layout else { return Ok(None) };
        if !["\\partial", "\\nabla", "\\Box", "\\square"].contains(&name.as_str()) {
            return Ok(None);
        }
        *cursor += 1;
        let mut text = printed(std::slice::from_ref(item));
        while matches!(items.get(*cursor).map(|item| &item.layout), Some(Layout::Space(_))) {
            *cursor += 1;
        }
        if let (Some(next), "\\nabla") = (items.get(*cursor), name.as_str())
            && matches!(&next.layout, Layout::Command(sign) if ["\\cdot", "\\times", "\\wedge", "\\otimes"].contains(&sign.as_str()))
        {
            text.push_str(&printed(std::slice::from_ref(next)));
            *cursor += 1;
        }
        // `\nabla\cdot k\nabla T`: a divergence of a scalar does not exist, so it is that of the product.
        let rest: Vec<&Item> =
            items[*cursor..].iter().filter(|item| !matches!(item.layout, Layout::Space(_))).collect();
        if text.ends_with("\\cdot") && is_scalar_before_a_gradient(&rest) {
            let product = self.term(&items[*cursor..])?;
            *cursor = items.len();
            return Ok(Some(self.acting(&text, Some(product), item.span)));
        }
        let applied = self.on_the_next(items, cursor)?;
        Ok(Some(self.acting(&text, applied, item.span)))
    }

    fn acting(&mut self, operator: &str, inner: Option<Expr>, span: Span) -> Expr {
        match inner {
            Some(inner) => {
                let whole = span.to(inner.span);
                self.template(&format!("{operator}(#)"), vec![inner], whole)
            }
            None => self.template(operator, Vec::new(), span),
        }
    }

    /// The next factor, which an operator acts on; `None` if there is none.
    pub(super) fn on_the_next(&mut self, items: &[Item], cursor: &mut usize) -> Read<Option<Expr>> {
        is_no_long_chain(&items[*cursor..])?;
        let next = items[*cursor..].iter().position(|item| !matches!(item.layout, Layout::Space(_)));
        let Some(next) = next.map(|at| *cursor + at).filter(|at| joint(&items[*at]).is_none()) else { return Ok(None) };
        *cursor = next;
        if is_constant_before_an_integral(&items[next..]) {
            *cursor = items.len();
            return self.term(&items[next..]).map(Some);
        }
        let (factor, _) = self.factor(items, cursor)?;
        // `\partial_\lambda R^\mu{}_{\nu}` is the derivative of all of it.
        let factor = self.with_what_follows(factor, items, cursor)?;
        let follows = items[*cursor..].iter().find(|item| !matches!(item.layout, Layout::Space(_)));
        let touches = items.get(*cursor).is_some_and(|item| !matches!(item.layout, Layout::Space(_)));
        // `\nabla\cdot\nu[\nabla u]`, `\nabla\cdot k\nabla T` too.
        let is_factor = |item: &Item| match &item.layout {
            Layout::Fence(delimiter, _) => matches!(delimiter, Delimiter::Round | Delimiter::Square),
            Layout::Command(name) => name == "\\nabla",
            _ => false,
        };
        let is_name = follows.is_some_and(|item| {
            names::printed(item, None).is_some() || is_factor(item) || is_any_integral(item) || is_big_sum(item)
        });
        if is_name && touches && !matches!(items[next].layout, Layout::Fence(..)) {
            return Err(Fault::ambiguous(
                items[next].span.to(items[*cursor].span),
                "an operator before f g may act on f or on the product f g",
            )
            .help("put the factors on which it acts in parentheses"));
        }
        Ok(Some(factor))
    }

    /// A parenthesis, or else the rest of the term; `None` if there is nothing.
    pub(super) fn on_the_rest(&mut self, items: &[Item], cursor: &mut usize) -> Read<Option<Expr>> {
        is_no_long_chain(&items[*cursor..])?;
        let next = items[*cursor..].iter().position(|item| !matches!(item.layout, Layout::Space(_)));
        let Some(next) = next.map(|at| *cursor + at).filter(|at| joint(&items[*at]).is_none()) else { return Ok(None) };
        if matches!(items[next].layout, Layout::Fence(..)) {
            *cursor = next + 1;
            return self.item(&items[next]).map(Some);
        }
        let rest = &items[next..];
        // `\frac{\partial}{\partial t} f \frac{\partial}{\partial t} g`: the first may act on f alone, or on all.
        let acted_on = rest.iter().position(|item| !is_derivative(item) && !matches!(item.layout, Layout::Space(_)));
        let again = acted_on.and_then(|at| rest[at..].iter().find(|item| is_derivative(item)));
        if let Some(again) = again {
            return Err(Fault::ambiguous(
                rest[0].span.to(again.span),
                "the first of two derivatives may act on the next factor, or on all that follows",
            )
            .help("put the factors on which it acts in parentheses"));
        }
        *cursor = items.len();
        self.term(rest).map(Some)
    }
}

/// Rejects a long chain of derivatives and functions, each of which would read the rest of the chain.
fn is_no_long_chain(items: &[Item]) -> Read<()> {
    const MOST: usize = 64;
    let follow = items.iter().filter(|item| !matches!(item.layout, Layout::Space(_)));
    let chain: Vec<&Item> = follow.take_while(|item| is_derivative(item) || is_named(item)).take(MOST + 1).collect();
    match chain.get(MOST) {
        Some(last) => Err(Fault::unsupported(
            chain[0].span.to(last.span),
            format!("more than {MOST} derivatives and functions side by side are not supported"),
        )
        .help("write the order of the derivative, or put parentheses around a part")),
        None => Ok(()),
    }
}

/// Whether an item is a derivative, or ∂ or ∇.
fn is_derivative(item: &Item) -> bool {
    match &item.layout {
        Layout::Fraction(above, below) => {
            [above, below].iter().all(|part| contents(part).first().is_some_and(|first| mark(first).is_some()))
        }
        Layout::Scripts { nucleus, .. } => is_derivative(nucleus),
        Layout::Command(name) => ["\\nabla", "\\partial"].contains(&name.as_str()),
        _ => false,
    }
}

/// Whether items are one name without the markup of a vector and a gradient, and nothing else: `k\nabla T`, `M(\nabla\mu)`.
fn is_scalar_before_a_gradient(items: &[&Item]) -> bool {
    let is_nabla = |item: &Item| matches!(&item.layout, Layout::Command(name) if name == "\\nabla");
    let [scalar, gradient @ ..] = items else { return false };
    let is_scalar = names::printed(scalar, None).is_some_and(|found| !is_vectorial(&found.name.base));
    is_scalar
        && match gradient {
            [nabla, _] => is_nabla(nabla),
            [Item { layout: Layout::Fence(Delimiter::Round, inside), .. }] => {
                matches!(inside.as_slice(), [nabla, _] if is_nabla(nabla))
            }
            _ => false,
        }
}

/// Whether an item is one name in parentheses, `(s)`.
pub(super) fn is_one_name(item: &Item) -> bool {
    let Layout::Fence(Delimiter::Round, inside) = &item.layout else { return false };
    matches!(inside.as_slice(), [only] if names::printed(only, None).is_some_and(|found| found.sup.is_none()))
}

pub(super) fn is_parenthesis(item: &Item) -> bool {
    let nucleus = if let Layout::Scripts { nucleus, .. } = &item.layout { nucleus } else { item };
    matches!(nucleus.layout, Layout::Fence(Delimiter::Round | Delimiter::Square, _))
}

/// Whether an item is a script without a base, `{}_{\\nu}`.
pub(super) fn is_bare_script(item: &Item) -> bool {
    matches!(&item.layout, Layout::Scripts { nucleus, .. } if nucleus.layout == Layout::Group(Vec::new()))
}

/// Items, where braces around one of them are left out, as a macro writes them: `\partial{x}`.
fn without_braces(items: &[Item]) -> Vec<Item> {
    let one = |item: &Item| match contents(item) {
        [only] => only.clone(),
        _ => item.clone(),
    };
    items.iter().map(one).collect()
}

/// What begins the numerator of a derivative, with its order: d, ∂, δ, D.
fn mark(item: &Item) -> Option<String> {
    match &item.layout {
        Layout::Scripts { nucleus, sub: None, sup: Some(sup), primes: 0 } => {
            let order = whole_number(sup).map(|order| order.to_string()).or_else(|| {
                names::printed(sup, None).filter(|found| found.sup.is_none()).map(|found| found.name.to_string())
            });
            let order = order.or_else(|| is_shifted(contents(sup)).then(|| printed(contents(sup))))?;
            mark_alone(nucleus).map(|mark| format!("{mark}^{{{order}}}"))
        }
        _ => mark_alone(item).map(str::to_owned),
    }
}

/// Whether an order is a letter and a number, `\frac{d^{n-1}y}{dt^{n-1}}`.
fn is_shifted(order: &[Item]) -> bool {
    matches!(
        order,
        [
            Item { layout: Layout::Letter(_), .. },
            Item { layout: Layout::Other('-' | '+'), .. },
            Item { layout: Layout::Number(_), .. }
        ]
    )
}

fn mark_alone(item: &Item) -> Option<&'static str> {
    match &item.layout {
        Layout::Command(name) if name == "\\partial" => Some("\\partial"),
        Layout::Command(name) if name == "\\delta" => Some("\\delta"),
        Layout::Letter('D') => Some("D"),
        // `\frac{\tilde d}{dt}`: another derivative by the time.
        Layout::Accent(accent, inner) if matches!(contents(inner), [only] if differential(only) == Some(1)) => {
            match accent.as_str() {
                "\\tilde" => Some("\\tilde{d}"),
                "\\hat" => Some("\\hat{d}"),
                "\\bar" => Some("\\bar{d}"),
                _ => None,
            }
        }
        Layout::Style(style, inner)
            if style == "\\mathrm" && matches!(contents(inner), [Item { layout: Layout::Letter('D'), .. }]) =>
        {
            Some("D")
        }
        _ => (differential(item) == Some(1)).then_some("d"),
    }
}

/// Whether a fraction is a derivative that follows the motion, `\frac{D\vec u}{Dt}`.
pub(in super::super) fn is_material(above: &Item, below: &Item) -> bool {
    let is_d = |item: &Item| mark_alone(item) == Some("D");
    matches!(contents(below), [d, _] if is_d(d)) && contents(above).first().is_some_and(is_d)
}
